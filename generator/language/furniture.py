"""The table that a text describes: outline, material, colour, legs and size."""

from __future__ import annotations

from typing import cast

import numpy as np

from ..scene import OutlineKind, PlannedTable
from .drafts import Reading
from .themes import Theme
from .vocabulary import COLORS, LEGS, OUTLINES, SHADES, SIZES, TABLE_MATERIALS

_FACTORS = {"tiny": 0.75, "small": 0.85, "large": 1.2, "huge": 1.35}
_LIMITS = ("long", 0.4, 2.4), ("deep", 0.35, 2.0), ("high", 0.25, 1.2)
"""Minimum and maximum length, depth and height of a table, in metres."""
_BOARDS = ("oak", "pine", "walnut")  # materials that slats can have
_DEFAULT = Theme(
    (), ("rectangle",), ("oak", "walnut", "pine", "beech", "white"), (1.2, 0.7, 0.74), ()
)


def plan_table(
    reading: Reading, theme: Theme | None, count: int, rng: np.random.Generator
) -> PlannedTable:
    """Plan a text's table for ``count`` objects; theme and chance decide what the text leaves open.

    A table whose size is not specified is smaller if there are few objects.
    """
    theme = theme or _DEFAULT
    outline = cast(OutlineKind, theme.outlines[int(rng.integers(len(theme.outlines)))])
    material = theme.materials[int(rng.integers(len(theme.materials)))]
    legs = theme.legs[int(rng.integers(len(theme.legs)))]
    color = None
    words = [word for noun in reading.table for word in noun.words[:-1] or noun.words]
    tops = [w for n in reading.table_parts if n.words[-1] not in ("leg", "legs") for w in n.words]
    feet = [w for n in reading.table_parts if n.words[-1] in ("leg", "legs") for w in n.words]
    words += tops
    outline = cast(OutlineKind, next((OUTLINES[w] for w in words if w in OUTLINES), outline))
    asked = [w for w in words if w in TABLE_MATERIALS]
    tints = _colors(words)
    if asked or tints:
        material = TABLE_MATERIALS[asked[0]] if asked else "painted wood"
        color = tints[0] if tints else None
    elif outline == "slatted" and material not in _BOARDS:
        material = _BOARDS[int(rng.integers(len(_BOARDS)))]
    elif material in COLORS:
        material, color = "painted wood", material
    legs = next((LEGS[w] for w in (*feet, *words) if w in LEGS and (w in feet or _is_leg(w))), legs)
    if outline in ("triangle", "oval") and legs == "trestle":
        legs = "tapered"
    length, depth, height = _size(reading, theme, outline, words)
    if not any(n.lengths for n in reading.table) and not any(w in SIZES for w in words):
        factor = float(np.clip(0.66 + 0.05 * count, 0.75, 1.0))
        length, depth = round(length * factor, 3), round(depth * factor, 3)
    return PlannedTable(outline, material, legs, (length, depth, height), color)


def _limit_side(
    asked: float | None, limits: tuple[str, float, float], reading: Reading
) -> float | None:
    """Limit a length to the range for tables, and add a warning if this changes it."""
    if asked is None:
        return None
    side, least, most = limits
    length = float(np.clip(asked, least, most))
    if length != asked:
        reading.warnings.append(
            f"A table cannot be {asked:g} m {side}; {length:g} m is used instead."
        )
    return length


def _is_leg(word: str) -> bool:
    return LEGS[word] in ("tapered", "splayed", "trestle", "pedestal", "hairpin")


def _colors(words: list[str]) -> list[str]:
    return [
        f"{before} {word}" if before in SHADES else word
        for before, word in zip(("", *words), words, strict=False)
        if word in COLORS and word not in TABLE_MATERIALS
    ]


def _size(
    reading: Reading, theme: Theme, outline: OutlineKind, words: list[str]
) -> tuple[float, float, float]:
    """Return the length, depth and height in metres, from lengths or size words in the text."""
    x, y, z = theme.size
    if outline in ("square", "round"):
        x = y = float(np.sqrt(x * y)) * (1.02 if outline == "round" else 1.0)
    elif outline == "triangle":
        x, y = max(x, 1.1), max(x, 1.1) * 0.87
    elif outline == "oval":
        x, y = x * 1.05, max(y, 0.62 * x)
    for word in words:
        factor = _FACTORS.get(SIZES.get(word, ""), 1.0)
        if word in ("long", "wide"):
            x = x * 1.25
        elif word == "narrow":
            y = y * 0.8
        elif word == "low":
            z = 0.45
        else:
            x, y = x * factor, y * factor
    flat = tuple(v for n in reading.table if not n.upright for v in n.lengths)
    tall = next((n.lengths for n in reading.table if n.lengths and n.upright), flat[2:])
    asked = (*flat[:2], *(None,) * (2 - len(flat[:2])), *tall[:1])
    given = [_limit_side(*pair, reading) for pair in zip(asked, _LIMITS, strict=False)]
    if given[0] is not None:
        x, y = given[0], given[1] or y * given[0] / x
        y = x if outline in ("square", "round") else y
    z = given[2] if len(given) > 2 and given[2] is not None else z
    return round(x, 3), round(float(np.clip(y, *_LIMITS[1][1:])), 3), round(z, 3)
