"""Where to put two fingers: top grasps found on the collision shapes as they stand.

For each turn of the hand and each strip of a finger's breadth across the object, the object's
cross-section at the fingers' height is cut into solid runs: a can gives one run, a mug its two
walls, a handle one of its own. A run narrow enough to be straddled, whose sides face each other
(antipodal within the friction cone), is a grasp if there is room beside it: a gripper that comes
straight down meets the rest of the world as a height map.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float

from generator.geometry import rotation_yaw

from ..robot import franka
from .heights import HeightMap, Solid, moved, solid, surroundings

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ..world import World

WIDEST = 0.0735
"""Widest run to straddle, metres: the opening of 8 cm less what aiming needs."""

TIP = 0.0088
"""How far the fingertips reach beyond the tool centre point, metres."""

_TURNS = 12
_STEP_U, _STEP_V, _RISE = 0.0015, 0.003, 0.003
_FINGER_HALF = 0.0105
_PAD_DEPTH, _PAD_HEIGHT = 0.0125, 0.0188
_SHAFT = (0.007, 0.0265)
_PALM_U, _PALM_V, _PALM_Z = 0.112, 0.042, 0.042
_PALM_REACH = 0.13
_DEPTHS = (0.041, 0.036, 0.03, 0.026, 0.022, 0.0185, 0.015, 0.011)
_LEAST_HOLD = 0.008
_MARGIN = 0.011
_ABOVE_TABLE = 0.003
_STEEPEST = 0.4
_MOST_LEAN = 0.6
_TOUCHED = 0.75


@dataclass(frozen=True, eq=False)
class Grasp:
    """Where to close the fingers, in the world frame.

    ``point`` is the tool centre point (m), ``angle`` the direction of opening about +z (radians,
    equal modulo pi), ``opening`` how far to open before going down and ``width`` what will be
    between the fingers (m). A higher ``score`` is better.
    """

    point: Float[np.ndarray, "3"]
    angle: float
    opening: float
    width: float
    score: float


def plan_grasps(world: World, target: str, avoid: tuple[Grasp, ...] = ()) -> list[Grasp]:
    """Return top grasps of ``target`` where it is now, best first.

    Args:
        world: the world; live poses count.
        target: an object's name.
        avoid: grasps that failed; those within 1.5 cm and 20 degrees of them rank last.
    """
    found = [_demoted(grasp, avoid) for grasp in _candidates(world, target)]
    return sorted(found, key=lambda grasp: -grasp.score)


def is_graspable(world: World, target: str) -> bool:
    """Return whether ``plan_grasps`` finds any; stops at the first."""
    return next(_candidates(world, target), None) is not None


def _candidates(world: World, target: str) -> Iterator[Grasp]:
    """Yield grasps of ``target`` where it is now, turn by turn of the hand."""
    position, rotation = world.position(target), world.rotation(target)
    own = moved(world.scene.object(target).parts, position, rotation)
    shape = solid(own, _STEP_U, _RISE)
    low = shape.origin
    high = low + np.array(shape.filled.shape[:2]) * shape.cell
    others = surroundings(world, target, low - _PALM_REACH, high + _PALM_REACH, _STEP_V)
    com = position + rotation @ world.scene.object(target).com
    floor = world.scene.table.height
    facing = rotation_yaw(rotation)
    for angle in facing + np.arange(_TURNS) * np.pi / _TURNS:
        yield from _along(shape, others, com, float(angle), floor)


def _demoted(grasp: Grasp, avoid: tuple[Grasp, ...]) -> Grasp:
    for failed in avoid:
        turn = (grasp.angle - failed.angle + np.pi / 2) % np.pi - np.pi / 2
        near = np.linalg.norm(grasp.point - failed.point) < 0.015
        if near and abs(turn) < np.deg2rad(20.0):
            grasp = Grasp(grasp.point, grasp.angle, grasp.opening, grasp.width, grasp.score - 4.0)
    return grasp


def _along(
    shape: Solid,
    others: HeightMap,
    com: Float[np.ndarray, "3"],
    angle: float,
    floor: float,
) -> Iterator[Grasp]:
    """Yield grasps whose fingers open along ``angle``."""
    across = np.array([np.cos(angle), np.sin(angle)])
    along = np.array([-across[1], across[0]])
    size = np.array(shape.filled.shape[:2]) * shape.cell
    middle = shape.origin + size / 2
    half = float(np.linalg.norm(size)) / 2
    u = np.arange(-half - 0.11, half + 0.11, _STEP_U)
    v = np.arange(-half - 0.04, half + 0.04, _STEP_V)
    points = middle + u[None, :, None] * across + v[:, None, None] * along
    filled = shape.at(points)
    steps = np.arange(1, len(shape.levels) + 1)
    own = shape.levels[0] - _RISE / 2 + _RISE * (filled * steps).max(-1)
    both = np.maximum(np.maximum(own, others.at(points)), floor)
    finger, palm = (int(np.ceil(h / _STEP_V)) for h in (_FINGER_HALF, _PALM_V))
    rows = np.flatnonzero(filled.any((1, 2)))
    for row in range(rows[0], rows[-1] + 1, 2):
        strip = filled[row - finger + 1 : row + finger]
        beside = both[row - finger : row + finger + 1].max(0)
        above = both[row - palm : row + palm + 1].max(0)
        for tip, left, right, quality in _runs(strip, shape.levels, floor):
            center, width = (u[left] + u[right]) / 2, u[right] - u[left] + _STEP_U
            room = _room(u, beside, above, float(center), float(width), tip)
            if room is None:
                continue
            point = np.array([*(middle + center * across + v[row] * along), tip + TIP])
            away = float(np.linalg.norm(point[:2] - com[:2]))
            score = quality - 12.0 * away + 40.0 * min(room - width, 0.02)
            yield Grasp(point, angle, room, float(width), float(score))


def _runs(
    strip: Bool[np.ndarray, "k n z"], levels: Float[np.ndarray, "z"], floor: float
) -> Iterator[tuple[float, int, int, float]]:
    """Yield (tip height, first cell, last cell, quality) of runs that can be straddled."""
    occupied = np.flatnonzero(strip.any((0, 1)))
    if not len(occupied):
        return
    top = float(levels[occupied[-1]]) + _RISE / 2
    for tip in sorted({round(max(top - d, floor + _ABOVE_TABLE), 4) for d in _DEPTHS}):
        at_pad = (levels >= tip) & (levels <= tip + _PAD_HEIGHT)
        if not at_pad.any():
            continue
        slab = strip[:, :, at_pad]
        edges = np.flatnonzero(np.diff(np.concatenate([[0], slab.any((0, 2)), [0]]).astype(int)))
        for left, end in edges.reshape(-1, 2):
            if (end - left) * _STEP_U <= WIDEST:
                quality = _quality(slab[:, left:end])
                if quality is not None:
                    yield tip, int(left), int(end) - 1, quality


def _quality(run: Bool[np.ndarray, "k n z"]) -> float | None:
    """Rate the two sides of a run, or None if the fingers would slide off.

    A side is where the run begins or ends, by line (along the finger's breadth) and by level. Its
    *slope* along the breadth, the *squeeze* by which the run narrows upwards (it would pop out) and
    the *lean* of its middle (the fingers would meet at different heights) stay below limits that
    lie well within the pads' friction cone. Levels much narrower than the widest are not touched.
    """
    lines = np.flatnonzero(run.any((1, 2)))
    widths = np.any(run, axis=0).sum(0)
    layers = np.flatnonzero(widths >= _TOUCHED * widths.max())
    share, hold = len(lines) / len(run), len(layers) * _RISE
    if share < 0.6 or hold < _LEAST_HOLD:
        return None
    by_line, by_layer = np.any(run, axis=2)[lines], np.any(run, axis=0).T[layers]
    ends = [_ends(rows) for rows in (by_line, by_layer)]
    first_slope, last_slope = (_trend(side, lines * _STEP_V) for side in ends[0])
    first_rise, last_rise = (_trend(side, layers * _RISE) for side in ends[1])
    slope = max(abs(first_slope), abs(last_slope))
    squeeze, lean = (first_rise - last_rise) / 2, abs(first_rise + last_rise) / 2
    if slope > _STEEPEST or squeeze > _STEEPEST or squeeze < -1.0 or lean > _MOST_LEAN:
        return None
    rough = float(np.ptp(ends[0][0]) + np.ptp(ends[0][1]))
    bent = 2.0 * slope + 2.0 * max(squeeze, 0.0) + 1.5 * lean + 20.0 * rough
    return share + hold / _PAD_HEIGHT - bent


def _ends(
    rows: Bool[np.ndarray, "k n"],
) -> tuple[Float[np.ndarray, "k"], Float[np.ndarray, "k"]]:
    """Return where each row begins and ends, metres."""
    last = rows.shape[1] - 1 - rows[:, ::-1].argmax(1)
    return rows.argmax(1) * _STEP_U, last * _STEP_U


def _trend(side: Float[np.ndarray, "k"], at: Float[np.ndarray, "k"]) -> float:
    """Return the slope of a straight line through ``side`` over ``at``, zero for one point."""
    offset = at - at.mean()
    spread = float(offset @ offset)
    return float(side @ offset) / spread if spread > 0 else 0.0


def _room(
    u: Float[np.ndarray, "n"],
    beside: Float[np.ndarray, "n"],
    above: Float[np.ndarray, "n"],
    center: float,
    width: float,
    tip: float,
) -> float | None:
    """Return the widest opening (m) whose fingers and palm come down free, or None.

    ``beside`` and ``above`` are the highest surfaces in the fingers' and in the palm's strip.
    """
    if above[np.abs(u - center) <= _PALM_U].max() > tip + _PALM_Z:
        return None
    distance = np.abs(u - center)
    for margin in (2.0 * _MARGIN, 1.5 * _MARGIN, _MARGIN, 0.6 * _MARGIN):
        opening = min(width + 2 * margin, 2 * franka.FINGER_STROKE - 0.001)
        inner = opening / 2
        pads = (distance >= inner - 0.001) & (distance <= inner + _PAD_DEPTH)
        shafts = (distance >= inner + _SHAFT[0]) & (distance <= inner + _SHAFT[1])
        if beside[pads].max() <= tip - 0.001 and beside[shafts].max() <= tip + _PAD_HEIGHT - 0.002:
            return opening
    return None
