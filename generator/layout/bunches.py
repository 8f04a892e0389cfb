"""Long objects in a vessel, each leaning in its own direction without intersecting the others.

As with flowers in a vase, each foot is on the far side of the vessel's floor and each stem leans on
the rim. Lines twisted about the axis in this way pass each other.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from jaxtyping import Bool, Float
from scipy.spatial import ConvexHull, QhullError

from ..geometry import rotation_z
from ..physics.parts import body_parts
from ..scene import Model
from .cavities import Cavity

_SLICES = 18
_POINTS = 40  # number of positions compared along an object's axis
_CLEAR = 6e-4  # minimum distance of an object from the others and from the wall, metres
_HEAD = 1.25  # minimum ratio of the radius of an object's head to that of its stem
_MANY = 7  # minimum number of objects for which some stand in an inner ring
_TILT = np.deg2rad(58.0)  # maximum lean

Rotation = Float[np.ndarray, "3 3"]


@dataclass(frozen=True, eq=False)
class Stem:
    """A standing object described along its height, in metres; its axis starts at ``foot``.

    ``core`` is its typical radius; ``spheres`` lists (x, y, z, radius) from the foot upwards.
    """

    foot: Float[np.ndarray, "3"]
    length: float
    core: float
    spheres: Float[np.ndarray, "k 4"]


@dataclass(frozen=True, eq=False)
class Stance:
    """An object's rotation in the vessel's frame, and the position of its ``foot`` in metres."""

    turn: Rotation
    foot: Float[np.ndarray, "3"]


@dataclass(frozen=True)
class _Ring:
    """The target position of one of ``count`` objects: its angle in radians and relative radius.

    ``twist`` is the angle between the foot and the point opposite the top, radians.
    """

    angle: float
    share: float
    twist: float
    count: int


def measure_stem(model: Model) -> Stem:
    """Return the axis and thickness of a standing model, in the frame of its bounding box."""
    points = _surface(model)
    low, high = points[:, 2].min(), points[:, 2].max()
    edges = np.linspace(low, high, _SLICES + 1)
    middles, radii, spheres = [], [], []
    for a, b in pairwise(edges):
        slab = points[(points[:, 2] >= a) & (points[:, 2] <= b), :2]
        if len(slab):
            balls = _cover(slab, (a + b) / 2)
            middles.append((slab.min(0) + slab.max(0)) / 2)
            radii.append(float(balls[:, 3].max()))
            spheres.append(balls)
    foot = np.array([*np.mean(middles[: max(2, len(middles) // 4)], axis=0), low])
    core = float(np.median(radii[: max(2, 2 * len(radii) // 3)]))
    return Stem(foot, float(high - low), core, np.concatenate(spheres) - [*foot, 0.0])


def _cover(slab: Float[np.ndarray, "n 2"], z: float) -> Float[np.ndarray, "k 4"]:
    """Return a row of spheres that covers a slice at height ``z``; flat slices need several."""
    middle = (slab.min(0) + slab.max(0)) / 2
    _, axes = np.linalg.eigh(np.cov((slab - slab.mean(0)).T))
    spread = (slab - middle) @ axes
    low, high = spread.min(0), spread.max(0)
    narrow, wide = high - low
    count = int(np.clip(round(wide / max(narrow, 0.2 * wide, 1e-4)), 1, 5))
    if count == 1:
        return np.array([[*middle, z, np.hypot(*(slab - middle).T).max()]])
    along = low[1] + (np.arange(count) + 0.5) * wide / count
    places = middle + np.column_stack([np.full(count, (low[0] + high[0]) / 2), along]) @ axes.T
    radius = np.hypot(narrow / 2, wide / count / 2)
    return np.column_stack([places, np.full(count, z), np.full(count, radius)])


def _surface(model: Model) -> Float[np.ndarray, "n 3"]:
    """Return points, in metres, on the surface of a model's collision shape."""
    steps = 12
    weights = np.array([(i, j, steps - i - j) for i in range(steps + 1)
                        for j in range(steps + 1 - i)]) / steps  # fmt: skip
    found = []
    for points in (part.vertices for part in body_parts(model, model.size)):
        try:
            corners = points[ConvexHull(points).simplices]
        except (QhullError, ValueError):
            corners = points[None, :3]
        found.append(np.einsum("wk,tkd->twd", weights, corners).reshape(-1, 3))
    return np.concatenate(found)


def arrange_bunch(
    stems: Sequence[Stem], cavity: Cavity, upright: Sequence[bool], *, strict: bool
) -> list[Stance | None]:
    """Return the stance of each object in a vessel, or None for an object that has no room.

    With ``strict``, the search stops at the first such object. The ``upright`` objects, which stand
    by themselves, stand straight if possible; all others lean against the rim.
    """
    order = sorted(range(len(stems)), key=lambda k: -stems[k].core)
    placed: list[tuple[Stem, Stance]] = []
    found: list[Stance | None] = [None] * len(stems)
    for number, k in enumerate(order):
        ring = _ring(number, len(stems), stems[k], cavity)
        stance = _stand(stems[k], cavity, placed, ring, straight=upright[k])
        if stance is not None:
            placed.append((stems[k], stance))
            found[k] = stance
        elif strict:
            break
    return found


def _stand(
    stem: Stem,
    cavity: Cavity,
    placed: Sequence[tuple[Stem, Stance]],
    ring: _Ring,
    *,
    straight: bool,
) -> Stance | None:
    """Return an object's best stance that is clear of the objects in ``placed``."""
    feet, tops, cost = _proposals(stem, cavity, ring, straight=straight)
    way = tops - feet
    lean = np.arctan2(np.hypot(way[:, 0], way[:, 1]), way[:, 2])
    keep = lean <= _TILT
    feet, way, lean, cost = feet[keep], way[keep], lean[keep], cost[keep]
    feet[:, 2] += stem.core * np.sin(lean)
    axes = way / np.linalg.norm(way, axis=1, keepdims=True)
    order = np.argsort(cost, kind="stable")
    for chunk in np.array_split(order, max(1, len(order) // 200)):
        turns = np.stack([_turn(axis) for axis in axes[chunk]]) if len(chunk) else np.empty(0)
        if not len(chunk):
            continue
        free = _is_free(stem, feet[chunk], axes[chunk], turns, cavity, placed)
        if free.any():
            best = int(np.flatnonzero(free)[0])
            return Stance(turns[best], feet[chunk[best]])
    return None


def _turn(axis: Float[np.ndarray, "3"]) -> Rotation:
    """Return the rotation that aligns +z with ``axis`` and turns the -x side outwards."""
    lean = float(np.arctan2(np.hypot(axis[0], axis[1]), axis[2]))
    heading = float(np.arctan2(axis[1], axis[0]))
    c, s = np.cos(lean), np.sin(lean)
    tip = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return rotation_z(heading) @ tip @ rotation_z(np.pi)


def _ring(number: int, count: int, stem: Stem, cavity: Cavity) -> _Ring:
    """Return an object's target position by its index; many objects also form an inner ring.

    All objects are twisted just enough to pass each other where they are closest to the axis.
    """
    inner = 0 if count < _MANY else round(count / 4)
    outer = count - inner
    share = 1.0 if number < outer else 0.4
    place, among = (number, outer) if number < outer else (number - outer, inner)
    if count == 1:
        return _Ring(0.7, 1.0, 0.0, 1)
    wide = among * (2.4 * stem.core + 2 * _CLEAR) / (2 * np.pi)
    room = float(min(cavity.radii[0].min(), cavity.radii[-1].min())) - 1.15 * stem.core
    waist = share * max(room, 1e-4)
    return _Ring(
        2 * np.pi * place / among + 0.7, share,
        float(np.clip(2 * np.arcsin(min(wide / waist, 1.0)), 0.3, np.pi)), count,
    )  # fmt: skip


def _proposals(
    stem: Stem, cavity: Cavity, ring: _Ring, *, straight: bool
) -> tuple[Float[np.ndarray, "n 3"], Float[np.ndarray, "n 3"], Float[np.ndarray, "n"]]:
    """Return candidate foot positions, the points where the axes cross the rim, and the costs."""
    steps = (0.15, 0.3, 0.5, 0.75, 1.0, 1.3, 1.6, 2.0, 2.4, 2.8, 3.1)
    spread = np.array([0.0, *(s * v for v in steps for s in (1, -1))])
    twists = np.array([ring.twist] if ring.count == 1 else
                      [ring.twist, 0.3, 0.8, 1.3, 1.8, 2.4, np.pi])  # fmt: skip
    shares = np.array([1.0, 0.7, 0.4, 0.15])
    turn, twist, high, low = (
        v.ravel() for v in np.meshgrid(spread, twists, shares, shares, indexing="ij")
    )
    tops = _at(cavity, ring.angle + turn, high, cavity.rim, stem.core)
    feet = _at(cavity, ring.angle + turn + np.pi - twist, low, cavity.floor, stem.core)
    cost = 0.35 * np.abs(turn) + 1.5 * np.abs(high - ring.share)
    cost += 0.4 * np.abs(low - ring.share) + 0.2 * np.abs(twist - ring.twist)
    if straight:  # upright: the top is directly above the foot, anywhere on the floor
        tops = np.concatenate([feet + np.array([0, 0, cavity.depth]), tops])
        best = 0.15 if ring.count == 1 else 0.7 if ring.count < _MANY else ring.share
        cost = np.concatenate([0.05 * np.abs(turn) + 0.3 * np.abs(low - best), 3.0 + cost])
        feet = np.concatenate([feet, feet])
    return feet, tops, cost


def _at(
    cavity: Cavity,
    angle: Float[np.ndarray, "n"],
    share: Float[np.ndarray, "n"],
    z: float,
    radius: float,
) -> Float[np.ndarray, "n 3"]:
    """Return points at a given height and fraction of the distance from the axis to the wall."""
    ways = np.column_stack([np.cos(angle), np.sin(angle)])
    height = min(max(z, float(cavity.levels[0])), float(cavity.levels[-1]))
    probe = np.column_stack([cavity.middle + 1e-3 * ways, np.full(len(angle), height)])
    away = share * np.maximum(cavity.wall(probe) - 1.15 * radius - 2 * _CLEAR, 0)
    return np.column_stack([cavity.middle + away[:, None] * ways, np.full(len(angle), z)])


def _thickness(stem: Stem, along: Float[np.ndarray, "*n"]) -> Float[np.ndarray, "*n"]:
    """Return the radii of a stem along its axis, with the head limited to the stem's radius."""
    heights, where = np.unique(stem.spheres[:, 2], return_inverse=True)
    radii = np.zeros(len(heights))
    np.maximum.at(radii, where, np.minimum(stem.spheres[:, 3], _HEAD * stem.core))
    return np.interp(along, heights, radii)


def _is_free(
    stem: Stem,
    feet: Float[np.ndarray, "n 3"],
    axes: Float[np.ndarray, "n 3"],
    turns: Float[np.ndarray, "n 3 3"],
    cavity: Cavity,
    placed: Sequence[tuple[Stem, Stance]],
) -> Bool[np.ndarray, "n"]:
    """Return which stances are clear of the vessel's wall and of the objects already placed."""
    steps = np.linspace(0, stem.length, _POINTS)
    thick = _thickness(stem, steps)
    line = feet[:, None] + steps[None, :, None] * axes[:, None]
    free = np.ones(len(feet), bool)
    for other, stance in placed:
        axis = stance.turn[:, 2]
        offset = line[free] - stance.foot
        along = np.clip(offset @ axis, 0, other.length)
        near = np.linalg.norm(offset - along[..., None] * axis, axis=-1)
        free[free] = (near - _thickness(other, along) - thick).min(1) >= _CLEAR
    left = np.flatnonzero(free)
    balls = np.einsum("nij,kj->nki", turns[left], stem.spheres[:, :3]) + feet[left, None]
    radii = stem.spheres[:, 3]
    away = np.hypot(*np.moveaxis(balls[..., :2] - cavity.middle, -1, 0))
    low = np.minimum(balls, [np.inf, np.inf, cavity.rim - 1e-4])
    inner = (balls[..., 2] - radii >= cavity.rim) | (away + radii <= cavity.wall(low))
    clear = (inner & (balls[..., 2] + radii >= cavity.floor)).all(1)
    heads = radii > _HEAD * stem.core
    for other, stance in placed:
        there = other.spheres[:, :3] @ stance.turn.T + stance.foot
        big = other.spheres[:, 3] > _HEAD * other.core
        for own, theirs in ((heads, ~big), (heads, big), (~heads, big)):
            if own.any() and theirs.any():
                gap = np.linalg.norm(balls[:, own, None] - there[None, None, theirs], axis=-1)
                gap -= radii[None, own, None] + other.spheres[None, None, theirs, 3]
                clear &= gap.min((1, 2)) >= _CLEAR
    free[left] = clear
    return free
