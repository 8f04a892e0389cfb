"""Procedural texture tiles: small ``uint8`` RGB images, row 0 at the top (v = 1).

Every function is pure: the same arguments and generator state give the same bytes. Sides are
powers of two between 8 and 256 pixels; plain surfaces stay small because they hold little detail.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float, UInt8

from .colors import RGB, tint_color

Tile = UInt8[np.ndarray, "h w 3"]


def _tile(image: Float[np.ndarray, "h w 3"]) -> Tile:
    return np.clip(np.round(image), 0, 255).astype(np.uint8)


def _resize(image: np.ndarray, height: int, width: int) -> np.ndarray:
    """Resample smoothly along both axes."""
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
    """One flat colour."""
    return _tile(np.broadcast_to(np.array(color), (8, 8, 3)).astype(float))


def speckles(rng: np.random.Generator, color: RGB, amount: float = 6.0, side: int = 64) -> Tile:
    """A surface with soft unevenness: plastic, painted metal, ceramic, skin of fruit."""
    shade = noise(rng, side, side, (5, 5), 2) * amount
    return _tile(np.array(color) + shade[..., None])


def spots(
    rng: np.random.Generator, color: RGB, spots: RGB, share: float = 0.02, side: int = 128
) -> Tile:
    """A glaze or crust with fine spots of another colour over a ``share`` of it."""
    image = np.array(color) + noise(rng, side, side, (4, 4), 2)[..., None] * 5
    mask = noise(rng, side, side, (side // 3, side // 3), 1)
    mask = mask > np.quantile(mask, 1 - share)
    return _tile(np.where(mask[..., None], np.array(spots), image))


def wood(
    rng: np.random.Generator, color: RGB, *, grain: float = 1.0, side: int = 128, planks: int = 0
) -> Tile:
    """Wood with its grain along u; ``planks`` draws that many boards."""
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
    """Polished stone with thin veins."""
    y, x = np.mgrid[0 : 1 : side * 1j, 0 : 1 : side * 1j]
    angle = rng.uniform(0.4, 1.1)
    warp = noise(rng, side, side, (4, 4), 4)
    lines = np.abs(np.sin(np.pi * (2.2 * (x * np.cos(angle) + y * np.sin(angle)) + 1.3 * warp)))
    veins = np.exp(-lines * 9)[..., None] * 0.8
    cloud = noise(rng, side, side, (3, 3), 3)[..., None] * 7
    return _tile((np.array(color) + cloud) * (1 - veins) + np.array(vein) * veins)


def brushed_metal(rng: np.random.Generator, color: RGB, side: int = 64) -> Tile:
    """Brushed metal, the strokes along u, with one soft glint."""
    strokes = noise(rng, side, side, (side // 2, 2), 1) * 9
    glint = 18 * np.cos(np.linspace(-2.5, 2.5, side))[None, :]
    return _tile(np.array(color) + (strokes + glint)[..., None])


def fabric(
    rng: np.random.Generator, color: RGB, other: RGB | None = None, threads: int = 32
) -> Tile:
    """Woven cloth; ``other`` gives every second stripe of a check its colour."""
    side = 128
    y, x = np.mgrid[0:side, 0:side]
    weave = 9 * np.sin(2 * np.pi * x * threads / side) * np.sin(2 * np.pi * y * threads / side)
    image = np.array(color) + np.zeros((side, side, 1))
    if other is not None:
        bands = ((x // 16) % 2).astype(float) + ((y // 16) % 2)
        image = image + (np.array(other) - image) * (bands / 2)[..., None]
    return _tile(image + (weave + rng.uniform(-4, 4, (side, side)))[..., None])


def basketwork(rng: np.random.Generator, color: RGB, strands: int = 12) -> Tile:
    """Basketwork: flat strands going over and under each other."""
    side = 96
    y, x = np.mgrid[0:side, 0:side] * strands / side
    over = (np.floor(x) + np.floor(y)) % 2 > 0
    bulge = np.where(over, np.sin(np.pi * (x % 1)), np.sin(np.pi * (y % 1)))
    shade = 0.62 + 0.42 * bulge + 0.06 * noise(rng, side, side, (6, 6), 2)
    return _tile(np.array(color) * shade[..., None])


def cardboard(rng: np.random.Generator, color: RGB = (188, 148, 100)) -> Tile:
    """Corrugated board with parcel tape across the middle."""
    side = 128
    flutes = 4 * np.sin(np.arange(side) * 2 * np.pi / 8)[None]
    image = np.array(color) + (flutes + noise(rng, side, side, (6, 6), 3) * 7)[..., None]
    tape = slice(int(side * 0.42), int(side * 0.58))
    image[tape] = image[tape] * 0.35 + np.array([216, 190, 140]) * 0.65
    return _tile(image)


def stripes(
    colors: Sequence[RGB], counts: int = 1, *, upright: bool = False, side: int = 64
) -> Tile:
    """Bands of ``colors`` from the bottom up (or left to right), repeated ``counts`` times."""
    index = (np.arange(side) * len(colors) * counts // side) % len(colors)
    line = np.array(colors, float)[index]
    image = np.broadcast_to(line[None] if upright else line[::-1, None], (side, side, 3))
    return _tile(image)


def stack(*bands: tuple[Tile, float], side: int = 128) -> Tile:
    """Put tiles above each other, from the bottom up, each with its share of the height."""
    total = sum(share for _, share in bands)
    edges = np.round(np.cumsum([0.0] + [share for _, share in bands]) / total * side).astype(int)
    width = max(tile.shape[1] for tile, _ in bands)
    rows = [
        fit(tile, max(int(b - a), 1), width)
        for (tile, _), a, b in zip(bands, edges, edges[1:], strict=False)
    ]
    return np.concatenate(rows[::-1])


def fit(tile: Tile, height: int, width: int) -> Tile:
    """Resample a tile by nearest pixels."""
    rows = (np.arange(height) + 0.5) * tile.shape[0] / height
    columns = (np.arange(width) + 0.5) * tile.shape[1] / width
    return tile[rows.astype(int)][:, columns.astype(int)]


def gradient(bottom: RGB, top: RGB, rng: np.random.Generator, amount: float = 5.0) -> Tile:
    """Blend two colours from the bottom up, slightly uneven: ripe fruit, glazes, sunsets."""
    side = 64
    t = np.linspace(1, 0, side)[:, None] + 0.12 * noise(rng, side, side, (4, 4), 2)
    t = np.clip(t, 0, 1)[..., None]
    image = np.array(bottom) * (1 - t) + np.array(top) * t
    return _tile(image + noise(rng, side, side, (8, 8), 2)[..., None] * amount)


def grid(line: RGB, ground: RGB, rows: int, columns: int, side: int = 128, width: int = 1) -> Tile:
    """A ruled sheet: ``rows`` by ``columns`` cells; 0 leaves that direction unruled."""
    image = np.broadcast_to(np.array(ground, float), (side, side, 3)).copy()
    for k in range(1, rows):
        image[k * side // rows : k * side // rows + width] = line
    for k in range(1, columns):
        image[:, k * side // columns : k * side // columns + width] = line
    return _tile(image)


def knitting(rng: np.random.Generator, color: RGB, rows: int = 24) -> Tile:
    """Strands of yarn wound in slanted rows."""
    side = 128
    y, x = np.mgrid[0:side, 0:side] / side
    phase = 2 * np.pi * (rows * y + 2 * np.sin(2 * np.pi * x) + rng.random())
    return _tile(np.array(color) * (0.8 + 0.22 * np.sin(phase))[..., None])


def scratches(rng: np.random.Generator, color: RGB, strokes: RGB, count: int = 60) -> Tile:
    """Short slanted strokes on a ground: bread crust, fur, grass, bristles."""
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
    """A leaf: dark green with a pale middle rib along v and side veins."""
    side = 64
    y, x = np.mgrid[0:side, 0:side] / side
    rib = np.exp(-(((x - 0.5) / 0.03) ** 2))
    veins = np.exp(-(np.sin(np.pi * 7 * (y + np.abs(x - 0.5))) ** 2) / 0.02) * 0.35
    mix = np.clip(rib + veins, 0, 1)[..., None] * 0.6
    image = np.array(color) + noise(rng, side, side, (5, 5), 2)[..., None] * 9
    return _tile(image * (1 - mix) + np.array(tint_color(color, 1.5)) * mix)
