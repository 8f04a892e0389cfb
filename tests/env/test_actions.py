"""Action modes: documented step sizes, limits, and bad input."""

import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.errors import InputError
from tabletopgen_env.actions import (
    ACTIONS,
    EE_LEASH,
    EE_STEP,
    EE_TURN,
    JOINT_LEASH,
    JOINT_STEP,
    WORKSPACE,
    YAW_LEASH,
    ActionConfig,
    check_action,
)
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.robot.kinematics import rotation_vector
from tabletopgen_env.world.composition import TIMESTEP


def over_the_table(action: str = "ee_delta", **settings) -> TabletopEnv:
    """An action mode at a table with one distant cube, the robot at home."""
    scene = toy_scene((toy_object("cube_1", (0.04, 0.04, 0.04), (0.45, -0.2)),))
    env = make_env(scene, action=action, **settings)
    env.reset(seed=0, options={"goal": (0.2, 0.0)})
    return env


@pytest.fixture
def ee() -> TabletopEnv:
    """An end-effector mode, the hand 0.3 m above the table."""
    env = over_the_table()
    act(env, [0, 0, -1, 0, 1], 9)
    act(env, [0, 0, 0, 0, 1], 8)
    return env


def act(env: TabletopEnv, action, times: int) -> None:
    for _ in range(times):
        env.step(np.array(action, np.float32))


def tool(env: TabletopEnv) -> np.ndarray:
    return env.world.to_base(env.world.data.site_xpos[env.world.tcp])


def hand(env: TabletopEnv) -> np.ndarray:
    return env.world.base_rotation.T @ env.world.data.site_xmat[env.world.tcp].reshape(3, 3)


def yaw(env: TabletopEnv) -> float:
    return float(np.arctan2(hand(env)[1, 0], hand(env)[0, 0]))


def opening(env: TabletopEnv) -> float:
    """Return the distance between the fingers, metres."""
    return env.world.data.qpos[env.world.finger_qpos].sum()


def joints(env: TabletopEnv) -> np.ndarray:
    return env.world.data.qpos[env.world.arm_qpos].copy()


def arm_ranges(env: TabletopEnv) -> np.ndarray:
    """Return the lower and upper bounds of the arm's joint commands."""
    return env.world.model.actuator_ctrlrange[env.world.actuators[:7]].T


def test_a_step_takes_a_twentieth_of_a_second(ee) -> None:
    before = ee.world.data.time
    act(ee, np.zeros(5), 1)
    assert ee.world.data.time - before == pytest.approx(1 / 20) == 25 * TIMESTEP


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


def test_pulling_beyond_reach_stands_still(ee) -> None:
    """A straight arm that is commanded to stretch further must not oscillate."""
    act(ee, [1, 0, 0.4, 0, 1], 40)
    turned, tools = [], []
    for _ in range(20):
        act(ee, [1, 0, 0.4, 0, 1], 1)
        turned.append(joints(ee))
        tools.append(tool(ee))
    assert turned[-1][3] > -0.7, "as far as it goes"
    assert np.abs(np.diff(turned, 2, axis=0)).max() < 0.001
    act(ee, [-1, 0, 0, 0, 1], 8)
    assert tools[-1][0] - tool(ee)[0] > 0.08, "and it comes back at once"


def test_joint_delta_turns_each_joint_by_the_documented_amount() -> None:
    env = over_the_table("joint_delta")
    before = joints(env)
    action = np.array([0.5, -0.5, 0.25, -0.5, 0.5, 0.5, -1.0, 1.0])
    act(env, action, 2)
    act(env, [0] * 7 + [1], 12)
    assert np.allclose(joints(env) - before, 2 * JOINT_STEP * action[:7], atol=5e-3)


def test_joint_commands_stay_in_range_and_near_the_arm() -> None:
    env = over_the_table("joint_delta")
    low, high = arm_ranges(env)
    for _ in range(40):
        env.step(np.array([1.0] * 7 + [0.0]))
        command = env.world.data.ctrl[env.world.actuators[:7]]
        assert (command >= low).all() and (command <= high).all()
    assert np.abs(command - joints(env)).max() <= 3 * JOINT_LEASH


@pytest.mark.parametrize(
    ("gripper", "command", "wide"),
    [("continuous", 1.0, 0.08), ("continuous", 0.0, 0.04), ("continuous", -1.0, 0.0),
     ("binary", 1.0, 0.08), ("binary", 0.0, 0.08), ("binary", -0.01, 0.0)],
)  # fmt: skip
def test_the_gripper_goes_to_its_opening(gripper, command, wide) -> None:
    env = over_the_table("ee_delta_pos", gripper=gripper)
    act(env, [0, 0, 0, command], 25)
    assert opening(env) == pytest.approx(wide, abs=5e-3)


SIZES = {
    "ee_delta": 5,
    "ee_delta_pos": 4,
    "ee_delta_6d": 7,
    "ee_absolute": 5,
    "joint_delta": 8,
    "joint_target": 8,
}


def test_every_mode_is_listed_with_its_size() -> None:
    assert {mode: ActionConfig(mode).controller().space.shape for mode in ACTIONS} == {
        mode: (size,) for mode, size in SIZES.items()
    }
    for mode in ACTIONS:
        space = ActionConfig(mode).controller().space
        assert space.dtype == np.float32 and (space.low == -1).all() and (space.high == 1).all()


@pytest.fixture(scope="module", params=SIZES)
def ready(request) -> TabletopEnv:
    """An environment in each mode, for invalid actions."""
    return over_the_table(request.param)


@pytest.mark.parametrize(
    ("action", "message"),
    [
        (np.zeros(3), r"shape \(\d,\), got \(3,\)"),
        (np.zeros(9), r"shape \(\d,\), got \(9,\)"),
        (np.zeros((1, 5)), r"shape \(\d,\), got \(1, 5\)"),
        (0.5, r"shape \(\d,\), got \(\)"),
        ("forward", "numbers, got 'forward'"),
        ([[1, 2], 3], "numbers, got"),
        (None, r"got \(\)"),
    ],
)
def test_actions_of_wrong_shape_are_refused(ready, action, message) -> None:
    with pytest.raises(InputError, match=message):
        ready.step(action)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("at", [0, -1])
def test_actions_that_are_not_finite_are_refused_and_change_nothing(ready, bad, at) -> None:
    before, ctrl = ready.world.data.qpos.copy(), ready.world.data.ctrl.copy()
    action = np.zeros(ready.action_space.shape)
    action[at] = bad
    with pytest.raises(InputError, match="must be finite"):
        ready.step(action)
    assert np.array_equal(ready.world.data.qpos, before)
    assert np.array_equal(ready.world.data.ctrl, ctrl)


@pytest.mark.parametrize(
    "action", [np.zeros(5, complex), [1j] * 5, ["0"] * 5, np.zeros(5, "datetime64[s]")]
)
def test_what_is_no_number_is_refused(action) -> None:
    with pytest.raises(InputError, match="An action must have 5 real numbers, got"):
        check_action(action, ActionConfig().controller().space)


def test_out_of_range_actions_are_clipped(ready) -> None:
    size, seen = ready.action_space.shape, []
    for action in (np.full(size, 50.0), np.ones(size)):
        ready.reset(seed=0, options={"goal": (0.2, 0.0)})
        seen.append(ready.step(action)[0])
    assert np.array_equal(*seen)


def test_commands_stay_in_range_whatever_is_asked(ready) -> None:
    ready.reset(seed=0, options={"goal": (0.2, 0.0)})
    world, rng = ready.world, np.random.default_rng(0)
    low, high = world.model.actuator_ctrlrange[world.actuators].T
    for _ in range(3):
        action = rng.choice([-1.0, 1.0], ready.action_space.shape)
        for _ in range(6):
            ready.step(action)
            command = world.data.ctrl[world.actuators]
            assert (command >= low).all() and (command <= high).all()
    assert np.isfinite(world.data.qpos).all()


def test_unknown_modes_name_the_known_ones() -> None:
    with pytest.raises(InputError, match="Available: ee_absolute, ee_delta, ee_delta_6d"):
        ActionConfig("torque")
    with pytest.raises(InputError, match="Did you mean 'binary'"):
        ActionConfig(gripper="binery")  # type: ignore[arg-type]


# ------------------------------------------------------------------------------- single modes
def test_ee_delta_pos_moves_as_ee_delta_does_without_turning() -> None:
    both = [over_the_table("ee_delta"), over_the_table("ee_delta_pos")]
    for k in range(10):
        x, y, z, grip = np.sin([k, 2 * k, 3 * k, 4 * k])
        seen = [both[0].step([x, y, z, 0.0, grip])[0], both[1].step([x, y, z, grip])[0]]
        assert np.array_equal(*seen)


def test_ee_delta_6d_turns_about_the_axes_of_the_base() -> None:
    for axis in range(3):
        env = over_the_table("ee_delta_6d")
        action, start = np.zeros(7), hand(env)
        action[3 + axis] = 1.0
        act(env, action, 3)
        act(env, np.zeros(7), 10)
        turned = rotation_vector(hand(env) @ start.T)
        wanted = np.zeros(3)
        wanted[axis] = 3 * EE_TURN
        assert np.allclose(turned, wanted, atol=0.01)


def test_ee_delta_6d_turns_about_the_tool_centre_point() -> None:
    env = over_the_table("ee_delta_6d")
    before = tool(env)
    act(env, [0, 0, 0, 0, 1, 0, 1], 3)
    act(env, np.zeros(7), 10)
    assert np.allclose(tool(env), before, atol=2e-3)


def test_ee_delta_6d_does_not_wind_up() -> None:
    env = over_the_table("ee_delta_6d")
    act(env, [0, 0, 0, 1, 0, 0, 1], 60)
    leaning = hand(env)
    act(env, [0, 0, 0, -1, 0, 0, 1], 6)
    back = rotation_vector(hand(env) @ leaning.T)
    assert back[0] < -(6 * EE_TURN - YAW_LEASH - 0.15)


def test_ee_absolute_goes_where_it_is_sent_and_stays() -> None:
    env = over_the_table("ee_absolute")
    low, high = np.array(WORKSPACE)
    point, turn = np.array([0.45, -0.15, 0.25]), 0.7
    action = [*(2 * (point - low) / (high - low) - 1), turn / (np.pi / 2), 1.0]
    act(env, action, 40)
    assert np.allclose(tool(env), point, atol=2e-3)
    assert yaw(env) == pytest.approx(turn, abs=0.01)


def test_ee_absolute_goes_straight_and_no_faster_than_documented() -> None:
    env = over_the_table("ee_absolute")
    start, seen = tool(env), []
    for _ in range(8):
        env.step(np.array([1.0, 0.5, -0.5, 0.0, 1.0]))
        seen.append(tool(env))
    moved = np.diff([start, *seen], axis=0)
    assert np.linalg.norm(moved, axis=1).max() < 1.3 * EE_STEP
    assert np.linalg.norm(seen[-1] - seen[3]) > 2.5 * EE_STEP  # the joints are near their limits
    along = (seen[-1] - start) / np.linalg.norm(seen[-1] - start)
    aside = np.array(seen) - start
    aside -= np.outer(aside @ along, along)
    assert np.linalg.norm(aside, axis=1).max() < 0.01


def test_ee_absolute_turns_from_end_to_end_through_the_middle() -> None:
    env = over_the_table("ee_absolute")
    middle = [0.55, 0.0, 0.3, 1.0, 1.0]
    act(env, middle, 30)
    assert yaw(env) == pytest.approx(np.pi / 2, abs=0.02)
    seen = []
    for _ in range(40):
        env.step(np.array([*middle[:3], -1.0, 1.0]))
        seen.append(yaw(env))
    assert seen[-1] == pytest.approx(-np.pi / 2, abs=0.02)
    assert min(np.abs(seen)) < 0.1


def test_joint_target_goes_to_the_joints_at_the_documented_speed() -> None:
    env = over_the_table("joint_target")
    low, high = arm_ranges(env)
    start = joints(env)
    wanted = start + np.array([0.5, -0.3, 0.2, -0.3, 0.2, 0.3, -1.0])
    action = np.array([*(2 * (wanted - low) / (high - low) - 1), 1.0])
    act(env, action, 4)
    assert np.abs(joints(env) - start).max() < 4 * JOINT_STEP + 0.01
    act(env, action, 20)
    assert np.allclose(joints(env), wanted, atol=5e-3)


# ----------------------------------------------------------------------------------- the rate
@pytest.mark.slow
@pytest.mark.parametrize("hz", [5, 10, 50, 100])
@pytest.mark.parametrize("mode", ["ee_delta", "joint_delta", "ee_delta_6d"])
def test_at_another_rate_the_speeds_are_the_same(mode, hz) -> None:
    env = over_the_table(mode, control_hz=hz)
    action = np.zeros(env.action_space.shape)
    action[[0, -1]] = [0.5, 1.0]
    before, joint = tool(env), joints(env)[0]
    act(env, action, round(0.4 * hz))
    assert env.world.data.time == pytest.approx(0.4)
    assert env.metadata["render_fps"] == hz
    act(env, [*np.zeros(len(action) - 1), 1.0], round(0.8 * hz))
    if mode == "joint_delta":
        moved = joints(env)[0] - joint
        assert moved == pytest.approx(0.4 * 0.5 * JOINT_STEP * 20, abs=5e-3)
    else:
        assert np.allclose(tool(env) - before, [0.4 * 0.5 * EE_STEP * 20, 0, 0], atol=3e-3)


@pytest.mark.parametrize("hz", [0, -20, 30, 1000, 20.0, True, "20"])
def test_rates_that_do_not_divide_the_steps_are_refused(hz) -> None:
    with pytest.raises(InputError, match=r"control_hz must divide the 500.*10, 20, 25, 50"):
        ActionConfig(control_hz=hz)
