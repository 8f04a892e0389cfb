"""Sauces, syrups and dairy in their bottles, boxes and tubs."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.forms import speck
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import box, cylinder, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look
from ..kitchen.bottles import label_skin, sauce_bottle, vessel, vessel_parts


def _in(look: Look, color: str) -> Look:
    """Return a look in ``color`` unless another one was asked for."""
    return Look(look.rng, {"color": color, **look.attributes})


def ketchup(look: Look) -> Shape:
    """A red bottle of ketchup: squeezed, standing on its cap, or of glass."""
    return sauce_bottle(_in(look, look.pick(["red", "red", "crimson"])))


def mustard(look: Look) -> Shape:
    """A yellow bottle of mustard: squeezed, standing on its cap, or of glass."""
    return sauce_bottle(_in(look, look.pick(["yellow", "yellow", "gold", "mustard"])))


def salad_dressing(look: Look) -> Shape:
    """A bottle of salad dressing: a slim waist, herbs or two layers, a wide cap."""
    r, h = look.between(0.03, 0.036), look.between(0.19, 0.225)
    color = look.color("cream", "white", "olive", "orange", "amber", "mustard", "pink", "green")
    layered = look.chance(0.4)
    waist = look.chance(0.5)
    body = vessel(r, h, 0.013, 0.6 * h, 0.84 * h, waist=waist)
    word = look.pick(["RANCH", "ITALIAN", "CAESAR", "GREEK", "DRESSING", "FRENCH"])
    ground = look.pick([(244, 242, 234), (40, 90, 60), (250, 230, 150), (246, 240, 222)])
    skin = label_skin(look, color, word, 0.16, look.between(0.44, 0.52), ground)
    if layered:
        skin[: int(0.42 * len(skin))] = np.array((226, 196, 96), np.uint8)
    else:
        skin[: int(0.4 * len(skin))] = speck(skin[: int(0.4 * len(skin))], look.rng,
                                              tint_color((90, 130, 60), 1.0), 40, 2)  # fmt: skip
    cap = cylinder(0.0165, 0.03, 22, top=0.015, bevel=0.002).move(z=h - 0.012)
    tone = look.own_color("green", "white", "red", "navy", "black", "gold")
    return shape([(body, skin), (cap, textures.plain(tone))],
                 [*vessel_parts(body, 0.86 * r if waist else r, 0.6 * h, 0.013, h, 0.84 * h),
                  hull_of(cap)])  # fmt: skip


def maple_syrup(look: Look) -> Shape:
    """A flat flask of maple syrup with a ring handle at its neck and a leaf on its label."""
    r, h = look.between(0.038, 0.046), look.between(0.16, 0.2)
    color = look.color("brown", "maroon", "amber", "bronze", "copper")
    syrup = tint_color(color, 0.75)
    body = vessel(r, h, 0.013, 0.5 * h, 0.78 * h)
    image = prints.canvas(256, 128, look.pick([(246, 240, 222), (196, 42, 40), (250, 226, 150)]))
    ground: RGB = tuple(float(c) for c in image[0, 0])  # type: ignore[assignment]
    front = image[:, 80:176]
    leaf = (196, 42, 40) if sum(ground) > 560 else (250, 244, 226)
    for a in (-1.25, -0.65, 0, 0.65, 1.25):
        tip = (0.5 + 0.3 * np.sin(a), 0.42 - 0.32 * np.cos(a))
        prints.polygon(front, [(0.42, 0.44), tip, (0.58, 0.44)], leaf)
    prints.fill(front, 0.485, 0.42, 0.03, 0.14, leaf)
    prints.write(front, look.pick(["MAPLE", "SYRUP", "ERABLE"]), 0.5, 0.76, 0.22,
                 readable_on(ground), bold=True)  # fmt: skip
    skin = textures.plain(syrup)
    tile = textures.stack((skin, 0.12), (image, 0.34), (skin, 0.54), side=192)
    tile = textures.fit(tile, 192, 256)
    ring = torus(0.013, 0.0045, 18, 8).turn(0, np.pi / 2).move(x=0.026, z=0.8 * h)
    cap = cylinder(0.0155, 0.02, 20, bevel=0.001).move(z=h - 0.006)
    tone = look.own_color("red", "black", "white", "gold", "brown")
    return shape(
        [(body.scale(1, 0.72, 1), tile), (ring, skin), (cap, textures.plain(tone))],
        [hull_part(body.vertices[body.vertices[:, 2] < 0.52 * h] * [1, 0.72, 1]),
         hull_part(body.vertices[body.vertices[:, 2] > 0.48 * h] * [1, 0.72, 1]),
         hull_of(ring), hull_of(cap)],
    )  # fmt: skip


def soy_sauce(look: Look) -> Shape:
    """A small glass dispenser of soy sauce with a spouted cap, or a labelled bottle."""
    color = look.color("red", "red", "green", "yellow", "black", "gold")
    dark = textures.plain((52, 26, 20))
    clear = textures.plain((196, 186, 178))
    if look.chance(0.6):
        r, h = look.between(0.03, 0.034), look.between(0.1, 0.12)
        body = lathe(
            [(0, 0), (r, 0), (r, 0.02), (0.62 * r, 0.55 * h), (0.56 * r, 0.72 * h), (0, 0.72 * h)],
            look.pick([28, 8]),
            v=[0, 0.02, 0.15, 0.75, 0.97, 1],
        )
        cap = lathe([(0, 0.7 * h), (0.68 * r, 0.7 * h), (0.7 * r, 0.84 * h), (0.4 * r, 0.97 * h),
                     (0, 0.98 * h)], 24)  # fmt: skip
        nose = [
            tube(
                smooth(
                    [(s * 0.45 * r, 0, 0.86 * h), (s * 0.95 * r, 0, 0.94 * h), (s * 1.1 * r, 0, h)],
                    3,
                ),
                [0.004] * 6 + [0.002],
                8,
            )
            for s in (-1, 1)
        ]
        tile = textures.stack((dark, 0.6), (clear, 0.4), side=96)
        return shape([(body, tile), (join([cap, *nose]), textures.plain(color))],
                     [hull_of(body), hull_of(cap), *(hull_of(n) for n in nose)])  # fmt: skip
    r, h = look.between(0.028, 0.033), look.between(0.17, 0.2)
    body = vessel(r, h, 0.0125, 0.55 * h, 0.78 * h)
    skin = label_skin(look, (56, 28, 20), look.pick(["SOY", "SHOYU", "TAMARI"]), 0.14, 0.48,
                    look.pick([(250, 230, 150), (244, 242, 234), (196, 42, 40)]))  # fmt: skip
    cap = cylinder(0.0145, 0.026, 22, bevel=0.001).move(z=h - 0.01)
    return shape([(body, skin), (cap, textures.plain(color))],
                 [*vessel_parts(body, r, 0.55 * h, 0.0125, h, 0.78 * h), hull_of(cap)])  # fmt: skip


def _panel(look: Look, title: str, color: RGB, ground: RGB, size: tuple[int, int]) -> textures.Tile:
    """Return a front of a box: a title on a curved band over its ground."""
    image = prints.canvas(*size, ground)
    prints.disc(image, 0.5, 1.1, 0.75, tint_color(color, 1.35))
    prints.fill(image, 0, 0.2, 1, 0.4, color)
    prints.write(image, title, 0.5, 0.41, 0.26, readable_on(color), bold=True)
    prints.lines(image, look.rng, (0.2, 0.7, 0.6, 0.16), 2, tint_color(color, 0.6))
    return image


def cream_cheese(look: Look) -> Shape:
    """Cream cheese in a silvery brick-shaped box, or in a tub with a printed lid."""
    color = look.color("blue", "navy", "sky", "green", "teal", "red")
    ground = look.pick([(246, 246, 244), (206, 210, 216), (228, 236, 244)])
    word = look.pick(["CREAM", "CHEESE", "CREAM CHEESE", "SPREAD"])
    if look.chance(0.6):
        x, y, h = look.between(0.1, 0.125), look.between(0.055, 0.07), look.between(0.034, 0.042)
        side = _panel(look, word, color, ground, (160, 64))
        top = _panel(look, word, color, ground, (160, 88))
        lid = box(x, y, 0.0006).move(z=h - 0.0003)
        return shape([(box(x, y, h), side), (lid, top)], [box_part(x, y, h)])
    r, h = look.between(0.048, 0.056), look.between(0.045, 0.06)
    band = textures.fit(_panel(look, word, color, ground, (128, 64)), 64, 128)
    tub = lathe([(0, 0), (0.84 * r, 0), (0.97 * r, 0.8 * h), (0, 0.8 * h)], 34, v=[0, 0, 1, 1])
    wrap = np.concatenate([band, band, band], axis=1)
    lid = cylinder(r, 0.24 * h, 34, bevel=0.002).move(z=0.76 * h)
    disc = cylinder(0.9 * r, 0.0006, 34).move(z=h - 0.0003)
    return shape([(tub, wrap), (lid, textures.plain(ground)),
                  (disc, _panel(look, word, color, ground, (128, 128)))],
                 [hull_of(tub), cylinder_part(r, 0.24 * h, (0, 0, 0.76 * h))])  # fmt: skip


def yogurt(look: Look) -> Shape:
    """A cup of yoghurt with a foil lid, fruit on its side; sometimes open."""
    r, h = look.between(0.034, 0.042), look.between(0.075, 0.1)
    color = look.color("pink", "sky", "violet", "green", "orange", "crimson", "yellow", "blue")
    image = prints.label(look.rng, look.pick(["YOGURT", "YOGHURT", "SKYR", "GREEK"]), color,
                         (248, 247, 243))  # fmt: skip
    white = textures.plain((248, 247, 243))
    body = lathe([(0, 0), (0.72 * r, 0), (0.94 * r, 0.95 * h), (r, 0.96 * h), (r, h - 0.001),
                  (0, h - 0.001)], 30, v=[0, 0, 0.93, 0.95, 0.97, 1])  # fmt: skip
    tile = textures.stack((image, 94), (white, 6), side=160)
    foil = cylinder(1.01 * r, 0.0012, 34).move(z=h - 0.001)
    flap = box(0.018, 0.016, 0.0012).move(x=1.02 * r, z=h - 0.001)
    lid = prints.canvas(96, 96, (222, 224, 230))
    prints.disc(lid, 0.5, 0.5, 0.44, color)
    prints.disc(lid, 0.5, 0.5, 0.4, tint_color(color, 1.5))
    prints.write(lid, "YOGURT", 0.5, 0.5, 0.16, tint_color(color, 0.5), bold=True)
    return shape([(body, tile), (foil, lid), (flap, textures.plain((222, 224, 230)))],
                 [hull_of(body), cylinder_part(1.01 * r, 0.003, (0, 0, h - 0.003))])  # fmt: skip


CATEGORIES = (
    Category("ketchup", ketchup, (0.062, 0.062, 0.185), 0.5, ("ketchup bottle",
             "bottle of ketchup", "tomato ketchup", "catsup", "bbq sauce", "barbecue sauce",
             "bbq sauce bottle"), ("dining", "kitchen"), ("tall", "round"), ("red",)),
    Category("mustard_bottle", mustard, (0.062, 0.062, 0.185), 0.45, ("bottle of mustard",
             "yellow mustard", "mustard", "mustard container"), ("dining", "kitchen"), ("tall",
             "round"), ("yellow",)),
    Category("salad_dressing", salad_dressing, (0.066, 0.066, 0.22), 0.42,
             ("salad dressing bottle", "dressing", "bottle of dressing", "ranch dressing",
             "vinaigrette", "salad sauce", "dressing bottle", "caesar dressing"), ("dining",
             "kitchen"), ("tall", "round"),
             ("cream", "olive")),
    Category("maple_syrup", maple_syrup, (0.085, 0.06, 0.19), 0.5, ("syrup", "maple syrup bottle",
             "bottle of maple syrup", "pancake syrup", "syrup bottle", "bottle of syrup",
             "maple syrup jug"),
             ("breakfast", "kitchen"), ("tall",), ("brown", "amber")),
    Category("soy_sauce", soy_sauce, (0.0689, 0.0621, 0.147), 0.28, ("soy sauce bottle",
             "bottle of soy sauce", "soya sauce", "soy sauce dispenser", "worcestershire sauce"),
             ("dining", "kitchen"), ("tall",), ("red", "black")),
    Category("cream_cheese", cream_cheese, (0.111, 0.0853, 0.0463), 0.24, ("cream cheese box",
             "box of cream cheese", "soft cheese", "cheese spread", "cream cheese tub"),
             ("breakfast", "kitchen"), (), ("blue",)),
    Category("yogurt", yogurt, (0.0866, 0.0774, 0.0884), 0.18, ("yoghurt", "yogurt cup",
             "cup of yogurt", "yoghurt pot", "pot of yoghurt", "yogurt pot", "skyr", "yoghurt cup",
             "yogurt container"), ("breakfast", "kitchen"), ("round",), ("pink", "sky")),
)  # fmt: skip
"""The module's categories."""
