"""Convex parts: the analytic collision shapes of objects, in metres."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Literal

import numpy as np
from jaxtyping import Float

from ..values import ConvexPart
from .outlines import ellipse, lift
from .solids import Profile, Solid, lathe

MAX_VERTICES = 32
"""A hull keeps at most this many vertices."""


def box_part(x: float, y: float, z: float, at: Sequence[float] = (0, 0, 0)) -> ConvexPart:
    """Return an axis-aligned box; ``at`` is the centre of its bottom face."""
    signs = np.array([[i, j, k] for k in (0, 1) for i in (-0.5, 0.5) for j in (-0.5, 0.5)])
    return ConvexPart(signs * [x, y, z] + np.asarray(at, float), "box")


def cylinder_part(
    radius: float, length: float, at: Sequence[float] = (0, 0, 0), axis: Literal[0, 1, 2] = 2
) -> ConvexPart:
    """Return a cylinder along ``axis``; ``at`` is the centre of its lower end disc."""
    circle = ellipse(2 * radius, 2 * radius, 16)
    points = np.concatenate([np.column_stack([circle, np.full(16, end)]) for end in (0, length)])
    return ConvexPart(np.roll(points, axis + 1, axis=1) + np.asarray(at, float), "cylinder", axis)


def hull_part(points: Any) -> ConvexPart:
    """Return the convex hull of ``points``, reduced to extreme points if there are too many."""
    points = np.unique(np.asarray(points, float).round(6), axis=0)
    if len(points) > MAX_VERTICES:
        points = _extremes(points)
    return ConvexPart(points)


def whole_hull(points: Any) -> ConvexPart:
    """Return the convex hull of ``points`` with all its vertices, so that no point is outside."""
    from scipy.spatial import ConvexHull

    points = np.asarray(points, float)
    return ConvexPart(points[ConvexHull(points).vertices])


def hull_of(*solids: Solid) -> ConvexPart:
    """Return the convex hull of solids, which preserves a flat bottom."""
    return hull_part(np.concatenate([s.vertices for s in solids]))


def flat_foot(points: Any, share: float = 0.12) -> ConvexPart:
    """Return the hull of ``points``, flattened to z = 0 in the lowest ``share`` of its height.

    An object that is drawn with a flat spot gets a matching flat collision shape and does not
    roll. If its flat spot were larger than the drawn one, a gap would be visible when the object
    leans against another one.
    """
    p = np.array(points, float)
    p[p[:, 2] < share * p[:, 2].max(), 2] = 0.0
    return hull_part(p)


def _extremes(points: np.ndarray) -> np.ndarray:
    """Return at most 32 points that span most of the hull, in their original order."""
    middle = (points.min(0) + points.max(0)) / 2
    span = np.maximum(np.ptp(points, axis=0), 1e-9)
    unit = (points - middle) / span
    ring = np.column_stack([ellipse(2, 2, 8, np.pi / 8), np.zeros(8)])
    ways = np.concatenate([ring + np.array([0.0, 0.0, rise]) for rise in (-20, 20, -0.7, 0.7)])
    chosen = {int(np.argmax(unit @ way)) for way in ways}
    return points[sorted(chosen)]


def resting_ball(x: float, y: float, z: float, flat: float = 0.45) -> ConvexPart:
    """Return a faceted ellipsoid with diameters x, y and z that stands on a flat facet at z = 0.

    ``flat`` is the facet's radius relative to the largest radius. All vertices lie on or inside
    the ellipsoid, except those of the facet, which is lowered to z = 0.
    """
    levels = [(-1.0, flat), (-0.55, 0.835), (0.25, 0.968), (0.93, 0.36)]
    points = [lift(ellipse(x * r, y * r, 8, np.pi / 8 * (k % 2)), z / 2 * (1 + h)) for k,
              (h, r) in enumerate(levels)]  # fmt: skip
    return ConvexPart(np.concatenate(points))


def ring_parts(
    outer: Sequence[tuple[float, float]],
    inner: Sequence[tuple[float, float]],
    wedges: int = 14,
    *,
    stretch: tuple[float, float] = (1.0, 1.0),
) -> tuple[ConvexPart, ...]:
    """Return the wall of a hollow round object as convex wedges.

    ``outer`` and ``inner`` are (radius, z) points of the outside and the inside of the wall, at
    most 6 in total. Each wedge is a convex hull with one extra corner on the outside. Where the
    inside bulges outwards, the wedges are too thick: their inner faces are flat. ``stretch`` scales
    x and y.
    """
    angles = 2 * np.pi * np.arange(2 * wedges + 1) / (2 * wedges)
    parts = []
    for k in range(wedges):
        start, middle, end = angles[2 * k : 2 * k + 3]
        sides = [(outer, (start, middle, end)), (inner, (start, end))]
        points = [(r * np.cos(a) * stretch[0], r * np.sin(a) * stretch[1], z) for profile,
                  ways in sides for a in ways for r, z in profile]  # fmt: skip
        parts.append(hull_part(points))
    return tuple(parts)


def bowl_parts(
    outer: Float[np.ndarray, "n 2"], inner: Float[np.ndarray, "n 2"], wedges: int = 14
) -> tuple[ConvexPart, ...]:
    """Return the wall of a round bowl as two rings of wedges that leave the inside empty.

    ``outer`` and ``inner`` are (radius, z) points from the bottom up, the same number on each side.
    """
    sides = [[(float(r), float(z)) for r, z in side] for side in (outer, inner)]
    last, middle = len(sides[0]) - 1, (len(sides[0]) - 1) // 2
    rings = []
    for low, high in ((0, middle), (middle, last)):
        out, within = ((s[low], s[(low + high) // 2], s[high]) for s in sides)
        rings += ring_parts(out, (within[2], within[0]), wedges)
    return tuple(rings)


def frame_parts(x: float, y: float, z: float, wall: float, bottom: float) -> tuple[ConvexPart, ...]:
    """Return the parts of an open box on z = 0: a bottom and four walls."""
    return (
        box_part(x, y, bottom),
        box_part(wall, y, z - bottom, (-(x - wall) / 2, 0, bottom)),
        box_part(wall, y, z - bottom, ((x - wall) / 2, 0, bottom)),
        box_part(x - 2 * wall, wall, z - bottom, (0, -(y - wall) / 2, bottom)),
        box_part(x - 2 * wall, wall, z - bottom, (0, (y - wall) / 2, bottom)),
    )


def above(p: np.ndarray) -> np.ndarray:
    """Return the points with negative z raised to z = 0."""
    return np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)])


def open_vessel(
    side: Profile, wall: float, bottom: float, segments: int = 28
) -> tuple[Solid, tuple[ConvexPart, ...]]:
    """Return an open vessel and its convex parts.

    Args:
        side: (radius, z) points of the outside in metres, from z = 0 up to the rim.
        wall: thickness of the wall, in metres.
        bottom: thickness of the bottom, in metres.
        segments: number of sides, seen from above.

    Texture coordinate v is below 0.5 on the outside, 0.5 at the rim and above 0.5 on the inside.
    """
    outer = np.array(side, float)
    inner = np.column_stack(
        [np.maximum(outer[:, 0] - wall, 0.001), np.maximum(outer[:, 1], bottom)]
    )
    inner[0, 1] = bottom
    inner = inner[np.append(np.diff(inner[:, 1]) > 1e-9, True)]
    profile = [(0, 0), *outer, *inner[::-1], (0, bottom)]
    v = [0, *np.linspace(0.02, 0.49, len(outer)), *np.linspace(0.51, 0.98, len(inner)), 1]
    body = lathe(profile, segments, v=v)
    flat = np.cos(np.pi / segments) if segments < 16 else 1.0
    out, within = outer * [flat, 1], inner * [flat, 1]
    floor = cylinder_part(float(within[0, 0]), bottom)
    if len(side) > 3 and len(within) == len(out):
        return body, (*bowl_parts(out, within), floor)
    rim = [(float(r), float(z)) for r, z in out[:4]]
    ends = [(float(r), float(z)) for r, z in (within[-1], within[0])]
    return body, (*ring_parts(rim, ends), floor)


def hull_above(*solids: Solid) -> ConvexPart:
    """Return the hull of solids with points below z = 0 raised to z = 0."""
    points = np.concatenate([s.vertices for s in solids])
    return hull_part(np.column_stack([points[:, :2], np.maximum(points[:, 2], 0)]))


def stretch_parts(parts: Iterable[ConvexPart], x: float, y: float) -> tuple[ConvexPart, ...]:
    """Return collision parts scaled along x and y, to match a scaled solid."""
    return tuple(ConvexPart(p.vertices * np.array([x, y, 1.0])) for p in parts)


def lift_parts(parts: Iterable[ConvexPart], z: float) -> tuple[ConvexPart, ...]:
    """Return collision parts raised by ``z``."""
    return tuple(ConvexPart(p.vertices + np.array([0, 0, z]), p.kind, p.axis) for p in parts)
