"""Curios and decoration: ships in bottles, little houses, signs, stones in sand, urns."""

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
    plate,
    spindle,
    wood,
)
from ...build.outlines import rectangle, smooth
from ...build.recipes import Pieces, standing_plate, straight
from ...build.solids import join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.look import Look
from ..rows import Rows

WHITE = textures.plain((244, 242, 238))


def _ship(look: Look) -> Pieces:
    """A bottle on its side on a stand; inside, seen through its glass, a sailing ship."""
    stand = [at_box(0.014, 0.09, 0.022, (x, 0, 0)) for x in (-0.06, 0.05)]
    z = 0.06
    floor = plate(rectangle(0.14, 0.07, 0.03), 0.012, z - 0.026)
    hull = hull_solid(
        [
            (x, y, h)
            for x, w, h in (
                (-0.05, 0.012, z - 0.004),
                (-0.035, 0.006, z - 0.02),
                (0.03, 0.006, z - 0.02),
                (0.055, 0.002, z - 0.002),
                (-0.05, 0.01, z + 0.004),
            )
            for y in (-w, w)
        ]
    )
    masts = [straight((x, 0, z - 0.004), (x, 0, z + 0.034), 0.0013, 6) for x in (-0.03, 0.0, 0.028)]
    sails = [
        at_box(0.002, w, 0.013, (x, 0, z + h))
        for x in (-0.028, 0.002, 0.03)
        for w, h in ((0.034, 0.002), (0.026, 0.018))
    ]
    hoops = [
        torus(r, 0.0016, 32, 5).turn(1, np.pi / 2).move(x, 0, z)
        for x, r in ((-0.075, 0.036), (-0.03, 0.044), (0.03, 0.044), (0.075, 0.036))
    ]
    spines = [
        tube(
            smooth(
                [
                    (-0.088, 0.018 * np.cos(a), z + 0.018 * np.sin(a)),
                    (-0.07, 0.04 * np.cos(a), z + 0.04 * np.sin(a)),
                    (0.0, 0.044 * np.cos(a), z + 0.044 * np.sin(a)),
                    (0.06, 0.042 * np.cos(a), z + 0.042 * np.sin(a)),
                    (0.095, 0.016 * np.cos(a), z + 0.016 * np.sin(a)),
                ],
                5,
            ),
            0.0011,
            5,
        )
        for a in np.arange(10) * 0.6283
    ]
    neck = [
        lathe([(0.012, 0), (0.016, 0), (0.014, 0.045), (0.017, 0.05), (0.012, 0.05)], 20, loop=True)
        .turn(1, np.pi / 2)
        .move(0.094, 0, z)
    ]
    cork = spindle((0.138, 0.0115), (0.158, 0.013), z=z)
    back = (
        lathe([(0.0, 0), (0.03, 0), (0.034, 0.006), (0, 0.006)], 26)
        .turn(1, np.pi / 2)
        .move(-0.09, 0, z)
    )
    glass = textures.plain((190, 220, 216))
    return [
        (join([*hoops, *spines]), glass),
        (join(neck), glass),
        (join([back]), glass),
        (stand[0], wood(look, "brown", "wooden")),
        (stand[1], wood(look, "brown", "wooden")),
        (cork, dye(look, "tan")),
        (floor, textures.plain((60, 130, 180))),
        (hull, plastic(look, "brown", "red", "navy")),
        (join(masts), dye(look, "brown")),
        (join(sails), WHITE),
    ]


def _house(look: Look) -> Pieces:
    """A little house: walls with windows and a door, a tiled roof, a chimney."""
    color = look.color("cream", "pink", "sky", "yellow", "white", "terracotta")
    front = prints.canvas(96, 80, color)
    for x in (0.12, 0.66):
        for y in (0.1, 0.52):
            prints.fill(front, x, y, 0.22, 0.3, (250, 250, 246))
            prints.fill(front, x + 0.02, y + 0.03, 0.18, 0.24, (110, 150, 190))
            prints.fill(front, x + 0.1, y, 0.02, 0.3, (250, 250, 246))
    prints.fill(front, 0.41, 0.48, 0.18, 0.52, (120, 60, 44))
    body = at_box(0.11, 0.09, 0.085, (0, 0, 0.006))
    roof = standing_plate([(-0.065, 0.088), (0.065, 0.088), (0, 0.14)], 0.104)
    chimney = at_box(0.016, 0.016, 0.045, (0.032, 0.015, 0.11))
    face = at_box(0.11, 0.001, 0.085, (0, -0.0452, 0.006))
    plain = textures.plain(color)
    return [
        (at_block(0.14, 0.12, 0.006, 0.004), dye(look, "green", "sage")),
        (body, plain),
        (roof, dye(look, "terracotta", "charcoal", "brown", "teal")),
        (chimney, dye(look, "terracotta", "brown")),
        (face, front),
    ]


def _dollhouse(look: Look) -> Pieces:
    """A doll's house with an open front: two floors, four rooms, a pitched roof."""
    tile = plastic(look, "pink", "white", "sky", "cream", "mint")
    x, y, h = 0.26, 0.13, 0.2
    walls = [at_box(0.006, y, h, (s * (x / 2 - 0.003), 0, 0.006)) for s in (-1, 1)]
    middle = at_box(0.005, y - 0.01, h, (0.02, 0, 0.006))
    floors = [at_box(x, y, 0.006, (0, 0, z)) for z in (0, 0.1, 0.2)]
    back = at_box(x, 0.005, h, (0, y / 2 - 0.0025, 0.006))
    roof = [
        at_box(0.165, y + 0.02, 0.007).turn(1, s * 0.62).move(s * 0.067, 0, 0.25) for s in (-1, 1)
    ]
    gable = standing_plate([(-0.13, 0.206), (0.13, 0.206), (0, 0.297)], 0.005, y / 2 - 0.003)
    bed = [
        at_box(0.07, 0.05, 0.018, (-0.075, 0.02, 0.106)),
        at_box(0.006, 0.05, 0.035, (-0.108, 0.02, 0.106)),
    ]
    table = [disc(0.026, 0.003, (-0.06, -0.01, 0.036)), disc(0.004, 0.03, (-0.06, -0.01, 0.006))]
    sofa = [
        at_box(0.06, 0.026, 0.018, (0.075, 0.035, 0.006)),
        at_box(0.06, 0.008, 0.036, (0.075, 0.05, 0.006)),
    ]
    shelf = at_box(0.04, 0.018, 0.06, (0.08, 0.05, 0.106))
    return [
        *((w, tile) for w in walls),
        *((f, wood(look, "wooden")) for f in floors),
        (back, dye(look, "cream", "pink", "mint")),
        *((r, dye(look, "terracotta", "purple", "red", "teal")) for r in roof),
        (middle, tile),
        (gable, tile),
        (join(bed), dye(look, "red", "purple", "blue")),
        (join(table), dye(look, "wooden", "white")),
        (join(sofa), dye(look, "teal", "yellow", "orange")),
        (shelf, dye(look, "brown", "wooden")),
    ]


def _castle(look: Look) -> Pieces:
    """A castle: four round towers with cones, walls with battlements, a gate."""
    stone = plastic(look, "gray", "beige", "tan", "pink")
    base = at_block(0.19, 0.19, 0.006, 0.01)
    towers, roofs = [], []
    for x in (-0.07, 0.07):
        for y in (-0.07, 0.07):
            towers.append(disc(0.022, 0.1, (x, y, 0.006)))
            roofs.append(disc(0.027, 0.045, (x, y, 0.106), top=0.0008))
    walls = [at_box(0.13, 0.012, 0.06, (0, s * 0.07, 0.006)) for s in (-1, 1)] + [
        at_box(0.012, 0.13, 0.06, (s * 0.07, 0, 0.006)) for s in (-1, 1)
    ]
    teeth = [
        at_box(0.01, 0.012, 0.01, (x, s * 0.07, 0.066))
        for s in (-1, 1)
        for x in (-0.04, -0.016, 0.016, 0.04)
    ]
    keep = at_box(0.06, 0.06, 0.1, (0, 0.01, 0.006))
    more = [
        at_box(0.012, 0.012, 0.012, (x, y, 0.106)) for x in (-0.024, 0.024) for y in (-0.014, 0.034)
    ]
    gate = at_box(0.03, 0.014, 0.036, (0, -0.0705, 0.006))
    flag = [
        straight((0, 0.01, 0.105), (0, 0.01, 0.16), 0.0015, 6),
        at_box(0.03, 0.0015, 0.018, (0.015, 0.01, 0.14)),
    ]
    return [
        (base, dye(look, "green", "gray")),
        *((t, stone) for t in towers),
        *((w, stone) for w in walls),
        (keep, stone),
        (join(roofs), dye(look, "blue", "red", "purple")),
        (join([*teeth, *more]), stone),
        (gate, dye(look, "brown")),
        (join(flag), dye(look, "red", "yellow")),
    ]


def _message(look: Look) -> Pieces:
    """A corked bottle lying with a rolled paper inside."""
    z = 0.034
    glass = textures.plain((168, 206, 190))
    hoops = [
        torus(r, 0.0016, 28, 5).turn(1, np.pi / 2).move(x, 0, z)
        for x, r in ((-0.088, 0.03), (-0.03, 0.033), (0.03, 0.033))
    ]
    wires = [
        tube(
            smooth(
                [
                    (-0.09, 0.03 * np.cos(a), z + 0.03 * np.sin(a)),
                    (0.0, 0.033 * np.cos(a), z + 0.033 * np.sin(a)),
                    (0.04, 0.032 * np.cos(a), z + 0.032 * np.sin(a)),
                    (0.07, 0.013 * np.cos(a), z + 0.013 * np.sin(a)),
                    (0.11, 0.012 * np.cos(a), z + 0.012 * np.sin(a)),
                ],
                5,
            ),
            0.0012,
            5,
        )
        for a in np.arange(9) * 0.698
    ]
    base = spindle((-0.09, 0.03), (-0.087, 0.032), z=z)
    lip = torus(0.0125, 0.003, 22, 6).turn(1, np.pi / 2).move(0.11, 0, z)
    scroll = spindle((-0.06, 0.014), (0.05, 0.014), z=0.018)
    tie = spindle((-0.01, 0.0148), (0.0, 0.0148), z=0.018)
    cork = spindle((0.1, 0.011), (0.13, 0.0125), z=z)
    foot = at_box(0.12, 0.03, 0.003)
    return [
        (join([*hoops, *wires]), glass),
        (base, glass),
        (cork, dye(look, "tan")),
        (foot, glass),
        (lip, glass),
        (scroll, textures.spots(look.rng, look.color("cream", "beige"), (176, 146, 102), 0.05)),
        (tie, dye(look, "crimson")),
    ]


_row = Rows("living", ("red", "blue")).of_shape


CATEGORIES = (
    _row("ship_in_a_bottle", of(_ship, bodies=6), (0.25, 0.092, 0.106), 0.4, ("ship in bottle",
             "bottled ship", "bottle ship", "boat in a bottle"), ("brown",), ("big",)),
    _row("message_in_a_bottle", of(_message, 0.03, bodies=4), (0.22, 0.068, 0.068), 0.3,
             ("message in bottle", "letter in a bottle", "bottle message"), ("cream",)),
    _row("miniature_house", of(_house, bodies=4), (0.14, 0.12, 0.155), 0.3, ("toy house",
             "model house", "house model", "house", "cottage", "little house", "ceramic house",
             "wooden house", "village house", "cabin", "log cabin model"),
             ("cream", "pink")),
    _row("dollhouse", of(_dollhouse, bodies=8), (0.29, 0.15, 0.3), 1.2, ("doll house",
             "doll's house", "dolls house", "barbie house"), ("pink",), ("big", "tall")),
    _row("toy_castle", of(_castle, bodies=10), (0.19, 0.19, 0.16), 0.4, ("castle model",
             "toy fort", "toy fortress", "sand castle", "sandcastle"), ("gray",),
             ("big",)),
)  # fmt: skip
"""The module's categories."""
