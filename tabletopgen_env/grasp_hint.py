"""A grasp of the active target as part of the state: where a gripper from above could take it.

A box and a pose do not say where a mug's handle is, or on which side a neighbour leaves room for a
finger. With ``grasp_hint=True`` eight entries more do: the expert's grasp planner is asked when a
goal becomes active, and its answer moves with the object.

=====  =============================================================================  ==========
entry  meaning                                                                        unit
=====  =============================================================================  ==========
0-2    the grasp minus the tool centre point, base frame                              m
3      the turn of the hand about the vertical that is left, as its last joint allows rad
4      how far to open the fingers before going down                                  m
5      what will be between the fingers                                               m
6      how much higher the tool has to be to pass straight over what lies on its way  m
7      1 if a grasp is known, 0 (as all others) if not
=====  =============================================================================  ==========

The way of entry 6 leads to the grasp, or to the goal's region while both fingers touch the target.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from generator.geometry import rotation_yaw, wrap

from .expert.arm import turn_left
from .expert.choosing import Plan, choose
from .expert.grasps import TIP, Grasp
from .expert.path import clear_height

if TYPE_CHECKING:
    from .tasks.goals import Goal
    from .world import World

HINT_BOUNDS = np.array([3.0] * 3 + [7.0] + [0.1] * 2 + [3.0] + [1.0])
"""Largest magnitude of each entry."""

HINT_BOUNDS.setflags(write=False)

_MOVED, _TILTED, _STILL = 0.015, 0.97, 0.05  # metres, cosine, metres a second
_HIGHER = 0.3  # metres that entry 6 is at most


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
    read[:3] += target - tool
    read[3] -= yaw
    read[6] = max(read[6] - tool[2], 0.0)
    return read


class GraspHint:
    """The grasp of the active target, carried along with the object.

    It is planned anew when the object has come to rest elsewhere, untouched by the robot.
    """

    def __init__(self) -> None:
        self._target: str | None = None
        self._plan: Plan | None = None

    def begin(self, world: World, goal: Goal) -> None:
        """Plan for a goal that has just become active."""
        self._target, self._plan = goal.target, None
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
        if not any_part and self._is_elsewhere(world, name):
            self._take(world, name)
        plan = self.plan(world, name)
        if plan is None:
            return np.zeros(8)
        tool = world.data.site_xpos[world.tcp]
        held = left and right
        grasp = plan.grasp
        end = goal.region(world).center if held else grasp.point
        depth = max(float(tool[2]) - world.lowest(name), TIP) if held else TIP
        high = clear_height(world, name, tool, end) + depth
        away = world.base_rotation.T @ (grasp.point - tool)
        turn = turn_left(world, plan.yaw, grasp.point)
        rise = min(max(high - float(tool[2]), 0.0), _HIGHER)
        return np.array([*away, turn, grasp.opening, grasp.width, rise, 1.0])

    def _take(self, world: World, name: str) -> None:
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
