"""Grasp planning for two fingers: top grasps on the collision shapes at their current poses.

For each yaw of the hand and each strip of a finger's width across the object, the object's
cross-section at the fingers' height is divided into solid runs: a can gives one run, a mug its two
walls, and a handle a separate one. A run that is narrow enough for the fingers and whose sides face
each other (antipodal within the friction cone) is a grasp if there is space beside it. For a
gripper that moves straight down, all other objects are a height map.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.ndimage import maximum_filter1d

from generator.geometry import rotation_yaw, rotation_z
from generator.scene import ConvexPart, Object

from ...robot import franka
from ...world.world import World
from .heights import HeightMap, VoxelSolid, move_parts, solid, surroundings
from .runs import FINGER_HALF, PAD_HEIGHT, RISE, STEP_U, STEP_V, Slabs, find_runs, slabs

TIP = 0.0088
"""Extent of the fingertips beyond the tool centre point, in metres."""

_TURNS = 12
_PAD_DEPTH, _SHAFT = 0.0125, (0.007, 0.0265)
_PALM_U, _PALM_V, _PALM_Z = 0.112, 0.042, 0.042
_TIGHT_U, _TIGHT_V = 0.106, 0.036  # if there is not enough space for more
_TIGHT = 2.0  # score penalty of such a grasp
_PALM_REACH = 0.13
_MARGIN = 0.011


@dataclass(frozen=True, eq=False)
class Grasp:
    """A grasp in the world frame.

    ``point`` is the tool centre point (m), ``angle`` the direction in which the fingers open, about
    +z (radians, modulo pi), ``opening`` the opening before the descent and ``width`` the expected
    distance between the closed fingers (m). A higher ``score`` is better.
    """

    point: Float[np.ndarray, "3"]
    angle: float
    opening: float
    width: float
    score: float


def plan_grasps(world: World, target: str, avoid: tuple[Grasp, ...] = ()) -> list[Grasp]:
    """Return top grasps of ``target`` at its current pose, best first.

    Grasps near any in ``avoid`` are last.
    """
    angles = rotation_yaw(world.rotation(target)) + np.arange(_TURNS) * np.pi / _TURNS
    found = [_demote(grasp, avoid) for grasp in grasps_along(world, target, angles.tolist())]
    return sorted(found, key=lambda grasp: -grasp.score)


def grasps_along(world: World, target: str, angles: Iterable[float]) -> Iterator[Grasp]:
    """Yield grasps of ``target`` at its current pose with fingers that open along ``angles``."""
    thing = world.scene.object(target)
    position, rotation = world.position(target), world.rotation(target)
    own = move_parts(thing.parts, position, rotation)
    bounds = np.stack([part.bounds[:, :2] for part in own])
    low, high = bounds[:, 0].min(0) - _PALM_REACH, bounds[:, 1].max(0) + _PALM_REACH
    others = surroundings(world, target, low, high, STEP_V)
    com = position + rotation @ thing.com
    seen = _see(own, position, rotation, world.scene.table.height)
    for angle in angles:
        yield from _along(seen, others, com, angle)


def grasps_alone(
    thing: Object, rotation: Float[np.ndarray, "3 3"], angles: Iterable[float]
) -> Iterator[Grasp]:
    """Yield top grasps of an isolated object, with nothing under it or beside it.

    ``rotation`` rotates it, about the origin of its frame, into the frame of the grasps.
    """
    own, origin = move_parts(thing.parts, np.zeros(3), rotation), np.zeros(3)
    nothing = HeightMap(np.zeros(2), STEP_V, np.full((1, 1), -np.inf))
    seen = _see(own, origin, rotation, -np.inf)
    for angle in angles:
        yield from _along(seen, nothing, rotation @ thing.com, angle)


def _demote(grasp: Grasp, avoid: tuple[Grasp, ...]) -> Grasp:
    for failed in avoid:
        if is_like(grasp, failed):
            grasp = replace(grasp, score=grasp.score - 4.0)
    return grasp


def is_like(grasp: Grasp, other: Grasp) -> bool:
    """Return whether two grasps are within 1.5 cm and 20 degrees of each other."""
    turn = (grasp.angle - other.angle + np.pi / 2) % np.pi - np.pi / 2
    near = np.linalg.norm(grasp.point - other.point) < 0.015
    return bool(near and abs(turn) < np.deg2rad(20.0))


@dataclass(frozen=True, eq=False)
class _Seen:
    """An object's voxels above a floor, with their origin ``center`` and rotation ``heading``."""

    shape: VoxelSolid
    cut: Slabs
    center: Float[np.ndarray, "2"]
    heading: Float[np.ndarray, "2 2"]
    floor: float

    @property
    def middle(self) -> Float[np.ndarray, "2"]:
        """The centre of the voxels (x, y, world)."""
        return self.center + self.heading @ (self.shape.origin + self.size / 2)

    @property
    def size(self) -> Float[np.ndarray, "2"]:
        """The extent of the voxels, in metres."""
        return np.array(self.shape.filled.shape[:2]) * self.shape.cell

    def columns(self, points: Float[np.ndarray, "*n 2"]) -> Int[np.ndarray, "*n"]:
        """Return the column nearest to each point (x, y, world); see ``VoxelSolid.nearest``."""
        # a single matrix product, for speed
        turned = (points - self.center).reshape(-1, 2) @ self.heading
        return self.shape.nearest(turned.reshape(points.shape))


def _see(
    own: tuple[ConvexPart, ...],
    position: Float[np.ndarray, "3"],
    rotation: Float[np.ndarray, "3 3"],
    floor: float,
) -> _Seen:
    """Convert an object's parts, given in the world frame, to voxels above height ``floor``."""
    # Voxels follow the object's heading, so that results do not depend on its pose on the table.
    heading = rotation_z(rotation_yaw(rotation))
    shape = solid(move_parts(own, -position * [1, 1, 0] @ heading, heading.T), STEP_U, RISE)
    return _Seen(shape, slabs(shape, floor), position[:2], heading[:2, :2], floor)


def _along(
    seen: _Seen, others: HeightMap, com: Float[np.ndarray, "3"], angle: float
) -> Iterator[Grasp]:
    """Yield grasps in which the fingers open along ``angle``."""
    across = np.array([np.cos(angle), np.sin(angle)])
    along = np.array([-across[1], across[0]])
    shape, cut, middle = seen.shape, seen.cut, seen.middle
    half = float(np.linalg.norm(seen.size)) / 2
    u = np.arange(-half - 0.11, half + 0.11, STEP_U)
    v = np.arange(-half - 0.04, half + 0.04, STEP_V)
    points = middle + u[None, :, None] * across + v[:, None, None] * along
    columns = seen.columns(points)
    runs = find_runs(cut, columns)
    if not len(runs.row):
        return
    own = shape.levels[0] - RISE / 2 + RISE * cut.tops[columns]
    both = np.maximum(np.maximum(own, others.at(points)), seen.floor)
    beside, above, under = (
        maximum_filter1d(both, 2 * int(np.ceil(h / STEP_V)) + 1, axis=0)[runs.row]
        for h in (FINGER_HALF, _PALM_V, _TIGHT_V)
    )
    center, width = (u[runs.left] + u[runs.right]) / 2, u[runs.right] - u[runs.left] + STEP_U
    room = _room(u, beside, center, width, runs.tip)
    distance = np.abs(u - center[:, None])
    wide, tight = (
        np.where(distance <= far, surface, -np.inf).max(1) <= runs.tip + _PALM_Z
        for surface, far in ((above, _PALM_U), (under, _TIGHT_U))
    )
    at = middle + center[:, None] * across + v[runs.row, None] * along
    away = np.sqrt(np.vecdot(at - com[:2], at - com[:2]))
    score = runs.quality - 12.0 * away + 40.0 * np.minimum(room - width, 0.02) - _TIGHT * ~wide
    free = ~np.isnan(room) & tight
    points = np.column_stack([at, runs.tip + TIP])[free]
    values = np.column_stack([room, width, score])[free].tolist()
    for point, (opening, between, rating) in zip(points, values, strict=True):
        yield Grasp(point, angle, opening, between, rating)


def _room(
    u: Float[np.ndarray, "n"],
    beside: Float[np.ndarray, "r n"],
    center: Float[np.ndarray, "r"],
    width: Float[np.ndarray, "r"],
    tip: Float[np.ndarray, "r"],
) -> Float[np.ndarray, "r"]:
    """Return the widest opening (m) for the fingers around each run, or NaN if none fits."""
    distance = np.abs(u - center[:, None])

    def free(
        near: Float[np.ndarray, "r"], far: Float[np.ndarray, "r"], limit: Float[np.ndarray, "r"]
    ) -> Bool[np.ndarray, "r"]:
        under = (distance >= near[:, None]) & (distance <= far[:, None])
        return np.where(under, beside, -np.inf).max(1) <= limit

    room = np.full_like(center, np.nan)
    for margin in (0.6 * _MARGIN, _MARGIN, 1.5 * _MARGIN, 2.0 * _MARGIN):
        opening = np.minimum(width + 2 * margin, 2 * franka.FINGER_STROKE - 0.001)
        inner = opening / 2
        pads = free(inner - 0.001, inner + _PAD_DEPTH, tip - 0.001)
        shafts = free(inner + _SHAFT[0], inner + _SHAFT[1], tip + PAD_HEIGHT - 0.002)
        room = np.where(pads & shafts, opening, room)
    return room
