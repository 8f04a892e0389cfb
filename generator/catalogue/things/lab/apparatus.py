"""Stands, burners, balances and models of a laboratory."""

from __future__ import annotations

import numpy as np

from ....scene import ConvexPart
from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, resting_ball
from ...build.forms import above, lay_down
from ...build.shape import Shape, shape
from ...build.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    prism,
    tube,
)
from ...build.variants import in_sizes
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from .glass import GLASS, LIQUIDS, marks

STEEL: RGB = (186, 189, 194)


def bunsen_burner(look: Look) -> Shape:
    """A Bunsen burner: foot, barrel with an air ring, gas inlet, some alight."""
    k = look.between(0.9, 1.08)
    color = look.color("charcoal", "green", "black", "blue", "gray")
    foot = lathe(np.array([(0, 0), (0.04, 0), (0.041, 0.004), (0.036, 0.012), (0.014, 0.022),
                           (0, 0.024)]) * k, 30)  # fmt: skip
    barrel = lathe(np.array([(0, 0.02), (0.008, 0.02), (0.008, 0.13), (0.0092, 0.132),
                             (0.0092, 0.14), (0.0065, 0.14), (0.0065, 0.136), (0, 0.136)]) * k,
                                 22)  # fmt: skip
    collar = cylinder(0.0108 * k, 0.02 * k, 22).move(z=0.032 * k)
    inlet = lay_down(cylinder(0.0048 * k, 0.05 * k, 14), 0.005 * k, 0.03 * k)
    knob = lay_down(cylinder(0.009 * k, 0.008 * k, 12), -0.03 * k, 0.03 * k)
    spots = [box(0.006 * k, 0.001, 0.009 * k).move(y=-0.0106 * k, z=0.037 * k)]
    brass = textures.brushed_metal(look.rng, (204, 170, 96))
    steel = textures.brushed_metal(look.rng, STEEL)
    pieces = [(foot, look.surface(color, "metal")), (barrel, steel),
              (join([collar, inlet, knob]), brass), (join(spots),
                  textures.plain((30, 30, 32)))]  # fmt: skip
    if look.chance(0.4):
        flame = lathe(np.array([(0, 0.134), (0.005, 0.138), (0.0085, 0.15), (0.006, 0.172),
                                (0.001, 0.19), (0, 0.192)]) * k, 16)  # fmt: skip
        pieces.append((flame, textures.gradient((70, 120, 240), (150, 200, 250), look.rng)))
    return shape(pieces, [cylinder_part(0.04 * k, 0.011 * k), hull_of(foot),
                          cylinder_part(0.0092 * k, 0.12 * k, (0, 0, 0.02 * k)),
                          hull_of(collar), hull_of(inlet)])  # fmt: skip


def lab_tripod(look: Look) -> Shape:
    """A tripod with a gauze mat on it, to heat things over."""
    k = look.between(0.9, 1.06)
    color = look.color("charcoal", "black", "gray", "silver")
    r, h = 0.062 * k, 0.13 * k
    ring = lathe([(0.82 * r, h - 0.006), (r, h - 0.006), (r, h), (0.82 * r, h)], 34, loop=True)
    legs = [tube([(1.22 * r * np.cos(a), 1.22 * r * np.sin(a), 0.0),
                  (0.9 * r * np.cos(a), 0.9 * r * np.sin(a), h - 0.003)], 0.0042 * k, 8)
            for a in np.pi / 2 + np.arange(3) * 2 * np.pi / 3]  # fmt: skip
    net = textures.fit(textures.grid((120, 122, 126), (186, 188, 192), 16, 16, 96), 96, 96).copy()
    prints.disc(net, 0.5, 0.5, 0.34, (232, 230, 224))
    mat = box(1.9 * r, 1.9 * r, 0.002).move(z=h)
    return shape([(join([ring, *legs]), look.surface(color, "metal")), (mat, net)],
                 [*(hull_of(s.bend(above)) for s in legs),
                     cylinder_part(r, 0.006, (0, 0, h - 0.006)),
                  hull_of(mat)])  # fmt: skip


def retort_stand(look: Look) -> Shape:
    """A stand with a rod and a clamp that holds a burette."""
    k = look.between(0.8, 0.95)
    color = look.color("gray", "green", "charcoal", "blue", "white")
    base = box(0.13 * k, 0.2 * k, 0.016 * k)
    rod = cylinder(0.0055 * k, 0.4 * k, 14).move(y=0.07 * k, z=0.014 * k)
    boss = block(0.022 * k, 0.03 * k, 0.03 * k, 0.004).move(y=0.07 * k, z=0.27 * k)
    arm = tube(np.array([(0, 0.07, 0.285), (0, -0.01, 0.285)]) * k, 0.0045 * k, 8)
    ring = lathe([(0.009 * k, 0), (0.014 * k, 0), (0.014 * k, 0.016 * k), (0.009 * k, 0.016 * k)],
        20,
                 loop=True).move(y=-0.022 * k, z=0.277 * k)  # fmt: skip
    glass = lathe(np.array([(0, 0.07), (0.0015, 0.07), (0.002, 0.09), (0.0085, 0.105),
                            (0.0085, 0.4), (0.0105, 0.404), (0, 0.404)]) * k, 20)  # fmt: skip
    glass = glass.move(y=-0.022 * k)
    tap = lay_down(cylinder(0.003 * k, 0.03 * k, 10), -0.015 * k, 0.096 * k).move(y=-0.022 * k)
    liquid = look.own_color(*LIQUIDS)
    fill = textures.stack((textures.plain(tint_color(liquid, 1.1)), 0.6), (marks(GLASS), 0.4))
    steel = textures.brushed_metal(look.rng, STEEL)
    return shape([(base, look.surface(color, "metal")), (join([rod, arm]), steel),
                  (join([boss, ring]), textures.plain((70, 72, 76))), (glass, fill),
                  (tap, textures.plain((206, 52, 46)))],
                 [hull_of(base), hull_of(rod), hull_of(boss, arm), hull_of(ring),
                     hull_of(glass)])  # fmt: skip


def balance_scale(look: Look) -> Shape:
    """A beam balance with two hanging pans."""
    k = look.between(0.88, 1.06)
    metal = look.surface(look.color("brass", "gold", "silver", "copper", "black"), "metal")
    base = lathe(np.array([(0, 0), (0.06, 0), (0.062, 0.006), (0.05, 0.016), (0.012, 0.024),
                           (0, 0.024)]) * k, 30)  # fmt: skip
    post = lathe(np.array([(0, 0.02), (0.008, 0.02), (0.005, 0.06), (0.0065, 0.12), (0.005, 0.2),
                           (0.009, 0.215), (0.004, 0.228), (0, 0.232)]) * k, 18)  # fmt: skip
    tilt = look.between(-0.1, 0.1)
    beam = box(0.2 * k, 0.007 * k, 0.009 * k).turn(1, tilt).move(z=0.205 * k)
    pieces: list[Solid] = [base, post, beam]
    parts = [cylinder_part(0.06 * k, 0.008 * k), hull_of(base), hull_of(post), hull_of(beam)]
    for s in (-1, 1):
        x, top = s * 0.098 * k, (0.208 - s * 0.098 * np.tan(tilt)) * k
        bottom = top - 0.1 * k
        dish = lathe([(0, 0), (0.02 * k, 0.001), (0.04 * k, 0.01 * k), (0.041 * k, 0.012 * k),
                      (0.038 * k, 0.0115 * k), (0.02 * k, 0.003), (0, 0.002)], 26)  # fmt: skip
        pieces.append(dish.move(x=x, z=bottom))
        for a in np.arange(3) * 2 * np.pi / 3 + np.pi / 2:
            foot = (x + 0.039 * k * np.cos(a), 0.039 * k * np.sin(a), bottom + 0.011 * k)
            pieces.append(tube([foot, (x, 0, top)], 0.0009 * k, 5))
        parts += [cylinder_part(0.04 * k, 0.011 * k, (x, 0, bottom)),
                  box_part(0.012 * k, 0.012 * k, 0.088 * k,
                      (x, 0, bottom + 0.011 * k))]  # fmt: skip
    return shape([(join(pieces), metal)], parts)


def molecule_model(look: Look) -> Shape:
    """A ball-and-stick model of a small molecule."""
    k = look.between(0.9, 1.1)
    color = look.color("black", "red", "blue", "black")
    ways = np.array([(0.94, 0, -0.33), (-0.47, 0.82, -0.33), (-0.47, -0.82, -0.33), (0, 0, 1.0)])
    long, big, small = 0.046 * k, 0.034 * k, 0.025 * k
    center = np.array([0, 0, 0.33 * long + small / 2])
    balls = [ellipsoid(big, big, big, 20, 12).move(*center)]
    outer = [ellipsoid(small, small, small, 16, 10).move(*(center + long * w)) for w in ways]
    rods = [tube([center, center + long * w], 0.0032 * k, 8) for w in ways]
    tone = look.own_color("white", "white", "red", "green", "yellow")
    feet = [resting_ball(small, small, small) for _ in range(3)]
    feet = [
        ConvexPart(np.add(p.vertices, (*(long * w)[:2], 0.0)))
        for p, w in zip(feet, ways, strict=False)
    ]
    return shape([(join(balls), textures.speckles(look.rng, color, 3, 32)),
                  (join(outer), textures.speckles(look.rng, tone, 3, 32)),
                  (join(rods), textures.plain((170, 172, 176)))],
                 [*feet, hull_of(balls[0]), hull_of(outer[3]),
                     *(hull_of(r) for r in rods)])  # fmt: skip


def glass_prism(look: Look) -> Shape:
    """A triangular glass prism lying, rainbow light in it."""
    k = look.between(0.88, 1.15)
    color = look.color("clear", "clear", "sky")
    long, side = 0.08 * k, 0.034 * k
    outline = np.array([(-side / 2, 0), (side / 2, 0), (0, 0.866 * side)])
    body = prism(outline, -long / 2, long / 2, 0.0008).turn(0, np.pi / 2).turn(2, np.pi / 2)
    tones = [(230, 60, 60), (240, 150, 50), (240, 220, 80), (90, 190, 100), (80, 130, 220),
             (150, 90, 200)]  # fmt: skip
    rainbow = textures.stripes([color, *(tint_color(t, 1.3) for t in tones)],
                               1, upright=True)  # fmt: skip
    return shape([(body, rainbow)], [hull_of(body)], opacity=0.78)


def newtons_cradle(look: Look) -> Shape:
    """Five steel balls hanging in a row from a frame."""
    k = look.between(0.85, 1.05)
    color = look.color("silver", "black", "gold", "charcoal")
    x, y, h = 0.15 * k, 0.11 * k, 0.14 * k
    base = block(1.12 * x, 1.1 * y, 0.014 * k, 0.008, 0.002)
    bars = [tube(np.array([(-x / 2, s * y / 2, 0.012), (-x / 2, s * y / 2, h),
        (x / 2, s * y / 2, h),
                           (x / 2, s * y / 2, 0.012)]), 0.0034 * k, 8)
                               for s in (-1, 1)]  # fmt: skip
    d = 0.022 * k
    balls, wires = [], []
    swing = look.between(0.3, 0.6) if look.chance(0.6) else 0.0
    for n in range(5):
        u = (n - 2) * d
        a = swing if n == 4 else 0.0
        at = np.array([u + np.sin(a) * 0.095 * k, 0, h - 0.095 * k * np.cos(a)])
        balls.append(ellipsoid(d, d, d, 16, 10).move(*at))
        wires += [tube([at, (u, s * y / 2, h)], 0.0006, 4) for s in (-1, 1)]
    wood = look.own_color("black", "brown", "wooden")
    return shape([(base, textures.wood(look.rng, wood)), (join(bars), look.surface(color, "metal")),
                  (join(balls), textures.brushed_metal(look.rng, (206, 208, 212))),
                  (join(wires), textures.plain((210, 210, 212)))],
                 [hull_of(base), *(box_part(x, 0.006 * k, 0.006 * k, (0, s * y / 2, h - 0.003 * k))
                                   for s in (-1, 1)),
                  *(box_part(0.0068 * k, 0.0068 * k, h - 0.004, (s * x / 2, t * y / 2, 0.002))
                    for s in (-1, 1) for t in (-1, 1)), hull_of(*balls)])  # fmt: skip


CATEGORIES = (
    Category("bunsen_burner", bunsen_burner, (0.093, 0.081, 0.16), 0.5, ("gas burner",
             "lab burner", "bunsen"), ("lab",), ("tall",), ("charcoal",)),
    Category("lab_tripod", lab_tripod, (0.135, 0.124, 0.1305), 0.4, ("tripod stand",
             "heating tripod", "bunsen tripod", "laboratory tripod", "lab stand"), ("lab",),
             ("support", "tall"), ("charcoal",)),
    Category("retort_stand", retort_stand, (0.115, 0.175, 0.365), 1.1, ("burette stand",
             "burette", "ring stand", "clamp stand", "buret", "laboratory stand"), ("lab",),
             ("tall", "big"), ("gray",)),
    Category("balance_scale", balance_scale, (0.272, 0.12, 0.226), 0.7, ("beam balance",
             "balance", "scales of justice", "pan balance", "balance scales", "justice scales",
             "old scale"), ("lab",), ("tall", "big"), ("brass",)),
    Category("molecule_model", molecule_model, (0.09, 0.103, 0.086), 0.06, ("molecule",
             "molecular model", "atom model", "ball and stick model",
             "dna model", "cell model"),
             ("lab",), (), ("black", "red")),
    Category("glass_prism", in_sizes(glass_prism, 0.12), (0.0805, 0.034, 0.03), 0.09, ("prism",
             "optical prism", "light prism", "crystal prism", "triangular glass prism"), ("lab",),
             (), ("clear",)),
    Category("newtons_cradle", newtons_cradle, (0.16, 0.115, 0.137), 0.5, ("newton's cradle",
             "newton cradle", "pendulum balls", "pendulum", "desk pendulum"), ("office",),
             ("tall",), ("silver",)),
)  # fmt: skip
"""The module's categories."""
