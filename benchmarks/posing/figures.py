"""Numbers of a table's columns, and the curves drawn of them (Pillow alone)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from jaxtyping import Float, UInt8
from PIL import Image, ImageDraw, ImageFont

from .tables import Row

_COLORS = ((31, 119, 180), (214, 69, 65), (44, 140, 60), (148, 90, 180))
_INK, _PALE = (40, 44, 52), (214, 218, 224)
_WIDTH, _HEIGHT, _LEFT, _TOP, _RIGHT, _BOTTOM = 720, 420, 64, 40, 24, 58


def column(rows: Sequence[Row], field: str) -> Float[np.ndarray, "n"]:
    """Return the numbers of a column; empty cells are left out."""
    return np.array([float(r[field]) for r in rows if str(r.get(field, "")) not in ("", "None")])


def median(values: Float[np.ndarray, "n"], unit: str = "", digits: int = 1) -> str:
    """Return a median as text; "-" of nothing."""
    return f"{np.median(values):.{digits}f}{unit}" if len(values) else "-"


def share(hits: Float[np.ndarray, "n"] | Sequence[bool]) -> str:
    """Return the share of true values as text."""
    return f"{100 * float(np.mean(hits)):.0f} %" if len(hits) else "-"


def error_cells(errors: Float[np.ndarray, "n"]) -> list[str]:
    """Return median and the shares within 2, 5 and 10 degrees."""
    return [median(errors, "°", 2), *(share(errors <= limit) for limit in (2, 5, 10))]


def cumulative(
    title: str,
    curves: Mapping[str, Float[np.ndarray, "n"]],
    unit: str,
    low: float = 0.1,
    high: float = 180.0,
) -> UInt8[np.ndarray, "h w 3"]:
    """Draw the share of cases up to each error, errors on a logarithmic axis."""
    picture = Image.new("RGB", (_WIDTH, _HEIGHT), "white")
    draw = ImageDraw.Draw(picture)
    small, large = ImageFont.load_default(13), ImageFont.load_default(17)
    wide, tall = _WIDTH - _LEFT - _RIGHT, _HEIGHT - _TOP - _BOTTOM

    def x(value: float) -> float:
        at = np.log(np.clip(value, low, high) / low) / np.log(high / low)
        return _LEFT + wide * float(at)

    def y(value: float) -> float:
        return _TOP + tall * (1 - value)

    draw.text((_LEFT, 10), title, _INK, large)
    for tick in (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 180):
        if low <= tick <= high:
            draw.line((x(tick), _TOP, x(tick), _TOP + tall), _PALE)
            draw.text((x(tick), _TOP + tall + 6), f"{tick:g}", _INK, small, anchor="mt")
    for level in np.arange(0, 1.01, 0.2):
        draw.line((_LEFT, y(level), _LEFT + wide, y(level)), _PALE)
        draw.text((_LEFT - 8, y(level)), f"{100 * level:.0f} %", _INK, small, anchor="rm")
    draw.text((_LEFT + wide / 2, _HEIGHT - 24), unit, _INK, small, anchor="mt")
    for k, (name, values) in enumerate(curves.items()):
        color = _COLORS[k % len(_COLORS)]
        ordered = np.sort(values)
        points = [(x(low), y(float((ordered <= low).mean()) if len(ordered) else 0.0))]
        for number, value in enumerate(ordered, start=1):
            points += [(x(value), points[-1][1]), (x(value), y(number / len(ordered)))]
        points.append((x(high), points[-1][1]))
        draw.line(points, color, 2)
        draw.text((_LEFT + wide - 8, _TOP + tall - 22 * (len(curves) - k)),
                  f"{name} ({len(ordered)})", color, small, anchor="ra")  # fmt: skip
    return np.asarray(picture, np.uint8)
