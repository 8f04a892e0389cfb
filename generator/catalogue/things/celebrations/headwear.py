"""Hats for a feast: Santa's, an elf's, a paper crown."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of, ring_parts
from ...build.recipes import ball
from ...build.settled import hull_above, limb
from ...build.shape import Shape, shape
from ...build.solids import join, lathe, torus, tube
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def santa_hat(look: Look) -> Shape:
    """A red cap with a white fur brim, its tip fallen over, a bobble."""
    k = look.between(0.92, 1.08)
    color = look.color("red", "red", "crimson")
    cone = limb(
        [(0, 0, 0.02), (0, 0, 0.07), (0.015, 0, 0.125), (0.065, 0, 0.135), (0.105, 0, 0.09)],
        [0.082, 0.07, 0.042, 0.024, 0.01],
        20,
    )
    brim = torus(0.082, 0.022, 36, 10).move(z=0.022)
    bob = ball(0.046, 0.046, 0.046, (0.112, 0, 0.07), 16)
    fur = textures.scratches(look.rng, (250, 248, 244), (226, 224, 220), 120)
    return shape([(cone, textures.fabric(look.rng, color)), (join([brim, bob]), fur)],
                 [hull_of(brim), hull_above(cone), hull_of(bob)]).scale(k)  # fmt: skip


def elf_hat(look: Look) -> Shape:
    """A pointed cap with a zigzag collar and a bell at its tip."""
    k = look.between(0.92, 1.08)
    color = look.color("green", "green", "red")
    cone = limb([(0, 0, 0.004), (0, 0, 0.06), (0.01, 0, 0.13), (0.04, 0, 0.18)],
                [0.085, 0.068, 0.034, 0.006], 20)  # fmt: skip
    collar = lathe([(0.086, 0), (0.095, 0.004), (0.084, 0.03), (0.076, 0.03)], 40, loop=True)
    zigzag = collar.bend(lambda p: p * np.column_stack([np.ones((len(p), 2)), 1 + 0.35 * np.sign(
        p[:, 2] - 0.01) * np.cos(10 * np.arctan2(p[:, 1], p[:, 0]))]))  # fmt: skip
    bell = ball(0.022, 0.022, 0.022, (0.044, 0, 0.184), 12)
    trim = textures.fabric(look.rng, look.own_color("red", "yellow") if color[1] > color[0]
                           else look.own_color("green", "yellow"))  # fmt: skip
    return shape([(cone, textures.fabric(look.rng, color)), (zigzag, trim),
                  (bell, textures.plain((222, 182, 80)))],
                 [hull_of(zigzag), hull_above(cone), hull_of(bell)]).scale(k)  # fmt: skip


def paper_crown(look: Look) -> Shape:
    """A thin paper crown out of a cracker, standing: a ring with points."""
    k = look.between(0.92, 1.08)
    color = look.color("yellow", "red", "green", "purple", "orange", "blue")
    r, h, t = 0.085, 0.075, 0.0022
    ring = lathe([(r, 0), (r, 0.6 * h), (r, h), (r - t, h), (r - t, 0.6 * h), (r - t, 0)], 72,
                 loop=True)  # fmt: skip
    points = ring.bend(
        lambda p: (
            p
            * np.column_stack(
                [
                    np.ones((len(p), 2)),
                    np.where(
                        p[:, 2] > 0.8 * h, 0.8 + 0.2 * np.cos(9 * np.arctan2(p[:, 1], p[:, 0])), 1.0
                    ),
                ]
            )
        )
    )
    folds = [tube([((r + 0.0006) * np.cos(a), (r + 0.0006) * np.sin(a), 0.001), ((r + 0.0006) *
             np.cos(a), (r + 0.0006) * np.sin(a), 0.6 * h)], 0.0008, 4)
             for a in 2 * np.pi * np.arange(6) / 6]  # fmt: skip
    return shape([(points, textures.speckles(look.rng, color, 5)),
                  (join(folds), textures.plain(tint_color(color, 0.8)))],
                 ring_parts([(r, 0), (r, 0.92 * h)], [(r - t, 0.92 * h), (r - t, 0)], 14)
                 ).scale(k)  # fmt: skip


_L = ("living",)
CATEGORIES = (
    vary(Category("santa_hat", santa_hat, (0.238, 0.207, 0.166), 0.06, ("santa's hat",
             "christmas hat",
             "father christmas hat", "santa claus hat"), _L, (), ("red",))),
    Category("elf_hat", elf_hat, (0.191, 0.191, 0.196), 0.06, ("elf's hat", "pixie hat",
             "gnome hat", "christmas elf hat"), _L, ("tall",), ("green",)),
    Category("paper_crown", paper_crown, (0.175, 0.172, 0.076), 0.004, ("cracker crown",
             "christmas cracker hat", "tissue paper crown", "cracker hat", "cardboard crown"), _L,
             ("round",), ("yellow",)),
)  # fmt: skip
"""The module's categories."""
