"""Screws, bolts, nails and keys for them, files, chisels, rollers, padlocks, a sewing machine."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of, ring_parts
from ...build.forms import facing
from ...build.outlines import arc
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .tools import lying

METALS = ("silver", "silver", "gold", "brass", "charcoal", "gray")


def screw(look: Look) -> Shape:
    """A wood screw lying: a countersunk head with a cross, a thread, a point."""
    k = look.between(0.85, 1.3)
    color = look.color(*METALS)
    long, r = 0.04 * k, 0.0024 * k
    shank = lathe(
        [
            (0, 0),
            (2.1 * r, 0),
            (2.1 * r, 0.0006),
            (r, 0.0035 * k),
            (r, 0.72 * long),
            (0.2 * r, long),
            (0, long),
        ],
        12,
    )
    a = np.linspace(0, 9 * 2 * np.pi, 72)
    t = a / a[-1]
    away = 0.95 * r * np.clip((1 - t) / 0.3, 0.15, 1)
    thread = tube(
        np.column_stack([away * np.cos(a), away * np.sin(a), 0.3 * long + 0.69 * long * t]),
        0.00055 * k,
        3,
    )
    cross = [box(2.6 * r, 0.6 * r, 0.0004).turn(2, n * np.pi / 2).move(z=-0.0002) for n in (0, 1)]
    lean = np.arctan2(1.3 * r, long)
    lay = [lying(s).turn(1, lean) for s in (join([shank, thread]), join(cross))]
    low = min(float(s.bounds[0, 2]) for s in lay)
    body, mark = (s.move(x=-long / 2, z=-low) for s in lay)
    skin, dark = look.surface(color, "metal"), textures.plain(tint_color(color, 0.35))
    return shape([(body, skin), (mark, dark)], [flat_foot(body.vertices, 0.15)])


def nail(look: Look) -> Shape:
    """A nail lying: a flat head, a long point."""
    k = look.between(0.8, 1.25)
    color = look.color("silver", "gray", "charcoal", "silver", "bronze", "copper")
    long, r = 0.065 * k, 0.0017 * k
    one = lathe(
        [
            (0, 0),
            (2.6 * r, 0),
            (2.6 * r, 0.0012 * k),
            (r, 0.002 * k),
            (r, 0.93 * long),
            (0.1 * r, long),
            (0, long),
        ],
        12,
    )
    body = lying(one).turn(1, np.arctan2(1.6 * r, long))
    body = body.move(x=-long / 2, z=-float(body.bounds[0, 2]))
    return shape([(body, look.surface(color, "metal"))], [flat_foot(body.vertices, 0.15)])


def bolt(look: Look) -> Shape:
    """A hexagon bolt standing on its head, a nut on its thread, or lying."""
    k = look.between(0.8, 1.4)
    color = look.color(*METALS)
    metal = look.surface(color, "metal")
    head = cylinder(0.0095 * k, 0.0065 * k, 6, bevel=0.0006)
    long, r = 0.042 * k, 0.005 * k
    rod = cylinder(r, long, 18, bevel=0.0008).move(z=0.006 * k)
    rings = [torus(r, 0.0007 * k, 16, 4).move(z=0.016 * k + 0.0016 * k * n) for n in range(19)]
    z = look.between(0.018, 0.034) * k
    nut = lathe(
        [(0.9 * r, 0), (0.0093 * k, 0), (0.0093 * k, 0.0075 * k), (0.9 * r, 0.0075 * k)],
        6,
        loop=True,
    )
    pieces = [head, rod, *rings]
    if look.chance(0.6):
        pieces.append(nut.move(z=z))
    if look.chance(0.6):
        return shape(
            [(join(pieces), metal)],
            [
                hull_of(head),
                cylinder_part(r, long + 0.006 * k),
                *([hull_of(pieces[-1])] if len(pieces) > 21 else []),
            ],
        )
    turned = [s.turn(2, np.pi / 6).turn(1, np.pi / 2) for s in pieces]
    low = float(turned[0].bounds[0, 2])
    lean = np.arctan2(-low - r - 0.0006 * k, long)
    turned = [s.turn(1, lean) for s in turned]
    low = min(float(s.bounds[0, 2]) for s in turned)
    turned = [s.move(x=-0.5 * long, z=-low) for s in turned]
    return shape(
        [(join(turned), metal)],
        [flat_foot(turned[0].vertices, 0.12), flat_foot(turned[1].vertices, 0.12)],
    )


def nut(look: Look) -> Shape:
    """A hexagon nut or a washer lying flat."""
    k = look.between(0.8, 1.4)
    color = look.color(*METALS)
    metal = look.surface(color, "metal")
    one = lathe(
        [
            (0.0052, 0),
            (0.0085, 0),
            (0.0095, 0.0008),
            (0.0095, 0.0072),
            (0.0085, 0.008),
            (0.0052, 0.008),
        ],
        6,
        loop=True,
    ).scale(k, k, k)
    ring = lathe([(0.0055, 0), (0.011, 0), (0.011, 0.0015), (0.0055, 0.0015)], 28, loop=True).scale(
        k, k, k
    )
    if look.chance(0.75):
        flat = float(np.cos(np.pi / 6))
        return shape([(one, metal)], ring_parts(
            [(0.0095 * flat * k, 0), (0.0095 * flat * k, 0.008 * k)],
            [(0.0052 * k, 0.008 * k), (0.0052 * k, 0)], 8))  # fmt: skip
    return shape(
        [(ring, metal)],
        ring_parts(
            [(0.011 * k, 0), (0.011 * k, 0.0015 * k)],
            [(0.0055 * k, 0.0015 * k), (0.0055 * k, 0)],
            8,
        ),
    )


def hex_key(look: Look) -> Shape:
    """A hexagon key lying: an L of six-sided steel, or one with a T grip."""
    k = look.between(0.8, 1.3)
    color = look.color("charcoal", "black", "silver", "silver", "gray")
    r = 0.0032 * k
    path = np.concatenate(
        [
            [(-0.06 * k, 0, r)],
            np.column_stack(
                [arc((0.024 * k, 0.006 * k), 0.006 * k, -np.pi / 2, 0, 5), np.full(6, r)]
            ),
            [(0.03 * k, 0.03 * k, r)],
        ]
    )
    rod = tube(path, r, 6)
    rod = rod.move(z=-float(rod.bounds[0, 2]))
    pieces = [(rod, look.surface(color, "metal"))]
    high = float(rod.bounds[1, 2])
    parts = [
        box_part(0.084 * k, 1.7 * r, high, (-0.018 * k, 0, 0)),
        box_part(1.7 * r, 0.03 * k, high, (0.03 * k, 0.015 * k, 0)),
    ]
    if look.chance(0.4):
        grip = block(0.022 * k, 0.075 * k, 3.6 * r, 0.008, 0.002).move(x=0.032 * k, y=0.005 * k)
        tone = look.own_color("red", "blue", "yellow", "orange", "green")
        pieces.append((grip, textures.speckles(look.rng, tone, 4, 32)))
        parts.append(hull_of(grip))
    return shape(pieces, parts)


def padlock(look: Look) -> Shape:
    """A padlock standing: a body with a keyhole or number wheels, a shackle."""
    k = look.between(0.85, 1.25)
    color = look.color("brass", "gold", "silver", "black", "red", "blue", "charcoal")
    metal = look.surface(color, "metal")
    x, y, h = 0.042 * k, 0.018 * k, 0.036 * k
    body = block(x, y, h, 0.005, 0.002)
    a = np.linspace(0, np.pi, 11)
    bow = np.column_stack([0.0125 * k * np.cos(a), 0 * a, h + 0.018 * k + 0.0125 * k * np.sin(a)])
    path = np.concatenate([[(0.0125 * k, 0, h - 0.002)], bow, [(-0.0125 * k, 0, h - 0.002)]])
    shackle = tube(path, 0.0036 * k, 10)
    pieces = [(body, metal), (shackle, textures.brushed_metal(look.rng, (200, 203, 208)))]
    if look.chance(0.65):
        plate = facing(cylinder(0.0075 * k, 0.001, 22)).move(y=-y / 2, z=0.42 * h)
        hole = [facing(cylinder(0.0022 * k, 0.0012, 12)).move(y=-y / 2 - 0.0006, z=0.46 * h),
                box(0.0018 * k, 0.0012, 0.006 * k).move(y=-y / 2 - 0.001, z=0.28 * h)]  # fmt: skip
        pieces += [
            (plate, textures.plain(tint_color(color, 1.25))),
            (join(hole), textures.plain((26, 26, 28))),
        ]
    else:
        for n in range(3):
            wheel = prints.canvas(32, 48, (236, 236, 232))
            prints.write(
                wheel, str(int(look.rng.integers(10))), 0.5, 0.5, 0.55, (30, 30, 34), bold=True
            )
            pieces.append(
                (
                    box(0.008 * k, 0.002, 0.014 * k).move(
                        (n - 1) * 0.011 * k, -y / 2 - 0.0006, 0.3 * h
                    ),
                    wheel,
                )
            )
    return shape(pieces, [box_part(x, y, h), hull_of(shackle)])


CATEGORIES = (
    Category("screw", screw, (0.0452, 0.0113, 0.0113), 0.008, ("wood screw", "metal screw",
             "loose screw",
             "self tapping screw", "self-tapping screw", "thumbscrew", "grub screw",
             "machine screw"), ("workbench",), ("flat",), ("silver", "gold"), state="lying flat"),
    Category("nail", nail, (0.0663, 0.00899, 0.00904), 0.006, ("iron nail",), ("workbench",),
             ("flat",), ("silver",), state="lying flat"),
    Category("bolt", bolt, (0.0376, 0.0206, 0.04), 0.035, ("hex bolt", "machine bolt",
             "threaded bolt", "wheel axle", "axle", "spoke nipple", "carriage bolt",
             "dental implant"), ("workbench",),
             (),
             ("silver",)),
    Category("nut", nut, (0.0197, 0.0213, 0.00567), 0.01, ("hex nut", "metal nut",
             "hexagon nut",
             "square nut", "wing nut"), ("workbench",), ("flat",), ("silver",), state="lying flat"),
    Category("hex_key", hex_key, (0.105, 0.0562, 0.0089), 0.03, ("allen key", "allen wrench",
             "hex wrench", "hex keys", "allen keys", "hexagon key"), ("workbench",), ("flat",),
             ("charcoal",), state="lying flat"),
    Category("padlock", padlock, (0.044, 0.02, 0.07), 0.14, ("lock", "combination lock",
             "pad lock", "d-lock", "bike lock", "key safe"), ("workbench",), (), ("brass",
             "silver")),
)  # fmt: skip
"""The module's categories."""
