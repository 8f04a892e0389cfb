"""Boards, trays and mats that carry other objects and that detectors mistake for the tabletop.

They differ in colour from the rest of the top, are convex, and carry something. A shadow, in
contrast, is darker than the surface with hardly any change of hue, and is convex only together with
the object that casts it.
"""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8

from ...meshes.pixels import dilate, erode, foot_of, hull_of, mask_iou
from .plane.outline import working_copy

_DIFFERENT = 12.0  # CIELAB distance from the top's usual colour
# a shadow is darker by less than the first value and less coloured than the second
_SHADOW = 35.0, 6.0
_ALIKE = 12.0  # CIELAB distance between the patches of one carrier
_CRUMB = 2e-4  # minimum area of a patch, as a fraction of the picture
_FLAT = 0.02, 0.4  # fraction of the tabletop that a carrier covers
_FILLED = 0.9  # minimum fraction of its hull that the carrier and the objects on it fill
_BARE = 0.2  # minimum fraction of its hull where the carrier itself is visible
_STANDS = 0.6  # fraction of an object's foot within the hull, for objects on the carrier
_KNOWN = 0.4  # overlap (IoU) with a detection, above which the carrier is already known
_OWN = 0.85  # fraction of nearby pixels of its colour that lie within the carrier


def find_carriers(
    image: UInt8[np.ndarray, "h w 3"],
    top: Bool[np.ndarray, "h w"],
    things: Sequence[Bool[np.ndarray, "h w"]],
) -> list[Bool[np.ndarray, "h w"]]:
    """Return the complete masks of the carriers on a tabletop.

    ``top`` is the whole tabletop, including the objects on it; ``things`` are the visible parts of
    these objects.
    """
    if not things or not top.any():
        return []
    lab, _ = working_copy(image)
    size = lab.shape[1::-1]

    def small(mask: Bool[np.ndarray, "h w"]) -> Bool[np.ndarray, "a b"]:
        return cv2.resize(mask.astype(np.uint8), size, interpolation=cv2.INTER_NEAREST) > 0

    masks = [small(mask) for mask in things]
    covered = dilate(np.any(masks, axis=0), 5)
    area = small(top)
    other = _other_colour(lab, erode(area, 7) & ~covered)
    found = []
    for piece in _pieces(lab, other, covered & area):
        whole = hull_of(piece)
        if not _is_carrier(piece, whole, area, covered, other, masks):
            continue
        if any(mask_iou(whole, mask) > _KNOWN for mask in masks):
            continue
        full = cv2.resize(whole.astype(np.float32), image.shape[1::-1]) > 0.5
        found.append(full)
    return found


def _other_colour(
    lab: Float[np.ndarray, "h w 3"], bare: Bool[np.ndarray, "h w"]
) -> Bool[np.ndarray, "h w"]:
    """Return the bare tabletop's pixels that differ from its most common colour, except shadows."""
    smooth = cv2.medianBlur(np.ascontiguousarray(lab, np.float32), 5)
    if not bare.any():
        return bare
    steps = np.round(smooth[bare] / 6.0).astype(int)
    kinds, counts = np.unique(steps, axis=0, return_counts=True)
    usual = kinds[counts.argmax()] * 6.0
    away = smooth - usual
    coloured = np.hypot(away[..., 1], away[..., 2])
    distance = np.hypot(coloured, away[..., 0])
    darkest, plain = _SHADOW
    shadow = (away[..., 0] < 0) & (away[..., 0] > -darkest) & (coloured < plain)
    return bare & (distance > _DIFFERENT) & ~shadow


def _pieces(
    lab: Float[np.ndarray, "h w 3"],
    other: Bool[np.ndarray, "h w"],
    covered: Bool[np.ndarray, "h w"],
) -> list[Bool[np.ndarray, "h w"]]:
    """Return the patches of other colours; parts that an object separates are joined."""
    opened = cv2.morphologyEx(other.astype(np.uint8), cv2.MORPH_OPEN, np.ones((5, 5), np.uint8))
    count, labels, stats, _ = cv2.connectedComponentsWithStats(opened)
    kept = [k for k in range(1, count) if stats[k, cv2.CC_STAT_AREA] >= _CRUMB * other.size]
    patches = [labels == k for k in kept]
    colours = [np.median(lab[patch], axis=0) for patch in patches]
    pieces = []
    while patches:
        alike = [np.linalg.norm(colour - colours[0]) < _ALIKE for colour in colours]
        bridged = np.any([p for p, a in zip(patches, alike, strict=True) if a], axis=0) | covered
        _, areas = cv2.connectedComponents(bridged.astype(np.uint8))
        own = np.unique(areas[patches[0]])
        joins = [
            a and bool(np.isin(areas[p], own).any()) for p, a in zip(patches, alike, strict=True)
        ]
        pieces.append(np.any([p for p, j in zip(patches, joins, strict=True) if j], axis=0))
        patches = [p for p, j in zip(patches, joins, strict=True) if not j]
        colours = [c for c, j in zip(colours, joins, strict=True) if not j]
    return pieces


def _is_carrier(
    piece: Bool[np.ndarray, "h w"],
    whole: Bool[np.ndarray, "h w"],
    top: Bool[np.ndarray, "h w"],
    covered: Bool[np.ndarray, "h w"],
    other: Bool[np.ndarray, "h w"],
    masks: Sequence[Bool[np.ndarray, "h w"]],
) -> bool:
    size, least, most = int(whole.sum()), *(share * int(top.sum()) for share in _FLAT)
    if not least <= size <= most or int(piece.sum()) < _BARE * size:
        return False
    if int((whole & (piece | covered)).sum()) < _FILLED * size:
        return False
    near = dilate(whole, 2 * max(3, round(size**0.5 / 8)) + 1) & other
    if int((near & whole).sum()) < _OWN * int(near.sum()):
        return False
    return any(_stands_in(m, whole) and int(m.sum()) < size for m in masks)


def _stands_in(mask: Bool[np.ndarray, "h w"], area: Bool[np.ndarray, "h w"]) -> bool:
    foot = foot_of(mask)
    return int((foot & area).sum()) > _STANDS * int(foot.sum())
