"""Free spots on a table."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from jaxtyping import Float

from generator.geometry import inside_margin

from ..robot.mount import clear_of_tall
from .world import World

FREE_MARGIN = 0.015
"""Margin around an object on a free spot, in metres."""

LEAST_WAY = 0.12
"""Minimum distance from an object's position to a free spot drawn for it, in metres."""

Fits = Callable[[Float[np.ndarray, "2"]], bool]
"""A function that returns whether a point (x, y) on the table is acceptable."""

_TRIES, _ASKED = 400, 40


def free_spot(
    world: World, name: str, rng: np.random.Generator, fits: Fits | None = None
) -> Float[np.ndarray, "2"] | None:
    """Draw a reachable point (x, y) on the table where an object has clearance from all others.

    The point is at least ``LEAST_WAY`` from the object's position, and no tall object between it
    and the base obstructs the forearm. ``fits`` may reject points. The result is None if 400 draws
    yield no point, or if ``fits`` rejects the first 40.
    """
    table, position = world.scene.table, world.scene.object(name).pose.position
    radius = float(np.linalg.norm(world.footprints[name] - position[:2], axis=1).max())
    points = rng.uniform(table.outline.min(0), table.outline.max(0), (_TRIES, 2))
    free = inside_margin(points, table.outline) >= min(radius, 0.1) + FREE_MARGIN
    free &= np.linalg.norm(points - position[:2], axis=1) >= LEAST_WAY
    free &= world.mount.reaches(np.column_stack([points, np.full(_TRIES, table.height)]))
    for other, outline in world.footprints.items():
        if other != name:
            free &= inside_margin(points, outline) <= -(radius + FREE_MARGIN)
    found = points[free]
    found = found[clear_of_tall(world.scene, world.mount, name, found)]
    return next((point for point in found[:_ASKED] if fits is None or fits(point)), None)
