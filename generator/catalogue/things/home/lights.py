"""Lamps and candles."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import block, cylinder, ellipsoid, lathe, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look


def desk_lamp(look: Look) -> Shape:
    """A lamp: a jointed arm with a tilted shade or a bar of light, or a shade on a foot."""
    color = look.color(
        *("black", "black", "white", "teal", "red", "brass", "mustard", "silver", "sage", "navy"),
        *("pink", "copper"),
    )
    if look.chance(0.6):
        return _arm_lamp(look, color)
    return _shade_lamp(look, color)


def _arm_lamp(look: Look, color: RGB) -> Shape:
    """Return a lamp of two arms, or one bow, on a heavy base."""
    skin = textures.speckles(look.rng, color, 3, 32)
    metal = look.pick(
        [skin, textures.brushed_metal(look.rng, look.own_color("brass", "silver", "copper"))]
    )
    r = look.between(0.066, 0.084)
    square, bar, bow = look.chance(0.3), look.chance(0.35), look.chance(0.3)
    base = (
        block(1.8 * r, 1.8 * r, 0.018, 0.02, 0.004)
        if square
        else cylinder(r, look.between(0.014, 0.024), 32, bevel=0.004)
    )
    elbow = np.array([0.02, 0.07, look.between(0.18, 0.24)])
    head = np.array([0.0, -0.075, look.between(0.33, 0.38)])
    if bow:
        path = [(0, 0.03, 0.012), (0, 0.085, 0.2), (0, 0.04, head[2] + 0.02), head]
        arms = [tube(smooth(path, 6), 0.006, 8)]
    else:
        arms = [tube([(0, 0.03, 0.012), elbow], 0.006, 10), tube([elbow, head], 0.006, 10)]
    joint = ellipsoid(0.024, 0.024, 0.024, 14, 8).move(*(head if bow else elbow))
    glow = textures.plain((255, 240, 196))
    if bar:
        shade = block(0.07, 0.2, 0.014, 0.02, 0.003).move(z=0.004)
        light = block(0.056, 0.18, 0.003, 0.016).move(z=0.0025)
        tilt = (s.turn(0, 0.12).move(*head).move(z=-0.012) for s in (shade, light))
    else:
        wide, tall, wall = look.between(0.056, 0.076), look.between(0.07, 0.095), 0.003
        round_ = look.chance(0.4)
        side = (
            [(0.024, tall - 0.005), (0.9 * wide, 0.45 * tall)]
            if round_
            else [(0.024, tall - 0.005)]
        )
        shade = lathe(
            [(0, tall), *side, (wide, -0.01), (wide - wall, -0.01),
             *[(x - wall, z - 0.004) for x, z in side[::-1]], (0, tall - 0.007)], 28,
        )  # fmt: skip
        bulb = ellipsoid(0.042, 0.042, 0.05, 14, 8).move(z=0.018)
        tilt = (s.turn(0, -0.5).move(*head).move(z=-0.04) for s in (shade, bulb))
    shade, light = tilt
    return shape(
        [
            (base, skin),
            *((arm, metal) for arm in arms),
            (joint, skin),
            (shade, skin),
            (light, glow),
        ],
        [hull_of(base), *[hull_of(arm) for arm in arms], hull_of(shade)],
    )


def _shade_lamp(look: Look, color: RGB) -> Shape:
    """Return a table lamp: a fabric shade, plain, banded or pleated, on a turned foot."""
    feet = [
        [(0.06, 0), (0.06, 0.01), (0.018, 0.03), (0.03, 0.08), (0.012, 0.15), (0.008, 0.22)],
        [(0.05, 0), (0.062, 0.04), (0.055, 0.09), (0.02, 0.13), (0.012, 0.16), (0.008, 0.22)],
        [(0.062, 0), (0.062, 0.012), (0.01, 0.02), (0.008, 0.1), (0.008, 0.16), (0.008, 0.22)],
        [(0.036, 0), (0.052, 0.03), (0.036, 0.06), (0.05, 0.095), (0.016, 0.15), (0.008, 0.22)],
    ]
    side = look.pick(feet)
    foot = lathe([(0, 0), *side, (0, 0.22)], 28, v=[0, *np.linspace(0.02, 0.98, 6), 1])
    hue = look.pick([color, (250, 246, 236), (236, 222, 190)])
    cloth = textures.gradient((255, 246, 214), tint_color(hue, 1.5), look.rng, 2)
    kind = int(look.rng.integers(4))
    if kind == 1:
        band = textures.plain(tint_color(color, 0.8))
        cloth = textures.stack((band, 1), (cloth, 8), (band, 1))
    elif kind == 2:
        cloth = textures.stripes([(250, 240, 214), (228, 214, 184)], 20, upright=True, side=128)
    elif kind == 3:
        cloth = textures.fabric(look.rng, tint_color(hue, 1.2))
    top, wide = look.between(0.045, 0.078), look.between(0.08, 0.095)
    shade = lathe(
        [(wide, 0.17), (top, 0.31), (top - 0.003, 0.31), (wide - 0.003, 0.17)], 32, loop=True
    )
    glow = textures.plain((255, 240, 196))
    cap = cylinder(top - 0.001, 0.002, 28).move(z=0.296)
    bulb = ellipsoid(0.05, 0.05, 0.06, 14, 8).move(z=0.235)
    wide_foot = min(r for r, z in side if z <= 0.012)
    return shape(
        [(foot, glaze_tile(look, color)), (shade, cloth), (cap, glow), (bulb, glow)],
        [
            cylinder_part(wide_foot, 0.012),
            cylinder_part(0.018, 0.16, (0, 0, 0.012)),
            hull_of(shade),
        ],
    )


def night_light(look: Look) -> Shape:
    """A small glowing lamp: a mushroom, or a globe on a ring."""
    glow = look.color("yellow", "amber", "cream", "pink", "sky", "mint", "lavender", "red")
    warm = textures.gradient(tint_color(glow, 1.55), tint_color(glow, 1.2), look.rng, 2)
    base_color = look.own_color("white", "wooden", "gray", "black", "brown")
    foot = look.surface(base_color, look.pick(["plastic", "wood"]))
    if look.chance(0.4):
        warm = textures.spots(look.rng, tint_color(glow, 1.3), (252, 248, 238), 0.12)
    r = look.between(0.046, 0.058)
    if look.chance(0.5):
        stem = lathe([(0, 0), (0.62 * r, 0), (0.45 * r, 1.1 * r), (0, 1.1 * r)], 24)
        t = np.linspace(0, np.pi / 2, 8)
        dome = np.column_stack([r * np.cos(t), r * (1.0 + 0.75 * np.sin(t))])
        dome[-1, 0] = 0
        cap = lathe([(0, r), *dome], 28)
        return shape([(stem, foot), (cap, warm)], [hull_of(stem), hull_of(cap)])
    ball = ellipsoid(2 * r, 2 * r, 2 * r, 28, 16).move(z=r + 0.012)
    base = cylinder(0.68 * r, 0.026, 28, bevel=0.003)
    return shape([(ball, warm), (base, foot)], [cylinder_part(0.68 * r, 0.026), hull_of(ball)])


def candle(look: Look) -> Shape:
    """A pillar candle on a dish, or a scented candle in a glass."""
    r, h = look.between(0.026, 0.036), look.between(0.06, 0.13)
    wax = look.color(
        *("cream", "white", "red", "sage", "lavender", "coral", "navy", "mustard", "pink", "black")
    )
    pale = 1.35 if sum(wax) > 240 else 1.06  # black wax stays black
    tile = textures.gradient(wax, tint_color(wax, pale), look.rng, 3)
    if look.chance(0.35):
        tile = glaze_tile(look, wax)
    wick = cylinder(0.0014, 0.016, 6).move(z=h - 0.004)
    flame = lathe([(0, 0), (0.0045, 0.008), (0.0035, 0.014), (0, 0.026)], 12).move(z=h + 0.008)
    fire = textures.gradient((255, 150, 40), (255, 236, 140), look.rng, 0)
    lit = [(wick, textures.plain((40, 36, 34))), (flame, fire)]
    tip = cylinder_part(0.003, 0.03, (0, 0, h))
    if look.chance(0.55):
        dish = lathe([(0, 0), (0.9 * r, 0), (1.5 * r, 0.01), (1.45 * r, 0.012), (0.9 * r, 0.004),
                      (0, 0.004)], 28)  # fmt: skip
        body = cylinder(r, h - 0.003, 28, bevel=0.002).move(z=0.003)
        metal = textures.brushed_metal(look.rng, look.own_color("gold", "silver", "black"))
        return shape(
            [(body, tile), (dish, metal), *lit],
            [hull_of(dish), cylinder_part(r, h - 0.003, (0, 0, 0.003)), tip],
        )
    glass = lathe([(0, 0), (r, 0), (1.05 * r, h + 0.012), (1.05 * r - 0.003, h + 0.012),
                   (r - 0.002, h - 0.004), (0, h - 0.004)], 28,
                  v=[0, 0, 0.9, 0.93, 0.98, 1])  # fmt: skip
    word = look.pick(["CALM", "FIG", "CEDAR", "ROSE", "AMBER", "SEA"])
    ink = look.own_color("charcoal", "gold", "teal", "brown", "navy")
    print_ = prints.label(look.rng, word, ink, look.pick([tint_color(wax, 1.3), (246, 244, 238)]))
    skin = textures.stack((print_, 90), (tile, 10), side=128)
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
        ("nightlight", "glow lamp"),
        ("living", "vanity", "play"),
        ("round",),
        ("yellow", "cream"),
    ),
    Category(
        "candle",
        candle,
        (0.075, 0.075, 0.12),
        0.2,
        ("scented candle", "pillar candle", "candle wick"),
        ("dining", "vanity", "living"),
        ("round",),
        ("cream", "white"),
    ),
)
