"""Episodes: their seeds, and when one is a success, the same wherever one is played."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import gymnasium as gym
import numpy as np

HOLD = 10
"""Steps in a row for which ``info["success"]`` has to hold."""


def episode_seeds(*key: int) -> Iterator[int]:
    """Yield episodes' seeds without end; a key of other numbers gives others."""
    rng = np.random.default_rng(key)
    while True:
        yield int(rng.integers(2**31))


class Held:
    """Tells when a success has held for ``steps`` in a row; of one episode, told of each step."""

    def __init__(self, steps: int = HOLD) -> None:
        self._steps = steps
        self._in_a_row = 0

    def after(self, info: Mapping[str, Any]) -> bool:
        """Return whether success has held, now that a step gave ``info``."""
        self._in_a_row = self._in_a_row + 1 if info["success"] else 0
        return self._in_a_row >= self._steps


class EndOnSuccess(gym.Wrapper):
    """Ends an episode (``terminated``) once success has held, as evaluations of this package do.

    For evaluations of others. Not for training with the dense reward, which is highest where the
    task stays done.
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
        """Act; the episode ends with the step after which success has held."""
        seen, reward, ended, cut, info = self.env.step(action)
        return seen, reward, ended or self._held.after(info), cut, info
