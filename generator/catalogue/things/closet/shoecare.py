"""What belongs to shoes: laces, insoles, trees, horns, clogs."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import BRASS_TONE, DARK, at_box, drum, plate, steel
from ...build.outlines import smooth
from ...build.recipes import ball, put_down, rod
from ...build.shape import Shape
from ...build.solids import join, loft, prism, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain

FOOT = np.array(
    [
        (-0.12, -0.03),
        (-0.06, -0.034),
        (0.0, -0.03),
        (0.07, -0.046),
        (0.115, -0.036),
        (0.135, -0.005),
        (0.12, 0.03),
        (0.06, 0.042),
        (0.0, 0.03),
        (-0.06, 0.034),
        (-0.12, 0.03),
        (-0.135, 0),
    ]
)
"""The outline of a sole, its toe towards +x."""


def shoelace(look: Look) -> Shape:
    """A pair of laces lying in loops, their ends capped."""
    color = look.color("white", "black", "red", "yellow", "brown", "blue")
    k = look.between(0.85, 1.15)
    t = np.linspace(0, 2 * np.pi, 70)
    path = np.column_stack(
        [0.065 * np.sin(t), 0.038 * np.sin(2 * t + 0.2), 0.0024 + 0.0018 * (1 + np.cos(t))]
    )
    path = path + np.column_stack([0 * t, 0.006 * t - 0.02, 0 * t])
    lace = tube(path, 0.0027, 7)
    tips = [
        tube([path[i], path[i] + w], 0.0029, 8)
        for i, w in ((0, [-0.018, -0.008, 0]), (-1, [0.018, 0.008, 0]))
    ]
    lines = textures.stripes([color, tint_color(color, 0.8)], 24)
    bits = [tube(path[i : i + 8], 0.0027, 6) for i in range(0, 63, 7)]
    return put_down(
        [(lace, lines), (join(tips), plain((70, 72, 78)))], *bits, *tips, factor=k, foot=0.3
    )


def insole(look: Look) -> Shape:
    """An insole lying."""
    color = look.color("blue", "tan", "gray", "green", "black", "cream")
    k, s = look.between(0.85, 1.08), look.pick([-1, 1])
    rim = smooth(np.concatenate([FOOT, FOOT[:1]]) * [1, s], 4)[:-1]
    sole, top = plate(rim, 0.005), plate(0.965 * rim, 0.0014, at=(0, 0, 0.0048))
    image = textures.fabric(look.rng, color)
    arch = [at_box(0.03, 0.012, 0.0012, (-0.09, 0, 0.0058))]
    return put_down(
        [(sole, plain(tint_color(color, 0.6))), (top, image), (join(arch), plain((244, 240, 230)))],
        sole,
        factor=k,
    )


def shoe_tree(look: Look) -> Shape:
    """A wooden shoe tree lying: a split toe, a spring tube and a heel with a knob."""
    color = look.color("tan", "wooden", "brown")
    k = look.between(0.85, 1.05)
    toes = [ball(0.12, 0.04, 0.05, (0.075, s * 0.023, 0.022), 16) for s in (-1, 1)]
    heel = ball(0.06, 0.055, 0.055, (-0.1, 0, 0.026), 16)
    pole = rod([(-0.1, 0, 0.028), (0.05, 0, 0.026)], 0.0055, 10)
    knob = ball(0.022, 0.022, 0.022, (-0.13, 0, 0.042), 12)
    wood = textures.wood(look.rng, color)
    return put_down(
        [(join([*toes, heel]), wood), (join([pole, knob]), steel(look, BRASS_TONE))],
        *toes,
        heel,
        pole,
        factor=k,
    )


def clog(look: Look) -> Shape:
    """A wooden clog with a turned-up toe."""
    color = look.color("wooden", "tan", "yellow", "red", "blue")
    k = look.between(0.85, 1.1)
    rim = smooth(np.concatenate([FOOT, FOOT[:1]]), 4)[:-1]
    sole = prism(0.98 * rim, 0, 0.03)
    front = ball(0.17, 0.092, 0.085, (0.055, -0.002, 0.036), 20)
    toe = rod([(0.1, 0, 0.04), (0.14, 0, 0.044), (0.152, 0, 0.062)], [0.02, 0.012, 0.004], 10)
    heel = [
        tube(
            smooth(
                [
                    (0.0, s * 0.042, 0.05),
                    (-0.07, s * 0.04, 0.045),
                    (-0.12, s * 0.02, 0.048),
                    (-0.128, 0, 0.05),
                ],
                4,
            ),
            0.009,
            8,
            squash=2.6,
        )
        for s in (-1, 1)
    ]
    hole = ball(0.1, 0.06, 0.03, (-0.035, 0, 0.052), 16)
    blocks = [at_box(0.05, 0.06, 0.012, (-0.09, 0, 0)), at_box(0.06, 0.07, 0.012, (0.06, 0, 0))]
    paint = look.surface(color, "wood")
    return put_down(
        [(join([sole, front, toe, *heel, *blocks]), paint), (hole, plain((70, 50, 36)))],
        sole,
        front,
        join(heel),
        factor=k,
    )


def shoe_horn(look: Look) -> Shape:
    """A shoehorn lying: a curved blade with a hole in its handle."""
    color = look.color("silver", "brown", "black", "gold", "tan")
    k = look.between(0.8, 1.2)
    n = 15
    x = np.linspace(-0.085, 0.085, n)
    half = np.interp(x, [-0.085, -0.06, 0.0, 0.06, 0.085], [0.008, 0.014, 0.013, 0.021, 0.015])
    rims = []
    for a, w in zip(x, half, strict=True):
        deep = 0.42 * w
        y = np.array([-w, -0.5 * w, 0.5 * w, w, 0.5 * w, -0.5 * w])
        z = np.array(
            [deep, 0.12 * deep, 0.12 * deep, deep, 0.12 * deep + 0.0022, 0.12 * deep + 0.0022]
        )
        z[[0, 3]] += 0.001
        rims.append(np.column_stack([np.full(6, a), y, z]))
    made = loft(np.stack(rims), rims[0][:, 1:])
    hole = drum(0.004, 0.001, (-0.072, 0, 0.0035))
    tile = look.surface(color, "steel" if min(color) > 130 else "plastic")
    return put_down([(made, tile), (hole, plain(DARK))], made, factor=k)


CATEGORIES = (
    Category("shoelace", shoelace, (0.135, 0.0909, 0.00892), 0.01, ("shoe lace", "boot lace",
             "bootlace", "pair of shoelaces"),
             ("living",), ("flat",), ("white",)),
    Category("insole", insole, (0.27, 0.0879, 0.00699), 0.03, ("shoe insole", "inner sole",
             "shoe insert"), ("living",), ("flat",),
             ("blue",)),
    Category("shoe_tree", shoe_tree, (0.267, 0.0832, 0.0517), 0.35, ("shoe stretcher",
             "boot tree", "glove stretcher"), ("living",), (),
             ("tan",)),
    Category("clog", clog, (0.287, 0.1, 0.077), 0.35, ("wooden shoe", "wooden clog",
             "dutch clog"), ("living",), ("big",), ("tan",)),
    Category("shoe_horn", shoe_horn, (0.169, 0.0413, 0.00926), 0.05, ("shoehorn",), ("living",),
             ("flat",), ("silver",)),
)  # fmt: skip
"""The module's categories."""
