"""Short ways to shapes: balls, rods, plates, pads, open vessels, and parts that fit them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from jaxtyping import Float

from ...scene import ConvexPart
from ..surfaces.textures import Tile, speckles
from .collision import bowl_parts, cylinder_part, hull_part, ring_parts
from .forms import above, facing
from .outlines import rectangle, smooth
from .shape import Shape, shape
from .solids import Solid, ellipsoid, lathe, loft, prism, tube

Pieces = list[tuple[Solid, Tile]]
"""Solids, each with the tile it shows."""

Point = tuple[float, float, float]

Profile = Sequence[tuple[float, float]]
"""(radius, z) points of an outside, metres."""


def put_down(
    pieces: Pieces, *bodies: Solid, factor: float = 1.0, opacity: float = 1.0, foot: float = 0.0
) -> Shape:
    """Return a shape of pieces whose convex parts are the hulls of ``bodies`` (else all pieces).

    What lies under z = 0 is pressed flat there, so that round things get a foot. ``foot`` sets the
    lowest share of each part that is near the ground down on it: what is round and lies stays.
    """
    solids = bodies or tuple(solid for solid, _ in pieces)
    low = max(min(float(solid.bounds[0, 2]) for solid, _ in pieces), 0.0)
    parts = [hull_part(_set_down(above(solid.vertices), low, foot)) for solid in solids]
    return shape(pieces, parts, opacity).scale(factor)


def _set_down(points: Float[np.ndarray, "n 3"], low: float, share: float) -> np.ndarray:
    """Return points, the lowest ``share`` of the height above ``low`` moved down to it."""
    made = points.copy()
    made[made[:, 2] < low + share * (made[:, 2].max() - low), 2] = low
    return made


def ball(x: float, y: float, z: float, at: Point = (0, 0, 0), fine: int = 16) -> Solid:
    """Return an ellipsoid with diameters x, y, z about ``at``."""
    return ellipsoid(x, y, z, fine, max(fine // 2, 5)).move(*at)


def rod(points: Any, radius: Any, sides: int = 8, steps: int = 4) -> Solid:
    """Return a round rod along a smooth curve through ``points``; one radius, or one per point."""
    path = smooth(points, steps)
    if np.ndim(radius):
        radius = np.interp(
            np.linspace(0, 1, len(path)), np.linspace(0, 1, len(radius)), np.asarray(radius)
        )
    return tube(path, radius, sides)


def straight(a: Point, b: Point, radius: Any, sides: int = 8) -> Solid:
    """Return a straight round rod from ``a`` to ``b``."""
    return tube([a, b], radius, sides)


def standing_plate(outline: Any, thick: float, y: float = 0.0, bevel: float = 0.0) -> Solid:
    """Return an outline (x, z; counter-clockwise) as an upright plate facing the front."""
    return facing(prism(outline, -thick / 2, thick / 2, bevel)).move(y=y)


def pad(x: float, y: float, h: float, radius: float, *, soft: float = 0.3, steps: int = 5) -> Solid:
    """Return a soft-edged slab on z = 0: folded cloth, cushions, pouches, soap."""
    outline = rectangle(x, y, radius, steps)
    edge = soft * h
    levels = [(edge, 0.0), (0.3 * edge, 0.15 * h), (0, 0.5 * h), (0.3 * edge, 0.85 * h), (edge, h)]
    rings = [
        np.column_stack(
            [outline * [1 - 2 * inward / x, 1 - 2 * inward / y], np.full(len(outline), z)]
        )
        for inward, z in levels
    ]
    return loft(np.stack(rings), outline)


def leather(rng: np.random.Generator, color: tuple[float, float, float]) -> Tile:
    """Return grained leather."""
    return speckles(rng, color, 9, 64)


def open_vessel(
    side: Profile, wall: float, bottom: float, segments: int = 28
) -> tuple[Solid, tuple[ConvexPart, ...]]:
    """Return an open vessel and its convex parts.

    Args:
        side: (radius, z) points of the outside in metres, from z = 0 up to the rim.
        wall: thickness of the wall, metres.
        bottom: thickness of the bottom, metres.
        segments: sides of the vessel seen from above.

    v is below 0.5 on the outside, 0.5 at the rim and above it on the inside.
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
