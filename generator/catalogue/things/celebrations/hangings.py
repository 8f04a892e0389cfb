"""Ornaments and charms to hang up."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of
from ...build.outlines import smooth
from ...build.recipes import put_down, standing_plate
from ...build.settled import limb, settle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def snowflake(look: Look) -> Shape:
    """A six-armed snowflake with a loop to hang it, lying."""
    k = look.between(0.85, 1.2)
    color = look.color("white", "silver", "sky", "white", "gold")
    arms = []
    for n in range(6):
        a = np.pi / 3 * n
        way, side = np.array([np.cos(a), np.sin(a)]), np.array([-np.sin(a), np.cos(a)])

        def rod_(p: np.ndarray, q: np.ndarray, wide: float = 0.0026) -> Solid:
            return tube([(*p, 0.0025), (*q, 0.0025)], wide, 6)

        arms.append(rod_(0 * way, 0.046 * way))
        for d, reach in ((0.018, 0.011), (0.031, 0.014)):
            arms += [rod_(d * way, (d + 0.6 * reach) * way + s * reach * side, 0.0021)
                     for s in (-1, 1)]  # fmt: skip
    loop = torus(0.006, 0.001, 16, 6).move(0, 0.052, 0.0015)
    glitter = textures.spots(look.rng, color, (255, 255, 255), 0.2)
    return put_down([(join([*arms, loop]), glitter)], factor=k)


def icicle(look: Look) -> Shape:
    """A twisted glass icicle with a gold cap and loop, lying."""
    k = look.between(0.85, 1.15)
    color = look.color("clear", "sky", "silver", "white")
    t = np.linspace(0, 1, 40)
    strands = [tube(np.column_stack([0.13 * t - 0.065, 0.0045 * (1 - 0.8 * t) * np.cos(16 * t + a),
                                     0.0045 * (1 - 0.8 * t) * np.sin(16 * t + a)]),
                    0.0062 * (1 - 0.86 * t), 7) for a in (0, np.pi)]  # fmt: skip
    cap = cylinder(0.009, 0.01, 16).turn(1, np.pi / 2).move(x=-0.072)
    loop = torus(0.006, 0.001, 16, 6).move(x=-0.078)
    return settle(
        [
            (join(strands), textures.gradient(color, tint_color(color, 1.4), look.rng)),
            (join([cap, loop]), textures.plain((214, 176, 90))),
        ],
        0.12,
    ).scale(k)


def sleigh(look: Look) -> Shape:
    """A small sleigh on curved runners, its sack of presents in it."""
    k = look.between(0.85, 1.15)
    color = look.color("red", "red", "green", "wooden", "gold")
    side = smooth(
        np.array(
            [
                (-0.06, 0.02),
                (0.035, 0.02),
                (0.06, 0.034),
                (0.066, 0.056),
                (0.05, 0.05),
                (0.03, 0.042),
                (-0.02, 0.044),
                (-0.045, 0.07),
                (-0.066, 0.072),
                (-0.06, 0.02),
            ]
        ),
        3,
    )[:-1]
    walls = [standing_plate(side, 0.004).move(y=s * 0.026) for s in (-1, 1)]
    seat = box(0.1, 0.05, 0.004).move(-0.01, 0, 0.019)
    back = box(0.004, 0.052, 0.048).turn(1, -0.12).move(-0.06, 0, 0.022)
    front = box(0.004, 0.052, 0.024).turn(1, 0.4).move(0.054, 0, 0.024)
    runners = [
        limb(
            [
                (-0.075, s * 0.022, 0.004),
                (0.05, s * 0.022, 0.004),
                (0.082, s * 0.022, 0.016),
                (0.082, s * 0.022, 0.034),
                (0.07, s * 0.022, 0.038),
            ],
            [0.0032] * 5,
            7,
        )
        for s in (-1, 1)
    ]
    posts = [tube([(x, s * 0.022, 0.004), (x, s * 0.022, 0.022)], 0.0025, 6) for s in (-1, 1)
             for x in (-0.045, 0.03)]  # fmt: skip
    sack = ellipsoid(0.056, 0.044, 0.05, 16, 8).move(-0.022, 0, 0.046)
    gifts = [block(0.022, 0.022, 0.022, 0.001).turn(2, 0.4).move(0.024, s * 0.01, 0.023)
             for s in (-1, 1)]  # fmt: skip
    gold = textures.plain((214, 176, 90))
    body = join([*walls, seat, back, front])
    return shape(
        [
            (body, look.surface(color, "plastic")),
            (join([*runners, *posts]), gold),
            (sack, textures.fabric(look.rng, (128, 92, 60))),
            (join(gifts), textures.plain((60, 130, 90))),
        ],
        [hull_of(*runners, *posts), hull_of(body), hull_of(sack, *gifts)],
    ).scale(k)


def medallion(look: Look) -> Shape:
    """An evil-eye charm: rings of blue, white and black glass, a loop."""
    r = look.between(0.018, 0.026)
    color = look.color("navy", "blue", "blue")
    rings = [(r, 0.006, color), (0.64 * r, 0.0068, (250, 250, 250)), (0.44 * r, 0.0074,
             (90, 180, 226)), (0.24 * r, 0.008, (20, 20, 26))]  # fmt: skip
    pieces = [(cylinder(a, h, 26, bevel=0.0008), textures.plain(tone)) for a, h, tone in rings]
    loop = torus(0.004, 0.001, 14, 6).move(0, 1.16 * r, 0.002)
    cord = limb([(0, 1.16 * r, 0.002), (0.004, 1.16 * r + 0.03, 0.0016), (-0.003, 1.16 * r + 0.05,
                0.0016)], [0.0012] * 3, 5)  # fmt: skip
    pieces.append((join([loop, cord]), textures.plain((50, 80, 150))))
    return shape(pieces, [cylinder_part(r, 0.008), hull_of(loop, cord)])


_L = ("living",)
_D = "lying flat"


CATEGORIES = (
    Category("snowflake", snowflake, (0.0992, 0.109, 0.00486), 0.01, ("snowflake ornament",
             "paper snowflake", "snowflake decoration", "wooden snowflake"), _L, ("flat",),
             ("white",), state=_D),
    Category("icicle", icicle, (0.155, 0.0215, 0.0174), 0.02, ("icicle ornament", "glass icicle",
             "icicle decoration"), _L, (), ("clear",), state=_D),
    Category("sleigh", sleigh, (0.149, 0.0513, 0.0698), 0.1, ("sleigh ornament", "mini sled",
             "toy sleigh", "sled", "santa's sleigh", "toy sled", "sledge"), _L, (), ("red",)),
    Category("evil_eye", medallion, (0.0438, 0.0981, 0.008), 0.015, ("evil eye charm", "nazar",
             "evil eye bead", "evil eye amulet", "nazar amulet"), _L, ("flat",), ("navy",),
             state=_D),
)  # fmt: skip
"""The module's categories."""
