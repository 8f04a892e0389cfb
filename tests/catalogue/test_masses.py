"""Masses of models compared with real objects, and their growth with size."""

import json
from pathlib import Path

import numpy as np
import pytest

from generator.physics.inertia import body_mass
from generator.physics.parts import model_parts
from tabletop_objects import CATEGORIES, build
from tabletop_objects.kit.shapes import FRICTION

KNOWN = json.loads((Path(__file__).parent / "known_masses.json").read_text())["things"]
VARIANTS = 8
FACTOR = 1.5


def weight(key: str, seed: int, factor: float = 1.0) -> float:
    model = build(key, seed)
    scale = model.size * factor
    return body_mass(model.mesh, scale, model.physics, model_parts(model, scale)).mass


def test_the_table_is_sound() -> None:
    assert len(KNOWN) >= 40
    assert len({thing["category"] for thing in KNOWN}) == len(KNOWN)
    for thing in KNOWN:
        assert thing["source"]
        assert 0 < thing["low"] <= thing["high"]


@pytest.mark.slow
@pytest.mark.parametrize("thing", KNOWN, ids=lambda thing: thing["category"])
def test_every_variant_weighs_what_real_ones_do(thing) -> None:
    masses = [weight(thing["category"], seed) for seed in range(VARIANTS)]
    assert thing["low"] / FACTOR <= min(masses), thing["source"]
    assert max(masses) <= thing["high"] * FACTOR, thing["source"]


@pytest.mark.parametrize("factor", [0.8, 1.25])
def test_solid_things_grow_with_volume_and_hollow_ones_with_area(factor: float) -> None:
    for key, power in (("apple", 3), ("book", 3), ("can", 3), ("mug", 2), ("bowl", 2), ("vase", 2)):
        assert weight(key, 0, factor) / weight(key, 0) == pytest.approx(factor**power, rel=1e-3)


def test_a_larger_variant_weighs_more() -> None:
    sizes = [float(np.prod(build("ball", seed).size)) for seed in range(12)]
    masses = [weight("ball", seed) for seed in range(12)]
    assert np.corrcoef(np.log(sizes), np.log(masses))[0, 1] > 0.9


def test_mass_grows_with_volume_surface_or_not_at_all() -> None:
    growth = {key: CATEGORIES[key].growth for key in ("laptop", "mug", "apple")}
    assert growth == {"laptop": 0.0, "mug": 2 / 3, "apple": 1.0}
    assert {category.growth for category in CATEGORIES.values()} == {0.0, 2 / 3, 1.0}


def test_every_material_of_the_friction_table_is_used() -> None:
    assert {category.material for category in CATEGORIES.values()} == set(FRICTION)


def test_rubber_grips_better_than_glass() -> None:
    slide = {key: build(key, 0).physics.friction for key in ("glass", "book", "cutting_mat")}
    assert slide["glass"] < slide["book"] < slide["cutting_mat"]
