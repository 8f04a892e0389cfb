"""Choice of the best reachable grasp, cached for the initial arrangement of a scene."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import compress
from typing import Protocol

import numpy as np
from jaxtyping import Float

from generator.geometry import wrap

from ...world.world import World
from ..arm import easiest, knuckle_is_free, stretch, up, wrists_are_free
from .grasps import TIP, Grasp, plan_grasps
from .heights import surroundings

HOVER = 0.06
"""Height above a grasp from which the hand moves straight down, in metres."""

_AROUND = 0.35  # distance from the object within which the wrist can collide, metres
_MOST = 80  # maximum number of examined grasps


@dataclass(frozen=True, eq=False)
class GraspPlan:
    """A reachable grasp, with the hand's yaw in the base frame and the object's position."""

    grasp: Grasp
    yaw: float
    seen: Float[np.ndarray, "3"]


class Chooser(Protocol):
    """A function that chooses a grasp: the expert's planner (``choose``) or a detector."""

    def __call__(
        self, world: World, target: str, failed: tuple[Grasp, ...] = ()
    ) -> GraspPlan | None:
        """Return a grasp of ``target`` at its current pose, or None if there is none."""
        ...


def choose(world: World, target: str, failed: tuple[Grasp, ...] = ()) -> GraspPlan | None:
    """Return the best reachable grasp of ``target`` at its current pose, or None if there is none.

    Grasps in ``failed`` rank last.
    """
    return first_reachable(world, target, plan_grasps(world, target, failed)[:_MOST])


def first_reachable(world: World, target: str, found: list[Grasp]) -> GraspPlan | None:
    """Return the first grasp in ``found`` that the arm can reach, or None if there is none.

    The wrist must clear the height map of all other objects.
    """
    center = world.position(target)
    low, high = center[:2] - _AROUND, center[:2] + _AROUND
    others = surroundings(world, target, low, high, 0.01)
    points = np.array([grasp.point for grasp in found]).reshape(-1, 3)
    clear = wrists_are_free(world, others, points[:, :2], points[:, 2] - TIP)
    free = list(compress(found, clear))
    last: GraspPlan | None = None
    # If the wrist has no space for any grasp, the motion may still succeed.
    for grasp in free or found:
        points, tip = (grasp.point, grasp.point + up(HOVER)), float(grasp.point[2]) - TIP
        yaw = easiest(world, points, grasp.angle - world.mount.yaw + np.pi / 2)
        if yaw is None:
            continue
        last = last or GraspPlan(grasp, yaw, center)
        for turned in (yaw, wrap(yaw + np.pi)):
            if knuckle_is_free(world, others, grasp.point[:2], tip, turned) and (
                turned == yaw or stretch(world, points, turned) is not None
            ):
                return GraspPlan(grasp, turned, center)
    return last


def first_plan(world: World, name: str, chooser: Chooser = choose) -> GraspPlan | None:
    """Return the grasp that ``chooser`` selects for an object at the start of an episode."""
    return world.remember((chooser, name), lambda: chooser(world, name))


def has_grasp(world: World, name: str) -> bool:
    """Return whether the arm can reach a grasp of an object at its pose in the scene."""
    return first_plan(world, name) is not None
