"""The interior of a vessel, derived from its collision parts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float

from ..physics.cover import outside
from ..physics.parts import body_parts
from ..scene import ConvexPart, Model

SECTORS = 24
"""Number of directions around a vessel's axis in which the vessel's wall is searched for."""

_LEVELS = 14
_STEPS = 64  # steps from the axis to the outside
_CLOSED = 0.9  # minimum fraction of directions with a wall at the rim
_ANGLES = 2 * np.pi * np.arange(SECTORS) / SECTORS
_WAYS = np.column_stack([np.cos(_ANGLES), np.sin(_ANGLES)])
_ROUNDS = 3  # number of iterations that centre the axis between the walls


@dataclass(frozen=True, eq=False)
class Cavity:
    """The space in a vessel that is reachable from above, in metres, relative to the vessel's box.

    Attributes:
        middle: x and y of its axis.
        floor, rim: its lowest and highest z.
        levels: heights from the floor to the rim.
        radii: distance of the wall from the axis, for each level and direction.
    """

    middle: Float[np.ndarray, "2"]
    floor: float
    rim: float
    levels: Float[np.ndarray, "l"]
    radii: Float[np.ndarray, "l s"]

    @property
    def depth(self) -> float:
        """Depth from the rim to the floor, in metres."""
        return self.rim - self.floor

    @property
    def mouth(self) -> float:
        """Minimum width of the opening, in metres."""
        half = SECTORS // 2
        across = self.radii[-1, :half] + self.radii[-1, half:]
        return float(across.min())

    def wall(self, points: Float[np.ndarray, "*n 3"]) -> Float[np.ndarray, "*n"]:
        """Return the wall's distance from the axis at the given points' heights and directions."""
        offset = points[..., :2] - self.middle
        angle = np.arctan2(offset[..., 1], offset[..., 0]) % (2 * np.pi)
        sector = (angle / (2 * np.pi) * SECTORS).round().astype(int) % SECTORS
        share = (points[..., 2] - self.floor) / max(self.depth, 1e-9)
        level = np.clip(np.floor(share * (len(self.levels) - 1)), 0, len(self.levels) - 1)
        return self.radii[level.astype(int), sector]


def find_cavity(model: Model) -> Cavity | None:
    """Return the cavity of a vessel, or None if there is no wall around its middle."""
    parts = body_parts(model, model.size)
    height, reach = float(model.size[2]), float(np.hypot(*model.size[:2])) / 2
    column = np.linspace(-height / 2, height / 2, 8 * _LEVELS)
    middle = np.zeros(2)
    for _ in range(_ROUNDS):
        solid = _inside(parts, np.column_stack([np.tile(middle, (len(column), 1)), column]))
        if not solid.any() or solid[-1]:
            return None
        floor = float(column[np.flatnonzero(solid)[-1] + 1])
        half = np.array([floor + 0.4 * (height / 2 - floor)])
        ring = np.minimum(_look_around(parts, middle, half, reach)[0], reach)
        edge = ring[:, None] * _WAYS
        middle = middle + (edge.max(0) + edge.min(0)) / 2
    levels = np.linspace(floor + 1e-3, height / 2 - 1e-4, _LEVELS)
    radii = _look_around(parts, middle, levels, reach)
    closed = np.isfinite(radii).mean(1) > _CLOSED
    if not closed[: _LEVELS // 2].any():
        return None
    last = int(np.flatnonzero(closed)[-1])
    rim = float(levels[last])
    radii = np.minimum(radii[: last + 1], reach)
    reached = np.minimum.accumulate(radii[::-1], axis=0)[::-1]
    return Cavity(middle, floor, rim, levels[: last + 1], reached)


def _look_around(
    parts: Sequence[ConvexPart],
    middle: Float[np.ndarray, "2"],
    levels: Float[np.ndarray, "l"],
    reach: float,
) -> Float[np.ndarray, "l s"]:
    """Return the distance to the first wall per level and direction, or inf if there is none."""
    away = np.linspace(0, reach, _STEPS)
    flat = middle + away[:, None, None] * _WAYS  # (steps, sectors, 2)
    points = np.empty((len(levels), SECTORS, _STEPS, 3))
    points[..., :2] = flat.transpose(1, 0, 2)
    points[..., 2] = levels[:, None, None]
    solid = _inside(parts, points.reshape(-1, 3)).reshape(points.shape[:-1])
    first = away[np.maximum(solid.argmax(-1) - 1, 0)]
    return np.where(solid.any(-1), first, np.inf)


def _inside(parts: Sequence[ConvexPart], points: Float[np.ndarray, "n 3"]) -> Bool[np.ndarray, "n"]:
    """Return which points are inside a collision part."""
    found = np.zeros(len(points), bool)
    for part in parts:
        low, high = part.bounds
        near = np.flatnonzero(((points >= low) & (points <= high)).all(1) & ~found)
        found[near[outside(part, points[near]) <= 0]] = True
    return found
