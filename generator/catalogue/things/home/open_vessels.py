"""Vessels that stand open and empty, for what a text puts into them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, frame_parts, hull_of
from ...build.outlines import smooth
from ...build.recipes import open_vessel
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, join, lathe, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look

_CARTON = (190, 150, 104)
_WOODS = ("wood", "wooden", "oak", "walnut", "pine", "bamboo")


def _walls(x: float, y: float, h: float, wall: float, bottom: float) -> list[Solid]:
    """Return the bottom and the four walls of an open box standing on z = 0."""
    across = box(x, wall, h - bottom)
    along = box(wall, y - 2 * wall, h - bottom)
    return [
        box(x, y, bottom),
        *(across.move(y=s * (y - wall) / 2, z=bottom) for s in (-1, 1)),
        *(along.move(x=s * (x - wall) / 2, z=bottom) for s in (-1, 1)),
    ]


def open_box(look: Look) -> Shape:
    """A wooden box or a cardboard carton without a lid."""
    x, y, h = look.between(0.24, 0.3), look.between(0.17, 0.21), look.between(0.1, 0.13)
    wooden = look.attributes.get("material", "") in _WOODS
    skin = textures.speckles(look.rng, _CARTON, 4)
    if wooden:
        skin = look.surface(look.color("wooden"), "wood")
    elif "color" in look.attributes:
        skin = look.surface(look.color("tan"), "plastic")
    wall = 0.008 if wooden else 0.004
    return shape([(s, skin) for s in _walls(x, y, h, wall, wall)], frame_parts(x, y, h, wall, wall))


def _case(
    size: tuple[float, float, float], wall: float, colors: tuple[str, ...], lining: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """Return the shape of a case whose lid stands open at the back."""

    def make(look: Look) -> Shape:
        k = look.between(0.95, 1.05)
        x, y, h = (float(v) * k for v in size)
        outside = look.surface(look.color(*colors), "plastic")
        inside = textures.plain(look.own_color(*lining))
        lid = box(x, 0.28 * h, 0.85 * y).move(y=y / 2 + 0.14 * h, z=0.1 * h)
        panel = box(x - 4 * wall, 0.004, 0.85 * y - 4 * wall).move(y=y / 2, z=0.1 * h + 2 * wall)
        handle = box(0.3 * x, 0.014, 0.016).move(y=-y / 2 - 0.007, z=0.55 * h)
        pieces = [*((s, outside) for s in _walls(x, y, h, wall, wall)), (lid, outside),
                  (panel, inside), (handle, textures.plain((52, 52, 56)))]  # fmt: skip
        parts = [*frame_parts(x, y, h, wall, wall),
                 box_part(x, 0.28 * h, 0.85 * y + 0.1 * h, (0, y / 2 + 0.14 * h, 0))]  # fmt: skip
        return shape(pieces, parts)

    return make


def pen_cup(look: Look) -> Shape:
    """A cup for pens, empty."""
    r, h = look.between(0.038, 0.043), look.between(0.09, 0.105)
    color = look.color("black", "white", "teal", "wooden", "coral", "silver", "navy", "mustard")
    body, parts = open_vessel([(r, 0), (r, h)], 0.003, 0.005)
    return shape([(body, look.surface(color, look.pick(["plastic", "wood", "metal"])))], parts)


def open_jar(look: Look) -> Shape:
    """A glass jar without its lid."""
    r, h = look.between(0.045, 0.052), look.between(0.12, 0.14)
    side = [(0.94 * r, 0), (r, 0.08 * h), (r, 0.8 * h), (0.84 * r, 0.9 * h), (0.84 * r, h)]
    body, parts = open_vessel(side, 0.003, 0.006)
    tint = look.color("clear", "clear", "sky", "mint")
    return shape([(body, look.surface(tint, "glass"))], parts, opacity=0.55)


def steamer(look: Look) -> Shape:
    """One tier of a bamboo steamer without its lid."""
    r, h = look.between(0.09, 0.11), look.between(0.05, 0.058)
    color = look.color("tan", "beige", "wooden")
    body, parts = open_vessel([(r, 0), (r, h)], 0.005, 0.008)
    weave = textures.basketwork(look.rng, color, 16)
    dark = textures.speckles(look.rng, tint_color(color, 0.78), 8)
    inside = textures.speckles(look.rng, color, 8)
    skin = textures.stack((dark, 0.08), (weave, 0.3), (dark, 0.08), (inside, 0.54), side=128)
    return shape([(body, skin)], parts)


def ice_bucket(look: Look) -> Shape:
    """A bucket for bottles on ice, with two ring handles, empty."""
    r, h = look.between(0.085, 0.1), look.between(0.17, 0.2)
    color = look.color("silver", "silver", "copper", "gold", "black", "white")
    skin = look.surface(color, "metal")
    body, parts = open_vessel([(0.76 * r, 0), (r, h)], 0.004, 0.008)
    ring = torus(0.022, 0.0035, 20, 6).turn(1, np.pi / 2)
    ears = [ring.move(s * (0.93 * r + 0.003), 0, 0.74 * h) for s in (-1, 1)]
    return shape([(body, skin), (join(ears), skin)], [*parts, *(hull_of(e) for e in ears)])


def pot(look: Look) -> Shape:
    """A cooking pot without its lid."""
    r, h = look.between(0.1, 0.118), look.between(0.1, 0.125)
    color = look.color("silver", "silver", "red", "black", "blue", "copper", "cream")
    skin = look.surface(color, "metal")
    body, parts = open_vessel([(0.97 * r, 0), (r, 0.06 * h), (r, h)], 0.003, 0.006, 40)
    ears = [tube(smooth([(s * 0.99 * r, -0.03, 0.8 * h), (s * (r + 0.022), -0.02, 0.82 * h),
                         (s * (r + 0.022), 0.02, 0.82 * h), (s * 0.99 * r, 0.03, 0.8 * h)], 3),
                 0.0045, 8) for s in (-1, 1)]  # fmt: skip
    return shape([(body, skin), *((e, skin) for e in ears)], [*parts, *map(hull_of, ears)])


def tin_can(look: Look) -> Shape:
    """A tin can without its lid."""
    r, h = look.between(0.036, 0.042), look.between(0.105, 0.118)
    metal = textures.brushed_metal(look.rng, (176, 178, 182))
    color = look.own_color("silver", "red", "green", "navy", "cream")
    body, parts = open_vessel([(r, 0), (r, h)], 0.0025, 0.004)
    sleeve = lathe([(r, 0.1 * h), (r + 0.0006, 0.1 * h), (r + 0.0006, 0.9 * h), (r, 0.9 * h)], 32,
                   loop=True)  # fmt: skip
    return shape([(body, metal), (sleeve, textures.speckles(look.rng, color, 4))], parts)


def utensil_crock(look: Look) -> Shape:
    """A stoneware crock for wooden spoons and whisks, empty."""
    r, h = look.between(0.058, 0.066), look.between(0.15, 0.175)
    color = look.color("white", "cream", "sage", "navy", "terracotta", "charcoal")
    side = [(0.92 * r, 0), (r, 0.12 * h), (0.98 * r, 0.85 * h), (r, h)]
    body, parts = open_vessel(side, 0.005, 0.01)
    return shape([(body, textures.fit(glaze_tile(look, color), 128, 128))], parts)


def empty_vase(look: Look) -> Shape:
    """A vase with nothing in it."""
    r, h = look.between(0.05, 0.057), look.between(0.155, 0.175)
    t = np.linspace(0, 1, 8)
    swell = 0.62 + 0.38 * np.sin(np.pi * (0.12 + 0.72 * t))
    color = look.color("white", "teal", "terracotta", "navy", "cream", "sage", "mustard", "pink")
    side = [(float(r * s), float(h * u)) for s, u in zip(swell, t, strict=True)]
    body, parts = open_vessel(side, 0.004, 0.008)
    return shape([(body, textures.fit(glaze_tile(look, color), 128, 128))], parts)


CATEGORIES = (
    Category("open_box", open_box, (0.27, 0.19, 0.115), 0.5,
             ("open carton", "open cardboard box", "storage bin", "bin without a lid"), ("living",),
             ("container", "big"), ("tan", "wooden")),
    Category("tool_caddy", _case((0.34, 0.19, 0.1), 0.005, ("red", "blue", "black", "yellow"),
                                 ("gray",)),
             (0.34, 0.23, 0.18), 1.6, ("open tool box", "tool tray"), ("workbench",),
             ("container", "big"), ("red", "blue")),
    Category("open_suitcase", _case((0.42, 0.28, 0.11), 0.006, ("brown", "navy", "teal", "red"),
                                    ("cream", "gray")),
             (0.42, 0.32, 0.26), 1.8, ("opened suitcase",), ("living",), ("container", "big"),
             ("brown", "navy")),
    Category("open_lunch_box", _case((0.2, 0.15, 0.07), 0.004, ("sky", "mint", "pink", "yellow"),
                                     ("white",)),
             (0.2, 0.18, 0.14), 0.3, ("open lunchbox", "open food container"), ("kitchen",),
             ("container",), ("sky", "mint")),
    Category("empty_pencil_holder", pen_cup, (0.08, 0.08, 0.098), 0.12, ("empty pen holder",
             "empty pen cup"),
             ("office", "craft"), ("container", "round"), ("black", "white")),
    Category("open_jar", open_jar, (0.097, 0.097, 0.13), 0.3, ("jar without a lid",), ("kitchen",),
             ("container", "round"), ("clear",)),
    Category("open_steamer", steamer, (0.2, 0.2, 0.054), 0.25, ("open bamboo steamer",),
             ("kitchen",), ("container", "round", "big"), ("tan",)),
    Category("open_ice_bucket", ice_bucket, (0.2, 0.185, 0.185), 1.0, ("empty ice bucket",),
             ("kitchen", "dining"), ("container", "round", "big"), ("silver",)),
    Category("open_pot", pot, (0.263, 0.218, 0.1125), 0.9, ("open pot", "pot without a lid"),
             ("kitchen",), ("container", "round", "big"), ("silver",)),
    Category("open_can", tin_can, (0.079, 0.079, 0.1115), 0.06, ("empty can", "empty tin can",
             "open can"), ("kitchen",), ("container", "round"), ("silver",)),
    Category("utensil_crock", utensil_crock, (0.124, 0.124, 0.1625), 0.9, ("utensil holder",
             "utensil crock", "utensil jar", "utensil pot", "cutlery holder", "spoon holder",
             "kitchen utensil holder"), ("kitchen",), ("container", "round", "tall"),
             ("white", "cream")),
    Category("empty_vase", empty_vase, (0.107, 0.107, 0.165), 0.6, ("vase for flowers",),
             ("living",), ("container", "round", "tall"), ("white", "teal")),
)  # fmt: skip
