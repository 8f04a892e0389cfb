"""Screen contents of computers and phones."""

from __future__ import annotations

import numpy as np

from .artwork import artwork, landscape
from .colors import RGB, tint_color
from .ink import Canvas, disc, fill, lines, stroke, write
from .textures import Tile

BARS: tuple[RGB, ...] = ((60, 110, 190), (70, 72, 84), (190, 90, 70), (60, 140, 110))
CODE: tuple[RGB, ...] = ((206, 144, 110), (110, 180, 230), (200, 200, 206), (130, 170, 110))


def desktop(rng: np.random.Generator, width: int = 256, height: int = 160) -> Tile:
    """A computer screen: windows, code, charts, a table, a call, a picture, or switched off."""
    kind = int(rng.integers(8))
    if kind == 0:
        return _off(width, height)
    image = landscape(rng, width, height)
    if kind == 1:
        return image
    (_windows, _windows, _code, _dashboard, _cells, _call)[kind - 2](image, rng)
    return image


def _off(width: int, height: int) -> Tile:
    """A dark panel with the gleam of a window."""
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
    """A phone or tablet screen: icons, a lock screen, a chat, music, a map, a feed, or dark."""
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
