"""Height fields: the heights at which an object rests on or in a support, for all positions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from ..geometry import rotation_z
from ..scene import Model, Placement

_CELLS = 52  # number of cells along the longer side of the support
_FINEST = 0.0025  # side of a cell, metres
_DENSITY = 1.6  # surface samples per side of a cell


@dataclass(frozen=True, eq=False)
class HeightField:
    """The highest surface in each cell of a grid over the world's x and y axes.

    Attributes:
        origin: centre of the first cell, metres.
        step: side of a cell, metres.
        top: heights, metres; -inf in empty cells. The first axis is x.
    """

    origin: Float[np.ndarray, "2"]
    step: float
    top: Float[np.ndarray, "nx ny"]

    def with_thing(self, model: Model, placement: Placement) -> HeightField:
        """Return the field with another object added."""
        points = samples(model, placement, self.step)
        cells = np.round((points[:, :2] - self.origin) / self.step).astype(int)
        inside = ((cells >= 0) & (cells < self.top.shape)).all(1)
        top = self.top.copy()
        np.maximum.at(top, tuple(cells[inside].T), points[inside, 2])
        return HeightField(self.origin, self.step, top)

    def resting(
        self, model: Model, yaw: float
    ) -> tuple[Float[np.ndarray, "nx ny"], Float[np.ndarray, "nx ny"]]:
        """Return, for each cell, the height of an object's centre if the object rests on that cell.

        The second array is the fraction of the cells under the object that are empty. If all of
        them are empty, the height is -inf.
        """
        start = Placement(model.name, yaw, np.zeros(3), model.size)
        points = samples(model, start, self.step)
        cells = np.round(points[:, :2] / self.step).astype(int)
        low = cells.min(0)
        under = np.full(cells.max(0) - low + 1, np.inf)
        np.minimum.at(under, tuple((cells - low).T), points[:, 2])
        known = np.argwhere(np.isfinite(under))
        pad = np.abs(np.concatenate([low, cells.max(0)])).max() + 1
        padded = np.pad(self.top, pad, constant_values=-np.inf)
        nx, ny = self.top.shape
        height = np.full((nx, ny), -np.inf)
        empty = np.zeros((nx, ny))
        for cell in known:
            dx, dy = cell + low + pad
            below = padded[dx : dx + nx, dy : dy + ny]
            np.maximum(height, below - under[tuple(cell)], out=height)
            empty += np.isneginf(below)
        return height, empty / max(len(known), 1)

    def place(self, cell: tuple[int, int]) -> Float[np.ndarray, "2"]:
        """Return the x and y of a cell's centre, in metres."""
        return self.origin + self.step * np.asarray(cell, float)


def field_of(model: Model, placement: Placement) -> HeightField:
    """Return the height field of an object at its placement."""
    corners = model.mesh.vertices * placement.scale @ rotation_z(placement.yaw).T
    low = corners[:, :2].min(0) + placement.translation[:2]
    high = corners[:, :2].max(0) + placement.translation[:2]
    step = max(float((high - low).max()) / _CELLS, _FINEST)
    shape = np.ceil((high - low) / step).astype(int) + 1
    empty = HeightField(low, step, np.full(shape, -np.inf))
    return empty.with_thing(model, placement)


def samples(model: Model, placement: Placement, step: float) -> Float[np.ndarray, "n 3"]:
    """Sample an object's surface densely enough that each cell it covers has at least one point."""
    vertices = np.asarray(model.mesh.vertices, float) * placement.scale
    vertices = vertices @ rotation_z(placement.yaw).T + placement.translation
    corners = vertices[model.mesh.faces]
    flat = corners[..., :2]
    longest = np.max([np.hypot(*(flat[:, k] - flat[:, (k + 1) % 3]).T) for k in range(3)], axis=0)
    counts = np.clip(np.ceil(longest / step * _DENSITY), 1, 160).astype(int)
    found = [vertices]
    for count in np.unique(counts):
        if count == 1:
            continue
        weights = np.array(
            [(i, j, count - i - j) for i in range(count + 1) for j in range(count + 1 - i)]
        ) / count  # fmt: skip
        found.append(np.einsum("wk,tkd->twd", weights, corners[counts == count]).reshape(-1, 3))
    return np.concatenate(found)
