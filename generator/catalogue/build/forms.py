"""Forms and prints several categories share: side views, lobes, leaves, packets, wrappers."""

from __future__ import annotations

from typing import Any

import numpy as np
from jaxtyping import Float

from ..surfaces import prints, textures
from ..surfaces.colors import RGB, readable_on, tint_color
from ..surfaces.look import Look
from ..surfaces.textures import Tile
from .outlines import lift, smooth
from .solids import Solid, loft, prism, tube


def side_view(outline: Any, width: float, bevel: float = 0.0) -> Solid:
    """Return a side view (x, z; counter-clockwise) as thick as ``width`` along y."""
    return prism(outline, -width / 2, width / 2, bevel).turn(0, np.pi / 2)


def facing(solid: Solid) -> Solid:
    """Return a solid with its top (+z) turned to the front (-y)."""
    return solid.turn(0, np.pi / 2)


def lay_down(solid: Solid, x: float = 0.0, z: float = 0.0) -> Solid:
    """Return a solid that stands on z = 0 laid down along +x from ``x`` at height ``z``."""
    return solid.turn(1, np.pi / 2).move(x=x, z=z)


def lobe(solid: Solid, count: int, depth: float) -> Solid:
    """Return a solid about z with ``count`` lobes: its radius swells and sinks by ``depth``."""

    def warp(p: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 3"]:
        around = np.arctan2(p[:, 1], p[:, 0])
        factor = 1 + depth * (np.abs(np.cos(count * around / 2)) - 0.64)
        return p * np.column_stack([factor, factor, np.ones(len(p))])

    return solid.bend(warp)


def blade(path: Any, width: float, *, thick: float = 0.35, sides: int = 6) -> Solid:
    """Return a leaf or sprout through the points ``path``, widest a third of the way, pointed."""
    points = smooth(path, 3)
    t = np.linspace(0, 1, len(points))
    radii = width / 2 * np.maximum((1 - t) ** 0.8 * (0.55 + 1.6 * t), 0.04)
    return tube(points, radii, sides, squash=thick)


def streaks(rng: np.random.Generator, color: RGB, other: RGB, count: int = 18) -> Tile:
    """Return a skin with soft upright streaks of ``other``."""
    wave = textures.noise(rng, 96, 96, (2, count), 2)
    mix = np.clip(0.5 + wave, 0, 1)[..., None] * 0.8
    return np.clip(np.array(color) * (1 - mix) + np.array(other) * mix, 0, 255).astype(np.uint8)


def speck(image: Tile, rng: np.random.Generator, color: RGB, count: int, side: int = 3) -> Tile:
    """Return a tile with ``count`` specks of ``color`` scattered over it: seeds, crumbs, chips."""
    made = image.copy()
    h, w = made.shape[:2]
    for _ in range(count):
        row, column = rng.integers(0, h - side), rng.integers(0, w - side)
        made[row : row + side, column : column + side] = np.array(color, np.uint8)
    return made


def wrap(
    look: Look, title: str, color: RGB, ground: RGB, *, fronts: int = 1, share: float = 0.3
) -> Tile:
    """A print to go round a packet; the title's panel takes ``share`` of the way round.

    One front lies in the middle (u = 0.5), a second one opposite.
    """
    image = prints.canvas(320, 160, ground)
    prints.lines(image, look.rng, (0.06, 0.28, 0.13, 0.5), 7, tint_color(color, 0.7))
    prints.barcode(image, look.rng, 0.82, 0.4, 0.12)
    wide = int(share * 320)
    panel = prints.canvas(wide, 160, ground)
    prints.disc(panel, 0.5, 0.56, 0.26, color)
    prints.disc(panel, 0.5, 0.56, 0.22, tint_color(color, 1.35))
    prints.fill(panel, 0.04, 0.43, 0.92, 0.26, color)
    prints.write(panel[:, 4:-4], title, 0.5, 0.55, 0.17, readable_on(color), bold=True)
    for k in range(fronts):
        image = np.roll(image, -(320 // 2) * k, axis=1)
        image[:, 160 - wide // 2 : 160 - wide // 2 + wide] = panel
    prints.fill(image, 0, 0, 1, 0.16, color)
    prints.fill(image, 0, 0.84, 1, 0.16, color)
    return image


def turned_to(tile: Tile, u: float) -> Tile:
    """Return a wrap-round print with its front moved from u = 0.5 to ``u``."""
    return np.roll(tile, round((u - 0.5) * tile.shape[1]), axis=1)


def packet(outline: np.ndarray, levels: list[tuple[float, float, float]]) -> Solid:
    """Return a packet: ``outline`` scaled in x and y at each (z, x factor, y factor)."""
    rings = [lift(outline * [fx, fy], z) for z, fx, fy in levels]
    heights = np.array([z for z, _, _ in levels])
    curve = np.column_stack([[fy * 0.05 for _, _, fy in levels], heights])
    span = heights - heights.min()
    return loft(np.stack(rings), outline, v=span / span.max(), profile=curve)


def above(p: np.ndarray) -> np.ndarray:
    """Return points, those under the table lifted onto it."""
    return np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)])


def pillow(x: np.ndarray, y: np.ndarray, lift: np.ndarray) -> Solid:
    """Return a cushion over a grid: raised by ``lift`` above and below, closed at its rim."""
    n = len(x)
    index = np.arange(n * n).reshape(n, n)
    a, b, c, d = index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]
    top = np.concatenate([np.stack(t, -1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
    rim = np.concatenate([index[0, :-1], index[:-1, -1], index[-1, :0:-1], index[:0:-1, 0]])
    after = np.roll(rim, -1)
    wall = np.concatenate([np.stack([rim + n * n, after + n * n, after], 1),
                           np.stack([rim + n * n, after, rim], 1)])  # fmt: skip
    flat = [np.stack([x, y, s * lift], -1).reshape(-1, 3) for s in (1, -1)]
    uv = np.stack(np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n)), -1).reshape(-1, 2)
    faces = np.concatenate([top, top[:, ::-1] + n * n, wall])
    return Solid(np.concatenate(flat), faces, np.concatenate([uv, uv * [-1, 1] + [1, 0]]))


def spread(points: Float[np.ndarray, "n m 3"], thick: float) -> Solid:
    """Return a sheet ``thick`` over a grid of points, its picture upright seen from above.

    ``points`` are the underside: rows run from front to back, columns from left to right.
    """
    n, m = points.shape[:2]
    index = np.arange(n * m).reshape(n, m)
    a, b, c, d = index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]
    top = np.concatenate([np.stack(t, -1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
    rim = np.concatenate([index[0, :-1], index[:-1, -1], index[-1, :0:-1], index[:0:-1, 0]])
    after, up = np.roll(rim, -1), n * m
    wall = np.concatenate([np.stack([rim, after, after + up], 1),
                           np.stack([rim, after + up, rim + up], 1)])  # fmt: skip
    low = points.reshape(-1, 3)
    uv = (low[:, :2] - low[:, :2].min(0)) / np.ptp(low[:, :2], axis=0)
    faces = np.concatenate([top + up, top[:, ::-1], wall])
    return Solid(np.concatenate([low, low + np.array([0, 0, thick])]), faces, np.tile(uv, (2, 1)))
