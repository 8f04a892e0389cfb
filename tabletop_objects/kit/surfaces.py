"""Colours, texture tiles, and ``Look``, which makes the random choices of one variant.

Tiles are small ``uint8`` RGB images with row 0 at the top (v = 1); their sides are powers of two
between 8 and 256 pixels. Every function is pure: the same arguments and generator state give the
same bytes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import TypeVar

import numpy as np
from jaxtyping import Float, UInt8

RGB = tuple[float, float, float]
"""Red, green, blue in [0, 255]."""

COLORS: Mapping[str, RGB] = MappingProxyType({"white": (240, 238, 233), "cream": (240, 228, 200),
                                              "ivory": (243, 234, 214), "beige": (214, 196, 164),
                                              "black": (38, 38, 41), "charcoal": (62, 64, 68),
                                              "gray": (138, 140, 143), "grey": (138, 140, 143),
                                              "silver": (192, 194, 198), "red": (196, 42, 40),
                                              "crimson": (160, 26, 46), "maroon": (120, 32, 40),
                                              "pink": (236, 158, 178), "coral": (240, 122, 96),
                                              "orange": (238, 132, 38), "amber": (222, 150, 40),
                                              "gold": (212, 172, 82), "golden": (212, 172, 82),
                                              "yellow": (244, 206, 62), "mustard": (206, 160, 52),
                                              "olive": (122, 124, 58), "lime": (160, 204, 70),
                                              "green": (66, 142, 76), "sage": (152, 172, 142),
                                              "mint": (168, 216, 190), "teal": (38, 128, 128),
                                              "turquoise": (72, 184, 184), "cyan": (78, 192, 214),
                                              "sky": (134, 188, 226), "blue": (48, 98, 180),
                                              "navy": (34, 50, 92), "indigo": (66, 60, 132),
                                              "purple": (124, 70, 150), "violet": (140, 92, 176),
                                              "lavender": (186, 168, 214),
                                              "magenta": (200, 60, 136), "brown": (122, 80, 50),
                                              "tan": (196, 158, 112), "terracotta": (188, 98, 66),
                                              "copper": (188, 116, 76), "bronze": (150, 110, 62),
                                              "brass": (196, 160, 84), "clear": (214, 230, 232),
                                              "transparent": (214, 230, 232),
                                              "wooden": (176, 128, 80)})  # fmt: skip


def rgb(word: str) -> RGB | None:
    """Return the colour named by a word or phrase ("dark blue"), or None if it names none."""
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
    """Return ``color`` darkened (factor below 1) or lightened towards white (from 1 to 2)."""
    c = np.array(color, float)
    c = c * factor if factor <= 1 else c + (252 - c) * (factor - 1)
    return float(c[0]), float(c[1]), float(c[2])


def readable_on(color: RGB) -> RGB:
    """Return black or white, whichever is readable on ``color``."""
    return (250, 250, 247) if sum(color) < 380 else (35, 35, 40)


Tile = UInt8[np.ndarray, "_ _ 3"]


def _tile(image: Float[np.ndarray, "h w 3"]) -> Tile:
    return np.clip(np.round(image), 0, 255).astype(np.uint8)


def _resize(image: np.ndarray, height: int, width: int) -> np.ndarray:
    """Resample an image smoothly along both axes."""
    rows = np.linspace(0, image.shape[0] - 1, height)
    columns = np.linspace(0, image.shape[1] - 1, width)
    r, c = (
        np.minimum(rows.astype(int), image.shape[0] - 2),
        np.minimum(columns.astype(int), image.shape[1] - 2),
    )
    fr, fc = rows - r, columns - c
    fr, fc = (fr * fr * (3 - 2 * fr))[:, None], (fc * fc * (3 - 2 * fc))[None]
    low = image[r][:, c] * (1 - fc) + image[r][:, c + 1] * fc
    high = image[r + 1][:, c] * (1 - fc) + image[r + 1][:, c + 1] * fc
    return low * (1 - fr) + high * fr


def noise(
    rng: np.random.Generator, height: int, width: int, cells: tuple[int, int], octaves: int = 3
) -> Float[np.ndarray, "h w"]:
    """Return smooth noise in about [-1, 1]; ``cells`` is the coarsest grid (rows, columns)."""
    total, weight = np.zeros((height, width)), 1.0
    for k in range(octaves):
        grid = rng.uniform(-1, 1, (cells[0] * 2**k + 2, cells[1] * 2**k + 2))
        total += weight * _resize(grid, height, width)
        weight /= 2
    return total / 1.5


def plain(color: RGB) -> Tile:
    """Return a tile of one flat colour."""
    return _tile(np.broadcast_to(np.array(color), (8, 8, 3)).astype(float))


def speckles(rng: np.random.Generator, color: RGB, amount: float = 6.0, side: int = 64) -> Tile:
    """Return a slightly uneven tile for plastic, painted metal, ceramic and fruit skin."""
    shade = noise(rng, side, side, (5, 5), 2) * amount
    return _tile(np.array(color) + shade[..., None])


def spots(
    rng: np.random.Generator, color: RGB, spots: RGB, share: float = 0.02, side: int = 128
) -> Tile:
    """Return a glaze or crust with fine spots of another colour over the fraction ``share``."""
    image = np.array(color) + noise(rng, side, side, (4, 4), 2)[..., None] * 5
    mask = noise(rng, side, side, (side // 3, side // 3), 1)
    mask = mask > np.quantile(mask, 1 - share)
    return _tile(np.where(mask[..., None], np.array(spots), image))


def wood(
    rng: np.random.Generator, color: RGB, *, grain: float = 1.0, side: int = 128, planks: int = 0
) -> Tile:
    """Return a tile of wood with its grain along u, divided into ``planks`` boards."""
    rows = np.linspace(0, 1, side)[:, None]
    wave = noise(rng, side, side, (5, 2), 2)
    rings = np.sin(2 * np.pi * (9 * rows + 1.1 * wave + 3 * rng.random()))
    fibre = noise(rng, side, side, (side // 2, 3), 1)
    shade = grain * (9 * rings + 11 * fibre + 8 * wave)
    if planks:
        board = np.minimum((rows * planks).astype(int), planks - 1)[:, 0]
        shade = shade + grain * rng.uniform(-16, 16, planks)[board][:, None]
        seam = np.abs(rows * planks - np.round(rows * planks))[:, 0] < 0.6 * planks / side
        shade[seam & (rows[:, 0] > 0.02) & (rows[:, 0] < 0.98)] -= 45
    tint = np.array([1.0, 0.88, 0.72])
    return _tile(np.array(color) + shade[..., None] * tint)


def marble(rng: np.random.Generator, color: RGB, vein: RGB, side: int = 128) -> Tile:
    """Return a tile of polished stone with thin veins."""
    y, x = np.mgrid[0 : 1 : side * 1j, 0 : 1 : side * 1j]
    angle = rng.uniform(0.4, 1.1)
    warp = noise(rng, side, side, (4, 4), 4)
    lines = np.abs(np.sin(np.pi * (2.2 * (x * np.cos(angle) + y * np.sin(angle)) + 1.3 * warp)))
    veins = np.exp(-lines * 9)[..., None] * 0.8
    cloud = noise(rng, side, side, (3, 3), 3)[..., None] * 7
    return _tile((np.array(color) + cloud) * (1 - veins) + np.array(vein) * veins)


def brushed_metal(rng: np.random.Generator, color: RGB, side: int = 64) -> Tile:
    """Return a tile of brushed metal with strokes along u and one soft highlight."""
    strokes = noise(rng, side, side, (side // 2, 2), 1) * 9
    glint = 18 * np.cos(np.linspace(-2.5, 2.5, side))[None, :]
    return _tile(np.array(color) + (strokes + glint)[..., None])


def fabric(
    rng: np.random.Generator, color: RGB, other: RGB | None = None, threads: int = 32
) -> Tile:
    """Return a tile of woven cloth; ``other`` is the second colour of a checked pattern."""
    side = 128
    y, x = np.mgrid[0:side, 0:side]
    weave = 9 * np.sin(2 * np.pi * x * threads / side) * np.sin(2 * np.pi * y * threads / side)
    image = np.array(color) + np.zeros((side, side, 1))
    if other is not None:
        bands = ((x // 16) % 2).astype(float) + ((y // 16) % 2)
        image = image + (np.array(other) - image) * (bands / 2)[..., None]
    return _tile(image + (weave + rng.uniform(-4, 4, (side, side)))[..., None])


def basketwork(rng: np.random.Generator, color: RGB, strands: int = 12) -> Tile:
    """Return a tile of basketwork, with flat strands woven over and under each other."""
    side = 96
    y, x = np.mgrid[0:side, 0:side] * strands / side
    over = (np.floor(x) + np.floor(y)) % 2 > 0
    bulge = np.where(over, np.sin(np.pi * (x % 1)), np.sin(np.pi * (y % 1)))
    shade = 0.62 + 0.42 * bulge + 0.06 * noise(rng, side, side, (6, 6), 2)
    return _tile(np.array(color) * shade[..., None])


def cardboard(rng: np.random.Generator, color: RGB = (188, 148, 100)) -> Tile:
    """Return corrugated cardboard with parcel tape across the middle."""
    side = 128
    flutes = 4 * np.sin(np.arange(side) * 2 * np.pi / 8)[None]
    image = np.array(color) + (flutes + noise(rng, side, side, (6, 6), 3) * 7)[..., None]
    tape = slice(int(side * 0.42), int(side * 0.58))
    image[tape] = image[tape] * 0.35 + np.array([216, 190, 140]) * 0.65
    return _tile(image)


def stripes(
    colors: Sequence[RGB], counts: int = 1, *, upright: bool = False, side: int = 64
) -> Tile:
    """Return ``colors`` as stripes, upwards or from left to right, repeated ``counts`` times."""
    index = (np.arange(side) * len(colors) * counts // side) % len(colors)
    line = np.array(colors, float)[index]
    image = np.broadcast_to(line[None] if upright else line[::-1, None], (side, side, 3))
    return _tile(image)


def stack(*bands: tuple[Tile, float], side: int = 128) -> Tile:
    """Stack tiles from the bottom up, each at its given fraction of the height."""
    total = sum(share for _, share in bands)
    edges = np.round(np.cumsum([0.0] + [share for _, share in bands]) / total * side).astype(int)
    width = max(tile.shape[1] for tile, _ in bands)
    rows = [
        fit(tile, max(int(b - a), 1), width)
        for (tile, _), a, b in zip(bands, edges, edges[1:], strict=False)
    ]
    return np.concatenate(rows[::-1])


def fit(tile: Tile, height: int, width: int) -> Tile:
    """Resample a tile with nearest-neighbour interpolation."""
    rows = (np.arange(height) + 0.5) * tile.shape[0] / height
    columns = (np.arange(width) + 0.5) * tile.shape[1] / width
    return tile[rows.astype(int)][:, columns.astype(int)]


def gradient(bottom: RGB, top: RGB, rng: np.random.Generator, amount: float = 5.0) -> Tile:
    """Blend two colours unevenly from the bottom up, for ripe fruit, glazes and sunsets."""
    side = 64
    t = np.linspace(1, 0, side)[:, None] + 0.12 * noise(rng, side, side, (4, 4), 2)
    t = np.clip(t, 0, 1)[..., None]
    image = np.array(bottom) * (1 - t) + np.array(top) * t
    return _tile(image + noise(rng, side, side, (8, 8), 2)[..., None] * amount)


def grid(line: RGB, ground: RGB, rows: int, columns: int, side: int = 128, width: int = 1) -> Tile:
    """Return a ruled sheet of ``rows`` by ``columns`` cells; 0 means no lines in that direction."""
    image = np.broadcast_to(np.array(ground, float), (side, side, 3)).copy()
    for k in range(1, rows):
        image[k * side // rows : k * side // rows + width] = line
    for k in range(1, columns):
        image[:, k * side // columns : k * side // columns + width] = line
    return _tile(image)


def knitting(rng: np.random.Generator, color: RGB, rows: int = 24) -> Tile:
    """Return a tile of yarn wound in slanted rows."""
    side = 128
    y, x = np.mgrid[0:side, 0:side] / side
    phase = 2 * np.pi * (rows * y + 2 * np.sin(2 * np.pi * x) + rng.random())
    return _tile(np.array(color) * (0.8 + 0.22 * np.sin(phase))[..., None])


def scratches(rng: np.random.Generator, color: RGB, strokes: RGB, count: int = 60) -> Tile:
    """Return a tile with short slanted strokes, for bread crust, fur, grass and bristles."""
    side = 128
    image = np.broadcast_to(np.array(color, float), (side, side, 3)).copy()
    image += noise(rng, side, side, (6, 6), 3)[..., None] * 8
    for row, column, length in zip(
        rng.integers(0, side - 10, count),
        rng.integers(0, side - 20, count),
        rng.integers(5, 16, count),
        strict=True,
    ):
        steps = np.arange(length)
        image[row + steps // 2, column + steps] = strokes
    return _tile(image)


def leaf(rng: np.random.Generator, color: RGB) -> Tile:
    """Return a leaf in ``color`` with side veins and a pale midrib along v."""
    side = 64
    y, x = np.mgrid[0:side, 0:side] / side
    rib = np.exp(-(((x - 0.5) / 0.03) ** 2))
    veins = np.exp(-(np.sin(np.pi * 7 * (y + np.abs(x - 0.5))) ** 2) / 0.02) * 0.35
    mix = np.clip(rib + veins, 0, 1)[..., None] * 0.6
    image = np.array(color) + noise(rng, side, side, (5, 5), 2)[..., None] * 9
    return _tile(image * (1 - mix) + np.array(tint_color(color, 1.5)) * mix)


T = TypeVar("T")

SIZE_FACTORS: Mapping[str, float] = {"tiny": 0.65, "mini": 0.7, "small": 0.8, "little": 0.8,
                                     "medium": 1.0, "big": 1.25, "large": 1.25, "huge": 1.45,
                                     "giant": 1.45}  # fmt: skip
"""Factors by which size words scale an object's extent."""


def size_factor(attributes: Mapping[str, str]) -> float:
    """Return the scale factor of the attribute "size", or 1 if it has no known size word."""
    words = attributes.get("size", "").lower().split()
    return next((SIZE_FACTORS[word] for word in words if word in SIZE_FACTORS), 1.0)


WOODS: Mapping[str, RGB] = {"oak": (196, 154, 104), "walnut": (112, 76, 50),
                            "pine": (222, 186, 132), "beech": (214, 172, 124),
                            "maple": (226, 194, 148), "cherry": (156, 88, 56),
                            "mahogany": (116, 58, 40), "birch": (230, 206, 166),
                            "bamboo": (220, 190, 124), "teak": (166, 112, 66),
                            "ebony": (58, 46, 42), "wood": (190, 144, 94),
                            "wooden": (190, 144, 94)}  # fmt: skip
"""Ground colours of woods."""

METALS: Mapping[str, RGB] = {"steel": (176, 180, 186), "stainless": (186, 190, 194),
                             "metal": (172, 176, 182), "metallic": (172, 176, 182),
                             "aluminum": (196, 198, 202), "iron": (74, 76, 80),
                             "brass": (196, 160, 84), "copper": (188, 116, 76),
                             "bronze": (150, 110, 62), "gold": (212, 172, 82),
                             "silver": (200, 202, 206), "chrome": (206, 210, 214)}  # fmt: skip
"""Ground colours of metals."""


@dataclass(frozen=True, eq=False)
class Look:
    """The random generator and requested attributes from which one variant is drawn.

    Draw random numbers first and in a fixed order, so that a seed always gives the same variant.
    """

    rng: np.random.Generator
    attributes: Mapping[str, str]

    def between(self, low: float, high: float) -> float:
        """Return a uniform random number between ``low`` and ``high``."""
        return float(self.rng.uniform(low, high))

    def pick(self, options: Sequence[T]) -> T:
        """Return one of ``options`` with equal probability."""
        return options[int(self.rng.integers(len(options)))]

    def chance(self, probability: float) -> bool:
        """Return True with the given probability."""
        return bool(self.rng.random() < probability)

    @property
    def material(self) -> str:
        """The requested material in lower case, or an empty string."""
        return self.attributes.get("material", "").lower()

    def color(self, *palette: str, spread: float = 8.0) -> RGB:
        """Return the requested colour, or a random one from ``palette``, slightly varied."""
        choice = self.pick(palette)
        drift = self.rng.uniform(-spread, spread, 3)
        asked = rgb(self.attributes.get("color", ""))
        base = asked if asked is not None else rgb(choice)
        if base is None:
            raise ValueError(f"{choice!r} is not the name of a colour.")
        r, g, b = np.clip(np.array(base) + drift, 6, 250)
        return float(r), float(g), float(b)

    def own_color(self, *palette: str, spread: float = 6.0) -> RGB:
        """Return a colour from ``palette`` for a detail, independent of the requested colour."""
        return Look(self.rng, {}).color(*palette, spread=spread)

    def surface(self, color: RGB, default: str = "plastic") -> Tile:
        """Return a tile of the requested material, or else of ``default``, in ``color``.

        A requested wood or metal has its usual colour unless a colour is also requested.
        """
        asked = self.material
        word = asked or default
        own = "color" not in self.attributes and asked != ""
        for key, ground in WOODS.items():
            if key in word.split():
                return wood(self.rng, ground if own else color)
        for key, ground in METALS.items():
            if key in word.split():
                return brushed_metal(self.rng, ground if own else color)
        if "marble" in word or "stone" in word:
            ground = (232, 230, 226) if own else color
            return marble(self.rng, ground, tint_color(ground, 0.6))
        if word in ("fabric", "cloth", "linen", "cotton", "felt", "wool"):
            return fabric(self.rng, color)
        if word in ("stoneware", "clay", "granite"):
            return spots(self.rng, color, tint_color(color, 0.55))
        return speckles(self.rng, color, 3.0, 32)


def streaks(rng: np.random.Generator, color: RGB, other: RGB, count: int = 18) -> Tile:
    """Return a skin with soft vertical streaks of ``other``."""
    wave = noise(rng, 96, 96, (2, count), 2)
    mix = np.clip(0.5 + wave, 0, 1)[..., None] * 0.8
    return np.clip(np.array(color) * (1 - mix) + np.array(other) * mix, 0, 255).astype(np.uint8)


def speck(image: Tile, rng: np.random.Generator, color: RGB, count: int, side: int = 3) -> Tile:
    """Return a tile with ``count`` scattered specks of ``color``, for seeds, crumbs or chips."""
    made = image.copy()
    h, w = made.shape[:2]
    for _ in range(count):
        row, column = rng.integers(0, h - side), rng.integers(0, w - side)
        made[row : row + side, column : column + side] = np.array(color, np.uint8)
    return made
