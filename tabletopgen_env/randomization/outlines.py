"""Convex outlines on the table, seen from above: motion and distances."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Bool, Float

from generator.geometry import convex_outline

Outline = Float[np.ndarray, "_ 2"]
"""A convex outline, counter-clockwise, in metres."""

Outlines = Float[np.ndarray, "c k 2"]
Point = Float[np.ndarray, "2"]
Moves = Float[np.ndarray, "c 3"]
"""Translation along x and y, in metres, and rotation, in radians."""


def hull(outlines: Sequence[Outline]) -> Outline:
    """Return the convex hull of several outlines."""
    return outlines[0] if len(outlines) == 1 else convex_outline(np.concatenate(outlines))


def carry(outline: Outline, centre: Point, moves: Moves) -> Outlines:
    """Return the outline after each of the moves: rotated about ``centre``, then translated."""
    c, s = np.cos(moves[:, 2, None]), np.sin(moves[:, 2, None])
    x, y = (outline - centre).T
    turned = np.stack([c * x - s * y, s * x + c * y], -1)
    return turned + centre + moves[:, None, :2]


def keeps(
    own: Outlines, other: Outline, was: Outline, others: Outline, room: float
) -> Bool[np.ndarray, "c"]:
    """Return which outlines keep a gap of ``room`` to ``other``, or the original gap if smaller.

    ``was`` and ``others`` are the original outlines of the moved object and of ``other``; their
    distance is sufficient if it is smaller than ``room``.
    """
    if not near(own, other, room):
        return np.ones(len(own), bool)
    far = apart(own, other)
    if (far >= room).all():
        return np.ones(len(own), bool)
    return far >= min(room, float(apart(was[None], others)[0]))


def near(own: Outlines, other: Outline, room: float) -> bool:
    """Return whether the bounding boxes of ``own`` and ``other`` are at most ``room`` apart."""
    low, high = own.min((0, 1)) - room, own.max((0, 1)) + room
    return bool((low <= other.max(0)).all() and (high >= other.min(0)).all())


def apart(own: Outlines, other: Float[np.ndarray, "m 2"]) -> Float[np.ndarray, "c"]:
    """Return each convex outline's distance to an outline or a point, negative if they overlap.

    The result is the largest separation along an edge normal, a lower bound of the distance.
    """
    normals = _normals(own)
    ahead = np.einsum("cki,mi->ckm", normals, other) - (normals * own).sum(-1)[..., None]
    found = ahead.min(2).max(1)
    if len(other) < 3:
        return found
    normals = _normals(other[None])[0]
    ahead = own @ normals.T - (normals * other).sum(-1)
    return np.maximum(found, ahead.min(1).max(1))


def _normals(outlines: Outlines) -> Outlines:
    """Return the outward edge normals of counter-clockwise outlines."""
    edges = np.roll(outlines, -1, axis=1) - outlines
    normals = np.stack([edges[..., 1], -edges[..., 0]], -1)
    return normals / np.linalg.norm(normals, axis=-1, keepdims=True)
