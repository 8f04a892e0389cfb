"""Planning of the release: a position and yaw with space for the held object and the fingers.

The held object and the opening fingers move straight down onto the height map of all other objects;
their undersides determine how deep they can go. Among many places and yaws in the goal's region,
the best one is low, near the centre and well supported, with the shortest drop.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple, Protocol

import numpy as np
from jaxtyping import Float
from scipy import ndimage

from generator.geometry import rotation_z, wrap

from ...goals.goal import INSIDE, Goal, Into, OnTop, Region
from ...world.world import World
from ..arm import knuckle_is_free, stretch, wrist_is_free
from .grasps import TIP
from .heights import HeightMap, parts_of, solid, surroundings

RELEASE = 0.004
"""Height above the surface at which an object is released, in metres."""

_TURNS = np.arange(-6, 6) * np.pi / 6
_CELL = 0.005
_MOST_COLUMNS = 160
_INSIDE = 0.006  # minimum distance of a place from the region's edge, metres
_LEVEL = 0.005  # height above a flat surface at which an object comes to rest on another, metres
_ABOVE = 0.06
_TRIED = 10  # number of places checked for reachability
PAD, SHAFT, SHAFT_Z = 0.0125, 0.0265, 0.017
FINGER_HALF = 0.0105
PALM, PALM_Z = (0.106, 0.036), 0.043


@dataclass(frozen=True, eq=False)
class Place:
    """The pose at release: the tool's position (m, world) and the hand's yaw (base frame, radians).

    A ``yaw`` of None means the current yaw, turned only as far as the last joint's range requires.
    ``target`` is the position of the held object's centre at release (x, y, world), ``hanging`` its
    extent below the tool, and ``seen`` the position of the goal's region at planning time.
    """

    tool: Float[np.ndarray, "3"]
    yaw: float | None
    target: Float[np.ndarray, "2"]
    hanging: float
    seen: Float[np.ndarray, "3"]


class Placer(Protocol):
    """A function that plans the release: the expert's ``plan_place``, or ``middle_place``."""

    def __call__(self, world: World, goal: Goal, yaw: float, opening: float) -> Place:
        """Return a release pose; see ``plan_place``."""
        ...


class Underside(NamedTuple):
    """An underside as a set of columns: their (x, y) and lowest heights, relative to the tool."""

    at: Float[np.ndarray, "n 2"]
    low: Float[np.ndarray, "n"]


def plan_place(world: World, goal: Goal, yaw: float, opening: float) -> Place:
    """Return the best release pose in a goal's region for the target in its current grasp.

    ``yaw`` is the hand's current yaw in the base frame, radians; ``opening`` is the opening of the
    fingers for release, metres.
    """
    assert goal.target is not None
    tool = world.data.site_xpos[world.tcp].copy()
    held = _held_underside(world, goal.target, tool)
    hand = _hand(opening, yaw + world.mount.yaw)
    offset = (world.position(goal.target) - tool)[:2]
    lever = np.zeros(2)
    if isinstance(goal, OnTop):  # the object has to balance there
        lever = (world.rotation(goal.target) @ world.scene.object(goal.target).com)[:2]
    region = goal.region(world)
    points = _points(goal, region)
    others = _room(world, goal.target, region, held)
    base = _base(world, goal, region)
    found: list[tuple[float, float, Float[np.ndarray, "3"], Float[np.ndarray, "2"]]] = []
    for turn in _TURNS:
        spin = rotation_z(float(turn))[:2, :2].T
        tools = points - offset @ spin
        touching = _touching(others, tools, Underside(held.at @ spin, held.low))
        rest = touching.max(1)
        support = (touching >= rest[:, None] - 2 * _CELL).mean(1)
        free = _touching(others, tools, Underside(hand.at @ spin, hand.low)).max(1)
        height = np.maximum(rest, free)
        above = rest + float(held.low.min()) - base
        middles = points + lever @ spin - region.center[:2]
        away = np.linalg.norm(middles / region.semi[:2], axis=1)
        cost = 15.0 * (height - rest) + 25.0 * np.maximum(above, 0.0) + 0.3 * away
        cost += 0.02 * abs(turn)
        if isinstance(goal, Into):
            cost += 10.0 * (above > goal.opening.depth - INSIDE)
        else:
            cost += 100.0 * (above > _LEVEL) + 1.0 * (1.0 - support)
        for k in np.argsort(cost)[:3]:
            at = np.array([*tools[k], height[k] + RELEASE])
            found.append((float(cost[k]), float(turn), at, points[k]))
    found.sort(key=lambda place: place[0])
    hanging = -float(held.low.min())
    reached = (f for f in found[:_TRIED] if _reached(world, others, f[2], yaw + f[1]))
    chosen = next(reached, found[0])
    return Place(chosen[2], wrap(yaw + chosen[1]), chosen[3], hanging, region.center)


def middle_place(world: World, goal: Goal, yaw: float, opening: float) -> Place:
    """Return the release pose at the centre of a goal's region; for arguments, see ``plan_place``.

    The hand keeps its yaw, or makes half a turn if the arm can reach the place only in this way.
    The plan uses the height map of all other objects, and the box and the lowest point of the held
    object.
    """
    places = [*_middles(world, goal, yaw, opening, (0.0, np.pi))]
    reached = (p for p in places if p.yaw is not None and _stretched(world, p.tool, p.yaw))
    return next(reached, places[0])


def unturned_place(world: World, goal: Goal, yaw: float, opening: float) -> Place:
    """Return the release pose of ``middle_place``, but without a prescribed yaw of the hand.

    The place does not depend on the hand's pose at planning time, so following it needs no memory.
    """
    (place,) = _middles(world, goal, yaw, opening, (0.0,))
    return replace(place, yaw=None)


def _middles(
    world: World, goal: Goal, yaw: float, opening: float, turns: tuple[float, ...]
) -> Iterator[Place]:
    """Yield the release pose at the centre of a goal's region for each turn of the hand."""
    assert goal.target is not None
    tool = world.data.site_xpos[world.tcp].copy()
    held, hand = _boxed_underside(world, goal.target, tool), _hand(opening, yaw + world.mount.yaw)
    offset = (world.position(goal.target) - tool)[:2]
    region = goal.region(world)
    others = _room(world, goal.target, region, held)
    hanging = -float(held.low.min())
    for turn in turns:
        spin = rotation_z(turn)[:2, :2].T
        at = (region.center[:2] - offset @ spin)[None]
        undersides = (Underside(under.at @ spin, under.low) for under in (held, hand))
        height = max(float(_touching(others, at, under).max()) for under in undersides)
        place = np.array([*at[0], height + RELEASE])
        yield Place(place, wrap(yaw + turn), region.center[:2], hanging, region.center)


def _reached(world: World, others: HeightMap, tool: Float[np.ndarray, "3"], yaw: float) -> bool:
    tip = float(tool[2]) - TIP
    return (
        wrist_is_free(world, others, tool[None, :2], tip)
        and knuckle_is_free(world, others, tool[:2], tip, yaw)
        and _stretched(world, tool, yaw)
    )


def _stretched(world: World, tool: Float[np.ndarray, "3"], yaw: float) -> bool:
    above = tool + np.array([0.0, 0.0, _ABOVE])
    return stretch(world, (tool, above), wrap(yaw)) is not None


def _points(goal: Goal, region: Region) -> Float[np.ndarray, "n 2"]:
    """Return candidate positions (x, y, world) of the target, with the region's centre first."""
    rings = (0.0, 0.3, 0.6, 0.95) if isinstance(goal, Into | OnTop) else (0.0, 0.3, 0.6)
    angles = np.arange(12) * np.pi / 6
    ring = np.column_stack([np.cos(angles), np.sin(angles)])
    unit = np.concatenate([r * ring if r else np.zeros((1, 2)) for r in rings])
    semi = np.maximum(region.semi[:2] - _INSIDE, 0.0)
    return region.center[:2] + (unit * semi) @ rotation_z(region.yaw)[:2, :2].T


def _base(world: World, goal: Goal, region: Region) -> float:
    """Return the height of the surface on which the target is to rest, in the world frame."""
    if isinstance(goal, Into):
        return float(world.position(goal.reference)[2]) + goal.opening.floor
    if isinstance(goal, OnTop):
        return float(region.center[2]) - goal.rest
    return world.scene.table.height if goal.spot is None else float(goal.spot[2])


def _room(world: World, target: str, region: Region, held: Underside) -> HeightMap:
    reach = float(region.semi[:2].max() + 2 * np.linalg.norm(held.at, axis=1).max() + 0.15)
    low, high = region.center[:2] - reach, region.center[:2] + reach
    found = surroundings(world, target, low, high, _CELL)
    # Each surface is enlarged by a cell, as clearance beside it.
    heights = ndimage.maximum_filter(found.heights, 3)
    return HeightMap(found.origin, _CELL, np.maximum(heights, world.scene.table.height))


def _held_underside(world: World, target: str, tool: Float[np.ndarray, "3"]) -> Underside:
    """Return the underside of the target as held in the hand."""
    shape = solid(parts_of(world, target), _CELL, _CELL)
    i, j = np.nonzero(shape.filled.any(-1))
    low = shape.levels[shape.filled[i, j].argmax(-1)] - _CELL / 2
    at = shape.origin + _CELL * np.column_stack([i, j])
    low[int(low.argmin())] = world.lowest(target)
    step = max(1, len(at) // _MOST_COLUMNS)
    kept = np.unique(np.append(np.arange(0, len(at), step), low.argmin()))
    return Underside(at[kept] - tool[:2], np.maximum(low[kept], world.lowest(target)) - tool[2])


def _boxed_underside(world: World, target: str, tool: Float[np.ndarray, "3"]) -> Underside:
    """Return the underside of the held target, approximated by that of its bounding box."""
    rotation, half = world.rotation(target), world.scene.object(target).scale / 2
    across = np.linspace(-1.0, 1.0, 9)
    unit = np.stack(np.meshgrid(across, across, across), -1).reshape(-1, 3)
    at = ((unit * half) @ rotation.T + world.position(target) - tool)[:, :2]
    return Underside(at, np.full(len(at), world.lowest(target) - tool[2]))


def _hand(opening: float, yaw: float) -> Underside:
    """Return the underside of the hand with open fingers; ``yaw`` is in the world frame."""
    inner = opening / 2
    boxes = (
        ((inner, inner + PAD), FINGER_HALF, -TIP),
        ((inner + PAD, inner + SHAFT), FINGER_HALF, -TIP + SHAFT_Z),
        ((0.0, PALM[0]), PALM[1], -TIP + PALM_Z),
    )
    at, low = [], []
    for (near, far), half, height in boxes:
        out = np.linspace(near, far, max(int((far - near) / 0.01), 1) + 2)
        aside = np.linspace(-half, half, max(int(2 * half / 0.012), 1) + 2)
        grid = np.stack(np.meshgrid(aside, np.concatenate([-out, out])), -1).reshape(-1, 2)
        at.append(grid)
        low.append(np.full(len(grid), height))
    return Underside(np.concatenate(at) @ rotation_z(yaw)[:2, :2].T, np.concatenate(low))


def _touching(
    others: HeightMap, tools: Float[np.ndarray, "k 2"], under: Underside
) -> Float[np.ndarray, "k n"]:
    """Return the contact height of each column of ``under`` at each tool position."""
    return others.at(tools[:, None] + under.at) - under.low
