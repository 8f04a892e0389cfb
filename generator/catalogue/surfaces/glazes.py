"""Paint and glaze for mugs, bowls, pots and vases."""

from __future__ import annotations

import numpy as np

from . import textures
from .colors import RGB, readable_on, tint_color
from .ink import canvas, disc, fill, polygon, stroke, write
from .look import Look
from .textures import Tile

SIDE = 128
WORDS = ("COFFEE", "HELLO", "TEA", "HOME", "MONDAY", "CLUB", "RUN", "LOVE", "#1", "CAMP", "OK")


def glaze_tile(look: Look, color: RGB, *, words: bool = False) -> Tile:
    """Return the outside of a piece of crockery; u goes round (0.5 to the viewer), v up.

    Plain, banded, dipped, speckled, reactive, striped, dotted, checked, leafy, floral or, with
    ``words``, printed with a word or a badge. A material asked for stays as it is.
    """
    other = look.own_color(
        "white", "navy", "terracotta", "teal", "cream", "mustard", "black", "coral"
    )
    kind = int(look.rng.integers(13 if words else 11))
    base = look.surface(color, "ceramic")
    if look.material or kind <= 1:
        return base
    if np.abs(np.array(other) - color).max() < 50:
        other = tint_color(color, 0.5 if sum(color) > 330 else 1.6)
    makers = (_bands, _dip, _speckles, _reactive, _stripes, _dots, _checks, _leafy, _floral)
    if kind < 11:
        return makers[kind - 2](look, color, other)
    return _print(look, color, other, badge=kind == 12)


def _bands(look: Look, color: RGB, other: RGB) -> Tile:
    image = canvas(SIDE, SIDE, color)
    at, wide = look.between(0.06, 0.5), look.between(0.05, 0.2)
    fill(image, 0, at, 1, wide, other)
    fill(image, 0, at + wide + 0.03, 1, 0.025, other)
    return image


def _dip(look: Look, color: RGB, other: RGB) -> Tile:
    rng = look.rng
    image = textures.speckles(rng, color, 4, SIDE).copy()
    edge = rng.uniform(0.35, 0.7) + 0.03 * textures.noise(rng, 1, SIDE, (1, 6), 2)[0]
    edge[-12:] += (edge[0] - edge[-1]) * np.linspace(0, 1, 12)
    below = np.arange(SIDE)[:, None] / SIDE > edge[None]
    image[below] = textures.speckles(rng, other, 5, SIDE)[below]
    return image


def _speckles(look: Look, color: RGB, other: RGB) -> Tile:
    return textures.spots(look.rng, color, tint_color(color, 0.55), look.between(0.02, 0.07))


def _reactive(look: Look, color: RGB, other: RGB) -> Tile:
    low, high = (tint_color(color, 0.5), tint_color(color, 1.3))
    tile = textures.gradient(low if look.chance(0.5) else other, high, look.rng, 9)
    return textures.fit(tile, SIDE, SIDE)


def _stripes(look: Look, color: RGB, other: RGB) -> Tile:
    upright = look.chance(0.5)
    count = int(look.rng.integers(6, 12)) if upright else int(look.rng.integers(3, 7))
    colors = [color, other] if look.chance(0.5) else [color, color, color, other]
    return textures.stripes(colors, count, upright=upright, side=SIDE)


def _dots(look: Look, color: RGB, other: RGB) -> Tile:
    image = canvas(SIDE, SIDE, color)
    rows = int(look.rng.integers(3, 6))
    for j in range(rows):
        for k in range(2 * rows):
            x = (k + 0.5 * (j % 2) + 0.25) / (2 * rows)
            disc(image, x, (j + 0.5) / rows, 0.17 / rows, other)
    return image


def _checks(look: Look, color: RGB, other: RGB) -> Tile:
    rows = int(look.rng.integers(3, 7))
    y, x = np.mgrid[0:SIDE, 0:SIDE] / SIDE
    odd = (np.floor(2 * rows * x) + np.floor(rows * y)) % 2 > 0
    return np.where(odd[..., None], np.array(color), np.array(other)).round().astype(np.uint8)


def _leafy(look: Look, color: RGB, other: RGB) -> Tile:
    image = canvas(SIDE, SIDE, color)
    for k in range(6):
        x = (k + 0.5) / 6
        stroke(image, [(x, 0.9), (x, 0.2)], 0.012, other)
        for j in range(5):
            y, s = 0.8 - 0.13 * j, 0.05 * (1 - 0.12 * j)
            for side in (-1, 1):
                polygon(image, [(x, y), (x + side * s, y - 0.09), (x + side * 0.3 * s, y - 0.1)],
                        other)  # fmt: skip
    return image


def _floral(look: Look, color: RGB, other: RGB) -> Tile:
    image = canvas(SIDE, SIDE, color)
    for k in range(12):
        x, y = (k % 6 + 0.25 + 0.5 * (k // 6)) / 6, 0.3 + 0.4 * (k // 6)
        for angle in np.arange(5) * 2 * np.pi / 5 + 0.3 * k:
            disc(image, x + 0.045 * np.cos(angle), y + 0.09 * np.sin(angle), 0.04, other)
        disc(image, x, y, 0.035, (240, 200, 90))
    return image


def _print(look: Look, color: RGB, other: RGB, *, badge: bool) -> Tile:
    image = canvas(2 * SIDE, SIDE, color)
    for x in (0.25, 0.5, 0.75):
        part = image[:, int((x - 0.115) * 2 * SIDE) : int((x + 0.115) * 2 * SIDE)]
        if badge:
            disc(part, 0.5, 0.45, 0.21, other)
            disc(part, 0.5, 0.45, 0.17, readable_on(other), 0.155)
            polygon(part, [(0.3, 0.55), (0.5, 0.3), (0.7, 0.55)], readable_on(other))
        elif x == 0.5:
            write(part, look.pick(WORDS), 0.5, 0.42, 0.22, readable_on(color), bold=True)
            fill(part, 0.2, 0.6, 0.6, 0.025, other)
    return image
