"""Colour words and their red, green and blue."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

RGB = tuple[float, float, float]
"""Red, green, blue in [0, 255]."""

COLORS: Mapping[str, RGB] = MappingProxyType(
    {
        "white": (240, 238, 233),
        "cream": (240, 228, 200),
        "ivory": (243, 234, 214),
        "beige": (214, 196, 164),
        "black": (38, 38, 41),
        "charcoal": (62, 64, 68),
        "gray": (138, 140, 143),
        "grey": (138, 140, 143),
        "silver": (192, 194, 198),
        "red": (196, 42, 40),
        "crimson": (160, 26, 46),
        "maroon": (120, 32, 40),
        "pink": (236, 158, 178),
        "coral": (240, 122, 96),
        "orange": (238, 132, 38),
        "amber": (222, 150, 40),
        "gold": (212, 172, 82),
        "golden": (212, 172, 82),
        "yellow": (244, 206, 62),
        "mustard": (206, 160, 52),
        "olive": (122, 124, 58),
        "lime": (160, 204, 70),
        "green": (66, 142, 76),
        "sage": (152, 172, 142),
        "mint": (168, 216, 190),
        "teal": (38, 128, 128),
        "turquoise": (72, 184, 184),
        "cyan": (78, 192, 214),
        "sky": (134, 188, 226),
        "blue": (48, 98, 180),
        "navy": (34, 50, 92),
        "indigo": (66, 60, 132),
        "purple": (124, 70, 150),
        "violet": (140, 92, 176),
        "lavender": (186, 168, 214),
        "magenta": (200, 60, 136),
        "brown": (122, 80, 50),
        "tan": (196, 158, 112),
        "terracotta": (188, 98, 66),
        "copper": (188, 116, 76),
        "bronze": (150, 110, 62),
        "brass": (196, 160, 84),
        "clear": (214, 230, 232),
        "transparent": (214, 230, 232),
        "wooden": (176, 128, 80),
    }
)


def rgb(word: str) -> RGB | None:
    """Return the colour a word or phrase ("dark blue") names, or None when it names none."""
    words = word.lower().replace("-", " ").split()
    named = [COLORS[w] for w in words if w in COLORS]
    if not named:
        return None
    color = np.array(named[-1], float)
    if "dark" in words or "deep" in words:
        color = color * 0.62
    if "light" in words or "pale" in words:
        color = color + (250 - color) * 0.5
    return float(color[0]), float(color[1]), float(color[2])


def tint_color(color: RGB, factor: float) -> RGB:
    """Return ``color`` darkened (factor below 1) or lightened towards white (above 1, up to 2)."""
    c = np.array(color, float)
    c = c * factor if factor <= 1 else c + (252 - c) * (factor - 1)
    return float(c[0]), float(c[1]), float(c[2])


def readable_on(color: RGB) -> RGB:
    """Return black or white, whichever can be read on ``color``."""
    return (250, 250, 247) if sum(color) < 380 else (35, 35, 40)
