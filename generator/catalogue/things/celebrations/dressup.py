"""Things to dress up with, and party balloons of foil."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.outlines import smooth
from ...build.recipes import put_down
from ...build.settled import hull_above, limb, settle
from ...build.shape import Shape, shape
from ...build.solids import block, cylinder, ellipsoid, join, lathe, loft, prism, torus
from ...build.variants import at_rest, vary
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def devil_horns(look: Look) -> Shape:
    """A headband lying with two red horns."""
    k = look.between(0.94, 1.06)
    color = look.color("red", "red", "black", "purple")
    band = limb(
        [
            (-0.065, 0.05, 0.004),
            (-0.07, 0, 0.004),
            (-0.04, -0.055, 0.004),
            (0.0, -0.07, 0.004),
            (0.04, -0.055, 0.004),
            (0.07, 0, 0.004),
            (0.065, 0.05, 0.004),
        ],
        [0.0042] * 7,
        8,
    )
    horns = [
        limb(
            [
                (s * 0.03, -0.06, 0.012),
                (s * 0.045, -0.085, 0.016),
                (s * 0.04, -0.115, 0.014),
                (s * 0.03, -0.13, 0.012),
            ],
            [0.0155, 0.012, 0.006, 0.001],
            12,
        )
        for s in (-1, 1)
    ]
    return settle([(band, textures.plain((30, 28, 30))),
                   (join(horns), textures.stripes([color, tint_color(color, 0.82)], 6))], 0.06,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip


def eye_patch(look: Look) -> Shape:
    """A black eye patch lying with its elastic; a skull or plain."""
    k = look.between(0.94, 1.08)
    color = look.color("black", "black", "brown")
    half = smooth([(0.0, -0.036), (0.024, -0.022), (0.034, 0.008), (0.03, 0.026), (0.0, 0.028)], 4)
    outline = np.concatenate([half, (half * [-1, 1])[-2:0:-1]])
    patch = prism(outline, 0, 0.004, 0.0015)
    cord = limb([(-0.03, 0.022, 0.002), (-0.08, 0.05, 0.002), (-0.05, 0.11, 0.002), (0.05, 0.11,
                0.002), (0.08, 0.05, 0.002), (0.03, 0.022, 0.002)], [0.0018] * 6, 6)  # fmt: skip
    bone = [ellipsoid(0.022, 0.019, 0.002, 12, 4).move(0, 0.004, 0.004),
            block(0.012, 0.01, 0.001, 0.002).move(0, -0.009, 0.0037)]  # fmt: skip
    eyes = [cylinder(0.0028, 0.0006, 10).move(s * 0.0046, 0.004, 0.0047) for s in (-1, 1)]
    cloth = textures.fabric(look.rng, tint_color(color, 0.8))
    return put_down(
        [
            (patch, cloth),
            (cord, textures.plain((24, 24, 26))),
            (join(bone), textures.plain((244, 242, 234))),
            (join(eyes), textures.plain((24, 24, 26))),
        ],
        patch,
        cord,
        factor=k,
    )


def hook(look: Look) -> Shape:
    """A pirate's hook lying: a cuff and a bent steel hook."""
    k = look.between(0.94, 1.06)
    color = look.color("black", "brown", "red")
    cuff = lathe([(0, 0), (0.04, 0), (0.034, 0.07), (0, 0.07)], 26).turn(1, np.pi / 2)
    rim = torus(0.039, 0.004, 26, 6).turn(1, np.pi / 2)
    stem = limb([(0.065, 0, 0), (0.11, 0, 0), (0.15, 0.02, 0), (0.165, 0.055, 0), (0.14, 0.085, 0),
                 (0.105, 0.075, 0)], [0.007, 0.007, 0.0068, 0.006, 0.0045, 0.001], 10)  # fmt: skip
    return settle([(cuff, look.surface(color, "plastic")), (rim, textures.plain((214, 176, 90))),
                   (stem, textures.brushed_metal(look.rng, (200, 203, 208)))], 0.06,
                  hulls=[[0, 1], [2]]).scale(k)  # fmt: skip


def kazoo(look: Look) -> Shape:
    """A kazoo lying: a flattened tube with a round turret."""
    k = look.between(0.94, 1.08)
    color = look.color("red", "blue", "yellow", "silver", "green", "gold")
    body = limb([(-0.06, 0, 0), (-0.02, 0, 0), (0.03, 0, 0), (0.06, 0, 0)],
                [0.013, 0.0145, 0.013, 0.008], 16, squash=0.75)  # fmt: skip
    turret = cylinder(0.011, 0.012, 22, bevel=0.001).move(0.0, 0, 0.006)
    cap = cylinder(0.0075, 0.001, 18).move(0.0, 0, 0.0178)
    end = cylinder(0.0085, 0.001, 16).turn(1, np.pi / 2).scale(1, 1, 0.75).move(x=-0.0608)
    return settle(
        [
            (join([body, turret]), look.surface(color, "plastic")),
            (join([cap, end]), textures.plain(tint_color(color, 0.45))),
        ],
        0.12,
    ).scale(k)


def foil_balloon(look: Look) -> Shape:
    """A shiny foil balloon lying: a heart, a star or a round, its tail and ribbon out."""
    k = look.between(0.9, 1.1)
    color = look.color("silver", "gold", "pink", "red", "blue")
    kind = look.pick(["star", "heart", "star"])
    n = 60
    a = 2 * np.pi * np.arange(n) / n
    if kind == "star":
        away = 0.1 + 0.032 * np.cos(5 * a - np.pi / 2 * 5)
        ring = np.column_stack([away * np.cos(a), away * np.sin(a)])
    else:
        ring = 0.0075 * np.column_stack([16 * np.sin(a) ** 3, 13 * np.cos(a) - 5 * np.cos(
            2 * a) - 2 * np.cos(3 * a) - np.cos(4 * a)])[::-1]  # fmt: skip
    levels = [
        (0.35, 0),
        (0.7, 0.004),
        (0.93, 0.018),
        (1.0, 0.03),
        (0.93, 0.042),
        (0.7, 0.056),
        (0.35, 0.062),
    ]
    body = loft(np.stack([np.column_stack([ring * f, np.full(n, z)]) for f, z in levels]), ring)
    tail = prism(
        np.array([(-0.012, -0.125), (0.012, -0.125), (0.005, -0.08), (-0.005, -0.08)]), 0.026, 0.03
    )
    string = limb([(0, -0.122, 0.026), (0.02, -0.15, 0.004), (-0.01, -0.19, 0.003), (0.02, -0.23,
                  0.003)], [0.0015] * 4, 5)  # fmt: skip
    foil = textures.gradient(tint_color(color, 0.8), tint_color(color, 1.4), look.rng)
    return shape([(join([body, tail]), foil), (string, textures.plain((240, 240, 236)))],
                 [hull_of(body), hull_above(tail), hull_above(string)]).scale(k)  # fmt: skip


_L = ("living",)
_D = "lying flat"


CATEGORIES = (
    vary(Category("devil_horns", devil_horns, (0.151, 0.181, 0.0298), 0.04, ("horned headband",
             "devil horn headband", "devil headband"), _L, (), ("red",), state=_D)),
    vary(Category("eye_patch", eye_patch, (0.162, 0.154, 0.00524), 0.008, ("pirate eye patch",
             "eyepatch", "eye patch for pirate"), _L, ("flat",), ("black",), state=_D)),
    at_rest(Category("hook_hand", hook, (0.175, 0.133, 0.0805), 0.09, ("pirate hook", "hand hook",
             "captain hook's hook"), _L, (), ("black",), state=_D)),
    Category("kazoo", kazoo, (0.119, 0.0285, 0.0256), 0.015, ("kazoo toy", "toy kazoo",
             "metal kazoo"), _L, (), ("red", "blue"), state=_D),
    Category("foil_balloon", foil_balloon, (0.246, 0.355, 0.0607), 0.03, ("mylar balloon",
             "star balloon", "heart balloon", "helium balloon"), _L, (), ("silver", "gold"),
             state=_D),
)  # fmt: skip
"""The module's categories."""
