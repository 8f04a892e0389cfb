"""Tins and jars with labels that say and show what is in them."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, join, lathe, torus
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look
from ..kitchen.bottles import vessel, vessel_parts

Pieces = list[tuple[Solid, textures.Tile]]
CREAM: RGB = (246, 240, 222)


def _draw(front: prints.Canvas, what: str, x: float, y: float, r: float) -> None:
    """Draw a tomato, fish, bowl of soup, bee, nut or berries round (x, y) of a label's front."""
    wide = front.shape[0] / front.shape[1]
    if what == "tomato":
        prints.disc(front, x, y, r, (206, 44, 34))
        prints.disc(front, x - 0.3 * r * wide, y - 0.3 * r, 0.25 * r, (240, 130, 110))
        for a in np.linspace(0.2, 2.94, 5):
            tip = (x + 0.8 * r * wide * np.cos(a), y - 0.75 * r - 0.3 * r * np.sin(a))
            prints.stroke(front, [(x, y - 0.75 * r), tip], 0.25 * r, (70, 130, 50))
    elif what == "fish":
        t = np.linspace(0, 2 * np.pi, 24)
        body = [(x + 1.5 * r * wide * np.cos(a), y + 0.6 * r * np.sin(a)) for a in t]
        prints.polygon(front, body, (86, 120, 168))
        prints.polygon(front, [(x + 1.2 * r * wide, y), (x + 2.1 * r * wide, y - 0.7 * r),
                               (x + 2.1 * r * wide, y + 0.7 * r)], (86, 120, 168))  # fmt: skip
        prints.disc(front, x - 0.9 * r * wide, y - 0.15 * r, 0.13 * r, (250, 250, 250))
    elif what == "soup":
        prints.disc(front, x, y, r, (250, 248, 240))
        prints.disc(front, x, y, 0.8 * r, (222, 120, 40))
        prints.disc(front, x + 0.2 * r * wide, y - 0.2 * r, 0.2 * r, (90, 150, 60))
        prints.disc(front, x - 0.3 * r * wide, y + 0.2 * r, 0.18 * r, (240, 190, 80))
    elif what == "bee":
        for s in (-1, 1):
            prints.disc(front, x + 0.5 * s * r * wide, y - 0.6 * r, 0.5 * r, (232, 238, 244))
        prints.disc(front, x, y, 0.7 * r, (246, 196, 50))
        for k in (-1, 0, 1):
            prints.fill(front, x + (0.35 * k - 0.09) * r * wide, y - 0.55 * r, 0.18 * r * wide,
                        1.1 * r, (40, 34, 30))  # fmt: skip
    elif what == "nut":
        for s in (-0.55, 0.45):
            prints.disc(front, x + s * r * wide, y, 0.7 * r, (206, 156, 92))
            prints.disc(front, x + s * r * wide, y, 0.4 * r, (178, 128, 70))
    else:
        tone: RGB = (186, 28, 48) if what == "berries" else (80, 50, 130)
        for a, b in ((-0.5, 0.2), (0.5, 0.25), (0, -0.35)):
            prints.disc(front, x + a * r * wide, y + b * r, 0.5 * r, tone)
            prints.disc(front, x + (a - 0.15) * r * wide, y + (b - 0.15) * r, 0.12 * r,
                        tint_color(tone, 1.6))  # fmt: skip


def _label(look: Look, title: str, color: RGB, ground: RGB, what: str) -> textures.Tile:
    """Return a wrap-round label: a title over a picture on a ground, bands, small print behind."""
    image = prints.canvas(320, 160, ground)
    band = look.pick([0.07, 0.12])
    prints.fill(image, 0, 0, 1, band, color)
    prints.fill(image, 0, 1 - band, 1, band, color)
    front = image[:, 116:204]
    upper = look.chance(0.6)
    if upper:
        prints.fill(image, 0, 0.14, 1, 0.34, color)
        prints.write(front, title, 0.5, 0.31, 0.17, readable_on(color), bold=True)
        _draw(front, what, 0.5, 0.68, 0.17)
    else:
        prints.disc(front, 0.5, 0.5, 0.36, color)
        prints.disc(front, 0.5, 0.5, 0.33, tint_color(color, 1.5))
        _draw(front, what, 0.5, 0.34, 0.13)
        prints.fill(front, 0.02, 0.5, 0.96, 0.22, color)
        prints.write(front, title, 0.5, 0.61, 0.15, readable_on(color), bold=True)
    ink: RGB = (90, 90, 96) if sum(ground) > 380 else (220, 220, 220)
    prints.lines(image, look.rng, (0.04, 0.55, 0.18, 0.28), 6, ink)
    prints.barcode(image, look.rng, 0.8, 0.58, 0.15)
    return image


def _tin(look: Look, r: float, h: float, label: textures.Tile, *, ribs: bool = False) -> Pieces:
    """Return a food can of radius ``r``: rims at both ends, a label between, maybe a pull ring."""
    steel = textures.brushed_metal(look.rng, look.own_color("silver", "silver", "gold", spread=4))
    rim = min(0.004, 0.06 * h)
    body = lathe([(0, 0.0015), (r - 0.003, 0.0015), (r - 0.001, 0), (r, rim / 2), (r - 0.0012, rim),
                  (r - 0.0012, h - rim), (r, h - rim / 2), (r - 0.001, h), (r - 0.003, h - 0.0025),
                  (0, h - 0.0025)], 32,
                 v=[0, 0.01, 0.015, 0.02, 0.03, 0.95, 0.96, 0.97, 0.98, 1])  # fmt: skip
    tile = textures.stack((steel, 3), (label, 92), (steel, 5), side=200)
    top = [torus(k * r, 0.0008, 26, 5).move(z=h - 0.0025) for k in (0.82, 0.5)]
    if look.chance(0.6) or ribs:
        ring = torus(0.0085, 0.0014, 18, 6).scale(1, 1.25, 1).move(y=-0.3 * r, z=h - 0.001)
        tab = cylinder(0.005, 0.002, 12).move(y=-0.68 * r, z=h - 0.003)
        top += [ring, tab]
    return [(body, tile), (join(top), steel)]


def soup_can(look: Look) -> Shape:
    """A tall tin of soup, beans, corn or fruit with a picture on its label."""
    r, h = look.between(0.032, 0.038), look.between(0.098, 0.115)
    color = look.color("red", "red", "green", "navy", "orange", "teal", "crimson", "mustard")
    what, words = look.pick([("soup", ("SOUP", "NOODLE", "ALPHABET", "CHICKEN")),
                             ("soup", ("SOUP", "MINESTRONE", "VEGGIE")),
                             ("nut", ("BEANS", "CHICKPEAS"))])  # fmt: skip
    ground = look.pick([CREAM, (250, 250, 248), (250, 228, 150)])
    label = _label(look, look.pick(words), color, ground, what)
    return shape(_tin(look, r, h, label), [cylinder_part(r, h)])


def tomato_can(look: Look) -> Shape:
    """A tin of tomatoes: whole, chopped or as a sauce or paste."""
    paste = look.chance(0.2)
    r, h = (0.026, 0.06) if paste else (look.between(0.034, 0.045), look.between(0.1, 0.12))
    color = look.color("red", "green", "yellow", "crimson", "navy", "black")
    word = "PASTE" if paste else look.pick(["TOMATO", "POMODORI", "SAUCE", "CHOPPED"])
    label = _label(
        look, word, color, look.pick([CREAM, (250, 250, 248), (250, 230, 140)]), "tomato"
    )
    return shape(_tin(look, r, h, label), [cylinder_part(r, h)])


def tuna_can(look: Look) -> Shape:
    """A flat tin of tuna with a fish on its label and a pull ring."""
    r, h = look.between(0.038, 0.045), look.between(0.032, 0.042)
    color = look.color("blue", "navy", "teal", "red", "green", "yellow", "sky")
    word = look.pick(["TUNA", "TUNA", "SALMON", "SARDINES"])
    label = _label(look, word, color, look.pick([(250, 250, 248), CREAM, (206, 226, 236)]), "fish")
    pieces = _tin(look, r, h, label, ribs=True)
    lid = cylinder(0.84 * r, 0.0006, 30).move(z=h - 0.0028)
    art = prints.canvas(96, 96, tint_color(color, 1.2))
    _draw(art, "fish", 0.42, 0.62, 0.17)
    prints.write(art, word, 0.5, 0.33, 0.16, readable_on(tint_color(color, 1.2)), bold=True)
    if look.chance(0.5):
        pieces.append((lid, art))
    return shape(pieces, [cylinder_part(r, h)])


def coffee_can(look: Look) -> Shape:
    """A large round tin of ground coffee with a plastic lid."""
    r, h = look.between(0.047, 0.053), look.between(0.13, 0.15)
    color = look.color("red", "blue", "green", "brown", "black", "maroon", "gold")
    ground = look.pick([tint_color(color, 0.75), (60, 40, 30), CREAM, tint_color(color, 0.55)])
    label = prints.label(look.rng, look.pick(["COFFEE", "ROAST", "CAFE", "MASTER"]), color, ground)
    pieces = _tin(look, r, h - 0.004, label)
    lid = cylinder(r + 0.0015, 0.014, 34, bevel=0.002).move(z=h - 0.012)
    tone = look.pick([tint_color(color, 0.6), (240, 238, 232), (40, 40, 44), (200, 40, 40)])
    pieces.append((lid, textures.speckles(look.rng, tone, 3, 32)))
    return shape(pieces, [cylinder_part(r, h - 0.012), hull_of(lid)])


def chips_can(look: Look) -> Shape:
    """A tall paper tube of stacked crisps with a see-through lid."""
    r, h = look.between(0.036, 0.039), look.between(0.22, 0.255)
    color = look.color("red", "green", "purple", "orange", "blue", "yellow", "teal")
    image = prints.canvas(320, 256, color)
    front = image[:, 100:220]
    prints.disc(front, 0.5, 0.24, 0.115, (250, 244, 230))
    prints.disc(front, 0.46, 0.22, 0.014, (40, 34, 30))
    prints.disc(front, 0.54, 0.22, 0.014, (40, 34, 30))
    prints.fill(front, 0.36, 0.27, 0.28, 0.022, (90, 54, 30))
    word = look.pick(["CHIPS", "CRISPS", "STAX", "SALTY"])
    prints.write(front, word, 0.5, 0.45, 0.1, (255, 246, 180), bold=True)
    prints.write(front, look.pick(["ORIGINAL", "PAPRIKA", "ONION", "SALT"]), 0.5, 0.54, 0.05,
                 (255, 255, 250))  # fmt: skip
    for k in range(5):
        y = 0.66 + 0.05 * k
        t = np.linspace(0, 2 * np.pi, 20)
        prints.polygon(front, [(0.5 + 0.26 * np.cos(a), y + 0.05 * np.sin(a)) for a in t],
                       (238, 196 - 8 * (k % 2), 100))  # fmt: skip
    prints.fill(image, 0, 0.95, 1, 0.05, tint_color(color, 0.6))
    steel = textures.plain((196, 198, 202))
    body = lathe([(0, 0), (r, 0), (r, h - 0.008), (0, h - 0.008)], 32, v=[0, 0.0, 0.97, 1])
    lid = cylinder(r + 0.0012, 0.012, 32, bevel=0.002).move(z=h - 0.012)
    foot = torus(r - 0.0005, 0.0015, 30, 6).move(z=0.0015)
    tone = look.pick([(226, 230, 232), (226, 230, 232), tint_color(color, 0.7)])
    return shape([(body, image), (lid, textures.plain(tone)), (foot, steel)],
                 [cylinder_part(r, h - 0.01), hull_of(lid)])  # fmt: skip


def _jar(
    look: Look, r: float, h: float, fill: RGB, label: textures.Tile, lid: textures.Tile,
    *, sides: int = 32, neck: float = 0.8, wide: tuple[float, float] = (0.2, 0.68),
) -> Shape:  # fmt: skip
    """Return a jar full of something with a label and a screw lid."""
    body = vessel(r, h, neck * r, 0.8 * h, 0.93 * h, sides=sides)
    skin = textures.spots(look.rng, fill, tint_color(fill, 0.75), 0.08)
    low, high = wide
    tile = textures.stack((skin, low), (label, high - low), (skin, 0.86 - high),
                            (textures.plain((214, 222, 224)), 0.14), side=220)  # fmt: skip
    cap = cylinder(neck * r + 0.0025, 0.016, 30, bevel=0.002).move(z=h - 0.005)
    flat = np.cos(np.pi / sides)
    return shape(
        [(body, tile), (cap, lid)],
        [*vessel_parts(body, r * flat, 0.8 * h, neck * r * flat, h, 0.93 * h), hull_of(cap)],
    )


def peanut_butter(look: Look) -> Shape:
    """A wide jar of peanut butter with a coloured lid."""
    r, h = look.between(0.038, 0.044), look.between(0.105, 0.125)
    color = look.color("red", "blue", "green", "orange", "teal", "yellow")
    label = _label(look, look.pick(["PEANUT", "CRUNCHY", "CREAMY", "BUTTER"]), color,
                   look.pick([CREAM, (250, 226, 140), (250, 250, 248)]), "nut")  # fmt: skip
    lid = textures.speckles(look.rng, color, 3, 32)
    return _jar(look, r, h, look.pick([(190, 130, 70), (170, 112, 58)]), label, lid, neck=0.88)


def honey_jar(look: Look) -> Shape:
    """A six-sided or round jar of honey, a bee on its label."""
    r, h = look.between(0.036, 0.042), look.between(0.09, 0.11)
    color = look.color("gold", "mustard", "brown", "black", "amber", "white", "green")
    label = _label(look, look.pick(["HONEY", "HONEY", "MIEL", "ACACIA"]), color,
                   look.pick([CREAM, (250, 232, 160), (252, 250, 244)]), "bee")  # fmt: skip
    fill = look.pick([(222, 150, 30), (236, 176, 60), (176, 104, 24)])
    lid = look.pick([textures.brushed_metal(look.rng, (212, 172, 82)), textures.plain((40, 40, 44)),
                     textures.fabric(look.rng, (230, 180, 60), (250, 246, 236), 16)])  # fmt: skip
    return _jar(look, r, h, fill, label, lid, sides=look.pick([6, 8, 32]), neck=0.74)


def jam_jar(look: Look) -> Shape:
    """A jar of jam or marmalade with a checked or golden lid and berries on its label."""
    r, h = look.between(0.033, 0.04), look.between(0.085, 0.105)
    color = look.color("crimson", "red", "purple", "orange", "maroon", "amber")
    words = ["JAM", "BERRY", "CHERRY", "PLUM"] if color[1] < 110 else ["JAM", "APRICOT", "PEACH"]
    other = look.own_color("red", "navy", "green", "crimson", "purple")
    what = "berries" if color[2] < 90 else "plums"
    label = _label(look, look.pick(words), other, look.pick([CREAM, (252, 250, 246)]), what)
    cloth = textures.fabric(look.rng, look.own_color("red", "navy", "green"), (246, 244, 238), 16)
    lid = look.pick([cloth, cloth, textures.brushed_metal(look.rng, (212, 172, 82)),
                     textures.plain((236, 234, 228))])  # fmt: skip
    return _jar(look, r, h, color, label, lid, sides=look.pick([32, 32, 10]), neck=0.8)


CATEGORIES = (
    Category("soup_can", soup_can, (0.07, 0.07, 0.106), 0.38, ("can of soup", "tin of soup",
             "soup tin", "can of beans", "bean can", "baked beans", "tin of beans", "corn can",
             "can of corn", "alphabet soup", "alphabet soup can", "chicken soup", "canned soup",
             "canned food", "food can", "campbell soup can", "can of baked beans"), ("kitchen",
             "food"), ("round",),
             ("red", "green")),
    Category("tomato_can", tomato_can, (0.076, 0.076, 0.103), 0.42, ("can of tomatoes",
             "tomato soup can", "tomato tin", "canned tomatoes", "tomato sauce",
             "tomato sauce can", "tomato paste", "tomato soup", "tin of tomatoes",
             "can of tomato soup", "sauce can"), ("kitchen", "food"), ("round",), ("red",
             "green")),
    Category("tuna_can", tuna_can, (0.083, 0.083, 0.038), 0.19, ("can of tuna", "tuna",
             "tuna fish can", "tin of tuna", "tuna tin", "fish can", "sardine can", "sardine tin",
             "canned fish", "tin of sardines", "sardines", "can of sardines"), ("kitchen", "food"),
             ("round", "flat"), ("blue", "red")),
    Category("coffee_can", coffee_can, (0.102, 0.102, 0.14), 0.42, ("can of coffee", "coffee tub",
             "ground coffee", "master chef can", "coffee canister"), ("kitchen", "coffee"),
             ("round",), ("red", "blue")),
    Category("chips_can", chips_can, (0.077, 0.077, 0.24), 0.21, ("chip can", "can of chips",
                 "pringles", "pringles can", "crisps tube", "tube of chips", "tube of crisps",
                 "chips tube", "potato crisp tube", "crisp tube", "tube of potato crisps"),
             ("living", "food"), ("round", "tall"), ("red", "green")),
    Category("peanut_butter", peanut_butter, (0.082, 0.082, 0.125), 0.45, ("peanut butter jar",
             "jar of peanut butter", "nutella", "nut butter", "chocolate spread",
             "hazelnut spread"), ("kitchen", "breakfast"), ("round",), ("red", "blue")),
    Category("honey_jar", honey_jar, (0.0711, 0.0778, 0.109), 0.4, ("jar of honey", "honey",
             "honey bottle"), ("kitchen", "breakfast"), ("round",),
             ("gold", "amber")),
    Category("jam_jar", jam_jar, (0.073, 0.073, 0.106), 0.36, ("jar of jam", "jam", "marmalade",
                 "strawberry jam", "jar of marmalade", "jelly jar", "marmalade jar",
                 "jar of jelly", "fruit preserve", "preserve", "raspberry jam",
                 "clotted cream pot"), ("kitchen",
             "breakfast"), ("round",), ("crimson", "purple")),
)  # fmt: skip
"""The module's categories."""
