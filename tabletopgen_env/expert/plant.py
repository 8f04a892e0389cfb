"""The interface that the experts require of an environment."""

from __future__ import annotations

from typing import Protocol

from ..actions.servos import Controller
from ..goals.goal import Goal
from ..world.world import World
from .planning.choice import Chooser, GraspPlan
from .planning.drop import Drop


class Advice(Protocol):
    """The grasp hint of an environment, which the expert follows if there is one.

    Attributes:
        planned: the hinted grasp.
        drop: the hinted release, once the target is raised.
        choose: the function that chooses the hints.
    """

    planned: GraspPlan | None
    drop: Drop | None
    choose: Chooser

    def plan(self, world: World, name: str) -> GraspPlan | None:
        """Return a grasp of an object at its current pose, or None if it is not the target."""
        ...


class Plant(Protocol):
    """An environment in the action mode "ee_delta"; ``goal`` is the active goal."""

    action_mode: str
    controller: Controller
    world: World
    goal: Goal
    hint: Advice | None
