"""Seats around a table: where people sit, and which way they face."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from .footprint import DIRECTIONS, Footprint

MARGIN = 0.025
"""Distance between a place setting and the table's edge, in metres."""

WIDTH = 0.52
"""Length of table edge per person, in metres."""

_LONG = 1.35  # ratio of length to depth above which a table for four has no seats at its ends


@dataclass(frozen=True)
class Seat:
    """One seat at a table.

    Attributes:
        turn: yaw of the place setting, radians; 0 is the seat in front of the table.
        side: direction from the table's centre to the seat, unit vector.
        along: position along the edge, as a fraction of half its length, in [-1, 1].
    """

    turn: float
    side: tuple[float, float]
    along: float = 0.0


_FRONT, _BACK, _LEFT, _RIGHT = (0.0, -1.0), (0.0, 1.0), (-1.0, 0.0), (1.0, 0.0)
_TURNS = {_FRONT: 0.0, _RIGHT: np.pi / 2, _BACK: np.pi, _LEFT: -np.pi / 2}


def seats(count: int, outline: str, size: tuple[float, float]) -> list[Seat]:
    """Return ``count`` seats at a table with an outline and a size (length, depth) in metres."""
    if outline in ("round", "triangle") or (outline == "oval" and count > 4):
        angles = -np.pi / 2 + 2 * np.pi * np.arange(count) / count
        return [Seat(float(a + np.pi / 2), (float(np.cos(a)), float(np.sin(a)))) for a in angles]
    ends = _at_ends(count, size[0] / size[1])
    front = -(-(count - ends) // 2)
    sides = [(_FRONT, front), (_BACK, count - ends - front)]
    sides += [(_RIGHT, ends > 0), (_LEFT, ends > 1)]
    found = []
    for side, number in sides:
        found += [Seat(_TURNS[side], side, (2 * k + 1) / number - 1) for k in range(int(number))]
    return found


def _at_ends(count: int, length: float) -> int:
    """Return the number of people at the ends of a rectangular table."""
    if count <= 2:
        return 0
    if count % 2:
        return 1
    return 0 if count == 4 and length > _LONG else 2


def seat_center(
    seat: Seat, shape: Footprint, outline: Float[np.ndarray, "k 2"]
) -> Float[np.ndarray, "2"]:
    """Return the centre of a place setting: at the edge, in front of the seat."""
    side = np.asarray(seat.side)
    along = np.array([-side[1], side[0]])
    if abs(side[0]) == 1.0:
        along = np.array([0.0, 1.0])
    elif abs(side[1]) == 1.0:
        along = np.array([1.0, 0.0])
    half = float((outline @ along).max()) - 0.12
    start = along * seat.along * half
    reach = float(shape.reach[int(np.argmax(DIRECTIONS @ side))])
    for distance in np.arange(2.0, 0.0, -0.005):
        center = start + side * distance
        corners = shape.outline + center
        if _inside(corners, outline) >= MARGIN:
            return center
    return start + side * max(reach, 0.05)


def _inside(points: Float[np.ndarray, "p 2"], outline: Float[np.ndarray, "k 2"]) -> float:
    edges = np.roll(outline, -1, axis=0) - outline
    normals = np.column_stack([edges[:, 1], -edges[:, 0]])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return float(((outline * normals).sum(1)[None] - points @ normals.T).min())
