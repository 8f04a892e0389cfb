"""Plugs, straps, clips for cables, pulleys."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    metal,
    plastic,
    shine,
    spindle,
    standing,
)
from ...build.outlines import arc
from ...build.recipes import Pieces, rod
from ...build.solids import join, lathe, tube
from ...surfaces import textures
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


def _catch(look: Look) -> Pieces:
    body = at_block(0.045, 0.016, 0.014, 0.003)
    ears = at_block(0.065, 0.012, 0.004, 0.005)
    face = [at_box(0.034, 0.002, 0.003, (0, -0.0085, z)) for z in (0.003, 0.009)]
    return [
        (body, plastic(look, "white", "brown", "black")),
        (ears, plastic(look, "white", "brown", "black")),
        (join(face), shine(look)),
    ]


def _cableclip(look: Look) -> Pieces:
    tile = plastic(look, "white", "black", "gray")
    body = at_block(0.016, 0.01, 0.008, 0.002)
    loop = (
        tube([(*p, 0.0) for p in arc((0, 0), 0.006, 0, np.pi, 10)], 0.0022, 7)
        .turn(0, np.pi / 2)
        .move(-0.001, 0, 0.008)
    )
    nail = standing((0.0012, 0.0), (0.0012, 0.018), (0.0028, 0.019), (0.0028, 0.02), sides=10).move(
        x=0.0055
    )
    return [(body, tile), (loop, tile), (nail, shine(look))]


def _grommet(look: Look) -> Pieces:
    tile = plastic(look, "black", "gray", "white", "charcoal")
    body = lathe(
        [
            (0.008, 0),
            (0.015, 0),
            (0.016, 0.003),
            (0.013, 0.004),
            (0.013, 0.007),
            (0.016, 0.008),
            (0.015, 0.011),
            (0.008, 0.011),
        ],
        28,
        loop=True,
    )
    return [(body, tile)]


def _mains(look: Look) -> Pieces:
    """A three-pin plug lying on its back, a short cord."""
    shell = plastic(look, "white", "black", "gray")
    body = at_block(0.05, 0.05, 0.022, 0.01)
    pins = [
        at_box(0.0065, 0.004, 0.017, (x, y, 0.021)) for x, y in ((-0.011, -0.008), (0.011, -0.008))
    ] + [at_box(0.004, 0.008, 0.022, (0, 0.013, 0.021))]
    cord = rod(
        [(0, -0.024, 0.008), (0, -0.05, 0.005), (0.03, -0.075, 0.004), (0.075, -0.06, 0.004)],
        0.0038,
        8,
        6,
    )
    return [(body, shell), (join(pins), shine(look, "gold", "brass")), (cord, shell)]


def _schuko(kind: str) -> Drawing:
    """A small plug on a curled cord."""

    def draw(look: Look) -> Pieces:
        z = 0.008
        cord = rod(
            [
                (-0.03, 0, z),
                (-0.05, 0.0, 0.004),
                (-0.08, 0.02, 0.003),
                (-0.06, 0.045, 0.003),
                (-0.02, 0.04, 0.003),
            ],
            0.0028,
            8,
            6,
        )
        if kind == "rj45":
            body = at_block(0.024, 0.0125, 0.009, 0.0015, (0.0, 0, 0.002))
            clip = at_box(0.016, 0.006, 0.0012, (-0.001, 0, 0.0118)).turn(1, 0.12)
            pins = [
                at_box(0.006, 0.0007, 0.0008, (0.0085, -0.0045 + 0.0013 * k, 0.0107))
                for k in range(8)
            ]
            boot = spindle((-0.032, 0.0035), (-0.011, 0.0062), z=0.0065)
            return [
                (body, textures.plain((216, 226, 232))),
                (boot, plastic(look, "blue", "gray", "yellow", "red", "black")),
                (cord, plastic(look, "blue", "gray", "yellow", "black")),
                (join([clip]), textures.plain((206, 216, 222))),
                (join(pins), shine(look, "gold")),
            ]
        ring = (0.0045, 0.0085) if kind == "phono" else (0.0032, 0.007)
        body = spindle((-0.032, 0.003), (-0.026, 0.0065), (0.006, 0.0078), (0.01, ring[1]), z=z)
        tip = spindle((0.01, ring[0]), (0.036, ring[0]), (0.04, 0.0012), z=z)
        band = [
            spindle((x, ring[0] * 1.04), (x + 0.0012, ring[0] * 1.04), z=z) for x in (0.022, 0.03)
        ]
        collar = spindle((0.009, ring[1]), (0.016 if kind == "phono" else 0.011, ring[1]), z=z)
        return [
            (body, plastic(look, "black", "silver", "red", "gold")),
            (tip, shine(look, "gold", "silver")),
            (cord, dye(look, "black", "charcoal")),
            (join(band), BLACK),
            (collar, shine(look)),
        ]

    return draw


def _strap(look: Look) -> Pieces:
    """A hook-and-loop strap lying in a loop."""
    color = look.color("black", "blue", "red", "gray", "green")
    loop = lathe([(0.028, 0), (0.03, 0), (0.03, 0.018), (0.028, 0.018)], 40, loop=True)
    tail = at_box(0.06, 0.0022, 0.018, (0.03, -0.0295, 0)).turn(2, 0.08)
    buckle = at_block(0.008, 0.008, 0.02, 0.002, (0.0, -0.03, 0))
    return [
        (loop, textures.fabric(look.rng, color)),
        (tail, textures.fabric(look.rng, color)),
        (buckle, BLACK),
    ]


def _organiser(look: Look) -> Pieces:
    """A block with grooves that hold cables."""
    tile = plastic(look, "black", "white", "gray", "blue")
    body = at_block(0.09, 0.03, 0.008, 0.006)
    ribs = [at_block(0.011, 0.026, 0.012, 0.004, (-0.036 + 0.018 * k, 0, 0.006)) for k in range(5)]
    cords = [
        rod(
            [
                (-0.027 + 0.018 * k, -0.045, 0.003),
                (-0.027 + 0.018 * k, -0.01, 0.012),
                (-0.027 + 0.018 * k, 0.03, 0.012),
                (-0.02 + 0.022 * k, 0.055, 0.003),
            ],
            0.0022,
            6,
        )
        for k in range(4)
    ]
    return [(body, tile), (join(ribs), tile), (join(cords), dye(look, "white", "black", "gray"))]


def _pulley(look: Look) -> Pieces:
    """A block with a grooved wheel and a hook, lying."""
    steel = metal(look, "silver", "gray", "charcoal", "brass")
    wheel = lathe([(0, 0), (0.03, 0), (0.024, 0.006), (0.03, 0.012), (0, 0.012)], 32).move(z=0.004)
    cheeks = [at_block(0.03, 0.085, 0.003, 0.014, (0, 0.006, z)) for z in (0.0, 0.0165)]
    axle = disc(0.006, 0.022)
    hook = tube(
        [(*p, 0.01) for p in arc((0, 0.066), 0.014, -np.pi * 0.5, np.pi * 1.1, 16)], 0.0035, 8
    )
    return [
        (wheel, dye(look, "brass", "red", "gray")),
        (cheeks[0], steel),
        (cheeks[1], steel),
        (axle, shine(look)),
        (hook, steel),
    ]


_row = Rows("workbench", ("silver",), "lying").of_drawing


CATEGORIES = (
    _row("magnet_catch", _catch, (0.065, 0.0175, 0.014), 0.02, ("magnetic catch", "cabinet catch",
             "door magnet"), ("white",), bodies=2),
    _row("cable_clip", _cableclip, (0.017, 0.00978, 0.0196), 0.002, ("wire clip", "nail clip",
             "cable tack"), ("white",), bodies=2),
    _row("grommet", _grommet, (0.032, 0.032, 0.011), 0.004, ("cable grommet", "rubber grommet",
             "cable gland", "eyelet"), ("black",)),
    _row("power_plug", _mains, (0.102, 0.105, 0.0435), 0.06, ("uk plug",
             "electrical plug", "three pin plug", "wall socket plug",
             "plug with a cord"), ("white",), bodies=2),
    _row("network_plug", _schuko("rj45"), (0.095, 0.055, 0.013), 0.015, ("rj45 connector",
             "rj 45 connector", "ethernet plug", "network connector", "patch cable end"),
             ("blue",), bodies=3),
    _row("phono_plug", _schuko("phono"), (0.125, 0.057, 0.0165), 0.02, ("rca plug", "balun",
             "coax plug", "aerial plug", "antenna plug"), ("black",), bodies=3),
    _row("jack_plug", _schuko("jack"), (0.116, 0.0535, 0.0148), 0.02, ("audio jack",
             "headphone plug", "headphone jack", "aux plug", "guitar plug"), ("black",), bodies=3),
    _row("velcro_strap", _strap, (0.09, 0.064, 0.02), 0.006, ("hook and loop strap",
             "cable strap", "velcro tie", "velcro", "cable tie strap", "watch band strap"),
             ("black",), bodies=2),
    _row("cable_organiser", _organiser, (0.0911, 0.1, 0.0177), 0.04, ("cable organizer",
             "cable holder", "cable tidy", "cord organizer", "cable management clip"), ("black",),
             bodies=2),
    _row("pulley", _pulley, (0.06, 0.13, 0.022), 0.2, ("pulley block",
             "block and tackle", "rope pulley"), bodies=3),
)  # fmt: skip
"""The module's categories."""
