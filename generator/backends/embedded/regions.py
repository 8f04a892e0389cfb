"""Which pixels belong to the table, and which to the things on it.

On the top, whatever is not the bare surface is part of a thing; above the far edge, whatever is not
background; below the front edge everything is the table's front and legs.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float

from .outline import background_patch, flat_patches, gradient
from .plane import TablePlane
from .surface import bare, bare_top, disc, reach, smooth_color, wider

_OUTLINE_EDGE = 3.0  # most of a thing's outline has at least this
_WISP_EDGE = 4.0  # thin parts of a thing have at least this beside them
_FAINT_EDGE = 0.8  # an outline against the background has at least this
_SMALLEST = 2.5e-4  # of the picture: fewer pixels are a speck


@dataclass(frozen=True, eq=False)
class Regions:
    """The table's pixels and the connected things on it, at working size, largest first."""

    table: Bool[np.ndarray, "h w"]
    things: tuple[Bool[np.ndarray, "h w"], ...]
    strength: Float[np.ndarray, "h w"]


def find_regions(lab: Float[np.ndarray, "h w 3"], plane: TablePlane) -> Regions:
    """Separate the table and the things on it in a working copy of the picture."""
    size = (lab.shape[0], lab.shape[1])
    top = plane_at(plane, size)
    strength = gradient(lab)
    around = ~wider(top, 2)
    background = background_patch(flat_patches(strength, 1.0, 4)) & around
    if not background.any():
        background = ~wider(top, 9)
    far = int(np.flatnonzero(top.any(1))[0])  # above, no floor can lie in the table's shadow
    sky = np.arange(size[0])[:, None] < far
    floor = bare(lab, strength, background, ~top)
    ground = np.where(sky, _open_ground(lab, strength, background), floor)
    other = np.where(top, ~bare_top(lab, strength, plane, top), ~ground)
    other = cv2.morphologyEx(other.astype(np.uint8), cv2.MORPH_CLOSE, disc(1)) > 0
    raw = _firm(other & above_front(top), strength)
    edge = cv2.morphologyEx(top.astype(np.uint8), cv2.MORPH_GRADIENT, disc(3)) > 0
    grown = cv2.morphologyEx((raw & ~edge).astype(np.uint8), cv2.MORPH_OPEN, disc(1)) > 0
    for _ in range(5):
        grown = wider(grown, 1) & raw
    things = _components(grown, top, strength)
    covered = np.any(things, axis=0) if things else np.zeros_like(top)
    below = other & ~above_front(top)
    return Regions((top & ~covered) | _largest_touching(below, top), things, strength)


def _open_ground(
    lab: Float[np.ndarray, "h w 3"],
    strength: Float[np.ndarray, "h w"],
    background: Bool[np.ndarray, "h w"],
) -> Bool[np.ndarray, "h w"]:
    """Return the background that a ball reaches from the border without touching a faint edge.

    A white thing before a white ground has at least a faint outline; its inside is not reached.
    """
    color, spread = smooth_color(lab, background)
    plain = (np.abs(lab - color) < 3.5 * spread).all(-1)
    reached = background_patch(flat_patches(strength, _FAINT_EDGE, 4))
    return reached | (plain & wider(reached, 4))


def above_front(plane_mask: Bool[np.ndarray, "h w"]) -> Bool[np.ndarray, "h w"]:
    """Return the pixels that are not below the top's front edge (where the legs are)."""
    h = plane_mask.shape[0]
    lowest = np.where(plane_mask.any(0), h - plane_mask[::-1].argmax(0), -1)
    columns = np.flatnonzero(lowest >= 0)
    lowest[: columns[0]], lowest[columns[-1] + 1 :] = lowest[columns[0]], lowest[columns[-1]]
    return np.arange(h)[:, None] < lowest[None, :]


def _firm(
    mask: Bool[np.ndarray, "h w"], strength: Float[np.ndarray, "h w"]
) -> Bool[np.ndarray, "h w"]:
    """Drop thin wisps without an edge: remains of shadows and reflections."""
    thick = cv2.morphologyEx(mask.astype(np.uint8), cv2.MORPH_OPEN, disc(3)) > 0
    edged = cv2.dilate(strength.astype(np.float32), disc(2)) >= _WISP_EDGE
    return mask & (thick | edged)


def _components(
    mask: Bool[np.ndarray, "h w"],
    top: Bool[np.ndarray, "h w"],
    strength: Float[np.ndarray, "h w"],
) -> tuple[Bool[np.ndarray, "h w"], ...]:
    """Return the connected things on the top, largest first, without what is part of the top."""
    beside = cv2.dilate(strength.astype(np.float32), disc(2))
    closed = cv2.morphologyEx(mask.astype(np.uint8), cv2.MORPH_CLOSE, disc(1))
    _, numbers, stats, _ = cv2.connectedComponentsWithStats(closed, connectivity=8)
    on_top, rim = wider(top, 3), top & (cv2.erode(top.astype(np.uint8), disc(5)) == 0)
    found = []
    for k in np.argsort(-stats[1:, cv2.CC_STAT_AREA]) + 1:
        own = numbers == k
        if stats[k, cv2.CC_STAT_AREA] < _SMALLEST * mask.size:
            break
        thick = cv2.distanceTransform(own.astype(np.uint8), cv2.DIST_L2, 3).max()
        outline = own & (cv2.erode(own.astype(np.uint8), disc(1)) == 0)
        clear = thick >= 2.0 and np.median(beside[outline]) >= _OUTLINE_EDGE
        if clear and (own & on_top).any() and not _is_edge_strip(own, outline, top, rim):
            found.append(own)
    return tuple(found)


def _is_edge_strip(
    own: Bool[np.ndarray, "h w"],
    outline: Bool[np.ndarray, "h w"],
    top: Bool[np.ndarray, "h w"],
    rim: Bool[np.ndarray, "h w"],
) -> bool:
    """Return whether a region lies flat in the top and along its edge: an outer plank."""
    inside = (own & top).sum() > 0.97 * own.sum()
    return bool(inside and (outline & rim).sum() > 0.25 * outline.sum())


def _largest_touching(mask: np.ndarray, top: np.ndarray) -> Bool[np.ndarray, "h w"]:
    """Return the parts of ``mask`` that touch the tabletop: its front and its legs."""
    touching = (cv2.dilate(top.astype(np.uint8), disc(3)) > 0) & mask
    return reach(touching, mask) if touching.any() else np.zeros_like(top)


def plane_at(plane: TablePlane, size: tuple[int, int]) -> Bool[np.ndarray, "h w"]:
    """Return the inside of the tabletop's outline at another picture size (height, width)."""
    canvas = np.zeros(size, np.uint8)
    factor = size[1] / plane.camera.width
    cv2.fillPoly(canvas, [np.round(plane.outline * factor - 0.5).astype(np.int32)], 1)
    return canvas > 0
