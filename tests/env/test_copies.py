"""Copies of environments: the same settings and random state, no episode."""

import copy
import multiprocessing
import os
import pickle
from typing import Any

import gymnasium as gym
import numpy as np
import pytest
from toy import toy_scene
from worlds import two_scenes

from generator.errors import InputError
from tabletopgen_env.env import make_env
from tabletopgen_env.parallel.vector import TabletopVectorEnv

ID = "tabletopgen_env:TabletopGen/PickPlace-v0"
SETTINGS: dict[str, dict[str, Any]] = {
    "hinted": {"grasp_hint": True},
    "detected": {"grasp_hint": "detected"},
    "drawn": {
        "observation": "pixels+state", "image_size": 16,
        "render_mode": "rgb_array", "render_size": (16, 16),
    },
    "randomized": {"randomization": "strong", "observation": "goal", "reward": "sparse"},
}  # fmt: skip


def pickled(env: Any) -> Any:
    return pickle.loads(pickle.dumps(env))


def flat(seen: Any) -> np.ndarray:
    """Return an observation's numbers as a flat array."""
    parts = [seen[key] for key in sorted(seen)] if isinstance(seen, dict) else [seen]
    return np.concatenate([np.ravel(part).astype(np.float64) for part in parts])


def played(env: gym.Env, steps: int = 3) -> np.ndarray:
    """Return the results of a reset without seed and some steps, which show the random state."""
    numbers = [flat(env.reset()[0])]
    for _ in range(steps):
        seen, reward, *_ = env.step(np.full(5, 0.3))
        numbers += [flat(seen), np.array([reward])]
    return np.concatenate(numbers)


@pytest.mark.slow
@pytest.mark.parametrize("copied", [pickled, copy.deepcopy])
@pytest.mark.parametrize("settings", SETTINGS.values(), ids=SETTINGS)
def test_a_copy_of_an_episode_under_way_is_to_be_reset_and_goes_on_alike(settings, copied) -> None:
    env = make_env(toy_scene(), **settings)
    env.reset(seed=3)
    for _ in range(3):
        env.step(np.full(5, 0.3))
    env.render()
    other = copied(env)
    for call in (lambda: other.step(np.zeros(5)), lambda: other.world, lambda: other.episode):
        with pytest.raises(InputError, match=r"Call reset\(\)"):
            call()
    env.step(np.full(5, 0.3))
    assert np.array_equal(played(other), played(env))
    assert other.world is not env.world and other.world.model is not env.world.model
    assert other.action_space == env.action_space
    if env.render_mode:
        assert np.array_equal(other.render(), env.render())
    env.close()
    other.close()


def test_a_copy_carries_no_compiled_world() -> None:
    env = make_env(toy_scene(), randomization="light")
    before = len(pickle.dumps(env))
    env.reset(seed=0)
    env.step(np.zeros(5))
    assert len(pickle.dumps(env)) < before + 2000


def test_a_made_environment_is_copied_with_its_wrappers() -> None:
    env = gym.make(ID, scenes=toy_scene(), max_episode_steps=4)
    env.reset(seed=0)
    env.step(np.zeros(5, np.float32))
    other = pickled(env)
    with pytest.raises(InputError, match=r"Call reset\(\)"):
        other.step(np.zeros(5, np.float32))
    assert np.array_equal(other.reset()[0], env.reset()[0])
    assert [other.step(np.zeros(5, np.float32))[3] for _ in range(4)] == [False] * 3 + [True]


@pytest.mark.slow
@pytest.mark.parametrize("copied", [pickled, copy.deepcopy])
def test_a_vector_environment_is_copied_slot_by_slot(copied) -> None:
    envs = gym.make_vec(ID, num_envs=3, scenes=two_scenes(), threads=2, max_episode_steps=2)
    envs.reset(seed=1)
    actions = np.full((3, 5), 0.3, np.float32)
    for _ in range(2):
        envs.step(actions)
    other = copied(envs)
    assert isinstance(envs, TabletopVectorEnv) and isinstance(other, TabletopVectorEnv)
    assert other.autoreset_mode == envs.autoreset_mode
    with pytest.raises(InputError, match=r"Call reset\(\)"):
        other.step(actions)
    assert np.array_equal(other.reset()[0], envs.reset()[0])
    for _ in range(4):
        mine, theirs = envs.step(actions), other.step(actions)
        assert all(np.array_equal(a, b) for a, b in zip(mine[:4], theirs[:4], strict=True))
    assert len({id(world.model) for e in (envs, other) for world in e.get_attr("world")}) == 6
    envs.close()
    assert other.step(actions)[1].shape == (3,)
    other.close()
    with pytest.raises(InputError, match="closed"):
        pickled(other).reset()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_a_forked_vector_environment_says_that_it_has_no_threads() -> None:
    envs = TabletopVectorEnv(2, scenes=toy_scene())
    envs.reset(seed=0)
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)

    def work() -> None:
        try:
            envs.step(np.zeros((2, 5)))
        except InputError as error:
            envs.close()
            sender.send(str(error))

    process = context.Process(target=work, daemon=True)
    process.start()
    try:
        assert receiver.poll(60), "it hangs"
        assert "send a pickled copy" in receiver.recv()
    finally:
        process.kill()
        process.join(60)
    envs.close()
