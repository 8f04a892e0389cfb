"""Post-processing of detections: one per object, without duplicates, groups or parts."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Protocol

import numpy as np
from jaxtyping import Bool, Float, UInt8
from PIL import Image

from ....geometry import mask_box
from ....meshes.pixels import fill_holes, hull_of, main_parts, mask_iou
from .tiles import Tile

if TYPE_CHECKING:
    from torch import Tensor


@dataclass(frozen=True, eq=False)
class BoxDetection:
    """A box (x0, y0, x1, y1) in picture pixels, labelled with one of the requested words.

    ``score`` is in [0, 1]; ``mask`` is None until it is computed.
    """

    label: str
    score: float
    box: Float[np.ndarray, "4"]
    mask: Bool[np.ndarray, "h w"] = field(default_factory=lambda: np.zeros((0, 0), bool))


class Finder(Protocol):
    """A model that detects objects described by words."""

    def find(
        self, image: UInt8[np.ndarray, "h w 3"], words: Sequence[str], tiles: Sequence[Tile]
    ) -> list[BoxDetection]:
        """Return the detections of ``words`` in each tile, except those cut by its border."""
        ...


class Masker(Protocol):
    """A model that segments the object in a box."""

    def mask(
        self,
        image: UInt8[np.ndarray, "h w 3"],
        detections: Sequence[BoxDetection],
        tiles: Sequence[Tile],
    ) -> list[BoxDetection]:
        """Return the detections with masks, in order; those with empty masks are removed."""
        ...


SAME = 0.6
"""Overlap (IoU) above which two boxes with the same label count as one object."""

ALIKE = 0.8
"""Overlap above which two boxes or masks with different labels count as one object."""

HOLE = 0.02
"""Holes smaller than this fraction of their mask are filled; larger holes, such as those in
handles, are kept."""

_NAMED = 0.5  # overlap above which a better word applies to a detection
_WITHIN = 0.85  # fraction of a mask within another, above which it is a part of it
_LEFT = 0.3  # minimum fraction of a mask left after smaller objects have taken their pixels


def distinct(detections: Sequence[BoxDetection]) -> list[BoxDetection]:
    """Return the detections by descending score, without lower-scored duplicates of a box."""
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
    """Replace the label ``generic`` of detections with the best specific word for each box."""
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
    """Return the intersection over union of a box with each detection's box."""
    others = np.array([f.box for f in detections]).reshape(-1, 4)
    sides = np.minimum(box[2:], others[:, 2:]) - np.maximum(box[:2], others[:, :2])
    shared = np.clip(sides, 0, None).prod(1)
    areas = (others[:, 2:] - others[:, :2]).prod(1) + (box[2:] - box[:2]).prod()
    return shared / np.maximum(areas - shared, 1e-9)


def clean(detection: BoxDetection) -> BoxDetection:
    """Return a detection with a tight box, and a mask without specks and small holes."""
    mask = fill_holes(main_parts(detection.mask), HOLE)
    return dataclasses.replace(detection, mask=mask, box=mask_box(mask))


def separate(detections: Sequence[BoxDetection], minimum: float) -> list[BoxDetection]:
    """Return each object once, by descending score, with disjoint masks.

    Duplicates of masks with a higher score, masks that combine several objects of one word, and
    parts of an object of the same word are removed. A pixel shared by several masks belongs to the
    smallest one, which is in front or inside. A mask with fewer than ``minimum`` pixels, or less
    than ``_LEFT`` of its area, is removed.
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
    """Return whether a mask combines two or more smaller masks of the same word."""
    inside = [f.mask for f in detections if _holds(detection, f)]
    if len(inside) < 2:
        return False
    together = np.any(inside, axis=0)
    return bool((together & detection.mask).sum() > _WITHIN * detection.mask.sum())


def _holds(outer: BoxDetection, part: BoxDetection) -> bool:
    """Return whether a mask lies in a larger mask of the same word."""
    area = part.mask.sum()
    smaller = outer.label == part.label and area < outer.mask.sum()
    return bool(smaller and (outer.mask & part.mask).sum() > _WITHIN * area)


_FOOT = 1 / 6  # height of an object's foot, relative to its mask
_BELOW = 1 / 60  # search distance below a foot, relative to the picture's longer side


def on_table(things: Sequence[BoxDetection], table: Bool[np.ndarray, "h w"]) -> list[BoxDetection]:
    """Return the detections on the table, in order, without those beside or below it.

    Most of the lowest part of an object on the table is over the table's outline, or directly above
    other objects on the table: it stands on them or behind them.
    """
    ground, others = hull_of(table), np.zeros_like(table)
    standing: set[int] = set()
    while True:
        more = [
            k for k, f in enumerate(things)
            if k not in standing and (_over(f.mask, ground) or _upon(f.mask, others))
        ]  # fmt: skip
        if not more:
            return [things[k] for k in sorted(standing)]
        standing.update(more)
        others |= np.any([things[k].mask for k in more], axis=0)


def _over(mask: Bool[np.ndarray, "h w"], ground: Bool[np.ndarray, "h w"]) -> bool:
    foot = _foot(mask)
    return bool((foot & ground).sum() > 0.5 * foot.sum())


def _upon(mask: Bool[np.ndarray, "h w"], others: Bool[np.ndarray, "h w"]) -> bool:
    step = int(_BELOW * max(mask.shape)) + 1
    below = np.zeros_like(mask)
    below[step:] = _foot(mask)[:-step]
    below &= ~mask
    return bool((below & others).sum() > 0.5 * below.sum())


def _foot(mask: Bool[np.ndarray, "h w"]) -> Bool[np.ndarray, "h w"]:
    rows = np.flatnonzero(mask.any(1))
    low = rows[-1] - _FOOT * (rows[-1] - rows[0])
    return mask & (np.arange(len(mask))[:, None] >= low)


IMAGENET = ((0.485, 0.456, 0.406), (0.229, 0.224, 0.225))
"""Mean and standard deviation of RGB for Grounding DINO, SAM 2 and DINOv2."""

HALVES = ((0.5, 0.5, 0.5), (0.5, 0.5, 0.5))
"""Mean and standard deviation of RGB for SAM 3."""

Norm = tuple[tuple[float, float, float], tuple[float, float, float]]


def normalise(images: Float[Tensor, "b 3 h w"], norm: Norm) -> Float[Tensor, "b 3 h w"]:
    """Normalise images in [0, 1] differentiably with a model's mean and standard deviation."""
    mean, deviation = (images.new_tensor(v).view(1, 3, 1, 1) for v in norm)
    return (images - mean) / deviation


def to_batch(
    image: UInt8[np.ndarray, "h w 3"], width: int, height: int, norm: Norm
) -> Float[Tensor, "1 3 b a"]:
    """Return a picture resized to ``width`` x ``height`` and normalised, as a batch of one."""
    import torch

    small = Image.fromarray(image).resize((width, height), Image.Resampling.BILINEAR)
    pixels = torch.from_numpy(np.asarray(small, np.float32) / 255).permute(2, 0, 1)[None]
    return normalise(pixels, norm)


def bound_size(width: int, height: int, shorter: int, longer: int) -> tuple[int, int]:
    """Return a size with the same aspect ratio, the given shorter side and a limited longer side.

    Sizes are rounded as in Grounding DINO's processor.
    """
    low, high = sorted((width, height))
    near = longer * low / high if high / low * shorter > longer else float(shorter)
    close, far = round(near), int(near * high / low)
    return (far, close) if width >= height else (close, far)
