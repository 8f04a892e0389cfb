"""Soft sweets: worms, bottles, pastilles, floss."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.outlines import smooth
from ...build.settled import settle
from ...build.shape import Shape, shape
from ...build.solids import ellipsoid, join, lathe, prism, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def candyfloss(look: Look) -> Shape:
    """Candyfloss: a pink cloud round a stick, lying."""
    k, color = look.between(0.85, 1.1), look.color("pink", "pink", "sky", "lavender", "mint")
    puffs = [
        ellipsoid(0.075, 0.07, 0.066, 12, 8).move(
            0.035 * np.cos(2.4 * n) - 0.02, 0.03 * np.sin(2.4 * n), 0.05 + 0.012 * np.cos(1.7 * n)
        )
        for n in range(8)
    ]
    stick = tube([(0.02, 0, 0.045), (0.2, 0, 0.004)], 0.0035, 8)
    fluff = textures.scratches(look.rng, color, tint_color(color, 1.4), 300)
    return settle(
        [(join(puffs), fluff), (stick, textures.plain((238, 222, 190)))], 0.08, hulls=[[0], [1]]
    ).scale(k)


def gummy_worm(look: Look) -> Shape:
    """A sour worm: a ribbed jelly worm of two colours, sugared."""
    long = look.between(0.07, 0.1)
    color = look.color("red", "green", "orange", "sky", "yellow", "pink")
    other = look.own_color("yellow", "lime", "sky", "pink")
    u = np.linspace(-1, 1, 25)
    path = np.column_stack([long / 2 * u, 0.012 * np.sin(5 * u), 0 * u])
    body = tube(path, 0.0042 * (1 + 0.12 * np.cos(30 * u)) * np.maximum(1 - u**8, 0.1), 8)
    half = np.where((np.linspace(0, 1, 96) > 0.5)[:, None, None], np.array(color), np.array(other))
    tile = np.broadcast_to(half, (96, 64, 3)).astype(np.uint8).copy()
    for _ in range(160):
        a, b = look.rng.integers(0, 95), look.rng.integers(0, 63)
        tile[a, b] = 250
    return settle([(body, tile)], 0.16)


def cola_bottle(look: Look) -> Shape:
    """A cola bottle sweet: a flat jelly bottle, brown below, clear above."""
    k, color = look.between(0.9, 1.2), look.color("brown", "maroon", "copper")
    side = smooth(
        [(-0.016, 0.0075), (-0.006, 0.0055), (0.002, 0.0072), (0.008, 0.004), (0.016, 0.003)], 3
    )
    outline = np.concatenate([side[::-1], side * [1, -1]])
    body = prism(outline, 0, 0.006)
    tile = np.where(
        (np.linspace(0, 1, 64) > 0.62)[None, :, None], np.array((246, 206, 140)), np.array(color)
    )
    return shape(
        [(body.scale(k, k, k), np.broadcast_to(tile, (64, 64, 3)).astype(np.uint8).copy())],
        [hull_of(body.scale(k, k, k))],
    )


def pastille(look: Look) -> Shape:
    """A fruit pastille: a sugared disc with a rounded top; a lozenge is an oval."""
    r, color = (
        look.between(0.0095, 0.0125),
        look.color("red", "green", "yellow", "orange", "purple", "black"),
    )
    body = lathe([(0, 0), (r, 0), (0.95 * r, 0.5 * r), (0.6 * r, 0.75 * r), (0, 0.78 * r)], 24)
    body = body.scale(look.pick([1.0, 1.3]), 1, 1)
    return shape(
        [(body, textures.spots(look.rng, color, tint_color(color, 1.5), 0.25))], [hull_of(body)]
    )


_F = ("food",)


_E, _R = ("edible",), ("edible", "round")

CATEGORIES = (
    Category("candyfloss", candyfloss, (0.281, 0.124, 0.0834), 0.03, ("candy floss",
        "cotton candy", "fairy floss", "stick of candyfloss"), _F, _E, ("pink",), state="lying"),
    Category("gummy_worm", gummy_worm, (0.0867, 0.0314, 0.0079), 0.005,
             ("sour worm", "jelly worm", "jelly snake", "gummy snake", "earthworm"), _F,
             _E, ("red",), state="lying"),
    Category("cola_bottle_sweet", cola_bottle, (0.0342, 0.016, 0.0064), 0.004,
             ("cola bottle", "gummy bottle", "fizzy cola bottle"), _F, _E, ("brown",),
             state="lying flat"),
    Category("fruit_pastille", pastille, (0.0266, 0.0224, 0.00874), 0.003,
             ("pastille", "wine gum", "gumdrop", "gum drop", "lozenge",
              "fruit gum", "jelly sweet"), _F, _E,
             ("red",)),
)  # fmt: skip
"""The module's categories."""
