"""Height maps of scenes for a gripper that approaches from above, and voxel models of objects."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

from generator.scene import ConvexPart

from ...affordance import cells_under, part_span, scan_surface
from ...world.world import World


@dataclass(frozen=True, eq=False)
class HeightMap:
    """Heights of the highest surface over a grid, in the world frame, with -inf in empty cells.

    ``origin`` is the centre of cell (0, 0), ``cell`` the spacing (metres); ``heights[i, j]`` is at
    ``origin + cell * (i, j)``.
    """

    origin: Float[np.ndarray, "2"]
    cell: float
    heights: Float[np.ndarray, "nx ny"]

    def at(self, points: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n"]:
        """Return the height at the cell nearest to each point, or -inf outside the grid."""
        i, j = _nearest(points, self.origin, self.cell)
        nx, ny = self.heights.shape
        inside = (i >= 0) & (i < nx) & (j >= 0) & (j < ny)
        return np.where(inside, self.heights.take(np.where(inside, i * ny + j, 0)), -np.inf)


def move_parts(
    parts: Iterable[ConvexPart],
    position: Float[np.ndarray, "3"],
    rotation: Float[np.ndarray, "3 3"],
) -> tuple[ConvexPart, ...]:
    """Transform convex parts from the body frame to the world frame."""
    return tuple(ConvexPart(part.vertices @ rotation.T + position) for part in parts)


def parts_of(world: World, name: str) -> tuple[ConvexPart, ...]:
    """Return an object's convex parts at its current pose, in the world frame."""
    parts = world.scene.object(name).parts
    return world.remember(
        ("parts", name), lambda: move_parts(parts, world.position(name), world.rotation(name))
    )


def height_map(
    parts: Iterable[ConvexPart],
    low: Float[np.ndarray, "2"],
    high: Float[np.ndarray, "2"],
    cell: float,
) -> HeightMap:
    """Scan world-frame ``parts`` from above between the corners ``low`` and ``high``."""
    axes = [np.arange(low[k], high[k] + cell, cell) for k in (0, 1)]
    return HeightMap(np.array([axis[0] for axis in axes]), cell, scan_surface(parts, axes))


def surroundings(
    world: World,
    target: str,
    low: Float[np.ndarray, "2"],
    high: Float[np.ndarray, "2"],
    cell: float,
) -> HeightMap:
    """Return the height map of all objects but ``target`` at their current poses."""
    parts = [p for o in world.scene.objects if o.name != target for p in parts_of(world, o.name)]
    return height_map(parts, low, high, cell)


@dataclass(frozen=True, eq=False)
class VoxelSolid:
    """A voxel model of an object, in the world frame.

    ``filled[i, j, k]`` is at (``origin`` + ``cell`` * (i, j), ``levels[k]``), metres; ``levels``
    are equally spaced. The columns on the grid's border are empty.
    """

    origin: Float[np.ndarray, "2"]
    cell: float
    levels: Float[np.ndarray, "nz"]
    filled: Bool[np.ndarray, "nx ny nz"]

    def nearest(self, points: Float[np.ndarray, "*n 2"]) -> Int[np.ndarray, "*n"]:
        """Return the column nearest to each point as a flat index i * ny + j.

        Points outside the grid map to a column on its border, which is empty.
        """
        i, j = _nearest(points, self.origin, self.cell)
        nx, ny, _ = self.filled.shape
        return np.clip(i, 0, nx - 1) * ny + np.clip(j, 0, ny - 1)


def _nearest(
    points: Float[np.ndarray, "*n 2"], origin: Float[np.ndarray, "2"], cell: float
) -> tuple[Int[np.ndarray, "*n"] | np.int64, Int[np.ndarray, "*n"] | np.int64]:
    """Return the indices of the grid cell nearest to each point; they can be outside the grid."""
    x, y = points[..., 0], points[..., 1]
    i, j = (x - origin[0]) / cell, (y - origin[1]) / cell
    return np.rint(i).astype(int), np.rint(j).astype(int)


def solid(parts: tuple[ConvexPart, ...], cell: float, rise: float) -> VoxelSolid:
    """Convert world-frame ``parts`` to voxels of ``cell`` by ``cell`` by ``rise`` metres."""
    bounds = np.stack([part.bounds for part in parts])
    first, last = bounds[:, 0].min(0), bounds[:, 1].max(0)
    axes = [np.arange(first[k] - cell, last[k] + 2 * cell, cell) for k in (0, 1)]
    levels = np.arange(first[2] + rise / 2, last[2], rise)
    filled = np.zeros((len(axes[0]), len(axes[1]), len(levels)), bool)
    for part, cells, points in cells_under(parts, axes):
        hit, ground, ceiling = part_span(part, points)
        # A part thinner than a voxel fills the voxel at its centre.
        spare = np.maximum(rise - (ceiling - ground), 0.0)[:, None] / 2
        low, high = ground[:, None] - spare, ceiling[:, None] + spare
        window = filled[cells]
        window[np.unravel_index(hit, window.shape[:2])] |= (levels >= low) & (levels <= high)
    return VoxelSolid(np.array([axis[0] for axis in axes]), cell, levels, filled)
