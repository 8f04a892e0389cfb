"""Episode seeds and the common criterion for a successful episode."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import gymnasium as gym
import numpy as np

HOLD = 10
"""Number of consecutive steps for which ``info["success"]`` must hold."""


def episode_seeds(*key: int) -> Iterator[int]:
    """Yield an endless sequence of episode seeds; different keys give different seeds."""
    rng = np.random.default_rng(key)
    while True:
        yield int(rng.integers(2**31))


class Held:
    """A counter of consecutive successful steps, which reports when it reaches ``steps``."""

    def __init__(self, steps: int = HOLD) -> None:
        self._steps = steps
        self._in_a_row = 0

    def after(self, info: Mapping[str, Any]) -> bool:
        """Return whether success has lasted long enough, given the ``info`` of the next step."""
        self._in_a_row = self._in_a_row + 1 if info["success"] else 0
        return self._in_a_row >= self._steps


class EndOnSuccess(gym.Wrapper):
    """A wrapper that ends an episode after ``steps`` successful steps in a row, as in evaluations.

    Use it for evaluation in other libraries, but do not train on the dense reward with it, because
    that reward is highest while the task remains solved.
    """

    def __init__(self, env: gym.Env[Any, Any], steps: int = HOLD) -> None:
        super().__init__(env)
        self._steps = steps
        self._held = Held(steps)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Any, dict[str, Any]]:
        """Begin an episode."""
        self._held = Held(self._steps)
        return self.env.reset(seed=seed, options=options)

    def step(self, action: Any) -> tuple[Any, Any, bool, bool, dict[str, Any]]:
        """Apply an action; the episode terminates once success has lasted long enough."""
        seen, reward, ended, cut, info = self.env.step(action)
        return seen, reward, ended or self._held.after(info), cut, info
