"""The tables shipped for specific tasks: the default scenes have a valid task."""

from typing import Any

import gymnasium as gym
import pytest
from gymnasium.utils.env_checker import check_env

import assets_cache
from assets_cache.make_starter import TASKS
from tabletopgen_env.env import make_env
from tabletopgen_env.expert.run import TaskExpert

pytestmark = pytest.mark.slow

OWN = [("Sequence", "kitchen"), ("Sequence", "coffee_table"), ("Tidy", None)]


def made(task: str, preset: str | None) -> Any:
    more: dict[str, Any] = {"preset": preset} if preset else {}
    return gym.make(f"tabletopgen_env:TabletopGen/{task}-v0", **more)


@pytest.mark.parametrize(("task", "preset"), OWN)
def test_default_tables_are_the_task_s_own(task: str, preset: str | None) -> None:
    env = made(task, preset)
    stem = {"kitchen": "kitchen", "coffee_table": "coffee-table", None: "tidy"}[preset]
    own = {name for name in TASKS if name.startswith(f"{stem}-task-")}
    assert {ref.load().name for ref in env.unwrapped.source.refs} == own
    check_env(env.unwrapped, skip_render_check=True)
    env.close()


@pytest.mark.parametrize(("task", "preset"), OWN)
def test_the_expert_solves_an_episode(task: str, preset: str | None) -> None:
    env = made(task, preset)
    env.reset(seed=0)
    expert = TaskExpert(env)
    expert.reset()
    success = truncated = False
    while not (success or truncated):
        _, _, _, truncated, info = env.step(expert.act())
        success = info["success"]
    assert success, (info["scene"], info["instruction"], expert.phase)
    env.close()


@pytest.mark.parametrize("name", sorted(TASKS))
def test_each_table_offers_its_task(name: str) -> None:
    (path,) = assets_cache.find(name)
    preset = {"kitchen-task": "kitchen", "coffee-table-task": "coffee_table"}.get(name[:-2])
    env = make_env(path, task="Sequence" if preset else "Tidy", preset=preset)
    assert max(env.reset(seed=seed)[1]["goals"][1] for seed in range(8)) >= 3
    env.close()
