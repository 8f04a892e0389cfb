"""Choose a grasp: the best one that the arm can reach, once per arrangement of a scene."""

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
"""Metres above a grasp from which the hand goes straight down."""

_AROUND = 0.35  # metres about the object in which the wrist may hit something
_MOST = 80  # grasps that are looked at


@dataclass(frozen=True, eq=False)
class GraspPlan:
    """A grasp that can be reached: the hand's yaw in the base frame, and where the object was."""

    grasp: Grasp
    yaw: float
    seen: Float[np.ndarray, "3"]


class Chooser(Protocol):
    """Chooses a grasp: the expert's planner (``choose``), or a detector."""

    def __call__(
        self, world: World, target: str, failed: tuple[Grasp, ...] = ()
    ) -> GraspPlan | None:
        """Return a grasp of ``target`` where it is now, None if there is none; as ``choose``."""
        ...


def choose(world: World, target: str, failed: tuple[Grasp, ...] = ()) -> GraspPlan | None:
    """Return the best grasp of ``target`` where it is now that the arm can reach, None if none.

    Those that ``failed`` rank last.
    """
    return first_reachable(world, target, plan_grasps(world, target, failed)[:_MOST])


def first_reachable(world: World, target: str, found: list[Grasp]) -> GraspPlan | None:
    """Return the first of the grasps ``found`` that the arm can reach; None if it can reach none.

    The wrist is kept off the height map of all but the target.
    """
    center = world.position(target)
    low, high = center[:2] - _AROUND, center[:2] + _AROUND
    others = surroundings(world, target, low, high, 0.01)
    points = np.array([grasp.point for grasp in found]).reshape(-1, 3)
    clear = wrists_are_free(world, others, points[:, :2], points[:, 2] - TIP)
    free = list(compress(found, clear))
    last: GraspPlan | None = None
    # If the wrist has no room for any grasp, it may still pass.
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
    """Return the grasp that ``chooser`` takes of an object at the start of an episode."""
    return world.remember((chooser, name), lambda: chooser(world, name))


def has_grasp(world: World, name: str) -> bool:
    """Return whether the arm reaches a grasp of an object where the scene puts it."""
    return first_plan(world, name) is not None
