"""Brooms, cauldrons, fangs, cobwebs and other props of Halloween."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.recipes import ball, open_vessel, put_down, straight
from ...build.settled import lift_parts, limb, settle
from ...build.shape import Shape, shape
from ...build.solids import cylinder, join, prism, torus, tube
from ...build.variants import at_rest
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

STRAW: RGB = (206, 164, 96)


def broom(look: Look) -> Shape:
    """A small witch's broom lying: a crooked stick and a bound bundle of twigs."""
    k = look.between(0.9, 1.1)
    color = look.color("brown", "brown", "black", "wooden")
    stick = limb([(-0.2, 0.004, 0.02), (-0.08, -0.005, 0.022), (0.06, 0.004, 0.022)],
                 [0.006, 0.0065, 0.006], 8)  # fmt: skip
    twigs = []
    for n in range(38):
        away, a = np.sqrt((n + 0.5) / 38), 2.4 * n
        y, z = away * np.cos(a), away * np.sin(a)
        twigs.append(tube([(0.04, 0.008 * y, 0.022 + 0.008 * z), (0.1, 0.02 * y, 0.022 + 0.016 * z),
                           (0.165 + 0.012 * ((n * 7) % 3), 0.03 * y, 0.022 + 0.02 * z)],
                          [0.0022, 0.0024, 0.001], 5))  # fmt: skip
    rings = [torus(0.0115, 0.003, 18, 6).turn(1, np.pi / 2).move(x, 0, 0.022)
             for x in (0.055, 0.064)]  # fmt: skip
    return settle([(stick, look.surface(color, "wood")),
                   (join(twigs), textures.scratches(look.rng, STRAW, (150, 108, 56), 80)),
                   (join(rings), textures.plain((86, 60, 40)))], 0.06,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip


def fork(look: Look) -> Shape:
    """A devil's pitchfork lying: a shaft and three barbed prongs."""
    k = look.between(0.9, 1.1)
    color = look.color("red", "red", "black")
    shaft = straight((-0.2, 0, 0.006), (0.08, 0, 0.006), 0.0055)
    yoke = limb(
        [
            (0.15, -0.05, 0.006),
            (0.09, -0.046, 0.006),
            (0.076, 0, 0.006),
            (0.09, 0.046, 0.006),
            (0.15, 0.05, 0.006),
        ],
        [0.005] * 5,
        8,
    )
    prong = straight((0.07, 0, 0.006), (0.16, 0, 0.006), 0.005)
    tips = [prism(np.array([(0.145, y - 0.014), (0.185, y), (0.145, y + 0.014), (0.152, y)]), 0.002,
                  0.01) for y in (-0.051, 0, 0.051)]  # fmt: skip
    return settle([(shaft, textures.speckles(look.rng, tint_color(color, 0.9), 6)),
                   (join([yoke, prong, *tips]), textures.speckles(look.rng, color, 6))], 0.1,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip


def cauldron(look: Look) -> Shape:
    """A round black pot on three feet with a ring at each side, open above."""
    r, h = look.between(0.06, 0.08), look.between(0.1, 0.12)
    color = look.color("black", "black", "charcoal", "green")
    foot = 0.016
    side = [(0.3 * r, foot), (0.86 * r, foot + 0.12 * h), (1.04 * r, foot + 0.42 * h),
            (0.86 * r, foot + 0.84 * h), (0.96 * r, foot + h)]  # fmt: skip
    body, parts = open_vessel([(x, z - foot) for x, z in side], 0.006, 0.01, 30)
    body = body.move(z=foot)
    feet = [
        cylinder(0.009, foot + 0.02, 12, top=0.013).move(0.6 * r * np.cos(a), 0.6 * r * np.sin(a))
        for a in (0.5, 2.6, 4.7)
    ]
    rim = torus(0.95 * r, 0.005, 34, 8).move(z=foot + h - 0.004)
    ears = [torus(0.015, 0.0035, 16, 6).turn(0, np.pi / 2).move(s * (r + 0.012), 0, foot + 0.78 * h)
            for s in (-1, 1)]  # fmt: skip
    iron = textures.speckles(look.rng, tint_color(color, 0.9), 8)
    return shape([(body, iron), (join([*feet, rim, *ears]), iron)],
                 [*lift_parts(parts, foot), *(hull_of(f) for f in feet)])  # fmt: skip


def fangs(look: Look) -> Shape:
    """A set of plastic vampire teeth: two arches of gums, teeth, two long fangs."""
    k = look.between(0.95, 1.2)
    color = look.color("white", "white", "lime", "ivory")
    gums, teeth = [], []
    for level, way in ((0.005, 1), (0.026, -1)):
        curve = [(0.026 * np.cos(a), -0.03 * np.sin(a) + 0.01, level)
                 for a in np.linspace(-0.15, np.pi + 0.15, 9)]  # fmt: skip
        gums.append(limb(curve, [0.0052] * 9, 8))
        for n, a in enumerate(np.linspace(0.25, np.pi - 0.25, 8)):
            fang = way < 0 and n in (2, 5)
            long = 0.019 if fang else 0.0075
            at = (0.026 * np.cos(a), -0.03 * np.sin(a) + 0.007, level)
            tip = (at[0], at[1] - 0.001, level + way * long)
            teeth.append(tube([at, tip], [0.0042, 0.0008 if fang else 0.0034], 8))
    hinge = [
        tube([(s * 0.026, 0.013, 0.005), (s * 0.026, 0.016, 0.026)], 0.004, 8) for s in (-1, 1)
    ]
    return settle(
        [
            (join([*gums, *hinge]), textures.speckles(look.rng, (206, 70, 84), 8)),
            (join(teeth), textures.speckles(look.rng, color, 4)),
        ],
        0.05,
    ).scale(k)


def clown_nose(look: Look) -> Shape:
    """A red foam ball with a slit."""
    r = look.between(0.023, 0.027)
    color = look.color("red", "red", "red")
    body = ball(2 * r, 2 * r, 2 * r, (0, 0, 0), 24)
    hole = ball(0.9 * r, 0.5 * r, 0.9 * r, (0, 0.8 * r, 0.2 * r), 12)
    return settle(
        [
            (body, textures.speckles(look.rng, color, 6)),
            (hole, textures.plain(tint_color(color, 0.4))),
        ],
        0.1,
        hulls=[[0]],
    )


def cobweb(look: Look) -> Shape:
    """A spun web lying flat: spokes and sagging rings, a small spider on it."""
    k = look.between(0.85, 1.2)
    color = look.color("white", "white", "silver", "black")
    spokes, rings = [], []
    angles = 2 * np.pi * np.arange(8) / 8
    spokes += [tube([(0, 0, 0.0018), (0.115 * np.cos(a), 0.115 * np.sin(a), 0.0014)], 0.0014, 5)
               for a in angles]  # fmt: skip
    for r in (0.025, 0.048, 0.072, 0.098):
        points = []
        for a in angles:
            b = a + np.pi / 8
            points += [(r * np.cos(a), r * np.sin(a), 0.0014),
                       (0.82 * r * np.cos(b), 0.82 * r * np.sin(b), 0.0014)]  # fmt: skip
        rings.append(tube(np.array(points), 0.0012, 5, loop=True))
    bug = join([ball(0.014, 0.012, 0.01, (0.03, 0.012, 0.007), 10),
                ball(0.008, 0.008, 0.007, (0.022, 0.012, 0.006), 8)])  # fmt: skip
    net = join([*spokes, *rings])
    return put_down([(net, textures.plain(color)), (bug, textures.plain((30, 28, 32)))], net,
                    factor=k)  # fmt: skip


_L = ("living",)
_D = "lying flat"


CATEGORIES = (
    at_rest(Category("witch_broom", broom, (0.397, 0.0573, 0.0381), 0.08, ("witch's broom",
             "witches broom",
             "broomstick", "toy broom", "besom", "mini broom", "hand broom", "broom"), _L, (),
             ("brown",), state=_D)),
    Category("pitchfork", fork, (0.39, 0.132, 0.01), 0.1, ("devil's pitchfork", "pitchfork prop",
             "toy pitchfork", "trident", "devil fork"), _L, (), ("red",), state=_D),
    Category("cauldron", cauldron, (0.19, 0.134, 0.123), 0.35, ("witch's cauldron",
             "plastic cauldron", "mini cauldron", "toy cauldron", "black cauldron"), _L,
             ("container", "round"), ("black",)),
    Category("vampire_fangs", fangs, (0.067, 0.0507, 0.0323), 0.012, ("vampire teeth", "fangs",
             "plastic fangs", "fake teeth", "plastic teeth"), _L, (),
             ("white",)),
    Category("clown_nose", clown_nose, (0.0516, 0.0529, 0.0465), 0.004, ("red nose", "foam nose",
             "clown's nose"), _L, ("round",), ("red",)),
    Category("cobweb", cobweb, (0.251, 0.251, 0.013), 0.01, ("spider web", "spider's web",
             "fake cobweb", "spiderweb"), _L, ("flat",), ("white",), state=_D),
)  # fmt: skip
"""The module's categories."""
