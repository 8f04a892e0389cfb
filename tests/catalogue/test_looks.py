"""Looks: how they are counted, and that requested colours show."""

import numpy as np
import pytest

from generator.objects.checks import count_looks
from generator.scene import Model
from tabletop_objects import build


def test_same_seed_counts_once():
    assert count_looks([build("mug", 3)] * 4) == 1
    assert count_looks([build("mug", 3, attributes={"style": "cartoon"}), build("mug", 3)]) == 2


def share_of_hue(model: Model, low: float, high: float) -> float:
    """Return the share of the texture's pixels with a hue between two, of 0 to 1."""
    pixels = model.mesh.texture.reshape(-1, 3) / 255.0
    strong = pixels.max(1) - pixels.min(1) > 0.2
    red, green, blue = pixels.T
    hue = np.degrees(np.arctan2(np.sqrt(3) * (green - blue), 2 * red - green - blue)) % 360 / 360
    return float((strong & (hue >= low) & (hue <= high)).mean())


@pytest.mark.parametrize(
    "key", ["toy_block", "corkscrew", "desk_lamp", "tissue_box", "salt_shaker", "map"]
)
@pytest.mark.parametrize("seed", range(3))
def test_the_colour_asked_for_is_seen(key: str, seed: int) -> None:
    model = build(key, seed, attributes={"color": "green"})
    assert share_of_hue(model, 0.25, 0.5) > 0.1


def test_food_keeps_its_own_colours() -> None:
    plain, asked = build("pizza", 0), build("pizza", 0, attributes={"color": "blue"})
    assert np.abs(plain.mesh.texture.astype(float) - asked.mesh.texture).mean() < 40
