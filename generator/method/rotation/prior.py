"""A modeler's estimate of its model's orientation (``Model.orientation``), used as a hint.

The yaw that it implies is an additional start of the search, and decides between candidates whose
losses hardly differ. It never overrides a candidate whose loss is clearly lowest.
"""

from __future__ import annotations

import numpy as np

from ...geometry import wrap
from ...scene import Model
from .certainty import OTHER
from .results import RotationCandidate

UPRIGHT = float(np.deg2rad(30.0))
"""Maximum angle between a model's up axis and the vertical at which its yaw is meaningful."""

NEAR = float(np.deg2rad(40.0))
"""Angle within which a yaw agrees with the prior; less than an eighth of a turn."""

SHARE = 0.05
"""Relative margin above the lowest loss within which candidates count as equally good."""


def prior_yaw(model: Model) -> float | None:
    """Return the yaw, in [-pi, pi) radians, that best approximates a model's orientation.

    Returns None if the model has no orientation, or leans from the vertical by more than
    ``UPRIGHT``.
    """
    seen = model.orientation
    if seen is None or seen[2, 2] < np.cos(UPRIGHT):
        return None
    return wrap(float(np.arctan2(seen[1, 0] - seen[0, 1], seen[0, 0] + seen[1, 1])))


def agrees(yaw: float, prior: float | None) -> bool:
    """Return whether a yaw differs from the prior by at most ``NEAR``."""
    return prior is not None and abs(wrap(yaw - prior)) <= NEAR


def prefer(found: list[RotationCandidate], prior: float | None) -> list[RotationCandidate]:
    """Return the candidates, led by one that agrees with the prior yaw if it fits equally well.

    If the best candidate does not agree with the prior, the supported one is the best that does. It
    is moved to the front only if the losses of the two cannot be distinguished.
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
    """Return the candidate, rotated by a multiple of 2 pi / ``order`` to agree with the prior yaw.

    The object looks the same after that rotation. If there is no such multiple, the candidate is
    unchanged.
    """
    turns = (found.yaw + 2 * np.pi * k / order for k in range(order))
    nearest = min(turns, key=lambda yaw: abs(wrap(yaw - (prior or 0.0))))
    if not agrees(nearest, prior) or agrees(found.yaw, prior):
        return found
    return found._replace(yaw=wrap(nearest))
