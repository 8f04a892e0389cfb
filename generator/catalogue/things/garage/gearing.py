"""More parts of an engine: shafts, pumps, filters, exhausts."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    at_block,
    at_box,
    disc,
    dye,
    metal,
    plastic,
    shine,
    spindle,
)
from ...build.recipes import Pieces, straight
from ...build.solids import join, lathe, prism, torus, tube
from ...surfaces import textures
from ...surfaces.look import Look
from ..rows import Rows

DARK = textures.plain((28, 28, 30))


def _carb(look: Look) -> Pieces:
    """A carburettor: a bowl, a throat with a flap, screws and a lever."""
    steel = metal(look, "silver", "gold", "gray")
    base = at_block(0.09, 0.06, 0.01, 0.008)
    bowl = at_block(0.05, 0.055, 0.045, 0.01, (-0.012, 0, 0.01))
    throat = lathe(
        [(0.018, 0), (0.026, 0), (0.026, 0.06), (0.03, 0.075), (0.024, 0.075), (0.018, 0.05)],
        26,
        loop=True,
    ).move(0.02, 0, 0.01)
    flap = disc(0.0185, 0.002, (0.02, 0, 0.045))
    lever = [
        at_block(0.01, 0.004, 0.04, 0.002, (-0.03, -0.032, 0.03)),
        straight((-0.03, -0.034, 0.06), (-0.03, -0.02, 0.06), 0.004),
    ]
    screws = [
        disc(0.004, 0.012, (x, y, 0.053), sides=10)
        for x in (-0.03, -0.005)
        for y in (-0.018, 0.018)
    ]
    pipe = straight((-0.03, 0, 0.04), (-0.06, 0, 0.045), 0.005)
    return [(base, steel), (bowl, steel), (throat, steel), (flap, shine(look, "brass")),
             (join(lever), shine(look)),
            (join(screws), shine(look, "brass")), (pipe, shine(look, "brass"))]  # fmt: skip


def _snail(look: Look) -> Pieces:
    """A turbocharger: two snail housings on one shaft."""
    pieces: Pieces = []
    for x, tile, r in (
        (-0.04, metal(look, "silver", "gray"), 0.05),
        (0.045, dye(look, "charcoal", "bronze"), 0.044),
    ):
        a = np.linspace(0, 1.9 * np.pi, 34)
        radii = np.linspace(0.008, 0.02, 34)
        path = np.column_stack([0 * a + x, r * np.cos(a), 0.07 + r * np.sin(a)])
        out = np.array(
            [
                [x, path[-1, 1] + 0.01, path[-1, 2] + 0.03],
                [x, path[-1, 1] + 0.012, path[-1, 2] + 0.055],
            ]
        )
        pieces.append((tube(np.concatenate([path, out]), [*radii, 0.02, 0.021], 12), tile))
        core = disc(r, 0.022, sides=26).turn(1, np.pi / 2).move(x - 0.011, 0, 0.07)
        pieces.append((core, tile))
    neck = straight((-0.06, 0, 0.07), (-0.09, 0, 0.07), 0.026, 20)
    hole = disc(0.02, 0.001).turn(1, np.pi / 2).move(-0.0912, 0, 0.07)
    fins = [
        at_box(0.001, 0.004, 0.036, (0, 0, -0.018)).turn(0, k).move(-0.0915, 0, 0.07)
        for k in (0, 0.79, 1.57, 2.36)
    ]
    shaft = straight((-0.03, 0, 0.07), (0.04, 0, 0.07), 0.024, 16)
    foot = at_box(0.05, 0.05, 0.03, (0.0, 0, 0))
    return [
        *pieces,
        (neck, pieces[0][1]),
        (shaft, shine(look)),
        (foot, shine(look, "charcoal")),
        (hole, DARK),
        (join(fins), shine(look)),
    ]


def _shock(look: Look) -> Pieces:
    """A shock absorber lying: a rod and a tube with a coloured spring."""
    z = 0.03
    body = spindle((-0.16, 0.012), (-0.155, 0.017), (-0.02, 0.017), (-0.015, 0.012), z=z)
    shaft = spindle((-0.02, 0.006), (0.15, 0.006), z=z)
    seats = [spindle((x, 0.028), (x + 0.006, 0.028), z=z) for x in (-0.11, 0.12)]
    t = np.linspace(0, 1, 130)
    a = 2 * np.pi * 8 * t
    coil = tube(
        np.column_stack([-0.104 + 0.224 * t, 0.0245 * np.cos(a), z + 0.0245 * np.sin(a)]), 0.0042, 7
    )
    eyes = [lathe([(0.007, 0), (0.015, 0), (0.015, 0.022), (0.007, 0.022)], 20, loop=True).turn(0,
             np.pi / 2).move(x, 0.011, z)
            for x in (-0.172, 0.164)]  # fmt: skip
    return [(body, dye(look, "black", "silver")), (shaft, shine(look)), (join(seats),
             shine(look)), (coil, plastic(look, "red", "yellow", "blue", "black")),
            (join(eyes), dye(look, "charcoal"))]  # fmt: skip


def _flywheel(look: Look) -> Pieces:
    n = 60
    a = np.arange(2 * n) * np.pi / n
    r = np.where(np.arange(2 * n) % 2, 0.125, 0.13)
    ring = prism(np.column_stack([r * np.cos(a), r * np.sin(a)]), 0, 0.014)
    steel = metal(look, "silver", "gray")
    face = lathe([(0.03, 0), (0.118, 0), (0.118, 0.026), (0.03, 0.026)], 40, loop=True)
    holes = [
        disc(0.006, 0.001, (0.042 * np.cos(t), 0.042 * np.sin(t), 0.0256), sides=12)
        for t in np.arange(6) * np.pi / 3
    ]
    return [
        (ring, dye(look, "charcoal")),
        (face, steel),
        (join(holes), DARK),
        (disc(0.0295, 0.002, (0, 0, 0.01)), DARK),
    ]


def _coil(look: Look) -> Pieces:
    body = at_block(0.04, 0.03, 0.03, 0.005, (0.06, 0, 0))
    stem = spindle((-0.09, 0.009), (-0.085, 0.012), (0.0, 0.012), (0.045, 0.01), z=0.0145)
    plug = at_block(0.02, 0.024, 0.02, 0.003, (0.088, 0, 0.004))
    lug = at_block(0.02, 0.02, 0.006, 0.008, (0.06, 0.022, 0.006))
    return [
        (body, plastic(look, "black", "charcoal", "red")),
        (stem, dye(look, "black")),
        (plug, dye(look, "gray")),
        (lug, dye(look, "black")),
    ]


def _gasket(look: Look) -> Pieces:
    """A head gasket: a thin plate with big and small holes, drawn."""
    color = look.color("charcoal", "silver", "brown", "copper")
    body = at_block(0.3, 0.12, 0.002, 0.012)
    holes = [disc(0.034, 0.0004, (x, 0, 0.0019)) for x in (-0.105, -0.035, 0.035, 0.105)]
    rims = [torus(0.035, 0.0012, 30, 5).move(x, 0, 0.0016) for x in (-0.105, -0.035, 0.035, 0.105)]
    small = [
        disc(0.005, 0.0004, (x, s * 0.05, 0.0019), sides=12)
        for x in np.linspace(-0.14, 0.14, 7)
        for s in (-1, 1)
    ]
    return [
        (body, textures.speckles(look.rng, color, 6)),
        (join([*holes, *small]), textures.plain((214, 208, 198))),
        (join(rims), shine(look, "copper", "silver")),
    ]


def _catalyst(look: Look) -> Pieces:
    steel = metal(look, "silver", "gray", "bronze")
    body = spindle(
        (-0.15, 0.024),
        (-0.11, 0.024),
        (-0.08, 0.05),
        (0.08, 0.05),
        (0.11, 0.024),
        (0.15, 0.024),
        z=0.05,
    ).scale(1, 1.3, 1)
    shield = [
        spindle((x, 0.0512), (x + 0.006, 0.0512), z=0.05).scale(1, 1.29, 1)
        for x in (-0.06, 0.0, 0.054)
    ]
    flanges = [spindle((x, 0.036), (x + 0.008, 0.036), sides=6, z=0.05) for x in (-0.15, 0.142)]
    return [(body, steel), (join(shield), steel), (join(flanges), dye(look, "charcoal"))]


def _generator(look: Look) -> Pieces:
    """An alternator: a ribbed round housing with slots, a pulley, lugs."""
    steel = metal(look, "silver", "gray")
    z = 0.07
    body = spindle((-0.05, 0.045), (-0.04, 0.06), (0.045, 0.06), (0.055, 0.045), z=z)
    band = spindle((-0.012, 0.0615), (0.018, 0.0615), z=z)
    slots = [
        at_box(0.02, 0.004, 0.012, (-0.03 if k % 2 else 0.034, 0, 0.053))
        .turn(0, 0.42 * k)
        .move(z=z)
        for k in range(15)
    ]
    pulley = [
        spindle((x, 0.028), (x + 0.004, 0.025), (x + 0.008, 0.028), z=z)
        for x in (0.062, 0.07, 0.078)
    ]
    lugs = [at_block(0.03, 0.026, 0.07, 0.008, (0, s * 0.035, 0)) for s in (-1, 1)]
    return [
        (body, steel),
        (join(lugs), steel),
        (join(pulley), dye(look, "charcoal", "silver")),
        (band, dye(look, "charcoal")),
        (join(slots), DARK),
    ]


def _pump(look: Look) -> Pieces:
    steel = metal(look, "silver", "gray", "bronze")
    body = disc(0.045, 0.04, (0, 0, 0.0))
    flange = at_block(0.12, 0.06, 0.012, 0.02)
    pulley = lathe([(0, 0), (0.05, 0), (0.046, 0.006), (0.05, 0.012), (0, 0.012)], 32).move(z=0.055)
    hub = disc(0.016, 0.02, (0, 0, 0.04))
    pipe = straight((0.03, 0, 0.022), (0.08, 0.02, 0.026), 0.013, 14)
    return [
        (flange, steel),
        (body, steel),
        (hub, shine(look)),
        (pulley, dye(look, "charcoal", "silver")),
        (pipe, steel),
    ]


_row = Rows("workbench", ("silver",)).of_drawing


CATEGORIES = (
    _row("carburettor", _carb, (0.108, 0.06, 0.085), 0.7, ("carburetor", "throttle body",
             "fuel injector", "carb"), bodies=3),
    _row("turbocharger", _snail, (0.163, 0.149, 0.135), 3.0, ("turbo", "supercharger"), bodies=7),
    _row("shock_absorber", _shock, (0.36, 0.058, 0.058), 1.5, ("damper", "car shock",
             "suspension strut", "coilover"), ("red",), 0.08),
    _row("flywheel", _flywheel, (0.27, 0.27, 0.0277), 4.0, ("fly wheel", "clutch disc",
             "clutch plate"), bodies=2),
    _row("ignition_coil", _coil, (0.187, 0.0467, 0.0298), 0.2, ("coil pack",), ("black",), 0.05),
    _row("gasket", _gasket, (0.3, 0.12, 0.0028), 0.1, ("head gasket", "engine gasket",
             "rubber gasket"), ("charcoal",), bodies=1),
    _row("catalytic_converter", _catalyst, (0.288, 0.127, 0.0971), 2.5, ("exhaust", "silencer",
             "muffler", "exhaust pipe"), foot=0.06),
    _row("alternator", _generator, (0.14, 0.125, 0.132), 4.0, ("car alternator", "starter motor"),
             bodies=3),
    _row("water_pump", _pump, (0.144, 0.0993, 0.0666), 1.2, ("fuel pump", "coolant pump",
             "oil pump"),
             bodies=4),
)  # fmt: skip
"""The module's categories."""
