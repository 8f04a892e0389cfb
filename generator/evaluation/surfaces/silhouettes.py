"""Estimation of yaw and size errors from the rotation and scale that best fit an object's mask.

Each object is drawn alone from the picture's camera, as it stands and with other yaws or scales.
Pixels of other objects in the picture are ignored, so that occluded parts have no effect. Each
silhouette may be shifted onto the mask, since a wrong position does not imply a wrong yaw.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float

from ...comparison import Comparison
from ...geometry import Camera, quaternion_matrix, rotation_z
from ...meshes.pixels import mask_iou
from ...render.scanlines import rasterise
from ...scene import TABLE, Object
from .symmetry import order, yaw_error

TURNS = tuple(np.deg2rad(range(15, 360, 15)).tolist())
"""Yaws to test in radians."""

FACTORS = (0.4, 0.5, 0.6, 0.7, 0.8, 1.25, 1.4, 1.65, 2.0, 2.5)
"""Scales to test."""

_SIDE = 480  # longest side of the pictures that are compared, pixels
_MIN_PIXELS, _MIN_SHOWN = 60, 0.5
_SAME = 20.0  # degrees; yaws this close to a symmetry are not distinguished


@dataclass(frozen=True)
class SilhouetteFit:
    """A silhouette's IoU with a mask: in its own pose, at the best yaw, and at the best scale.

    ``turn`` (radians, counter-clockwise) and ``factor`` are the best of the tested values.
    """

    name: str
    iou: float
    turn: float
    turned_iou: float
    factor: float
    scaled_iou: float


def fits(compared: Comparison) -> tuple[SilhouetteFit, ...]:
    """Return the silhouette fit of each object that is sufficiently visible in the picture.

    Objects are skipped if they have no mask or one of only a few pixels, or are more than half
    occluded.
    """
    height, width = compared.segments.index.shape
    factor = min(1.0, _SIDE / max(height, width))
    rows = (np.arange(round(height * factor)) / factor).astype(int)
    columns = (np.arange(round(width * factor)) / factor).astype(int)
    index = np.asarray(compared.segments.index)[np.ix_(rows, columns)]
    segments = replace(compared.segments, index=index)
    camera = replace(compared.camera, width=index.shape[1], height=index.shape[0])
    ground = (index == 0) | segments.mask(TABLE)
    pairs = ((thing, segments.mask(thing.name)) for thing in compared.scene.objects)
    found = (_fit(thing, camera, mask, mask | ground) for thing, mask in pairs)
    return tuple(fit for fit in found if fit is not None)


def _fit(
    thing: Object, camera: Camera, mask: Bool[np.ndarray, "h w"], free: Bool[np.ndarray, "h w"]
) -> SilhouetteFit | None:
    if mask.sum() < _MIN_PIXELS:
        return None
    shape = _silhouette(thing, camera)
    if not shape.any() or (shape & free).sum() < _MIN_SHOWN * shape.sum():
        return None
    whole = _overlap(shape, mask, free)
    own = order(thing.model.mesh, thing.scale, prints=False)  # the colours do not matter
    tested = [turn for turn in TURNS if yaw_error(turn, 0.0, own) > _SAME]
    turned = [(_overlap(_silhouette(thing, camera, turn=t), mask, free), t) for t in tested]
    scaled = [(_overlap(_silhouette(thing, camera, factor=f), mask, free), f) for f in FACTORS]
    turned_iou, turn = max(turned, default=(whole, 0.0))
    scaled_iou, factor = max(scaled)
    return SilhouetteFit(thing.name, whole, turn, turned_iou, factor, scaled_iou)


def _silhouette(
    thing: Object, camera: Camera, turn: float = 0.0, factor: float = 1.0
) -> Bool[np.ndarray, "h w"]:
    """Return the pixels of an object rendered alone, rotated and scaled about its bottom centre."""
    points = (thing.model.mesh.vertices * thing.scale) @ quaternion_matrix(thing.pose.quaternion).T
    foot = np.array([0.0, 0.0, points[:, 2].min()])
    points = factor * (points - foot) @ rotation_z(turn).T + foot + thing.pose.position
    seen = camera.to_camera(points)
    near = 1 / np.maximum(seen[:, 2:], 1e-3)
    corners = np.concatenate([seen[:, :2] * near * camera.focal + camera.center, near], 1)
    faces = thing.model.mesh.faces
    shown = rasterise(corners[faces[(seen[faces, 2] > 1e-3).all(1)]], camera.width, camera.height)
    return (shown[0] >= 0).reshape(camera.height, camera.width)


def _overlap(
    shape: Bool[np.ndarray, "h w"], mask: Bool[np.ndarray, "h w"], free: Bool[np.ndarray, "h w"]
) -> float:
    """Return a silhouette's IoU with the mask: in place or with centroids aligned, if higher."""
    if not shape.any():
        return 0.0
    shown = shape & free if (shape & free).any() else shape
    here, there = (np.argwhere(m).mean(0) for m in (shown, mask))
    return max(mask_iou(s & free, mask) for s in (shape, _shift(shape, there - here)))


def _shift(mask: Bool[np.ndarray, "h w"], by: Float[np.ndarray, "2"]) -> np.ndarray:
    """Return a mask shifted by ``by``, in whole pixels; pixels that leave the image are dropped."""
    places = np.argwhere(mask) + np.round(by).astype(int)
    places = places[((places >= 0) & (places < mask.shape)).all(1)]
    moved = np.zeros(mask.shape, bool)
    moved[tuple(places.T)] = True
    return moved
