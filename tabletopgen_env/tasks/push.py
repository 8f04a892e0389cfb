"""Push: slide one object along the table to a marked spot, with the fingers closed.

The gripper stays closed regardless of the action. Targets stand on the table alone and neither
topple nor roll easily; they need not fit into the hand. Long objects are pushed sideways only,
since they would turn if pushed at an end. ``reset`` options: ``target``, the name of an object;
``goal``, a point (x, y) on the table in the world frame. Goal: `Pushed`.
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
"""Minimum and maximum distance of a push, in metres."""

HEAVIEST = 1.5
"""Maximum mass of a target, in kg."""

SLENDER = 1.2
"""Maximum height of a target as a multiple of its smallest width: more slender objects topple."""

LEAST_GRIP = 0.5
"""Lowest friction coefficient with the table at which a target must slide without toppling."""

LONGEST = 2.0
"""Maximum length of a target along the push, as a multiple of its breadth."""

_TRIES = 200
_PLANS = 25  # maximum number of strokes planned in search of one that the arm can perform


class Push(Task):
    """Push one object to a spot; see the module docstring."""

    weights = MappingProxyType({"reach": 0.20, "place": 0.50, "success": 0.30})
    closed = True
    needs = (LOW, LOW)

    def sample(
        self, world: World, rng: np.random.Generator, target: str | None = None, goal: Choice = None
    ) -> Episode:
        """Draw a target and a spot, or use the given ones; see ``Task.sample``."""
        if isinstance(goal, str) and goal != SPOT:
            raise InputError(f"The goal of Push must be a point (x, y) on the table, got {goal!r}.")

        def make(obj: Object) -> Episode | None:
            named = goal is not None and not isinstance(goal, str)
            xy = given_point(world, goal) if named else _end(world, obj, rng)  # type: ignore[arg-type]
            if xy is None:
                return None
            spot = np.array([*xy, world.scene.table.height])
            up = world.rotation(obj.name)[2]
            return episode(world, (Pushed(obj.name, spot, rest_height(world, obj.name), up),))

        lacks = "no free path for a push"
        return draw_episode(world, rng, target, slidable(world), make, lacks, held=False)


def slidable(world: World) -> Reasons:
    """Return why each object cannot be pushed, or None if it can."""
    return {o.name: _fixed_reason(world, o) for o in world.scene.objects}


def _fixed_reason(world: World, obj: Object) -> str | None:
    if not on_table(obj):
        return f"the object stands on {obj.placement.on}"
    if obj.mass > HEAVIEST:
        return f"the mass of {obj.mass:.3g} kg exceeds {HEAVIEST} kg"
    if resting_height(obj) > SLENDER * grasp_width(obj) or tips(obj):
        return "the object would topple or roll"
    if resting_height(obj) < 0.01:
        return "the object is too flat for the fingers"
    return blocking_reason(world, obj)


def tips(obj: Object) -> bool:
    """Return whether an object topples or rolls before it slides.

    If an object is pushed at the height of its centre of mass, it topples at a friction coefficient
    of tan(a), where a is the lean from which it falls by itself; until then its centre of mass
    rises by a factor of 1 / cos(a).
    """
    turned = quaternion_matrix(obj.pose.quaternion).T
    points = (collision_points(obj) - obj.com) @ turned
    leans, bearings = np.deg2rad(np.arange(0, 61, 5)), np.deg2rad(np.arange(0, 360, 15))
    along = points[:, :2] @ np.stack([np.cos(bearings), np.sin(bearings)])
    down = [along * np.sin(lean) - points[:, 2:] * np.cos(lean) for lean in leans]
    heights = np.max(down, axis=1)  # heights of the centre of mass, by lean and bearing
    rise = float((heights.max(0) / heights[0]).min())
    return rise < float(np.hypot(1.0, max(LEAST_GRIP, obj.friction)))


def _end(world: World, obj: Object, rng: np.random.Generator) -> Float[np.ndarray, "2"] | None:
    """Draw the end of a free push path with room for the hand at its start, or return None."""
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
