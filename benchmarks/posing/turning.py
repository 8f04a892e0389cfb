"""Rotation between two models of one object, estimated from their surfaces."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float
from scipy.spatial import KDTree

from generator.evaluation.surfaces.symmetry import Cloud, find_changes
from generator.geometry import wrap

_COARSE, _FINE = 1200, 4000  # points of each cloud during the search, and during refinement
_FLAT = 0.012  # sampling noise of the mean distance, relative to the object's radius
_TIE = 0.03  # relative margin within which two rotations fit about equally well
_TELLING = 0.15  # share of their difference in the true object that decides between them
_FEW = 20  # minimum number of points that must differ
_INK = 0.3  # weight of colours relative to positions


def best_turn(found: Cloud, true: Cloud) -> float | None:
    """Return the rotation of one posed object relative to another model of it, radians.

    Both clouds are posed; sizes are made equal. The result is the rotation whose inverse brings the
    surfaces, with their colours, closest together. Among rotations that fit nearly equally well,
    like those of a pencil's two ends, the one is chosen that fits clearly better where the true
    object itself looks different between them; if that does not decide either, the smallest one
    within the margin ``_TIE``. None if rotation changes nothing, that is, if one of the objects is
    round.
    """
    one, other = _normal(found), _normal(true)
    near, far = one.thin(_COARSE), other.thin(_COARSE)
    coarse = np.deg2rad(np.arange(0, 360, 5.0))
    costs = np.array([_apart(near, far, -angle) for angle in coarse])
    change = float(np.ptp(costs))
    if change < _FLAT:
        return None
    low = (costs <= np.roll(costs, 1)) & (costs <= np.roll(costs, -1))
    starts = coarse[low & (costs <= costs.min() + 0.35 * change)]
    near, far = one.thin(_FINE), other.thin(_FINE)
    ends = [_refine(near, far, float(start)) for start in starts]
    least = min(cost for cost, _ in ends)
    close = [(cost > least + _TIE * change, abs(turn), turn)
             for cost, turn in ends if cost <= least + max(_TIE * change, _FLAT)]  # fmt: skip
    best, *rivals = [turn for *_, turn in sorted(close)]
    for rival in rivals:
        best = rival if _fits_better(one, other, rival, best) else best
    return best


def turn_cloud(points: Cloud, yaw: float) -> Cloud:
    """Return a cloud rotated by ``yaw`` radians."""
    return Cloud(points.turn(yaw), points.color, points.spacing)


def _refine(one: Cloud, other: Cloud, turn: float) -> tuple[float, float]:
    """Return the cost and the rotation of the minimum near ``turn``."""
    cost = np.inf
    for reach, step in ((4.0, 1.0), (0.75, 0.25)):
        near = turn + np.deg2rad(np.arange(-reach, reach + step / 2, step))
        here = [_apart(one, other, -angle) for angle in near]
        cost, turn = min(here), float(near[int(np.argmin(here))])
    return cost, wrap(turn)


def _fits_better(found: Cloud, true: Cloud, rival: float, best: float) -> bool:
    """Return whether ``rival`` fits clearly better than ``best`` where the true object differs.

    If ``rival`` is correct, ``found`` rotated back by ``best`` shows the true object rotated by
    ``rival - best``: only where that changes the object can the two be distinguished.
    """
    between = rival - best
    telling = find_changes(true, -between)
    if int(telling.sum()) < _FEW:
        return False
    asked = _features(true, 0.0)[telling]

    def away(cloud: Cloud, turn: float) -> float:
        return float(KDTree(_features(cloud, turn)).query(asked)[0].mean())

    gain = away(found, -best) - away(found, -rival)
    return gain > _TELLING * away(true, between)


def _normal(points: Cloud) -> Cloud:
    radius = float(np.sqrt((points.position**2).sum(1).mean()))
    return Cloud(points.position / radius, points.color, points.spacing / radius)


def _features(points: Cloud, angle: float) -> Float[np.ndarray, "n 6"]:
    """Return rotated positions and weighted colours side by side."""
    return np.hstack([points.turn(angle), _INK * points.color])


def _apart(one: Cloud, other: Cloud, angle: float) -> float:
    """Return the mean nearest-point distance, both ways, in space and (weighted) colour."""
    a, b = _features(one, angle), _features(other, 0.0)
    return float(KDTree(b).query(a)[0].mean() + KDTree(a).query(b)[0].mean())
