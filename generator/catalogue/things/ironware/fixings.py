"""Fixings and fittings: rivets, plugs, clips, catches, knobs, hooks, rings."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    at_block,
    at_box,
    disc,
    metal,
    plastic,
    shine,
    spindle,
    standing,
)
from ...build.recipes import Pieces
from ...build.solids import join, lathe, torus, tube
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


def _rivet(look: Look) -> Pieces:
    steel = metal(look, "silver", "copper", "gray")
    return [
        (
            standing(
                (0.0048, 0), (0.0052, 0.0012), (0.0035, 0.003), (0.0022, 0.0034), (0.0022, 0.016)
            ),
            steel,
        )
    ]


def _plug(look: Look) -> Pieces:
    """A wall plug lying: a ribbed sleeve with a collar."""
    points = [(-0.016, 0.0046), (-0.014, 0.0046)]
    for k in range(8):
        points += [(-0.013 + 0.0036 * k, 0.0029), (-0.011 + 0.0036 * k, 0.0037)]
    return [
        (
            spindle(*points, (0.017, 0.0018), z=0.0042),
            plastic(look, "red", "gray", "brown", "white", "yellow"),
        )
    ]


def _eye(look: Look) -> Pieces:
    steel = metal(look, "silver", "gold", "brass")
    ring = torus(0.0075, 0.0017, 22, 7).move(-0.008, 0, 0.0018)
    shank = spindle((0.0, 0.0017), (0.018, 0.0017), (0.024, 0.0004), z=0.0018)
    thread = spindle(
        *[(0.008 + 0.001 * k, 0.0021 - 0.0006 * (k % 2)) for k in range(13)], z=0.0021, sides=10
    )
    return [(ring, steel), (shank, steel), (thread, steel)]


def _tack(look: Look) -> Pieces:
    """A drawing pin lying on its flat head, the point up."""
    steel = metal(look, "gold", "silver", "brass", "red", "blue")
    head = standing((0.0042, 0), (0.0052, 0.0007), (0.004, 0.0012), sides=20)
    return [
        (head, steel),
        (standing((0.0006, 0.001), (0.00055, 0.007), (0.0001, 0.0095), sides=8), shine(look)),
    ]


def _staple(look: Look) -> Pieces:
    """One staple lying on its side."""
    steel = metal(look, "silver", "gray", "gold")
    way = [(-0.006, -0.006), (-0.006, 0.0), (0.006, 0.0), (0.006, -0.006)]
    return [
        (at_box(0.0126, 0.0007, 0.0006), steel),
        *((at_box(0.0007, 0.0065, 0.0006, (x, -0.0033, 0)), steel) for x, _ in (way[0], way[3])),
    ]


def _strip(look: Look) -> Pieces:
    """A strip of staples, legs down."""
    lines = textures.stripes([(206, 208, 212), (150, 152, 158)], 24, upright=True)
    top = at_box(0.05, 0.0126, 0.0008, (0, 0, 0.0056))
    sides = [at_box(0.05, 0.0008, 0.006, (0, s * 0.0059, 0)) for s in (-1, 1)]
    return [(top, lines), (sides[0], lines), (sides[1], lines)]


def _hoseclip(look: Look) -> Pieces:
    steel = metal(look, "silver", "silver", "gray")
    band = lathe([(0.019, 0), (0.02, 0), (0.02, 0.009), (0.019, 0.009)], 36, loop=True)
    box = at_block(0.014, 0.01, 0.01, 0.002, (0, 0.022, 0))
    screw = spindle((-0.012, 0.0032), (-0.008, 0.0042), (0.009, 0.003), z=0.0045).move(y=0.0255)
    slits = [
        at_box(0.0012, 0.0008, 0.006, (0.0202 * np.sin(a), -0.0202 * np.cos(a), 0.0015)).turn(2, 0)
        for a in np.linspace(-0.7, 0.7, 9)
    ]
    return [(band, steel), (box, steel), (screw, shine(look)), (join(slits), BLACK)]


def _circlip(look: Look) -> Pieces:
    steel = metal(look, "silver", "charcoal")
    a = np.linspace(-1.25, np.pi + 1.25, 40)
    way = np.column_stack([0.012 * np.cos(a), 0.012 * np.sin(a), 0 * a + 0.0012])
    ears = [at_block(0.005, 0.004, 0.0022, 0.0018, (s * 0.0042, -0.0118, 0)) for s in (-1, 1)]
    return [(tube(way, 0.0016, 6, squash=0.75), steel), (join(ears), steel)]


def _oring(look: Look) -> Pieces:
    return [
        (
            torus(0.015, 0.0022, 36, 10).move(z=0.0021),
            look.surface(look.color("black", "charcoal", "red", "orange"), "rubber"),
        )
    ]


def _bush(look: Look) -> Pieces:
    return [
        (
            lathe([(0.006, 0), (0.0115, 0), (0.0115, 0.016), (0.006, 0.016)], 26, loop=True),
            metal(look, "brass", "bronze", "silver", "black"),
        )
    ]


def _standoff(look: Look) -> Pieces:
    steel = metal(look, "brass", "silver", "gold")
    return [
        (spindle((-0.008, 0.0032), (0.008, 0.0032), sides=6, z=0.0028), steel),
        (spindle((0.008, 0.0016), (0.014, 0.0016), sides=10, z=0.0028), steel),
        (spindle((-0.0081, 0.0017), (-0.0079, 0.0017), z=0.0028), BLACK),
    ]


def _latch(look: Look) -> Pieces:
    """A barrel bolt: a plate, two loops, a sliding bolt with a knob."""
    steel = metal(look, "silver", "brass", "black", "gray")
    base = at_block(0.08, 0.03, 0.002, 0.004)
    keep = at_block(0.016, 0.03, 0.002, 0.003, (0.054, 0, 0))
    loops = [at_block(0.01, 0.02, 0.012, 0.004, (x, 0, 0.001)) for x in (-0.025, 0.022, 0.054)]
    bolt = spindle((-0.036, 0.004), (0.066, 0.004), z=0.0065)
    knob = standing((0.003, 0.006), (0.003, 0.016), (0.005, 0.018), (0.005, 0.022), sides=12).move(
        x=-0.004
    )
    screws = [
        disc(0.0028, 0.001, (x, y, 0.0018), sides=10)
        for x in (-0.036, 0.036)
        for y in (-0.01, 0.01)
    ]
    return [
        (base, steel),
        (keep, steel),
        *((p, steel) for p in loops),
        (bolt, shine(look)),
        (knob, steel),
        (join(screws), shine(look)),
    ]


_row = Rows("workbench", ("silver",), "lying").of_drawing


CATEGORIES = (
    _row("rivet", _rivet, (0.0104, 0.0104, 0.016), 0.002, ("pop rivet", "steel rivet",
             "metal stud", "stud", "rivet nail")),
    _row("wall_plug", _plug, (0.033, 0.0088, 0.0088), 0.001, ("rawlplug", "wall anchor",
             "screw anchor", "screw plug", "dowel plug", "rawl plug"), ("red", "gray"), 0.1),
    _row("screw_eye", _eye, (0.042, 0.0184, 0.004), 0.003, ("eye screw", "eye bolt",
             "eyelet screw", "ring bolt", "hook screw"), foot=0.1, bodies=2),
    _row("thumbtack", _tack, (0.0104, 0.0104, 0.0095), 0.0006, ("drawing pin", "tack", "brad",
             "single thumbtack", "carpet tack", "upholstery tack", "brass tack"), ("gold",),
             bodies=1),
    _row("staple", _staple, (0.0126, 0.0068, 0.0006), 0.0001, ("single staple", "wire staple",
             "loose staple")),
    vary(_row("staple_strip", _strip, (0.05, 0.0126, 0.0064), 0.004, ("strip of staples",
             "staples",
             "box of staples"))),
    vary(_row("hose_clip", _hoseclip, (0.0403, 0.0507, 0.0101), 0.015, ("jubilee clip",
             "hose clamp",
             "pipe clip", "worm clip"), bodies=2)),
    _row("circlip", _circlip, (0.027, 0.027, 0.0024), 0.002, ("retaining ring", "snap ring",
             "c clip", "piston ring")),
    _row("o_ring", _oring, (0.0344, 0.0344, 0.0043), 0.001, ("oring", "rubber washer",
             "rubber seal", "rubber o ring", "o-ring"), ("black",), 0.08),
    _row("bushing", _bush, (0.023, 0.023, 0.016), 0.02, ("bush", "sleeve bearing", "spacer",
             "metal sleeve", "collet", "metal spacer", "tube spacer"), ("brass",)),
    _row("standoff", _standoff, (0.022, 0.0064, 0.0056), 0.002, ("hex standoff",
             "threaded insert", "hex spacer", "brass standoff"), ("brass",), bodies=2),
    _row("latch", _latch, (0.102, 0.03, 0.022), 0.08, ("barrel bolt", "slide bolt", "door bolt",
             "door latch", "door lock bolt")),
)  # fmt: skip
"""The module's categories."""
