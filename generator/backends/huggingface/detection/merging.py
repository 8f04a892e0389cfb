"""One find for each thing: duplicates, groups and parts go, and each pixel has one owner."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
from jaxtyping import Float

from ....geometry import fill_holes, main_parts, mask_box
from ....meshes.pixels import mask_iou
from .detections import BoxDetection

SAME = 0.6
"""Boxes of one word that overlap (intersection over union) by more are one thing."""

ALIKE = 0.8
"""Boxes or masks of two words that overlap by more are one thing."""

HOLE = 0.02
"""A hole below this share of its mask is filled; larger ones (a handle) are real."""

_NAMED = 0.5  # overlap from which a better word belongs to a find
_WITHIN = 0.85  # share of a mask that lies within another: it is a part of that
_LEFT = 0.3  # share of a mask that has to be left once smaller things have theirs


def distinct(detections: Sequence[BoxDetection]) -> list[BoxDetection]:
    """Return the finds without those whose box a surer one has already, the surest first."""
    kept: list[BoxDetection] = []
    for detection in sorted(detections, key=lambda f: -f.score):
        overlaps = overlap(detection.box, kept)
        limits = np.array([SAME if k.label == detection.label else ALIKE for k in kept])
        if not (overlaps > limits).any():
            kept.append(detection)
    return kept


def name_generic(
    detections: Sequence[BoxDetection], generic: str, better: Sequence[BoxDetection]
) -> list[BoxDetection]:
    """Return the finds, those called ``generic`` by the surest better word for their box."""
    made = []
    for detection in detections:
        if detection.label == generic:
            at = overlap(detection.box, better) > _NAMED
            fitting = [b for b, fits in zip(better, at, strict=True) if fits]
            word = max(fitting, key=lambda b: b.score, default=detection).label
            detection = dataclasses.replace(detection, label=word)
        made.append(detection)
    return made


def overlap(
    box: Float[np.ndarray, "4"], detections: Sequence[BoxDetection]
) -> Float[np.ndarray, "n"]:
    """Return the intersection over union of a box and each find's."""
    others = np.array([f.box for f in detections]).reshape(-1, 4)
    sides = np.minimum(box[2:], others[:, 2:]) - np.maximum(box[:2], others[:, :2])
    shared = np.clip(sides, 0, None).prod(1)
    areas = (others[:, 2:] - others[:, :2]).prod(1) + (box[2:] - box[:2]).prod()
    return shared / np.maximum(areas - shared, 1e-9)


def clean(detection: BoxDetection) -> BoxDetection:
    """Return a find whose mask has no specks and no small holes, its box tight about it."""
    mask = fill_holes(main_parts(detection.mask), HOLE)
    return dataclasses.replace(detection, mask=mask, box=mask_box(mask))


def separate(detections: Sequence[BoxDetection], minimum: float) -> list[BoxDetection]:
    """Return each thing once, the surest first; no pixel belongs to two of them.

    Gone are masks that a surer one has already, masks of several things of one word together, and
    parts of a thing of the same word. A pixel of several masks is the smallest one's, which stands
    in front or inside. What keeps less than ``minimum`` pixels, or ``_LEFT`` of its mask, is gone.
    """
    kept: list[BoxDetection] = []
    for detection in sorted(detections, key=lambda f: -f.score):
        if all(mask_iou(detection.mask, k.mask) <= ALIKE for k in kept):
            kept.append(detection)
    kept = [f for f in kept if not _is_group(f, kept)]
    kept = [f for f in kept if not any(_holds(other, f) for other in kept)]
    if not kept:
        return []
    areas, taken = [int(f.mask.sum()) for f in kept], np.zeros_like(kept[0].mask)
    made: dict[int, BoxDetection] = {}
    for k in sorted(range(len(kept)), key=lambda k: areas[k]):
        mask = kept[k].mask & ~taken
        if mask.sum() >= max(minimum, _LEFT * areas[k], 1):
            made[k] = dataclasses.replace(kept[k], mask=mask, box=mask_box(mask))
            taken |= mask
    return [made[k] for k in sorted(made)]


def _is_group(detection: BoxDetection, detections: Sequence[BoxDetection]) -> bool:
    """Tell whether a mask is that of two or more smaller ones of the same word."""
    inside = [f.mask for f in detections if _holds(detection, f)]
    if len(inside) < 2:
        return False
    together = np.any(inside, axis=0)
    return bool((together & detection.mask).sum() > _WITHIN * detection.mask.sum())


def _holds(outer: BoxDetection, part: BoxDetection) -> bool:
    """Tell whether a mask lies in a larger one of the same word."""
    area = part.mask.sum()
    smaller = outer.label == part.label and area < outer.mask.sum()
    return bool(smaller and (outer.mask & part.mask).sum() > _WITHIN * area)
