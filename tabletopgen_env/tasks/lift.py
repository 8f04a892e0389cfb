"""Lift: pick up one object and hold it in the air.

``reset`` option: ``target``, the name of an object. Goal: `Raised`.
"""

from __future__ import annotations

from types import MappingProxyType

import numpy as np

from generator.errors import InputError
from generator.scene import Object

from ..goals.goal import Raised
from ..world.world import World
from .candidates import draw_episode, liftable
from .task import Choice, Episode, Task, episode


class Lift(Task):
    """Hold one object in the air; see the module docstring."""

    weights = MappingProxyType({"reach": 0.20, "grasp": 0.20, "lift": 0.30, "success": 0.30})

    def sample(
        self, world: World, rng: np.random.Generator, target: str | None = None, goal: Choice = None
    ) -> Episode:
        """Draw a target, or use the given one; see ``Task.sample``."""
        if goal is not None:
            raise InputError("Lift has no goal to choose; omit the option 'goal'.")

        def make(obj: Object) -> Episode:
            return episode(world, (Raised(obj.name, world.position(obj.name)),))

        return draw_episode(world, rng, target, liftable(world), make, "")
