"""Swap: exchange the positions of two objects, such as the cup and apple in Sec. 11 of the paper.

There are three goals, shown in order: the second object aside on a marked free spot, the first
object at the start position of the second, and the second at the start position of the first. The
first goal counts as met once the second one is; only the last two matter in the end. ``reset``
options: ``target`` and ``goal``, the names of the two objects. Goals: `OnSpot`.
"""

from __future__ import annotations

from types import MappingProxyType

import numpy as np

from generator.geometry import inside_margin
from generator.scene import Object

from ..expert.planning.choice import has_grasp
from ..goals.goal import Goal, the
from ..goals.needs import SMALL
from ..world.workspace import FREE_MARGIN
from ..world.world import World
from .candidates import draw_episode, given_object, in_stead, liftable, on_spot, on_table, spot_of
from .task import Choice, Episode, Task, episode


class Swap(Task):
    """Exchange the positions of two objects; see the module docstring."""

    weights = MappingProxyType(
        {"reach": 0.05, "grasp": 0.10, "lift": 0.10, "place": 0.25, "met": 0.25, "success": 0.25}
    )
    most = 3
    aside = MappingProxyType({0: 1})
    needs = (SMALL, SMALL)

    def sample(
        self, world: World, rng: np.random.Generator, target: str | None = None, goal: Choice = None
    ) -> Episode:
        """Draw two objects, or use the given ones; see ``Task.sample``."""
        wanted = given_object(
            world, goal, "to swap with", "The goal of Swap must be the name of the other object"
        )
        reasons = liftable(world)
        for obj in world.scene.objects:
            if not on_table(obj):
                reasons[obj.name] = reasons[obj.name] or f"the object stands on {obj.placement.on}"
        fit = [name for name, why in reasons.items() if why is None]

        def make(obj: Object) -> Episode | None:
            names = fit if wanted is None else [wanted]
            for k in map(int, rng.permutation(len(names))):
                other = world.scene.object(names[k])
                if other.name == obj.name or not has_grasp(world, other.name):
                    continue
                spot = spot_of(world, other, None, rng)
                if spot is not None and _fits(world, obj, other) and _fits(world, other, obj):
                    aside = on_spot(world, other, spot)
                    return episode(
                        world, (aside, in_stead(world, obj, other), in_stead(world, other, obj))
                    )
            return None

        lacks = "no other object to swap it with"
        return draw_episode(world, rng, target, reasons, make, lacks)

    def instruction(self, world: World, goals: tuple[Goal, ...]) -> str:
        """Return the instruction for the last two ``goals``."""
        first, second = (str(goals[k].target) for k in (1, 2))
        return f"swap {the(world, first)} and {the(world, second)}"


def _fits(world: World, obj: Object, place: Object) -> bool:
    """Return whether ``obj`` fits at the position of ``place`` once ``place`` is removed."""
    outline = world.footprints[obj.name] - obj.pose.position[:2]
    radius = float(np.linalg.norm(outline, axis=1).max())
    center = place.pose.position[:2]
    if inside_margin(center, world.scene.table.outline)[0] < 0.7 * radius:
        return False
    others = (world.footprints[o] for o in world.names if o not in (obj.name, place.name))
    return all(inside_margin(center, f)[0] <= -(radius + FREE_MARGIN) for f in others)
