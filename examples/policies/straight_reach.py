"""A policy for TabletopBench: the hand goes straight to the marked point.

tabletopgen bench run straight_reach:make --suite reach-validation
"""

from __future__ import annotations

from typing import Any

import numpy as np

STEP = 0.025  # metres of hand motion per unit of action, in the action mode "ee_delta"


class StraightReach:
    """Observes the goal vectors, and moves the hand towards the goal."""

    env = {"observation": "goal", "action": "ee_delta"}  # noqa: RUF012

    def reset(self) -> None:
        """Forget the last episode; needed by policies with a memory."""

    def predict(self, observation: Any, deterministic: bool = True) -> tuple[np.ndarray, None]:
        """Return the action; the second value of the pair is unused."""
        way = observation["desired_goal"][:3] - observation["achieved_goal"][:3]
        move = np.clip(0.5 * way / STEP, -1.0, 1.0)
        return np.array([*move, 0.0, -1.0], np.float32), None


def make() -> StraightReach:
    """Return the policy; the command calls this function."""
    return StraightReach()
