"""Objects of the ``living`` theme: bags."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import BRASS_TONE, glaze_tile, leather, steel
from ...kit.outlines import arc, rectangle, smooth
from ...kit.parts import box_part, hull_of, hull_part
from ...kit.primitives import at_box, ball, drum, pad, rod, side_view, spread
from ...kit.shapes import Category, Pieces, Shape, category, put_down, settle, shape
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    prism,
    torus,
    tube,
)
from ...kit.surfaces import Look, plain, readable_on, tint_color
from ..kitchen.bags import bag
from ..workbench.boxes import case


@category("charcoal_bag", size=(0.206, 0.103, 0.288), mass=2.0, material="paper",
          aliases=("bag of charcoal", "sack of charcoal", "bag of briquettes", "bag of coal",
          "charcoal sack"), themes=("living",), roles=("tall", "big"),
          colors=("tan", "black"))  # fmt: skip
def charcoal_bag(look: Look) -> Shape:
    """An upright paper sack of charcoal with a folded top and a flame on its front."""
    k = look.between(0.94, 1.06)
    color = look.color("tan", "black", "red", "orange")
    x, y, h = 0.2 * k, 0.1 * k, 0.28 * k
    body = block(x, y, 0.88 * h, 0.03, 0.012)
    top = box(0.94 * x, 0.018, 0.14 * h).move(z=0.86 * h)
    image = prints.canvas(120, 150, color)
    ink = readable_on(color)
    prints.polygon(image, [(0.3, 0.8), (0.26, 0.6), (0.4, 0.42), (0.46, 0.54), (0.54, 0.32),
                           (0.7, 0.56), (0.72, 0.72), (0.62, 0.84)], (240, 120, 30))  # fmt: skip
    prints.polygon(image, [(0.42, 0.82), (0.42, 0.68), (0.52, 0.56), (0.6, 0.7), (0.56, 0.82)],
                   (252, 206, 70))  # fmt: skip
    prints.write(image, look.pick(["CHARCOAL", "BRIQUETTES", "BBQ"]), 0.5, 0.18, 0.13, ink,
                 bold=True)  # fmt: skip
    front = box(0.78 * x, 0.001, 0.74 * h).move(y=-y / 2, z=0.05 * h)
    paper = surfaces.speckles(look.rng, color, 6)
    return shape([(join([body, top]), paper), (front, image)],
                 [box_part(x, y, 0.88 * h), hull_of(top)])  # fmt: skip


@category("satchel", size=(0.239, 0.0955, 0.204), mass=0.8, material="leather", hollow=True,
          aliases=("school satchel", "leather satchel", "messenger bag", "briefcase bag"),
          themes=("living", "office"), roles=("big",), colors=("brown",))  # fmt: skip
def satchel(look: Look) -> Shape:
    """An upright school satchel with a handle and a flap with two buckled straps."""
    color = look.color("brown", "tan", "maroon", "navy", "black", "mustard")
    k = look.between(0.7, 0.9)
    body = block(0.3, 0.1, 0.21, 0.015, 0.008)
    flap = at_box(0.29, 0.012, 0.12, (0, -0.053, 0.085))
    top = block(0.296, 0.112, 0.02, 0.012, 0.006).move(0, -0.003, 0.196)
    straps = [at_box(0.026, 0.006, 0.17, (s * 0.085, -0.06, 0.035)) for s in (-1, 1)]
    straps += [at_box(0.026, 0.1, 0.006, (s * 0.085, -0.006, 0.214)) for s in (-1, 1)]
    buckles = [at_box(0.038, 0.008, 0.03, (s * 0.085, -0.063, 0.06)) for s in (-1, 1)]
    handle = rod(
        [(-0.05, 0, 0.215), (-0.04, 0, 0.245), (0.04, 0, 0.245), (0.05, 0, 0.215)], 0.007, 8
    )
    hide = leather(look.rng, color)
    return put_down([(join([body, flap, top]), hide),
                     (join([*straps, handle]), leather(look.rng, tint_color(color, 0.6))),
                     (join(buckles), steel(look, BRASS_TONE))], body, flap, top, handle,
                    factor=k)  # fmt: skip


@category("waist_bag", size=(0.226, 0.201, 0.0959), mass=0.2, material="fabric", hollow=True,
          aliases=("fanny pack", "bum bag", "hip pack", "belt bag", "waist pack"),
          themes=("living",), roles=("big",), colors=("black",))  # fmt: skip
def waist_bag(look: Look) -> Shape:
    """A waist bag lying flat: a zipped pouch with its belt looped behind it."""
    color = look.color("black", "pink", "teal", "red", "navy", "orange")
    k = look.between(0.85, 1.1)
    pouch = block(0.2, 0.075, 0.1, 0.034, 0.016)
    front = block(0.14, 0.02, 0.055, 0.009, 0.006).move(0, -0.04, 0.012)
    zips = [at_box(0.15, 0.006, 0.006, (0, -0.03, 0.092)), at_box(0.11, 0.003, 0.005,
                                                                  (0, -0.0505, 0.055))]  # fmt: skip
    tags = [
        at_box(0.005, 0.004, 0.018, (0.06, -0.034, 0.078)),
        at_box(0.005, 0.003, 0.014, (0.045, -0.052, 0.044)),
    ]
    a = np.linspace(0.0, np.pi, 22)
    path = np.column_stack([0.115 * np.cos(a), 0.02 + 0.13 * np.sin(a), 0.05 + 0 * a])
    belt = tube(path, 0.003, 8, squash=5.5)
    clip = at_box(0.045, 0.012, 0.038, (0.0, 0.15, 0.031))
    foot = [tube(path[i : i + 8], 0.003, 8, squash=5.5) for i in (0, 7, 14)]
    return put_down([(join([pouch, front]), surfaces.fabric(look.rng, color)),
                     (join([*zips, *tags]), steel(look)),
                     (join([belt, clip]), plain(tint_color(color, 0.6)))], pouch, front, *foot,
                    factor=k)  # fmt: skip


@category("tote_bag", size=(0.214, 0.0791, 0.281), mass=0.2, material="fabric", hollow=True,
          aliases=("tote", "canvas bag", "canvas tote", "cloth bag", "shopper"), themes=("living",),
          roles=("big",), colors=("cream",))  # fmt: skip
def tote_bag(look: Look) -> Shape:
    """An open, upright canvas tote bag with two handles and a print."""
    color = look.color("cream", "white", "black", "navy", "mustard", "sage")
    k = look.between(0.75, 0.95)
    body = block(0.26, 0.09, 0.25, 0.02)
    mouth = at_box(0.235, 0.07, 0.001, (0, 0, 0.2496))
    rims = [at_box(0.24, 0.004, 0.02, (0, s * 0.0445, 0.238)) for s in (-1, 1)]
    handles = [rod([(-0.06, s * 0.042, 0.24), (-0.05, s * 0.04, 0.31), (0, s * 0.036, 0.335),
                    (0.05, s * 0.04, 0.31), (0.06, s * 0.042, 0.24)], 0.006, 8)
               for s in (-1, 1)]  # fmt: skip
    tone = look.own_color("coral", "teal", "navy", "mustard", "green", "black")
    print_ = [drum(0.05, 0.0012, (0, -0.046, 0.125), 1, sides=28)]
    inner = drum(0.036, 0.0014, (0, -0.0465, 0.125), 1, sides=28)
    cloth = surfaces.fabric(look.rng, color)
    return put_down([(join([body, *rims, *handles]), cloth), (mouth, plain(tint_color(color, 0.4))),
                     (join(print_), plain(tone)), (inner, plain(tint_color(tone, 1.5)))], body,
                    *handles, factor=k)  # fmt: skip


@category("lavender_sachet", size=(0.0658, 0.053, 0.1), mass=0.03, material="fabric",
          aliases=("scented sachet", "lavender bag", "potpourri sachet", "drawer sachet"),
          themes=("living",), colors=("lavender",))  # fmt: skip
def lavender_sachet(look: Look) -> Shape:
    """A small cloth pouch tied with a ribbon, with lavender sticking out."""
    r, h = look.between(0.03, 0.037), look.between(0.085, 0.1)
    color = look.color("lavender", "white", "violet", "beige", "pink")
    bag = lathe([(0, 0), (0.8 * r, 0), (r, 0.18 * h), (0.9 * r, 0.42 * h), (0.3 * r, 0.66 * h),
                 (0.26 * r, 0.7 * h), (0.7 * r, 0.94 * h), (0.66 * r, h), (0, 0.86 * h)],
                 26)  # fmt: skip
    tie = torus(0.3 * r, 0.0025, 18, 6).move(z=0.68 * h)
    loops = [ellipsoid(0.02, 0.005, 0.011, 10, 6).turn(1, 0.3 * s).move(s * 0.011, -0.34 * r,
        0.68 * h)
             for s in (-1, 1)]  # fmt: skip
    cloth = surfaces.fabric(look.rng, color)
    sprigs = [ellipsoid(0.006, 0.006, 0.014, 8, 5).move(0.3 * r * np.cos(a), 0.3 * r * np.sin(a), h)
              for a in np.arange(5) * 1.26]  # fmt: skip
    bow = surfaces.plain(look.own_color("purple", "violet", "indigo"))
    return shape([(bag.scale(1, 0.8, 1), cloth), (join([tie, *loops]), bow),
                  (join(sprigs), surfaces.plain((128, 96, 176)))],
                 settle([(bag.scale(1, 0.8, 1), cloth)], 0.0).parts)  # fmt: skip


@category("fertilizer_bag", size=(0.135, 0.068, 0.19), mass=0.9, material="plastic",
          aliases=("fertilizer", "fertiliser", "bag of fertilizer", "potting soil", "compost",
          "fertiliser bag", "bag of soil", "bag of compost", "plant food", "compost bag",
          "potting soil bag", "bag of potting soil", "slug pellet tub"), themes=("living",),
          roles=("tall",), colors=("green",))  # fmt: skip
def fertilizer_bag(look: Look) -> Shape:
    """A small, upright sack of fertiliser or compost with a plant on its front."""
    x, y, h = look.between(0.12, 0.15), look.between(0.06, 0.075), look.between(0.17, 0.21)
    color = look.color("green", "olive", "yellow", "brown", "white", "teal")
    image = prints.canvas(112, 160, color)
    prints.fill(image, 0, 0.12, 1, 0.2, (248, 246, 238))
    prints.write(image, look.pick(["PLANT FOOD", "COMPOST", "FERTILIZER", "SOIL"]), 0.5, 0.225,
                 0.12, tint_color(color, 0.55), bold=True)  # fmt: skip
    prints.stroke(image, [(0.5, 0.85), (0.5, 0.45)], 0.025, (60, 110, 50))
    for s in (-1, 1):
        for z in (0.5, 0.62, 0.74):
            prints.polygon(image, [(0.5, z + 0.06), (0.5 + s * 0.2, z - 0.03),
                                   (0.5 + s * 0.26, z + 0.03), (0.5 + s * 0.1, z + 0.08)],
                           (96, 160, 76))  # fmt: skip
    prints.fill(image, 0.2, 0.85, 0.6, 0.09, (96, 66, 44))
    outline = rectangle(1, 1, 0.3, 3)
    levels = [(0.94, 0.9, 0), (1, 1, 0.02), (1, 1, 0.6), (0.98, 0.6, 0.85), (0.97, 0.1, 0.97),
              (0.97, 0.08, 1.0)]  # fmt: skip
    body = loft(np.stack([np.column_stack([outline * [x * a, y * b], np.full(len(outline), h * z)])
                          for a, b, z in levels]), outline)  # fmt: skip
    front = box(0.84 * x, 0.0008, 0.56 * h).move(0, -y / 2, 0.04 * h)
    z = body.vertices[:, 2]
    return shape(
        [(body, surfaces.speckles(look.rng, color, 4)), (front, image)],
        [hull_part(body.vertices[z < 0.7 * h]), hull_part(body.vertices[z > 0.5 * h])],
    )


@category("wallet", size=(0.109, 0.09, 0.02), mass=0.12, material="leather",
          aliases=("billfold", "leather wallet"), themes=("living", "office"), roles=("flat",),
          colors=("brown", "black"), state="lying flat", common=True)  # fmt: skip
def wallet(look: Look) -> Shape:
    """A folded leather wallet with cards or notes showing at its edge."""
    x, y, h = look.between(0.1, 0.118), look.between(0.082, 0.095), look.between(0.016, 0.024)
    color = look.color("brown", "black", "tan", "navy", "maroon", "red", "olive")
    leather = surfaces.spots(look.rng, color, tint_color(color, 0.78), 0.2)
    stitched = leather.copy()
    thread = np.array(tint_color(color, 1.4), np.uint8)
    for at in (5, 122):
        stitched[at, ::3], stitched[::3, at] = thread, thread
    bow = arc((-x / 2 + 0.5 * h, 0.5 * h), 0.5 * h, np.pi / 2, 1.5 * np.pi, 6)
    spine = side_view([*bow, (-x / 2 + h, 0), (-x / 2 + h, h)], y)
    flaps = [block(x, y, 0.36 * h, 0.005, 0.002).move(z=z) for z in (0, 0.64 * h)]
    inner = box(0.93 * x, 0.94 * y, 0.3 * h).move(x=0.01 * x, z=0.35 * h)
    paper = surfaces.stripes([tint_color(color, 0.5), (188, 200, 160), (226, 226, 220)], 3)
    pieces = [(join([*flaps[:1], spine]), leather), (flaps[1], stitched), (inner, paper)]
    if look.chance(0.5):
        card = block(0.085, 0.05, 0.0012, 0.003).move(0.02, -0.45 * y, 0.5 * h)
        ink = look.own_color("blue", "gold", "teal", "red")
        pieces.append((card, surfaces.stripes([ink, tint_color(ink, 1.3)], 2)))
    return shape(pieces, [box_part(x, y, h)])


TONES = ("brown", "black", "red", "tan", "navy", "teal", "pink", "mustard", "gray", "green")


def _body(
    x: float, y: float, h: float, levels: list[tuple[float, float, float]], corner: float
) -> Solid:
    """Return a bag's body; ``levels`` lists (x scale, y scale, relative z) from bottom to top."""
    outline = rectangle(1, 1, corner, 5)
    return loft(np.stack([np.column_stack([outline * [x * a, y * b], np.full(len(outline), h * z)])
                          for a, b, z in levels]), outline)  # fmt: skip


def _metal(look: Look) -> surfaces.Tile:
    return surfaces.brushed_metal(look.rng, look.pick([(206, 172, 96), (190, 194, 200)]))


@category("handbag", size=(0.21, 0.11, 0.23), mass=0.5, material="leather", assembled=True,
          aliases=("hand bag", "leather bag", "leather handbag", "shoulder bag", "ladies bag"),
          themes=("living",), roles=("big",), colors=("brown", "red"))  # fmt: skip
def handbag(look: Look) -> Shape:
    """A leather handbag with two handles, a flap and a clasp."""
    x, y, h = look.between(0.19, 0.23), look.between(0.08, 0.1), look.between(0.13, 0.16)
    color = look.color(*TONES)
    body = _body(x, y, h, [(0.94, 0.9, 0), (1, 1, 0.06), (0.96, 0.85, 0.6), (0.84, 0.4, 0.97),
                           (0.82, 0.3, 1.0)], 0.22)  # fmt: skip
    flap = _body(0.8 * x, 0.05, 0.4 * h, [(1, 0.5, 0), (1.06, 1, 0.6), (1.05, 0.7, 1.0)], 0.3)
    flap = flap.move(0, -0.36 * y, 0.6 * h)
    handles = [rod([(-0.25 * x, s * 0.014, h - 0.012), (-0.22 * x, s * 0.018, h + 0.055),
                    (0, s * 0.02, h + 0.085), (0.22 * x, s * 0.018, h + 0.055),
                    (0.25 * x, s * 0.014, h - 0.012)], 0.0055, 8) for s in (-1, 1)]  # fmt: skip
    clasp = ball(0.02, 0.009, 0.016, (0, -0.36 * y - 0.022, 0.68 * h), 12)
    hide = leather(look.rng, color)
    dark = surfaces.plain(tint_color(color, 0.72))
    return put_down([(body, hide), (join([flap, *handles]), dark), (clasp, _metal(look))],
                   body, flap, join(handles))  # fmt: skip


@category("purse", size=(0.105, 0.044, 0.087), mass=0.08, material="leather",
          aliases=("coin purse", "change purse", "small purse", "kiss lock purse"),
          themes=("living",), colors=("red", "pink"))  # fmt: skip
def purse(look: Look) -> Shape:
    """A small, round purse with a metal frame and a kiss-lock clasp."""
    x, h = look.between(0.09, 0.12), look.between(0.065, 0.08)
    color = look.color("red", "pink", "teal", "black", "gold", "purple", "navy", "mustard")
    y = 0.42 * x
    body = _body(
        x, y, h, [(0.6, 0.6, 0), (0.95, 1.0, 0.2), (1.0, 0.95, 0.5), (0.86, 0.35, 0.97)], 0.45
    )
    frame = rod([(-0.45 * x, 0, 0.72 * h), (-0.4 * x, 0, 0.98 * h), (0, 0, 1.02 * h),
                 (0.4 * x, 0, 0.98 * h), (0.45 * x, 0, 0.72 * h)], 0.0045, 8)  # fmt: skip
    knobs = [
        ball(0.011, 0.011, 0.011, (s * 0.005, s * 0.003, 1.02 * h + 0.009), 10) for s in (-1, 1)
    ]
    cloth = surfaces.spots(look.rng, color, tint_color(color, 1.5), 0.12) if look.chance(0.4) else (
        leather(look.rng, color))  # fmt: skip
    return put_down(
        [(body, cloth), (join([frame, *knobs]), _metal(look))], body, join([frame, *knobs])
    )


@category("clutch", size=(0.24, 0.14, 0.034), mass=0.2, material="leather",
          aliases=("clutch bag", "evening bag", "clutch purse"), themes=("living",),
          roles=("flat",), colors=("black", "gold"), state="lying flat")  # fmt: skip
def clutch(look: Look) -> Shape:
    """An envelope-shaped evening bag with a flap, lying flat."""
    x, y, h = look.between(0.22, 0.26), look.between(0.13, 0.15), look.between(0.026, 0.034)
    color = look.color("black", "gold", "silver", "red", "pink", "navy", "purple")
    body = pad(x, y, h, 0.01, soft=0.4, steps=4)
    flap = prism([(-0.48 * x, 0.48 * y), (-0.48 * x, 0.1 * y), (0, -0.22 * y), (0.48 * x, 0.1 * y),
                  (0.48 * x, 0.48 * y)], h - 0.001, h + 0.0025)  # fmt: skip
    clasp = cylinder(0.009, 0.005, 18, bevel=0.001).move(0, -0.17 * y, h + 0.002)
    hide = leather(look.rng, color)
    return put_down([(body, hide), (flap, surfaces.plain(tint_color(color, 0.82))),
                     (clasp, _metal(look))], body, flap)  # fmt: skip


@category("backpack", size=(0.18, 0.16, 0.26), mass=0.5, material="fabric", assembled=True,
          aliases=("rucksack", "school bag", "knapsack", "small backpack", "mini backpack",
          "schoolbag", "book bag", "pannier", "packing cube"), themes=("living",),
          roles=("big", "tall"), colors=("red", "navy"))  # fmt: skip
def backpack(look: Look) -> Shape:
    """A small, upright backpack with a front pocket, zips and a loop, and straps at the back."""
    color = look.color("red", "navy", "green", "gray", "black", "teal", "mustard", "pink")
    x, y, h = 0.2, 0.11, 0.27
    body = _body(x, y, h, [(0.95, 0.95, 0), (1, 1, 0.05), (1, 1, 0.6), (0.92, 0.9, 0.85),
                           (0.6, 0.55, 0.98), (0.5, 0.4, 1.0)], 0.3)  # fmt: skip
    pocket = _body(
        0.155, 0.05, 0.12, [(0.95, 0.9, 0), (1, 1, 0.1), (1, 1, 0.75), (0.9, 0.6, 1.0)], 0.35
    )
    pocket = pocket.move(0, -y / 2 - 0.008, 0.02)
    zip_ = rod([(-0.095, -y / 2 + 0.002, 0.14), (-0.08, -0.045, 0.215), (0, -0.04, 0.245),
                (0.08, -0.045, 0.215), (0.095, -y / 2 + 0.002, 0.14)], 0.003, 6)  # fmt: skip
    line = box(0.125, 0.003, 0.004).move(0, -y / 2 - 0.034, 0.12)
    loop = rod([(-0.02, 0.01, h - 0.006), (-0.018, 0.01, h + 0.022), (0.018, 0.01, h + 0.022),
                (0.02, 0.01, h - 0.006)], 0.005, 8)  # fmt: skip
    straps = [rod([(s * 0.05, y / 2 - 0.01, 0.23), (s * 0.065, y / 2 + 0.024, 0.16),
                   (s * 0.075, y / 2 + 0.006, 0.03)], 0.011, 8) for s in (-1, 1)]  # fmt: skip
    cloth = surfaces.fabric(look.rng, color)
    other = surfaces.fabric(look.rng, look.own_color("gray", "black", "tan", "navy"))
    pieces: Pieces = [(body, cloth), (pocket, other),
                      (join([zip_, line]), surfaces.plain((50, 50, 54))),
                      (join([loop, *straps]), other)]  # fmt: skip
    return put_down(pieces, body, pocket, join(straps), factor=look.between(0.75, 1.05))


def _suitcase_case(look: Look, travel: bool) -> Shape:
    color = look.color("brown", "tan", "red", "navy", "teal", "black", "yellow")
    k = look.between(0.85, 1.1)
    x, y, h = (0.17, 0.09, 0.24) if travel else (0.28, 0.1, 0.19)
    lift = 0.014 if travel else 0.0
    shell = block(x, h, y, 0.022, 0.01).turn(0, np.pi / 2).move(0, y / 2, h / 2 + lift)
    metal = _metal(look)
    pieces: Pieces = []
    hulls = [shell]
    if travel:
        ribs = [
            block(0.012, h - 0.05, y + 0.005, 0.005, 0.002)
            .turn(0, np.pi / 2)
            .move(0.03 * n, y / 2 + 0.0025, h / 2 + lift)
            for n in (-2, -1, 0, 1, 2)
        ]
        wheels = [
            cylinder(0.009, 0.01, 14)
            .move(z=-0.005)
            .turn(1, np.pi / 2)
            .move(sx * (x / 2 - 0.026), sy * (y / 2 - 0.018), 0.009)
            for sx in (-1, 1)
            for sy in (-1, 1)
        ]
        stems = [box(0.014, 0.014, 0.012).move(sx * (x / 2 - 0.026), sy * (y / 2 - 0.018), 0.008)
                 for sx in (-1, 1) for sy in (-1, 1)]  # fmt: skip
        pull = rod([(-0.04, 0, h + lift - 0.01), (-0.04, 0, h + 0.07), (0.04, 0, h + 0.07),
                    (0.04, 0, h + lift - 0.01)], 0.0045, 8, 6)  # fmt: skip
        pieces += [(shell, look.surface(color, "plastic")),
                   (join(ribs), surfaces.plain(tint_color(color, 0.85))),
                   (join([*wheels, *stems]), surfaces.plain((48, 48, 52))),
                   (pull, metal)]  # fmt: skip
        hulls += [join([*wheels, *stems]), pull]
    else:
        belts = [box(0.022, y + 0.004, h + 0.002).move(s * 0.085, 0, 0) for s in (-1, 1)]
        corners = [ball(0.04, y + 0.006, 0.04, (sx * (x / 2 - 0.012), 0, z), 12)
                   for sx in (-1, 1) for z in (0.014, h - 0.014)]  # fmt: skip
        grip = rod(
            [(-0.045, 0, h), (-0.035, 0, h + 0.03), (0.035, 0, h + 0.03), (0.045, 0, h)], 0.0065, 8
        )
        locks = [box(0.024, 0.006, 0.02).move(s * 0.05, -y / 2, h - 0.03) for s in (-1, 1)]
        pieces += [(shell, leather(look.rng, color)), (join([*belts, *corners, grip]),
                                                       surfaces.plain(tint_color(color, 0.6))),
                   (join(locks), metal)]  # fmt: skip
        hulls += [grip]
    return put_down(pieces, *hulls, factor=k)


@category("suitcase", size=(0.286, 0.107, 0.245), mass=1.2, material="leather",
          aliases=("small suitcase", "luggage", "travel case", "vintage suitcase", "trolley case",
          "briefcase", "mini suitcase", "toy suitcase", "carry on", "trolley bag"),
          themes=("living",), roles=("big",), colors=("brown", "red"),
          opened="open_suitcase")  # fmt: skip
def suitcase(look: Look) -> Shape:
    """A small, upright suitcase: leather with straps, or a hard shell on wheels."""
    return _suitcase_case(look, look.chance(0.4))


@category("duffel_bag", size=(0.29, 0.155, 0.2), mass=0.6, material="fabric", aliases=("duffel",
          "gym bag", "sports bag", "travel bag", "duffle bag", "holdall", "weekend bag"),
          themes=("living",), roles=("big",), colors=("black", "navy"), state="lying")  # fmt: skip
def duffel_bag(look: Look) -> Shape:
    """A long, round duffel bag lying flat, with a zip, two handles and straps."""
    color = look.color("black", "navy", "red", "green", "gray", "tan", "teal")
    long, r = look.between(0.26, 0.32), look.between(0.07, 0.085)
    body = cylinder(r, long, 26, bevel=0.018).move(z=-long / 2).turn(1, np.pi / 2).move(z=0.93 * r)
    ends = cylinder(r + 0.001, 0.012, 26).move(z=-0.006).turn(1, np.pi / 2)
    rims = [ends.move(s * (0.5 * long - 0.035), 0, 0.93 * r) for s in (-1, 1)]
    zip_ = box(0.7 * long, 0.008, 0.004).move(0, 0, 1.92 * r)
    handles = [rod([(-0.2 * long, s * 0.6 * r, 1.6 * r), (-0.17 * long, s * 0.3 * r, 2.15 * r),
                    (0, s * 0.2 * r, 2.5 * r), (0.17 * long, s * 0.3 * r, 2.15 * r),
                    (0.2 * long, s * 0.6 * r, 1.6 * r)], 0.0065, 8) for s in (-1, 1)]  # fmt: skip
    bands = [cylinder(r + 0.0015, 0.024, 26).move(z=-0.012).turn(1, np.pi / 2).move(
        s * 0.2 * long, 0, 0.93 * r) for s in (-1, 1)]  # fmt: skip
    other = surfaces.plain(tint_color(color, 0.6) if sum(color) > 200 else (110, 112, 118))
    return put_down([(body, surfaces.fabric(look.rng, color)), (join([*rims, *handles, *bands]),
                                                                other),
                     (zip_, surfaces.plain((206, 208, 212)))], body, join(handles))  # fmt: skip


BRIGHT = ("red", "teal", "navy", "pink", "white", "lavender", "black", "sage", "mustard", "sky")


@category("gift_bag", size=(0.148, 0.0814, 0.261), mass=0.15, material="paper", hollow=True,
          aliases=("present bag", "party bag", "shopping bag", "goodie bag", "party favour",
          "party favor", "wedding favour", "favour bag"), themes=("living",), roles=("tall",),
          colors=("red", "pink"))  # fmt: skip
def gift_bag(look: Look) -> Shape:
    """A coloured paper bag with cord handles and crumpled tissue paper."""
    x, y, h = look.between(0.13, 0.18), look.between(0.07, 0.09), look.between(0.17, 0.22)
    color = look.color(*BRIGHT)
    face = surfaces.fit(glaze_tile(look, color), 128, 128).copy()
    if look.chance(0.4):
        prints.disc(face, 0.5, 0.5, 0.24, (250, 248, 240))
        prints.write(face[:, 34:94], look.pick(["FOR YOU", "LOVE", "THANKS", "WOW"]), 0.5, 0.5, 0.1,
                     tint_color(color, 0.6), bold=True)  # fmt: skip
    pieces = bag(x, y, h, face, surfaces.plain(tint_color(color, 0.88)))
    cord = surfaces.plain(look.own_color("white", "gold", "black", "red"))
    for s in (-1, 1):
        path = smooth([(-0.24 * x, s * (y / 2 - 0.003), h - 0.015),
                       (-0.2 * x, s * 0.4 * y, h + 0.05), (0.2 * x, s * 0.4 * y, h + 0.05),
                       (0.24 * x, s * (y / 2 - 0.003), h - 0.015)], 5)  # fmt: skip
        pieces.append((tube(path, 0.0026, 6), cord))
    tissue = surfaces.speckles(
        look.rng, look.own_color("white", "pink", "sky", "cream", "yellow"), 8, 32
    )
    n = 10
    u, v = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n))
    lift = 0.03 * (1 - 0.6 * u**2) + 0.022 * surfaces.noise(look.rng, n, n, (4, 4), 1)
    rim = np.maximum(np.abs(u), np.abs(v)) > 0.99
    lift = np.where(rim, -0.03, np.maximum(lift, 0))
    sheet = spread(
        np.stack([u * (x / 2 - 0.004), v * (y / 2 - 0.004), h - 0.012 + lift], -1), 0.0015
    )
    pieces.append((sheet, tissue))
    return shape(pieces, [box_part(x, y, h), hull_part(np.array([p for p in sheet.vertices
                                                                if p[2] > h - 0.02]))])  # fmt: skip


@category("luggage_tag", size=(0.165, 0.0619, 0.00802), mass=0.02, material="leather",
          assembled=True, aliases=("baggage tag", "suitcase tag", "bag tag", "bookmark tag"),
          themes=("living",), roles=("flat",), colors=("brown", "red"),
          state="lying flat")  # fmt: skip
def luggage_tag(look: Look) -> Shape:
    """A luggage tag with a strap, lying flat."""
    color = look.color("brown", "red", "black", "teal", "tan", "navy", "pink")
    k = look.between(0.9, 1.15)
    body = prism([(-0.05, -0.018), (-0.034, -0.03), (0.05, -0.03), (0.05, 0.03), (-0.034, 0.03),
                  (-0.05, 0.018)], 0, 0.004)  # fmt: skip
    window = box(0.06, 0.04, 0.0006).move(0.012, 0, 0.0038)
    image = prints.canvas(96, 64, (246, 244, 238))
    prints.lines(image, look.rng, (0.1, 0.2, 0.8, 0.6), 4, (90, 90, 96), 0.3)
    strap = rod([(-0.04, 0, 0.004), (-0.07, 0.012, 0.004), (-0.105, 0.004, 0.003),
                 (-0.1, -0.012, 0.003), (-0.07, -0.01, 0.004), (-0.04, -0.002, 0.005)], 0.0032,
                6)  # fmt: skip
    return put_down([(join([body, strap]), surfaces.speckles(look.rng, color, 7)), (window, image)],
                   body, strap, factor=k)  # fmt: skip


@category("bag_roll", size=(0.0687, 0.0805, 0.0335), mass=0.03, material="plastic",
          aliases=("poop bag roll", "poo bag roll", "dog poop bag", "dog waste bag", "poop bag",
          "poo bag", "roll of poop bags", "roll of poo bags"), themes=("living",),
          colors=("black",), state="lying")  # fmt: skip
def bag_roll(look: Look) -> Shape:
    """A small roll of bags in a bone-shaped or tubular dispenser, with a bag hanging out."""
    k, color = look.between(0.9, 1.15), look.color("black", "blue", "green", "pink", "red")
    roll = cylinder(0.016, 0.06, 22, bevel=0.002).turn(1, np.pi / 2).move(-0.03, 0, 0.016)
    core = cylinder(0.007, 0.064, 14).turn(1, np.pi / 2).move(-0.032, 0, 0.016)
    tail = prism(rectangle(0.056, 0.05, 0.002), 0, 0.0012).move(y=-0.034)
    paws = prints.canvas(128, 64, color)
    for n in range(8):
        x, y = (n % 4 + 0.5) / 4, 0.3 + 0.45 * (n // 4)
        prints.disc(paws, x, y, 0.07, tint_color(color, 1.6))
        for s in (-1, 0, 1):
            prints.disc(paws, x + 0.03 * s, y - 0.12 + 0.03 * abs(s), 0.03, tint_color(color, 1.6))
    return settle([(roll, paws), (core, surfaces.plain((226, 214, 190))),
                   (tail, surfaces.plain(tint_color(color, 1.15)))],
                  0.02, hulls=[[0], [2]]).scale(k)  # fmt: skip


@category("ice_pack", size=(0.172, 0.0903, 0.0278), mass=0.35, material="plastic",
          aliases=("freezer block", "cool pack", "freezer pack", "ice block", "gel pack",
          "cooling pack"), themes=("living",), roles=("flat",), colors=("blue",),
          state="lying flat")  # fmt: skip
def ice_pack(look: Look) -> Shape:
    """A flat, ribbed plastic ice pack with a cap, filled with blue gel."""
    k, color = look.between(0.9, 1.12), look.color("blue", "sky", "cyan", "white", "teal")
    body = pad(0.16 * k, 0.09 * k, 0.026 * k, 0.014 * k, soft=0.3)
    ribs = [
        box(0.012 * k, 0.064 * k, 0.002).move(i * 0.024 * k, 0, 0.0252 * k) for i in range(-2, 3)
    ]
    cap = cylinder(0.009 * k, 0.012, 16).turn(1, np.pi / 2).move(0.079 * k, 0.025 * k, 0.013 * k)
    label = prints.canvas(120, 40, (250, 250, 250))
    prints.write(label, look.pick(["ICE", "COOL", "FREEZE"]), 0.5, 0.5, 0.6, color
                 if sum(color) < 600 else (50, 90, 170), bold=True)  # fmt: skip
    plate = box(0.06 * k, 0.02 * k, 0.0006).move(0, 0, 0.0271 * k)
    return shape([(body, look.surface(color, "plastic")),
                  (join(ribs), surfaces.plain(tint_color(color, 0.85))),
                  (cap, surfaces.plain((246, 246, 246))), (plate, label)],
                 [hull_of(body)])  # fmt: skip


CATEGORIES = (
    Category("open_suitcase",
             case((0.42, 0.28, 0.11), 0.006, ("brown", "navy", "teal", "red"), ("cream", "gray")),
             size=(0.42, 0.32, 0.26), mass=1.8, material="plastic", hollow=True,
             aliases=("opened suitcase",), themes=("living",), roles=("container", "big"),
             colors=("brown", "navy")),
)  # fmt: skip
"""Objects that share their drawing functions."""
