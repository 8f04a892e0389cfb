"""Objects of the ``office`` theme: minerals."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import surfaces
from ...kit.materials import shine
from ...kit.primitives import at_box, hull_solid, spindle
from ...kit.shapes import Category, Drawing, Pieces, at_rest, category, from_pieces
from ...kit.solids import Solid
from ...kit.surfaces import RGB, Look, tint_color

Skin = Callable[[Look, RGB], surfaces.Tile]


def lump(look: Look, x: float, y: float, z: float, corners: int) -> Solid:
    """Return a broken stone that rests on a flat face; fewer ``corners`` make it more angular."""
    n = np.arange(corners) + 0.5
    up = 1 - 2 * n / corners
    around = np.pi * (1 + 5**0.5) * n
    away = np.sqrt(1 - up**2)
    p = np.column_stack([away * np.cos(around), away * np.sin(around), up])
    p = p * look.rng.uniform(0.78, 1.12, (corners, 1)) * [x / 2, y / 2, z / 2]
    p[:, 2] = np.maximum(p[:, 2], -0.3 * z)
    return hull_solid(np.add(p, (0, 0, 0.3 * z)))


def _grains(other: str, share: float) -> Skin:
    def skin(look: Look, color: RGB) -> surfaces.Tile:
        return surfaces.spots(look.rng, color, look.own_color(other), share)

    return skin


def _veined_skin(factor: float) -> Skin:
    def skin(look: Look, color: RGB) -> surfaces.Tile:
        return surfaces.marble(look.rng, color, tint_color(color, factor))

    return skin


def _layered_skin(look: Look, color: RGB) -> surfaces.Tile:
    return surfaces.stripes([color, tint_color(color, 0.85), tint_color(color, 1.12), color,
                             tint_color(color, 0.72)], 2)  # fmt: skip


def _metallic(look: Look, color: RGB) -> surfaces.Tile:
    return surfaces.brushed_metal(look.rng, color)


def _rough(colors: tuple[str, ...], skin: Skin, size: tuple[float, float, float], corners: int
           ) -> Drawing:  # fmt: skip
    """Return the drawing function of a rough stone of the given colours, texture and size."""

    def draw(look: Look) -> Pieces:
        color = look.color(*colors)
        return [(lump(look, *size, corners), skin(look, color))]

    return draw


def _cubes(palette: tuple[str, ...]) -> Drawing:
    """Return the drawing function of intergrown cubic crystals."""

    def draw(look: Look) -> Pieces:
        tile = shine(look, *palette)
        body = at_box(0.03, 0.03, 0.03).turn(2, 0.2)
        more = [at_box(s, s, s).turn(1, 0.3).turn(2, a).move(x, y, z) for s, a, x, y, z in (
            (0.018, 0.6, 0.014, 0.004, 0.004), (0.014, 1.2, -0.012, 0.01, 0.003),
            (0.013, 0.4, 0.002, -0.012, 0.022))]  # fmt: skip
        return [(body, tile), *((m, tile) for m in more)]

    return draw


@category("stalactite", size=(0.136, 0.037, 0.037), mass=0.15, material="stone",
          aliases=("stalagmite", "stalactite piece", "dripstone"), themes=("office",),
          colors=("cream",), state="lying")  # fmt: skip
@at_rest
@from_pieces(foot=0.15)
def stalactite(look: Look) -> Pieces:
    """A stalactite lying flat: an uneven stone cone, thin on the left and thick on the right."""
    color = look.color("cream", "tan", "beige")
    body = spindle((-0.07, 0.003), (-0.05, 0.006), (-0.02, 0.0095), (0.01, 0.0105), (0.03, 0.015),
                  (0.06, 0.019), (0.066, 0.017), sides=14)  # fmt: skip
    return [(body, surfaces.spots(look.rng, color, tint_color(color, 0.8), 0.2))]


CATEGORIES = (
    Category("malachite",
             from_pieces(spread=0.15)(_rough(("green",), _layered_skin, (0.062, 0.05, 0.046), 26)),
             size=(0.05766, 0.04650000000000001, 0.03404), mass=0.1734, material="stone",
             aliases=("piece of malachite", "malachite stone"), themes=("office",),
             colors=("green",), state="lying"),
    Category("obsidian", at_rest(from_pieces(spread=0.15)(_rough(("black",), _veined_skin(1.5),
             (0.062, 0.05, 0.046), 14))), size=(0.05766, 0.04650000000000001, 0.03404), mass=0.1232,
             material="stone",
             aliases=("piece of obsidian", "volcanic glass", "tektite", "obsidian shard"),
             themes=("office",), colors=("black",), state="lying"),
    Category("flint", from_pieces(spread=0.15)(_rough(("charcoal", "gray"), _grains("white", 0.12),
             (0.07, 0.045, 0.035), 16)), size=(0.0651, 0.04185, 0.025900000000000003), mass=0.0953,
             material="stone",
             aliases=("flintstone", "piece of flint", "flint stone", "flint nodule"),
             themes=("office",), colors=("charcoal", "gray"), state="lying"),
    Category("pumice", from_pieces(spread=0.15)(_rough(("gray", "beige"), _grains("charcoal", 0.2),
             (0.062, 0.05, 0.046), 60)), size=(0.05766, 0.04650000000000001, 0.03404), mass=0.0319,
             material="stone", aliases=("pumice stone", "lava stone"), themes=("office",),
             colors=("gray", "beige"), state="lying"),
    Category("granite_sample", from_pieces(spread=0.15)(_rough(("gray", "pink"), _grains("black",
             0.22), (0.062, 0.05, 0.046), 18)), size=(0.05766, 0.04650000000000001, 0.03404),
             mass=0.1232, material="stone", aliases=("granite rock", "piece of granite",
             "granite stone", "rock sample", "mineral specimen", "mineral", "rock specimen"),
             themes=("office",), colors=("gray", "pink"), state="lying"),
    Category("marble_sample", from_pieces(spread=0.15)(_rough(("white",), _veined_skin(0.6),
             (0.062, 0.05, 0.046), 16)), size=(0.05766, 0.04650000000000001, 0.03404), mass=0.1232,
             material="stone", aliases=("piece of marble", "marble chunk", "lump of marble"),
             themes=("office",), colors=("white",), state="lying"),
    Category("sandstone", from_pieces(spread=0.15)(_rough(("tan", "terracotta"), _layered_skin,
             (0.062, 0.05, 0.046), 34)), size=(0.05766, 0.04650000000000001, 0.03404), mass=0.1004,
             material="stone", aliases=("sandstone sample", "piece of sandstone", "limestone",
             "chalk lump", "lump of chalk"), themes=("office",), colors=("tan", "terracotta"),
             state="lying"),
    Category("slate_piece", from_pieces(spread=0.15)(_rough(("charcoal",), _layered_skin,
             (0.11, 0.075, 0.018), 22)), size=(0.1023, 0.06975, 0.013319999999999999), mass=0.1283,
             material="stone", aliases=("piece of slate", "shale", "slate shard"),
             themes=("office",), colors=("charcoal",), state="lying"),
    Category("coal", from_pieces(spread=0.15)(_rough(("black",), _veined_skin(1.25),
             (0.062, 0.05, 0.046), 16)), size=(0.05766, 0.04650000000000001, 0.03404), mass=0.0639,
             material="stone",
             aliases=("coal lump", "anthracite", "charcoal lump", "piece of charcoal"),
             themes=("office",), colors=("black",), state="lying"),
    Category("basalt", from_pieces(spread=0.15)(_rough(("charcoal",), _grains("black", 0.2),
             (0.062, 0.05, 0.046), 26)), size=(0.05766, 0.04650000000000001, 0.03404), mass=0.1369,
             material="stone", aliases=("basalt rock", "lava rock", "magnetite", "lodestone"),
             themes=("office",), colors=("charcoal",), state="lying"),
    Category("meteorite", from_pieces(spread=0.15)(_rough(("charcoal", "brown"), _grains("gray",
             0.15), (0.062, 0.05, 0.046), 44)), size=(0.05766, 0.04650000000000001, 0.03404),
             mass=0.251, material="stone",
             aliases=("piece of meteorite", "moon rock", "iron meteorite"), themes=("office",),
             colors=("charcoal", "brown"), state="lying"),
    Category("iron_ore", from_pieces(spread=0.15)(_rough(("terracotta", "maroon"), _grains("black",
             0.2), (0.062, 0.05, 0.046), 26)), size=(0.05766, 0.04650000000000001, 0.03404),
             mass=0.2054, material="stone",
             aliases=("haematite", "hematite", "bauxite", "ore", "piece of ore", "coprolite"),
             themes=("office",), colors=("terracotta", "maroon"), state="lying"),
    Category("silver_ore", from_pieces(spread=0.15)(_rough(("gray",), _grains("white", 0.25),
             (0.062, 0.05, 0.046), 26)), size=(0.05766, 0.04650000000000001, 0.03404), mass=0.2282,
             material="stone", aliases=("silver nugget", "lead ore", "piece of silver ore"),
             themes=("office",), colors=("gray",), state="lying"),
    Category("gold_nugget",
             from_pieces(spread=0.15)(_rough(("gold",), _metallic, (0.032, 0.024, 0.02), 40)),
             size=(0.02976, 0.022320000000000003, 0.0148), mass=0.0737, material="stone",
             aliases=("nugget of gold", "lump of gold"), themes=("office",), colors=("gold",),
             state="lying"),
    Category("copper_nugget",
             from_pieces(spread=0.15)(_rough(("copper",), _metallic, (0.045, 0.034, 0.026), 40)),
             size=(0.04185, 0.03162, 0.01924), mass=0.1018, material="stone",
             aliases=("native copper", "copper ore"), themes=("office",), colors=("copper",),
             state="lying"),
    Category("fluorite", at_rest(from_pieces(spread=0.15)(_rough(("purple", "mint"),
             _veined_skin(1.5), (0.062, 0.05, 0.046), 12))),
             size=(0.05766, 0.04650000000000001, 0.03404), mass=0.1415, material="stone",
             aliases=("fluorite crystal", "rough amethyst", "rough crystal", "selenite"),
             themes=("office",), colors=("purple", "mint"), state="lying"),
    Category("pyrite", from_pieces()(_cubes(("gold", "brass"))), size=(0.0507, 0.0423, 0.0357),
             mass=0.15, material="stone",
             aliases=("pyrite cube", "fool gold", "iron pyrite", "piece of pyrite"),
             themes=("office",), colors=("gold",)),
    Category("galena", from_pieces()(_cubes(("gray", "silver"))), size=(0.0505, 0.0422, 0.0357),
             mass=0.2, material="stone", aliases=("galena cube", "bismuth", "bismuth crystal"),
             themes=("office",), colors=("silver",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
