"""On a shop's or cafe's counter: signs, holders, collecting tins, cash boxes, bags."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, frame_parts, hull_of
from ...build.recipes import Pieces, rod, straight
from ...build.settled import limb
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, open_box, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

PAPER: RGB = (248, 247, 242)
CLEAR: RGB = (214, 226, 230)


def _menu_page(look: Look, color: RGB, wide: int, tall: int) -> textures.Tile:
    image = prints.canvas(wide, tall, color)
    ink = readable_on(color)
    prints.write(image, look.pick(["MENU", "MENU", "BISTRO", "CAFE"]), 0.5, 0.12, 0.1, ink,
                 bold=True)  # fmt: skip
    prints.fill(image, 0.3, 0.19, 0.4, 0.008, ink)
    for n in range(9):
        y = 0.27 + 0.075 * n
        prints.fill(image, 0.1, y, look.between(0.35, 0.55), 0.014, ink)
        prints.fill(image, 0.82, y, 0.09, 0.014, ink)
    return image


def _acrylic(page: Callable[[Look, RGB, int, int], textures.Tile], form: tuple[float, float],
             pocket: bool) -> Callable[[Look], Shape]:  # fmt: skip
    """Return a leaning clear holder with a page in it; a deep ``pocket`` holds leaflets."""

    def make(look: Look) -> Shape:
        k = look.between(0.94, 1.06)
        x, h = form[0] * k, form[1] * k
        color = look.color("white", "cream", "sky", "yellow", "red")
        lean = 0.28
        back = box(x, 0.003, h).turn(0, -lean).move(y=0.012)
        sheet = box(0.94 * x, 0.0012, 0.94 * h).move(y=-0.002, z=0.03 * h).turn(0, -lean).move(
            y=0.012)  # fmt: skip
        foot = block(x, 0.075 * k, 0.003, 0.004).move(y=0.02)
        glass = textures.plain(CLEAR)
        pieces: Pieces = [(join([back, foot]), glass), (sheet, page(look, color, 120, 170))]
        bodies = [back, foot]
        if pocket:
            stack = box(0.92 * x, 0.018, 0.8 * h).move(y=-0.011, z=0.02).turn(0, -lean).move(
                y=0.012)  # fmt: skip
            front = box(x, 0.003, 0.4 * h).move(y=-0.024).turn(0, -lean).move(y=0.012)
            pieces = [(join([back, foot, front]), glass), (stack, page(look, color, 120, 170))]
            bodies += [stack, front]
        low = min(float(s.bounds[0, 2]) for s in bodies)
        pieces = [(s.move(z=-low), t) for s, t in pieces]
        return shape(pieces, [hull_of(s.move(z=-low)) for s in bodies])

    return make


def _leaflet(look: Look, color: RGB, wide: int, tall: int) -> textures.Tile:
    image = prints.canvas(wide, tall, color)
    ink = readable_on(color)
    image[int(0.24 * tall) : int(0.6 * tall)] = textures.fit(prints.landscape(look.rng, 120, 60),
        int(0.6 * tall) - int(0.24 * tall), wide)  # fmt: skip
    prints.write(image, look.pick(["WELCOME", "TOURS", "OFFERS", "VISIT"]), 0.5, 0.13, 0.1, ink,
                 bold=True)  # fmt: skip
    prints.lines(image, look.rng, (0.12, 0.66, 0.76, 0.28), 6, ink)
    return image


def shop_sign(look: Look) -> Shape:
    """A hanging sign with its cord, lying: OPEN or CLOSED."""
    k = look.between(0.92, 1.08)
    word = look.pick(["OPEN", "OPEN", "CLOSED"])
    color = look.color("red", "green", "navy", "black", "white", "wooden")
    x, y = 0.2 * k, 0.1 * k
    board = block(x, y, 0.006, 0.01, 0.001)
    image = prints.canvas(200, 100, color)
    ink = readable_on(color)
    prints.fill(image, 0.03, 0.06, 0.94, 0.88, ink)
    prints.fill(image, 0.045, 0.09, 0.91, 0.82, color)
    prints.write(image, word, 0.5, 0.5, 0.42, ink, bold=True)
    face = box(0.95 * x, 0.92 * y, 0.0006).move(z=0.0057)
    cord = rod([(-0.4 * x, 0.46 * y, 0.005), (-0.1 * x, 0.95 * y, 0.0022), (0.1 * x, 0.95 * y,
                0.0022), (0.4 * x, 0.46 * y, 0.005)], 0.0017, 6)  # fmt: skip
    return shape([(board, look.surface(color, "wood")), (face, image),
                  (cord, textures.plain((206, 184, 140)))],
                 [box_part(x, y, 0.006), hull_of(cord)])  # fmt: skip


def collecting_tin(look: Look) -> Shape:
    """A round collecting tin: a slot in its lid, a handle, a label."""
    r, h = look.between(0.04, 0.046), look.between(0.12, 0.14)
    color = look.color("red", "blue", "yellow", "green", "purple")
    label = prints.label(look.rng, look.pick(["DONATE", "CHARITY", "HELP", "THANK YOU"]), color,
                         (248, 246, 240))  # fmt: skip
    body = cylinder(r, h, 34)
    lid = cylinder(1.03 * r, 0.012, 34, bevel=0.002).move(z=h - 0.002)
    slot = box(0.036, 0.004, 0.0006).move(z=h + 0.0099)
    grip = torus(0.024, 0.0035, 20, 8).turn(1, np.pi / 2).turn(2, np.pi / 2)
    grip = grip.turn(2, np.pi / 2).scale(1, 1, 1.3).move(y=1.0 * r, z=0.55 * h)
    return shape([(body, label), (join([lid, grip]), textures.plain(tint_color(color, 0.7))),
                  (slot, textures.plain((24, 24, 28)))],
                 [cylinder_part(1.0 * r, h + 0.01), hull_of(lid), hull_of(grip)])  # fmt: skip


def cash_tin(look: Look) -> Shape:
    """A steel cash box with a folding handle and a lock."""
    k = look.between(0.92, 1.1)
    color = look.color("red", "black", "blue", "gray", "green", "navy")
    x, y, h = 0.2 * k, 0.15 * k, 0.08 * k
    low = block(x, y, 0.66 * h, 0.008, 0.002)
    top = block(1.02 * x, 1.02 * y, 0.36 * h, 0.009, 0.004).move(z=0.64 * h)
    grip = rod([(-0.2 * x, 0, h - 0.002), (-0.18 * x, 0, h + 0.008), (0.18 * x, 0, h + 0.008),
                (0.2 * x, 0, h - 0.002)], 0.0034, 8)  # fmt: skip
    lock = cylinder(0.009, 0.003, 18).turn(0, np.pi / 2).move(y=-0.5 * y, z=0.5 * h)
    key = box(0.002, 0.0012, 0.008).move(y=-0.5 * y - 0.0032, z=0.5 * h - 0.004)
    steel = textures.brushed_metal(look.rng, (196, 199, 204))
    paint = textures.speckles(look.rng, color, 4)
    return shape([(low, textures.speckles(look.rng, tint_color(color, 0.9), 4)), (top, paint),
                  (join([grip, lock]), steel), (key, textures.plain((30, 30, 32)))],
                 [hull_of(low), hull_of(top), hull_of(grip), hull_of(lock)])  # fmt: skip


def spike(look: Look) -> Shape:
    """A spike on a round foot with receipts on it."""
    k = look.between(0.9, 1.1)
    color = look.color("black", "wooden", "silver", "red")
    foot = cylinder(0.04, 0.012, 28, bevel=0.002)
    needle = straight((0, 0, 0.01), (0, 0, 0.14), [0.0018, 0.0006], 8)
    slips = [box(0.07, 0.1, 0.0012).turn(2, look.between(-0.5, 0.5)).move(
             look.between(-0.006, 0.006), look.between(-0.01, 0.01), 0.013 + 0.005 * n)
             for n in range(6)]  # fmt: skip
    page = prints.canvas(64, 96, PAPER)
    prints.lines(page, look.rng, (0.1, 0.1, 0.8, 0.8), 12, (130, 130, 136))
    return shape([(foot, look.surface(color, "metal")), (needle, textures.plain((190, 194, 198))),
                  (join(slips), page)],
                 [hull_of(foot), hull_of(*slips), hull_of(needle)]).scale(k)  # fmt: skip


def open_bag(look: Look) -> Shape:
    """A brown paper bag standing open."""
    k = look.between(0.92, 1.08)
    color = look.color("tan", "tan", "white", "brown", "beige")
    x, y, h, t = 0.16 * k, 0.105 * k, 0.2 * k, 0.0024
    walls = open_box(x, y, h, t, t)
    paper = textures.speckles(look.rng, color, 9)
    fold = [box(0.0016, y * 0.98, 0.0016).move(x=s * x / 2, z=0.5 * h) for s in (-1, 1)]
    creases = [
        tube(
            [(s * x / 2, -y / 2, 0.001), (s * x / 2, 0, 0.4 * h), (s * x / 2, y / 2, 0.001)],
            0.0012,
            5,
        )
        for s in (-1, 1)
    ]
    return shape([(join(walls), paper), (join([*fold, *creases]), textures.plain(
                  tint_color(color, 0.82)))], frame_parts(x, y, h, t, t))  # fmt: skip


def cup_tray(look: Look) -> Shape:
    """A moulded pulp tray with four round places for cups."""
    k = look.between(0.95, 1.06)
    color = look.color("gray", "beige", "tan")
    x, h = 0.21 * k, 0.045 * k
    base = block(x, x, 0.35 * h, 0.03, 0.003)
    rings = []
    for i in (-1, 1):
        for j in (-1, 1):
            ring = lathe(
                [(0.033, 0.3 * h), (0.046, 0.3 * h), (0.044, h), (0.037, h)], 26, loop=True
            )
            rings.append(ring.move(0.25 * x * i, 0.25 * x * j, 0))
    pulp = textures.spots(look.rng, color, tint_color(color, 0.86), 0.2)
    bars = [block(0.9 * x, 0.014, 0.7 * h, 0.004).turn(2, a) for a in (0, np.pi / 2)]
    parts = [box_part(x, x, 0.35 * h), *(hull_of(b) for b in bars)]
    return shape([(join([base, *rings, *bars]), pulp)],
                 [*parts, *(hull_of(r) for r in rings)])  # fmt: skip


def price_gun(look: Look) -> Shape:
    """A labelling gun lying on its side: a body, a pistol grip, a roll of labels."""
    k = look.between(0.92, 1.06)
    color = look.color("orange", "blue", "yellow", "red", "green")
    body = block(0.13, 0.05, 0.034, 0.012, 0.004)
    grip = block(0.035, 0.1, 0.03, 0.012, 0.004).turn(2, -0.25).move(0.035, -0.06, 0.001)
    roll = cylinder(0.026, 0.028, 26).move(-0.01, 0.036, 0.003)
    lever = limb([(-0.01, -0.02, 0.016), (0.0, -0.06, 0.016), (0.012, -0.09, 0.016)],
                 [0.006, 0.006, 0.005], 8)  # fmt: skip
    labels = box(0.05, 0.016, 0.0008).move(-0.088, 0.0, 0.008)
    return shape(
        [
            (join([body, grip]), textures.speckles(look.rng, color, 4)),
            (join([roll, labels]), textures.plain((250, 246, 220))),
            (lever, textures.plain((40, 42, 46))),
        ],
        [hull_of(body), hull_of(grip), hull_of(roll), hull_of(lever)],
    ).scale(k)


_O = ("office",)
_F = ("flat",)
_L = "lying flat"


CATEGORIES = (
    Category("sign_holder", _acrylic(_menu_page, (0.15, 0.2), False), (0.15, 0.0865, 0.194), 0.15,
             ("menu holder", "acrylic sign holder", "menu stand", "table sign", "acrylic sign",
              "sign stand", "table talker", "countertop sign", "menu board"), _O, ("tall",),
             ("white",)),
    Category("leaflet_holder", _acrylic(_leaflet, (0.115, 0.19), True), (0.114, 0.0823, 0.181),
             0.35, ("brochure holder", "leaflet stand", "leaflet dispenser", "brochure stand",
             "pamphlet holder", "flyer holder"), _O, ("tall",), ("sky",)),
    Category("shop_sign", shop_sign, (0.197, 0.151, 0.00648), 0.12, ("open sign", "closed sign",
             "hanging sign", "door sign", "open closed sign", "sign", "name plaque",
             "house sign"), _O, _F, ("red", "green"), state=_L),
    Category("collection_tin", collecting_tin, (0.0907, 0.117, 0.14), 0.2, ("collecting tin",
             "charity tin", "donation tin", "donation box", "charity box",
             "charity collection tin", "collection box"), _O, ("round", "tall"), ("red",)),
    Category("cash_tin", cash_tin, (0.207, 0.157, 0.0937), 1.1, ("cash box",
             "lock box", "lockbox", "petty cash tin", "petty cash box",
             "metal cash box", "deed box", "strongbox", "safe box"), _O, ("support",), ("red",
             "black")),
    Category("receipt_spike", spike, (0.112, 0.136, 0.146), 0.25, ("bill spike", "paper spike",
             "spindle of receipts", "order spike", "spike file"), _O, (), ("black",)),
    Category("open_paper_bag", open_bag, (0.166, 0.109, 0.204), 0.03, ("open bag", "paper sack",
             "empty paper bag", "open brown bag", "sack", "open shopping bag",
             "paper shopping bag", "empty bag"), ("kitchen",), ("container", "tall"), ("tan",)),
    Category("cup_carrier", cup_tray, (0.211, 0.211, 0.0452), 0.04, ("cup tray", "drink carrier",
             "drinks carrier", "coffee cup carrier", "cup holder tray", "coffee carrier"),
             ("coffee",), _F, ("gray",)),
    Category("price_gun", price_gun, (0.177, 0.171, 0.0338), 0.3, ("pricing gun", "labelling gun",
             "label gun", "labeling gun", "price tag gun", "tagging gun"), _O, (), ("orange",),
             state=_L),
)  # fmt: skip
"""The module's categories."""
