"""The batched core gives the values of the single environment, term by term."""

from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
import pytest
import torch
from extent import count
from toy import toy_scene

from tabletopgen_env.actions import ACTIONS, Servos
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.expert.run import TaskExpert
from tabletopgen_env.parallel.core import rewards
from tabletopgen_env.parallel.core.arms import arms_at, ik_steps, rotation_vectors, rotations_of
from tabletopgen_env.parallel.core.controls import RobotPose, advance, restart, start_commands
from tabletopgen_env.parallel.core.flat_states import flat_states, slot_orders
from tabletopgen_env.parallel.core.goal_rows import GoalRows, goal_vectors
from tabletopgen_env.parallel.core.readings import Readings, WorldRows
from tabletopgen_env.parallel.core.vectors import agreement
from tabletopgen_env.robot.chain import chain_at
from tabletopgen_env.robot.kinematics import LOWER, UPPER, forward, ik_step, rotation_vector

OBJECTS = 12
SEEDS, STEPS = 2, count(200, 120)


@dataclass
class Frames:
    """Steps of one environment, a row each, and its results."""

    seen: Readings
    rows: GoalRows
    active: np.ndarray
    present: np.ndarray
    half: np.ndarray
    order: list[list[int]]
    states: np.ndarray
    vectors: np.ndarray
    rewards: np.ndarray
    terms: dict[str, np.ndarray]


def play(env: TabletopEnv) -> Frames:
    """Play some episodes with the expert, sometimes perturbed."""
    count, most = SEEDS * STEPS, env.task.most
    gathered, rows = WorldRows(count, OBJECTS, most), GoalRows.blank(count, most)
    present, half = np.zeros((count, OBJECTS), bool), np.zeros((count, OBJECTS, 3))
    kept: dict[str, list[Any]] = {
        "active": [], "order": [], "states": [], "vectors": [], "rewards": [], "terms": [],
    }  # fmt: skip
    rng, row = np.random.default_rng(0), 0
    for seed in range(SEEDS):
        env.reset(seed=seed)
        expert = TaskExpert(env, patience=2.0)
        expert.reset()
        for step in range(STEPS):
            action = expert.act() if seed or step % 7 else rng.uniform(-1, 1, 5)
            state, reward, _, _, info = env.step(action)
            world = env.world
            gathered.copy(row, world, env.episode.goals)
            rows.write(row, world, env.episode)
            present[row, : len(world.names)] = True
            half[row, : len(world.names)] = world.half_extent
            desired = env.task.desired_goal(world, env.episode)
            achieved = env.task.achieved_goal(world, env.episode, desired)
            now = {
                "active": info["goals"][0],
                "order": [world.index(name) for name in env._order],
                "states": state,
                "vectors": np.concatenate([achieved, desired]),
                "rewards": reward,
                "terms": info["reward_terms"],
            }
            for name, value in now.items():
                kept[name].append(value)
            row += 1
    terms = {name: np.array([t[name] for t in kept["terms"]]) for name in kept["terms"][0]}
    stacked = {k: np.array(kept[k]) for k in ("active", "states", "vectors", "rewards")}
    return Frames(seen=gathered.read(), rows=rows, present=present, half=half, order=kept["order"],
                  terms=terms, **stacked)  # fmt: skip


def as_torch(values: Any) -> Any:
    """The same dataclass with torch tensors."""
    made = {f.name: torch.from_numpy(np.asarray(getattr(values, f.name))) for f in fields(values)}
    return replace(values, **made)


@pytest.mark.parametrize("name", ["Reach", "Lift", "PickPlace", "Swap"])
def test_observation_reward_and_terms_are_those_of_the_single_environment(name: str) -> None:
    frames = check_parity(make_env(toy_scene(), task=name))
    assert name == "Swap" or frames.terms["success"].any(), "no success was compared"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["Push", "Stack", "Sequence", "Tidy"])
def test_the_other_tasks_have_the_same_numbers(name: str) -> None:
    scenes = None if name == "Tidy" else toy_scene()
    check_parity(make_env(scenes, task=name))


def check_parity(env: TabletopEnv) -> Frames:
    """Compare the core's results on NumPy and on torch with those of the environment."""
    frames = play(env)
    assert np.ptp(frames.rewards) > 0.05, "nothing happened"
    for seen, rows, array in (
        (frames.seen, frames.rows, np.asarray),
        (as_torch(frames.seen), as_torch(frames.rows), torch.from_numpy),
    ):
        achieved, desired = goal_vectors(rows, seen)
        found_vectors = np.concatenate([achieved, desired], axis=1)
        np.testing.assert_allclose(found_vectors, frames.vectors, atol=2e-7)
        wide = [v.double() if isinstance(v, torch.Tensor) else v.astype(float)
                for v in (achieved, desired)]  # fmt: skip
        found = agreement(*wide, env.task.aside)
        assert np.array_equal(found.active, frames.active)
        terms = rewards.terms(rows, seen, found, env.task.aside)
        assert set(terms) == set(frames.terms)
        for name, values in frames.terms.items():
            np.testing.assert_allclose(terms[name], values, atol=2e-6, err_msg=name)
        reward = rewards.weigh(terms, env.task.weights, sparse=False)
        np.testing.assert_allclose(reward, frames.rewards, atol=2e-6)
        active = array(frames.active)
        first = slot_orders(rows, seen, active, array(frames.present))
        began = np.r_[True, np.diff(frames.active) != 0]
        began[::STEPS] = True
        order = np.array([o + [-1] * (OBJECTS - len(o)) for o in frames.order])
        assert np.array_equal(np.asarray(first)[:, 0], order[:, 0]), "the target comes first"
        assert (np.sort(first, axis=1) == np.sort(order, axis=1)).all(), "all are there once"
        states = flat_states(rows, seen, active, array(order), array(frames.half))
        np.testing.assert_allclose(states, frames.states, atol=3e-6)
    return frames


def test_slots_are_ordered_as_when_the_goal_became_active() -> None:
    env = make_env(toy_scene(), task="PickPlace")
    for seed in range(6):
        env.reset(seed=seed)
        gathered, rows = WorldRows(1, OBJECTS, 1), GoalRows.blank(1, 1)
        gathered.copy(0, env.world, env.episode.goals)
        seen = gathered.read()
        rows.write(0, env.world, env.episode)
        present = np.arange(OBJECTS)[None] < len(env.world.names)
        order = slot_orders(rows, seen, np.zeros(1, int), present)[0]
        assert [env.world.names[k] for k in order if k >= 0] == env._order


def test_arms_and_their_inverse_are_those_of_one_arm() -> None:
    rng = np.random.default_rng(0)
    joints = rng.uniform(LOWER, UPPER, (200, 7))
    wanted = [forward(q) for q in rng.uniform(LOWER, UPPER, (200, 7))]
    position, rotation = (np.array(part) for part in zip(*wanted, strict=True))
    arms, steps = arms_at(joints), ik_steps(joints, position, rotation, 0.05)
    for k, q in enumerate(joints):
        point, hand = forward(q)
        np.testing.assert_allclose(arms.tool[k], point, atol=1e-13)
        np.testing.assert_allclose(arms.hand[k], hand, atol=1e-13)
        np.testing.assert_allclose(arms.jacobian[k], chain_at(q).jacobian(), atol=1e-13)
        np.testing.assert_allclose(steps[k], ik_step(q, position[k], rotation[k])[0], atol=1e-9)
    on_torch = ik_steps(*(torch.from_numpy(v) for v in (joints, position, rotation)), 0.05)
    np.testing.assert_allclose(on_torch, steps, atol=1e-9)


def test_rotation_vectors_there_and_back() -> None:
    rng = np.random.default_rng(1)
    vectors = rng.normal(size=(50, 3)) * np.logspace(-9, 0, 50)[:, None]
    turns = rotations_of(vectors)
    np.testing.assert_allclose(rotation_vectors(turns), vectors, atol=1e-12)
    for turn, vector in zip(turns, vectors, strict=True):
        np.testing.assert_allclose(rotation_vector(turn), vector, atol=1e-12)


@pytest.mark.parametrize("gripper", ["continuous", "binary"])
@pytest.mark.parametrize("mode", ACTIONS)
def test_controls_are_those_of_the_single_environment(mode: str, gripper: str) -> None:
    for hz in (20, 50, 10):
        env = make_env(toy_scene(), task="Reach", action=mode, gripper=gripper, control_hz=hz)
        rng = np.random.default_rng(0)
        env.reset(seed=0)
        servos = Servos(hz, gripper)
        commands = start_commands(env.world.state.joints[None].copy())
        for _ in range(15):
            world = env.world
            action = rng.uniform(-1, 1, env.action_space.shape).astype(np.float32)
            state = world.state
            pose = RobotPose(state.joints[None], world.to_base(state.tool)[None], world.hand[None])
            commands, ctrl = advance(mode, servos, commands, pose, action[None].astype(float))
            env.controller.apply(world, action.astype(float))
            given = [*state.servos, *state.gripper]
            np.testing.assert_allclose(ctrl[0], given, rtol=0, atol=1e-7)
            world.step(servos.substeps)


def test_some_rows_start_again_and_the_others_go_on() -> None:
    rng = np.random.default_rng(0)
    before = start_commands(rng.uniform(LOWER, UPPER, (3, 7)))
    joints = rng.uniform(LOWER, UPPER, (3, 7))
    after = restart(before, joints, np.array([False, True, False]))
    fresh = start_commands(joints)
    for f in fields(before):
        old, new, wanted = (getattr(c, f.name) for c in (before, after, fresh))
        assert np.array_equal(new[[0, 2]], old[[0, 2]]) and np.array_equal(new[1], wanted[1])
