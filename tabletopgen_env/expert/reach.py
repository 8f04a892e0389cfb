"""Reaching a point: moving above obstacles, then straight to the point."""

from __future__ import annotations

from typing import Any

import numpy as np
from jaxtyping import Float

from ..goals.goal import Reached
from .driver import Expert
from .planning.grasps import TIP


class Reacher(Expert):
    """An expert that brings the tool centre point to a point and keeps it there."""

    phase = "go"
    attempts = 1
    finished = True

    def __init__(self, env: Any, goal: Reached, patience: float = 1.0) -> None:
        super().__init__(env, patience)
        self._goal = goal

    def reset(self) -> None:
        """Do nothing, since every goal point is within reach."""

    def act(self) -> Float[np.ndarray, "5"]:
        """Return the next action, ``float32`` in [-1, 1]."""
        tool, spot = self._tool, self._goal.spot
        near = np.linalg.norm((tool - spot)[:2]) < 0.05
        return self._act((spot if near else self._over(spot, TIP, None)) - tool, 0.0, 0.0)
