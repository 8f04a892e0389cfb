"""What the experts drive: the part of an environment that they need."""

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
        planned: the grasp that is hinted at.
        drop: where to let go, once the target is raised.
        choose: what the hints are chosen by.
    """

    planned: GraspPlan | None
    drop: Drop | None
    choose: Chooser

    def plan(self, world: World, name: str) -> GraspPlan | None:
        """Return the grasp of an object where it is now; None if it is not the active target."""
        ...


class Plant(Protocol):
    """An environment in the action mode "ee_delta"; ``goal`` is the active one."""

    action_mode: str
    controller: Controller
    world: World
    goal: Goal
    hint: Advice | None
