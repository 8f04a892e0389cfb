"""Perception of the baselines, and cloning of the expert."""

import gymnasium as gym
import numpy as np
import pytest
import torch
from stable_baselines3 import SAC
from toy import toy_scene

from generator.errors import InputError
from generator.threads import torch_threads
from tabletopgen_env.env import make_env
from tabletopgen_env.episodes import HOLD
from tabletopgen_env.learning.demonstrations.cloning import CloningConfig, clone, policy_of
from tabletopgen_env.learning.demonstrations.recorded import demonstrate
from tabletopgen_env.learning.networks.network import TableExtractor
from tabletopgen_env.rendering.views import SLOTS


def lift() -> gym.Env:
    env = make_env(toy_scene(), task="Lift")
    return gym.wrappers.TimeLimit(env, 80)


def test_the_order_of_other_objects_does_not_matter() -> None:
    env = lift()
    seen = env.reset(seed=0, options={"target": "cube_1"})[0]
    slots = seen[40:268].reshape(SLOTS, -1)
    mixed = seen.copy()
    mixed[40:268] = slots[[0, 1, *reversed(range(2, SLOTS))]].ravel()
    torch.manual_seed(0)
    network = TableExtractor(env.observation_space)
    one, two = network(torch.from_numpy(np.stack([seen, mixed])))
    assert not np.array_equal(seen, mixed) and torch.allclose(one, two)
    moved = seen.copy()
    moved[40 + 2 * 19] += 0.1  # another object elsewhere
    assert not torch.allclose(one, network(torch.from_numpy(moved[None]))[0])


def test_other_observations_are_refused() -> None:
    with pytest.raises(InputError, match="observation='state'"):
        TableExtractor(gym.spaces.Box(-1, 1, (7,)))


@pytest.mark.slow
def test_a_demonstration_holds_what_was_seen_done_and_advised() -> None:
    shown = demonstrate(lift(), seed=3)
    assert shown is not None and shown.solved
    assert len(shown.observations) == len(shown.actions) + 1 == len(shown.rewards) + 1
    assert np.array_equal(shown.actions, shown.advice)
    assert (shown.rewards[-HOLD:] == pytest.approx(1.0)) and shown.rewards[0] < 0.9
    shaken = demonstrate(lift(), seed=3, noise=0.2)
    assert shaken is not None and not np.array_equal(shaken.actions, shaken.advice)
    assert np.array_equal(shaken.actions[:, -1], shaken.advice[:, -1])
    idle = demonstrate(lift(), seed=3, policy=lambda seen: np.zeros(5, np.float32))
    assert idle is not None and not idle.solved and np.abs(idle.advice).max() > 0.5


@pytest.mark.slow
def test_what_is_seen_may_be_a_dict_and_infos_are_told() -> None:
    env = gym.wrappers.TimeLimit(make_env(toy_scene(), task="Lift", observation="goal"), 80)
    told: list[dict] = []
    shown = demonstrate(env, seed=3, report=told.append)
    assert shown is not None and set(shown.observations) == set(env.observation_space.spaces)
    seen = shown.observations["observation"]
    assert seen.dtype == np.float32 and len(seen) == len(told) == len(shown.actions) + 1
    assert np.array_equal(seen, demonstrate(lift(), seed=3).observations[:, :268])
    assert "randomization" in told[0] and told[-1]["success"]


@pytest.mark.slow
def test_cloning_comes_nearer_to_the_advice_and_repeats_itself() -> None:
    config = CloningConfig(rounds=2, episodes=2, steps=60, last_steps=60, batch=64)
    losses, threads = [], torch.get_num_threads
    for _ in range(2):
        env = lift()
        model = SAC(
            "MlpPolicy", env, seed=0, buffer_size=10,
            policy_kwargs={"features_extractor_class": TableExtractor, "net_arch": [32]},
        )  # fmt: skip
        rounds = []
        with torch_threads(2):
            seen = clone(model, env, config, 5, rounds.append)
            assert threads() == 2, "a script's own setting is put back"
        losses.append([r.loss for r in rounds])
        assert [r.number for r in rounds] == [0, 1] and len(seen) == 4
        assert rounds[-1].states == sum(len(d.advice) for d in seen)
        assert policy_of(model)(seen[0].observations[0]).shape == (5,)
    assert losses[0] == losses[1]
    assert losses[0][0] < 0.6  # of a policy that does nothing: about 0.7


@pytest.mark.slow
def test_cloning_computes_on_one_thread() -> None:
    model = SAC("MlpPolicy", lift(), buffer_size=10, policy_kwargs={"net_arch": [8]})
    config, seen = CloningConfig(rounds=1, episodes=1, last_steps=1, batch=8), []
    with torch_threads(2):
        clone(model, lift(), config, 0, lambda _: seen.append(torch.get_num_threads()))
    assert seen == [1]


@pytest.mark.parametrize("settings", [{"rounds": 0}, {"expert_share": 2}, {"noise": -1.0}])
def test_settings_out_of_range_are_refused(settings) -> None:
    with pytest.raises(InputError, match="CloningConfig"):
        CloningConfig(**settings)
