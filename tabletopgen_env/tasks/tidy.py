"""Tidy: put the small objects on the table into one tray, box or bowl.

The targets are two to four objects that fit into the container together, beside its contents; the
nearest objects come first. ``reset`` option: ``goal``, the name of the container. Goals: `Into`.
Few tables have a container for several objects; the tables in ``SCENES`` do.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial import ConvexHull

from generator.errors import InputError
from generator.scene import Object

from ..affordance import Opening, grasp_width, resting_height
from ..expert.planning.choice import has_grasp
from ..goals.goal import INSIDE, Goal, the
from ..goals.needs import TINY, TRAYS
from ..world.world import World
from .candidates import containers, given_object, into, liftable, nothing
from .swap import Swap
from .task import Choice, Episode, Task, episode

SCENES = "tidy-task-*"
"""Bundles (a glob) with a tray and small objects."""

FULL = 0.45
"""Maximum fraction of a container's floor that the objects may cover together."""


class Tidy(Task):
    """Put all small objects into one container; see the module docstring."""

    weights = Swap.weights
    most = 4
    scenes = SCENES
    needs = (TRAYS, TINY, TINY, TINY)

    def sample(
        self, world: World, rng: np.random.Generator, target: str | None = None, goal: Choice = None
    ) -> Episode:
        """Draw a container, or use the given one; see ``Task.sample``."""
        if target is not None:
            raise InputError("Tidy moves all objects that fit; omit the option 'target'.")
        wanted = given_object(
            world, goal, "to put objects into", "The goal of Tidy must be the name of a container"
        )
        reasons = liftable(world)
        small = [o for o in world.scene.objects if reasons[o.name] is None]
        loads: dict[str, list[Object]] = {}
        for obj in small:
            for container in containers(world, obj):
                if wanted in (None, container.name):
                    loads.setdefault(container.name, []).append(obj)
        for obj in small:
            reasons[obj.name] = "no container that fits it together with another object"
        names = sorted(loads)
        for k in map(int, rng.permutation(len(names))):
            container = world.scene.object(names[k])
            taken = _together(world, container, loads[container.name])
            if len(taken) >= 2:
                return episode(world, tuple(into(world, o, container) for o in taken))
        raise nothing(world, reasons)

    def instruction(self, world: World, goals: tuple[Goal, ...]) -> str:
        """Return the instruction for ``goals`` as one sentence."""
        *listed, last = (the(world, str(goal.target)) for goal in goals)
        container = the(world, str(goals[0].reference))
        return f"put {', '.join(listed)} and {last} into {container}"


def _together(world: World, container: Object, things: list[Object]) -> list[Object]:
    """Return objects that together fit into a container, chosen in order of distance."""
    hollow = world.openings[container.name]
    assert hollow is not None
    room = FULL * np.pi * float(hollow.semi.prod())
    room -= sum(_area(world, o) for o in world.scene.objects if o.placement.on == container.name)
    center = container.pose.position
    taken: list[Object] = []
    for obj in sorted(things, key=lambda o: float(np.linalg.norm(o.pose.position - center))):
        area = _area(world, obj)
        fits = area <= room and all(_has_room(hollow, first, obj) for first in taken)
        if len(taken) < Tidy.most and fits and has_grasp(world, obj.name):
            taken.append(obj)
            room -= area
    return taken


def _has_room(hollow: Opening, first: Object, second: Object) -> bool:
    """Return whether ``second`` fits into a container on top of, or beside, a centred ``first``."""
    on_top = resting_height(first) + INSIDE <= hollow.depth
    beside = grasp_width(first) / 2 + grasp_width(second)
    return on_top or beside <= float(hollow.semi.min())


def _area(world: World, obj: Object) -> float:
    """Return the footprint area of an object in square metres."""
    return float(ConvexHull(world.footprints[obj.name]).volume)  # area of a polygon
