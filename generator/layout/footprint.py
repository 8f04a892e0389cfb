"""Footprints: outlines seen from above, stored so that gaps between them are fast to compute."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from jaxtyping import Float

from ..geometry import convex_outline, rotation_z
from ..scene import Model

COUNT = 48
"""Number of directions along which a footprint's extent is stored."""

_ANGLES = 2 * np.pi * np.arange(COUNT) / COUNT
DIRECTIONS: Float[np.ndarray, "d 2"] = np.column_stack([np.cos(_ANGLES), np.sin(_ANGLES)])
"""Unit vectors, counter-clockwise from +x."""
DIRECTIONS.setflags(write=False)

RIGHT, BACK, LEFT, FRONT = 0, COUNT // 4, COUNT // 2, 3 * COUNT // 4
"""Indices of +x, +y, -x and -y among the directions."""


@dataclass(frozen=True, eq=False)
class Footprint:
    """An object's convex outline seen from above at one yaw, in metres relative to its centre.

    ``reach[k]`` is its extent along direction k; ``outline`` is its convex hull.
    """

    outline: Float[np.ndarray, "k 2"]
    reach: Float[np.ndarray, "d"]
    height: float
    yaw: float = 0.0

    @property
    def half(self) -> Float[np.ndarray, "2"]:
        """Half extents along x and y."""
        return (self.reach[[RIGHT, BACK]] + self.reach[[LEFT, FRONT]]) / 2

    @property
    def area(self) -> float:
        """Area of the convex hull, in square metres."""
        x, y = self.outline.T
        return float(abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2)

    def along(self, normals: Float[np.ndarray, "e 2"]) -> Float[np.ndarray, "e"]:
        """Return the exact extent along each of ``normals``."""
        return (self.outline @ normals.T).max(0)

    def covering(self, other: Footprint) -> Footprint:
        """Return the combined footprint of this object and another one centred on it."""
        outline = convex_outline(np.concatenate([self.outline, other.outline]))
        return Footprint(
            outline, np.maximum(self.reach, other.reach), self.height + other.height, self.yaw
        )


@lru_cache(maxsize=64)
def footprint(model: Model, yaw: float) -> Footprint:
    """Return the footprint of a model at its own size, rotated by ``yaw``.

    It is cached because every layout attempt needs the footprints of the same objects.
    """
    points = model.mesh.vertices[:, :2] * model.size[:2] @ rotation_z(yaw)[:2, :2].T
    outline = convex_outline(points)
    reach = (outline @ DIRECTIONS.T).max(0)
    return Footprint(outline, reach, float(model.size[2]), yaw)


def gaps(
    own: Footprint, centers: Float[np.ndarray, "m 2"], other: Footprint, at: Float[np.ndarray, "2"]
) -> Float[np.ndarray, "m"]:
    """Return a lower bound of the gap to ``other`` for each centre, negative if the two overlap."""
    blocked = own.reach + np.roll(other.reach, COUNT // 2)
    return ((at - centers) @ DIRECTIONS.T - blocked).max(1)


def margins(
    own: Footprint, centers: Float[np.ndarray, "m 2"], outline: Float[np.ndarray, "k 2"]
) -> Float[np.ndarray, "m"]:
    """Return how far each centre is inside a convex, counter-clockwise outline."""
    normals, limits = _sides(outline)
    return (limits - own.along(normals) - centers @ normals.T).min(1)


def rim_distance(
    points: Float[np.ndarray, "m 2"], way: Float[np.ndarray, "2"], outline: Float[np.ndarray, "k 2"]
) -> Float[np.ndarray, "m"]:
    """Return the distance from each point to an outline's rim in the direction of a unit vector.

    The outline is convex and counter-clockwise, and contains the points.
    """
    normals, limits = _sides(outline)
    toward = normals @ way
    ahead = toward > 1e-9
    return ((limits - points @ normals.T)[:, ahead] / toward[ahead]).min(1)


def _sides(
    outline: Float[np.ndarray, "k 2"],
) -> tuple[Float[np.ndarray, "k 2"], Float[np.ndarray, "k"]]:
    """Return the outward normals of an outline's edges and their distances from the origin."""
    edges = np.roll(outline, -1, axis=0) - outline
    normals = np.column_stack([edges[:, 1], -edges[:, 0]])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return normals, (outline * normals).sum(1)
