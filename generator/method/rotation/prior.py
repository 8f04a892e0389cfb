"""The orientation in which a modeler saw its model (``Model.orientation``): a hint.

The yaw that it implies is one more start of the search, and decides between sides whose losses
hardly differ. It never overrides a loss that is clearly lowest.
"""

from __future__ import annotations

import numpy as np

from ...geometry import wrap
from ...scene import Model
from .certainty import OTHER
from .results import RotationCandidate

UPRIGHT = float(np.deg2rad(30.0))
"""Angle between a model's upward axis and the table's above which its yaw tells nothing."""

NEAR = float(np.deg2rad(40.0))
"""Angle within which a yaw agrees with the prior; less than half of a quarter turn."""

SHARE = 0.05
"""Sides whose loss is at most that share above the least cannot be told apart by it."""


def prior_yaw(model: Model) -> float | None:
    """Return the yaw (radians, [-pi, pi)) nearest to a model's orientation.

    None without one, or if the model leans by more than ``UPRIGHT`` from the table's vertical.
    """
    seen = model.orientation
    if seen is None or seen[2, 2] < np.cos(UPRIGHT):
        return None
    return wrap(float(np.arctan2(seen[1, 0] - seen[0, 1], seen[0, 0] + seen[1, 1])))


def agrees(yaw: float, prior: float | None) -> bool:
    """Tell whether a yaw is within ``NEAR`` of a prior."""
    return prior is not None and abs(wrap(yaw - prior)) <= NEAR


def prefer(found: list[RotationCandidate], prior: float | None) -> list[RotationCandidate]:
    """Return candidates, best first, with the one that the prior supports in front.

    That is the best of another side that agrees with the prior, if the best does not, and if the
    losses of the two cannot be told apart.
    """
    if prior is None or not found or agrees(found[0].yaw, prior):
        return found
    best = found[0]
    for k, other in enumerate(found):
        apart = abs(wrap(other.yaw - best.yaw)) >= OTHER
        if apart and agrees(other.yaw, prior) and other.loss <= (1 + SHARE) * best.loss:
            return [other, *found[:k], *found[k + 1 :]]
    return found


def same_side(found: RotationCandidate, order: int, prior: float | None) -> RotationCandidate:
    """Return a candidate turned, by a multiple of 2 pi / ``order``, to where the prior has it.

    So turned it looks the same; where no such turn agrees with the prior, it stays.
    """
    turns = (found.yaw + 2 * np.pi * k / order for k in range(order))
    nearest = min(turns, key=lambda yaw: abs(wrap(yaw - (prior or 0.0))))
    if not agrees(nearest, prior) or agrees(found.yaw, prior):
        return found
    return found._replace(yaw=wrap(nearest))
