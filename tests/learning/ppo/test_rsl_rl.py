import importlib.util
from pathlib import Path
from typing import Any

import pytest
import torch
from moving_points import LIMIT, PartedPoint, TensorPoints, points

from generator.errors import InputError
from tabletopgen_env.learning.ppo.rsl_rl import GROUP, RslRlWorlds

HERE = {name for name in ("tensordict", "rsl_rl", "git") if importlib.util.find_spec(name)}
with_tensordict = pytest.mark.skipif("tensordict" not in HERE, reason="needs tensordict")
with_rsl_rl = pytest.mark.skipif(len(HERE) < 3, reason="needs rsl-rl-lib")

NETWORK = {"class_name": "MLPModel", "hidden_dims": [16], "activation": "elu"}


@pytest.mark.skipif("tensordict" in HERE, reason="tensordict is here")
def test_without_tensordict_it_says_what_to_install() -> None:
    with pytest.raises(InputError, match=r"tabletopgen\[rsl\]"):
        RslRlWorlds(points(), LIMIT)


@with_tensordict
def test_worlds_are_stepped_as_rsl_rl_says() -> None:
    worlds = RslRlWorlds(TensorPoints(points(3)), LIMIT)
    assert (worlds.num_envs, worlds.num_actions, worlds.max_episode_length) == (3, 2, LIMIT)
    first = worlds.get_observations()
    assert first.batch_size == (3,) and first[GROUP].shape == (3, 2)
    outwards = torch.tensor([[9.0, 9.0], [0.0, 0.0], [0.0, 0.0]])
    timed_out, ended = [], []
    for k in range(LIMIT):
        seen, rewards, dones, more = worlds.step(outwards)
        assert rewards.shape == dones.shape == more["time_outs"].shape == (3,)
        assert torch.equal(worlds.get_observations()[GROUP], seen[GROUP])
        assert worlds.episode_length_buf[1] == (k + 1) % LIMIT
        assert ("log" in more) == bool(dones.any())
        timed_out.append(more["time_outs"].tolist())
        ended.append(dones.tolist())
    assert timed_out[-1][1:] == [True, True] and not any(t[0] for t in timed_out[:-1])
    assert any(e[0] for e in ended[:-1]), "the first one falls off the edge"
    with pytest.raises(InputError, match="init_at_random_ep_len"):
        worlds.episode_length_buf = torch.zeros(3)


@with_tensordict
def test_parts_of_observations_are_groups() -> None:
    seen = RslRlWorlds(points(2, PartedPoint), LIMIT).get_observations()
    assert {name: part.shape for name, part in seen.items()} == {"x": (2, 1), "y": (2, 1)}


@with_rsl_rl
def test_the_runner_of_rsl_rl_learns(tmp_path: Path) -> None:
    from rsl_rl.runners import OnPolicyRunner

    noise = {"class_name": "GaussianDistribution", "init_std": 0.6}
    settings: dict[str, Any] = {
        "algorithm": {"class_name": "PPO", "gamma": 0.8, "entropy_coef": 0.0},
        "actor": {**NETWORK, "distribution_cfg": noise}, "critic": dict(NETWORK),
        "obs_groups": {"actor": [GROUP], "critic": [GROUP]}, "num_steps_per_env": 24,
        "save_interval": 100, "logger": "tensorboard",
    }  # fmt: skip
    torch.manual_seed(0)
    worlds = RslRlWorlds(points(8), LIMIT)
    runner = OnPolicyRunner(worlds, settings, str(tmp_path))
    runner.learn(25)
    act = runner.get_inference_policy()
    fresh = RslRlWorlds(points(8), LIMIT, seed=9)
    for _ in range(LIMIT):
        with torch.no_grad():
            _, _, dones, more = fresh.step(act(fresh.get_observations()))
    assert dones.all() and float(more["log"]["/success"]) > 0.5
