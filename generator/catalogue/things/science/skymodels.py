"""Recorders, rules and wheels for measuring."""

from __future__ import annotations

from itertools import product

import numpy as np

from ...build.making import (
    PAINTS,
    at_block,
    at_box,
    disc,
    dye,
    plastic,
    shine,
    spindle,
    standing,
    wood,
)
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join, torus, tube
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.look import Look
from ..rows import Rows, tall

BLACK = textures.plain((34, 34, 37))


def _soma(look: Look) -> Pieces:
    """A cube puzzle of bent pieces."""
    s = 0.02
    tones = [look.own_color(*PAINTS) for _ in range(7)]
    pieces: Pieces = []
    for i, j, k in product(range(3), repeat=3):
        cube = at_box(0.96 * s, 0.96 * s, 0.98 * s, ((i - 1) * s, (j - 1) * s, k * s))
        pieces.append((cube, textures.plain(tones[(i + 2 * j * (k + 1) + (i * j)) % 7])))
    return pieces


def _galton(look: Look) -> Pieces:
    """A Galton board: a funnel, rows of pins, bins with a bell curve of beads."""
    image = prints.canvas(96, 144, (238, 232, 214))
    for row in range(9):
        for k in range(9 + row % 2):
            prints.disc(
                image, 0.1 + 0.1 * k - 0.05 * (row % 2), 0.24 + 0.045 * row, 0.009, (60, 60, 66)
            )
    tall = (0.03, 0.08, 0.16, 0.25, 0.29, 0.25, 0.16, 0.08, 0.03)
    bead = look.own_color("blue", "red", "teal")
    for k, h in enumerate(tall):
        prints.fill(image, 0.06 + 0.1 * k, 0.97 - h, 0.085, h, bead)
    prints.polygon(image, [(0.2, 0.05), (0.8, 0.05), (0.53, 0.18), (0.47, 0.18)], bead)
    tile = wood(look, "wooden", "brown", "black")
    body = at_box(0.16, 0.03, 0.24, (0, 0, 0.012))
    foot = at_box(0.18, 0.09, 0.012)
    return [(foot, tile), (body, tile), (at_box(0.145, 0.002, 0.225, (0, -0.0155, 0.019)), image)]


def _newton(look: Look) -> Pieces:
    """A spring balance lying: a clear tube with a scale, a ring and a hook."""
    z = 0.013
    scale = textures.grid((60, 60, 66), (232, 238, 240), 0, 20)
    body = spindle((-0.09, 0.0125), (0.07, 0.0125), z=z)
    caps = [spindle((x, 0.0134), (x + 0.014, 0.0134), z=z + 0.0004) for x in (-0.095, 0.065)]
    ring = torus(0.012, 0.002, 22, 6).move(-0.108, 0, 0.0022)
    hook = tube(
        [
            (*p, 0.006)
            for p in smooth(
                [(0.078, 0), (0.1, 0), (0.112, 0.009), (0.104, 0.018), (0.094, 0.013)], 5
            )
        ],
        0.0018,
        6,
    )
    return [
        (body, scale),
        (caps[0], plastic(look, *PAINTS)),
        (caps[1], plastic(look, *PAINTS)),
        (ring, shine(look)),
        (hook, shine(look)),
    ]


def _graaff(look: Look) -> Pieces:
    dome = ball(0.16, 0.16, 0.14, (0, 0, 0.31), 28)
    column = standing((0.026, 0.06), (0.026, 0.25))
    base = at_block(0.14, 0.12, 0.06, 0.012)
    knob = disc(0.012, 0.012).turn(0, np.pi / 2).move(0.04, -0.058, 0.03)
    belt = at_box(0.03, 0.054, 0.19, (0, 0, 0.06))
    return [
        (base, plastic(look, "navy", "black", "red", "gray")),
        (column, textures.plain((206, 222, 226))),
        (dome, shine(look)),
        (belt, dye(look, "charcoal", "orange")),
        (knob, BLACK),
    ]


def _radiometer(look: Look) -> Pieces:
    """A light mill: a glass bulb on a foot with four vanes inside, seen as a cage."""
    foot = standing((0.035, 0), (0.034, 0.006), (0.012, 0.014), (0.01, 0.035), (0.016, 0.045))
    glass = textures.plain((206, 224, 232))
    hoops = [
        torus(0.04, 0.0012, 32, 5).turn(0, np.pi / 2).turn(2, a).move(z=0.085)
        for a in np.arange(5) * 0.6283
    ]
    belt = torus(0.04, 0.0012, 32, 5).move(z=0.085)
    needle = straight((0, 0, 0.045), (0, 0, 0.09), 0.001, 6)
    vanes = [
        at_box(0.018, 0.0012, 0.018, (0.018, 0, 0.078)).turn(2, a + 0.3)
        for a in np.arange(4) * np.pi / 2
    ]
    tip = standing((0.008, 0.124), (0.003, 0.135), sides=12)
    return [
        (foot, glass),
        (join([*hoops, belt]), glass),
        (join([needle]), shine(look)),
        (join(vanes), textures.stripes([(30, 30, 32), (240, 240, 238)], 1)),
        (tip, glass),
    ]


def _quake(look: Look) -> Pieces:
    """A seismograph: a paper drum, a pen on a weighted arm, a base."""
    image = prints.canvas(160, 64, (246, 244, 232))
    x = np.linspace(0, 1, 120)
    wave = (
        0.5 + 0.36 * np.sin(260 * x) * np.exp(-(((x - 0.55) / 0.12) ** 2)) + 0.02 * np.sin(90 * x)
    )
    prints.stroke(image, list(zip(x, wave, strict=True)), 0.02, (170, 30, 34))
    base = at_block(0.22, 0.13, 0.022, 0.008)
    drum = spindle((-0.055, 0.035), (0.055, 0.035), sides=28, z=0.065).move(x=-0.03)
    ends = [spindle((x, 0.038), (x + 0.004, 0.038), z=0.065) for x in (-0.089, 0.025)]
    posts = [at_box(0.012, 0.03, 0.065, (x, 0, 0.02)) for x in (-0.1, 0.04)]
    tower = at_box(0.02, 0.02, 0.15, (0.09, 0.03, 0.02))
    arm = straight((0.09, 0.03, 0.12), (-0.02, -0.01, 0.101), 0.0026, 8)
    weight = spindle((0.03, 0.016), (0.06, 0.016), z=0.11).move(y=0.015)
    return [
        (base, wood(look, "brown", "wooden", "black")),
        (drum, image),
        (join(posts), shine(look, "brass")),
        (tower, shine(look, "brass")),
        (weight, shine(look, "brass")),
        (join(ends), shine(look, "brass")),
        (arm, shine(look)),
    ]


def _panto(look: Look) -> Pieces:
    tile = wood(look, "wooden", "tan", "beige")
    a, b, c, d, e = (-0.14, -0.06), (0.0, 0.09), (0.12, -0.06), (-0.07, 0.015), (0.06, 0.015)
    bars = [
        straight((*p, 0.006), (*q, 0.006), 0.006, 4)
        for p, q in ((a, b), (b, c), (d, (-0.01, -0.06)), (e, (-0.01, -0.06)))
    ]
    pins = [disc(0.006, 0.018, (*p, 0), sides=12) for p in (a, b, c, d, e, (-0.01, -0.06))]
    return [*((s, tile) for s in bars), (join(pins), shine(look, "brass", "silver"))]


def _rule(look: Look) -> Pieces:
    """A slide rule: a body with scales, a slide drawn out a little, a cursor."""
    scale = prints.rule(25, (246, 242, 226), (40, 40, 46))
    body = [at_box(0.28, 0.013, 0.007, (0, s * 0.0125, 0)) for s in (-1, 1)]
    out = look.between(0.01, 0.04)
    slide = at_box(0.28, 0.0118, 0.0065, (out, 0, 0))
    cursor = at_box(0.026, 0.042, 0.003, (-0.03, 0, 0.0065))
    line = at_box(0.0008, 0.04, 0.0006, (-0.03, 0, 0.0092))
    return [
        (body[0], scale),
        (body[1], scale[::-1]),
        (slide, scale),
        (cursor, textures.plain((206, 226, 232))),
        (line, textures.plain((200, 40, 40))),
    ]


def _trundle(look: Look) -> Pieces:
    wheel = torus(0.11, 0.008, 40, 8).move(z=0.008)
    spokes = [
        straight(
            (0.11 * np.cos(a), 0.11 * np.sin(a), 0.008),
            (-0.11 * np.cos(a), -0.11 * np.sin(a), 0.008),
            0.004,
            6,
        )
        for a in np.arange(3) * 1.0472
    ]
    hub, stick = (
        disc(0.02, 0.024),
        rod([(0, 0, 0.03), (0.12, 0.03, 0.03), (0.34, 0.08, 0.012)], 0.009, 10),
    )
    grip = straight((0.3, 0.07, 0.016), (0.37, 0.087, 0.013), 0.0125, 10)
    return [
        (wheel, plastic(look, "yellow", "red", "orange")),
        (join(spokes), BLACK),
        (hub, BLACK),
        (stick, plastic(look, "yellow", "red", "orange")),
        (grip, BLACK),
    ]


_row = Rows("office", ("brass",), role=tall).of_drawing


CATEGORIES = (
    _row("soma_cube", _soma, (0.06, 0.06, 0.06), 0.12, ("cube puzzle",
             "wooden cube puzzle", "burr puzzle", "3d puzzle"), ("red",)),
    _row("galton_board", _galton, (0.18, 0.09, 0.252), 0.6, ("bean machine", "quincunx",
             "plinko board", "pinball board"), ("wooden",)),
    _row("newton_meter", _newton, (0.239, 0.0343, 0.0272), 0.06, ("force meter", "spring balance",
             "spring scale", "luggage scale", "dynamometer"), ("red",), 0.06, 3),
    _row("van_de_graaff_generator", _graaff, (0.16, 0.16, 0.38), 2.5, ("van de graaff",
             "static generator", "tesla coil", "wimshurst machine", "plasma ball"), ("navy",)),
    vary(_row("radiometer", _radiometer, (0.082, 0.082, 0.135), 0.1, ("light mill",
             "crookes radiometer", "solar radiometer"), ("clear",)), 0.08),
    _row("seismograph", _quake, (0.22, 0.13, 0.17), 1.5, ("seismometer", "earthquake recorder"),
             ("brown",), bodies=5),
    _row("pantograph", _panto, (0.27, 0.17, 0.018), 0.12, ("drawing pantograph",), ("wooden",)),
    vary(_row("slide_rule", _rule, (0.3, 0.042, 0.0098), 0.08, ("sliding ruler",
             "calculating ruler"),
             ("cream",), bodies=4), 0.08),
    _row("trundle_wheel", _trundle, (0.48, 0.24, 0.04), 0.7, ("measuring wheel", "odometer wheel",
             "surveyor wheel"), ("yellow",)),
)  # fmt: skip
"""The module's categories."""
