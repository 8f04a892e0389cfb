"""Pots, spices and pipes of the Levant and India."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of, hull_part
from ...build.outlines import smooth
from ...build.recipes import ball, open_vessel, straight
from ...build.settled import hull_above, limb
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, join, lathe, torus
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def cezve(look: Look) -> Shape:
    """A small pot for Turkish coffee with a long rising handle, open above."""
    k = look.between(0.92, 1.1)
    color = look.color("copper", "copper", "brass", "silver")
    r, h = 0.038 * k, 0.072 * k
    side = [(0.9 * r, 0), (r, 0.1 * h), (0.86 * r, 0.6 * h), (0.72 * r, 0.84 * h), (0.86 * r, h)]
    body, parts = open_vessel(side, 0.0026, 0.003, 30)
    grip = limb([(0.78 * r, 0, 0.84 * h), (1.6 * r, 0, 1.0 * h), (3.6 * r, 0, 1.45 * h)],
                [0.004, 0.0045, 0.006], 8)  # fmt: skip
    lip = ball(0.018 * k, 0.016 * k, 0.01 * k, (0, -0.84 * r, 0.98 * h), 10)
    brew = cylinder(0.8 * r, 0.0016, 26).move(z=0.55 * h)
    metal = textures.brushed_metal(look.rng, color)
    foam = textures.spots(look.rng, (96, 58, 34), (150, 104, 64), 0.3)
    pieces: list[tuple[Solid, textures.Tile]] = [(join([body, lip]), metal), (grip, look.surface(
        look.own_color("brown", "black"), "wood"))]  # fmt: skip
    if look.attributes.get("state") != "empty":
        pieces.append((brew, foam))
    return shape(pieces, [*parts, hull_of(grip)])


def dallah(look: Look) -> Shape:
    """An Arabic coffee pot: a waisted body, a tall pointed lid, a beak of a spout."""
    k = look.between(0.92, 1.08)
    color = look.color("gold", "brass", "silver", "copper")
    body = lathe(np.maximum(smooth([(0, 0), (0.05, 0), (0.056, 0.01), (0.058, 0.05), (0.036, 0.1),
                 (0.03, 0.125), (0.042, 0.155), (0, 0.157)], 3), 0), 30)  # fmt: skip
    lid = lathe(np.maximum(smooth([(0, 0.155), (0.043, 0.155), (0.036, 0.175), (0.014, 0.2), (0.006,
                0.215), (0.009, 0.225), (0.002, 0.245), (0, 0.246)], 3), 0), 26)  # fmt: skip
    spout = limb([(-0.03, 0, 0.1), (-0.062, 0, 0.13), (-0.078, 0, 0.16), (-0.1, 0, 0.168)],
                 [0.017, 0.013, 0.009, 0.004], 10)  # fmt: skip
    grip = limb([(0.032, 0, 0.148), (0.075, 0, 0.15), (0.086, 0, 0.1), (0.055, 0, 0.045)],
                [0.006, 0.007, 0.0065, 0.005], 8)  # fmt: skip
    bands = [torus(r, 0.0022, 28, 6).move(z=z) for r, z in ((0.0585, 0.045), (0.031, 0.122))]
    metal = textures.brushed_metal(look.rng, color)
    return shape(
        [
            (join([body, lid]), metal),
            (join([spout, grip]), metal),
            (join(bands), textures.plain(tint_color(color, 0.7))),
        ],
        [hull_of(body), hull_of(lid), hull_of(spout), hull_of(grip)],
    ).scale(k)


def spice_box(look: Look) -> Shape:
    """A round steel box with seven bowls of spices, its lid beside under it."""
    k = look.between(0.94, 1.06)
    color = look.color("silver", "silver", "copper")
    r, h = 0.095 * k, 0.045 * k
    tin, parts = open_vessel([(r, 0), (r, h)], 0.002, 0.003, 40)
    bowls, heaps = [], {}
    tones = ((214, 150, 30), (170, 40, 26), (96, 60, 34), (60, 46, 36), (200, 176, 110),
             (140, 112, 50), (190, 96, 40))  # fmt: skip
    for n in range(7):
        a = n * np.pi / 3
        at = (0.0, 0.0) if n == 6 else (0.62 * r * float(np.cos(a)), 0.62 * r * float(np.sin(a)))
        cup = lathe([(0, 0.003), (0.26 * r, 0.003), (0.285 * r, 0.74 * h), (0.27 * r, 0.74 * h),
                     (0.25 * r, 0.5 * h), (0, 0.5 * h)], 20).move(*at)  # fmt: skip
        bowls.append(cup)
        heaps[n] = (ball(0.5 * r, 0.5 * r, 0.3 * h, (at[0], at[1], 0.58 * h), 14),
                 textures.speckles(
            look.rng, tones[n], 14))  # fmt: skip
    steel = textures.brushed_metal(look.rng, color)
    return shape([(join([tin, *bowls]), steel), *heaps.values()],
                 [*parts, cylinder_part(0.93 * r, 0.7 * h)])  # fmt: skip


def _thirds(count: int) -> list[tuple[int, int]]:
    """Return the ranges of four equal runs of ``count`` points along a hose."""
    step = count // 4
    return [(n * step, (n + 1) * step if n < 3 else count) for n in range(4)]


def hookah(look: Look) -> Shape:
    """A water pipe: a glass vase, a brass stem, a clay bowl and a hose."""
    k = look.between(0.92, 1.08)
    color = look.color("blue", "green", "purple", "red", "amber")
    vase = lathe(np.maximum(smooth([(0, 0), (0.055, 0), (0.064, 0.012), (0.06, 0.05), (0.03, 0.1),
                 (0.02, 0.14), (0.023, 0.16), (0, 0.162)], 3), 0), 28)  # fmt: skip
    stem = lathe(np.maximum(smooth([(0, 0.155), (0.018, 0.155), (0.012, 0.18), (0.016, 0.2), (0.009,
                 0.23), (0.014, 0.27), (0.008, 0.3), (0, 0.302)], 3), 0), 20)  # fmt: skip
    tray = cylinder(0.045, 0.004, 28, bevel=0.001).move(z=0.295)
    bowl = lathe([(0, 0.298), (0.012, 0.298), (0.024, 0.32), (0.027, 0.345), (0.022, 0.345), (0,
                  0.335)], 22)  # fmt: skip
    coal = [box(0.013, 0.013, 0.011).turn(2, n).move(0.008 * np.cos(2 * n), 0.008 * np.sin(2 * n),
            0.34) for n in range(3)]  # fmt: skip
    hose = limb([(0.012, 0, 0.2), (0.06, -0.01, 0.19), (0.105, -0.03, 0.1), (0.11, -0.07, 0.012),
                 (0.03, -0.1, 0.008), (-0.06, -0.095, 0.008)], [0.0065] * 6, 8)  # fmt: skip
    tip = straight((-0.05, -0.0955, 0.008), (-0.11, -0.09, 0.008), [0.0075, 0.004])
    brass = textures.brushed_metal(look.rng, (206, 166, 82))
    return shape(
        [
            (vase, textures.gradient(tint_color(color, 0.7), tint_color(color, 1.2), look.rng)),
            (join([stem, tray, tip]), brass),
            (bowl, textures.plain((160, 90, 60))),
            (join(coal), textures.plain((60, 40, 36))),
            (hose, textures.stripes([color, tint_color(color, 0.6)], 14)),
        ],
        [
            hull_of(vase),
            hull_of(stem, bowl),
            hull_of(tray),
            hull_above(tip),
            *(
                hull_part(np.maximum(hose.vertices[a:b], [-9, -9, 0]))
                for a, b in _thirds(len(hose.vertices))
            ),
        ],
    ).scale(k)


_C = ("coffee",)


CATEGORIES = (
    Category("cezve", cezve, (0.175, 0.0766, 0.109), 0.25, ("turkish coffee pot", "ibrik", "briki",
             "turkish pot"), _C, ("container",), ("copper",)),
    Category("dallah", dallah, (0.195, 0.122, 0.247), 0.7, ("arabic coffee pot",
             "arabian coffee pot", "brass coffee pot"), _C, ("tall",), ("gold",)),
    Category("masala_dabba", spice_box, (0.189, 0.189, 0.0448), 0.7, ("spice box",
             "indian spice box", "masala box", "spice tray"), ("kitchen",), ("round",),
             ("silver",)),
    Category("hookah", hookah, (0.23, 0.171, 0.348), 1.5, ("shisha", "water pipe", "shisha pipe",
             "nargile"), ("living",), ("tall",), ("blue",)),
)  # fmt: skip
"""The module's categories."""
