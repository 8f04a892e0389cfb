"""Which way the drawing shows things whose shapes are the plan's."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from ...geometry import rotation_z, wrap
from ...scene import Model, Rotation

Turn = Callable[[str, Model], Rotation]
"""Finds the rotation of another model of an instance in the drawing (Sec. 3.3), by its name."""

AGREE = float(np.deg2rad(15.0))
"""Yaws of two shapes of one thing that differ by less say the same."""

TOLD, SURE = 0.2, 0.5
"""From these margins on (``Rotation.margin``) the drawing tells a yaw that two shapes agree on, and
one that only the plan's shape has."""


@dataclass(frozen=True, eq=False)
class FoundYaws:
    """Yaws of things as the drawing shows them, radians.

    Attributes:
        yaws: of the shapes that were found, by name.
        rotations: what is known of how sure these are.
        turn: finds the yaw of another shape. With None the yaws are of the things' fronts, which
            all shapes share.
    """

    yaws: Mapping[str, float]
    rotations: Mapping[str, Rotation] = field(default_factory=dict[str, Rotation])
    turn: Turn | None = None

    def of(self, name: str, planned: Model) -> float | None:
        """Return the yaw at which the drawing shows the plan's model; None where it does not tell.

        A modeler chooses the axes of its meshes by itself, so a yaw of the shape that was found
        counts only if the plan's shape looks like the drawing at the same yaw.
        """
        yaw = self.yaws[name]
        if self.turn is None:
            return yaw
        other = self.turn(name, replace(planned, orientation=rotation_z(yaw)))
        if other.symmetric:
            return yaw
        known = self.rotations.get(name)
        margin = max(other.margin, known.margin if known else 0.0)
        apart = abs(wrap(other.order * (other.yaw - yaw))) / other.order
        if apart <= AGREE and margin >= TOLD:
            return yaw
        return other.yaw if other.margin >= SURE else None
