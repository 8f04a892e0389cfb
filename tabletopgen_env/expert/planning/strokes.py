"""Push strokes: the position of the closed fingers and the yaw of the hand for pushing.

The hand pushes along the line through the centre of mass, where an object slides without turning.
The fingers and the palm above them need space along the whole way.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from jaxtyping import Float

from generator.geometry import wrap
from generator.scene import ConvexPart

from ...world.world import World
from ..arm import stretch, turn_left, wrist_is_free
from .grasps import TIP
from .heights import HeightMap, height_map, parts_of, surroundings

BEHIND = 0.025
"""Distance between the fingers and the object before a stroke, in metres."""

HOVER = 0.06
"""Height from which the hand moves straight down, in metres."""

PAD = 0.01
"""Half the thickness of the closed fingers' pads, in metres."""

_THICK = 0.013  # half the closed fingers' thickness, metres
_HALF_STRIP = 0.012  # half the width of the contact strip, metres
# half width and half thickness of the fingers with shafts and clearance, metres
_FINGERS = (0.03, 0.015)
_TIPS = (0.012, 0.0095)  # half width and half thickness of the pads only, metres
_PALM = (0.11, 0.042)  # half width and half thickness of the palm with clearance, metres
_TIGHT = ((0.0265, 0.0105), (0.102, 0.0315))  # fingers and palm without clearance, metres
_PALM_Z = 0.044  # height of the palm above the fingertips, metres
_PUSH_HEIGHT = 0.03  # height at which the fingers push, metres
_CLOSE = 0.01  # distance behind the object if there is little space, metres
_LOWEST, _HIGHEST = 0.012, 0.07  # range of the tool's height above the table, metres
_CELL = 0.006  # of height maps, metres
_TURNS = np.deg2rad([0.0, 180.0, 30.0, -30.0, 150.0, -150.0, 60.0, -60.0, 120.0, -120.0, 90.0])
_REACH = 0.62  # range of a stroke around the object, metres


Care = Literal["free", "tight", "bold"]
"""Where the hand needs free space during a stroke.

"free": along the whole path. "tight": only at the start, beside the object. "bold": nowhere.
"""


@dataclass(frozen=True, eq=False)
class Stroke:
    """A push: the tool moves from ``start`` (m, world) along ``ahead`` with the hand at ``yaw``.

    ``ahead`` is a horizontal unit vector, ``yaw`` is in the base frame, radians.
    """

    start: Float[np.ndarray, "3"]
    ahead: Float[np.ndarray, "2"]
    yaw: float


def beside(world: World, target: str) -> HeightMap:
    """Return the height map of everything but the target, within the range of a stroke."""
    center = world.position(target)[:2]
    return surroundings(world, target, center - _REACH, center + _REACH, _CELL)


def mass_center(world: World, target: str) -> Float[np.ndarray, "3"]:
    """Return an object's centre of mass, in the world frame."""
    return world.position(target) + world.rotation(target) @ world.scene.object(target).com


def plan_stroke(
    world: World,
    target: str,
    spot: Float[np.ndarray, "2"],
    others: HeightMap | None = None,
    care: Care = "free",
) -> Stroke | None:
    """Plan a push that moves an object's centre to a spot (x, y, world); return None if impossible.

    ``others`` is the height map ``beside`` the object, if it is already known.
    """
    way = spot - world.position(target)[:2]
    length = float(np.linalg.norm(way))
    ahead = way / max(length, 1e-9)
    bearing = float(np.arctan2(ahead[1], ahead[0]))
    parts = parts_of(world, target)
    com = mass_center(world, target)[:2]
    others = others or beside(world, target)
    own = _tops(parts)
    behind = BEHIND if care == "free" else _CLOSE
    best: tuple[float, Stroke] | None = None
    for k, turn in enumerate(_TURNS):
        if best is not None and k > 1:
            break  # the yaw and its opposite are compared; the others are fallbacks
        # The fingers open along the hand's y axis; side by side they are widest.
        opening = bearing + turn + np.pi / 2
        found = _contact(parts, own, com, ahead, opening, world.scene.table.height)
        if found is None:
            continue
        front, height = found
        steps = np.linspace(-behind, length, max(int((length + behind) / 0.015), 2))
        line = front + steps[:, None] * ahead
        tip = height - TIP
        if care == "free" and not (
            _is_free(others, line, opening, tip) and wrist_is_free(world, others, line, tip)
        ):
            continue
        if care == "tight" and not _is_free(others, line[steps < 0.01], opening, tip, _TIGHT):
            continue
        start, end = (np.array([*at, height]) for at in line[[0, -1]])
        yaw = wrap(bearing + turn - world.mount.yaw)
        far = stretch(world, (start, end, start + np.array([0.0, 0.0, HOVER])), yaw)
        if far is None:
            continue
        far += abs(turn_left(world, yaw, start))  # a quick turn is worth some additional stretch
        if best is None or far < best[0]:
            best = far, Stroke(start, ahead, yaw)
    return None if best is None else best[1]


def _tops(parts: tuple[ConvexPart, ...]) -> HeightMap:
    """Return the height map of an object's parts alone, in the world frame."""
    low, high = (f([p.bounds[k] for p in parts], axis=0) for k, f in ((0, np.min), (1, np.max)))
    return height_map(parts, low[:2] - _CELL, high[:2] + _CELL, _CELL)


def _contact(
    parts: tuple[ConvexPart, ...],
    own: HeightMap,
    com: Float[np.ndarray, "2"],
    ahead: Float[np.ndarray, "2"],
    opening: float,
    floor: float,
) -> tuple[Float[np.ndarray, "2"], float] | None:
    """Return the (x, y) and height at which the tool touches an object near its base, or None.

    Both are in the world frame.
    """
    spans = np.array([p.bounds[:, 2] for p in parts])
    low, high = spans[:, 0].min(), spans[:, 1].max()
    palm, fingers = (_rectangle(half, opening) for half in (_PALM, _TIPS))
    lowest = float(np.clip(0.4 * (high - low), _LOWEST, 0.04))
    for height in floor + np.arange(lowest, _HIGHEST, 0.006):
        tip = height - TIP
        met = (spans[:, 1] >= tip + 0.003) & (spans[:, 0] <= tip + _PUSH_HEIGHT)
        behind = _behind([parts[k] for k in np.flatnonzero(met)], com, ahead)
        if behind is None:
            continue
        front = com + (behind - _THICK) * ahead
        fits = own.at(front + palm).max() <= tip + _PALM_Z
        if fits and own.at(front - _CELL * ahead + fingers).max() <= tip:
            return front, float(height)
    return None


def _behind(
    parts: list[ConvexPart], com: Float[np.ndarray, "2"], ahead: Float[np.ndarray, "2"]
) -> float | None:
    """Return how far (m) from ``com`` along ``ahead`` the fingers meet a part, or None if never."""
    across = np.array([-ahead[1], ahead[0]])
    found: list[float] = []
    for part in parts:
        flat = part.vertices[:, :2] - com
        u, v = flat @ ahead, flat @ across
        if v.min() <= _HALF_STRIP and v.max() >= -_HALF_STRIP:
            found.append(_first_in_strip(u, v))
    return min(found, default=None)


def _first_in_strip(u: Float[np.ndarray, "n"], v: Float[np.ndarray, "n"]) -> float:
    """Return the smallest u with |v| <= ``_HALF_STRIP`` in the convex hull of the points (u, v)."""
    within = np.abs(v) <= _HALF_STRIP
    least = [float(u[within].min())] if within.any() else []
    for edge in (-_HALF_STRIP, _HALF_STRIP):
        below, above = v <= edge, v >= edge
        if below.any() and above.any():
            du = u[above][None] - u[below][:, None]
            dv = v[above][None] - v[below][:, None]
            share = np.where(dv > 1e-9, (edge - v[below][:, None]) / np.maximum(dv, 1e-9), 0.0)
            least.append(float((u[below][:, None] + share * du).min()))
    return min(least)


def _is_free(
    others: HeightMap,
    line: Float[np.ndarray, "k 2"],
    opening: float,
    tip: float,
    hand: tuple[tuple[float, float], tuple[float, float]] = (_FINGERS, _PALM),
) -> bool:
    """Return whether the palm and fingers, opened along ``opening``, clear ``others`` on a line."""
    return all(
        others.at(line[:, None] + _rectangle(half, opening)).max() <= height
        for half, height in zip(hand, (tip - 0.001, tip + _PALM_Z), strict=True)
    )


def _rectangle(half: tuple[float, float], opening: float) -> Float[np.ndarray, "n 2"]:
    """Return grid points in a rectangle whose first side is along ``opening``, in metres."""
    axis = np.array([np.cos(opening), np.sin(opening)])
    sides = [np.linspace(-h, h, max(int(2 * h / 0.01), 2) + 1) for h in half]
    grid = np.stack(np.meshgrid(*sides), -1).reshape(-1, 2)
    return grid @ np.stack([axis, [-axis[1], axis[0]]])
