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
    """An error that cannot be made of its message alone."""

    def __init__(self, one: str, two: str) -> None:
        super().__init__(one + two)


class Counting:
    """Draws scenes in memory in turn, ever the same, and notes what it is told."""

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
    """Draws nothing."""

    def draw(self, rng: np.random.Generator) -> SceneRef:
        raise UnportableError("nothing ", "to draw")


def pid(env: gym.Env) -> int:
    """Return the process that an environment is in."""
    return os.getpid()


def nap(env: gym.Env, seconds: float = 0.5) -> str:
    """Take a while."""
    time.sleep(seconds)
    return "slept"


def vanish(env: gym.Env) -> None:
    """End the process with a code."""
    os._exit(3)


def key(env: gym.Env) -> str:
    """Return by what the compiled worlds of an environment are known."""
    return ",".join(sorted(env.unwrapped._worlds._worlds))  # type: ignore[attr-defined]
