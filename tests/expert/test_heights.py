"""Height maps: each part is scanned where it is, with the heights of a scan of everything."""

from __future__ import annotations

import numpy as np
from toy import corners

from generator.scene import ConvexPart
from tabletopgen_env.affordance import top_surface
from tabletopgen_env.expert.heights import height_map


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
