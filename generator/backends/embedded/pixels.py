"""Questions about masks: nearest inside pixel, hull, pieces, distance, overlap, the frame."""

from __future__ import annotations

import cv2
import numpy as np
from jaxtyping import Bool, Float, Int
from scipy import ndimage

Mask = Bool[np.ndarray, "h w"]


def nearest_inside(
    mask: Mask, steps: tuple[float, float] = (1.0, 1.0)
) -> tuple[Int[np.ndarray, "h w"], Int[np.ndarray, "h w"]]:
    """Return row and column of the nearest pixel inside ``mask``, for every pixel.

    ``steps`` is what a step to the next row and to the next column counts.
    """
    found = ndimage.distance_transform_edt(
        ~mask, sampling=steps, return_distances=False, return_indices=True
    )
    rows, columns = np.asarray(found)
    return rows, columns


def hull_of(mask: Mask) -> Mask:
    """Return the filled convex hull of a mask."""
    points = np.column_stack(np.nonzero(mask)[::-1]).astype(np.int32)
    canvas = np.zeros(mask.shape, np.uint8)
    cv2.fillConvexPoly(canvas, cv2.convexHull(points), 1)
    return canvas > 0


def hull_corners(mask: Mask) -> Float[np.ndarray, "k 2"]:
    """Return the corners of the convex hull of a mask's pixel squares, in pixels."""
    contours, _ = cv2.findContours(mask.astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    pixels = np.concatenate(contours)[:, 0].astype(np.float32)
    corners = np.concatenate([pixels + shift for shift in ([0, 0], [1, 0], [0, 1], [1, 1])])
    return cv2.convexHull(corners.astype(np.float32))[:, 0].astype(float)


def distance_to(mask: Mask, points: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n"]:
    """Return each point's distance from the nearest pixel of ``mask``, pixels."""
    if not mask.any():
        return np.full(len(points), np.inf)
    away = cv2.distanceTransform((~mask).astype(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_PRECISE)
    x, y = np.clip(points.astype(int), 0, np.array([mask.shape[1], mask.shape[0]]) - 1).T
    return away[y, x]


def largest_piece(mask: Mask) -> Mask:
    """Return the largest 4-connected piece of a mask."""
    labels = np.asarray(cv2.connectedComponents(mask.astype(np.uint8), connectivity=4)[1])
    counts = np.bincount(labels.ravel())
    counts[0] = 0
    return (labels == int(counts.argmax())) & mask


def mask_iou(a: Mask, b: Mask) -> float:
    """Return the intersection over union of two masks."""
    union = np.count_nonzero(a | b)
    return np.count_nonzero(a & b) / union if union else 0.0
