"""Which turns about the vertical leave an object as it is, and yaw errors that respect them."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float
from scipy.spatial import KDTree

from generator.geometry import rotation_z, wrap
from generator.scene import Mesh

ORDERS = (8, 6, 5, 4, 3, 2)
"""Finite orders that are looked for, highest first."""

_ANY_ANGLE = np.deg2rad([13.0, 37.0, 71.0, 101.0, 158.0, 223.0])  # in no symmetry of low order
_MISFIT = 0.015  # share of the surface that may differ
_NEAR = 1.6  # of the spacing of points: that far may a turned point lie from the surface
_SHADE = 0.15  # difference of colours in [0, 1] that counts
_FLAT = 0.012  # change of the mean distance, over the object's radius, that is the samples' own
_POINTS, _ASKED, _AROUND = 10_000, 2_000, 8


@dataclass(frozen=True, eq=False)
class Cloud:
    """Even points of a visible textured surface: metres about the vertical through its centroid.

    ``color`` is in [0, 1] and smoothed over neighbours; ``spacing`` is the points' distance.
    """

    position: Float[np.ndarray, "n 3"]
    color: Float[np.ndarray, "n 3"]
    spacing: float

    def turned(self, angle: float) -> Float[np.ndarray, "n 3"]:
        """Return the points turned by ``angle`` radians about the vertical."""
        return self.position @ rotation_z(angle).T


def cloud(
    mesh: Mesh, size: Float[np.ndarray, "3"], count: int = _POINTS, around: int = _AROUND
) -> Cloud:
    """Sample a canonical mesh of ``size`` (metres); what lies right under a cover is left out."""
    from generator.render.soft import sample_surface

    drawn = sample_surface(mesh, size, count, seed=0)
    open_air = ~drawn.covered[0].numpy()
    position = drawn.position[0].numpy().astype(float)[open_air]
    color = drawn.color[0].numpy().astype(float)[open_air]
    near = KDTree(position).query(position, k=min(around, len(position)))[1]
    smooth = color[near.reshape(len(position), -1)].mean(1)
    middle = np.array([*position[:, :2].mean(0), position[:, 2].min()])
    return Cloud(position - middle, smooth, float(np.sqrt(drawn.area)))


def misfit(points: Cloud, angle: float) -> float:
    """Return the share of the surface that looks different when it is turned by ``angle``."""
    asked = slice(None, None, max(1, len(points.position) // _ASKED))
    turned, color = points.turned(angle)[asked], points.color[asked]
    apart, index = KDTree(points.position).query(turned, k=6)
    away = apart > _NEAR * points.spacing
    shade = np.abs(points.color[index] - color[:, None]).max(-1)
    return float((away | (shade > _SHADE)).all(1).mean())


def order(mesh: Mesh, size: Float[np.ndarray, "3"]) -> float:
    """Return the order of an object's rotational symmetry about the vertical, from shape and look.

    1 has none, n looks the same turned by 360/n degrees, infinity turned by any angle. Only
    ``ORDERS`` are looked for. Up to ``_MISFIT`` of the surface may differ.
    """
    points = cloud(mesh, size)
    if all(misfit(points, angle) < _MISFIT for angle in _ANY_ANGLE):
        return math.inf
    for n in ORDERS:
        if misfit(points, 2 * np.pi / n) < _MISFIT:
            return n
    return 1


def yaw_error(found: float, true: float, order: float) -> float:
    """Return how far two yaws (radians) are apart, at best, for an object of that order: degrees.

    In [0, 180 / order]; 0 if the order is infinite.
    """
    if math.isinf(order):
        return 0.0
    period = 2 * np.pi / order
    off = abs(wrap(found - true)) % period
    return float(np.rad2deg(min(off, period - off)))


def best_turn(found: Cloud, true: Cloud) -> float | None:
    """Return by how much one posed object is turned against another of another make, radians.

    Both clouds are posed; sizes are made equal. The turn undone that brings the surfaces, with
    their colours, closest together counts; of turns that do so equally well (to 3 % of what
    turning changes), the smallest. None if turning changes nothing: then one of the two is round.
    """
    one, other = _normal(found), _normal(true)
    coarse = np.deg2rad(np.arange(0, 360, 5.0))
    costs = np.array([_apart(one, other, -angle) for angle in coarse])
    change = float(np.ptp(costs))
    if change < _FLAT:
        return None
    low = (costs <= np.roll(costs, 1)) & (costs <= np.roll(costs, -1))
    starts = coarse[low & (costs <= costs.min() + 0.35 * change)]
    ends = []
    for start in starts:
        cost, turn = np.inf, float(start)
        for reach, step in ((4.0, 1.0), (0.75, 0.25)):
            near = turn + np.deg2rad(np.arange(-reach, reach + step / 2, step))
            here = [_apart(one, other, -angle) for angle in near]
            cost, turn = min(here), float(near[int(np.argmin(here))])
        ends.append((cost, wrap(turn)))
    least = min(cost for cost, _ in ends)
    return min((turn for cost, turn in ends if cost <= least + 0.03 * change), key=abs)


def posed(points: Cloud, yaw: float) -> Cloud:
    """Return a cloud turned by ``yaw`` radians."""
    return Cloud(points.turned(yaw), points.color, points.spacing)


def _normal(points: Cloud) -> Cloud:
    radius = float(np.sqrt((points.position**2).sum(1).mean()))
    return Cloud(points.position / radius, points.color, points.spacing / radius)


def _apart(one: Cloud, other: Cloud, angle: float, weight: float = 0.3) -> float:
    """Return the mean distance of nearest points, both ways, in space and (weighted) colour."""
    a = np.hstack([one.turned(angle), weight * one.color])
    b = np.hstack([other.position, weight * other.color])
    return float(KDTree(b).query(a)[0].mean() + KDTree(a).query(b)[0].mean())
