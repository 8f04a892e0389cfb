"""Sizes and positions of objects from the points of a depth map."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float

from ....geometry import Camera, rotation_z
from ..plane.plane import TablePlane
from .plane import smooth

_FEW = 12  # minimum number of points of a measurement
_TAIL = 1.0  # percentage of the points excluded at each end
_STRAY = 0.06  # gap in metres that separates an object's points from outliers
_MOST = 4000  # maximum number of points per object
_LEVEL = 0.03  # metres between the top of a support and the bottom of an object on it
_NARROW = 0.85  # length ratio of an object's top to its base, below which it tapers
_HOLLOW = 0.025  # depth in metres of a container's middle below its rim
_GROUND = 0.008  # metres; lower points of a clearly taller object are ignored


@dataclass(frozen=True, eq=False)
class ObservedSolid:
    """The visible part of one object, in the table's frame (in metres, with the tabletop at z = 0).

    ``center``, ``yaw`` and ``extent`` describe its upright bounding box, where ``extent`` is
    (length, width) with length >= width; ``bottom`` and ``top`` are its lowest and highest visible
    points. ``points`` are a sample of its points.
    """

    center: Float[np.ndarray, "2"]
    yaw: float
    extent: tuple[float, float]
    bottom: float
    top: float
    points: Float[np.ndarray, "n 3"]

    @property
    def tapers(self) -> bool:
        """Whether the object tapers clearly towards its top, so that its back may be hidden."""
        high = self.points[:, 2] > self.top - 0.2 * (self.top - self.bottom)
        along = self._own()[:, 0]
        if high.sum() < _FEW:
            return False
        return bool(np.ptp(np.percentile(along[high], [_TAIL, 100 - _TAIL])) < 2 * _NARROW)

    @property
    def inner(self) -> float:
        """The height of the visible surface at the centre, such as the floor of a container."""
        middle = self._within(0.3)
        heights = self.points[middle, 2] if middle.any() else self.points[:, 2]
        return float(np.percentile(heights, 20))

    @property
    def hollow(self) -> bool:
        """Whether the object's middle, seen from above, lies well below a rim on all sides."""
        middle = self._within(0.3)
        turned = self._own()
        rims = [
            self.points[~self._within(0.65) & (turned[:, k] * side > 0), 2]
            for k in (0, 1)
            for side in (-1, 1)
        ]
        if middle.sum() < _FEW / 2 or min(len(r) for r in rims) < _FEW / 2:
            return False
        rim = min(float(np.percentile(r, 85)) for r in rims)
        return bool(np.median(self.points[middle, 2]) < rim - _HOLLOW)

    def _own(self) -> Float[np.ndarray, "n 2"]:
        """Return the points' coordinates along the box's axes, as fractions of its half extents."""
        turned = (self.points[:, :2] - self.center) @ rotation_z(self.yaw)[:2, :2]
        return turned / (np.asarray(self.extent) / 2)

    def _within(self, share: float) -> Bool[np.ndarray, "n"]:
        return np.asarray((np.abs(self._own()) < share).all(1))


def table_points(depth: Float[np.ndarray, "h w"], camera: Camera) -> Float[np.ndarray, "h w 3"]:
    """Return each pixel's point in the frame of ``camera``, or NaN where the depth is 0."""
    h, w = depth.shape
    y, x = np.mgrid[0:h, 0:w] + 0.5
    z = np.where(depth > 0, depth, np.nan).astype(np.float64)
    across = (np.stack([x, y], -1) - camera.center) / camera.focal
    rays = np.concatenate([across, np.ones((h, w, 1))], -1)
    return (rays * z[..., None]) @ camera.rotation + camera.position


def measure_solid(
    mask: Bool[np.ndarray, "h w"], depth: Float[np.ndarray, "h w"], plane: TablePlane
) -> ObservedSolid | None:
    """Return the bounding box of the points under ``mask``, or None if there are too few of them.

    Points at depth discontinuities (where sensors mix near and far surfaces), groups of points
    apart from the rest, and the tabletop around the foot are excluded. An object whose top is not
    visible because the camera is too low is assumed to be as deep as it is wide.
    """
    clean = mask & steady(depth)
    calm = cv2.medianBlur(np.ascontiguousarray(depth, np.float32), 5)
    points = table_points(np.where(clean & (calm > 0), calm, depth), plane.camera)
    chosen = points[clean] if clean.sum() >= _FEW else points[mask & (depth > 0)]
    chosen = chosen[:: max(1, len(chosen) // _MOST)]
    chosen = _above_tabletop(_together(chosen, plane.camera))
    if len(chosen) < _FEW:
        return None
    bottom, top = (float(v) for v in np.percentile(chosen[:, 2], [_TAIL, 100 - _TAIL]))
    center, yaw, extent = _box(chosen[:, :2])
    if plane.camera.position[2] < top:
        center, yaw, extent = _deepen(center, yaw, extent, plane.camera)
    return ObservedSolid(center, yaw, extent, bottom, top, chosen)


def steady(depth: Float[np.ndarray, "h w"]) -> Bool[np.ndarray, "h w"]:
    """Return the valid pixels of a depth map that are not behind a depth discontinuity."""
    z = np.where(depth > 0, depth, np.nan)
    return smooth(np.stack([z, z, z], -1))


def _together(points: Float[np.ndarray, "n 3"], camera: Camera) -> Float[np.ndarray, "k 3"]:
    """Return the largest group of points without a gap in their distances from the camera."""
    away = np.linalg.norm(points - camera.position, axis=1)
    order = np.argsort(away)
    groups = np.split(order, np.flatnonzero(np.diff(away[order]) > _STRAY) + 1)
    return points[max(groups, key=len)]


def _above_tabletop(points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "k 3"]:
    """Return an object's points, excluding tabletop points unless the object itself is flat."""
    high = points[points[:, 2] > _GROUND]
    tall = len(high) > _FEW and float(np.percentile(points[:, 2], 90)) > 3 * _GROUND
    return high if tall else points


def _box(
    places: Float[np.ndarray, "n 2"],
) -> tuple[Float[np.ndarray, "2"], float, tuple[float, float]]:
    """Return the centre, yaw and (length, width) of the tightest bounding box, ignoring outliers.

    Objects whose boxes are about equally tight at all angles, such as round ones, are aligned with
    the table's axes.
    """
    angles = np.deg2rad(np.arange(0, 90, 2.0))
    axes = np.stack([np.stack([np.cos(angles), np.sin(angles)], -1),
                     np.stack([-np.sin(angles), np.cos(angles)], -1)], 1)  # fmt: skip
    along = np.einsum("abk,nk->abn", axes, places)
    low, high = np.percentile(along, [_TAIL, 100 - _TAIL], axis=-1)
    spans = np.maximum(high - low, 1e-3)
    areas = spans.prod(1)
    best = int(areas.argmin())
    if areas[best] > 0.88 * areas[0]:
        best = 0
    center = ((low + high) / 2)[best] @ axes[best]
    length, width = (float(v) for v in spans[best])
    yaw = float(angles[best])
    if width > length:
        length, width, yaw = width, length, yaw + np.pi / 2
    return center, yaw, (length, width)


def _deepen(
    center: Float[np.ndarray, "2"], yaw: float, extent: tuple[float, float], camera: Camera
) -> tuple[Float[np.ndarray, "2"], float, tuple[float, float]]:
    """Return an object's box, extended away from the camera because the top is hidden."""
    length, width = extent
    away = center - camera.position[:2]
    away /= np.linalg.norm(away)
    across = np.array([-np.sin(yaw), np.cos(yaw)])
    lacking = max(0.8 * length - width, 0.0) * abs(float(across @ away))
    return center + away * lacking / 2, yaw, (length, width + lacking)


def holds(below: ObservedSolid, thing: ObservedSolid) -> float:
    """Return the fraction of ``thing`` above ``below``, or 0 if their heights rule out support."""
    rise = max(below.top - below.bottom, 0.01)
    if thing.bottom < below.bottom + (0.3 if below.hollow else 0.6) * rise - 0.005:
        return 0.0
    if thing.bottom > below.top + _LEVEL or thing.top < below.top:
        return 0.0
    turned = (thing.points[:, :2] - below.center) @ rotation_z(below.yaw)[:2, :2]
    return float((np.abs(turned) < np.asarray(below.extent) / 2 + 0.005).all(1).mean())
