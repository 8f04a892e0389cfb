"""Rough stones and ores as collectors keep them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.making import Drawing, at_box, disc, hull_solid, of, shine, spindle
from ...build.recipes import Pieces, ball
from ...build.solids import Solid
from ...build.variants import at_rest
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

Skin = Callable[[Look, RGB], textures.Tile]


def _lump(look: Look, x: float, y: float, z: float, corners: int) -> Solid:
    """A broken stone with flat faces, the fewer ``corners`` the sharper, set down flat."""
    n = np.arange(corners) + 0.5
    up = 1 - 2 * n / corners
    around = np.pi * (1 + 5**0.5) * n
    away = np.sqrt(1 - up**2)
    p = np.column_stack([away * np.cos(around), away * np.sin(around), up])
    p = p * look.rng.uniform(0.78, 1.12, (corners, 1)) * [x / 2, y / 2, z / 2]
    p[:, 2] = np.maximum(p[:, 2], -0.3 * z)
    return hull_solid(np.add(p, (0, 0, 0.3 * z)))


def _grains(other: str, share: float) -> Skin:
    def skin(look: Look, color: RGB) -> textures.Tile:
        return textures.spots(look.rng, color, look.own_color(other), share)

    return skin


def _veined_skin(factor: float) -> Skin:
    def skin(look: Look, color: RGB) -> textures.Tile:
        return textures.marble(look.rng, color, tint_color(color, factor))

    return skin


def _layered_skin(look: Look, color: RGB) -> textures.Tile:
    return textures.stripes([color, tint_color(color, 0.85), tint_color(color, 1.12), color,
                             tint_color(color, 0.72)], 2)  # fmt: skip


def _metallic(look: Look, color: RGB) -> textures.Tile:
    return textures.brushed_metal(look.rng, color)


def _rough(colors: tuple[str, ...], skin: Skin, size: tuple[float, float, float], corners: int
           ) -> Drawing:  # fmt: skip
    """A stone of one kind."""

    def draw(look: Look) -> Pieces:
        color = look.color(*colors)
        return [(_lump(look, *size, corners), skin(look, color))]

    return draw


def _row(
    key: str,
    colors: tuple[str, ...],
    skin: Skin,
    words: tuple[str, ...],
    *,
    size: tuple[float, float, float] = (0.062, 0.05, 0.046),
    corners: int = 26,
    density: float = 2700,
) -> Category:
    real = (0.93 * size[0], 0.93 * size[1], 0.74 * size[2])
    mass = round(0.5 * real[0] * real[1] * real[2] * density, 4)
    return Category(key, of(_rough(colors, skin, size, corners), spread=0.15), real, mass, words,
                    ("office",), (), colors[:2], state="lying")  # fmt: skip


def _cubes(palette: tuple[str, ...]) -> Drawing:
    """Cubic crystals grown into each other."""

    def draw(look: Look) -> Pieces:
        tile = shine(look, *palette)
        body = at_box(0.03, 0.03, 0.03).turn(2, 0.2)
        more = [at_box(s, s, s).turn(1, 0.3).turn(2, a).move(x, y, z) for s, a, x, y, z in (
            (0.018, 0.6, 0.014, 0.004, 0.004), (0.014, 1.2, -0.012, 0.01, 0.003),
            (0.013, 0.4, 0.002, -0.012, 0.022))]  # fmt: skip
        return [(body, tile), *((m, tile) for m in more)]

    return draw


def _slice(look: Look) -> Pieces:
    """A slice of agate: coloured rings, a crystal middle, a brown rind."""
    color = look.color("blue", "purple", "teal", "orange", "pink", "brown")
    swell = look.rng.uniform(0, 6.28, 2)
    a = 2 * np.pi * np.arange(40) / 40
    wave = 1 + 0.08 * np.sin(2 * a + swell[0]) + 0.05 * np.sin(5 * a + swell[1])
    ring = np.column_stack([0.055 * wave * np.cos(a), 0.042 * wave * np.sin(a)])
    tones = [(92, 70, 54), tint_color(color, 0.7), tint_color(color, 1.5), color,
             tint_color(color, 1.25), tint_color(color, 0.8), tint_color(color, 1.75)]  # fmt: skip
    pieces: Pieces = []
    for k, tone in enumerate(tones):
        rings = np.concatenate([np.column_stack([ring * (1 - 0.12 * k), np.full(40, z)])
                                for z in (0.0, 0.006 + 0.0002 * k)])  # fmt: skip
        pieces.append((hull_solid(rings), textures.speckles(look.rng, tone, 8, 32)))
    return pieces


def _geode(look: Look) -> Pieces:
    """Half a geode: a grey rind round a hollow of crystals."""
    color = look.color("purple", "purple", "white", "blue", "amber")
    rind = _lump(look, 0.1, 0.085, 0.075, 40)
    top = float(rind.bounds[1, 2])
    cut = 0.62 * top
    rind = rind.bend(lambda p: np.column_stack([p[:, :2], np.minimum(p[:, 2], cut)]))
    pieces: Pieces = [(rind, textures.spots(look.rng, (128, 120, 112), (90, 84, 78), 0.2))]
    pale = ball(0.082, 0.068, 0.006, (0, 0, cut), 24)
    pieces.append((pale, textures.speckles(look.rng, tint_color(color, 1.7), 6)))
    for k in range(34):
        r, t = 0.03 * np.sqrt((k + 0.5) / 34), 2.4 * k
        h = look.between(0.008, 0.014)
        tip = [(0.0045 * np.cos(a), 0.0045 * np.sin(a), z) for a in np.arange(6) * np.pi / 3
               for z in (-0.001, 0.6 * h)] + [(0, 0, h)]  # fmt: skip
        one = hull_solid(tip).turn(1, look.between(-0.4, 0.4)).turn(0, look.between(-0.4, 0.4))
        tone = textures.plain(tint_color(color, 0.75 + 0.2 * (k % 4)))
        pieces.append((one.move(1.15 * r * np.cos(t), 0.95 * r * np.sin(t), cut), tone))
    return pieces


def _dripstone(look: Look) -> Pieces:
    color = look.color("cream", "tan", "beige")
    body = spindle((-0.07, 0.003), (-0.05, 0.006), (-0.02, 0.0095), (0.01, 0.0105), (0.03, 0.015),
                  (0.06, 0.019), (0.066, 0.017), sides=14)  # fmt: skip
    return [(body, textures.spots(look.rng, color, tint_color(color, 0.8), 0.2))]


def _logs(look: Look) -> Pieces:
    color = look.color("brown", "terracotta", "tan")
    body = spindle((-0.04, 0.028), (0.04, 0.026), sides=11)
    rings = np.zeros((64, 64, 3))
    y, x = np.mgrid[0:64, 0:64] / 63 - 0.5
    band = (np.hypot(x, y) * 22).astype(int) % 3
    for k, f in enumerate((0.7, 1.0, 1.35)):
        rings[band == k] = tint_color(color, f)
    ends = [disc(0.0255, 0.0006).turn(1, np.pi / 2).move(s * 0.0398, 0, 0.028) for s in (-1, 1)]
    bark = textures.spots(look.rng, tint_color(color, 0.75), tint_color(color, 0.5), 0.25)
    return [(body, bark), *((e, rings.astype(np.uint8)) for e in ends)]


CATEGORIES = (
    _row("malachite", ("green",), _layered_skin, ("piece of malachite", "malachite stone"),
         density=3800),
    at_rest(_row("obsidian", ("black",), _veined_skin(1.5), ("piece of obsidian", "volcanic glass",
             "tektite",
         "obsidian shard"), corners=14)),
    _row("flint", ("charcoal", "gray"), _grains("white", 0.12), ("flintstone", "piece of flint",
         "flint stone", "flint nodule"), corners=16, size=(0.07, 0.045, 0.035)),
    _row("pumice", ("gray", "beige"), _grains("charcoal", 0.2), ("pumice stone", "lava stone"),
         density=700, corners=60),
    _row("granite_sample", ("gray", "pink"), _grains("black", 0.22), ("granite rock",
         "piece of granite", "granite stone", "rock sample", "mineral specimen", "mineral",
         "rock specimen"), corners=18),
    _row("marble_sample", ("white",), _veined_skin(0.6), ("piece of marble", "marble chunk",
         "lump of marble"), corners=16),
    _row("sandstone", ("tan", "terracotta"), _layered_skin, ("sandstone sample",
             "piece of sandstone",
         "limestone", "chalk lump", "lump of chalk"), corners=34, density=2200),
    _row("slate_piece", ("charcoal",), _layered_skin, ("piece of slate", "shale", "slate shard"),
         size=(0.11, 0.075, 0.018), corners=22),
    _row("coal", ("black",), _veined_skin(1.25), ("coal lump",
         "anthracite", "charcoal lump", "piece of charcoal"), corners=16,
         density=1400),
    _row("basalt", ("charcoal",), _grains("black", 0.2), ("basalt rock", "lava rock", "magnetite",
         "lodestone"), density=3000),
    _row("meteorite", ("charcoal", "brown"), _grains("gray", 0.15), ("piece of meteorite",
         "moon rock", "iron meteorite"), density=5500, corners=44),
    _row("iron_ore", ("terracotta", "maroon"), _grains("black", 0.2), ("haematite", "hematite",
         "bauxite", "ore", "piece of ore", "coprolite"), density=4500),
    _row("silver_ore", ("gray",), _grains("white", 0.25), ("silver nugget", "lead ore",
         "piece of silver ore"), density=5000),
    _row("gold_nugget", ("gold",), _metallic, ("nugget of gold", "lump of gold"),
         size=(0.032, 0.024, 0.02), corners=40, density=15000),
    _row("copper_nugget", ("copper",), _metallic, ("native copper", "copper ore"),
         size=(0.045, 0.034, 0.026), corners=40, density=8000),
    at_rest(_row("fluorite", ("purple", "mint"), _veined_skin(1.5), ("fluorite crystal",
             "rough amethyst",
         "rough crystal", "selenite"), corners=12, density=3100)),
    Category("pyrite", of(_cubes(("gold", "brass"))), (0.0507, 0.0423, 0.0357), 0.15,
             ("pyrite cube",
             "fool gold", "iron pyrite", "piece of pyrite"), ("office",), (), ("gold",)),
    Category("galena", of(_cubes(("gray", "silver"))), (0.0505, 0.0422, 0.0357), 0.2,
             ("galena cube",
             "bismuth", "bismuth crystal"), ("office",), (), ("silver",)),
    Category("agate_slice", of(_slice, bodies=1), (0.112, 0.086, 0.0072), 0.09, ("slice of agate",
             "agate coaster", "sliced agate"), ("living",), ("flat",), ("blue", "purple")),
    Category("geode", of(_geode, bodies=2), (0.0984, 0.083, 0.0512), 0.35, ("amethyst geode",
             "crystal geode", "half geode", "split geode"), ("living",), (), ("purple",)),
    at_rest(Category("stalactite", of(_dripstone, 0.15), (0.136, 0.037, 0.037), 0.15, ("stalagmite",
             "stalactite piece", "dripstone"), ("office",), (), ("cream",), state="lying")),
    Category("petrified_wood", of(_logs, 0.12), (0.081, 0.055, 0.056), 0.35, ("fossil wood",
             "petrified log", "piece of petrified wood"), ("office",), (), ("brown",),
             state="lying"),
)  # fmt: skip
"""The module's categories."""
