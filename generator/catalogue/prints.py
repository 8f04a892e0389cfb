"""Printed and displayed texture tiles: labels, book covers, pages, screens, keys, cards."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from jaxtyping import Float, UInt8

from .colors import RGB, readable_on, tinted
from .textures import Tile

Canvas = UInt8[np.ndarray, "h w 3"]


def canvas(width: int, height: int, color: RGB) -> Canvas:
    """Return a blank picture to draw on."""
    return np.broadcast_to(np.array(color).round().astype(np.uint8), (height, width, 3)).copy()


def fill(image: Canvas, x: float, y: float, width: float, height: float, color: RGB) -> None:
    """Fill a rectangle given in fractions of the picture, (x, y) its upper left corner."""
    h, w = image.shape[:2]
    rows = slice(max(round(y * h), 0), max(round((y + height) * h), round(y * h) + 1))
    columns = slice(max(round(x * w), 0), max(round((x + width) * w), round(x * w) + 1))
    image[rows, columns] = np.array(color).round().astype(np.uint8)


def disc(image: Canvas, x: float, y: float, radius: float, color: RGB, inner: float = 0.0) -> None:
    """Fill a disc, or a ring from ``inner``, in fractions of the picture's height."""
    h, w = image.shape[:2]
    rows, columns = np.mgrid[0:h, 0:w] + 0.5
    away = np.hypot(columns - x * w, rows - y * h) / h
    image[(away <= radius) & (away >= inner)] = np.array(color).round().astype(np.uint8)


def write(
    image: Canvas, text: str, x: float, y: float, height: float, color: RGB, bold: bool = False
) -> None:
    """Write ``text`` centred at (x, y), ``height`` tall, shrunk to fit the picture's width."""
    import cv2

    h, w = image.shape[:2]
    scale = height * h / 22.0
    thickness = 2 if bold else 1
    font = cv2.FONT_HERSHEY_SIMPLEX
    (width, tall), _ = cv2.getTextSize(text, font, scale, thickness)
    if width > 0.92 * w:
        scale *= 0.92 * w / width
        (width, tall), _ = cv2.getTextSize(text, font, scale, thickness)
    corner = (round(x * w - width / 2), round(y * h + tall / 2))
    ink = tuple(float(c) for c in color)
    cv2.putText(image, text, corner, font, scale, ink, thickness, cv2.LINE_AA)


def lines(
    image: Canvas,
    rng: np.random.Generator,
    box: tuple[float, float, float, float],
    count: int,
    color: RGB,
    weight: float = 0.4,
) -> None:
    """Draw ``count`` lines of small print as bars within box (x, y, width, height)."""
    x, y, width, height = box
    for k in range(count):
        long = width * (rng.uniform(0.75, 1.0) if k % 5 < 4 else rng.uniform(0.3, 0.6))
        fill(image, x, y + height * k / count, long, height * weight / count, color)


def barcode(image: Canvas, rng: np.random.Generator, x: float, y: float, width: float) -> None:
    """Draw a barcode, a third as tall as it is wide."""
    tall = width / 3 * image.shape[1] / image.shape[0]
    fill(image, x, y, width, tall, (250, 250, 250))
    at = x + 0.06 * width
    while at < x + 0.9 * width:
        step = width * rng.uniform(0.02, 0.05)
        fill(image, at, y + 0.1 * tall, step * 0.6, 0.8 * tall, (20, 20, 20))
        at += step + width * 0.015


def label(
    rng: np.random.Generator, title: str, color: RGB, ground: RGB, *, width: int = 256
) -> Tile:
    """A wrap-round product label: the title faces the viewer, small print and barcode behind."""
    image = canvas(width, 128, ground)
    fill(image, 0, 0.0, 1, 0.1, color)
    fill(image, 0, 0.9, 1, 0.1, color)
    fill(image, 0.33, 0.25, 0.34, 0.34, color)
    middle = image[:, int(0.34 * width) : int(0.66 * width)]
    write(middle, title, 0.5, 0.42, 0.2, readable_on(color), bold=True)
    lines(image, rng, (0.36, 0.66, 0.28, 0.18), 3, tinted(color, 0.7))
    lines(image, rng, (0.04, 0.2, 0.16, 0.6), 8, (90, 90, 90))
    barcode(image, rng, 0.8, 0.35, 0.16)
    return image


def cover(rng: np.random.Generator, title: str, color: RGB, accent: RGB) -> Tile:
    """The front of a book or box: a title, a picture of simple shapes, an author line."""
    image = canvas(128, 176, color)
    style = rng.integers(3)
    if style == 0:
        disc(image, 0.5, 0.6, 0.2, accent)
        disc(image, 0.5, 0.6, 0.11, tinted(color, 1.35))
    elif style == 1:
        for k in range(5):
            fill(image, 0.12 + 0.16 * k, 0.82 - 0.09 * rng.integers(2, 6), 0.1, 0.45, accent)
        fill(image, 0, 0.84, 1, 0.16, color)
    else:
        fill(image, 0.1, 0.42, 0.8, 0.4, accent)
        fill(image, 0.16, 0.46, 0.68, 0.32, tinted(color, 1.4))
    fill(image, 0.08, 0.06, 0.84, 0.012, accent)
    write(image, title, 0.5, 0.2, 0.1, readable_on(color), bold=True)
    lines(image, rng, (0.3, 0.9, 0.4, 0.04), 1, readable_on(color), 0.8)
    return image


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


def landscape(rng: np.random.Generator, width: int = 192, height: int = 128) -> Tile:
    """A picture: sky, sun or moon, hills."""
    skies = [
        ((120, 180, 230), (240, 240, 230)),
        ((240, 150, 90), (250, 220, 150)),
        ((40, 50, 100), (150, 120, 170)),
        ((150, 210, 210), (250, 245, 225)),
    ]
    top, low = skies[rng.integers(len(skies))]
    t = np.linspace(0, 1, height)[:, None, None]
    image = (np.array(top) * (1 - t) + np.array(low) * t) * np.ones((1, width, 1))
    image = np.clip(image, 0, 255).astype(np.uint8)
    disc(image, rng.uniform(0.2, 0.8), rng.uniform(0.2, 0.4), 0.11, (255, 240, 190))
    x, y = np.arange(width) / width, np.arange(height)[:, None] / height
    for k, green in enumerate([(96, 132, 126), (78, 122, 84), (52, 92, 62)]):
        waves = np.sin(2 * np.pi * (x * rng.uniform(0.8, 2) + rng.random()))
        crest = 0.55 + 0.14 * k + 0.09 * waves
        image[y >= crest[None]] = green
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
            fill(image, a + slot, y + gap, b - a - 2 * slot, tall - 2 * gap, tinted(color, 0.8))
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


def desktop(rng: np.random.Generator, width: int = 256, height: int = 160) -> Tile:
    """A computer screen: wallpaper, one or two windows with text, a task bar."""
    image = landscape(rng, width, height)
    bars: list[RGB] = [(60, 110, 190), (70, 72, 84), (190, 90, 70), (60, 140, 110)]
    for _ in range(int(rng.integers(1, 3))):
        x, y = rng.uniform(0.06, 0.4), rng.uniform(0.06, 0.25)
        fill(image, x, y, 0.5, 0.6, (250, 250, 252))
        fill(image, x, y, 0.5, 0.07, bars[rng.integers(len(bars))])
        lines(image, rng, (x + 0.03, y + 0.13, 0.42, 0.42), 9, (150, 152, 160))
    fill(image, 0, 0.93, 1, 0.07, (36, 40, 52))
    for k in range(6):
        fill(image, 0.34 + 0.055 * k, 0.945, 0.032, 0.042, tinted(bars[k % 4], 1.4))
    return image


def apps(rng: np.random.Generator, width: int = 96, height: int = 192) -> Tile:
    """A phone or tablet screen: wallpaper, status line, rows of coloured icons."""
    image = landscape(rng, width, height)
    fill(image, 0.08, 0.015, 0.2, 0.012, (255, 255, 255))
    columns, rows = 4, max(3, round(4.2 * height / width * 0.7))
    side = 0.6 / columns
    for j in range(rows - 1):
        for k in range(columns):
            color: RGB = tuple(rng.uniform(60, 240, 3))  # type: ignore[assignment]
            fill(
                image,
                0.08 + k * 0.84 / columns + 0.02,
                0.1 + j * 0.84 / rows,
                side,
                side * width / height,
                color,
            )
    return image


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
