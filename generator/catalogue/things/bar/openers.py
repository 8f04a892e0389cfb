"""Openers and cutters for the table, and chopsticks."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of, hull_part
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, loft, sweep, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..kitchen.utensils import bright_steel, grip_bar


def corkscrew(look: Look) -> Shape:
    """A corkscrew lying: a winged one of steel, or a screw with a wooden handle."""
    color = look.color("wooden", "black", "brown", "red", "silver", "maroon")
    a = np.linspace(0, 6 * 2 * np.pi, 66)
    steel = bright_steel(look)
    if look.chance(0.5):
        coil = tube(np.column_stack([-0.035 - 0.055 * a / a[-1], 0.004 * np.cos(a),
                                     0.004 * np.sin(a)]),
                    np.linspace(0.0016, 0.0006, len(a)), 5)  # fmt: skip
        shaft = join([coil, tube([(0, 0, 0), (-0.038, 0, 0)], 0.003, 8)])
        shaft = shaft.turn(1, -np.arctan2(0.0068, 0.09)).move(z=0.0115)
        grip = (
            lathe(
                [
                    (0, -0.05),
                    (0.007, -0.048),
                    (0.011, -0.03),
                    (0.0095, 0),
                    (0.011, 0.03),
                    (0.007, 0.048),
                    (0, 0.05),
                ],
                16,
            )
            .turn(0, np.pi / 2)
            .move(z=0.0115)
        )
        return shape([(shaft, steel), (grip, look.surface(color, "wood"))],
                     [box_part(0.012, 0.09, 0.021, (0, 0, 0.001)), hull_of(shaft)])  # fmt: skip
    metal = textures.brushed_metal(
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


def bottle_opener(look: Look) -> Shape:
    """A bottle opener lying flat: a steel bar with an eye, or an eye with a handle."""
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
    ring = [
        box_part(
            0.5 * r,
            0.35 * r,
            t,
            (-0.5 * long + r + 0.9 * r * np.cos(a), 0.78 * r * np.sin(a), 0.003),
        )
        for a in angles
    ]
    return shape([(join([eye, tooth, neck]), bright_steel(look)), (grip, skin),
                  (hole, textures.plain(tint_color(color, 0.4)))],
                 [*ring, hull_of(neck), hull_of(grip)])  # fmt: skip


def chopsticks(look: Look) -> Shape:
    """A pair of chopsticks lying side by side, thin ends to the left."""
    long, gap = look.between(0.21, 0.25), look.between(0.012, 0.02)
    color = look.color("wooden", "brown", "black", "red", "tan", "maroon", "white")
    wood = look.surface(color, "wood")
    band = textures.plain(look.own_color("gold", "red", "white", "black", "teal"))
    tile = textures.stack((wood, 74), (band, 4), (wood, 4), (band, 2), (wood, 16), side=128)
    sticks = []
    for s in (-1, 1):
        stick = loft(np.stack([np.column_stack([rectangle(w, w, 0.25 * w, 1), np.full(8, z)])
                               for w, z in ((0.0036, 0), (0.0052, 0.4 * long), (0.0075, long))]),
                     rectangle(1, 1, 0.25, 1))  # fmt: skip
        stick = stick.turn(1, np.pi / 2 + np.arctan2(0.002, long)).move(x=-long / 2)
        stick = stick.turn(2, s * look.between(0.0, 0.02))
        low = stick.bounds[0, 2]
        sticks.append(stick.move(y=s * gap / 2, z=-low))
    return shape([(s, tile) for s in sticks], [hull_of(s) for s in sticks])


def pizza_cutter(look: Look) -> Shape:
    """A pizza wheel lying flat, its wheel to the left."""
    r, long = look.between(0.034, 0.046), look.between(0.2, 0.23)
    color = look.color("black", "red", "wooden", "white", "green", "teal")
    wheel = lathe([(0, 0.0085), (0.8 * r, 0.0085), (r, 0.0095), (0.8 * r, 0.0105), (0, 0.0105)], 34)
    wheel = wheel.move(x=-0.5 * long + r)
    hub = cylinder(0.008, 0.019, 16, bevel=0.002).move(x=-0.5 * long + r)
    arms = [box(r + 0.03, 0.012, 0.002).move(-0.5 * long + r + 0.5 * (r + 0.02), 0, z)
            for z in (0.0055, 0.0115)]  # fmt: skip
    start = -0.5 * long + 2 * r + 0.012
    grip = grip_bar(start, 0.5 * long, 0.028, 0.0095)
    guard = block(0.01, 0.034, 0.018, 0.004, 0.002).move(x=start + 0.004)
    return shape(
        [
            (join([wheel, *arms]), bright_steel(look)),
            (hub, textures.plain((60, 62, 66))),
            (join([grip, guard]), look.surface(color, "plastic")),
        ],
        [hull_of(wheel), hull_of(hub), hull_of(*arms), hull_of(grip), hull_of(guard)],
    )


CATEGORIES = (
    Category("corkscrew", corkscrew, (0.134, 0.106, 0.0271), 0.12, ("cork screw", "wine opener",
                 "wine bottle opener", "winged corkscrew", "waiters friend", "waiter's friend",
                 "sommelier knife"), ("kitchen", "dining"), (), ("silver",
             "wooden"), state="lying flat"),
    Category("bottle_opener", bottle_opener, (0.115, 0.038, 0.01), 0.06, ("beer opener",
                 "church key", "bar blade", "bar key"),
             ("kitchen", "dining"), ("flat",), ("silver", "black"),
             state="lying flat"),
    Category("chopsticks", chopsticks, (0.224, 0.0273, 0.00755), 0.018, ("pair of chopsticks",
             "chopstick", "chop sticks"), ("dining",), ("flat",), ("wooden", "black"),
             state="lying flat"),
    Category("pizza_cutter", pizza_cutter, (0.215, 0.08, 0.019), 0.12, ("pizza wheel",
             "pizza slicer", "rolling cutter", "tracing wheel"), ("kitchen",),
             ("flat",), ("black",
             "red"), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
