"""Objects of the ``breakfast`` theme: breads."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import skin
from ...kit.outlines import smooth
from ...kit.parts import cylinder_part, hull_of
from ...kit.primitives import bent_rod, pad, scatter
from ...kit.shapes import Shape, category, settle, shape
from ...kit.solids import cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...kit.surfaces import RGB, Look, tint_color

DARK: RGB = (150, 94, 46)


def crust(look: Look, dark: RGB = DARK, amount: float = 0.7) -> surfaces.Tile:
    """Return a tile of crust in the requested colour, or else in a baked shade."""
    return skin(look, tint_color(look.color("amber", "copper", "tan"), 0.95), dark, amount)


@category("ciabatta", size=(0.234, 0.1, 0.0513), mass=0.25, material="food",
          aliases=("ciabatta bread", "ciabatta roll", "ciabatta loaf"),
          themes=("breakfast", "dining"), roles=("edible",), colors=("beige",),
          state="lying flat")  # fmt: skip
def ciabatta(look: Look) -> Shape:
    """A flat, floury ciabatta loaf."""
    x, y = look.between(0.21, 0.26), look.between(0.09, 0.11)
    body = pad(x, y, look.between(0.045, 0.055), 0.04, soft=0.7)
    flour = skin(look, look.color("beige", "tan"), (240, 228, 204), 1.4)
    return shape([(body, flour)], [hull_of(body)])


@category("focaccia", size=(0.197, 0.158, 0.039), mass=0.35, material="food",
          aliases=("focaccia bread", "slice of focaccia", "manakish", "garlic bread"),
          themes=("breakfast", "dining"), roles=("edible", "flat"), colors=("amber",),
          state="lying flat")  # fmt: skip
def focaccia(look: Look) -> Shape:
    """A square of focaccia with dimples, rosemary and tomatoes."""
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
    return shape([(slab, crust(look)), (join(dots), surfaces.plain((160, 104, 50))),
                  (join(herbs), surfaces.plain((70, 98, 56))),
                  (join(red), surfaces.plain((196, 50, 36)))], [hull_of(slab)])  # fmt: skip


@category("bloomer", size=(0.244, 0.112, 0.0819), mass=0.5, material="food",
          aliases=("bloomer loaf", "farmhouse loaf", "rye bread", "rye loaf"),
          themes=("breakfast", "dining"), roles=("edible", "big"), colors=("amber",),
          state="lying flat")  # fmt: skip
def bloomer(look: Look) -> Shape:
    """A plump bloomer loaf with slanted cuts across its crust."""
    long, r = look.between(0.22, 0.27), look.between(0.052, 0.06)
    bread = bent_rod(long, r, blunt=3.5, squash=0.8)
    cuts = [ellipsoid(0.09, 0.012, 0.012, 12, 6).turn(2, 0.9).move(x=u * long, z=0.78 * r)
            for u in (-0.27, -0.09, 0.09, 0.27)]  # fmt: skip
    pale = surfaces.speckles(look.rng, (236, 204, 146), 8)
    return settle([(bread, crust(look)), (join(cuts), pale)], 0.12)


@category("challah", size=(0.279, 0.104, 0.0593), mass=0.45, material="food",
          aliases=("challah bread", "plaited loaf", "braided bread", "braided loaf", "challah loaf",
          "zopf"), themes=("breakfast", "dining"), roles=("edible", "big"), colors=("copper",),
          state="lying flat")  # fmt: skip
def challah(look: Look) -> Shape:
    """A braided challah loaf with seeds."""
    long, r = look.between(0.24, 0.29), look.between(0.02, 0.023)
    t = np.linspace(0, 1, 50)
    thick = r * np.sqrt(np.maximum(1 - np.abs(2 * t - 1) ** 4, 0.08))
    strands = []
    for n in range(3):
        a = 5 * np.pi * t + 2 * np.pi * n / 3
        wide = 1.5 * thick
        strands.append(tube(np.column_stack([long * (t - 0.5), wide * np.sin(a), 0.55 * r
                                             * np.sin(2 * a) + 0.001 * n]), thick, 8))  # fmt: skip
    seeds = [ellipsoid(0.004, 0.0025, 0.002, 6, 4).turn(2, look.between(0, 3)).move(
             look.between(-0.4, 0.4) * long, look.between(-0.8, 0.8) * r, 1.22 * r)
             for _ in range(16)]  # fmt: skip
    glaze = skin(look, tint_color(look.color("copper", "bronze"), 1.05), (120, 64, 26), 0.8)
    return settle([(join(strands), glaze), (join(seeds), surfaces.plain((246, 232, 190)))], 0.1)


@category("breadstick", size=(0.21, 0.0165, 0.0108), mass=0.008, material="food",
          aliases=("grissini", "grissino", "bread stick"), themes=("breakfast", "dining"),
          roles=("edible",), colors=("amber",), state="lying flat")  # fmt: skip
def breadstick(look: Look) -> Shape:
    """A thin, crisp breadstick."""
    long, r = look.between(0.19, 0.23), look.between(0.006, 0.0075)
    t = np.linspace(-0.5, 0.5, 30)
    path = np.column_stack([long * t, 0.0015 * np.sin(22 * t), 0 * t])
    radii = r * (1 + 0.07 * np.sin(40 * t)) * np.sqrt(np.maximum(1 - np.abs(2 * t) ** 12, 0.1))
    return settle([(tube(path, radii, 10), crust(look, amount=0.4))], 0.18)


@category("crumpet", size=(0.0931, 0.0936, 0.0214), mass=0.055, material="food",
          aliases=("english muffin", "pikelet", "buttered crumpet"), themes=("breakfast",),
          roles=("edible", "flat", "round"), colors=("amber",), state="lying flat")  # fmt: skip
def crumpet(look: Look) -> Shape:
    """A thick, round crumpet with a top full of holes."""
    r, h = look.between(0.043, 0.05), look.between(0.02, 0.024)
    body = cylinder(r, h, 30, bevel=0.004)
    top = surfaces.spots(look.rng, look.color("tan", "amber"), (150, 92, 46), 0.25)
    face = cylinder(0.93 * r, 0.0012, 30).move(z=h - 0.0006)
    return shape([(body, skin(look, (236, 204, 150), (200, 140, 80), 0.7)), (face, top)],
                 [cylinder_part(r, h)])  # fmt: skip


@category("cheese_twist", size=(0.196, 0.0353, 0.0254), mass=0.03, material="food",
          aliases=("cheese straw", "puff pastry twist", "twisted breadstick"),
          themes=("breakfast", "dining"), roles=("edible",), colors=("amber",),
          state="lying flat")  # fmt: skip
def cheese_twist(look: Look) -> Shape:
    """A long twist of puff pastry with cheese."""
    long, r = look.between(0.17, 0.2), look.between(0.008, 0.01)
    t = np.linspace(0, 1, 40)
    strands = [tube(np.column_stack([long * (t - 0.5), r * np.sin(7 * np.pi * t + s),
                                     0.7 * r * np.cos(7 * np.pi * t + s)]), r, 7, squash=0.7)
               for s in (0, np.pi)]  # fmt: skip
    gold = surfaces.spots(look.rng, (226, 170, 90), (170, 98, 40), 0.25)
    return settle([(join(strands), gold)], 0.15)


BREAD_ROLL_DARK: RGB = (150, 94, 46)


def _crust(look: Look) -> surfaces.Tile:
    color = look.color("amber", "copper", "tan")
    return skin(look, tint_color(color, 0.95), BREAD_ROLL_DARK, 0.7)


@category("toast", size=(0.116, 0.116, 0.0144), mass=0.03, material="food",
          aliases=("slice of bread", "bread slice", "slice of toast", "piece of toast",
          "piece of bread", "toasted bread", "toast slice"), themes=("breakfast", "kitchen"),
          roles=("edible", "flat", "support"), colors=("tan",), state="lying flat")  # fmt: skip
def toast(look: Look) -> Shape:
    """A slice of toast lying flat, with a crust darker than its crumb."""
    side = [(-0.9, -1), (0.9, -1), (0.94, 0.3), (1.06, 0.55), (0.95, 0.92), (0.5, 1.04),
            (0, 0.97)]  # fmt: skip
    half = np.array(side + [(-x, y) for x, y in side[2:6][::-1]], float)
    ring = smooth(np.concatenate([half, half[:1]]), 3)[:-1]
    w, t = look.between(0.05, 0.058), look.between(0.012, 0.016)
    color = look.color("tan", "amber", "tan", "beige")
    face = surfaces.spots(look.rng, tint_color(color, 1.15), tint_color(color, 0.72), 0.35)
    edge = prism(w * ring, 0, t)
    crumb = prism(0.9 * w * ring, 0.0008, t + 0.0008)
    return shape([(edge, surfaces.speckles(look.rng, (140, 84, 42), 8)), (crumb, face)],
                 [hull_of(edge), hull_of(crumb)])  # fmt: skip


@category("bread_roll", size=(0.0903, 0.091, 0.0528), mass=0.06, material="food",
          aliases=("bun", "dinner roll", "burger bun", "bread bun"), themes=("breakfast", "dining"),
          roles=("edible", "round"), colors=("amber",))  # fmt: skip
def bread_roll(look: Look) -> Shape:
    """A round bread roll with a cut across its top."""
    r, h = look.between(0.04, 0.05), look.between(0.045, 0.058)
    dome = lathe([(0, 0), (0.8 * r, 0), (r, 0.28 * h), (0.9 * r, 0.62 * h), (0.5 * r, 0.94 * h),
                  (0, h)], 26)  # fmt: skip
    pieces = [(dome, _crust(look))]
    if look.chance(0.5):
        cut = ellipsoid(1.2 * r, 0.011, 0.01, 12, 6).move(z=0.96 * h)
        pieces.append((cut, surfaces.speckles(look.rng, (240, 212, 160), 6)))
    else:
        pieces.append((scatter(look, 0.7 * r, 26, (0.0035, 0.0045), 0.8 * h, dome=0.2 * h,
                               stretch=(1, 0.7, 0.5)),
                       surfaces.plain((246, 232, 190))))  # fmt: skip
    return shape(pieces, [hull_of(dome)])


@category("bagel", size=(0.106, 0.106, 0.0301), mass=0.1, material="food",
          aliases=("sesame bagel", "poppy seed bagel", "simit"), themes=("breakfast",),
          roles=("edible", "round", "flat"), colors=("amber",), state="lying flat")  # fmt: skip
def bagel(look: Look) -> Shape:
    """A ring-shaped bagel with seeds on top."""
    r, t = look.between(0.031, 0.036), look.between(0.018, 0.021)
    ring = torus(r, t, 30, 12).scale(1, 1, 0.85)
    color = look.pick([(246, 232, 190), (50, 46, 48)])
    seeds = []
    for k in range(34):
        a, b = 2.4 * k, look.between(-0.9, 0.9)
        at = (r + t * np.sin(b)) * np.array([np.cos(a), np.sin(a)])
        seeds.append(ellipsoid(0.0045, 0.003, 0.002, 6, 4).turn(2, a).move(
            at[0], at[1], 0.85 * t * np.cos(b)))  # fmt: skip
    return settle([(ring, _crust(look)), (join(seeds), surfaces.plain(color))], 0.1)
