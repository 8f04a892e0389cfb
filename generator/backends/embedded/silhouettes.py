"""What the catalogue's shapes look like in outline, for telling which word fits a region."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import cv2
import numpy as np
from jaxtyping import Bool, Float

from ...catalogue import build
from ...geometry import rotation_z, view_rotation
from ...render.raster import rasterise
from ...scene import View

GRID = 48
"""Side of the square grid that outlines are compared on."""

_YAWS = 16


@dataclass(frozen=True, eq=False)
class Silhouette:
    """An outline on a grid, its longer side filling it, and its size and mean colour.

    ``size`` is the width and height in the picture, in metres at the thing's distance. ``color``
    is in CIELAB.
    """

    shape: Bool[np.ndarray, "g g"]
    size: Float[np.ndarray, "2"]
    color: Float[np.ndarray, "3"]


def overlap(a: Bool[np.ndarray, "g g"], b: Bool[np.ndarray, "g g"]) -> float:
    """Return the intersection over union of two grids."""
    return float((a & b).sum() / max((a | b).sum(), 1))


@cache
def silhouettes(key: str, elevation: int, variants: int) -> tuple[Silhouette, ...]:
    """Return the outlines of a category's variants, turned around, seen from ``elevation`` degrees.

    The same arguments give the same outlines; they are kept.
    """
    turn = view_rotation(View(0.0, float(np.deg2rad(elevation)), 0.6))
    found = []
    for seed in range(variants):
        model = build(key, seed)
        vertices = model.mesh.vertices * model.size
        color = _mean_color(np.asarray(model.mesh.texture))
        square = abs(model.size[0] - model.size[1]) < 0.03 * model.size[0]
        for k in range(3 if square else _YAWS):
            yaw = 2 * np.pi * k / _YAWS
            seen = (vertices @ rotation_z(yaw).T @ turn.T)[:, :2]
            found.append(_outline(seen, np.asarray(model.mesh.faces), color))
    return tuple(found)


def _outline(
    points: Float[np.ndarray, "n 2"], faces: np.ndarray, color: Float[np.ndarray, "3"]
) -> Silhouette:
    low, high = points.min(0), points.max(0)
    size = high - low
    scaled = (points - (low + high) / 2) * (GRID / max(float(size.max()), 1e-6)) + GRID / 2
    corners = np.column_stack([scaled, np.ones(len(scaled))])[faces]
    owner, _, _ = rasterise(corners, GRID, GRID)
    shape = (owner >= 0).reshape(GRID, GRID)
    for array in (shape, size, color):  # kept, so nobody may write to them
        array.flags.writeable = False
    return Silhouette(shape, size, color)


def _mean_color(texture: np.ndarray) -> Float[np.ndarray, "3"]:
    mean = texture.reshape(-1, 3).mean(0).astype(np.float32)[None, None] / 255.0
    return np.asarray(cv2.cvtColor(mean, cv2.COLOR_RGB2LAB), float)[0, 0]
