"""Models of the body, and machines and small things of a biology laboratory."""

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
    standing,
    wood,
)
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join, lathe, torus
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows
from .displays import display

BLACK = textures.plain((34, 34, 37))


def _cycler(look: Look) -> Pieces:
    """A thermocycler: a lid with a knob over its block."""
    shell = plastic(look, "white", "gray", "sky")
    return [
        (at_block(0.2, 0.26, 0.12, 0.02), shell),
        (
            at_block(0.14, 0.12, 0.035, 0.012, (0, 0.05, 0.118)),
            dye(look, "gray", "navy", "charcoal"),
        ),
        (disc(0.02, 0.018, (0, -0.03, 0.118)), BLACK),
        (at_box(0.08, 0.035, 0.001, (-0.03, -0.09, 0.1195)), display("PCR 95")),
    ]


def _photometer(look: Look) -> Pieces:
    """A spectrophotometer with the lid of its sample chamber."""
    shell = plastic(look, "white", "gray", "sky")
    return [
        (at_block(0.24, 0.28, 0.1, 0.02), shell),
        (
            at_block(0.14, 0.12, 0.035, 0.012, (0, 0.05, 0.099)),
            dye(look, "gray", "navy", "charcoal"),
        ),
        (at_block(0.05, 0.04, 0.016, 0.006, (0.07, -0.04, 0.099)), BLACK),
        (at_box(0.08, 0.035, 0.001, (-0.03, -0.09, 0.0995)), display("0.482 A")),
    ]


def _box(look: Look) -> Pieces:
    """A freezer box with its lid off beside: a grid of vials."""
    shell = plastic(look, "white", "sky", "yellow", "red", "green")
    body = at_box(0.13, 0.13, 0.04)
    vials = [
        disc(0.0062, 0.012, ((i - 3.5) * 0.0152, (j - 3.5) * 0.0152, 0.0395), sides=7)
        for i in range(8)
        for j in range(8)
    ]
    tones = ("red", "blue", "yellow", "green")
    pieces: Pieces = [(body, shell)]
    for k, tone in enumerate(tones):
        pieces.append((join(vials[k::4]), dye(look, tone)))
    return pieces


def _net(look: Look) -> Pieces:
    """A butterfly net lying: a hoop with a tapering bag, a long handle."""
    hoop = torus(0.09, 0.003, 40, 6).move(0.1, 0, 0.0032)
    color = look.color("white", "green", "sky", "yellow", "pink")
    bag = lathe(
        [(0.0, 0.0), (0.088, 0.0), (0.08, 0.02), (0.05, 0.035), (0.012, 0.042), (0.0, 0.043)], 30
    ).move(0.1, 0, 0.001)
    stick = spindle((-0.28, 0.006), (0.012, 0.006), z=0.006)
    mesh = textures.grid(tint_color(color, 0.8), tint_color(color, 1.2), 24, 24)
    grip = spindle((-0.285, 0.009), (-0.18, 0.009), z=0.009)
    return [(bag, mesh), (hoop, shine(look)), (stick, wood(look, "wooden")), (grip, BLACK)]


def _brain(look: Look) -> Pieces:
    color = look.color("pink", "beige", "coral")
    pieces: Pieces = []

    def folds(p: np.ndarray) -> np.ndarray:
        wave = 1 + 0.035 * np.sin(160 * p[:, 0] + 3 * np.sin(150 * p[:, 1])) * np.cos(
            150 * p[:, 2] + 2 * np.sin(120 * p[:, 0])
        )
        return p * wave[:, None]

    skin = textures.spots(look.rng, color, tint_color(color, 0.78), 0.3)
    for s in (-1, 1):
        half = ball(0.13, 0.062, 0.095, (0, 0, 0), 40).bend(folds).move(0, s * 0.03, 0.085)
        pieces.append((half, skin))
    stem = rod([(0.03, 0, 0.06), (0.04, 0, 0.035), (0.045, 0, 0.014)], [0.016, 0.013, 0.01], 10)
    cere = ball(0.055, 0.08, 0.04, (0.045, 0, 0.05), 16)
    return [
        (disc(0.045, 0.014), BLACK),
        *pieces,
        (cere, textures.stripes([tint_color(color, 0.8), tint_color(color, 1.05)], 8)),
        (stem, textures.plain(tint_color(color, 1.2))),
    ]


def _eye(look: Look) -> Pieces:
    iris = look.color("blue", "green", "brown", "gray")
    foot = standing((0.04, 0), (0.038, 0.008), (0.008, 0.016), (0.008, 0.04))
    globe = ball(0.1, 0.1, 0.1, (0, 0, 0.088), 30)
    cornea = [
        ball(0.05, 0.014, 0.05, (0, -0.0435, 0.088), 20),
        ball(0.022, 0.008, 0.022, (0, -0.0482, 0.088), 14),
    ]
    veins = [
        rod(
            [
                (
                    0.05 * np.sin(t) * np.cos(a),
                    0.05 * np.cos(t) - 0.0,
                    0.088 + 0.05 * np.sin(t) * np.sin(a),
                )
                for t in (0.2, 0.8, 1.4)
            ],
            0.001,
            5,
        )
        for a in (0.5, 1.6, 2.7, 3.8, 5.1)
    ]
    nerve = rod([(0, 0.048, 0.088), (0, 0.07, 0.088)], 0.011, 10)
    return [
        (foot, BLACK),
        (globe, textures.plain((244, 240, 234))),
        (cornea[0], textures.plain(iris)),
        (cornea[1], BLACK),
        (nerve, dye(look, "coral")),
        (join(veins), textures.plain((204, 60, 56))),
    ]


def _bones(look: Look) -> Pieces:
    """A skeleton hung on a stand."""
    bone = look.surface(look.color("ivory", "cream", "white"))
    base, pole = (
        at_block(0.11, 0.09, 0.012, 0.01),
        straight((0, 0.025, 0.01), (0, 0.025, 0.33), 0.004, 8),
    )
    skull = [
        ball(0.045, 0.05, 0.05, (0, 0, 0.315), 16),
        ball(0.03, 0.034, 0.03, (0, -0.006, 0.292), 12),
    ]
    holes = [ball(0.012, 0.008, 0.013, (s * 0.011, -0.0225, 0.315), 8) for s in (-1, 1)] + [
        ball(0.006, 0.006, 0.008, (0, -0.0245, 0.303), 6)
    ]
    spine = [ball(0.012, 0.012, 0.01, (0, 0.006, 0.17 + 0.0115 * k), 8) for k in range(10)]
    ribs = [
        torus(1, 0.055, 16, 4)
        .scale(0.036 - 0.0016 * abs(k - 2.5), 0.024, 0.03)
        .move(0, 0, 0.215 + 0.012 * k)
        for k in range(5)
    ]
    hips = torus(1, 0.2, 18, 6).scale(0.03, 0.017, 0.03).move(0, 0, 0.163)
    limbs = []
    for s in (-1, 1):
        limbs += [
            rod(
                [(s * 0.036, 0, 0.272), (s * 0.055, 0, 0.215), (s * 0.06, -0.006, 0.15)], 0.0042, 6
            ),
            ball(0.014, 0.01, 0.022, (s * 0.061, -0.007, 0.138), 8),
        ]
        limbs += [
            rod([(s * 0.02, 0, 0.158), (s * 0.022, -0.003, 0.09), (s * 0.02, 0, 0.024)], 0.0052, 6),
            ball(0.016, 0.036, 0.011, (s * 0.02, -0.01, 0.018), 8),
        ]
    collar = straight((-0.036, 0, 0.275), (0.036, 0, 0.275), 0.0042, 6)
    return [
        (base, BLACK),
        (pole, shine(look)),
        (join(skull), bone),
        (join(spine), bone),
        (hips, bone),
        (join(ribs), bone),
        (join(limbs), bone),
        (collar, bone),
        (join(holes), BLACK),
    ]


_row = Rows("lab", ("white",)).of_drawing


CATEGORIES = (
    _row("thermocycler", _cycler, (0.2, 0.26, 0.153), 5.0, ("pcr machine",
             "thermal cycler"), bodies=3, roles=("big",)),
    _row("spectrophotometer", _photometer, (0.24, 0.28, 0.134), 5.0, ("photometer",
             "colorimeter", "spectrometer", "plate reader"), bodies=3, roles=("big",)),
    _row("cryobox", _box, (0.13, 0.13, 0.052), 0.3, ("cryo box", "vial box", "box of vials",
             "freezer box", "sample box"), bodies=1),
    _row("butterfly_net", _net, (0.48, 0.186, 0.044), 0.15, ("insect net",
             "bug net", "pooter"), roles=("big",)),
    _row("brain_model", _brain, (0.135, 0.125, 0.13), 0.5, ("model brain", "brain",
             "human brain model", "anatomical brain"), ("pink",), bodies=5),
    vary(_row("eye_model", _eye, (0.1, 0.125, 0.138), 0.3, ("model eye", "eyeball model"),
             ("blue",),
             bodies=2)),
    _row("skeleton_model", _bones, (0.13, 0.09, 0.34), 0.4, ("model skeleton",
             "human skeleton"),
             ("ivory",), roles=("tall",)),
)  # fmt: skip
"""The module's categories."""
