"""Printed and displayed tiles: labels, covers, pages, pictures, screens and keys.

Coordinates are fractions of the tile, with x to the right and y downwards.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from jaxtyping import Float, UInt8

from .surfaces import RGB, Look, Tile, fit, readable_on, tint_color

Canvas = UInt8[np.ndarray, "_ _ 3"]


def canvas(width: int, height: int, color: RGB) -> Canvas:
    """Return a blank picture of one colour."""
    return np.broadcast_to(np.array(color).round().astype(np.uint8), (height, width, 3)).copy()


def fill(image: Canvas, x: float, y: float, width: float, height: float, color: RGB) -> None:
    """Fill a rectangle given in fractions of the picture; (x, y) is its upper left corner."""
    h, w = image.shape[:2]
    rows = slice(max(round(y * h), 0), max(round((y + height) * h), round(y * h) + 1))
    columns = slice(max(round(x * w), 0), max(round((x + width) * w), round(x * w) + 1))
    image[rows, columns] = np.array(color).round().astype(np.uint8)


def disc(image: Canvas, x: float, y: float, radius: float, color: RGB, inner: float = 0.0) -> None:
    """Fill a disc, or a ring if ``inner`` is given; radii are fractions of the image's height."""
    h, w = image.shape[:2]
    rows, columns = np.mgrid[0:h, 0:w] + 0.5
    away = np.hypot(columns - x * w, rows - y * h) / h
    image[(away <= radius) & (away >= inner)] = np.array(color).round().astype(np.uint8)


def write(
    image: Canvas, text: str, x: float, y: float, height: float, color: RGB, bold: bool = False
) -> None:
    """Write ``text`` centred at (x, y) with the given height, shrunk to fit the picture's width."""
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
    """Draw ``count`` lines of small print as bars in the box (x, y, width, height)."""
    x, y, width, height = box
    for k in range(count):
        long = width * (rng.uniform(0.75, 1.0) if k % 5 < 4 else rng.uniform(0.3, 0.6))
        fill(image, x, y + height * k / count, long, height * weight / count, color)


def barcode(image: Canvas, rng: np.random.Generator, x: float, y: float, width: float) -> None:
    """Draw a barcode whose height is a third of its width."""
    tall = width / 3 * image.shape[1] / image.shape[0]
    fill(image, x, y, width, tall, (250, 250, 250))
    at = x + 0.06 * width
    while at < x + 0.9 * width:
        step = width * rng.uniform(0.02, 0.05)
        fill(image, at, y + 0.1 * tall, step * 0.6, 0.8 * tall, (20, 20, 20))
        at += step + width * 0.015


def polygon(image: Canvas, points: Sequence[tuple[float, float]], color: RGB) -> None:
    """Fill a polygon given by its corners in fractions of the picture."""
    import cv2

    h, w = image.shape[:2]
    corners = np.round(np.array(points) * [w, h]).astype(np.int32)
    cv2.fillPoly(image, [corners], tuple(float(c) for c in color), cv2.LINE_AA)


def stroke(image: Canvas, points: Sequence[tuple[float, float]], width: float, color: RGB) -> None:
    """Draw a polyline; ``width`` is a fraction of the picture's height."""
    import cv2

    h, w = image.shape[:2]
    corners = np.round(np.array(points) * [w, h]).astype(np.int32)
    thick = max(1, round(width * h))
    cv2.polylines(image, [corners], False, tuple(float(c) for c in color), thick, cv2.LINE_AA)


PALETTES: tuple[tuple[RGB, ...], ...] = (
    ((240, 228, 204), (206, 92, 66), (46, 84, 110), (228, 172, 74), (60, 60, 66)),
    ((246, 242, 234), (38, 70, 64), (196, 140, 92), (232, 190, 160), (120, 146, 118)),
    ((28, 34, 58), (236, 96, 110), (250, 196, 90), (92, 170, 190), (240, 236, 226)),
    ((252, 248, 240), (232, 120, 150), (110, 150, 210), (250, 214, 120), (90, 180, 150)),
    ((232, 232, 230), (24, 24, 28), (200, 40, 40), (120, 122, 128), (250, 250, 248)),
    ((220, 232, 238), (36, 96, 150), (80, 160, 196), (246, 246, 240), (230, 150, 60)),
)
"""Combinations of colours; the first colour of each combination is the background."""


def landscape(rng: np.random.Generator, width: int = 192, height: int = 128) -> Tile:
    """Return a landscape with a sky, a sun or moon, and hills."""
    skies = [((120, 180, 230), (240, 240, 230)), ((240, 150, 90), (250, 220, 150)),
             ((40, 50, 100), (150, 120, 170)), ((150, 210, 210), (250, 245, 225)),
             ((226, 160, 190), (250, 224, 214)), ((70, 110, 160), (200, 216, 226))]  # fmt: skip
    lands = [[(96, 132, 126), (78, 122, 84), (52, 92, 62)], [(150, 120, 140), (110, 80, 110),
                                                             (60, 46, 78)],
             [(200, 170, 120), (180, 140, 90), (140, 100, 66)], [(140, 170, 200), (90, 130, 170),
                                                                 (50, 90, 130)]]  # fmt: skip
    top, low = skies[rng.integers(len(skies))]
    t = np.linspace(0, 1, height)[:, None, None]
    image = (np.array(top) * (1 - t) + np.array(low) * t) * np.ones((1, width, 1))
    image = np.clip(image, 0, 255).astype(np.uint8)
    disc(image, rng.uniform(0.2, 0.8), rng.uniform(0.2, 0.4), 0.11, (255, 240, 190))
    x, y = np.arange(width) / width, np.arange(height)[:, None] / height
    for k, color in enumerate(lands[rng.integers(len(lands))]):
        waves = np.sin(2 * np.pi * (x * rng.uniform(0.8, 2) + rng.random()))
        crest = 0.55 + 0.14 * k + 0.09 * waves
        image[y >= crest[None]] = color
    return image


def artwork(rng: np.random.Generator, width: int = 128, height: int = 128) -> Tile:
    """Return a random picture: a landscape, portrait or skyline, flowers, blocks, arcs or waves."""
    kind = rng.integers(7)
    if kind == 0:
        return landscape(rng, width, height)
    colors = PALETTES[rng.integers(len(PALETTES))]
    image = canvas(width, height, colors[0])
    (_portrait, _flowers, _skyline, _blocks, _arcs, _waves)[kind - 1](image, rng, colors)
    return image


def _portrait(image: Canvas, rng: np.random.Generator, colors: tuple[RGB, ...]) -> None:
    skin: RGB = [(236, 200, 172), (204, 152, 114), (140, 96, 70), (248, 222, 200)][rng.integers(4)]
    hair: RGB = [(54, 38, 30), (120, 76, 40), (210, 170, 100), (30, 30, 34)][rng.integers(4)]
    wide = image.shape[0] / image.shape[1]
    disc(image, 0.5, 0.37, 0.235, hair)
    fill(image, 0.5 - 0.235 * wide, 0.37, 0.47 * wide, rng.uniform(0.05, 0.32), hair)
    polygon(image, [(0.1, 1), (0.22, 0.76), (0.5, 0.66), (0.78, 0.76), (0.9, 1)], colors[1])
    fill(image, 0.5 - 0.07 * wide, 0.5, 0.14 * wide, 0.2, tint_color(skin, 0.9))
    disc(image, 0.5, 0.43, 0.175, skin)
    for side in (-1, 1):
        disc(image, 0.5 + side * 0.07 * wide, 0.41, 0.02, (40, 36, 36))
    stroke(image, [(0.5 - 0.05 * wide, 0.51), (0.5, 0.525), (0.5 + 0.05 * wide, 0.51)], 0.012,
           (176, 70, 70))  # fmt: skip


def _flowers(image: Canvas, rng: np.random.Generator, colors: tuple[RGB, ...]) -> None:
    wide = image.shape[0] / image.shape[1]
    for _ in range(int(rng.integers(4, 9))):
        x, y, r = rng.uniform(0.15, 0.85), rng.uniform(0.15, 0.7), rng.uniform(0.05, 0.1)
        stroke(image, [(x, y), (0.5 + 0.3 * (x - 0.5), 1)], 0.014, (84, 128, 80))
        petal = colors[int(rng.integers(1, len(colors)))]
        for angle in np.arange(5) * 2 * np.pi / 5 + rng.random():
            disc(image, x + r * wide * np.cos(angle), y + r * np.sin(angle), 0.62 * r, petal)
        disc(image, x, y, 0.5 * r, (246, 206, 90))


def _skyline(image: Canvas, rng: np.random.Generator, colors: tuple[RGB, ...]) -> None:
    disc(image, rng.uniform(0.2, 0.8), 0.25, 0.1, colors[3])
    for color, tall in ((tint_color(colors[1], 1.3), 0.6), (colors[2], 0.45)):
        x = 0.0
        while x < 1:
            wide, top = rng.uniform(0.08, 0.18), rng.uniform(0.5, 1.1) * tall
            fill(image, x, 1 - top, wide, top, color)
            for k in range(int(top / 0.07)):
                fill(image, x + 0.2 * wide, 1 - top + 0.03 + 0.07 * k, 0.6 * wide, 0.02, colors[0])
            x += wide + 0.004


def _blocks(image: Canvas, rng: np.random.Generator, colors: tuple[RGB, ...]) -> None:
    for _ in range(9):
        x, y = rng.integers(0, 5, 2) / 5
        wide, tall = rng.integers(1, 4, 2) / 5
        fill(image, x, y, wide, tall, colors[int(rng.integers(len(colors)))])
    for k in range(1, 5):
        if rng.random() < 0.7:
            fill(image, 0, k / 5, 1, 0.012, (30, 30, 32))
            fill(image, k / 5, 0, 0.012, 1, (30, 30, 32))


def _arcs(image: Canvas, rng: np.random.Generator, colors: tuple[RGB, ...]) -> None:
    for _ in range(3):
        x, y, r = rng.uniform(0, 1), rng.uniform(0.2, 1), rng.uniform(0.25, 0.45)
        for k in range(4):
            disc(image, x, y, r * (1 - 0.22 * k), colors[1 + k % (len(colors) - 1)])


def _waves(image: Canvas, rng: np.random.Generator, colors: tuple[RGB, ...]) -> None:
    h, w = image.shape[:2]
    x, y = np.arange(w) / w, np.arange(h)[:, None] / h
    count = int(rng.integers(5, 10))
    pace, phase = rng.uniform(0.7, 2.5), rng.random()
    for k in range(count):
        crest = k / count + 0.06 * np.sin(2 * np.pi * (pace * x + phase + 0.13 * k))
        image[y >= crest[None]] = np.array(colors[k % len(colors)]).round().astype(np.uint8)


BARS: tuple[RGB, ...] = ((60, 110, 190), (70, 72, 84), (190, 90, 70), (60, 140, 110))
CODE: tuple[RGB, ...] = ((206, 144, 110), (110, 180, 230), (200, 200, 206), (130, 170, 110))


def desktop(rng: np.random.Generator, width: int = 256, height: int = 160) -> Tile:
    """Return a computer screen: off, or with windows, code, charts, a table, a call or an image."""
    kind = int(rng.integers(8))
    if kind == 0:
        return _off(width, height)
    image = landscape(rng, width, height)
    if kind == 1:
        return image
    (_windows, _windows, _code, _dashboard, _cells, _call)[kind - 2](image, rng)
    return image


def _off(width: int, height: int) -> Tile:
    """Return a dark panel that reflects a window."""
    y, x = np.mgrid[0:height, 0:width] / height
    gleam = np.clip(1 - np.abs(x - 0.7 * y - 0.9) * 4, 0, 1)[..., None] * 26
    return (np.array([20.0, 21, 24]) + gleam).astype(np.uint8)


def _windows(image: Canvas, rng: np.random.Generator) -> None:
    for _ in range(int(rng.integers(1, 3))):
        x, y = rng.uniform(0.06, 0.4), rng.uniform(0.06, 0.25)
        fill(image, x, y, 0.5, 0.6, (250, 250, 252))
        fill(image, x, y, 0.5, 0.07, BARS[rng.integers(len(BARS))])
        lines(image, rng, (x + 0.03, y + 0.13, 0.42, 0.42), 9, (150, 152, 160))
    fill(image, 0, 0.93, 1, 0.07, (36, 40, 52))
    for k in range(6):
        fill(image, 0.34 + 0.055 * k, 0.945, 0.032, 0.042, tint_color(BARS[k % 4], 1.4))


def _code(image: Canvas, rng: np.random.Generator) -> None:
    image[:] = (30, 32, 40)
    fill(image, 0, 0, 0.17, 1, (40, 43, 54))
    lines(image, rng, (0.02, 0.08, 0.12, 0.6), 12, (120, 124, 138), 0.35)
    fill(image, 0.17, 0, 0.83, 0.06, (52, 56, 70))
    deep = 0.0
    for k in range(20):
        deep = float(np.clip(deep + rng.choice([-0.04, 0, 0.04]), 0, 0.16))
        x = 0.21 + deep
        for _ in range(int(rng.integers(1, 5))):
            wide = rng.uniform(0.03, 0.15)
            fill(image, x, 0.1 + 0.043 * k, wide, 0.014, CODE[int(rng.integers(4))])
            x += wide + 0.015
    fill(image, 0, 0.95, 1, 0.05, BARS[0])


def _dashboard(image: Canvas, rng: np.random.Generator) -> None:
    image[:] = (240, 242, 246)
    fill(image, 0, 0, 1, 0.09, BARS[int(rng.integers(4))])
    for k in range(3):
        fill(image, 0.04 + 0.32 * k, 0.14, 0.28, 0.16, (255, 255, 255))
        write(image, str(int(rng.integers(10, 990))), 0.18 + 0.32 * k, 0.22, 0.1, BARS[k])
    fill(image, 0.04, 0.36, 0.44, 0.56, (255, 255, 255))
    fill(image, 0.52, 0.36, 0.44, 0.56, (255, 255, 255))
    for k in range(7):
        tall = rng.uniform(0.08, 0.44)
        fill(image, 0.07 + 0.056 * k, 0.88 - tall, 0.036, tall, BARS[k % 2 * 3])
    climb = np.cumsum(rng.uniform(-0.05, 0.1, 10))
    curve = [(0.55 + 0.042 * k, 0.82 - 0.6 * max(c, 0)) for k, c in enumerate(climb)]
    stroke(image, curve, 0.018, BARS[2])


def _cells(image: Canvas, rng: np.random.Generator) -> None:
    image[:] = (252, 252, 252)
    fill(image, 0, 0, 1, 0.12, (40, 124, 80))
    for k in range(1, 16):
        fill(image, 0, 0.12 + 0.058 * k, 1, 0.004, (206, 208, 212))
    for j in range(8):
        fill(image, 0.125 * j, 0.12, 0.002, 1, (206, 208, 212))
        for k in range(15):
            if rng.random() < 0.75:
                fill(image, 0.125 * j + 0.02, 0.14 + 0.058 * k, rng.uniform(0.03, 0.09), 0.018,
                     (90, 94, 104))  # fmt: skip


def _call(image: Canvas, rng: np.random.Generator) -> None:
    image[:] = (28, 30, 34)
    h, w = image.shape[:2]
    for j in range(2):
        for k in range(2):
            a, b = int((0.05 + 0.44 * j) * h), int((0.04 + 0.47 * k) * w)
            tall, wide = int(0.41 * h), int(0.45 * w)
            image[a : a + tall, b : b + wide] = artwork(rng, wide, tall)
    for k in range(4):
        disc(image, 0.38 + 0.08 * k, 0.955, 0.032, (220, 60, 60) if k == 3 else (90, 94, 102))


def apps(rng: np.random.Generator, width: int = 96, height: int = 192) -> Tile:
    """Return a phone or tablet screen: off, locked, or with icons, a chat, a player or a map."""
    kind = int(rng.integers(7))
    if kind == 0:
        return _off(width, height)
    image = landscape(rng, width, height)
    (_icons, _icons, _lock, _chat, _music, _map)[kind - 1](image, rng)
    fill(image, 0.08, 0.015, 0.2, 0.012, (255, 255, 255))
    return image


def _icons(image: Canvas, rng: np.random.Generator) -> None:
    height, width = image.shape[:2]
    columns, rows = 4, max(3, round(4.2 * height / width * 0.7))
    side = 0.6 / columns
    for j in range(rows - 1):
        for k in range(columns):
            color: RGB = tuple(rng.uniform(60, 240, 3))  # type: ignore[assignment]
            x, y = 0.1 + k * 0.84 / columns, 0.1 + j * 0.84 / rows
            fill(image, x, y, side, side * width / height, color)


def _lock(image: Canvas, rng: np.random.Generator) -> None:
    hour, minute = int(rng.integers(1, 13)), int(rng.integers(60))
    write(image, f"{hour}:{minute:02d}", 0.5, 0.2, 0.13, (255, 255, 255), bold=True)
    fill(image, 0.28, 0.3, 0.44, 0.015, (236, 236, 240))
    for k in range(int(rng.integers(0, 3))):
        fill(image, 0.08, 0.5 + 0.12 * k, 0.84, 0.1, (232, 234, 238))
        lines(image, rng, (0.22, 0.525 + 0.12 * k, 0.6, 0.05), 2, (120, 122, 130))


def _chat(image: Canvas, rng: np.random.Generator) -> None:
    image[:] = (244, 242, 238)
    own = BARS[int(rng.integers(4))]
    fill(image, 0, 0, 1, 0.1, own)
    y = 0.14
    while y < 0.84:
        tall, wide, mine = rng.uniform(0.05, 0.12), rng.uniform(0.4, 0.7), rng.random() < 0.5
        x = 0.95 - wide if mine else 0.05
        fill(image, x, y, wide, tall, tint_color(own, 1.3) if mine else (255, 255, 255))
        lines(image, rng, (x + 0.05, y + 0.018, wide - 0.1, tall - 0.025), 2, (90, 92, 98), 0.3)
        y += tall + 0.025
    fill(image, 0.05, 0.92, 0.9, 0.05, (255, 255, 255))


def _music(image: Canvas, rng: np.random.Generator) -> None:
    height, width = image.shape[:2]
    image[:] = (26, 26, 32)
    side = int(0.8 * width)
    top = int(0.12 * height)
    tall = min(side, height - top)
    image[top : top + tall, width // 10 : width // 10 + side] = artwork(rng, side, side)[:tall]
    y = 0.2 + 0.8 * width / height
    fill(image, 0.1, min(y, 0.86), 0.5, 0.02, (240, 240, 244))
    fill(image, 0.1, min(y + 0.05, 0.9), 0.8, 0.008, (110, 112, 120))
    disc(image, 0.5, min(y + 0.14, 0.95), 0.04, (240, 240, 244))


def _map(image: Canvas, rng: np.random.Generator) -> None:
    image[:] = (236, 232, 222)
    fill(image, 0, rng.uniform(0.5, 0.7), 1, 0.14, (160, 200, 226))
    fill(image, rng.uniform(0, 0.5), rng.uniform(0.1, 0.4), 0.4, 0.2, (188, 218, 170))
    for _ in range(6):
        a, b = rng.random(2), rng.random(2)
        stroke(image, [(0, float(a[0])), (1, float(a[1]))], 0.014, (255, 255, 255))
        stroke(image, [(float(b[0]), 0), (float(b[1]), 1)], 0.014, (255, 255, 255))
    way = [(0.2, 0.85), (0.35, 0.6), (0.55, 0.5), (0.7, 0.2)]
    stroke(image, way, 0.022, (60, 120, 230))
    disc(image, 0.7, 0.2, 0.028, (214, 60, 50))


FRONT = (0.3, 0.7)
"""Range of the texture coordinate u in which a wrap-around label faces the viewer."""


def label(
    rng: np.random.Generator, title: str, color: RGB, ground: RGB, *, width: int = 256
) -> Tile:
    """Return a wrap-round label: a title in front, and small print and a barcode at the back."""
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
    """Return the front of a book or box with a title, a picture or simple shapes, and an author."""
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


def pages(rng: np.random.Generator, color: RGB = (240, 234, 218)) -> Tile:
    """Return the edge of a stack of sheets as fine lines along u."""
    shade = np.where(np.arange(32) % 2, -14.0, 4.0) + rng.uniform(-6, 6, 32)
    image = np.array(color) + np.repeat(shade[:, None, None], 32, 1)
    return np.clip(image, 0, 255).astype(np.uint8)


def sheet(rng: np.random.Generator, *, picture: bool = False) -> Tile:
    """Return a printed page with a heading, paragraphs and sometimes a picture."""
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
    """Return a block of keys seen from above; each row lists the relative widths of its keys."""
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


QWERTY: tuple[tuple[float, ...], ...] = ((1,) * 15, (1,) * 13 + (2,), (1.5,) + (1,) * 12 + (1.5,),
                                         (1.75,) + (1,) * 11 + (2.25,), (2.25,) + (1,) * 10
                                         + (2.75,), (1.25, 1.25, 1.25, 6.25, 1.25, 1.25, 1.25,
                                                     1.25))  # fmt: skip
"""Key widths of a keyboard, from the top row down."""


def clock_face(rng: np.random.Generator, ground: RGB, ink: RGB) -> Tile:
    """Return an analogue clock face with ticks, numerals and hands."""
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
    """Return one face of a die."""
    image = canvas(64, 64, ground)
    places = {1: [(0, 0)], 2: [(-1, -1), (1, 1)], 3: [(-1, -1), (0, 0), (1, 1)],
              4: [(-1, -1), (1, -1), (-1, 1), (1, 1)], 5: [(-1, -1), (1, -1), (-1, 1), (1, 1),
                                                           (0, 0)], 6: [(-1, -1), (1, -1), (-1, 1),
                                                                        (1, 1), (-1, 0),
                                                                        (1, 0)]}  # fmt: skip
    for x, y in places[count]:
        disc(image, 0.5 + 0.27 * x, 0.5 + 0.27 * y, 0.1, ink)
    return image


def rule(length_cm: int, ground: RGB, ink: RGB) -> Tile:
    """Return the scale of a ruler along u."""
    image = canvas(256, 32, ground)
    for mm in range(length_cm * 10 + 1):
        tall = 0.55 if mm % 10 == 0 else 0.4 if mm % 5 == 0 else 0.0 if length_cm > 20 else 0.25
        if tall:
            fill(image, 0.01 + 0.98 * mm / (length_cm * 10), 0, 0.004, tall, ink)
    return image


def mesh_holes(color: RGB, hole: RGB, rows: int = 12, columns: int = 12) -> Tile:
    """Return a perforated grille."""
    y, x = np.mgrid[0:128, 0:128] / 128
    dots: Float[np.ndarray, "h w"] = np.hypot((x * columns) % 1 - 0.5, (y * rows) % 1 - 0.5)
    image = canvas(128, 128, color)
    image[dots < 0.32] = np.array(hole).round().astype(np.uint8)
    return image


def wrap(
    look: Look, title: str, color: RGB, ground: RGB, *, fronts: int = 1, share: float = 0.3
) -> Tile:
    """Return a print that wraps around a packet; ``share`` is the relative width of its front.

    Each front shows the title. The first is in the middle (u = 0.5), the second opposite it.
    """
    image = canvas(320, 160, ground)
    lines(image, look.rng, (0.06, 0.28, 0.13, 0.5), 7, tint_color(color, 0.7))
    barcode(image, look.rng, 0.82, 0.4, 0.12)
    wide = int(share * 320)
    panel = canvas(wide, 160, ground)
    disc(panel, 0.5, 0.56, 0.26, color)
    disc(panel, 0.5, 0.56, 0.22, tint_color(color, 1.35))
    fill(panel, 0.04, 0.43, 0.92, 0.26, color)
    write(panel[:, 4:-4], title, 0.5, 0.55, 0.17, readable_on(color), bold=True)
    for k in range(fronts):
        image = np.roll(image, -(320 // 2) * k, axis=1)
        image[:, 160 - wide // 2 : 160 - wide // 2 + wide] = panel
    fill(image, 0, 0, 1, 0.16, color)
    fill(image, 0, 0.84, 1, 0.16, color)
    return image


def turned_to(tile: Tile, u: float) -> Tile:
    """Return a wrap-round print shifted so that its front is at ``u`` instead of u = 0.5."""
    return np.roll(tile, round((u - 0.5) * tile.shape[1]), axis=1)


def word_plate(text: str, ground: RGB, ink: RGB, size: float = 0.3, wide: int = 128, tall: int = 64
          ) -> Tile:  # fmt: skip
    """Return a plate printed with one word."""
    image = canvas(wide, tall, ground)
    write(image, text, 0.5, 0.5, size, ink, bold=True)
    return image
