"""Graspable cross-sections of an object: slices divided into solid runs with quality scores.

The object is seen along one yaw of the hand: v counts the lines of cells perpendicular to the
fingers' opening, u the cells along it. A pad covers a strip of ``_LINES`` lines and, at one height,
a slab of at most ``_LAYERS`` levels. Both fit into the bits of a byte, so that all strips of a yaw,
at all heights to be examined, are divided and scored together.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int, UInt8

from .heights import VoxelSolid

WIDEST = 0.0735
"""Width of the widest graspable run, in metres: the opening of 8 cm minus a margin for aiming."""

STEP_U, STEP_V, RISE = 0.0015, 0.003, 0.003
"""Size of cells along the opening and across it, and height of levels, in metres."""

FINGER_HALF, PAD_HEIGHT = 0.0105, 0.0188
"""Half a finger's width and the height of its pad, in metres."""

_ACROSS = np.arange(1 - np.ceil(FINGER_HALF / STEP_V), np.ceil(FINGER_HALF / STEP_V), dtype=int)
_LINES, _LAYERS = len(_ACROSS), int(PAD_HEIGHT / RISE) + 1
_LINE_BITS = np.uint8(1) << np.arange(_LINES, dtype=np.uint8)[:, None]
_BITS = max(_LINES, _LAYERS)
_DEPTHS = (0.041, 0.036, 0.03, 0.026, 0.022, 0.0185, 0.015, 0.011)
_LEAST_HOLD = 0.008
_ABOVE_TABLE = 0.003
_STEEPEST = 0.4
_MOST_LEAN = 0.6
_TOUCHED = 0.75


@dataclass(frozen=True, eq=False)
class Slabs:
    """An object divided into slabs as high as a finger pad, one starting at each level.

    Bit b of ``codes[k, c]`` is set if column c (in the order of ``VoxelSolid.nearest``) is filled
    at level k + b. ``tops[c]`` is the number of levels up to the highest filled one, ``looks[t]``
    lists the slabs to examine for a top of t: height of the fingertips (metres), lowest level and
    bits.
    """

    codes: UInt8[np.ndarray, "nz c"]
    tops: Int[np.ndarray, "c"]
    looks: Mapping[int, tuple[tuple[float, int, int], ...]]


def slabs(shape: VoxelSolid, floor: float) -> Slabs:
    """Return the slabs of ``shape``, which stands on a table at height ``floor`` (metres)."""
    count = len(shape.levels)
    filled = np.ascontiguousarray(shape.filled.reshape(-1, count).T).astype(np.uint8)
    tops = (filled * np.arange(1, count + 1, dtype=np.int16)[:, None]).max(0)
    codes = filled.copy()
    for k in range(1, min(_LAYERS, count)):
        codes[: count - k] |= filled[k:] << k
    looks = {top: _looks(shape.levels, top, floor) for top in np.unique(tops[tops > 0]).tolist()}
    return Slabs(codes, tops, looks)


def _looks(
    levels: Float[np.ndarray, "z"], top: int, floor: float
) -> tuple[tuple[float, int, int], ...]:
    """Return the slabs to examine below a surface that is ``top`` levels high, lowest first."""
    highest = float(levels[top - 1]) + RISE / 2
    tips = sorted({round(max(highest - d, floor + _ABOVE_TABLE), 4) for d in _DEPTHS})
    first = np.searchsorted(levels, tips).tolist()
    end = np.searchsorted(levels, np.add(tips, PAD_HEIGHT), "right").tolist()
    found = zip(tips, first, end, strict=True)
    return tuple((tip, low, (1 << high - low) - 1) for tip, low, high in found if high > low)


@dataclass(frozen=True, eq=False)
class Runs:
    """Graspable runs (solid cross-sections), ordered by row, height and position.

    ``row`` is the middle line of a run's strip, ``left`` and ``right`` its first and last cell,
    ``tip`` the height of the fingertips (metres); a higher ``quality`` is better.
    """

    row: Int[np.ndarray, "r"]
    left: Int[np.ndarray, "r"]
    right: Int[np.ndarray, "r"]
    tip: Float[np.ndarray, "r"]
    quality: Float[np.ndarray, "r"]


def find_runs(cut: Slabs, columns: Int[np.ndarray, "nv nu"]) -> Runs:
    """Return the graspable runs in every second row of ``columns``, a grid of column indices."""
    tops = cut.tops[columns]
    lines, cells = (np.flatnonzero(tops.any(axis)) for axis in (1, 0))
    rows = np.arange(lines[0], lines[-1] + 1, 2) if len(lines) else lines
    strips = rows[:, None] + _ACROSS
    highest = tops.max(1)[strips].max(1)
    looks = [(k, *look) for k, t in enumerate(highest.tolist()) for look in cut.looks.get(t, ())]
    if not looks:
        nowhere = np.empty(0, int)
        return Runs(nowhere, nowhere, nowhere, np.empty(0), np.empty(0))
    strip, tip, low, bits = (np.array(column) for column in zip(*looks, strict=True))

    lows, which = np.unique(low, return_inverse=True)
    seen = cut.codes[lows].take(columns[:, cells[0] : cells[-1] + 1], axis=1)
    slab = seen[which[:, None], strips[strip]] & bits.astype(np.uint8)[:, None, None]
    by_layer = np.bitwise_or.reduce(slab, axis=1)
    by_line = np.bitwise_or.reduce((slab != 0) * _LINE_BITS, axis=1)

    look, ends = np.nonzero(np.diff(by_layer != 0, axis=1, prepend=False, append=False))
    left, width = ends[::2], ends[1::2] - ends[::2]
    narrow = width * STEP_U <= WIDEST
    look, left, width = look[::2][narrow], left[narrow], width[narrow]
    quality = _quality(*(_windows(codes, look, left, width) for codes in (by_line, by_layer)))
    kept = ~np.isnan(quality)
    look, left = look[kept], left[kept] + cells[0]
    return Runs(rows[strip[look]], left, left + width[kept] - 1, tip[look], quality[kept])


def _windows(
    codes: UInt8[np.ndarray, "k n"],
    row: Int[np.ndarray, "r"],
    left: Int[np.ndarray, "r"],
    width: Int[np.ndarray, "r"],
) -> Bool[np.ndarray, "r b w"]:
    """Unpack the bits of ``width`` codes per ``row``, from ``left`` on; fill up with zeros."""
    along = np.arange(width.max(initial=1))
    found = codes[row[:, None], np.minimum(left[:, None] + along, codes.shape[1] - 1)]
    found = np.where(along < width[:, None], found, np.uint8(0))
    return np.unpackbits(found[:, None], axis=1, count=_BITS, bitorder="little").astype(bool)


def _quality(
    by_line: Bool[np.ndarray, "r b w"], by_layer: Bool[np.ndarray, "r b w"]
) -> Float[np.ndarray, "r"]:
    """Return a quality score for each run, or NaN if the fingers would slide off its sides."""
    # These must stay well within the pads' friction cone: a side's *slope* along the finger's
    # width, the *squeeze* by which the run narrows upwards (the object would pop out) and the
    # *lean* of its middle (fingers would make contact at different heights). Levels much narrower
    # than the widest one make no contact.
    lines, widths = np.asarray(by_line.any(2)), by_layer.sum(2)
    layers = widths >= _TOUCHED * widths.max(1, keepdims=True)
    share, hold = lines.sum(1) / _LINES, layers.sum(1) * RISE
    sides = _ends(by_line)
    first_slope, last_slope = (_trend(side, lines, STEP_V) for side in sides)
    first_rise, last_rise = (_trend(side, layers, RISE) for side in _ends(by_layer))
    slope = np.maximum(np.abs(first_slope), np.abs(last_slope))
    squeeze, lean = (first_rise - last_rise) / 2, np.abs(first_rise + last_rise) / 2
    rough = sum(
        side.max(1, where=lines, initial=0.0) - side.min(1, where=lines, initial=np.inf)
        for side in sides
    )
    bent = 2.0 * slope + 2.0 * np.maximum(squeeze, 0.0) + 1.5 * lean + 20.0 * rough
    good = (share >= 0.6) & (hold >= _LEAST_HOLD) & (slope <= _STEEPEST) & (lean <= _MOST_LEAN)
    good &= (squeeze <= _STEEPEST) & (squeeze >= -1.0)
    return np.where(good, share + hold / PAD_HEIGHT - bent, np.nan)


def _ends(
    rows: Bool[np.ndarray, "r b w"],
) -> tuple[Float[np.ndarray, "r b"], Float[np.ndarray, "r b"]]:
    """Return the positions of the first and the last filled cell in each row, in metres."""
    last = rows.shape[2] - 1 - rows[:, :, ::-1].argmax(2)
    return rows.argmax(2) * STEP_U, last * STEP_U


def _trend(
    side: Float[np.ndarray, "r b"], used: Bool[np.ndarray, "r b"], step: float
) -> Float[np.ndarray, "r"]:
    """Return the slope of the line fitted to each side's ``used`` points, or 0 for one point."""
    at = np.arange(used.shape[1]) * step
    middle = (used * at).sum(1) / used.sum(1)
    offset = np.where(used, at - middle[:, None], 0.0)
    spread = np.vecdot(offset, offset)
    return np.divide(np.vecdot(side, offset), spread, out=np.zeros(len(side)), where=spread > 0)
