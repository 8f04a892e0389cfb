"""Upright objects as stacks of level ellipses, each as wide as the silhouette allows.

A solid of revolution is the stack whose slices are circles about one axis. If slices may be shifted
sideways and be shallower than wide, a stack is the inflated silhouette of any upright object.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from jaxtyping import Bool, Float

from ....meshes.pixels import Mask, mask_iou
from ....meshes.projection import Projection, fill_hull
from .solids import PosedSolid, simplify_profile, stack_of_ellipses

_ANGLES = np.arange(32) * np.pi / 16
_FEW = slice(None, None, 3)  # subset of the angles, for the search of slices
_DEPTHS = (1.0, 0.6)  # candidate ratios of depth to width of the slices
_FLAT = 0.04  # cost of slices that are not round, because their depth is hardly visible
_CUT = 0.006  # maximum loss of overlap from trimming an end


@dataclass(frozen=True, eq=False)
class EllipseStack:
    """Level ellipses at ascending ``z``, with sideways centres ``x`` and half widths ``r``.

    Lengths are in the object frame, whose origin lies on the stack's plane. ``depth`` is the ratio
    of the ellipses' extent away from the camera to their width.
    """

    z: Float[np.ndarray, "k"]
    x: Float[np.ndarray, "k"]
    r: Float[np.ndarray, "k"]
    depth: float = 1.0

    def cut(self, start: int, stop: int) -> EllipseStack:
        """Return the slices from ``start`` up to, but not including, ``stop``."""
        run = slice(start, stop)
        return EllipseStack(self.z[run], self.x[run], self.r[run], self.depth)

    def silhouette(self, projection: Projection) -> Mask:
        """Return the pixels that the stack covers."""
        canvas = np.zeros((projection.height, projection.width), np.uint8)
        rings = _rings(projection, self.z, self.x, self.r, self.depth)
        flat = projection.project(rings.reshape(-1, 3)).reshape(*rings.shape[:2], 2)
        for lower, upper in pairwise(flat):
            fill_hull(canvas, np.concatenate([lower, upper]))
        return canvas > 0

    def pose(self, kind: str, projection: Projection, maximum: int = 20) -> PosedSolid:
        """Return the stack as a solid of at most ``maximum`` slices."""
        profile = np.column_stack([self.r, self.x])
        keep = simplify_profile(self.z, profile, maximum, 0.012)
        foot = self.x[0] * projection.right + self.z[0] * np.array([0, 0, 1.0])
        yaw = float(np.arctan2(projection.right[1], projection.right[0]))
        solid = stack_of_ellipses(
            self.z[keep] - self.z[0], self.r[keep], self.x[keep] - self.x[0], self.depth
        )
        return PosedSolid(kind, solid, yaw, foot)


def _rings(
    projection: Projection,
    z: np.ndarray,
    x: np.ndarray,
    r: np.ndarray,
    depth: float,
    angles: slice = slice(None),
) -> np.ndarray:
    """Return points on level ellipses; ``z``, ``x`` and ``r`` broadcast together."""
    across = x[..., None] + r[..., None] * np.cos(_ANGLES[angles])
    ahead = depth * r[..., None] * np.sin(_ANGLES[angles])
    points = across[..., None] * projection.right + ahead[..., None] * projection.away
    return points + z[..., None, None] * np.array([0, 0, 1.0])


def reach_of(mask: Mask, projection: Projection) -> tuple[float, float]:
    """Return the sideways and upward limits of slices, in units of the object frame."""
    width = int(mask.any(0).sum()) * projection.pixel
    tall = int(mask.any(1).sum())
    tall = 1.3 * tall * projection.pixel / max(np.sqrt(1 - projection.sine**2), 0.25)
    return width, tall


def largest_slices(
    mask: Mask, projection: Projection, z: np.ndarray, x: np.ndarray, depth: float, count: int
) -> EllipseStack:
    """Return, at each height, the widest ellipse inside the mask with its centre among ``x``."""
    width, _ = reach_of(mask, projection)
    radii = np.linspace(0, 0.62 * width, count + 1)[1:]
    points = _rings(projection, z[:, None, None], x[:, None], radii, depth, _FEW)
    fits = projection.inside(mask, points).mean(-1) > 0.9
    run = np.cumprod(fits, axis=2).sum(2)
    best = run.argmax(1)
    # Among equally wide slices the middle one is chosen.
    tied = run == run.max(1, keepdims=True)
    middle = (tied * x).sum(1) / tied.sum(1)
    widest = run[np.arange(len(z)), best]
    return EllipseStack(
        z, middle, np.where(widest > 0, radii[np.maximum(widest - 1, 0)], 0.0), depth
    )


def with_stems(stack: EllipseStack, mask: Mask, projection: Projection) -> EllipseStack:
    """Return the stack, adding thin slices where the mask is narrower than all ellipses tried.

    Such a slice is as wide as the mask's widest run at its height.
    """
    unit = projection.pixel
    axis = projection.project(stack.z[:, None] * np.array([0, 0, 1.0]))
    x, r = stack.x.copy(), stack.r.copy()
    for k in np.flatnonzero(stack.r <= 0):
        row = int(np.floor(axis[k, 1]))
        if not 0 <= row < len(mask) or not mask[row].any():
            continue
        start, stop = max(_runs(mask[row]), key=lambda run: run[1] - run[0])
        x[k] = ((start + stop) / 2 - axis[k, 0]) * unit
        r[k] = (stop - start) / 2 * unit
    return replace(stack, x=x, r=r)


def longest_run(stack: EllipseStack, minimum: float) -> EllipseStack | None:
    """Return the longest run of slices wider than ``minimum``, or None if it is too short."""
    runs = _runs(stack.r > minimum)
    start, stop = max(runs, key=lambda run: (run[1] - run[0], run), default=(0, 0))
    return stack.cut(start, stop) if stop - start >= 4 else None


def _runs(flags: Bool[np.ndarray, "n"]) -> list[tuple[int, int]]:
    """Return the start and stop of each run of true values."""
    edges = np.flatnonzero(np.diff(np.pad(flags.astype(int), 1))).tolist()
    return list(zip(edges[::2], edges[1::2], strict=True))


def trim(stack: EllipseStack, mask: Mask, projection: Projection) -> EllipseStack:
    """Trim a stack's ends as long as the silhouette does not change noticeably.

    Surfaces hidden by a flat top or bottom are ambiguous, so the base is placed as high and the top
    as low as the silhouette allows.
    """
    whole = mask_iou(stack.silhouette(projection), mask)

    def longest(cuts: list[tuple[int, int]]) -> EllipseStack:
        low, high = 0, len(cuts) - 1
        while low < high:
            middle = (low + high + 1) // 2
            score = mask_iou(stack.cut(*cuts[middle]).silhouette(projection), mask)
            low, high = (middle, high) if score > whole - _CUT else (low, middle - 1)
        return stack.cut(*cuts[low])

    count = len(stack.z)
    stack = longest([(k, count) for k in range(count - 3)])
    count = len(stack.z)
    return longest([(0, k) for k in range(count, 2, -1)])


def refine(stack: EllipseStack, mask: Mask, projection: Projection, free: bool) -> EllipseStack:
    """Move each slice's sides to the mask's own sides, as long as the overlap improves.

    With ``free``, slices also move sideways.
    """
    rows = np.arange(projection.height)
    best, reached = stack, mask_iou(stack.silhouette(projection), mask)
    for _ in range(4):
        drawn = stack.silhouette(projection)
        both = mask.any(1) & drawn.any(1)
        if not both.any():
            break
        middle = projection.project(
            stack.x[:, None] * projection.right + stack.z[:, None] * np.array([0, 0, 1.0])
        )[:, 1]
        moves = []
        for side in (_left_edges, _right):
            gap = np.interp(rows, rows[both], (side(mask) - side(drawn))[both].astype(float))
            moves.append(np.interp(middle - 0.5, rows, gap) * projection.pixel * 0.8)
        left, right = (_smooth(m) for m in moves)
        wider = np.maximum(stack.r + (right - left) / 2, 0.3 * stack.r)
        aside = stack.x + (right + left) / 2 if free else stack.x
        stack = replace(stack, r=wider, x=aside)
        score = mask_iou(stack.silhouette(projection), mask)
        if score > reached:
            best, reached = stack, score
    return best


def _left_edges(mask: Mask) -> np.ndarray:
    return mask.argmax(1)


def _right(mask: Mask) -> np.ndarray:
    return mask.shape[1] - 1 - mask[:, ::-1].argmax(1)


def _smooth(values: np.ndarray) -> np.ndarray:
    return np.convolve(np.pad(values, 1, mode="edge"), [0.25, 0.5, 0.25], "valid")


def best_stack(
    stacks: list[EllipseStack], mask: Mask, projection: Projection, free: bool
) -> EllipseStack | None:
    """Return the best stack, trimmed and refined, or None if there are none."""
    if not stacks:
        return None
    overlaps = [mask_iou(s.silhouette(projection), mask) - _FLAT * (1 - s.depth) for s in stacks]
    best = trim(stacks[int(np.argmax(overlaps))], mask, projection)
    smooth = replace(best, r=_smooth(best.r), x=_smooth(best.x))
    return refine(smooth, mask, projection, free)


def fit_slices(mask: Mask, projection: Projection) -> PosedSolid | None:
    """Return an upright solid made by inflating the silhouette, or None if nothing fits."""
    width, tall = reach_of(mask, projection)
    z = np.linspace(-tall, tall, 64)
    x = np.linspace(-0.4, 0.4, 17) * width
    found = []
    for depth in _DEPTHS:
        slices = largest_slices(mask, projection, z, x, depth, 20)
        stack = longest_run(with_stems(slices, mask, projection), 0.012 * width)
        if stack is not None:
            found.append(replace(stack, x=_smooth(_smooth(stack.x))))
    best = best_stack(found, mask, projection, free=True)
    return None if best is None else best.pose("slices", projection, 26)
