"""Solids of revolution about a vertical axis, cut out of a silhouette."""

from __future__ import annotations

from itertools import pairwise

import cv2
import numpy as np
from jaxtyping import Bool

from .extrusions import plane_outline
from .pixels import mask_iou
from .projection import Projection, fill_hull
from .solids import Posed, Solid, revolution, simplify_profile, upright

Mask = Bool[np.ndarray, "h w"]

_CIRCLE = np.column_stack(
    [np.cos(np.arange(32) * np.pi / 16), np.sin(np.arange(32) * np.pi / 16), np.zeros(32)]
)


def _stack(
    projection: Projection, axis: np.ndarray, heights: np.ndarray, radii: np.ndarray
) -> Mask:
    canvas = np.zeros((projection.height, projection.width), np.uint8)
    centers = axis + heights[:, None] * np.array([0, 0, 1.0])
    rings = [projection.project(_CIRCLE * r + c) for c, r in zip(centers, radii, strict=True)]
    for lower, upper in pairwise(rings):
        fill_hull(canvas, np.concatenate([lower, upper]))
    return canvas > 0


def _largest_radii(
    mask: Mask, projection: Projection, axis: np.ndarray, heights: np.ndarray, reach: float
) -> np.ndarray:
    """Return per height the radius of the largest circle about the axis whose picture is inside."""
    radii = np.linspace(0, reach, 56)[1:]
    points = _CIRCLE[None, None] * radii[None, :, None, None] + axis
    points = points + np.array([0, 0, 1.0]) * heights[:, None, None, None]
    fits = projection.inside(mask, points).mean(-1) > 0.97
    count = np.cumprod(fits, axis=1).sum(1)
    return np.where(count > 0, radii[np.maximum(count - 1, 0)], 0.0)


def fit_revolution(mask: Mask, projection: Projection) -> Posed | None:
    """Return the solid of revolution about a vertical axis, or None if nothing round fits.

    The largest profile comes from circles inside the silhouette. What a flat top or bottom hides
    is ambiguous, so the base is put as high and the top as low as the silhouette allows.
    """
    width = int(mask.any(0).sum())
    unit = float(np.linalg.norm(projection.position)) / projection.focal
    reach, tall = 0.62 * width * unit, 1.3 * int(mask.any(1).sum()) * unit
    tall /= max(np.sqrt(1 - projection.sine**2), 0.25)
    heights = np.linspace(-tall, tall, 120)
    best: tuple[float, np.ndarray, np.ndarray, np.ndarray] | None = None
    for offset in np.linspace(-0.2, 0.2, 9):
        axis = offset * width * unit * projection.right
        radii = _largest_radii(mask, projection, axis, heights, reach)
        run = _longest_run(radii > 0.02 * reach)
        if run is None:
            continue
        z, r = heights[run], radii[run]
        score = mask_iou(_stack(projection, axis, z, r), mask)
        if best is None or score > best[0]:
            best = (score, axis, z, r)
    if best is None:
        return None
    _, axis, z, r = best
    z, r = _trim(mask, projection, axis, z, r)
    r = np.convolve(np.pad(r, 1, mode="edge"), [0.25, 0.5, 0.25], "valid")
    keep = simplify_profile(z, r, 18, 0.012)
    foot = axis + z[0] * np.array([0, 0, 1.0])
    body = Posed("revolution", revolution(z[keep] - z[0], r[keep]), 0.0, foot)
    return _with_handle(body, mask, projection)


def _with_handle(body: Posed, mask: Mask, projection: Projection) -> Posed:
    """Add what sticks out of a round body as a flat piece in the plane facing the camera."""
    covered = projection.silhouette(body.world, body.solid.faces)
    rest = cv2.morphologyEx(
        (mask & ~covered).astype(np.uint8), cv2.MORPH_OPEN, np.ones((3, 3), np.uint8)
    )
    count, labels, stats, _ = cv2.connectedComponentsWithStats(rest)
    if count < 2:
        return body
    largest = 1 + int(stats[1:, cv2.CC_STAT_AREA].argmax())
    if stats[largest, cv2.CC_STAT_AREA] < 0.02 * mask.sum():
        return body
    piece = cv2.dilate((labels == largest).astype(np.uint8), np.ones((7, 7), np.uint8)) > 0
    facing = projection.right
    axes = np.array([facing, [0, 0, 1.0]])
    outline = plane_outline(piece & mask, projection, body.position, axes, np.zeros((1, 3)))
    if outline is None or outline.bounds[1] < 0:
        return body
    low, high = body.solid.vertices.min(0), body.solid.vertices.max(0)
    handle = upright(outline, 0.16 * float(high[0] - low[0]))
    yaw = float(np.arctan2(facing[1], facing[0]))
    vertices = np.concatenate([body.solid.vertices, handle.vertices])
    faces = np.concatenate([body.solid.faces, handle.faces + len(body.solid.vertices)])
    solid = Solid(vertices, faces, body.solid.parts + handle.parts)
    return Posed("revolution", solid, yaw, body.position)


def _longest_run(flags: np.ndarray) -> slice | None:
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags.astype(int), [0]])))
    runs = [(b - a, a, b) for a, b in zip(edges[::2], edges[1::2], strict=True)]
    if not runs or max(runs)[0] < 4:
        return None
    _, start, stop = max(runs)
    return slice(start, stop)


def _trim(
    mask: Mask, projection: Projection, axis: np.ndarray, z: np.ndarray, r: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Cut the profile's ends as far as the silhouette does not notice."""
    whole = mask_iou(_stack(projection, axis, z, r), mask)

    def longest(cut: list[tuple[int, int]]) -> tuple[int, int]:
        low, high = 0, len(cut) - 1
        while low < high:
            middle = (low + high + 1) // 2
            a, b = cut[middle]
            score = mask_iou(_stack(projection, axis, z[a:b], r[a:b]), mask)
            low, high = (middle, high) if score > whole - 0.006 else (low, middle - 1)
        return cut[low]

    a, _ = longest([(k, len(z)) for k in range(len(z) - 3)])
    _, b = longest([(a, k) for k in range(len(z), a + 2, -1)])
    return z[a:b], r[a:b]
