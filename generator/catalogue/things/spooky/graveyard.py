"""Gravestones, coffins, boards of letters, gargoyles."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.outlines import arc, smooth
from ...build.recipes import ball, standing_plate
from ...build.settled import hull_above, limb
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, prism
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look


def tombstone(look: Look) -> Shape:
    """A round-headed gravestone on a base, RIP carved in it."""
    k = look.between(0.85, 1.15)
    color = look.color("gray", "gray", "silver", "charcoal")
    x, h, t = 0.09 * k, 0.12 * k, 0.02 * k
    outline = np.concatenate([[(-x / 2, 0), (x / 2, 0)], arc((0, h - x / 2), x / 2, 0, np.pi, 14)])
    slab = standing_plate(outline, t, bevel=0.002).move(z=0.012)
    foot = block(1.25 * x, 2.2 * t, 0.014, 0.003, 0.002)
    image = prints.canvas(120, 140, color)
    image[:] = textures.fit(textures.marble(look.rng, color, tint_color(color, 0.7)), 140, 120)
    dark = tint_color(color, 0.35)
    prints.write(image, "R.I.P.", 0.5, 0.4, 0.24, dark, bold=True)
    prints.stroke(image, [(0.5, 0.06), (0.5, 0.24)], 0.03, dark)
    prints.stroke(image, [(0.42, 0.12), (0.58, 0.12)], 0.03, dark)
    prints.lines(image, look.rng, (0.25, 0.62, 0.5, 0.22), 3, dark)
    face = box(0.84 * x, 0.0008, 0.74 * h).move(y=-t / 2, z=0.02)
    moss = [ball(0.02 * k, 0.014 * k, 0.008, (s * 0.5 * x, -0.6 * t, 0.014), 8) for s in (-1, 1)]
    stone = textures.marble(look.rng, color, tint_color(color, 0.7))
    return shape([(join([slab, foot]), stone), (face, image),
                  (join(moss), textures.spots(look.rng, (92, 120, 60), (70, 96, 46), 0.3))],
                 [hull_of(slab), hull_of(foot)])  # fmt: skip


def coffin(look: Look) -> Shape:
    """A small six-sided coffin lying, a cross on its lid."""
    k = look.between(0.85, 1.15)
    color = look.color("brown", "black", "wooden", "purple")
    outline = (
        np.array(
            [
                (-0.1, -0.022),
                (0.045, -0.045),
                (0.1, -0.026),
                (0.1, 0.026),
                (0.045, 0.045),
                (-0.1, 0.022),
            ]
        )
        * k
    )
    body = prism(outline * 0.97, 0, 0.036 * k)
    lid = prism(outline * 1.03, 0.034 * k, 0.046 * k, 0.003)
    cross = [box(0.09 * k, 0.011 * k, 0.003).move(x=0.0, z=0.045 * k),
             box(0.011 * k, 0.045 * k, 0.003).move(x=0.025 * k, z=0.045 * k)]  # fmt: skip
    wood = look.surface(color, "wood")
    return shape([(body, wood), (lid, wood), (join(cross), textures.plain((206, 172, 90)))],
                 [hull_of(body), hull_of(lid)])  # fmt: skip


def spirit_board(look: Look) -> Shape:
    """A board of letters and numbers, YES and NO, with its heart-shaped pointer."""
    k = look.between(0.94, 1.06)
    color = look.color("tan", "beige", "wooden", "brown")
    x, y = 0.36 * k, 0.25 * k
    image = textures.fit(textures.wood(look.rng, color), 200, 280).copy()
    ink = readable_on(color)
    prints.fill(image, 0.03, 0.04, 0.94, 0.012, ink)
    prints.fill(image, 0.03, 0.95, 0.94, 0.012, ink)
    prints.write(image[:, :80], "YES", 0.5, 0.15, 0.1, ink, bold=True)
    prints.write(image[:, 200:], "NO", 0.5, 0.15, 0.1, ink, bold=True)
    prints.disc(image, 0.08, 0.15, 0.04, ink)
    prints.disc(image, 0.92, 0.15, 0.05, ink, 0.035)
    for n, c in enumerate("ABCDEFGHIJKLMNOPQRSTUVWXYZ"):
        t = (n % 13) / 12
        u, v = 0.1 + 0.8 * t, 0.36 + 0.18 * (n // 13) - 0.1 * np.sin(np.pi * t)
        left = int(280 * u) - 12
        prints.write(image[:, left : left + 24], c, 0.5, v + 0.08, 0.1, ink, bold=True)
    prints.write(image, "1 2 3 4 5 6 7 8 9 0", 0.5, 0.73, 0.09, ink, bold=True)
    prints.write(image, "GOOD BYE", 0.5, 0.87, 0.09, ink, bold=True)
    board = block(x, y, 0.008, 0.008, 0.0015)
    face = box(0.98 * x, 0.97 * y, 0.0006).move(z=0.0077)
    pointer = pointer_solid(k).move(0.06 * k, -0.03 * k, 0.0125)
    legs = [cylinder(0.003, 0.0045, 8).move(0.06 * k + u, -0.03 * k + v, 0.0082)
            for u, v in ((0.02, -0.02), (-0.02, -0.02), (0, 0.028))]  # fmt: skip
    pale = look.own_color("ivory", "wooden", "black")
    return shape([(board, textures.wood(look.rng, tint_color(color, 0.8))), (face, image),
                  (join([pointer, *legs]), textures.wood(look.rng, pale))],
                 [box_part(x, y, 0.0082), hull_of(pointer, *legs)])  # fmt: skip


def pointer_solid(k: float) -> Solid:
    """Return a heart-shaped pointer with a round window, 5 mm thick."""
    half = smooth(
        [(0.0, 0.055), (0.026, 0.016), (0.036, -0.014), (0.024, -0.034), (0.0, -0.026)], 4
    )
    outline = np.concatenate([half[::-1], (half * [-1, 1])[1:-1]]) * k
    return prism(outline, 0, 0.005, 0.001)


def planchette(look: Look) -> Shape:
    """A heart-shaped pointer with a window, on three small feet."""
    k = look.between(0.95, 1.2)
    color = look.color("wooden", "ivory", "brown", "black")
    plate = pointer_solid(k).move(z=0.006)
    feet = [
        cylinder(0.004, 0.007, 10).move(u * k, v * k)
        for u, v in ((0.02, -0.02), (-0.02, -0.02), (0, 0.034))
    ]
    window = cylinder(0.011 * k, 0.0056, 20).move(z=0.006)
    return shape([(join([plate, *feet]), look.surface(color, "wood")),
                  (window, textures.plain((210, 226, 230)))],
                 [hull_of(plate), hull_of(*feet)])  # fmt: skip


def gargoyle(look: Look) -> Shape:
    """A figure hunched on a plinth, wings folded: a gargoyle of stone."""
    k = look.between(0.9, 1.1)
    color = look.color("gray", "charcoal", "silver")
    plinth = block(0.06, 0.06, 0.022, 0.003, 0.002)
    body = lathe(np.maximum(smooth([(0, 0.02), (0.024, 0.02), (0.028, 0.04), (0.018, 0.07), (0,
                 0.08)], 3), 0), 18)  # fmt: skip
    head = ball(0.034, 0.038, 0.03, (0, -0.014, 0.084), 14)
    horns = [limb([(s * 0.01, -0.006, 0.094), (s * 0.018, 0.004, 0.108), (s * 0.014, 0.012, 0.116)],
                  [0.005, 0.0035, 0.001], 6) for s in (-1, 1)]  # fmt: skip
    snout = ball(0.018, 0.018, 0.014, (0, -0.034, 0.078), 10)
    arms = [
        limb(
            [(s * 0.022, -0.006, 0.06), (s * 0.028, -0.024, 0.045), (s * 0.018, -0.026, 0.024)],
            [0.008, 0.007, 0.008],
            8,
        )
        for s in (-1, 1)
    ]
    wings = [
        prism(
            np.array([(0, 0), (0.03, 0.012), (0.034, 0.06), (0.018, 0.046), (0.004, 0.05)]),
            -0.0025,
            0.0025,
        )
        .turn(0, np.pi / 2)
        .turn(2, 0.5)
        .move(0.012, 0.014, 0.036)
    ]
    wings.append(Solid(wings[0].vertices * [-1, 1, 1], wings[0].faces[:, ::-1], wings[0].uv))
    stone = textures.spots(look.rng, color, tint_color(color, 0.7), 0.2)
    thing = join([body, head, *horns, snout, *arms, *wings])
    return shape([(plinth, stone), (thing, stone)],
                 [hull_of(plinth), hull_above(thing)]).scale(k)  # fmt: skip


_L = ("living",)
_D = "lying flat"


CATEGORIES = (
    Category("tombstone", tombstone, (0.116, 0.0454, 0.136), 0.3, ("gravestone", "gravestone prop",
             "headstone", "fake gravestone", "grave stone"), _L, ("tall",), ("gray",)),
    Category("coffin", coffin, (0.201, 0.0905, 0.0469), 0.2, ("toy coffin", "coffin prop",
             "mini coffin", "coffin box"), _L, ("support",), ("brown",)),
    Category("spirit_board", spirit_board, (0.358, 0.249, 0.0175), 0.5, ("ouija board", "ouija",
             "talking board", "witch board"), _L, ("big", "support"), ("tan",), state=_D),
    Category("planchette", planchette, (0.0825, 0.102, 0.0116), 0.03, ("ouija planchette",
             "ouija pointer"), _L, (), ("wooden",)),
    Category("gargoyle", gargoyle, (0.0872, 0.076, 0.118), 0.35, ("gargoyle figurine",
             "gargoyle statue", "stone gargoyle"), _L, (), ("gray",)),
)  # fmt: skip
"""The module's categories."""
