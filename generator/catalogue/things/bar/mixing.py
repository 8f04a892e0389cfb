"""Things for mixing and serving drinks: shakers, jiggers, muddlers, tumblers, flasks, cans."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, ring_parts
from ...build.outlines import smooth
from ...build.recipes import open_vessel
from ...build.settled import limb, settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, tube
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.contents import contents
from ...surfaces.look import Look
from ..kitchen.bottles import label_skin, vessel, vessel_parts


def _metal(look: Look) -> textures.Tile:
    return look.surface(look.color("silver", "silver", "gold", "copper", "black"), "metal")


def cocktail_shaker(look: Look) -> Shape:
    """A three-piece cocktail shaker of steel."""
    r, h = look.between(0.04, 0.046), look.between(0.2, 0.24)
    skin = _metal(look)
    body = lathe([(0, 0), (0.72 * r, 0), (0.76 * r, 0.02 * h), (r, 0.62 * h), (0, 0.62 * h)], 36)
    cap = lathe([(0, 0.62 * h), (1.03 * r, 0.62 * h), (1.02 * r, 0.68 * h), (0.7 * r, 0.8 * h),
                 (0.5 * r, 0.85 * h), (0, 0.85 * h)], 36)  # fmt: skip
    top = lathe([(0, 0.84 * h), (0.48 * r, 0.84 * h), (0.5 * r, 0.87 * h), (0.44 * r, 0.98 * h),
                 (0.3 * r, h), (0, h)], 30)  # fmt: skip
    return shape([(body, skin), (cap, skin), (top, skin)],
                 [hull_of(body), hull_of(cap), hull_of(top)])  # fmt: skip


def jigger(look: Look) -> Shape:
    """A double jigger: two cones joined at their tips, open above."""
    r, h = look.between(0.02, 0.024), look.between(0.075, 0.095)
    skin = _metal(look)
    side = [(0.86 * r, 0), (0.88 * r, 0.004), (0.3 * r, 0.42 * h), (0.3 * r, 0.46 * h), (r, h)]
    inner = [(r - 0.0012, h), (0.24 * r, 0.52 * h)]
    body = lathe([(0, 0), *side, *inner, (0, 0.5 * h)], 30)
    low = lathe([(0, 0), *side[:3], (0, 0.42 * h)], 20)
    walls = ring_parts([(0.3 * r, 0.44 * h), (r, h)], [(r - 0.0012, h), (0.24 * r, 0.5 * h)], 10)
    return shape(
        [(body, skin)], [hull_of(low), *walls, cylinder_part(0.28 * r, 0.09 * h, (0, 0, 0.42 * h))]
    )


def muddler(look: Look) -> Shape:
    """A muddler lying: a stick with a thick ribbed end to the left."""
    long, r = look.between(0.19, 0.23), look.between(0.014, 0.017)
    wood = look.surface(look.color("wooden", "brown", "black", "silver"), "wood")
    body = limb(
        [
            (-0.5 * long, 0, 0),
            (-0.45 * long, 0, 0),
            (-0.3 * long, 0, 0),
            (0, 0, 0),
            (0.4 * long, 0, 0),
            (0.46 * long, 0, 0),
            (0.5 * long, 0, 0),
        ],
        [0.8 * r, r, 0.96 * r, 0.72 * r, 0.78 * r, 0.74 * r, 0.4 * r],
        18,
    )
    rings = [cylinder(1.02 * r, 0.002, 20).turn(1, np.pi / 2).move(x=(-0.45 + 0.03 * k) * long)
             for k in range(3)]  # fmt: skip
    dark = textures.plain((70, 48, 34))
    return settle([(body, wood), (join(rings), dark)], 0.1)


def ice_tongs(look: Look) -> Shape:
    """Small tongs bent from one strip, toothed at their ends, lying on their side."""
    long = look.between(0.14, 0.17)
    skin = _metal(look)
    path = smooth(
        [
            (-0.5 * long, -0.012, 0),
            (-0.2 * long, -0.02, 0),
            (0.3 * long, -0.018, 0),
            (0.47 * long, -0.009, 0),
            (0.5 * long, 0, 0),
            (0.47 * long, 0.009, 0),
            (0.3 * long, 0.018, 0),
            (-0.2 * long, 0.02, 0),
            (-0.5 * long, 0.012, 0),
        ],
        3,
    )
    flat = tube(path, 0.0013, 6).scale(1, 1, 5.5)
    teeth = [box(0.004, 0.006, 0.012).move((-0.49 + 0.03 * k) * long, s * 0.012, -0.006)
             for k in range(3) for s in (-1, 1)]  # fmt: skip
    return settle([(join([flat, *teeth]), skin)], 0.02)


def _open_glass(look: Look, side: list[tuple[float, float]], wall: float, bottom: float,
                sides: int = 32) -> Shape:  # fmt: skip
    color = look.color("clear", "clear", "clear", "sky", "amber")
    clear = textures.plain(tint_color(color, 1.15))
    drink = look.pick([(222, 150, 50), (214, 146, 40), (196, 222, 234), (196, 222, 234)])
    full = look.chance(0.5)
    body, parts = open_vessel(side, wall, bottom, sides)
    h = side[-1][1]
    level = 0.62 * h
    at = float(np.interp(level, [z for _, z in side], [r for r, _ in side])) - wall + 0.0004
    said = contents(look, at, level)
    pieces = [(body, clear)]
    if said is not None:
        pieces += said
    elif full:
        low = side[0][0] - wall
        fill = lathe([(0, bottom), (low, bottom), (at, level), (0, level)], 26)
        pieces.append((fill, textures.plain(drink)))
    return shape(pieces, parts, opacity=0.7)


def pint_glass(look: Look) -> Shape:
    """A tall glass widening to its rim, with or without beer."""
    r, h = look.between(0.041, 0.046), look.between(0.145, 0.165)
    side = [(0.7 * r, 0), (0.78 * r, 0.3 * h), (0.9 * r, 0.7 * h), (r, h)]
    return _open_glass(look, side, 0.003, 0.01)


def whiskey_glass(look: Look) -> Shape:
    """A low heavy tumbler with a thick bottom, round or faceted."""
    r, h = look.between(0.039, 0.045), look.between(0.08, 0.095)
    side = [(0.88 * r, 0), (0.93 * r, 0.3 * h), (0.97 * r, 0.7 * h), (r, h)]
    return _open_glass(look, side, 0.004, 0.016, look.pick([10, 12, 32]))


def hip_flask(look: Look) -> Shape:
    """A curved flat flask of steel or leather, standing."""
    x, h = look.between(0.088, 0.1), look.between(0.11, 0.13)
    color = look.color("silver", "brown", "black", "silver", "maroon", "navy")
    skin = look.surface(color, "metal")
    body = block(x, 0.026, 0.82 * h, 0.0125, 0.008, 5)
    body = body.bend(lambda p: p + np.column_stack([0 * p[:, 0], 2.4 * p[:, 0] ** 2, 0 * p[:, 0]]))
    neck = cylinder(0.0095, 0.1 * h, 18).move(y=0.001, z=0.81 * h)
    cap = cylinder(0.0125, 0.11 * h, 20, bevel=0.001).move(y=0.001, z=0.89 * h)
    band = block(0.99 * x, 0.0275, 0.44 * h, 0.0127, 0.0, 5).move(z=0.16 * h)
    band = band.bend(lambda p: p + np.column_stack([0 * p[:, 0], 2.4 * p[:, 0] ** 2, 0 * p[:, 0]]))
    leather = textures.spots(
        look.rng, look.own_color("brown", "black", "maroon"), (60, 40, 30), 0.1
    )
    pieces = [(body, skin), (join([neck, cap]), textures.brushed_metal(look.rng, (196, 199, 204)))]
    if look.chance(0.5):
        pieces.append((band, leather))
    return shape(pieces, [hull_of(body), hull_of(neck, cap)])


def cork(look: Look) -> Shape:
    """A wine cork standing, or a champagne cork with its head."""
    r, h = look.between(0.0105, 0.0125), look.between(0.04, 0.05)
    color = look.color("tan", "beige", "wooden")
    tile = textures.spots(look.rng, color, tint_color(color, 0.7), 0.12)
    if look.chance(0.6):
        body = cylinder(r, h, 24, bevel=0.0008)
        return shape([(body, tile)], [cylinder_part(r, h)])
    body = lathe(
        [
            (0, 0),
            (1.15 * r, 0),
            (1.25 * r, 0.1 * h),
            (1.05 * r, 0.5 * h),
            (r, 0.6 * h),
            (1.35 * r, 0.66 * h),
            (1.4 * r, 0.8 * h),
            (1.0 * r, 0.98 * h),
            (0, h),
        ],
        26,
    )
    return shape([(body, tile)], [hull_of(body)])


def bottle_cap(look: Look) -> Shape:
    """A crown cap lying, its crimped edge down."""
    r, h = look.between(0.0145, 0.0165), look.between(0.0058, 0.007)
    color = look.color("red", "gold", "blue", "green", "silver", "black", "white")
    t = 42
    body = lathe([(0, 0), (r, 0), (0.93 * r, 0.5 * h), (0.85 * r, 0.92 * h), (0, h)], t)

    def crimp(p: np.ndarray) -> np.ndarray:
        wave = 1 + 0.05 * np.cos(21 * np.arctan2(p[:, 1], p[:, 0])) * (1 - p[:, 2] / h)
        return p * np.column_stack([wave, wave, np.ones(len(p))])

    face = prints.canvas(64, 64, color)
    prints.disc(face, 0.5, 0.5, 0.34, tint_color(color, 1.5), 0.3)
    prints.write(face, look.pick(["ALE", "A", "CO", "IPA"]), 0.5, 0.5, 0.3, readable_on(color))
    top = cylinder(0.8 * r, 0.0005, 28).move(z=0.93 * h)
    return shape([(body.bend(crimp), textures.brushed_metal(look.rng, color)), (top, face)],
                 [hull_of(body)])  # fmt: skip


def _can(look: Look, r: float, h: float, word: str, palette: tuple[str, ...]) -> Shape:
    color = look.color(*palette)
    ground = look.pick([(244, 242, 234), (40, 42, 48), (226, 190, 90)])
    image = prints.label(look.rng, word, color, ground)
    steel = textures.plain((206, 209, 214))
    tile = textures.stack((steel, 6), (image, 84), (steel, 10), side=192)
    body = lathe([(0, 0.002), (0.8 * r, 0), (r, 0.06 * h), (r, 0.9 * h), (0.84 * r, 0.975 * h),
                  (0.85 * r, h), (0.8 * r, h), (0.76 * r, 0.975 * h), (0, 0.975 * h)], 32,
                 v=[0, 0.01, 0.06, 0.9, 0.97, 0.98, 0.985, 0.99, 1])  # fmt: skip
    tab = block(0.013, 0.02, 0.0014, 0.006).move(y=-0.004, z=0.975 * h)
    return shape([(body, tile), (tab, textures.plain((180, 184, 190)))], [hull_of(body)])


def beer_can(look: Look) -> Shape:
    """A can of beer."""
    return _can(look, 0.033, look.between(0.12, 0.165), look.pick(["BEER", "LAGER", "PILS", "IPA"]),
                ("green", "gold", "red", "navy", "white", "black"))  # fmt: skip


def energy_drink(look: Look) -> Shape:
    """A slim can of energy drink."""
    return _can(
        look,
        look.between(0.0255, 0.0275),
        look.between(0.13, 0.15),
        look.pick(["ENERGY", "POWER", "BOOST", "VOLT"]),
        ("blue", "black", "lime", "red", "silver"),
    )


def beer_mat(look: Look) -> Shape:
    """A printed mat of pulpboard, round or square."""
    x, h = look.between(0.09, 0.105), look.between(0.003, 0.004)
    color = look.color("red", "green", "navy", "gold", "white", "maroon")
    face = prints.canvas(128, 128, (244, 240, 228))
    prints.disc(face, 0.5, 0.5, 0.44, color)
    prints.disc(face, 0.5, 0.5, 0.38, (244, 240, 228), 0.36)
    prints.write(face, look.pick(["BEER", "ALE", "BRAU", "PUB"]), 0.5, 0.5, 0.22,
                 readable_on(color), bold=True)  # fmt: skip
    if look.chance(0.5):
        return shape([(cylinder(x / 2, h, 36), face)], [cylinder_part(x / 2, h)])
    return shape([(block(x, x, h, 0.01), face)], [box_part(x, x, h)])


def whiskey_bottle(look: Look) -> Shape:
    """A square-shouldered bottle of spirits with a label and a stopper."""
    r, h = look.between(0.038, 0.044), look.between(0.23, 0.27)
    color = look.color("amber", "bronze", "clear", "green", "brown", "amber")
    body = vessel(r, h, 0.0135, 0.62 * h, 0.74 * h, sides=look.pick([8, 32]))
    word = look.pick(["WHISKY", "RUM", "GIN", "VODKA", "BRANDY"])
    skin = label_skin(look, color, word, 0.14, 0.46, look.pick([(244, 238, 220), (34, 34, 38)]))
    cap = cylinder(0.017, 0.034, 22, bevel=0.002).move(z=h - 0.012)
    tone = textures.plain(look.own_color("black", "gold", "brown", "red"))
    return shape(
        [(body, skin), (cap, tone)],
        [*vessel_parts(body, 0.92 * r, 0.62 * h, 0.0135, h, 0.74 * h), hull_of(cap)],
    )


def milkshake(look: Look) -> Shape:
    """A tall glass of milkshake: cream, a cherry and a straw."""
    r, h = look.between(0.038, 0.044), look.between(0.15, 0.175)
    color = look.color("pink", "brown", "cream", "mint", "orange", "purple", "green")
    clear = textures.plain((222, 230, 234))
    body = lathe(
        [
            (0, 0),
            (0.75 * r, 0),
            (0.6 * r, 0.06 * h),
            (0.68 * r, 0.14 * h),
            (0.82 * r, 0.5 * h),
            (r, h),
            (0, h),
        ],
        30,
        v=[0, 0.01, 0.06, 0.14, 0.5, 0.97, 1],
    )
    tile = textures.stack((clear, 13), (textures.plain(color), 77), (clear, 10), side=128)
    cream = [ellipsoid(1.5 * r * k, 1.5 * r * k, 0.9 * r * k, 20, 10).move(z=h + z * r)
             for k, z in ((1.0, 0.05), (0.75, 0.4), (0.45, 0.7))]  # fmt: skip
    cherry = ellipsoid(0.018, 0.018, 0.018, 14, 8).move(z=h + 1.02 * r)
    pipe = tube([(0.4 * r, 0.1 * r, 0.6 * h), (0.75 * r, 0.25 * r, h + 0.065)], 0.0036, 8)
    stripes = textures.stripes([look.own_color("red", "sky", "pink"), (250, 248, 244)], 8)
    return shape([(body, tile), (join(cream), textures.plain((252, 248, 240))),
                  (cherry, textures.plain((196, 30, 44))), (pipe, stripes)],
                 [hull_of(body), hull_of(*cream, cherry), hull_of(pipe)])  # fmt: skip


_B = ("dining",)
CATEGORIES = (
    Category("cocktail_shaker", cocktail_shaker, (0.0897, 0.0897, 0.218), 0.35, ("drink shaker",
             "martini shaker", "bar shaker"), _B, ("tall", "round"), ("silver",)),
    Category("jigger", jigger, (0.0436, 0.0438, 0.0888), 0.08, ("bar jigger", "spirit measure",
             "shot measure", "measuring jigger"), _B, ("round", "tall"), ("silver",)),
    Category("muddler", muddler, (0.207, 0.0319, 0.0288), 0.08, ("cocktail muddler",), _B, (),
             ("wooden",), state="lying flat"),
    Category("ice_tongs", ice_tongs, (0.155, 0.0433, 0.0121), 0.05, ("sugar tongs", "bar tongs",
             "ice cube tongs", "sugar tong"), _B, (), ("silver",), state="lying flat"),
    Category("pint_glass", pint_glass, (0.0897, 0.0897, 0.152), 0.35, ("pint", "beer glass",
             "pint of beer", "highball glass", "long drink glass"), _B, ("container", "round",
             "tall"), ("clear",)),
    Category("whiskey_glass", whiskey_glass, (0.0813, 0.0834, 0.0872), 0.3, ("whisky glass",
             "tumbler", "whisky tumbler", "rocks glass", "old fashioned glass", "whiskey tumbler",
             "glass of whiskey", "glass of whisky"), _B, ("container", "round"), ("clear",)),
    Category("hip_flask", hip_flask, (0.0918, 0.0273, 0.12), 0.15, ("pocket flask", "whiskey flask",
             "powder horn"), _B, (), ("silver", "brown")),
    Category("cork", cork, (0.0276, 0.0277, 0.0463), 0.005, ("wine cork", "champagne cork",
             "bottle cork", "bottle stopper", "wine stopper", "champagne stopper", "rubber bung",
             "cork stopper", "glass stopper", "bung"), _B, ("round",), ("tan",)),
    Category("bottle_cap", bottle_cap, (0.0308, 0.0309, 0.00633), 0.002, ("crown cap", "beer cap",
             "bottle top", "beer bottle cap"), _B, ("round", "flat"), ("red", "gold"),
             state="lying flat"),
    Category("beer_can", beer_can, (0.066, 0.066, 0.149), 0.5, ("can of beer", "beer tin",
             "lager can", "tin of beer"), _B, ("round", "tall"), ("green", "gold")),
    Category("energy_drink", energy_drink, (0.0526, 0.0526, 0.144), 0.27, ("energy drink can",
             "slim can", "can of energy drink"), ("office",), ("round", "tall"), ("blue", "black")),
    Category("beer_mat", beer_mat, (0.0993, 0.0993, 0.00356), 0.02, ("beermat", "beer coaster",
             "paper coaster", "beer mat collection"), _B, ("flat", "support"), ("red",),
             state="lying flat"),
    Category("whiskey_bottle", whiskey_bottle, (0.0807, 0.0807, 0.274), 1.1, ("whisky bottle",
             "rum bottle", "vodka bottle", "gin bottle", "bottle of whiskey", "liquor bottle",
             "spirit bottle", "bottle of rum", "bottle of gin", "bottle of vodka",
             "bottle of whisky", "liquor", "whiskey", "whisky", "rum", "vodka"), _B, ("tall",
             "round"), ("amber",)),
    Category("milkshake", milkshake, (0.0812, 0.0817, 0.23), 0.5, ("smoothie", "milk shake",
             "glass of milkshake", "frappe", "iced coffee", "root beer float", "ice cream float",
             "coke float"), ("coffee",), ("tall", "round"), ("pink",)),
)  # fmt: skip
"""The module's categories."""
