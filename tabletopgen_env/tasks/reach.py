"""Reach: move the tool centre point to a marked point in the air above the table.

``reset`` option: ``goal``, a point (x, y, z) in the world frame. Goal: `Reached`.
"""

from __future__ import annotations

from types import MappingProxyType

import numpy as np
from jaxtyping import Float

from generator.errors import InputError, SceneError

from ..expert.path import clear_height
from ..goals.goal import Reached
from ..world.world import World
from .candidates import coordinates
from .task import Choice, Episode, Task, episode

HEIGHTS = (0.05, 0.30)
"""Minimum and maximum height of a goal above the surface below it, in metres."""

_TRIES = 400


class Reach(Task):
    """Move the hand to a point; see the module docstring."""

    weights = MappingProxyType({"place": 0.5, "success": 0.5})
    marker_radius, marker_shape = 0.02, "ball"

    def sample(
        self, world: World, rng: np.random.Generator, target: str | None = None, goal: Choice = None
    ) -> Episode:
        """Draw a point, or use the given one; see ``Task.sample``."""
        if target is not None:
            raise InputError("Reach has no target; omit the option 'target'.")
        wanted = "The goal of Reach must be a point (x, y, z) in the world frame"
        point = free_point(world, rng) if goal is None else coordinates(goal, 3, wanted)
        return episode(world, (Reached(point),))


def free_point(world: World, rng: np.random.Generator) -> Float[np.ndarray, "3"]:
    """Draw a reachable point over the table, clear of all objects."""
    outline = world.scene.table.outline
    for _ in range(_TRIES):
        xy = rng.uniform(np.asarray(outline.min(0)), np.asarray(outline.max(0)))
        rise = rng.uniform(*HEIGHTS)
        here = np.array([*xy, world.scene.table.height])
        point = np.array([*xy, clear_height(world, None, here, here) + rise])
        if world.mount.reaches(point[None])[0]:
            return point
    raise SceneError(
        f"Scene {world.scene.name!r} has no free point within the robot's reach. Use other scenes."
    )
