"""Boxes of any yaw that fit a silhouette, and boxes carved to match a silhouette."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from ....geometry import rotation_z
from ....meshes.pixels import Mask, mask_iou
from ....meshes.projection import Projection
from ....scene import ConvexPart
from .frames import bounded_gap, descend, frame_to_mask
from .solids import ConvexSolid, PosedSolid, box, heightfield

_UNIT_BOX = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (0.0, 1.0)])


def _box_at(
    parameters: np.ndarray, projection: Projection, mask: Mask
) -> tuple[np.ndarray, float, np.ndarray]:
    yaw, width, height = parameters[0], np.exp(parameters[1]), np.exp(parameters[2])
    corners = (_UNIT_BOX * [width, 1.0, height]) @ rotation_z(yaw).T
    scale, shift = frame_to_mask(corners, projection, mask)
    return corners * scale + shift, scale, shift


def fit_box(
    mask: Mask, projection: Projection, expected: Float[np.ndarray, "3"] | None = None
) -> PosedSolid:
    """Return the upright box that best fits ``mask``; ``expected`` (l, w, h) ratios break ties."""

    def loss(parameters: np.ndarray) -> float:
        if not (-1.6 < parameters[1] < 3 and -4 < parameters[2] < 3):
            return 2.0
        corners, *_ = _box_at(parameters, projection, mask)
        value = 1 - mask_iou(projection.hull_silhouette(corners), mask)
        if expected is not None:
            sides = np.array([np.exp(parameters[1]), 1.0, np.exp(parameters[2])])
            value += 0.01 * bounded_gap(sides, expected)
        return value

    grid = [
        np.array([yaw, np.log(w), np.log(h)])
        for yaw in np.arange(10) * np.pi / 10 + 0.02
        for w in (1.0, 1.5, 2.3, 4.0)
        for h in (0.07, 0.2, 0.45, 0.9, 1.7, 3.0)
    ]
    starts = sorted(grid, key=loss)[:3]
    best = min((descend(loss, start, (0.15, 0.2, 0.25), 90) for start in starts), key=loss)
    _, scale, shift = _box_at(best, projection, mask)
    width, height, yaw = float(np.exp(best[1])), float(np.exp(best[2])), float(best[0])
    if width < 1:
        return PosedSolid("box", box(scale, scale * width, scale * height), yaw + np.pi / 2, shift)
    return PosedSolid("box", box(scale * width, scale, scale * height), yaw, shift)


def fit_carved(
    mask: Mask, projection: Projection, bounding: PosedSolid, cells: int = 26
) -> PosedSolid | None:
    """Return a box carved by the silhouette, as a grid of vertical columns.

    Mirrored halves of the box are made symmetric where the silhouette allows.
    """
    width, depth, height = np.ptp(bounding.solid.vertices, axis=0)
    along = np.linspace(-0.5, 0.5, cells)
    x, y = np.meshgrid(along * width, along * depth, indexing="ij")
    turn = rotation_z(bounding.yaw)
    base = np.stack([x, y, np.zeros_like(x)], -1) @ turn.T + bounding.position
    levels = np.linspace(0, 1.3 * height, 40)
    columns = base[None] + levels[:, None, None, None] * np.array([0, 0, 1.0])
    inside = np.cumprod(projection.inside(mask, columns), axis=0).sum(0)
    heights = np.where(inside > 1, levels[np.maximum(inside - 1, 0)], 0.0)
    if (heights > 0).sum() < 9:
        return None

    def pose(grid: np.ndarray) -> PosedSolid:
        solid = heightfield(grid, width, depth)
        return PosedSolid("carved", solid, bounding.yaw, bounding.position)

    def score(grid: np.ndarray) -> float:
        candidate = pose(grid)
        return mask_iou(projection.silhouette(candidate.world, candidate.solid.faces), mask)

    reached = score(heights)
    for mirrored in (np.minimum(heights, heights[:, ::-1]), np.minimum(heights, heights[::-1])):
        if (mirrored > 0).sum() >= 9 and score(mirrored) > reached - 0.012:
            heights = np.minimum(heights, mirrored)
    return recenter(pose(heights))


def recenter(posed: PosedSolid) -> PosedSolid:
    """Move a solid's origin to the middle of its base."""
    low, high = posed.solid.vertices.min(0), posed.solid.vertices.max(0)
    shift = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    parts = tuple(ConvexPart(p.vertices - shift, p.kind, p.axis) for p in posed.solid.parts)
    solid = ConvexSolid(posed.solid.vertices - shift, posed.solid.faces, parts)
    return PosedSolid(posed.kind, solid, posed.yaw, posed.position + rotation_z(posed.yaw) @ shift)
