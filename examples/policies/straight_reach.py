"""A policy for TabletopBench: the hand goes straight to the marked point.

tabletopgen bench run straight_reach:make --suite reach-validation
"""

from __future__ import annotations

from typing import Any

import numpy as np

STEP = 0.025  # metres that an action of 1 moves the hand, in the action mode "ee_delta"


class StraightReach:
    """Sees the goal vectors, and moves the hand towards the goal."""

    env = {"observation": "goal", "action": "ee_delta"}  # noqa: RUF012

    def reset(self) -> None:
        """Forget the last episode; a policy with a memory would need it."""

    def predict(self, observation: Any, deterministic: bool = True) -> tuple[np.ndarray, None]:
        """Return the action; the second of the pair is not used."""
        way = observation["desired_goal"][:3] - observation["achieved_goal"][:3]
        move = np.clip(0.5 * way / STEP, -1.0, 1.0)
        return np.array([*move, 0.0, -1.0], np.float32), None


def make() -> StraightReach:
    """Return the policy; this is what the command calls."""
    return StraightReach()
