"""Object proposals from a table's depth map, and corrections of detections.

A detector that uses only colours confuses prints and parts with objects. Depth shows flat regions,
regions that belong together, and missed objects.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np
from jaxtyping import Float

from ....geometry import mask_box
from ....language.names import shape_word
from ....meshes.pixels import Mask, dilate, erode, hull_of
from ....scene import Detection
from ..plane.plane import TablePlane, outline_distance
from .measure import ObservedSolid, holds, measure_solid, steady, table_points
from .plane import TALLEST, noise

_BESIDE = 0.03  # metres by which an object may extend over the table's edge
_LEAST = 3e-4  # minimum area of an object, as a fraction of the picture
# thresholds that separate islands, as fractions of a region's height
_WATERLINES = (0.1, 0.2, 0.3, 0.4)
_LOW = 0.006  # minimum height of an object in metres
_KNOWN = 0.3  # minimum fraction of an object's pixels with valid depth
_FLAT = 0.15  # an object is flat if a smaller fraction of these pixels stands above the table
_SURE = 0.6  # minimum confidence of a flat object
_CERTAIN = 0.75  # confidence above which a seemingly hovering object may have a hidden foot
_KEPT = 0.6  # minimum fraction of a mask that remains without the surrounding tabletop
_GROWN = 4.0  # maximum growth factor of a mask's area
_HOVER = 0.03  # metres above the table at which the foot of an unsupported object hovers
_HELD = 0.45  # minimum fraction of an object above its support
_BROAD = 0.6  # minimum width of a support, relative to the object's width
_JUMP = 0.03  # depth difference in metres that separates two touching objects
_BAND = 0.04  # width of the band around a seam, as a fraction of the picture's longer side
_LEVEL = 0.005  # metres; closer points belong to a plane
_MISSED = 0.03  # minimum height in metres of an object that was not detected
_SHREDS = 0.014  # maximum width of edge artefacts, as a fraction of the picture's longer side
_GUESS = 0.5  # confidence of such an object
_FLOOR = (0.25, 1.3)  # depth in metres of the floor below a tabletop
_FLOOR_AREA = 0.15  # m²; minimum visible area of the floor
_CELL, _LAYER = 0.05, 0.02  # metres; side and height of the cells in which area is counted


def heights_above(
    depth: Float[np.ndarray, "h w"], plane: TablePlane
) -> tuple[Float[np.ndarray, "h w"], Mask, Mask]:
    """Return heights above the tabletop (in metres, or NaN), and masks of raised and level pixels.

    Raised pixels belong to objects that rise above the table; level pixels are at its height,
    within this depth map's accuracy. Both masks are limited to the tabletop's outline.
    """
    points = table_points(depth, plane.camera)
    height = points[..., 2]
    spread = noise(np.where(depth > 0, depth, 0.0))
    flat = np.abs(height) < spread
    level = 1.4826 * float(np.median(np.abs(height[flat]))) if flat.any() else 0.0
    usual = float(np.median(spread[flat])) if flat.any() else 1.0
    lowest = np.maximum(_LOW, 3.0 * level * np.maximum(spread / usual, 1))
    places = np.nan_to_num(points[..., :2].reshape(-1, 2))
    off = outline_distance(places, plane.shape, plane.flipped, plane.size, plane.radius)
    near = (off < _BESIDE).reshape(depth.shape)
    return height, near & (height > lowest) & (height < TALLEST), near & (np.abs(height) <= lowest)


def _regions(pieces: Sequence[Mask], height: Float[np.ndarray, "h w"]) -> tuple[Mask, ...]:
    """Return the pieces, split at deep saddles and slightly enlarged, from largest to smallest."""
    known, least = np.nan_to_num(height), int(_LEAST * height.size)
    masks = [part for piece in pieces for part in _part(piece, known, least)]
    masks.sort(key=lambda m: (-int(m.sum()), int(m.argmax())))
    return tuple(dilate(mask, 3) for mask in masks)


def _standing_pieces(depth: Float[np.ndarray, "h w"], standing: Mask) -> list[Mask]:
    """Return the connected regions of the raised pixels, split at depth discontinuities."""
    high = (standing & steady(depth)).astype(np.uint8)
    opened = cv2.morphologyEx(high, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8)) > 0
    return _pieces(opened, int(_LEAST * depth.size))


def _pieces(mask: Mask, minimum: int) -> list[Mask]:
    """Return the connected parts of ``mask`` with at least ``minimum`` pixels."""
    count, numbers, stats, _ = cv2.connectedComponentsWithStats(
        mask.astype(np.uint8), connectivity=4
    )
    return [numbers == k for k in range(1, count) if stats[k, cv2.CC_STAT_AREA] >= minimum]


def _part(region: Mask, height: Float[np.ndarray, "h w"], minimum: int) -> list[Mask]:
    """Split a region into parts above a height threshold; other pixels join the nearest part."""
    tall = float(np.percentile(height[region], 98))
    for share in _WATERLINES:
        islands = _pieces(region & (height > share * tall), minimum)
        if len(islands) > 1:
            away = [cv2.distanceTransform((~i).astype(np.uint8), cv2.DIST_L2, 3) for i in islands]
            nearest = np.argmin(away, axis=0)
            shores = (region & (nearest == k) for k in range(len(islands)))
            return [part for shore in shores for part in _part(shore, height, minimum)]
    return [region]


# ------------------------------------------------------------------------------ detections


def confirm(
    found: Sequence[Detection], depth: Float[np.ndarray, "h w"], plane: TablePlane
) -> list[Detection]:
    """Return a detector's detections, corrected with the depth map.

    Uncertain detections that are level with the table are removed, masks lose the tabletop around
    their object, and unsupported upper parts are merged with the object to which they belong or
    extended down to their base. Objects that rise above the table but were not detected are added.
    All other outlines are the detector's, because those of depth maps are ragged.
    """
    height, standing, lying = heights_above(depth, plane)
    things = [t for d in found if (t := _judge(d, height, standing, lying)) is not None]
    pieces = _standing_pieces(depth, standing)
    regions = _regions(pieces, height)
    things += _find_missed(things, [*pieces, *regions], height)
    things = _rejoin(things, depth, plane)
    return _grow(things, regions, depth, plane)


def _judge(
    thing: Detection, height: Float[np.ndarray, "h w"], standing: Mask, lying: Mask
) -> Detection | None:
    """Return a detection without the surrounding tabletop, or None if it is flat and uncertain."""
    mask = np.asarray(thing.mask)
    known = mask & np.isfinite(height)
    if known.sum() < _KNOWN * mask.sum():
        return thing
    if (standing & mask).sum() < _FLAT * known.sum():
        return thing if thing.score >= _SURE else None
    foot = max(3, int(0.1 * np.sqrt(mask.sum())))  # pixels; the foot itself is level with the table
    near = dilate(standing & mask, 2 * foot + 1)
    # the low inside of a bowl belongs to it
    spill = mask & lying & ~near & ~hull_of(standing & mask)
    kept = mask & ~spill
    if not spill.any() or kept.sum() < _KEPT * mask.sum():
        return thing
    return _with_mask(thing, kept, None if thing.full is None else thing.full & ~spill)


def _with_mask(thing: Detection, mask: Mask, full: Mask | None) -> Detection:
    full = None if full is None else full | mask
    return replace(thing, mask=mask, box=mask_box(mask), full=full)


def _rejoin(
    things: list[Detection], depth: Float[np.ndarray, "h w"], plane: TablePlane
) -> list[Detection]:
    """Merge each unsupported upper part into the lower part next to it at a similar depth.

    A confident detection may have a hidden foot: it is merged only if it continues the other's flat
    side.
    """
    points = table_points(depth, plane.camera)
    solids = [measure_solid(np.asarray(t.mask), depth, plane) for t in things]
    order = sorted(range(len(things)), key=lambda k: -(s.bottom if (s := solids[k]) else 0.0))
    left: dict[int, Detection] = dict(enumerate(things))
    for part in order:
        upper = solids[part]
        if upper is None or upper.bottom < _HOVER:
            continue
        certain = things[part].score >= _CERTAIN
        others = {k: s for k in left if k != part and (s := solids[k]) is not None}
        if any(_carries(s, upper) for s in others.values()):
            continue
        touching = {
            k: _contact(left[part], left[k], depth)
            for k, s in others.items()
            if s.bottom < upper.bottom and (not certain or _one_side(left[part], left[k], points))
        }
        below = max(touching, key=lambda k: (touching[k], -k), default=None)
        if below is not None and touching[below] > 0:
            left[below] = _union(left[below], left.pop(part))
            solids[below] = measure_solid(np.asarray(left[below].mask), depth, plane)
    return [left[k] for k in sorted(left)]


def _carries(below: ObservedSolid, upper: ObservedSolid) -> bool:
    """Return whether ``upper`` may stand on ``below``, which must be underneath and wide enough."""
    return holds(below, upper) > _HELD and below.extent[1] > _BROAD * upper.extent[1]


def _one_side(one: Detection, other: Detection, points: Float[np.ndarray, "h w 3"]) -> bool:
    """Return whether two detections meet on one flat surface, like a box and the print on it."""
    a, b = np.asarray(one.mask), np.asarray(other.mask)
    side = 2 * round(_BAND * max(a.shape)) + 1
    known = np.isfinite(points).all(-1)
    here = points[a & known & dilate(b, side)]
    there = points[b & known & dilate(a, side)]
    if min(len(here), len(there)) < side:
        return False
    middle = np.median(here, axis=0)
    normal = np.linalg.svd(here - middle, full_matrices=False)[2][2]
    return max(float(np.median(np.abs((p - middle) @ normal))) for p in (here, there)) < _LEVEL


def _contact(one: Detection, other: Detection, depth: Float[np.ndarray, "h w"]) -> int:
    """Return the number of ``one``'s pixels next to ``other`` in the picture at a similar depth."""
    a, b = np.asarray(one.mask), np.asarray(other.mask)
    here, there = a & dilate(b, 9) & (depth > 0), b & dilate(a, 9) & (depth > 0)
    if here.sum() < np.sqrt(min(a.sum(), b.sum())) or not there.any():
        return 0
    gap = abs(float(np.median(depth[here])) - float(np.median(depth[there])))
    return int(here.sum()) if gap < _JUMP else 0


def _union(one: Detection, other: Detection) -> Detection:
    """Return the union of two parts, labelled like the larger one."""
    larger = max(one, other, key=lambda d: int(np.asarray(d.mask).sum()))
    mask = np.asarray(one.mask) | np.asarray(other.mask)
    full = np.any([mask, *(d.full for d in (one, other) if d.full is not None)], axis=0)
    return Detection(larger.label, mask_box(mask), mask, max(one.score, other.score), full)


def _grow(
    things: list[Detection],
    regions: Sequence[Mask],
    depth: Float[np.ndarray, "h w"],
    plane: TablePlane,
) -> list[Detection]:
    """Extend seemingly floating detections into regions that touch no other detection."""
    taken = [np.asarray(t.mask) for t in things]
    grown = list(things)
    for region in regions:
        size = float(region.sum())
        owners = [k for k, m in enumerate(taken) if (m & region).sum() > 0.05 * size]
        if len(owners) != 1:
            continue
        (k,) = owners
        wider = taken[k] | (region & ~np.logical_or.reduce(taken))
        solid = measure_solid(taken[k], depth, plane)
        if solid is not None and solid.bottom > _HOVER and wider.sum() < _GROWN * taken[k].sum():
            grown[k] = _with_mask(grown[k], wider, grown[k].full)
    return grown


def _find_missed(
    things: Sequence[Detection], regions: Sequence[Mask], height: Float[np.ndarray, "h w"]
) -> list[Detection]:
    """Return raised objects that are missing from ``things``, labelled by their shape."""
    seen = np.any([np.zeros(height.shape, bool), *(t.mask for t in things)], axis=0)
    added = []
    shred = max(3, round(_SHREDS * max(height.shape)))
    for region in regions:
        mask, area = region & ~seen, region.sum()
        if (region & seen).sum() > 0.1 * area or erode(mask, shred).sum() < 0.3 * area:
            continue
        if float(np.nanpercentile(height[region], 90)) < _MISSED:
            continue
        seen |= region
        x0, y0, x1, y1 = box = mask_box(mask)
        label = shape_word(x1 - x0, y1 - y0, float(mask.sum() / ((x1 - x0) * (y1 - y0))))
        added.append(Detection(label, box, mask, _GUESS))
    return added


# --------------------------------------------------------------------------------- the floor


def height_above_floor(depth: Float[np.ndarray, "h w"], plane: TablePlane) -> float | None:
    """Return the height of the tabletop above the floor in metres, or None if it is unknown.

    The floor is the level below the table with the largest visible area.
    """
    points = table_points(depth, plane.camera)[::3, ::3].reshape(-1, 3)
    low = points[(points[:, 2] < -_FLOOR[0]) & (points[:, 2] > -_FLOOR[1])]
    if not len(low):
        return None
    cells = np.round(low / [_CELL, _CELL, _LAYER]).astype(int)
    layers = -np.unique(cells, axis=0)[:, 2]
    areas = np.bincount(layers, minlength=int(_FLOOR[1] / _LAYER) + 2) * _CELL**2
    areas = np.convolve(areas, np.ones(3), "same")
    best = int(areas.argmax())
    # walls contribute equally to all layers
    upright = float(np.median(areas[int(_FLOOR[0] / _LAYER) :]))
    if areas[best] - upright < _FLOOR_AREA:
        return None
    return -float(np.median(low[np.abs(low[:, 2] + best * _LAYER) < 1.5 * _LAYER, 2]))
