"""What to do with the active target next, as part of the state: where to grasp it, where to let go.

A box and a pose do not say where a mug's handle is, on which side a neighbour leaves room for a
finger, or how the mug has to be turned to fit beside what lies in a tray. With ``grasp_hint=True``
eight entries more do. The expert's planners are asked when a goal becomes active, for a grasp that
then moves with the object, and when both fingers have raised the object, for a place.

=====  =============================================================================  ==========
entry  meaning                                                                        unit
=====  =============================================================================  ==========
0-2    where to close the fingers, or to open them, minus the tool, base frame        m
3      the turn of the hand about the vertical that is left, as its last joint allows rad
4      how far to open the fingers before going down, or to let go                    m
5      what will be, or is, between the fingers                                       m
6      how much higher the tool has to be to pass over what lies on its way           m
7      1 if the entries are of a grasp, -1 if of a place, 0 (as all others) if of none
=====  =============================================================================  ==========

Within 2 cm of the vertical over the end of its way entry 6 is 0. A place is shown until the object
lies still, let go, elsewhere. `Raised` and `Pushed` have none.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from jaxtyping import Float

from generator.geometry import rotation_yaw, rotation_z, wrap

from .expert.arm import turn_left
from .expert.choosing import Plan, choose
from .expert.driver import NEAR
from .expert.dropping import Drop, breadth, hanging, let_go_at, lost
from .expert.grasps import TIP, Grasp
from .expert.path import clear_height
from .tasks.goals import Into, OnSpot, OnTop

if TYPE_CHECKING:
    from .tasks.goals import Goal
    from .world import World

HINT_BOUNDS = np.array([3.0] * 3 + [7.0] + [0.1] * 2 + [3.0] + [1.0])
"""Largest magnitude of each entry."""

HINT_BOUNDS.setflags(write=False)

_MOVED, _TILTED, _STILL = 0.015, 0.97, 0.05  # metres, cosine, metres a second
_HIGHER = 0.3  # metres that entry 6 is at most
_RAISED = 0.035  # metres above where it was grasped at which an object's place is planned


def misread(
    entries: Float[np.ndarray, "8"],
    target: Float[np.ndarray, "3"],
    tool: Float[np.ndarray, "3"],
    yaw: float,
) -> Float[np.ndarray, "8"]:
    """Return the entries as sensors that err give them.

    Args:
        entries: as things are.
        target: by how much the reading of its place errs, base frame, metres.
        tool: the same of the tool centre point.
        yaw: by how much that of the hand's yaw does, radians.
    """
    if not entries[-1]:
        return entries
    read = entries.copy()
    if entries[-1] > 0:
        read[:3] += target - tool
    else:  # where the object is in the hand turns with it
        read[:3] -= rotation_z(float(entries[3])) @ (target - tool) + tool
    read[3] -= yaw
    read[6] = max(read[6] - tool[2], 0.0)
    return read


class GraspHint:
    """The grasp of the active target, carried along with the object, and then its place.

    A grasp is planned anew when the object has come to rest elsewhere, untouched by the robot.
    ``drop`` is the place while there is one.
    """

    def __init__(self) -> None:
        self._target: str | None = None
        self._plan: Plan | None = None
        self.drop: Drop | None = None

    def begin(self, world: World, goal: Goal) -> None:
        """Plan for a goal that has just become active."""
        self._target, self._plan, self.drop = goal.target, None, None
        if goal.target is not None:
            self._take(world, goal.target)

    def plan(self, world: World, name: str) -> Plan | None:
        """Return the grasp of an object where it is now; None if it is not the active target."""
        if self._plan is None or self._target != name:
            return None
        turned = world.rotation(name) @ self._rotation.T
        at, then = world.position(name), self._plan.seen
        turn = rotation_yaw(turned)
        old = self._plan.grasp
        point = at + turned @ (old.point - then)
        grasp = Grasp(point, old.angle + turn, old.opening, old.width, old.score)
        return Plan(grasp, wrap(self._plan.yaw + turn), at)

    def entries(self, world: World, goal: Goal) -> Float[np.ndarray, "8"]:
        """Return the entries as things are, after planning anew if need be."""
        name = self._target
        if name is None:
            return np.zeros(8)
        left, right, any_part = world.touched(name)
        if self.drop is None:
            gone = not any_part and self._is_elsewhere(world, name)
        else:
            gone = lost(world, goal)
        if gone:
            self._take(world, name)
        plan = self.plan(world, name)
        if plan is None:
            return np.zeros(8)
        if self.drop is None and left and right and self._asks_place(world, goal):
            yaw = rotation_yaw(world.hand)
            self.drop = Drop(world, goal, yaw, let_go_at(plan.grasp))
        if self.drop is None:
            way = _Way(plan.grasp.point, turn_left(world, plan.yaw, plan.grasp.point), TIP, 0.0)
            return _entries(world, name, way, plan.grasp.opening, plan.grasp.width, 1.0)
        drop = self.drop
        drop.follow(world)
        way = _Way(drop.tool, drop.turn(world), hanging(world, name), breadth(world, name))
        return _entries(world, name, way, drop.opening, plan.grasp.width, -1.0)

    def _asks_place(self, world: World, goal: Goal) -> bool:
        """Return whether the held object is to be put down, and is high enough to see where."""
        risen = world.position(goal.target)[2] - self._seen[2] if goal.target else 0.0
        return isinstance(goal, Into | OnTop | OnSpot) and bool(risen > _RAISED)

    def _take(self, world: World, name: str) -> None:
        self.drop = None
        started = world.data.time > 0
        self._plan = choose(world, name) if started else world.first_plan(name)
        self._rotation = world.rotation(name)
        self._seen = world.position(name)

    def _is_elsewhere(self, world: World, name: str) -> bool:
        """Return whether the object rests at another place, or tilted, since the last plan."""
        speed = world.velocity(name)[:3]
        if float(speed @ speed) > _STILL**2:
            return False
        moved = world.position(name) - self._seen
        if float(moved @ moved) > _MOVED**2:
            return True
        return float((world.rotation(name) @ self._rotation.T)[2, 2]) < _TILTED


class _Way(NamedTuple):
    """The end of the tool's way (world), the turn left, and how far what is held reaches."""

    end: Float[np.ndarray, "3"]
    turn: float
    depth: float
    broad: float


def _entries(
    world: World, name: str, way: _Way, opening: float, width: float, kind: float
) -> Float[np.ndarray, "8"]:
    tool = world.data.site_xpos[world.tcp]
    left = way.end - tool
    rise = 0.0
    if math.hypot(left[0], left[1]) > NEAR:
        high = clear_height(world, name, tool, way.end, way.broad) + way.depth
        rise = min(max(high - float(tool[2]), 0.0), _HIGHER)
    return np.array([*(world.base_rotation.T @ left), way.turn, opening, width, rise, kind])
