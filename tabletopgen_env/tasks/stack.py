"""Stack: place one object on the flat top of another.

``reset`` options: ``target``, the name of the object to place; ``goal``, the name of its support.
Goal: `OnTop`.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from generator.errors import InputError
from generator.geometry import quaternion_matrix
from generator.scene import Object

from ..affordance import grasp_width, resting_height
from ..expert.arm import stretch, up
from ..expert.planning.choice import HOVER, choose, first_plan
from ..goals.goal import OnTop
from ..goals.needs import FLAT, STANDING
from ..robot.mount import reachable
from ..world.world import World
from .candidates import draw_episode, given_object, liftable, on_table, rest_height
from .pick_place import PickPlace
from .task import Choice, Episode, Task, episode

LEAST_TOP = 0.022
"""Minimum radius of a flat top that serves as a support, in metres."""

_YAWS = np.arange(8) * np.pi / 4
"""Candidate yaws of the hand in the base frame, in radians."""

TALLEST = 0.25
"""Maximum height of a support, in metres: the arm must pass over it."""


class Stack(Task):
    """Place one object on another; see the module docstring."""

    weights = PickPlace.weights
    needs = (FLAT, STANDING)

    def sample(
        self, world: World, rng: np.random.Generator, target: str | None = None, goal: Choice = None
    ) -> Episode:
        """Draw a target and a support, or use the given ones; see ``Task.sample``."""
        wanted = given_object(
            world, goal, "to put objects on", "The goal of Stack must be the name of an object"
        )

        def make(obj: Object) -> Episode | None:
            found = list(supports(world, obj, wanted))
            if not found:
                return None
            base = found[int(rng.integers(len(found)))]
            return episode(world, (on_top(world, obj, base),))

        lacks = "no flat top in reach that can carry it"
        return draw_episode(world, rng, target, liftable(world), make, lacks)


def supports(world: World, obj: Object, wanted: str | None = None) -> Iterator[Object]:
    """Yield the supports for an object: flat tops in reach that carry no object yet.

    If the object's centre is above that of the flat part, its centre of mass is above the flat
    part.
    """
    loaded = {o.placement.on for o in world.scene.objects}
    plan = first_plan(world, obj.name, choose)
    held = 0.0 if plan is None else float(plan.grasp.point[2] - world.position(obj.name)[2])
    lever = float(np.linalg.norm((quaternion_matrix(obj.pose.quaternion) @ obj.com)[:2]))
    for other in world.scene.objects:
        if other.name in {obj.name, obj.placement.on} or other.name in loaded:
            continue
        if wanted not in (None, other.name) or not on_table(other):
            continue
        top = world.plateaus[other.name]
        if top is None or top.radius < max(LEAST_TOP, 0.3 * grasp_width(obj), lever):
            continue
        if resting_height(other) > TALLEST or other.mass < 0.3 * obj.mass:
            continue
        if reachable(world.mount, other.pose.position) and _is_carried_to(world, obj, other, held):
            yield other


def _is_carried_to(world: World, obj: Object, base: Object, held: float) -> bool:
    """Return whether the arm can hold ``obj``, gripped ``held`` above its centre, over ``base``."""
    tool = on_top(world, obj, base).region(world).center + up(held)
    ends = (tool, tool + up(HOVER))
    return any(stretch(world, ends, float(yaw)) is not None for yaw in _YAWS)


def on_top(world: World, obj: Object, base: Object) -> OnTop:
    """Return the goal of placing ``obj`` on ``base``.

    Raises:
        InputError: the base has no flat top, or is the object itself.
    """
    top = world.plateaus[base.name]
    if top is None or base.name == obj.name:
        raise InputError(f"{base.name!r} has no flat top for {obj.name!r}.")
    upwards = quaternion_matrix(base.pose.quaternion)[2]
    return OnTop(obj.name, base.name, top, rest_height(world, obj.name), upwards)
