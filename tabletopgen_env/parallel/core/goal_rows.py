"""The goals of n episodes as arrays: the kind and the parameters of each ``goals.goal.Goal``.

Everything is in the base frame of each world's robot.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np
from jaxtyping import Bool, Float, Int

from ...affordance import outer_points
from ...goals.goal import (
    GAP,
    INSIDE,
    LYING,
    REST_SPEED,
    REST_SPIN,
    UPRIGHT,
    Goal,
    Into,
    OnSpot,
    OnTop,
    Pushed,
    Raised,
    Reached,
)
from ...tasks.task import FAR, Episode
from ...world.world import World
from .arrays import Array, apply, namespace, squares, take_rows, wrap, yaw_of
from .readings import Readings

KINDS: tuple[type[Goal], ...] = (Reached, Raised, Pushed, OnSpot, Into, OnTop)
"""The goal classes; the index of a class is its kind."""

REACHED, RAISED, PUSHED, ON_SPOT, INTO, ON_TOP = range(len(KINDS))

POINTS = 512
"""Number of points that represent a target's collision shape, padded; convex hulls rarely have
more.
"""


@dataclass(frozen=True, eq=False)
class GoalRows:
    """The goals of n episodes, g per episode; unused goals are padding.

    Attributes:
        kind: index in ``KINDS``.
        target: row of the object to move, -1 for the tool and for padding.
        reference: row of the object that carries the region, otherwise -1.
        used: which goals are not padding.
        center: centre of the region, or its position in the reference's frame, metres.
        semi: semi-axes x', y', z of the region, metres.
        yaw: yaw of regions that are not carried by an object or are on top of one, rad.
        rest: height of the "on top" region above that position, metres.
        up: the world's up direction at the start, in the frame of the target ("push") or of the
            reference.
        floor, rim: heights in the reference's frame that bound the target's lowest point, metres.
        start: initial height of the target's centre, metres.
        points: points of the target's collision shape in its own frame; its lowest point is always
            one of them.
        mount_yaw: bearing of the robot's x axis in the world frame, rad.
        table: height of the top, and its half length and half width, metres.
    """

    kind: Int[Array, "n g"]
    target: Int[Array, "n g"]
    reference: Int[Array, "n g"]
    used: Bool[Array, "n g"]
    center: Float[Array, "n g 3"]
    semi: Float[Array, "n g 3"]
    yaw: Float[Array, "n g"]
    rest: Float[Array, "n g"]
    up: Float[Array, "n g 3"]
    floor: Float[Array, "n g"]
    rim: Float[Array, "n g"]
    start: Float[Array, "n g"]
    points: Float[Array, "n g p 3"]
    mount_yaw: Float[Array, "n"]
    table: Float[Array, "n 3"]

    @classmethod
    def blank(cls, worlds: int, goals: int, kind: type = np.float64) -> GoalRows:
        """Return NumPy rows without goals for ``write`` to fill; ``kind`` is the type of floats."""
        shapes = {"center": (3,), "semi": (3,), "up": (3,), "points": (POINTS, 3)}
        found = {
            f.name: np.zeros((worlds, goals, *shapes.get(f.name, ())), kind) for f in fields(cls)
        }
        found |= {"mount_yaw": np.zeros(worlds, kind), "table": np.zeros((worlds, 3), kind)}
        numbers = {name: np.full((worlds, goals), -1) for name in ("kind", "target", "reference")}
        return cls(**{**found, **numbers, "used": np.zeros((worlds, goals), bool)})

    def write(self, row: int, world: World, episode: Episode) -> None:
        """Write the goals of a world's episode into a row of NumPy arrays.

        Raises:
            TypeError: a goal is not an instance of ``KINDS``.
        """
        for array in (self.kind, self.target, self.reference):
            array[row] = -1
        self.used[row] = False
        self.mount_yaw[row] = world.mount.yaw
        self.table[row, 0] = world.scene.table.height - world.base_position[2]
        self.table[row, 1:] = world.half_top
        for k, goal in enumerate(episode.goals):
            self._write_goal((row, k), world, goal)
            self.start[row, k] = episode.starts[k] - world.base_position[2]

    def _write_goal(self, at: tuple[int, int], world: World, goal: Goal) -> None:
        if type(goal) not in KINDS:
            raise TypeError(f"Batched goals must be instances of {KINDS}, got {type(goal)}.")
        self.kind[at] = KINDS.index(type(goal))
        self.used[at] = True
        region = goal.region(world)
        self.center[at], self.semi[at] = world.to_base(region.center), region.semi
        self.yaw[at] = -world.mount.yaw
        if goal.target is not None:
            self.target[at] = world.index(goal.target)
            points = _outer_points(world, goal.target)
            self.points[at] = points[np.minimum(np.arange(POINTS), len(points) - 1)]
        if isinstance(goal, Into | OnTop):
            self.reference[at] = world.index(goal.reference)
        if isinstance(goal, Pushed | OnTop):
            self.up[at] = goal.up
        if isinstance(goal, OnTop):
            self.center[at], self.rest[at] = goal.plateau.center, goal.rest
        if isinstance(goal, Into):
            hollow = goal.opening
            self.center[at] = [*hollow.center, (hollow.floor + hollow.rim + goal.height) / 2]
            self.floor[at] = hollow.floor - hollow.thickness / 2
            self.rim[at] = hollow.rim


def _outer_points(world: World, name: str) -> Float[np.ndarray, "p 3"]:
    """Return the points of an object's collision shape that can be its lowest point."""
    key = "outer points", name
    if key not in world.cached:
        world.cached[key] = outer_points(world.scene.object(name), POINTS)
    return world.cached[key]


def regions(rows: GoalRows, seen: Readings) -> tuple[Float[Array, "n g 3"], Float[Array, "n g"]]:
    """Return the current centres and yaws of the goals' regions, as defined for goal vectors."""
    xp = namespace(rows.center)
    turned = take_rows(seen.rotations, rows.reference)
    center = take_rows(seen.positions, rows.reference) + apply(turned, rows.center)
    center[..., 2] += xp.where(rows.kind == ON_TOP, rows.rest, xp.zeros_like(rows.rest))
    center = xp.where((rows.reference >= 0)[..., None], center, rows.center)
    mount = rows.mount_yaw[:, None]
    yaw = xp.where(rows.kind == INTO, wrap(yaw_of(turned) + mount) - mount, rows.yaw)
    return center, yaw


def targets(rows: GoalRows, seen: Readings) -> Float[Array, "n g 3"]:
    """Return the positions of the goals' targets: object centres or tool centre points."""
    xp = namespace(rows.center)
    there = take_rows(seen.positions, rows.target)
    return xp.where((rows.target >= 0)[..., None], there, seen.tool[:, None])


def are_settled(rows: GoalRows, seen: Readings) -> Bool[Array, "n g"]:
    """Return whether the target of each goal is in the required state, apart from its position."""
    xp = namespace(rows.center)
    kind, turned = rows.kind, take_rows(seen.rotations, rows.reference)
    own = take_rows(seen.rotations, rows.target)
    left, right, any_part = (seen.touched[..., k] for k in range(3))
    resting = squares(take_rows(seen.linear, rows.target)) <= REST_SPEED**2
    resting &= squares(take_rows(seen.angular, rows.target)) <= REST_SPIN**2
    points = (rows.points @ own[..., 2, :, None])[..., 0]
    lowest = take_rows(seen.positions, rows.target)[..., 2] + xp.min(points, axis=-1)
    base, rise = take_rows(seen.positions, rows.reference)[..., 2], turned[..., 2, 2]
    top = base + xp.sum(turned[..., 2, :] * rows.center, axis=-1)
    inside = (base + rise * rows.floor <= lowest) & (lowest <= base + rise * rows.rim - INSIDE)
    lying = lowest <= rows.table[:, :1] + LYING
    free = resting & ~any_part
    found = (kind == REACHED) | ((kind == RAISED) & left & right) | ((kind == ON_SPOT) & free)
    found |= (kind == PUSHED) & _upright(own, rows.up) & lying & resting
    found |= (kind == INTO) & free & (rise >= UPRIGHT) & inside
    on_top = _upright(turned, rows.up) & (xp.abs(lowest - top) <= GAP)
    return found | ((kind == ON_TOP) & free & on_top)


def goal_vectors(rows: GoalRows, seen: Readings) -> tuple[Float[Array, "n v"], Float[Array, "n v"]]:
    """Return the achieved and the desired goal vectors as ``float32``; see ``tasks.task``."""
    xp = namespace(rows.center)
    center, yaw = regions(rows, seen)
    shared = [rows.semi[..., :2], yaw[..., None], rows.semi[..., 2:]]
    ones = xp.ones_like(rows.rest)
    made = []
    for place, last in ((targets(rows, seen), xp.astype(are_settled(rows, seen), ones.dtype)),
                        (center, ones)):  # fmt: skip
        entries = xp.concat([xp.clip(place, -FAR, FAR), *shared, last[..., None]], axis=-1)
        entries = xp.where(rows.used[..., None], entries, xp.zeros_like(entries))
        made.append(xp.astype(xp.reshape(entries, (entries.shape[0], -1)), xp.float32))
    return made[0], made[1]


def _upright(rotations: Array, up: Array) -> Array:
    """Return whether ``up``, given in body frames, points upwards."""
    return namespace(up).sum(rotations[..., 2, :] * up, axis=-1) >= UPRIGHT
