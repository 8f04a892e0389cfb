"""Loaves and savoury bakes: ciabatta, focaccia, bloomer, challah, sticks, crumpets, flat rounds."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of
from ...build.outlines import rectangle
from ...build.recipes import pad
from ...build.settled import rod, settle
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import skin

DARK: RGB = (150, 94, 46)


def crust(look: Look, dark: RGB = DARK, amount: float = 0.7) -> textures.Tile:
    """Return baked crust, or the colour asked for."""
    return skin(look, tint_color(look.color("amber", "copper", "tan"), 0.95), dark, amount)


def ciabatta(look: Look) -> Shape:
    """A flat, floury slipper of bread."""
    x, y = look.between(0.21, 0.26), look.between(0.09, 0.11)
    body = pad(x, y, look.between(0.045, 0.055), 0.04, soft=0.7)
    flour = skin(look, look.color("beige", "tan"), (240, 228, 204), 1.4)
    return shape([(body, flour)], [hull_of(body)])


def focaccia(look: Look) -> Shape:
    """A square of flat bread with dimples, rosemary and tomatoes."""
    x = look.between(0.17, 0.21)
    slab = pad(x, 0.8 * x, 0.032, 0.02, soft=0.5)
    dots, herbs, red = [], [], []
    for i in range(5):
        for j in range(4):
            at = ((i - 2) * 0.18 * x, (j - 1.5) * 0.19 * x)
            if (i + j) % 3 == 0:
                red.append(ellipsoid(0.019, 0.019, 0.012, 10, 6).move(*at, 0.033))
            else:
                dots.append(ellipsoid(0.014, 0.014, 0.003, 10, 4).move(*at, 0.0322))
            turn = look.between(0, 3)
            herbs.append(ellipsoid(0.018, 0.003, 0.003, 6, 4).turn(2, turn).move(
                at[0] + 0.015, at[1] + 0.01, 0.033))  # fmt: skip
    return shape([(slab, crust(look)), (join(dots), textures.plain((160, 104, 50))),
                  (join(herbs), textures.plain((70, 98, 56))),
                  (join(red), textures.plain((196, 50, 36)))], [hull_of(slab)])  # fmt: skip


def bloomer(look: Look) -> Shape:
    """A plump loaf with slanted cuts across its crust."""
    long, r = look.between(0.22, 0.27), look.between(0.052, 0.06)
    bread = rod(long, r, blunt=3.5, squash=0.8)
    cuts = [ellipsoid(0.09, 0.012, 0.012, 12, 6).turn(2, 0.9).move(x=u * long, z=0.78 * r)
            for u in (-0.27, -0.09, 0.09, 0.27)]  # fmt: skip
    pale = textures.speckles(look.rng, (236, 204, 146), 8)
    return settle([(bread, crust(look)), (join(cuts), pale)], 0.12)


def plait(look: Look) -> Shape:
    """A braided loaf with seeds."""
    long, r = look.between(0.24, 0.29), look.between(0.02, 0.023)
    t = np.linspace(0, 1, 50)
    thick = r * np.sqrt(np.maximum(1 - np.abs(2 * t - 1) ** 4, 0.08))
    strands = []
    for n in range(3):
        a = 5 * np.pi * t + 2 * np.pi * n / 3
        wide = 1.5 * thick
        strands.append(
            tube(
                np.column_stack(
                    [long * (t - 0.5), wide * np.sin(a), 0.55 * r * np.sin(2 * a) + 0.001 * n]
                ),
                thick,
                8,
            )
        )
    seeds = [ellipsoid(0.004, 0.0025, 0.002, 6, 4).turn(2, look.between(0, 3)).move(
             look.between(-0.4, 0.4) * long, look.between(-0.8, 0.8) * r, 1.22 * r)
             for _ in range(16)]  # fmt: skip
    glaze = skin(look, tint_color(look.color("copper", "bronze"), 1.05), (120, 64, 26), 0.8)
    return settle([(join(strands), glaze), (join(seeds), textures.plain((246, 232, 190)))], 0.1)


def breadstick(look: Look) -> Shape:
    """A thin crisp stick of bread."""
    long, r = look.between(0.19, 0.23), look.between(0.006, 0.0075)
    t = np.linspace(-0.5, 0.5, 30)
    path = np.column_stack([long * t, 0.0015 * np.sin(22 * t), 0 * t])
    radii = r * (1 + 0.07 * np.sin(40 * t)) * np.sqrt(np.maximum(1 - np.abs(2 * t) ** 12, 0.1))
    return settle([(tube(path, radii, 10), crust(look, amount=0.4))], 0.18)


def crumpet(look: Look) -> Shape:
    """A thick round, its top full of holes."""
    r, h = look.between(0.043, 0.05), look.between(0.02, 0.024)
    body = cylinder(r, h, 30, bevel=0.004)
    top = textures.spots(look.rng, look.color("tan", "amber"), (150, 92, 46), 0.25)
    face = cylinder(0.93 * r, 0.0012, 30).move(z=h - 0.0006)
    return shape([(body, skin(look, (236, 204, 150), (200, 140, 80), 0.7)), (face, top)],
                 [cylinder_part(r, h)])  # fmt: skip


def yorkshire(look: Look) -> Shape:
    """A risen, hollow, crisp batter cup."""
    r, h = look.between(0.04, 0.05), look.between(0.042, 0.052)
    cup = lathe(
        [
            (0, 0),
            (0.62 * r, 0),
            (0.72 * r, 0.3 * h),
            (0.95 * r, 0.62 * h),
            (r, 0.86 * h),
            (0.85 * r, h),
            (0.66 * r, 0.92 * h),
            (0.5 * r, 0.6 * h),
            (0, 0.46 * h),
        ],
        22,
    )
    a = look.between(0, 6)
    wavy = cup.bend(lambda p: p * np.column_stack([np.ones((len(p), 2)), 1 + 0.09 * np.sin(
        3 * np.arctan2(p[:, 1], p[:, 0]) + a)]))  # fmt: skip
    return settle([(wavy, skin(look, (226, 166, 84), (140, 80, 34), 1.1))], 0.02)


def twist(look: Look) -> Shape:
    """A long twist of puff pastry with cheese."""
    long, r = look.between(0.17, 0.2), look.between(0.008, 0.01)
    t = np.linspace(0, 1, 40)
    strands = [tube(np.column_stack([long * (t - 0.5), r * np.sin(7 * np.pi * t + s),
                                     0.7 * r * np.cos(7 * np.pi * t + s)]), r, 7, squash=0.7)
               for s in (0, np.pi)]  # fmt: skip
    gold = textures.spots(look.rng, (226, 170, 90), (170, 98, 40), 0.25)
    return settle([(join(strands), gold)], 0.15)


def poppadom(look: Look) -> Shape:
    """A thin, blistered, wavy disc."""
    r = look.between(0.075, 0.09)
    disc = lathe([(0, 0), (0.5 * r, 0), (r, 0.002), (r, 0.0036), (0.5 * r, 0.0026), (0, 0.0026)],
                 36)  # fmt: skip
    wavy = disc.bend(
        lambda p: (
            p
            + np.column_stack(
                [
                    0 * p[:, :2],
                    0.12
                    * (np.hypot(p[:, 0], p[:, 1]) / r) ** 2
                    * 0.05
                    * (1 + np.sin(4 * np.arctan2(p[:, 1], p[:, 0]))),
                ]
            )
        )
    )
    blister = [ellipsoid(d, d, 0.003, 8, 4).move(a, b, 0.0028) for a, b, d in (
        (look.between(-0.55, 0.55) * r, look.between(-0.55, 0.55) * r, look.between(0.008, 0.018))
        for _ in range(16))]  # fmt: skip
    tone = look.color("amber", "tan")
    return shape([(wavy, textures.spots(look.rng, tint_color(tone, 1.2), tint_color(tone, 0.8),
                                        0.12)),
                  (join(blister), textures.plain(tint_color(tone, 1.35)))],
                 [hull_of(wavy)])  # fmt: skip


def cracker(look: Look) -> Shape:
    """A thin cracker with docking holes, round or square."""
    r, h = look.between(0.027, 0.034), look.between(0.0048, 0.006)
    round_ = look.chance(0.5)
    body = cylinder(r, h, 30, bevel=0.001) if round_ else prism(
        rectangle(2 * r, 2 * r, 0.004), 0, h, 0.001)  # fmt: skip
    holes = [cylinder(0.0013, 0.0006, 6).move(0.4 * r * i, 0.4 * r * j, h - 0.0003)
             for i in (-1.6, -0.55, 0.55, 1.6) for j in (-1.6, -0.55, 0.55, 1.6)
             if not round_ or abs(i) + abs(j) < 3]  # fmt: skip
    gold = skin(look, tint_color(look.color("tan", "amber"), 1.1), (196, 136, 70), 0.7)
    part = cylinder_part(r, h) if round_ else hull_of(body)
    return shape([(body, gold), (join(holes), textures.plain((150, 100, 54)))], [part])


def panettone(look: Look) -> Shape:
    """A tall domed loaf in a paper case."""
    r, h = look.between(0.068, 0.08), look.between(0.12, 0.14)
    case = lathe([(0, 0), (0.93 * r, 0), (r, 0.6 * h), (0, 0.6 * h)], 32)
    dome = lathe([(0, 0.5 * h), (0.97 * r, 0.59 * h), (1.14 * r, 0.7 * h), (1.08 * r, 0.84 * h),
                  (0.7 * r, 0.97 * h), (0, h)], 30)  # fmt: skip
    bars: list[Solid] = [box(1.0 * r, 0.006, 0.004).turn(2, a).move(z=0.985 * h) for a in (0, 1.57)]
    brown = textures.speckles(look.rng, (96, 58, 38), 8)
    return shape([(case, textures.stripes([(120, 76, 46), (142, 94, 58)], 12, upright=True)),
                  (dome, skin(look, look.color("copper", "amber"), (130, 70, 30), 0.9)),
                  (join(bars), brown)], [hull_of(case), hull_of(dome)])  # fmt: skip


_B = ("breakfast", "dining")
_E = ("edible",)
CATEGORIES = (
    Category("ciabatta", ciabatta, (0.234, 0.1, 0.0513), 0.25, ("ciabatta bread", "ciabatta roll",
             "ciabatta loaf"), _B, _E, ("beige",), state="lying flat"),
    Category("focaccia", focaccia, (0.197, 0.158, 0.039), 0.35, ("focaccia bread",
             "slice of focaccia", "manakish", "garlic bread"), _B, ("edible", "flat"), ("amber",),
             state="lying flat"),
    Category("bloomer", bloomer, (0.244, 0.112, 0.0819), 0.5, ("bloomer loaf", "farmhouse loaf",
             "rye bread", "rye loaf"), _B, ("edible", "big"), ("amber",), state="lying flat"),
    Category("challah", plait, (0.279, 0.104, 0.0593), 0.45, ("challah bread", "plaited loaf",
             "braided bread", "braided loaf", "challah loaf", "zopf"), _B, ("edible", "big"),
             ("copper",), state="lying flat"),
    Category("breadstick", breadstick, (0.21, 0.0165, 0.0108), 0.008, ("grissini", "grissino",
             "bread stick"), _B, _E, ("amber",), state="lying flat"),
    Category("crumpet", crumpet, (0.0931, 0.0936, 0.0214), 0.055, ("english muffin", "pikelet",
             "buttered crumpet"), ("breakfast",), ("edible", "flat", "round"), ("amber",),
             state="lying flat"),
    Category("yorkshire_pudding", yorkshire, (0.0904, 0.0913, 0.0465), 0.04, ("popover",
             "yorkshire pud"), ("dining",), ("edible", "round"), ("amber",)),
    Category("cheese_twist", twist, (0.196, 0.0353, 0.0254), 0.03, ("cheese straw",
             "puff pastry twist", "twisted breadstick"), _B, _E, ("amber",), state="lying flat"),
    Category("poppadom", poppadom, (0.165, 0.165, 0.0155), 0.015, ("papadum", "papad", "poppadum",
             "papadam", "popadom"), ("dining",), ("edible", "flat", "round"), ("amber",),
             state="lying flat"),
    Category("cracker", cracker, (0.059, 0.0591, 0.00579), 0.006, ("cheese cracker",
             "water biscuit", "cream cracker", "oatcake", "saltine", "rice cracker", "rice cake",
             "crispbread"), ("dining",), ("edible", "flat"), ("tan",),
             state="lying flat"),
    Category("panettone", panettone, (0.169, 0.17, 0.133), 0.8, ("panettone cake", "pandoro"),
             ("dining",), ("edible", "round"), ("amber",)),
)  # fmt: skip
"""The module's categories."""
