"""Lidded tea bowls, warmers for pots, dishes for spoons."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of, ring_parts
from ...build.forms import facing
from ...build.recipes import open_vessel
from ...build.settled import limb
from ...build.shape import Shape, shape
from ...build.solids import cylinder, ellipsoid, join, lathe, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def gaiwan(look: Look) -> Shape:
    """A gaiwan: a lidded Chinese tea bowl on its saucer."""
    k, color = look.between(0.88, 1.1), look.color("white", "sky", "mint", "teal", "cream", "red")
    saucer = lathe(
        [(0, 0), (0.03, 0), (0.055, 0.012), (0.056, 0.015), (0.03, 0.005), (0, 0.005)], 32
    )
    bowl = lathe(
        [
            (0, 0.005),
            (0.02, 0.005),
            (0.022, 0.012),
            (0.036, 0.034),
            (0.046, 0.06),
            (0.048, 0.064),
            (0, 0.064),
        ],
        32,
    )
    lid = lathe(
        [
            (0, 0.062),
            (0.041, 0.062),
            (0.03, 0.076),
            (0.012, 0.08),
            (0.015, 0.09),
            (0.013, 0.092),
            (0, 0.088),
        ],
        28,
    )
    image = textures.fit(look.surface(color, "ceramic"), 96, 192).copy()
    ink = tint_color(look.own_color("blue", "navy", "red", "green"), 1.0)
    for n in range(5):
        x = 0.1 + 0.2 * n
        prints.stroke(image, [(x - 0.06, 0.6), (x, 0.42), (x + 0.05, 0.62)], 0.02, ink)
        prints.disc(image, x, 0.42, 0.06, ink)
    made = [(join([saucer, lid]), look.surface(color, "ceramic")), (bowl, image)]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made, [hull_of(saucer.scale(k, k, k)), hull_of(made[1][0]), hull_of(lid.scale(k, k, k))]
    )


def tea_warmer(look: Look) -> Shape:
    """A tea warmer: a pierced ring on which a pot stands, a tea light inside."""
    k, color = look.between(0.88, 1.1), look.color("white", "black", "teal", "silver", "terracotta")
    wall = lathe(
        [(0.058, 0), (0.066, 0), (0.068, 0.05), (0.06, 0.056), (0.05, 0.056), (0.058, 0.046)],
        34,
        loop=True,
    )
    floor, candle = (
        cylinder(0.06, 0.004, 30),
        lathe([(0, 0.004), (0.019, 0.004), (0.019, 0.018), (0, 0.018)], 18),
    )
    flame = ellipsoid(0.006, 0.006, 0.014, 8, 6).move(z=0.026)
    holes = [
        facing(cylinder(0.009, 0.002, 14)).move(y=-0.0662, z=0.026).turn(2, a)
        for a in np.arange(9) * 0.698
    ]
    made = [
        (join([wall, floor]), look.surface(color, "ceramic")),
        (candle, textures.plain((246, 242, 230))),
        (flame, textures.plain((255, 190, 70))),
        (join(holes), textures.plain((52, 40, 34))),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made,
        [
            *ring_parts(
                [(0.062 * k, 0), (0.067 * k, 0.05 * k), (0.062 * k, 0.056 * k)],
                [(0.05 * k, 0.056 * k), (0.057 * k, 0.0)],
                12,
            ),
            hull_of(floor.scale(k, k, k)),
        ],
    )


def caddy_dish(look: Look) -> Shape:
    """A tiny shallow dish for a teaspoon or a used tea bag, sometimes shaped like a teapot."""
    k, color = (
        look.between(0.88, 1.12),
        look.color("white", "sky", "pink", "mint", "yellow", "teal"),
    )
    body, parts = open_vessel(
        [(0.034 * k, 0), (0.044 * k, 0.006 * k), (0.052 * k, 0.016 * k)], 0.003, 0.003
    )
    tile = look.surface(color, "ceramic")
    pieces = [(body, tile)]
    if look.chance(0.6):
        grip = torus(0.014 * k, 0.0035 * k, 18, 7).move(0.06 * k, 0, 0.012 * k)
        spout = limb(
            [(-0.046 * k, 0, 0.008 * k), (-0.062 * k, 0, 0.012 * k), (-0.072 * k, 0, 0.016 * k)],
            [0.008 * k, 0.006 * k, 0.004 * k],
            8,
        )
        pieces.append((join([grip, spout]), tile))
    return shape(pieces, parts)


_K = ("kitchen",)

CATEGORIES = (
    Category("gaiwan", gaiwan, (0.115, 0.115, 0.0941), 0.22, ("lidded tea bowl",
        "chinese tea bowl", "lidded cup"), _K, ("round",), ("white",)),
    Category("tea_warmer", tea_warmer, (0.133, 0.131, 0.054), 0.4, ("teapot warmer",
        "teapot stand", "rechaud"), _K, ("round", "support"), ("white",)),
    Category("spoon_dish", caddy_dish, (0.13, 0.107, 0.0183), 0.08, ("teaspoon dish",
        "tea bag tidy", "teabag tidy", "tea bag holder", "tea bag rest", "teaspoon rest",
        "teabag dish", "tea bag dish"), _K,
             ("container",), ("white",)),
)  # fmt: skip
"""The module's categories."""
