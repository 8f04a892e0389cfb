"""The bare tabletop: which pixels show nothing but the table's own surface.

Its colour is a smooth function of place, or a pattern that is everywhere (grain, veins, planks).
What can be reached from it without crossing an edge, while only the light changes, is a shadow or
a reflection on it.
"""

from __future__ import annotations

import cv2
import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.ndimage import maximum_filter, median_filter, uniform_filter

from .outline import flat_patches
from .plane import TablePlane

_SHADOW_EDGE = 2.6  # CIELAB units per pixel: the steepest edge of a soft shadow
_GLOW_EDGE = 1.2  # the steepest edge of coloured light or of a coloured shadow
_TINT = 14.0  # CIELAB units by which such light changes the hue
_DARKEST = 0.55  # share of the light that a shadow leaves
_PATTERN = 0.08  # of the top: a pattern must explain this much more than one even colour
_SPREAD = 0.33  # of the top's cells: a pattern must explain something in this many
_PLANK, _PLANK_EDGE = 0.02, 2.5  # likewise for planks: share of the top, edges within
_PATTERN_EDGE = 5.8  # CIELAB units per pixel: a pattern's edges are softer than things' outlines
_ISLAND = 0.02  # of the top: cut-off bare spots below this lie inside things
_GRID = (12, 16)  # rows and columns of cells on the top
_ALONG, _ACROSS = 0.65, 0.9  # of a row, of a column of cells: what a plank's colour fills
_BIN, _BINS = 5.0, (21, 24, 24)  # CIELAB units of a colour bin, and bins along L, a, b
_BANDS = 160  # bands along each side of the top in which joints are sought


def disc(radius: int) -> np.ndarray:
    """Return a round structuring element."""
    return cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * radius + 1, 2 * radius + 1))


def wider(mask: Bool[np.ndarray, "h w"], radius: int) -> Bool[np.ndarray, "h w"]:
    """Return a mask dilated by ``radius`` pixels."""
    return cv2.dilate(mask.astype(np.uint8), disc(radius)) > 0


def reach(start: np.ndarray, allowed: np.ndarray) -> Bool[np.ndarray, "h w"]:
    """Return the parts of ``allowed`` connected to ``start``."""
    numbers = cv2.connectedComponents((allowed | start).astype(np.uint8), connectivity=4)[1]
    return np.isin(numbers, np.unique(numbers[start])) & (numbers > 0)


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


def _dimmed(
    lab: np.ndarray, color: np.ndarray, hue_limit: float | np.ndarray
) -> Bool[np.ndarray, "h w"]:
    """Return the pixels that are the surface's colour under less (or slightly more) light."""
    ratio = (lab[..., 0] + 8) / np.maximum(color[..., 0] + 8, 1)
    hue = np.abs(lab[..., 1:] - color[..., 1:] * np.clip(ratio, 0, 1.1)[..., None])
    return (ratio > _DARKEST) & (ratio < 1.15) & (hue < hue_limit).all(-1)


def bare(
    lab: Float[np.ndarray, "h w 3"],
    strength: Float[np.ndarray, "h w"],
    sure: Bool[np.ndarray, "h w"],
    within: Bool[np.ndarray, "h w"],
) -> Bool[np.ndarray, "h w"]:
    """Return the pixels of ``within`` that show the bare surface, shadows included."""
    color, spread = smooth_color(lab, sure)
    plain = (np.abs(lab - color) < 3.5 * spread).all(-1) & within
    darker = (lab[..., 0] < color[..., 0] + 3.5 * spread[0]) & (strength < _SHADOW_EDGE)
    shade = _dimmed(lab, color, 3.0 + 3 * spread[1:]) & darker
    glow = (_dimmed(lab, color, _TINT) & (strength < _GLOW_EDGE) & within).astype(np.uint8)
    glow = cv2.morphologyEx(glow, cv2.MORPH_OPEN, disc(2)) > 0
    return reach(plain, (shade | glow) & within) | plain


def patterned(
    lab: Float[np.ndarray, "h w 3"],
    strength: Float[np.ndarray, "h w"],
    place: Float[np.ndarray, "h w 2"],
    within: Bool[np.ndarray, "h w"],
) -> Bool[np.ndarray, "h w"]:
    """Return the pixels of ``within`` whose colour is part of the surface's pattern.

    Grain, planks and veins are everywhere; a thing is in one place. A colour belongs to the
    pattern if it occurs in half of all cells of a grid on the tabletop, or in nearly all cells of
    one row or column (a plank). ``place`` is each pixel's position on the top, 0 to 1. Shadows are
    the pattern's colours under less light, reached from it without crossing an edge.
    """
    code = _color_code(lab)
    rows, columns = _GRID
    cell = _cells(place)
    size = int(np.prod(_BINS))
    counts = np.bincount((cell * size + code)[within], minlength=rows * columns * size)
    counts = counts.reshape(rows, columns, *_BINS).astype(np.float32)
    near = uniform_filter(counts, 3, axes=(2, 3, 4), mode="constant") * 27
    total = counts.sum((2, 3, 4), keepdims=True)
    real = (total > 8)[..., 0, 0, 0]
    occupied = (near >= np.maximum(3.0, 0.01 * total)) & (total > 8)
    by_row = occupied.sum(1) / np.maximum(real.sum(1), 4)[:, None, None, None]
    by_column = occupied.sum(0) / np.maximum(real.sum(0), 4)[:, None, None, None]
    everywhere = occupied.sum((0, 1)) / max(int(real.sum()), 1)
    pattern = (everywhere >= 0.5) | (by_row.max(0) >= _ALONG) | (by_column.max(0) >= _ACROSS)
    pattern = pattern.ravel()
    known = within & pattern[code]
    shade = np.zeros_like(within)
    for light in (0.88, 0.76, 0.66):
        lit = np.dstack([(lab[..., 0] + 8) / light - 8, lab[..., 1:] / light])
        shade |= pattern[_color_code(lit)]
    return reach(known, shade & (strength < _SHADOW_EDGE) & within) | known


def _color_code(lab: Float[np.ndarray, "h w 3"]) -> Int[np.ndarray, "h w"]:
    """Number colours by the cube of ``_BIN`` CIELAB units they fall into."""
    shift = np.array([0.0, _BINS[1] * _BIN / 2, _BINS[2] * _BIN / 2])
    cubes = np.clip((lab + shift) / _BIN, 0, np.array(_BINS) - 1).astype(int)
    return (cubes[..., 0] * _BINS[1] + cubes[..., 1]) * _BINS[2] + cubes[..., 2]


def bare_top(
    lab: Float[np.ndarray, "h w 3"],
    strength: Float[np.ndarray, "h w"],
    plane: TablePlane,
    top: Bool[np.ndarray, "h w"],
) -> Bool[np.ndarray, "h w"]:
    """Return the bare pixels of the top: an even surface's, or a patterned one's if it is one."""
    inner = cv2.erode(top.astype(np.uint8), disc(4)) > 0
    patches = flat_patches(strength, 1.5, 2)
    counts = np.bincount(patches[inner & (patches > 0)], minlength=2)
    largest = inner & (patches == counts.argmax())
    even = bare(lab, strength, largest if largest.sum() > 0.08 * inner.sum() else inner, top)
    place = positions(plane, (lab.shape[0], lab.shape[1]))
    pattern = patterned(lab, strength, place, top)
    if _is_pattern(pattern & ~even & inner, inner, strength, place):
        even = even | pattern
    even = even | _planks(lab, strength, ~even & top, top, place)
    even |= _seams(~even & top, top, place)
    return even & ~_islands(even, _ISLAND * int(top.sum()), top & ~inner)


def _is_pattern(
    gained: Bool[np.ndarray, "h w"],
    inner: Bool[np.ndarray, "h w"],
    strength: Float[np.ndarray, "h w"],
    place: Float[np.ndarray, "h w 2"],
) -> bool:
    """Return whether what a pattern explains beyond an even colour is a pattern, not things.

    It must be soft, as planks are, or much, all over the top, and softer than things.
    """
    if gained.sum() < _PLANK * inner.sum():
        return False
    edge = float(np.percentile(strength[gained], 75))
    if edge < _PLANK_EDGE:
        return True
    cell = _cells(place)
    total = np.bincount(cell[inner], minlength=int(np.prod(_GRID)))
    share = np.bincount(cell[gained], minlength=len(total)) / np.maximum(total, 1)
    spread = (share[total > 20] > 0.1).mean()
    much = gained.sum() > _PATTERN * inner.sum()
    return bool(much and spread > _SPREAD and edge < _PATTERN_EDGE)


def _cells(place: Float[np.ndarray, "h w 2"]) -> Int[np.ndarray, "h w"]:
    """Number the cells of a grid on the top that pixels fall into, row by row."""
    rows, columns = _GRID
    row = np.clip(place[..., 1] * rows, 0, rows - 1).astype(int)
    return row * columns + np.clip(place[..., 0] * columns, 0, columns - 1).astype(int)


def _band_share(
    mask: Bool[np.ndarray, "h w"], top: Bool[np.ndarray, "h w"], slot: Int[np.ndarray, "h w"]
) -> Float[np.ndarray, "n"]:
    """Return how much of each band of the top a mask covers."""
    covered = np.bincount(slot[mask], minlength=_BANDS)
    return covered / np.maximum(np.bincount(slot[top], minlength=_BANDS), 1)


def _planks(
    lab: Float[np.ndarray, "h w 3"],
    strength: Float[np.ndarray, "h w"],
    mask: Bool[np.ndarray, "h w"],
    top: Bool[np.ndarray, "h w"],
    place: Float[np.ndarray, "h w 2"],
) -> Bool[np.ndarray, "h w"]:
    """Return the bare parts of bands that nothing of the known surface shows in: other planks.

    Things never fill a band from side to side, so the colour that most of such a band has is the
    table's.
    """
    slot = np.clip(place[..., 1] * _BANDS, 0, _BANDS - 1).astype(int)
    full = (_band_share(mask, top, slot) > 0.85).astype(np.uint8)
    numbers = cv2.connectedComponents(full, connectivity=4)[1].ravel()
    numbers = np.where(full, numbers, 0)
    found = np.zeros_like(mask)
    for k in range(1, int(numbers.max()) + 1):
        band = top & (numbers == k)[slot]
        if (numbers == k).sum() >= 4 and band.sum() > 100:
            found |= bare(lab, strength, band & mask, band)
    return found


def _seams(
    mask: Bool[np.ndarray, "h w"], top: Bool[np.ndarray, "h w"], place: Float[np.ndarray, "h w 2"]
) -> Bool[np.ndarray, "h w"]:
    """Return the pixels of narrow bands that run along or across most of the top: joints.

    Where a thing lies over a joint, on both sides of it, the band is the thing's.
    """
    found = np.zeros_like(mask)
    for axis in (0, 1):
        slot = np.clip(place[..., axis] * _BANDS, 0, _BANDS - 1).astype(int)
        share = _band_share(mask, top, slot)
        around = median_filter(share, 21, mode="nearest")
        narrow = (share > 0.7) & (share > around + 0.25)
        found |= maximum_filter(narrow, 3)[slot] & mask
    rest = (mask & ~found).astype(np.uint8)
    return found & (cv2.morphologyEx(rest, cv2.MORPH_CLOSE, disc(4)) == 0)


def _islands(
    mask: Bool[np.ndarray, "h w"], smallest: float, rim: Bool[np.ndarray, "h w"]
) -> Bool[np.ndarray, "h w"]:
    """Return the small parts of a mask that are cut off from its largest part and from ``rim``.

    They are insides of things: a page, a label, the lens of a magnifying glass.
    """
    numbers = np.asarray(cv2.connectedComponents(mask.astype(np.uint8), connectivity=4)[1], int)
    areas = np.bincount(numbers.ravel())
    areas[0] = 0
    small = areas < smallest
    small[[0, int(areas.argmax())]] = False
    small[np.unique(numbers[rim])] = False
    return small[numbers]


def positions(plane: TablePlane, size: tuple[int, int]) -> Float[np.ndarray, "h w 2"]:
    """Return each pixel's place on the top, 0 to 1 along its length and width."""
    h, w = size
    y, x = np.mgrid[0:h, 0:w] + 0.5
    pixels = np.column_stack([x.ravel(), y.ravel()]) * (plane.camera.width / w)
    place = plane.to_table(pixels) / np.asarray(plane.size) + 0.5
    return np.nan_to_num(place, nan=-1.0).reshape(h, w, 2)
