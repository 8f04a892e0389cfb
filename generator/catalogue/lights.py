"""Lamps and candles."""

from __future__ import annotations

import numpy as np

from . import prints, textures
from .category import Category
from .collision import cylinder_part, hull_of
from .colors import tinted
from .look import Look
from .shape import Shape, shape
from .solids import cylinder, ellipsoid, lathe, tube


def desk_lamp(look: Look) -> Shape:
    """A lamp: an arm with a tilted shade, or a fabric shade on a foot."""
    color = look.color("black", "white", "teal", "red", "brass", "mustard", "silver")
    skin = textures.speckled(look.rng, color, 3, 32)
    glow = textures.plain((255, 240, 196))
    if look.chance(0.6):
        base = cylinder(0.078, 0.018, 32, bevel=0.004)
        elbow, head = np.array([0.02, 0.07, 0.21]), np.array([0.0, -0.075, 0.36])
        lower = tube([(0, 0.03, 0.012), elbow], 0.006, 10)
        upper = tube([elbow, head], 0.006, 10)
        joint = ellipsoid(0.024, 0.024, 0.024, 14, 8).moved(*elbow)
        wall = 0.003
        shade = lathe(
            [(0, 0.075), (0.024, 0.07), (0.066, -0.01), (0.066 - wall, -0.01), (0.022, 0.065),
             (0, 0.068)], 28,
        )  # fmt: skip
        bulb = ellipsoid(0.042, 0.042, 0.05, 14, 8).moved(z=0.018)
        shade, bulb = (s.turned(0, -0.5).moved(*head).moved(z=-0.04) for s in (shade, bulb))
        return shape(
            [
                (base, skin),
                (lower, skin),
                (upper, skin),
                (joint, skin),
                (shade, skin),
                (bulb, glow),
            ],
            [cylinder_part(0.078, 0.018), hull_of(lower), hull_of(upper), hull_of(shade)],
        )
    foot = lathe([(0, 0), (0.06, 0), (0.06, 0.01), (0.018, 0.03), (0.03, 0.08), (0.012, 0.15),
                  (0.008, 0.22), (0, 0.22)], 28)  # fmt: skip
    cloth = textures.gradient((255, 246, 214), tinted(color, 1.6), look.rng, 2)
    shade = lathe([(0.088, 0.17), (0.06, 0.31), (0.057, 0.31), (0.085, 0.17)], 32, loop=True)
    cap = cylinder(0.057, 0.002, 28).moved(z=0.296)
    bulb = ellipsoid(0.05, 0.05, 0.06, 14, 8).moved(z=0.235)
    return shape(
        [(foot, look.surface(color, "ceramic")), (shade, cloth), (cap, glow), (bulb, glow)],
        [cylinder_part(0.06, 0.012), cylinder_part(0.018, 0.16, (0, 0, 0.012)), hull_of(shade)],
    )


def night_light(look: Look) -> Shape:
    """A small glowing lamp: a mushroom, or a globe on a ring."""
    glow = look.color("yellow", "amber", "cream", "pink", "sky")
    warm = textures.gradient(tinted(glow, 1.55), tinted(glow, 1.2), look.rng, 2)
    foot = look.surface(look.fixed("white", "wooden", "gray"), "plastic")
    r = look.between(0.046, 0.058)
    if look.chance(0.5):
        stem = lathe([(0, 0), (0.62 * r, 0), (0.45 * r, 1.1 * r), (0, 1.1 * r)], 24)
        t = np.linspace(0, np.pi / 2, 8)
        dome = np.column_stack([r * np.cos(t), r * (1.0 + 0.75 * np.sin(t))])
        dome[-1, 0] = 0
        cap = lathe([(0, r), *dome], 28)
        return shape([(stem, foot), (cap, warm)], [hull_of(stem), hull_of(cap)])
    ball = ellipsoid(2 * r, 2 * r, 2 * r, 28, 16).moved(z=r + 0.012)
    base = cylinder(0.68 * r, 0.026, 28, bevel=0.003)
    return shape([(ball, warm), (base, foot)], [cylinder_part(0.68 * r, 0.026), hull_of(ball)])


def candle(look: Look) -> Shape:
    """A pillar candle on a dish, or a scented candle in a glass."""
    r, h = look.between(0.026, 0.036), look.between(0.06, 0.13)
    wax = look.color("cream", "white", "red", "sage", "lavender", "coral")
    tile = textures.gradient(wax, tinted(wax, 1.35), look.rng, 3)
    wick = cylinder(0.0014, 0.016, 6).moved(z=h - 0.004)
    flame = lathe([(0, 0), (0.0045, 0.008), (0.0035, 0.014), (0, 0.026)], 12).moved(z=h + 0.008)
    fire = textures.gradient((255, 150, 40), (255, 236, 140), look.rng, 0)
    lit = [(wick, textures.plain((40, 36, 34))), (flame, fire)]
    tip = cylinder_part(0.003, 0.03, (0, 0, h))
    if look.chance(0.5):
        dish = lathe([(0, 0), (0.9 * r, 0), (1.5 * r, 0.01), (1.45 * r, 0.012), (0.9 * r, 0.004),
                      (0, 0.004)], 28)  # fmt: skip
        body = cylinder(r, h - 0.003, 28, bevel=0.002).moved(z=0.003)
        metal = textures.brushed(look.rng, look.fixed("gold", "silver", "black"))
        return shape(
            [(body, tile), (dish, metal), *lit],
            [hull_of(dish), cylinder_part(r, h - 0.003, (0, 0, 0.003)), tip],
        )
    glass = lathe([(0, 0), (r, 0), (1.05 * r, h + 0.012), (1.05 * r - 0.003, h + 0.012),
                   (r - 0.002, h - 0.004), (0, h - 0.004)], 28,
                  v=[0, 0, 0.9, 0.93, 0.98, 1])  # fmt: skip
    word = look.pick(["CALM", "FIG", "CEDAR", "ROSE"])
    print_ = prints.label(look.rng, word, (90, 84, 78), tinted(wax, 1.3))
    skin = textures.stacked((print_, 90), (tile, 10), side=128)
    return shape([(glass, skin), *lit], [cylinder_part(r, h), tip])


CATEGORIES = (
    Category(
        "desk_lamp",
        desk_lamp,
        (0.16, 0.21, 0.36),
        0.9,
        ("lamp", "table lamp", "reading lamp", "light"),
        ("office", "living", "craft"),
        ("tall", "big"),
        ("black", "white", "brass"),
    ),
    Category(
        "night_light",
        night_light,
        (0.105, 0.105, 0.105),
        0.2,
        ("nightlight", "glow lamp", "lantern"),
        ("living", "vanity", "play"),
        ("round",),
        ("yellow", "cream"),
    ),
    Category(
        "candle",
        candle,
        (0.075, 0.075, 0.12),
        0.2,
        ("scented candle", "pillar candle", "tea light"),
        ("dining", "vanity", "living"),
        ("round",),
        ("cream", "white"),
    ),
)
