"""Where on a table things can still be put."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from generator.geometry import convex_outline, inside_margin, quaternion_matrix
from generator.scene import Object, Scene

from .affordance import collision_points
from .robot.mount import Mount

FREE_MARGIN = 0.015
"""Room left around a thing put on a free spot, metres."""

LEAST_WAY = 0.12
"""Least distance from where a thing stands to a free spot drawn for it, metres."""

_TRIES = 400


def footprint(obj: Object) -> Float[np.ndarray, "k 2"]:
    """Return the convex outline of an object seen from above where it rests, world frame."""
    turned = collision_points(obj) @ quaternion_matrix(obj.pose.quaternion).T
    return convex_outline((turned + obj.pose.position)[:, :2])


def free_spot(
    scene: Scene, obj: Object, mount: Mount, rng: np.random.Generator
) -> Float[np.ndarray, "2"] | None:
    """Draw a point (x, y) of the table where ``obj`` can stand clear of everything, in reach.

    The point keeps ``LEAST_WAY`` from where the object stands. None if 400 draws found none.
    """
    own = collision_points(obj) @ quaternion_matrix(obj.pose.quaternion).T
    radius = float(np.linalg.norm(own[:, :2], axis=1).max())
    outline = scene.table.outline
    points = rng.uniform(outline.min(0), outline.max(0), (_TRIES, 2))
    free = inside_margin(points, outline) >= min(radius, 0.1) + FREE_MARGIN
    free &= np.linalg.norm(points - obj.pose.position[:2], axis=1) >= LEAST_WAY
    on_table = np.column_stack([points, np.full(len(points), scene.table.height)])
    free &= mount.reaches(on_table)
    for other in scene.objects:
        if other.name != obj.name:
            free &= inside_margin(points, footprint(other)) <= -(radius + FREE_MARGIN)
    found = np.flatnonzero(free)
    return points[found[0]] if len(found) else None
