"""Objects of the ``workbench`` theme: cans."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, tool_steel
from ...kit.outlines import smooth
from ...kit.parts import cylinder_part, hull_of, ring_parts
from ...kit.primitives import at_block, at_box, disc, rod
from ...kit.prints import wrap
from ...kit.shapes import Pieces, Shape, category, from_pieces, shape
from ...kit.solids import cylinder, ellipsoid, join, lathe, torus, tube
from ...kit.surfaces import Look, tint_color


@category("oil_can", size=(0.142, 0.083, 0.164), mass=0.3, material="metal", assembled=True,
          aliases=("oiler", "oil dispenser can", "lubricant can"), themes=("workbench",),
          roles=("tall",), colors=("red", "copper"))  # fmt: skip
def oil_can(look: Look) -> Shape:
    """An oil can: a squat body with a conical top, a handle and a long, bent spout."""
    k = look.between(0.88, 1.08)
    color = look.color("red", "green", "blue", "copper", "silver", "yellow")
    body = lathe(np.array([(0, 0), (0.04, 0), (0.042, 0.003), (0.042, 0.04), (0.034, 0.05),
                           (0.01, 0.068), (0.009, 0.076), (0, 0.076)]) * k, 30)  # fmt: skip
    spout = smooth([(0, 0, 0.072), (0.005, 0, 0.1), (0.04, 0, 0.14), (0.075, 0, 0.165)], 5) * k
    nose = tube(spout, np.linspace(0.006, 0.0018, len(spout)) * k, 10)
    handle = tube(smooth([(-0.04, 0, 0.035), (-0.07, 0, 0.045), (-0.065, 0, 0.075),
                          (-0.012, 0, 0.072)], 4) * k, 0.0042 * k, 8)  # fmt: skip
    return shape([(body, look.surface(color, "metal")), (nose, tool_steel(look)),
                  (handle, surfaces.plain(tint_color(color, 0.7)))],
                 [cylinder_part(0.042 * k, 0.042 * k), hull_of(body), hull_of(nose),
                  hull_of(handle)])  # fmt: skip


@category("paint_can", size=(0.117, 0.117, 0.12), mass=0.9, material="metal",
          aliases=("can of paint", "tin of paint", "paint tin", "paint bucket", "tub of filler",
          "contact adhesive tin", "tub of grease", "filler tub", "varnish tin", "car wax tin",
          "paint tin lid", "tin of varnish"), themes=("workbench", "craft"), roles=("round",),
          colors=("red", "blue"), common=True)  # fmt: skip
def paint_can(look: Look) -> Shape:
    """A can of paint with a wire handle: either closed, or open and full."""
    r, h = look.between(0.046, 0.062), look.between(0.1, 0.135)
    color = look.color("red", "blue", "yellow", "green", "teal", "orange", "purple", "white")
    label = wrap(look, look.pick(["PAINT", "COLOR", "LATEX", "GLOSS"]), color, (242, 241, 236))
    tin = surfaces.brushed_metal(look.rng, (184, 186, 190))
    rims = [torus(r, 0.0018, 32, 6).move(z=z) for z in (0.002, h)]
    ears = [ellipsoid(0.012, 0.014, 0.014, 10, 6).move(s * r, 0, 0.84 * h) for s in (-1, 1)]
    a = np.linspace(0, np.pi, 13)
    bow = tube(np.column_stack([1.04 * r * np.cos(a), -0.9 * r * np.sin(a) - 0.12 * r * np.sin(a),
                                0.84 * h - 0.34 * h * np.sin(a)]), 0.0016, 6)  # fmt: skip
    drip = join([ellipsoid(0.012, 0.004, long, 8, 6).move(0, -r, h - long / 2).turn(2, angle)
                 for angle, long in look.rng.uniform((-0.9, 0.02), (0.9, 0.06),
                                                     (3, 2))])  # fmt: skip
    pieces = [(join([*rims, *ears, bow]), tin), (drip, surfaces.plain(color))]
    if look.chance(0.5):
        groove = torus(0.78 * r, 0.0016, 28, 6).move(z=h + 0.0008)
        lid = join([cylinder(0.97 * r, 0.003, 28, bevel=0.001).move(z=h - 0.002), groove])
        pieces += [(cylinder(r, h, 30), label), (lid, tin)]
        return shape(pieces, [cylinder_part(r, h)])
    body = lathe([(0, 0), (r, 0), (r, h), (0.94 * r, h), (0.94 * r, 0.8 * h), (0, 0.8 * h)], 30,
                 v=[0, 0, 0.97, 0.98, 0.99, 1])  # fmt: skip
    wet = cylinder(0.94 * r, 0.003, 28).move(z=0.8 * h)
    pieces += [(body, label), (wet, surfaces.gradient(color, tint_color(color, 1.15), look.rng))]
    ring = ring_parts([(r, 0.8 * h), (r, h)], [(0.94 * r, h), (0.94 * r, 0.8 * h)], 10)
    return shape(pieces, [cylinder_part(r, 0.8 * h), *ring])


GRIPS = ("red", "yellow", "blue", "orange", "green", "black", "teal", "gray", "lime", "violet")


@category("spray_can", size=(0.065, 0.065, 0.19), mass=0.35, material="metal",
          aliases=("spray paint", "aerosol can", "spray", "spray lubricant", "air freshener",
          "limescale remover", "stain remover", "drain cleaner", "wd-40", "wd 40", "can of wd 40",
          "de icer can", "de-icer can", "car wax spray"), themes=("workbench", "craft"),
          roles=("round", "tall"), colors=("red", "yellow", "blue", "orange", "green", "black",
          "teal", "gray", "lime", "violet"), common=True)  # fmt: skip
def spray_can(look: Look) -> Shape:
    """A spray can of paint with a cap."""
    r, h = 0.0325, look.between(0.14, 0.17)
    color = look.color(*GRIPS, "violet", "white")
    print_ = prints.label(look.rng, look.pick(["SPRAY", "PAINT", "GLOSS"]), color, (240, 240, 238))
    body = lathe([(0, 0), (r - 0.002, 0), (r, 0.002), (r, h), (0.72 * r, h + 0.016),
                  (0, h + 0.016)], v=[0, 0, 0.01, 0.95, 0.99, 1])  # fmt: skip
    cap = cylinder(0.78 * r, 0.036, 24, bevel=0.003).move(z=h + 0.008)
    return shape([(body, print_), (cap, surfaces.speckles(look.rng, color, 3))],
                 [cylinder_part(r, h), cylinder_part(0.78 * r, 0.044, (0, 0, h))])  # fmt: skip


@category("engine_oil", size=(0.12, 0.066, 0.212), mass=0.95, material="plastic",
          aliases=("bottle of engine oil", "motor oil", "engine oil bottle", "bottle of motor oil",
          "antifreeze", "coolant bottle", "screen wash", "can of engine oil", "jerry can",
          "petrol can", "fuel can"), themes=("workbench",), colors=("black", "gold"))  # fmt: skip
@from_pieces()
def engine_oil(look: Look) -> Pieces:
    """A flat bottle of engine oil with a handle, a cap and a label."""
    color = look.color("black", "gold", "blue", "red", "green", "silver")
    body = at_block(0.12, 0.065, 0.15, 0.016)
    shoulder = at_block(0.11, 0.06, 0.03, 0.02, (0, 0, 0.148))
    neck, cap = disc(0.016, 0.025, (0.032, 0, 0.175)), disc(0.019, 0.022, (0.032, 0, 0.19))
    grip = rod([(-0.045, 0, 0.17), (-0.045, 0, 0.195), (-0.01, 0, 0.2), (0.02, 0, 0.185)], 0.009, 8)
    tile = look.surface(color)
    tag = prints.canvas(96, 96, tint_color(color, 1.7))
    prints.fill(tag, 0, 0.12, 1, 0.34, (200, 44, 40))
    prints.write(tag, "OIL", 0.5, 0.29, 0.26, (250, 250, 246), True)
    prints.write(tag, look.pick(["5W-30", "10W-40", "0W-20"]), 0.5, 0.66, 0.17, (30, 30, 34), True)
    front = at_box(0.09, 0.001, 0.1, (0, -0.0328, 0.025))
    return [(body, tile), (shoulder, tile),
            (join([neck, cap]), dye(look, "red", "black", "yellow")), (grip, tile),
            (front, tag)]  # fmt: skip
