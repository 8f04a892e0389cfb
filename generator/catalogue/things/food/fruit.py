"""More fruit: whole, sliced, bunched."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, flat_foot, hull_of
from ...build.forms import blade, speck
from ...build.outlines import arc, smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, ellipsoid, join, lathe, prism, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ...surfaces.textures import Tile
from .food import press_flat, skin

LEAF: RGB = (78, 130, 58)


def _diamonds(look: Look, color: RGB) -> Tile:
    """A pineapple's skin: slanted rows of eyes with dark seams."""
    y, x = np.mgrid[0:128, 0:128] / 128
    a, b = (8 * x + 7 * y) % 1 - 0.5, (8 * x - 7 * y) % 1 - 0.5
    eye = np.exp(-(a**2 + b**2) / 0.012)
    seam = np.maximum(np.abs(a), np.abs(b)) > 0.4
    shade = 1.08 - 0.5 * eye - 0.45 * seam + 0.1 * textures.noise(look.rng, 128, 128, (4, 4), 2)
    return np.clip(np.array(color) * shade[..., None], 0, 255).astype(np.uint8)


def pineapple(look: Look) -> Shape:
    """A pineapple standing, crowned with stiff leaves."""
    r, h = look.between(0.046, 0.058), look.between(0.13, 0.17)
    color = look.color("amber", "mustard", "golden", "olive")
    body = lathe(
        [(0, 0), (0.6 * r, 0), (0.85 * r, 0.08 * h), (r, 0.3 * h), (r, 0.6 * h),
         (0.86 * r, 0.84 * h), (0.5 * r, 0.98 * h), (0, h)],
        26,
    )  # fmt: skip
    crown, long = [], look.between(0.075, 0.1)
    for ring, (count, lean) in enumerate([(9, 0.75), (8, 0.45), (5, 0.16)]):
        for k in range(count):
            angle = 2 * np.pi * (k + 0.5 * ring) / count
            way = np.array([np.cos(angle), np.sin(angle), 0]) * lean * long
            foot = np.array([0, 0, 0.94 * h]) + 0.2 * r * way / np.linalg.norm(way)
            rise = np.array([0, 0, long * (0.55 + 0.22 * ring)])
            crown.append(blade([foot, foot + 0.35 * way + 0.6 * rise, foot + way + rise], 0.022))
    green = textures.leaf(look.rng, look.own_color("sage", "green", "olive"))
    low = hull_of(body)
    return shape(
        [(body, _diamonds(look, color)), (join(crown), green)],
        [low, cylinder_part(0.45 * r, 0.9 * long, (0, 0, 0.94 * h))],
    )


def watermelon_slice(look: Look) -> Shape:
    """A slice of watermelon lying flat: flesh with seeds, pale and green rind."""
    r, thick = look.between(0.085, 0.12), look.between(0.018, 0.03)
    half = look.pick([np.pi / 2, np.pi / 2, 0.62, 0.75])
    color = look.color("red", "coral", "red", "crimson", "amber")
    side = textures.speckles(look.rng, color, 10, 96)
    flesh = speck(side, look.rng, (40, 28, 24), int(look.rng.integers(16, 30)))

    def band(inner: float, outer: float) -> Solid:
        out = arc((0, 0), outer * r, -half, half, 16)
        back = arc((0, 0), inner * r, half, -half, 16) if inner else np.zeros((1, 2))
        if inner == 0 and half > 1.5:
            return prism(out, 0, thick)
        return prism(np.concatenate([out, back]), 0, thick)

    rind = look.own_color("green", "lime", "green")
    dark = textures.stripes([rind, tint_color(rind, 0.6)], 12, upright=True)
    solids = [band(0, 0.86), band(0.86, 0.92), band(0.92, 1.0)]
    tiles = [flesh, textures.plain((228, 234, 196)), dark]
    turned = [s.turn(2, -np.pi / 2) for s in solids]
    return shape(zip(turned, tiles, strict=True), [hull_of(*turned)])


def grapes(look: Look) -> Shape:
    """A bunch of grapes lying, with its stalk."""
    d = look.between(0.019, 0.024)
    color = look.color("purple", "lime", "crimson", "indigo", "sage")
    rows = [(1, 0), (2, 1), (3, 2), (4, 2), (4, 3), (3, 2)]
    balls = []
    for i, (low, high) in enumerate(rows):
        for level, count in enumerate((low, high)):
            for k in range(count):
                jitter = look.rng.uniform(-0.14, 0.14, 3) * d
                x, y = (i - 2.5 + 0.4 * level) * 0.84 * d, (k - (count - 1) / 2) * 0.92 * d
                z = (0.47 + 0.7 * level) * d
                balls.append(ellipsoid(1.06 * d, d, d, 11, 7).move(*(np.array([x, y, z]) + jitter)))
    end = 2.6 * d
    stalk = tube(smooth([(-d, 0, d), (end, 0, 1.3 * d), (end + 1.4 * d, 0.4 * d, 1.5 * d)], 3),
                 0.0024, 6)  # fmt: skip
    fruit = join(balls)
    bloom = skin(look, color, tint_color(color, 1.35), 0.8)
    return shape(
        [(fruit, bloom), (stalk, textures.plain((108, 96, 56)))],
        [flat_foot(fruit.vertices)],
    )


def strawberry(look: Look) -> Shape:
    """A strawberry lying on its side, with its green star."""
    r, h = look.between(0.015, 0.019), look.between(0.036, 0.046)
    color = look.color("red", "crimson", "red", "coral")
    profile = [(0, 0), (0.2 * r, 0.03 * h), (0.62 * r, 0.3 * h), (0.95 * r, 0.66 * h),
               (r, 0.82 * h), (0.7 * r, 0.97 * h), (0, 0.94 * h)]  # fmt: skip
    body = press_flat(lathe(profile, 22).turn(1, np.pi / 2).move(x=-h / 2), 0.9 * r)
    seeds = speck(textures.speckles(look.rng, color, 5, 64), look.rng, (236, 206, 110), 70, 1)
    end, leaves = 0.44 * h, []
    for k in range(7):
        angle = 2 * np.pi * k / 7
        way = np.array([-0.25, np.cos(angle), np.sin(angle)]) * 1.15 * r
        foot = np.array([end, 0, 0.9 * r])
        leaves.append(blade([foot, foot + 0.6 * way + [0.002, 0, 0], foot + way], 0.009))
    stalk = tube([(end - 0.002, 0, 0.9 * r), (end + 0.01, 0, 1.1 * r)], 0.0014, 6)
    star = join([*leaves, stalk])
    return shape([(body, seeds), (star, textures.plain(LEAF))], [flat_foot(body.vertices, 0.18)])


CATEGORIES = (
    Category("pineapple", pineapple, (0.13, 0.13, 0.245), 1.1, ("ananas",),
             ("kitchen", "food"), ("tall", "round", "edible"), ("amber",)),
    Category("watermelon_slice", watermelon_slice, (0.18, 0.1, 0.024), 0.25,
             ("slice of watermelon", "melon slice"),
             ("kitchen", "food"), ("flat", "edible"), ("red",), state="lying flat"),
    Category("grapes", grapes, (0.14, 0.09, 0.05), 0.3, ("bunch of grapes", "grape"),
             ("kitchen", "food", "dining"), ("edible",), ("purple", "lime"), state="lying flat"),
    Category("strawberry", strawberry, (0.05, 0.035, 0.033), 0.018, ("berry",),
             ("kitchen", "food"), ("edible",), ("red",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
