"""The tabletop's outline in a picture: the detected region's boundary, snapped to edges.

The detector returns the pixels of the whole top surface, including the objects on it. All tabletops
of the catalogue are convex, so the hull of this region is the outline; where the surface itself is
visible next to it, the outline is moved to the picture's edge.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8

from ....errors import SceneError
from ....meshes.pixels import dilate, distance_to, hull_corners, main_parts, mask_iou
from ..eye.sight import EyeReading

WORKING_SIZE = 640
"""Longer side, in pixels, of the copy of the picture that is analysed."""

_POINTS = 240  # number of points along the outline
_SMALLEST = 0.015  # minimum area of a top, as a fraction of the picture
_SURE, _FILLED = 0.8, 0.7  # minimum mean probability of a top, and minimum fill of its hull
_AGREED = 0.75  # minimum overlap of the visible top with the pixels of a tabletop
_REACH = 3.0  # maximum distance to an edge in pixels
_NEAR = 1.5  # scale in pixels at which farther edges lose weight
_AWAY = 4.0  # maximum distance in pixels to the boundary of the region itself
_RIM = 6  # margin around an object that counts as hidden, in pixels
_LEAST = 0.35  # minimum fraction of unhidden points; with fewer, hidden ones are used too


@dataclass(frozen=True, eq=False)
class Outline:
    """The outline of the whole tabletop, counter-clockwise on screen, in working pixels.

    ``hull`` is the closed outline; ``points`` are the reliable edge points; ``hidden`` is the area
    covered by objects; ``top`` is the region itself, including the objects on it.
    """

    hull: Float[np.ndarray, "k 2"]
    points: Float[np.ndarray, "n 2"]
    hidden: Bool[np.ndarray, "h w"]
    top: Bool[np.ndarray, "h w"]


def working_copy(image: UInt8[np.ndarray, "h w 3"]) -> tuple[Float[np.ndarray, "a b 3"], float]:
    """Return the picture in CIELAB, reduced to the working size, and the scale factor."""
    factor = min(1.0, WORKING_SIZE / max(image.shape[:2]))
    size = (max(1, round(image.shape[1] * factor)), max(1, round(image.shape[0] * factor)))
    small = cv2.resize(image, size, interpolation=cv2.INTER_AREA) if factor < 1 else image
    lab = cv2.cvtColor(np.ascontiguousarray(small, np.float32) / 255.0, cv2.COLOR_RGB2LAB)
    return np.asarray(lab), factor


def find_outline(image: UInt8[np.ndarray, "h w 3"], sight: EyeReading) -> tuple[Outline, float]:
    """Return the tabletop's outline, and the scale from picture pixels to working pixels.

    Raises:
        SceneError: no tabletop was detected.
    """
    lab, factor = working_copy(image)
    height, width = lab.shape[:2]
    top = cv2.resize(top_of(sight).astype(np.float32), (width, height)) > 0.5

    def small(mask: np.ndarray) -> np.ndarray:
        return cv2.resize(mask.astype(np.uint8), (width, height), interpolation=0) > 0

    bare, things = small(sight.shows("top")), small(sight.shows("thing"))
    points, normals = walk(hull_corners(top), _POINTS)
    ends = distance_to(~top, points) < _AWAY
    inner, outer = _at(bare, points - 5 * normals), _at(things, points + 5 * normals)
    plain = ends & inner & ~outer
    moved = snap(points, normals, gradient(lab))
    points = np.where(plain[:, None], moved, points)
    hull = cv2.convexHull(points.astype(np.float32))[:, 0].astype(float)
    kept = plain if plain.mean() > _LEAST else ends | plain
    hidden = dilate(things, 2 * _RIM + 1)
    return Outline(hull, points[kept] if kept.sum() > 20 else points, hidden, top), factor


def top_of(sight: EyeReading) -> Bool[np.ndarray, "h w"]:
    """Return the pixels of the whole tabletop, including the objects on it.

    Raises:
        SceneError: no tabletop was detected; regions that are too small, ragged or uncertain do not
            count.
    """
    top = main_parts(sight.top > 0.5)
    shown, bare = sight.shows("top"), top & ~sight.shows("thing")
    agreed = mask_iou(shown, bare)
    if top.sum() >= _SMALLEST * top.size and sight.top[top].mean() > _SURE and agreed > _AGREED:
        hull = np.zeros(top.shape, np.uint8)
        cv2.fillConvexPoly(hull, np.round(hull_corners(top)).astype(np.int32), 1)
        if top.sum() > _FILLED * hull.sum():
            return top
    raise SceneError(
        "No table found in the picture. Show the table's top surface, and light it well enough to "
        "distinguish the table from its surroundings."
    )


def gradient(lab: Float[np.ndarray, "h w 3"]) -> Float[np.ndarray, "h w"]:
    """Return the edge strength, in CIELAB units per pixel, of the bilaterally smoothed picture."""
    smooth = cv2.bilateralFilter(lab.astype(np.float32), 7, 6, 4)
    strength = np.zeros(lab.shape[:2], np.float32)
    for c in range(3):
        gx = cv2.Scharr(smooth[..., c], cv2.CV_32F, 1, 0) / 32
        gy = cv2.Scharr(smooth[..., c], cv2.CV_32F, 0, 1) / 32
        strength = np.maximum(strength, np.hypot(gx, gy))
    return strength


def walk(outline: Float[np.ndarray, "k 2"], count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return ``count`` evenly spaced points on a closed outline and their outward normals."""
    ends = np.roll(outline, -1, axis=0)
    lengths = np.linalg.norm(ends - outline, axis=1)
    stations = np.linspace(0, lengths.sum(), count, endpoint=False)
    starts = np.concatenate([[0.0], np.cumsum(lengths)])
    edge = np.clip(np.searchsorted(starts, stations, side="right") - 1, 0, len(outline) - 1)
    share = (stations - starts[edge]) / np.maximum(lengths[edge], 1e-9)
    points = outline[edge] + share[:, None] * (ends - outline)[edge]
    along = (ends - outline)[edge] / np.maximum(lengths[edge], 1e-9)[:, None]
    normals = np.column_stack([along[:, 1], -along[:, 0]])
    outward = np.sign(((points - outline.mean(0)) * normals).sum(1).sum()) or 1.0
    return points, normals * outward


def snap(
    points: Float[np.ndarray, "n 2"],
    normals: Float[np.ndarray, "n 2"],
    strength: Float[np.ndarray, "h w"],
) -> Float[np.ndarray, "n 2"]:
    """Move points along their normals to the strongest edge, with more weight on closer edges."""
    offsets = np.arange(-_REACH, _REACH + 0.25, 0.5)
    along = points[:, None] + offsets[None, :, None] * normals[:, None]
    near = np.exp(-((offsets / _NEAR) ** 2))
    best = (_sample(strength, along) * near).argmax(1)
    return along[np.arange(len(points)), best]


def _sample(field: Float[np.ndarray, "h w"], points: Float[np.ndarray, "n m 2"]) -> np.ndarray:
    """Interpolate bilinearly at pixel positions (centres at half-integers), with edges repeated."""
    x, y = (np.ascontiguousarray(points[..., k] - 0.5, np.float32) for k in range(2))
    field = np.ascontiguousarray(field, np.float32)
    return np.asarray(cv2.remap(field, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE))


def _at(field: np.ndarray, points: Float[np.ndarray, "n 2"]) -> np.ndarray:
    x, y = np.clip(points.astype(int), 0, np.array([field.shape[1], field.shape[0]]) - 1).T
    return field[y, x]
