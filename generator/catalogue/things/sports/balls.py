"""Balls of several sports, pins and weights."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, flat_foot, hull_of, resting_ball, ring_parts
from ...build.forms import facing
from ...build.outlines import ellipse, smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look


def _sphere_print(look: Look, d: float, image: textures.Tile) -> Shape:
    return shape([(ellipsoid(d, d, d, 32, 20).move(z=d / 2), image)], [resting_ball(d, d, d)])


def volleyball(look: Look) -> Shape:
    """A mini volleyball in panels of two or three colours."""
    d = look.between(0.14, 0.2)
    tones = [look.color("white", "yellow", "cream"), look.own_color("blue", "navy", "red"),
             look.own_color("yellow", "white", "green")]  # fmt: skip
    image = prints.canvas(192, 96, tones[0])
    for n in range(6):
        x = n / 6
        for m in range(3):
            if n % 2:
                prints.fill(image, x + m / 18, 0.18, 1 / 18, 0.64, tones[(m + n // 2) % 3])
            else:
                prints.fill(image, x, 0.18 + 0.213 * m, 1 / 6, 0.213, tones[(m + n // 2) % 3])
        prints.fill(image, x, 0, 0.008, 1, (90, 90, 90))
    for y in (0.18, 0.393, 0.606, 0.82):
        for n in range(0, 6, 2):
            prints.fill(image, n / 6, y, 1 / 6, 0.012, (90, 90, 90))
    prints.fill(image, 0, 0, 1, 0.18, tones[0])
    prints.fill(image, 0, 0.82, 1, 0.18, tones[1])
    return _sphere_print(look, d, image)


def cricket_ball(look: Look) -> Shape:
    """A leather cricket ball with a stitched seam."""
    d = look.between(0.07, 0.073)
    color = look.color("crimson", "maroon", "red", "white", "pink")
    image = textures.fit(textures.speckles(look.rng, color, 5, 64), 128, 128).copy()
    thread = (236, 228, 210) if sum(color) < 560 else (40, 110, 70)
    for y in (0.455, 0.48, 0.52, 0.545):
        for n in range(48):
            prints.fill(image, n / 48, y - 0.006, 0.012, 0.012, thread)
    prints.fill(image, 0, 0.496, 1, 0.008, tint_color(color, 0.6))
    body = ellipsoid(d, d, d, 32, 20).turn(1, 0.6).move(z=d / 2)
    return shape([(body, image)], [resting_ball(d, d, d)])


def bowling_ball(look: Look) -> Shape:
    """A small marbled bowling ball with three finger holes."""
    d = look.between(0.1, 0.13)
    color = look.color("navy", "black", "crimson", "purple", "teal", "green")
    skin = textures.marble(look.rng, color, tint_color(color, 1.5))
    holes = []
    for n, (a, b) in enumerate(((0.0, 0.2), (-0.28, -0.15), (0.28, -0.15))):
        hole = cylinder((0.0095 if n else 0.011) * d / 0.12, 0.004, 16).move(z=d / 2 - 0.0034)
        holes.append(hole.turn(1, a).turn(0, b + 0.5).move(z=d / 2))
    return shape([(ellipsoid(d, d, d, 32, 20).move(z=d / 2), skin),
                  (join(holes), textures.plain((14, 14, 16)))],
                      [resting_ball(d, d, d)])  # fmt: skip


def rugby_ball(look: Look) -> Shape:
    """A rugby ball lying, coloured panels at its ends."""
    k = look.between(0.62, 0.8)
    color = look.color("white", "white", "cream", "orange")
    other = look.own_color("red", "blue", "green", "navy", "black")
    image = prints.canvas(128, 128, color)
    for n in range(4):
        prints.polygon(image, [(n / 4, 0), (n / 4 + 0.25, 0), (n / 4 + 0.125, 0.38)], other)
        prints.polygon(image, [(n / 4, 1), (n / 4 + 0.25, 1), (n / 4 + 0.125, 0.62)], other)
        prints.fill(image, n / 4, 0, 0.012, 1, tint_color(color, 0.6))
    prints.fill(image, 0, 0.49, 1, 0.02, other)
    a = np.linspace(-np.pi / 2, np.pi / 2, 21)
    profile = np.column_stack([0.095 * np.cos(a) ** 0.85, 0.14 * np.sin(a)]) * k
    profile[[0, -1], 0] = 0
    body = lathe(profile, 28).turn(1, np.pi / 2).move(z=0.095 * k)
    return shape([(body, image)], [flat_foot(body.vertices, 0.06)])


def hockey_puck(look: Look) -> Shape:
    """A hard rubber puck."""
    k = look.between(0.96, 1.04)
    color = look.color("black", "black", "charcoal", "blue", "orange")
    body = cylinder(0.038 * k, 0.0254 * k, 36, bevel=0.001)
    return shape([(body, textures.spots(look.rng, color, tint_color(color, 1.25), 0.08))],
                 [cylinder_part(0.038 * k, 0.0254 * k)])  # fmt: skip


def bowling_pin(look: Look) -> Shape:
    """A small bowling pin with red stripes at its neck."""
    k = look.between(0.45, 0.62)
    color = look.color("white", "white", "cream", "wooden", "yellow")
    profile = np.array([(0, 0), (0.028, 0), (0.034, 0.02), (0.052, 0.08), (0.06, 0.115),
                        (0.055, 0.16), (0.038, 0.21), (0.024, 0.255), (0.0225, 0.28),
                        (0.027, 0.31), (0.032, 0.34), (0.029, 0.365), (0.016, 0.379),
                        (0, 0.381)])  # fmt: skip
    curve = smooth(profile[1:-1], 3)
    points = np.concatenate([[(0, 0)], curve, [(0, 0.381)]]) * k
    image = textures.fit(look.surface(color, "plastic"), 128, 32).copy()
    band = look.own_color("red", "red", "blue")
    heights = points[:, 1] / points[-1, 1]
    for z in (0.66, 0.725):
        prints.fill(image, 0, 1 - z - 0.035, 1, 0.035, band)
    body = lathe(points, 28, v=list(heights))
    return shape([(body, image)], [cylinder_part(0.028 * k, 0.03 * k), hull_of(body)])


def golf_tee(look: Look) -> Shape:
    """A golf tee standing on its cup, point up, as it stands on a table."""
    k = look.between(0.9, 1.15)
    color = look.color("white", "red", "wooden", "yellow", "blue", "orange")
    body = lathe(np.array([(0, 0), (0.006, 0), (0.0062, 0.002), (0.0035, 0.009), (0.0023, 0.014),
                           (0.0021, 0.046), (0.0003, 0.054), (0, 0.0542)]) * k, 16)  # fmt: skip
    return shape([(body, look.surface(color, look.pick(["wood", "plastic"])))],
                 [cylinder_part(0.006 * k, 0.002 * k), hull_of(body)])  # fmt: skip


def kettlebell(look: Look) -> Shape:
    """A kettlebell: a flattened ball under a thick handle."""
    k = look.between(0.85, 1.05)
    color = look.color("black", "charcoal", "red", "blue", "green", "purple", "yellow")
    ball = lathe(np.array([(0, 0), (0.042, 0), (0.058, 0.018), (0.064, 0.05), (0.056, 0.084),
                           (0.035, 0.104), (0, 0.112)]) * k, 30)  # fmt: skip
    way = smooth([(-0.036, 0, 0.09), (-0.05, 0, 0.13), (-0.042, 0, 0.165), (0, 0, 0.176),
                  (0.042, 0, 0.165), (0.05, 0, 0.13), (0.036, 0, 0.09)], 4) * k  # fmt: skip
    handle = tube(way, 0.013 * k, 12)
    badge = prism(ellipse(0.05 * k, 0.05 * k, 24), 0, 0.002)
    weight = look.pick(["2", "4", "6"])
    image = prints.canvas(64, 64, (240, 240, 236))
    prints.write(image, weight + " kg", 0.5, 0.5, 0.28, (30, 30, 32), bold=True)
    badge = facing(badge).turn(0, -0.12).move(y=-0.0615 * k, z=0.052 * k)
    n = len(way)
    spans = [hull_of(tube(way[a:b], 0.0125 * k, 8)) for a, b in
             ((0, n // 3 + 1), (n // 3, 2 * n // 3 + 1), (2 * n // 3, n))]  # fmt: skip
    return shape([(join([ball, handle]), textures.speckles(look.rng, color, 5, 48)),
                  (badge, image)], [hull_of(ball), *spans])  # fmt: skip


def weight_plate(look: Look) -> Shape:
    """A small weight disc with a hole, lying."""
    k = look.between(0.9, 1.1)
    color = look.color("black", "gray", "red", "blue", "charcoal", "green")
    r, h, hole = 0.08 * k, 0.022 * k, 0.0145 * k
    profile = [(hole, 0), (0.9 * r, 0), (r, 0.003), (r, h - 0.003), (0.95 * r, h), (0.8 * r, h),
               (0.76 * r, 0.7 * h), (0.45 * r, 0.7 * h), (0.4 * r, h), (hole, h)]  # fmt: skip
    image = prints.canvas(128, 64, color)
    body = lathe(profile, 40, loop=True)
    sign = prints.canvas(48, 24, color)
    prints.write(sign, look.pick(["1 KG", "2 KG", "1.25", "2.5"]), 0.5, 0.5, 0.6,
                 readable_on(color), bold=True)  # fmt: skip
    plate = box(0.042 * k, 0.021 * k, 0.0006).move(y=-0.6 * r, z=0.7 * h)
    return shape([(body, look.surface(color, "metal") if look.chance(0.4) else image),
                  (plate, sign)],
                 ring_parts([(r, 0), (r, h)], [(hole, h), (hole, 0)], 10))  # fmt: skip


def yoga_block(look: Look) -> Shape:
    """A foam or cork block for yoga."""
    k = look.between(0.9, 1.02)
    color = look.color("purple", "teal", "pink", "gray", "tan", "blue", "mint")
    cork = textures.spots(look.rng, color, tint_color(color, 0.75), 0.08)
    body = block(0.22 * k, 0.14 * k, 0.075 * k, 0.012, 0.006)
    return shape([(body, cork)], [hull_of(body)])


CATEGORIES = (
    Category("volleyball", volleyball, (0.17, 0.17, 0.17), 0.2, ("beach volleyball",
             "mini volleyball"), ("sports",), ("round", "big")),
    Category("cricket_ball", cricket_ball, (0.0715, 0.0715, 0.0715), 0.16, ("leather ball",
             "shot put", "cannonball",),
             ("sports",), ("round",), ("crimson",)),
    Category("bowling_ball", bowling_ball, (0.115, 0.115, 0.115), 1.2, ("mini bowling ball",),
             ("sports",), ("round",), ("navy", "black")),
    Category("rugby_ball", rugby_ball, (0.2, 0.135, 0.135), 0.24, ("rugby", "mini rugby ball"),
             ("sports",), ("big",), ("white",)),
    vary(Category("hockey_puck", hockey_puck, (0.076, 0.076, 0.0254), 0.16, ("puck",
             "ice hockey puck"), ("sports",), ("round", "flat"), ("black",))),
    Category("bowling_pin", bowling_pin, (0.064, 0.064, 0.205), 0.25,
        ("skittle", "tenpin", "mini bowling pin"), ("sports",), ("round", "tall"), ("white",)),
    Category("golf_tee", golf_tee, (0.0125, 0.0125, 0.0555), 0.002, (), ("sports",),
             ("round",), ("white",)),
    Category("kettlebell", kettlebell, (0.122, 0.122, 0.18), 2.5, ("kettle bell",), ("sports",),
             (), ("black",)),
    Category("weight_plate", weight_plate, (0.16, 0.16, 0.022), 1.3, ("barbell plate",
             "weight disc", "weight disk", "barbell disc", "dumbbell plate"), ("sports",),
             ("round", "flat"), ("black",)),
    Category("yoga_block", yoga_block, (0.21, 0.135, 0.072), 0.2, ("yoga brick", "pilates block"),
             ("sports",), ("support", "big"), ("purple",)),
)  # fmt: skip
"""The module's categories."""
