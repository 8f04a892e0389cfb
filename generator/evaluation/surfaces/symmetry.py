"""Rotational symmetry of objects about the vertical, in shape and texture."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float
from scipy.spatial import KDTree

from ...geometry import rotation_z, wrap
from ...scene import Mesh

ORDERS = (8, 6, 5, 4, 3, 2)
"""Finite orders to test, highest first."""

_ANY_ANGLE = np.deg2rad([13.0, 37.0, 71.0, 101.0, 158.0, 223.0])  # angles without symmetry
_MISFIT = 0.015  # maximum fraction of the surface that may differ
_NEAR = 1.6  # maximum distance of a turned point from the surface, in units of the point spacing
_SHADE = 0.15  # minimum colour difference that matters, in [0, 1]
_POINTS, _ASKED, _AROUND = 10_000, 2_000, 8


@dataclass(frozen=True, eq=False)
class Cloud:
    """Evenly spaced points on a visible textured surface, in metres, relative to its vertical axis.

    ``color`` is in [0, 1] and smoothed over neighbours; ``spacing`` is the distance between points.
    """

    position: Float[np.ndarray, "n 3"]
    color: Float[np.ndarray, "n 3"]
    spacing: float

    def turn(self, angle: float) -> Float[np.ndarray, "n 3"]:
        """Return the points rotated about the vertical by ``angle`` radians."""
        return self.position @ rotation_z(angle).T

    def thin(self, count: int) -> Cloud:
        """Return about ``count`` points (every k-th), with colours averaged over neighbours."""
        step = max(1, len(self.position) // count)
        position = self.position[::step]
        smooth = _smooth(self.position, self.color, position, step * _AROUND)
        return Cloud(position, smooth, self.spacing * math.sqrt(step))


def cloud(mesh: Mesh, size: Float[np.ndarray, "3"], count: int = _POINTS) -> Cloud:
    """Sample a canonical mesh of ``size`` (metres), omitting points that another surface covers."""
    from ...render.soft import sample_surface

    drawn = sample_surface(mesh, size, count, seed=0)
    open_air = ~drawn.covered[0].numpy()
    position = drawn.position[0].numpy().astype(float)[open_air]
    color = drawn.color[0].numpy().astype(float)[open_air]
    smooth = _smooth(position, color, position, _AROUND)
    middle = np.array([*position[:, :2].mean(0), position[:, 2].min()])
    return Cloud(position - middle, smooth, math.sqrt(float(drawn.area)))


def _smooth(
    position: Float[np.ndarray, "n 3"],
    color: Float[np.ndarray, "n 3"],
    queries: Float[np.ndarray, "m 3"],
    around: int,
) -> Float[np.ndarray, "m 3"]:
    """Return the mean colour of the ``around`` points nearest to each query position."""
    near = KDTree(position).query(queries, k=min(around, len(position)))[1]
    return color[near.reshape(len(queries), -1)].mean(1)


def find_changes(points: Cloud, angle: float, every: int = 1) -> Bool[np.ndarray, "m"]:
    """Return which points do not match the surface they land on when rotated by ``angle`` radians.

    Only every ``every``-th point is tested.
    """
    turned, color = points.turn(angle)[::every], points.color[::every]
    apart, index = KDTree(points.position).query(turned, k=6)
    away = apart > _NEAR * points.spacing
    shade = np.abs(points.color[index] - color[:, None]).max(-1)
    return (away | (shade > _SHADE)).all(1)


def misfit(points: Cloud, angle: float) -> float:
    """Return the fraction of the surface that looks different when rotated by ``angle`` radians."""
    every = max(1, len(points.position) // _ASKED)
    return float(find_changes(points, angle, every).mean())


def order(mesh: Mesh, size: Float[np.ndarray, "3"], *, prints: bool = True) -> float:
    """Return the order of an object's rotational symmetry about the vertical.

    Shape and texture both count. An order of 1 means no symmetry; n means that the object looks the
    same if turned by 360/n degrees, and infinity, by any angle. Only ``ORDERS`` are tested. Up to
    ``_MISFIT`` of the surface may differ. ``size`` is the canonical mesh's extent, metres. Without
    ``prints``, only shapes are compared, not colours.
    """
    if not prints:
        mesh = Mesh(mesh.vertices, mesh.faces, 0 * mesh.uv, mesh.texture)
    points = cloud(mesh, size)
    if all(misfit(points, angle) < _MISFIT for angle in _ANY_ANGLE):
        return math.inf
    return next((n for n in ORDERS if misfit(points, 2 * np.pi / n) < _MISFIT), 1)


def yaw_error(found: float, true: float, order: float) -> float:
    """Return the difference in degrees between two yaws in radians, given the symmetry ``order``.

    The result is in [0, 180 / order], or 0 if the order is infinite.
    """
    if math.isinf(order):
        return 0.0
    period = 2 * np.pi / order
    off = abs(wrap(found - true)) % period
    return float(np.rad2deg(min(off, period - off)))
