"""Toy bundles on disk, one for training and one held out, and small recipes."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import gymnasium as gym
import pytest
import torch
from toy import toy_object, toy_scene

from generator.bundle import save
from generator.physics.gate import judge
from tabletopgen_env.learning import training
from tabletopgen_env.learning.recipes import Recipe, recipe_of

SMALL: dict[str, dict[str, Any]] = {
    "sac": {"learning_starts": 20, "buffer_size": 2000, "batch_size": 16},
    "td3": {"learning_starts": 20, "buffer_size": 2000, "batch_size": 16, "action_noise": 0.1},
    "ppo": {"n_steps": 16, "batch_size": 16, "n_epochs": 1},
    "ppo-batch": {"rollout": 16, "epochs": 1, "minibatches": 2},
    "clone": {},
}


@pytest.fixture(scope="module", autouse=True)
def one_thread() -> Iterator[None]:
    """Use one thread, which is faster for small networks, especially in parallel tests."""
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    yield
    torch.set_num_threads(before)


@pytest.fixture(scope="session")
def table(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The path of a bundle of one cube for training."""
    return _saved("table", 0.04, tmp_path_factory.mktemp("store"))


@pytest.fixture(scope="session")
def other(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The path of a bundle of another cube, held out."""
    return _saved("other", 0.05, tmp_path_factory.mktemp("store"))


def _saved(name: str, size: float, store: Path) -> str:
    made = toy_scene((toy_object("cube_1", (size,) * 3, (-0.1, 0.0)),), name=name)
    return str(save(made.replace(report=judge(made)), store))


@pytest.fixture
def small(table: str, other: str):
    """Return a function that makes small recipes of an algorithm for the toy bundles."""

    def make(algorithm: str = "sac", **changes: Any) -> Recipe:
        return recipe_of({
            "name": f"small-{algorithm}", "task": "Reach", "algorithm": algorithm, "steps": 120,
            "envs": 2, "scenes": table, "held_out": other, "options": SMALL[algorithm],
            "network": {"layers": [16, 16], "width": 8},
            **changes,
        })  # fmt: skip

    return make


@pytest.fixture
def brief(monkeypatch: pytest.MonkeyPatch) -> None:
    """End the episodes of evaluations and demonstrations after some steps, solved or not."""
    whole = training.single_env
    monkeypatch.setattr(
        training, "single_env", lambda *a, **k: gym.wrappers.TimeLimit(whole(*a, **k), 12)
    )


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder for a run."""
    return tmp_path / "run"
