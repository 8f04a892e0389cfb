"""Drawing styles: sound models in every category, flatter, thicker, coarser."""

import numpy as np
import pytest
from built import Models
from solidity import fingerprint, is_closed, mass_of

from generator.errors import InputError
from generator.scene import Model
from tabletop_objects import CATEGORIES, build
from tabletop_objects.kit.solids import signed_volume
from tabletop_objects.kit.styles import STYLES, apply_style, flatten


def in_style(key: str, style: str, seed: int = 0) -> Model:
    return build(key, seed, attributes={"style": style})


@pytest.mark.slow
@pytest.mark.parametrize("style", sorted(STYLES))
def test_styled_model_is_sound(variants: Models, style: str):
    model = in_style(variants.key, style)
    assert is_closed(model.mesh), "the surface has holes"
    assert signed_volume(model.mesh.vertices.astype(float), model.mesh.faces) > 0
    assert len(model.mesh.faces) <= 5000
    assert 1 <= len(model.parts) <= 32
    bounds = np.stack([p.bounds for p in model.parts])
    assert np.abs(bounds).max() <= 0.504, "a part sticks out of the mesh"
    assert (bounds[:, 0, 2].min() + 0.5) * model.size[2] < 6e-4
    for part in model.parts:
        assert len(part.vertices) <= 32
        assert (np.ptp(part.vertices, axis=0) * model.size > 2e-4).all(), "a part is flat"
    plain = variants[0]
    assert (np.abs(model.size - plain.size) <= 0.012 * plain.size.max()).all()


def test_style_keeps_seed_and_mass():
    for style in STYLES:
        assert fingerprint(in_style("teapot", style)) == fingerprint(in_style("teapot", style))
        assert fingerprint(in_style("teapot", style)) != fingerprint(build("teapot", 0))
        plain = mass_of(build("teapot", 0))
        assert mass_of(in_style("teapot", style)) == pytest.approx(plain, rel=0.05)


def test_plain_is_no_style():
    assert fingerprint(in_style("mug", "plain")) == fingerprint(build("mug", 0))
    assert fingerprint(in_style("mug", "Low_Poly")) == fingerprint(in_style("mug", "low-poly"))


def test_unknown_style_is_refused():
    with pytest.raises(InputError, match="cartoon"):
        in_style("mug", "cartoony")


def test_cartoon_is_rounder_and_thicker():
    plain, drawn = build("fork", 0), in_style("fork", "cartoon")

    def volume(model: Model) -> float:
        return signed_volume(model.mesh.vertices * model.size, model.mesh.faces)

    assert volume(drawn) > 1.2 * volume(plain)
    corner = in_style("speaker", "cartoon").mesh.vertices
    assert np.linalg.norm(corner, axis=1).max() < 0.97 * np.linalg.norm([0.5] * 3)


def test_low_poly_is_coarser():
    for key in ("apple", "teapot", "teddy_bear", "bottle"):
        assert len(in_style(key, "low-poly").mesh.faces) < 0.6 * len(build(key, 0).mesh.faces)


def test_flattened_tile_has_few_vivid_colours():
    rng = np.random.default_rng(0)
    tile = np.clip(rng.normal((180, 90, 80), 12, (64, 64, 3)), 0, 255).astype(np.uint8)
    flat = flatten(tile, 4, 1.5)
    assert len(np.unique(flat.reshape(-1, 3), axis=0)) <= 4
    assert np.ptp(flat.mean((0, 1))) > np.ptp(tile.mean((0, 1)))


def test_styled_leaves_the_plain_shape_alone():
    from tabletop_objects.kit.surfaces import Look

    made = CATEGORIES["mug"].shape(Look(np.random.default_rng(0), {}))
    assert apply_style(made, "") is made
