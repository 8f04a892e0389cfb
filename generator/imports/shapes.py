"""Primitive shapes as points and triangles, and as convex parts along a body's axes."""

from __future__ import annotations

from functools import cache
from itertools import product
from typing import Literal

import numpy as np
from jaxtyping import Float, Int

from ..geometry import hull_points
from ..scene import ConvexPart

Solid = Literal["box", "cylinder", "capsule", "ellipsoid"]
"""Kinds of primitives; a sphere is stored as an ellipsoid."""

_SIDES, _RINGS = 32, 16
_ALIGNED = 1e-4  # tolerance of a rotation that maps axes to axes


def solid_surface(
    kind: Solid, half: Float[np.ndarray, "3"]
) -> tuple[Float[np.ndarray, "n 3"], Int[np.ndarray, "m 3"]]:
    """Return the vertices and outward faces of a solid at the origin with half extents ``half``.

    Cylinders and capsules are along z; half[2] excludes a capsule's caps.
    """
    from trimesh import creation

    if kind == "box":
        made = creation.box(2 * half)
    elif kind == "cylinder":
        made = creation.cylinder(float(half[0]), 2 * float(half[2]), sections=_SIDES)
    elif kind == "capsule":
        made = creation.capsule(2 * float(half[2]), float(half[0]), count=(_SIDES, _RINGS))
        low, high = made.bounds
        made.vertices = made.vertices - (low + high) / 2
    else:
        points, faces = _unit_ball()
        return points * half, faces.copy()
    return np.asarray(made.vertices, np.float64), np.asarray(made.faces, np.int64)


@cache
def _unit_ball() -> tuple[Float[np.ndarray, "n 3"], Int[np.ndarray, "m 3"]]:
    from trimesh import creation

    made = creation.uv_sphere(1.0, count=(_SIDES, _SIDES))
    return np.asarray(made.vertices, np.float64), np.asarray(made.faces, np.int64)


def solid_part(
    kind: Solid,
    half: Float[np.ndarray, "3"],
    center: Float[np.ndarray, "3"],
    rotation: Float[np.ndarray, "3 3"],
) -> ConvexPart:
    """Return a solid at a pose as a convex part: a primitive if it is aligned with the axes."""
    axes = np.abs(rotation).round()
    ball = kind == "ellipsoid" and np.ptp(half) < 1e-9
    aligned = ball or np.abs(np.abs(rotation) - axes).max() < _ALIGNED
    if not aligned or kind == "capsule":
        return ConvexPart(hull_corners(solid_surface(kind, half)[0] @ rotation.T + center))
    turned = half if ball else axes @ half
    if kind == "cylinder":
        axis = int(axes[:, 2].argmax())
        points = _drum(turned, axis)
        return ConvexPart(points + center, "cylinder", (0, 1, 2)[axis])
    corners = np.array([*product((-1.0, 1.0), repeat=3)])
    if kind == "box":
        return ConvexPart(corners * turned + center, "box")
    return ConvexPart(solid_surface("ellipsoid", turned)[0] + center, "ellipsoid")


def part_of(points: Float[np.ndarray, "n 3"], kind: str) -> ConvexPart:
    """Return a convex part of a known kind, such as "sphere", given points on its surface."""
    if kind == "cylinder":
        flat = [len(np.unique(points[:, k].round(6))) for k in range(3)]
        return ConvexPart(points, "cylinder", (0, 1, 2)[int(np.argmin(flat))])
    if kind in ("sphere", "ellipsoid"):
        return ConvexPart(points, "ellipsoid")
    return ConvexPart(points, "box") if kind == "box" else ConvexPart(hull_corners(points))


def hull_corners(points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "k 3"]:
    """Return the vertices of the points' convex hull, or all distinct points of a flat set."""
    return hull_points(np.unique(np.asarray(points, np.float64).round(7), axis=0))


def few_corners(points: Float[np.ndarray, "n 3"], most: int = 128) -> Float[np.ndarray, "k 3"]:
    """Return at most ``most`` convex hull vertices that are extreme in evenly spread directions."""
    corners = hull_corners(points)
    if len(corners) <= most:
        return corners
    height = 1 - (2 * np.arange(most) + 1) / most
    angle = np.pi * (1 + 5**0.5) * np.arange(most)
    across = np.sqrt(1 - height**2)
    directions = np.column_stack([across * np.cos(angle), across * np.sin(angle), height])
    return corners[np.unique((directions @ corners.T).argmax(1))]


def _drum(half: Float[np.ndarray, "3"], axis: int) -> Float[np.ndarray, "n 3"]:
    """Return points on both rims of a cylinder along an axis."""
    angles = np.arange(_SIDES) * 2 * np.pi / _SIDES
    across = [k for k in range(3) if k != axis]
    points = np.zeros((2, _SIDES, 3))
    points[:, :, across[0]] = half[across[0]] * np.cos(angles)
    points[:, :, across[1]] = half[across[1]] * np.sin(angles)
    points[0, :, axis], points[1, :, axis] = -half[axis], half[axis]
    return points.reshape(-1, 3)
