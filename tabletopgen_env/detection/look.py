"""Height maps of an object and its surroundings, as seen by a depth camera above the table."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, UInt8

from generator.geometry import rotation_yaw

from ..expert.planning.heights import height_map, move_parts, surroundings

if TYPE_CHECKING:
    from ..world.world import World

CELLS, CELL, STEP = 64, 0.004, 0.002
"""Number of cells along a side of a map, and the cell size and height step in metres."""


@dataclass(frozen=True, eq=False)
class HeightView:
    """Two height maps around an object: one of the object alone, and one of everything else.

    The axes are parallel to the world's. ``heights[m, i, j]`` is map m (0 the object, 1 everything
    else) at ``center + CELL * ((i, j) - 31.5)`` (x, y, world, metres), in units of ``STEP`` above
    the table, 0 where there is nothing and at most 255. ``facing`` is the bearing of the object's x
    axis (radians), ``floor`` the table's height (metres, world).
    """

    heights: UInt8[np.ndarray, "2 64 64"]
    center: Float[np.ndarray, "2"]
    facing: float
    floor: float


def look(world: World, target: str) -> HeightView:
    """Return the height maps around an object's current position, without the robot."""
    position, rotation = world.position(target), world.rotation(target)
    low = position[:2] - CELL * (CELLS - 1) / 2
    high = low + CELL * (CELLS - 1.5)  # half a cell short: rounding must not add a cell
    own = height_map(
        move_parts(world.scene.object(target).parts, position, rotation), low, high, CELL
    )
    rest = surroundings(world, target, low, high, CELL)
    above = np.stack([own.heights, rest.heights]) - world.scene.table.height
    heights = np.rint(np.clip(above / STEP, 0.0, 255.0)).astype(np.uint8)
    return HeightView(heights, position[:2], rotation_yaw(rotation), world.scene.table.height)
