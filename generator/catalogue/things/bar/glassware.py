"""Glasses and bottles for special drinks: cocktails, champagne, beer, spirits, milk, soda."""

from __future__ import annotations

import numpy as np

from ....scene import ConvexPart
from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, ring_parts
from ...build.outlines import smooth
from ...build.recipes import open_vessel
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, cylinder, ellipsoid, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..kitchen.bottles import label_skin, vessel, vessel_parts

Pieces = list[tuple[Solid, textures.Tile]]
WORDS = ("COLA", "FIZZ", "LIME", "ORANGE", "TONIC", "CHERRY", "BERRY", "ROOT")


def _stem_profile(
    side: list[tuple[float, float]], foot: float, wet: tuple[RGB, float], clear: textures.Tile
) -> tuple[Pieces, list[ConvexPart]]:
    """Return a on_stem glass whose cup has the outside ``side``, filled to a share of it."""
    (low, cup), (rim, h) = side[0], side[-1]
    outer = np.array(side)
    inner = np.column_stack([np.maximum(outer[:, 0] - 0.0022, 0.001), outer[:, 1] + 0.003])[::-1]
    inner[0, 1] = h
    stem = [(0, 0), (foot, 0), (foot, 0.0016), (0.006, 0.008), (0.0038, 0.03), (0.0038, cup - 0.01)]
    n, (drink, share) = len(outer), wet
    up = 0.2 + 0.35 * (outer[:, 1] - cup) / (h - cup)
    body = lathe([*stem, *outer, *inner, (0, cup + 0.003)], 28,
                 v=[*np.linspace(0, 0.18, 6), *up, *np.linspace(0.56, 0.99, n), 1])  # fmt: skip
    shown = textures.stack((clear, 0.2), (textures.plain(drink), 0.35 * share),
                             (clear, 0.8 - 0.35 * share), side=128)  # fmt: skip
    level = cup + 0.004 + share * (h - cup)
    below = [
        (max(float(r) - 0.003, 0.0012), float(z) + 0.004) for r, z in outer if z + 0.004 < level
    ]
    top = max(float(np.interp(level, outer[:, 1] + 0.004, outer[:, 0])) - 0.003, 0.002)
    fill = lathe([(0, below[0][1]), *below, (top, level), (0, level)], 24)
    wedges = ring_parts([(low, cup), *side[len(side) // 2 : -1][:2], (rim, h)],
                        [(rim - 0.0022, h), (max(low - 0.002, 0.002), cup + 0.003)])  # fmt: skip
    return [(body, shown), (fill, textures.plain(drink))], [
        *wedges, cylinder_part(foot, 0.004), cylinder_part(0.0042, cup, (0, 0, 0.002)),
    ]  # fmt: skip


def cocktail_glass(look: Look) -> Shape:
    """A martini glass or a coupe with a drink and a garnish: an olive, a cherry, a lime wheel."""
    r, h = look.between(0.046, 0.056), look.between(0.15, 0.18)
    color = look.color("clear", "clear", "sky", "pink", "mint", "amber")
    drink = look.pick([(220, 226, 200), (230, 110, 130), (240, 160, 60), (90, 180, 200),
                       (130, 190, 90), (200, 40, 50)])  # fmt: skip
    cup = 0.55 * h
    if look.chance(0.7):
        side = [(0.005, cup), (0.35 * r, cup + 0.33 * (h - cup)), (0.7 * r, cup + 0.68 * (h - cup)),
                (r, h)]  # fmt: skip
    else:
        t = np.linspace(0, 1, 6)
        side = [(max(r * float(np.sin(np.pi / 2 * min(1.3 * u, 1))), 0.005),
                 cup + (0.3 + 0.1 * u) * 0 + u**1.6 * 0.8 * (h - cup)) for u in t]  # fmt: skip
        side.append((1.02 * r, h))
    pieces, parts = _stem_profile(
        side, 0.72 * r, (drink, 0.72), textures.plain(tint_color(color, 1.2))
    )
    kind, z = look.pick(["olive", "cherry", "lime", "none"]), h - 0.012
    stick = tube([(-0.02, 0, z - 0.01), (0.9 * r, 0.01, h + 0.012)], 0.0012, 6)
    if kind in ("olive", "cherry"):
        ball = ellipsoid(0.017, 0.017, 0.02, 14, 8).move(-0.004, 0, z)
        tone = (120, 140, 50) if kind == "olive" else (180, 20, 36)
        pieces += [(ball, textures.plain(tone)), (stick, textures.plain((220, 190, 130)))]
    elif kind == "lime":
        wheel = cylinder(0.02, 0.004, 20).turn(0, np.pi / 2).move(0.93 * r, 0, h)
        pieces.append((wheel, textures.plain((140, 190, 60))))
    return shape(pieces, parts, opacity=0.6)


def champagne_flute(look: Look) -> Shape:
    """A tall, slim on_stem glass, often with sparkling wine."""
    r, h = look.between(0.024, 0.029), look.between(0.2, 0.24)
    color = look.color("clear", "clear", "sky", "pink", "amber", "mint")
    cup = look.between(0.36, 0.42) * h
    t = np.linspace(0, 1, 7)
    bulge = look.pick([0.0, 0.14])
    side = [(float(0.006 + (r - 0.006) * (np.sin(np.pi / 2 * min(1.5 * u, 1)) + bulge
                                         * np.sin(np.pi * u))), float(cup + (h - cup) * u))
            for u in t]  # fmt: skip
    wine = look.pick([(238, 208, 120), (244, 176, 160), (238, 214, 140)])
    pieces, parts = _stem_profile(side, 1.15 * r, (wine, look.between(0.4, 0.85)),
                             textures.plain(tint_color(color, 1.2)))  # fmt: skip
    return shape(pieces, parts, opacity=0.55)


def beer_mug(look: Look) -> Shape:
    """A heavy glass mug of beer with a head of foam, or a stoneware stein."""
    r, h = look.between(0.042, 0.05), look.between(0.13, 0.165)
    color = look.color("amber", "gold", "amber", "brown", "mustard")
    stein = look.chance(0.2)
    body, parts = open_vessel([(1.02 * r, 0), (r, 0.1 * h), (0.98 * r, 0.6 * h), (r, h)], 0.005,
                              0.012, 14 if not stein else 28)  # fmt: skip
    ear = tube(smooth([(0.95 * r, 0, 0.86 * h), (r + 0.04, 0, 0.84 * h), (r + 0.042, 0, 0.3 * h),
                       (0.97 * r, 0, 0.2 * h)], 5), 0.008, 10)  # fmt: skip
    lug = box_part(0.03, 0.016, 0.6 * h, (r + 0.028, 0, 0.22 * h))
    if stein:
        grey = look.surface(tint_color(color, 1.2), "stoneware")
        other = prints.canvas(128, 64, tint_color(color, 1.2))
        prints.fill(other, 0, 0.1, 1, 0.08, (40, 60, 120))
        prints.fill(other, 0, 0.8, 1, 0.08, (40, 60, 120))
        prints.disc(other, 0.5, 0.5, 0.24, (40, 60, 120))
        skin = textures.stack((other, 50), (grey, 50), side=128)
        return shape([(body, skin), (ear, grey)], [*parts, lug])
    clear = textures.plain((214, 226, 230))
    foam = textures.spots(look.rng, (250, 244, 226), (232, 220, 190), 0.08)
    beer = textures.stack((clear, 0.03), (textures.plain(color), 0.37), (clear, 0.6), side=128)
    tall = look.between(1.05, 1.12) * h
    head = lathe([(0, 0.76 * h), (0.84 * r, 0.76 * h), (0.86 * r, h), (0.6 * r, 0.98 * tall),
                  (0, tall)], 24)  # fmt: skip
    return shape([(body, beer), (ear, clear), (head, foam)],
                 [*parts, lug, hull_of(head)], opacity=0.75)  # fmt: skip


def shot_glass(look: Look) -> Shape:
    """A small thick glass for spirits."""
    r, h = look.between(0.021, 0.025), look.between(0.05, 0.066)
    color = look.color("clear", "clear", "clear", "sky", "amber", "green", "red")
    body, parts = open_vessel([(0.76 * r, 0), (0.84 * r, 0.35 * h), (0.92 * r, 0.7 * h), (r, h)],
                              0.0025, 0.011, look.pick([24, 24, 8]))  # fmt: skip
    clear = textures.plain(tint_color(color, 1.15))
    pieces: Pieces = [(body, clear)]
    if look.chance(0.6):
        drink = look.pick([(214, 140, 50), (236, 240, 240), (120, 40, 30), (90, 160, 90)])
        wet, top = textures.plain(drink), 0.78 * h
        pieces = [(body, textures.stack((clear, 0.06), (wet, 0.31), (clear, 0.63), side=128))]
        pieces.append((lathe([(0, 0.0115), (0.6 * r, 0.0115), (0.78 * r, top), (0, top)], 18),
                       wet))  # fmt: skip
    return shape(pieces, parts, opacity=0.6)


def beer_bottle(look: Look) -> Shape:
    """A bottle of beer: brown, green or clear glass, a paper label, a crown cap."""
    r, h = look.between(0.029, 0.032), look.between(0.215, 0.25)
    color = look.color("brown", "brown", "green", "amber", "olive")
    long = look.chance(0.6)
    shoulder, rise = (0.56, 0.74) if long else (0.6, 0.7)
    body = vessel(r, h, 0.0125, shoulder * h, rise * h)
    word = look.pick(["LAGER", "ALE", "STOUT", "PILS", "IPA", "BOCK"])
    ground = look.pick([(244, 238, 216), (196, 42, 40), (40, 90, 60), (230, 190, 90), (36, 50, 92)])
    skin = label_skin(look, tint_color(color, 0.8), word, 0.13, 0.47, ground)
    band = textures.plain(tint_color(ground, 0.9))
    skin[int(0.16 * len(skin)) : int(0.22 * len(skin))] = band[0, 0]
    cap = lathe([(0, h - 0.003), (0.0145, h - 0.003), (0.0138, h + 0.003), (0.01, h + 0.0045),
                 (0, h + 0.0045)], 21)  # fmt: skip
    tone = look.own_color("gold", "silver", "red", "navy", "green", "black")
    ribs = textures.stripes([tone, tint_color(tone, 0.7)], 21, upright=True, side=84)
    flat = textures.stack((ribs, 50), (textures.plain(tone), 50))
    return shape(
        [(body, skin), (cap, flat)],
        [*vessel_parts(body, r, shoulder * h, 0.0125, h, rise * h), hull_of(cap)],
    )


def milk_bottle(look: Look) -> Shape:
    """A glass bottle of milk with a wide mouth and a foil or a swing lid."""
    r, h = look.between(0.036, 0.042), look.between(0.19, 0.23)
    milk = look.color("white", "white", "cream", "pink", "tan", "brown", spread=4)
    neck = 0.55 * r
    body = vessel(r, h, neck, 0.52 * h, 0.76 * h)
    glass = textures.plain((212, 224, 228))
    skin = textures.stack((textures.plain(milk), 0.8), (glass, 0.2), side=192)
    sign = prints.canvas(192, 64, milk)
    ink = look.own_color("blue", "red", "green", "navy", "teal")
    if sum(milk) < 480:
        ink = (246, 244, 238)
    prints.write(
        sign[:, 72:120], look.pick(["MILK", "FRESH", "DAIRY"]), 0.5, 0.35, 0.4, ink, bold=True
    )
    prints.fill(sign, 0.4, 0.66, 0.2, 0.06, ink)
    skin = textures.fit(skin, 192, 192).copy()
    skin[96:160] = sign
    tone = look.own_color("silver", "red", "blue", "gold", "green", "white")
    lid = lathe(
        [
            (0, h - 0.012),
            (neck + 0.002, h - 0.012),
            (neck + 0.003, h),
            (neck - 0.002, h + 0.003),
            (0, h + 0.002),
        ],
        28,
    )
    collar = torus(neck, 0.0022, 28, 6).move(z=0.86 * h)
    return shape([(body, skin), (lid, textures.speckles(look.rng, tone, 8, 32)), (collar, glass)],
                 [*vessel_parts(body, r, 0.52 * h, neck, h, 0.76 * h), hull_of(lid)])  # fmt: skip


def soda_can(look: Look) -> Shape:
    """An aluminium can of soda or an energy drink, necked at both ends, with its pull tab."""
    slim = look.chance(0.3)
    r, h = (0.0265, look.between(0.134, 0.16)) if slim else (0.033, look.between(0.115, 0.125))
    color = look.color("red", "blue", "green", "orange", "silver", "purple", "black", "yellow",
                       "cyan", "pink")  # fmt: skip
    ground = look.pick(
        [(240, 240, 240), tint_color(color, 0.6), tint_color(color, 1.5), (206, 210, 214)]
    )
    art = prints.label(look.rng, look.pick(WORDS), color, ground)
    steel = textures.brushed_metal(look.rng, (200, 203, 208))
    body = lathe(
        [(0, 0.006), (0.72 * r, 0.004), (0.8 * r, 0), (0.84 * r, 0.001), (r, 0.012), (r, h - 0.015),
         (0.84 * r, h - 0.003), (0.86 * r, h), (0.8 * r, h), (0.77 * r, h - 0.004), (0, h - 0.004)],
        30, v=[0, 0.01, 0.015, 0.02, 0.1, 0.88, 0.965, 0.97, 0.98, 0.99, 1],
    )  # fmt: skip
    tile = textures.stack((steel, 5), (art, 88), (steel, 7), side=160)
    z = h - 0.0042
    tab = [block(0.012, 0.022, 0.0014, 0.005).move(y=-0.004, z=z + 0.001),
           cylinder(0.0035, 0.003, 10).move(z=z)]  # fmt: skip
    mouth = cylinder(0.008, 0.0006, 16).move(y=-0.011, z=z - 0.0002)
    return shape(
        [(body, tile), (join(tab), steel), (mouth, textures.plain((150, 152, 158)))],
        [cylinder_part(r, h - 0.027, (0, 0, 0.012)), cylinder_part(0.85 * r, h)],
    )


CATEGORIES = (
    Category("cocktail_glass", cocktail_glass, (0.104, 0.104, 0.165), 0.2, ("martini glass",
             "margarita glass", "cocktail", "martini", "margarita", "coupe glass", "coupe"),
             ("dining",), ("round", "tall"), ("clear",)),
    Category("champagne_flute", champagne_flute, (0.064, 0.064, 0.22), 0.16, ("champagne glass",
                 "flute glass", "prosecco glass", "glass of champagne", "sparkling wine glass",
                 "mimosa", "bellini"),
             ("dining",), ("round", "tall"), ("clear",)),
    Category("beer_mug", beer_mug, (0.14, 0.096, 0.155), 0.9, ("beer stein", "tankard", "stein",
             "glass of beer", "mug of beer", "beer tankard"), ("dining",), ("round", "tall"),
             ("amber",)),
    Category("shot_glass", shot_glass, (0.046, 0.046, 0.058), 0.09, ("tequila glass",
                 "vodka glass", "schnapps glass", "shot of tequila", "tequila shot",
                 "shot of vodka"), ("dining",), ("round", "container"), ("clear",)),
    Category("beer_bottle", beer_bottle, (0.061, 0.061, 0.235), 0.55, ("bottle of beer",
             "lager bottle", "beer"), ("dining", "kitchen"), ("tall", "round"), ("brown",
             "green")),
    Category("milk_bottle", milk_bottle, (0.078, 0.078, 0.21), 0.95, ("bottle of milk",
             "glass milk bottle"), ("kitchen", "dining", "breakfast"), ("tall", "round"),
             ("white",)),
    Category("soda_can", soda_can, (0.062, 0.062, 0.13), 0.36, ("can of soda", "coke can",
             "cola can", "can of cola", "can of coke", "pop can", "fizzy drink can", "aluminum can",
             "aluminium can", "soft drink", "coke", "soda", "cola", "pepsi"), ("kitchen", "dining",
             "office",
             "gaming"), ("round", "tall"), ("red", "blue")),
)  # fmt: skip
"""The module's categories."""
