"""The room inside a vessel, from its collision parts."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float
from scipy.spatial import ConvexHull, QhullError

from ...physics.parts import body_parts
from ...scene import ConvexPart, Model

SECTORS = 24
"""Directions from a vessel's middle in which its wall is looked for."""

_LEVELS = 14
_STEPS = 48  # places looked at between the middle and the outside
_ROUNDS = 3  # times that the middle is moved to where the walls are equally far


@dataclass(frozen=True, eq=False)
class Cavity:
    """The room that can be reached from above, metres, in the frame of the vessel's box.

    Attributes:
        middle: x and y of its axis.
        floor, rim: its lowest and its highest z.
        levels: heights from the floor to the rim.
        radii: how far the wall is from the axis, for each level and direction.
    """

    middle: Float[np.ndarray, "2"]
    floor: float
    rim: float
    levels: Float[np.ndarray, "l"]
    radii: Float[np.ndarray, "l s"]

    @property
    def depth(self) -> float:
        return self.rim - self.floor

    @property
    def mouth(self) -> float:
        """The least width of the opening."""
        half = SECTORS // 2
        across = self.radii[-1, :half] + self.radii[-1, half:]
        return float(across.min())

    def wall(self, points: Float[np.ndarray, "*n 3"]) -> Float[np.ndarray, "*n"]:
        """Return how far the wall is from the axis at the height and in the direction of points."""
        offset = points[..., :2] - self.middle
        angle = np.arctan2(offset[..., 1], offset[..., 0]) % (2 * np.pi)
        sector = (angle / (2 * np.pi) * SECTORS).round().astype(int) % SECTORS
        share = (points[..., 2] - self.floor) / max(self.depth, 1e-9)
        level = np.clip(np.floor(share * (len(self.levels) - 1)), 0, len(self.levels) - 1)
        return self.radii[level.astype(int), sector]


def find_cavity(model: Model) -> Cavity | None:
    """Return the room inside a vessel; None where it has no wall around its middle."""
    parts = [_planes(part) for part in body_parts(model, model.size)]
    height, reach = float(model.size[2]), float(np.hypot(*model.size[:2])) / 2
    middle = np.zeros(2)
    for _ in range(_ROUNDS):
        column = np.linspace(-height / 2, height / 2, 8 * _LEVELS)
        line = np.column_stack([np.tile(middle, (len(column), 1)), column])
        solid = _inside(parts, line)
        if not solid.any() or solid[-1]:
            return None
        floor = float(column[np.flatnonzero(solid)[-1] + 1])
        levels = np.linspace(floor + 1e-3, height / 2, _LEVELS)
        radii = _look_around(parts, middle, levels, reach)
        tops = np.isfinite(radii)
        closed = tops.mean(1) > 0.9
        if not closed[: _LEVELS // 2].any():
            return None
        last = int(np.flatnonzero(closed)[-1])
        ring = np.where(tops[last], radii[last], reach)
        angles = 2 * np.pi * np.arange(SECTORS) / SECTORS
        edge = ring[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
        middle = middle + (edge.max(0) + edge.min(0)) / 2
    rim = float(levels[last])
    levels = np.linspace(floor + 1e-3, rim - 1e-3, _LEVELS)
    radii = np.minimum(_look_around(parts, middle, levels, reach), reach)
    reached = np.minimum.accumulate(radii[::-1], axis=0)[::-1]
    return Cavity(middle, floor, rim, levels, reached)


def _look_around(
    parts: list[Float[np.ndarray, "_k 4"]],
    middle: Float[np.ndarray, "2"],
    levels: Float[np.ndarray, "l"],
    reach: float,
) -> Float[np.ndarray, "l s"]:
    """Return how far the first wall is at each level in each direction; inf where there is none."""
    angles = 2 * np.pi * np.arange(SECTORS) / SECTORS
    away = np.linspace(0, reach, _STEPS)
    z, angle, r = np.meshgrid(levels, angles, away, indexing="ij")
    points = np.stack([middle[0] + r * np.cos(angle), middle[1] + r * np.sin(angle), z], -1)
    solid = _inside(parts, points.reshape(-1, 3)).reshape(z.shape)
    first = away[np.maximum(solid.argmax(-1) - 1, 0)]
    return np.where(solid.any(-1), first, np.inf)


def _planes(part: ConvexPart) -> Float[np.ndarray, "k 4"]:
    """Return the sides of a part: inside is where n·p + c <= 0."""
    points = part.vertices
    try:
        return np.unique(ConvexHull(points).equations.round(9), axis=0)
    except (QhullError, ValueError):
        low, high = points.min(0), points.max(0)
        return np.column_stack([np.vstack([np.eye(3), -np.eye(3)]), np.append(-high, low)])


def _inside(
    parts: list[Float[np.ndarray, "_k 4"]], points: Float[np.ndarray, "n 3"]
) -> Bool[np.ndarray, "n"]:
    """Tell which points are inside of a part."""
    found = np.zeros(len(points), bool)
    for planes in parts:
        left = np.flatnonzero(~found)
        deep = (points[left] @ planes[:, :3].T + planes[:, 3] <= 1e-9).all(1)
        found[left[deep]] = True
    return found
