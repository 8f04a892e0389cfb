"""Spread-out maps: sheets with creases both ways, and their print."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from types import MappingProxyType

import numpy as np

from ...build.category import Category
from ...build.collision import hull_part
from ...build.forms import spread
from ...build.shape import Shape, shape
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.ink import Canvas
from ...surfaces.look import Look

WIDE, TALL = 336, 232
"""Pixels of a map's print."""


def unfolded_map(look: Look) -> Shape:
    """A large map spread out, its panels still rising and sinking at the creases."""
    x, y = look.between(0.42, 0.56), look.between(0.3, 0.4)
    columns, rows = int(look.pick([4, 6, 8])), int(look.pick([2, 3, 4]))
    lift = look.between(0.002, 0.006)
    land = look.color("cream", "beige", "sage", "mint", "white", "tan", "ivory")
    image = prints.canvas(WIDE, TALL, land)
    DRAWN[look.pick(sorted(DRAWN))](image, look, land)
    _trim(image, look, land)
    _crease(image, columns, rows)
    u = np.linspace(-x / 2, x / 2, columns + 1)
    v = np.linspace(-y / 2, y / 2, rows + 1)
    ridge = np.arange(columns + 1)[None] % 2 + 0.6 * (np.arange(rows + 1)[:, None] % 2)
    height = lift * ridge * look.rng.uniform(0.7, 1, ridge.shape)
    grid = np.stack([*np.meshgrid(u, v), height], -1)
    sheet = spread(grid, 4e-4)
    strips = []
    for k in range(columns):
        low = grid[:, k : k + 2].reshape(-1, 3)
        strips.append(hull_part(np.concatenate([low, low + np.array([0, 0, 4e-4])])))
    return shape([(sheet, image)], strips)


def _trim(image: Canvas, look: Look, land: RGB) -> None:
    """Add a margin, a title and a legend."""
    ink = look.own_color("crimson", "navy", "green", "charcoal", "orange")
    margin = tint_color(land, 1.6)
    for box in ((0, 0, 1, 0.025), (0, 0.975, 1, 0.025), (0, 0, 0.018, 1), (0.982, 0, 0.018, 1)):
        prints.fill(image, *box, margin)
    x, y = look.pick([(0.03, 0.04), (0.72, 0.04), (0.03, 0.7), (0.72, 0.7)])
    prints.fill(image, x, y, 0.25, 0.26, margin)
    prints.fill(image, x, y, 0.25, 0.09, ink)
    panel = image[int(y * TALL) : int((y + 0.09) * TALL), int(x * WIDE) : int((x + 0.25) * WIDE)]
    prints.write(panel, look.pick(["ROADS", "CITY", "ISLES", "ALPS", "PARK"]), 0.5, 0.5, 0.62,
                 (248, 246, 240))  # fmt: skip
    for k, color in enumerate(((200, 70, 60), (226, 170, 70), (90, 140, 200))):
        prints.fill(image, x + 0.02, y + 0.12 + 0.045 * k, 0.04, 0.022, color)
        prints.fill(image, x + 0.08, y + 0.126 + 0.045 * k, 0.12, 0.01, (110, 110, 112))


def _crease(image: Canvas, columns: int, rows: int) -> None:
    """Draw the creases: worn pale in the middle, in shadow beside it."""
    for k in range(1, columns):
        at = k * WIDE // columns
        image[:, at] = image[:, at] * 0.35 + 0.65 * 252
        image[:, at + 1 : at + 3] = image[:, at + 1 : at + 3] * 0.84
    for k in range(1, rows):
        at = k * TALL // rows
        image[at] = image[at] * 0.35 + 0.65 * 252
        image[at + 1 : at + 3] = image[at + 1 : at + 3] * 0.84


def _wander(look: Look, across: bool, rough: float = 0.16) -> list[tuple[float, float]]:
    """Return a winding line from edge to edge."""
    t = np.linspace(0, 1, 60)
    away = look.between(0.2, 0.8) + rough * textures.noise(look.rng, 2, 60, (1, 4), 3)[0]
    pair = (t, away) if across else (away, t)
    return list(zip(*pair, strict=True))


def _city(image: Canvas, look: Look, land: RGB) -> None:
    """Blocks and streets, a river, parks."""
    angle = look.between(-0.5, 0.5)
    c, s = np.cos(angle), np.sin(angle)
    for _ in range(4):
        u, v, r = look.between(0.05, 0.95), look.between(0.05, 0.95), look.between(0.05, 0.11)
        spots = [(u + r * np.cos(a), v + 1.3 * r * np.sin(a)) for a in np.arange(6) + angle]
        prints.polygon(image, spots, (164, 204, 144))
    prints.stroke(image, _wander(look, look.chance(0.5)), 0.06, (140, 186, 222))
    for k in np.linspace(-1, 1, 30):
        for way, side in (((c, s), (-s, c)), ((-s, c), (c, s))):
            at = 0.5 + k * np.array(side)
            ends = [(at[0] - way[0], at[1] - way[1]), (at[0] + way[0], at[1] + way[1])]
            prints.stroke(image, ends, 0.006, tint_color(land, 0.8))
    for color, wide in (((236, 160, 70), 0.028), ((246, 214, 100), 0.018), ((236, 160, 70), 0.02)):
        line = _wander(look, look.chance(0.5), 0.08)
        prints.stroke(image, line, wide + 0.01, (150, 120, 80))
        prints.stroke(image, line, wide, color)


def _relief(image: Canvas, look: Look, land: RGB) -> None:
    """Hills in bands of height with contour lines, lakes, a trail."""
    height = textures.noise(look.rng, TALL, WIDE, (3, 4), 3)
    green = np.array(look.pick([(150, 186, 120), (190, 200, 140), (214, 178, 126)]), float)
    mix = np.clip(0.5 + height, 0, 1)[..., None]
    image[:] = np.clip(green * (1 - mix) + np.array(land) * mix, 0, 255)
    image[(height * 9) % 1 < 0.16] = np.array(tint_color((170, 120, 80), 0.9), np.uint8)
    image[height < -0.42] = (130, 178, 216)
    for ink in ((200, 60, 50), (90, 90, 96)):
        prints.stroke(image, _wander(look, True), 0.012, ink)


def _roads(image: Canvas, look: Look, land: RGB) -> None:
    """A country between seas: forests, towns, roads of three kinds."""
    ground = textures.noise(look.rng, TALL, WIDE, (3, 4), 4)
    image[ground > 0.3] = (182, 210, 150)
    sea = ground < -0.28
    image[sea] = (146, 192, 224)
    image[sea & (ground > -0.31)] = (84, 130, 170)
    inks = ((206, 60, 50), (206, 60, 50), (240, 180, 60), (240, 180, 60), (240, 240, 236))
    for k, ink in enumerate(inks):
        line = _wander(look, k % 2 == 0)
        prints.stroke(image, line, 0.022, (100, 90, 84))
        prints.stroke(image, line, 0.013, ink)
    for _ in range(16):
        prints.disc(image, look.between(0, 1), look.between(0, 1), 0.014, (50, 48, 52))


def _world(image: Canvas, look: Look, land: RGB) -> None:
    """Continents in many colours on a sea with meridians."""
    sea = look.pick([(120, 176, 214), (176, 208, 226), (40, 84, 130)])
    image[:] = np.array(sea, np.uint8)
    ground = textures.noise(look.rng, TALL, WIDE, (3, 5), 4)
    states = textures.noise(look.rng, TALL, WIDE, (7, 9), 2)
    colors = ((232, 196, 110), (150, 186, 120), (220, 140, 110), (190, 160, 200), land)
    rank = np.digitize(states, [-0.35, -0.12, 0.1, 0.35])
    for k, color in enumerate(colors):
        image[(ground > 0.08) & (rank == k)] = np.array(color, np.uint8)
    for k in range(1, 12):
        prints.fill(image, k / 12, 0, 0.004, 1, tint_color(sea, 0.8))
        if k % 2:
            prints.fill(image, 0, k / 12, 1, 0.005, tint_color(sea, 0.8))


def _old(image: Canvas, look: Look, land: RGB) -> None:
    """A parchment chart: an island, a dashed course to a cross, a compass."""
    stain = textures.noise(look.rng, TALL, WIDE, (4, 5), 4)[..., None]
    parchment = np.array(look.pick([(222, 192, 140), (206, 170, 116), (232, 210, 164)]), float)
    image[:] = np.clip(parchment + 22 * stain, 0, 255)
    v, u = np.mgrid[0:TALL, 0:WIDE] / [[[TALL]], [[WIDE]]]
    shore = np.hypot(u - 0.5, 0.9 * (v - 0.5)) + 0.14 * textures.noise(
        look.rng, TALL, WIDE, (4, 5), 3
    )
    image[shore < 0.36] = np.clip(parchment * (0.82, 0.9, 0.72), 0, 255)
    image[np.abs(shore - 0.36) < 0.008] = (96, 66, 40)
    image[np.abs(shore - 0.4) < 0.003] = (130, 96, 60)
    points = _wander(look, True, 0.2)[12:48]
    for k in range(0, len(points) - 2, 3):
        prints.stroke(image, points[k : k + 2], 0.014, (120, 40, 30))
    (x, y) = points[-1]
    for s in (-1, 1):
        ends = [(x - 0.028, y - s * 0.04), (x + 0.028, y + s * 0.04)]
        prints.stroke(image, ends, 0.022, (180, 30, 26))
    for a in np.arange(8) * np.pi / 4:
        long = 0.1 if round(a / (np.pi / 4)) % 2 == 0 else 0.05
        tip = (0.86 + 0.7 * long * np.cos(a), 0.5 + long * np.sin(a))
        prints.stroke(image, [(0.86, 0.5), tip], 0.01, (96, 66, 40))


def _lines(image: Canvas, look: Look, land: RGB) -> None:
    """A network of underground lines with stations."""
    image[:] = np.array(tint_color(land, 1.5), np.uint8)
    prints.stroke(image, _wander(look, True), 0.05, (180, 212, 236))
    inks = ((206, 44, 50), (40, 98, 180), (50, 150, 80), (240, 180, 40), (130, 70, 150))
    for k, ink in enumerate(inks):
        u = np.sort(look.rng.uniform(0.05, 0.95, 4))
        v = look.rng.uniform(0.08, 0.92, 2)
        line = [(0.02, v[0]), (u[1], v[0]), (u[2], v[1]), (0.98, v[1])]
        if k % 2:
            line = [(b, a) for a, b in line]
        prints.stroke(image, line, 0.026, ink)
        for a, b in itertools.pairwise(line):
            for t in (0.25, 0.6, 0.95):
                spot = (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))
                prints.disc(image, *spot, 0.019, (40, 40, 44))
                prints.disc(image, *spot, 0.012, (250, 250, 248))


DRAWN: MappingProxyType[str, Callable[[Canvas, Look, RGB], None]] = MappingProxyType(
    {"city": _city, "lines": _lines, "old": _old, "relief": _relief, "roads": _roads,
     "world": _world}
)  # fmt: skip
"""What a map may show."""

CATEGORIES = (
    Category("map", unfolded_map, (0.49, 0.35, 0.0065), 0.06,
             ("road map", "paper map", "city map", "treasure map", "unfolded map", "open map",
              "world map", "street map", "tourist map", "trail map", "hiking map", "metro map",
              "subway map", "spread map"), ("living", "toys"),
             ("flat", "big"), ("cream",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
