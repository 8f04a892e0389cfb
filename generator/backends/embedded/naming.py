"""Which word belongs to which region: outline, size and colour against the catalogue's shapes."""

from __future__ import annotations

import cv2
import numpy as np
from jaxtyping import Bool, UInt8
from scipy.optimize import linear_sum_assignment

from ...catalogue import CATEGORIES, Category, category
from ...errors import InputError
from ...geometry import mask_box
from .plane import TablePlane
from .silhouettes import GRID, Silhouette, overlap, silhouettes

_SIZE, _COLOR = 0.35, 0.002  # weights against the outlines' overlap, per e-fold and per CIELAB unit
_UNKNOWN = 0.55  # unlikeness of a word that the catalogue does not know
_SURE = ((0.2, 0.015), (0.33, 0.06))  # a region is named at this unlikeness and this lead
_SIZE_CAP, _COLOR_CAP = 1.5, 60.0  # e-folds, CIELAB units


def known(word: str) -> Category | None:
    """Return the catalogue's category for a word, or None if it has none."""
    try:
        return category(word)
    except InputError:
        return None


def name_things(
    image: UInt8[np.ndarray, "h w 3"],
    plane: TablePlane,
    masks: list[Bool[np.ndarray, "h w"]],
    wanted: tuple[str, ...],
) -> list[tuple[str, float] | None]:
    """Return a label and a score in [0, 1] for each region; None for regions too many.

    With words to expect, each word is given to one region, all together as alike as possible;
    regions left over are not wanted. Without, a region gets the category it is clearly like, else
    a word for its shape.
    """
    seen = [_seen(image, plane, mask) for mask in masks]
    if not wanted:
        return [_recognised(s, _elevation(plane)) for s in seen]
    cost = _costs(seen, wanted, _elevation(plane))
    names: list[tuple[str, float] | None] = [None] * len(seen)
    for row, column in zip(*linear_sum_assignment(cost), strict=True):
        names[row] = (wanted[column], float(np.clip(1 - cost[row, column], 0, 1)))
    return names


def total_unlikeness(
    image: UInt8[np.ndarray, "h w 3"],
    plane: TablePlane,
    masks: list[Bool[np.ndarray, "h w"]],
    wanted: tuple[str, ...],
) -> float:
    """Return how unlike regions are, together, to the words that fit them best."""
    cost = _costs([_seen(image, plane, mask) for mask in masks], wanted, _elevation(plane))
    return float(cost[linear_sum_assignment(cost)].sum())


def _elevation(plane: TablePlane) -> int:
    """Return the view's elevation to 5 degrees, as silhouettes are kept."""
    return int(5 * round(float(np.rad2deg(plane.view.elevation)) / 5))


def _seen(
    image: UInt8[np.ndarray, "h w 3"], plane: TablePlane, mask: Bool[np.ndarray, "h w"]
) -> Silhouette:
    """Describe a region as the catalogue's outlines are described."""
    x0, y0, x1, y1 = mask_box(mask).astype(int)
    crop = mask[y0:y1, x0:x1]
    side = max(crop.shape)
    canvas = np.zeros((side, side), np.float32)
    top, left = (side - crop.shape[0]) // 2, (side - crop.shape[1]) // 2
    canvas[top : top + crop.shape[0], left : left + crop.shape[1]] = crop
    shape = cv2.resize(canvas, (GRID, GRID), interpolation=cv2.INTER_AREA) > 0.5
    foot = plane.camera.on_plane(np.array([[(x0 + x1) / 2, float(y1)]]), 0.0)
    metre = float(plane.camera.to_camera(foot)[0, 2]) / plane.camera.focal
    pixels = image[mask].astype(np.float32)[None] / 255.0
    color = cv2.cvtColor(pixels, cv2.COLOR_RGB2LAB)[0].mean(0).astype(float)
    return Silhouette(shape, np.array([x1 - x0, y1 - y0]) * metre, color)


def _unlikeness(seen: Silhouette, key: str, elevation: int, variants: int) -> float:
    """Return how unlike a region is to a category: 0 the same, 1 and more unlike."""
    best = np.inf
    for form in silhouettes(key, elevation, variants):
        scale = abs(float(np.log(np.prod(seen.size) / np.prod(form.size)))) / 2
        color = float(np.linalg.norm(seen.color - form.color))
        rest = _SIZE * min(scale, _SIZE_CAP) + _COLOR * min(color, _COLOR_CAP)
        if rest < best:
            best = min(best, 1 - overlap(seen.shape, form.shape) + rest)
    return best


def _costs(seen: list[Silhouette], wanted: tuple[str, ...], elevation: int) -> np.ndarray:
    """Return how unlike each region is to each word."""
    cost = np.full((len(seen), len(wanted)), _UNKNOWN)
    for column, word in enumerate(wanted):
        found = known(word)
        if word in wanted[:column]:
            cost[:, column] = cost[:, wanted.index(word)]
        elif found is not None:
            cost[:, column] = [_unlikeness(s, found.key, elevation, 2) for s in seen]
    return cost


def _recognised(seen: Silhouette, elevation: int) -> tuple[str, float]:
    costs = sorted((_unlikeness(seen, key, elevation, 1), key) for key in CATEGORIES)
    (cost, key), (runner_up, _) = costs[:2]
    if any(cost < limit and runner_up - cost > lead for limit, lead in _SURE):
        return CATEGORIES[key].noun, float(1 - cost)
    return _shape_word(seen), 0.3


def _shape_word(seen: Silhouette) -> str:
    """Return "tall", "flat", "round" or plain "object" after a region's outline."""
    width, height = seen.size
    box = seen.shape.sum() / max(np.ptp(np.nonzero(seen.shape), axis=1).clip(1).prod(), 1)
    if height > 1.6 * width:
        return "tall object"
    if width > 1.6 * height:
        return "flat object"
    return "round object" if 0.72 < box < 0.86 else "object"
