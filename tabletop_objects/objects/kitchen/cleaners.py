"""Objects of the ``kitchen`` theme: cleaning supplies."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import steel
from ...kit.outlines import rectangle
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import lobe, rod, straight, vessel
from ...kit.prints import canvas, disc, wrap, write
from ...kit.shapes import Category, Pieces, Shape, category, keep_still, put_down, shape
from ...kit.solids import block, box, cylinder, join, lathe, loft, prism, tube
from ...kit.surfaces import RGB, Look, plain, tint_color
from ..living.clothes import hand_shape
from .utensils import with_handle


@category("wipes_canister", size=(0.083, 0.083, 0.21), mass=0.35, material="plastic",
          aliases=("wipes", "cleaning wipes", "disinfecting wipes", "wipe canister"),
          themes=("kitchen", "office"), roles=("tall", "round"), colors=("yellow", "green"),
          common=True)  # fmt: skip
def wipes_canister(look: Look) -> Shape:
    """A canister of cleaning wipes with one wipe pulled through its lid."""
    r, h = look.between(0.037, 0.044), look.between(0.16, 0.2)
    color = look.color("yellow", "green", "sky", "lavender", "orange", "teal", "white")
    accent = look.own_color("navy", "green", "blue", "teal", "purple")
    label = wrap(look, look.pick(["WIPES", "CLEAN", "FRESH", "WIPE"]), accent, color)
    white = surfaces.speckles(look.rng, look.own_color("white", "white", "blue", "green"), 3, 32)
    lid = lathe([(0, 0), (r + 0.001, 0), (r + 0.001, 0.014), (0.86 * r, 0.022), (0, 0.022)], 28)
    flap = block(1.1 * r, 0.9 * r, 0.006, 0.008, 0.001).move(z=h + 0.02)
    pieces = [(cylinder(r, h, 28), label), (lid.move(z=h), white), (flap, white)]
    if look.chance(0.6):
        sheet = lathe([(0, 0), (0.22 * r, 0), (0.3 * r, 0.012), (0.62 * r, 0.034), (0, 0.02)], 20)
        pieces.append((lobe(sheet, 5, 0.5).move(z=h + 0.024), surfaces.plain((246, 247, 248))))
    return shape(pieces, [cylinder_part(r, h + 0.024)])


@category("bleach", size=(0.12, 0.06, 0.239), mass=1.0, material="plastic",
          aliases=("bleach bottle", "bleach cleanser", "cleaner bottle", "cleanser",
          "fabric softener", "bottle of bleach", "toilet cleaner", "floor cleaner"),
          themes=("kitchen",), roles=("tall",), colors=("white", "blue"))  # fmt: skip
def bleach(look: Look) -> Shape:
    """A bottle of bleach or cleaner with a moulded handle and a ribbed cap."""
    color = look.color("white", "blue", "yellow", "green", "orange")
    k = look.between(0.9, 1.1)
    outline = rectangle(1, 1, 0.4, 5)
    levels = [(0.095, 0.056, 0), (0.1, 0.06, 0.01), (0.1, 0.06, 0.13), (0.07, 0.05, 0.18),
              (0.036, 0.034, 0.2), (0.03, 0.03, 0.215)]  # fmt: skip
    body = loft(np.stack([np.column_stack([outline * [a, b] - [0.2 * (0.1 - a), 0], np.full(
        len(outline), z)]) for a, b, z in levels]), outline)  # fmt: skip
    grip = rod([(-0.018, 0, 0.2), (0.03, 0, 0.195), (0.05, 0, 0.165), (0.046, 0, 0.12)],
               [0.009, 0.01, 0.011, 0.011], 10)  # fmt: skip
    cap = cylinder(0.019, 0.026, 20, bevel=0.001).move(-0.014, 0, 0.213)
    label = box(0.074, 0.001, 0.09).move(0, -0.0302, 0.025)
    hue = look.own_color("blue", "red", "green", "navy")
    image = canvas(96, 112, hue)
    disc(image, 0.5, 0.62, 0.2, (250, 250, 246))
    write(
        image, look.pick(["BLEACH", "CLEAN", "POWER"]), 0.5, 0.24, 0.16, (250, 250, 246), bold=True
    )
    pieces: Pieces = [(join([body, grip]), look.surface(color, "plastic")),
                      (cap, surfaces.plain(hue)), (label, image)]  # fmt: skip
    return put_down(pieces, body, grip, cap, factor=k)


@category("sponge", size=(0.1, 0.065, 0.033), mass=0.008, material="fabric", friction=0.8,
          aliases=("kitchen sponge", "dish sponge", "scrubber", "scouring pad", "steel wool",
          "wire wool", "swiffer pad", "scourer", "scouring sponge", "make up sponge"),
          themes=("kitchen", "vanity"), roles=("flat",), colors=("yellow",), state="lying flat",
          common=True)  # fmt: skip
def sponge(look: Look) -> Shape:
    """A kitchen sponge with its scouring side up or down."""
    x, y = look.between(0.09, 0.11), look.between(0.06, 0.07)
    soft, pad = look.between(0.022, 0.028), look.between(0.007, 0.01)
    color = look.color("yellow", "pink", "sky", "orange", "lime", "yellow")
    foam = surfaces.spots(look.rng, color, tint_color(color, 0.72), 0.12)
    scour = look.own_color("green", "green", "navy", "charcoal", "red")
    rough = surfaces.scratches(look.rng, scour, tint_color(scour, 0.7), 260)
    lower = block(x, y, soft, 0.006, 0.003)
    upper = block(x, y, pad, 0.006, 0.001).move(z=soft - 0.0005)
    if look.chance(0.35):
        lower = block(x, y, pad, 0.006, 0.001)
        upper = block(x, y, soft, 0.006, 0.003).move(z=pad - 0.0005)
        foam, rough = rough, foam
    return shape([(lower, foam), (upper, rough)], [box_part(x, y, soft + pad - 0.0005)])


@category("bottle_brush", size=(0.26, 0.0357, 0.0347), mass=0.04, material="plastic",
          aliases=("bottle cleaning brush", "test tube brush", "tube brush"), themes=("kitchen",),
          colors=("white", "blue"))  # fmt: skip
def bottle_brush(look: Look) -> Shape:
    """A long, thin bottle brush lying flat, with bristles around a twisted wire and a handle."""
    color = look.color("white", "blue", "pink", "green", "yellow")
    k = look.between(0.8, 1.1)
    t = np.linspace(0, 1, 60)
    path = np.column_stack([0.02 + 0.11 * t, 0 * t, 0.019 + 0 * t])
    brush = tube(path, 0.0175 * (1 + 0.12 * (-1) ** np.arange(60)), 14)
    wire = straight((-0.1, 0, 0.019), (0.135, 0, 0.019), 0.0022, 8)
    wire = wire.bend(lambda p: np.column_stack([p[:, :2], p[:, 2] - 0.013
                                                * np.clip((0.0 - p[:, 0]) / 0.1, 0,
                                                          1)]))  # fmt: skip
    handle = rod([(-0.08, 0, 0.009), (-0.15, 0, 0.0075)], [0.006, 0.008], 10)
    fur = surfaces.scratches(look.rng, color, tint_color(color, 0.8), 120)
    return put_down([(brush, fur), (wire, steel(look)), (handle, plain(look.own_color("blue",
                                                                                      "green",
                                                                                      "white")))],
                    straight((0.02, 0, 0.0185), (0.13, 0, 0.0185), 0.018, 14), handle, wire,
                    factor=k, foot=0.3)  # fmt: skip


@category("dish_soap", size=(0.082, 0.046, 0.24), mass=0.55, material="plastic",
          aliases=("washing up liquid", "dishwashing liquid", "dish soap bottle", "dish detergent",
          "detergent", "detergent bottle", "dishwasher soap", "washing-up liquid bottle",
          "washing-up liquid", "washing up liquid bottle"), themes=("kitchen",), roles=("tall",),
          colors=("green", "yellow"))  # fmt: skip
def dish_soap(look: Look) -> Shape:
    """A flat bottle of washing-up liquid with a push-pull cap."""
    x, h = look.between(0.075, 0.09), look.between(0.2, 0.235)
    color = look.color("green", "yellow", "sky", "orange", "blue", "lime", "pink")
    body = vessel(x / 2, h, 0.014, 0.66 * h, 0.93 * h, waist=look.chance(0.6)).scale(1, 0.56, 1)
    label = prints.label(look.rng, look.pick(["DISH", "CLEAN", "FRESH", "LEMON"]),
                         look.own_color("navy", "green", "red", "teal"),
                         (244, 244, 240))  # fmt: skip
    skin = surfaces.speckles(look.rng, color, 3, 32)
    tile = surfaces.stack((skin, 0.14), (label, 0.4), (skin, 0.46), side=192)
    cap = [cylinder(0.017, 0.016, 20, bevel=0.001).move(z=h - 0.004),
           cylinder(0.01, 0.016, 16, top=0.007).move(z=h + 0.011)]  # fmt: skip
    tone = look.own_color("white", "red", "blue", "green", "yellow")
    return shape([(body, tile), (join(cap), surfaces.plain(tone))],
                 [box_part(0.86 * x, 0.5 * x, 0.66 * h), hull_of(*cap), hull_of(body)])  # fmt: skip


def _swatter(look: Look, color: RGB, z: float) -> Pieces:
    plate = prism(rectangle(0.11, 0.1, 0.02), 0, 0.0022).move(-0.055, 0, z - 0.001)
    return [(plate, prints.mesh_holes(tint_color(color, 1.15), tint_color(color, 0.5), 12, 12))]


TONES = ("red", "blue", "green", "yellow", "teal", "pink", "gray", "orange")


@category("dustpan", size=(0.315, 0.19, 0.045), mass=0.15, material="plastic", assembled=True,
          aliases=("dust pan", "dustpan and brush"), themes=("kitchen",), colors=("red", "blue"),
          state="lying flat")  # fmt: skip
def dustpan(look: Look) -> Shape:
    """A dustpan lying flat, with its handle on the right."""
    color = look.color(*TONES)
    floor = prism(
        [(-0.12, -0.1), (0.05, -0.075), (0.065, 0), (0.05, 0.075), (-0.12, 0.1)], 0, 0.004
    )
    walls = [prism([(-0.12, 0.002), (0.05, 0.002), (0.05, 0.045), (-0.1, 0.012)], -0.002,
                   0.002).turn(0, np.pi / 2).turn(2, -s * 0.146).move(0.005, s * 0.083, 0)
             for s in (-1, 1)]  # fmt: skip
    back = box(0.005, 0.152, 0.045).move(0.052)
    grip = rod([(0.05, 0, 0.03), (0.1, 0, 0.024), (0.2, 0, 0.02)], [0.014, 0.0115, 0.013], 12)
    lip = box(0.008, 0.196, 0.003).move(-0.118)
    return put_down([(join([floor, *walls, back, grip]), look.surface(color, "plastic")),
                    (lip, surfaces.plain((60, 60, 64)))], floor, back, grip,
                   factor=look.between(0.85, 1.05))  # fmt: skip


@category("scrub_brush", size=(0.15, 0.055, 0.042), mass=0.1, material="wood",
          aliases=("scrubbing brush", "cleaning brush", "dish brush", "washing brush", "shoe brush",
          "clothes brush", "bristle brush", "grill brush", "group head brush", "wire brush",
          "washing-up brush", "washing up brush", "back brush", "nail brush", "dry body brush",
          "carding brush", "body brush"), themes=("kitchen",), colors=("wooden", "red"),
          state="lying")  # fmt: skip
def scrub_brush(look: Look) -> Shape:
    """A scrubbing brush lying on its bristles."""
    color = look.color("wooden", "red", "blue", "green", "white", "teal")
    x, y = look.between(0.13, 0.17), look.between(0.05, 0.06)
    top = block(x, y, 0.02, 0.025, 0.005).move(z=0.022)
    tufts = [cylinder(0.0042, 0.024, 6, top=0.0034).move((i - 5) * x / 12.5, (j - 1.5) * y / 5)
             for i in range(11) for j in range(4)]  # fmt: skip
    bristle = surfaces.plain(look.pick([(240, 236, 224), (214, 186, 140), (70, 110, 180)]))
    return put_down([(top, look.surface(color, "wood")), (join(tufts), bristle)], top, join(tufts))


@category("rubber_glove", size=(0.266, 0.146, 0.0237), mass=0.05, material="rubber",
          aliases=("latex glove", "cleaning glove", "dish glove", "household glove"),
          themes=("kitchen",), colors=("yellow",), state="lying flat")  # fmt: skip
def rubber_glove(look: Look) -> Shape:
    """A rubber glove with a long cuff, lying flat."""
    return hand_shape(look, ("yellow", "yellow", "pink", "blue", "green"), 0.09, knit=False)


CATEGORIES = (
    Category("fly_swatter", keep_still(with_handle(_swatter, (0.09, 0.12), 0.2, ("red", "blue",
             "green", "yellow", "pink"))), size=(0.427, 0.102, 0.0203), mass=0.04,
             material="plastic", assembled=True, aliases=("fly swat", "fly-swatter", "swatter"),
             themes=("kitchen",), colors=("black", "red"), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
