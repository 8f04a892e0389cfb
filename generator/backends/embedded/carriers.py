"""Flat things that others stand on: boards, trays and mats that the eye takes for tabletop.

They differ in colour from the rest of the top, are convex, and carry something. A shadow is darker
than what it falls on, hardly another colour, and convex only with what throws it.
"""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8

from ...meshes.pixels import dilate, erode, foot_of, hull_of, mask_iou
from .plane.outline import working_copy

_DIFFERENT = 12.0  # CIELAB units from the top's usual colour
_SHADOW = 35.0, 6.0  # darker by less, and less coloured than this: a shadow
_ALIKE = 12.0  # CIELAB units between the patches of one carrier
_CRUMB = 2e-4  # of the picture: a smaller patch is none
_FLAT = 0.02, 0.4  # share of the tabletop that a carrier covers
_FILLED = 0.9  # share of its hull that it fills, with the things on it
_BARE = 0.2  # share of its hull that shows it
_STANDS = 0.6  # share of a thing's foot within its hull, of what stands on it
_KNOWN = 0.4  # overlap (IoU) of it with something that the eye has found
_OWN = 0.85  # share of its own colour's pixels around it that are within it


def find_carriers(
    image: UInt8[np.ndarray, "h w 3"],
    top: Bool[np.ndarray, "h w"],
    things: Sequence[Bool[np.ndarray, "h w"]],
) -> list[Bool[np.ndarray, "h w"]]:
    """Return the whole masks of the carriers on a tabletop.

    ``top`` is all of it, with what is on it; ``things`` is what shows of each thing there.
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
    """Return the pixels of the bare top that are of another colour than most of it."""
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
    """Return the patches of another colour; things may lie between parts of the same colour."""
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
