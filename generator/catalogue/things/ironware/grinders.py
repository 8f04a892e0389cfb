"""Blades, discs, chucks, lathes, chainsaws."""

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
from ...build.outlines import rectangle
from ...build.recipes import Pieces, rod
from ...build.solids import join, lathe, prism, torus
from ...build.variants import at_rest
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows, wide

BLACK = textures.plain((36, 36, 39))


BODIES = ("teal", "red", "green", "yellow", "blue", "orange")


def _polish(look: Look) -> Pieces:
    """An angle polisher lying on its soft pad."""
    tile = plastic(look, *BODIES)
    pad = standing((0.06, 0), (0.075, 0.012), (0.07, 0.026), (0.03, 0.032))
    head = at_block(0.06, 0.055, 0.06, 0.016, (0, 0, 0.03))
    body = spindle((0.02, 0.028), (0.05, 0.031), (0.17, 0.027), (0.22, 0.024), z=0.062)
    side = rod([(0, -0.02, 0.065), (0, -0.1, 0.075)], [0.012, 0.014], 10)
    return [
        (pad, dye(look, "white", "yellow", "cream")),
        (head, shine(look)),
        (body, tile),
        (side, BLACK),
        (spindle((0.09, 0.0305), (0.2, 0.027), z=0.062), BLACK),
    ]


def _blade(teeth: int, r: float, hole: float, palette: tuple[str, ...], h: float) -> Drawing:
    """A toothed saw blade or a plain disc with a hole, lying."""

    def draw(look: Look) -> Pieces:
        color = look.color(*palette)
        if teeth:
            a = np.arange(3 * teeth) * 2 * np.pi / (3 * teeth)
            radii = np.tile([r, 0.9 * r, 0.93 * r], teeth)
            body = prism(np.column_stack([radii * np.cos(a), radii * np.sin(a)]), 0, h)
        else:
            body = lathe([(hole, 0), (r, 0), (r, h), (hole, h)], 44, loop=True)
        tile = (
            look.surface(color, "metal")
            if teeth
            else textures.spots(look.rng, color, tint_color(color, 0.7), 0.3)
        )
        pieces: Pieces = [(body, tile), (torus(1.6 * hole, 0.0008, 28, 5).move(z=h), shine(look))]
        if teeth:
            pieces.append((disc(hole, 0.0006, (0, 0, h - 0.0002)), BLACK))
            name = disc(0.55 * r, 0.0004, (0, 0, h - 0.0002))
            pieces.insert(1, (name, dye(look, "red", "yellow", "blue", "black")))
            pieces.append((disc(2.2 * hole, 0.0006, (0, 0, h - 0.0001)), shine(look)))
            pieces[-1], pieces[-2] = pieces[-2], pieces[-1]
        return pieces

    return draw


def _jig(look: Look) -> Pieces:
    teeth = np.column_stack(
        [np.linspace(-0.03, 0.04, 29), np.where(np.arange(29) % 2, -0.0048, -0.0034)]
    )
    outline = [
        *teeth,
        (0.046, 0.002),
        (0.046, 0.0035),
        (-0.03, 0.0035),
        (-0.032, 0.0045),
        (-0.046, 0.0045),
        (-0.046, -0.003),
        (-0.032, -0.003),
    ]
    return [
        (
            plate(outline, 0.0013),
            textures.brushed_metal(look.rng, look.color("silver", "gray", "gold")),
        )
    ]


def _chuck(look: Look) -> Pieces:
    steel = shine(look, "silver", "charcoal")
    body = standing(
        (0.02, 0), (0.021, 0.004), (0.021, 0.03), (0.019, 0.034), (0.008, 0.052), sides=28
    )
    ribs = [
        at_box(0.0025, 0.003, 0.022, (0.021 * np.cos(a), 0.021 * np.sin(a), 0.005))
        for a in np.arange(16) * 0.3927
    ]
    return [
        (body, dye(look, "charcoal", "black", "silver")),
        (join(ribs), steel),
        (disc(0.004, 0.001, (0, 0, 0.0515)), BLACK),
    ]


def _lathe(look: Look) -> Pieces:
    """A wood lathe: a bed, a headstock, a tailstock, a turned piece between."""
    tile = plastic(look, "green", "blue", "gray", "red")
    bed = [at_box(0.42, 0.02, 0.03, (0, s * 0.025, 0.02)) for s in (-1, 1)]
    feet = [at_box(0.05, 0.11, 0.022, (x, 0, 0)) for x in (-0.17, 0.17)]
    head = at_block(0.09, 0.09, 0.12, 0.014, (-0.16, 0, 0.048))
    tail = at_block(0.06, 0.06, 0.085, 0.01, (0.15, 0, 0.048))
    wheel = spindle((0.2, 0.022), (0.212, 0.022), z=0.12)
    shaft = spindle((0.1, 0.009), (0.2, 0.009), z=0.12)
    work = spindle(
        (-0.115, 0.022),
        (-0.08, 0.022),
        (-0.07, 0.014),
        (-0.05, 0.026),
        (-0.02, 0.012),
        (0.02, 0.017),
        (0.05, 0.026),
        (0.07, 0.016),
        (0.1, 0.022),
        z=0.12,
    )
    rest = [
        at_box(0.12, 0.008, 0.03, (-0.01, -0.045, 0.09)),
        at_box(0.016, 0.02, 0.05, (-0.01, -0.045, 0.045)),
    ]
    return [
        (bed[0], shine(look)),
        (bed[1], shine(look)),
        (join([feet[0]]), tile),
        (feet[1], tile),
        (head, tile),
        (tail, tile),
        (wheel, BLACK),
        (shaft, shine(look)),
        (work, dye(look, "wooden", "tan")),
        (join(rest), BLACK),
    ]


def _chainsaw(look: Look) -> Pieces:
    """A small chainsaw lying: a body, two handles, a bar with its chain."""
    tile = plastic(look, "orange", "red", "green", "yellow")
    body = at_block(0.17, 0.1, 0.09, 0.02, (-0.06, 0, 0))
    bar = (
        prism(rectangle(0.27, 0.055, 0.027, 8), -0.002, 0.002)
        .turn(0, np.pi / 2)
        .move(0.15, 0.01, 0.045)
    )
    chain = (
        prism(rectangle(0.285, 0.066, 0.032, 8), -0.0032, 0.0032)
        .turn(0, np.pi / 2)
        .move(0.15, 0.01, 0.045)
    )
    front = rod(
        [(0.01, -0.045, 0.05), (0.01, -0.05, 0.12), (0.01, 0.045, 0.125), (0.01, 0.05, 0.05)],
        0.009,
        10,
    )
    rear = rod(
        [(-0.13, 0, 0.07), (-0.2, 0, 0.075), (-0.225, 0, 0.03), (-0.14, 0, 0.012)], 0.012, 10
    )
    guard = at_box(0.006, 0.08, 0.05, (0.035, 0, 0.085))
    return [
        (body, tile),
        (chain, dye(look, "charcoal")),
        (bar.scale(1, 1.9, 1).move(y=-0.009), shine(look)),
        (front, BLACK),
        (rear, tile),
        (guard, BLACK),
    ]


def _jointer(look: Look) -> Pieces:
    tile = plastic(look, *BODIES)
    base = at_block(0.08, 0.12, 0.014, 0.006, (0.08, 0, 0))
    fence = at_box(0.012, 0.12, 0.075, (0.115, 0, 0.0))
    body = spindle((-0.16, 0.028), (-0.14, 0.032), (0.04, 0.032), z=0.036)
    head = at_block(0.09, 0.075, 0.07, 0.01, (0.06, 0, 0.012))
    grip = rod(
        [(0.05, -0.05, 0.06), (0.05, -0.05, 0.115), (0.05, 0.05, 0.115), (0.05, 0.05, 0.06)],
        0.009,
        10,
    )
    return [
        (base, shine(look)),
        (fence, shine(look)),
        (body, tile),
        (head, shine(look, "charcoal", "gray")),
        (grip, BLACK),
    ]


_row = Rows("workbench", ("teal", "red"), "lying", role=wide).of_drawing


CATEGORIES = (
    at_rest(_row("polisher", _polish, (0.3, 0.18, 0.093), 1.8, ("car polisher", "buffing machine",
             "buffer machine", "floor polisher"), bodies=4)),
    _row("circular_saw_blade", _blade(24, 0.085, 0.012, ("silver", "gray"), 0.002), (0.171, 0.171,
             0.00277), 0.25, ("saw blade", "round saw blade", "table saw blade"), ("silver",),
             bodies=1),
    _row("grinding_disc", _blade(0, 0.0575, 0.011, ("charcoal", "brown", "gray"), 0.006), (0.111,
             0.111, 0.00653), 0.15, ("grinding wheel", "cutting disc", "sanding disc",
             "abrasive disc", "angle grinder disc", "cutting wheel", "flap disc",
             "whetstone wheel"), ("charcoal",), bodies=1),
    _row("jigsaw_blade", _jig, (0.092, 0.0093, 0.0013), 0.008, ("hacksaw blade",
             "reciprocating saw blade", "scroll saw blade", "spare blade"), ("silver",)),
    _row("drill_chuck", _chuck, (0.045, 0.045, 0.0525), 0.3, ("keyless chuck",), ("charcoal",),
             bodies=1),
    _row("wood_lathe", _lathe, (0.42, 0.11, 0.17), 8.0, ("lathe", "mini lathe", "metal lathe"),
             ("green",)),
    _row("chainsaw", _chainsaw, (0.527, 0.125, 0.139), 3.5, ("chain saw", "toy chainsaw"),
             ("orange",)),
    _row("biscuit_jointer", _jointer, (0.28, 0.12, 0.125), 2.5, ("plate joiner", "biscuit joiner")),
)  # fmt: skip
"""The module's categories."""
