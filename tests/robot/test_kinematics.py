import mujoco
import numpy as np
import pytest

from tabletopgen_env.robot import franka, kinematics
from tabletopgen_env.robot.chain import chain_at
from tabletopgen_env.robot.kinematics import (
    HIGHEST,
    HOME,
    LOWER,
    LOWEST,
    UPPER,
    forward,
    ik_step,
    is_beyond_reach,
    link_frames,
    pointing_down,
    rotation_vector,
    solve_ik,
)
from tabletopgen_env.robot.panda import Panda

DOWN = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])


def about_z(yaw: float) -> np.ndarray:
    c, s = np.cos(yaw), np.sin(yaw)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])


def test_forward_and_jacobian_agree_with_the_simulated_robot() -> None:
    model = Panda().spec().compile()
    data = mujoco.MjData(model)
    rng = np.random.default_rng(0)
    for joints in rng.uniform(LOWER, UPPER, (20, 7)):
        data.qpos[:7] = joints
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        jac = np.zeros((6, model.nv))
        mujoco.mj_jacSite(model, data, jac[:3], jac[3:], model.site("tcp").id)
        position, rotation = forward(joints)
        np.testing.assert_allclose(position, data.site("tcp").xpos, atol=1e-9)
        np.testing.assert_allclose(rotation, data.site("tcp").xmat.reshape(3, 3), atol=1e-9)
        np.testing.assert_allclose(chain_at(joints).jacobian(), jac[:, :7], atol=1e-9)


@pytest.mark.slow
def test_ik_meets_random_reachable_poses() -> None:
    rng = np.random.default_rng(1)
    solved = 0
    for joints in rng.uniform(LOWER + 0.1, UPPER - 0.1, (100, 7)):
        position, rotation = forward(joints)
        found = solve_ik(position, rotation)
        if not found.solved:
            continue
        solved += 1
        reached, turned = forward(found.joints)
        assert np.linalg.norm(reached - position) < 1e-3
        assert np.linalg.norm(rotation_vector(rotation @ turned.T)) < 1e-2
        assert (found.joints >= LOWER).all() and (found.joints <= UPPER).all()
    assert solved >= 97


def test_ik_meets_every_top_grasp_over_a_table() -> None:
    rng = np.random.default_rng(2)
    for _ in range(100):
        radius, bearing = rng.uniform(0.3, 0.72), rng.uniform(-1.5, 1.5)
        position = np.array(
            [radius * np.cos(bearing), radius * np.sin(bearing), rng.uniform(0, 0.1)]
        )
        assert solve_ik(position, about_z(rng.uniform(-1.57, 1.57)) @ DOWN).solved


def test_ik_says_when_a_target_is_out_of_reach() -> None:
    found = solve_ik(np.array([1.2, 0.0, 0.2]), DOWN)
    assert not found.solved
    assert found.position_error > 0.3


def test_ik_stays_near_where_it_started() -> None:
    position, rotation = forward(HOME)
    found = solve_ik(position + np.array([0.01, 0, 0]), rotation, HOME)
    assert np.abs(found.joints - HOME).max() < 0.1


def test_a_step_at_the_target_relaxes_towards_the_posture_without_moving_the_tool() -> None:
    rng = np.random.default_rng(3)
    start = HOME + rng.uniform(-0.3, 0.3, 7)
    position, rotation = forward(start)
    joints = start
    for _ in range(100):
        joints, far, _ = ik_step(joints, position, rotation)
        assert far < 5e-3
    assert np.linalg.norm(joints - HOME) < np.linalg.norm(start - HOME)


def test_an_arm_that_is_stretched_out_comes_back_by_no_longer_steps() -> None:
    rng = np.random.default_rng(4)
    for joints in rng.uniform(LOWER, UPPER, (200, 7)):
        joints[3] = rng.uniform(-0.6, UPPER[3])  # beyond where the elbow stays by itself
        position, rotation = forward(joints + rng.normal(0.0, 0.3, 7))
        for _ in range(10):
            new = ik_step(joints, position, rotation)[0]
            assert np.abs(new - joints).max() <= kinematics.MAX_STEP + 1e-12
            joints = new
        assert joints[3] <= -0.62, "it comes back"


@pytest.mark.parametrize("angle", [0.0, 1e-9, 0.5, 3.0, np.pi - 1e-9, np.pi])
def test_rotation_vector(angle: float) -> None:
    axis = np.array([2.0, -1.0, 0.5]) / np.sqrt(5.25)
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    rotation = np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k
    vector = rotation_vector(rotation)
    assert np.linalg.norm(vector) == pytest.approx(angle, abs=1e-6)
    if angle > 1e-6:
        assert abs(vector @ axis) == pytest.approx(angle, abs=1e-5)


def test_constants_do_not_change() -> None:
    with pytest.raises(ValueError, match="read-only"):
        kinematics.HOME[0] = 1.0


@pytest.mark.slow
def test_what_is_beyond_reach_has_no_solution() -> None:
    rng = np.random.default_rng(0)
    beyond = 0
    while beyond < 12:
        height, radius, bearing = rng.uniform((0.3, 0.5, -1.5), (0.7, 0.9, 1.5))
        at = np.array([radius * np.cos(bearing), radius * np.sin(bearing), height])
        near = at - 0.01 * at / np.linalg.norm(at)
        if is_beyond_reach(at) and not is_beyond_reach(near):  # by less than a centimetre
            beyond += 1
            for yaw in rng.uniform(-np.pi, np.pi, 3):
                assert not solve_ik(at, pointing_down(yaw)).solved


def test_what_the_arm_reaches_is_not_beyond_reach() -> None:
    rng = np.random.default_rng(1)
    for _ in range(300):
        joints = rng.uniform(LOWEST, HIGHEST)
        joints[3] = rng.uniform(-1.2, HIGHEST[3])
        wrist, (x, y) = link_frames(joints)[5, :3, 3], rng.normal(size=2)
        aside = franka.JOINTS[6].a * np.array([x, y]) / np.hypot(x, y)
        tool = wrist + np.array([*aside, -franka.FLANGE - franka.TCP])  # of a hand that points down
        assert not is_beyond_reach(tool)
