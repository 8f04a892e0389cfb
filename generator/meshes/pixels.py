"""Operations on masks: nearest pixel inside, hull, pieces, holes, distance, overlap and frame."""

from __future__ import annotations

import cv2
import numpy as np
from jaxtyping import Bool, Float, Int
from scipy import ndimage

Mask = Bool[np.ndarray, "_ _"]


def nearest_inside(
    mask: Mask, steps: tuple[float, float] = (1.0, 1.0)
) -> tuple[Int[np.ndarray, "h w"], Int[np.ndarray, "h w"]]:
    """Return the row and column of the nearest pixel inside ``mask``, for every pixel.

    ``steps`` are the lengths of a step to the next row and to the next column.
    """
    found = ndimage.distance_transform_edt(
        ~mask, sampling=steps, return_distances=False, return_indices=True
    )
    rows, columns = np.asarray(found)
    return rows, columns


def dilate(mask: Mask, side: int) -> Mask:
    """Return a mask dilated with a square kernel of ``side`` pixels."""
    return cv2.dilate(mask.astype(np.uint8), np.ones((side, side), np.uint8)) > 0


def erode(mask: Mask, side: int) -> Mask:
    """Return a mask eroded with a square kernel of ``side`` pixels, except at the image border."""
    return cv2.erode(mask.astype(np.uint8), np.ones((side, side), np.uint8)) > 0


def foot_of(mask: Mask) -> Mask:
    """Return the lowest sixth of a mask, where an object touches its support."""
    rows = np.flatnonzero(mask.any(1))
    line = rows[-1] + (rows[0] - rows[-1]) // 6 if len(rows) else 0
    return mask & (np.arange(mask.shape[0])[:, None] >= line)


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


def distances(mask: Mask) -> Float[np.ndarray, "h w"]:
    """Return every pixel's distance, in pixels, from the nearest pixel of ``mask``.

    SciPy's transform is used because OpenCV's exact one is not reproducible bit for bit.
    """
    return np.asarray(ndimage.distance_transform_edt(~mask))


def distance_to(mask: Mask, points: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n"]:
    """Return each point's distance, in pixels, from the nearest pixel of ``mask``."""
    if not mask.any():
        return np.full(len(points), np.inf)
    away = distances(mask)
    x, y = np.clip(points.astype(int), 0, np.array([mask.shape[1], mask.shape[0]]) - 1).T
    return away[y, x]


def main_parts(mask: Mask, share: float = 0.1) -> Mask:
    """Return the parts of a mask that have at least ``share`` of the area of the largest part."""
    _, numbers, stats, _ = cv2.connectedComponentsWithStats(mask.astype(np.uint8), connectivity=8)
    areas = stats[1:, cv2.CC_STAT_AREA]
    if not len(areas):
        return mask
    return np.isin(numbers, np.flatnonzero(areas >= share * areas.max()) + 1)


def fill_holes(mask: Mask, share: float) -> Mask:
    """Fill enclosed holes smaller than a fraction ``share`` of the mask's area."""
    outside = (~mask).astype(np.uint8)
    _, numbers, stats, _ = cv2.connectedComponentsWithStats(outside, connectivity=4)
    border = np.unique(np.concatenate([numbers[0], numbers[-1], numbers[:, 0], numbers[:, -1]]))
    small = np.flatnonzero(stats[:, cv2.CC_STAT_AREA] < share * max(int(mask.sum()), 1))
    inner = np.setdiff1d(np.setdiff1d(small, border), [0])
    return mask | np.isin(numbers, inner)


def largest_piece(mask: Mask) -> Mask:
    """Return the largest 4-connected component of a mask."""
    labels = np.asarray(cv2.connectedComponents(mask.astype(np.uint8), connectivity=4)[1])
    counts = np.bincount(labels.ravel())
    counts[0] = 0
    return (labels == int(counts.argmax())) & mask


def in_one_piece(mask: Mask, minimum: float = 0.02) -> Mask:
    """Return a mask whose components are joined by bridges where they are closest to each other.

    A bridge is as wide as the narrower of the two ends that it joins. Specks smaller than a
    fraction ``minimum`` of the whole are not joined.
    """
    labels = np.asarray(cv2.connectedComponents(mask.astype(np.uint8), connectivity=8)[1])
    counts = np.bincount(labels.ravel())
    counts[0] = 0
    order = [int(k) for k in np.argsort(-counts) if counts[k] > max(8, minimum * mask.sum())]
    if len(order) < 2:
        return mask
    inside = cv2.distanceTransform(np.pad(mask, 1).astype(np.uint8), cv2.DIST_L2, 5)[1:-1, 1:-1]
    width = cv2.dilate(inside, np.ones((9, 9)))
    joined, canvas = labels == order[0], mask.astype(np.uint8)
    apart = [labels == k for k in order[1:]]
    while apart:
        away = distances(joined)
        gaps = [float(away[piece].min()) for piece in apart]
        piece = apart.pop(int(np.argmin(gaps)))
        ys, xs = np.nonzero(piece)
        k = int(np.argmin(away[ys, xs]))
        here = int(ys[k]), int(xs[k])
        rows, columns = nearest_inside(joined)
        there = int(rows[here]), int(columns[here])
        thick = max(1, round(2 * float(min(width[here], width[there])) - 1))
        cv2.line(canvas, here[::-1], there[::-1], 1, thick)
        joined = joined | piece
    return canvas > 0


def mask_iou(a: Mask, b: Mask) -> float:
    """Return the intersection over union of two masks."""
    union = np.count_nonzero(a | b)
    return np.count_nonzero(a & b) / union if union else 0.0
