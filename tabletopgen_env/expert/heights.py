"""Scenes as height maps, all that a gripper from above can hit, and objects as voxels."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float

from generator.scene import ConvexPart

from ..affordance import part_span, top_surface

if TYPE_CHECKING:
    from ..world import World


@dataclass(frozen=True, eq=False)
class HeightMap:
    """Heights of the highest surface over a grid, world frame, -inf where nothing is.

    ``origin`` is the centre of cell (0, 0), ``cell`` the spacing (metres); ``heights[i, j]`` is at
    ``origin + cell * (i, j)``.
    """

    origin: Float[np.ndarray, "2"]
    cell: float
    heights: Float[np.ndarray, "nx ny"]

    def at(self, points: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n"]:
        """Return the height at the cell nearest to each point, -inf outside the grid."""
        index = np.rint((points - self.origin) / self.cell).astype(int)
        size = np.array(self.heights.shape)
        inside = ((index >= 0) & (index < size)).all(-1)
        i, j = np.moveaxis(np.clip(index, 0, size - 1), -1, 0)
        return np.where(inside, self.heights[i, j], -np.inf)


def moved(
    parts: Iterable[ConvexPart],
    position: Float[np.ndarray, "3"],
    rotation: Float[np.ndarray, "3 3"],
) -> tuple[ConvexPart, ...]:
    """Return convex parts carried from the body frame into the world."""
    return tuple(ConvexPart(part.vertices @ rotation.T + position) for part in parts)


def height_map(
    parts: Iterable[ConvexPart],
    low: Float[np.ndarray, "2"],
    high: Float[np.ndarray, "2"],
    cell: float,
) -> HeightMap:
    """Scan world-frame ``parts`` from above between the corners ``low`` and ``high``."""
    axes = [np.arange(low[k], high[k] + cell, cell) for k in (0, 1)]
    heights = np.full((len(axes[0]), len(axes[1])), -np.inf)
    for part in parts:
        first, last = part.bounds[:, :2]
        under = [  # the cells within the part's bounds
            slice(np.searchsorted(axis, first[k]), np.searchsorted(axis, last[k], "right"))
            for k, axis in enumerate(axes)
        ]
        xs, ys = (axis[cells] for axis, cells in zip(axes, under, strict=True))
        window = heights[under[0], under[1]]
        points = np.stack(np.meshgrid(xs, ys, indexing="ij"), -1).reshape(-1, 2)
        np.maximum(window, top_surface((part,), points).reshape(window.shape), out=window)
    return HeightMap(np.array([axis[0] for axis in axes]), cell, heights)


def surroundings(
    world: World,
    target: str,
    low: Float[np.ndarray, "2"],
    high: Float[np.ndarray, "2"],
    cell: float,
) -> HeightMap:
    """Return the height map of every object but ``target``, where they are now."""
    parts = [
        part
        for obj in world.scene.objects
        if obj.name != target
        for part in moved(obj.parts, world.position(obj.name), world.rotation(obj.name))
    ]
    return height_map(parts, low, high, cell)


@dataclass(frozen=True, eq=False)
class Solid:
    """An object as voxels, world frame.

    ``filled[i, j, k]`` is at (``origin`` + ``cell`` * (i, j), ``levels[k]``), metres; ``levels``
    rise by equal steps.
    """

    origin: Float[np.ndarray, "2"]
    cell: float
    levels: Float[np.ndarray, "nz"]
    filled: Bool[np.ndarray, "nx ny nz"]

    def at(self, points: Float[np.ndarray, "*n 2"]) -> Bool[np.ndarray, "*n nz"]:
        """Return the column at the cell nearest to each point, empty outside the grid."""
        index = np.rint((points - self.origin) / self.cell).astype(int)
        size = np.array(self.filled.shape[:2])
        inside = ((index >= 0) & (index < size)).all(-1)
        i, j = np.moveaxis(np.clip(index, 0, size - 1), -1, 0)
        return self.filled[i, j] & np.expand_dims(inside, -1)


def solid(parts: tuple[ConvexPart, ...], cell: float, rise: float) -> Solid:
    """Return world-frame ``parts`` as voxels of ``cell`` by ``cell`` by ``rise`` metres."""
    bounds = np.stack([part.bounds for part in parts])
    first, last = bounds[:, 0].min(0), bounds[:, 1].max(0)
    xs, ys = (np.arange(first[k] - cell, last[k] + 2 * cell, cell) for k in (0, 1))
    levels = np.arange(first[2] + rise / 2, last[2], rise)
    points = np.stack(np.meshgrid(xs, ys, indexing="ij"), -1).reshape(-1, 2)
    filled = np.zeros((len(points), len(levels)), bool)
    for part in parts:
        hit, ground, ceiling = part_span(part, points)
        # What is thinner than a voxel fills the one in whose middle it lies.
        spare = np.maximum(rise - (ceiling - ground), 0.0)[:, None] / 2
        low, high = ground[:, None] - spare, ceiling[:, None] + spare
        filled[hit] |= (levels >= low) & (levels <= high)
    return Solid(np.array([xs[0], ys[0]]), cell, levels, filled.reshape(len(xs), len(ys), -1))
