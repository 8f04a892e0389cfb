"""Card files, cutters, sleeves, nibs, things for the desk."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    PAINTS,
    at_block,
    at_box,
    disc,
    dye,
    metal,
    plastic,
    plate,
    shine,
    spindle,
    standing,
    wood,
)
from ...build.recipes import Pieces, rod
from ...build.solids import join
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


WHITE = textures.plain((244, 243, 240))


def _rolo(look: Look) -> Pieces:
    """A rotary card file: a drum of cards between two stands with knobs."""
    tile = plastic(look, "black", "charcoal", "gray")
    stands = [at_block(0.012, 0.1, 0.08, 0.003, (s * 0.066, 0, 0)) for s in (-1, 1)]
    floor = at_box(0.13, 0.1, 0.008)
    leaves = [
        at_box(0.105, 0.0016, 0.05, (0, 0, 0.022)).turn(0, a).move(0, 0, 0.08)
        for a in np.linspace(-1.9, 1.9, 26)
    ]
    tabs = [
        at_box(0.016, 0.002, 0.008, (-0.04 + 0.016 * (k % 6), 0, 0.071)).turn(0, a).move(0, 0, 0.08)
        for k, a in enumerate(np.linspace(-1.7, 1.7, 12))
    ]
    core = spindle((-0.06, 0.024), (0.06, 0.024), z=0.08)
    knobs = [
        spindle((s * 0.072, 0.018), (s * 0.088, 0.018), z=0.08)
        if s > 0
        else spindle((-0.088, 0.018), (-0.072, 0.018), z=0.08)
        for s in (-1, 1)
    ]
    return [
        (floor, tile),
        (stands[0], tile),
        (stands[1], tile),
        (core, dye(look, "gray")),
        (join(knobs), tile),
        (join(leaves[::2]), WHITE),
        (join(leaves[1::2]), dye(look, "cream", "ivory")),
        (join(tabs), dye(look, "blue", "green", "orange")),
    ]


def _guillotine(look: Look) -> Pieces:
    """A paper cutter: a ruled board with a long arm blade."""
    board = at_block(0.32, 0.26, 0.018, 0.008)
    image = textures.grid((140, 160, 170), (206, 216, 214), 14, 18)
    tile = plastic(look, "black", "gray", "blue", "green")
    rail = at_box(0.012, 0.26, 0.008, (0.15, 0, 0.018))
    arm = at_block(0.02, 0.29, 0.012, 0.004, (0, -0.14, 0)).turn(0, -0.28).move(0.165, 0.12, 0.022)
    blade = at_box(0.003, 0.26, 0.022, (0, -0.13, -0.012)).turn(0, -0.28).move(0.158, 0.12, 0.024)
    grip = rod([(0.165, -0.145, 0.105), (0.165, -0.19, 0.118)], [0.01, 0.012], 10)
    stop = at_box(0.3, 0.012, 0.008, (-0.01, 0.122, 0.018))
    return [
        (board, tile),
        (arm, tile),
        (grip, BLACK),
        (stop, shine(look)),
        (rail, shine(look)),
        (blade, shine(look)),
        (at_box(0.29, 0.23, 0.0006, (-0.01, -0.005, 0.0178)), image),
    ]


def _file(look: Look) -> Pieces:
    """A magazine file: a slanting open box with magazines in it."""
    tile = plastic(look, "gray", "white", "blue", "red", "black", "beige")
    side = [(-0.12, 0.0), (0.12, 0.0), (0.12, 0.3), (0.06, 0.3), (-0.12, 0.13)]
    walls = [plate(side, 0.003).turn(0, np.pi / 2).move(0, s * 0.045 + 0.0015, 0) for s in (-1, 1)]
    ends = [
        at_box(0.003, 0.09, 0.3, (0.1185, 0, 0)),
        at_box(0.003, 0.09, 0.13, (-0.1185, 0, 0)),
        at_box(0.24, 0.09, 0.003),
    ]
    books = [
        (
            at_box(0.2, 0.011, 0.26 + 0.004 * (k % 3), (0.012, -0.03 + 0.015 * k, 0.003)),
            dye(look, *PAINTS, "white"),
        )
        for k in range(5)
    ]
    return [
        (walls[0], tile),
        (walls[1], tile),
        (ends[0], tile),
        (ends[1], tile),
        (ends[2], tile),
        *books,
    ]


def _spike(look: Look) -> Pieces:
    base = disc(0.045, 0.012)
    pin = standing((0.0018, 0.01), (0.0016, 0.12), (0.0003, 0.135), sides=8)
    notes = [
        at_box(0.07, 0.1, 0.0012).turn(2, a).move(0.004 * np.cos(3 * a), 0, 0.014 + 0.006 * k)
        for k, a in enumerate((0.1, 0.5, -0.2, 0.3))
    ]
    return [
        (base, metal(look, "black", "brass", "silver")),
        (pin, shine(look)),
        (join(notes), WHITE),
    ]


def _sleeve(look: Look) -> Pieces:
    """A clear sleeve with holes along its edge and a page in it."""
    color = look.color("clear", "clear", "sky")
    page = prints.sheet(look.rng, picture=look.chance(0.5))
    base = at_box(0.225, 0.305, 0.0012)
    holes = [disc(0.003, 0.0004, (-0.107, y, 0.001), sides=12) for y in np.linspace(-0.12, 0.12, 8)]
    return [
        (base, textures.plain(tint_color(color, 1.1))),
        (at_box(0.2, 0.29, 0.0005, (0.008, 0, 0.001)), page),
        (join(holes), textures.plain((120, 130, 140))),
    ]


def _nib(look: Look) -> Pieces:
    steel = metal(look, "gold", "silver", "bronze")
    body = plate(
        [
            (-0.016, -0.0035),
            (0.0, -0.0042),
            (0.018, -0.0002),
            (0.018, 0.0002),
            (0.0, 0.0042),
            (-0.016, 0.0035),
        ],
        0.0016,
    )
    slit = [
        at_box(0.015, 0.0004, 0.0004, (0.009, 0, 0.0015)),
        disc(0.001, 0.0004, (0.001, 0, 0.0015), sides=10),
    ]
    return [(body, steel), (join(slit), BLACK)]


def _blotter(look: Look) -> Pieces:
    """A rocker blotter: a curved wooden base with a knob."""
    a = np.linspace(-0.75, 0.75, 16)
    outline = np.column_stack([0.1 * np.sin(a), 0.1 - 0.1 * np.cos(a)])
    body = plate([*outline, (0.07, 0.036), (-0.07, 0.036)], 0.06).turn(0, np.pi / 2).move(y=0.03)
    knob = standing((0.008, 0.034), (0.008, 0.046), (0.017, 0.056), (0.014, 0.068), sides=18)
    foot = at_box(0.06, 0.058, 0.004)
    return [
        (body, wood(look, "brown", "wooden", "maroon")),
        (foot, dye(look, "cream", "green")),
        (knob, wood(look, "brown", "black")),
    ]


def _grip(look: Look) -> Pieces:
    return [
        (
            spindle(
                (-0.02, 0.0058),
                (-0.016, 0.0075),
                (0.0, 0.0062),
                (0.016, 0.0075),
                (0.02, 0.0058),
                sides=12,
                z=0.0073,
            ),
            plastic(look, *PAINTS),
        ),
        (spindle((0.0199, 0.0036), (0.0205, 0.0036), z=0.0073), BLACK),
    ]


_row = Rows("office", ("black",)).of_drawing


CATEGORIES = (
    _row("rolodex", _rolo, (0.176, 0.155, 0.155), 0.7, ("rotary card file", "card file",
             "card index", "address file"), bodies=(0, 1, 2, 3, 5)),
    _row("guillotine", _guillotine, (0.335, 0.34, 0.13), 1.8, ("paper guillotine", "paper cutter",
             "paper trimmer", "trimmer board"), bodies=4, roles=("big",)),
    _row("magazine_file", _file, (0.24, 0.093, 0.3), 0.8, (
             "file holder", "document holder", "file box", "journal holder"), ("gray",),
             roles=("big", "tall")),
    _row("docket_spike", _spike, (0.111, 0.123, 0.137), 0.2, (), bodies=2),
    _row("plastic_sleeve", _sleeve, (0.225, 0.305, 0.0015), 0.01, ("sheet protector",
             "plastic wallet", "punched pocket", "document sleeve", "page protector",
             "clear sleeve", "plastic folder"), ("clear",), roles=("flat",)),
    _row("pen_nib", _nib, (0.034, 0.0084, 0.0019), 0.001, ("nib", "fountain pen nib",
             "calligraphy nib", "dip pen nib"), ("gold",), roles=("flat",)),
    _row("blotter", _blotter, (0.14, 0.06, 0.068), 0.25, ("ink blotter", "rocker blotter",
             "desk blotter"), ("brown",), 0.06),
    _row("pencil_grip", _grip, (0.041, 0.0148, 0.0146), 0.003, ("pen grip",
             "writing grip"), ("red", "blue"), 0.1, 1),
)  # fmt: skip
"""The module's categories."""
