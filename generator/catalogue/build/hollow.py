"""Open round vessels: a wall of one thickness and the convex parts that keep its hollow open."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...scene import ConvexPart
from .collision import bowl_parts, cylinder_part, ring_parts
from .solids import Solid, lathe

Profile = Sequence[tuple[float, float]]


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
