"""Shoes beside trainers: boots, sandals, slippers, heels."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_part
from ...build.forms import above
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, leather, put_down, rod
from ...build.shape import Shape, shape
from ...build.solids import Solid, join, loft
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def _sole(grow: float = 1.0) -> np.ndarray:
    """Return the outline of a sole, its toe to the left, 0.26 m long."""
    half = smooth([(-0.13, 0.0), (-0.115, 0.03), (-0.07, 0.046), (-0.01, 0.038), (0.05, 0.032),
                   (0.1, 0.034), (0.125, 0.02), (0.13, 0.0)], 2)  # fmt: skip
    curve = half * [1, 1] * grow
    return np.concatenate([curve * [1, -1], curve[::-1][1:-1]])


def _upper(levels: list[tuple[float, float, float, float]]) -> Solid:
    """Return a body over the sole: (growth x, growth y, shift x, z) from the bottom up."""
    base = _sole()
    return loft(np.stack([np.column_stack([base * [a, b] + [x, 0], np.full(len(base), z)])
                          for a, b, x, z in levels]), base)  # fmt: skip


def boot(look: Look) -> Shape:
    """An ankle boot with a heel and laces, its toe to the left."""
    color = look.color("brown", "black", "tan", "red", "olive", "navy", "yellow")
    k = look.between(0.75, 0.9)
    hide = leather(look.rng, color)
    sole = _upper([(0.99, 0.99, 0, 0), (1.0, 1.0, 0, 0.006), (1.0, 1.0, 0, 0.026)])
    foot = _upper([(0.96, 0.94, 0, 0.024), (0.93, 0.9, 0.004, 0.055), (0.72, 0.84, 0.03, 0.085),
                   (0.5, 0.82, 0.062, 0.11)])  # fmt: skip
    shaft = _upper([(0.5, 0.82, 0.062, 0.1), (0.47, 0.84, 0.066, 0.15), (0.5, 0.9, 0.064, 0.19),
                    (0.44, 0.78, 0.064, 0.192), (0.42, 0.74, 0.064, 0.17)])  # fmt: skip
    hole = _upper([(0.42, 0.74, 0.064, 0.188), (0.42, 0.74, 0.064, 0.1905)])
    laces = [
        rod(
            [
                (-0.03 + 0.012 * n, -0.022, 0.08 + 0.017 * n),
                (-0.035 + 0.012 * n, 0, 0.09 + 0.017 * n),
                (-0.03 + 0.012 * n, 0.022, 0.08 + 0.017 * n),
            ],
            0.0032,
            6,
        )
        for n in range(4)
    ]
    laces += [rod([(0.004, -0.026, 0.15 + 0.016 * n), (-0.002, 0, 0.154 + 0.016 * n),
                   (0.004, 0.026, 0.15 + 0.016 * n)], 0.0032, 6) for n in range(2)]  # fmt: skip
    pieces: Pieces = [
        (sole, textures.plain((62, 50, 42))),
        (join([foot, shaft]), hide),
        (hole, textures.plain((40, 34, 32))),
        (join(laces), textures.plain(look.own_color("yellow", "black", "white", "red"))),
    ]
    return put_down(pieces, sole, foot, shaft, factor=k)


def sandal(look: Look) -> Shape:
    """A sandal or flip-flop, its toe to the left."""
    color = look.color("brown", "tan", "red", "blue", "black", "teal", "pink", "yellow")
    sole = _upper([(0.98, 0.98, 0, 0), (1.0, 1.0, 0, 0.012), (0.99, 0.99, 0, 0.018)])
    bed = _upper([(0.93, 0.9, 0, 0.0175), (0.93, 0.9, 0, 0.0195)])
    strap = textures.plain(tint_color(color, 0.6) if sum(color) > 300 else (230, 210, 180))
    if look.chance(0.5):  # a flip-flop
        bands = [
            rod(
                [
                    (-0.07, 0, 0.02),
                    (-0.045, s * 0.012, 0.036),
                    (0.0, s * 0.034, 0.032),
                    (0.03, s * 0.034, 0.016),
                ],
                [0.0045, 0.006, 0.0065, 0.005],
                8,
            )
            for s in (-1, 1)
        ]
    else:
        bands = [
            rod(
                [
                    (x, -w, 0.014),
                    (x, -0.7 * w, 0.04),
                    (x, 0, 0.052),
                    (x, 0.7 * w, 0.04),
                    (x, w, 0.014),
                ],
                0.008,
                8,
            ).scale(1, 1, 1)
            for x, w in ((-0.065, 0.044), (-0.02, 0.042))
        ]
        bands.append(rod([(0.03, -0.033, 0.015), (0.07, -0.036, 0.06), (0.115, 0, 0.07),
                          (0.07, 0.036, 0.06), (0.03, 0.033, 0.015)], 0.006, 8))  # fmt: skip
    pieces: Pieces = [
        (sole, textures.speckles(look.rng, color, 5)),
        (bed, textures.plain(tint_color(color, 1.25))),
        (join(bands), strap),
    ]
    return put_down(pieces, sole, join(bands), factor=look.between(0.75, 1.0))


def slipper(look: Look) -> Shape:
    """A soft slipper, open at its heel."""
    color = look.color("pink", "gray", "navy", "red", "cream", "teal", "brown")
    plush = textures.scratches(look.rng, color, tint_color(color, 0.8), 120)
    sole = _upper([(0.97, 0.97, 0, 0), (1.0, 1.0, 0, 0.008), (0.98, 0.98, 0, 0.02)])
    bed = _upper([(0.92, 0.88, 0, 0.0195), (0.92, 0.88, 0, 0.0215)])
    cap = ball(0.14, 0.1, 0.095, (-0.062, 0, 0.016), 20)
    cap = cap.bend(
        lambda p: np.column_stack([np.minimum(p[:, 0], 0.0), p[:, 1], np.maximum(p[:, 2], 0.006)])
    )
    mouth = ball(0.006, 0.074, 0.062, (0.0, 0, 0.02), 16)
    mouth = mouth.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0.02)]))
    rim = rod([(0.0, -0.045, 0.014), (0.0, -0.036, 0.046), (0, 0, 0.062), (0.0, 0.036, 0.046),
               (0.0, 0.045, 0.014)], 0.0075, 8)  # fmt: skip
    pieces: Pieces = [
        (sole, textures.plain(tint_color(color, 0.5))),
        (bed, textures.plain(tint_color(color, 1.4))),
        (cap, plush),
        (mouth, textures.plain((52, 44, 44))),
        (rim, textures.plain((246, 242, 234))),
    ]
    return put_down(pieces, sole, cap, factor=look.between(0.8, 1.0))


def high_heel(look: Look) -> Shape:
    """A lady's shoe with a high heel, its toe to the left."""
    color = look.color("red", "black", "gold", "silver", "pink", "navy", "white")
    base = _sole()
    n = len(base)

    def arch(p: np.ndarray) -> np.ndarray:
        t = np.clip((p[:, 0] + 0.06) / 0.17, 0, 1)
        rise = 0.075 * t * t * (3 - 2 * t)
        return np.column_stack([p[:, 0] * 0.88, p[:, 1] * 0.85, p[:, 2] + rise])

    sole = loft(np.stack([np.column_stack([base * g, np.full(n, z)]) for g, z in (
        (0.97, 0), (1.0, 0.003), (1.0, 0.007))]), base).bend(arch)  # fmt: skip
    toe = ball(0.12, 0.078, 0.06, (-0.07, 0, 0.006), 18)
    toe = toe.bend(
        lambda p: np.column_stack([np.minimum(p[:, 0], -0.03), p[:, 1], np.maximum(p[:, 2], 0.004)])
    )
    heel_cup = [
        rod(
            [
                (-0.02, s * 0.033, 0.02),
                (0.04, s * 0.029, 0.07),
                (0.09, s * 0.024, 0.1),
                (0.112, 0, 0.112),
            ],
            [0.004, 0.01, 0.016, 0.016],
            8,
        )
        for s in (-1, 1)
    ]
    heel = rod([(0.094, 0, 0.08), (0.1, 0, 0.045), (0.098, 0, 0.0)], [0.018, 0.009, 0.006], 12)
    skin = textures.gradient(tint_color(color, 0.9), tint_color(color, 1.12), look.rng, 2)
    inner = loft(
        np.stack([np.column_stack([base * 0.85, np.full(n, z)]) for z in (0.0068, 0.0085)]), base
    )
    pieces: Pieces = [(join([sole, toe, *heel_cup, heel]), skin),
                      (inner.bend(arch), textures.plain((226, 200, 170)))]  # fmt: skip
    v = above(sole.vertices)
    return shape(
        pieces,
        [
            hull_part(above(np.concatenate([v[v[:, 0] < -0.02], toe.vertices]))),
            hull_part(v[v[:, 0] > -0.05]),
            hull_part(above(heel.vertices)),
            hull_part(join(heel_cup).vertices),
        ],
    ).scale(look.between(0.8, 0.95))


CATEGORIES = (
    Category("boot", boot, (0.213, 0.075, 0.158), 0.45, ("ankle boot", "leather boot",
             "hiking boot", "winter boot", "rain boot", "wellington boot", "cowboy boot",
             "work boot", "wellie", "welly", "gumboot"), ("living",), (), ("brown", "black")),
    Category("sandal", sandal, (0.237, 0.091, 0.0609), 0.18, ("flip flop", "flip-flop",
             "leather sandal", "beach sandal", "thong sandal", "flip-flops"), ("living",), (),
             ("brown",
             "red")),
    Category("slipper", slipper, (0.235, 0.09, 0.058), 0.12, ("house slipper", "house shoe",
             "bedroom slipper", "fluffy slipper",
             "glass slipper"), ("living",), (), ("pink", "gray")),
    Category("high_heel", high_heel, (0.21, 0.068, 0.11), 0.2, ("high heels",
             "stiletto", "high heeled shoe", "court shoe", "dress shoe",
             "ladies shoe", "high heel shoe"), ("living",), (), ("red", "black")),
)  # fmt: skip
"""The module's categories."""
