"""Teeth, plates, casts, and machines for the sick."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    at_block,
    at_box,
    disc,
    dye,
    plastic,
    shine,
    spindle,
)
from ...build.recipes import Pieces, ball, pad, rod, straight
from ...build.solids import join, lathe, torus
from ...surfaces import prints, textures
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


WHITE = textures.plain((244, 243, 240))


def _pan(look: Look) -> Pieces:
    """A bedpan: a low broad bowl with a flat rim and a handle."""
    tile = plastic(look, "white", "gray", "sky", "silver")
    floor = at_block(0.22, 0.2, 0.01, 0.08)
    wall = lathe(
        [(0.09, 0), (0.11, 0.06), (0.135, 0.066), (0.135, 0.07), (0.104, 0.068), (0.084, 0.006)],
        36,
        loop=True,
    )
    grip = at_block(0.08, 0.05, 0.012, 0.018, (0.155, 0, 0.056))
    return [(floor, tile), (wall.scale(1.05, 1, 1), tile), (grip, tile)]


def _probe(look: Look) -> Pieces:
    """An ultrasound probe lying with its cord."""
    shell = plastic(look, "white", "gray", "sky")
    body = rod([(-0.06, 0, 0.018), (0.0, 0, 0.018), (0.03, 0, 0.018)], [0.013, 0.017, 0.018], 14)
    head = ball(0.05, 0.066, 0.034, (0.045, 0, 0.0175), 18)
    tip = ball(0.02, 0.058, 0.026, (0.066, 0, 0.0175), 16)
    cord = rod(
        [
            (-0.06, 0, 0.018),
            (-0.09, 0, 0.012),
            (-0.12, 0.03, 0.004),
            (-0.08, 0.07, 0.004),
            (0.0, 0.06, 0.004),
        ],
        0.0036,
        8,
        6,
    )
    return [
        (body, shell),
        (head, shell),
        (tip, dye(look, "gray", "navy")),
        (cord, dye(look, "gray", "white")),
    ]


def _defib(look: Look) -> Pieces:
    """A defibrillator: a bright case with a heart, a screen, a big button, a handle."""
    shell = plastic(look, "red", "yellow", "orange", "green")
    body = at_block(0.22, 0.2, 0.075, 0.03)
    grip = rod(
        [(-0.06, 0.09, 0.05), (-0.05, 0.125, 0.05), (0.05, 0.125, 0.05), (0.06, 0.09, 0.05)],
        0.01,
        10,
    )
    screen = prints.canvas(96, 56, (24, 40, 36))
    prints.stroke(
        screen,
        [(0, 0.5), (0.3, 0.5), (0.37, 0.2), (0.45, 0.85), (0.52, 0.5), (1, 0.5)],
        0.05,
        (110, 240, 140),
    )
    badge = prints.canvas(64, 64, (246, 246, 244))
    prints.disc(badge, 0.36, 0.38, 0.17, (206, 36, 40))
    prints.disc(badge, 0.64, 0.38, 0.17, (206, 36, 40))
    prints.polygon(badge, [(0.2, 0.45), (0.8, 0.45), (0.5, 0.85)], (206, 36, 40))
    prints.polygon(
        badge,
        [(0.55, 0.3), (0.4, 0.55), (0.5, 0.55), (0.45, 0.75), (0.62, 0.47), (0.52, 0.47)],
        (250, 240, 120),
    )
    knob = disc(0.018, 0.008, (0.06, -0.055, 0.074))
    return [
        (body, shell),
        (grip, BLACK),
        (knob, dye(look, "orange", "green")),
        (at_box(0.09, 0.055, 0.001, (-0.045, 0.04, 0.0746)), screen),
        (at_box(0.055, 0.055, 0.001, (0.06, 0.035, 0.0746)), badge),
    ]


def _nebuliser(look: Look) -> Pieces:
    """A nebuliser: a small pump, a hose, a clear mask."""
    shell = plastic(look, "white", "sky", "gray")
    body = at_block(0.15, 0.12, 0.08, 0.03, (-0.04, 0, 0))
    vents = [at_box(0.05, 0.003, 0.001, (-0.05, 0.02 + 0.01 * k, 0.0796)) for k in range(4)]
    knob = disc(0.012, 0.006, (-0.03, -0.03, 0.0795))
    mask = (
        lathe(
            [
                (0.012, 0.045),
                (0.03, 0.03),
                (0.042, 0.0),
                (0.039, 0.0),
                (0.027, 0.028),
                (0.009, 0.042),
            ],
            26,
            loop=True,
        )
        .scale(0.85, 1.1, 1)
        .move(0.11, 0, 0)
    )
    cup = disc(0.012, 0.03, (0.11, 0, 0.043))
    hose = rod(
        [
            (0.035, 0.03, 0.03),
            (0.06, 0.08, 0.006),
            (0.13, 0.08, 0.006),
            (0.13, 0.02, 0.05),
            (0.115, 0, 0.06),
        ],
        0.003,
        8,
        6,
    )
    return [
        (body, shell),
        (mask, textures.plain((196, 222, 226))),
        (cup, textures.plain((206, 226, 230))),
        (hose, textures.plain((206, 226, 230))),
        (join(vents), BLACK),
        (knob, dye(look, "green", "blue")),
    ]


def _ampoule(look: Look) -> Pieces:
    color = look.color("amber", "clear", "brown", "sky")
    body = spindle(
        (-0.03, 0.0035),
        (-0.028, 0.0056),
        (0.008, 0.0056),
        (0.013, 0.0026),
        (0.016, 0.0032),
        (0.026, 0.0028),
        (0.031, 0.0008),
        z=0.0056,
    )
    band = spindle((-0.02, 0.0058), (0.0, 0.0058), z=0.0057)
    return [
        (body, textures.plain(color)),
        (band, textures.stripes([(246, 246, 244), (60, 110, 180)], 1, upright=True)),
    ]


def _hand(look: Look) -> Pieces:
    """An artificial hand lying: jointed fingers, a wrist ring."""
    tile = plastic(look, "black", "gray", "beige", "silver", "white")
    palm = pad(0.085, 0.08, 0.03, 0.02)
    fingers = []
    for y, n in ((-0.03, 0.07), (-0.01, 0.085), (0.011, 0.08), (0.031, 0.062)):
        fingers.append(
            rod(
                [
                    (0.035, y, 0.016),
                    (0.035 + 0.5 * n, 1.15 * y, 0.022),
                    (0.035 + n, 1.2 * y, 0.011),
                ],
                [0.0095, 0.009, 0.0075],
                10,
            )
        )
    thumb = rod(
        [(-0.02, -0.035, 0.014), (0.01, -0.065, 0.016), (0.04, -0.075, 0.011)],
        [0.011, 0.01, 0.008],
        10,
    )
    wrist = spindle((-0.085, 0.026), (-0.035, 0.024), z=0.0225).scale(1, 1.15, 1)
    rings = [
        torus(0.0095, 0.0016, 14, 5).turn(1, np.pi / 2).move(0.07, 1.1 * y, 0.0195)
        for y in (-0.03, -0.01, 0.011, 0.031)
    ]
    return [
        (palm, tile),
        (wrist, dye(look, "charcoal", "silver")),
        (thumb, tile),
        *((f, tile) for f in fingers),
        (join(rings), shine(look)),
    ]


def _pace(look: Look) -> Pieces:
    steel = shine(look, "silver", "gray")
    body = at_block(0.048, 0.042, 0.008, 0.019)
    head = at_block(0.04, 0.014, 0.0085, 0.006, (0, 0.024, 0))
    lead = rod(
        [
            (0.012, 0.03, 0.004),
            (0.03, 0.05, 0.002),
            (0.06, 0.03, 0.002),
            (0.05, -0.02, 0.002),
            (0.075, -0.03, 0.002),
        ],
        0.0014,
        6,
        6,
    )
    return [
        (body, steel),
        (head, textures.plain((190, 214, 222))),
        (lead, dye(look, "white", "gray")),
    ]


def _speculum(look: Look) -> Pieces:
    tile = shine(look, "silver", "gray") if look.chance(0.6) else textures.plain((206, 224, 230))
    bills = [
        rod(
            [
                (-0.02, 0, 0.02 + s * 0.004),
                (0.04, 0, 0.02 + s * 0.008),
                (0.09, 0, 0.02 + s * 0.003),
            ],
            [0.018, 0.014, 0.007],
            12,
        )
        for s in (-1, 1)
    ]
    grip = [
        at_block(0.016, 0.02, 0.012, 0.004, (-0.03, 0, 0.006)),
        rod([(-0.03, 0, 0.012), (-0.045, -0.04, 0.008), (-0.05, -0.09, 0.007)], 0.007, 10),
    ]
    screw = straight((-0.03, -0.02, 0.012), (0.0, -0.03, 0.012), 0.003, 8)
    return [
        (bills[0], tile),
        (bills[1], tile),
        (grip[0], tile),
        (grip[1], tile),
        (screw, shine(look)),
    ]


def _flow(look: Look) -> Pieces:
    """A peak flow meter lying: a tube with a scale and a mouthpiece."""
    scale = prints.rule(8, (250, 250, 248), (30, 60, 140))
    body = at_block(0.15, 0.04, 0.03, 0.012)
    mouth = spindle((0.072, 0.0145), (0.105, 0.0145), z=0.0152)
    slider = at_box(0.006, 0.01, 0.003, (look.between(-0.03, 0.03), 0.0, 0.0296))
    return [
        (body, plastic(look, "white", "blue", "yellow")),
        (mouth, WHITE),
        (at_box(0.12, 0.026, 0.0006, (-0.005, 0, 0.0297)), scale),
        (slider, textures.plain((206, 40, 38))),
    ]


_row = Rows("lab", ("white",)).of_drawing


CATEGORIES = (
    _row("bedpan", _pan, (0.34, 0.27, 0.07), 0.35, ("bed pan",), bodies=(0,
             2), roles=("big",)),
    _row("ultrasound_probe", _probe, (0.2, 0.11, 0.036), 0.15, ("ultrasound wand",
             "ultrasound transducer", "massage gun"), foot=0.06, bodies=3),
    _row("defibrillator", _defib, (0.22, 0.235, 0.082), 1.8, ("aed", "aed device",
             "portable defibrillator"), ("red", "yellow"), bodies=2, roles=("big",)),
    _row("nebuliser", _nebuliser, (0.27, 0.16, 0.085), 1.2, ("nebulizer", "inhalation device",
             "oxygen mask"), bodies=2, roles=("big",)),
    _row("ampoule", _ampoule, (0.061, 0.0116, 0.0116), 0.004, ("glass ampoule", "ampule", "ampul",
             "ammonia inhalant", "smelling salt ampoule"), ("amber",), 0.1),
    _row("prosthetic_hand", _hand, (0.21, 0.13, 0.047), 0.35, ("artificial hand",
             "hand model", "bionic hand"), ("black",), 0.06),
    _row("pacemaker", _pace, (0.1, 0.08, 0.0085), 0.03, ("heart pacemaker",), ("silver",)),
    _row("speculum", _speculum, (0.15, 0.11, 0.042), 0.12, ("retractor", "surgical retractor",
             "vaginal speculum"), ("silver",), 0.05),
    _row("peak_flow_meter", _flow, (0.18, 0.04, 0.033), 0.08, ("spirometer", "flow meter",
             "peak flow"), bodies=2),
)  # fmt: skip
"""The module's categories."""
