"""Artwork for frames, covers and screens."""

from __future__ import annotations

import numpy as np

from .colors import RGB, tint_color
from .ink import Canvas, canvas, disc, fill, polygon, stroke
from .textures import Tile

PALETTES: tuple[tuple[RGB, ...], ...] = (
    ((240, 228, 204), (206, 92, 66), (46, 84, 110), (228, 172, 74), (60, 60, 66)),
    ((246, 242, 234), (38, 70, 64), (196, 140, 92), (232, 190, 160), (120, 146, 118)),
    ((28, 34, 58), (236, 96, 110), (250, 196, 90), (92, 170, 190), (240, 236, 226)),
    ((252, 248, 240), (232, 120, 150), (110, 150, 210), (250, 214, 120), (90, 180, 150)),
    ((232, 232, 230), (24, 24, 28), (200, 40, 40), (120, 122, 128), (250, 250, 248)),
    ((220, 232, 238), (36, 96, 150), (80, 160, 196), (246, 246, 240), (230, 150, 60)),
)
"""Colours that go together: the ground first."""


def landscape(rng: np.random.Generator, width: int = 192, height: int = 128) -> Tile:
    """A picture: sky, sun or moon, hills."""
    skies = [
        ((120, 180, 230), (240, 240, 230)),
        ((240, 150, 90), (250, 220, 150)),
        ((40, 50, 100), (150, 120, 170)),
        ((150, 210, 210), (250, 245, 225)),
        ((226, 160, 190), (250, 224, 214)),
        ((70, 110, 160), (200, 216, 226)),
    ]
    lands = [
        [(96, 132, 126), (78, 122, 84), (52, 92, 62)],
        [(150, 120, 140), (110, 80, 110), (60, 46, 78)],
        [(200, 170, 120), (180, 140, 90), (140, 100, 66)],
        [(140, 170, 200), (90, 130, 170), (50, 90, 130)],
    ]
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
    """Any picture: a landscape, a portrait, flowers, a skyline, blocks, arcs, waves."""
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
