"""Labels of products and covers of books, in several layouts each."""

from __future__ import annotations

import numpy as np

from .artwork import artwork
from .colors import RGB, readable_on, tint_color
from .ink import Canvas, barcode, canvas, disc, fill, lines, polygon, write
from .textures import Tile, fit

FRONT = (0.3, 0.7)
"""The part of a wrap-round label that faces the viewer, in u."""


def label(
    rng: np.random.Generator, title: str, color: RGB, ground: RGB, *, width: int = 256
) -> Tile:
    """A wrap-round product label: the title faces the viewer, small print and barcode behind."""
    image = canvas(width, 128, ground)
    kind = int(rng.integers(6))
    front = image[:, int(FRONT[0] * width) : int(FRONT[1] * width)]
    (_box, _badge, _halves, _frame, _fruit, _bands)[kind](image, front, rng, title, color)
    ink = readable_on(tuple(float(c) for c in image[64, 8]))  # type: ignore[arg-type]
    lines(image, rng, (0.05, 0.2, 0.15, 0.6), 8, tuple(0.5 * c + 60 for c in ink))  # type: ignore[arg-type]
    barcode(image, rng, 0.8, 0.35, 0.16)
    return image


def _box(image: Canvas, front: Canvas, rng: np.random.Generator, title: str, color: RGB) -> None:
    fill(image, 0, 0.0, 1, 0.1, color)
    fill(image, 0, 0.9, 1, 0.1, color)
    fill(front, 0.06, 0.24, 0.88, 0.36, color)
    write(front, title, 0.5, 0.42, 0.2, readable_on(color), bold=True)
    lines(front, rng, (0.14, 0.67, 0.72, 0.18), 3, tint_color(color, 0.7))


def _badge(image: Canvas, front: Canvas, rng: np.random.Generator, title: str, color: RGB) -> None:
    pale = tint_color(color, 1.85)
    image[:] = np.array(color).astype(np.uint8)
    disc(front, 0.5, 0.48, 0.41, pale)
    disc(front, 0.5, 0.48, 0.37, tint_color(color, 0.6), 0.35)
    write(front, title, 0.5, 0.47, 0.17, tint_color(color, 0.5), bold=True)
    fill(image, 0, 0.94, 1, 0.03, pale)
    lines(front, rng, (0.3, 0.62, 0.4, 0.1), 2, tint_color(color, 0.7))


def _halves(image: Canvas, front: Canvas, rng: np.random.Generator, title: str, color: RGB) -> None:
    cut = rng.uniform(0.42, 0.62)
    fill(image, 0, cut, 1, 1, color)
    write(front, title, 0.5, 0.26, 0.2, tint_color(color, 0.55), bold=True)
    disc(front, 0.5, 0.5 * (1 + cut), 0.15, tint_color(color, 1.7))
    disc(front, 0.5, 0.5 * (1 + cut), 0.08, tint_color(color, 0.6))


def _frame(image: Canvas, front: Canvas, rng: np.random.Generator, title: str, color: RGB) -> None:
    fill(front, 0.04, 0.08, 0.92, 0.84, tint_color(color, 0.8))
    fill(front, 0.07, 0.11, 0.86, 0.78, tuple(float(c) for c in image[0, 0]))  # type: ignore[arg-type]
    write(front, title, 0.5, 0.33, 0.15, tint_color(color, 0.55))
    fill(front, 0.3, 0.5, 0.4, 0.012, color)
    lines(front, rng, (0.22, 0.58, 0.56, 0.24), 4, tint_color(color, 1.2))


def _fruit(image: Canvas, front: Canvas, rng: np.random.Generator, title: str, color: RGB) -> None:
    for _ in range(14):
        x, y, r = rng.random(), rng.uniform(0.5, 1), rng.uniform(0.06, 0.13)
        disc(image, x, y, r, tint_color(color, rng.uniform(0.75, 1.3)))
        disc(image, x - 0.015, y - 0.03, 0.25 * r, tint_color(color, 1.7))
    fill(image, 0, 0.05, 1, 0.36, color)
    write(front, title, 0.5, 0.23, 0.2, readable_on(color), bold=True)


def _bands(image: Canvas, front: Canvas, rng: np.random.Generator, title: str, color: RGB) -> None:
    step = float(rng.choice([0.0625, 0.125]))
    image[:] = np.array(color).astype(np.uint8)
    for k in range(round(1 / step)):
        x = k * step
        corners = [(x, 1), (x + 0.5 * step, 1), (x + step, 0), (x + 0.5 * step, 0)]
        polygon(image, corners, tint_color(color, 0.75))
    fill(image, 0, 0.34, 1, 0.34, (248, 246, 240))
    write(front, title, 0.5, 0.51, 0.22, tint_color(color, 0.6), bold=True)


def cover(rng: np.random.Generator, title: str, color: RGB, accent: RGB) -> Tile:
    """The front of a book or box: a title, a picture or simple shapes, an author line."""
    image = canvas(128, 176, color)
    kind = int(rng.integers(7))
    height, ink = 0.2, readable_on(color)
    if kind == 0:
        disc(image, 0.5, 0.6, 0.2, accent)
        disc(image, 0.5, 0.6, 0.11, tint_color(color, 1.35))
    elif kind == 1:
        for k in range(5):
            fill(image, 0.12 + 0.16 * k, 0.82 - 0.09 * rng.integers(2, 6), 0.1, 0.45, accent)
        fill(image, 0, 0.84, 1, 0.16, color)
    elif kind == 2:
        fill(image, 0.1, 0.42, 0.8, 0.4, accent)
        fill(image, 0.16, 0.46, 0.68, 0.32, tint_color(color, 1.4))
    elif kind == 3:
        image[62:] = fit(artwork(rng, 128, 114), 114, 128)
    elif kind == 4:
        image[:] = artwork(rng, 128, 176)
        fill(image, 0.1, 0.09, 0.8, 0.24, color)
    elif kind == 5:
        fill(image, 0.06, 0.045, 0.88, 0.91, accent)
        fill(image, 0.085, 0.065, 0.83, 0.87, color)
        disc(image, 0.5, 0.66, 0.09, accent, 0.07)
        height = 0.34
    else:
        polygon(image, [(0, 1), (0, 0.55), (1, 0.35), (1, 1)], accent)
        lines(image, rng, (0.56, 0.8, 0.34, 0.1), 3, readable_on(accent))
    write(image, title, 0.5, height, 0.1, ink, bold=True)
    if kind < 3:
        fill(image, 0.08, 0.06, 0.84, 0.012, accent)
        lines(image, rng, (0.3, 0.9, 0.4, 0.04), 1, ink, 0.8)
    return image
