"""Which of the masks are things: of nested ones the whole, or its contents too; of equal ones one.

The names that the eye gives decide: what lies in or on a thing has a clear name of its own, or was
found as a thing of its own by the eye; what has not is a part.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Bool, Float

from ....meshes.pixels import dilate, mask_iou
from ..eye.judge import EyeDetection
from .prompts import Proposal

CLEAR = 0.6
"""Probability of a name that makes a thing of what might be a part."""

_SAME = 0.65  # overlap (IoU) at which two masks are one thing
_WITHIN = 0.85  # share of a mask that lies within another one, from which it is nested
_PART = 0.9  # share of the outer one's area from which an inner mask is the same thing
_FOUND = 0.5  # certainty of the eye's detection, and overlap with it, that do so too
_ALONG = 0.2  # share of a part's rim along which it touches what it is a part of
_UNITED = 0.8  # share of a mask that things found apart cover, from which it is those
_SMALLEST = 1.5e-4  # of the picture, a thing


def choose(
    proposals: Sequence[Proposal],
    names: Sequence[Float[np.ndarray, "k"]],
    known: Sequence[EyeDetection],
) -> list[int]:
    """Return which proposals are things.

    ``names`` are each one's probabilities over the eye's names, the last being "unknown"; ``known``
    are the eye's own detections.
    """
    masks = [p.mask for p in proposals]
    areas = [int(m.sum()) for m in masks]
    kept = [
        k
        for k in _without_copies(proposals, masks, areas)
        if areas[k] >= _SMALLEST * masks[k].size and not _unites(masks[k], areas[k], known)
    ]
    kept.sort(key=lambda k: -areas[k])
    chosen: list[int] = []
    sure = find_own(masks, known)
    for k in kept:
        around = [j for j in chosen if int((masks[k] & masks[j]).sum()) > _WITHIN * areas[k]]
        if not around or all(
            areas[k] < _PART * areas[j] and (sure[k] or _named_apart(names[k], names[j]))
            for j in around
        ):
            chosen.append(k)
    return chosen


def join_parts(
    masks: Sequence[Bool[np.ndarray, "h w"]], stands: Sequence[bool], own: Sequence[bool]
) -> list[Bool[np.ndarray, "h w"]]:
    """Return masks in which parts are joined to what they touch most.

    What stands on nothing is a part: a lamp's head is held by its arm. So is what is no thing of
    its ``own`` by its name or by the eye, and touches along much of its rim. What touches nothing
    stays as it is.
    """
    joined = list(masks)
    owner = list(range(len(masks)))
    reach = max(masks[0].shape) // 250 + 2 if masks else 0
    for k in sorted(range(len(masks)), key=lambda k: foot_row(masks[k])):
        if stands[k] and own[k]:
            continue
        grown = dilate(joined[k], reach)
        rim = int((grown & ~joined[k]).sum())
        touch = [
            0 if owner[j] != j or j == k or foot_row(joined[j]) <= foot_row(joined[k])
            else int((grown & joined[j]).sum())
            for j in range(len(masks))
        ]  # fmt: skip
        best = int(np.argmax(touch))
        if touch[best] > (_ALONG * rim if stands[k] else 0):
            joined[best] = joined[best] | joined[k]
            owner[k] = best
    return [joined[k] for k in range(len(masks)) if owner[k] == k]


def foot_row(mask: Bool[np.ndarray, "h w"]) -> int:
    """Return the lowest row of a mask."""
    return int(np.flatnonzero(mask.any(1))[-1])


def find_own(masks: Sequence[Bool[np.ndarray, "h w"]], known: Sequence[EyeDetection]) -> list[bool]:
    """Tell of each mask whether the eye has found it as a thing of its own."""
    overlap = _overlaps(masks, [d.visible for d in known])
    return [
        any(o >= _FOUND and d.score >= _FOUND for o, d in zip(row, known, strict=True))
        for row in overlap
    ]


def is_one(
    whole: Float[np.ndarray, "k"], one: Float[np.ndarray, "k"], other: Float[np.ndarray, "k"]
) -> bool:
    """Tell by their names whether two masks that were also outlined as one are one thing.

    They are if they have the same name, or if the whole's is at least as clear as theirs. Two with
    different clear names are two.
    """
    best = [int(names[:-1].argmax()) for names in (whole, one, other)]
    sure = [float(names[:-1].max()) for names in (whole, one, other)]
    if min(sure[1:]) > CLEAR and best[1] != best[2]:
        return False
    return best[1] == best[2] or sure[0] >= max(sure[1:])


def _named_apart(inner: Float[np.ndarray, "k"], outer: Float[np.ndarray, "k"]) -> bool:
    """Tell whether what is nested has a clear name, and another one than what is around it."""
    best = int(inner[:-1].argmax())
    return bool(inner[best] > CLEAR and best != int(outer[:-1].argmax()))


def _without_copies(
    proposals: Sequence[Proposal], masks: Sequence[Bool[np.ndarray, "h w"]], areas: Sequence[int]
) -> list[int]:
    """Return the best of masks that show the same."""
    kept: list[int] = []
    for k in sorted(range(len(masks)), key=lambda k: -proposals[k].quality * proposals[k].seen):
        shared = [int((masks[k] & masks[j]).sum()) for j in kept]
        same = (s > _SAME * (areas[k] + areas[j] - s) for s, j in zip(shared, kept, strict=True))
        if not any(same):
            kept.append(k)
    return kept


def _unites(mask: Bool[np.ndarray, "h w"], area: int, known: Sequence[EyeDetection]) -> bool:
    """Tell whether a mask is several things that the eye has found apart, and none as a whole."""
    inside = np.zeros(mask.shape, bool)
    count = 0
    for detection in known:
        if detection.score < _FOUND:
            continue
        own = int(detection.visible.sum())
        shared = int((mask & detection.visible).sum())
        if shared > _SAME * (area + own - shared):
            return False
        if shared > _WITHIN * own:
            inside |= detection.visible
            count += 1
    return count > 1 and int((inside & mask).sum()) > _UNITED * area


def _overlaps(
    masks: Sequence[Bool[np.ndarray, "h w"]], others: Sequence[Bool[np.ndarray, "h w"]]
) -> Float[np.ndarray, "n m"]:
    found = np.zeros((len(masks), len(others)))
    for i, mask in enumerate(masks):
        for j, other in enumerate(others):
            found[i, j] = mask_iou(mask, other)
    return found
