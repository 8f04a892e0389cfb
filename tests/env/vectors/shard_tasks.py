"""Tasks, sources and functions that tests send to processes."""

import os
import time

import gymnasium as gym
import numpy as np
from toy import toy_scene

from tabletopgen_env.scenes import SceneRef
from tabletopgen_env.scenes.lookup import fixed_scenes
from tabletopgen_env.tasks.reach import Reach as Reach


class UnportableError(Exception):
    """An error that cannot be recreated from its message alone."""

    def __init__(self, one: str, two: str) -> None:
        super().__init__(one + two)


class Counting:
    """Draws scenes in memory in a fixed order, and records outcomes."""

    def __init__(self) -> None:
        self.refs = fixed_scenes([toy_scene(name="a"), toy_scene(name="b")]).refs
        self.draws, self.records, self.closed = 0, [], 0

    def draw(self, rng: np.random.Generator) -> SceneRef:
        rng.integers(2)
        self.draws += 1
        return self.refs[self.draws % 2]

    def record(self, ref: SceneRef, success: bool) -> None:
        self.records.append(success)

    def close(self) -> None:
        self.closed += 1


class Failing:
    """Raises on every draw."""

    def draw(self, rng: np.random.Generator) -> SceneRef:
        raise UnportableError("nothing ", "to draw")


def pid(env: gym.Env) -> int:
    """Return the process id of an environment."""
    return os.getpid()


def nap(env: gym.Env, seconds: float = 0.5) -> str:
    """Sleep for a while."""
    time.sleep(seconds)
    return "slept"


def vanish(env: gym.Env) -> None:
    """Exit the process with a code."""
    os._exit(3)


def key(env: gym.Env) -> str:
    """Return the key of an environment's compiled worlds."""
    return ",".join(sorted(env.unwrapped._worlds._worlds))  # type: ignore[attr-defined]
