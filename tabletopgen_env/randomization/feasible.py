"""Feasibility of an episode at its start: the targets must be reachable and movable."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from generator.geometry import rotation_yaw, wrap

from ..expert.arm import stretch, up
from ..expert.planning.choice import HOVER, GraspPlan, choose, first_plan
from ..expert.planning.grasps import grasps_along, is_like
from ..expert.planning.strokes import plan_stroke
from ..goals.goal import Goal, Pushed

if TYPE_CHECKING:
    from ..world.world import World


class Feasible:
    """Conditions for feasible goals, derived from the original start and checked after moves."""

    def __init__(self, world: World, goals: Sequence[Goal]) -> None:
        self._world = world
        self._pushed = tuple(goal for goal in goals if isinstance(goal, Pushed))
        taken = [g.target for g in goals if g.target is not None and not isinstance(g, Pushed)]
        found = ((name, first_plan(world, name, choose)) for name in dict.fromkeys(taken))
        self._taken = tuple(
            _Taken(name, plan, world.position(name).copy(), world.rotation(name).copy())
            for name, plan in found
            if plan is not None
        )

    def now(self) -> bool:
        """Return whether the goals can be reached from the current arrangement.

        No object may touch the robot, the robot must have a stroke for each target to push, and
        targets that had a reachable grasp must still have one.
        """
        world = self._world
        return (
            not touches_robot(world)
            and all(taken.has_grasp(world) for taken in self._taken)
            and all(plan_stroke(world, g.target, g.spot[:2]) is not None for g in self._pushed)
        )


def touches_robot(world: World) -> bool:
    """Return whether an object touches the robot."""
    return any(world.touches(name)[2] for name in world.names)


@dataclass(frozen=True, eq=False)
class _Taken:
    """An object to be grasped, its pose in the world (metres), and a grasp plan for that pose."""

    name: str
    plan: GraspPlan
    position: Float[np.ndarray, "3"]
    rotation: Float[np.ndarray, "3 3"]

    def has_grasp(self, world: World) -> bool:
        """Return whether the planned or another grasp is reachable at the object's current pose."""
        turned = world.rotation(self.name) @ self.rotation.T
        point = world.position(self.name) + turned @ (self.plan.grasp.point - self.position)
        turn = rotation_yaw(turned)
        along = replace(self.plan.grasp, point=point, angle=self.plan.grasp.angle + turn)
        if any(is_like(found, along) for found in grasps_along(world, self.name, [along.angle])):
            ends = (point, point + up(HOVER))
            yaws = (wrap(self.plan.yaw + turn), wrap(self.plan.yaw + turn + np.pi))
            if any(stretch(world, ends, yaw) is not None for yaw in yaws):
                return True
        return choose(world, self.name) is not None
