import numpy as np
import pytest
from toy import toy_object
from worlds import world_of

from generator.scene import Object
from tabletopgen_env.expert.path import CLEAR, clear_height
from tabletopgen_env.expert.planning.grasps import TIP, Grasp, plan_grasps
from tabletopgen_env.expert.planning.heights import height_map, move_parts


def grasps_of(*objects: Object) -> list[Grasp]:
    return plan_grasps(world_of(*objects), objects[0].name)


def test_a_box_is_taken_by_its_middle_across_its_narrow_side() -> None:
    best = grasps_of(toy_object("box", (0.12, 0.04, 0.06), (0.1, 0.05), yaw=0.5))[0]
    np.testing.assert_allclose(best.point[:2], [0.1, 0.05], atol=0.006)
    across = 0.5 + np.pi / 2
    assert abs((best.angle - across + np.pi / 2) % np.pi - np.pi / 2) < np.deg2rad(10)
    assert best.width == pytest.approx(0.04, abs=0.008)
    assert 0.74 + 0.002 <= best.point[2] - TIP < 0.74 + 0.06


def test_what_is_too_wide_has_no_grasp() -> None:
    assert not grasps_of(toy_object("block", (0.1, 0.1, 0.1), (0.0, 0.0)))


def test_a_wide_cup_is_taken_by_its_wall() -> None:
    found = grasps_of(toy_object("bowl", (0.16, 0.16, 0.07), (0.0, 0.0), wall=0.008))
    best = found[0]
    assert best.width < 0.02
    assert 0.06 < np.linalg.norm(best.point[:2]) < 0.085
    radial = np.arctan2(best.point[1], best.point[0])
    assert abs((best.angle - radial + np.pi / 2) % np.pi - np.pi / 2) < np.deg2rad(20)


def test_neighbours_forbid_the_sides_they_stand_at() -> None:
    cube = toy_object("cube", (0.04, 0.04, 0.04), (0.0, 0.0))
    left, right = (toy_object(f"wall_{x}", (0.02, 0.1, 0.04), (x, 0.0)) for x in (-0.042, 0.042))
    alone, hemmed = grasps_of(cube), grasps_of(cube, left, right)
    along_x = [g for g in alone if np.cos(g.angle) ** 2 > 0.9]
    assert along_x and hemmed
    assert not [g for g in hemmed if np.cos(g.angle) ** 2 > 0.9]


def test_a_tall_neighbour_forbids_the_palm() -> None:
    cube = toy_object("cube", (0.04, 0.04, 0.04), (0.0, 0.0))
    tower = toy_object("tower", (0.04, 0.04, 0.3), (0.085, 0.0))
    assert not [g for g in grasps_of(cube, tower) if np.cos(g.angle) ** 2 > 0.9]


def test_failed_grasps_rank_last() -> None:
    world = world_of(toy_object("can", (0.06, 0.06, 0.1), (0.0, 0.0), kind="cylinder"))
    best = plan_grasps(world, "can")[0]
    other = plan_grasps(world, "can", avoid=(best,))[0]
    turn = abs((other.angle - best.angle + np.pi / 2) % np.pi - np.pi / 2)
    assert turn >= np.deg2rad(19) or np.linalg.norm(other.point - best.point) >= 0.014


def test_grasps_follow_the_object_as_it_lies_now() -> None:
    world = world_of(toy_object("box", (0.15, 0.05, 0.05), (0.0, 0.0)))
    world.teleport("box", np.array([0.2, 0.1, 0.765]), np.array([np.sqrt(0.5), 0, 0, np.sqrt(0.5)]))
    best = plan_grasps(world, "box")[0]
    np.testing.assert_allclose(best.point[:2], [0.2, 0.1], atol=0.008)
    assert np.cos(best.angle) ** 2 > 0.9


def test_height_map_of_a_moved_box() -> None:
    box = toy_object("box", (0.1, 0.06, 0.04), (0.0, 0.0))
    turn = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    parts = move_parts(box.parts, np.array([0.3, 0.2, 0.5]), turn)
    heights = height_map(parts, np.array([0.2, 0.1]), np.array([0.4, 0.3]), 0.002)
    assert heights.at(np.array([0.3, 0.24])) == pytest.approx(0.52)
    assert heights.at(np.array([0.34, 0.2])) == -np.inf
    assert heights.at(np.array([9.0, 9.0])) == -np.inf


def test_the_way_goes_over_what_stands_in_it() -> None:
    cube = toy_object("cube", (0.04, 0.04, 0.04), (-0.3, 0.0))
    tower = toy_object("tower", (0.05, 0.05, 0.2), (0.0, 0.0))
    world = world_of(cube, tower)
    start, end, far = (np.array(p) for p in ([-0.3, 0, 0.9], [0.3, 0, 0.8], [-0.3, 0.3, 0.8]))
    assert clear_height(world, "cube", start, end) == pytest.approx(0.94 + CLEAR, abs=2e-3)
    assert clear_height(world, "cube", start, far) == pytest.approx(0.74 + CLEAR, abs=2e-3)
    beside, past = np.array([-0.3, 0.1, 0.9]), np.array([0.3, 0.1, 0.9])
    assert clear_height(world, "cube", beside, past) == pytest.approx(0.94 + CLEAR, abs=2e-3)
    assert clear_height(world, "cube", beside, past, 0.02) == pytest.approx(0.74 + CLEAR, abs=2e-3)


@pytest.mark.parametrize("width", [0.07, 0.0715])
def test_what_barely_fits_the_hand_does_so_however_it_lies(width: float) -> None:
    size, rng = (width, width, 0.06), np.random.default_rng(0)
    counts = {
        len(grasps_of(toy_object("box", size, tuple(rng.uniform(-0.1, 0.1, 2)), yaw=yaw)))
        for yaw in rng.uniform(-np.pi, np.pi, 4)
    }
    assert len(counts) == 1 and counts != {0}


def test_the_palm_comes_nearer_where_it_must_and_only_there() -> None:
    cube = toy_object("cube", (0.04, 0.04, 0.04), (0.0, 0.0))
    towers = [toy_object(f"tower_{y}", (0.3, 0.02, 0.3), (0.0, y)) for y in (-0.05, 0.05)]
    hemmed = [g for g in grasps_of(cube, *towers) if np.cos(g.angle) ** 2 > 0.9]
    best = grasps_of(cube)[0]
    assert hemmed and max(g.score for g in hemmed) < best.score - 1
