"""Meat and eggs by the piece: sausages, bacon, roast chicken, ham, legs, meatballs, fried eggs."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import speck, spread
from ...build.outlines import ellipse, smooth
from ...build.settled import crockery, hull_above, limb, rod, serve, settle
from ...build.shape import Shape, shape
from ...build.solids import cylinder, ellipsoid, join, lathe, loft, prism, torus
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import skin

BONE: RGB = (240, 230, 208)


def _roast(look: Look) -> textures.Tile:
    return skin(look, look.color("bronze", "copper", "amber"), (128, 66, 28), 0.9)


def sausage(look: Look) -> Shape:
    """A bent grilled sausage lying, its tied ends showing."""
    long, r = look.between(0.115, 0.145), look.between(0.0125, 0.0155)
    bend = look.between(0.006, 0.022)
    body = rod(long, r, bend=bend, blunt=8)
    knots = [ellipsoid(0.012, 0.008, 0.008, 8, 6).move(s * 0.51 * long, 0.5 * bend)
             for s in (-1, 1)]  # fmt: skip
    color = look.color("terracotta", "copper", "maroon", "brown")
    marks = [ellipsoid(0.02, 0.004, 0.004, 8, 5).turn(2, 0.7).move(u * long, bend * (
             4 * u * u - 0.5), 0.9 * r) for u in (-0.3, -0.15, 0.0, 0.15, 0.3)]  # fmt: skip
    meat = skin(look, color, tint_color(color, 0.66), 0.7)
    return settle([(join([body, *knots]), meat),
                   (join(marks), textures.plain(tint_color(color, 0.45)))], 0.1)  # fmt: skip


def bacon(look: Look) -> Shape:
    """A wavy rasher of streaky bacon lying flat."""
    long, y, t = look.between(0.17, 0.21), look.between(0.028, 0.036), 0.0028
    n = 30
    u, v = np.meshgrid(np.linspace(-0.5, 0.5, n), np.linspace(-0.5, 0.5, 4))
    wave = 0.0042 * (1 + np.sin(2 * np.pi * (3.5 * u + look.between(0, 1))))
    edge = 0.002 * np.sin(2 * np.pi * 2.3 * u)
    grid = np.stack([u * long, v * y + edge, wave], -1)
    solid = spread(grid, t)
    rows = np.linspace(0, 1, 64)[:, None] + 0.05 * textures.noise(look.rng, 64, 128, (2, 6), 2)
    fat = (np.sin(2 * np.pi * 2.2 * rows + 0.6) > 0.25)[..., None]
    color = look.color("crimson", "maroon", "terracotta")
    tile = np.where(fat, np.array((240, 206, 170)), np.array(tint_color(color, 0.9)))
    return settle([(solid, tile.astype(np.uint8))], 0.05)


def fried_egg(look: Look) -> Shape:
    """A fried egg lying flat, its yolk up."""
    r = look.between(0.045, 0.055)
    ring = ellipse(2, 2, 36)
    turn = np.arctan2(ring[:, 1], ring[:, 0])
    wave = 1 + 0.07 * np.sin(3 * turn + look.between(0, 6)) + 0.05 * np.sin(
        5 * turn + look.between(0, 6))  # fmt: skip
    levels = [(0.97, 0), (1.0, 0.002), (0.94, 0.0036), (0.5, 0.0046), (0.1, 0.0056)]
    white = loft(np.stack([np.column_stack([ring * (r * k * wave)[:, None], np.full(36, z)])
                           for k, z in levels]), ring)  # fmt: skip
    edge = textures.plain((222, 184, 120))
    pale = textures.speckles(look.rng, (248, 246, 240), 4)
    at = (look.between(-0.1, 0.1) * r, look.between(-0.1, 0.1) * r)
    yolk = ellipsoid(0.78 * r, 0.78 * r, 0.021, 24, 10).move(*at, 0.005)
    color = look.color("yellow", "orange", "amber")
    tile = textures.stack((edge, 12), (pale, 88))
    return shape([(white, tile), (yolk, textures.speckles(look.rng, color, 5))],
                 [hull_of(white), hull_above(yolk)])  # fmt: skip


def roast_chicken(look: Look) -> Shape:
    """A whole roast bird on an oval platter, legs to the right, lettuce round it."""
    k = look.between(0.9, 1.1)
    body = ellipsoid(0.19, 0.15, 0.12, 26, 16).move(z=0.075)
    breast = [ellipsoid(0.14, 0.085, 0.09, 18, 10).move(-0.02, s * 0.028, 0.1) for s in (-1, 1)]
    legs, ends = [], []
    for s in (-1, 1):
        legs.append(limb([(-0.01, s * 0.06, 0.075), (0.035, s * 0.068, 0.085),
                          (0.085, s * 0.05, 0.075), (0.118, s * 0.035, 0.07)],
                         [0.026, 0.032, 0.02, 0.0085], 12))  # fmt: skip
        legs.append(limb([(-0.05, s * 0.065, 0.07), (-0.02, s * 0.085, 0.055),
                          (-0.055, s * 0.088, 0.045)], [0.014, 0.014, 0.008], 10))  # fmt: skip
        ends.append(ellipsoid(0.02, 0.016, 0.016, 10, 6).move(0.125, s * 0.033, 0.069))
    plate = crockery(0.15, 0.024, deep=False).scale(1.08, 0.8, 1)
    greens = [ellipsoid(0.055, 0.035, 0.014, 10, 6).turn(2, 1.1 * n).move(
        0.12 * np.cos(n * 0.785), 0.085 * np.sin(n * 0.785), 0.02) for n in range(8)]  # fmt: skip
    bird = join([body, *breast, *legs])
    meat = _roast(look)
    dish = textures.plain(look.own_color("white", "cream", "sky"))
    leaf = textures.speckles(look.rng, (110, 156, 66), 14)
    return serve(look, plate, dish, [(bird, meat), (join(ends), textures.plain(BONE)),
                                      (join(greens), leaf)]).scale(k)  # fmt: skip


def ham(look: Look) -> Shape:
    """A ham lying: the pink cut face to the left, a scored rind, the bone."""
    long, r = look.between(0.16, 0.19), look.between(0.055, 0.065)
    joint = lathe([(0, 0), (0.93 * r, 0), (r, 0.1 * long), (0.97 * r, 0.42 * long),
                   (0.6 * r, 0.78 * long), (0.28 * r, 0.97 * long), (0, long)], 28)  # fmt: skip
    rows, columns = np.mgrid[0:128, 0:128]
    net = (((rows + columns) % 21) < 2) | (((rows - columns) % 21) < 2)
    color = look.color("copper", "terracotta", "bronze")
    rind = np.where(net[..., None], np.array(tint_color(color, 0.55)), np.array(color))
    cut = cylinder(0.88 * r, 0.003, 28).move(z=-0.001)
    face = textures.noise(look.rng, 96, 96, (4, 4), 2)[..., None] * 16
    pink = np.clip(np.array((232, 138, 132)) + face, 0, 255).astype(np.uint8)
    bone = cylinder(0.15 * r, long + 0.042, 14, bevel=0.003).move(z=-0.004)
    pieces = [(joint, rind.astype(np.uint8)), (cut, pink), (bone, textures.plain(BONE))]
    laid = [(s.turn(1, np.pi / 2 - 0.1).move(x=-0.5 * long), tile) for s, tile in pieces]
    return settle(laid, 0.08)


def chicken_leg(look: Look) -> Shape:
    """A roast drumstick lying, its bone to the right."""
    k = look.between(0.9, 1.12)
    meat = limb([(-0.058, 0, 0), (-0.05, 0, 0), (-0.03, 0, 0), (0, 0, 0), (0.03, 0, -0.004),
                 (0.045, 0, -0.007)], [0.006, 0.02, 0.029, 0.024, 0.012, 0.009], 16)  # fmt: skip
    bone = limb([(0.03, 0, -0.005), (0.06, 0, -0.011), (0.075, 0, -0.0125)],
                [0.0055, 0.005, 0.0065], 10)  # fmt: skip
    knobs = [ellipsoid(0.013, 0.012, 0.012, 10, 8).move(0.078, s * 0.0055, -0.013)
             for s in (-1, 1)]  # fmt: skip
    tip = join([bone, *knobs])
    return settle([(meat, _roast(look)), (tip, textures.plain(BONE))], 0.1).scale(k)


def meatball(look: Look) -> Shape:
    """A browned ball of minced meat."""
    d = look.between(0.03, 0.04)
    phase = look.rng.uniform(0, 6, 2)

    def bumps(p: np.ndarray) -> np.ndarray:
        wave = 0.035 * np.sin(p @ np.array([300, 220, 180]) + phase[0])
        return p * (1 + wave + 0.03 * np.sin(p @ np.array([-260, 320, 240]) + phase[1]))[:, None]

    color = look.color("brown", "brown", "copper")
    meat = textures.spots(look.rng, tint_color(color, 0.85), tint_color(color, 0.5), 0.2)
    return settle([(ellipsoid(d, d, 0.92 * d, 24, 14).bend(bumps), meat)], 0.12)


def salami(look: Look) -> Shape:
    """A salami cut open at its left end, with a few slices beside it."""
    long, r = look.between(0.12, 0.16), look.between(0.024, 0.03)
    body = lathe([(0, 0), (r, 0), (r, 0.86 * long), (0.7 * r, 0.96 * long), (0.15 * r, long),
                  (0, long)], 26)  # fmt: skip
    color = look.color("maroon", "crimson", "brown")
    face = textures.spots(look.rng, tint_color(color, 1.05), (240, 220, 206), 0.22)
    casing = textures.spots(look.rng, tint_color(color, 0.75), (214, 196, 186), 0.14)
    cut = cylinder(0.93 * r, 0.002, 26).move(z=-0.001)
    laid = [(s.turn(1, np.pi / 2).move(-0.3 * long, 0, r), t)
            for s, t in ((body, casing), (cut, face))]  # fmt: skip
    flat = [cylinder(r, 0.003, 26).move(-0.3 * long - (0.25 + 0.55 * n) * r, -(1.2 - 0.3 * n) * r,
            0.003 * n) for n in range(3)]  # fmt: skip
    return shape(
        [*((s, t) for s, t in laid), *((s, face) for s in flat)],
        [hull_of(laid[0][0]), *(hull_of(s) for s in flat)],
    )


def pork_ribs(look: Look) -> Shape:
    """A slab of ribs lying flat, bone ends along one side."""
    n, pitch = 6, look.between(0.02, 0.024)
    ribs, bones = [], []
    for k in range(n):
        x = (k - (n - 1) / 2) * pitch
        ribs.append(limb([(x - 0.004, -0.05, 0.008), (x, 0, 0.013), (x + 0.004, 0.05, 0.008)],
                         [0.011, 0.0135, 0.011], 10))  # fmt: skip
        bones.append(limb([(x - 0.004, -0.045, 0.008), (x - 0.008, -0.066, 0.0065)],
                          [0.0048, 0.0056], 8))  # fmt: skip
    glaze = speck(_roast(look), look.rng, (88, 40, 22), 60, 4)
    return settle([(join(ribs), glaze), (join(bones), textures.plain(BONE))], 0.12)


def chicken_nugget(look: Look) -> Shape:
    """A breaded nugget lying flat."""
    ring = smooth(np.array([(0.9, 0), (0.75, 0.62), (0, 0.72), (-0.8, 0.6), (-1, -0.1),
                            (-0.55, -0.66), (0.3, -0.62), (0.9, 0)]), 4)[:-1]  # fmt: skip
    k = look.between(0.022, 0.027)
    ring = ring * [k, k * look.between(0.85, 1.1)]
    body = prism(ring, 0, look.between(0.015, 0.019), 0.005)
    crumb = textures.spots(look.rng, look.color("amber", "tan", "bronze"), (166, 96, 36), 0.3)
    return shape([(body, crumb)], [hull_of(body)])


def onion_ring(look: Look) -> Shape:
    """A breaded ring lying flat."""
    r, t = look.between(0.026, 0.034), look.between(0.0075, 0.0095)
    ring = torus(r, t, 30, 10)
    crumb = textures.spots(look.rng, look.color("amber", "tan", "golden"), (166, 96, 36), 0.3)
    return settle([(ring, crumb)], 0.15)


CATEGORIES = (
    Category("sausage", sausage, (0.148, 0.0381, 0.0263), 0.08, ("bratwurst", "frankfurter",
             "grilled sausage", "sausage link", "wiener", "chorizo"), ("breakfast", "dining"),
             ("edible",), ("brown",), state="lying flat"),
    Category("bacon", bacon, (0.198, 0.0359, 0.0106), 0.02, ("bacon strip", "bacon slice",
             "bacon rasher", "rasher", "slice of bacon", "strip of bacon", "rasher of bacon",
             "piece of bacon"), ("breakfast",), ("edible", "flat"), (), state="lying flat"),
    Category("fried_egg", fried_egg, (0.101, 0.103, 0.0155), 0.05, ("sunny side up egg",
             "egg sunny side up"), ("breakfast",), ("edible", "flat", "round"), ("yellow",),
             state="lying flat"),
    Category("roast_chicken", roast_chicken, (0.321, 0.238, 0.144), 1.6, ("turkey", "roast turkey",
             "whole chicken", "roasted chicken", "roasted turkey", "thanksgiving turkey", "chicken",
             "roast duck", "roast goose", "rotisserie chicken", "cooked chicken"), ("dining",),
             ("edible", "big"), ("amber",)),
    Category("ham", ham, (0.216, 0.12, 0.114), 1.5, ("ham joint", "gammon", "baked ham",
             "leg of ham", "roast ham"), ("dining",), ("edible", "big"), (), state="lying flat"),
    Category("chicken_leg", chicken_leg, (0.146, 0.0595, 0.0536), 0.12, ("chicken drumstick",
             "turkey leg", "fried chicken", "chicken thigh", "chicken wing"),
             ("dining",), ("edible",), ("amber",), state="lying flat"),
    Category("meatball", meatball, (0.0348, 0.0351, 0.0288), 0.03, ("swedish meatball",),
             ("dining",), ("edible", "round"), ("brown",)),
    Category("salami", salami, (0.206, 0.0871, 0.0542), 0.25, ("pepperoni", "salami sausage",
             "cured sausage", "cold cuts", "dry sausage"), ("kitchen",), ("edible",), ("maroon",),
             state="lying flat"),
    Category("ribs", pork_ribs, (0.14, 0.119, 0.0248), 0.45, ("pork ribs", "spare ribs",
             "rack of ribs", "barbecue ribs", "bbq ribs", "slab of ribs", "pork rib"),
             ("dining",), ("edible",), (), state="lying flat"),
    Category("chicken_nugget", chicken_nugget, (0.046, 0.0341, 0.0168), 0.018, ("nugget",
             "chicken bite"), ("dining",), ("edible",), ("amber",), state="lying flat"),
    Category("onion_ring", onion_ring, (0.0771, 0.0775, 0.0132), 0.02, ("fried onion ring",
             "fried calamari"), ("dining",), ("edible", "round", "flat"), ("amber",),
             state="lying flat"),
)  # fmt: skip
"""The module's categories."""
