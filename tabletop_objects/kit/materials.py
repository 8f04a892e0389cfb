"""Surfaces by material (metal, wood, plastic, cloth, glaze) and the contents of vessels."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from . import surfaces
from .prints import canvas, disc, fill, polygon, stroke, write
from .solids import Solid, cylinder, ellipsoid
from .surfaces import RGB, Look, Tile, plain, readable_on, rgb, speckles, spots, tint_color

DRINKS: Mapping[str, RGB] = MappingProxyType(
    {
        "coffee": (58, 34, 22), "espresso": (44, 26, 18), "tea": (166, 88, 32),
        "milk": (248, 246, 238), "cocoa": (96, 58, 38), "chocolate": (96, 58, 38),
        "juice": (242, 156, 40), "lemonade": (244, 226, 130), "wine": (112, 20, 42),
        "beer": (214, 146, 40), "cola": (48, 26, 20), "coke": (48, 26, 20),
        "soda": (200, 224, 232), "water": (196, 222, 234), "soup": (214, 124, 52),
        "sauce": (176, 44, 30), "oil": (206, 178, 60), "paint": (52, 110, 190),
        "ink": (28, 32, 80), "syrup": (150, 82, 26), "liquid": (120, 160, 190),
    }
)  # fmt: skip
"""Colours of liquids by word; an explicit colour word takes precedence ("blue liquid")."""

FOODS: Mapping[str, RGB] = MappingProxyType(
    {
        "cereal": (206, 152, 82), "crisps": (236, 196, 92), "chips": (236, 196, 92),
        "popcorn": (248, 238, 200), "rice": (244, 240, 228), "salad": (104, 156, 66),
        "sugar": (250, 250, 248), "salt": (248, 248, 246), "flour": (246, 242, 232),
        "nuts": (150, 98, 58), "candy": (226, 84, 110), "sweets": (226, 84, 110),
        "pasta": (238, 206, 118), "butter": (250, 226, 130), "soil": (84, 60, 44),
        "sand": (224, 200, 150), "pepper": (70, 62, 56),
    }
)  # fmt: skip
"""Colours of food and the like by word."""


def drink_color(look: Look) -> RGB | None:
    """Return the colour of the drink in a vessel, or None if its state does not name a drink."""
    state = look.attributes.get("state", "")
    words = state.split()[1:] if state.startswith("with ") else []
    found = next((DRINKS[word] for word in words if word in DRINKS), None)
    return found and (rgb(" ".join(words)) or found)


def contents(look: Look, radius: float, height: float) -> list[tuple[Solid, Tile]] | None:
    """Return the contents of a round vessel with the given radius and fill height, in metres.

    Returns an empty list if the vessel's state is "empty", and None if it does not name contents.
    """
    state = look.attributes.get("state", "")
    if state == "empty":
        return []
    if drink := drink_color(look):
        return [(cylinder(radius, 0.0016, 28).move(z=height), plain(drink))]
    for word in state.split()[1:] if state.startswith("with ") else []:
        if word in FOODS:
            color = rgb(state) or FOODS[word]
            heap = ellipsoid(2 * radius, 2 * radius, 0.5 * radius, 24, 12).move(z=height)
            return [(heap, spots(look.rng, color, tint_color(color, 0.8), 0.3))]
    return None


SIDE = 128
WORDS = ("COFFEE", "HELLO", "TEA", "HOME", "MONDAY", "CLUB", "RUN", "LOVE", "#1", "CAMP", "OK")


def glaze_tile(look: Look, color: RGB, *, words: bool = False) -> Tile:
    """Return the tile for the outside of crockery; u runs around it (0.5 in front) and v upwards.

    The glaze is plain, banded, dipped, speckled, reactive, striped, dotted, checked, leafy or
    floral; with ``words``, it can also have a printed word or badge. If a material is requested,
    it is left plain.
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
    image = surfaces.speckles(rng, color, 4, SIDE).copy()
    edge = rng.uniform(0.35, 0.7) + 0.03 * surfaces.noise(rng, 1, SIDE, (1, 6), 2)[0]
    edge[-12:] += (edge[0] - edge[-1]) * np.linspace(0, 1, 12)
    below = np.arange(SIDE)[:, None] / SIDE > edge[None]
    image[below] = surfaces.speckles(rng, other, 5, SIDE)[below]
    return image


def _speckles(look: Look, color: RGB, other: RGB) -> Tile:
    return surfaces.spots(look.rng, color, tint_color(color, 0.55), look.between(0.02, 0.07))


def _reactive(look: Look, color: RGB, other: RGB) -> Tile:
    low, high = (tint_color(color, 0.5), tint_color(color, 1.3))
    tile = surfaces.gradient(low if look.chance(0.5) else other, high, look.rng, 9)
    return surfaces.fit(tile, SIDE, SIDE)


def _stripes(look: Look, color: RGB, other: RGB) -> Tile:
    upright = look.chance(0.5)
    count = int(look.rng.integers(6, 12)) if upright else int(look.rng.integers(3, 7))
    colors = [color, other] if look.chance(0.5) else [color, color, color, other]
    return surfaces.stripes(colors, count, upright=upright, side=SIDE)


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


def leather(rng: np.random.Generator, color: tuple[float, float, float]) -> Tile:
    """Return a tile of grained leather."""
    return speckles(rng, color, 9, 64)


STEEL = ("silver", "silver", "gray", "charcoal")
BRASS = ("brass", "gold", "bronze")
GOLD = ("gold", "gold", "silver")
WOODEN = ("wooden", "tan", "brown", "wooden", "beige")
DARK: RGB = (40, 42, 46)
STEEL_TONE: RGB = (184, 188, 194)
BRASS_TONE: RGB = (196, 160, 84)
GLASS_TONE: RGB = (206, 224, 228)
PAINTS = ("red", "blue", "green", "yellow", "orange", "purple", "teal", "pink")


def metal(look: Look, *palette: str) -> Tile:
    """Return a metal tile in the object's colour."""
    return look.surface(look.color(*(palette or STEEL)), "metal")


def wood(look: Look, *palette: str) -> Tile:
    """Return a wood tile in the object's colour."""
    return look.surface(look.color(*(palette or WOODEN)), "wood")


def plastic(look: Look, *palette: str) -> Tile:
    """Return a plastic or paint tile in the object's colour."""
    return look.surface(look.color(*(palette or PAINTS)))


def cloth(look: Look, *palette: str) -> Tile:
    """Return a cloth tile in the object's colour."""
    return look.surface(look.color(*palette), "fabric")


def dye(look: Look, *palette: str) -> Tile:
    """Return a paint tile for a detail, independent of the requested colour."""
    return surfaces.speckles(look.rng, look.own_color(*palette), 4, 32)


def steel(look: Look, color: RGB = STEEL_TONE) -> Tile:
    """Return a tile of brushed steel."""
    return surfaces.brushed_metal(look.rng, color)


def shine(look: Look, *palette: str) -> Tile:
    """Return a metal tile for a detail, independent of the requested attributes."""
    return surfaces.brushed_metal(look.rng, look.own_color(*(palette or ("silver",))))


def skin(look: Look, base: RGB, blush: RGB, amount: float = 1.0) -> surfaces.Tile:
    """Return a fruit skin: ``base`` with soft patches of ``blush``."""
    mix = np.clip(surfaces.noise(look.rng, 96, 96, (3, 3), 3) * 0.5 * amount + 0.35, 0, 1)[
        ..., None
    ]
    image = np.array(base) * (1 - mix) + np.array(blush) * mix
    return np.clip(image, 0, 255).astype(np.uint8)


def tool_steel(look: Look) -> surfaces.Tile:
    """Return a tile of bare tool steel."""
    return surfaces.brushed_metal(look.rng, (170, 174, 180))
