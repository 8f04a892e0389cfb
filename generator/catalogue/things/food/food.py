"""Fruit, vegetables and an egg."""

from __future__ import annotations

import numpy as np

from ....scene import ConvexPart
from ...build.category import Category
from ...build.collision import flat_foot, hull_of, resting_ball
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, ellipsoid, join, lathe, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look


def skin(look: Look, base: RGB, blush: RGB, amount: float = 1.0) -> textures.Tile:
    """Return a fruit's skin: ``base`` with soft patches of ``blush``."""
    mix = np.clip(textures.noise(look.rng, 96, 96, (3, 3), 3) * 0.5 * amount + 0.35, 0, 1)[
        ..., None
    ]
    image = np.array(base) * (1 - mix) + np.array(blush) * mix
    return np.clip(image, 0, 255).astype(np.uint8)


def press_flat(solid: Solid, depth: float) -> Solid:
    """Return a solid centred at the origin, pressed flat ``depth`` below it and put on z = 0."""
    flat = solid.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], -depth)]))
    return flat.move(z=depth)


def apple(look: Look) -> Shape:
    """An apple with a stem."""
    d = look.between(0.07, 0.08)
    base = look.color("red", "red", "green", "lime", "crimson", "yellow", "maroon")
    tall = look.between(0.9, 1.08)
    blush = look.own_color("red", "amber", "lime", "crimson")
    a = np.linspace(-np.pi / 2, np.pi / 2, 13)
    r = d / 2 * np.cos(a) * (1 + 0.06 * np.sin(a))
    z = 0.44 * tall * d * np.sin(a) - 0.09 * d * np.exp(-((r / (0.22 * d)) ** 2)) * np.sign(
        np.sin(a)
    )
    r[[0, -1]] = 0
    body = press_flat(lathe(np.column_stack([r, z]), 26), 0.41 * tall * d)
    body = body.move(z=-float(body.vertices[:, 2].min()))
    top = float(body.vertices[:, 2].max())
    stem = tube([(0, 0, 0.72 * top), (0.002, 0, 0.95 * top), (0.006, 0, 1.12 * top)], 0.0016, 6)
    brown = textures.plain((92, 66, 40))
    return shape([(body, skin(look, base, blush)), (stem, brown)], [resting_ball(d, d, 0.97 * top)])


def _citrus(look: Look, size: tuple[float, float, float], color: RGB) -> Shape:
    x, y, z = size
    body = press_flat(ellipsoid(x, y, z, 26, 14), 0.46 * z)
    peel = textures.spots(look.rng, color, tint_color(color, 0.86), 0.12)
    nub = cylinder(0.0035, 0.002, 8).move(z=0.955 * z)
    green = textures.plain((94, 110, 58))
    return shape([(body, peel), (nub, green)], [resting_ball(x, y, 0.96 * z)])


def orange(look: Look) -> Shape:
    """An orange."""
    d = look.between(0.07, 0.08)
    return _citrus(look, (d, d, 0.97 * d), look.color("orange", "amber", "orange"))


def lemon(look: Look) -> Shape:
    """A lemon lying, pointed at both ends."""
    x, d = look.between(0.078, 0.09), look.between(0.054, 0.06)
    color = look.color("yellow")
    a = np.linspace(-np.pi / 2, np.pi / 2, 15)
    point = 0.16 * np.exp(-(((np.abs(a) - np.pi / 2) / 0.3) ** 2)) * np.sign(a)
    profile = np.column_stack([d / 2 * np.cos(a), (x / 2.3) * (np.sin(a) + point)])
    profile[[0, -1], 0] = 0
    body = press_flat(lathe(profile, 22).turn(1, np.pi / 2), 0.46 * d)
    peel = textures.spots(look.rng, color, tint_color(color, 0.88), 0.12)
    return shape([(body, peel)], [resting_ball(float(np.ptp(body.vertices[:, 0])), d, 0.95 * d)])


def pear(look: Look) -> Shape:
    """A pear standing."""
    r, h = look.between(0.032, 0.037), look.between(0.088, 0.1)
    base = look.color("lime", "yellow", "olive", "amber")
    body = lathe(
        [(0, 0.004), (0.35 * r, 0.0), (0.6 * r, 0.002), (0.95 * r, 0.16 * h), (r, 0.3 * h),
         (0.88 * r, 0.46 * h), (0.58 * r, 0.64 * h), (0.45 * r, 0.82 * h), (0.3 * r, 0.95 * h),
         (0, h)],
        24,
    )  # fmt: skip
    stem = tube([(0, 0, 0.92 * h), (0.003, 0, 1.06 * h), (0.008, 0, 1.16 * h)], 0.0017, 6)
    return shape(
        [(body, skin(look, base, look.own_color("yellow", "olive", "terracotta"), 0.7)),
         (stem, textures.plain((92, 66, 40)))],
        [hull_of(body)],
    )  # fmt: skip


def banana(look: Look) -> Shape:
    """A banana lying on its side, curved."""
    bow, r = look.between(0.085, 0.1), look.between(0.016, 0.018)
    color = look.color("yellow")
    angles = np.linspace(np.deg2rad(205), np.deg2rad(335), 13)
    path = np.column_stack(
        [bow * np.cos(angles), bow * np.sin(angles) + 0.8 * bow, np.full(13, 0.93 * r)]
    )
    radii = r * np.array([0.32, 0.36, 0.72, 0.9, 0.98, 1, 1, 1, 0.97, 0.88, 0.68, 0.4, 0.28])
    image = textures.speckles(look.rng, color, 5, 96).copy()
    for _ in range(26):
        i, j = look.rng.integers(0, 92, 2)
        image[i : i + 3, j : j + 2] = np.array(tint_color(color, 0.5), np.uint8)
    image[:7], image[-7:] = (86, 66, 38), (96, 84, 40)
    body = tube(path, radii, 8, squash=0.93)
    pieces = [flat_foot(np.concatenate([_slice(body, k) for k in range(a, b + 1)]))
              for a, b in ((1, 4), (4, 8), (8, 11))]  # fmt: skip
    return shape([(body, image)], pieces)


def _slice(body: Solid, ring: int) -> np.ndarray:
    """Return the points of a banana's ``ring`` of 13 along its length, by angle."""
    p = body.vertices
    center = p[:, :2].mean(0) + np.array([0, 0.1])
    away = np.arctan2(*(p[:, :2] - center).T[::-1])
    order = np.quantile(away, [max(0.0, (ring - 0.5) / 12), min(1.0, (ring + 0.5) / 12)])
    return p[(away >= order[0] - 1e-6) & (away <= order[1] + 1e-6)]


def tomato(look: Look) -> Shape:
    """A tomato with its green star."""
    d, tall = look.between(0.058, 0.076), look.between(0.74, 0.98)
    color = look.color("red", "red", "coral", "crimson")
    body = press_flat(ellipsoid(d, d, tall * d, 24, 14), 0.45 * tall * d)
    top = float(body.vertices[:, 2].max())
    green = textures.plain((70, 120, 50))
    leaves = [
        ellipsoid(0.024, 0.006, 0.002, 8, 4).move(x=0.012).turn(1, 0.25).turn(2, 1.257 * k)
        for k in range(5)
    ]
    stem = tube([(0, 0, 0), (0.001, 0, 0.006), (0.003, 0, 0.011)], 0.0016, 6)
    star = join([*leaves, stem]).move(z=top + 0.0005)
    return shape(
        [(body, skin(look, color, tint_color(color, 1.12), 0.5)), (star, green)],
        [resting_ball(d, d, top)],
    )


def egg(look: Look) -> Shape:
    """An egg lying."""
    color = look.color("cream", "tan", "white", "beige")
    a = np.linspace(-np.pi / 2, np.pi / 2, 13)
    profile = np.column_stack([0.0215 * np.cos(a) * (1 - 0.12 * np.sin(a)), 0.028 * np.sin(a)])
    profile[[0, -1], 0] = 0
    body = press_flat(lathe(profile, 20).turn(1, np.pi / 2), 0.0198)
    shell = textures.spots(look.rng, color, tint_color(color, 0.85), 0.03)
    return shape([(body, shell)], [resting_ball(0.056, 0.043, 0.0405)])


def _root(look: Look, length: float, radii: list[float]) -> Solid:
    bend = look.between(-0.008, 0.008)
    t = np.linspace(-1, 1, len(radii))
    radius = max(radii)
    return tube(
        np.column_stack([t * length / 2, bend * (1 - t**2), np.full(len(t), 0.92 * radius)]),
        radii, 12, squash=0.92,
    )  # fmt: skip


def halves(body: Solid, pieces: int) -> list[ConvexPart]:
    """Return hulls of equal lengths of a lying body, each reaching down to the table."""
    p = body.vertices
    cuts = np.linspace(p[:, 0].min(), p[:, 0].max(), pieces + 1)
    width = (cuts[1] - cuts[0]) * 0.55
    middles = (cuts[1:] + cuts[:-1]) / 2
    return [flat_foot(p[np.abs(p[:, 0] - m) <= width + 0.004]) for m in middles]


def cucumber(look: Look) -> Shape:
    """A cucumber lying."""
    length, r = look.between(0.17, 0.21), look.between(0.018, 0.021)
    color = look.color("green", "green", "olive")
    dark = tint_color(color, 0.72)
    rind = textures.stripes([dark, dark, tint_color(color, 0.95)], 7, upright=True)
    body = _root(look, length, [0.4 * r, 0.8 * r, r, r, r, r, r, 0.85 * r, 0.45 * r])
    return shape([(body, rind)], halves(body, 3))


def carrot(look: Look) -> Shape:
    """A carrot lying, with a tuft of green."""
    length, r = look.between(0.14, 0.18), look.between(0.014, 0.017)
    color = look.color("orange", "orange", "coral")
    rings = textures.stripes([color, color, color, tint_color(color, 0.82)], 9)
    body = _root(
        look, length, [0.12 * r, 0.4 * r, 0.6 * r, 0.78 * r, 0.92 * r, r, 0.9 * r, 0.5 * r]
    )
    low = float(body.vertices[:, 2].min())
    green = textures.plain((84, 140, 60))
    tuft = [
        tube([(length / 2 - 0.004, 0, 0.9 * r), (length / 2 + 0.02, 0.01 * k, 0.9 * r + 0.004),
              (length / 2 + 0.045, 0.022 * k, 0.8 * r)], [0.0025, 0.002, 0.003], 6)
        for k in (-1, 0, 1)
    ]  # fmt: skip
    body = body.move(z=-low)
    return shape([(body, rings), (join(tuft), green)], [*halves(body, 3), hull_of(*tuft)])


CATEGORIES = (
    Category(
        "apple",
        apple,
        (0.075, 0.075, 0.075),
        0.2,
        (),
        ("kitchen", "dining", "office"),
        ("round", "edible"),
        ("red", "green"),
    ),
    Category(
        "orange",
        orange,
        (0.075, 0.075, 0.07),
        0.2,
        ("mandarin", "tangerine", "clementine", "satsuma"),
        ("kitchen", "dining"),
        ("round", "edible"),
        ("orange",),
    ),
    Category(
        "lemon",
        lemon,
        (0.085, 0.057, 0.055),
        0.11,
        (),
        ("kitchen",),
        ("round", "edible"),
        ("yellow",),
    ),
    Category(
        "pear",
        pear,
        (0.07, 0.07, 0.11),
        0.19,
        (),
        ("kitchen", "dining"),
        ("round", "edible"),
        ("lime", "yellow"),
    ),
    Category(
        "banana",
        banana,
        (0.18, 0.07, 0.035),
        0.107,
        (),
        ("kitchen", "dining"),
        ("edible",),
        ("yellow",),
        state="lying flat",
    ),
    Category(
        "tomato",
        tomato,
        (0.067, 0.067, 0.062),
        0.13,
        (),
        ("kitchen",),
        ("round", "edible"),
        ("red",),
    ),
    Category(
        "egg",
        egg,
        (0.056, 0.043, 0.041),
        0.058,
        (
            "wooden egg",
            "marble egg",
            "hard boiled egg",
            "golden egg",
        ),
        ("kitchen",),
        ("round", "edible"),
        ("cream", "tan"),
        state="lying flat",
    ),
    Category(
        "cucumber",
        cucumber,
        (0.19, 0.04, 0.038),
        0.16,
        (),
        ("kitchen",),
        ("edible",),
        ("green",),
        state="lying flat",
    ),
    Category(
        "carrot",
        carrot,
        (0.2, 0.05, 0.03),
        0.06,
        (),
        ("kitchen",),
        ("edible",),
        ("orange",),
        state="lying flat",
    ),
)
