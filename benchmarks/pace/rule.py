"""A rule that goes where the grasp hint points: the baseline that a trained policy must exceed.

It observes only the hint's eight entries, and remembers whether it has released the object.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from jaxtyping import Float

from tabletopgen_env.actions import EE_STEP, EE_TURN
from tabletopgen_env.observations.grasp_hint import HINT_BOUNDS
from tabletopgen_env.robot import franka

_OVER = 0.05  # height above the end of its path at which the hand is aligned, metres


class HintRule:
    """Moves above the end of its path, aligns, descends, and closes or opens the fingers there.

    ``lets_go`` says whether a held object is released at the end of the path (not in Lift).
    """

    def __init__(self, lets_go: bool) -> None:
        self._lets_go, self._opened = lets_go, False

    def predict(
        self, observation: Float[np.ndarray, "n"], *, deterministic: bool
    ) -> tuple[Float[np.ndarray, "5"], Any]:
        """Return the action, like a policy."""
        *way, turn, opening, _, rise, kind = observation[-len(HINT_BOUNDS) :]
        holds = kind < 0
        aimed = np.hypot(way[0], way[1]) < (0.01 if holds else 0.006) and abs(turn) < 0.06
        there = bool(aimed and abs(way[2]) < 0.01)
        self._opened = self._lets_go and bool(holds and (there or self._opened))
        up = rise if rise > 0.005 else way[2] + (0.0 if aimed else _OVER)
        aside = 0.2 if rise > 0.02 else 1.0  # up first
        move = np.array([aside * way[0], aside * way[1], up]) / EE_STEP * (0.6 if holds else 0.8)
        wide = opening / franka.FINGER_STROKE - 1.0
        closed = not self._opened if holds else there
        action = np.array([*move, turn / EE_TURN, -1.0 if closed else wide], np.float32)
        if self._opened:
            action[:4] = 0.0
        return np.clip(action, -1.0, 1.0), None
