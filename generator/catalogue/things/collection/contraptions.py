"""More toys: cranes, dispensers, runs for marbles, small kitchens, telephones."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    at_block,
    at_box,
    disc,
    dye,
    hull_solid,
    of,
    plastic,
    shine,
    wood,
)
from ...build.outlines import arc
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join, tube
from ...surfaces import textures
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


WHITE = textures.plain((244, 242, 238))


def _crane(look: Look) -> Pieces:
    """A toy crane on wheels with a lattice arm and a hook."""
    tile = plastic(look, "yellow", "orange", "red", "blue")
    base = at_block(0.13, 0.06, 0.02, 0.006, (0, 0, 0.014))
    wheels = [
        disc(0.014, 0.01).turn(0, np.pi / 2).move(x, s * 0.031 + 0.005, 0.014)
        for x in (-0.045, 0, 0.045)
        for s in (-1, 1)
    ]
    cab = at_block(0.05, 0.05, 0.05, 0.006, (-0.02, 0, 0.034))
    pane = at_box(0.02, 0.0505, 0.022, (-0.006, 0, 0.054))
    boom = [straight((0.0, s * 0.014, 0.06), (0.115, s * 0.005, 0.17), 0.0032, 6) for s in (-1, 1)]
    rungs = [
        straight(
            (0.0 + 0.115 * t, -0.014 + 0.009 * t, 0.06 + 0.11 * t),
            (0.115 * t + 0.0, 0.014 - 0.009 * t, 0.06 + 0.11 * t),
            0.002,
            5,
        )
        for t in np.linspace(0.1, 0.95, 8)
    ]
    line = straight((0.115, 0, 0.168), (0.115, 0, 0.075), 0.0011, 5)
    hook = (
        tube([(*p, 0.0) for p in arc((0, 0), 0.008, -2.6, 1.2, 10)], 0.0022, 6)
        .turn(0, np.pi / 2)
        .move(0.115, 0, 0.068)
    )
    return [
        (base, tile),
        (cab, tile),
        (join(boom), tile),
        (join(wheels[::2]), BLACK),
        (join(wheels[1::2]), BLACK),
        (join(rungs), tile),
        (join([line, hook]), BLACK),
        (pane, textures.plain((150, 196, 222))),
    ]


def _pez(look: Look) -> Pieces:
    color = look.color("red", "blue", "yellow", "green", "purple")
    stem = at_block(0.022, 0.013, 0.08, 0.003, (0, 0, 0.005))
    foot = at_block(0.03, 0.028, 0.006, 0.006)
    head = ball(0.032, 0.032, 0.034, (0, 0, 0.1), 18)
    ears = [ball(0.02, 0.008, 0.02, (s * 0.016, 0, 0.118), 12) for s in (-1, 1)]
    eyes = [ball(0.007, 0.004, 0.009, (s * 0.006, -0.0145, 0.104), 8) for s in (-1, 1)]
    nose = ball(0.008, 0.006, 0.006, (0, -0.016, 0.097), 8)
    return [
        (foot, textures.plain(color)),
        (stem, textures.plain(color)),
        (head, dye(look, "beige", "white", "yellow", "pink")),
        (join(ears), BLACK),
        (join([*eyes, nose]), BLACK),
    ]


def _run(look: Look) -> Pieces:
    """A marble run: three sloping tracks on posts, marbles on their way."""
    tile = wood(look, "wooden", "beige")
    base = at_box(0.26, 0.08, 0.01)
    posts = [at_box(0.012, 0.06, 0.17, (s * 0.12, 0, 0.01)) for s in (-1, 1)]
    pieces: Pieces = [(base, tile), *((p, tile) for p in posts)]
    tones = ("red", "blue", "green")
    for k in range(3):
        slope = 0.13 * (1 if k % 2 else -1)
        bed = [
            at_box(0.2, 0.026, 0.005),
            at_box(0.2, 0.004, 0.014, (0, -0.013, 0)),
            at_box(0.2, 0.004, 0.014, (0, 0.013, 0)),
        ]
        x = 0.012 * (-1 if k % 2 else 1)
        for b in bed[:1]:
            pieces.append((b.turn(1, slope).move(x, 0, 0.042 + 0.048 * k), dye(look, tones[k])))
        pieces.append((join(bed[1:]).turn(1, slope).move(x, 0, 0.042 + 0.048 * k), pieces[-1][1]))
        pieces.append(
            (
                ball(
                    0.016,
                    0.016,
                    0.016,
                    (0.04 * (-1) ** k, 0, 0.058 + 0.048 * k - 0.04 * (-1) ** k * -slope * 0.0),
                    12,
                ),
                dye(look, "sky", "amber", "green"),
            )
        )
    return pieces


def _kitchen(look: Look) -> Pieces:
    """A toy kitchen: an oven with a window, a hob, a sink, a back wall."""
    tile = plastic(look, "pink", "white", "red", "mint", "wooden")
    body = at_block(0.2, 0.1, 0.12, 0.005)
    top = at_block(0.208, 0.106, 0.008, 0.004, (0, 0, 0.12))
    back = at_box(0.2, 0.008, 0.1, (0, 0.047, 0.126))
    shelf = at_box(0.18, 0.03, 0.006, (0, 0.034, 0.185))
    plates = [
        disc(0.02, 0.002, (x, y, 0.1275))
        for x, y in ((-0.07, -0.02), (-0.025, -0.02), (-0.07, 0.024), (-0.025, 0.024))
    ]
    sink = at_block(0.06, 0.05, 0.002, 0.012, (0.055, -0.005, 0.1275))
    tap = rod(
        [(0.055, 0.03, 0.126), (0.055, 0.03, 0.155), (0.055, 0.01, 0.155), (0.055, 0.005, 0.148)],
        0.0035,
        8,
    )
    door = at_box(0.08, 0.004, 0.07, (-0.048, -0.051, 0.02))
    pane = at_box(0.055, 0.005, 0.035, (-0.048, -0.0515, 0.03))
    grip = straight((-0.08, -0.058, 0.08), (-0.015, -0.058, 0.08), 0.003, 8)
    knobs = [
        disc(0.006, 0.006).turn(0, np.pi / 2).move(-0.078 + 0.02 * k, -0.049, 0.106)
        for k in range(4)
    ]
    door2 = at_box(0.07, 0.004, 0.09, (0.05, -0.051, 0.012))
    return [
        (body, tile),
        (top, WHITE),
        (back, tile),
        (shelf, WHITE),
        (join([door, door2]), WHITE),
        (join(plates), BLACK),
        (sink, shine(look)),
        (tap, shine(look)),
        (pane, textures.plain((60, 66, 80))),
        (grip, shine(look)),
        (join(knobs), BLACK),
    ]


def _phone(look: Look) -> Pieces:
    """A toddler's telephone: a face, a dial, wheels, a receiver on a cord."""
    body = hull_solid(
        [
            (x, y, z)
            for x in (-0.05, 0.05)
            for y, z in (
                (-0.05, 0.012),
                (-0.05, 0.03),
                (0.04, 0.085),
                (0.055, 0.07),
                (0.055, 0.012),
            )
        ]
    )
    wheels = [
        disc(0.018, 0.01).turn(0, np.pi / 2).turn(2, np.pi / 2).move(s * 0.052 + 0.005, y, 0.018)
        for s in (-1, 1)
        for y in (-0.035, 0.035)
    ]
    dial = disc(0.032, 0.004).turn(0, 0.55).move(0, -0.012, 0.054)
    holes = [
        disc(0.005, 0.001, (0.022 * np.cos(a), 0.022 * np.sin(a), 0.0036))
        .turn(0, 0.55)
        .move(0, -0.012, 0.054)
        for a in np.arange(9) * 0.6
    ]
    grip = [
        rod(
            [
                (-0.055, 0.045, 0.1),
                (-0.03, 0.045, 0.116),
                (0.03, 0.045, 0.116),
                (0.055, 0.045, 0.1),
            ],
            0.01,
            10,
        ),
        ball(0.032, 0.032, 0.024, (-0.055, 0.045, 0.095), 12),
        ball(0.032, 0.032, 0.024, (0.055, 0.045, 0.095), 12),
    ]
    return [
        (body, plastic(look, "white", "yellow", "sky", "pink")),
        (join(wheels[:2]), dye(look, "red", "blue")),
        (join(wheels[2:]), dye(look, "red", "blue")),
        (join(grip), dye(look, "red", "orange")),
        (dial, dye(look, "yellow", "teal")),
        (join(holes), dye(look, "red", "navy")),
    ]


_row = Rows("toys", ("red", "blue")).of_shape


CATEGORIES = (
    _row("toy_crane", of(_crane, bodies=5), (0.192, 0.0726, 0.173), 0.2, ("crane", "crane truck",
             "tower crane model", "model crane"), ("yellow",)),
    _row("pez_dispenser", of(_pez, bodies=3), (0.05, 0.034, 0.128), 0.03, (), ("red", "blue"),
             ("tall",)),
    _row("marble_run", of(_run), (0.26, 0.08, 0.18), 0.5, ("marble track", "ball run",
             "marble toy"), ("wooden",), ("big",)),
    _row("toy_kitchen", of(_kitchen, bodies=5), (0.208, 0.112, 0.226), 0.6, ("play kitchen",
             "mini kitchen", "dollhouse kitchen"), ("pink", "white"), ("big",)),
    _row("toy_phone", of(_phone, bodies=4), (0.142, 0.115, 0.127), 0.25, ("toy telephone",
             "play phone", "chatter telephone"), ("white",)),
)  # fmt: skip
"""The module's categories."""
