"""Rasterisation of triangles row by row: the z-buffer of the software renderer."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int

from ..errors import SceneError

_CHUNK = 2_000_000  # number of candidate pixels, or triangle rows, processed at once

_ROW = 3  # cost of one triangle row, in candidate pixels

MOST_LAYERS = 40
"""Maximum number of overlapping surfaces, averaged over a picture; scenes on tables have a few."""


def _spans(
    xy: Float[np.ndarray, "m 3 2"], width: int, height: int
) -> tuple[Int[np.ndarray, "k"], Int[np.ndarray, "k"], Int[np.ndarray, "k"], Int[np.ndarray, "k"]]:
    """Return (triangle, row, first column, end column) for each span of pixels in a triangle."""
    low = np.clip(np.ceil(xy[..., 1].min(1) - 0.5), 0, height).astype(np.int64)
    high = np.clip(np.floor(xy[..., 1].max(1) - 0.5) + 1, 0, height).astype(np.int64)
    triangle, row = _expand(low, np.maximum(high - low, 0))
    y = row + 0.5
    left, right = np.full(len(row), np.inf), np.full(len(row), -np.inf)
    for k in range(3):
        p, q = xy[triangle, k], xy[triangle, (k + 1) % 3]
        rise = q[:, 1] - p[:, 1]
        crossed = (np.minimum(p[:, 1], q[:, 1]) <= y) & (y <= np.maximum(p[:, 1], q[:, 1]))
        crossed &= np.abs(rise) > 1e-12
        x = p[:, 0] + (y - p[:, 1]) * (q[:, 0] - p[:, 0]) / np.where(crossed, rise, 1.0)
        left = np.where(crossed, np.minimum(left, x), left)
        right = np.where(crossed, np.maximum(right, x), right)
    first = np.clip(np.ceil(np.clip(left, 0, width + 1) - 0.5), 0, width).astype(np.int64)
    end = np.clip(np.floor(np.clip(right, -1, width) - 0.5) + 1, 0, width).astype(np.int64)
    kept = end > first
    return triangle[kept], row[kept], first[kept], end[kept]


def _expand(
    start: Int[np.ndarray, "m"], count: Int[np.ndarray, "m"]
) -> tuple[Int[np.ndarray, "k"], Int[np.ndarray, "k"]]:
    """Return the range index and the value of each integer in the ranges [start, start + count)."""
    owner = np.repeat(np.arange(len(count)), count)
    before = np.cumsum(count) - count
    return owner, np.arange(len(owner)) + (start - before)[owner]


def rasterise(
    corners: Float[np.ndarray, "m 3 3"], width: int, height: int
) -> tuple[Int[np.ndarray, "hw"], Float[np.ndarray, "hw 3"], Float[np.ndarray, "hw"]]:
    """Return the nearest triangle of every pixel and the barycentric weights at the pixel's centre.

    A corner consists of pixel x, pixel y, and 1/depth (for perspective) or any other quantity that
    increases towards the viewer and is linear in the image. Returns per pixel (row-major): triangle
    index or -1, screen-space barycentric weights, and the interpolated third coordinate (0 in empty
    pixels).
    """
    owner, near = nearest(corners, width, height)
    weights = np.zeros((len(owner), 3))
    hit = np.flatnonzero(owner >= 0)
    weights[hit] = barycentric(corners[..., :2], owner[hit], hit, width).T
    return owner, weights, near


def nearest(
    corners: Float[np.ndarray, "m 3 3"], width: int, height: int
) -> tuple[Int[np.ndarray, "hw"], Float[np.ndarray, "hw"]]:
    """Return the triangles and third coordinates of :func:`rasterise`, without the weights.

    Raises:
        SceneError: The triangles form more than ``MOST_LAYERS`` layers.
    """
    near = np.zeros(width * height)
    owner = np.full(width * height, -1, np.int64)
    xy, closeness = corners[..., :2], corners[..., 2]
    e1, e2 = xy[:, 1] - xy[:, 0], xy[:, 2] - xy[:, 0]
    area = e1[:, 0] * e2[:, 1] - e1[:, 1] * e2[:, 0]
    whole = np.flatnonzero(np.abs(area) > 1e-12)
    d1, d2 = closeness[:, 1] - closeness[:, 0], closeness[:, 2] - closeness[:, 0]
    safe = np.where(np.abs(area) > 1e-12, area, 1.0)
    along_x = (d1 * e2[:, 1] - d2 * e1[:, 1]) / safe
    along_y = (d2 * e1[:, 0] - d1 * e2[:, 0]) / safe
    for some in _portions(xy[whole], area[whole], width, height):
        triangle, row, first, end = _spans(xy[whole[some]], width, height)
        triangle = whole[some][triangle]
        load = np.cumsum(end - first)
        cuts = np.searchsorted(load, np.arange(_CHUNK, load[-1] if len(load) else 0, _CHUNK))
        for chunk in np.split(np.arange(len(triangle)), np.unique(cuts)):
            span, column = _expand(first[chunk], (end - first)[chunk])
            t, y = triangle[chunk], row[chunk]
            start = closeness[t, 0] + along_x[t] * (0.5 - xy[t, 0, 0])
            start += along_y[t] * (y + 0.5 - xy[t, 0, 1])
            close = start[span] + along_x[t][span] * column
            pixel = (y * width)[span] + column
            np.maximum.at(near, pixel, close)
            front = close >= near[pixel]
            owner[pixel[front]] = t[span[front]]
    return owner, near


def _portions(
    xy: Float[np.ndarray, "m 3 2"], area: Float[np.ndarray, "m"], width: int, height: int
) -> list[Int[np.ndarray, "_k"]]:
    """Split the triangles, in order, into chunks that have a limited number of rows."""
    size = np.array([width, height])
    low, high = np.clip(xy.min(1), 0, size), np.clip(xy.max(1), 0, size)
    box = np.ceil(high) - np.floor(low)
    covered = np.minimum(np.abs(area) / 2, box.prod(1)).sum()
    rows = np.cumsum(box[:, 1])
    most = MOST_LAYERS * width * height
    # Every triangle counts as at least two rows, however small it is.
    if len(rows) and max(covered, _ROW * (rows[-1] - 2 * len(rows))) > most:
        raise SceneError(
            f"The triangles form more than {MOST_LAYERS} layers, too many to draw. Use meshes with "
            "fewer surfaces behind one another."
        )
    cuts = np.arange(_CHUNK, rows[-1] if len(rows) else 0, _CHUNK)
    return np.split(np.arange(len(xy)), np.unique(np.searchsorted(rows, cuts)))


def barycentric(
    xy: Float[np.ndarray, "m 3 2"],
    triangle: Int[np.ndarray, "k"],
    pixel: Int[np.ndarray, "k"],
    width: int,
) -> Float[np.ndarray, "3 k"]:
    """Return the barycentric weights, in [0, 1], of pixel centres in the given triangles."""
    x, y = pixel % width + 0.5, pixel // width + 0.5
    e1, e2 = xy[:, 1] - xy[:, 0], xy[:, 2] - xy[:, 0]
    area = (e1[:, 0] * e2[:, 1] - e1[:, 1] * e2[:, 0])[triangle]
    (ax, ay), (bx, by), (cx, cy) = (
        (xy[:, k, 0][triangle] - x, xy[:, k, 1][triangle] - y) for k in range(3)
    )
    w0 = (bx * cy - by * cx) / area
    w1 = (cx * ay - cy * ax) / area
    return np.clip(np.stack([w0, w1, 1.0 - w0 - w1]), 0.0, 1.0)
