"""Parts of an engine: plugs, filters, pistons, shafts, discs, pumps."""

from __future__ import annotations

import numpy as np

from ...build.making import (
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
)
from ...build.outlines import arc
from ...build.recipes import Pieces, rod, straight
from ...build.solids import Solid, join, lathe, prism, torus
from ...surfaces import textures
from ...surfaces.look import Look
from ..rows import Rows

DARK = textures.plain((28, 28, 30))


def _plug(look: Look) -> Pieces:
    """A spark plug lying: terminal, ribbed insulator, hexagon, thread, electrode."""
    steel = metal(look, "silver", "gray")
    white = spindle((-0.035, 0.0045), (-0.034, 0.005), (-0.03, 0.0045), (-0.028, 0.005),
                   (-0.024, 0.0045), (-0.022, 0.005), (-0.005, 0.0062), z=0.01)  # fmt: skip
    tip = spindle((-0.045, 0.0022), (-0.043, 0.0032), (-0.035, 0.0032), z=0.01)
    hexagon = spindle(
        (-0.006, 0.0085), (-0.004, 0.0105), (0.004, 0.0105), (0.006, 0.0085), sides=6, z=0.0092
    )
    shoulder = spindle((0.005, 0.0085), (0.011, 0.0085), (0.012, 0.007), z=0.01)
    points = [(0.012 + 0.001 * k, 0.0068 - 0.0008 * (k % 2)) for k in range(19)]
    thread = spindle(*points, z=0.01, sides=14)
    end = straight((0.03, 0, 0.01), (0.034, 0, 0.01), 0.0018)
    hook = rod([(0.03, 0, 0.016), (0.036, 0, 0.0155), (0.036, 0, 0.01)], 0.0011, 6)
    return [(hexagon, steel), (white, textures.plain((240, 238, 232))), (thread, shine(look)),
            (join([tip, shoulder, end, hook]), steel)]  # fmt: skip


def _pad(look: Look) -> Pieces:
    """A brake pad lying: a steel back with ears, a dark lining with a groove."""
    a = np.linspace(0.5, np.pi - 0.5, 18)
    outer, inner = (
        np.column_stack([0.1 * np.cos(a), 0.1 * np.sin(a)]),
        np.column_stack([0.052 * np.cos(a), 0.052 * np.sin(a)]),
    )
    shape = np.concatenate([outer, inner[::-1]]) - [0, 0.08]
    back = plate(shape, 0.006)
    ears = [at_block(0.016, 0.014, 0.006, 0.003, (s * 0.082, -0.036, 0)) for s in (-1, 1)]
    small = [0.92 * shape[k] + [0, -0.0] for k in range(36)]
    lining = plate(np.array(small), 0.011, 0.006)
    groove = at_box(0.003, 0.046, 0.0008, (0, -0.005, 0.0166))
    return [(back, metal(look, "charcoal", "silver", "red")), (lining, textures.spots(look.rng,
             (62, 58, 56), (110, 100, 90), 0.1)),
            (join(ears), dye(look, "charcoal")), (groove, DARK)]  # fmt: skip


def _rotor(look: Look) -> Pieces:
    """A brake disc lying: a broad ring, a hub with bolt holes."""
    steel = metal(look, "silver", "gray")
    ring = lathe([(0.055, 0), (0.13, 0), (0.13, 0.02), (0.055, 0.02)], 44, loop=True)
    hat = lathe([(0.03, 0), (0.068, 0), (0.066, 0.045), (0.03, 0.045)], 36, loop=True)
    holes = [
        disc(0.006, 0.001, (0.048 * np.cos(a), 0.048 * np.sin(a), 0.0446), sides=14)
        for a in np.arange(5) * 1.2566
    ]
    vents = [disc(0.0045, 0.001, (r * np.cos(a), r * np.sin(a), 0.0196), sides=10)
             for r, o in ((0.085, 0.0), (0.112,
             0.13)) for a in np.arange(12) * np.pi / 6 + o]  # fmt: skip
    return [(ring, steel), (hat, dye(look, "gray", "charcoal")), (join([*holes, *vents]), DARK)]


def _canister(look: Look) -> Pieces:
    """An oil filter: a painted can with flutes below and a print."""
    color = look.color("orange", "white", "blue", "black", "red")
    can = standing((0.034, 0), (0.038, 0.004), (0.038, 0.075), (0.033, 0.085), (0.02, 0.088))
    flutes = [
        at_box(0.004, 0.008, 0.028, (0.0365 * np.cos(a), 0.0365 * np.sin(a), 0.052))
        for a in np.arange(14) * 0.4488
    ]
    image = textures.stack(
        (textures.plain(color), 3), (textures.plain((240, 240, 238)), 1), (textures.plain(color), 5)
    )
    gasket = torus(0.03, 0.003, 30, 6).move(z=0.086)
    hole = disc(0.01, 0.001, (0, 0, 0.0876))
    return [(can, image), (join(flutes), textures.plain(color)), (gasket, DARK), (hole, DARK)]


def _panel(look: Look) -> Pieces:
    """A panel filter: a frame round pleated paper."""
    frame = plastic(look, "orange", "black", "blue", "gray")
    color = look.own_color("cream", "white", "beige")
    sides = [at_box(0.22, 0.012, 0.035, (0, s * 0.079, 0)) for s in (-1, 1)]
    ends = [at_box(0.012, 0.146, 0.035, (s * 0.104, 0, 0)) for s in (-1, 1)]
    pleats = textures.stripes([color, tuple(0.72 * c for c in color)], 16, upright=True)  # type: ignore[list-item]
    ridges = [prism(np.array([(-0.0055, 0), (0.0055, 0), (0, 0.022)]), -0.073, 0.073).turn(0,
             np.pi / 2)
              .move(-0.0915 + 0.0114 * k, 0, 0.008) for k in range(17)]  # fmt: skip
    bed = at_box(0.196, 0.146, 0.01)
    return [
        *((s, frame) for s in (*sides, *ends)),
        (bed, pleats),
        (join(ridges), textures.plain(color)),
    ]


def _piston(look: Look) -> Pieces:
    """A piston standing on its skirt, its rod leaning out, or upright with rings."""
    steel = metal(look, "silver", "gray")
    body = standing((0.036, 0), (0.038, 0.004), (0.038, 0.03), (0.0365, 0.031), (0.0365, 0.034),
             (0.038, 0.035),
                    (0.038, 0.039), (0.0365, 0.04), (0.0365, 0.043), (0.038, 0.044), (0.038,
             0.05), (0.036, 0.052), sides=32)  # fmt: skip
    rings = [torus(0.037, 0.0012, 32, 6).move(z=z) for z in (0.0325, 0.0415)]
    bosses = [disc(0.011, 0.004).turn(0, np.pi / 2).move(0, -0.0355, 0.017)]
    bore = disc(0.0075, 0.001).turn(0, np.pi / 2).move(0, -0.039, 0.017)
    return [
        (body, steel),
        (join(rings), dye(look, "charcoal")),
        (join(bosses), steel),
        (bore, DARK),
    ]


def _connecting(look: Look) -> Pieces:
    steel = metal(look, "silver", "gray", "charcoal")
    big = lathe([(0.02, 0), (0.032, 0), (0.032, 0.018), (0.02, 0.018)], 28, loop=True).move(x=-0.06)
    small = lathe([(0.01, 0), (0.018, 0), (0.018, 0.018), (0.01, 0.018)], 24, loop=True).move(
        x=0.07
    )
    beam = plate(
        [(-0.034, -0.014), (0.056, -0.009), (0.056, 0.009), (-0.034, 0.014)], 0.013, 0.0025
    )
    return [(big, steel), (small, steel), (beam, steel)]


def _crank(look: Look) -> Pieces:
    """A crankshaft lying: journals, webs with weights, pins to either side."""
    steel = metal(look, "silver", "gray", "charcoal")
    journals = [
        spindle((x, 0.016), (x + 0.034, 0.016), z=0.048)
        for x in (-0.19, -0.105, -0.02, 0.065, 0.15)
    ]
    web = np.concatenate(
        [arc((0, -0.012), 0.034, np.pi, 2 * np.pi, 10), arc((0, 0.026), 0.02, 0, np.pi, 8)]
    )
    pieces: list[Solid] = []
    pins = []
    for k, x in enumerate((-0.157, -0.072, 0.013, 0.098)):
        flip = 1 if k in (0, 3) else -1
        for dx in (0, 0.034):
            one = (
                prism(web * [1, 1] if flip > 0 else (-web), 0, 0.01)
                .turn(0, np.pi / 2)
                .turn(2, np.pi / 2)
            )
            pieces.append(one.move(x + dx, 0, 0.048))
        pins.append(spindle((x + 0.008, 0.014), (x + 0.036, 0.014), z=0.048 + flip * 0.024))
    nose = spindle((-0.225, 0.01), (-0.19, 0.012), z=0.048)
    flange = spindle((0.184, 0.03), (0.194, 0.03), z=0.048)
    return [(join(pieces), steel), (join([*journals, nose]), shine(look)), (join(pins),
             shine(look)),
            (flange, steel)]  # fmt: skip


def _cams(look: Look) -> Pieces:
    steel = metal(look, "silver", "gray", "charcoal")
    shaft = spindle((-0.18, 0.009), (0.18, 0.009), z=0.022)
    lobe = np.concatenate(
        [arc((0, 0), 0.015, np.pi * 0.9, 2.1 * np.pi, 14), [(0.006, 0.021), (-0.006, 0.021)]]
    )
    lobes = []
    for k in range(8):
        a = (0, 2.4, 3.9, 1.2)[k % 4]
        one = prism(lobe, 0, 0.013).turn(2, a).turn(0, np.pi / 2).turn(2, np.pi / 2)
        lobes.append(one.move(-0.15 + 0.04 * k, 0, 0.022))
    end = spindle((0.17, 0.024), (0.18, 0.024), sides=20, z=0.0225)
    return [(shaft, shine(look)), (join(lobes), steel), (end, steel)]


def _head(look: Look) -> Pieces:
    steel = metal(look, "silver", "gray")
    body = at_box(0.34, 0.16, 0.07)
    deck = at_box(0.32, 0.06, 0.02, (0, 0, 0.07))
    ports = [
        disc(0.02, 0.004).turn(0, np.pi / 2).move(x, -0.079, 0.035)
        for x in (-0.12, -0.04, 0.04, 0.12)
    ]
    bolts = [
        disc(0.009, 0.012, (x, s * 0.06, 0.07), sides=6)
        for x in np.linspace(-0.15, 0.15, 5)
        for s in (-1, 1)
    ]
    plugs = [disc(0.012, 0.006, (x, 0, 0.089)) for x in (-0.12, -0.04, 0.04, 0.12)]
    return [
        (body, steel),
        (deck, dye(look, "gray", "charcoal")),
        (join(ports), DARK),
        (join(bolts), shine(look)),
        (join(plugs), DARK),
    ]


_row = Rows("workbench", ("silver",)).of_drawing


CATEGORIES = (
    _row("spark_plug", _plug, (0.081, 0.021, 0.0185), 0.05, ("sparking plug", "glow plug",
             "spark plug lead"), foot=0.1),
    _row("brake_pad", _pad, (0.178, 0.0741, 0.0172), 0.35, ("brake shoe", "brake lining"),
             ("charcoal",)),
    _row("brake_disc", _rotor, (0.26, 0.26, 0.045), 3.0, ("brake rotor", "disc brake"), bodies=2),
    _row("oil_filter", _canister, (0.077, 0.077, 0.0885), 0.3, ("fuel filter", "car oil filter"),
             ("orange", "white"), bodies=1),
    _row("air_filter", _panel, (0.22, 0.17, 0.035), 0.25, ("cabin filter", "pollen filter",
             "hepa filter", "engine filter"), ("orange", "black")),
    _row("piston", _piston, (0.077, 0.078, 0.052), 0.4, ("engine piston",), bodies=1),
    _row("connecting_rod", _connecting, (0.18, 0.064, 0.018), 0.5, ("con rod", "conrod",
             "track rod end", "ball joint", "rocker arm", "rotor arm")),
    _row("crankshaft", _crank, (0.418, 0.0678, 0.0918), 4.0, ("crank shaft",), bodies=(0, 1, 3),
             foot=0.02),
    _row("camshaft", _cams, (0.36, 0.048, 0.046), 1.5, ("cam shaft", "drive shaft"),
             foot=0.05),
    _row("cylinder_head", _head, (0.34, 0.166, 0.095), 6.0, ("engine block", "engine head",
             "gearbox")),
)  # fmt: skip
"""The module's categories."""
