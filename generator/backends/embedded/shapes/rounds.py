"""Solids of revolution about a vertical axis, cut out of a silhouette, with protruding parts."""

from __future__ import annotations

import cv2
import numpy as np

from ....meshes.pixels import Mask, dilate
from ....meshes.projection import Projection
from .extrusions import plane_outline
from .slices import best_stack, largest_slices, longest_run, reach_of
from .solids import ConvexSolid, PosedSolid, join, upright

_LIMB = 0.015  # minimum area of a handle or a spout, as a fraction of the silhouette
_LIMBS = 3


def fit_revolution(mask: Mask, projection: Projection) -> PosedSolid | None:
    """Return the solid of revolution about a vertical axis, or None if nothing round fits."""
    width, tall = reach_of(mask, projection)
    heights = np.linspace(-tall, tall, 90)
    found = []
    for offset in np.linspace(-0.2, 0.2, 7) * width:
        stack = largest_slices(mask, projection, heights, np.array([offset]), 1.0, 36)
        stack = longest_run(stack, 0.012 * width)
        if stack is not None:
            found.append(stack)
    best = best_stack(found, mask, projection, free=False)
    if best is None:
        return None
    return _with_handle(best.pose("revolution", projection), mask, projection)


def _with_handle(body: PosedSolid, mask: Mask, projection: Projection) -> PosedSolid:
    """Add the largest few protruding parts of a round body as flat pieces facing the camera."""
    covered = projection.silhouette(body.world, body.solid.faces)
    rest = cv2.morphologyEx(
        (mask & ~covered).astype(np.uint8), cv2.MORPH_OPEN, np.ones((3, 3), np.uint8)
    )
    count, labels, stats, _ = cv2.connectedComponentsWithStats(rest)
    order = 1 + np.argsort(-stats[1:count, cv2.CC_STAT_AREA], kind="stable")
    solids = [body.solid]
    for k in order[:_LIMBS]:
        if stats[k, cv2.CC_STAT_AREA] < _LIMB * mask.sum():
            break
        limb = _limb((labels == k) & mask, mask, body, projection)
        if limb is not None:
            solids.append(limb)
    return PosedSolid("revolution", join(solids), body.yaw, body.position)


def _limb(piece: Mask, mask: Mask, body: PosedSolid, projection: Projection) -> ConvexSolid | None:
    """Return a part of the silhouette beside the body as a flat solid that reaches into it."""
    grown = dilate(piece, 7) & mask
    axes = np.array([projection.right, [0, 0, 1.0]])
    outline = plane_outline(grown, projection, body.position, axes, np.zeros((1, 3)))
    if outline is None or outline.bounds[1] < 0:
        return None
    across = float(np.ptp(body.solid.vertices[:, 0]))
    low, _, high, _ = outline.bounds
    return upright(outline, min(0.16 * across, 0.8 * (high - low)))
