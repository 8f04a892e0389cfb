"""Action modes: documented amounts, limits, and bad input."""

from __future__ import annotations

import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.errors import InputError
from tabletopgen_env.actions import (
    EE_LEASH,
    EE_STEP,
    EE_TURN,
    JOINT_LEASH,
    JOINT_STEP,
    SUBSTEPS,
    controller,
)
from tabletopgen_env.composition import TIMESTEP
from tabletopgen_env.env import TabletopEnv, make_env


@pytest.fixture
def ee() -> TabletopEnv:
    """End-effector mode at a table with one cube out of the way, the hand 0.3 m over the table."""
    env = make_env(toy_scene((toy_object("cube_1", (0.04, 0.04, 0.04), (0.45, -0.2)),)))
    env.reset(seed=0, options={"goal": (0.2, 0.0)})
    act(env, [0, 0, -1, 0, 1], 9)
    act(env, [0, 0, 0, 0, 1], 8)
    return env


def act(env: TabletopEnv, action, times: int) -> None:
    for _ in range(times):
        env.step(np.array(action, np.float32))


def tool(env: TabletopEnv) -> np.ndarray:
    """Tool centre point in the base frame."""
    return env.world.to_base(env.world.data.site_xpos[env.world.tcp])


def yaw(env: TabletopEnv) -> float:
    hand = env.world.base_rotation.T @ env.world.data.site_xmat[env.world.tcp].reshape(3, 3)
    return float(np.arctan2(hand[1, 0], hand[0, 0]))


def test_a_step_takes_a_twentieth_of_a_second(ee) -> None:
    before = ee.world.data.time
    act(ee, np.zeros(5), 1)
    assert ee.world.data.time - before == pytest.approx(1 / 20) == SUBSTEPS * TIMESTEP


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("sign", [1.0, -0.5])
def test_ee_delta_moves_the_tool_by_the_documented_amount(ee, axis, sign) -> None:
    before, action = tool(ee), np.zeros(5)
    action[axis] = sign
    act(ee, action, 3)
    act(ee, np.zeros(5), 10)
    wanted = np.zeros(3)
    wanted[axis] = 3 * sign * EE_STEP
    assert np.allclose(tool(ee) - before, wanted, atol=1e-3)


def test_ee_delta_follows_without_lag(ee) -> None:
    act(ee, [1, 0, 0, 0, 1], 2)
    before = tool(ee)
    act(ee, [1, 0, 0, 0, 1], 1)
    assert np.allclose(tool(ee) - before, [EE_STEP, 0, 0], atol=5e-3)


def test_ee_delta_turns_the_hand_and_keeps_it_pointing_down(ee) -> None:
    before = yaw(ee)
    act(ee, [0, 0, 0, 1, 1], 4)
    act(ee, np.zeros(5), 10)
    assert yaw(ee) - before == pytest.approx(4 * EE_TURN, abs=0.01)
    assert ee.world.data.site_xmat[ee.world.tcp].reshape(3, 3)[2, 2] < -0.9999


def test_standing_still_stays(ee) -> None:
    before = tool(ee)
    act(ee, [0, 0, 0, 0, 1], 40)
    assert np.allclose(tool(ee), before, atol=1e-3)


def test_pressing_on_the_table_does_not_wind_up(ee) -> None:
    act(ee, [0, 0, -1, 0, -1], 60)
    pressed = tool(ee)[2]
    assert pressed > -0.03  # the table top is 1 cm below the base
    act(ee, [0, 0, 1, 0, -1], 4)
    assert tool(ee)[2] - pressed > 4 * EE_STEP - EE_LEASH - 0.01


def test_joint_delta_turns_each_joint_by_the_documented_amount() -> None:
    env = make_env(toy_scene(), action="joint_delta")
    env.reset(seed=0)
    joints = env.world.data.qpos[env.world.arm_qpos].copy()
    action = np.array([0.5, -0.5, 0.25, -0.5, 0.5, 0.5, -1.0, 1.0])
    act(env, action, 2)
    act(env, [0] * 7 + [1], 12)
    moved = env.world.data.qpos[env.world.arm_qpos] - joints
    assert np.allclose(moved, 2 * JOINT_STEP * action[:7], atol=5e-3)


def test_joint_commands_stay_in_range_and_near_the_arm() -> None:
    env = make_env(toy_scene(), action="joint_delta")
    env.reset(seed=0)
    world = env.world
    low, high = world.model.actuator_ctrlrange[world.actuators[:7]].T
    for _ in range(40):
        env.step(np.array([1.0] * 7 + [0.0]))
        command = world.data.ctrl[world.actuators[:7]]
        assert (command >= low).all() and (command <= high).all()
    ahead = command - world.data.qpos[world.arm_qpos]
    assert np.abs(ahead).max() <= 3 * JOINT_LEASH


@pytest.mark.parametrize(("command", "opening"), [(1.0, 0.08), (0.0, 0.04), (-1.0, 0.0)])
def test_the_gripper_goes_to_its_opening(ee, command, opening) -> None:
    act(ee, [0, 0, 0, 0, command], 25)
    assert ee.world.data.qpos[ee.world.finger_qpos].sum() == pytest.approx(opening, abs=5e-3)


def test_out_of_range_actions_are_clipped() -> None:
    a, b = make_env(toy_scene()), make_env(toy_scene())
    a.reset(seed=0)
    b.reset(seed=0)
    assert np.array_equal(a.step(np.full(5, 50.0))[0], b.step(np.ones(5))[0])


@pytest.mark.parametrize("mode", ["ee_delta", "joint_delta"])
@pytest.mark.parametrize(
    ("action", "message"),
    [
        (np.zeros(3), r"shape \(\d,\), got \(3,\)"),
        (np.zeros((1, 5)), r"shape \(\d,\), got \(1, 5\)"),
        (0.5, r"shape \(\d,\), got \(\)"),
        ("forward", "numbers, got 'forward'"),
        (None, r"got \(\)"),
    ],
)
def test_actions_of_wrong_shape_are_refused(mode, action, message) -> None:
    env = make_env(toy_scene(), action=mode)
    env.reset(seed=0)
    with pytest.raises(InputError, match=message):
        env.step(action)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_actions_that_are_not_finite_are_refused_and_change_nothing(bad) -> None:
    env = make_env(toy_scene())
    env.reset(seed=0)
    before = env.world.data.qpos.copy()
    with pytest.raises(InputError, match="must be finite"):
        env.step(np.array([0, 0, bad, 0, 0]))
    assert np.array_equal(env.world.data.qpos, before)


def test_unknown_modes_name_the_known_ones() -> None:
    with pytest.raises(InputError, match="Available: ee_delta, joint_delta"):
        controller("torque")
