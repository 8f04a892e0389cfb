"""Every category looks different from seed to seed: in proportions, colours or prints."""

import numpy as np
import pytest
from built import Models
from jaxtyping import Float

from generator.scene import Model
from tabletop_objects import build


def appearance(model: Model) -> Float[np.ndarray, "n"]:
    """Size (log), then mean and spread of the surface's colours, in steps one can see."""
    mesh = model.mesh
    points = mesh.vertices.astype(float)[mesh.faces] * model.size
    area = np.linalg.norm(
        np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]), axis=1
    )
    height, width = mesh.texture.shape[:2]
    colors = []
    for weights in np.array([(4, 1, 1), (1, 4, 1), (1, 1, 4), (2, 2, 2)]) / 6:
        u, v = np.einsum("k,fkd->df", weights, mesh.uv[mesh.faces])
        rows = np.clip(((1 - v) * height).astype(int), 0, height - 1)
        colors.append(mesh.texture[rows, np.clip((u * width).astype(int), 0, width - 1)])
    seen, share = np.concatenate(colors).astype(float), np.tile(area, 4) / area.sum() / 4
    mean = share @ seen
    spread = np.sqrt(share @ (seen - mean) ** 2)
    return np.concatenate([np.log(model.size) / 0.05, mean / 8, spread / 6])


def count_looks(models: list[Model]) -> int:
    """How many of the models differ from all counted before them in at least one visible step."""
    kept: list[np.ndarray] = []
    for model in models:
        here = appearance(model)
        if all(np.abs(here - other).max() > 1 for other in kept):
            kept.append(here)
    return len(kept)


@pytest.mark.slow
def test_category_has_five_looks(variants: Models):
    assert count_looks(variants.first(10)) >= 5


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
