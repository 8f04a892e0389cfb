"""Drawing styles: flatter, thicker, coarser."""

import numpy as np
import pytest

from generator.errors import InputError
from generator.objects.checks import fingerprint, mass_of
from generator.scene import Model
from tabletop_objects import CATEGORIES, build
from tabletop_objects.kit.solids import signed_volume
from tabletop_objects.kit.styles import STYLES, apply_style, flatten


def in_style(key: str, style: str, seed: int = 0) -> Model:
    return build(key, seed, attributes={"style": style})


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
