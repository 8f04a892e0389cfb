"""Objects of the ``office`` theme: tools."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import PAINTS, dye, metal, plastic, shine, wood
from ...kit.outlines import ellipse, smooth
from ...kit.parts import box_part, hull_of
from ...kit.primitives import at_block, at_box, disc, limb, rod, spindle, standing
from ...kit.shapes import Pieces, Shape, at_rest, category, from_pieces, shape
from ...kit.solids import block, box, cylinder, join, lathe, prism, torus, tube
from ...kit.surfaces import Look, tint_color

BLACK = surfaces.plain((34, 34, 37))


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


@category("eyeglasses", size=(0.138, 0.14, 0.046), mass=0.03, material="plastic", assembled=True,
          aliases=("glasses", "spectacles", "sunglasses", "reading glasses", "eyeglass",
          "lorgnette", "pince-nez", "3d glasses", "safety goggles", "safety glasses", "lab goggles",
          "swimming goggles", "face shield"), themes=("office", "living", "coffee"),
          colors=("black", "brown"), state="lying open", common=True)  # fmt: skip
def eyeglasses(look: Look) -> Shape:
    """Spectacles with their arms folded out at the back and the lenses towards the viewer."""
    color = look.color("black", "black", "brown", "red", "gold", "navy", "silver", "teal", "pink")
    wire = look.chance(0.3)
    skin = surfaces.speckles(look.rng, color, 3, 16)
    if look.chance(0.25):
        skin = surfaces.spots(look.rng, (150, 96, 50), (60, 40, 30), 0.35)
    sun = look.chance(0.4)
    dark = look.pick([(60, 56, 60), (70, 50, 36), (50, 70, 60), (90, 110, 170)])
    tint = surfaces.plain(dark if sun else (206, 222, 228))
    half, tall = look.between(0.025, 0.0275), look.between(0.016, 0.023)
    square = look.pick([1.0, 1.0, 0.55, 0.7])
    thick = 0.0011 if wire else look.between(0.0018, 0.003)
    curve = ellipse(2, 2, 28)
    curve = np.sign(curve) * np.abs(curve) ** square * [half, tall]
    ring = np.column_stack([curve[:, 0], np.zeros(28), curve[:, 1]])
    pieces = []
    for side in (-1, 1):
        rim = tube(ring, thick, 6, loop=True)
        lens = prism(0.99 * curve, -0.0008, 0.0008).turn(0, np.pi / 2)
        at = (side * 0.036, 0, tall + thick)
        pieces += [(rim.move(*at), skin), (lens.move(*at), tint)]
        hinge = side * (0.036 + half)
        arm = tube([(hinge, 0, 1.35 * tall), (side * 0.067, 0.1, 1.3 * tall),
                    (side * 0.064, 0.135, 0.002)], max(thick, 0.0016), 6)  # fmt: skip
        pieces.append((arm.move(z=0.0002), skin))
    bridge = tube(smooth([(-0.01, 0, 0.03), (0, 0, 0.034), (0.01, 0, 0.03)], 3), 0.002, 6)
    pieces.append((bridge, skin))
    return shape(pieces, [box_part(0.12, 0.0036, 2 * tall), *[box_part(0.0036, 0.13, 1.3 * tall,
                                                                       (side * 0.0645, 0.066, 0))
                                                              for side in (-1, 1)]])  # fmt: skip
