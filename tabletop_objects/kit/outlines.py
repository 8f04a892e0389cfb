"""Flat counter-clockwise outlines and curves in metres, for extruded and swept solids."""

from __future__ import annotations

from typing import Any

import numpy as np
from jaxtyping import Float


def rectangle(x: float, y: float, radius: float = 0.0, steps: int = 4) -> Float[np.ndarray, "k 2"]:
    """Return a centred counter-clockwise rectangle with corners of the given radius."""
    if radius <= 0:
        return np.array([[-x, -y], [x, -y], [x, y], [-x, y]]) / 2
    radius = min(radius, 0.499 * x, 0.499 * y)
    return rounded_polygon(rectangle(x, y), radius, steps)


def rounded_polygon(
    corners: Float[np.ndarray, "k 2"], radius: float, steps: int = 4
) -> Float[np.ndarray, "n 2"]:
    """Return a convex counter-clockwise polygon with corners rounded to ``radius``."""
    points = []
    for before, here, after in zip(
        np.roll(corners, 1, 0), corners, np.roll(corners, -1, 0), strict=True
    ):
        a, b = ((before - here) / np.hypot(*(before - here)), (after - here)
                / np.hypot(*(after - here)))  # fmt: skip
        half = np.arccos(np.clip(a @ b, -1, 1)) / 2
        middle = here + (a + b) / np.hypot(*(a + b)) * radius / np.sin(half)
        start = np.arctan2(*(here + a * radius / np.tan(half) - middle)[::-1])
        turn = np.pi - 2 * half
        angles = start + np.linspace(0, turn, steps + 1)
        points.append(middle + radius * np.column_stack([np.cos(angles), np.sin(angles)]))
    return np.concatenate(points)


def ellipse(x: float, y: float, segments: int = 32, start: float = 0.0) -> Float[np.ndarray, "k 2"]:
    """Return a centred counter-clockwise ellipse with *diameters* ``x`` and ``y``."""
    angles = start + 2 * np.pi * np.arange(segments) / segments
    return np.column_stack([np.cos(angles) * x / 2, np.sin(angles) * y / 2])


def arc(
    center: tuple[float, float], radius: float, start: float, stop: float, steps: int = 8
) -> Float[np.ndarray, "k 2"]:
    """Return the points of a circular arc from angle ``start`` to ``stop``."""
    angles = np.linspace(start, stop, steps + 1)
    return np.array(center) + radius * np.column_stack([np.cos(angles), np.sin(angles)])


def smooth(points: Any, steps: int = 5) -> Float[np.ndarray, "k d"]:
    """Return a Catmull-Rom curve through ``points`` (2D or 3D) with ``steps`` segments per span."""
    p = np.asarray(points, float)
    p = np.concatenate([[2 * p[0] - p[1]], p, [2 * p[-1] - p[-2]]])
    t = np.linspace(0, 1, steps, endpoint=False)[:, None]
    pieces = [
        0.5
        * (
            2 * b
            + (c - a) * t
            + (2 * a - 5 * b + 4 * c - d) * t**2
            + (3 * b - 3 * c + d - a) * t**3
        )
        for a, b, c, d in zip(p, p[1:], p[2:], p[3:], strict=False)
    ]
    return np.concatenate([*pieces, p[-2][None]])


def inset(outline: Any, distance: float) -> Float[np.ndarray, "m 2"]:
    """Return a convex outline shrunk so that its bounding box loses ``distance`` on each side."""
    low, high = outline.min(0), outline.max(0)
    middle, half = (low + high) / 2, (high - low) / 2
    return middle + (outline - middle) * np.maximum(1 - distance / half, 0.02)


def lift(outline: Any, z: float) -> Float[np.ndarray, "m 3"]:
    """Return an outline as a 3D ring at height ``z``."""
    return np.column_stack([outline, np.full(len(outline), z)])
