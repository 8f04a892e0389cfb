"""Objects of the ``kitchen`` theme: containers."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import rectangle
from ...kit.parts import box_part, cylinder_part, frame_parts, hull_of, open_vessel, ring_parts
from ...kit.primitives import ball
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import block, box, cylinder, join, lathe, loft, open_box, torus
from ...kit.surfaces import RGB, Look, readable_on, tint_color
from .bags import panel


@category("basket", size=(0.24, 0.19, 0.095), mass=0.35, material="wood", hollow=True,
          assembled=True, aliases=("fruit basket", "bread basket", "wicker basket",
          "storage basket", "bin", "creel", "hanging basket", "trug", "waste-paper basket",
          "tub of maggots"), themes=("kitchen", "dining", "craft"), roles=("container", "big"),
          colors=("tan", "brown"), common=True)  # fmt: skip
def basket(look: Look) -> Shape:
    """A woven basket, open at the top, that can hold other objects."""
    color = look.color("tan", "brown", "beige", "wooden", "white")
    weave = surfaces.basketwork(look.rng, color)
    dark = surfaces.speckles(look.rng, tint_color(color, 0.75), 6, 32)
    if look.chance(0.5):
        r, h, wall = look.between(0.1, 0.12), look.between(0.08, 0.1), 0.007
        low = 0.82 * r
        body = lathe([(0, 0), (low, 0), (r, h), (r - wall, h), (low - wall, 0.008), (0, 0.008)],
                     v=[0, 0, 0.48, 0.52, 1, 1])  # fmt: skip
        rim = torus(r - wall / 2, 0.0065, 32, 8).move(z=h)
        return shape(
            [(body, weave), (rim, dark)],
            [*ring_parts([(low, 0), (r, h)], [(r - wall, h), (low - wall, 0.008)]),
             cylinder_part(low, 0.008)],
        )  # fmt: skip
    x, y, h, wall = look.between(0.22, 0.27), look.between(0.15, 0.18), 0.09, 0.008
    rails = [block(x + 0.006, 0.012, 0.012, 0.003).move(y=side * (y - 0.008) / 2, z=h - 0.006)
             for side in (-1, 1)] + [block(0.012, y + 0.006, 0.012, 0.003).move(x=side * (x - 0.008)
                                                                                / 2, z=h - 0.006)
                                     for side in (-1, 1)]  # fmt: skip
    return shape([*((s, weave) for s in open_box(x, y, h, wall, wall)),
                  *((s, dark) for s in rails)], frame_parts(x, y, h, wall, wall))  # fmt: skip


@category("cup_lid", size=(0.0874, 0.0878, 0.0168), mass=0.004, material="plastic", hollow=True,
          aliases=("coffee cup lid", "coffee lid", "takeaway cup lid", "lid of a coffee cup",
          "travel cup lid"), themes=("kitchen",), roles=("round", "flat"), colors=("white",),
          state="lying flat")  # fmt: skip
def cup_lid(look: Look) -> Shape:
    """A plastic lid lying flat: a coffee cup lid with a sip hole, or a plain jar lid."""
    r = look.between(0.04, 0.046)
    color = look.color("white", "black", "white", "brown")
    low = lathe([(0, 0), (r, 0), (1.0 * r, 0.004), (0.93 * r, 0.006), (0.88 * r, 0.016),
                 (0.8 * r, 0.0165), (0.76 * r, 0.012), (0, 0.012)], 34)  # fmt: skip
    hole = block(0.012, 0.004, 0.0008, 0.0018).move(0, -0.84 * r, 0.016)
    tone = surfaces.plain(tint_color(color, 0.5))
    rib = lathe([(0, 0.0118), (0.34 * r, 0.0118), (0.32 * r, 0.0128), (0, 0.0128)], 24)
    return shape([(join([low, rib]), surfaces.speckles(look.rng, color, 3, 32)), (hole, tone)],
                 [hull_of(low)])  # fmt: skip


PALE: RGB = (246, 244, 238)
Make = Callable[[Look], Shape]


def tub(words: tuple[str, ...], palette: tuple[str, ...], form: tuple[float, float, float],
        oval: bool = False) -> Make:  # fmt: skip
    """Return a plastic tub, either round or a rounded rectangle, with a printed lid."""

    def make(look: Look) -> Shape:
        k = look.between(0.93, 1.07)
        x, y, h = (v * k for v in form)
        color = look.color(*palette)
        ground = look.pick([PALE, PALE, tint_color(color, 1.6)])
        word = look.pick(words)
        band = surfaces.fit(panel(look, word, color, 128, 96), 96, 128)
        wrap = np.concatenate([band, band, band], axis=1)
        if oval:
            ring = rectangle(x, y, 0.24 * y, 5)
            levels = [(0.86, 0.0), (0.97, 0.86 * h)]
            body = loft(np.stack([np.column_stack([ring * f, np.full(len(ring), z)])
                                  for f, z in levels]), ring)  # fmt: skip
            lid = block(x, y, 0.16 * h, 0.24 * y, 0.002).move(z=0.84 * h)
            sign = block(0.9 * x, 0.86 * y, 0.0006, 0.2 * y).move(z=h - 0.0003)
            parts = [hull_of(body), hull_of(lid)]
            front = box(0.6 * x, 0.0006, 0.6 * h).turn(0, -0.1).move(y=-0.465 * y, z=0.14 * h)
            pieces = [(body, surfaces.plain(ground)), (lid, surfaces.plain(color)),
                      (sign, panel(look, word, color, 150, 104)), (front, band)]  # fmt: skip
            return shape(pieces, parts)
        r = x / 2
        body = lathe([(0, 0), (0.84 * r, 0), (0.97 * r, 0.82 * h), (0, 0.82 * h)], 34,
                     v=[0, 0, 1, 1])  # fmt: skip
        lid = cylinder(r, 0.16 * h, 34, bevel=0.0015).move(z=0.84 * h - 0.0002)
        neck = cylinder(0.96 * r, 0.04 * h, 34).move(z=0.81 * h)
        sign = cylinder(0.9 * r, 0.0006, 34).move(z=h - 0.0004)
        return shape(
            [
                (body, wrap),
                (join([lid, neck]), surfaces.plain(ground)),
                (sign, panel(look, word, color)),
            ],
            [hull_of(body), cylinder_part(r, 0.16 * h, (0, 0, 0.84 * h - 0.0002))],
        )

    return make


@category("open_ice_bucket", size=(0.2, 0.185, 0.185), mass=1.0, material="metal",
          aliases=("empty ice bucket",), themes=("kitchen", "dining"),
          roles=("container", "round", "big"), colors=("silver",))  # fmt: skip
def open_ice_bucket(look: Look) -> Shape:
    """An empty ice bucket for bottles, with two ring handles."""
    r, h = look.between(0.085, 0.1), look.between(0.17, 0.2)
    color = look.color("silver", "silver", "copper", "gold", "black", "white")
    skin = look.surface(color, "metal")
    body, parts = open_vessel([(0.76 * r, 0), (r, h)], 0.004, 0.008)
    ring = torus(0.022, 0.0035, 20, 6).turn(1, np.pi / 2)
    ears = [ring.move(s * (0.93 * r + 0.003), 0, 0.74 * h) for s in (-1, 1)]
    return shape([(body, skin), (join(ears), skin)], [*parts, *(hull_of(e) for e in ears)])


@category("food_container", size=(0.186, 0.149, 0.0883), mass=0.45, material="plastic", hollow=True,
          aliases=("tupperware", "plastic container", "storage container", "plastic box",
          "food box", "food storage container"), themes=("kitchen", "office"),
          colors=("blue", "green"), opened="open_lunch_box")  # fmt: skip
def food_container(look: Look) -> Shape:
    """A plastic box for food with a coloured lid and clips."""
    x, y, h = look.between(0.15, 0.2), look.between(0.11, 0.14), look.between(0.06, 0.09)
    color = look.color("red", "blue", "green", "teal", "orange", "pink", "gray", "yellow")
    food = look.pick([(214, 222, 224), (214, 222, 224), (220, 120, 60), (120, 160, 70),
                      (230, 210, 160)])  # fmt: skip
    clear = surfaces.plain((208, 218, 222))
    tile = surfaces.stack((surfaces.speckles(look.rng, food, 16, 32), 70), (clear, 30))
    outline = rectangle(1, 1, 0.12, 5)
    rings = np.stack([np.column_stack([outline * [x * k, y * k], np.full(len(outline), z)])
                      for k, z in ((0.9, 0), (0.93, 0.006), (1.0, h))])  # fmt: skip
    body = loft(rings, outline)
    lid = block(x + 0.008, y + 0.008, 0.014, 0.024, 0.003).move(z=h - 0.004)
    inset = block(0.8 * x, 0.76 * y, 0.002, 0.018).move(z=h + 0.0095)
    skin = look.surface(color, "plastic")
    clips = [box(0.05, 0.006, 0.022).move(y=s * (y / 2 + 0.005), z=h - 0.014) for s in (-1, 1)]
    clips += [box(0.006, 0.04, 0.022).move(x=s * (x / 2 + 0.005), z=h - 0.014) for s in (-1, 1)]
    return shape([(body, tile), (join([lid, *clips]), skin),
                  (inset, surfaces.plain(tint_color(color, 1.25)))],
                 [hull_of(body), hull_of(lid)], opacity=0.9)  # fmt: skip


@category("ice_cube_tray", size=(0.253, 0.0837, 0.0305), mass=0.12, material="plastic",
          aliases=("ice tray", "ice cube mould", "ice cube mold"), themes=("kitchen",),
          colors=("sky", "white"))  # fmt: skip
def ice_cube_tray(look: Look) -> Shape:
    """A tray with twelve or more compartments for ice cubes, some with ice in them."""
    columns, rows = look.pick([6, 7, 8]), 2
    pitch, h = look.between(0.034, 0.038), look.between(0.028, 0.034)
    x, y = columns * pitch + 0.012, rows * pitch + 0.012
    color = look.color("sky", "white", "blue", "teal", "pink", "green", "orange")
    skin = look.surface(color, "plastic")
    at = [((i - (columns - 1) / 2) * pitch, (j - 0.5) * pitch) for i in range(columns)
          for j in range(rows)]  # fmt: skip
    bottom = block(x - 0.006, y - 0.006, 0.006, 0.008)
    walls = [box(x, 0.005, h - 0.005).move(y=(k / rows - 0.5) * (y - 0.006), z=0.005)
             for k in range(rows + 1)]  # fmt: skip
    walls += [box(0.005, y, h - 0.005).move(x=(k / columns - 0.5) * (x - 0.006), z=0.005)
              for k in range(columns + 1)]  # fmt: skip
    pieces = [(join([bottom, *walls]), skin)]
    parts = [box_part(x - 0.006, y - 0.006, 0.006)]
    parts += [box_part(x, 0.005, h - 0.005, (0, (k / rows - 0.5) * (y - 0.006), 0.005))
              for k in range(rows + 1)]  # fmt: skip
    parts += [box_part(0.005, y, h - 0.005, ((k / columns - 0.5) * (x - 0.006), 0, 0.005))
              for k in range(columns + 1)]  # fmt: skip
    if look.chance(0.6):
        cubes = [block(0.8 * pitch, 0.8 * pitch, h - 0.008, 0.006, 0.002).move(a, b, 0.005)
                 for a, b in at]  # fmt: skip
        pieces.append((join(cubes), surfaces.gradient((206, 226, 236), (246, 250, 252), look.rng)))
        parts.append(box_part(x - 0.02, y - 0.02, h - 0.008, (0, 0, 0.005)))
    return shape(pieces, parts)


@category("utensil_crock", size=(0.124, 0.124, 0.1625), mass=0.9, material="ceramic",
          aliases=("utensil holder", "utensil crock", "utensil jar", "utensil pot",
          "cutlery holder", "spoon holder", "kitchen utensil holder"), themes=("kitchen",),
          roles=("container", "round", "tall"), colors=("white", "cream"))  # fmt: skip
def utensil_crock(look: Look) -> Shape:
    """An empty stoneware crock for wooden spoons and whisks."""
    r, h = look.between(0.058, 0.066), look.between(0.15, 0.175)
    color = look.color("white", "cream", "sage", "navy", "terracotta", "charcoal")
    side = [(0.92 * r, 0), (r, 0.12 * h), (0.98 * r, 0.85 * h), (r, h)]
    body, parts = open_vessel(side, 0.005, 0.01)
    return shape([(body, surfaces.fit(glaze_tile(look, color), 128, 128))], parts)


STEEL: RGB = (196, 199, 204)


@category("paste_tube", size=(0.161, 0.0594, 0.0315), mass=0.15, material="metal",
          aliases=("tomato paste tube", "tomato puree tube", "tube of tomato puree", "tomato puree",
          "anchovy paste tube", "harissa tube", "tube of tomato paste", "mustard tube",
          "wasabi tube"), themes=("kitchen",), colors=("red",), state="lying flat")  # fmt: skip
def paste_tube(look: Look) -> Shape:
    """A soft metal tube of tomato paste lying flat, with its cap on the right."""
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
    return shape([(solids[0], surfaces.brushed_metal(look.rng, color)),
                  (solids[1], surfaces.brushed_metal(look.rng, STEEL)),
                  (solids[2], surfaces.plain(look.own_color("white", "red", "green"))),
                  (solids[3], sign)], [hull_of(solids[0], solids[1]),
                                       hull_of(solids[2])]).scale(k)  # fmt: skip


@category("masala_dabba", size=(0.189, 0.189, 0.0448), mass=0.7, material="metal",
          aliases=("spice box", "indian spice box", "masala box", "spice tray"),
          themes=("kitchen",), roles=("round",), colors=("silver",))  # fmt: skip
def masala_dabba(look: Look) -> Shape:
    """A round, open steel box with seven bowls of spices."""
    k = look.between(0.94, 1.06)
    color = look.color("silver", "silver", "copper")
    r, h = 0.095 * k, 0.045 * k
    tin, parts = open_vessel([(r, 0), (r, h)], 0.002, 0.003, 40)
    bowls, heaps = [], {}
    tones = ((214, 150, 30), (170, 40, 26), (96, 60, 34), (60, 46, 36), (200, 176, 110),
             (140, 112, 50), (190, 96, 40))  # fmt: skip
    for n in range(7):
        a = n * np.pi / 3
        at = (0.0, 0.0) if n == 6 else (0.62 * r * float(np.cos(a)), 0.62 * r * float(np.sin(a)))
        cup = lathe([(0, 0.003), (0.26 * r, 0.003), (0.285 * r, 0.74 * h), (0.27 * r, 0.74 * h),
                     (0.25 * r, 0.5 * h), (0, 0.5 * h)], 20).move(*at)  # fmt: skip
        bowls.append(cup)
        heaps[n] = (ball(0.5 * r, 0.5 * r, 0.3 * h, (at[0], at[1], 0.58 * h), 14),
                 surfaces.speckles(
            look.rng, tones[n], 14))  # fmt: skip
    steel = surfaces.brushed_metal(look.rng, color)
    return shape([(join([tin, *bowls]), steel), *heaps.values()],
                 [*parts, cylinder_part(0.93 * r, 0.7 * h)])  # fmt: skip


CATEGORIES = (
    Category("cream_tub", tub(("CREAM", "RICOTTA", "COTTAGE", "LABNEH", "HUMMUS", "CREME"), ("sky",
             "green", "blue", "red", "teal"), (0.095, 0.095, 0.075)), size=(0.093, 0.0934, 0.0739),
             mass=0.28, material="plastic", aliases=("sour cream tub", "tub of cream",
             "cottage cheese tub", "ricotta tub", "mascarpone tub", "labneh tub", "cottage cheese",
             "ricotta", "mascarpone", "tub of hummus", "sour cream", "tub of sour cream",
             "cream pot", "creme fraiche", "pot of cream", "labneh", "bicarb tub",
             "bicarbonate of soda", "plastic tub", "food tub", "tub of yogurt", "yogurt tub",
             "protein tub"), themes=("kitchen",), roles=("round",), colors=("sky",)),
    Category("margarine_tub", tub(("SPREAD", "SUNNY", "LIGHT", "BUTTER"), ("yellow", "gold",
             "green", "blue"), (0.15, 0.105, 0.06), True), size=(0.147, 0.103, 0.059), mass=0.5,
             material="plastic", aliases=("margarine", "tub of margarine", "butter tub",
             "tub of butter", "spreadable butter", "spread tub", "tub of spread"),
             themes=("kitchen",), colors=("yellow",)),
    Category("ice_cream_tub", tub(("ICE CREAM", "VANILLA", "GELATO", "COOKIE"), ("brown", "pink",
             "sky", "cream", "purple"), (0.098, 0.098, 0.105)), size=(0.1, 0.101, 0.108), mass=0.45,
             material="plastic", aliases=("ice cream carton", "tub of ice cream", "ice cream pot",
             "carton of ice cream", "ice cream container", "gelato tub", "sorbet tub",
             "pint of ice cream"), themes=("kitchen",), roles=("round",), colors=("brown", "pink")),
)  # fmt: skip
"""Objects that share their drawing functions."""
