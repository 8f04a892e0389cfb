"""Things to play with outdoors and in: tops, kites, yo-yos, slings, paddles, discs."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of, resting_ball, ring_parts
from ...build.outlines import ellipse, smooth
from ...build.shape import Shape, shape
from ...build.solids import (
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    prism,
    torus,
    tube,
)
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

BRIGHT = ("red", "blue", "yellow", "green", "orange", "purple", "pink", "teal")


def spinning_top(look: Look) -> Shape:
    """A top leaning on its rim and point."""
    k = look.between(0.9, 1.15)
    color = look.color(*BRIGHT)
    bands = [color, look.own_color("cream", "white", "yellow"), tint_color(color, 0.6)]
    body = lathe(
        np.array([(0, 0), (0.002, 0.001), (0.008, 0.01), (0.026, 0.022), (0.028, 0.027),
                  (0.024, 0.031), (0.006, 0.036), (0.0035, 0.04), (0.003, 0.058), (0, 0.06)]) * k,
        30)  # fmt: skip
    lean = np.arctan2(0.022, 0.026)
    body = body.turn(1, lean)
    body = body.move(z=-float(body.bounds[0, 2]))
    return shape([(body, textures.stripes(bands, 2))], [flat_foot(body.vertices, 0.1)])


def yo_yo(look: Look) -> Shape:
    """A yo-yo lying on one of its halves, its string beside it."""
    k = look.between(0.92, 1.08)
    color = look.color(*BRIGHT)
    half = np.array([(0, 0), (0.018, 0), (0.026, 0.003), (0.0285, 0.009), (0.027, 0.015),
                     (0.008, 0.018)])  # fmt: skip
    upper = half[::-1] * [1, -1] + [0, 0.04]
    body = lathe(np.concatenate([half, upper]) * k, 32)
    badge = cylinder(0.014 * k, 0.0006, 24).move(z=0.0398 * k)
    a = np.linspace(0, 2.6 * np.pi, 40)
    way = np.column_stack([0.009 * np.cos(a[:12]), 0.009 * np.sin(a[:12]), 0.02 + 0 * a[:12]])
    tail = smooth([(0.009, 0.01, 0.02), (0.03, 0.02, 0.012), (0.04, 0.005, 0.0012),
                   (0.05, -0.015, 0.0012), (0.065, 0.0, 0.0012)], 5)  # fmt: skip
    string = [tube(p * k, 0.0009, 5) for p in (way, tail)]
    return shape(
        [(body, look.surface(color, look.pick(["plastic", "wood"]))),
         (badge, textures.plain(look.own_color("white", "yellow", "black", "red"))),
         (join(string), textures.plain((238, 234, 224)))],
        [cylinder_part(0.0265 * k, 0.0395 * k)])  # fmt: skip


def kite(look: Look) -> Shape:
    """A small diamond kite lying flat, bows on its tail."""
    k = look.between(0.9, 1.1)
    color = look.color(*BRIGHT)
    others = [look.own_color(*BRIGHT) for _ in range(3)]
    image = prints.canvas(128, 128, color)
    prints.polygon(image, [(0.5, 0), (1, 0.36), (0.5, 0.36)], others[0])
    prints.polygon(image, [(0, 0.36), (0.5, 0.36), (0.5, 1)], others[0])
    prints.polygon(image, [(0.5, 0.36), (1, 0.36), (0.5, 1)], others[1])
    prints.fill(image, 0.485, 0, 0.03, 1, (110, 80, 50))
    prints.fill(image, 0, 0.35, 1, 0.02, (110, 80, 50))
    sail = prism(np.array([(0, -0.11), (0.075, 0.035), (0, 0.11), (-0.075, 0.035)]) * k, 0, 0.003)
    t = np.linspace(0, 1, 22)
    way = np.column_stack([0.025 * np.sin(9 * t) * t, -0.108 - 0.12 * t, 0.0012 + 0 * t]) * [
        k,
        k,
        1,
    ]
    pieces = [(sail, image), (tube(way, 0.0012, 5), textures.plain((240, 236, 226)))]
    for n in (7, 12, 17, 21):
        bow = np.array([(-0.011, -0.006), (0, -0.001), (0.011, -0.006), (0.011, 0.006), (0, 0.001),
                        (-0.011, 0.006)]) * k  # fmt: skip
        pieces.append((prism(bow, 0, 0.0028).move(*way[n][:2]), textures.plain(others[n % 3])))
    return shape(pieces, [hull_of(sail), box_part(0.03 * k, 0.13 * k, 0.0026, (0, -0.17 * k, 0))])


def slingshot(look: Look) -> Shape:
    """A forked wooden slingshot lying, a rubber band and a leather patch on it."""
    k = look.between(0.92, 1.08)
    wood = look.surface(look.color("wooden", "brown", "tan", "wooden"), "wood")
    z = r = 0.009 * k
    stem = [tube(smooth(np.array(p) * k + [0, 0, z], 4), r, 10) for p in (
        [(0, -0.085, 0), (0, -0.03, 0), (0, 0.0, 0)],
        [(0, -0.01, 0), (0.018, 0.02, 0), (0.036, 0.045, 0), (0.038, 0.075, 0)],
        [(0, -0.01, 0), (-0.018, 0.02, 0), (-0.036, 0.045, 0), (-0.038, 0.075, 0)])]  # fmt: skip
    band = [tube(smooth(np.array([(s * 0.038, 0.068, 0.021), (s * 0.025, 0.03, 0.015),
                                  (s * 0.008, -0.005, 0.022)]) * k, 4), 0.0035 * k, 6)
            for s in (-1, 1)]  # fmt: skip
    ties = [torus(0.0095 * k, 0.0022 * k, 16, 6).turn(0, np.pi / 2).move(s * 0.038 * k, 0.066 * k,
        z)
            for s in (-1, 1)]  # fmt: skip
    patch = block(0.026 * k, 0.016 * k, 0.004, 0.004).move(0, -0.006 * k, 0.0195 * k)
    return shape([(join(stem), wood), (join([*band, *ties]), textures.plain((176, 52, 44))),
                  (patch, textures.speckles(look.rng, (96, 62, 42), 8, 32))],
                 [*(hull_of(s) for s in stem), hull_of(patch)])  # fmt: skip


def frisbee(look: Look) -> Shape:
    """A flying disc lying rim down."""
    r, h = look.between(0.1, 0.135), look.between(0.022, 0.028)
    color = look.color(*BRIGHT, "white")
    body = lathe([(0, 0.7 * h), (0.9 * r, 0.7 * h), (0.97 * r, 0), (r, 0.002), (r, 0.45 * h),
                  (0.93 * r, 0.9 * h), (0.7 * r, h), (0, h)], 40)  # fmt: skip
    rings = [torus(f * r, 0.0009, 40, 5).move(z=h - 0.0004) for f in (0.5, 0.56, 0.62)]
    badge = cylinder(0.3 * r, 0.0012, 28).move(z=h - 0.0005)
    return shape(
        [(body, textures.speckles(look.rng, color, 3, 32)),
         (join(rings), textures.plain(tint_color(color, 0.8))),
         (badge, textures.plain(look.own_color("white", "black", "yellow")))],
        [*ring_parts([(0.99 * r, 0), (0.99 * r, 0.4 * h)], [(0.92 * r, 0.7 * h), (0.955 * r, 0)],
                     12), cylinder_part(0.93 * r, 0.3 * h, (0, 0, 0.7 * h))])  # fmt: skip


def table_tennis_bat(look: Look) -> Shape:
    """A table tennis bat lying, rubber up."""
    k = look.between(0.95, 1.06)
    color = look.color("red", "black", "red", "blue", "green")
    blade = ellipse(0.15, 0.155, 36) * k
    wood = textures.wood(look.rng, (214, 176, 122), side=64)
    grip = block(0.03 * k, 0.1 * k, 0.02 * k, 0.008, 0.004).move(y=-0.115 * k)
    cut = blade[blade[:, 1] > -0.052 * k]
    start = int(np.argmax(np.linalg.norm(np.diff(cut, axis=0), axis=1))) + 1
    rubber = np.roll(cut, -start, 0)
    return shape(
        [(prism(blade, 0.005 * k, 0.0115 * k), wood), (grip, wood),
         (prism(rubber, 0.0115 * k, 0.0145 * k), textures.speckles(look.rng, color, 4, 32)),
         (prism(rubber, 0.002 * k, 0.005 * k), textures.plain((40, 38, 40))),
         (box(0.012 * k, 0.085 * k, 0.0008).move(y=-0.115 * k, z=0.0197 * k),
          textures.plain(look.own_color("red", "black", "navy")))],
        [hull_of(prism(rubber, 0.002 * k, 0.0145 * k)), hull_of(grip)])  # fmt: skip


def shuttlecock(look: Look) -> Shape:
    """A shuttlecock standing on the rim of its feathers, cork up."""
    k = look.between(0.95, 1.08)
    color = look.color("white", "white", "white", "yellow")
    image = prints.canvas(160, 64, color)
    for n in range(16):
        prints.stroke(image, [(n / 16, 0), (n / 16, 1)], 0.03, tint_color(color, 0.72))
    prints.fill(image, 0, 0.3, 1, 0.04, tint_color(color, 0.6))
    prints.fill(image, 0, 0.6, 1, 0.04, tint_color(color, 0.6))
    skirt = lathe(np.array([(0.0315, 0), (0.033, 0), (0.0125, 0.062), (0.011, 0.062)]) * k, 16,
                  v=[0, 0.02, 0.98, 1], loop=True)  # fmt: skip
    cork = lathe(np.array([(0, 0.06), (0.0125, 0.06), (0.0135, 0.068), (0.0125, 0.078),
                           (0.008, 0.0845), (0, 0.0865)]) * k, 22)  # fmt: skip
    band = cylinder(0.0139 * k, 0.004 * k, 22).move(z=0.062 * k)
    return shape([(skirt, image), (cork, textures.speckles(look.rng, (238, 230, 210), 5, 32)),
                  (band, textures.plain(look.own_color("red", "green", "blue")))],
                 [*ring_parts([(0.0325 * k, 0), (0.0123 * k, 0.062 * k)],
                              [(0.011 * k, 0.062 * k), (0.031 * k, 0)], 8),
                                  hull_of(cork)])  # fmt: skip


def ping_pong_ball(look: Look) -> Shape:
    """A smooth table tennis ball."""
    d = look.between(0.039, 0.041)
    color = look.color("white", "orange", "white", "yellow")
    skin = textures.fit(textures.speckles(look.rng, color, 2, 32), 64, 64).copy()
    prints.fill(skin, 0, 0.49, 1, 0.02, tint_color(color, 0.93))
    return shape([(ellipsoid(d, d, d, 28, 18).move(z=d / 2), skin)], [resting_ball(d, d, d)])


def skipping_rope(look: Look) -> Shape:
    """A skipping rope laid in loops, two handles beside each other."""
    k = look.between(0.94, 1.06)
    color = look.color(*BRIGHT)
    t = np.linspace(0, 1, 110)
    a = 2 * np.pi * 3 * t
    away = 0.055 + 0.008 * np.sin(2.3 * a)
    way = np.column_stack([1.25 * away * np.cos(a), away * np.sin(a),
                           0.0035 + 0.007 * np.abs(np.sin(1.5 * a + 0.4))]) * k  # fmt: skip
    way = np.concatenate([[(0.06 * k, -0.075 * k, 0.006)], way, [(0.06 * k, -0.105 * k, 0.006)]])
    rope = tube(way, 0.003 * k, 5)
    grips = [lathe(np.array([(0, 0), (0.008, 0), (0.0105, 0.02), (0.0095, 0.07), (0.012, 0.1),
                             (0, 0.102)]) * k, 14).turn(1, np.pi / 2)
             .move(-0.045 * k, y * k, 0.012 * k) for y in (-0.075, -0.105)]  # fmt: skip
    ends = [s.turn(2, np.pi).move(y=-2 * 0.09 * k) for s in grips]
    wood = look.surface(color, look.pick(["wood", "plastic"]))
    strands = textures.stripes([(240, 236, 226), tint_color(color, 1.3)], 16, side=128)
    return shape([(rope, strands), (join(ends), wood)],
                 [*(hull_of(s) for s in ends),
                  *ring_parts([(0.057 * k, 0.0006), (0.057 * k, 0.0095 * k)],
                              [(0.047 * k, 0.0095 * k), (0.047 * k, 0.0006)], 10,
                              stretch=(1.25, 1.0))])  # fmt: skip


def bubbles_tub(look: Look) -> Shape:
    """A tub of soap bubbles with a coloured cap."""
    k = look.between(0.92, 1.1)
    color = look.color(*BRIGHT)
    body = lathe(np.array([(0, 0), (0.02, 0), (0.021, 0.002), (0.021, 0.078), (0.017, 0.084),
                           (0.017, 0.088), (0, 0.088)]) * k, 28, v=[0, 0, 0.02, 0.9, 0.95, 0.99,
                                                                    1])  # fmt: skip
    image = prints.canvas(192, 96, tint_color(color, 1.3))
    for _ in range(26):
        x, y, r = look.between(0, 1), look.between(0.1, 0.9), look.between(0.03, 0.11)
        prints.disc(image, x, y, r, (252, 252, 252), 0.8 * r)
    prints.write(image[:, 68:124], "BUBBLES", 0.5, 0.5, 0.3, tint_color(color, 0.5), bold=True)
    cap = cylinder(0.0195 * k, 0.022 * k, 24, bevel=0.001).move(z=0.088 * k)
    return shape([(body, image), (cap, textures.speckles(look.rng, color, 4, 32))],
                 [cylinder_part(0.021 * k, 0.08 * k), hull_of(cap)])  # fmt: skip


def boomerang(look: Look) -> Shape:
    """A boomerang lying flat."""
    k = look.between(0.92, 1.1)
    color = look.color("wooden", "red", "yellow", "wooden", "blue", "green")
    outer = smooth([(-0.13, -0.02), (-0.12, 0.005), (-0.03, 0.078), (0.03, 0.078), (0.12, 0.005),
                    (0.13, -0.02)], 5)  # fmt: skip
    inner = smooth([(0.105, -0.026), (0.02, 0.035), (-0.02, 0.035), (-0.105, -0.026)], 5)
    outline = np.concatenate([outer, inner])[::-1] * k
    body = prism(outline, 0, 0.007)
    image = textures.fit(look.surface(color, "wood"), 96, 96).copy()
    for x in (0.12, 0.2, 0.8, 0.88):
        prints.fill(image, x - 0.015, 0, 0.03, 1, look.own_color("white", "black", "red"))
    cuts = [(-0.14, -0.05), (-0.05, 0.05), (0.05, 0.14)]
    points = [outline[(outline[:, 0] >= a * k) & (outline[:, 0] <= b * k)] for a, b in cuts]
    parts = [
        hull_of(join([box(0.0002, 0.0002, 0.007).move(*(p * 0.99)) for p in side]))
        for side in points
    ]
    return shape([(body, image)], parts)


CATEGORIES = (
    Category("spinning_top", spinning_top, (0.0472, 0.0584, 0.0487), 0.03, ("top spinner",
             "toy top", "whipping top", "humming top", "tippe top", "anti-gravity spinner",
             "thaumatrope", "wooden spinning disc", "rattleback"), ("toys",), (), ("red",)),
    Category("yo_yo", yo_yo, (0.093, 0.057, 0.0405), 0.055, ("yoyo", "yo-yo"), ("toys",), (),
             ("red", "blue")),
    Category("kite", kite, (0.15, 0.34, 0.003), 0.03, ("diamond kite", "toy kite"), ("toys",),
             ("flat", "big"), ("red", "yellow"), 0.6, "lying flat"),
    Category("slingshot", slingshot, (0.1, 0.17, 0.026), 0.07, ("catapult", "sling shot"),
             ("toys",), (), ("wooden",), None, "lying flat"),
    Category("frisbee", frisbee, (0.235, 0.235, 0.0256), 0.12, ("flying disc", "disc golf disc",
             "flying disk", "discus", "newton disc"), ("toys",), ("round", "flat", "big"), ("red",
             "blue")),
    Category("table_tennis_bat", table_tennis_bat, (0.15, 0.243, 0.02), 0.17,
             ("ping pong paddle", "table tennis paddle", "table tennis racket", "ping pong bat",
              "ping pong racket", "ping-pong paddle", "paddle"), ("sports",), ("flat",), ("red",),
             0.6, "lying flat"),
    Category("ping_pong_ball", ping_pong_ball, (0.04, 0.04, 0.04), 0.0027,
             ("table tennis ball", "pingpong ball", "ping-pong ball"), ("sports",), ("round",),
             ("white", "orange")),
    Category("shuttlecock", shuttlecock, (0.067, 0.067, 0.0875), 0.005, ("badminton birdie",
             "badminton shuttlecock", "birdie", "badminton ball", "shuttle"), ("sports",),
             ("round",), ("white",)),
    Category("skipping_rope", skipping_rope, (0.165, 0.185, 0.024), 0.12, ("jump rope",
             "jumping rope", "skip rope", "jumprope"), ("sports",), (), ("red",), 0.6),
    Category("bubbles_tub", bubbles_tub, (0.042, 0.042, 0.11), 0.09, ("bubble bottle",
             "soap bubbles", "bubble wand", "bubble tub", "bubble solution", "bubble tube"),
             ("toys",), ("round", "tall"), ("blue", "pink")),
    Category("boomerang", boomerang, (0.265, 0.104, 0.007), 0.08, ("toy boomerang",),
             ("toys",), ("flat",), ("wooden",), None, "lying flat"),
)  # fmt: skip
"""The module's categories."""
