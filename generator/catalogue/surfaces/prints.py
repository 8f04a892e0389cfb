"""Printed and displayed texture tiles: labels, book covers, pages, screens, keys, cards."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from jaxtyping import Float

from .artwork import artwork, landscape
from .colors import RGB, readable_on, tint_color
from .ink import Canvas, barcode, canvas, disc, fill, lines, polygon, stroke, write
from .labels import cover, label
from .screens import apps, desktop
from .textures import Tile

__all__ = [
    "QWERTY", "Canvas", "apps", "artwork", "barcode", "canvas", "clock_face", "cover", "desktop",
    "disc", "fill", "keys", "label", "landscape", "lines", "mesh_holes", "pages", "pips",
    "polygon", "rule", "sheet", "stroke", "write",
]  # fmt: skip


def pages(rng: np.random.Generator, color: RGB = (240, 234, 218)) -> Tile:
    """The edge of a stack of sheets: fine lines along u."""
    shade = np.where(np.arange(32) % 2, -14.0, 4.0) + rng.uniform(-6, 6, 32)
    image = np.array(color) + np.repeat(shade[:, None, None], 32, 1)
    return np.clip(image, 0, 255).astype(np.uint8)


def sheet(rng: np.random.Generator, *, picture: bool = False) -> Tile:
    """A printed page: heading, paragraphs, maybe a picture."""
    image = canvas(128, 176, (246, 244, 238))
    lines(image, rng, (0.12, 0.08, 0.6, 0.05), 1, (50, 50, 60), 0.8)
    lines(image, rng, (0.12, 0.18, 0.76, 0.72), 22, (120, 120, 125))
    if picture:
        fill(image, 0.12, 0.4, 0.76, 0.28, (120, 160, 190))
        fill(image, 0.12, 0.56, 0.76, 0.12, (104, 146, 92))
    return image


def keys(
    rows: Sequence[Sequence[float]],
    key: RGB,
    ground: RGB,
    *,
    accent: RGB | None = None,
    width: int = 256,
    height: int = 96,
) -> Tile:
    """A field of keys seen from above; each row lists the keys' relative widths."""
    image = canvas(width, height, ground)
    for j, row in enumerate(rows):
        edges = np.cumsum([0.0, *row]) / sum(row)
        for k, (a, b) in enumerate(itertools.pairwise(edges)):
            special = accent is not None and k in (0, len(row) - 1)
            color = accent if special and accent is not None else key
            y, tall = j / len(rows), 1 / len(rows)
            gap, slot = 0.12 * tall, 0.12 * tall * height / width
            fill(image, a + slot, y + gap, b - a - 2 * slot, tall - 2 * gap, tint_color(color, 0.8))
            fill(image, a + 1.6 * slot, y + 1.2 * gap, b - a - 3.2 * slot, tall - 3.6 * gap, color)
            if b - a < 0.12:
                mark = readable_on(color)
                fill(image, a + 3 * slot, y + 2.2 * gap, 0.012, 0.16 * tall, mark)
    return image


QWERTY: tuple[tuple[float, ...], ...] = (
    (1,) * 15,
    (1,) * 13 + (2,),
    (1.5,) + (1,) * 12 + (1.5,),
    (1.75,) + (1,) * 11 + (2.25,),
    (2.25,) + (1,) * 10 + (2.75,),
    (1.25, 1.25, 1.25, 6.25, 1.25, 1.25, 1.25, 1.25),
)
"""Key widths of a keyboard, from the top row down."""


def clock_face(rng: np.random.Generator, ground: RGB, ink: RGB) -> Tile:
    """An analogue clock face with ticks, figures and hands."""
    import cv2

    image = canvas(128, 128, ground)
    for k in range(12):
        angle = np.pi / 6 * k
        x, y = 0.5 + 0.42 * np.sin(angle), 0.5 - 0.42 * np.cos(angle)
        disc(image, x, y, 0.03 if k % 3 == 0 else 0.016, ink)
    for text, x, y in [("12", 0.5, 0.2), ("3", 0.8, 0.5), ("6", 0.5, 0.8), ("9", 0.2, 0.5)]:
        write(image, text, x, y, 0.12, ink)
    for length, thick, turn in [(0.2, 5, rng.uniform(0, 6.28)), (0.32, 3, rng.uniform(0, 6.28))]:
        end = (round(64 + 128 * length * np.sin(turn)), round(64 - 128 * length * np.cos(turn)))
        cv2.line(image, (64, 64), end, tuple(float(c) for c in ink), thick, cv2.LINE_AA)
    disc(image, 0.5, 0.5, 0.035, (200, 60, 50))
    return image


def pips(count: int, ground: RGB, ink: RGB) -> Tile:
    """One face of a die."""
    image = canvas(64, 64, ground)
    places = {
        1: [(0, 0)],
        2: [(-1, -1), (1, 1)],
        3: [(-1, -1), (0, 0), (1, 1)],
        4: [(-1, -1), (1, -1), (-1, 1), (1, 1)],
        5: [(-1, -1), (1, -1), (-1, 1), (1, 1), (0, 0)],
        6: [(-1, -1), (1, -1), (-1, 1), (1, 1), (-1, 0), (1, 0)],
    }
    for x, y in places[count]:
        disc(image, 0.5 + 0.27 * x, 0.5 + 0.27 * y, 0.1, ink)
    return image


def rule(length_cm: int, ground: RGB, ink: RGB) -> Tile:
    """The scale of a ruler, along u."""
    image = canvas(256, 32, ground)
    for mm in range(length_cm * 10 + 1):
        tall = 0.55 if mm % 10 == 0 else 0.4 if mm % 5 == 0 else 0.0 if length_cm > 20 else 0.25
        if tall:
            fill(image, 0.01 + 0.98 * mm / (length_cm * 10), 0, 0.004, tall, ink)
    return image


def mesh_holes(color: RGB, hole: RGB, rows: int = 12, columns: int = 12) -> Tile:
    """A perforated grille."""
    y, x = np.mgrid[0:128, 0:128] / 128
    dots: Float[np.ndarray, "h w"] = np.hypot((x * columns) % 1 - 0.5, (y * rows) % 1 - 0.5)
    image = canvas(128, 128, color)
    image[dots < 0.32] = np.array(hole).round().astype(np.uint8)
    return image
