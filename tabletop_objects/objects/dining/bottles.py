"""Objects of the ``dining`` theme: bottles."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import smooth
from ...kit.parts import cylinder_part, hull_of, hull_part
from ...kit.primitives import label_skin, vessel, vessel_parts
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import cylinder, join, lathe, torus, tube
from ...kit.surfaces import RGB, Look, speck, tint_color
from .barware import _can


@category("beer_bottle", size=(0.061, 0.061, 0.235), mass=0.55, material="glass",
          aliases=("bottle of beer", "lager bottle", "beer"), themes=("dining", "kitchen"),
          roles=("tall", "round"), colors=("brown", "green"))  # fmt: skip
def beer_bottle(look: Look) -> Shape:
    """A bottle of beer in brown, green or clear glass with a paper label and a crown cap."""
    r, h = look.between(0.029, 0.032), look.between(0.215, 0.25)
    color = look.color("brown", "brown", "green", "amber", "olive")
    long = look.chance(0.6)
    shoulder, rise = (0.56, 0.74) if long else (0.6, 0.7)
    body = vessel(r, h, 0.0125, shoulder * h, rise * h)
    word = look.pick(["LAGER", "ALE", "STOUT", "PILS", "IPA", "BOCK"])
    ground = look.pick([(244, 238, 216), (196, 42, 40), (40, 90, 60), (230, 190, 90), (36, 50, 92)])
    skin = label_skin(look, tint_color(color, 0.8), word, 0.13, 0.47, ground)
    band = surfaces.plain(tint_color(ground, 0.9))
    skin[int(0.16 * len(skin)) : int(0.22 * len(skin))] = band[0, 0]
    cap = lathe([(0, h - 0.003), (0.0145, h - 0.003), (0.0138, h + 0.003), (0.01, h + 0.0045),
                 (0, h + 0.0045)], 21)  # fmt: skip
    tone = look.own_color("gold", "silver", "red", "navy", "green", "black")
    ribs = surfaces.stripes([tone, tint_color(tone, 0.7)], 21, upright=True, side=84)
    flat = surfaces.stack((ribs, 50), (surfaces.plain(tone), 50))
    return shape(
        [(body, skin), (cap, flat)],
        [*vessel_parts(body, r, shoulder * h, 0.0125, h, rise * h), hull_of(cap)],
    )


@category("beer_can", size=(0.066, 0.066, 0.149), mass=0.5, material="metal",
          aliases=("can of beer", "beer tin", "lager can", "tin of beer"), themes=("dining",),
          roles=("round", "tall"), colors=("green", "gold"))  # fmt: skip
def beer_can(look: Look) -> Shape:
    """A beer can."""
    return _can(look, 0.033, look.between(0.12, 0.165), look.pick(["BEER", "LAGER", "PILS", "IPA"]),
                ("green", "gold", "red", "navy", "white", "black"))  # fmt: skip


@category("whiskey_bottle", size=(0.0807, 0.0807, 0.274), mass=1.1, material="glass",
          aliases=("whisky bottle", "rum bottle", "vodka bottle", "gin bottle", "bottle of whiskey",
          "liquor bottle", "spirit bottle", "bottle of rum", "bottle of gin", "bottle of vodka",
          "bottle of whisky", "liquor", "whiskey", "whisky", "rum", "vodka"), themes=("dining",),
          roles=("tall", "round"), colors=("amber",))  # fmt: skip
def whiskey_bottle(look: Look) -> Shape:
    """A square-shouldered bottle of spirits with a label and a stopper."""
    r, h = look.between(0.038, 0.044), look.between(0.23, 0.27)
    color = look.color("amber", "bronze", "clear", "green", "brown", "amber")
    body = vessel(r, h, 0.0135, 0.62 * h, 0.74 * h, sides=look.pick([8, 32]))
    word = look.pick(["WHISKY", "RUM", "GIN", "VODKA", "BRANDY"])
    skin = label_skin(look, color, word, 0.14, 0.46, look.pick([(244, 238, 220), (34, 34, 38)]))
    cap = cylinder(0.017, 0.034, 22, bevel=0.002).move(z=h - 0.012)
    tone = surfaces.plain(look.own_color("black", "gold", "brown", "red"))
    return shape([(body, skin), (cap, tone)], [*vessel_parts(body, 0.92 * r, 0.62 * h, 0.0135, h,
                                                             0.74 * h), hull_of(cap)])  # fmt: skip


@category("sake_bottle", size=(0.0724, 0.0728, 0.141), mass=0.25, material="ceramic", hollow=True,
          aliases=("tokkuri", "sake flask", "sake decanter", "sake"), themes=("dining",),
          roles=("tall", "round"), colors=("white", "navy"))  # fmt: skip
def sake_bottle(look: Look) -> Shape:
    """A small porcelain sake bottle with a narrow neck."""
    r, h = look.between(0.033, 0.039), look.between(0.13, 0.155)
    color = look.color("white", "navy", "black", "sage", "sky", "terracotta", "cream")
    side = smooth([(0.72 * r, 0), (0.95 * r, 0.16 * h), (r, 0.42 * h), (0.72 * r, 0.66 * h),
                   (0.36 * r, 0.8 * h), (0.42 * r, 0.92 * h), (0.62 * r, h)], 3)  # fmt: skip
    body = lathe([(0, 0), *side, (0.5 * r, h), (0.3 * r, 0.9 * h), (0, 0.88 * h)], 30)
    low = hull_of(body.bend(lambda p: np.minimum(p, [1, 1, 0.62 * h])))
    return shape([(body, glaze_tile(look, color))],
                 [low, cylinder_part(0.4 * r, 0.38 * h, (0, 0, 0.62 * h))])  # fmt: skip


def cap_ribs(color: RGB) -> surfaces.Tile:
    """Return the ribbed side of a screw cap."""
    return surfaces.stripes([color, tint_color(color, 0.75)], 16, upright=True, side=64)


@category("bottle", size=(0.067, 0.067, 0.23), mass=0.5, material="glass", aliases=("water bottle",
          "juice bottle", "soda bottle", "plastic bottle", "drink", "juice", "water",
          "barber's bottle", "after sun bottle", "micellar water bottle"),
          themes=("dining", "kitchen", "office"), roles=("tall", "round"),
          colors=("green", "sky", "amber"), common=True)  # fmt: skip
def bottle(look: Look) -> Shape:
    """A bottle of water, juice, soda, beer or milk with a label and a cap."""
    kind = look.pick(["water", "juice", "soda", "beer", "milk", "flask"])
    r, h = look.between(0.03, 0.037), look.between(0.195, 0.24)
    neck, shoulder, rise = {"water": (0.0125, 0.7, 0.86), "juice": (0.0165, 0.66, 0.88),
                            "soda": (0.0125, 0.56, 0.86), "beer": (0.0125, 0.58, 0.76),
                            "milk": (0.018, 0.62, 0.86),
                            "flask": (0.022, 0.86, 0.93)}[kind]  # fmt: skip
    color = look.color(*{
        "water": ("sky", "clear", "cyan", "mint"),
        "juice": ("orange", "red", "yellow", "lime", "purple"),
        "soda": ("brown", "green", "orange", "clear", "maroon"),
        "beer": ("brown", "green", "amber"),
        "milk": ("white", "cream", "pink", "brown"),
        "flask": ("teal", "black", "silver", "coral", "navy", "sage", "white", "yellow"),
    }[kind])  # fmt: skip
    word = look.pick({
        "water": ["WATER", "PURE", "SPRING"], "juice": ["JUICE", "FRESH", "MANGO"],
        "soda": ["SODA", "COLA", "FIZZ"], "beer": ["LAGER", "ALE", "STOUT"],
        "milk": ["MILK", "DAIRY", "OAT"], "flask": ["TREK", "HYDRO", "GYM"],
    }[kind])  # fmt: skip
    waist = kind in ("water", "juice") and look.chance(0.6)
    body = vessel(r, h, neck, shoulder * h, rise * h, waist=waist)
    low, high = look.between(0.14, 0.26), look.between(0.46, 0.56)
    if kind == "flask":
        tile = look.surface(color, look.pick(["metal", "plastic"]))
        if look.chance(0.6):
            sign = prints.canvas(128, 128, color)
            prints.write(sign[:, 40:88], word, 0.5, 0.45, 0.14, tint_color(color, 0.4), bold=True)
            prints.fill(sign, 0, 0.86, 1, 0.14, tint_color(color, 0.6))
            tile = sign
    else:
        ground = look.pick([(244, 242, 234), (250, 226, 120), (34, 40, 52), (206, 226, 236)])
        tile = label_skin(look, color, word, low, high, ground)
    cap = cylinder(neck + 0.0017, 0.016, 20, bevel=0.001).move(z=h - 0.004)
    lid = cap_ribs(look.own_color("white", "red", "blue", "green", "black", "gold", "silver"))
    return shape(
        [(body, tile), (cap, lid)],
        [*vessel_parts(body, 0.86 * r if waist else r, shoulder * h, neck, h, rise * h),
         cylinder_part(neck + 0.0017, 0.016, (0, 0, h - 0.004))],
    )  # fmt: skip


@category("wine_bottle", size=(0.075, 0.075, 0.31), mass=1.2, material="glass",
          aliases=("wine", "bottle of wine", "champagne", "champagne bottle"), themes=("dining",),
          roles=("tall", "round"), colors=("green", "maroon"), common=True)  # fmt: skip
def wine_bottle(look: Look) -> Shape:
    """A tall bottle of wine or oil with a paper label and a foil cap or a cork."""
    kind = look.pick(["bordeaux", "burgundy", "champagne", "oil"])
    r, h = look.between(0.035, 0.04), look.between(0.285, 0.32)
    neck, shoulder, rise = {"bordeaux": (0.0135, 0.6, 0.73), "burgundy": (0.0135, 0.44, 0.76),
                            "champagne": (0.0145, 0.42, 0.82),
                            "oil": (0.013, 0.66, 0.76)}[kind]  # fmt: skip
    r = {"champagne": 1.08 * r, "oil": 0.86 * r}.get(kind, r)
    color = look.color("green", "olive", "maroon", "black", "amber", "teal", "brown", "mustard")
    word = look.pick(["ROSSO", "1998", "VALLEY", "BRUT", "OLIVE", "RESERVA", "BLANC"])
    body = vessel(r, h, neck, shoulder * h, rise * h)
    top = look.between(0.8, 0.88)
    foil = cylinder(neck + 0.0013, (1.01 - top) * h, 20, bevel=0.001).move(z=top * h)
    paper = look.pick([(244, 242, 234), (236, 224, 196), (40, 38, 40), (122, 30, 40)])
    skin = label_skin(look, tint_color(color, 0.55), word, look.between(0.1, 0.18),
                     min(shoulder - 0.03, look.between(0.36, 0.5)), paper)  # fmt: skip
    seal = look.own_color("crimson", "gold", "black", "green", "silver", "white")
    return shape(
        [(body, skin), (foil, surfaces.speckles(look.rng, seal, 3, 32))],
        [*vessel_parts(body, r, shoulder * h, neck, h, rise * h),
         cylinder_part(neck + 0.0013, (1.01 - top) * h, (0, 0, top * h))],
    )  # fmt: skip


def sauce_bottle(look: Look) -> Shape:
    """A bottle of ketchup, mustard or hot sauce: a squeeze bottle on its cap, or a glass bottle."""
    r, h = look.between(0.028, 0.034), look.between(0.14, 0.17)
    color = look.color("red", "yellow", "red", "brown", "green", "cream", "orange", "black")
    kind = look.pick(["squeeze", "squeeze", "glass", "turned"])
    word = "MUSTARD" if color[1] > 150 else "KETCHUP" if color[0] > 150 else "SAUCE"
    if min(color) > 150:
        word = "MAYO"
    ground = look.pick([tint_color(color, 0.8), (246, 244, 236), (250, 220, 90), (40, 90, 60)])
    cap = surfaces.plain(look.own_color("white", "white", "green", "red", "black", "gold"))
    if kind == "turned":
        base = cylinder(0.86 * r, 0.03, 24, bevel=0.002)
        flipped = lathe(
            [(0, 0), (0.8 * r, 0), (0.9 * r, 0.2 * h), (r, 0.5 * h), (0.96 * r, 0.92 * h),
             (0.8 * r, h), (0, h)], v=[0, 0.01, 0.2, 0.5, 0.9, 0.98, 1],
        )  # fmt: skip
        body = flipped.move(z=0.028)
        return shape([(body, label_skin(look, color, word, 0.3, 0.75, ground)), (base, cap)],
                     [cylinder_part(0.86 * r, 0.03), hull_of(body)])  # fmt: skip
    neck, shoulder, rise = (0.016, 0.72, 0.94) if kind == "squeeze" else (0.011, 0.5, 0.82)
    body = vessel(r, h, neck, shoulder * h, rise * h)
    tip = 0.0032 if kind == "squeeze" else neck + 0.0015
    nozzle = cylinder(neck - 0.001 if kind == "squeeze" else tip, 0.034, 18, top=tip)
    nozzle = nozzle.move(z=h + 0.006 if kind == "squeeze" else h - 0.006)
    collar = cylinder(neck + 0.0015, 0.009, 20, bevel=0.001).move(z=h - 0.002)
    return shape(
        [(body, label_skin(look, color, word, look.between(0.16, 0.28), shoulder - 0.1, ground)),
         (nozzle, cap), (collar, cap)],
        [*vessel_parts(body, r, shoulder * h, neck, h, rise * h), hull_of(nozzle, collar)],
    )  # fmt: skip


def _in(look: Look, color: str) -> Look:
    """Return ``look`` with a request for ``color``, unless a colour is already requested."""
    return Look(look.rng, {"color": color, **look.attributes})


@category("ketchup", size=(0.062, 0.062, 0.185), mass=0.5, material="plastic",
          aliases=("ketchup bottle", "bottle of ketchup", "tomato ketchup", "catsup", "bbq sauce",
          "barbecue sauce", "bbq sauce bottle"), themes=("dining", "kitchen"),
          roles=("tall", "round"), colors=("red",))  # fmt: skip
def ketchup(look: Look) -> Shape:
    """Ketchup in a red squeeze bottle standing on its cap, or in a glass bottle."""
    return sauce_bottle(_in(look, look.pick(["red", "red", "crimson"])))


@category("mustard_bottle", size=(0.062, 0.062, 0.185), mass=0.45, material="plastic",
          aliases=("bottle of mustard", "yellow mustard", "mustard", "mustard container"),
          themes=("dining", "kitchen"), roles=("tall", "round"), colors=("yellow",))  # fmt: skip
def mustard_bottle(look: Look) -> Shape:
    """Mustard in a yellow squeeze bottle standing on its cap, or in a glass bottle."""
    return sauce_bottle(_in(look, look.pick(["yellow", "yellow", "gold", "mustard"])))


@category("salad_dressing", size=(0.066, 0.066, 0.22), mass=0.42, material="glass",
          aliases=("salad dressing bottle", "dressing", "bottle of dressing", "ranch dressing",
          "vinaigrette", "salad sauce", "dressing bottle", "caesar dressing"),
          themes=("dining", "kitchen"), roles=("tall", "round"),
          colors=("cream", "olive"))  # fmt: skip
def salad_dressing(look: Look) -> Shape:
    """A slim-waisted, wide-capped bottle of salad dressing with either herbs or two layers."""
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
    return shape([(body, skin), (cap, surfaces.plain(tone))],
                 [*vessel_parts(body, 0.86 * r if waist else r, 0.6 * h, 0.013, h, 0.84 * h),
                  hull_of(cap)])  # fmt: skip


@category("soy_sauce", size=(0.0689, 0.0621, 0.147), mass=0.28, material="glass",
          aliases=("soy sauce bottle", "bottle of soy sauce", "soya sauce", "soy sauce dispenser",
          "worcestershire sauce"), themes=("dining", "kitchen"), roles=("tall",),
          colors=("red", "black"))  # fmt: skip
def soy_sauce(look: Look) -> Shape:
    """A small glass soy sauce dispenser with a spouted cap, or a bottle with a label."""
    color = look.color("red", "red", "green", "yellow", "black", "gold")
    dark = surfaces.plain((52, 26, 20))
    clear = surfaces.plain((196, 186, 178))
    if look.chance(0.6):
        r, h = look.between(0.03, 0.034), look.between(0.1, 0.12)
        body = lathe([(0, 0), (r, 0), (r, 0.02), (0.62 * r, 0.55 * h), (0.56 * r, 0.72 * h),
                      (0, 0.72 * h)], look.pick([28, 8]),
                     v=[0, 0.02, 0.15, 0.75, 0.97, 1])  # fmt: skip
        cap = lathe([(0, 0.7 * h), (0.68 * r, 0.7 * h), (0.7 * r, 0.84 * h), (0.4 * r, 0.97 * h),
                     (0, 0.98 * h)], 24)  # fmt: skip
        nose = [tube(smooth([(s * 0.45 * r, 0, 0.86 * h), (s * 0.95 * r, 0, 0.94 * h),
                             (s * 1.1 * r, 0, h)], 3), [0.004] * 6 + [0.002], 8)
                for s in (-1, 1)]  # fmt: skip
        tile = surfaces.stack((dark, 0.6), (clear, 0.4), side=96)
        return shape([(body, tile), (join([cap, *nose]), surfaces.plain(color))],
                     [hull_of(body), hull_of(cap), *(hull_of(n) for n in nose)])  # fmt: skip
    r, h = look.between(0.028, 0.033), look.between(0.17, 0.2)
    body = vessel(r, h, 0.0125, 0.55 * h, 0.78 * h)
    skin = label_skin(look, (56, 28, 20), look.pick(["SOY", "SHOYU", "TAMARI"]), 0.14, 0.48,
                    look.pick([(250, 230, 150), (244, 242, 234), (196, 42, 40)]))  # fmt: skip
    cap = cylinder(0.0145, 0.026, 22, bevel=0.001).move(z=h - 0.01)
    return shape([(body, skin), (cap, surfaces.plain(color))],
                 [*vessel_parts(body, r, 0.55 * h, 0.0125, h, 0.78 * h), hull_of(cap)])  # fmt: skip


@category("growler", size=(0.111, 0.111, 0.26), mass=1.6, material="glass",
          aliases=("beer growler", "beer jug bottle", "cider jug", "moonshine jug", "demijohn"),
          themes=("dining",), roles=("tall", "round"), colors=("brown",))  # fmt: skip
def growler(look: Look) -> Shape:
    """A growler: a brown glass jug with a label and a small ring handle at its neck."""
    k, color = look.between(0.9, 1.06), look.color("brown", "brown", "amber", "green", "black")
    r, h = 0.058 * k, 0.26 * k
    body = lathe([(0, 0), (0.96 * r, 0), (r, 0.02), (r, 0.58 * h), (0.7 * r, 0.76 * h),
                  (0.34 * r, 0.84 * h), (0.3 * r, 0.95 * h), (0, 0.95 * h)], 32,
                 v=[0, 0, 0.05, 0.55, 0.75, 0.85, 0.98, 1])  # fmt: skip
    label = prints.canvas(256, 128, tint_color(color, 0.55))
    front = label[:, 84:172]
    prints.disc(front, 0.5, 0.5, 0.34, (244, 236, 214))
    prints.write(
        front, look.pick(["ALE", "IPA", "BREW", "STOUT"]), 0.5, 0.5, 0.24, (60, 40, 30), bold=True
    )
    dark = surfaces.plain(tint_color(color, 0.55))
    tile = surfaces.stack((dark, 0.1), (label, 0.42), (dark, 0.48), side=192)
    cap = cylinder(0.34 * r, 0.03 * k, 20).move(z=0.93 * h)
    ring = torus(0.018 * k, 0.0045 * k, 20, 8).turn(0, np.pi / 2).move(0.034 * k, 0, 0.83 * h)
    return shape([(body, surfaces.fit(tile, 192, 256)), (cap, surfaces.plain((30, 30, 32))),
                  (ring, dark)], [hull_of(body), hull_of(ring), hull_of(cap)])  # fmt: skip


@category("carafe", size=(0.104, 0.104, 0.238), mass=0.9, material="glass", aliases=("decanter",
          "wine decanter", "whiskey decanter", "whisky decanter", "wine carafe", "water carafe",
          "glass carafe"), themes=("dining",), roles=("tall", "round"),
          colors=("clear",))  # fmt: skip
def carafe(look: Look) -> Shape:
    """A glass carafe, or a cut-glass decanter with a stopper, often with wine, water or whisky."""
    h = look.between(0.22, 0.28)
    full = look.pick([(120, 22, 36), (214, 150, 60), (206, 222, 228), (236, 170, 40)])
    color = look.color("clear", "clear", "sky", "mint", "amber", "green")
    clear, wet = surfaces.plain(tint_color(color, 1.2)), surfaces.plain(full)
    level = look.between(0.25, 0.45)
    tile = surfaces.stack((wet, level), (clear, 1 - level), side=128)
    steel = surfaces.plain((206, 212, 216))
    if look.chance(0.5):
        s = look.between(0.078, 0.09)
        body = lathe([(0, 0), (0.7 * s, 0), (0.7 * s, 0.48 * h), (0.24 * s, 0.6 * h),
                      (0.22 * s, 0.72 * h), (0.3 * s, 0.74 * h), (0, 0.74 * h)], 4,
                     v=[0, 0.01, 0.6, 0.7, 0.9, 0.95, 1]).turn(2, np.pi / 4)  # fmt: skip
        cut = surfaces.grid(tint_color(full, 1.25), full, 8, 16, 64)
        tile = surfaces.stack((cut, level), (clear, 1 - level), side=128)
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
        pieces.append((cork, surfaces.spots(look.rng, (206, 166, 116), (160, 120, 78), 0.1)))
        parts.append(hull_of(cork))
    return shape(pieces, parts)


CATEGORIES = (
    Category("sauce_bottle", sauce_bottle, size=(0.062, 0.062, 0.195), mass=0.4, material="glass",
             aliases=("squeeze bottle", "sauce", "sauce dispenser"), themes=("dining", "kitchen"),
             roles=("tall", "round"), colors=("red", "yellow"), common=True),
)  # fmt: skip
"""Objects that share their drawing functions."""
