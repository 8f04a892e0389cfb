"""PickPlace: pick up one object and place it into a container or onto a marked free spot.

``reset`` options: ``target``, the name of an object; ``goal``, the name of a container, "spot" for
a random free spot, or a point (x, y) on the table in the world frame. Goals: `Into` or `OnSpot`.
"""

from __future__ import annotations

from types import MappingProxyType

import numpy as np

from generator.scene import Object

from ..world.world import World
from .candidates import (
    check_known,
    containers,
    draw_episode,
    into,
    liftable,
    on_spot,
    spot_of,
    target_of,
)
from .task import Choice, Episode, Task, episode


class PickPlace(Task):
    """Place one object into a container or onto a marked spot; see the module docstring."""

    weights = MappingProxyType(
        {"reach": 0.10, "grasp": 0.15, "lift": 0.15, "place": 0.30, "success": 0.30}
    )

    def sample(
        self, world: World, rng: np.random.Generator, target: str | None = None, goal: Choice = None
    ) -> Episode:
        """Draw a target and a goal, or use the given ones; see ``Task.sample``."""
        reasons, wanted = liftable(world), target_of(goal)
        if wanted is not None:
            check_known(world, wanted, "to put objects into")
            for obj in world.scene.objects:
                if not reasons[obj.name] and wanted not in {o.name for o in containers(world, obj)}:
                    reasons[obj.name] = f"does not fit into {wanted}"

        def make(obj: Object) -> Episode | None:
            if wanted is not None:
                return episode(world, (into(world, obj, world.scene.object(wanted)),))
            fitting = list(containers(world, obj)) if goal is None else []
            if fitting and rng.random() < 0.5:
                return episode(world, (into(world, obj, fitting[int(rng.integers(len(fitting)))]),))
            spot = spot_of(world, obj, goal, rng)
            if spot is not None:
                return episode(world, (on_spot(world, obj, spot),))
            return episode(world, (into(world, obj, fitting[0]),)) if fitting else None

        lacks = "no container fits the object, and no free spot is in reach"
        return draw_episode(world, rng, target, reasons, make, lacks)
