"""More fittings: latches, castors, knobs, plugs, straps."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    at_block,
    at_box,
    disc,
    metal,
    shine,
    spindle,
    standing,
    wood,
)
from ...build.outlines import arc
from ...build.recipes import Pieces, rod, straight
from ...build.solids import join, lathe, torus, tube
from ...surfaces import textures
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


def _hasp(look: Look) -> Pieces:
    steel = metal(look, "silver", "black", "brass")
    left = at_block(0.035, 0.034, 0.002, 0.003, (-0.045, 0, 0))
    flap = at_block(0.075, 0.03, 0.003, 0.008, (0.014, 0, 0.002))
    hinge = straight((-0.026, -0.017, 0.003), (-0.026, 0.017, 0.003), 0.0032, 10)
    loop = (
        tube([(*p, 0.0) for p in arc((0, 0), 0.008, 0, np.pi, 10)], 0.002, 6)
        .turn(0, np.pi / 2)
        .turn(2, np.pi / 2)
        .move(0.034, 0, 0.004)
    )
    slot = at_box(0.006, 0.018, 0.0008, (0.034, 0, 0.0046))
    holes = [
        disc(0.0028, 0.0008, (x, y, 0.0018), sides=10)
        for x in (-0.054, -0.038)
        for y in (-0.01, 0.01)
    ]
    return [
        (left, steel),
        (flap, steel),
        (hinge, steel),
        (loop, shine(look)),
        (join([slot, *holes]), BLACK),
    ]


def _turnbuckle(look: Look) -> Pieces:
    steel = metal(look, "silver", "gray")
    frame = [
        straight((-0.035, s * 0.009, 0.007), (0.035, s * 0.009, 0.007), 0.003, 8) for s in (-1, 1)
    ]
    ends = [at_block(0.014, 0.024, 0.012, 0.004, (s * 0.036, 0, 0.001)) for s in (-1, 1)]
    bolts = [straight((s * 0.015, 0, 0.007), (s * 0.065, 0, 0.007), 0.0034, 8) for s in (-1, 1)]
    eyes = [torus(0.01, 0.003, 20, 7).move(s * 0.074, 0, 0.0068) for s in (-1, 1)]
    return [
        (join([*frame, *ends]), steel),
        (join(bolts), shine(look)),
        (eyes[0], steel),
        (eyes[1], steel),
    ]


def _castor(look: Look) -> Pieces:
    """A castor standing on its wheel: a fork, a plate on top."""
    steel = metal(look, "silver", "gray", "black")
    wheel = (
        lathe([(0, 0), (0.02, 0), (0.025, 0.005), (0.025, 0.015), (0.02, 0.02), (0, 0.02)], 26)
        .turn(0, np.pi / 2)
        .move(0.012, 0.01, 0.024)
    )
    fork = [at_block(0.02, 0.003, 0.045, 0.001, (0.008, s * 0.0135, 0.02)) for s in (-1, 1)]
    bridge = at_block(0.034, 0.032, 0.006, 0.004, (0.003, 0, 0.06))
    top = at_block(0.05, 0.05, 0.004, 0.004, (0, 0, 0.068))
    stem = disc(0.011, 0.01, (0, 0, 0.06))
    foot = at_box(0.03, 0.02, 0.003, (0.012, 0, 0))
    return [
        (wheel, BLACK),
        (foot, BLACK),
        (join(fork), steel),
        (join([bridge, stem]), steel),
        (top, steel),
    ]


def _knob(look: Look) -> Pieces:
    """A round knob on a rose, standing on its back plate."""
    steel = metal(look, "brass", "silver", "gold", "white", "black")
    return [
        (
            standing(
                (0.029, 0),
                (0.028, 0.005),
                (0.013, 0.009),
                (0.011, 0.024),
                (0.02, 0.03),
                (0.027, 0.042),
                (0.026, 0.052),
                (0.014, 0.06),
                sides=30,
            ),
            steel,
        )
    ]


def _lever(look: Look) -> Pieces:
    """A lever handle on a long plate with a keyhole, lying."""
    steel = metal(look, "silver", "brass", "black")
    base = at_block(0.045, 0.2, 0.006, 0.012)
    neck = disc(0.012, 0.035, (0, 0.045, 0.005))
    lever = rod(
        [(0, 0.045, 0.036), (-0.03, 0.045, 0.04), (-0.115, 0.042, 0.037)],
        [0.0095, 0.0095, 0.007],
        10,
    )
    hole = [
        disc(0.005, 0.0008, (0, -0.03, 0.0056)),
        at_box(0.004, 0.012, 0.0008, (0, -0.036, 0.0056)),
    ]
    return [(base, steel), (neck, steel), (lever, steel), (join(hole), BLACK)]


def _pull(look: Look) -> Pieces:
    steel = metal(look, "silver", "brass", "black", "gold")
    bar = rod(
        [
            (-0.055, 0, 0.0),
            (-0.053, 0, 0.02),
            (-0.035, 0, 0.028),
            (0.035, 0, 0.028),
            (0.053, 0, 0.02),
            (0.055, 0, 0.0),
        ],
        0.0055,
        10,
        5,
    )
    feet = [disc(0.009, 0.004, (s * 0.055, 0, 0)) for s in (-1, 1)]
    return [(bar, steel), (feet[0], steel), (feet[1], steel)]


def _leg(look: Look) -> Pieces:
    """A turned wooden leg lying, a bolt at its thick end."""
    tile = wood(look, "wooden", "brown", "tan")
    leg = spindle(
        (-0.15, 0.013),
        (-0.13, 0.012),
        (0.05, 0.02),
        (0.09, 0.022),
        (0.1, 0.018),
        (0.11, 0.022),
        (0.14, 0.022),
        z=0.0215,
    )
    return [
        (leg, tile),
        (spindle((0.14, 0.004), (0.165, 0.004), z=0.0215), shine(look)),
        (spindle((-0.155, 0.008), (-0.149, 0.011), z=0.0215), BLACK),
    ]


_row = Rows("workbench", ("silver",), "lying").of_drawing


CATEGORIES = (
    _row("hasp", _hasp, (0.118, 0.0353, 0.0146), 0.08, ("hasp and staple", "lock hasp",
             "toggle latch", "clasp"), bodies=3),
    _row("turnbuckle", _turnbuckle, (0.168, 0.0251, 0.0116), 0.12, ("wire tensioner",
             "rigging screw"), foot=0.08),
    _row("castor", _castor, (0.06, 0.05, 0.072), 0.12, ("caster", "castor wheel", "caster wheel",
             "furniture wheel", "furniture castor")),
    _row("door_knob", _knob, (0.058, 0.058, 0.06), 0.2, (
             "round knob", "furniture knob"), ("brass",)),
    _row("door_handle", _lever, (0.139, 0.202, 0.0495), 0.35, ("door lever",),
             bodies=3),
    _row("drawer_pull", _pull, (0.128, 0.018, 0.034), 0.06, ("drawer handle", "cabinet handle",
             "cupboard handle", "pull handle"), foot=0.05),
    _row("furniture_leg", _leg, (0.32, 0.044, 0.043), 0.2, ("chair leg", "sofa leg", "turned leg",
             "table leg spare"), ("wooden",), 0.08, 1),
)  # fmt: skip
"""The module's categories."""
