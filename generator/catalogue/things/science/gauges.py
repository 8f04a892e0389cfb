"""Meters, generators, recorders and rules."""

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
from ...build.outlines import arc, smooth
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows, tall

BLACK = textures.plain((34, 34, 37))


def _volcano(look: Look) -> Pieces:
    color = look.color("brown", "charcoal", "terracotta")
    rock = standing(
        (0.09, 0.008),
        (0.075, 0.025),
        (0.05, 0.07),
        (0.03, 0.115),
        (0.018, 0.115),
        (0.012, 0.1),
        sides=18,
    )
    rock = rock.bend(
        lambda p: (
            p
            * np.column_stack(
                [
                    *(2 * [1 + 0.07 * np.sin(5 * np.arctan2(p[:, 1], p[:, 0]) + 20 * p[:, 2])]),
                    np.ones(len(p)),
                ]
            )
        )
    )
    lava = [
        tube(
            smooth(
                [
                    (0.008 * np.cos(a), 0.008 * np.sin(a), 0.112),
                    (0.033 * np.cos(a), 0.033 * np.sin(a), 0.113),
                    (0.054 * np.cos(a + 0.1), 0.054 * np.sin(a + 0.1), 0.075),
                    (0.08 * np.cos(a), 0.08 * np.sin(a), 0.034),
                ],
                5,
            ),
            0.008,
            8,
        )
        for a in (-2.2, -1.3, 0.3, 1.9)
    ]
    base = at_block(0.21, 0.21, 0.01, 0.02)
    return [
        (base, dye(look, "green", "wooden", "sage")),
        (rock, textures.spots(look.rng, color, tint_color(color, 0.6), 0.2)),
        (join([*lava, ball(0.04, 0.04, 0.014, (0, 0, 0.112), 14)]), textures.plain((240, 92, 30))),
    ]


def _theodolite(look: Look) -> Pieces:
    """A surveyor's instrument: a yoke with a telescope on a round base."""
    tile = plastic(look, "yellow", "green", "orange")
    base = [disc(0.06, 0.012), disc(0.045, 0.03, (0, 0, 0.018))]
    screws = [
        disc(0.011, 0.014, (0.045 * np.cos(a), 0.045 * np.sin(a), 0.01))
        for a in np.arange(3) * 2.0944
    ]
    yoke = [at_block(0.026, 0.06, 0.13, 0.01, (s * 0.05, 0, 0.046)) for s in (-1, 1)]
    bridge = at_block(0.13, 0.07, 0.02, 0.012, (0, 0, 0.045))
    scope = (
        spindle(
            (-0.09, 0.018),
            (-0.05, 0.018),
            (-0.03, 0.024),
            (0.05, 0.024),
            (0.07, 0.03),
            (0.09, 0.03),
            z=0,
        )
        .turn(2, np.pi / 2)
        .move(0, 0, 0.13)
    )
    lens = disc(0.025, 0.001).turn(0, np.pi / 2).move(0, -0.0905, 0.13)
    grip = rod([(-0.05, 0, 0.17), (-0.04, 0, 0.2), (0.04, 0, 0.2), (0.05, 0, 0.17)], 0.008, 8)
    return [
        (base[0], BLACK),
        (base[1], tile),
        (yoke[0], tile),
        (yoke[1], tile),
        (bridge, tile),
        (scope, dye(look, "charcoal", "white")),
        (grip, BLACK),
        (join(screws), BLACK),
        (lens, textures.plain((90, 120, 170))),
    ]


def _curve(look: Look) -> Pieces:
    """A French curve: a clear template with swirls and cut-outs."""
    color = look.color("clear", "green", "orange", "sky")
    outline = smooth(
        [
            (-0.1, -0.02),
            (-0.06, -0.05),
            (0.0, -0.03),
            (0.05, -0.045),
            (0.11, -0.03),
            (0.115, 0.0),
            (0.08, 0.012),
            (0.05, 0.0),
            (0.0, 0.028),
            (-0.04, 0.052),
            (-0.085, 0.04),
            (-0.1, -0.02),
        ],
        6,
    )[:-1]
    body = plate(outline, 0.002)
    holes = [
        disc(r, 0.0004, sides=20).scale(1.5, 1, 1).move(x, y, 0.0018)
        for r, x, y in ((0.016, -0.06, 0.005), (0.009, 0.01, -0.01), (0.009, 0.075, -0.02))
    ]
    return [
        (body, textures.plain(tint_color(color, 1.2))),
        (join(holes), textures.plain(tint_color(color, 0.75))),
    ]


def _tee(look: Look) -> Pieces:
    tile = wood(look, "wooden", "tan", "beige")
    blade = at_box(0.4, 0.04, 0.003, (0.02, 0, 0.004))
    head = at_box(0.03, 0.2, 0.008, (-0.185, 0, 0))
    scale = prints.rule(20, (236, 214, 166), (60, 46, 34))
    foot = at_box(0.03, 0.03, 0.0045, (0.2, 0, 0))
    return [
        (blade, tile),
        (head, tile),
        (foot, tile),
        (at_box(0.39, 0.01, 0.0005, (0.02, 0.014, 0.0068)), scale),
    ]


def _geometry(look: Look) -> Pieces:
    """An open tin of drawing tools: compasses, set square, protractor, ruler, pencil."""
    tile = metal(look, "silver", "blue", "red", "gold")
    floor = at_box(0.2, 0.1, 0.002)
    sides = [at_box(0.2, 0.002, 0.018, (0, s * 0.049, 0)) for s in (-1, 1)] + [
        at_box(0.002, 0.1, 0.018, (s * 0.099, 0, 0)) for s in (-1, 1)
    ]
    lid = at_box(0.2, 0.1, 0.002).turn(0, 1.9).move(0, 0.066, 0.046)
    ruler = at_box(0.17, 0.022, 0.002, (0, 0.034, 0.002))
    square = plate([(-0.09, -0.03), (-0.02, -0.03), (-0.09, 0.015)], 0.002, 0.003)
    half = plate(arc((0.045, -0.008), 0.036, 0, np.pi, 16), 0.002, 0.003)
    legs = [
        straight((0.0, -0.02, 0.008), (0.08, -0.03 + 0.014 * k, 0.006), 0.0026, 8) for k in (0, 1)
    ]
    pencil = spindle((-0.06, 0.0035), (0.06, 0.0035), (0.07, 0.0004), sides=6, z=0.008).move(
        y=-0.04
    )
    return [
        (floor, tile),
        *((s, tile) for s in sides),
        (lid.move(z=-float(lid.bounds[0, 2])), tile),
        (ruler, prints.rule(15, (244, 232, 160), (50, 50, 54))),
        (square, textures.plain((150, 206, 180))),
        (half, textures.plain((240, 170, 150))),
        (join(legs), shine(look)),
        (pencil, textures.plain((240, 190, 50))),
    ]


def _fractions(look: Look) -> Pieces:
    """A disc cut into coloured wedges."""
    n = look.pick([4, 6, 8])
    pieces: Pieces = []
    for k in range(n):
        a, b = 2 * np.pi * k / n, 2 * np.pi * (k + 1) / n
        m = (a + b) / 2
        wedge = np.concatenate([[(0, 0)], arc((0, 0), 0.055, a, b, 8)]) + 0.003 * np.array(
            [np.cos(m), np.sin(m)]
        )
        tile = textures.plain(look.own_color(PAINTS[k % len(PAINTS)]))
        pieces.append((plate(wedge, 0.005), tile))
    return pieces


def _cubes(look: Look) -> Pieces:
    """Six linking cubes in a rod."""
    s = 0.02
    pieces: Pieces = []
    for k in range(6):
        x = (k - 2.5) * s
        tile = textures.plain(look.color(*PAINTS))
        pieces.append((at_block(0.97 * s, s, s, 0.0015, (x, 0, 0)), tile))
        pieces.append((disc(0.005, 0.003, (x, 0, s - 0.0005)), tile))
    return pieces


_row = Rows("office", ("brass",), role=tall).of_drawing


CATEGORIES = (
    _row("volcano_model", _volcano, (0.21, 0.21, 0.12), 0.5, (), ("brown",), bodies=2),
    _row("theodolite", _theodolite, (0.13, 0.18, 0.21), 3.0, ("surveyor level",
             "surveying instrument", "total station", "surveyor transit", "dumpy level"),
             ("yellow",), bodies=7),
    _row("french_curve", _curve, (0.217, 0.103, 0.0022), 0.02, ("curve template",
             "drawing template", "drawing curve"), ("clear",), bodies=1),
    _row("t_square", _tee, (0.42, 0.2, 0.008), 0.15, ("tee square", "drafting square",
             "t-square"), ("wooden",)),
    _row("geometry_set", _geometry, (0.2, 0.13, 0.095), 0.25, ("maths set", "math set",
             "compass set", "drawing set", "geometry tin", "mathematical instruments"),
             ("silver",), bodies=6),
    _row("fraction_circle", _fractions, (0.116, 0.116, 0.005), 0.04, ("fraction tile",
             "fraction disc", "fraction set", "algebra tile", "pie chart model"), ("red",)),
    _row("linking_cubes", _cubes, (0.12, 0.02, 0.0225), 0.03, ("multilink cube",
             "unifix cube", "unifix cubes", "snap cube", "linking cube",
             "multilink cubes"), ("red", "blue")),
)  # fmt: skip
"""The module's categories."""
