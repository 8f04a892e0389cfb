"""Fast implementations agree with the plain formulas, exactly or up to rounding."""

import mujoco
import numpy as np
import pytest
from toy import toy_object, toy_scene

from tabletopgen_env.env import make_env
from tabletopgen_env.expert.planning.choice import has_grasp
from tabletopgen_env.expert.planning.grasps import plan_grasps
from tabletopgen_env.parallel.core import vectors
from tabletopgen_env.robot import kinematics
from tabletopgen_env.robot.chain import chain_at
from tabletopgen_env.robot.kinematics import (
    HOME,
    LOWER,
    UPPER,
    forward,
    ik_step,
    link_frames,
    solve_ik,
)
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.tasks.registry import task_named
from tabletopgen_env.tasks.task import first_open
from tabletopgen_env.world.world import World


def plain_step(world: World, substeps: int, before: np.ndarray) -> np.ndarray:
    """Interpolate and step as documented in ``World.step``; return the reached commands."""
    wanted = world.data.ctrl[world.actuators[:7]].copy()
    for k in range(1, substeps + 1):
        commands = before + (wanted - before) / substeps * k
        for servo, command in zip(world.actuators[:7], commands, strict=True):
            world.data.ctrl[servo] = command
        mujoco.mj_step(world.model, world.data)
    return wanted


def plain_touch(world: World, name: str) -> tuple[bool, bool, bool]:
    """Search all contacts for the robot's parts."""
    found = [False, False, False]
    for contact in world.data.contact:
        bodies = [world.model.body(int(world.model.geom_bodyid[g])).name for g in contact.geom]
        if name in bodies:
            other = bodies[1 - bodies.index(name)]
            sides = ("left_finger" in other, "right_finger" in other, other.startswith("panda/"))
            found = [a or b for a, b in zip(found, sides, strict=True)]
    return found[0], found[1], found[2]


def test_worlds_move_as_with_plain_steps() -> None:
    fast, plain = World(toy_scene(), Panda()), World(toy_scene(), Panda())
    rng = np.random.default_rng(0)
    for world in (fast, plain):
        world.reset()
    before = plain.data.ctrl[plain.actuators[:7]].copy()
    down = solve_ik(fast.to_base(fast.position("can_1")), np.diag([1.0, -1.0, -1.0])).joints
    met = set()
    for k in range(40):
        for world in (fast, plain):
            world.data.ctrl[world.actuators[7]] = 255.0 * (k % 3 > 0)
        goal = down + rng.uniform(-0.15, 0.15, 7)
        if k % 4 == 3:
            goal[k % 7] = before[k % 7]  # not every joint moves
        fast.data.ctrl[fast.actuators[:7]] = goal
        plain.data.ctrl[plain.actuators[:7]] = goal
        fast.step(25)
        before = plain_step(plain, 25, before)
        assert np.array_equal(fast.data.qpos, plain.data.qpos)
        assert np.array_equal(fast.data.qvel, plain.data.qvel)
        for name in fast.names:
            assert fast.touches(name) == plain_touch(plain, name)
            met.add(fast.touches(name))
    assert len(met) >= 3, "hardly anything was met: no test"


def plain_frames(joints: np.ndarray) -> np.ndarray:
    """Multiply the transforms of Craig's convention one by one."""
    frames, frame = [], np.eye(4)
    for k, joint in enumerate(kinematics.franka.JOINTS):
        c, s, ca, sa = (
            np.cos(joints[k]),
            np.sin(joints[k]),
            np.cos(joint.alpha),
            np.sin(joint.alpha),
        )
        step = np.array(
            [
                [c, -s, 0.0, joint.a],
                [s * ca, c * ca, -sa, -joint.d * sa],
                [s * sa, c * sa, ca, joint.d * ca],
                [0.0, 0.0, 0.0, 1.0],
            ]
        )
        frame = step if k == 0 else frame @ step
        frames.append(frame)
    return np.array(frames)


def plain_ik_step(joints: np.ndarray, position: np.ndarray, rotation: np.ndarray) -> np.ndarray:
    """Damped least squares, the pull towards home projected onto the null space.

    Joints that would leave their range go to its end, and the others make up for it.
    """
    point, hand = forward(joints)
    error = np.concatenate([position - point, kinematics.rotation_vector(rotation @ hand.T)])
    full = chain_at(joints).jacobian()
    damping = 1e-5 + 1e-2 * min(1.0, float(error @ error))
    highest = UPPER - 0.02
    highest[3] = -0.62
    low, high = np.minimum(LOWER + 0.02, joints + 0.2), np.maximum(highest, joints - 0.2)
    free, ended = np.ones(7, bool), np.zeros(7)
    for _ in range(3):
        jac = full * free
        inverse = np.linalg.solve(jac @ jac.T + damping * np.eye(6), jac).T
        rest = 0.05 * (HOME - joints) * free
        left = error - full @ ended
        step = inverse @ left + rest - inverse @ (jac @ rest) + ended
        step *= min(1.0, 0.2 / max(float(np.abs(step).max()), 1e-9))
        new = joints + step
        out = free & ((new < low) & (step < 0) | (new > high) & (step > 0))
        if not out.any():
            break
        free &= ~out
        ended = ended + np.where(out, np.where(step > 0, high, low) - joints, 0.0)
    return np.clip(new, low, high)


def test_inverse_kinematics_follows_its_formula() -> None:
    rng = np.random.default_rng(0)
    for _ in range(200):
        joints = rng.uniform(LOWER, UPPER)
        np.testing.assert_allclose(link_frames(joints), plain_frames(joints), atol=1e-14)
        tool, rotation = kinematics.forward(rng.uniform(LOWER, UPPER))
        found = ik_step(joints, tool, rotation)
        wanted = plain_ik_step(joints, tool, rotation)
        np.testing.assert_allclose(found[0], wanted, rtol=0, atol=1e-10)
        assert found[1] == np.linalg.norm(tool - forward(joints)[0])


@pytest.mark.slow
@pytest.mark.parametrize("name", ["PickPlace", "Swap", "Sequence"])
def test_goals_agree_as_their_definition_says(name) -> None:
    task = task_named(name)
    env = make_env(toy_scene(), task=task, observation="goal")
    rng = np.random.default_rng(0)
    for seed in range(10):
        desired = env.reset(seed=seed)[0]["desired_goal"]
        achieved = desired.copy()
        goals = achieved.reshape(-1, 8)
        goals[:, :3] += rng.normal(0, 0.03, (len(goals), 3))
        goals[:, 7] = rng.integers(0, 2, len(goals))
        met = [plain_met(a, d) for a, d in zip(goals, desired.reshape(-1, 8), strict=True)]
        for first, second in task.aside.items():
            met[first] |= met[second]
        used = [k for k, d in enumerate(desired.reshape(-1, 8)) if d[3] > 0]
        gaps = task.gaps(achieved, desired)
        assert [gap.met for gap in gaps] == [met[k] for k in used]
        assert first_open(gaps) == next((k for k in used if not met[k]), used[-1])
        rows = (v.astype(np.float64)[None] for v in (achieved, desired))
        agreement = vectors.agreement(*rows, task.aside)
        assert agreement.met[0].tolist() == met and agreement.active.tolist() == [first_open(gaps)]
        across, up = agreement.across[0, used], agreement.up[0, used]
        np.testing.assert_allclose(across, [gap.across for gap in gaps], atol=1e-15)
        np.testing.assert_allclose(up, [gap.up for gap in gaps], atol=1e-15)
        for name, value in vectors.goal_terms(agreement, task.aside).items():
            assert value.item() == pytest.approx(task.goal_terms(gaps)[name], abs=1e-14)


def plain_met(achieved: np.ndarray, desired: np.ndarray) -> bool:
    """Return whether a point is in the upright elliptic cylinder, in the required state."""
    if desired[3] <= 0:
        return True
    x, y, z = achieved[:3].astype(float) - desired[:3].astype(float)
    c, s = np.cos(float(desired[5])), np.sin(float(desired[5]))
    u, v = (c * x + s * y) / desired[3], (c * y - s * x) / desired[4]
    return bool(np.hypot(u, v) <= 1 and abs(z) <= desired[6] and achieved[7] >= desired[7])


@pytest.mark.slow
def test_what_can_be_grasped_is_what_the_arm_reaches_a_grasp_of() -> None:
    walls = [
        toy_object(f"wall_{k}", (0.05, 0.3, 0.2), (x, 0.0)) for k, x in enumerate((-0.045, 0.045))
    ]
    pens = [toy_object(f"pen_{k}", (0.02, 0.02, 0.05), at) for k, at in enumerate(
        ((0.0, 0.0), (0.25, -0.2), (0.9, 0.9)))]  # fmt: skip
    world = World(toy_scene((*pens, *walls)), Panda())
    world.reset()
    planned = {name: bool(plan_grasps(world, name)) for name in world.names}
    assert [planned[f"pen_{k}"] for k in range(3)] == [False, True, True]
    assert [has_grasp(world, f"pen_{k}") for k in range(3)] == [False, True, False]
