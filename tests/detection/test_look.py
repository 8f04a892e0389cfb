"""The height maps for the detector."""

import numpy as np
import pytest
from toy import toy_object
from worlds import world_of

from tabletopgen_env.detection.look import CELL, CELLS, STEP, look

BOX = toy_object("box", (0.08, 0.04, 0.06), (0.1, 0.05), yaw=0.5)
BESIDE = toy_object("tower", (0.02, 0.02, 0.1), (0.1, 0.12))


def test_the_object_and_all_else_have_a_map_each() -> None:
    seen = look(world_of(BOX, BESIDE), "box")
    own, rest = seen.heights * STEP
    assert own.max() == pytest.approx(0.06, abs=STEP) and rest.max() == pytest.approx(0.1, abs=STEP)
    assert (own > 0).sum() * CELL**2 == pytest.approx(0.08 * 0.04, rel=0.1)
    assert (rest > 0).sum() * CELL**2 == pytest.approx(0.02 * 0.02, rel=0.3)
    assert not (own[rest > 0] > 0).any()


def test_a_map_says_where_things_are() -> None:
    world = world_of(BOX, BESIDE)
    seen = look(world, "box")
    cells = np.argwhere(seen.heights[1] > 0) - (CELLS - 1) / 2
    middle = seen.center + CELL * cells.mean(0)
    np.testing.assert_allclose(middle, world.position("tower")[:2], atol=CELL)
    assert seen.facing == pytest.approx(0.5) and seen.floor == pytest.approx(0.74)


def test_live_poses_count() -> None:
    world = world_of(BOX, BESIDE)
    before = look(world, "box")
    world.teleport("box", world.position("box") + np.array([0.0, -0.05, 0.0]))
    after = look(world, "box")
    assert np.array_equal(before.heights[0], after.heights[0])
    assert not np.array_equal(before.heights[1], after.heights[1])


def test_what_is_too_high_is_as_high_as_can_be_told() -> None:
    seen = look(world_of(toy_object("pole", (0.03, 0.03, 0.6), (0.0, 0.0))), "pole")
    assert seen.heights.max() == 255
