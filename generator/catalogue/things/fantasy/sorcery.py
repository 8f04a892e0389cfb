"""Toy weapons, chains, siege engines, ink."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    metal,
    plate,
    shine,
    spindle,
    standing,
    wood,
)
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join, lathe, torus
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows, wide

BLACK = textures.plain((34, 34, 37))


def _cuffs(look: Look) -> Pieces:
    """Two iron cuffs joined by a chain."""
    iron = metal(look, "charcoal", "gray", "silver")
    cuffs = [
        lathe([(0.031, 0), (0.036, 0), (0.036, 0.014), (0.031, 0.014)], 32, loop=True).move(
            x=s * 0.075
        )
        for s in (-1, 1)
    ]
    locks = [at_block(0.018, 0.018, 0.016, 0.004, (s * 0.04, 0, 0)) for s in (-1, 1)]
    links = [
        torus(0.0075, 0.002, 16, 6)
        .scale(1.3, 0.8, 1)
        .turn(0, (k % 2) * 0.9)
        .move(-0.026 + 0.013 * k, 0, 0.0065)
        for k in range(5)
    ]
    return [
        (cuffs[0], iron),
        (cuffs[1], iron),
        (locks[0], iron),
        (locks[1], iron),
        (join(links), iron),
    ]


def _cannon(look: Look) -> Pieces:
    """A cannon on a wheeled carriage."""
    iron = metal(look, "charcoal", "bronze", "black", "brass")
    tile = wood(look, "brown", "wooden", "maroon")
    barrel = (
        spindle(
            (-0.09, 0.008),
            (-0.082, 0.012),
            (-0.075, 0.022),
            (-0.06, 0.026),
            (0.02, 0.021),
            (0.075, 0.018),
            (0.08, 0.023),
            (0.088, 0.022),
            z=0,
        )
        .turn(1, -0.12)
        .move(0, 0, 0.062)
    )
    bore = spindle((0.0865, 0.013), (0.0885, 0.013), z=0).turn(1, -0.12).move(0, 0, 0.062)
    sides = [
        plate([(-0.085, 0.012), (0.045, 0.012), (0.05, 0.05), (0.0, 0.058), (-0.085, 0.028)], 0.012)
        .turn(0, np.pi / 2)
        .move(0, s * 0.026 + 0.006, 0)
        for s in (-1, 1)
    ]
    floor = at_box(0.13, 0.05, 0.01, (-0.02, 0, 0.012))
    wheels = [
        disc(0.022, 0.01).turn(0, np.pi / 2).move(x, s * 0.04 + 0.005, 0.022)
        for x in (-0.06, 0.028)
        for s in (-1, 1)
    ]
    return [
        (barrel, iron),
        (sides[0], tile),
        (sides[1], tile),
        (floor, tile),
        *((w, dye(look, "brown", "black")) for w in wheels),
        (bore, BLACK),
    ]


def _catapult(sling: bool) -> Drawing:
    """A toy siege engine: a frame on wheels, a throwing arm with a weight or a bowl."""

    def draw(look: Look) -> Pieces:
        tile = wood(look, "wooden", "brown", "tan")
        beams = [at_box(0.2, 0.014, 0.016, (0, s * 0.045, 0.016)) for s in (-1, 1)]
        cross = [at_box(0.014, 0.1, 0.016, (x, 0, 0.016)) for x in (-0.09, 0.02, 0.09)]
        wheels = [
            disc(0.022, 0.009).turn(0, np.pi / 2).move(x, s * 0.058 + 0.0045, 0.022)
            for x in (-0.07, 0.07)
            for s in (-1, 1)
        ]
        tall = 0.14 if sling else 0.09
        posts = [
            straight((x, s * 0.045, 0.03), (0.015, s * 0.03, tall), 0.006, 6)
            for s in (-1, 1)
            for x in (-0.04, 0.065)
        ]
        axle = straight((0.015, -0.045, tall), (0.015, 0.045, tall), 0.006, 8)
        if sling:
            arm = straight((0.07, 0, tall - 0.035), (-0.12, 0, tall + 0.065), 0.006, 8)
            load = at_block(0.045, 0.045, 0.045, 0.004, (0.075, 0, tall - 0.085))
        else:
            arm = straight((0.03, 0, 0.03), (-0.08, 0, 0.11), 0.0065, 8)
            load = standing((0.012, 0), (0.024, 0.012), (0.026, 0.018)).move(-0.085, 0, 0.106)
        stone = ball(
            0.022, 0.022, 0.022, (-0.085, 0, 0.126) if not sling else (0.05, 0.0, 0.042), 12
        )
        return [
            (join(beams), tile),
            (join(cross), tile),
            *((w, dye(look, "brown", "wooden")) for w in wheels),
            (posts[0], tile),
            (posts[2], tile),
            (join([posts[1], posts[3], axle]), tile),
            (arm, tile),
            (load, dye(look, "gray", "brown")),
            (stone, dye(look, "gray")),
        ]

    return draw


def _quill(look: Look) -> Pieces:
    """An inkwell with a feather standing in it."""
    glass = dye(look, "navy", "black", "teal")
    pot = standing(
        (0.022, 0), (0.028, 0.006), (0.028, 0.028), (0.014, 0.036), (0.014, 0.044), (0.018, 0.046)
    )
    ink = disc(0.012, 0.001, (0, 0, 0.0456))
    shaft = rod(
        [(0.0, 0.004, 0.03), (0.02, 0.012, 0.09), (0.06, 0.02, 0.17), (0.09, 0.022, 0.2)],
        [0.0018, 0.0018, 0.0012, 0.0006],
        6,
    )
    color = look.color("white", "cream", "brown", "gray", "red")
    vane = rod(
        [(0.02, 0.012, 0.09), (0.045, 0.017, 0.14), (0.07, 0.021, 0.18), (0.1, 0.023, 0.205)],
        [0.003, 0.02, 0.018, 0.001],
        10,
    ).bend(lambda p: np.column_stack([p[:, 0], 0.016 + 0.12 * (p[:, 1] - 0.016), p[:, 2]]))
    return [
        (pot, glass),
        (vane, textures.stripes([color, tint_color(color, 0.88)], 16)),
        (shaft, dye(look, "cream")),
        (ink, BLACK),
    ]


def _hilt(look: Look) -> Pieces:
    steel = metal(look, "silver", "gray", "black")
    z = 0.021
    body = spindle(
        (-0.13, 0.016),
        (-0.125, 0.02),
        (-0.06, 0.02),
        (-0.055, 0.016),
        (0.0, 0.017),
        (0.05, 0.016),
        (0.06, 0.021),
        (0.12, 0.021),
        (0.125, 0.018),
        z=z,
    )
    ribs = [
        spindle((-0.12 + 0.013 * k, 0.0215), (-0.113 + 0.013 * k, 0.0215), z=z) for k in range(5)
    ]
    switch = at_block(0.03, 0.012, 0.006, 0.002, (0.02, 0, 0.037))
    button = disc(0.004, 0.004, (0.02, 0, 0.042))
    return [
        (body, steel),
        (join(ribs), BLACK),
        (switch, shine(look, "gold", "silver")),
        (button, dye(look, "red")),
        (spindle((0.1245, 0.013), (0.126, 0.013), z=z), dye(look, "cyan", "green", "red")),
    ]


_row = Rows("toys", ("brown",), role=wide).of_drawing


CATEGORIES = (
    _row("manacles", _cuffs, (0.222, 0.072, 0.016), 0.4, ("handcuff",
             "shackles", "cuffs"), ("charcoal",)),
    _row("toy_cannon", _cannon, (0.189, 0.0943, 0.0989), 0.4, ("cannon", "mini cannon",
             "model cannon",
             "ship cannon"), ("charcoal",)),
    _row("toy_trebuchet", _catapult(True), (0.22, 0.13, 0.21), 0.25, ("trebuchet",
             "model trebuchet", "siege engine"), ("wooden",)),
    _row("toy_catapult", _catapult(False), (0.213, 0.126, 0.138), 0.2, ("catapult model",
             "model catapult", "wooden catapult", "mangonel"), ("wooden",)),
    _row("quill_and_ink", _quill, (0.135, 0.06, 0.21), 0.12, (
             "quill in an inkwell", "inkwell with a quill", "quill pen",
             "ink bottle with a quill"), ("white",), bodies=1),
    _row("lightsaber", _hilt, (0.256, 0.043, 0.046), 0.3, ("lightsaber hilt", "light saber",
             "laser sword", "lightsabre"), ("silver",), 0.08, 1),
)  # fmt: skip
"""The module's categories."""
