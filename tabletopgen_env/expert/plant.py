"""What the experts drive: the part of an environment that they need."""

from __future__ import annotations

from typing import Protocol

from ..actions.servos import Controller
from ..goals.goal import Goal
from ..world.world import World
from .planning.choosing import Chooser, GraspPlan
from .planning.dropping import Drop


class Advice(Protocol):
    """The grasp hint of an environment, which the expert follows if there is one."""

    @property
    def planned(self) -> GraspPlan | None:
        """The grasp that is hinted at."""

    @property
    def drop(self) -> Drop | None:
        """Where to let go, once the target is raised."""

    @property
    def choose(self) -> Chooser:
        """What the hints are chosen by."""

    def plan(self, world: World, name: str) -> GraspPlan | None:
        """Return the grasp of an object where it is now; None if it is not the active target."""


class Plant(Protocol):
    """An environment in the action mode "ee_delta"."""

    action_mode: str
    controller: Controller

    @property
    def world(self) -> World:
        """The simulated world."""

    @property
    def goal(self) -> Goal:
        """The goal that is active."""

    @property
    def hint(self) -> Advice | None:
        """The grasp hint, if the environment gives one."""
