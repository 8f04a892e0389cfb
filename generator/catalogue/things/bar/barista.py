"""Coffee makers, and what drinks are served from: pitchers, carafes, ice buckets."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.forms import facing, side_view
from ...build.outlines import rectangle, smooth
from ...build.recipes import open_vessel
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, sweep, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look

DARK: RGB = (38, 39, 43)


def moka_pot(look: Look) -> Shape:
    """An eight-sided stove-top espresso pot, waisted, its black handle to the right."""
    k, h = look.between(0.85, 1.08), look.between(0.165, 0.21)
    color = look.color("silver", "silver", "silver", "red", "black", "copper", "teal", "white")
    lower, sides = look.surface(color, "metal"), look.pick([8, 8, 8, 28])
    steel = textures.brushed_metal(look.rng, (192, 194, 198)) if look.chance(0.5) else lower
    r, waist = 0.046 * k, 0.44 * h
    base = lathe([(0, 0), (0.96 * r, 0), (r, 0.01), (0.8 * r, waist), (0, waist)], sides)
    ring = cylinder(0.86 * r, 0.03 * h, 30, bevel=0.001).move(z=waist)
    top = lathe([(0, 0.46 * h), (0.74 * r, 0.46 * h), (1.02 * r, 0.82 * h), (0, 0.82 * h)], sides)
    lid = lathe([(0, 0.82 * h), (1.05 * r, 0.82 * h), (1.03 * r, 0.835 * h), (0.3 * r, 0.9 * h),
                 (0, 0.905 * h)], sides)  # fmt: skip
    knob = lathe([(0, 0.9 * h), (0.006, 0.9 * h), (0.008, 0.94 * h), (0.013, 0.965 * h),
                  (0.01, h), (0, h)], 14)  # fmt: skip
    beak = side_view([(-0.6 * r, 0.55 * h), (-0.6 * r, 0.82 * h), (-1.42 * r, 0.82 * h)],
                     0.02 * k)  # fmt: skip
    grip = sweep(
        smooth([(0.9 * r, 0, 0.77 * h), (1.7 * r, 0, 0.8 * h), (2.0 * r, 0, 0.7 * h),
                (1.85 * r, 0, 0.3 * h)], 4), rectangle(0.02, 0.011, 0.004, 2),
    )  # fmt: skip
    dark = textures.speckles(look.rng, look.own_color("black", "black", "black", "brown"), 3, 32)
    valve = facing(cylinder(0.006, 0.008, 10)).move(y=-0.88 * r, z=0.25 * h)
    return shape(
        [(base, lower), (join([top, lid, beak]), lower), (join([ring, valve]), steel),
         (join([grip, knob]), dark)],
        [hull_of(base), hull_of(top), hull_of(lid), hull_of(knob), hull_of(beak),
         hull_part(grip.vertices[grip.vertices[:, 0] > 1.5 * r])],
    )  # fmt: skip


def espresso_machine(look: Look) -> Shape:
    """An espresso machine: group and filter holder over a drip tray, steam wand, cups on top."""
    x, y, h = look.between(0.22, 0.3), look.between(0.25, 0.3), look.between(0.28, 0.33)
    color = look.color("silver", "silver", "red", "black", "cream", "mint", "white")
    skin, dark = look.surface(color, "metal"), textures.plain(DARK)
    steel = textures.brushed_metal(look.rng, (194, 196, 200))
    tray = block(x, y, 0.055, 0.012, 0.004)
    back = block(x, 0.48 * y, h, 0.012, 0.004).move(y=0.26 * y)
    head = block(x, 0.86 * y, 0.33 * h, 0.014, 0.005).move(y=0.07 * y, z=0.67 * h)
    grate = box(0.84 * x, 0.42 * y, 0.003).move(y=-0.24 * y, z=0.054)
    grid = textures.grid((34, 35, 38), (150, 152, 156), 0, 14, 64, 2)
    group = cylinder(0.034, 0.035, 26, bevel=0.003).move(0, -0.2 * y, 0.67 * h - 0.034)
    basket = cylinder(0.033, 0.028, 26).move(0, -0.2 * y, 0.67 * h - 0.06)
    grip = facing(cylinder(0.013, 0.105, 14, top=0.016, bevel=0.003)).turn(0, 0.1)
    grip = grip.move(0, -0.2 * y - 0.03, 0.67 * h - 0.046)
    spouts = [cylinder(0.006, 0.022, 10).move(s * 0.01, -0.2 * y, 0.67 * h - 0.08)
              for s in (-1, 1)]  # fmt: skip
    wand = tube(smooth([(0.4 * x, -0.3 * y, 0.68 * h), (0.42 * x, -0.36 * y, 0.55 * h),
                        (0.42 * x, -0.4 * y, 0.3 * h)], 4), 0.005, 8)  # fmt: skip
    face = prints.canvas(160, 56, tint_color(color, 0.95))
    prints.disc(face, 0.16, 0.5, 0.36, (246, 246, 242))
    prints.disc(face, 0.16, 0.5, 0.36, DARK, 0.3)
    prints.stroke(face, [(0.16, 0.5), (0.2, 0.3)], 0.05, (200, 40, 40))
    for k in range(3):
        prints.disc(face, 0.46 + 0.17 * k, 0.5, 0.2, DARK)
        prints.disc(face, 0.46 + 0.17 * k, 0.5, 0.13, (224, 226, 230))
    front = box(0.86 * x, 0.004, 0.2 * h).move(y=-0.36 * y - 0.002, z=0.735 * h)
    pieces = [(join([tray, back, head]), skin), (grate, grid), (front, face),
              (join([group, basket, *spouts, wand]), steel), (grip, dark)]  # fmt: skip
    if look.chance(0.6):
        cup = lathe([(0, 0), (0.02, 0), (0.03, 0.045), (0.027, 0.045), (0.018, 0.004), (0, 0.004)])
        pieces.append((join([cup.move(s * 0.22 * x, 0.1 * y, h) for s in (-1, 1)]),
                       textures.plain((242, 240, 236))))  # fmt: skip
    return shape(pieces, [hull_of(tray), hull_of(back), hull_of(head), hull_of(group, basket),
                          hull_of(grip), hull_of(wand)])  # fmt: skip


def coffee_grinder(look: Look) -> Shape:
    """A coffee grinder: a wooden mill with a crank and a drawer, or an electric one."""
    if look.chance(0.55):
        s, h = look.between(0.105, 0.13), look.between(0.1, 0.13)
        color = look.color("wooden", "brown", "tan", "maroon", "black", "teal")
        wood = look.surface(color, "wood")
        metal = textures.brushed_metal(
            look.rng, look.own_color("brass", "copper", "silver", "charcoal")
        )
        feet = box(s + 0.014, s + 0.014, 0.012)
        body, top = box(s, s, h).move(z=0.012), box(s + 0.01, s + 0.01, 0.01).move(z=h + 0.012)
        face = textures.wood(look.rng, tint_color(color, 1.2))
        drawer = box(0.72 * s, 0.008, 0.42 * h).move(y=-s / 2 - 0.003, z=0.2 * h)
        pull = ellipsoid(0.016, 0.016, 0.016, 12, 8).move(y=-s / 2 - 0.012, z=0.41 * h)
        z = h + 0.022
        cup = lathe([(0, z), (0.024, z), (0.044, z + 0.03), (0.046, z + 0.04), (0.03, z + 0.056),
                     (0.008, z + 0.062), (0, z + 0.062)], 24)  # fmt: skip
        a = look.between(-0.6, 0.6)
        arm = tube(smooth([(0, 0, z + 0.055), (0, 0, z + 0.08), (0.05, 0, z + 0.088),
                           (0.11, 0, z + 0.084)], 4), 0.0045, 8)  # fmt: skip
        knob = ellipsoid(0.026, 0.026, 0.034, 14, 10).move(0.112, 0, z + 0.1)
        arm, knob = arm.turn(2, a), knob.turn(2, a)
        return shape(
            [(join([feet, body, top, knob]), wood), (drawer, face),
             (join([pull, cup, arm]), metal)],
            [hull_of(feet), hull_of(body), hull_of(top), hull_of(cup), hull_of(knob, arm)],
        )  # fmt: skip
    r, h = look.between(0.05, 0.06), look.between(0.2, 0.25)
    color = look.color("black", "silver", "white", "red", "mint")
    body = lathe([(0, 0), (r, 0), (r, 0.02), (0.86 * r, 0.3 * h), (0.9 * r, 0.62 * h),
                  (0, 0.62 * h)], 28)  # fmt: skip
    beans = textures.spots(look.rng, (72, 44, 28), (40, 24, 16), 0.4)
    clear = textures.plain((204, 214, 218))
    hopper = lathe([(0, 0.62 * h), (0.84 * r, 0.62 * h), (1.1 * r, 0.94 * h), (0, 0.94 * h)], 28,
                   v=[0, 0.05, 0.95, 1])  # fmt: skip
    lid = cylinder(1.12 * r, 0.06 * h, 28, bevel=0.002).move(z=0.94 * h)
    dial = facing(cylinder(0.02, 0.012, 20, bevel=0.002)).move(y=-0.84 * r, z=0.42 * h)
    return shape(
        [
            (body, look.surface(color)),
            (hopper, textures.stack((beans, 60), (clear, 40))),
            (join([lid, dial]), textures.plain(DARK)),
        ],
        [hull_of(body), hull_of(hopper), hull_of(lid)],
    )


def pitcher(look: Look) -> Shape:
    """An open jug with a lip to the left and a handle to the right."""
    r, h = look.between(0.052, 0.066), look.between(0.17, 0.23)
    color = look.color("white", "sky", "cream", "terracotta", "teal", "mustard", "clear", "navy")
    kind = look.pick(["belly", "straight", "flared"])
    t = np.linspace(0, 1, 9)
    swell = {
        "belly": 0.78 + 0.34 * np.sin(np.pi * (0.1 + 0.86 * t)) ** 1.4 - 0.1 * t,
        "straight": 0.92 + 0.08 * t,
        "flared": 0.72 + 0.3 * t**1.5,
    }[kind]
    body, parts = open_vessel([(r * s, h * u) for s, u in zip(swell, t, strict=True)], 0.005, 0.007)

    def lip_profile(p: np.ndarray) -> np.ndarray:
        up = np.clip((p[:, 2] / h - 0.72) / 0.28, 0, 1) ** 2
        left = np.clip(-p[:, 0] / r, 0, 1) ** 5
        return p + np.column_stack([-0.024 * up * left, -0.7 * p[:, 1] * up * left * 0.5,
                                    0.008 * up * left])  # fmt: skip

    rim, low = 0.96 * swell[-1] * r, float(np.interp(0.3, t, swell)) * r
    ear = tube(smooth([(rim, 0, 0.93 * h), (rim + 0.05, 0, 0.95 * h), (rim + 0.056, 0, 0.62 * h),
                       (low, 0, 0.3 * h)], 5), 0.0075, 10, squash=0.8)  # fmt: skip
    inside = look.surface(tint_color(color, 1.3), "ceramic")
    skin = glaze_tile(look, color)
    return shape(
        [(body.bend(lip_profile), textures.stack((skin, 50), (inside, 50), side=192)),
         (ear, look.surface(color, "ceramic"))],
        [*parts, box_part(0.03, 0.015, 0.55 * h, (rim + 0.04, 0, 0.38 * h))],
    )  # fmt: skip


def carafe(look: Look) -> Shape:
    """A glass carafe or a cut decanter with its stopper, often with wine, water or whisky in it."""
    h = look.between(0.22, 0.28)
    full = look.pick([(120, 22, 36), (214, 150, 60), (206, 222, 228), (236, 170, 40)])
    color = look.color("clear", "clear", "sky", "mint", "amber", "green")
    clear, wet = textures.plain(tint_color(color, 1.2)), textures.plain(full)
    level = look.between(0.25, 0.45)
    tile = textures.stack((wet, level), (clear, 1 - level), side=128)
    steel = textures.plain((206, 212, 216))
    if look.chance(0.5):
        s = look.between(0.078, 0.09)
        body = lathe([(0, 0), (0.7 * s, 0), (0.7 * s, 0.48 * h), (0.24 * s, 0.6 * h),
                      (0.22 * s, 0.72 * h), (0.3 * s, 0.74 * h), (0, 0.74 * h)], 4,
                     v=[0, 0.01, 0.6, 0.7, 0.9, 0.95, 1]).turn(2, np.pi / 4)  # fmt: skip
        cut = textures.grid(tint_color(full, 1.25), full, 8, 16, 64)
        tile = textures.stack((cut, level), (clear, 1 - level), side=128)
        ball = lathe([(0, 0.72 * h), (0.012, 0.74 * h), (0.026, 0.84 * h), (0.03, 0.92 * h),
                      (0.02, h), (0, h)], 8)  # fmt: skip
        return shape([(body, tile), (ball, steel)],
                     [hull_part(body.vertices[body.vertices[:, 2] < 0.5 * h]), hull_of(ball),
                      cylinder_part(0.2 * s, 0.24 * h, (0, 0, 0.5 * h))])  # fmt: skip
    r = look.between(0.052, 0.064)
    side = [(0.7 * r, 0), (r, 0.12 * h), (r, 0.3 * h), (0.6 * r, 0.55 * h), (0.42 * r, 0.72 * h),
            (0.4 * r, 0.86 * h), (0.6 * r, h)]  # fmt: skip
    path = smooth(side, 2)
    body = lathe([(0, 0), *path, (0.55 * r, h), (0.36 * r, 0.86 * h), (0, 0.86 * h)], 28,
                 v=[0, *(0.95 * z / h for _, z in path), 0.96, 0.98, 1])  # fmt: skip
    pieces = [(body, tile)]
    parts = [hull_part(body.vertices[body.vertices[:, 2] < 0.45 * h]),
             cylinder_part(0.4 * r, 0.54 * h, (0, 0, 0.4 * h))]  # fmt: skip
    if look.chance(0.4):
        cork = cylinder(0.4 * r, 0.035, 18, top=0.5 * r).move(z=0.95 * h)
        pieces.append((cork, textures.spots(look.rng, (206, 166, 116), (160, 120, 78), 0.1)))
        parts.append(hull_of(cork))
    return shape(pieces, parts)


def ice_bucket(look: Look) -> Shape:
    """A bucket of ice cubes with two ring handles; some cool a bottle."""
    r, h = look.between(0.085, 0.105), look.between(0.16, 0.2)
    color = look.color("silver", "silver", "copper", "gold", "black", "clear", "white")
    skin = look.surface(color, "metal")
    low, level = 0.74 * r, 0.8 * h
    side = [(low, 0), (low + (r - low) * 0.97, 0.94 * h), (1.05 * r, 0.95 * h), (1.05 * r, h),
            (r - 0.004, h), (r - 0.012, level)]  # fmt: skip
    body = lathe([(0, 0), *side, (0, level)], 32)
    ring = torus(0.024, 0.0035, 20, 6).turn(1, np.pi / 2)
    ears = [ring.move(s * (0.95 * r + 0.004), 0, 0.74 * h) for s in (-1, 1)]
    cubes = []
    for k in range(18):
        away, turn = 0.72 * r * np.sqrt((k + 0.5) / 18), 2.4 * k
        cube = block(0.028, 0.028, 0.026, 0.004, 0.003).turn(0, look.between(-0.6, 0.6))
        cube = cube.turn(2, turn).move(away * np.cos(turn), away * np.sin(turn), level - 0.008)
        cubes.append(cube)
    ice = textures.speckles(look.rng, (214, 230, 238), 10, 32)
    top = max(float(c.bounds[1, 2]) for c in cubes)
    return shape(
        [(body, skin), (join(ears), skin), (join(cubes), ice)],
        [hull_of(body), *(hull_of(e) for e in ears),
         cylinder_part(0.6 * r, top - h, (0, 0, h)) if top > h + 0.001 else hull_of(body)],
    )  # fmt: skip


CATEGORIES = (
    Category("moka_pot", moka_pot, (0.16, 0.09, 0.19), 0.5, ("stovetop espresso maker",
             "espresso pot", "moka", "bialetti", "espresso maker", "italian coffee maker"),
             ("coffee", "kitchen"), ("tall",), ("silver", "red")),
    Category("espresso_machine", espresso_machine, (0.248, 0.329, 0.322), 6.0,
             ("espresso coffee machine", "cappuccino machine", "nespresso machine",
             "capsule machine"), ("coffee", "kitchen"), ("tall", "big"), ("silver", "red")),
    Category("coffee_grinder", coffee_grinder, (0.134, 0.125, 0.235), 0.9, ("coffee mill",
             "grinder", "hand grinder", "burr grinder"), ("coffee", "kitchen"),
             ("tall",), ("wooden", "black")),
    Category("pitcher", pitcher, (0.185, 0.12, 0.203), 0.7, ("jug", "water jug", "milk jug",
             "water pitcher", "creamer", "milk pitcher", "lemonade pitcher", "ewer", "cream jug"),
             ("dining", "kitchen"), ("container", "tall"), ("white", "sky")),
    Category("carafe", carafe, (0.104, 0.104, 0.238), 0.9, ("decanter", "wine decanter",
             "whiskey decanter", "whisky decanter", "wine carafe", "water carafe", "glass carafe"),
             ("dining",), ("tall", "round"), ("clear",)),
    Category("ice_bucket", ice_bucket, (0.205, 0.205, 0.183), 1.6, ("wine cooler",
             "champagne bucket", "bucket of ice", "wine bucket", "champagne cooler"),
             ("dining",), ("round", "big"), ("silver", "copper")),
)  # fmt: skip
"""The module's categories."""
