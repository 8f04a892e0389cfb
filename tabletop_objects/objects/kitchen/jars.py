"""Objects of the ``kitchen`` theme: jars."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.parts import cylinder_part, hull_of, open_vessel
from ...kit.primitives import label_skin, vessel, vessel_parts
from ...kit.shapes import Shape, category, shape
from ...kit.solids import cylinder, ellipsoid, join, lathe
from ...kit.surfaces import RGB, Look, readable_on, tint_color
from .cans import _label


@category("cookie_jar", size=(0.164, 0.165, 0.171), mass=0.9, material="ceramic",
          aliases=("biscuit jar", "jar of cookies", "biscuit tin", "biscuit barrel", "cookie tin",
          "easter tin"), themes=("kitchen",), roles=("round", "tall"), colors=("white", "red"),
          opened="open_jar")  # fmt: skip
def cookie_jar(look: Look) -> Shape:
    """A bulbous jar with a lid, a knob and the word COOKIES on its front."""
    r, h = look.between(0.075, 0.09), look.between(0.16, 0.19)
    color = look.color("white", "red", "cream", "sky", "yellow", "mint", "brown")
    body = lathe([(0, 0), (0.72 * r, 0), (0.95 * r, 0.14 * h), (r, 0.38 * h), (0.9 * r, 0.62 * h),
                  (0.68 * r, 0.76 * h), (0, 0.76 * h)], 34,
                 v=[0, 0.02, 0.18, 0.5, 0.8, 0.95, 1])  # fmt: skip
    lid = lathe([(0, 0.75 * h), (0.76 * r, 0.75 * h), (0.74 * r, 0.8 * h), (0.4 * r, 0.88 * h),
                 (0, 0.9 * h)], 34)  # fmt: skip
    knob = ellipsoid(0.3 * r, 0.3 * r, 0.26 * r, 16, 10).move(z=0.93 * h)
    image = prints.canvas(256, 128, color)
    front = image[:, 84:172]
    prints.write(front, "COOKIES", 0.5, 0.42, 0.24, readable_on(color), bold=True)
    prints.disc(front, 0.5, 0.7, 0.13, (206, 152, 88))
    for u, v in ((-0.06, -0.03), (0.04, 0.04), (0.05, -0.05), (-0.03, 0.06)):
        prints.disc(front, 0.5 + u, 0.7 + v, 0.022, (90, 54, 34))
    plain = look.surface(tint_color(color, 0.9), "ceramic")
    return shape([(body, image), (join([lid, knob]), plain)], [hull_of(body), hull_of(lid, knob)])


@category("spice_jar", size=(0.0446, 0.0446, 0.0949), mass=0.12, material="glass",
          aliases=("spice bottle", "jar of spices", "spice", "paprika", "cinnamon", "spice shaker",
          "spice tin", "jar of paprika", "herb jar", "jar of spice", "hundreds and thousands pot",
          "sprinkles pot", "pot of sprinkles", "jar of sprinkles", "masala jar", "paprika tin",
          "fennel seed jar", "mustard seed jar", "cumin jar", "turmeric jar", "nutmeg jar",
          "saffron jar"), themes=("kitchen",), roles=("round", "tall"),
          colors=("red", "amber"))  # fmt: skip
def spice_jar(look: Look) -> Shape:
    """A small glass jar of spice with a label and a perforated or screw lid."""
    r, h = look.between(0.02, 0.025), look.between(0.085, 0.105)
    color = look.color("red", "amber", "brown", "green", "mustard", "orange", "maroon")
    word = look.pick(["PAPRIKA", "CURRY", "CUMIN", "BASIL", "CHILI", "OREGANO", "SPICE"])
    print_ = prints.label(look.rng, word, look.own_color("black", "red", "green", "navy"),
                          (246, 244, 236))  # fmt: skip
    spice = surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.25)
    glass = surfaces.plain((206, 218, 222))
    tile = surfaces.stack((spice, 22), (print_, 40), (spice, 14), (glass, 24), side=160)
    body = lathe([(0, 0), (0.95 * r, 0), (r, 0.03 * h), (r, 0.7 * h), (0.8 * r, 0.78 * h),
                  (0, 0.78 * h)], 28, v=[0, 0.01, 0.03, 0.9, 0.98, 1])  # fmt: skip
    cap = cylinder(0.92 * r, 0.23 * h, 28, bevel=0.001).move(z=0.77 * h)
    tone = look.own_color("black", "silver", "red", "white", "green", "wooden")
    return shape([(body, tile), (cap, surfaces.plain(tone))], [hull_of(body), hull_of(cap)])


@category("storage_jar", size=(0.112, 0.112, 0.156), mass=0.7, material="ceramic",
          aliases=("flour jar", "canister", "kitchen canister", "rice jar", "pasta jar",
          "flour canister", "sugar canister"), themes=("kitchen",), roles=("round", "tall"),
          colors=("white",), opened="open_jar")  # fmt: skip
def storage_jar(look: Look) -> Shape:
    """A canister with a tight lid and a word such as FLOUR on its front."""
    r, h = look.between(0.05, 0.06), look.between(0.14, 0.18)
    color = look.color("white", "cream", "sage", "silver", "red", "navy", "terracotta")
    word = look.pick(["FLOUR", "SUGAR", "RICE", "OATS", "PASTA", "COFFEE"])
    image = prints.canvas(256, 128, color)
    prints.write(image[:, 88:168], word, 0.5, 0.5, 0.22, readable_on(color), bold=True)
    body = cylinder(r, 0.86 * h, 36, bevel=0.003)
    wood = look.surface(look.own_color("wooden", "tan", "black"), "wood")
    lid = cylinder(1.02 * r, 0.12 * h, 36, bevel=0.003).move(z=0.86 * h)
    return shape([(body, image), (lid, wood)], [cylinder_part(r, 0.86 * h), hull_of(lid)])


@category("jar_lid", size=(0.0711, 0.0711, 0.0148), mass=0.012, material="metal", hollow=True,
          aliases=("screw lid", "jam jar lid", "screw cap", "lid of a jar", "mason jar lid",
          "bottle lid"), themes=("kitchen",), roles=("round", "flat"), colors=("gold",),
          state="lying flat")  # fmt: skip
def jar_lid(look: Look) -> Shape:
    """The screw lid of a jar, lying on its rim."""
    r, h = look.between(0.032, 0.038), look.between(0.013, 0.016)
    color = look.color("gold", "red", "white", "green", "black", "silver")
    body = cylinder(r, h, 36, bevel=0.0016)
    ribs = surfaces.stripes([color, tint_color(color, 0.82)], 32, upright=True, side=128)
    top = cylinder(0.86 * r, 0.0008, 34).move(z=h - 0.0005)
    return shape([(body, ribs), (top, surfaces.speckles(look.rng, tint_color(color, 1.1), 4))],
                 [cylinder_part(r, h)])  # fmt: skip


@category("open_jar", size=(0.097, 0.097, 0.13), mass=0.3, material="glass", hollow=True,
          aliases=("jar without a lid",), themes=("kitchen",), roles=("container", "round"),
          colors=("clear",))  # fmt: skip
def open_jar(look: Look) -> Shape:
    """A glass jar without its lid."""
    r, h = look.between(0.045, 0.052), look.between(0.12, 0.14)
    side = [(0.94 * r, 0), (r, 0.08 * h), (r, 0.8 * h), (0.84 * r, 0.9 * h), (0.84 * r, h)]
    body, parts = open_vessel(side, 0.003, 0.006)
    tint = look.color("clear", "clear", "sky", "mint")
    return shape([(body, look.surface(tint, "glass"))], parts, opacity=0.55)


@category("jar", size=(0.076, 0.076, 0.115), mass=0.4, material="glass",
          themes=("kitchen", "dining"), roles=("round",), colors=("crimson", "amber"),
          opened="open_jar", common=True)  # fmt: skip
def jar(look: Look) -> Shape:
    """A round, squat, tall or faceted jar of jam, honey, pickles or spice, with a lid."""
    r, h = look.between(0.033, 0.043), look.between(0.08, 0.12)
    color = look.color(
        *("crimson", "amber", "purple", "orange", "olive", "brown", "cream", "green", "gold")
    )
    word = look.pick(["JAM", "HONEY", "PICKLES", "BERRY", "CURRY", "PESTO", "OLIVES", "SPICE"])
    shoulder, sides = look.between(0.74, 0.88), look.pick([32, 32, 32, 8])
    neck = look.between(0.7, 0.86) * r
    body = vessel(r, h, neck, shoulder * h, 0.94 * h, sides=sides)
    lid = cylinder(neck + 0.002, look.between(0.012, 0.02), 28, bevel=0.002).move(z=h - 0.003)
    other = look.own_color("white", "red", "gold", "navy", "black", "silver", "green")
    cloth = surfaces.fabric(look.rng, other, (246, 244, 238), 16)
    top = look.pick([cloth, surfaces.plain(other), surfaces.brushed_metal(look.rng, other)])
    ground = look.pick([(244, 242, 234), (250, 240, 200), (46, 52, 48), tint_color(color, 1.7)])
    skin = label_skin(look, color, word, look.between(0.18, 0.3), look.between(0.6, 0.72), ground)
    flat = np.cos(np.pi / sides)
    return shape(
        [(body, skin), (lid, top)],
        [*vessel_parts(body, r * flat, shoulder * h, neck * flat, h, 0.94 * h), hull_of(lid)],
    )


CLEAR: RGB = (208, 218, 216)


def _jar(look: Look, inside: surfaces.Tile, word: str, lid: RGB, *, band: bool = True) -> Shape:
    """Return a glass jar with a screw lid and a label; ``inside`` is its contents' texture."""
    r, h = look.between(0.034, 0.04), look.between(0.1, 0.125)
    body = lathe([(0, 0), (0.92 * r, 0), (r, 0.04 * h), (r, 0.72 * h), (0.84 * r, 0.83 * h),
                  (0.8 * r, 0.86 * h), (0, 0.86 * h)], 32,
                 v=[0, 0.01, 0.04, 0.82, 0.94, 0.98, 1])  # fmt: skip
    print_ = prints.label(look.rng, word, look.own_color("green", "red", "navy", "gold"),
                          (246, 244, 236))  # fmt: skip
    image = surfaces.fit(inside, 128, 256)
    tile = np.asarray(image).copy()
    if band:
        tile[46:104] = surfaces.fit(print_, 58, 256)
    tile[:14] = np.array(CLEAR, np.uint8)
    cap = cylinder(0.88 * r, 0.15 * h, 32, bevel=0.0015).move(z=0.85 * h)
    return shape([(body, tile), (cap, surfaces.plain(lid))], [hull_of(body), hull_of(cap)])


@category("pickle_jar", size=(0.0724, 0.0724, 0.11), mass=0.55, material="glass",
          aliases=("jar of pickles", "jar of gherkins", "gherkin jar", "pickles jar", "pickles",
          "kimchi", "sauerkraut"), themes=("kitchen",), roles=("round",),
          colors=("olive",))  # fmt: skip
def pickle_jar(look: Look) -> Shape:
    """A jar of gherkins in brine."""
    color = look.color("olive", "green", "olive")
    image = prints.canvas(256, 128, tint_color(color, 1.3))
    for k in range(11):
        x = (k + 0.5) / 11
        prints.fill(image, x - 0.034, 0.14, 0.068, 0.82, tint_color(color, look.between(0.6, 0.9)))
        prints.fill(image, x - 0.026, 0.14, 0.012, 0.82, tint_color(color, 1.15))
    return _jar(look, image, look.pick(["PICKLES", "GHERKINS", "DILL"]), look.own_color(
        "green", "gold", "white", "red"))  # fmt: skip


@category("olive_jar", size=(0.0737, 0.0737, 0.11), mass=0.45, material="glass",
          aliases=("jar of olives", "olives jar"), themes=("kitchen",), roles=("round",),
          colors=("olive",))  # fmt: skip
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


@category("mayonnaise", size=(0.0743, 0.0743, 0.109), mass=0.45, material="glass",
          aliases=("mayo", "jar of mayonnaise", "mayonnaise jar", "mayo jar", "jar of mayo"),
          themes=("kitchen",), roles=("round",), colors=("cream",))  # fmt: skip
def mayonnaise(look: Look) -> Shape:
    """A jar of mayonnaise with a wide lid."""
    pale = surfaces.speckles(look.rng, look.color("cream", "ivory", "white"), 4)
    return _jar(
        look, pale, look.pick(["MAYO", "MAYONNAISE"]), look.own_color("blue", "yellow", "navy")
    )


@category("oats", size=(0.112, 0.112, 0.174), mass=0.55, material="paper", aliases=("oats canister",
          "rolled oats", "tub of oats", "box of oats", "oats box", "bag of oats",
          "packet of instant oats", "packet of oats"), themes=("kitchen",), roles=("round", "tall"),
          colors=("blue",))  # fmt: skip
def oats(look: Look) -> Shape:
    """A round cardboard tub of oats with a plastic lid."""
    r, h = look.between(0.05, 0.06), look.between(0.16, 0.19)
    color = look.color("blue", "red", "green", "orange", "brown")
    image = prints.label(look.rng, look.pick(["OATS", "PORRIDGE"]), color, (246, 240, 222))
    body = cylinder(r, 0.96 * h, 36)
    cap = cylinder(1.02 * r, 0.06 * h, 36, bevel=0.001).move(z=0.94 * h)
    return shape([(body, image), (cap, surfaces.plain(look.own_color("white", "red", "blue")))],
                 [cylinder_part(r, 0.95 * h), hull_of(cap)])  # fmt: skip


CREAM: RGB = (246, 240, 222)


def _peanut_butter_jar(
    look: Look, r: float, h: float, fill: RGB, label: surfaces.Tile, lid: surfaces.Tile,
    *, sides: int = 32, neck: float = 0.8, wide: tuple[float, float] = (0.2, 0.68),
) -> Shape:  # fmt: skip
    """Return a jar with a screw lid and a label; ``fill`` is the colour of its contents."""
    body = vessel(r, h, neck * r, 0.8 * h, 0.93 * h, sides=sides)
    skin = surfaces.spots(look.rng, fill, tint_color(fill, 0.75), 0.08)
    low, high = wide
    tile = surfaces.stack((skin, low), (label, high - low), (skin, 0.86 - high),
                            (surfaces.plain((214, 222, 224)), 0.14), side=220)  # fmt: skip
    cap = cylinder(neck * r + 0.0025, 0.016, 30, bevel=0.002).move(z=h - 0.005)
    flat = np.cos(np.pi / sides)
    return shape(
        [(body, tile), (cap, lid)],
        [*vessel_parts(body, r * flat, 0.8 * h, neck * r * flat, h, 0.93 * h), hull_of(cap)],
    )


@category("peanut_butter", size=(0.082, 0.082, 0.125), mass=0.45, material="plastic",
          aliases=("peanut butter jar", "jar of peanut butter", "nutella", "nut butter",
          "chocolate spread", "hazelnut spread"), themes=("kitchen", "breakfast"), roles=("round",),
          colors=("red", "blue"))  # fmt: skip
def peanut_butter(look: Look) -> Shape:
    """A wide jar of peanut butter with a coloured lid."""
    r, h = look.between(0.038, 0.044), look.between(0.105, 0.125)
    color = look.color("red", "blue", "green", "orange", "teal", "yellow")
    label = _label(look, look.pick(["PEANUT", "CRUNCHY", "CREAMY", "BUTTER"]), color,
                   look.pick([CREAM, (250, 226, 140), (250, 250, 248)]), "nut")  # fmt: skip
    lid = surfaces.speckles(look.rng, color, 3, 32)
    return _peanut_butter_jar(
        look, r, h, look.pick([(190, 130, 70), (170, 112, 58)]), label, lid, neck=0.88
    )


@category("honey_jar", size=(0.0711, 0.0778, 0.109), mass=0.4, material="glass",
          aliases=("jar of honey", "honey", "honey bottle"), themes=("kitchen", "breakfast"),
          roles=("round",), colors=("gold", "amber"))  # fmt: skip
def honey_jar(look: Look) -> Shape:
    """A six-sided or round jar of honey with a bee on its label."""
    r, h = look.between(0.036, 0.042), look.between(0.09, 0.11)
    color = look.color("gold", "mustard", "brown", "black", "amber", "white", "green")
    label = _label(look, look.pick(["HONEY", "HONEY", "MIEL", "ACACIA"]), color,
                   look.pick([CREAM, (250, 232, 160), (252, 250, 244)]), "bee")  # fmt: skip
    fill = look.pick([(222, 150, 30), (236, 176, 60), (176, 104, 24)])
    lid = look.pick([surfaces.brushed_metal(look.rng, (212, 172, 82)), surfaces.plain((40, 40, 44)),
                     surfaces.fabric(look.rng, (230, 180, 60), (250, 246, 236), 16)])  # fmt: skip
    return _peanut_butter_jar(look, r, h, fill, label, lid, sides=look.pick([6, 8, 32]), neck=0.74)


@category("jam_jar", size=(0.073, 0.073, 0.106), mass=0.36, material="glass", aliases=("jar of jam",
          "jam", "marmalade", "strawberry jam", "jar of marmalade", "jelly jar", "marmalade jar",
          "jar of jelly", "fruit preserve", "preserve", "raspberry jam", "clotted cream pot"),
          themes=("kitchen", "breakfast"), roles=("round",),
          colors=("crimson", "purple"))  # fmt: skip
def jam_jar(look: Look) -> Shape:
    """A jar of jam or marmalade with a checked or golden lid and berries on its label."""
    r, h = look.between(0.033, 0.04), look.between(0.085, 0.105)
    color = look.color("crimson", "red", "purple", "orange", "maroon", "amber")
    words = ["JAM", "BERRY", "CHERRY", "PLUM"] if color[1] < 110 else ["JAM", "APRICOT", "PEACH"]
    other = look.own_color("red", "navy", "green", "crimson", "purple")
    what = "berries" if color[2] < 90 else "plums"
    label = _label(look, look.pick(words), other, look.pick([CREAM, (252, 250, 246)]), what)
    cloth = surfaces.fabric(look.rng, look.own_color("red", "navy", "green"), (246, 244, 238), 16)
    lid = look.pick([cloth, cloth, surfaces.brushed_metal(look.rng, (212, 172, 82)),
                     surfaces.plain((236, 234, 228))])  # fmt: skip
    return _peanut_butter_jar(
        look, r, h, color, label, lid, sides=look.pick([32, 32, 10]), neck=0.8
    )
