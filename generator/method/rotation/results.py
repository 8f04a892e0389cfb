"""Results of the rotation search."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

Place = tuple[float, float, float]
"""Shift to the right and down, as fractions of a crop's side, and the logarithm of the zoom."""


class RotationCandidate(NamedTuple):
    """A candidate with its yaw and tilt (radians), loss, and position in its crop."""

    yaw: float
    loss: float = float("inf")
    tilt: float = 0.0
    place: Place = (0.0, 0.0, 0.0)


Rows = list[list[RotationCandidate]]
"""Candidates, best first, of several objects, or of one object at several resolutions."""


@dataclass(frozen=True)
class RotationAnswer:
    """The result for one object.

    ``looks`` are the object's candidates at each resolution, highest first; ``margin``, ``width``,
    ``symmetric`` and ``order`` are as in ``generator.scene.Rotation``.
    """

    looks: Rows
    margin: float = 0.0
    width: float = float(np.pi)
    symmetric: bool = True
    order: int = 1
