"""Telling apart things whose pictures touch: stacked, contained or one behind the other."""

from __future__ import annotations

from collections.abc import Callable

import cv2
import numpy as np
from jaxtyping import Bool, Float

from .surface import disc

_TRIED = 4  # splits compared by what they leave
_LEAST_SHARE = 0.06  # of a region: a smaller piece is a part, not a thing


def split_things(
    lab: Float[np.ndarray, "h w 3"],
    strength: Float[np.ndarray, "h w"],
    things: tuple[Bool[np.ndarray, "h w"], ...],
    expected: int,
    unlikeness: Callable[[list[Bool[np.ndarray, "h w"]]], float],
) -> tuple[Bool[np.ndarray, "h w"], ...]:
    """Split regions until there are ``expected`` things.

    Of the splits whose seam is among the clearest, the one is taken that leaves the regions least
    unlike what is expected.
    """
    current = list(things)
    while 0 < len(current) < expected:
        options = []
        for k, mask in enumerate(current):
            parts = halve(lab, strength, mask)
            if parts is not None:
                split = [*current[:k], parts[0], parts[1], *current[k + 1 :]]
                options.append((parts[2], split))
        if not options:
            break
        clearest = sorted(options, key=lambda option: -option[0])[:_TRIED]
        current = min((split for _, split in clearest), key=unlikeness)
    return tuple(current)


def halve(
    lab: Float[np.ndarray, "h w 3"],
    strength: Float[np.ndarray, "h w"],
    mask: Bool[np.ndarray, "h w"],
) -> tuple[np.ndarray, np.ndarray, float] | None:
    """Return the two most unlike parts of a region and how good the split is, or None.

    Flat pieces of the region are merged, most alike first, until two are left.
    """
    pieces = _pieces(strength, mask)
    count = int(pieces.max())
    if count < 2:
        return None
    areas = np.bincount(pieces[mask], minlength=count + 1)[1:].astype(float)
    colors = np.array([np.median(lab[pieces == k], axis=0) for k in range(1, count + 1)])
    touching = _borders(pieces, count)
    groups = [{k} for k in range(count)]
    while len(groups) > 2:
        best, pair = np.inf, (0, 1)
        for i in range(len(groups)):
            for j in range(i + 1, len(groups)):
                cost = _merge_cost(groups[i], groups[j], areas, colors, touching)
                if cost < best:
                    best, pair = cost, (i, j)
        groups[pair[0]] |= groups.pop(pair[1])
    share = areas[list(groups[0])].sum() / areas.sum()
    if min(share, 1 - share) < _LEAST_SHARE:
        return None
    parts = [np.isin(pieces, [k + 1 for k in g]) & mask for g in groups]
    contrast = np.linalg.norm(_mean(groups[0], areas, colors) - _mean(groups[1], areas, colors))
    score = float(contrast * np.sqrt(min(share, 1 - share)) * np.sqrt(areas.sum()))
    return parts[0], parts[1], score


def _mean(group: set[int], areas: np.ndarray, colors: np.ndarray) -> np.ndarray:
    members = list(group)
    return np.average(colors[members], axis=0, weights=areas[members])


def _merge_cost(
    a: set[int], b: set[int], areas: np.ndarray, colors: np.ndarray, touching: np.ndarray
) -> float:
    """Return how unlike two groups are; small and well-connected groups join early."""
    shared = touching[np.ix_(list(a), list(b))].sum()
    if shared == 0:
        return 1e6
    size_a, size_b = areas[list(a)].sum(), areas[list(b)].sum()
    contrast = float(np.linalg.norm(_mean(a, areas, colors) - _mean(b, areas, colors)))
    smaller = min(size_a, size_b)
    return (contrast + 4) * np.sqrt(smaller) * np.sqrt(np.sqrt(smaller) / shared)


def _pieces(strength: np.ndarray, mask: np.ndarray) -> np.ndarray:
    """Number the flat pieces of a region; every pixel of it belongs to the nearest one."""
    flat = cv2.erode(((strength < 5) & mask).astype(np.uint8), disc(1))
    _, numbers, stats, _ = cv2.connectedComponentsWithStats(flat, connectivity=4)
    areas = stats[1:, cv2.CC_STAT_AREA]
    keep = np.argsort(-areas)[:24] + 1
    keep = keep[areas[keep - 1] >= max(8, 0.004 * mask.sum())]
    seeds = np.zeros(mask.shape, np.int32)
    for new, old in enumerate(keep, start=1):
        seeds[numbers == old] = new
    if not len(keep):
        return mask.astype(np.int32)
    _, nearest = cv2.distanceTransformWithLabels(
        (seeds == 0).astype(np.uint8), cv2.DIST_L2, 3, labelType=cv2.DIST_LABEL_PIXEL
    )
    lookup = np.zeros(int(nearest.max()) + 1, np.int32)
    lookup[nearest[seeds > 0]] = seeds[seeds > 0]
    return np.where(mask, lookup[nearest], 0)


def _borders(pieces: np.ndarray, count: int) -> np.ndarray:
    """Return how many pixel sides each two pieces share."""
    shared = np.zeros((count, count))
    for a, b in ((pieces[:, 1:], pieces[:, :-1]), (pieces[1:], pieces[:-1])):
        meet = (a != b) & (a > 0) & (b > 0)
        np.add.at(shared, (a[meet] - 1, b[meet] - 1), 1)
    return shared + shared.T
