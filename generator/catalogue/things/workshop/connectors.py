"""What brings power to a circuit: cells and their holders, clips, plugs."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import at_box, drum, lies, plate, standing, steel
from ...build.recipes import put_down, rod
from ...build.shape import Shape
from ...build.solids import join, torus
from ...surfaces import prints
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def coin_cell(look: Look) -> Shape:
    """A button cell lying, its plus side up."""
    color = look.color("silver", "gray", "gold")
    r = look.between(0.0055, 0.0115)
    h = look.between(0.2, 0.42) * r
    body = drum(r, h, sides=28, bevel=0.12 * h)
    face = drum(0.86 * r, 0.0004, (0, 0, h - 0.00015), sides=28)
    image = prints.canvas(96, 96, color)
    ink = tint_color(color, 0.6)
    prints.write(
        image, look.pick(["CR2032", "LR44", "CR2025", "SR626"]), 0.5, 0.62, 0.16, ink, bold=True
    )
    prints.write(image, "+", 0.5, 0.32, 0.3, ink, bold=True)
    return put_down([(body, steel(look, color)), (face, image)], body)


def crocodile_clip(look: Look) -> Shape:
    """A crocodile clip lying, its sleeve coloured, its jaws toothed, a lead behind."""
    color = look.color("red", "black", "green", "yellow", "blue", "white")
    k = look.between(0.9, 1.5)
    teeth = [(0.016 - 0.002 * n, 0.0002 + 0.0009 * (n % 2)) for n in range(7)]
    rim = np.array([(0, 0), (0.004, 0.0028), (0.018, 0.0022), (0.021, 0), (0.018, 0.0005), *teeth])
    upper, lower = (plate(rim * [1, s] + [0, s * 0.0003], 0.0045) for s in (1, -1))
    sleeve = rod(
        [(-0.026, 0, 0.0042), (-0.012, 0, 0.0045), (0.004, 0, 0.0045)], [0.0032, 0.0046, 0.0048], 10
    )
    tail = rod([(-0.025, 0, 0.0038), (-0.036, 0.003, 0.0016), (-0.048, 0, 0.0013)], 0.0013, 8)
    return put_down(
        [
            (join([upper.move(z=0.002), lower.move(z=0.002)]), steel(look)),
            (join([sleeve, tail]), plain(color)),
        ],
        sleeve,
        join([upper.move(z=0.002), lower.move(z=0.002)]),
        tail,
        factor=k,
        foot=0.3,
    )


def banana_plug(look: Look) -> Shape:
    """A banana plug lying: a coloured grip and a sprung tip."""
    color = look.color("red", "black", "yellow", "green", "blue")
    k = look.between(0.9, 1.4)
    grip = drum(0.0048, 0.026, (-0.026, 0, 0.0055), 0, sides=16, bevel=0.001)
    ribs = [
        torus(0.0048, 0.0006, 16, 5).turn(1, np.pi / 2).move(-0.022 + 0.004 * n, 0, 0.0055)
        for n in range(4)
    ]
    collar = drum(0.0056, 0.004, (-0.002, 0, 0.0055), 0, sides=16)
    tip = lies(
        standing(
            (0.002, 0), (0.0024, 0.004), (0.003, 0.01), (0.0022, 0.017), (0.001, 0.019), sides=14
        ),
        0.0,
        0,
        0.0055,
    )
    return put_down(
        [(join([grip, *ribs, collar]), plain(color)), (tip, steel(look))],
        grip,
        collar,
        tip,
        factor=k,
        foot=0.3,
    )


def battery_holder(look: Look) -> Shape:
    """A plastic tray for round cells, with springs and two wires."""
    color = look.color("black", "charcoal", "white")
    k = look.between(0.9, 1.1)
    base = at_box(0.062, 0.034, 0.002)
    walls = [at_box(0.062, 0.002, 0.013, (0, s * 0.016, 0)) for s in (-1, 1)] + [
        at_box(0.002, 0.034, 0.014, (s * 0.03, 0, 0)) for s in (-1, 1)
    ]
    rib = at_box(0.058, 0.0015, 0.006, (0, 0, 0.0015))
    coils = [
        drum(0.004, 0.006, (-0.029, 0.008, 0.0075), 0, top=0.002, sides=12),
        drum(0.004, 0.006, (0.023, -0.008, 0.0075), 0, sides=12),
    ]
    wires = [
        rod([(0.03, y, 0.006), (0.045, y + 0.002, 0.003), (0.065, y - 0.006, 0.0013)], 0.0012, 6)
        for y in (-0.008, 0.008)
    ]
    return put_down(
        [
            (join([base, *walls, rib]), plain(color)),
            (join(coils), steel(look)),
            (wires[0], plain((206, 40, 40))),
            (wires[1], plain((30, 30, 34))),
        ],
        base,
        *walls,
        *wires,
        factor=k,
    )


CATEGORIES = (
    Category("coin_cell", coin_cell, (0.0161, 0.0161, 0.0029), 0.003, ("button cell",
             "button battery", "coin battery", "watch battery"), ("electronics",), ("flat",),
             ("silver",)),
    Category("crocodile_clip", crocodile_clip, (0.0754, 0.0104, 0.00986), 0.006,
             ("alligator clip", "croc clip", "crocodile lead", "test clip", "oscilloscope probe"),
             ("electronics",), (), ("red", "black")),
    Category("banana_plug", banana_plug, (0.051, 0.0127, 0.0126), 0.008, ("banana connector",
             "4 mm plug"), ("electronics",), (), ("red", "black")),
    Category("battery_holder", battery_holder, (0.0979, 0.0345, 0.0142), 0.015, ("battery tray",
             "battery case", "battery slot", "cell holder"), ("electronics",), (),
             ("black",)),
)  # fmt: skip
"""The module's categories."""
