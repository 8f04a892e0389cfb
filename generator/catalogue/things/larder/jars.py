"""Jars, mills, cruets and small packs: pickles, oil, vinegar, hot sauce, mayonnaise, noodles."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.outlines import smooth
from ...build.settled import limb
from ...build.shape import Shape, shape
from ...build.solids import box, cylinder, ellipsoid, join, lathe, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look
from ..kitchen.bottles import label_skin, vessel, vessel_parts

CLEAR: RGB = (208, 218, 216)


def _jar(look: Look, inside: textures.Tile, word: str, lid: RGB, *, band: bool = True) -> Shape:
    """Return a glass jar of ``inside`` with a screw lid and a label."""
    r, h = look.between(0.034, 0.04), look.between(0.1, 0.125)
    body = lathe(
        [
            (0, 0),
            (0.92 * r, 0),
            (r, 0.04 * h),
            (r, 0.72 * h),
            (0.84 * r, 0.83 * h),
            (0.8 * r, 0.86 * h),
            (0, 0.86 * h),
        ],
        32,
        v=[0, 0.01, 0.04, 0.82, 0.94, 0.98, 1],
    )
    print_ = prints.label(look.rng, word, look.own_color("green", "red", "navy", "gold"),
                          (246, 244, 236))  # fmt: skip
    image = textures.fit(inside, 128, 256)
    tile = np.asarray(image).copy()
    if band:
        tile[46:104] = textures.fit(print_, 58, 256)
    tile[:14] = np.array(CLEAR, np.uint8)
    cap = cylinder(0.88 * r, 0.15 * h, 32, bevel=0.0015).move(z=0.85 * h)
    return shape([(body, tile), (cap, textures.plain(lid))], [hull_of(body), hull_of(cap)])


def pickle_jar(look: Look) -> Shape:
    """A jar of gherkins standing in their brine."""
    color = look.color("olive", "green", "olive")
    image = prints.canvas(256, 128, tint_color(color, 1.3))
    for k in range(11):
        x = (k + 0.5) / 11
        prints.fill(image, x - 0.034, 0.14, 0.068, 0.82, tint_color(color, look.between(0.6, 0.9)))
        prints.fill(image, x - 0.026, 0.14, 0.012, 0.82, tint_color(color, 1.15))
    return _jar(look, image, look.pick(["PICKLES", "GHERKINS", "DILL"]), look.own_color(
        "green", "gold", "white", "red"))  # fmt: skip


def olive_jar(look: Look) -> Shape:
    """A jar of olives."""
    color = look.color("olive", "olive", "black", "green")
    image = prints.canvas(256, 128, tint_color(color, 1.25))
    for j in range(6):
        for k in range(12):
            x, y = (k + 0.5 * (j % 2) + 0.25) / 12, 0.2 + 0.15 * j
            prints.disc(image, x, y, 0.07, tint_color(color, look.between(0.65, 0.95)))
            prints.disc(image, x + 0.008, y, 0.02, (200, 60, 40))
    return _jar(look, image, "OLIVES", look.own_color("green", "black", "gold", "white"))


def mayonnaise(look: Look) -> Shape:
    """A jar of mayonnaise with a wide lid."""
    pale = textures.speckles(look.rng, look.color("cream", "ivory", "white"), 4)
    return _jar(
        look, pale, look.pick(["MAYO", "MAYONNAISE"]), look.own_color("blue", "yellow", "navy")
    )


def hot_sauce(look: Look) -> Shape:
    """A slim bottle of hot sauce with a chilli on its label."""
    r, h = look.between(0.022, 0.027), look.between(0.14, 0.17)
    color = look.color("red", "red", "orange", "green", "crimson")
    body = vessel(r, h, 0.0095, 0.56 * h, 0.72 * h)
    ground = look.pick([(246, 240, 222), (250, 214, 90), (34, 34, 38)])
    skin = np.asarray(label_skin(look, color, look.pick(["HOT", "FIRE", "CHILI"]), 0.12, 0.48,
                                 ground)).copy()  # fmt: skip
    cap = cylinder(0.0115, 0.03, 20, bevel=0.001).move(z=h - 0.014)
    tone = textures.plain(look.own_color("red", "green", "white", "black"))
    return shape(
        [(body, skin), (cap, tone)],
        [*vessel_parts(body, r, 0.56 * h, 0.0095, h, 0.72 * h), hull_of(cap)],
    )


def _cruet(look: Look, fill: RGB, word: str) -> Shape:
    """Return a bottle of oil or vinegar: slim, with a pouring spout or a cork."""
    r, h = look.between(0.031, 0.037), look.between(0.22, 0.27)
    square = look.chance(0.4)
    body = vessel(r, h, 0.012, 0.6 * h, 0.78 * h, sides=4 if square else 32)
    body = body.turn(2, np.pi / 4) if square else body
    skin = np.asarray(label_skin(look, fill, word, 0.2, 0.44, look.pick(
        [(246, 240, 222), (250, 250, 246)]))).copy()  # fmt: skip
    skin[: int(0.24 * len(skin))] = np.array(CLEAR, np.uint8)
    spout = limb([(0, 0, h - 0.004), (0, 0, h + 0.012), (0.006, 0, h + 0.028), (0.018, 0,
                  h + 0.04)], [0.0085, 0.0055, 0.0038, 0.003], 10)  # fmt: skip
    collar = cylinder(0.0145, 0.018, 20, bevel=0.001).move(z=h - 0.01)
    steel = textures.brushed_metal(look.rng, (196, 199, 204))
    wide = 0.7 * r if square else r
    return shape([(body, skin), (join([spout, collar]), steel)],
                 [hull_of(body.bend(lambda p: np.minimum(p, [1, 1, 0.6 * h]))),
                  *vessel_parts(body, wide, 0.6 * h, 0.012, h, 0.78 * h)[1:],
                  hull_of(spout, collar)])  # fmt: skip


def oil_bottle(look: Look) -> Shape:
    """A bottle of olive oil with a pouring spout."""
    return _cruet(
        look, look.color("mustard", "olive", "gold"), look.pick(["OLIVE", "OIL", "EXTRA"])
    )


def vinegar_bottle(look: Look) -> Shape:
    """A bottle of vinegar with a pouring spout."""
    return _cruet(
        look, look.color("maroon", "amber", "brown", "beige"), look.pick(["VINEGAR", "BALSAMIC"])
    )


def pepper_mill(look: Look) -> Shape:
    """A turned pepper mill of wood, or a straight one of steel and glass."""
    r, h = look.between(0.024, 0.029), look.between(0.17, 0.22)
    color = look.color("wooden", "brown", "black", "red", "white", "tan")
    skin = look.surface(color, "wood")
    steel = textures.brushed_metal(look.rng, (196, 199, 204))
    body = lathe(
        [
            (0, 0),
            (r, 0),
            (r, 0.08 * h),
            (0.82 * r, 0.2 * h),
            (0.66 * r, 0.42 * h),
            (0.9 * r, 0.6 * h),
            (0.92 * r, 0.68 * h),
            (0.6 * r, 0.72 * h),
            (0, 0.72 * h),
        ],
        28,
    )
    head = lathe([(0, 0.72 * h), (0.6 * r, 0.725 * h), (0.86 * r, 0.78 * h), (0.84 * r, 0.88 * h),
                  (0.5 * r, 0.95 * h), (0, 0.96 * h)], 28)  # fmt: skip
    knob = ellipsoid(0.016, 0.016, 0.014, 14, 8).move(z=0.975 * h)
    return shape([(body, skin), (head, skin), (knob, steel)], [hull_of(body), hull_of(head, knob)])


def honey_pot(look: Look) -> Shape:
    """A bellied honey pot, HONEY on it, its dipper sticking out."""
    r, h = look.between(0.045, 0.055), look.between(0.085, 0.105)
    color = look.color("gold", "yellow", "cream", "terracotta", "white")
    image = prints.canvas(256, 128, color)
    prints.write(image[:, 86:170], "HONEY", 0.5, 0.5, 0.26, readable_on(color), bold=True)
    body = lathe(
        [
            (0, 0),
            (0.72 * r, 0),
            (0.96 * r, 0.2 * h),
            (r, 0.45 * h),
            (0.86 * r, 0.78 * h),
            (0.7 * r, 0.88 * h),
            (0.78 * r, h),
            (0.68 * r, h),
            (0.6 * r, 0.92 * h),
            (0, 0.92 * h),
        ],
        32,
        v=[0, 0.01, 0.2, 0.45, 0.8, 0.9, 0.97, 0.98, 0.99, 1],
    )
    honey = cylinder(0.66 * r, 0.002, 28).move(z=0.93 * h)
    drip = [
        ellipsoid(0.016, 0.008, 0.03, 12, 8)
        .turn(2, a)
        .move(0.8 * r * np.sin(a), -0.8 * r * np.cos(a), 0.84 * h)
        for a in (-0.5, 0.2, 1.0)
    ]
    stick = tube([(0, 0, 0.9 * h), (0.75 * r, 0.2 * r, 1.55 * h)], 0.0038, 8)
    gold = textures.gradient((222, 140, 20), (244, 184, 50), look.rng)
    wood = textures.wood(look.rng, (206, 164, 110))
    return shape([(body, image), (join([honey, *drip]), gold), (stick, wood)],
                 [hull_of(body), hull_of(stick)])  # fmt: skip


def instant_noodles(look: Look) -> Shape:
    """A cup of instant noodles with its lid peeled half back, or shut."""
    r, h = look.between(0.046, 0.054), look.between(0.1, 0.115)
    color = look.color("red", "orange", "green", "yellow", "purple")
    image = prints.label(look.rng, look.pick(["NOODLES", "RAMEN", "CUP"]), color, (248, 246, 240))
    white = textures.plain((248, 246, 240))
    body = lathe([(0, 0), (0.72 * r, 0), (0.96 * r, 0.94 * h), (r, 0.95 * h), (r, h), (0, h)], 32,
                 v=[0, 0.02, 0.93, 0.95, 0.97, 1])  # fmt: skip
    lid = prints.canvas(96, 96, color)
    prints.write(lid, look.pick(["BEEF", "CHICKEN", "SPICY"]), 0.5, 0.5, 0.22, readable_on(color),
                 bold=True)  # fmt: skip
    cover = cylinder(1.01 * r, 0.0012, 32).move(z=h - 0.0004)
    tab = box(0.02, 0.014, 0.0012).move(0, -1.03 * r, h - 0.0004)
    return shape([(body, textures.stack((image, 90), (white, 10), side=160)), (cover, lid),
                  (tab, textures.plain(color))], [hull_of(body, cover)])  # fmt: skip


def juice_box(look: Look) -> Shape:
    """A small carton of juice with a bent straw."""
    x, y, h = look.between(0.05, 0.058), look.between(0.036, 0.042), look.between(0.1, 0.12)
    color = look.color("orange", "green", "red", "purple", "yellow", "pink")
    face = prints.canvas(80, 150, color)
    prints.disc(face, 0.5, 0.64, 0.17, tint_color(color, 0.7))
    prints.disc(face, 0.46, 0.6, 0.05, tint_color(color, 1.5))
    prints.fill(face, 0.06, 0.12, 0.88, 0.2, (250, 248, 240))
    prints.write(face, look.pick(["JUICE", "APPLE", "ORANGE"]), 0.5, 0.22, 0.13,
                 tint_color(color, 0.6), bold=True)  # fmt: skip
    front = [box(0.98 * x, 0.001, 0.97 * h).move(y=s * y / 2, z=0.01 * h) for s in (-1, 1)]
    pipe = tube(smooth([(0.25 * x, 0, h - 0.01), (0.25 * x, 0, h + 0.028), (0.3 * x, 0, h + 0.036),
                        (0.62 * x, 0, h + 0.046)], 4), 0.0024, 8)  # fmt: skip
    return shape([(box(x, y, h), textures.plain(tint_color(color, 0.9))), (join(front), face),
                  (pipe, textures.plain((250, 248, 244)))],
                 [box_part(x, y, h), hull_of(pipe)])  # fmt: skip


def oats_canister(look: Look) -> Shape:
    """A round cardboard tub of oats with a plastic lid."""
    r, h = look.between(0.05, 0.06), look.between(0.16, 0.19)
    color = look.color("blue", "red", "green", "orange", "brown")
    image = prints.label(look.rng, look.pick(["OATS", "PORRIDGE"]), color, (246, 240, 222))
    body = cylinder(r, 0.96 * h, 36)
    cap = cylinder(1.02 * r, 0.06 * h, 36, bevel=0.001).move(z=0.94 * h)
    return shape([(body, image), (cap, textures.plain(look.own_color("white", "red", "blue")))],
                 [cylinder_part(r, 0.95 * h), hull_of(cap)])  # fmt: skip


_K = ("kitchen",)
CATEGORIES = (
    Category("pickle_jar", pickle_jar, (0.0724, 0.0724, 0.11), 0.55, ("jar of pickles",
             "jar of gherkins", "gherkin jar", "pickles jar", "pickles", "kimchi", "sauerkraut"),
             _K, ("round",), ("olive",)),
    Category("olive_jar", olive_jar, (0.0737, 0.0737, 0.11), 0.45, ("jar of olives", "olives jar"),
             _K, ("round",), ("olive",)),
    Category("mayonnaise", mayonnaise, (0.0743, 0.0743, 0.109), 0.45, ("mayo", "jar of mayonnaise",
             "mayonnaise jar", "mayo jar", "jar of mayo"), _K, ("round",), ("cream",)),
    Category("hot_sauce", hot_sauce, (0.0478, 0.0478, 0.176), 0.22, ("chili sauce", "chilli sauce",
             "hot sauce bottle", "bottle of hot sauce", "sriracha", "fish sauce", "chili oil"), _K,
             ("tall", "round"), ("red",)),
    Category("oil_bottle", oil_bottle, (0.0621, 0.0621, 0.295), 0.8, ("olive oil",
             "bottle of olive oil", "oil cruet", "olive oil bottle", "cooking oil", "bottle of oil",
             "vegetable oil", "oil dispenser", "sunflower oil", "oil", "pre-shave oil bottle"),
             _K, ("tall", "round"),
             ("mustard",)),
    Category("vinegar_bottle", vinegar_bottle, (0.0555, 0.0555, 0.288), 0.75, ("vinegar",
             "bottle of vinegar", "balsamic vinegar", "vinegar cruet", "cruet"), _K, ("tall",
             "round"), ("maroon",)),
    Category("pepper_mill", pepper_mill, (0.0528, 0.0528, 0.194), 0.2, ("pepper grinder",
                 "salt mill", "salt grinder", "peppermill", "spice mill", "spice grinder",
                 "salt and pepper mill", "nutmeg grinder"),
             ("dining", "kitchen"), ("tall", "round"), ("wooden",)),
    Category("honey_pot", honey_pot, (0.0991, 0.0991, 0.151), 0.45, ("pot of honey", "honeypot"),
             ("breakfast",), ("round",), ("gold",)),
    Category("instant_noodles", instant_noodles, (0.102, 0.11, 0.109), 0.1, ("cup noodles",
             "instant noodle cup", "cup of noodles", "instant ramen", "cup noodle", "noodle cup",
             "pot noodle", "instant noodles cup"), ("office",), ("round",), ("red",)),
    Category("juice_box", juice_box, (0.0607, 0.0397, 0.157), 0.22, ("juice pack", "drink box",
             "box of juice", "juice carton with straw", "apple juice box", "juice pouch"),
             ("kitchen",), ("tall",), ("orange",)),
    Category("oats", oats_canister, (0.112, 0.112, 0.174), 0.55, ("oats canister", "rolled oats",
             "tub of oats", "box of oats", "oats box", "bag of oats", "packet of instant oats",
             "packet of oats"), _K, ("round", "tall"),
             ("blue",)),
)  # fmt: skip
"""The module's categories."""
