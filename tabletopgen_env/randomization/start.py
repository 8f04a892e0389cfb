"""Starts that are a little off: the arm's joints, and where things stand.

Things are displaced once the goal is drawn, about the table, by a move along x and y and a yaw.
What a thing carries, touches or stands against goes with it, as one *bundle*. Each bundle takes the
first of ``len(_SHARES)`` draws, which grow smaller, that leaves everything as sound as it was:

- nothing comes nearer than ``ROOM`` to anything, than ``HAND_ROOM`` to what the goals are about
  (than ``PALM_ROOM`` if it rises into the way of the palm), than ``EDGE`` to the table's edge or
  than ``CLEARANCE`` to the robot's base, or than it was if that is less;
- what the arm reaches it still does, and nothing tall comes between it and what the goals are
  about;
- marked spots, the ways of pushes, and the room at a place where a thing is to go stay free.

With no such draw it stays. Where the expert then finds no stroke for what is to be pushed, or no
grasp that the arm reaches of what is to be taken (``feasible``), ``_LESS`` of all draws is tried,
then none. What rests on the flat top stays at rest, so nothing is simulated. Goals that say where a
thing stood follow it (``goals.goal.begun``), marked spots stay.
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
"""Least room between things, about those of the goals, and to the table's edge, metres."""

_SHARES = np.array([1.0, 1.0, 1.0, 1.0, 0.5, 0.5, 0.25, 0.25])  # of move and turn, by draw
_LESS = 0.3  # share of all draws where they leave no way to push or take what is asked for
_TOGETHER = 0.002  # things nearer to each other are moved together, metres
_PALM_Z = 0.045  # metres above the table at which the palm is when flat things are taken
_BESIDE = 0.1  # metres about a point in the air, and behind what is pushed, kept for the hand
_CIRCLE = np.column_stack([f(np.arange(12) * np.pi / 6) for f in (np.cos, np.sin)])
_CIRCLE /= np.cos(np.pi / 12)  # around the circle, not in it


def start_off(
    world: World, goals: Sequence[Goal], settings: Randomization, rng: np.random.Generator
) -> dict[str, Any]:
    """Put the arm and the things at an episode's start a little off; return by how much.

    The world, at its start, is left at the new one. ``rng`` draws as much for every world of as
    many things. Returned are "joints", the seven angles added to the arm's, rad (zeros if the arm
    would touch something), and "moved", each displaced bundle's move (x, y, metres) and turn (rad).
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
    """An outline on the table to be kept free of all bundles but ``of``; moves with ``carrier``."""

    outline: Outline
    of: tuple[str, ...]
    carrier: str | None = None

    def carry(self, first: str, centre: Point, move: Float[np.ndarray, "3"]) -> _Zone:
        """Return the zone once a bundle is moved (x, y) and turned about its centre."""
        if first != self.carrier:
            return self
        return replace(self, outline=carry(self.outline, centre, move[None])[0])


class _Tabletop:
    """Bundles, by their first thing, that are displaced: in which ``order``, by what ``moves``."""

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
        """Move a bundle by the first of ``tries`` that will do, if one does."""
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
        """The scene as its things stand now."""
        return move(self._before, self._root, self.moves)

    def _free(self, first: str) -> bool:
        """Return whether a bundle stands on the table alone, wholly."""
        on = self._before.object(first).placement.on == TABLE
        return on and bool(inside_margin(self._then[first], self._before.table.outline).min() >= 0)

    def _room(self, first: str, other: str) -> float:
        """Return how far from one bundle another stays, for a hand that takes the one, metres."""
        if first not in self._wanted:
            return ROOM
        below = max(self._tops[first], _PALM_Z)
        return PALM_ROOM if self._tops[other] > below else HAND_ROOM

    def _on_table(self, first: str, own: Outlines) -> Bool[np.ndarray, "c"]:
        """Return which outlines keep off the table's edge and the robot's base."""
        top, base = self._before.table.outline, self._world.base_position[None, :2]
        inner = inside_margin(own.reshape(-1, 2), top).reshape(own.shape[:2]).min(1)
        edge = min(EDGE, float(inside_margin(self._then[first], top).min()))
        clear = min(CLEARANCE, float(apart(self._then[first][None], base)[0]))
        return (inner >= edge) & (apart(own, base) >= clear)

    def _in_reach(self, first: str, tries: Moves) -> Bool[np.ndarray, "c"]:
        """Return which moves leave in the arm's reach what was."""
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
        """Return which outlines leave room to other bundles and to what is to stay free."""
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
        """Return whether something tall comes into the arm's way to what the goals are about."""
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
    """Return how high each bundle, by its first thing, rises above the table, metres."""
    tops: dict[str, float] = {}
    for name, first in root.items():
        half = world.scene.object(name).scale / 2
        high = world.position(name)[2] + np.abs(world.rotation(name))[2] @ half
        tops[first] = max(float(high) - world.scene.table.height, tops.get(first, 0.0))
    return tops


def _together(world: World) -> tuple[dict[str, str], dict[str, Outline]]:
    """Return the first thing of the bundle of each thing, and the bundles' convex outlines."""
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
    """Return the first two outlines that stand together, if any do."""
    for (one, a), (other, b) in itertools.combinations(outlines.items(), 2):
        if near(a[None], b, _TOGETHER) and apart(a[None], b)[0] < _TOGETHER:
            return one, other
    return None


def _zones(world: World, goals: Sequence[Goal], root: Mapping[str, str]) -> list[_Zone]:
    """Return what goals need free: around marked spots, along pushes, where a thing stood."""
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
