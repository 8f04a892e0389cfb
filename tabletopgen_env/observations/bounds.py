"""Bounds and noise of observation entries; see ``modes`` for the entries."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from ..rendering.views import SLOTS
from .grasp_hint import HINT_BOUNDS

ROBOT_BOUNDS = np.array(
    [4.0] * 7 + [10.0] * 7 + [0.1] + [3.0] * 3 + [1.0] * 6 + [4.0] * 7 + [1.0] * 3 + [3.0] * 6
)
SLOT_BOUNDS = np.array([3.0] * 3 + [1.0] * 6 + [3.0] * 3 + [10.0] * 3 + [50.0] * 3 + [1.0])
GOAL_BOUNDS = np.array([1.0] + [3.0] * 3 + [4.0] * 4 + [3.0] * 3)
GOAL_VECTOR_BOUNDS = np.array([3.0] * 3 + [4.0] * 4 + [1.0])

BARE_BOUNDS = np.concatenate([ROBOT_BOUNDS, np.tile(SLOT_BOUNDS, SLOTS)])
_NONE = np.empty(0)
BOUNDS = {  # of the flat state, by presence of the hint and absence of the goal
    (hinted, bare): np.concatenate(
        [BARE_BOUNDS, _NONE if bare else GOAL_BOUNDS, HINT_BOUNDS if hinted else _NONE]
    )
    for hinted in (False, True)
    for bare in (False, True)
}
for _constant in (ROBOT_BOUNDS, SLOT_BOUNDS, GOAL_BOUNDS, GOAL_VECTOR_BOUNDS, *BOUNDS.values()):
    _constant.setflags(write=False)


@dataclass(frozen=True, eq=False)
class Noise:
    """Noise added to one reading of the state, but not to goals.

    ``joints`` (rad) are added to the arm joints, and the pose of the tool follows from them;
    ``positions`` (m) and ``turns`` (rotation vectors) are added to the objects by slot, base frame.
    """

    joints: Float[np.ndarray, "7"]
    positions: Float[np.ndarray, "slots 3"]
    turns: Float[np.ndarray, "slots 3"]
