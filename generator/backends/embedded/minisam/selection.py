"""Selection of the masks of objects among nested and duplicate masks.

The detector's names decide: an object in or on another has a clear name of its own, or was
detected; any other nested mask is a part.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Bool, Float

from ....meshes.pixels import dilate, mask_iou
from ..eye.judge import EyeDetection
from .prompts import Proposal

CLEAR = 0.6
"""Probability of the predicted name above which a possible part counts as a separate object."""

_SAME = 0.65  # overlap (IoU) above which two masks show the same object
_WITHIN = 0.85  # fraction of a mask within another one, above which it is nested
_PART = 0.9  # relative area above which a nested mask shows the same object
_FOUND = 0.5  # minimum confidence of, and overlap with, a detection of a nested object
_ALONG = 0.2  # minimum fraction of a part's boundary that touches its object
_UNITED = 0.8  # coverage by separate detections above which a mask is their union
_SMALLEST = 1.5e-4  # minimum area of an object, as a fraction of the picture


def choose(
    proposals: Sequence[Proposal],
    names: Sequence[Float[np.ndarray, "k"]],
    known: Sequence[EyeDetection],
) -> list[int]:
    """Return the indices of the proposals that are objects.

    ``names`` are each proposal's probabilities over the detector's names, with "unknown" as the
    last; ``known`` are the detector's own detections.
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
    """Return the masks, merging each part into the mask that it touches most.

    A mask that stands on nothing is a part: a lamp's head is held by its arm. So is a mask that,
    judging by its name and the detections, is not a separate object (``own``) and that touches
    another along much of its boundary. Masks that touch nothing are unchanged.
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
    """Return which masks the detector has found as separate objects."""
    overlap = _overlaps(masks, [d.visible for d in known])
    return [
        any(o >= _FOUND and d.score >= _FOUND for o, d in zip(row, known, strict=True))
        for row in overlap
    ]


def is_one(
    whole: Float[np.ndarray, "k"], one: Float[np.ndarray, "k"], other: Float[np.ndarray, "k"]
) -> bool:
    """Return whether two masks with a common outline show a single object, based on their names.

    They do if they have the same name, or if the name of the whole is at least as clear as theirs.
    Two masks with different clear names are separate.
    """
    best = [int(names[:-1].argmax()) for names in (whole, one, other)]
    sure = [float(names[:-1].max()) for names in (whole, one, other)]
    if min(sure[1:]) > CLEAR and best[1] != best[2]:
        return False
    return best[1] == best[2] or sure[0] >= max(sure[1:])


def _named_apart(inner: Float[np.ndarray, "k"], outer: Float[np.ndarray, "k"]) -> bool:
    """Return whether a nested mask has a clear name that differs from the surrounding mask's."""
    best = int(inner[:-1].argmax())
    return bool(inner[best] > CLEAR and best != int(outer[:-1].argmax()))


def _without_copies(
    proposals: Sequence[Proposal], masks: Sequence[Bool[np.ndarray, "h w"]], areas: Sequence[int]
) -> list[int]:
    """Return the indices of the masks without duplicates, keeping the best mask of each object."""
    kept: list[int] = []
    for k in sorted(range(len(masks)), key=lambda k: -proposals[k].quality * proposals[k].seen):
        shared = [int((masks[k] & masks[j]).sum()) for j in kept]
        same = (s > _SAME * (areas[k] + areas[j] - s) for s, j in zip(shared, kept, strict=True))
        if not any(same):
            kept.append(k)
    return kept


def _unites(mask: Bool[np.ndarray, "h w"], area: int, known: Sequence[EyeDetection]) -> bool:
    """Return whether a mask is the union of separate detections and not itself one of them."""
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
