"""Whether an episode can be played from its start: the things to move can be moved."""

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
    """Requirements on a start, built at the start of a scene and checked once things are moved."""

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
        """Return whether the goals can be reached from where things are now.

        Nothing touches the robot, what is to be pushed has a stroke, and what had a reachable grasp
        still has one.
        """
        world = self._world
        return (
            not touches_robot(world)
            and all(taken.has_grasp(world) for taken in self._taken)
            and all(plan_stroke(world, g.target, g.spot[:2]) is not None for g in self._pushed)
        )


def touches_robot(world: World) -> bool:
    """Return whether a thing touches the robot."""
    return any(world.touches(name)[2] for name in world.names)


@dataclass(frozen=True, eq=False)
class _Taken:
    """A thing to take, with a grasp of it at a place (metres) and rotation, world frame."""

    name: str
    plan: GraspPlan
    position: Float[np.ndarray, "3"]
    rotation: Float[np.ndarray, "3 3"]

    def has_grasp(self, world: World) -> bool:
        """Return whether the arm reaches this grasp where the thing is now, or another."""
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
