"""The height at which the tool passes above all objects on its path."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from ..world.world import World

ROOM = 0.1
"""Width of the corridor on either side of the path, in metres: half a hand."""

CLEAR = 0.035
"""Clearance above obstacles, in metres."""


def clear_height(
    world: World,
    held: str | None,
    start: Float[np.ndarray, "3"],
    end: Float[np.ndarray, "3"],
    broad: float = ROOM,
) -> float:
    """Return the height (world, m) that clears all objects between ``start`` and ``end``.

    The hand clears the highest point of every object except ``held`` whose upright bounding
    cylinder comes within ``broad`` of the straight path.
    """
    height = world.scene.table.height
    way = end[:2] - start[:2]
    length = float(way @ way)
    for obj in world.scene.objects:
        if obj.name == held:
            continue
        middle = world.position(obj.name)
        reach = np.abs(world.rotation(obj.name)) @ obj.scale / 2
        along = np.clip((middle[:2] - start[:2]) @ way / length, 0, 1) if length > 1e-9 else 0.0
        aside = float(np.linalg.norm(start[:2] + along * way - middle[:2]))
        if aside < broad + float(reach[:2].max()):
            height = max(height, float(middle[2] + reach[2]))
    return height + CLEAR
