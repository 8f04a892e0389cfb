"""Which pixels belong to the table, and which to the things on it.

The table's colour is a smooth surface fitted over its top; what departs from it is a thing, unless
it can be reached from the bare top without crossing an edge while only growing darker: then it is
a shadow or a reflection. Above the far edge the same holds against the background.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float, Int

from .outline import background_patch, flat_patches, gradient
from .plane import TablePlane

_SHADOW_EDGE = 2.6  # CIELAB units per pixel: the steepest edge of a soft shadow
_DARKEST = 0.55  # share of the light that a shadow leaves
_SMALLEST = 2.5e-4  # of the picture: fewer pixels are a speck


@dataclass(frozen=True, eq=False)
class Regions:
    """The table's pixels and the connected things on it, at working size, largest first."""

    table: Bool[np.ndarray, "h w"]
    things: tuple[Bool[np.ndarray, "h w"], ...]
    strength: Float[np.ndarray, "h w"]


def disc(radius: int) -> np.ndarray:
    """Return a round structuring element."""
    return cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * radius + 1, 2 * radius + 1))


def smooth_color(
    lab: Float[np.ndarray, "h w 3"], sure: Bool[np.ndarray, "h w"]
) -> tuple[Float[np.ndarray, "h w 3"], Float[np.ndarray, "3"]]:
    """Fit a quadratic colour surface to the ``sure`` pixels; return it and the robust spread.

    Outliers are dropped in three rounds, so ``sure`` may hold some things.
    """
    h, w = sure.shape
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    x, y = x / w - 0.5, y / h - 0.5
    terms = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], -1)
    chosen = np.flatnonzero(sure)
    chosen = chosen[:: max(1, len(chosen) // 8000)]
    design, colors = terms.reshape(-1, 6)[chosen], lab.reshape(-1, 3)[chosen]
    keep = np.ones(len(chosen), bool)
    spread = np.ones(3)
    weights = np.zeros((6, 3))
    for _ in range(4):
        weights = np.linalg.lstsq(design[keep], colors[keep], rcond=None)[0]
        off = np.abs(colors - design @ weights)
        spread = np.maximum(1.4826 * np.median(off[keep], axis=0), [0.8, 0.5, 0.5])
        keep = (off < 3.5 * spread).all(1)
        if keep.sum() < 50:
            break
    return terms @ weights, spread


def _darkening(lab: np.ndarray, color: np.ndarray, spread: np.ndarray) -> Bool[np.ndarray, "h w"]:
    """Return the pixels that are the surface's colour with less (or slightly more) light."""
    ratio = (lab[..., 0] + 8) / np.maximum(color[..., 0] + 8, 1)
    hue = np.abs(lab[..., 1:] - color[..., 1:] * np.clip(ratio, 0, 1.1)[..., None])
    return (ratio > _DARKEST) & (ratio < 1.12) & (hue < 3.0 + 3 * spread[1:]).all(-1)


def _reach(start: np.ndarray, allowed: np.ndarray) -> Bool[np.ndarray, "h w"]:
    """Return the parts of ``allowed`` connected to ``start``."""
    numbers = cv2.connectedComponents((allowed | start).astype(np.uint8), connectivity=4)[1]
    return np.isin(numbers, np.unique(numbers[start])) & (numbers > 0)


def bare(
    lab: Float[np.ndarray, "h w 3"],
    strength: Float[np.ndarray, "h w"],
    sure: Bool[np.ndarray, "h w"],
    within: Bool[np.ndarray, "h w"],
) -> Bool[np.ndarray, "h w"]:
    """Return the pixels of ``within`` that show the bare surface, shadows included."""
    color, spread = smooth_color(lab, sure)
    off = np.abs(lab - color) / spread
    plain = (off < 3.5).all(-1) & within
    steep = max(_SHADOW_EDGE, 1.2 * float(np.percentile(strength[sure], 90)) if sure.any() else 0)
    shade = _darkening(lab, color, spread) & (strength < steep) & within
    return _reach(plain, shade) | plain


def above_front(plane_mask: Bool[np.ndarray, "h w"]) -> Bool[np.ndarray, "h w"]:
    """Return the pixels that are not below the top's front edge (where the legs are)."""
    h = plane_mask.shape[0]
    lowest = np.where(plane_mask.any(0), h - plane_mask[::-1].argmax(0), -1)
    columns = np.flatnonzero(lowest >= 0)
    lowest[: columns[0]], lowest[columns[-1] + 1 :] = lowest[columns[0]], lowest[columns[-1]]
    return np.arange(h)[:, None] < lowest[None, :]


def find_regions(
    lab: Float[np.ndarray, "h w 3"], top: Bool[np.ndarray, "h w"]
) -> Regions:
    """Separate table and things. ``top`` is the inside of the tabletop's outline."""
    strength = gradient(lab)
    patches = flat_patches(strength, 1.0, 4)
    background = background_patch(patches) & ~cv2.dilate(top.astype(np.uint8), disc(2)).astype(bool)
    if not background.any():
        background = ~cv2.dilate(top.astype(np.uint8), disc(9)).astype(bool)
    ground = bare(lab, strength, background, ~top)
    inner = cv2.erode(top.astype(np.uint8), disc(4)) > 0
    plain = flat_patches(strength, 1.5, 2)
    largest = np.bincount(plain[inner & (plain > 0)], minlength=1)
    sure = inner & (plain == largest.argmax()) if largest.any() else inner
    table_top = bare(lab, strength, sure if sure.sum() > 0.08 * inner.sum() else inner, top)
    other = np.where(top, ~table_top, ~ground)
    raw = other & above_front(top)
    edge = cv2.morphologyEx(top.astype(np.uint8), cv2.MORPH_GRADIENT, disc(3)) > 0
    cores = cv2.morphologyEx((raw & ~edge).astype(np.uint8), cv2.MORPH_OPEN, disc(1)) > 0
    grown = cores
    for _ in range(5):
        grown = (cv2.dilate(grown.astype(np.uint8), disc(1)) > 0) & raw
    things = _components(grown | cores, top)
    covered = np.any(things, axis=0) if things else np.zeros_like(top)
    below = other & ~above_front(top)
    table = (top & ~covered) | _largest_touching(below, top)
    return Regions(table, things, strength)


def _components(
    mask: Bool[np.ndarray, "h w"], top: Bool[np.ndarray, "h w"]
) -> tuple[Bool[np.ndarray, "h w"], ...]:
    closed = cv2.morphologyEx(mask.astype(np.uint8), cv2.MORPH_CLOSE, disc(1))
    _, numbers, stats, _ = cv2.connectedComponentsWithStats(closed, connectivity=8)
    on_top = cv2.dilate(top.astype(np.uint8), disc(3)) > 0
    found = []
    for k in np.argsort(-stats[1:, cv2.CC_STAT_AREA]) + 1:
        own = numbers == k
        if stats[k, cv2.CC_STAT_AREA] < _SMALLEST * mask.size:
            break
        thick = cv2.distanceTransform(own.astype(np.uint8), cv2.DIST_L2, 3).max()
        if thick >= 2.0 and (own & on_top).any():
            found.append(own)
    return tuple(found)


def _largest_touching(mask: np.ndarray, top: np.ndarray) -> Bool[np.ndarray, "h w"]:
    """Return the parts of ``mask`` that touch the tabletop: its front and its legs."""
    touching = (cv2.dilate(top.astype(np.uint8), disc(3)) > 0) & mask
    return _reach(touching, mask) if touching.any() else np.zeros_like(top)


def number_map(masks: tuple[Bool[np.ndarray, "h w"], ...]) -> Int[np.ndarray, "h w"]:
    """Return 1, 2, ... where the first, second, ... mask is; 0 elsewhere."""
    numbers = np.zeros(masks[0].shape, np.int32)
    for k, mask in enumerate(masks, start=1):
        numbers[mask] = k
    return numbers


def plane_at(plane: TablePlane, size: tuple[int, int]) -> Bool[np.ndarray, "h w"]:
    """Return the inside of the tabletop's outline at another picture size (height, width)."""
    canvas = np.zeros(size, np.uint8)
    factor = size[1] / plane.camera.width
    cv2.fillPoly(canvas, [np.round(plane.outline * factor - 0.5).astype(np.int32)], 1)
    return canvas > 0
