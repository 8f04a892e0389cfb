"""Objects of the ``office`` theme: tools."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import PAINTS, dye, metal, plastic, shine, wood
from ...kit.outlines import arc, smooth
from ...kit.parts import hull_of
from ...kit.primitives import at_block, at_box, disc, limb, plate, rod, spindle, standing, straight
from ...kit.shapes import Pieces, Shape, at_rest, category, from_pieces, shape, vary
from ...kit.solids import block, box, cylinder, join, lathe, torus
from ...kit.surfaces import Look, tint_color

BLACK = surfaces.plain((34, 34, 37))
WHITE = surfaces.plain((244, 243, 240))


@category("watercolour_set", size=(0.189, 0.108, 0.078), mass=0.2, material="metal",
          aliases=("watercolor set", "watercolour box", "watercolor box", "watercolour pan set",
          "paint set", "paint box", "watercolor palette", "watercolour palette", "face paint set",
          "watercolor paint set", "watercolour paints"), themes=("office",),
          colors=("black",))  # fmt: skip
@from_pieces(bodies=2)
def watercolour_set(look: Look) -> Pieces:
    """An open watercolour box with two rows of pans, a lid behind and a brush."""
    case = metal(look, "black", "white", "silver", "red")
    body, lid = (at_block(0.19, 0.075, 0.014, 0.006),
                 at_block(0.19, 0.075, 0.008, 0.006).turn(0, 1.1))  # fmt: skip
    lid = lid.move(0, 0.055, 0.042)
    inner = at_block(0.178, 0.066, 0.001, 0.004, (0, 0, 0.0137))
    names = ("yellow", "orange", "red", "pink", "purple", "blue", "sky", "teal", "green", "lime",
             "brown", "black")  # fmt: skip
    pieces: Pieces = [(body, case), (lid.move(z=-min(float(lid.bounds[0, 2]), 0.0)), case),
                      (inner, WHITE)]  # fmt: skip
    for k, name in enumerate(names):
        pieces.append((at_block(0.023, 0.019, 0.003, 0.003, (-0.0725 + 0.029 * (k % 6), 0.019
                                                             - 0.024 * (k // 6), 0.0145)),
                       dye(look, name)))  # fmt: skip
    brush = [spindle((-0.06, 0.0022), (0.03, 0.003), z=0.0185).move(y=-0.027),
             spindle((0.03, 0.0028), (0.05, 0.0006), z=0.0185).move(y=-0.027)]  # fmt: skip
    return [*pieces, (brush[0], dye(look, "red", "black")), (brush[1], dye(look, "brown"))]


@category("stencil", size=(0.2, 0.13, 0.0014), mass=0.015, material="paper",
          aliases=("letter stencil", "drawing stencil", "lettering stencil", "stencil sheet",
          "shape template"), themes=("office",), roles=("flat",), colors=("green",))  # fmt: skip
@from_pieces()
def stencil(look: Look) -> Pieces:
    """A thin coloured sheet with pale cut-outs: letters, or circles above rectangles."""
    color = look.color("green", "blue", "orange", "yellow", "beige")
    image = prints.canvas(144, 96, color)
    hole = (246, 244, 238)
    kind = int(look.rng.integers(2))
    if kind:
        for k, letter in enumerate("ABCDEFGHIJKL"):
            prints.write(
                image, letter, 0.13 + 0.15 * (k % 6), 0.32 + 0.36 * (k // 6), 0.26, hole, True
            )
    else:
        for k in range(4):
            prints.disc(image, 0.16 + 0.225 * k, 0.3, 0.05 + 0.035 * k, hole)
            s = 0.06 + 0.03 * k
            prints.fill(image, 0.16 + 0.225 * k - s / 2, 0.74 - s * 0.75, s, 1.5 * s, hole)
    return [
        (at_block(0.2, 0.13, 0.0012, 0.006), surfaces.plain(color)),
        (at_box(0.19, 0.12, 0.0004, (0, 0, 0.001)), image),
    ]


@category("silkscreen", size=(0.26, 0.32, 0.022), mass=0.5, material="wood",
          aliases=("silk screen", "screen printing frame", "printing screen", "screen print frame"),
          themes=("office",), roles=("flat", "big"), colors=("wooden",))  # fmt: skip
@from_pieces()
def silkscreen(look: Look) -> Pieces:
    """A screen printing frame with a mesh and a picture."""
    tile = wood(look, "wooden", "beige", "brown")
    sides = [at_box(0.26, 0.025, 0.022, (0, s * 0.1475, 0)) for s in (-1, 1)] + [
        at_box(0.025, 0.27, 0.022, (s * 0.1175, 0, 0)) for s in (-1, 1)
    ]
    image = surfaces.grid((222, 214, 190), (236, 230, 208), 32, 32).copy()
    color = look.own_color(*PAINTS)
    prints.disc(image, 0.5, 0.45, 0.26, color)
    prints.polygon(image, [(0.2, 0.85), (0.5, 0.3), (0.8, 0.85)], tint_color(color, 0.7))
    return [*((s, tile) for s in sides), (at_box(0.212, 0.272, 0.003, (0, 0, 0.002)), image)]


@category("airbrush", size=(0.153, 0.0917, 0.0412), mass=0.15, material="metal", assembled=True,
          aliases=("air brush", "airbrush pen", "airbrush gun pen"), themes=("office",),
          colors=("silver",))  # fmt: skip
@at_rest
@from_pieces(foot=0.1, bodies=3)
def airbrush(look: Look) -> Pieces:
    """An airbrush lying flat: a slim metal body, a cup on top, a lever, a valve and a hose."""
    steel = metal(look, "silver", "gold", "gray")
    z = 0.012
    body = spindle((-0.08, 0.0055), (-0.075, 0.0085), (-0.02, 0.0085), (0.03, 0.0075),
                   (0.05, 0.005), (0.062, 0.0022), z=z)  # fmt: skip
    cup = standing((0.004, 0.018), (0.013, 0.028), (0.014, 0.042)).move(x=0.012)
    lever = rod([(-0.01, 0, 0.018), (-0.014, 0, 0.03), (-0.02, 0, 0.033)], 0.0028, 8)
    valve = at_block(0.012, 0.03, 0.014, 0.004, (-0.008, -0.018, 0.004))
    hose = rod([(-0.008, -0.03, 0.01), (-0.01, -0.06, 0.005), (-0.05, -0.075, 0.004),
                (-0.09, -0.05, 0.004)], 0.0035, 8, 5)  # fmt: skip
    return [(body, steel), (valve, steel), (hose, BLACK), (cup, steel), (lever, steel)]


@category("rotary_cutter", size=(0.168, 0.0449, 0.0242), mass=0.09, material="plastic",
          assembled=True, aliases=("rotary fabric cutter", "fabric cutter", "roller cutter",
          "rotary trimmer", "rotary knife", "rotary blade cutter"), themes=("office",),
          colors=("yellow",))  # fmt: skip
@from_pieces(foot=0.1, bodies=3)
def rotary_cutter(look: Look) -> Pieces:
    """A rotary cutter lying flat: a curved handle with a round blade at its end."""
    tile = plastic(look, "yellow", "pink", "purple", "teal", "red")
    grip = rod([(-0.08, -0.012, 0.011), (-0.03, 0.004, 0.011), (0.02, 0.006, 0.011),
                (0.045, 0.0, 0.011)], [0.011, 0.012, 0.0105, 0.01], 12)  # fmt: skip
    head = at_block(0.034, 0.03, 0.016, 0.01, (0.05, 0, 0.002))
    blade = disc(0.0225, 0.0012, (0.062, -0.004, 0.0085), sides=36)
    nut = disc(0.009, 0.006, (0.06, -0.003, 0.0165))
    strip = spindle((-0.06, 0.0108), (0.0, 0.0108), z=0.0135).scale(1, 0.5, 1)
    return [(grip, tile), (head, tile), (blade, shine(look)), (nut, BLACK),
            (strip, dye(look, "gray", "black"))]  # fmt: skip


@category("price_gun", size=(0.177, 0.171, 0.0338), mass=0.3, material="plastic", assembled=True,
          aliases=("pricing gun", "labelling gun", "label gun", "labeling gun", "price tag gun",
          "tagging gun"), themes=("office",), colors=("orange",), state="lying flat")  # fmt: skip
def price_gun(look: Look) -> Shape:
    """A price labelling gun lying on its side: a body, a pistol grip and a roll of labels."""
    k = look.between(0.92, 1.06)
    color = look.color("orange", "blue", "yellow", "red", "green")
    body = block(0.13, 0.05, 0.034, 0.012, 0.004)
    grip = block(0.035, 0.1, 0.03, 0.012, 0.004).turn(2, -0.25).move(0.035, -0.06, 0.001)
    roll = cylinder(0.026, 0.028, 26).move(-0.01, 0.036, 0.003)
    lever = limb([(-0.01, -0.02, 0.016), (0.0, -0.06, 0.016), (0.012, -0.09, 0.016)],
                 [0.006, 0.006, 0.005], 8)  # fmt: skip
    labels = box(0.05, 0.016, 0.0008).move(-0.088, 0.0, 0.008)
    return shape([(join([body, grip]), surfaces.speckles(look.rng, color, 4)),
                  (join([roll, labels]), surfaces.plain((250, 246, 220))),
                  (lever, surfaces.plain((40, 42, 46)))], [hull_of(body), hull_of(grip),
                                                           hull_of(roll),
                                                           hull_of(lever)]).scale(k)  # fmt: skip


@category("gavel", size=(0.235, 0.095, 0.065), mass=0.3, material="wood", assembled=True,
          aliases=("judge gavel", "judge hammer", "auction hammer", "judge's gavel"),
          themes=("office",), colors=("brown",))  # fmt: skip
def gavel(look: Look) -> Shape:
    """A judge's gavel lying across its sound block."""
    k = look.between(0.9, 1.06)
    color = look.color("brown", "wooden", "maroon", "brown", "black")
    wood = look.surface(color, "wood")
    plate = cylinder(0.048 * k, 0.02 * k, 32, bevel=0.004)
    head = lathe(np.array([(0, 0), (0.02, 0), (0.0225, 0.004), (0.0215, 0.014), (0.018, 0.018),
                           (0.02, 0.045), (0.018, 0.072), (0.0215, 0.076), (0.0225, 0.086),
                           (0.02, 0.09), (0, 0.09)]) * k, 24)  # fmt: skip
    head = head.turn(0, np.pi / 2).move(y=0.045 * k, z=0.0425 * k)
    grip = lathe(np.array([(0, 0), (0.0065, 0), (0.006, 0.05), (0.0085, 0.13), (0.0105, 0.17),
                           (0.007, 0.19), (0, 0.192)]) * k, 16)  # fmt: skip
    lean = np.arctan2(0.027, 0.17)
    grip = grip.turn(1, np.pi / 2 + lean).move(z=0.0425 * k)
    brass = torus(0.0206 * k, 0.0016 * k, 24, 6).turn(0, np.pi / 2).move(z=0.0425 * k)
    return shape([(join([plate, head, grip]), wood), (brass, surfaces.plain((206, 170, 90)))],
                 [hull_of(plate), hull_of(head), hull_of(grip)])  # fmt: skip


@category("french_curve", size=(0.217, 0.103, 0.0022), mass=0.02, material="plastic",
          aliases=("curve template", "drawing template", "drawing curve"), themes=("office",),
          colors=("clear",))  # fmt: skip
@from_pieces(bodies=1)
def french_curve(look: Look) -> Pieces:
    """A French curve: a clear template with swirls and cut-outs."""
    color = look.color("clear", "green", "orange", "sky")
    outline = smooth([(-0.1, -0.02), (-0.06, -0.05), (0.0, -0.03), (0.05, -0.045), (0.11, -0.03),
                      (0.115, 0.0), (0.08, 0.012), (0.05, 0.0), (0.0, 0.028), (-0.04, 0.052),
                      (-0.085, 0.04), (-0.1, -0.02)], 6)[:-1]  # fmt: skip
    body = plate(outline, 0.002)
    holes = [disc(r, 0.0004, sides=20).scale(1.5, 1, 1).move(x, y, 0.0018) for r, x,
             y in ((0.016, -0.06, 0.005), (0.009, 0.01, -0.01), (0.009, 0.075, -0.02))]  # fmt: skip
    return [(body, surfaces.plain(tint_color(color, 1.2))),
            (join(holes), surfaces.plain(tint_color(color, 0.75)))]  # fmt: skip


@category("t_square", size=(0.42, 0.2, 0.008), mass=0.15, material="wood",
          aliases=("tee square", "drafting square", "t-square"), themes=("office",),
          colors=("wooden",))  # fmt: skip
@from_pieces()
def t_square(look: Look) -> Pieces:
    """A wooden T-square lying flat: a head on the left and a long blade with a scale."""
    tile = wood(look, "wooden", "tan", "beige")
    blade = at_box(0.4, 0.04, 0.003, (0.02, 0, 0.004))
    head = at_box(0.03, 0.2, 0.008, (-0.185, 0, 0))
    scale = prints.rule(20, (236, 214, 166), (60, 46, 34))
    foot = at_box(0.03, 0.03, 0.0045, (0.2, 0, 0))
    return [(blade, tile), (head, tile), (foot, tile), (at_box(0.39, 0.01, 0.0005,
                                                               (0.02, 0.014, 0.0068)),
                                                        scale)]  # fmt: skip


@category("geometry_set", size=(0.2, 0.13, 0.095), mass=0.25, material="metal",
          aliases=("maths set", "math set", "compass set", "drawing set", "geometry tin",
          "mathematical instruments"), themes=("office",), colors=("silver",))  # fmt: skip
@from_pieces(bodies=6)
def geometry_set(look: Look) -> Pieces:
    """An open tin of drawing tools: compasses, a set square, a protractor, a ruler and a pencil."""
    tile = metal(look, "silver", "blue", "red", "gold")
    floor = at_box(0.2, 0.1, 0.002)
    sides = [at_box(0.2, 0.002, 0.018, (0, s * 0.049, 0)) for s in (-1, 1)] + [
        at_box(0.002, 0.1, 0.018, (s * 0.099, 0, 0)) for s in (-1, 1)
    ]
    lid = at_box(0.2, 0.1, 0.002).turn(0, 1.9).move(0, 0.066, 0.046)
    ruler = at_box(0.17, 0.022, 0.002, (0, 0.034, 0.002))
    square = plate([(-0.09, -0.03), (-0.02, -0.03), (-0.09, 0.015)], 0.002, 0.003)
    half = plate(arc((0.045, -0.008), 0.036, 0, np.pi, 16), 0.002, 0.003)
    legs = [
        straight((0.0, -0.02, 0.008), (0.08, -0.03 + 0.014 * k, 0.006), 0.0026, 8) for k in (0, 1)
    ]
    pencil = spindle((-0.06, 0.0035), (0.06, 0.0035), (0.07, 0.0004), sides=6, z=0.008).move(
        y=-0.04
    )
    return [(floor, tile), *((s, tile) for s in sides), (lid.move(z=-float(lid.bounds[0, 2])),
                                                         tile),
            (ruler, prints.rule(15, (244, 232, 160), (50, 50, 54))),
            (square, surfaces.plain((150, 206, 180))), (half, surfaces.plain((240, 170, 150))),
            (join(legs), shine(look)), (pencil, surfaces.plain((240, 190, 50)))]  # fmt: skip


@category("pantograph", size=(0.27, 0.17, 0.018), mass=0.12, material="wood",
          aliases=("drawing pantograph",), themes=("office",), colors=("wooden",))  # fmt: skip
@from_pieces()
def pantograph(look: Look) -> Pieces:
    """A pantograph lying flat: two long and two short wooden bars joined by metal pins."""
    tile = wood(look, "wooden", "tan", "beige")
    a, b, c, d, e = (-0.14, -0.06), (0.0, 0.09), (0.12, -0.06), (-0.07, 0.015), (0.06, 0.015)
    bars = [straight((*p, 0.006), (*q, 0.006), 0.006, 4) for p,
            q in ((a, b), (b, c), (d, (-0.01, -0.06)), (e, (-0.01, -0.06)))]  # fmt: skip
    pins = [disc(0.006, 0.018, (*p, 0), sides=12) for p in (a, b, c, d, e, (-0.01, -0.06))]
    return [*((s, tile) for s in bars), (join(pins), shine(look, "brass", "silver"))]


@category("slide_rule", size=(0.3, 0.042, 0.0098), mass=0.08, material="wood",
          aliases=("sliding ruler", "calculating ruler"), themes=("office",),
          colors=("cream",))  # fmt: skip
@vary(0.08)
@from_pieces(bodies=4)
def slide_rule(look: Look) -> Pieces:
    """A slide rule: a body with scales, a slightly extended slide and a cursor."""
    scale = prints.rule(25, (246, 242, 226), (40, 40, 46))
    body = [at_box(0.28, 0.013, 0.007, (0, s * 0.0125, 0)) for s in (-1, 1)]
    out = look.between(0.01, 0.04)
    slide = at_box(0.28, 0.0118, 0.0065, (out, 0, 0))
    cursor = at_box(0.026, 0.042, 0.003, (-0.03, 0, 0.0065))
    line = at_box(0.0008, 0.04, 0.0006, (-0.03, 0, 0.0092))
    return [(body[0], scale), (body[1], scale[::-1]), (slide, scale),
            (cursor, surfaces.plain((206, 226, 232))),
            (line, surfaces.plain((200, 40, 40)))]  # fmt: skip
