"""Training targets: crops of samples, and their dense targets."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
from jaxtyping import Bool, Float, Int, UInt8

from generator.backends.embedded.eye.closeups import CELL, Closeup, closeup
from generator.backends.embedded.eye.network import CLOSEUP, HINTS, STRIDE
from generator.geometry import Camera, view_rotation

from .pictures.nothing import nothing
from .sample import UNNAMED, Sample

_SMALLEST = 14  # minimum visible pixels of an object in the crop
_CORE = 0.5  # fraction of the maximum distance from the outline at which cells predict their object
_FALL = 0.3  # decay of the target certainty towards the outline
_MOST = {False: 7, True: 14}  # objects per crop, and per whole picture, whose masks are trained
_CELLS = 2  # number of cells that predict each of them
_USUAL = 0.8  # angle below the horizon, radians, where the picture does not determine it
_NAMED = {False: 4, True: 8}  # objects per sample that are named, likewise
_READABLE = 100  # minimum visible pixels for a name
_FINE = 2  # picture pixels per cell of the mask targets


@dataclass(frozen=True, eq=False)
class Crop:
    """A crop of a sample, with targets; "cells" are ``STRIDE`` pixels wide.

    ``weight`` is 0 at objects too small to be detected; ``things`` is the object index of each
    cell, 0 for none. ``cells``, ``boxes`` and ``masks`` are those of the predicting cells: column
    and row, the distances in cells to the visible and the whole box, both masks at half size.
    ``looks``, ``shown``, ``hints`` and ``category`` are those of objects of the sample seen in
    close-up; a category of -1 is unknown.
    """

    image: UInt8[np.ndarray, "s s 3"]
    heat: Float[np.ndarray, "c c"]
    weight: Float[np.ndarray, "c c"]
    things: UInt8[np.ndarray, "c c"]
    region: UInt8[np.ndarray, "c c"]
    top: Bool[np.ndarray, "c c"]
    latitude: Float[np.ndarray, "d d"]
    cells: Int[np.ndarray, "k 2"]
    boxes: Float[np.ndarray, "k 8"]
    masks: Bool[np.ndarray, "k 2 f f"]
    looks: UInt8[np.ndarray, "n l l 3"]
    shown: Float[np.ndarray, "n m m"]
    hints: Float[np.ndarray, "n 3"]
    category: Int[np.ndarray, "n"]


def window(sample: Sample, rng: np.random.Generator, entire: bool = False) -> tuple[int, int, int]:
    """Choose a square to crop: (left, top, side); (nearly) all, a part, or around one object."""
    height, width = sample.visible.shape
    most, draw = min(height, width), rng.random()
    ids = np.unique(sample.visible)
    ids = ids[ids > 0]
    if entire or draw < 0.3 or (draw > 0.55 and not len(ids)):
        side = int(most * rng.uniform(0.85, 1.0))
    elif draw < 0.55:
        side = int(most * rng.uniform(0.4, 0.85))
    else:
        own = np.argwhere(sample.visible == rng.choice(ids))
        low, high = own.min(0), own.max(0) + 1
        side = int(np.clip(float((high - low).max()) * rng.uniform(1.25, 2.6), 48, most))
        middle = (low + high) / 2 + rng.uniform(-0.12, 0.12, 2) * side
        y, x = np.clip((middle - side / 2).astype(int), 0, [height - side, width - side])
        return int(x), int(y), side
    return int(rng.integers(width - side + 1)), int(rng.integers(height - side + 1)), side


def cut(sample: Sample, size: int, rng: np.random.Generator, entire: bool = False) -> Crop:
    """Crop a random square of a sample, scaled to ``size`` pixels (a multiple of 32)."""
    x, y, side = window(sample, rng, entire)
    flip = rng.random() < 0.5
    inside = np.s_[y : y + side, x : x + side]
    step = -1 if flip else 1

    def scale(picture: np.ndarray, to: int, way: int) -> np.ndarray:
        part = np.ascontiguousarray(picture[inside][:, ::step])
        return cv2.resize(part, (to, to), interpolation=way)

    way = cv2.INTER_AREA if side > size else cv2.INTER_LINEAR
    visible = scale(sample.visible, size, cv2.INTER_NEAREST)
    image = scale(sample.image, size, way)
    heat, weight, chosen = _hearts(visible, rng, _MOST[entire])
    grid = size // STRIDE
    cells, boxes, masks = [], [], []
    fine = size // _FINE
    for index, spots in chosen:
        whole = scale(sample.full[index - 1].astype(np.uint8), size, cv2.INTER_NEAREST) > 0
        seen = visible == index
        both = np.stack([_shrink(seen, fine), _shrink(whole | seen, fine)])
        for spot in spots:
            cells.append(spot)
            boxes.append(np.concatenate([_reach(seen, spot), _reach(whole | seen, spot)]))
            masks.append(both)
    half = size // (2 * STRIDE)
    return Crop(
        _jitter(image, rng),
        heat,
        weight,
        cv2.resize(visible, (grid, grid), interpolation=cv2.INTER_NEAREST),
        scale(sample.region, grid, cv2.INTER_NEAREST),
        scale(sample.top.astype(np.uint8), grid, cv2.INTER_NEAREST) > 0,
        _angles(sample, (x, y, side), half, flip),
        np.array(cells, np.int64).reshape(-1, 2),
        np.array(boxes, np.float32).reshape(-1, 8),
        np.array(masks, bool).reshape(-1, 2, fine, fine),
        *closeups(sample, rng, _NAMED[entire]),
    )


def blank(size: int, rng: np.random.Generator) -> Crop:
    """Return a picture without a table: there are no objects and no view."""
    grid, half, fine = size // STRIDE, size // (2 * STRIDE), size // _FINE
    return Crop(
        _jitter(nothing(size, rng), rng),
        np.zeros((grid, grid), np.float32),
        np.ones((grid, grid), np.float32),
        np.zeros((grid, grid), np.uint8),
        np.zeros((grid, grid), np.uint8),
        np.zeros((grid, grid), bool),
        np.full((half, half), _USUAL, np.float32),
        np.zeros((0, 2), np.int64),
        np.zeros((0, 8), np.float32),
        np.zeros((0, 2, fine, fine), bool),
        *_side_by_side([], []),
    )


def closeups(
    sample: Sample, rng: np.random.Generator, maximum: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return close-ups of some objects of a sample: the last four fields of a :class:`Crop`."""
    area = np.bincount(sample.visible.ravel(), minlength=len(sample.full) + 1)[1:]
    share = area / np.maximum(sample.full.sum((1, 2)), 1)
    told = sample.category != UNNAMED
    readable = np.flatnonzero((area >= _READABLE) & (share >= 0.15) & told)
    looks: list[Closeup] = []
    chosen = rng.permutation(readable)[:maximum]
    for k in chosen:
        mask = _roughen(sample.visible == k + 1, rng)
        slip = rng.normal(0.0, 0.05, 4)
        look = closeup(sample.image, mask, float(sample.top.sum()), slip)
        if rng.random() < 0.5:
            image, visible = look.image[:, ::-1], look.visible[:, ::-1]
            look = replace(look, image=np.ascontiguousarray(image), visible=visible)
        looks.append(replace(look, image=_jitter(look.image, rng)))
    return _side_by_side(looks, [int(c) for c in sample.category[chosen]])


def _roughen(mask: Bool[np.ndarray, "h w"], rng: np.random.Generator) -> np.ndarray:
    """Return a mask with typical errors of the eye: slightly too wide or too narrow."""
    grow = int(rng.integers(-1, 3))
    if grow == 0:
        return mask
    way = cv2.dilate if grow > 0 else cv2.erode
    changed = way(mask.astype(np.uint8), np.ones((3, 3), np.uint8), iterations=abs(grow)) > 0
    return changed if changed.any() else mask


def _side_by_side(
    looks: list[Closeup], category: list[int]
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    count, cells = len(looks), CLOSEUP // CELL
    return (
        np.array([x.image for x in looks], np.uint8).reshape(count, CLOSEUP, CLOSEUP, 3),
        np.array([x.visible for x in looks], np.float32).reshape(count, cells, cells),
        np.array([x.hints for x in looks], np.float32).reshape(count, HINTS),
        np.array(category, np.int64),
    )


def _angles(
    sample: Sample, place: tuple[int, int, int], count: int, flip: bool
) -> Float[np.ndarray, "d d"]:
    """Return the angle below the horizon at the centre of each of ``count`` cells per side."""
    x, y, side = place
    middle = (np.arange(count) + 0.5) * side / count
    columns, rows = np.meshgrid(x + (middle[::-1] if flip else middle), y + middle)
    height, width = sample.visible.shape
    camera = Camera(np.zeros(3), view_rotation(sample.view), sample.view.fov, width, height)
    rays = camera.rays(np.column_stack([columns.ravel(), rows.ravel()]))
    return np.arcsin(np.clip(-rays[:, 2], -1, 1)).reshape(count, count).astype(np.float32)


def _hearts(
    visible: UInt8[np.ndarray, "s s"], rng: np.random.Generator, maximum: int
) -> tuple[np.ndarray, np.ndarray, list[tuple[int, np.ndarray]]]:
    """Return the target certainty, its weight, and cells (column, row) for some objects."""
    grid = visible.shape[0] // STRIDE
    heat, weight = np.zeros((grid, grid), np.float32), np.ones((grid, grid), np.float32)
    found: list[tuple[int, np.ndarray]] = []
    for index in np.unique(visible[visible > 0]):
        seen = visible == index
        rows, columns = np.flatnonzero(seen.any(1)), np.flatnonzero(seen.any(0))
        y0, y1, x0, x1 = rows[0], rows[-1] + 1, columns[0], columns[-1] + 1
        part = np.pad(seen[y0:y1, x0:x1], 1).astype(np.uint8)
        depth = np.zeros(visible.shape, np.float32)
        depth[y0:y1, x0:x1] = cv2.distanceTransform(part, cv2.DIST_L2, 3)[1:-1, 1:-1]
        blocks = depth.reshape(grid, STRIDE, grid, STRIDE).max((1, 3))
        if part.sum() < _SMALLEST:
            weight[blocks > 0] = 0
            continue
        share = blocks / blocks.max()
        wished = np.exp(-(((1 - share) / _FALL) ** 2)) * (blocks > 0)
        heat = np.maximum(heat, wished.astype(np.float32))
        core = np.argwhere((share > _CORE) & (blocks > 0))
        picked = core[rng.permutation(len(core))[: _CELLS - 1]]
        best = np.array(np.unravel_index(int(blocks.argmax()), blocks.shape))[None]
        found.append((int(index), np.concatenate([best, picked])[:, ::-1]))
    order = rng.permutation(len(found))[:maximum]
    return heat, weight, [found[k] for k in order]


def _reach(mask: Bool[np.ndarray, "s s"], cell: Int[np.ndarray, "2"]) -> Float[np.ndarray, "4"]:
    """Return the distances from the cell's centre to the mask's box: left, top, right, bottom."""
    rows, columns = np.flatnonzero(mask.any(1)), np.flatnonzero(mask.any(0))
    x, y = (cell + 0.5) * STRIDE
    sides = np.array([x - columns[0], y - rows[0], columns[-1] + 1 - x, rows[-1] + 1 - y])
    return np.maximum(sides / STRIDE, 0.25)


def _shrink(mask: Bool[np.ndarray, "s s"], size: int) -> Bool[np.ndarray, "f f"]:
    return cv2.resize(mask.astype(np.uint8) * 255, (size, size), interpolation=cv2.INTER_AREA) > 127


def _jitter(image: UInt8[np.ndarray, "s s 3"], rng: np.random.Generator) -> np.ndarray:
    """Change brightness, contrast and colour slightly; add blur, grey or noise sometimes."""
    if rng.random() < 0.3:
        image = cv2.GaussianBlur(image, (0, 0), rng.uniform(0.4, 1.3))
    if rng.random() < 0.08:
        image = np.repeat(cv2.cvtColor(image, cv2.COLOR_RGB2GRAY)[..., None], 3, 2)
    gain = (rng.uniform(0.85, 1.12) * rng.uniform(0.95, 1.05, 3)).astype(np.float32)
    contrast = np.float32(rng.uniform(0.85, 1.15))
    x = image * (contrast * gain) + (128 - 128 * contrast) * gain
    if rng.random() < 0.5:
        x += rng.standard_normal(x.shape, np.float32) * np.float32(rng.uniform(0, 4))
    return np.clip(x, 0, 255).astype(np.uint8)
