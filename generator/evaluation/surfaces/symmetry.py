"""Which turns about the vertical leave an object as it is, from its shape and its look."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float
from scipy.spatial import KDTree

from ...geometry import rotation_z, wrap
from ...scene import Mesh

ORDERS = (8, 6, 5, 4, 3, 2)
"""Finite orders that are looked for, highest first."""

_ANY_ANGLE = np.deg2rad([13.0, 37.0, 71.0, 101.0, 158.0, 223.0])  # in no symmetry of low order
_MISFIT = 0.015  # share of the surface that may differ
_NEAR = 1.6  # of the spacing of points: that far may a turned point lie from the surface
_SHADE = 0.15  # difference of colours in [0, 1] that counts
_POINTS, _ASKED, _AROUND = 10_000, 2_000, 8


@dataclass(frozen=True, eq=False)
class Cloud:
    """Even points of a visible textured surface: metres about the vertical through its centroid.

    ``color`` is in [0, 1] and smoothed over neighbours; ``spacing`` is the points' distance.
    """

    position: Float[np.ndarray, "n 3"]
    color: Float[np.ndarray, "n 3"]
    spacing: float

    def turn(self, angle: float) -> Float[np.ndarray, "n 3"]:
        """Return the points turned by ``angle`` radians about the vertical."""
        return self.position @ rotation_z(angle).T

    def thin(self, count: int) -> Cloud:
        """Return every k-th point, about ``count``, colours smoothed over as many neighbours."""
        step = max(1, len(self.position) // count)
        position = self.position[::step]
        smooth = _smooth(self.position, self.color, position, step * _AROUND)
        return Cloud(position, smooth, self.spacing * math.sqrt(step))


def cloud(mesh: Mesh, size: Float[np.ndarray, "3"], count: int = _POINTS) -> Cloud:
    """Sample a canonical mesh of ``size`` (metres); what lies right under a cover is left out."""
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
    asked: Float[np.ndarray, "m 3"],
    around: int,
) -> Float[np.ndarray, "m 3"]:
    """Return the mean colour of the points nearest to each place asked."""
    near = KDTree(position).query(asked, k=min(around, len(position)))[1]
    return color[near.reshape(len(asked), -1)].mean(1)


def find_changes(points: Cloud, angle: float, every: int = 1) -> Bool[np.ndarray, "m"]:
    """Return which points, turned by ``angle`` radians, lie where the surface looks different.

    Only each ``every``-th point is asked.
    """
    turned, color = points.turn(angle)[::every], points.color[::every]
    apart, index = KDTree(points.position).query(turned, k=6)
    away = apart > _NEAR * points.spacing
    shade = np.abs(points.color[index] - color[:, None]).max(-1)
    return (away | (shade > _SHADE)).all(1)


def misfit(points: Cloud, angle: float) -> float:
    """Return the share of the surface that looks different when it is turned by ``angle``."""
    every = max(1, len(points.position) // _ASKED)
    return float(find_changes(points, angle, every).mean())


def order(mesh: Mesh, size: Float[np.ndarray, "3"], *, prints: bool = True) -> float:
    """Return the order of an object's rotational symmetry about the vertical, from shape and look.

    1 has none, n looks the same turned by 360/n degrees, infinity turned by any angle. Only
    ``ORDERS`` are looked for. Up to ``_MISFIT`` of the surface may differ. ``size`` is the
    canonical mesh's extent, metres; without ``prints`` the shape alone counts, not colours.
    """
    if not prints:
        mesh = Mesh(mesh.vertices, mesh.faces, 0 * mesh.uv, mesh.texture)
    points = cloud(mesh, size)
    if all(misfit(points, angle) < _MISFIT for angle in _ANY_ANGLE):
        return math.inf
    return next((n for n in ORDERS if misfit(points, 2 * np.pi / n) < _MISFIT), 1)


def yaw_error(found: float, true: float, order: float) -> float:
    """Return how far two yaws (radians) are apart, at best, for an object of that order: degrees.

    In [0, 180 / order]; 0 if the order is infinite.
    """
    if math.isinf(order):
        return 0.0
    period = 2 * np.pi / order
    off = abs(wrap(found - true)) % period
    return float(np.rad2deg(min(off, period - off)))
