"""Push: slide one object along the table to a marked spot, with the fingers closed.

The gripper stays closed whatever the action says. Pushed is what stands on the table alone and
neither topples nor rolls easily; it need not fit into the hand. Ways are drawn across long things,
which turn aside when they are pushed at an end. ``reset`` options: ``target`` an object's name;
``goal`` a point (x, y) of the table in the world frame. Goal: `Pushed`.
"""

from __future__ import annotations

from types import MappingProxyType

import numpy as np
from jaxtyping import Float

from generator.errors import InputError
from generator.geometry import inside_margin, quaternion_matrix
from generator.scene import Object

from ..affordance import collision_points, grasp_width, resting_height
from ..expert.planning.strokes import beside, plan_stroke
from ..goals.goal import SPOT, Pushed
from ..goals.needs import LOW
from ..world.world import World
from .candidates import Reasons, blocking_reason, draw_episode, given_point, on_table, rest_height
from .task import Choice, Episode, Task, episode

WAY = (0.08, 0.25)
"""Shortest and longest way to push, metres."""

HEAVIEST = 1.5
"""Heaviest object to push, kg."""

SLENDER = 1.2
"""Tallest thing to push, in multiples of its smallest width: slenderer ones topple."""

LEAST_GRIP = 0.5
"""Friction on the table, at least, that a push at the centre of mass's height has to overcome."""

LONGEST = 2.0
"""Longest thing to push lengthwise, in its own breadths."""

_TRIES = 200
_PLANS = 25  # strokes planned at most to find one that the arm can make


class Push(Task):
    """Slide one object to a spot; see the module's page."""

    weights = MappingProxyType({"reach": 0.20, "place": 0.50, "success": 0.30})
    closed = True
    needs = (LOW, LOW)

    def sample(
        self, world: World, rng: np.random.Generator, target: str | None = None, goal: Choice = None
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
        return draw_episode(world, rng, target, slidable(world), make, lacks, held=False)


def slidable(world: World) -> Reasons:
    """Return why each object cannot be pushed, None where it can."""
    return {o.name: _fixed_reason(world, o) for o in world.scene.objects}


def _fixed_reason(world: World, obj: Object) -> str | None:
    if not on_table(obj):
        return f"it stands on {obj.placement.on}"
    if obj.mass > HEAVIEST:
        return f"{obj.mass:.3g} kg is heavier than {HEAVIEST} kg"
    if resting_height(obj) > SLENDER * grasp_width(obj) or tips(obj):
        return "it would topple or roll"
    if resting_height(obj) < 0.01:
        return "too flat for the fingers"
    return blocking_reason(world, obj)


def tips(obj: Object) -> bool:
    """Return whether an object goes over, or rolls, before it slides.

    Pushed at the height of its centre of mass it goes over at the friction tan(a), where it has to
    lean by the angle a, the centre of mass rising by 1 / cos(a), until it falls by itself.
    """
    turned = quaternion_matrix(obj.pose.quaternion).T
    points = (collision_points(obj) - obj.com) @ turned
    leans, bearings = np.deg2rad(np.arange(0, 61, 5)), np.deg2rad(np.arange(0, 360, 15))
    along = points[:, :2] @ np.stack([np.cos(bearings), np.sin(bearings)])
    down = [along * np.sin(lean) - points[:, 2:] * np.cos(lean) for lean in leans]
    heights = np.max(down, axis=1)  # of the centre of mass, by lean and bearing
    rise = float((heights.max(0) / heights[0]).min())
    return rise < float(np.hypot(1.0, max(LEAST_GRIP, obj.friction)))


def _end(world: World, obj: Object, rng: np.random.Generator) -> Float[np.ndarray, "2"] | None:
    """Draw where to push an object: along a way free of others, with room for the hand behind."""
    begin, table = obj.pose.position[:2], world.scene.table
    outline, others = world.footprints[obj.name], beside(world, obj.name)
    radius = float(np.linalg.norm(outline - begin, axis=1).max())
    plans = 0
    for _ in range(_TRIES):
        angle, way = rng.uniform(0, 2 * np.pi), rng.uniform(*WAY)
        ahead = np.array([np.cos(angle), np.sin(angle)])
        line = begin + np.linspace(0.0, way, 8)[:, None] * ahead
        across = np.array([-ahead[1], ahead[0]])
        if np.ptp(outline @ ahead) > LONGEST * np.ptp(outline @ across):
            continue
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
