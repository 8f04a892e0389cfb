"""Height maps: scans of each part equal scans of everything."""

import numpy as np
from toy import corners

from generator.scene import ConvexPart
from tabletopgen_env.affordance import top_surface
from tabletopgen_env.expert.planning.heights import HeightMap, height_map, solid


def test_a_height_map_is_the_top_surface_over_its_whole_grid() -> None:
    rng = np.random.default_rng(0)
    inside = [ConvexPart(rng.uniform(-0.1, 0.1, (8, 3)) + at) for at in rng.uniform(0, 0.4, (6, 3))]
    box = ConvexPart(corners([0.125, 0.125, 0.0], [0.25, 0.25, 0.7]))  # its sides lie on cells
    outside = ConvexPart(corners([1.0, 1.0, 0.0], [1.1, 1.1, 0.1]))
    parts = (*inside, box, outside)
    low, high, cell = np.zeros(2), np.array([0.375, 0.3125]), 2.0**-6
    found = height_map(parts, low, high, cell)
    xs, ys = (np.arange(low[k], high[k] + cell, cell) for k in (0, 1))
    points = np.stack(np.meshgrid(xs, ys, indexing="ij"), -1)
    whole = top_surface(parts, points.reshape(-1, 2)).reshape(points.shape[:2])
    assert np.isinf(whole).any() and np.isfinite(whole).any()
    np.testing.assert_array_equal(found.heights, whole)
    np.testing.assert_array_equal(found.origin, low)


def test_a_height_is_that_of_the_nearest_cell() -> None:
    heights = HeightMap(np.array([1.0, 2.0]), 0.1, np.arange(6.0).reshape(2, 3))
    points = np.array([[[1.04, 2.04], [1.06, 2.16]], [[0.94, 2.0], [1.0, 2.26]]])
    np.testing.assert_array_equal(heights.at(points), [[0.0, 5.0], [-np.inf, -np.inf]])


def test_a_solid_is_filled_where_its_parts_are() -> None:
    low, high = np.array([0.1, 0.2, 0.3]), np.array([0.14, 0.23, 0.32])
    shape = solid((ConvexPart(corners(low, high)),), 0.002, 0.003)
    points = np.random.default_rng(0).uniform(low[:2] - 0.1, high[:2] + 0.1, (500, 2))
    filled = shape.filled.any(-1).ravel()[shape.nearest(points)]
    depth = np.minimum(points - low[:2], high[:2] - points).min(1)
    assert filled[depth > 0.0015].all() and not filled[depth < -0.0015].any()
    assert filled.any() and (depth < -0.05).any(), "also far outside the grid"
