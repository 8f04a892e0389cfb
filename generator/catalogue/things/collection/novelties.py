"""Toys of the shops: figures, guns, gadgets for fingers, boxes with surprises."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    PAINTS,
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    of,
    plastic,
    plate,
    shine,
    spindle,
    standing,
)
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join, prism, torus
from ...surfaces import textures
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


def _brickman(look: Look) -> Pieces:
    """A small jointed brick figure."""
    shirt, trousers = plastic(look, *PAINTS), dye(look, "blue", "black", "gray", "green", "red")
    yellow = textures.plain((246, 206, 70))
    legs = [at_box(0.0075, 0.008, 0.0135, (s * 0.0041, 0, 0)) for s in (-1, 1)]
    hips = at_box(0.016, 0.008, 0.004, (0, 0, 0.0135))
    body = prism(
        np.array([(-0.008, 0.0175), (0.008, 0.0175), (0.0062, 0.03), (-0.0062, 0.03)]),
        -0.004,
        0.004,
    ).turn(0, np.pi / 2)
    arms = [
        rod(
            [(s * 0.0068, 0, 0.028), (s * 0.0105, -0.001, 0.023), (s * 0.0112, -0.006, 0.0175)],
            0.0024,
            8,
        )
        for s in (-1, 1)
    ]
    hands = [torus(0.0022, 0.0012, 12, 5).move(s * 0.0113, -0.008, 0.0165) for s in (-1, 1)]
    head = [disc(0.0051, 0.0085, (0, 0, 0.0305)), disc(0.0025, 0.002, (0, 0, 0.0388))]
    face = [ball(0.0014, 0.0008, 0.0014, (s * 0.0019, -0.0049, 0.036), 8) for s in (-1, 1)]
    face.append(at_box(0.0036, 0.0006, 0.0007, (0, -0.0051, 0.0328)))
    return [
        (join([*legs, hips]), trousers),
        (body, shirt),
        (join(arms), shirt),
        (join(head), yellow),
        (join(hands), yellow),
        (join(face), BLACK),
    ]


def _bighead(look: Look) -> Pieces:
    """A collector's figure with a huge square head and black eyes, on a base."""
    hair, shirt = plastic(look, "black", "brown", "red", "yellow", "purple"), dye(look, *PAINTS)
    skin = dye(look, "beige", "tan", "brown")
    base = disc(0.032, 0.004)
    legs = [at_block(0.013, 0.014, 0.018, 0.005, (s * 0.009, 0, 0.004)) for s in (-1, 1)]
    body = at_block(0.03, 0.02, 0.022, 0.008, (0, 0, 0.02))
    arms = [rod([(s * 0.015, 0, 0.038), (s * 0.021, -0.003, 0.026)], 0.0055, 8) for s in (-1, 1)]
    head = at_block(0.056, 0.048, 0.042, 0.018, (0, 0, 0.041))
    top = at_block(0.06, 0.05, 0.018, 0.02, (0, 0.002, 0.073))
    back = at_block(0.058, 0.02, 0.032, 0.009, (0, 0.018, 0.046))
    eyes = [ball(0.011, 0.004, 0.012, (s * 0.014, -0.0235, 0.058), 12) for s in (-1, 1)]
    nose = ball(0.006, 0.005, 0.005, (0, -0.0245, 0.051), 8)
    return [
        (base, BLACK),
        (join(legs), dye(look, "navy", "black", "brown")),
        (body, shirt),
        (head, skin),
        (top, hair),
        (back, hair),
        (join(arms), shirt),
        (join(eyes), BLACK),
        (nose, skin),
    ]


def _nodder(look: Look) -> Pieces:
    """A figure with a big head on a spring."""
    base = disc(0.034, 0.01)
    shirt = plastic(look, *PAINTS)
    legs = [standing((0.008, 0.01), (0.009, 0.04)).move(x=s * 0.01) for s in (-1, 1)]
    body = standing((0.018, 0.038), (0.02, 0.05), (0.016, 0.068), (0.006, 0.072)).scale(1, 0.75, 1)
    arms = [
        rod(
            [(s * 0.016, 0, 0.066), (s * 0.026, -0.006, 0.052), (s * 0.018, -0.016, 0.046)],
            [0.006, 0.0055, 0.005],
            8,
        )
        for s in (-1, 1)
    ]
    neck = standing((0.005, 0.07), (0.005, 0.08))
    head = ball(0.05, 0.048, 0.056, (0, 0, 0.104), 20)
    cap = ball(0.053, 0.051, 0.036, (0, 0.002, 0.118), 18)
    brim = disc(0.02, 0.003, (0, -0.02, 0.113))
    eyes = [ball(0.008, 0.004, 0.009, (s * 0.01, -0.022, 0.105), 10) for s in (-1, 1)]
    grin = ball(0.018, 0.004, 0.005, (0, -0.0215, 0.091), 10)
    skin = dye(look, "beige", "tan", "brown")
    return [
        (base, BLACK),
        (join(legs), dye(look, "white", "navy", "gray")),
        (body, shirt),
        (neck, skin),
        (head, skin),
        (cap, shirt),
        (brim, shirt),
        (join(arms), skin),
        (join(eyes), BLACK),
        (grin, dye(look, "crimson")),
    ]


def _gun(tank: bool, colors: tuple[str, ...]) -> Drawing:
    """A toy gun lying on its side: bright, with an orange tip or a water tank."""

    def draw(look: Look) -> Pieces:
        tile, other = plastic(look, *colors), dye(look, "orange", "yellow", "black")
        side = np.array([(-0.08, 0.0), (0.07, 0.0), (0.07, 0.034), (-0.075, 0.038)])
        frame = plate(side, 0.028)
        grip = plate(
            [(-0.075, -0.07), (-0.04, -0.075), (-0.025, 0.005), (-0.078, 0.01)], 0.026, 0.001
        )
        barrel = straight((0.06, 0.018, 0.0145), (0.115, 0.018, 0.0145), 0.01, 14)
        tip = straight((0.105, 0.018, 0.0145), (0.125, 0.018, 0.0145), 0.013, 14)
        guard = rod(
            [
                (-0.028, -0.002, 0.014),
                (-0.02, -0.028, 0.014),
                (0.01, -0.026, 0.014),
                (0.016, 0.002, 0.014),
            ],
            0.0035,
            6,
        )
        trigger = at_block(0.006, 0.018, 0.008, 0.002, (-0.008, -0.01, 0.01))
        pieces: Pieces = [
            (frame, tile),
            (grip, tile),
            (barrel, other),
            (tip, other),
            (join([guard, trigger]), other),
        ]
        if tank:
            pieces.append(
                (
                    spindle(
                        (-0.05, 0.012), (-0.045, 0.02), (0.0, 0.02), (0.006, 0.012), z=0.0205
                    ).move(y=0.056),
                    textures.plain((150, 206, 236)),
                )
            )
            pieces.append((at_block(0.02, 0.014, 0.016, 0.004, (-0.022, 0.04, 0.006)), other))
        else:
            lines = [
                at_box(0.004, 0.022, 0.001, (-0.05 + 0.012 * k, 0.018, 0.0276)) for k in range(4)
            ]
            stripe = at_box(0.06, 0.008, 0.001, (0.03, 0.018, 0.0276))
            pieces += [(join(lines), BLACK), (stripe, other)]
        return pieces

    return draw


def _spinner(look: Look) -> Pieces:
    """Three round lobes with rings round a hub."""
    tile = plastic(look, *PAINTS, "black", "silver")
    lobes = [
        disc(0.0165, 0.009, (0.026 * np.cos(a), 0.026 * np.sin(a), 0))
        for a in np.pi / 2 + np.arange(3) * 2.0944
    ]
    core = disc(0.019, 0.009)
    webs = [
        at_block(0.03, 0.016, 0.009, 0.004, (0.013, 0, 0)).turn(2, a)
        for a in np.pi / 2 + np.arange(3) * 2.0944
    ]
    rings = [
        torus(0.0105, 0.0018, 22, 6).move(0.026 * np.cos(a), 0.026 * np.sin(a), 0.009)
        for a in np.pi / 2 + np.arange(3) * 2.0944
    ]
    wells = [
        disc(0.009, 0.0006, (0.026 * np.cos(a), 0.026 * np.sin(a), 0.0088))
        for a in np.pi / 2 + np.arange(3) * 2.0944
    ]
    hub = disc(0.0115, 0.004, (0, 0, 0.0085))
    return [
        (join([*lobes, core, *webs]), tile),
        (join(rings), shine(look)),
        (hub, shine(look)),
        (join(wells), BLACK),
    ]


_row = Rows("toys", ("red", "blue")).of_shape


CATEGORIES = (
    _row("lego_figure", of(_brickman, bodies=4), (0.0297, 0.0167, 0.0412), 0.004, ("minifigure",
             "lego minifigure", "lego man", "minifig", "brick figure", "lego person")),
    _row("vinyl_figure", of(_bighead, bodies=7), (0.064, 0.064, 0.09), 0.1, ("funko pop", "funko",
             "collectible figure", "pop figure", "funko figure", "anime figure"), ("black",)),
    _row("bobblehead", of(_nodder, bodies=8), (0.0696, 0.0757, 0.139), 0.15, ("bobble head",
             "nodding figure", "bobblehead figure")),
    _row("toy_gun", of(_gun(False, ("blue", "yellow", "green", "orange", "black"))), (0.205,
             0.113, 0.029), 0.15, ("nerf gun", "cap gun", "popgun", "pop gun", "toy pistol",
             "toy blaster", "blaster", "ray gun", "laser gun", "nerf blaster", "dart gun"),
             ("blue", "orange")),
    _row("water_pistol", of(_gun(True, ("green", "blue", "pink", "yellow", "orange"))), (0.205,
             0.15, 0.041), 0.12, ("water gun", "squirt gun", "super soaker"), ("green", "blue")),
    _row("fidget_spinner", of(_spinner, bodies=1), (0.078, 0.068, 0.0125), 0.05,
             ("hand spinner",), roles=("flat",)),
)  # fmt: skip
"""The module's categories."""
