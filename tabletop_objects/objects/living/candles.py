"""Objects of the ``living`` theme: candles."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, cylinder_part, hull_of, hull_part
from ...kit.primitives import ball, bent_rod, limb, lobe, straight
from ...kit.shapes import Pieces, Shape, category, put_down, settle, shape
from ...kit.solids import box, cylinder, join, lathe, open_box, prism, sweep
from ...kit.surfaces import Look, tint_color
from .religious_items import branch


@category("wax_melt", size=(0.0425, 0.0438, 0.0152), mass=0.01, material="wax",
          aliases=("scented wax melt", "wax cube", "scented wax", "wax tart"), themes=("living",),
          colors=("pink",))  # fmt: skip
def wax_melt(look: Look) -> Shape:
    """A scented wax melt: a small fluted block of wax."""
    k = look.between(0.9, 1.15)
    color = look.color("pink", "lavender", "cream", "mint", "coral", "yellow")
    body = lathe([(0, 0), (0.02, 0), (0.016, 0.013), (0.013, 0.015), (0, 0.015)], 30)
    flute = body.bend(lambda p: p * np.column_stack([*[1 + 0.08 * np.cos(8 * np.arctan2(
        p[:, 1], p[:, 0]))] * 2, np.ones(len(p))]))  # fmt: skip
    return shape([(flute, surfaces.speckles(look.rng, color, 6))], [hull_of(flute)]).scale(k)


WAXES = ("white", "cream", "red", "green", "navy", "pink", "purple", "yellow", "sage")
FLAME = surfaces.gradient((250, 160, 40), (255, 236, 140), np.random.default_rng(0), 2)
WICK = surfaces.plain((50, 44, 40))


@category("tea_light", size=(0.0384, 0.0384, 0.0299), mass=0.015, material="metal",
          aliases=("tealight", "tea candle", "tealight candle", "tea light candle",
          "floating candle"), themes=("living",), roles=("round",), colors=("white",))  # fmt: skip
def tea_light(look: Look) -> Shape:
    """A tea light: a thin metal cup of wax with a wick, sometimes lit."""
    r, h = look.between(0.018, 0.021), look.between(0.014, 0.018)
    color = look.color("white", "white", "cream", "red", "green", "purple", "yellow")
    cup = lathe([(0, 0), (r, 0), (r, h), (0.93 * r, h), (0.93 * r, 0.8 * h), (0, 0.8 * h)], 28)
    wax = cylinder(0.92 * r, 0.002, 26).move(z=0.79 * h)
    wick = cylinder(0.0009, 0.007, 6).move(z=0.8 * h)
    foil = surfaces.brushed_metal(look.rng, (204, 206, 210))
    pieces: Pieces = [(cup, foil), (wax, surfaces.plain(color)), (wick, WICK)]
    if look.chance(0.5) or look.attributes.get("state") in ("lit", "burning"):
        pieces.append((ball(0.006, 0.006, 0.015, (0, 0, 0.8 * h + 0.013), 10), FLAME))
    made = shape(pieces, [cylinder_part(r, h)])
    return made.scale(look.between(0.9, 1.15))


@category("taper_candle", size=(0.072, 0.072, 0.24), mass=0.2, material="wax", assembled=True,
          aliases=("taper", "dinner candle", "stick candle", "tall candle",
          "candle in a candlestick", "rushlight"), themes=("living", "dining"), roles=("tall",),
          colors=("white", "red"))  # fmt: skip
def taper_candle(look: Look) -> Shape:
    """A slim taper candle in a small holder."""
    h, r = look.between(0.17, 0.24), look.between(0.009, 0.011)
    color = look.color(*WAXES)
    foot = lathe([(0, 0), (0.034, 0), (0.036, 0.005), (0.018, 0.012), (0.014, 0.03), (0, 0.03)], 24)
    stick = cylinder(r, h, 18, top=0.75 * r).move(z=0.026)
    wick = cylinder(0.0009, 0.01, 6).move(z=h + 0.026)
    wax = surfaces.speckles(look.rng, color, 4)
    pieces: Pieces = [(foot, look.surface(look.own_color("gold", "silver", "black", "white"),
                                          "metal")), (stick, wax), (wick, WICK)]  # fmt: skip
    if look.chance(0.5):
        pieces.append((ball(0.009, 0.009, 0.022, (0, 0, h + 0.042), 10), FLAME))
    return put_down(pieces, foot, stick)


@category("votive_candle", size=(0.0662, 0.0662, 0.0823), mass=0.2, material="glass",
          aliases=("votive", "votive holder", "jar candle", "candle jar", "candle in a glass",
          "glass candle", "tea light holder", "tealight holder"), themes=("living",),
          roles=("round",), colors=("amber", "red"))  # fmt: skip
def votive_candle(look: Look) -> Shape:
    """A candle in a coloured tumbler."""
    r, h = look.between(0.03, 0.037), look.between(0.06, 0.08)
    color = look.color("amber", "red", "teal", "purple", "green", "blue", "pink", "white")
    cup = lathe(
        [(0, 0), (0.85 * r, 0), (r, h), (0.92 * r, h), (0.86 * r, 0.7 * h), (0, 0.7 * h)], 28
    )
    wax = cylinder(0.85 * r, 0.003, 26).move(z=0.69 * h)
    wick = cylinder(0.001, 0.009, 6).move(z=0.7 * h)
    flame = ball(0.01, 0.01, 0.024, (0, 0, 0.7 * h + 0.02), 10)
    glass = surfaces.gradient(tint_color(color, 1.4), color, look.rng)
    pieces: Pieces = [(cup, glass), (wax, surfaces.plain((246, 238, 220))), (wick, WICK),
                      (flame, FLAME)]  # fmt: skip
    return put_down(pieces, cup)


@category("candelabra", size=(0.13, 0.105, 0.22), mass=0.7, material="metal", assembled=True,
          aliases=("candelabrum", "branched candlestick", "three armed candlestick"),
          themes=("living", "dining"), roles=("tall",), colors=("gold", "silver"),
          opened="empty_candelabra")  # fmt: skip
def candelabra(look: Look) -> Shape:
    """A candelabra with three or five candles."""
    return branch(look, look.pick([3, 5]), True)


@category("incense_holder", size=(0.24, 0.036, 0.08), mass=0.06, material="wood", assembled=True,
          aliases=("incense", "incense stick", "incense burner", "incense sticks", "mosquito coil"),
          themes=("living",), colors=("wooden",))  # fmt: skip
def incense_holder(look: Look) -> Shape:
    """A boat-shaped wooden incense holder with one glowing stick in it."""
    color = look.color("wooden", "brown", "black", "tan", "white")
    long = look.between(0.22, 0.26)
    path = smooth([(-long / 2, 0, 0.006), (0.1 * long, 0, 0.006), (0.4 * long, 0, 0.012),
                   (long / 2, 0, 0.028)], 4)  # fmt: skip
    board = sweep(path, rectangle(0.036, 0.008, 0.003, 2))
    stick = straight((0.43 * long, 0, 0.02), (-0.36 * long, 0, 0.075), 0.0013, 6)
    ember = ball(0.004, 0.003, 0.004, (-0.362 * long, 0, 0.0753), 6)
    pieces: Pieces = [(board, look.surface(color, "wood")), (stick, surfaces.plain((120, 84, 60))),
                      (ember, surfaces.plain((240, 120, 50)))]  # fmt: skip
    low = board.move(z=-float(board.bounds[0, 2]))
    up = float(low.bounds[0, 2] - board.bounds[0, 2])
    pieces = [(s.move(z=up), t) for s, t in pieces]
    x = low.vertices[:, 0]
    return shape(pieces, [hull_part(low.vertices[x < 0.12 * long]),
                          hull_part(low.vertices[x > 0.05 * long])])  # fmt: skip


@category("oil_burner", size=(0.09, 0.09, 0.1), mass=0.3, material="ceramic",
          aliases=("aroma burner", "oil diffuser", "wax melter", "fragrance burner",
          "essential oil burner", "aroma diffuser", "reed diffuser", "wax burner"),
          themes=("living",), roles=("round",), colors=("white", "teal"))  # fmt: skip
def oil_burner(look: Look) -> Shape:
    """An oil burner: a perforated pot with a tea light inside and a dish of oil above."""
    color = look.color("white", "teal", "terracotta", "black", "purple", "sage", "navy")
    r, h = look.between(0.04, 0.048), look.between(0.09, 0.11)
    pot = lathe([(0, 0), (0.9 * r, 0), (r, 0.3 * h), (0.8 * r, 0.8 * h), (0, 0.8 * h)], 28)
    dish = lathe([(0, 0.76 * h), (0.7 * r, 0.76 * h), (1.05 * r, h), (0.97 * r, h),
                  (0.66 * r, 0.86 * h), (0, 0.84 * h)], 28)  # fmt: skip
    arch = prism([(-0.45 * r, 0), (0.45 * r, 0), (0.45 * r, 0.3 * h), (0.2 * r, 0.46 * h),
                  (-0.2 * r, 0.46 * h), (-0.45 * r, 0.3 * h)], 0,
                 0.004).turn(0, np.pi / 2)  # fmt: skip
    arch = arch.move(0, -0.93 * r, 0.1 * h)
    flame = ball(0.012, 0.006, 0.024, (0, -0.955 * r, 0.26 * h), 10)
    oil = cylinder(0.8 * r, 0.002, 26).move(z=0.905 * h)
    pieces: Pieces = [(join([pot, dish]), look.surface(color, "ceramic")),
                      (arch, surfaces.plain((60, 40, 30))), (flame, FLAME),
                      (oil, surfaces.plain((226, 196, 110)))]  # fmt: skip
    return put_down(pieces, pot, dish)


@category("matchbox", size=(0.085, 0.042, 0.018), mass=0.012, material="paper",
          aliases=("box of matches", "match box", "matches box", "matchbox collection"),
          themes=("living", "kitchen"), colors=("red", "blue"), state="lying")  # fmt: skip
def matchbox(look: Look) -> Shape:
    """A matchbox lying flat with its drawer pulled out to show the matches."""
    color = look.color("red", "blue", "yellow", "green", "orange", "teal")
    x, y, h = 0.056, 0.037, 0.016
    image = prints.canvas(112, 72, color)
    prints.disc(image, 0.5, 0.5, 0.34, tint_color(color, 1.7))
    prints.write(image, look.pick(["MATCHES", "SAFETY", "FLAME"]), 0.5, 0.5, 0.2,
                 tint_color(color, 0.5), bold=True)  # fmt: skip
    sleeve = box(x, y, h)
    top = box(x - 0.001, y - 0.001, 0.0006).move(z=h - 0.0002)
    strike = box(x - 0.002, y + 0.0008, h - 0.004).move(z=0.002)
    out = look.between(0.012, 0.026)
    drawer = open_box(out, y - 0.003, h - 0.003, 0.0012, 0.0012)
    drawer = [s.move(-x / 2 - out / 2 + 0.0005, 0, 0.0015) for s in drawer]
    sticks = [box(out - 0.003, 0.0021, 0.0021).move(-x / 2 - out / 2, 0.0035 * n, 0.009 + 0.002
                                                    * (n % 2)) for n in range(-4, 5)]  # fmt: skip
    heads = [ball(0.0045, 0.0032, 0.0032, (-x / 2 - out + 0.0045, 0.0035 * n, 0.0101 + 0.002
                                           * (n % 2)), 8) for n in range(-4, 5)]  # fmt: skip
    pieces: Pieces = [(sleeve, surfaces.plain(color)), (top, image),
                      (strike, surfaces.plain((96, 70, 60))),
                      (join(drawer), surfaces.plain((236, 228, 208))),
                      (join(sticks), surfaces.plain((226, 196, 140))),
                      (join(heads), surfaces.plain((190, 44, 40)))]  # fmt: skip
    made = shape(pieces, [box_part(x, y, h), hull_of(*drawer)])
    return made.scale(look.between(0.95, 1.3))


GAY = ("red", "blue", "yellow", "green", "pink", "purple", "orange", "teal")


@category("birthday_candle", size=(0.024, 0.024, 0.072), mass=0.004, material="wax",
          aliases=("cake candle", "party candle"), themes=("living",), roles=("round",),
          colors=("pink", "blue"))  # fmt: skip
def birthday_candle(look: Look) -> Shape:
    """A thin, striped, burning candle in a flower-shaped holder."""
    h = look.between(0.05, 0.065)
    wax = surfaces.stripes([look.color(*GAY), (250, 250, 246)], 4)
    petals = lobe(cylinder(0.011, 0.008, 24, bevel=0.001), 6, 0.15)
    stick = cylinder(0.0036, h, 12).move(z=0.006)
    flame = ball(0.007, 0.007, 0.014, (0, 0, h + 0.011), 8)
    pieces: Pieces = [(petals, surfaces.plain((250, 250, 246))), (stick, wax),
                      (flame, surfaces.plain((252, 196, 60)))]  # fmt: skip
    return put_down(pieces, petals, stick)


@category("candle_snuffer", size=(0.272, 0.0262, 0.0261), mass=0.08, material="metal",
          assembled=True, aliases=("snuffer", "candle extinguisher", "brass snuffer"),
          themes=("living",), colors=("brass",), state="lying flat")  # fmt: skip
def candle_snuffer(look: Look) -> Shape:
    """A candle snuffer lying flat: a small bell at the end of a long handle."""
    k = look.between(0.92, 1.08)
    color = look.color("brass", "silver", "copper", "black")
    bell = lathe([(0, 0), (0.003, 0), (0.013, 0.022), (0.0115, 0.022), (0, 0.006)], 20).turn(
        1, np.pi / 2 + 0.5).move(0.105, 0, 0.024)  # fmt: skip
    stem = limb([(-0.13, 0, 0.006), (0.0, 0, 0.006), (0.08, 0, 0.012), (0.106, 0, 0.024)],
                [0.0035, 0.0032, 0.0028, 0.0026], 8)  # fmt: skip
    grip = bent_rod(0.08, 0.0065, blunt=5).move(x=-0.1, z=0.0065)
    metal = surfaces.brushed_metal(look.rng, color)
    return settle([(join([bell, stem]), metal), (grip, look.surface(look.own_color("brown",
                                                                                   "black"),
                                                                    "wood"))], 0.02,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip
