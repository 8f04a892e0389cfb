"""Lecterns, boards for ironing, lines and pods for washing, small chairs."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    hull_solid,
    plastic,
    plate,
    shine,
    spindle,
    wood,
)
from ...build.recipes import Pieces, ball, pad, rod, straight
from ...build.solids import join, torus
from ...surfaces import prints, textures
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


def _lectern(look: Look) -> Pieces:
    """A tabletop lectern: a slanting top with a lip on a closed base."""
    tile = wood(look, "brown", "wooden", "black", "maroon")
    base = at_block(0.3, 0.22, 0.02, 0.006)
    body = hull_solid(
        [
            (x, y, z)
            for x in (-0.12, 0.12)
            for y, z in ((-0.08, 0.02), (0.09, 0.02), (-0.08, 0.16), (0.09, 0.23))
        ]
    )
    top = at_box(0.32, 0.25, 0.014).turn(0, 0.38).move(0, -0.006, 0.195)
    lip = at_box(0.32, 0.012, 0.03).turn(0, 0.38).move(0, -0.122, 0.15)
    return [(base, tile), (body, tile), (top, tile), (lip, tile)]


def _pod(look: Look) -> Pieces:
    """A soft pod of washing liquid in two or three colours."""
    tones = [
        look.color("blue", "purple", "green", "orange"),
        look.own_color("white", "sky", "green"),
        look.own_color("orange", "blue", "purple"),
    ]
    base = pad(0.045, 0.042, 0.012, 0.01)
    lobes = [
        ball(0.028, 0.018, 0.02, (0.008 * (k - 1), 0.011 * (k - 1), 0.0105), 14).turn(2, 0.35)
        for k in range(3)
    ]
    return [
        (base, textures.plain((224, 234, 242))),
        *((b, textures.plain(t)) for b, t in zip(lobes, tones, strict=True)),
    ]


def _ironing(wide: float, long: float) -> Drawing:
    """A low ironing board: a padded pointed top on folding legs."""

    def draw(look: Look) -> Pieces:
        t = np.linspace(0, np.pi, 16)
        nose = np.column_stack(
            [0.5 * long - 0.45 * long + 0.45 * long * np.sin(t), -0.5 * wide * np.cos(t)]
        )
        outline = np.concatenate([[(-0.5 * long, 0.45 * wide), (-0.5 * long, -0.45 * wide)], nose])
        cover = textures.fabric(
            look.rng,
            look.color("sky", "beige", "gray", "mint", "pink"),
            look.own_color("white", "cream"),
        )
        top = plate(outline, 0.022, 0.1)
        legs = [
            straight((x, -0.4 * wide, 0.0065), (-0.6 * x, -0.3 * wide, 0.1), 0.006, 8)
            for x in (-0.3 * long, 0.3 * long)
        ]
        legs += [
            straight((x, 0.4 * wide, 0.0065), (-0.6 * x, 0.3 * wide, 0.1), 0.006, 8)
            for x in (-0.3 * long, 0.3 * long)
        ]
        feet = [
            straight((x, -0.45 * wide, 0.006), (x, 0.45 * wide, 0.006), 0.0065, 8)
            for x in (-0.3 * long, 0.3 * long)
        ]
        steel = shine(look, "silver", "gray")
        return [
            (top, cover),
            (feet[0], steel),
            (feet[1], steel),
            (join(legs[::2]), steel),
            (join(legs[1::2]), steel),
        ]

    return draw


def _washboard(look: Look) -> Pieces:
    tile = wood(look, "wooden", "tan", "brown")
    sides = [at_box(0.018, 0.42, 0.022, (s * 0.1, 0, 0)) for s in (-1, 1)]
    bars = [at_box(0.2, 0.06, 0.018, (0, 0.14, 0.002)), at_box(0.2, 0.02, 0.018, (0, -0.13, 0.002))]
    sheet = at_box(0.185, 0.25, 0.008, (0, -0.002, 0.002))
    ribs = [
        spindle((-0.09, 0.004), (0.09, 0.004), z=0.0105, sides=8).move(y=-0.11 + 0.0125 * k)
        for k in range(18)
    ]
    return [
        (sides[0], tile),
        (sides[1], tile),
        (bars[0], tile),
        (bars[1], tile),
        (sheet, s := shine(look, "silver", "gray")),
        (join(ribs), s),
    ]


def _reel(look: Look) -> Pieces:
    tile = plastic(look, "white", "gray", "green", "blue")
    body = disc(0.07, 0.05).turn(0, np.pi / 2).move(0, 0.025, 0.07)
    base = at_block(0.07, 0.06, 0.012, 0.006)
    line = rod(
        [(0.06, 0, 0.04), (0.11, 0, 0.02), (0.15, 0.03, 0.003), (0.1, 0.07, 0.003)], 0.002, 6, 6
    )
    hook = torus(0.01, 0.002, 18, 6).move(0.09, 0.075, 0.0025)
    face = disc(0.04, 0.002).turn(0, np.pi / 2).move(0, -0.0255, 0.07)
    return [
        (body, tile),
        (base, tile),
        (line, textures.plain((230, 230, 226))),
        (hook, shine(look)),
        (face, dye(look, "gray", "navy")),
    ]


def _bones(look: Look) -> Pieces:
    return [
        (
            plate(
                [
                    (-0.032, -0.0055),
                    (0.024, -0.0055),
                    (0.034, 0),
                    (0.024, 0.0055),
                    (-0.032, 0.0055),
                ],
                0.001,
            ),
            plastic(look, "white", "clear", "silver"),
        )
    ]


def _pin_card(look: Look) -> Pieces:
    card = at_box(0.07, 0.1, 0.0014)
    image = prints.canvas(64, 92, look.color("sky", "cream", "pink", "yellow"))
    prints.write(image, "PINS", 0.5, 0.12, 0.1, (40, 40, 60), True)
    pins = []
    for k in range(6):
        y = 0.024 - 0.012 * k
        pins += [
            straight((-0.022, y, 0.0024), (0.02, y, 0.0024), 0.0007, 6),
            straight((-0.022, y - 0.005, 0.0024), (0.02, y - 0.003, 0.0024), 0.0007, 6),
            at_block(0.007, 0.007, 0.0022, 0.002, (0.022, y - 0.0015, 0.0012)),
        ]
    return [(card, image), (join(pins), shine(look))]


def _receiver(look: Look) -> Pieces:
    tile = plastic(look, "black", "charcoal", "white")
    body = at_block(0.09, 0.06, 0.02, 0.008)
    mast = straight((0.032, 0.02, 0.016), (0.032, 0.03, 0.1), 0.0035, 8)
    lamp = ball(0.005, 0.005, 0.005, (-0.03, -0.015, 0.02), 8)
    return [(body, tile), (mast, BLACK), (lamp, textures.plain((90, 230, 110)))]


def _chair(look: Look) -> Pieces:
    """A small chair: a seat, four legs, a back of slats."""
    tile = wood(look, "wooden", "white", "brown", "pink", "red")
    seat = at_block(0.05, 0.05, 0.006, 0.006, (0, 0, 0.045))
    legs = [disc(0.0035, 0.046, (x, y, 0), sides=10) for x in (-0.02, 0.02) for y in (-0.02, 0.02)]
    posts = [disc(0.0035, 0.06, (x, 0.021, 0.05), sides=10) for x in (-0.02, 0.02)]
    slats = [at_box(0.042, 0.004, 0.008, (0, 0.021, 0.066 + 0.018 * k)) for k in range(3)]
    return [(seat, tile), *((leg, tile) for leg in legs), (join([*posts, *slats]), tile)]


_row = Rows("office", ("black",)).of_drawing


CATEGORIES = (
    _row("lectern", _lectern, (0.32, 0.26, 0.265), 2.5, ("tabletop lectern", "podium",
             "speaker stand lectern", "pulpit", "table lectern"), ("brown",), roles=("big",)),
    _row("laundry_pod", _pod, (0.0459, 0.046, 0.0209), 0.025, ("detergent pod", "washing pod",
             "laundry capsule", "dishwasher tablet", "washing capsule", "washing tablet",
             "detergent capsule", "dishwasher pod"), ("blue",), bodies=(0, 1, 2, 3)),
    _row("ironing_board", _ironing(0.2, 0.5), (0.5, 0.2, 0.122), 1.5, ("tabletop ironing board",
             "mini ironing board", "small ironing board"), ("sky",), roles=("big", "support")),
    _row("sleeve_board", _ironing(0.1, 0.45), (0.45, 0.1, 0.122), 0.8, ("sleeve ironing board",),
             ("sky",), roles=("big",)),
    _row("washboard", _washboard, (0.22, 0.42, 0.022), 0.9, ("wash board", "laundry board",
             "scrub board"), ("wooden",), roles=("flat", "big")),
    _row("washing_line_reel", _reel, (0.214, 0.113, 0.135), 0.5, ("washing line",
             "clothes line reel", "clothesline", "retractable washing line", "hose reel",
             "washing line reel retractable"), bodies=2),
    _row("collar_stiffener", _bones, (0.066, 0.011, 0.001), 0.001, ("collar stay", "collar bone",
             "shirt collar stiffener"), ("white",), roles=("flat",)),
    _row("safety_pin_card", _pin_card, (0.07, 0.1, 0.0034), 0.01, ("card of safety pins",
             "card of pins", "pin card", "needle card", "card of needles"), ("sky",), bodies=1,
             roles=("flat",)),
    _row("headset_receiver", _receiver, (0.0913, 0.0644, 0.102), 0.08, ("wireless receiver",
             "signal receiver", "receiver", "wireless transmitter", "bluetooth adapter"),
             ("black",)),
    _row("toy_chair", _chair, (0.05, 0.05, 0.11), 0.03, ("dollhouse chair",
             "miniature chair", "mini chair", "doll chair", "small chair", "wooden chair"),
             ("wooden",)),
)  # fmt: skip
"""The module's categories."""
