"""Strokes: where to put the closed fingers, and how to turn the hand, to push a thing along.

The hand pushes on the line through the centre of mass, where a thing slides without turning. The
fingers and the palm over them need room all along that way.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from generator.geometry import wrap

from .arm import stretch, wrist_is_free
from .grasps import TIP
from .heights import HeightMap, height_map, moved

if TYPE_CHECKING:
    from ..world import World

BEHIND = 0.025
"""Metres between the fingers and the object before a stroke."""

HOVER = 0.06
"""Height from which the hand comes straight down, metres."""

_THICK = 0.013  # half the closed fingers' thickness, metres
_HALF_STRIP = 0.012  # half the breadth of what the fingers meet, metres
_FINGERS = (0.027, 0.011)  # half their breadth and thickness, shafts and all
_PALM = (0.106, 0.036)
_PALM_Z = 0.044  # the palm above the fingertips, metres
_LOWEST, _HIGHEST = 0.014, 0.07
_CELL = 0.006
_TURNS = np.deg2rad([0.0, 180.0, 30.0, -30.0, 150.0, -150.0, 60.0, -60.0, 120.0, -120.0, 90.0])
_REACH = 0.62  # metres about the object that a stroke may touch


@dataclass(frozen=True, eq=False)
class Stroke:
    """A push: the tool goes from ``start`` (m, world) along ``ahead`` with the hand at ``yaw``.

    ``ahead`` is a unit vector along the table, ``yaw`` is in the base frame, radians.
    """

    start: Float[np.ndarray, "3"]
    ahead: Float[np.ndarray, "2"]
    yaw: float


def surroundings(world: World, target: str) -> HeightMap:
    """Return the height map of everything but the target, as far as a stroke may lead."""
    parts = [
        part
        for obj in world.scene.objects
        if obj.name != target
        for part in moved(obj.parts, world.position(obj.name), world.rotation(obj.name))
    ]
    center = world.position(target)[:2]
    return height_map(parts, center - _REACH, center + _REACH, _CELL)


def mass_center(world: World, target: str) -> Float[np.ndarray, "3"]:
    """Return an object's centre of mass, world frame."""
    return world.position(target) + world.rotation(target) @ world.scene.object(target).com


def push_height(world: World, target: str) -> float:
    """Return the tool's height in a stroke: off the table, and the palm over the object."""
    low = world.lowest(target)
    tall = 2 * (float(world.position(target)[2]) - low)
    over = tall + 0.006 + TIP - _PALM_Z
    return world.scene.table.height + float(np.clip(max(0.4 * tall, over), _LOWEST, _HIGHEST))


def plan_stroke(
    world: World,
    target: str,
    spot: Float[np.ndarray, "2"],
    others: HeightMap | None = None,
    bold: bool = False,
) -> Stroke | None:
    """Return the stroke that pushes an object, as it is now, towards a spot; None if none can.

    Args:
        world: the world; live poses count.
        target: an object's name.
        spot: where its centre is to go (x, y, world).
        others: its ``surroundings``, if known.
        bold: whether the hand may brush what stands beside the way.
    """
    way = spot - world.position(target)[:2]
    length = float(np.linalg.norm(way))
    ahead = way / max(length, 1e-9)
    height = push_height(world, target)
    com = mass_center(world, target)[:2]
    front = com + (_behind(world, target, com, ahead) - _THICK) * ahead
    start = np.array([*(front - BEHIND * ahead), height])
    end = np.array([*(front + length * ahead), height])
    others = others or surroundings(world, target)
    steps = np.linspace(0.0, length + BEHIND, max(int((length + BEHIND) / 0.015), 2))
    line = start[:2] + steps[:, None] * ahead
    if not (bold or wrist_is_free(world, others, line, height - TIP)):
        return None
    bearing = float(np.arctan2(ahead[1], ahead[0]))
    best: tuple[float, float] | None = None
    for k, turn in enumerate(_TURNS):
        # The fingers open along the hand's y axis; side by side they are broadest.
        if best is not None and k > 1:
            break
        if not (bold or _is_free(others, line, bearing + turn + np.pi / 2, height - TIP)):
            continue
        yaw = wrap(bearing + turn - world.mount.yaw)
        above = start + np.array([0.0, 0.0, HOVER])
        far = stretch(world, (start, end, above), yaw)
        if far is not None and (best is None or far < best[0]):
            best = far, yaw
    return None if best is None else Stroke(start, ahead, best[1])


def _behind(
    world: World, target: str, com: Float[np.ndarray, "2"], ahead: Float[np.ndarray, "2"]
) -> float:
    """Return where along ``ahead`` from the centre of mass the fingers meet the object, metres.

    What they meet is the part of its outline in their way: the outline of each collision part is
    cut to the strip that they sweep.
    """
    across = np.array([-ahead[1], ahead[0]])
    first = 0.0
    for part in world.scene.object(target).parts:
        flat = (part.vertices @ world.rotation(target).T + world.position(target))[:, :2] - com
        u, v = flat @ ahead, flat @ across
        if v.min() <= _HALF_STRIP and v.max() >= -_HALF_STRIP:
            first = min(first, _first_in_strip(u, v))
    return first


def _first_in_strip(u: Float[np.ndarray, "n"], v: Float[np.ndarray, "n"]) -> float:
    """Return the least ``u`` of the convex hull of (u, v) within the strip."""
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
    others: HeightMap, line: Float[np.ndarray, "k 2"], opening: float, tip: float
) -> bool:
    """Return whether fingers and palm pass along a line with the hand opening along ``opening``."""
    axis = np.array([np.cos(opening), np.sin(opening)])
    axes = np.stack([axis, [-axis[1], axis[0]]])
    for half, height in ((_FINGERS, tip - 0.001), (_PALM, tip + _PALM_Z)):
        sides = [np.linspace(-h, h, max(int(2 * h / 0.01), 2) + 1) for h in half]
        grid = np.stack(np.meshgrid(*sides), -1).reshape(-1, 2) @ axes
        if others.at(line[:, None] + grid).max() > height:
            return False
    return True
