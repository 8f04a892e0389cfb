"""Roots and the like: radishes, beetroots, ginger, sweet potatoes, courgettes, chillies."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.forms import blade, streaks
from ...build.settled import limb, rod, settle
from ...build.shape import Shape
from ...build.solids import Solid, cylinder, join, lathe
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import skin

GREEN: RGB = (92, 150, 62)


def _tuft(x: float, reach: float, wide: float, count: int, end: float) -> Solid:
    """Return leaves from ``x`` to the right, fanned out, their tips at height ``end``."""
    return join([
        blade([(x, 0, 0), (x + 0.45 * reach, wide * s, 0.06 * reach),
               (x + reach, 2.2 * wide * s, end)], 0.34 * reach / count + 0.016,
              thick=0.25, sides=5)
        for s in np.linspace(-1, 1, count)
    ])  # fmt: skip


def _root(look: Look, long: float, r: float, peel: textures.Tile, leaf: float) -> Shape:
    """Return a root lying, its thin tail to the left and leaves to the right."""
    body = limb([(-0.5 * long - 0.9 * r, 0, -0.2 * r), (-0.5 * long - 0.1 * r, 0, 0),
                 (-0.3 * long, 0, 0), (0.05 * long, 0, 0), (0.4 * long, 0, 0), (0.5 * long, 0, 0)],
                [0.03 * r, 0.14 * r, 0.78 * r, r, 0.72 * r, 0.2 * r], 20)  # fmt: skip
    top = _tuft(0.46 * long, leaf, 0.2 * leaf, 4, -0.8 * r)
    green = textures.leaf(look.rng, GREEN)
    return settle([(body, peel), (top, green)], 0.14, hulls=[[0], [1]])


def radish(look: Look) -> Shape:
    """A red radish with its leaves, lying."""
    d = look.between(0.027, 0.034)
    color = look.color("crimson", "red", "magenta", "white")
    peel = textures.stack((textures.plain((250, 244, 240)), 0.3), (textures.speckles(
        look.rng, color, 8), 0.7))  # fmt: skip
    return _root(look, 1.15 * d, d / 2, peel, look.between(0.07, 0.09))


def beetroot(look: Look) -> Shape:
    """A beetroot with cut red stalks, lying."""
    d = look.between(0.062, 0.075)
    color = look.color("maroon", "maroon", "crimson")
    peel = skin(look, tint_color(color, 0.75), (84, 30, 46), 0.6)
    return _root(look, 1.05 * d, d / 2, peel, look.between(0.08, 0.1))


def turnip(look: Look) -> Shape:
    """A turnip, purple towards its top, lying."""
    d = look.between(0.062, 0.078)
    color = look.color("purple", "violet", "magenta")
    peel = textures.gradient((246, 240, 226), color, look.rng)
    return _root(look, 0.95 * d, d / 2, peel, look.between(0.07, 0.09))


def parsnip(look: Look) -> Shape:
    """A pale parsnip lying, its tip to the left."""
    long, r = look.between(0.17, 0.22), look.between(0.02, 0.026)
    body = limb([(-0.5 * long, 0.003, -0.004), (-0.2 * long, 0, 0), (0.3 * long, 0, 0),
                 (0.46 * long, 0, 0), (0.5 * long, 0, 0)],
                [0.0016, 0.4 * r, 0.95 * r, 0.9 * r, 0.4 * r], 16)  # fmt: skip
    color = look.color("cream", "beige", "ivory")
    rings = textures.stripes([color, color, color, tint_color(color, 0.85)], 7)
    stub = cylinder(0.3 * r, 0.014, 12).turn(1, np.pi / 2).move(x=0.49 * long)
    return settle([(body, rings), (stub, textures.plain((150, 164, 90)))], 0.1)


def sweet_potato(look: Look) -> Shape:
    """A sweet potato lying, pointed at both ends."""
    long, r = look.between(0.13, 0.16), look.between(0.028, 0.034)
    color = look.color("terracotta", "copper", "maroon", "purple")
    bend = look.between(0.004, 0.014)
    body = limb([(-0.5 * long, bend, 0), (-0.34 * long, 0.4 * bend, 0), (-0.05 * long, -bend, 0),
                 (0.25 * long, 0, 0), (0.5 * long, bend, 0)],
                [0.0025, 0.6 * r, r, 0.8 * r, 0.003], 18)  # fmt: skip
    peel = textures.spots(look.rng, color, tint_color(color, 0.66), 0.06)
    return settle([(body, peel)], 0.12)


def zucchini(look: Look) -> Shape:
    """A courgette lying, its stub to the right."""
    long, r = look.between(0.17, 0.21), look.between(0.019, 0.023)
    color = look.color("green", "green", "olive", "yellow")
    body = rod(long, r, blunt=9, taper=-0.12, bend=0.006)
    stub = lathe([(0, 0), (0.62 * r, 0), (0.42 * r, 0.012), (0.5 * r, 0.026), (0, 0.026)], 8)
    stub = stub.turn(1, np.pi / 2).move(x=0.475 * long, y=0.003)
    dark = streaks(look.rng, tint_color(color, 0.62), tint_color(color, 0.95), 12)
    return settle([(body, dark), (stub, textures.plain((150, 164, 100)))], 0.1)


def ginger(look: Look) -> Shape:
    """A knobbly root of ginger lying."""
    k = look.between(0.9, 1.15)
    knobs = [rod(0.09, 0.015, bend=0.008, blunt=5)]
    for x, y, a, size in ((-0.028, 0.02, 1.9, 0.042), (0.012, 0.022, 1.2, 0.05),
                          (0.03, -0.018, -0.9, 0.04), (-0.012, -0.02, -1.8, 0.036),
                          (0.05, 0.008, 0.4, 0.04)):  # fmt: skip
        knobs.append(rod(size, 0.0115, blunt=4, sides=12).turn(2, a).move(x, y, 0.001))
    color = look.color("tan", "beige", "wooden")
    rings = textures.stripes([color, color, color, tint_color(color, 0.78)], 6)
    return settle([(join(knobs), rings)], 0.12).scale(k)


def chili(look: Look) -> Shape:
    """A chilli pepper lying, its green stalk to the right."""
    long, r = look.between(0.085, 0.125), look.between(0.0075, 0.011)
    bend = look.between(0.008, 0.02)
    color = look.color("red", "red", "green", "crimson", "yellow", "orange")
    body = limb([(-0.5 * long, bend, 0), (-0.2 * long, -0.2 * bend, 0),
                 (0.2 * long, -0.4 * bend, 0),
                 (0.44 * long, 0, 0), (0.48 * long, 0, 0)],
                [0.0008, 0.66 * r, 0.95 * r, r, 0.4 * r], 16)  # fmt: skip
    cap = limb(
        [
            (0.44 * long, 0, 0),
            (0.49 * long, 0, 0),
            (0.56 * long, 0.002, 0.002),
            (0.7 * long, 0.004, 0.006),
        ],
        [0.95 * r, 0.72 * r, 0.24 * r, 0.22 * r],
        10,
    )
    return settle([(body, skin(look, color, tint_color(color, 0.8), 0.5)),
                   (cap, textures.plain(GREEN))], 0.12)  # fmt: skip


_K = ("kitchen", "food")
CATEGORIES = (
    Category("zucchini", zucchini, (0.208, 0.0446, 0.0376), 0.2, ("courgette",),
             _K, ("edible",),
             ("green",), state="lying flat"),
    Category("radish", radish, (0.13, 0.0724, 0.0268), 0.02, (), _K, ("edible",), ("crimson",),
             state="lying flat"),
    Category("beetroot", beetroot, (0.185, 0.079, 0.0567), 0.16, ("beet",), _K, ("edible",),
             ("maroon",), state="lying flat"),
    Category("turnip", turnip, (0.174, 0.0721, 0.0599), 0.15, ("rutabaga", "swede"), _K,
             ("edible",), ("purple",), state="lying flat"),
    Category("parsnip", parsnip, (0.215, 0.0453, 0.0408), 0.12, (),
             _K, ("edible",), ("cream",), state="lying flat"),
    Category("sweet_potato", sweet_potato, (0.149, 0.0649, 0.055), 0.2, ("yam", "batata"),
             _K, ("edible",), ("terracotta",), state="lying flat"),
    Category("ginger", ginger, (0.12, 0.0878, 0.0269), 0.1, ("ginger root", "piece of ginger",
                 "root of ginger", "galangal", "galangal root", "root ginger",
                 "jerusalem artichoke", "sunchoke"),
             _K, ("edible",), ("tan",),
             state="lying flat"),
    Category("chili", chili, (0.127, 0.028, 0.0168), 0.015, ("chilli", "chili pepper",
                 "chilli pepper", "jalapeno", "hot pepper", "chile", "chile pepper",
                 "cayenne pepper", "jalapeno pepper", "habanero", "scotch bonnet",
                 "birds eye chilli"), _K, ("edible",), ("red", "green"), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
