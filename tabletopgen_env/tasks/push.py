"""Push: slide one object along the table to a marked spot, with the fingers closed.

The gripper stays closed whatever the action says. Pushed is what stands on the table alone, does
not topple easily and need not fit into the hand. ``reset`` options: ``target`` an object's name;
``goal`` a point (x, y) of the table in the world frame. Goal: `Pushed`.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from generator.errors import InputError
from generator.geometry import inside_margin
from generator.scene import Object

from ..affordance import grasp_width, resting_height
from ..expert.strokes import beside, plan_stroke
from .goals import SPOT, Pushed
from .sampling import Reasons, blocked, drawn, given_point, on_table, rest_height
from .task import Episode, Task, episode

if TYPE_CHECKING:
    from ..world import World

WAY = (0.08, 0.25)
"""Shortest and longest way to push, metres."""

HEAVIEST = 1.5
"""Heaviest object to push, kg."""

SLENDER = 1.2
"""Tallest thing to push, in its own smallest widths: what is more slender topples."""

_TRIES = 200
_PLANS = 25  # strokes planned at most to find one that the arm can make


class Push(Task):
    """Slide one object to a spot; see the module's page."""

    weights = MappingProxyType({"reach": 0.20, "place": 0.50, "success": 0.30})
    closed = True

    def sample(
        self,
        world: World,
        rng: np.random.Generator,
        target: str | None = None,
        goal: str | tuple[float, ...] | None = None,
    ) -> Episode:
        """Draw a target and a spot, or take those given; see ``Task.sample``."""
        if isinstance(goal, str) and goal != SPOT:
            raise InputError(f"The goal of Push is a point (x, y) of the table, got {goal!r}.")

        def make(obj: Object) -> Episode | None:
            named = goal is not None and not isinstance(goal, str)
            xy = given_point(world, goal) if named else _end(world, obj, rng)  # type: ignore[arg-type]
            if xy is None:
                return None
            spot = np.array([*xy, world.scene.table.height])
            up = world.rotation(obj.name)[2]
            return episode(world, (Pushed(obj.name, spot, rest_height(world, obj.name), up),))

        lacks = "no free way to push it along"
        return drawn(world, rng, target, slidable(world), make, lacks, held=False)


def slidable(world: World) -> Reasons:
    """Return why each object cannot be pushed, None where it can."""
    return {o.name: _fixed(world, o) for o in world.scene.objects}


def _fixed(world: World, obj: Object) -> str | None:
    if not on_table(obj):
        return f"it stands on {obj.placement.on}"
    if obj.mass > HEAVIEST:
        return f"{obj.mass:.3g} kg is heavier than {HEAVIEST} kg"
    if resting_height(obj) > SLENDER * grasp_width(obj):
        return "it would topple"
    if resting_height(obj) < 0.01:
        return "too flat for the fingers"
    return blocked(world, obj)


def _end(world: World, obj: Object, rng: np.random.Generator) -> Float[np.ndarray, "2"] | None:
    """Draw where to push an object: along a way free of others, with room for the hand behind."""
    begin = obj.pose.position[:2]
    outline = world.footprints[obj.name]
    radius = float(np.linalg.norm(outline - begin, axis=1).max())
    table = world.scene.table
    others = beside(world, obj.name)
    plans = 0
    for _ in range(_TRIES):
        angle, way = rng.uniform(0, 2 * np.pi), rng.uniform(*WAY)
        ahead = np.array([np.cos(angle), np.sin(angle)])
        line = begin + np.linspace(0.0, way, 8)[:, None] * ahead
        if not world.mount.reaches(np.array([[*line[-1], table.height + 0.02]])).all():
            continue
        if (inside_margin(line[1:], table.outline) < min(radius, 0.1)).any():
            continue
        outlines = (world.footprints[o] for o in world.names if o != obj.name)
        if any((inside_margin(line, other) > -(radius + 0.01)).any() for other in outlines):
            continue
        if plan_stroke(world, obj.name, line[-1], others) is not None:
            return line[-1]
        plans += 1
        if plans == _PLANS:
            break
    return None
