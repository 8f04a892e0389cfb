"""Grasps at the start of an episode, planned once for each arrangement of a scene."""

from __future__ import annotations

from ...world.world import World
from .choosing import Chooser, GraspPlan, choose


def first_plan(world: World, name: str, chooser: Chooser = choose) -> GraspPlan | None:
    """Return the grasp that ``chooser`` takes of an object at the start of an episode."""
    return world.remember((chooser, name), lambda: chooser(world, name))


def has_grasp(world: World, name: str) -> bool:
    """Return whether the arm reaches a grasp of an object where the scene puts it."""
    return first_plan(world, name) is not None
