"""The solids: volumes against formulas, texture atlas, curves."""

import numpy as np
import pytest

from generator.objects.checks import is_closed
from generator.scene import Mesh
from tabletop_objects.kit import outlines, solids, surfaces
from tabletop_objects.kit.shapes import mesh_of, pack, shape


def ring(path: np.ndarray) -> solids.Solid:
    return solids.tube(path, 0.1, 12, loop=True)


CIRCLE = np.column_stack([outlines.ellipse(2, 2, 48), np.zeros(48)])

CASES = [
    (solids.box(1, 2, 3), 6.0, 1e-9),
    (solids.block(1, 1, 0.5, 0.1), 0.5 - 0.5 * (4 - np.pi) * 0.01, 1e-3),
    (solids.cylinder(0.5, 2, 64), np.pi * 0.5, 5e-3),
    (solids.cylinder(0.5, 2, 64, top=0.0001), np.pi * 0.5 / 3, 5e-3),
    (solids.ellipsoid(1, 2, 3, 48, 32), np.pi, 1e-2),
    (solids.torus(1, 0.2, 64, 24), 2 * np.pi**2 * 0.04, 2e-2),
    (solids.lathe([(0, 0), (1, 0), (1, 1), (0.5, 1), (0.5, 0.5), (0, 0.5)], 128),
     np.pi * (1 - 0.125), 2e-3),
    (ring(CIRCLE), 2 * np.pi**2 * 0.01, 6e-2),
    (solids.prism(np.array([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2.0]]), 0, 1), 3.0, 1e-9),
]  # fmt: skip


@pytest.mark.parametrize(("solid", "volume", "tolerance"), CASES)
def test_solid_is_closed_and_has_its_volume(solid: solids.Solid, volume: float, tolerance: float):
    assert solid.volume == pytest.approx(volume, rel=tolerance)
    assert solid.uv.min() >= 0 and solid.uv.max() <= 1
    blank = np.zeros((8, 8, 3), np.uint8)
    assert is_closed(Mesh(solid.vertices, solid.faces, solid.uv, blank))


def test_turning_and_moving_keep_volume():
    solid = solids.ellipsoid(0.1, 0.2, 0.3)
    moved = solid.turn(0, 0.7).turn(1, -1.1).turn(2, 2.0).move(1, -2, 3)
    assert moved.volume == pytest.approx(solid.volume)
    np.testing.assert_allclose(solids.box(1, 1, 1).turn(2, np.pi / 2).bounds[1], [0.5, 0.5, 1])


def test_atlas_keeps_each_tile():
    red, blue = surfaces.plain((200, 0, 0)), surfaces.plain((0, 0, 200))
    stripes = surfaces.stripes([(0, 200, 0), (90, 90, 90)], 2)
    boxes = [solids.box(1, 1, 1).move(x=2.0 * k) for k in range(3)]
    made = mesh_of(shape(zip(boxes, (red, blue, stripes), strict=True), ()))
    height, width = made.texture.shape[:2]
    x = np.clip((made.uv[:, 0] * width).astype(int), 0, width - 1)
    y = np.clip(((1 - made.uv[:, 1]) * height).astype(int), 0, height - 1)
    seen = made.texture[y, x].reshape(3, -1, 3)
    assert (seen[0] == (200, 0, 0)).all()
    assert (seen[1] == (0, 0, 200)).all()
    low = made.vertices.reshape(3, -1, 3)[2][:20, 2] < 0.5
    np.testing.assert_array_equal(seen[2][:16][low[:16]], np.tile((0, 200, 0), (8, 1)))


def test_atlas_tiles_do_not_overlap():
    rng = np.random.default_rng(0)
    sizes = ((8, 8), (64, 32), (128, 128), (16, 96))
    tiles = [rng.integers(0, 255, (h, w, 3), np.uint8) for h, w in sizes]
    atlas, corners = pack(tiles)
    for tile, (x, y) in zip(tiles, corners, strict=True):
        np.testing.assert_array_equal(atlas[y : y + tile.shape[0], x : x + tile.shape[1]], tile)


def test_crossing_outline_is_refused():
    with pytest.raises(ValueError, match="crosses itself"):
        solids.prism(np.array([[0, 0], [1, 1], [1, 0], [0, 1.0]]), 0, 1)
