"""Perturbed starts: offsets of the arm's joints and of object poses.

After the goal is drawn, objects are moved along x and y and rotated by a yaw. An object and
everything that it carries or touches move together, as a *bundle*. Each bundle takes the first of
``len(_SHARES)`` draws, of decreasing size, that satisfies these conditions:

- objects keep a distance of ``ROOM`` from each other, of ``HAND_ROOM`` from objects of the goals
  (``PALM_ROOM`` if they are tall enough to obstruct the palm), of ``EDGE`` from the table's edge
  and of ``CLEARANCE`` from the robot's base, or their original distance if that is smaller;
- objects within reach of the arm remain so, and no tall object moves between the arm and objects of
  the goals;
- marked spots, push paths, and the destinations of objects remain free.

If no draw does, the bundle stays in place. If the expert then finds no stroke for a target to push,
or no reachable grasp of a target to lift (``feasible``), all draws are scaled by ``_LESS``, and
then by zero. Objects on the flat top stay at rest, so no simulation is needed. Goals that refer to
an object's start position follow it (``goals.goal.begin_goals``); marked spots are fixed.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Bool, Float

from generator.geometry import inside_margin
from generator.scene import TABLE, Scene

from ..goals.goal import Goal, OnSpot, Pushed, named_by
from ..robot.mount import CLEARANCE, TALL, obstacle
from ..world.workspace import FREE_MARGIN
from .arrangement import bundles, move
from .feasible import Feasible, touches_robot
from .outlines import Moves, Outline, Outlines, Point, apart, carry, hull, keeps, near

if TYPE_CHECKING:
    from ..world.world import World
    from .settings import Randomization

ROOM, HAND_ROOM, PALM_ROOM, EDGE = 0.01, 0.04, 0.08, 0.01
"""Minimum distance between objects, around objects of the goals, and to the table's edge,
metres."""

_SHARES = np.array([1.0, 1.0, 1.0, 1.0, 0.5, 0.5, 0.25, 0.25])  # scales of the draws
_LESS = 0.3  # scale of all draws if the full ones make a target infeasible
_TOGETHER = 0.002  # objects closer than this are moved together, metres
_PALM_Z = 0.045  # height of the palm above the table when it grasps flat objects, metres
_BESIDE = 0.1  # radius kept free around a point in the air, and behind a target to push, metres
_CIRCLE = np.column_stack([f(np.arange(12) * np.pi / 6) for f in (np.cos, np.sin)])
_CIRCLE /= np.cos(np.pi / 12)  # circumscribed about the circle


def start_off(
    world: World, goals: Sequence[Goal], settings: Randomization, rng: np.random.Generator
) -> dict[str, Any]:
    """Perturb the arm's joints and the objects at the start of an episode; return the offsets.

    The world must be at its start, and is at the new one afterwards. The number of draws from
    ``rng`` depends only on the number of objects. The result holds "joints", the seven offsets of
    the arm's joints, rad (zeros if the arm would touch something), and "moved", the move (x, y,
    metres) and rotation (rad) of each displaced bundle.
    """
    joints = rng.uniform(-settings.start_joints, settings.start_joints, 7)
    most = np.array([settings.start_move, settings.start_move, settings.start_turn])
    tries = most * rng.uniform(-1, 1, (len(world.names), len(_SHARES), 3)) * _SHARES[:, None]
    before, home = world.scene, world.data.qpos[world.arm_qpos].copy()
    feasible = Feasible(world, goals)
    for share in (1.0, _LESS) if most.any() else ():
        table = _Tabletop(world, goals)
        for first in table.order:
            table.displace(first, share * tries[world.index(first)])
        moves = table.moves
        if moves:
            world.rearrange(table.scene)
            world.reset()
        world.place_arm(home + joints)
        if feasible.now():
            break
        world.rearrange(before)
        world.reset()
    else:
        moves = {}
        world.place_arm(home + joints)
    if touches_robot(world):
        joints = np.zeros(7)
        world.place_arm(home)
    return {"joints": joints.tolist(), "moved": moves}


@dataclass(frozen=True, eq=False)
class _Zone:
    """An area that only the bundles in ``of`` may cover; it moves with the bundle ``carrier``."""

    outline: Outline
    of: tuple[str, ...]
    carrier: str | None = None

    def carry(self, first: str, centre: Point, move: Float[np.ndarray, "3"]) -> _Zone:
        """Return the zone after a bundle is moved (x, y) and rotated about ``centre``."""
        if first != self.carrier:
            return self
        return replace(self, outline=carry(self.outline, centre, move[None])[0])


class _Tabletop:
    """The bundles to displace, keyed by first object, with an ``order`` and accepted ``moves``."""

    def __init__(self, world: World, goals: Sequence[Goal]) -> None:
        self._before = world.scene
        self.moves: dict[str, list[float]] = {}
        self._world, self._named = world, named_by(goals)
        self._root, self._outlines = _together(world)
        self._then = dict(self._outlines)
        self._zones = _zones(world, goals, self._root)
        wanted = [self._root[name] for name in self._named]
        self._wanted = frozenset(wanted)
        self._tops = _tops(world, self._root)
        listed = dict.fromkeys([*wanted, *self._outlines])
        self.order = [name for name in listed if self._free(name)]

    def displace(self, first: str, tries: Moves) -> None:
        """Move the bundle named ``first`` by the first valid move in ``tries``, if there is one."""
        centre = self._before.object(first).pose.position[:2]
        own = carry(self._outlines[first], centre, tries)
        good = self._on_table(first, own) & self._in_reach(first, tries)
        for k in np.flatnonzero(good & self._clear(first, own, centre, tries)):
            moves = {**self.moves, first: tries[k].tolist()}
            if self._in_the_way(moves):
                continue
            self.moves, self._outlines[first] = moves, own[k]
            self._zones = [zone.carry(first, centre, tries[k]) for zone in self._zones]
            return

    @property
    def scene(self) -> Scene:
        """The scene with the current moves applied."""
        return move(self._before, self._root, self.moves)

    def _free(self, first: str) -> bool:
        """Return whether a bundle stands directly and entirely on the table."""
        on = self._before.object(first).placement.on == TABLE
        return on and bool(inside_margin(self._then[first], self._before.table.outline).min() >= 0)

    def _room(self, first: str, other: str) -> float:
        """Return the gap in metres to keep from a bundle, with room for the hand if necessary."""
        if first not in self._wanted:
            return ROOM
        below = max(self._tops[first], _PALM_Z)
        return PALM_ROOM if self._tops[other] > below else HAND_ROOM

    def _on_table(self, first: str, own: Outlines) -> Bool[np.ndarray, "c"]:
        """Return which outlines are far enough from the table's edge and the robot's base."""
        top, base = self._before.table.outline, self._world.base_position[None, :2]
        inner = inside_margin(own.reshape(-1, 2), top).reshape(own.shape[:2]).min(1)
        edge = min(EDGE, float(inside_margin(self._then[first], top).min()))
        clear = min(CLEARANCE, float(apart(self._then[first][None], base)[0]))
        return (inner >= edge) & (apart(own, base) >= clear)

    def _in_reach(self, first: str, tries: Moves) -> Bool[np.ndarray, "c"]:
        """Return which moves keep reachable objects within the arm's reach."""
        good = np.ones(len(tries), bool)
        centre = self._before.object(first).pose.position
        for thing in self._before.objects:
            if self._root[thing.name] != first:
                continue
            at = thing.pose.position
            ends = carry(at[None, :2], centre[:2], tries)[:, 0]
            points = np.column_stack([ends, np.full(len(tries), at[2])])
            if self._world.mount.reaches(at[None])[0]:
                good &= self._world.mount.reaches(points)
        return good

    def _clear(
        self, first: str, own: Outlines, centre: Point, tries: Moves
    ) -> Bool[np.ndarray, "c"]:
        """Return which outlines are far enough from other bundles and from the zones."""
        good = np.ones(len(own), bool)
        for other, outline in self._outlines.items():
            if other != first:
                room = max(self._room(first, other), self._room(other, first))
                good &= keeps(own, outline, self._then[first], self._then[other], room)
        for zone in self._zones:
            if zone.carrier == first:
                along = carry(zone.outline, centre, tries)
                for other, outline in self._outlines.items():
                    if other not in zone.of:
                        good &= keeps(along, outline, zone.outline, self._then[other], 0.0)
            elif first not in zone.of:
                good &= keeps(own, zone.outline, self._then[first], zone.outline, 0.0)
        return good

    def _in_the_way(self, moves: Mapping[str, list[float]]) -> bool:
        """Return whether a tall object would newly obstruct the arm's path to a goal's object."""
        before, mount = self._before, self._world.mount
        high = before.table.height + TALL
        if all(o.pose.position[2] + np.linalg.norm(o.scale) / 2 < high for o in before.objects):
            return False
        scene = move(before, self._root, moves)
        return any(
            obstacle(scene, mount, name) and not obstacle(before, mount, name)
            for name in self._named
        )


def _tops(world: World, root: Mapping[str, str]) -> dict[str, float]:
    """Return the height of each bundle's top above the table in metres, keyed by first object."""
    tops: dict[str, float] = {}
    for name, first in root.items():
        half = world.scene.object(name).scale / 2
        high = world.position(name)[2] + np.abs(world.rotation(name))[2] @ half
        tops[first] = max(float(high) - world.scene.table.height, tops.get(first, 0.0))
    return tops


def _together(world: World) -> tuple[dict[str, str], dict[str, Outline]]:
    """Return each object's bundle, named by its first object, and the bundles' convex outlines."""
    root = bundles(world)
    outlines = {
        first: hull([world.footprints[name] for name in world.names if root[name] == first])
        for first in dict.fromkeys(root.values())
    }
    while (pair := _nearest(outlines)) is not None:
        kept, gone = pair
        root = {name: kept if first == gone else first for name, first in root.items()}
        outlines[kept] = hull([outlines[kept], outlines.pop(gone)])
    return root, outlines


def _nearest(outlines: Mapping[str, Outline]) -> tuple[str, str] | None:
    """Return the first pair of outlines closer than ``_TOGETHER``, or None."""
    for (one, a), (other, b) in itertools.combinations(outlines.items(), 2):
        if near(a[None], b, _TOGETHER) and apart(a[None], b)[0] < _TOGETHER:
            return one, other
    return None


def _zones(world: World, goals: Sequence[Goal], root: Mapping[str, str]) -> list[_Zone]:
    """Return the zones to keep free for goals: marked spots, push paths and start positions."""
    zones = []
    for goal in goals:
        if goal.spot is None:
            continue
        spot = goal.spot[:2]
        if goal.target is None:
            zones.append(_Zone(spot + _BESIDE * _CIRCLE, ()))
            continue
        at, of = world.position(goal.target)[:2], (root[goal.target],)
        radius = float(np.linalg.norm(world.footprints[goal.target] - at, axis=1).max())
        disc = (radius + FREE_MARGIN) * _CIRCLE
        if isinstance(goal, Pushed):
            behind = at - _BESIDE * (spot - at) / max(float(np.linalg.norm(spot - at)), 1e-9)
            zones.append(_Zone(hull([behind + disc, spot + disc]), of))
        elif isinstance(goal, OnSpot) and goal.stead is not None:
            carrier = root[goal.stead]
            zones.append(_Zone(spot + disc, (*of, carrier), carrier))
        else:
            zones.append(_Zone(spot + disc, of))
    return zones
