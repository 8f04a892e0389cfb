"""Spoons and their like lying flat: wooden, slotted, tea, serving, scoops, paddles, brushes."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of, hull_part
from ...build.outlines import ellipse, rectangle
from ...build.settled import hull_above, limb, settle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, cylinder, join, lathe, loft, prism, sweep, torus
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..kitchen.cutlery import spoon

GRIPS = ("black", "red", "teal", "wooden", "white", "navy", "sage", "silver")


def _hollow(x: float, reach: float, wide: float, deep: float, wall: float) -> Solid:
    """Return a spoon's oval hollow lying at ``x``, its rim at the height ``deep``."""
    ring = ellipse(2, 2, 24) * [reach, wide]
    levels = [(0.25, 0), (0.7, 0.25 * deep), (0.94, 0.7 * deep), (1.0, deep),
              (0.9, deep), (0.82, 0.7 * deep + 0.3 * wall), (0.55, 0.25 * deep + wall),
              (0.15, wall)]  # fmt: skip
    rings = np.stack([np.column_stack([ring * k + [x, 0], np.full(24, z)]) for k, z in levels])
    return loft(rings, ring, profile=np.array([(k * reach, z) for k, z in levels]))


def _spoon(look: Look, long: float, reach: float, wide: float, deep: float,
           tile: textures.Tile, *, thick: float = 0.004, slots: bool = False) -> Shape:  # fmt: skip
    """Return a spoon lying on its bowl and the end of its handle, bowl to the left."""
    middle = -0.5 * long + reach
    head = _hollow(middle, reach, wide, deep, 0.3 * deep)
    grip = sweep(
        [(middle + 0.9 * reach, 0, deep - 0.4 * thick), (middle + 1.5 * reach, 0, deep + thick),
         (0.25 * long, 0, 0.55 * deep + 1.2 * thick), (0.5 * long, 0, 0.6 * thick)],
        rectangle(2.6 * thick, 1.2 * thick, 0.5 * thick, 3), [0.9, 0.8, 1.1, 1.2],
    )  # fmt: skip
    pieces = [(head, tile), (grip, tile)]
    if slots:
        dark = textures.plain((60, 58, 56))
        bars = [block(0.9 * reach, 0.1 * wide, 0.0012, 0.04 * wide).move(middle, s * 0.3 * wide,
                0.3 * deep + 0.0012 * abs(s)) for s in (-1, 0, 1)]  # fmt: skip
        pieces.append((join(bars), dark))
    v = np.maximum(grip.vertices, (-1, -1, 0))
    return shape(pieces, [hull_of(head), hull_part(v[v[:, 0] < 0.26 * long]),
                          hull_part(v[v[:, 0] > 0.24 * long])])  # fmt: skip


def wooden_spoon(look: Look) -> Shape:
    """A cooking spoon of wood."""
    wood = look.surface(look.color("wooden", "tan", "beige", "brown"), "wood")
    return _spoon(look, look.between(0.26, 0.32), look.between(0.032, 0.038), 0.026, 0.014, wood,
                  thick=0.0055)  # fmt: skip


def slotted_spoon(look: Look) -> Shape:
    """A kitchen spoon with slots in its bowl."""
    color = look.color("silver", "silver", "black", "red", "teal")
    tile = look.surface(color, "metal" if look.chance(0.6) else "plastic")
    return _spoon(look, look.between(0.28, 0.33), 0.046, 0.034, 0.014, tile, slots=True)


def serving_spoon(look: Look) -> Shape:
    """A large spoon for serving."""
    tile = look.surface(look.color("silver", "silver", "gold", "copper", "black"), "metal")
    return _spoon(look, look.between(0.22, 0.26), 0.036, 0.024, 0.012, tile, thick=0.0032)


def teaspoon(look: Look) -> Shape:
    """A small spoon: a table spoon at two thirds of its size."""
    return spoon(look).scale(0.7)


def soup_spoon(look: Look) -> Shape:
    """A spoon with a round bowl, or a flat-bottomed one of china."""
    if look.chance(0.6):
        tile = look.surface(look.color("silver", "silver", "gold"), "metal")
        return _spoon(look, look.between(0.165, 0.185), 0.024, 0.0225, 0.009, tile, thick=0.0026)
    tile = look.surface(look.color("white", "red", "black", "sky", "cream"), "ceramic")
    return _spoon(look, look.between(0.13, 0.145), 0.032, 0.022, 0.017, tile, thick=0.0052)


def rice_paddle(look: Look) -> Shape:
    """A flat round paddle for rice."""
    long = look.between(0.19, 0.22)
    tile = look.surface(look.color("white", "wooden", "cream", "red"), look.pick(
        ["wood", "plastic"]))  # fmt: skip
    head = prism(ellipse(0.42 * long, 0.34 * long, 28), 0, 0.006, 0.002).move(x=-0.29 * long)
    grip = sweep([(-0.12 * long, 0, 0.0035), (0.1 * long, 0, 0.0045), (0.5 * long, 0, 0.005)],
                 rectangle(0.024, 0.009, 0.004, 3), [1.3, 0.85, 1.0])  # fmt: skip
    return shape([(head, tile), (grip, tile)], [hull_of(head), hull_above(grip)])


def salad_servers(look: Look) -> Shape:
    """A salad spoon and fork lying side by side."""
    long = look.between(0.25, 0.29)
    tile = look.surface(look.color("wooden", "brown", "black", "silver", "white"), look.pick(
        ["wood", "plastic"]))  # fmt: skip
    first = _spoon(look, long, 0.04, 0.027, 0.013, tile, thick=0.0045)
    solids = [p.solid.move(y=-0.036) for p in first.pieces]
    tines = [limb([(-0.5 * long, 0.036 + 0.0155 * s, 0.009), (-0.47 * long, 0.036 + 0.0165 * s,
             0.004), (-0.4 * long, 0.036 + 0.015 * s, 0.003)], [0.0035, 0.005, 0.005], 8, 0.8)
             for s in (-1.2, -0.4, 0.4, 1.2)]  # fmt: skip
    palm = prism(ellipse(0.085, 0.053, 22), 0.0005, 0.0075, 0.002).move(-0.33 * long, 0.036)
    grip = first.pieces[1].solid.move(y=0.036)
    low = grip.move(z=-0.004).bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)]))
    forks = join([*tines, palm, low])
    parts = [hull_of(solids[0]), hull_above(solids[1]), hull_above(palm, *tines), hull_above(low)]
    return shape([(join(solids), tile), (forks, tile)], parts)


def honey_dipper(look: Look) -> Shape:
    """A grooved wooden dipper lying."""
    long, r = look.between(0.14, 0.165), look.between(0.013, 0.016)
    wood = look.surface(look.color("wooden", "tan", "brown"), "wood")
    head = []
    for k in range(6):
        u = (k + 0.5) / 6
        wide = r * np.sqrt(1 - (2 * u - 1) ** 2 * 0.72)
        head.append(cylinder(wide, 0.0046, 20, bevel=0.001).turn(1, np.pi / 2).move(
            -0.5 * long + 0.0062 * k))  # fmt: skip
    core = cylinder(0.5 * r, 0.038, 14).turn(1, np.pi / 2).move(x=-0.5 * long)
    stick = limb([(-0.5 * long + 0.03, 0, 0), (0.2 * long, 0, -0.2 * r),
                  (0.48 * long, 0, -0.62 * r), (0.5 * long, 0, -0.65 * r)],
                 [0.0036, 0.0036, 0.0046, 0.003], 10)  # fmt: skip
    return settle([(join([*head, core]), wood), (stick, wood)], 0.1)


def ice_cream_scoop(look: Look) -> Shape:
    """A round scoop with a thick handle, lying."""
    long, r = look.between(0.18, 0.21), look.between(0.024, 0.028)
    color = look.color(*GRIPS)
    t = np.linspace(0.1, np.pi / 2, 7)
    outer = [(r * np.sin(a), r * (1 - np.cos(a))) for a in t]
    inner = [(max(x - 0.002, 0.001), z + 0.002 * (1 - i / 6)) for i, (x, z) in enumerate(outer)]
    cup = lathe([(0, 0), *outer, *inner[::-1], (0, 0.002)], 26).move(x=-0.5 * long + r)
    steel = textures.brushed_metal(look.rng, (196, 199, 204))
    neck = limb([(-0.5 * long + 1.95 * r, 0, 0.8 * r), (-0.1 * long, 0, 0.62 * r),
                 (0.02 * long, 0, 0.5 * r)], [0.005, 0.0052, 0.006], 10)  # fmt: skip
    grip = limb([(-0.02 * long, 0, 0.5 * r), (0.2 * long, 0, 0.42 * r), (0.45 * long, 0, 0.38 * r),
                 (0.5 * long, 0, 0.36 * r)], [0.0085, 0.0115, 0.0115, 0.006], 14)  # fmt: skip
    return shape([(join([cup, neck]), steel), (grip, look.surface(color, "plastic"))],
                 [hull_of(cup), hull_above(grip), hull_of(neck)])  # fmt: skip


def scoop(look: Look) -> Shape:
    """A flour or ice scoop: an open half-round shovel with a handle."""
    long, r = look.between(0.2, 0.24), look.between(0.032, 0.038)
    steel = look.surface(look.color("silver", "silver", "copper", "white", "red"), "metal")
    a = np.linspace(np.pi, 2 * np.pi, 13)
    arc = np.column_stack([r * np.cos(a), r + r * np.sin(a)])
    ring = np.concatenate([arc, 0.93 * (arc - [0, r])[::-1] + [0, r]])
    levels = [(-0.5 * long, 0.82, 1.0), (-0.2 * long, 1.0, 1.0), (0.02 * long, 1.0, 1.0)]
    body = loft(np.stack([np.column_stack([np.full(len(ring), x), ring[:, 0] * k, ring[:, 1] * k2])
                          for x, k, k2 in levels]), ring)  # fmt: skip
    back = prism(np.array([*arc]), 0, 0.003).turn(0, np.pi / 2).turn(2, np.pi / 2)
    back = back.move(x=0.02 * long - float(back.bounds[0, 0]) - 0.002)
    grip = limb([(0.02 * long, 0, 0.8 * r), (0.12 * long, 0, 0.75 * r), (0.45 * long, 0, 0.0105),
                 (0.5 * long, 0, 0.0075)], [0.006, 0.0075, 0.0095, 0.006], 12)  # fmt: skip
    body = body.move(z=-0.0035)
    parts = [
        hull_part(
            np.maximum(body.vertices, (-1, -1, 0))[
                np.abs(np.arctan2(body.vertices[:, 1], r - body.vertices[:, 2]) - w) < 0.45
            ]
        )
        for w in (-1.2, -0.6, 0.0, 0.6, 1.2)
    ]
    return shape([(body, steel), (back, steel), (grip, steel)], [*parts, hull_of(back),
                                                                  hull_of(grip)])  # fmt: skip


def pastry_brush(look: Look) -> Shape:
    """A flat brush with bristles or silicone strands, lying."""
    long, wide = look.between(0.19, 0.23), look.between(0.032, 0.042)
    color = look.color("wooden", "red", "black", "teal", "wooden")
    handle = look.surface(color, "wood")
    hair = look.own_color("cream", "red", "white", "tan")
    grip = sweep(
        [
            (-0.14 * long, 0, 0.006),
            (0.02 * long, 0, 0.006),
            (0.2 * long, 0, 0.006),
            (0.5 * long, 0, 0.006),
        ],
        rectangle(0.02, 0.011, 0.004, 3),
        [1.5, 0.9, 1.1, 0.8],
    )
    band = block(0.03, wide, 0.012, 0.003).move(x=-0.17 * long)
    strands = [sweep([(-0.2 * long, y, 0.006), (-0.5 * long, 1.15 * y, 0.0055)],
                     rectangle(wide / 11, 0.009, 0.001, 1), [1, 0.8])
               for y in np.linspace(-0.44, 0.44, 9) * wide]  # fmt: skip
    steel = textures.brushed_metal(look.rng, (192, 195, 200))
    return settle([(grip, handle), (band, steel), (join(strands), textures.plain(hair))], 0.04,
                  hulls=[[0], [1], [2]])  # fmt: skip


def measuring_spoon(look: Look) -> Shape:
    """Measuring spoons fanned out on a ring."""
    color = look.color("silver", "silver", "copper", "red", "teal", "white")
    tile = look.surface(color, "metal" if look.chance(0.6) else "plastic")
    solids, parts = [], []
    for k, (r, a) in enumerate(((0.021, 0.62), (0.018, 0.2), (0.0145, -0.2), (0.011, -0.6))):
        cup = _hollow(0, r, r, 0.75 * r, 0.0016).move(x=-0.105)
        arm = sweep(
            [
                (-0.105 + 0.9 * r, 0, 0.75 * r - 0.001),
                (-0.05, 0, 0.004 + 0.0014 * k),
                (0.006, 0, 0.001 + 0.0016 * k),
            ],
            rectangle(0.011, 0.0016, 0.0006, 1),
        )
        cup, arm = cup.turn(2, a), arm.turn(2, a)
        solids += [cup, arm]
        parts += [hull_of(cup), hull_above(arm)]
    ring = torus(0.011, 0.0012, 20, 6).turn(0, 0.25).move(x=0.004, z=0.0042)
    scale = look.between(0.92, 1.08)
    made = shape([(join(solids), tile), (ring, textures.plain(tint_color((190, 192, 196), 0.9)))],
                 parts)  # fmt: skip
    return made.scale(scale)


_K = ("kitchen",)
CATEGORIES = (
    Category("wooden_spoon", wooden_spoon, (0.296, 0.052, 0.0221), 0.05, ("cooking spoon",
             "mixing spoon", "stirring spoon"), _K, (), ("wooden",), state="lying flat"),
    Category("slotted_spoon", slotted_spoon, (0.304, 0.068, 0.0199), 0.11, ("skimmer",
             "slotted ladle", "straining spoon", "skimming spoon"), _K, (), ("silver",),
             state="lying flat"),
    Category("serving_spoon", serving_spoon, (0.251, 0.048, 0.0167), 0.09, ("tablespoon",
             "salad spoon"), ("dining",), ("flat",), ("silver",), state="lying flat"),
    Category("teaspoon", teaspoon, (0.122, 0.0282, 0.00768), 0.022, ("coffee spoon",
             "dessert spoon", "espresso spoon", "tea spoon", "sugar spoon"), ("dining", "coffee"),
             ("flat",), ("silver",), state="lying flat"),
    Category("soup_spoon", soup_spoon, (0.161, 0.0446, 0.0173), 0.045, ("ramen spoon",
             "chinese spoon", "asian soup spoon"), ("dining",), ("flat",), ("silver", "white"),
             state="lying flat"),
    Category("rice_paddle", rice_paddle, (0.205, 0.0696, 0.0095), 0.04, ("rice spoon", "rice scoop",
             "shamoji"), _K, ("flat",), ("white", "wooden"), state="lying flat"),
    Category("salad_servers", salad_servers, (0.274, 0.125, 0.0197), 0.12, ("salad server",
             "salad tongs", "salad fork and spoon"), ("dining",), (), ("wooden",),
             state="lying flat"),
    Category("honey_dipper", honey_dipper, (0.15, 0.0287, 0.0258), 0.02, ("honey stick",
             "honey spoon", "honey wand"), _K, (), ("wooden",), state="lying flat"),
    Category("ice_cream_scoop", ice_cream_scoop, (0.202, 0.0528, 0.0264), 0.14,
             ("ice cream spoon",), _K, (), ("silver", "red"), state="lying flat"),
    Category("scoop", scoop, (0.224, 0.0682, 0.0342), 0.13, ("flour scoop", "ice scoop",
             "sugar scoop", "coffee scoop"), _K, (), ("silver",), state="lying flat"),
    Category("pastry_brush", pastry_brush, (0.217, 0.0401, 0.0158), 0.05, ("basting brush",
             "baking brush", "kitchen brush"), _K, ("flat",), ("wooden",), state="lying flat"),
    Category("measuring_spoon", measuring_spoon, (0.136, 0.151, 0.0156), 0.06, ("measuring spoons",
             "set of measuring spoons"), _K, (), ("silver",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
