"""Objects of the ``kitchen`` theme: cans."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle
from ...kit.parts import box_part, cylinder_part, hull_of, open_vessel
from ...kit.primitives import packet
from ...kit.prints import turned_to, wrap
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, torus
from ...kit.surfaces import RGB, Look, readable_on, tint_color

WORDS = ("COLA", "FIZZ", "LIME", "ORANGE", "TONIC", "CHERRY", "BERRY", "ROOT")


@category("soda_can", size=(0.062, 0.062, 0.13), mass=0.36, material="metal",
          aliases=("can of soda", "coke can", "cola can", "can of cola", "can of coke", "pop can",
          "fizzy drink can", "aluminum can", "aluminium can", "soft drink", "coke", "soda", "cola",
          "pepsi"), themes=("kitchen", "dining", "office", "gaming"), roles=("round", "tall"),
          colors=("red", "blue"))  # fmt: skip
def soda_can(look: Look) -> Shape:
    """An aluminium can of soda or energy drink, tapered at both ends, with a pull tab."""
    slim = look.chance(0.3)
    r, h = (0.0265, look.between(0.134, 0.16)) if slim else (0.033, look.between(0.115, 0.125))
    color = look.color("red", "blue", "green", "orange", "silver", "purple", "black", "yellow",
                       "cyan", "pink")  # fmt: skip
    ground = look.pick(
        [(240, 240, 240), tint_color(color, 0.6), tint_color(color, 1.5), (206, 210, 214)]
    )
    art = prints.label(look.rng, look.pick(WORDS), color, ground)
    steel = surfaces.brushed_metal(look.rng, (200, 203, 208))
    body = lathe(
        [(0, 0.006), (0.72 * r, 0.004), (0.8 * r, 0), (0.84 * r, 0.001), (r, 0.012), (r, h - 0.015),
         (0.84 * r, h - 0.003), (0.86 * r, h), (0.8 * r, h), (0.77 * r, h - 0.004), (0, h - 0.004)],
        30, v=[0, 0.01, 0.015, 0.02, 0.1, 0.88, 0.965, 0.97, 0.98, 0.99, 1],
    )  # fmt: skip
    tile = surfaces.stack((steel, 5), (art, 88), (steel, 7), side=160)
    z = h - 0.0042
    tab = [block(0.012, 0.022, 0.0014, 0.005).move(y=-0.004, z=z + 0.001),
           cylinder(0.0035, 0.003, 10).move(z=z)]  # fmt: skip
    mouth = cylinder(0.008, 0.0006, 16).move(y=-0.011, z=z - 0.0002)
    return shape(
        [(body, tile), (join(tab), steel), (mouth, surfaces.plain((150, 152, 158)))],
        [cylinder_part(r, h - 0.027, (0, 0, 0.012)), cylinder_part(0.85 * r, h)],
    )


@category("meat_can", size=(0.1, 0.06, 0.083), mass=0.37, material="metal", aliases=("spam",
          "spam can", "luncheon meat", "canned meat", "potted meat can", "ham can",
          "rectangular can"), themes=("kitchen", "food"), colors=("navy", "blue"),
          common=True)  # fmt: skip
def meat_can(look: Look) -> Shape:
    """A rectangular can of luncheon meat with a pull ring."""
    x, y, h = look.between(0.09, 0.105), look.between(0.055, 0.062), look.between(0.075, 0.088)
    color, ground = (look.color("navy", "blue", "red", "green"), look.own_color("yellow", "cream",
                                                                                "sky"))  # fmt: skip
    word = look.pick(["MEAT", "HAM", "PORK", "BEEF", "TUNA"])
    outline, share = rectangle(x, y, 0.018, 5), x / (x + y) / 2
    label = turned_to(wrap(look, word, ground, color, share=share), share / 2 + 0.03)
    tin = surfaces.brushed_metal(look.rng, (190, 190, 186))
    body = packet(outline, [(0.003, 1, 1), (h - 0.004, 1, 1)])
    ends = [block(x + 0.003, y + 0.003, 0.004, 0.0185, 0.001).move(z=z) for z in (0, h - 0.005)]
    ring = torus(0.009, 0.0014, 18, 6).scale(1, 0.8, 1).move(0.18 * x, 0, h + 0.0005)
    key = box(0.016, 0.006, 0.001).move(x=0.33 * x, z=h - 0.001)
    return shape([(body, label), (join([*ends, ring, key]), tin)], [hull_of(*ends)])


@category("tea_tin", size=(0.078, 0.078, 0.122), mass=0.18, material="metal", aliases=("tea caddy",
          "tin of tea", "tea canister", "coffee tin", "tobacco tin", "pill case", "snuff box",
          "bait tin", "formula tin", "mess tin", "bar keeper's tin", "etui", "vesta case",
          "ant trap"), themes=("kitchen", "tea"), colors=("green", "red"), common=True)  # fmt: skip
def tea_tin(look: Look) -> Shape:
    """A round or square tin of tea with its lid on."""
    w, h = look.between(0.07, 0.085), look.between(0.1, 0.14)
    color = look.color("green", "red", "teal", "navy", "gold", "black", "maroon")
    other = look.own_color("gold", "cream", "mustard", "sage")
    word = look.pick(["TEA", "CHAI", "GREEN", "EARL", "OOLONG"])
    label = wrap(look, word, other, color, fronts=2, share=0.22)
    lid_tile = surfaces.speckles(look.rng, tint_color(color, look.pick([0.75, 1.3])), 4)
    if look.chance(0.5):
        body, lid = cylinder(w / 2, 0.8 * h, 32), cylinder(w / 2 + 0.001, 0.2 * h, 32, bevel=0.002)
        part = cylinder_part(w / 2, h)
        knob = torus(0.4 * w, 0.0015, 28, 6).move(z=h)
    else:
        body = packet(rectangle(w, w, 0.006, 2), [(0, 1, 1), (0.8 * h, 1, 1)])
        label = turned_to(label, 0.135)
        lid, part = block(w + 0.002, w + 0.002, 0.2 * h, 0.007, 0.003), box_part(w, w, h)
        knob = block(0.6 * w, 0.6 * w, 0.004, 0.005, 0.001).move(z=h - 0.001)
    return shape([(body, label), (lid.move(z=0.8 * h), lid_tile), (knob, lid_tile)], [part])


PRINTS = ("red", "navy", "teal", "green", "mustard", "crimson", "orange", "purple", "blue")


@category("can", size=(0.068, 0.068, 0.113), mass=0.36, material="metal", aliases=("tin can",),
          themes=("kitchen", "dining", "office"), roles=("round",), colors=("red", "navy", "green"),
          opened="open_can", common=True)  # fmt: skip
def can(look: Look) -> Shape:
    """A tin of soup or a can of soda."""
    soup = look.chance(0.5)
    r, h = (look.between(0.033, 0.037), look.between(0.1, 0.112)) if soup else (0.033, 0.12)
    color = look.color(*PRINTS)
    word = look.pick(["SOUP", "BEANS", "TOMATO", "CORN"] if soup else ["COLA", "FIZZ", "LIME"])
    print_ = prints.label(look.rng, word, color, (244, 240, 228) if soup
                          else tint_color(color, look.pick([0.75, 1.5])))  # fmt: skip
    steel = surfaces.plain((196, 198, 202))
    rim = 0.0022 if soup else 0.005
    body = lathe(
        [(0, 0.001), (r - rim, 0), (r, rim), (r, h - rim), (r - rim, h),
         (r - rim - 0.002, h - 0.002), (0, h - 0.002)],
        v=[0, 0.02, 0.04, 0.96, 0.98, 0.99, 1],
    )  # fmt: skip
    tile = surfaces.stack((steel, 4), (print_, 92), (steel, 4), side=160)
    pull = torus(0.007, 0.0016, 16, 6).scale(1, 1.4, 0.8).move(y=-0.006, z=h - 0.0015)
    return shape([(body, tile), (pull, surfaces.plain((168, 170, 176)))], [cylinder_part(r, h)])


STEEL: RGB = (196, 199, 204)
PALE: RGB = (246, 244, 238)
Make = Callable[[Look], Shape]


def tin(words: tuple[str, ...], palette: tuple[str, ...], form: tuple[float, float], lid: str
        ) -> Make:  # fmt: skip
    """Return a labelled tin; ``form`` is (radius, height), and ``lid`` is "push" or "ring"."""

    def make(look: Look) -> Shape:
        k = look.between(0.92, 1.08)
        r, h = form[0] * k, form[1] * look.between(0.94, 1.08)
        color = look.color(*palette)
        ground = look.pick([PALE, (250, 232, 170), tint_color(color, 0.5)])
        label = prints.label(look.rng, look.pick(words), color, ground)
        metal = surfaces.brushed_metal(look.rng, STEEL if lid == "ring" else (206, 180, 110))
        body = cylinder(0.985 * r, 0.94 * h, 36).move(z=0.03 * h)
        rims = [cylinder(r, 0.035 * h, 36, bevel=0.0006), cylinder(r, 0.035 * h, 36, bevel=0.0006)
                .move(z=0.965 * h)]  # fmt: skip
        pieces: list[tuple[Solid, surfaces.Tile]] = [(body, label), (join(rims), metal)]
        if lid == "push":
            cap = cylinder(0.86 * r, 0.004, 32, bevel=0.001).move(z=h - 0.0004)
            pieces.append((cap, metal))
            return shape(pieces, [cylinder_part(r, h + 0.0034)])
        top = cylinder(0.9 * r, 0.0006, 32).move(z=h - 0.0003)
        tab = box(0.012, 0.02, 0.0012).move(0, -0.3 * r, h)
        pieces += [(top, surfaces.brushed_metal(look.rng, tint_color(STEEL, 0.92))), (tab, metal)]
        return shape(pieces, [cylinder_part(r, h), hull_of(tab)])

    return make


@category("open_can", size=(0.079, 0.079, 0.1115), mass=0.06, material="metal",
          aliases=("empty can", "empty tin can", "open can"), themes=("kitchen",),
          roles=("container", "round"), colors=("silver",))  # fmt: skip
def open_can(look: Look) -> Shape:
    """A tin can without a lid."""
    r, h = look.between(0.036, 0.042), look.between(0.105, 0.118)
    metal = surfaces.brushed_metal(look.rng, (176, 178, 182))
    color = look.own_color("silver", "red", "green", "navy", "cream")
    body, parts = open_vessel([(r, 0), (r, h)], 0.0025, 0.004)
    sleeve = lathe([(r, 0.1 * h), (r + 0.0006, 0.1 * h), (r + 0.0006, 0.9 * h), (r, 0.9 * h)], 32,
                   loop=True)  # fmt: skip
    return shape([(body, metal), (sleeve, surfaces.speckles(look.rng, color, 4))], parts)


Pieces = list[tuple[Solid, surfaces.Tile]]
CREAM: RGB = (246, 240, 222)


def _draw(front: prints.Canvas, what: str, x: float, y: float, r: float) -> None:
    """Draw a tomato, fish, bowl of soup, bee, nut or berries at (x, y) on a label's front."""
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


def _label(look: Look, title: str, color: RGB, ground: RGB, what: str) -> surfaces.Tile:
    """Return a wrap-round label with bands, a title over a picture, and small print at the back."""
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


def _tin(look: Look, r: float, h: float, label: surfaces.Tile, *, ribs: bool = False) -> Pieces:
    """Return a food can of radius ``r`` with rims, a label and sometimes a pull ring."""
    steel = surfaces.brushed_metal(look.rng, look.own_color("silver", "silver", "gold", spread=4))
    rim = min(0.004, 0.06 * h)
    body = lathe([(0, 0.0015), (r - 0.003, 0.0015), (r - 0.001, 0), (r, rim / 2), (r - 0.0012, rim),
                  (r - 0.0012, h - rim), (r, h - rim / 2), (r - 0.001, h), (r - 0.003, h - 0.0025),
                  (0, h - 0.0025)], 32,
                 v=[0, 0.01, 0.015, 0.02, 0.03, 0.95, 0.96, 0.97, 0.98, 1])  # fmt: skip
    tile = surfaces.stack((steel, 3), (label, 92), (steel, 5), side=200)
    top = [torus(k * r, 0.0008, 26, 5).move(z=h - 0.0025) for k in (0.82, 0.5)]
    if look.chance(0.6) or ribs:
        ring = torus(0.0085, 0.0014, 18, 6).scale(1, 1.25, 1).move(y=-0.3 * r, z=h - 0.001)
        tab = cylinder(0.005, 0.002, 12).move(y=-0.68 * r, z=h - 0.003)
        top += [ring, tab]
    return [(body, tile), (join(top), steel)]


@category("soup_can", size=(0.07, 0.07, 0.106), mass=0.38, material="metal", aliases=("can of soup",
          "tin of soup", "soup tin", "can of beans", "bean can", "baked beans", "tin of beans",
          "corn can", "can of corn", "alphabet soup", "alphabet soup can", "chicken soup",
          "canned soup", "canned food", "food can", "campbell soup can", "can of baked beans"),
          themes=("kitchen", "food"), roles=("round",), colors=("red", "green"),
          opened="open_can")  # fmt: skip
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


@category("tomato_can", size=(0.076, 0.076, 0.103), mass=0.42, material="metal", assembled=True,
          aliases=("can of tomatoes", "tomato soup can", "tomato tin", "canned tomatoes",
          "tomato sauce", "tomato sauce can", "tomato paste", "tomato soup", "tin of tomatoes",
          "can of tomato soup", "sauce can"), themes=("kitchen", "food"), roles=("round",),
          colors=("red", "green"))  # fmt: skip
def tomato_can(look: Look) -> Shape:
    """A tin of whole or chopped tomatoes, tomato sauce or tomato paste."""
    paste = look.chance(0.2)
    r, h = (0.026, 0.06) if paste else (look.between(0.034, 0.045), look.between(0.1, 0.12))
    color = look.color("red", "green", "yellow", "crimson", "navy", "black")
    word = "PASTE" if paste else look.pick(["TOMATO", "POMODORI", "SAUCE", "CHOPPED"])
    label = _label(
        look, word, color, look.pick([CREAM, (250, 250, 248), (250, 230, 140)]), "tomato"
    )
    return shape(_tin(look, r, h, label), [cylinder_part(r, h)])


@category("tuna_can", size=(0.083, 0.083, 0.038), mass=0.19, material="metal",
          aliases=("can of tuna", "tuna", "tuna fish can", "tin of tuna", "tuna tin", "fish can",
          "sardine can", "sardine tin", "canned fish", "tin of sardines", "sardines",
          "can of sardines"), themes=("kitchen", "food"), roles=("round", "flat"),
          colors=("blue", "red"))  # fmt: skip
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


@category("coffee_can", size=(0.102, 0.102, 0.14), mass=0.42, material="metal",
          aliases=("can of coffee", "coffee tub", "ground coffee", "master chef can",
          "coffee canister"), themes=("kitchen", "coffee"), roles=("round",),
          colors=("red", "blue"))  # fmt: skip
def coffee_can(look: Look) -> Shape:
    """A large round tin of ground coffee with a plastic lid."""
    r, h = look.between(0.047, 0.053), look.between(0.13, 0.15)
    color = look.color("red", "blue", "green", "brown", "black", "maroon", "gold")
    ground = look.pick([tint_color(color, 0.75), (60, 40, 30), CREAM, tint_color(color, 0.55)])
    label = prints.label(look.rng, look.pick(["COFFEE", "ROAST", "CAFE", "MASTER"]), color, ground)
    pieces = _tin(look, r, h - 0.004, label)
    lid = cylinder(r + 0.0015, 0.014, 34, bevel=0.002).move(z=h - 0.012)
    tone = look.pick([tint_color(color, 0.6), (240, 238, 232), (40, 40, 44), (200, 40, 40)])
    pieces.append((lid, surfaces.speckles(look.rng, tone, 3, 32)))
    return shape(pieces, [cylinder_part(r, h - 0.012), hull_of(lid)])


CATEGORIES = (
    Category("cocoa_tin", tin(("COCOA", "BAKING", "CUSTARD", "CHOCOLATE", "MUSTARD"), ("brown",
             "red", "yellow", "navy", "green"), (0.042, 0.115), "push"),
             size=(0.0853, 0.0853, 0.118), mass=0.3, material="metal", aliases=("tin of cocoa",
             "baking powder tin", "baking powder", "custard powder tin", "custard powder",
             "drinking chocolate tin", "cocoa powder", "tin of custard powder", "hot chocolate tin",
             "mustard powder tin", "powder tin"), themes=("kitchen",), roles=("round",),
             colors=("brown",)),
    Category("syrup_tin", tin(("SYRUP", "TREACLE", "MILK", "GOLDEN"), ("green", "gold", "red",
             "blue", "navy"), (0.038, 0.085), "push"), size=(0.0752, 0.0752, 0.0885), mass=0.5,
             material="metal", aliases=("golden syrup tin", "treacle tin", "condensed milk tin",
             "golden syrup", "treacle", "tin of treacle", "condensed milk", "tin of golden syrup",
             "evaporated milk", "tin of condensed milk", "molasses tin"), themes=("kitchen",),
             roles=("round",), colors=("green", "gold")),
    Category("fruit_tin", tin(("PEACHES", "PINEAPPLE", "BEANS", "CHICKPEAS", "PEAS", "SPAGHETTI"),
             ("yellow", "teal", "orange", "green", "blue"), (0.037, 0.108), "ring"),
             size=(0.073, 0.073, 0.109), mass=0.45, material="metal", aliases=("can of pineapple",
             "tin of peaches", "can of peaches", "baked bean tin", "tin of pineapple",
             "can of chickpeas", "tinned fruit", "canned fruit", "tin of peas", "fruit can",
             "food tin", "can of fruit", "canned peas", "tin of chickpeas", "pineapple tin",
             "peach tin", "fruit cocktail tin"), themes=("kitchen",), roles=("round",),
             colors=("yellow",)),
    Category("caviar_tin", tin(("CAVIAR", "SAFFRON", "PATE", "BALM"), ("navy", "black", "gold",
             "red"), (0.034, 0.024), "push"), size=(0.0683, 0.0683, 0.0277), mass=0.09,
             material="metal", aliases=("saffron tin", "tin of caviar", "caviar", "snuff tin",
             "pate tin", "salve tin", "pastille tin"), themes=("kitchen",), roles=("round", "flat"),
             colors=("navy",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
