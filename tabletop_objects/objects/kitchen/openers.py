"""Objects of the ``kitchen`` theme: openers."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, hull_above, hull_of, hull_part
from ...kit.primitives import ball, limb, lobe, straight
from ...kit.shapes import Category, Pieces, Shape, category, keep_still, shape
from ...kit.solids import block, box, cylinder, join, lathe, sweep, torus, tube
from ...kit.surfaces import RGB, Look, tint_color
from .utensils import bright_steel, with_handle


@category("corkscrew", size=(0.134, 0.106, 0.0271), mass=0.12, material="metal",
          aliases=("cork screw", "wine opener", "wine bottle opener", "winged corkscrew",
          "waiters friend", "waiter's friend", "sommelier knife"), themes=("kitchen", "dining"),
          colors=("silver", "wooden"), state="lying flat")  # fmt: skip
def corkscrew(look: Look) -> Shape:
    """A corkscrew lying flat: a winged metal corkscrew, or a screw with a wooden handle."""
    color = look.color("wooden", "black", "brown", "red", "silver", "maroon")
    a = np.linspace(0, 6 * 2 * np.pi, 66)
    steel = bright_steel(look)
    if look.chance(0.5):
        coil = tube(np.column_stack([-0.035 - 0.055 * a / a[-1], 0.004 * np.cos(a),
                                     0.004 * np.sin(a)]),
                    np.linspace(0.0016, 0.0006, len(a)), 5)  # fmt: skip
        shaft = join([coil, tube([(0, 0, 0), (-0.038, 0, 0)], 0.003, 8)])
        shaft = shaft.turn(1, -np.arctan2(0.0068, 0.09)).move(z=0.0115)
        grip = (lathe([(0, -0.05), (0.007, -0.048), (0.011, -0.03), (0.0095, 0), (0.011, 0.03),
                       (0.007, 0.048), (0, 0.05)],
                      16).turn(0, np.pi / 2).move(z=0.0115))  # fmt: skip
        return shape([(shaft, steel), (grip, look.surface(color, "wood"))],
                     [box_part(0.012, 0.09, 0.021, (0, 0, 0.001)), hull_of(shaft)])  # fmt: skip
    metal = surfaces.brushed_metal(
        look.rng, look.own_color("silver", "brass", "charcoal", "copper")
    )
    frame = lathe(
        [(0, 0), (0.018, 0), (0.018, 0.01), (0.01, 0.035), (0.012, 0.062), (0, 0.062)], 18
    )
    frame = frame.turn(1, np.pi / 2).move(x=-0.09, z=0.018)
    coil = tube(np.column_stack([-0.085 - 0.04 * a / a[-1], 0.0045 * np.cos(a),
                                 0.018 + 0.0045 * np.sin(a)]), 0.0014, 5)  # fmt: skip
    screw = join([coil, tube([(-0.03, 0, 0.018), (0.02, 0, 0.018)], 0.004, 8)])
    top = block(0.03, 0.036, 0.012, 0.009, 0.002).move(x=0.03, z=0.012)
    key = torus(0.009, 0.004, 18, 8).move(x=0.05, z=0.018)
    arms, parts = [], []
    for s in (-1, 1):
        path = smooth([(-0.034, s * 0.008, 0.018), (-0.03, s * 0.03, 0.018),
                       (-0.052, s * 0.045, 0.018), (-0.095, s * 0.052, 0.014)], 4)  # fmt: skip
        arm = sweep(path, rectangle(0.011, 0.006, 0.002, 2))
        arms.append(arm)
        parts.append(hull_part(arm.vertices[-36:]))
    return shape([(join([frame, *arms, top, key]), metal), (screw, steel)],
                 [box_part(0.062, 0.02, 0.035, (-0.059, 0, 0.0005)), hull_of(screw),
                  hull_of(top, key), *parts])  # fmt: skip


@category("bottle_opener", size=(0.115, 0.038, 0.01), mass=0.06, material="metal",
          aliases=("beer opener", "church key", "bar blade", "bar key"),
          themes=("kitchen", "dining"), roles=("flat",), colors=("silver", "black"),
          state="lying flat")  # fmt: skip
def bottle_opener(look: Look) -> Shape:
    """A bottle opener lying flat: a steel ring with a tooth and a metal, plastic or wooden grip."""
    color = look.color("silver", "black", "red", "gold", "wooden", "teal", "blue")
    long, r = look.between(0.1, 0.13), look.between(0.017, 0.021)
    t = 0.004
    eye = lathe([(0.62 * r, 0), (r, 0), (r, t), (0.62 * r, t)], 28, loop=True)
    eye = eye.scale(1.15, 1, 1).move(x=-0.5 * long + r, z=0.003)
    tooth = box(0.009, 0.014, t).move(x=-0.5 * long + 1.9 * r, z=0.003)
    neck = box(0.3 * long, 0.014, t).move(x=-0.5 * long + 2.05 * r + 0.12 * long, z=0.003)
    start = -0.5 * long + 2.3 * r
    grip = block(0.5 * long - start, 0.022, 0.01, 0.009, 0.003).move(x=(start + 0.5 * long) / 2)
    skin = look.surface(color, look.pick(["plastic", "metal", "wood"]))
    hole = cylinder(0.004, 0.0103, 12).move(x=0.5 * long - 0.011)
    angles = np.arange(8) * np.pi / 4
    ring = [box_part(0.5 * r, 0.35 * r, t, (-0.5 * long + r + 0.9 * r * np.cos(a), 0.78 * r
                                            * np.sin(a), 0.003)) for a in angles]  # fmt: skip
    return shape([(join([eye, tooth, neck]), bright_steel(look)), (grip, skin),
                  (hole, surfaces.plain(tint_color(color, 0.4)))],
                 [*ring, hull_of(neck), hull_of(grip)])  # fmt: skip


@category("egg_topper", size=(0.037, 0.0373, 0.167), mass=0.12, material="metal", assembled=True,
          aliases=("egg cracker", "egg opener", "egg clacker"), themes=("kitchen",),
          roles=("tall",), colors=("silver",))  # fmt: skip
def egg_topper(look: Look) -> Shape:
    """An egg topper: a steel bell on a rod with a sliding ball."""
    k = look.between(0.94, 1.06)
    color = look.color("silver", "silver", "copper", "gold")
    bell = lathe([(0, 0.012), (0.017, 0.0), (0.0185, 0.0), (0.016, 0.014), (0.006, 0.022), (0,
                  0.023)], 26)  # fmt: skip
    stem = straight((0, 0, 0.02), (0, 0, 0.16), 0.003)
    weight = ball(0.026, 0.026, 0.024, (0, 0, 0.07), 18)
    cap = ball(0.013, 0.013, 0.012, (0, 0, 0.16), 12)
    metal = surfaces.brushed_metal(look.rng, color)
    foot = cylinder(0.018, 0.003, 26)
    return shape([(join([bell, stem, weight, cap, foot]), metal)],
                 [hull_of(foot, bell), hull_of(stem, cap), hull_of(weight)]).scale(k)  # fmt: skip


GRIPS = ("black", "red", "teal", "white", "navy", "sage", "gray")


@category("can_opener", size=(0.2, 0.0595, 0.024), mass=0.16, material="plastic",
          aliases=("tin opener",), themes=("kitchen",), colors=("black", "red"),
          state="lying flat")  # fmt: skip
def can_opener(look: Look) -> Shape:
    """A can opener lying flat: two handles on the right, a cutting wheel and a turning key."""
    long = look.between(0.17, 0.2)
    color = look.color(*GRIPS)
    steel, skin = bright_steel(look), look.surface(color, "plastic")
    arms = [limb([(-0.38 * long, s * 0.004, 0.006), (-0.1 * long, s * 0.01, 0.006),
                  (0.46 * long, s * 0.021, 0.0075), (0.5 * long, s * 0.021, 0.0075)],
                 [0.006, 0.0065, 0.0085, 0.005], 10, 0.9) for s in (-1, 1)]  # fmt: skip
    plate = block(0.06, 0.03, 0.004, 0.01).move(-0.4 * long, 0, 0.006)
    wheel = cylinder(0.011, 0.003, 24).move(-0.46 * long, 0.004, 0.0095)
    cog = lobe(cylinder(0.0075, 0.004, 36), 12, 0.2).move(-0.43 * long, -0.007, 0.0095)
    stem = cylinder(0.004, 0.012, 12).move(-0.38 * long, 0, 0.009)
    key = block(0.013, 0.05, 0.005, 0.006, 0.001).turn(2, 0.35).move(-0.38 * long, 0, 0.019)
    return shape(
        [(join(arms), skin), (join([plate, wheel, cog, stem]), steel), (key, skin)],
        [hull_above(a) for a in arms] + [hull_of(plate, wheel), hull_of(stem, key)],
    )


def _jaw(look: Look, color: RGB, z: float) -> Pieces:
    ring = lathe([(0.026, 0), (0.032, 0), (0.032, 0.016), (0.026, 0.016)], 26, loop=True).move(
        -0.03, 0, z - 0.008
    )
    teeth = [cylinder(0.003, 0.016, 5).move(-0.03 + 0.026 * np.cos(a), 0.026 * np.sin(a), z - 0.008)
             for a in np.arange(14) * 0.449]  # fmt: skip
    return [(join([ring, *teeth]), surfaces.plain((44, 44, 48)))]


CATEGORIES = (
    Category("jar_opener", keep_still(with_handle(_jaw, (0.11, 0.14), 0.0, r=0.01)),
             size=(0.187, 0.0634, 0.0223), mass=0.12, material="plastic", assembled=True,
             aliases=("lid opener", "bottle grip", "jar wrench"), themes=("kitchen",),
             colors=("black", "red"), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
