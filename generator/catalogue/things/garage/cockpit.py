"""More parts of a car: caps, gauges, pumps, fobs, belts."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    at_block,
    at_box,
    cloth,
    disc,
    dye,
    metal,
    plastic,
    plate,
    shine,
    words,
)
from ...build.recipes import Pieces, rod, straight
from ...build.solids import join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


def _cap(look: Look) -> Pieces:
    body = disc(0.03, 0.022)
    ribs = [
        at_box(0.003, 0.004, 0.02, (0.03 * np.cos(a), 0.03 * np.sin(a), 0.001))
        for a in np.arange(18) * 0.349
    ]
    grip = at_block(0.05, 0.012, 0.012, 0.004, (0, 0, 0.021))
    tile = plastic(look, "black", "charcoal", "yellow", "silver")
    return [(body, tile), (grip, tile), (join(ribs), tile)]


def _dipstick(look: Look) -> Pieces:
    wire = rod([(-0.2, 0, 0.002), (0.1, 0, 0.002), (0.15, 0, 0.003)], 0.0018, 6)
    blade = at_box(0.06, 0.006, 0.0022, (-0.2, 0, 0))
    marks = [at_box(0.0015, 0.006, 0.0006, (x, 0, 0.0021)) for x in (-0.215, -0.19)]
    ring = torus(0.018, 0.004, 24, 8).move(0.17, 0, 0.004)
    return [
        (ring, plastic(look, "yellow", "orange", "red")),
        (wire, shine(look)),
        (blade, shine(look)),
        (join(marks), BLACK),
    ]


def _jug(look: Look) -> Pieces:
    """A can of engine oil: a flat bottle with a handle, a cap and a label."""
    color = look.color("black", "gold", "blue", "red", "green", "silver")
    body = at_block(0.12, 0.065, 0.15, 0.016)
    shoulder = at_block(0.11, 0.06, 0.03, 0.02, (0, 0, 0.148))
    neck, cap = disc(0.016, 0.025, (0.032, 0, 0.175)), disc(0.019, 0.022, (0.032, 0, 0.19))
    grip = rod([(-0.045, 0, 0.17), (-0.045, 0, 0.195), (-0.01, 0, 0.2), (0.02, 0, 0.185)], 0.009, 8)
    tile = look.surface(color)
    tag = prints.canvas(96, 96, tint_color(color, 1.7))
    prints.fill(tag, 0, 0.12, 1, 0.34, (200, 44, 40))
    prints.write(tag, "OIL", 0.5, 0.29, 0.26, (250, 250, 246), True)
    prints.write(tag, look.pick(["5W-30", "10W-40", "0W-20"]), 0.5, 0.66, 0.17, (30, 30, 34), True)
    front = at_box(0.09, 0.001, 0.1, (0, -0.0328, 0.025))
    return [
        (body, tile),
        (shoulder, tile),
        (join([neck, cap]), dye(look, "red", "black", "yellow")),
        (grip, tile),
        (front, tag),
    ]


def _horn(look: Look) -> Pieces:
    tile = metal(look, "black", "red", "silver")
    body = disc(0.045, 0.03)
    ring = [torus(0.045, 0.004, 30, 6).move(z=z) for z in (0.005, 0.026)]
    bell = (
        lathe([(0.012, 0), (0.016, 0.03), (0.04, 0.06), (0.037, 0.06), (0.01, 0.03)], 24, loop=True)
        .turn(1, np.pi / 2)
        .move(0.035, 0, 0.04)
    )
    slits = [
        at_box(0.06 - 0.01 * abs(k), 0.004, 0.001, (0, 0.014 * k, 0.0298))
        for k in (-2, -1, 0, 1, 2)
    ]
    return [(body, tile), (bell, tile), (join(ring), shine(look)), (join(slits), BLACK)]


def _fuse(look: Look) -> Pieces:
    body = at_block(0.019, 0.005, 0.012, 0.0015, (0, 0, 0)).turn(0, np.pi / 2).move(z=0.0025)
    body = body.move(z=-float(body.bounds[0, 2]))
    y = float(body.bounds[0, 1])
    legs = [
        at_box(0.0055, 0.009, 0.001, (s * 0.006, y - 0.0035 + 0.012 * 0, 0.002)) for s in (-1, 1)
    ]
    return [
        (body, plastic(look, "red", "blue", "yellow", "green", "orange", "tan")),
        (join(legs), shine(look)),
    ]


def _tree(look: Look) -> Pieces:
    """A hanging air freshener: a paper fir tree with a string."""
    color = look.color("green", "blue", "yellow", "red", "pink", "black")
    half = [
        (0.008, 0),
        (0.008, 0.012),
        (0.034, 0.012),
        (0.02, 0.036),
        (0.028, 0.036),
        (0.014, 0.06),
        (0.02, 0.06),
        (0.0, 0.092),
    ]
    outline = [*half, *[(-x, y) for x, y in half[-2::-1]]]
    body = plate(outline, 0.002)
    loop = rod(
        [
            (0, 0.088, 0.001),
            (0.016, 0.115, 0.001),
            (0, 0.14, 0.001),
            (-0.016, 0.115, 0.001),
            (0, 0.088, 0.001),
        ],
        0.0008,
        5,
        5,
    )
    mark = at_box(0.034, 0.014, 0.0006, (0, 0.03, 0.0018))
    return [
        (body, textures.speckles(look.rng, color, 4)),
        (loop, textures.plain((236, 232, 224))),
        (mark, words(look.pick(["PINE", "FRESH", "VANILLA"]), (250, 250, 246), (40, 40, 44), 0.5)),
    ]


def _navigator(look: Look) -> Pieces:
    """A navigation device on its foot, a map on its screen."""
    image = prints.canvas(128, 80, (206, 222, 196))
    for path in (
        [(0.0, 0.8), (0.4, 0.55), (1, 0.5)],
        [(0.2, 0), (0.35, 0.5), (0.3, 1)],
        [(0.7, 0), (0.75, 0.5), (0.95, 1)],
    ):
        prints.stroke(image, path, 0.06, (250, 250, 246))
    prints.stroke(image, [(0.5, 1), (0.5, 0.55), (0.75, 0.5), (0.72, 0)], 0.07, (220, 60, 160))
    prints.polygon(image, [(0.5, 0.7), (0.57, 0.92), (0.43, 0.92)], (40, 100, 220))
    prints.fill(image, 0, 0, 1, 0.16, (34, 60, 110))
    body = at_block(0.13, 0.08, 0.016, 0.01).turn(0, 1.25)
    face = at_box(0.114, 0.066, 0.001, (0, 0, 0.0158)).turn(0, 1.25)
    low = float(body.bounds[0, 2])
    arm = rod([(0, 0.02, 0.04), (0, 0.05, 0.03), (0, 0.06, 0.01)], 0.008, 10)
    cup = disc(0.03, 0.01, (0, 0.06, 0), top=0.02)
    shell = plastic(look, "black", "charcoal", "silver")
    return [(body.move(z=-low), shell), (arm, shell), (cup, shell), (face.move(z=-low), image)]


def _dice(look: Look) -> Pieces:
    """A pair of plush dice on a string."""
    color = look.color("red", "pink", "black", "white", "blue")
    ink = (240, 240, 238) if sum(color) < 500 else (30, 30, 32)
    face = prints.pips(5, color, ink)  # type: ignore[arg-type]
    cubes = [
        at_box(0.07, 0.07, 0.07).turn(2, a).move(x, y)
        for a, x, y in ((0.3, -0.055, 0), (0.8, 0.055, 0.02))
    ]
    cord = rod(
        [
            (-0.055, 0, 0.07),
            (-0.03, 0.06, 0.03),
            (0, 0.09, 0.002),
            (0.03, 0.08, 0.03),
            (0.055, 0.02, 0.07),
        ],
        0.0015,
        6,
        5,
    )
    return [*((c, face) for c in cubes), (cord, textures.plain((240, 236, 226)))]


def _fob(look: Look) -> Pieces:
    shell = plastic(look, "black", "charcoal", "silver")
    body = at_block(0.07, 0.036, 0.014, 0.014)
    keys = [at_block(0.012, 0.02, 0.002, 0.004, (x, 0, 0.0135)) for x in (-0.012, 0.004, 0.02)]
    ring = torus(0.013, 0.0016, 24, 6).move(-0.046, 0, 0.0018)
    blade = at_box(0.035, 0.009, 0.0025, (0.05, 0, 0.005))
    return [
        (body, shell),
        (join(keys), dye(look, "gray", "silver")),
        (join([ring, blade]), shine(look)),
    ]


def _buckle(look: Look) -> Pieces:
    webbing = cloth(look, "black", "charcoal", "red", "beige")
    belt = [
        at_box(0.12, 0.046, 0.003, (-0.1, 0, 0.006)),
        at_box(0.12, 0.046, 0.003, (0.115, 0, 0.006)),
    ]
    box = at_block(0.065, 0.055, 0.022, 0.008, (0.03, 0, 0))
    tongue = at_block(0.05, 0.05, 0.007, 0.006, (-0.035, 0, 0.004))
    button = at_block(0.018, 0.034, 0.003, 0.003, (0.014, 0, 0.021))
    return [
        (box, BLACK),
        (tongue, shine(look)),
        (join(belt), webbing),
        (button, textures.plain((206, 40, 38))),
    ]


def _strap(look: Look) -> Pieces:
    """A ratchet strap: webbing wound in a roll, a steel ratchet at its end."""
    color = look.color("orange", "blue", "yellow", "red", "green")
    a = np.linspace(0, 2 * np.pi * 5, 120)
    r = 0.014 + 0.0032 * a / (2 * np.pi) * 1.3
    roll = [disc(0.038, 0.035)]
    spiral = tube(np.column_stack([r * np.cos(a), r * np.sin(a), 0 * a + 0.0352]), 0.0009, 4)
    tail = at_box(0.1, 0.003, 0.034, (0.05, -0.0365, 0))
    frame = [at_box(0.1, 0.004, 0.03, (0.13, y - 0.03, 0)) for y in (0.0, 0.03)]
    drum = straight((0.14, -0.034, 0.015), (0.14, 0.004, 0.015), 0.012, 12)
    grip = at_block(0.03, 0.04, 0.026, 0.006, (0.185, -0.015, 0.002))
    return [
        (roll[0], textures.speckles(look.rng, color, 6)),
        (tail, textures.plain(color)),
        (join([*frame, drum]), shine(look)),
        (grip, BLACK),
        (spiral, textures.plain(tint_color(color, 0.5))),
    ]


def _badge(look: Look) -> Pieces:
    """A round paper disc in a clear holder."""
    image = prints.canvas(64, 64, look.color("blue", "green", "red", "purple"))
    prints.disc(image, 0.5, 0.5, 0.36, (244, 240, 226))
    prints.write(
        image, look.pick(["JUN 12", "MAR 09", "SEP 14"]), 0.5, 0.5, 0.2, (30, 30, 34), True
    )
    return [(disc(0.038, 0.0016, sides=36), image)]


_row = Rows("workbench", ("black",)).of_drawing


CATEGORIES = (
    _row("filler_cap", _cap, (0.0616, 0.0617, 0.0323), 0.06, ("petrol cap", "radiator cap",
             "fuel cap", "gas cap", "distributor cap", "oil cap", "oil filler cap", "tank cap"),
             bodies=2),
    _row("dipstick", _dipstick, (0.42, 0.044, 0.008), 0.05, ("oil dipstick",), ("yellow",),
             roles=("flat", "big")),
    _row("engine_oil", _jug, (0.12, 0.066, 0.212), 0.95, ("bottle of engine oil", "motor oil",
             "engine oil bottle", "bottle of motor oil", "antifreeze", "coolant bottle",
             "screen wash", "can of engine oil", "jerry can", "petrol can", "fuel can"), ("black",
             "gold")),
    _row("car_horn", _horn, (0.149, 0.101, 0.0827), 0.4, ("air horn",), ("black",
             "red"), bodies=2),
    _row("car_fuse", _fuse, (0.019, 0.02, 0.005), 0.002, ("blade fuse",
             "electrical fuse"), ("red", "blue")),
    _row("car_air_freshener", _tree, (0.0662, 0.137, 0.00233), 0.004, (
             "tree air freshener", "hanging air freshener"), ("green",), roles=("flat",)),
    _row("sat_nav", _navigator, (0.133, 0.12, 0.0812), 0.2, ("satnav", "gps", "navigation device",
             "gps device", "navigator"), bodies=3),
    _row("fuzzy_dice", _dice, (0.209, 0.141, 0.0734), 0.1, ("car mirror dice", "furry dice",
             "fluffy dice", "dice for a car mirror", "plush dice"), ("red", "pink"), bodies=2),
    _row("key_fob", _fob, (0.128, 0.036, 0.0155), 0.05, ("car key fob", "remote key", "car fob",
             "car key remote"), bodies=1),
    _row("seat_belt_buckle", _buckle, (0.335, 0.055, 0.024), 0.2, ("seatbelt buckle", "seat belt",
             "seatbelt", "safety belt"), roles=("flat",)),
    _row("ratchet_strap", _strap, (0.24, 0.078, 0.036), 0.5, ("tie down strap", "cargo strap",
             "lashing strap"), ("orange",)),
    _row("tax_disc", _badge, (0.076, 0.076, 0.0016), 0.002, ("parking disc", "parking permit"),
             ("blue",), roles=("flat",)),
)  # fmt: skip
"""The module's categories."""
