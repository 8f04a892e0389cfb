"""Small machines for wood and metal, their blades and discs."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    plastic,
    plate,
    shine,
    spindle,
    standing,
)
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join
from ...build.variants import at_rest
from ...surfaces import textures
from ...surfaces.look import Look
from ..rows import Rows, wide

BLACK = textures.plain((36, 36, 39))


BODIES = ("teal", "red", "green", "yellow", "blue", "orange")


def _gun(kind: str) -> Drawing:
    """A tool with a pistol grip lying on its side: a heat gun, nailer, spray gun, driver."""

    def draw(look: Look) -> Pieces:
        tile = plastic(look, *BODIES) if kind != "spray" else shine(look)
        z = 0.03
        grip = plate(
            [(-0.055, -0.125), (-0.01, -0.13), (0.012, -0.015), (-0.045, -0.01)], 0.036, z - 0.018
        )
        trigger = at_block(0.012, 0.03, 0.018, 0.004, (0.018, -0.032, z - 0.009))
        pieces: Pieces = [
            (grip, BLACK if kind != "spray" else tile),
            (trigger, dye(look, "black", "red")),
        ]
        if kind == "heat":
            pieces += [
                (spindle((-0.1, 0.026), (-0.09, 0.031), (0.05, 0.03), (0.07, 0.02), z=z), tile),
                (spindle((0.07, 0.018), (0.12, 0.014), (0.122, 0.017), z=z), shine(look)),
                (spindle((0.1215, 0.013), (0.1225, 0.013), z=z), BLACK),
                (
                    rod(
                        [
                            (-0.03, -0.12, z),
                            (-0.03, -0.16, 0.02),
                            (-0.07, -0.18, 0.004),
                            (-0.13, -0.16, 0.004),
                        ],
                        0.004,
                        8,
                    ),
                    BLACK,
                ),
            ]
        elif kind == "nail":
            pieces += [
                (spindle((-0.06, 0.024), (-0.05, 0.031), (0.07, 0.029), z=z), tile),
                (
                    at_block(0.03, 0.13, 0.03, 0.006, (0.085, -0.05, z - 0.015)),
                    shine(look, "gray", "charcoal"),
                ),
                (
                    plate(
                        [(0.08, -0.11), (0.1, -0.115), (-0.01, -0.165), (-0.03, -0.15)],
                        0.022,
                        z - 0.011,
                    ),
                    BLACK,
                ),
                (
                    at_block(0.07, 0.035, 0.05, 0.008, (-0.03, -0.145, z - 0.025)),
                    dye(look, "charcoal"),
                ),
            ]
        elif kind == "spray":
            cup = (
                standing((0.03, 0), (0.034, 0.008), (0.034, 0.06), (0.018, 0.075))
                .turn(0, np.pi)
                .turn(0, -np.pi / 2)
                .move(0.03, 0.02, z)
            )
            pieces += [
                (
                    spindle(
                        (-0.06, 0.009),
                        (-0.05, 0.014),
                        (0.05, 0.014),
                        (0.06, 0.019),
                        (0.075, 0.017),
                        (0.08, 0.01),
                        z=z,
                    ),
                    tile,
                ),
                (cup, dye(look, "gray", "red", "blue", "black")),
                (spindle((-0.078, 0.006), (-0.058, 0.008), z=z), shine(look, "brass")),
                (
                    straight((-0.033, -0.125, z), (-0.035, -0.155, z), 0.008, 10),
                    shine(look, "brass"),
                ),
            ]
        else:
            pieces += [
                (
                    spindle((-0.075, 0.024), (-0.065, 0.032), (0.03, 0.032), (0.04, 0.022), z=z),
                    tile,
                ),
                (spindle((0.04, 0.016), (0.075, 0.007), z=z), BLACK),
                (
                    spindle((0.075, 0.0035), (0.13, 0.0028), (0.135, 0.001), z=z),
                    shine(look, "copper", "silver"),
                ),
            ]
        return pieces

    return draw


def _multi(look: Look) -> Pieces:
    """An oscillating tool lying: a long body, a flat blade at an angle below its head."""
    tile = plastic(look, *BODIES)
    z = 0.034
    body = spindle((-0.14, 0.026), (-0.12, 0.031), (0.03, 0.029), (0.07, 0.026), z=z)
    head = at_block(0.05, 0.05, 0.05, 0.014, (0.09, 0, 0.012))
    blade = plate([(0.09, -0.012), (0.15, -0.016), (0.15, 0.016), (0.09, 0.012)], 0.0018, 0.006)
    nut = disc(0.013, 0.012)
    nut = nut.move(0.09, 0, 0.003)
    band = spindle((-0.07, 0.0315), (0.0, 0.0305), z=z)
    return [
        (body, tile),
        (head, dye(look, "charcoal", "black")),
        (blade, shine(look)),
        (nut, BLACK),
        (band, BLACK),
    ]


def _press(look: Look) -> Pieces:
    """A bench drill: a base, a column, a head with a chuck and a three-armed lever."""
    tile = plastic(look, "red", "blue", "green", "gray", "teal")
    base = at_block(0.16, 0.22, 0.016, 0.01)
    column = straight((0, 0.06, 0.014), (0, 0.06, 0.34), 0.014, 14)
    table = at_block(0.12, 0.12, 0.012, 0.008, (0, -0.02, 0.1))
    arm = at_box(0.04, 0.06, 0.016, (0, 0.05, 0.098))
    head = at_block(0.09, 0.19, 0.085, 0.02, (0, 0.0, 0.25))
    lid = at_block(0.085, 0.185, 0.02, 0.02, (0, 0.0, 0.335))
    chuck = standing((0.008, 0.18), (0.015, 0.195), (0.015, 0.225), (0.01, 0.25), sides=16).move(
        y=-0.035
    )
    bit = straight((0, -0.035, 0.135), (0, -0.035, 0.185), 0.003, 8)
    bars = [
        straight(
            (0.048, 0.02, 0.275),
            (0.06, 0.02 + 0.07 * np.cos(a), 0.275 + 0.07 * np.sin(a)),
            0.004,
            8,
        )
        for a in (0.5, 2.6, 4.7)
    ]
    ends = [
        ball(0.018, 0.018, 0.018, (0.06, 0.02 + 0.07 * np.cos(a), 0.275 + 0.07 * np.sin(a)), 10)
        for a in (0.5, 2.6, 4.7)
    ]
    return [
        (base, dye(look, "gray", "charcoal")),
        (column, shine(look)),
        (join([table, arm]), dye(look, "gray", "charcoal")),
        (head, tile),
        (lid, BLACK),
        (chuck, shine(look)),
        (bit, shine(look)),
        (join(bars), shine(look)),
        (join(ends), BLACK),
    ]


def _compressor(look: Look) -> Pieces:
    tile = plastic(look, "red", "blue", "black", "orange")
    tank = spindle((-0.15, 0.04), (-0.135, 0.065), (0.135, 0.065), (0.15, 0.04), z=0.09)
    feet = [at_box(0.03, 0.1, 0.03, (x, 0, 0)) for x in (-0.09, 0.09)]
    motor = spindle((-0.02, 0.038), (0.1, 0.038), z=0.195)
    pump = at_block(0.06, 0.07, 0.07, 0.008, (-0.07, 0, 0.15))
    fins = [at_box(0.066, 0.076, 0.003, (-0.07, 0, 0.165 + 0.012 * k)) for k in range(5)]
    dial = disc(0.018, 0.01).turn(0, np.pi / 2).move(0.02, -0.06, 0.15)
    face = disc(0.0155, 0.001).turn(0, np.pi / 2).move(0.02, -0.0698, 0.15)
    grip = rod(
        [
            (-0.14, 0, 0.12),
            (-0.17, 0, 0.24),
            (-0.1, 0, 0.265),
            (0.1, 0, 0.265),
            (0.16, 0, 0.22),
            (0.14, 0, 0.12),
        ],
        0.007,
        8,
    )
    return [
        (tank, tile),
        (feet[0], BLACK),
        (feet[1], BLACK),
        (motor, dye(look, "charcoal", "gray")),
        (pump, shine(look)),
        (grip, BLACK),
        (join(fins), shine(look)),
        (dial, shine(look, "brass")),
        (face, textures.plain((244, 242, 236))),
    ]


_row = Rows("workbench", ("teal", "red"), "lying", role=wide).of_drawing


CATEGORIES = (
    at_rest(_row("heat_gun", _gun("heat"), (0.26, 0.22, 0.062), 0.7, ("paint stripper gun",),
             bodies=4)),
    _row("nail_gun", _gun("nail"), (0.16, 0.19, 0.062), 1.8, ("brad nailer", "nailer",
             "finish nailer", "pneumatic nailer")),
    at_rest(_row("spray_gun", _gun("spray"), (0.155, 0.173, 0.0629), 0.6, ("paint sprayer",
             "paint spray gun", "airbrush gun"), ("silver",))),
    at_rest(_row("soldering_gun", _gun("solder"), (0.21, 0.16, 0.064), 0.7, ("solder gun",))),
    _row("oscillating_tool", _multi, (0.29, 0.063, 0.066), 1.2, ("multi tool saw",
             "oscillating multi tool", "oscillating saw"), bodies=4),
    _row("drill_press", _press, (0.16, 0.22, 0.355), 8.0, ("pillar drill", "bench drill",
             "bench drill press", "milling machine"), bodies=7),
    _row("air_compressor", _compressor, (0.365, 0.144, 0.293), 6.0, ("compressor", "vacuum pump"),
             ("red",), bodies=6),
)  # fmt: skip
"""The module's categories."""
