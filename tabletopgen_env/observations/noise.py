"""Errors of what is read of the state."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float


@dataclass(frozen=True, eq=False)
class Noise:
    """What is added to one reading of the state, but not to goals.

    ``joints`` (rad) are added to the arm's, and the tool's pose follows; ``positions`` (m) and
    ``turns`` (rotation vectors) are added to the objects by slot, base frame.
    """

    joints: Float[np.ndarray, "7"]
    positions: Float[np.ndarray, "slots 3"]
    turns: Float[np.ndarray, "slots 3"]
