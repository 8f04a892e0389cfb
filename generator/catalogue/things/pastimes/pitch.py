"""Kit of outdoor games: golf clubs, stumps, arrows, foam hands."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import DARK, at_box, drum, lies, plate, standing, steel
from ...build.recipes import ball, leather, put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import block, join
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def golf_club(look: Look) -> Shape:
    """A short club lying: head, shaft and grip."""
    color = look.color("silver", "black", "gold", "charcoal")
    k = look.between(0.4, 0.5)
    shaft = straight((-0.32, 0, 0.012), (0.42, 0, 0.012), [0.006, 0.0075], 10)
    grip = straight((0.2, 0, 0.012), (0.43, 0, 0.012), [0.0105, 0.0125], 12)
    if look.chance(0.5):
        head = plate(
            [(-0.36, -0.1), (-0.31, -0.1), (-0.305, 0.012), (-0.335, 0.014)],
            0.03,
            at=(0, 0, 0),
            bevel=0.004,
        )
    else:
        head = ball(0.09, 0.12, 0.06, (-0.34, -0.045, 0.028), 18)
    neck = straight((-0.325, 0, 0.012), (-0.3, 0, 0.012), 0.0095, 10)
    return put_down(
        [
            (shaft, steel(look)),
            (grip, textures.scratches(look.rng, (44, 44, 48), (90, 90, 94), 60)),
            (join([head, neck]), look.surface(color, "metal")),
        ],
        shaft,
        grip,
        head,
        factor=k,
        foot=0.3,
    )


def cricket_stumps(look: Look) -> Shape:
    """Three stumps in a base with two bails on them."""
    color = look.color("wooden", "tan", "yellow", "red", "blue")
    k = look.between(0.85, 1.15)
    base = block(0.1, 0.05, 0.014, 0.006, 0.003)
    stumps = [drum(0.006, 0.2, (x, 0, 0.012), sides=14) for x in (-0.034, 0, 0.034)]
    bails = [
        straight((x - 0.017, 0, 0.2135), (x + 0.017, 0, 0.2135), 0.003, 8) for x in (-0.018, 0.018)
    ]
    wood = look.surface(color, "wood")
    return put_down(
        [
            (base, plain(look.own_color("black", "green", "charcoal"))),
            (join([*stumps, *bails]), wood),
        ],
        base,
        join(stumps),
        factor=k,
    )


def arrow(look: Look) -> Shape:
    """An arrow lying: shaft, point and three feathers."""
    color = look.color("red", "yellow", "green", "white", "blue", "orange")
    k = look.between(0.45, 0.62)
    shaft = straight((-0.32, 0, 0.009), (0.34, 0, 0.009), 0.0042, 10)
    tip = lies(standing((0.0055, 0), (0.0055, 0.02), (0.0008, 0.045), sides=12), 0.33, 0, 0.009)
    vane = [(-0.31, 0.003), (-0.23, 0.003), (-0.25, 0.016), (-0.315, 0.02)]
    vanes = [
        plate(np.array(vane) * [1, t] if t > 0 else (np.array(vane) * [1, t])[::-1], 0.0012)
        .turn(0, t * lean)
        .move(z=0.009)
        for t, lean in ((1, 0.3), (-1, 0.3), (1, 1.57))
    ]
    nock = drum(0.005, 0.014, (-0.334, 0, 0.009), 0, sides=10)
    return put_down(
        [
            (shaft, textures.wood(look.rng, (206, 168, 112))),
            (tip, steel(look)),
            (join(vanes), plain(color)),
            (nock, plain(tint_color(color, 0.7))),
        ],
        straight((-0.33, 0, 0.0085), (0.37, 0, 0.0085), 0.0045, 8),
        join(vanes),
        factor=k,
        foot=0.5,
    )


def quiver(look: Look) -> Shape:
    """A leather quiver standing, with a few arrows in it."""
    color = look.color("brown", "tan", "black", "maroon")
    k = look.between(0.85, 1.15)
    body = drum(0.032, 0.17, top=0.04)
    bands = [
        drum(0.0345 + 0.001 * n, 0.012, (0, 0, 0.012 + 0.138 * n), top=0.035 + 0.006 * n)
        for n in range(2)
    ]
    hole = drum(0.036, 0.0008, (0, 0, 0.1698))
    strap = rod([(0.034, 0, 0.02), (0.06, 0, 0.06), (0.062, 0, 0.12), (0.04, 0, 0.155)], 0.005, 8)
    shafts, vanes = [], []
    for n in range(4):
        x, y = 0.016 * np.cos(1.7 * n), 0.016 * np.sin(1.7 * n)
        shafts.append(straight((x, y, 0.16), (1.5 * x, 1.5 * y, 0.24), 0.0028, 8))
        vanes += [
            at_box(0.022, 0.0015, 0.034, (1.4 * x, 1.4 * y, 0.2)).turn(2, 0.0),
            at_box(0.0015, 0.022, 0.034, (1.4 * x, 1.4 * y, 0.2)),
        ]
    return put_down(
        [
            (body, leather(look.rng, color)),
            (join([*bands, strap]), leather(look.rng, tint_color(color, 0.6))),
            (hole, plain(DARK)),
            (join(shafts), plain((206, 168, 112))),
            (join(vanes), plain(look.own_color("red", "white", "yellow", "green"))),
        ],
        body,
        strap,
        join(shafts),
        factor=k,
    )


def foam_finger(look: Look) -> Shape:
    """A big foam hand with one finger up, lying."""
    color = look.color("blue", "red", "green", "yellow", "purple")
    k = look.between(0.8, 1.1)
    rim = [
        (-0.055, -0.12),
        (0.055, -0.12),
        (0.065, 0.0),
        (0.06, 0.05),
        (0.02, 0.06),
        (0.02, 0.15),
        (0.005, 0.17),
        (-0.014, 0.15),
        (-0.02, 0.04),
        (-0.05, 0.03),
        (-0.085, 0.045),
        (-0.09, 0.025),
        (-0.06, -0.02),
    ]
    hand = plate(rim, 0.024)
    face = prints.canvas(128, 96, color)
    prints.write(face, look.pick(["No. 1", "GO!", "#1"]), 0.5, 0.5, 0.5, (250, 246, 230), bold=True)
    badge = at_box(0.09, 0.06, 0.001, (0, -0.06, 0.0236))
    lines = [at_box(0.003, 0.05, 0.001, (0.02 + 0.016 * n, 0.02, 0.0236)) for n in range(2)]
    return put_down(
        [
            (hand, textures.speckles(look.rng, color, 4)),
            (badge, face),
            (join(lines), plain(tint_color(color, 0.5))),
        ],
        hand,
        factor=k,
    )


CATEGORIES = (
    Category("golf_club", golf_club, (0.375, 0.0543, 0.0222), 0.25,
             ("golf putter", "putter", "golf iron", "golf driver", "mini golf club",
             "toy golf club"),
             ("sports",), ("big",), ("silver",)),
    Category("cricket_stumps", cricket_stumps, (0.108, 0.0542, 0.235), 0.2,
             ("cricket stump", "wicket", "cricket wicket", "cricket bail", "set of stumps"),
             ("sports",), ("tall",), ("wooden",)),
    Category("arrow", arrow, (0.381, 0.0205, 0.0137), 0.03, ("archery arrow", "wooden arrow",
             "crossbow bolt"),
             ("sports",), ("big",), ("red", "yellow")),
    Category("quiver", quiver, (0.115, 0.0854, 0.25), 0.3, ("arrow quiver", "quiver of arrows"),
             ("sports",), ("tall",), ("brown",)),
    Category("foam_finger", foam_finger, (0.149, 0.279, 0.0237), 0.06, ("foam hand", "fan finger",
             "giant foam finger"),
             ("sports",), ("flat", "big"), ("blue", "red")),
)  # fmt: skip
"""The module's categories."""
