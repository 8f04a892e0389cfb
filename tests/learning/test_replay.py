"""Demonstrations in replay buffers, and buffers on disk."""

from pathlib import Path

import gymnasium as gym
import numpy as np
import pytest
import torch
from stable_baselines3 import HerReplayBuffer

from generator.errors import InputError, SceneError
from tabletopgen_env.episodes import HOLD
from tabletopgen_env.learning.demonstrations.recorded import demonstrate
from tabletopgen_env.learning.demonstrations.replay import fill, read_buffer, write_buffer
from tabletopgen_env.learning.setup import many_envs, new_model, single_env, source_of

LIMIT = 60  # of Reach


def filled(recipe, episodes: int = 2, seed: int = 0):
    """A model's replay buffer filled with demonstrations."""
    source = source_of(recipe.scenes, "train")
    envs = many_envs(recipe, source, 0)
    model = new_model(recipe, envs, 0)
    count = fill(model.replay_buffer, single_env(recipe.task, recipe.env, source), episodes, seed)
    return model, envs, count


def test_demonstrations_end_by_the_time_limit_alone(small) -> None:
    model, envs, count = filled(small(), 3)
    buffer = model.replay_buffer
    assert count == 4 and buffer.pos == 2 * LIMIT and not buffer.full
    dones, timeouts = buffer.dones[: buffer.pos], buffer.timeouts[: buffer.pos]
    assert np.array_equal(np.flatnonzero(dones[:, 0]), [LIMIT - 1, 2 * LIMIT - 1])
    assert np.array_equal(dones, timeouts)
    sample = buffer.sample(200)
    assert float(sample.dones.max()) == 0.0, "a time limit is no end: values go on beyond it"
    assert np.array_equal(buffer.observations[1], buffer.next_observations[0])
    ends = buffer.observations[LIMIT], buffer.next_observations[LIMIT - 1]
    assert not np.array_equal(*ends), "an episode's end is not the next one's start"
    assert buffer.rewards[LIMIT - 1].min() == pytest.approx(1.0), "the expert has solved it"
    assert np.abs(buffer.actions[: buffer.pos]).max() <= 1.0
    envs.close()


class Slipping(gym.Wrapper):
    """The first episode succeeds for a while, but not at its end."""

    def reset(self, **given):
        self.episodes = getattr(self, "episodes", 0) + 1
        self.steps = 0
        return super().reset(**given)

    def step(self, action):
        self.steps += 1
        seen, reward, ended, cut, info = super().step(action)
        holds = HOLD < self.steps < LIMIT if self.episodes == 1 else info["success"]
        return seen, reward, ended, cut, info | {"success": holds}


def test_only_what_ends_in_success_is_kept(small) -> None:
    recipe = small(envs=1)
    env = Slipping(single_env(recipe.task, recipe.env, source_of(recipe.scenes, "train")))
    model = new_model(recipe, env, 0)
    fill(model.replay_buffer, env, 1, 0)
    assert env.episodes == 2 and model.replay_buffer.pos == LIMIT
    shown = demonstrate(env, 0, to_the_limit=True)
    assert shown is not None and len(shown.actions) == LIMIT, "success has held long before"


@pytest.mark.slow
def test_a_demonstration_of_pick_place_ends_where_the_thing_belongs(small) -> None:
    recipe = small(task="PickPlace", envs=1, scenes="office-round-*")
    env = single_env(recipe.task, recipe.env, source_of(recipe.scenes, "train"))
    model = new_model(recipe, env, 0)
    assert fill(model.replay_buffer, env, 1, 0) == 1
    buffer = model.replay_buffer
    assert buffer.rewards[buffer.pos - HOLD : buffer.pos] == pytest.approx(1.0), "dense reward"
    assert buffer.timeouts[buffer.pos - 1].all()
    env.close()


def test_demonstrations_can_be_replayed_in_hindsight(small) -> None:
    goal = {"observation": "goal", "reward": "sparse"}
    recipe = small(env=goal, network={"extractor": "goal", "layers": [8]}, hindsight=4,
                   demonstrations=2)  # fmt: skip
    model, envs, _ = filled(recipe)
    buffer = model.replay_buffer
    assert isinstance(buffer, HerReplayBuffer)
    assert (buffer.ep_length[:LIMIT] == LIMIT).all() and (buffer.ep_start[:LIMIT] == 0).all()
    sample = buffer.sample(100)
    assert set(torch.unique(sample.rewards).tolist()) == {-1.0, 0.0}
    assert float(sample.dones.max()) == 0.0
    envs.close()


@pytest.mark.slow
def test_the_same_seed_gives_the_same_demonstrations(small) -> None:
    buffers = []
    for seed in (0, 0, 1):
        model, envs, _ = filled(small(), 2, seed)
        buffers.append(model.replay_buffer.observations)
        envs.close()
    assert np.array_equal(buffers[0], buffers[1])
    assert not np.array_equal(buffers[0], buffers[2])


def test_more_than_fits_is_refused(small) -> None:
    options = {"buffer_size": 150, "learning_starts": 20}
    with pytest.raises(InputError, match="do not fit"):
        filled(small(options=options), 4)


def test_an_expert_that_solves_nothing_ends_in_an_error(small, monkeypatch) -> None:
    monkeypatch.setattr(
        "tabletopgen_env.learning.demonstrations.replay.demonstrate", lambda *a, **k: None
    )
    with pytest.raises(SceneError, match="solves none of 100"):
        filled(small())


def test_returns_of_several_steps_do_not_reach_over_the_seam(small, tmp_path: Path) -> None:
    options = {"learning_starts": 20, "buffer_size": 2000, "n_steps": 3}
    recipe = small(options=options)
    envs = many_envs(recipe, source_of(recipe.scenes, "train"), 0)
    buffer = new_model(recipe, envs, 0).replay_buffer
    seen = envs.reset()
    ends, goes_on = np.array([1.0, 0.0]), np.zeros(2)
    buffer.add(seen, seen, np.zeros((2, 5)), np.full(2, 7.0), ends, [{}, {}])
    write_buffer(buffer, tmp_path / "replay.npz")
    again = new_model(recipe, envs, 0).replay_buffer
    read_buffer(again, tmp_path / "replay.npz")
    assert again.dones[0].tolist() == [1.0, 1.0] and again.timeouts[0].tolist() == [0.0, 1.0]
    for _ in range(3):
        again.add(seen, seen, np.zeros((2, 5)), np.full(2, 1.0), goes_on, [{}, {}])
    np.random.seed(0)  # noqa: NPY002  the buffer draws from it
    rewards = again._get_samples(np.zeros(50, int)).rewards
    assert set(rewards.flatten().tolist()) == {7.0}
    envs.close()


@pytest.mark.parametrize("hindsight", [0, 4])
def test_a_buffer_comes_back_from_disk(small, tmp_path: Path, hindsight: int) -> None:
    goal = {"observation": "goal"} if hindsight else {}
    network = {"extractor": "flat", "layers": [8]}
    recipe = small(env=goal, network=network, hindsight=hindsight, demonstrations=2)
    model, envs, _ = filled(recipe)
    buffer = model.replay_buffer
    obs = envs.reset()
    buffer.add(obs, obs, np.zeros((2, 5)), np.zeros(2), np.zeros(2), [{}, {}])  # unfinished
    write_buffer(buffer, tmp_path / "replay.npz")
    again = new_model(recipe, envs, 0).replay_buffer
    read_buffer(again, tmp_path / "replay.npz")
    assert (again.pos, again.full) == (LIMIT + 1, False)
    assert np.array_equal(again.actions, buffer.actions)
    if hindsight:
        assert isinstance(again, HerReplayBuffer)
        assert again.timeouts[LIMIT].all() and (again.ep_length[LIMIT] == 1).all()
        assert np.array_equal(
            again.observations["desired_goal"], buffer.observations["desired_goal"]
        )
    else:
        assert np.array_equal(again.observations, buffer.observations)
    again.sample(20)
    envs.close()


def test_another_runs_buffer_is_refused(small, tmp_path: Path) -> None:
    model, envs, _ = filled(small())
    path = tmp_path / "replay.npz"
    write_buffer(model.replay_buffer, path)
    other = new_model(small(options={"buffer_size": 500, "learning_starts": 9}), envs, 0)
    with pytest.raises(InputError, match="not a valid replay buffer of this run"):
        read_buffer(other.replay_buffer, path)
    path.write_bytes(path.read_bytes()[:1000])
    with pytest.raises(InputError, match="not a valid replay buffer of this run"):
        read_buffer(model.replay_buffer, path)
    envs.close()
