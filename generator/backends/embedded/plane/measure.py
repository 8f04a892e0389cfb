"""Size of an object from its mask and the tabletop's plane."""

from __future__ import annotations

from functools import lru_cache

import cv2
import numpy as np
from jaxtyping import Bool, Float

from tabletop_objects import CATEGORIES, build

from ....geometry import hull_points, mask_box, rotation_z
from ....scene import Instance
from .plane import TablePlane

_TURNS = 24
_HAND = 0.15  # initial size of an object in metres
_ROUNDS = 3  # number of size corrections, since larger objects are closer
_THINNEST = 0.003  # metres


def _rounded_box() -> Float[np.ndarray, "32 3"]:
    """Return the outer points of an upright unit box with cut corners that stands on z = 0."""
    turn = np.arange(16) * np.pi / 8
    ring = np.clip(0.6 * np.column_stack([np.cos(turn), np.sin(turn)]), -0.5, 0.5)
    return np.vstack([np.column_stack([ring, np.full(16, z)]) for z in (0.0, 1.0)])


_ROUNDED = _rounded_box()


def measured_extent(
    mask: Bool[np.ndarray, "h w"], plane: TablePlane
) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "2"]]:
    """Return an object's extent (along world x, y, z) and the centre of its base in metres.

    The mask is explained as an upright box: its width is x, twice the depth of its lower outline on
    the plane is y, and z is the part of its height that the depth does not explain.
    """
    x0, y0, x1, y1 = mask_box(mask)
    camera = plane.camera
    foot = np.array([(x0 + x1) / 2, y1])
    near = camera.on_plane(foot[None], 0.0)[0]
    distance = float(camera.to_camera(near[None])[0, 2])
    metre = distance / camera.focal
    width = (x1 - x0) * metre
    elevation = max(plane.elevation_at(mask_box(mask)), 0.05)
    tall = (y1 - y0) * metre
    filled = float(mask.sum() / max((x1 - x0) * (y1 - y0), 1))
    depth = float(np.clip(_outline_depth(mask, plane), 0.15 * width, width * 1.2))
    height = (tall - depth * np.sin(elevation)) / np.cos(elevation)
    if height < 0.08 * width:
        height = 0.08 * width * (0.5 + filled)
        depth = max((tall - height * np.cos(elevation)) / np.sin(elevation), 0.02)
    middle = near[:2] + np.array([0.0, depth / 2])
    return np.array([max(width, 0.005), max(depth, 0.005), max(height, 0.004)]), middle


def _outline_depth(mask: Bool[np.ndarray, "h w"], plane: TablePlane) -> float:
    """Return twice the front-to-back length of a mask's lower outline on the plane, in metres."""
    columns = np.flatnonzero(mask.any(0))
    lowest = (mask.shape[0] - mask[::-1, columns].argmax(0)).astype(float)
    near = lowest.max() - lowest < 0.6 * np.ptp(np.flatnonzero(mask.any(1))) + 1
    outline = np.column_stack([columns + 0.5, lowest])[near].astype(np.float32)
    away = plane.to_table(cv2.convexHull(outline)[:, 0].astype(float))[:, 1]
    return 2.0 * float(np.nanmax(away) - np.nanmin(away))


def whole_box(instance: Instance) -> Float[np.ndarray, "4"]:
    """Return the pixel box of the whole object, from its completed crop if it was occluded."""
    own = np.asarray(instance.box, float)
    alpha = instance.crop[..., 3] > 127
    if not instance.occluded or not alpha.any():
        return own
    x0, y0, x1, y1 = instance.crop_box
    shape = np.array([alpha.shape[1], alpha.shape[0]] * 2)
    box = mask_box(alpha) / shape * np.array([x1 - x0, y1 - y0] * 2) + [x0, y0, x0, y0]
    return np.concatenate([np.minimum(box[:2], own[:2]), np.maximum(box[2:], own[2:])])


@lru_cache(maxsize=256)
def usual_solid(key: str) -> Float[np.ndarray, "n 3"]:
    """Return the outer points (read-only) of a category's typical object on z = 0, in metres."""
    points = hull_points(build(key, 0).mesh.vertices.astype(float))
    solid = (points + np.array([0.0, 0.0, 0.5])) * CATEGORIES[key].size
    solid.flags.writeable = False
    return solid


def apparent_scale(
    box: Float[np.ndarray, "4"], solid: Float[np.ndarray, "n 3"], plane: TablePlane
) -> tuple[float, float]:
    """Return an object's apparent size relative to its usual size, and its shape difference.

    ``solid`` are points of the object at its usual size in metres, upright on z = 0. The object is
    placed on the table at the foot of the pixel ``box``, with the yaw that gives its own pixel box
    the most similar aspect ratio. The shape difference is the difference between the logarithms of
    the two aspect ratios (width over height).
    """
    near = plane.camera.on_plane(np.array([[(box[0] + box[2]) / 2, box[3]]]), 0.0)[0]
    best = (1.0, np.inf)
    for yaw in np.arange(_TURNS) * 2 * np.pi / _TURNS:
        turned = solid @ rotation_z(yaw).T
        turned[:, :2] += near[:2] - [np.mean([turned[:, 0].min(), turned[:, 0].max()]),
                                     turned[:, 1].min()]  # fmt: skip
        wide, tall = np.log((box[2:] - box[:2]) / np.ptp(plane.camera.project(turned), axis=0))
        if abs(wide - tall) < best[1]:
            best = (float(np.exp((wide + tall) / 2)), float(abs(wide - tall)))
    return best


def sized_extent(
    box: Float[np.ndarray, "4"], proportions: Float[np.ndarray, "3"], plane: TablePlane
) -> Float[np.ndarray, "3"]:
    """Return the extent in metres of an object whose projection fills the pixel ``box``.

    The object stands on the table with the yaw of :func:`apparent_scale`; ``proportions`` are those
    of its length, width and height.
    """
    extent = np.asarray(proportions) * (_HAND / np.max(proportions))
    for _ in range(_ROUNDS):
        scale, _ = apparent_scale(box, _ROUNDED * extent, plane)
        extent = extent * np.clip(scale, 0.1, 10.0)
    return np.maximum(extent, _THINNEST)
