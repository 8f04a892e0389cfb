"""Going to a point: over what is in the way, then straight to it."""

from __future__ import annotations

from typing import Any

import numpy as np
from jaxtyping import Float

from ..goals.goal import Reached
from .driver import Expert
from .planning.grasps import TIP


class Reacher(Expert):
    """Brings the tool centre point to a point, and stays there."""

    phase = "go"
    attempts = 1
    finished = True

    def __init__(self, env: Any, goal: Reached, patience: float = 1.0) -> None:
        super().__init__(env, patience)
        self._goal = goal

    def reset(self) -> None:
        """Nothing to plan: every goal point is in reach."""

    def act(self) -> Float[np.ndarray, "5"]:
        """Return the next action, ``float32`` in [-1, 1]."""
        tool = self._tool
        aim = self._goal.spot if self._straight(tool) else self._over(self._goal.spot, TIP, None)
        return self._act(aim - tool, 0.0, 0.0)

    def _straight(self, tool: Float[np.ndarray, "3"]) -> bool:
        return bool(np.linalg.norm((tool - self._goal.spot)[:2]) < 0.05)
