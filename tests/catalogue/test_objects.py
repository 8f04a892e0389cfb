"""Every category: closed meshes, honest collision parts, true sizes and masses, seeds."""

import numpy as np
import pytest
from built import Models
from solidity import fingerprint, is_closed, mass_of

from generator.errors import InputError
from generator.gallery import draw
from generator.scene import Mesh, Model
from tabletop_objects import CATEGORIES, build, get_category
from tabletop_objects.kit.solids import signed_volume

FAR = 2.2
"""How many times as large or small as usual one variant may be."""

LIGHTEST = 0.002
"""The least mass of a body, kg."""


def test_there_are_enough_categories():
    assert len(CATEGORIES) >= 2400


def test_closedness_is_told_apart():
    whole = build("book", 0).mesh
    torn = Mesh(whole.vertices, whole.faces[1:], whole.uv, whole.texture)
    assert is_closed(whole)
    assert not is_closed(torn)


def assert_sound(model: Model) -> None:
    assert is_closed(model.mesh), "the surface has holes"
    assert signed_volume(model.mesh.vertices.astype(float), model.mesh.faces) > 0
    assert len(model.mesh.faces) <= 4000
    assert max(model.mesh.texture.shape[:2]) <= 640
    assert model.mesh.uv.min() >= 0 and model.mesh.uv.max() <= 1


def assert_parts_fit(model: Model) -> None:
    assert 1 <= len(model.parts) <= 32
    bounds = np.stack([p.bounds for p in model.parts])
    assert np.abs(bounds).max() <= 0.5 + 0.004, "a part sticks out of the mesh"
    gap = (bounds[:, 0, 2].min() + 0.5) * model.size[2]
    assert gap < 6e-4, f"the collision shape hangs {gap:.4f} m above the mesh's bottom"
    for part in model.parts:
        assert len(part.vertices) <= 32
        assert (np.ptp(part.vertices, axis=0) * model.size > 2e-4).all(), "a part is flat"


@pytest.mark.slow
def test_every_category_is_sound(models: Models):
    """One variant of each category; more of some in the tests below."""
    model, found = models[0], CATEGORIES[models.key]
    assert_sound(model)
    assert_parts_fit(model)
    assert model.category == models.key
    assert model.label == found.noun
    reach = float(np.linalg.norm(model.size) / np.linalg.norm(found.size))
    assert 1 / FAR < reach < FAR, f"{found.size} but {model.size}"
    mass = mass_of(model)
    assert 0.4 * found.mass < mass < 2.5 * max(found.mass, LIGHTEST), f"{mass} kg"


@pytest.mark.slow
def test_variants_are_sound(variants: Models):
    for model in variants.first(3):
        assert_sound(model)
        assert_parts_fit(model)


@pytest.mark.slow
def test_seed_decides_everything(variants: Models):
    prints = [fingerprint(model) for model in variants.first(3)]
    assert len(set(prints)) == 3
    assert fingerprint(build(variants.key, 1)) == prints[1]


@pytest.mark.slow
def test_nominal_size_is_true(variants: Models):
    found = CATEGORIES[variants.key]
    sizes = np.array([model.size for model in variants.first(8)])
    ratio = sizes.mean(0) / np.array(found.size)
    assert (np.abs(np.log(ratio)) < np.log(1.35)).all(), f"{found.size} but {sizes.mean(0)}"


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
@pytest.mark.parametrize("models", sorted(MASSES), indirect=True)
def test_mass_is_plausible(models: Models):
    low, high = MASSES[models.key]
    for model in models.first(3):
        assert low <= mass_of(model) <= high


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


@pytest.mark.slow
def test_contact_sheet_shows_each_variant():
    picture = draw(["apple", "book"], variants=2, side=48)
    assert picture.shape == (48 + 22, 4 * 48, 3)
    cells = np.split(picture[:48], 4, axis=1)
    assert all((cell.min(axis=2) < 200).mean() > 0.05 for cell in cells)
