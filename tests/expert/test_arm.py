"""Reach of the arm, rotation of the hand, and paths around the base."""

from typing import Any

import mujoco
import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.geometry import rotation_yaw
from tabletopgen_env.env import make_env
from tabletopgen_env.expert.arm import (
    MIDDLE,
    NARROW,
    ROLL,
    around,
    easiest,
    knuckle_is_free,
    stretch,
    turn_left,
    wrist_is_free,
    wrists_are_free,
)
from tabletopgen_env.expert.planning.grasps import TIP
from tabletopgen_env.expert.planning.heights import HeightMap, surroundings
from tabletopgen_env.robot.kinematics import HOME, UPPER, forward
from tabletopgen_env.world.world import World

TOP = 0.74


@pytest.fixture(scope="module")
def table() -> World:
    env = make_env(toy_scene())
    env.reset(seed=0)
    return env.world


@pytest.fixture
def world(table: World) -> World:
    table.reset()
    return table


def over(world: World, radius: float, bearing: float, height: float = 0.1) -> np.ndarray:
    """Return a world point at a distance and bearing from the base."""
    return world.to_world(np.array([radius * np.cos(bearing), radius * np.sin(bearing), height]))


def test_points_beyond_the_arm_are_out_of_reach(world: World) -> None:
    near = stretch(world, (over(world, 0.5, 0.0),), np.pi / 2)
    assert near is not None
    assert stretch(world, (over(world, 0.5, 0.0), over(world, 1.2, 0.0)), np.pi / 2) is None
    assert stretch(world, (over(world, 0.22, 0.0),), np.pi / 2) is None, "beside the base"


def test_of_two_opposite_yaws_the_one_nearer_home_is_taken(world: World) -> None:
    points = (over(world, 0.5, 0.0),)
    assert easiest(world, points, -np.pi / 2) == pytest.approx(np.pi / 2)
    assert easiest(world, (over(world, 1.2, 0.0),), 0.0) is None


def test_the_hand_turns_the_way_its_last_joint_can(world: World) -> None:
    at_home = world.data.site_xpos[world.tcp].copy()
    assert turn_left(world, np.pi / 2 + 0.4, at_home) == pytest.approx(0.4, abs=1e-6)
    # Near its limit the joint cannot go on: half a turn more is half a turn back.
    world.data.qpos[world.arm_qpos[6]] = UPPER[6] - 0.2
    mujoco.mj_forward(world.model, world.data)
    axis = world.base_rotation.T @ world.data.site_xmat[world.tcp].reshape(3, 3)[:, 0]
    yaw = float(np.arctan2(axis[1], axis[0]))
    assert turn_left(world, yaw - 1.5, at_home) == pytest.approx(2 * np.pi - 1.5, abs=1e-6)
    assert turn_left(world, yaw + 1.5, at_home) == pytest.approx(1.5, abs=1e-6)


def test_the_way_leads_around_the_base(world: World) -> None:
    left, right = over(world, 0.5, 1.4), over(world, 0.5, -1.4)
    aim = world.to_base(np.append(around(world, left, right), 0.0))
    assert np.linalg.norm(aim[:2]) > NARROW
    assert 0.8 < np.arctan2(aim[1], aim[0]) < 1.4
    ahead, aside = over(world, 0.6, 0.3), over(world, 0.6, -0.3)
    np.testing.assert_allclose(around(world, ahead, aside), aside[:2])


def test_a_tower_behind_the_hand_stops_the_wrist() -> None:
    def free(height: float) -> bool:
        tower: Any = toy_object("tower", (0.08, 0.08, height), (0.0, 0.0))
        env = make_env(toy_scene((tower, toy_object("cube", (0.04, 0.04, 0.04), (0.3, 0.2)))))
        env.reset(seed=0, options={"target": "cube"})
        world = env.world
        outwards = -world.base_position[:2] / np.linalg.norm(world.base_position[:2])
        at = 0.1 * outwards
        others = surroundings(world, "cube", at - 0.3, at + 0.3, 0.01)
        return wrist_is_free(world, others, at[None], TOP + 0.01)

    assert free(0.1)
    assert not free(0.25)


def test_wrists_are_judged_each_by_its_own_place_and_height(world: World) -> None:
    before = -0.088 * world.base_position[:2] / np.linalg.norm(world.base_position[:2])
    points = np.array([before, before, [0.5, 0.3]])
    tips = TOP + np.array([0.02, 0.12, 0.02])
    pole = toy_pole(np.zeros(3), TOP + 0.25)
    free = wrists_are_free(world, pole, points, tips)
    assert free.tolist() == [False, True, True]
    assert not wrist_is_free(world, pole, points, TOP + 0.02)
    assert wrist_is_free(world, pole, points, TOP + 0.12)


def test_what_is_kept_free_covers_the_links_over_the_hand(world: World) -> None:
    model, data = world.model, world.data
    tool = data.site_xpos[world.tcp]
    tip, yaw = float(tool[2]) - TIP, rotation_yaw(world.hand)
    checked = 0
    for geom in range(model.ngeom):
        name = model.body(model.geom_bodyid[geom]).name
        if name not in ("panda/link6", "panda/link7") or not model.geom_contype[geom]:
            continue
        radius, half = model.geom_size[geom][:2]
        axis = data.geom_xmat[geom].reshape(3, 3)[:, 2]
        low = data.geom_xpos[geom] - axis * half * np.sign(axis[2] or 1.0)
        if name == "panda/link7" and np.linalg.norm((low - tool)[:2]) < 0.01:
            continue  # straight above the hand, which is broader
        checked += 1
        pole = toy_pole(low, float(low[2]) - radius + 0.01)
        if name == "panda/link6":
            assert not wrist_is_free(world, pole, tool[None, :2], tip)
        else:
            assert not knuckle_is_free(world, pole, tool[:2], tip, yaw)
            assert knuckle_is_free(world, pole, tool[:2], tip, yaw + np.pi)
    assert checked == 2


def toy_pole(at: np.ndarray, height: float) -> HeightMap:
    """A height map of one thin pole."""
    cell = 0.004
    origin = at[:2] - 0.4
    heights = np.zeros((200, 200))
    heights[98:103, 98:103] = height
    return HeightMap(origin, cell, heights)


def test_the_hands_yaw_at_home_is_that_of_its_joints() -> None:
    assert rotation_yaw(forward(HOME)[1]) == pytest.approx(ROLL, abs=1e-12)
    assert pytest.approx(ROLL + HOME[6]) == MIDDLE
