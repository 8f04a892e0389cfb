"""The catalogue and its words: masses, sizes, colours and names of some categories."""

import numpy as np
import pytest

from generator.errors import InputError
from generator.objects.checks import mass_of
from tabletop_objects import CATEGORIES, build, get_category


def test_there_are_enough_categories():
    assert len(CATEGORIES) >= 2400


MASSES = {
    "mug": (0.2, 0.45), "bowl": (0.2, 0.6), "plate": (0.3, 0.8), "glass": (0.12, 0.4),
    "fork": (0.02, 0.08), "spoon": (0.02, 0.08), "bottle": (0.35, 0.9), "can": (0.25, 0.5),
    "milk_carton": (0.4, 1.2), "apple": (0.12, 0.25), "banana": (0.09, 0.2),
    "orange": (0.12, 0.3), "egg": (0.04, 0.08), "book": (0.25, 0.9), "pen": (0.006, 0.03),
    "laptop": (1.0, 2.5), "monitor": (2.5, 7.0), "keyboard": (0.3, 1.2),
    "computer_mouse": (0.05, 0.15), "smartphone": (0.13, 0.25), "teapot": (0.4, 1.2),
    "pan": (0.5, 1.6), "hammer": (0.3, 1.0), "screwdriver": (0.04, 0.2), "die": (0.002, 0.03),
    "desk_lamp": (0.5, 2.0), "lipstick": (0.015, 0.05), "microscope": (1.5, 5.0),
    "microwave": (8.0, 15.0), "moka_pot": (0.3, 1.0), "soda_can": (0.3, 0.5),
    "soup_can": (0.3, 0.5), "tuna_can": (0.12, 0.28), "tennis_ball": (0.05, 0.07),
    "golf_ball": (0.04, 0.05), "spatula": (0.04, 0.2), "padlock": (0.05, 0.3),
    "newspaper": (0.08, 0.35),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("key", sorted(MASSES))
def test_mass_is_plausible(key: str):
    low, high = MASSES[key]
    for seed in range(3):
        assert low <= mass_of(build(key, seed)) <= high


@pytest.mark.parametrize(
    ("key", "low", "high"),
    [("mug", 1500, 3200), ("plate", 1500, 3200), ("bowl", 1200, 3200), ("fork", 2500, 9000),
     ("glass", 1800, 3200), ("apple", 600, 1050), ("banana", 600, 1100), ("book", 400, 1000)],
)  # fmt: skip
def test_density_is_the_materials_own(key: str, low: float, high: float):
    """Mass was stated and volume modelled; their quotient must be the material's density.

    Some forks have a plastic handle, others are steel all through.
    """
    for seed in range(3):
        assert low <= build(key, seed).physics.density <= high


def test_size_words_scale_and_sizes_fix():
    plain = build("mug", 4)
    large = build("mug", 4, attributes={"size": "large"})
    np.testing.assert_allclose(large.size, 1.25 * plain.size)
    assert mass_of(large) == pytest.approx(1.25**2 * mass_of(plain))
    np.testing.assert_array_equal(build("mug", 4, size=(0.1, 0.2, 0.3)).size, [0.1, 0.2, 0.3])


@pytest.mark.parametrize("key", ["mug", "book", "vase", "toy_block", "chess_piece", "pen"])
def test_color_is_honoured(key: str):
    def mean(color: str) -> np.ndarray:
        models = [build(key, seed, attributes={"color": color}) for seed in range(4)]
        return np.mean([m.mesh.texture.reshape(-1, 3).mean(0) for m in models], axis=0)

    red, blue = mean("red"), mean("blue")
    assert red[0] - red[2] > blue[0] - blue[2] + 25


def test_material_is_honoured():
    wooden = build("bowl", 2, attributes={"material": "wooden"}).mesh.texture
    assert wooden.std() > 5
    metal = build("tray", 2, attributes={"material": "steel"}).mesh.texture.reshape(-1, 3)
    spread = metal.astype(float).max(1) - metal.min(1)
    assert np.median(spread) < 20  # grey


def test_words_find_their_category():
    assert get_category("Coffee Mug").key == "mug"
    assert get_category("rubik's cube").key == "puzzle_cube"
    assert get_category("computer_mouse").key == "computer_mouse"
    with pytest.raises(InputError, match="Did you mean 'mug'"):
        get_category("mugg")


def test_table_of_categories_cannot_be_changed():
    with pytest.raises(TypeError):
        CATEGORIES["mug"] = CATEGORIES["bowl"]  # type: ignore[index]


def test_aliases_name_one_thing_each():
    nouns = {c.noun: c.key for c in CATEGORIES.values()}
    seen: dict[str, str] = {}
    for found in CATEGORIES.values():
        for alias in found.aliases:
            assert nouns.get(alias, found.key) == found.key, f"{alias!r} is a category's noun"
            assert seen.setdefault(alias, found.key) == found.key, f"{alias!r} is claimed twice"
