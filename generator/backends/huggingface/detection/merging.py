"""One find for each thing: duplicates, groups and parts go, and each pixel has one owner."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
from jaxtyping import Float

from ....geometry import fill_holes, main_parts, mask_box
from ....meshes.pixels import mask_iou
from .detections import Find

SAME = 0.6
"""Boxes of one word that overlap (intersection over union) by more are one thing."""

ALIKE = 0.8
"""Boxes or masks of two words that overlap by more are one thing."""

HOLE = 0.02
"""A hole below this share of its mask is filled; larger ones (a handle) are real."""

_NAMED = 0.5  # overlap from which a better word belongs to a find
_WITHIN = 0.85  # share of a mask that lies within another: it is a part of that
_LEFT = 0.3  # share of a mask that has to be left once smaller things have theirs


def distinct(finds: Sequence[Find]) -> list[Find]:
    """Return the finds without those whose box a surer one has already, the surest first."""
    kept: list[Find] = []
    for find in sorted(finds, key=lambda f: -f.score):
        overlaps = overlap(find.box, kept)
        limits = np.array([SAME if k.label == find.label else ALIKE for k in kept])
        if not (overlaps > limits).any():
            kept.append(find)
    return kept


def named(finds: Sequence[Find], generic: str, better: Sequence[Find]) -> list[Find]:
    """Return the finds, those called ``generic`` by the surest better word for their box."""
    made = []
    for find in finds:
        if find.label == generic:
            at = overlap(find.box, better) > _NAMED
            fitting = [b for b, fits in zip(better, at, strict=True) if fits]
            word = max(fitting, key=lambda b: b.score, default=find).label
            find = dataclasses.replace(find, label=word)
        made.append(find)
    return made


def overlap(box: Float[np.ndarray, "4"], finds: Sequence[Find]) -> Float[np.ndarray, "n"]:
    """Return the intersection over union of a box and each find's."""
    others = np.array([f.box for f in finds]).reshape(-1, 4)
    sides = np.minimum(box[2:], others[:, 2:]) - np.maximum(box[:2], others[:, :2])
    shared = np.clip(sides, 0, None).prod(1)
    areas = (others[:, 2:] - others[:, :2]).prod(1) + (box[2:] - box[:2]).prod()
    return shared / np.maximum(areas - shared, 1e-9)


def cleaned(find: Find) -> Find:
    """Return a find whose mask has no specks and no small holes, its box tight about it."""
    mask = fill_holes(main_parts(find.mask), HOLE)
    return dataclasses.replace(find, mask=mask, box=mask_box(mask))


def separate(finds: Sequence[Find], least: float) -> list[Find]:
    """Return each thing once, the surest first; no pixel belongs to two of them.

    Gone are masks that a surer one has already, masks of several things of one word together, and
    parts of a thing that has the same word. A pixel of several masks is the smallest one's, which
    stands in front or inside. Of a mask less than ``least`` pixels, or than ``_LEFT`` of it, is
    nothing.
    """
    kept: list[Find] = []
    for find in sorted(finds, key=lambda f: -f.score):
        if all(mask_iou(find.mask, k.mask) <= ALIKE for k in kept):
            kept.append(find)
    kept = [f for f in kept if not _is_group(f, kept)]
    kept = [f for f in kept if not _is_part(f, kept)]
    return _owned(kept, least)


def _owned(finds: Sequence[Find], least: float) -> list[Find]:
    if not finds:
        return []
    areas = [int(f.mask.sum()) for f in finds]
    taken = np.zeros_like(finds[0].mask)
    made: dict[int, Find] = {}
    for k in sorted(range(len(finds)), key=lambda k: areas[k]):
        mask = finds[k].mask & ~taken
        if mask.sum() >= max(least, _LEFT * areas[k], 1):
            made[k] = dataclasses.replace(finds[k], mask=mask, box=mask_box(mask))
            taken |= mask
    return [made[k] for k in sorted(made)]


def _is_group(find: Find, finds: Sequence[Find]) -> bool:
    """Tell whether a mask is that of two or more smaller ones of the same word."""
    inside = [f for f in finds if f is not find and f.label == find.label and _holds(find, f)]
    if len(inside) < 2:
        return False
    together = np.any([f.mask for f in inside], axis=0)
    return bool((together & find.mask).sum() > _WITHIN * find.mask.sum())


def _is_part(find: Find, finds: Sequence[Find]) -> bool:
    return any(f is not find and f.label == find.label and _holds(f, find) for f in finds)


def _holds(whole: Find, part: Find) -> bool:
    """Tell whether a mask lies in a larger one."""
    area = part.mask.sum()
    return bool(area < whole.mask.sum() and (whole.mask & part.mask).sum() > _WITHIN * area)
