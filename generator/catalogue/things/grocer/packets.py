"""Groceries in tubes, packets, sachets and trays, hampers, lids."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import pillow
from ...build.recipes import ball
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, loft
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

STEEL: RGB = (196, 199, 204)
PALE: RGB = (246, 244, 238)
Make = Callable[[Look], Shape]


def panel(look: Look, word: str, color: RGB, wide: int = 120, tall: int = 120) -> textures.Tile:
    """Return the print of a lid or front: a title on a band over a ground, a round picture."""
    image = prints.canvas(wide, tall, color)
    prints.disc(image, 0.5, 0.7, 0.24, tint_color(color, 1.55))
    prints.disc(image, 0.5, 0.7, 0.15, tint_color(color, 0.7))
    prints.fill(image, 0, 0.16, 1, 0.28, PALE)
    prints.write(image, word, 0.5, 0.31, 0.17, tint_color(color, 0.55), bold=True)
    return image


def squeezed_tube(look: Look) -> Shape:
    """A soft metal tube of tomato paste lying, its cap to the right."""
    k = look.between(0.92, 1.08)
    color = look.color("red", "red", "green", "gold", "blue")
    t = np.linspace(0, 1, 9)
    n = 20
    a = 2 * np.pi * np.arange(n) / n
    rings = []
    for s in t:
        flat = 0.06 + 0.94 * s**0.7
        wide = 0.027 * (1.12 - 0.12 * s)
        rings.append(np.column_stack([np.full(n, 0.13 * s), wide * np.cos(a),
                                      0.02 * flat * np.sin(a)]))  # fmt: skip
    rings.append(np.column_stack([np.full(n, 0.138), 0.01 * np.cos(a), 0.01 * np.sin(a)]))
    body = loft(np.stack(rings), np.column_stack([np.cos(a), np.sin(a)]))
    foil = block(0.012, 0.06, 0.003, 0.001).move(x=0.0, z=-0.0015)
    cap = cylinder(0.011, 0.022, 20, bevel=0.001).turn(1, np.pi / 2).move(x=0.136)
    word = look.pick(["TOMATO", "PUREE", "PASTE"])
    sign = prints.canvas(130, 64, color)
    prints.disc(sign, 0.16, 0.5, 0.3, (216, 50, 36) if color[0] < 180 else (250, 230, 190))
    prints.write(sign[:, 34:], word, 0.5, 0.5, 0.32, readable_on(color), bold=True)
    lay = box(0.072, 0.024, 0.0006).turn(1, -0.075).move(x=0.074, z=0.0178)
    body, foil, cap, lay = (s.move(x=-0.075, z=0.0) for s in (body, foil, cap, lay))
    solids = [s.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2] + 0.011, 0)]))
              for s in (body, foil, cap, lay)]  # fmt: skip
    return shape(
        [
            (solids[0], textures.brushed_metal(look.rng, color)),
            (solids[1], textures.brushed_metal(look.rng, STEEL)),
            (solids[2], textures.plain(look.own_color("white", "red", "green"))),
            (solids[3], sign),
        ],
        [hull_of(solids[0], solids[1]), hull_of(solids[2])],
    ).scale(k)


def soft_pack(words: tuple[str, ...], palette: tuple[str, ...], form: tuple[float, float, float],
              seam: bool = True) -> Make:  # fmt: skip
    """Return a filled plastic or paper packet lying flat, its ends crimped."""

    def make(look: Look) -> Shape:
        k = look.between(0.92, 1.08)
        x, y, h = (v * k for v in form)
        color = look.color(*palette)
        u = np.linspace(-1, 1, 15)
        gx, gy = np.meshgrid(u, u)
        swell = np.clip((1 - gx**6) * (1 - gy**4), 0, 1) ** 0.5
        lift = 0.5 * h * (0.03 + 0.97 * swell)
        body = pillow(0.5 * x * gx, 0.5 * y * gy, lift)
        low = 0.3 * h
        body = body.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2] + low, 0)]))
        image = panel(look, look.pick(words), color, 150, max(int(150 * y / x), 48))
        if seam:
            for left in (0.0, 0.95):
                prints.fill(image, left, 0, 0.05, 1, tint_color(color, 0.8))
        return shape([(body, image)], [hull_of(body)])

    return make


def tray_meal(look: Look) -> Shape:
    """A ready meal: a black tray with food in parts under a printed sleeve."""
    k = look.between(0.95, 1.06)
    x, y, h = 0.19 * k, 0.14 * k, 0.036 * k
    color = look.color("green", "red", "navy", "purple", "orange", "brown")
    tray = block(x, y, 0.8 * h, 0.018, 0.004)
    rim = block(1.04 * x, 1.05 * y, 0.004, 0.02, 0.001).move(z=0.78 * h)
    stew = block(0.52 * x, 0.84 * y, 0.004, 0.012, 0.0015).move(x=-0.21 * x, z=0.86 * h)
    mash = block(0.34 * x, 0.4 * y, 0.004, 0.01, 0.0015).move(x=0.27 * x, y=0.22 * y, z=0.86 * h)
    peas = block(0.34 * x, 0.38 * y, 0.004, 0.01, 0.0015).move(x=0.27 * x, y=-0.22 * y, z=0.86 * h)
    bed = block(0.97 * x, 0.96 * y, 0.003, 0.014).move(z=0.84 * h)
    band = box(0.24 * x, 1.07 * y, 0.0012).move(x=0.0, z=0.97 * h)
    sign = prints.canvas(70, 200, color)
    prints.fill(sign, 0, 0.3, 1, 0.4, PALE)
    prints.write(sign, look.pick(["MEAL", "DINNER", "READY", "CURRY"]), 0.5, 0.5, 0.11,
                 tint_color(color, 0.6), bold=True)  # fmt: skip
    return shape([(join([tray, rim]), textures.plain((36, 36, 40))),
                  (bed, textures.plain((52, 50, 50))),
                  (stew, textures.spots(look.rng, (150, 82, 40), (212, 130, 60), 0.2)),
                  (mash, textures.speckles(look.rng, (244, 230, 176), 8)),
                  (peas, textures.spots(look.rng, (104, 164, 70), (70, 120, 50), 0.4)),
                  (band, sign)], [hull_of(tray), hull_of(rim, band)])  # fmt: skip


def foil_cube(look: Look) -> Shape:
    """A stock cube in coloured foil, folded like a parcel."""
    k = look.between(0.95, 1.25)
    color = look.color("gold", "red", "green", "silver", "amber")
    x, h = 0.024 * k, 0.018 * k
    cube = block(x, x, h, 0.002, 0.0012)
    folds = [box(0.86 * x, 0.002 * k, 0.0012).turn(2, s * 0.6).move(z=h - 0.0006) for s in (-1, 1)]
    foil = textures.brushed_metal(look.rng, color)
    return shape([(cube, foil), (join(folds), textures.plain(tint_color(color, 0.7)))],
                 [box_part(x, x, h + 0.0004)])  # fmt: skip


def hamper(look: Look) -> Shape:
    """A wicker hamper filled with bottles, jars and fruit, a ribbon on its front."""
    k = look.between(0.94, 1.06)
    color = look.color("tan", "brown", "bronze")
    x, y, h = 0.3 * k, 0.2 * k, 0.11 * k
    body = block(x, y, h, 0.015)
    straw = block(0.94 * x, 0.9 * y, 0.006, 0.012).move(z=h - 0.003)
    wine = [cylinder(0.031, 0.12, 22).move(-0.09 * k, 0.03, h), cylinder(0.011, 0.07, 16).move(
            -0.09 * k, 0.03, h + 0.118)]  # fmt: skip
    jars = [cylinder(0.032, 0.06, 22, bevel=0.003).move(0.0, 0.04, h),
            cylinder(0.032, 0.055, 22, bevel=0.003).move(0.075 * k, 0.035, h)]  # fmt: skip
    lids = [cylinder(0.03, 0.014, 22).move(0.0, 0.04, h + 0.06),
            cylinder(0.03, 0.014, 22).move(0.075 * k, 0.035, h + 0.055)]  # fmt: skip
    fruit = [ball(0.06, 0.06, 0.056, (dx * k, -0.045, h + 0.018), 14) for dx in (-0.09, 0.095)]
    pack = block(0.09, 0.05, 0.05, 0.002).move(0.0, -0.045, h)
    bow = [ball(0.05, 0.014, 0.034, (s * 0.028, -0.5 * y - 0.006, 0.62 * h), 12) for s in (-1, 1)]
    tie = box(0.02, 1.01 * y, 1.01 * h)
    weave = textures.basketwork(look.rng, color, 16)
    red = textures.plain(look.own_color("red", "gold", "green"))
    return shape(
        [
            (body, weave),
            (straw, textures.scratches(look.rng, (222, 196, 130), (186, 150, 84), 120)),
            (join(wine), textures.plain((36, 60, 44))),
            (join(jars), textures.plain((190, 60, 40))),
            (join(lids), textures.plain((222, 184, 80))),
            (join(fruit), textures.speckles(look.rng, (216, 60, 50), 12)),
            (pack, panel(look, "TEA", (40, 80, 140), 90, 50)),
            (join([*bow, tie]), red),
        ],
        [
            box_part(x, y, h + 0.003),
            hull_of(*wine),
            hull_of(*jars, *lids),
            hull_of(pack),
            hull_of(*bow),
            *(hull_of(f) for f in fruit),
        ],
    )


def round_lid(look: Look) -> Shape:
    """A plastic lid lying: a coffee cup's with its sip hole, or a plain one of a jar."""
    r = look.between(0.04, 0.046)
    color = look.color("white", "black", "white", "brown")
    low = lathe([(0, 0), (r, 0), (1.0 * r, 0.004), (0.93 * r, 0.006), (0.88 * r, 0.016),
                 (0.8 * r, 0.0165), (0.76 * r, 0.012), (0, 0.012)], 34)  # fmt: skip
    hole = block(0.012, 0.004, 0.0008, 0.0018).move(0, -0.84 * r, 0.016)
    tone = textures.plain(tint_color(color, 0.5))
    rib = lathe([(0, 0.0118), (0.34 * r, 0.0118), (0.32 * r, 0.0128), (0, 0.0128)], 24)
    return shape([(join([low, rib]), textures.speckles(look.rng, color, 3, 32)), (hole, tone)],
                 [hull_of(low)])  # fmt: skip


def jar_lid(look: Look) -> Shape:
    """The screw lid of a jar lying on its rim."""
    r, h = look.between(0.032, 0.038), look.between(0.013, 0.016)
    color = look.color("gold", "red", "white", "green", "black", "silver")
    body = cylinder(r, h, 36, bevel=0.0016)
    ribs = textures.stripes([color, tint_color(color, 0.82)], 32, upright=True, side=128)
    top = cylinder(0.86 * r, 0.0008, 34).move(z=h - 0.0005)
    return shape([(body, ribs), (top, textures.speckles(look.rng, tint_color(color, 1.1), 4))],
                 [cylinder_part(r, h)])  # fmt: skip


_K = ("kitchen",)
_F = ("flat",)
_L = "lying flat"


CATEGORIES = (
    Category("paste_tube", squeezed_tube, (0.161, 0.0594, 0.0315), 0.15, ("tomato paste tube",
             "tomato puree tube", "tube of tomato puree", "tomato puree", "anchovy paste tube",
             "harissa tube", "tube of tomato paste", "mustard tube", "wasabi tube"), _K, (),
             ("red",), state=_L),
    Category("food_packet", soft_pack(("NOODLES", "CHEESE", "HAM", "MASALA", "PASTA", "NUTS"),
             ("red", "orange", "green", "blue", "yellow", "purple"), (0.15, 0.105, 0.03)),
             (0.15, 0.105, 0.0239), 0.15, ("ramen packet", "packet of noodles", "noodle packet",
             "cheese packet", "ham packet", "sausage packet", "packet of ham", "packet of cheese",
             "garam masala packet", "spice packet", "packet of peanuts", "peanut packet",
             "salted peanut packet", "packet of nuts", "packet of sausages", "packet of bacon",
             "bacon packet", "frozen peas", "bag of frozen peas", "packet of ramen",
             "soup packet", "packet", "food pouch", "cat food pouch",
             "packet of soup", "snack packet", "jerky packet", "packet of spices"), _K, _F,
             ("red", "orange"), state=_L),
    Category("spaghetti_packet", soft_pack(("SPAGHETTI", "PASTA", "LINGUINE"), ("blue", "navy",
             "yellow", "red"), (0.27, 0.07, 0.035)), (0.27, 0.07, 0.028), 0.5,
             ("packet of spaghetti", "packet of pasta", "bag of pasta", "dried spaghetti",
             "pack of spaghetti"), _K, (), ("blue",), state=_L),
    Category("sachet", soft_pack(("KETCHUP", "SUGAR", "YEAST", "SALT", "MAYO", "SAUCE"), ("red",
             "white", "yellow", "brown", "pink", "blue"), (0.082, 0.042, 0.008)), (0.0819, 0.042,
             0.0064), 0.008, ("ketchup sachet", "sugar sachet", "yeast packet", "ketchup packet",
             "sugar packet", "sauce sachet", "sauce packet", "salt sachet", "yeast sachet",
             "sweetener sachet", "mayonnaise sachet", "mustard sachet", "soy sauce packet",
             "coffee sachet", "sachet of sugar", "sachet of ketchup", "sugar stick", "silica gel",
             "silica gel packet", "shampoo sachet", "wet wipe sachet", "salt packet",
             "pepper sachet"), _K, _F, ("red", "white"), state=_L),
    vary(Category("ready_meal", tray_meal, (0.196, 0.149, 0.0359), 0.4, ("microwave meal",
             "tv dinner",
             "frozen dinner", "microwave dinner", "frozen meal"), _K, _F,
             ("green",), state=_L)),
    Category("stock_cube", foil_cube, (0.0271, 0.0271, 0.0209), 0.01, ("bouillon cube", "oxo cube",
             "gravy cube", "stock pot cube", "bouillon"), _K, (), ("gold",)),
    Category("gift_hamper", hamper, (0.303, 0.216, 0.299), 3.0, ("hamper", "food hamper",
             "christmas hamper"), ("dining",), ("big",), ("tan",)),
    Category("cup_lid", round_lid, (0.0874, 0.0878, 0.0168), 0.004, ("coffee cup lid", "coffee lid",
             "takeaway cup lid", "lid of a coffee cup", "travel cup lid"), _K,
             ("round", "flat"), ("white",), state=_L),
    Category("jar_lid", jar_lid, (0.0711, 0.0711, 0.0148), 0.012, ("screw lid", "jam jar lid",
             "screw cap", "lid of a jar", "mason jar lid", "bottle lid"), _K, ("round", "flat"),
             ("gold",), state=_L),
)  # fmt: skip
"""The module's categories."""
