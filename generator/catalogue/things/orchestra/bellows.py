"""Pipes with bellows and bags, horns of fans, reeds."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import (
    Drawing,
    at_block,
    at_box,
    dye,
    metal,
    of,
    plastic,
    spindle,
    wood,
)
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, rod
from ...build.solids import join, lathe, torus, tube
from ...build.variants import at_rest
from ...surfaces import textures
from ...surfaces.look import Look


def _bellows(sides: int | None, wide: float) -> Drawing:
    """Folded bellows between two ends with buttons, standing on their side."""

    def draw(look: Look) -> Pieces:
        shell = plastic(look, "red", "black", "maroon", "navy", "white")
        pieces: Pieces = []
        if sides is None:
            ends = [at_block(0.055, 0.13, wide, 0.012, (s * 0.1, 0, 0)) for s in (-1, 1)]
            folds = [at_box(0.007, 0.115 + 0.012 * (k % 2), wide - 0.02 + 0.012 * (k % 2),
                            (0.0075 * (k - 9), 0, 0.004)) for k in range(19)]  # fmt: skip
            pieces = [(e, shell) for e in ends]
            board = at_box(0.04, 0.022, 0.24 if wide > 0.2 else 0.9 * wide, (0.095, -0.072, 0.005))
            keys = [at_box(0.026, 0.004, 0.0105, (0.1, -0.0845, 0.012 + 0.0125 * k))
                    for k in range(int(0.86 * wide / 0.0125))]  # fmt: skip
            dots = [ball(0.007, 0.007, 0.007, (-0.128, -0.04 + 0.016 * n, 0.03 + 0.02 * k), 8)
                    for k in range(int(wide / 0.024)) for n in range(5)]  # fmt: skip
            pieces += [(board, shell), (join(keys), textures.plain((244, 242, 236))),
                       (join(dots), textures.plain((236, 234, 228)))]  # fmt: skip
        else:
            ends = [lathe([(0, 0), (wide, 0), (wide, 0.03), (0, 0.03)], sides).turn(1, np.pi / 2)
                    .move(x=x) for x in (-0.095, 0.065)]  # fmt: skip
            folds = [lathe([(0, 0), (r, 0), (r, 0.007), (0, 0.007)], sides).turn(1, np.pi / 2)
                     .move(x=-0.066 + 0.0073 * k) for k in range(18)
                     for r in ((0.92 - 0.09 * (k % 2)) * wide,)]  # fmt: skip
            dots = [ball(0.006, 0.006, 0.006, (s * 0.096, y, z), 8) for s in (-1, 1)
                    for y in (-0.018, 0, 0.018) for z in (-0.018, 0, 0.018)]  # fmt: skip
            straps = [torus(0.03, 0.004, 18, 6).turn(0, np.pi / 2).scale(0.6, 1, 1).move(s * 0.1,
             0, 0)
                      for s in (-1, 1)]  # fmt: skip
            low = min(float(e.bounds[0, 2]) for e in ends)
            ends, folds, dots, straps = (
                [s.move(z=-low) for s in g] for g in (ends, folds, dots, straps)
            )
            pieces = [(e, wood(look, "brown", "maroon", "black")) for e in ends]
            pieces += [(join(dots), textures.plain((236, 234, 228)))]
            del straps
        mid = len(folds) // 2
        return (
            [*pieces[:2], (join(folds), dye(look, "black", "red", "charcoal")), *pieces[2:]]
            if mid
            else pieces
        )

    return draw


def _melodica(look: Look) -> Pieces:
    tile = plastic(look, "sky", "red", "pink", "black", "green")
    body = at_block(0.34, 0.075, 0.035, 0.015)
    keys = [at_box(0.0135, 0.05, 0.006, (-0.14 + 0.0148 * k, -0.012, 0.034)) for k in range(19)]
    dark = [at_box(0.008, 0.03, 0.004, (-0.1326 + 0.0148 * k, -0.002, 0.039)) for k in range(18)
            if k % 7 not in (2, 6)]  # fmt: skip
    mouth = rod(
        [(-0.165, 0.01, 0.02), (-0.19, 0.01, 0.02), (-0.21, 0.01, 0.022)], [0.009, 0.006, 0.008]
    )
    return [(body, tile), (mouth, tile), (join(keys), textures.plain((246, 244, 238))),
            (join(dark), textures.plain((30, 30, 32)))]  # fmt: skip


def _bagpipes(look: Look) -> Pieces:
    """A tartan bag with three drones and a chanter, lying."""
    bag = ball(0.26, 0.14, 0.1, (0, 0, 0.045), 24)
    a, b = look.color("red", "green", "navy", "maroon"), look.own_color("navy", "green", "black")
    plaid = textures.fabric(look.rng, a, b)
    tile = wood(look, "black", "brown")
    white = textures.plain((238, 234, 224))
    drones = [rod([(0.02 + 0.03 * k, 0.05, 0.06), (0.05 + 0.05 * k, 0.15, 0.03), (0.08 + 0.07 * k,
             0.28 - 0.05 * k, 0.012)],
                  [0.008, 0.0085, 0.01], 10) for k in range(3)]  # fmt: skip
    tips = [
        ball(0.026, 0.026, 0.022, (0.08 + 0.07 * k, 0.28 - 0.05 * k, 0.013), 12) for k in range(3)
    ]
    pipe = rod(
        [(-0.11, 0, 0.05), (-0.16, -0.06, 0.02), (-0.2, -0.15, 0.01)], [0.008, 0.007, 0.011], 10
    )
    blow = rod(
        [(-0.04, 0.05, 0.07), (-0.09, 0.12, 0.04), (-0.12, 0.17, 0.012)], [0.008, 0.007, 0.006], 10
    )
    return [(bag, plaid), (join([pipe]), tile), (join([blow]), tile), *((d, tile) for d in drones),
            (join(tips), white)]  # fmt: skip


def _didgeridoo(look: Look) -> Pieces:
    color = look.color("brown", "terracotta", "wooden")
    bands = textures.stripes(
        [color, (226, 206, 160), color, color, (70, 36, 26), color, (196, 120, 60)], 3
    )
    body = spindle((-0.3, 0.014), (-0.29, 0.017), (0.0, 0.019), (0.2, 0.024), (0.3, 0.033), z=0.031)
    return [
        (body, bands),
        (spindle((0.2995, 0.026), (0.3006, 0.026), z=0.031), textures.plain((30, 22, 18))),
    ]


def _vuvuzela(look: Look) -> Pieces:
    tile = plastic(look, "red", "yellow", "green", "blue", "orange")
    horn = spindle((-0.26, 0.012), (-0.25, 0.008), (-0.1, 0.011), (0.12, 0.02), (0.22, 0.034),
                  (0.27, 0.052), z=0.05)  # fmt: skip
    return [
        (horn, tile),
        (spindle((0.2695, 0.046), (0.2705, 0.046), z=0.05), textures.plain((40, 36, 36))),
    ]


def _jaw_harp(look: Look) -> Pieces:
    tile = metal(look, "silver", "brass", "charcoal")
    way = [
        (0.06, 0.006),
        (0.0, 0.009),
        (-0.03, 0.02),
        (-0.05, 0.0),
        (-0.03, -0.02),
        (0.0, -0.009),
        (0.06, -0.006),
    ]
    frame = tube([(*p, 0.004) for p in smooth(way, 6)], 0.004, 8)
    tongue = rod([(-0.048, 0, 0.004), (0.062, 0, 0.004), (0.066, 0, 0.018)], 0.0014, 6)
    return [(frame, tile), (tongue, tile)]


def _reed_piece(look: Look) -> Pieces:
    tile = wood(look, "beige", "cream", "tan")
    body = at_block(0.067, 0.013, 0.003, 0.003).bend(
        lambda p: p * np.column_stack([np.ones((len(p), 2)), np.clip(0.75 - 11 * p[:, 0], 0.2,
             1)]))  # fmt: skip
    return [(body, tile)]


CATEGORIES = (
    Category("accordion", of(_bellows(None, 0.24), bodies=4), (0.248, 0.145, 0.235), 2.5,
             ("piano accordion", "squeezebox", "toy accordion", "button accordion"), ("living",),
             ("big",), ("red", "black")),
    Category("concertina", of(_bellows(6, 0.07), bodies=3), (0.198, 0.14, 0.122), 0.9,
             ("small accordion", "bandoneon"), ("living",), (), ("brown",)),
    Category("melodica", of(_melodica, bodies=2), (0.39, 0.075, 0.043), 0.6, ("key harmonica",
             "pianica", "blow organ"), ("living",), ("flat", "big"), ("sky", "red")),
    Category("bagpipes", of(_bagpipes, 0.05), (0.42, 0.44, 0.095), 1.2, ("bagpipe",
             "set of bagpipes", "highland pipes"), ("living",), ("big",), ("red", "green"),
             state="lying"),
    at_rest(Category("didgeridoo", of(_didgeridoo, 0.08, bodies=1), (0.6, 0.066, 0.064), 1.2,
             ("didjeridu",), ("living",), ("big",), ("brown",), state="lying")),
    at_rest(Category("vuvuzela", of(_vuvuzela, 0.06, bodies=1), (0.53, 0.104, 0.102), 0.12,
             ("stadium horn",
             "fan horn", "bugle toy"), ("living",), ("big",), ("red", "yellow"),
             state="lying")),
    Category("jaw_harp", of(_jaw_harp, 0.1), (0.128, 0.0487, 0.0188), 0.03, ("jew harp",
             "mouth harp harp",
             "khomus"), ("living",), (), ("silver",), state="lying"),
    Category("clarinet_reed", of(_reed_piece), (0.0661, 0.0128, 0.00296), 0.001, ("reed",
             "saxophone reed",
             "sax reed", "oboe reed"), ("living",), ("flat",), ("beige",), state="lying"),
)  # fmt: skip
"""The module's categories."""
