"""Shadows cast by the sun: an orthographic depth map of the items, sampled for soft edges."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float, Int

from .scanlines import nearest
from .shading import Light

_TAPS = tuple(
    (r * np.cos(t), r * np.sin(t))
    for r, t in [(0.0, 0.0)]
    + [(0.5, np.pi / 2 * (k + 0.25)) for k in range(4)]
    + [(1.0, np.pi / 3 * k) for k in range(6)]
)  # sample positions of a soft shadow, in units of its softness

_TILE = 4  # number of map cells along the side of a tile
_SIZE = 1024  # number of map cells along the side of the map
_RIM = 4  # number of empty map cells at each end of a side


class Shadow:
    """Depth map of shadow-casting surfaces, seen from the light.

    The map is padded with empty cells. Each tile stores the maximum and minimum of all cells within
    sampling range of its points. Samples are needed only for points between the two.
    """

    def __init__(
        self,
        points: Float[np.ndarray, "n 3"],
        surfaces: Sequence[tuple[Float[np.ndarray, "_ 3"], Int[np.ndarray, "_ 3"]]],
        light: Light,
    ) -> None:
        """Build a map around ``points``; ``surfaces`` are pairs (vertices, faces), in metres."""
        forward = -light.direction
        side = np.cross(forward, [0.0, 1.0, 0.0])
        side /= np.linalg.norm(side)
        self._axes = np.stack([side, np.cross(forward, side), forward])
        turned = points @ self._axes.T
        self._low, high = turned.min(0), turned.max(0)
        self._scale = (_SIZE - 2 * _RIM) / max(float((high - self._low)[:2].max()), 1e-6)
        self._top = float(high[2]) + 1.0
        self._softness = light.softness
        self._reach = max(1.0, light.softness * self._scale)
        blocks = [np.zeros((0, 3, 3))]
        for vertices, faces in surfaces:
            x, y, far = self._on_map(vertices)
            blocks.append(np.stack([x, y, self._top - far], 1)[faces])
        corners = np.concatenate(blocks)
        self._fill(nearest(corners, _SIZE, _SIZE)[1].reshape(_SIZE, _SIZE))

    def _fill(self, depth_map: Float[np.ndarray, "h w"]) -> None:
        """Store the map with an empty border, and the extremes of each tile and its neighbours."""
        around = -(-(int(np.ceil(self._reach)) + 1) // _TILE)  # reach of a sample, in tiles
        self._border = _TILE * (2 * around + 2)
        padded = np.pad(depth_map, self._border, constant_values=-np.inf)
        self._width = len(padded)
        self._map = padded.ravel()
        self._tiles = self._width // _TILE
        border = self._border // _TILE
        self._highest = _extremes(depth_map, border, around, np.maximum).ravel()
        self._lowest = _extremes(depth_map, border, around, np.minimum).ravel()

    def _on_map(self, points: Float[np.ndarray, "p 3"]) -> tuple[Float[np.ndarray, "p"], ...]:
        """Return points' columns and rows on the map, and their depths along the rays in metres."""
        turned = points @ self._axes.T
        x, y = ((turned[:, k] - self._low[k]) * self._scale + _RIM for k in range(2))
        return x, y, turned[:, 2]

    def lit_share(
        self, points: Float[np.ndarray, "p 3"], normals: Float[np.ndarray, "p 3"]
    ) -> Float[np.ndarray, "p"]:
        """Return the fraction in [0, 1] of sunlight at each point, which is 1 outside the map."""
        x, y, far = self._on_map(points)
        cosine = np.clip(np.abs(normals @ self._axes[2]), 0.15, 1)
        bias = 0.002 + self._softness * np.sqrt(1 - cosine**2) / cosine * 1.5
        closeness = self._top - far + bias  # grows with the slope to prevent self-shadowing
        tile = self._tile_along(y) * self._tiles + self._tile_along(x)
        share = (closeness >= np.take(self._highest, tile)).astype(float)
        unsure = np.flatnonzero((share == 0) & (closeness >= np.take(self._lowest, tile)))
        share[unsure] = self._sample(x[unsure], y[unsure], closeness[unsure])
        return share

    def _tile_along(self, x: Float[np.ndarray, "p"]) -> Int[np.ndarray, "p"]:
        """Return the column (or row) of the tile that contains, or is nearest to, a coordinate."""
        cell = np.clip(x + self._border, 0, self._width - 1).astype(np.int64)
        return cell // _TILE

    def _sample(
        self,
        x: Float[np.ndarray, "p"],
        y: Float[np.ndarray, "p"],
        closeness: Float[np.ndarray, "p"],
    ) -> Float[np.ndarray, "p"]:
        """Return the lit fraction of the samples around each point, given in map coordinates."""
        total = np.zeros(len(x), np.int32)
        first = self._border * (self._width + 1)
        for dx, dy in _TAPS:
            column = (x + dx * self._reach).astype(np.int64)
            row = (y + dy * self._reach).astype(np.int64)
            total += closeness >= np.take(self._map, row * self._width + column + first)
        return total / len(_TAPS)


def _extremes(
    values: Float[np.ndarray, "h w"], border: int, around: int, extreme: np.ufunc
) -> Float[np.ndarray, "th tw"]:
    """Return the extreme value over each tile and the ``around`` tiles on every side of it.

    The map is empty outside ``values``, also in the ``border`` tiles of the result on every side.
    """
    window = 2 * around + 1
    for axis in (0, 1):
        values = np.moveaxis(values, axis, 0)
        tiles = values[::_TILE]
        for k in range(1, _TILE):
            tiles = extreme(tiles, values[k::_TILE])
        margin = border + around
        values = np.pad(tiles, ((margin, margin), (0, 0)), constant_values=-np.inf)
        covered = 1  # tiles of which each entry has the extreme, doubled until they are a window
        while covered < window:
            more = min(covered, window - covered)
            values = extreme(values[:-more], values[more:])
            covered += more
        values = np.moveaxis(values, 0, axis)
    return values
