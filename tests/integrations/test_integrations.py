"""TabletopGen in LeRobot and in vla-eval, with and without these packages."""

import importlib
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import gymnasium as gym
import numpy as np
import pytest
from gymnasium.wrappers import TimeLimit
from toy import toy_scene

from tabletopgen_env.env import make_env
from tabletopgen_env.episodes import HOLD, EndOnSuccess
from tabletopgen_env.expert.run import TaskExpert

ROOT = Path(__file__).parents[2]
LEROBOT = """
import numpy as np, torch
from lerobot.envs.factory import make_env, make_env_config
from lerobot.envs.utils import preprocess_observation
from lerobot.utils.import_utils import register_third_party_plugins
import lerobot_env_tabletopgen
from tabletopgen_env.expert.run import TaskExpert

cfg = make_env_config("tabletopgen", task="Lift", scenes="office-desk", image_size=32)
env = make_env(cfg, n_envs=1)["tabletopgen"][0]
limit = env.call("_max_episode_steps")[0]
for who in ("random", "expert"):
    seen, info = env.reset(seed=[3])
    shown = preprocess_observation(seen)
    assert shown["observation.images.front"].shape == (1, 3, 32, 32), shown
    assert shown["observation.state"].shape == (1, 33)
    assert env.call("task_description")[0].startswith("lift "), env.call("task_description")
    expert = TaskExpert(env.envs[0])
    expert.reset()
    done, steps, success = False, 0, False
    while not done and steps < 120:
        action = env.action_space.sample() if who == "random" else expert.act()[None]
        seen, reward, ended, cut, info = env.step(action)
        steps, done = steps + 1, bool(ended[0] or cut[0])
        if done and "final_info" in info:
            success = bool(info["final_info"]["is_success"][0])
    print(who, limit, steps, success)
    assert success == (who == "expert")
"""
VLA = """
import asyncio, sys
import numpy as np
from vla_eval_tabletopgen.benchmark import TabletopGenBenchmark
from tabletopgen_env.expert.run import TaskExpert

async def play(bench, who):
    task = {**bench.get_tasks()[0], "episode_idx": 3}
    await bench.start_episode(task)
    seen = await bench.get_observation()
    assert seen["images"]["front"].shape == (32, 32, 3) and seen["state"].shape == (33,)
    assert seen["task_description"].startswith("lift ")
    expert, rng = TaskExpert(bench._env), np.random.default_rng(0)
    expert.reset()
    for _ in range(120):
        if who == "expert":
            five = expert.act()
            action = np.array([*five[:3], 0, 0, five[3], -five[4]])  # as most models act
        else:
            action = rng.uniform(-1, 1, 7)
        await bench.apply_action({"actions": action})
        if await bench.is_done():
            break
    return (await bench.get_result())["success"]

bench = TabletopGenBenchmark(["Lift"], "office-desk", image_size=32)
assert asyncio.run(play(bench, "random")) is False
assert asyncio.run(play(bench, "expert")) is True
assert bench.get_hold_action(None)["actions"].tolist() == [0, 0, 0, 0, 1]
bench.cleanup()
"""


def test_an_episode_ends_once_success_has_held() -> None:
    env = EndOnSuccess(TimeLimit(make_env(toy_scene(), task="Lift"), 150))
    env.reset(seed=0, options={"target": "cube_1"})
    expert, ended, row = TaskExpert(env), False, 0
    expert.reset()
    for _ in range(150):
        _, _, ended, cut, info = env.step(expert.act())
        row = row + 1 if info["success"] else 0
        if ended or cut:
            break
    assert ended and not cut and row == HOLD
    env.reset(seed=0, options={"target": "cube_1"})
    assert not env.step(env.action_space.sample())[2]


@pytest.fixture
def view(monkeypatch: pytest.MonkeyPatch) -> Any:
    """LeRobot's view of an environment, from a module that does not need LeRobot."""
    monkeypatch.syspath_prepend(
        str(ROOT / "integrations/lerobot_env_tabletopgen/lerobot_env_tabletopgen")
    )
    return importlib.import_module("view")


def test_a_success_that_does_not_hold_is_none_to_lerobot(
    view: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    env = view.make_lerobot_env("Lift", ["office-desk"], ["front"], 16, 20, "starts", None)
    known = env.unwrapped
    assert not env.reset(seed=0, options={"lerobot_new_rollout": True})[1]["is_success"]
    assert env.reset(seed=0, options={"target": known.world.names[0]})[1]["target"]
    inside, now = type(known).step, [True] * (HOLD - 1) + [False] + [True] * HOLD
    marks = iter(now)

    def step(self: Any, action: Any) -> Any:
        *rest, info = inside(self, action)
        success = next(marks)
        return *rest, {**info, "success": success, "is_success": success}

    monkeypatch.setattr(type(known), "step", step)
    found = [env.step(np.zeros(5, np.float32)) for _ in now]
    assert [info["is_success"] for *_, info in found] == [False] * (len(now) - 1) + [True]
    assert [ended for _, _, ended, _, _ in found] == [info["is_success"] for *_, info in found]
    env.close()


def test_lerobots_view_has_its_names(view: Any) -> None:
    env = view.make_lerobot_env("Lift", ["office-desk"], ["front"], 16, 20, "starts", 7)
    seen, info = env.reset(seed=0)
    assert env.observation_space.contains(seen) and seen["pixels"]["front"].shape == (16, 16, 3)
    assert seen["agent_pos"].shape == (view.PROPRIO,)
    assert env.task_description == info["instruction"] == env.get_wrapper_attr("task")
    assert env.get_wrapper_attr("_max_episode_steps") == 7
    for _ in range(7):
        _, _, ended, cut, _ = env.step(np.zeros(5, np.float32))
    assert cut and not ended
    assert isinstance(env, gym.Wrapper)
    env.close()


def run(python: str, script: str, folder: str) -> None:
    path = os.pathsep.join([str(ROOT), str(ROOT / "integrations" / folder)])
    done = subprocess.run(
        [python, "-c", script], env={**os.environ, "PYTHONPATH": path}, capture_output=True,
        text=True, timeout=600, stdin=subprocess.DEVNULL,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr[-3000:]


@pytest.mark.slow
@pytest.mark.real
def test_lerobot_evaluates_a_random_and_an_expert_policy() -> None:
    python = os.environ.get("TABLETOPGEN_LEROBOT_PYTHON")
    if not python:
        pytest.skip("TABLETOPGEN_LEROBOT_PYTHON names no Python with LeRobot and TabletopGen")
    run(python, LEROBOT, "lerobot_env_tabletopgen")


@pytest.mark.slow
@pytest.mark.real
def test_vla_eval_plays_a_random_and_an_expert_policy() -> None:
    python = os.environ.get("TABLETOPGEN_VLA_EVAL_PYTHON", sys.executable)
    there = subprocess.run(
        [python, "-c", "import vla_eval"], capture_output=True, check=False, timeout=120
    )
    if there.returncode:
        pytest.skip("TABLETOPGEN_VLA_EVAL_PYTHON names no Python with vla-eval and TabletopGen")
    run(python, VLA, "vla_eval_tabletopgen")
