"""Texture atlases: every chart has a separate place, for any number of charts."""

import numpy as np
import pytest

from generator.meshes.unwrap import unwrap
from generator.scene.triangles import weld_index


def soup(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return triangles without shared vertices, each a separate chart."""
    rng = np.random.default_rng(0)
    vertices = rng.uniform(-1.0, 1.0, (3 * count, 3))
    return vertices, np.arange(3 * count).reshape(-1, 3)


@pytest.mark.parametrize(("count", "size"), [(1, 64), (12, 64), (400, 64), (2000, 128)])
def test_charts_lie_inside_also_where_their_gutters_alone_would_fill_the_texture(
    count: int, size: int
) -> None:
    atlas = unwrap(*soup(count), size)
    assert atlas.uv.min() >= 0.0 and atlas.uv.max() <= 1.0
    assert len(np.unique(atlas.face)) >= 0.5 * count
    assert len(np.unique(atlas.texel)) == len(atlas.texel)


def test_vertices_at_one_place_are_one_in_the_order_of_their_places() -> None:
    rng = np.random.default_rng(1)
    places = rng.normal(0, [3.0, 1.0, 1e-4], (50, 3)) - 7.0
    which = rng.integers(0, 50, 400)
    order = np.lexsort(np.round(places / np.ptp(places, axis=0).max() * 1e5).T[::-1])
    rank = np.empty(50, np.int64)
    rank[order] = np.arange(50)
    assert np.array_equal(weld_index(places[which]), np.unique(rank[which], return_inverse=True)[1])
