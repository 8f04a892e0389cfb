"""Dishes in bowls and on plates: noodles, ramen, salad, pasta, mash, curry, rice, cereal."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.settled import Pieces, crockery, scatter, serve
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, ellipsoid, join, lathe, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look

GREEN: RGB = (96, 158, 62)


def filled_bowl(look: Look, *palette: str) -> tuple[float, float, Solid, textures.Tile]:
    """Return a bowl's radius, height, solid and tile."""
    r, h = look.between(0.072, 0.085), look.between(0.055, 0.066)
    color = look.color(*(palette or ("white", "white", "navy", "cream", "teal", "red", "black")))
    inside = look.surface(tint_color(color, 1.3), "ceramic")
    tile = textures.stack((glaze_tile(look, color), 62), (inside, 38), side=128)
    return r, h, crockery(r, h), tile


def _plate(look: Look) -> tuple[float, float, Solid, textures.Tile]:
    r, h = look.between(0.118, 0.135), look.between(0.022, 0.027)
    color = look.color("white", "white", "cream", "sky", "charcoal", "sage")
    return r, h, crockery(r, h, deep=False), look.surface(color, "ceramic")


def _strands(look: Look, radius: float, z: float, dome: float, thick: float, count: int) -> Solid:
    """Return tangled noodles over a disc at height ``z``."""
    made = []
    for k in range(count):
        t = np.linspace(0, look.between(4.5, 6.2), 20)
        away = radius * look.between(0.3, 0.62)
        wave = 1 + 0.3 * np.sin(look.between(2.2, 3.6) * t + look.between(0, 6))
        x = look.between(-0.3, 0.3) * radius + away * wave * np.cos(t + 2.4 * k)
        y = look.between(-0.3, 0.3) * radius + away * wave * np.sin(t + 2.4 * k)
        far = np.maximum(np.hypot(x, y) / (0.95 * radius), 1)
        x, y = x / far, y / far
        up = dome * (1 - (x * x + y * y) / radius**2) + 0.0035 * np.sin(3 * t + k)
        made.append(tube(np.column_stack([x, y, z + up]), thick, 5))
    return join(made)


def pool(r: float, low: float, z: float) -> Solid:
    """Return what fills a bowl up to the height ``z``."""
    return lathe([(0, low), (0.6 * r, low), (0.88 * r, z), (0, z)], 30)


def noodles(look: Look) -> Shape:
    """A bowl of fried noodles with greens, chopsticks laid across."""
    r, h, dish, tile = filled_bowl(look)
    tone = look.pick([(232, 190, 100), (214, 160, 84), (240, 214, 140)])
    bed = lathe([(0, 0.5 * h), (0.84 * r, 0.8 * h), (0.5 * r, 1.02 * h), (0, 1.1 * h)], 26)
    nest = _strands(look, 0.84 * r, 0.84 * h, 0.3 * h, 0.0024, 11)
    greens = scatter(look, 0.5 * r, 7, (0.014, 0.02), 0.98 * h, dome=0.2 * h,
                     stretch=(1, 0.5, 0.4))  # fmt: skip
    sticks = [tube([(-0.6 * r, -0.1 * r + 0.14 * r * s, 1.18 * h),
                    (1.5 * r, 0.35 * r + 0.1 * r * s, 1.14 * h)], [0.0017, 0.0034], 6)
              for s in (-1, 1)]  # fmt: skip
    food = [(bed, textures.spots(look.rng, tone, tint_color(tone, 0.7), 0.25)),
            (nest, textures.plain(tint_color(tone, 1.08))),
            (greens, textures.speckles(look.rng, GREEN, 16))]  # fmt: skip
    made = serve(look, dish, tile, food)
    wood = look.own_color("wooden", "maroon", "black")
    both = join(sticks)
    return shape([*((p.solid, p.tile) for p in made.pieces), (both, textures.plain(wood))],
                 [*made.parts, hull_of(both)])  # fmt: skip


def ramen(look: Look) -> Shape:
    """A bowl of noodle soup: half an egg, seaweed, spring onion and meat on top."""
    r, h, dish, tile = filled_bowl(look, "black", "red", "navy", "white", "charcoal")
    broth = pool(r, 0.4 * h, 0.8 * h)
    nest = _strands(look, 0.66 * r, 0.785 * h, 0.05 * h, 0.0024, 8)
    egg = ellipsoid(0.036, 0.028, 0.02, 18, 8).move(-0.36 * r, 0.26 * r, 0.83 * h)
    yolk = ellipsoid(0.018, 0.018, 0.012, 14, 6).move(-0.36 * r, 0.26 * r, 0.95 * h)
    nori = box(0.03, 0.0014, 0.036).turn(0, 0.2).move(0.3 * r, 0.58 * r, 0.72 * h)
    meat = [cylinder(0.021, 0.004, 20, bevel=0.001).turn(0, 0.14 * s).move(
        (0.3 + 0.16 * s) * r, -0.28 * r, 0.83 * h + 0.002 * s) for s in (0, 1)]  # fmt: skip
    onion = scatter(look, 0.3 * r, 12, (0.005, 0.007), 0.86 * h, stretch=(1, 1, 0.5))
    soup = look.pick([(206, 140, 66), (176, 96, 44), (232, 206, 150)])
    food: Pieces = [
        (broth, textures.spots(look.rng, soup, tint_color(soup, 1.25), 0.05)),
        (nest, textures.plain((244, 216, 140))), (egg, textures.plain((250, 248, 240))),
        (yolk, textures.plain((242, 150, 40))), (nori, textures.plain((34, 44, 38))),
        (join(meat), textures.spots(look.rng, (206, 140, 110), (240, 214, 190), 0.3)),
        (onion.move(-0.15 * r, -0.4 * r), textures.plain((120, 190, 80))),
    ]  # fmt: skip
    return serve(look, dish, tile, food)


def salad(look: Look) -> Shape:
    """A bowl heaped with leaves, tomatoes, cucumber and onion."""
    r, h, dish, tile = filled_bowl(look, "white", "wooden", "cream", "clear", "teal")
    r1 = 0.8 * r
    leaves, dark = [], []
    for k in range(30):
        away, turn = r1 * np.sqrt((k + 0.5) / 30), 2.4 * k
        up = 0.95 * h + 0.3 * h * (1 - (away / r1) ** 2)
        leaf = ellipsoid(0.042, 0.03, 0.008, 8, 5).bend(
            lambda p: p + np.column_stack([0 * p[:, 0], 0 * p[:, 0], 12 * p[:, 0] ** 2])
        )
        leaf = leaf.turn(0, look.between(-0.6, 0.6)).turn(2, turn).move(
            away * np.cos(turn), away * np.sin(turn), up)  # fmt: skip
        (leaves if k % 3 else dark).append(leaf)
    bed = pool(r, 0.4 * h, 0.9 * h)
    places = [(0.5, 0.3), (-0.2, 0.55), (-0.5, -0.2), (0.15, -0.5), (0.1, 0.05)]
    red = [ellipsoid(0.022, 0.022, 0.021, 12, 8).move(x * r, y * r, 1.2 * h) for x, y in places]
    discs = [cylinder(0.014, 0.0035, 18).turn(0, 0.4).turn(2, 2 * n).move(-y * r, x * r, 1.2 * h)
             for n, (x, y) in enumerate(places[:4])]  # fmt: skip
    food = [(bed, textures.plain((86, 130, 56))),
            (join(leaves), textures.speckles(look.rng, (124, 178, 68), 18)),
            (join(dark), textures.speckles(look.rng, (70, 126, 56), 14)),
            (join(red), textures.speckles(look.rng, (208, 46, 36), 6)),
            (join(discs), textures.stack((textures.plain((66, 120, 60)), 1),
                                         (textures.plain((206, 224, 160)), 2)))]  # fmt: skip
    return serve(look, dish, tile, food)


def spaghetti(look: Look) -> Shape:
    """A plate of spaghetti with sauce, meatballs and basil."""
    r, h, dish, tile = _plate(look)
    z = 0.55 * h
    bed = lathe([(0, z), (0.6 * r, z), (0.5 * r, z + 0.018), (0, z + 0.026)], 26)
    nest = _strands(look, 0.62 * r, z + 0.003, 0.026, 0.0026, 13)
    tone = look.pick([(190, 44, 28), (190, 44, 28), (110, 150, 60), (240, 226, 190)])
    sauce = ellipsoid(0.62 * r, 0.56 * r, 0.022, 22, 8).move(z=z + 0.026)
    top = scatter(look, 0.22 * r, 4, (0.026, 0.03), z + 0.04)
    leaf = scatter(look, 0.1 * r, 3, (0.022, 0.026), z + 0.05, stretch=(1, 0.55, 0.2))
    food = [(bed, textures.plain((232, 196, 110))), (nest, textures.plain((246, 216, 130))),
            (sauce, textures.spots(look.rng, tone, tint_color(tone, 0.7), 0.2)),
            (top, textures.spots(look.rng, (118, 68, 40), (80, 46, 28), 0.2)),
            (leaf, textures.plain((60, 130, 56)))]  # fmt: skip
    return serve(look, dish, tile, food)


def _curry(look: Look, tone: RGB, rice: bool) -> Pieces:
    z = 0.8
    chunks = scatter(look, 0.62, 10, (0.2, 0.3), z, stretch=(1, 0.8, 0.5))
    pool = lathe([(0, 0.4), (0.6, 0.4), (0.88, z), (0, z)], 30)
    pieces: Pieces = [(pool, textures.spots(look.rng, tone, tint_color(tone, 1.2), 0.08)),
                      (chunks, textures.spots(look.rng, tint_color(tone, 0.85), (226, 176, 90),
                                              0.25))]  # fmt: skip
    if rice:
        heap = ellipsoid(1.0, 1.5, 0.8, 20, 10).move(x=-0.4, z=z - 0.05)
        pieces.append(
            (
                heap.bend(
                    lambda p: (
                        p / np.maximum(np.hypot(p[:, :1], p[:, 1:2]) / 0.87, 1) * [1, 1, 0]
                        + p * [0, 0, 1]
                    )
                ),
                textures.spots(look.rng, (248, 246, 238), (226, 222, 210), 0.3),
            )
        )
    herb = scatter(look, 0.25, 4, (0.16, 0.2), z + 0.12, stretch=(1, 0.5, 0.25))
    return [*pieces, (herb.move(0.3, 0.1), textures.plain((66, 140, 60)))]


def curry(look: Look) -> Shape:
    """A bowl of curry with rice at one side."""
    r, h, dish, tile = filled_bowl(look)
    tone = look.pick([(206, 130, 34), (176, 72, 30), (120, 140, 60), (220, 150, 50)])
    food = [(s.scale(r, r, h), t) for s, t in _curry(look, tone, True)]
    return serve(look, dish, tile, food)


def stew(look: Look) -> Shape:
    """A bowl of stew: meat, carrots and potatoes in a brown gravy."""
    r, h, dish, tile = filled_bowl(look, "terracotta", "cream", "navy", "charcoal")
    food = [(s.scale(r, r, h), t) for s, t in _curry(look, (134, 70, 34), False)]
    carrots = scatter(look, 0.6 * r, 6, (0.016, 0.02), 0.84 * h, stretch=(1, 1, 0.6))
    food.append((carrots.turn(2, 0.8), textures.plain((232, 124, 40))))
    return serve(look, dish, tile, food)


CATEGORIES = (
    Category("noodles", noodles, (0.2, 0.159, 0.0752), 0.7, ("bowl of noodles", "noodle bowl",
                 "noodle", "chow mein", "fried noodles", "pad thai", "plate of noodles", "udon",
                 "noodle dish", "bowl of udon"),
             ("dining",), ("edible", "round"), ("white", "navy")),
    Category("ramen", ramen, (0.158, 0.158, 0.079), 0.85, ("bowl of ramen", "noodle soup", "pho",
             "ramen bowl", "bowl of pho", "miso soup", "laksa"), ("dining",), ("edible", "round"),
             ("black", "red")),
    Category("salad", salad, (0.153, 0.153, 0.081), 0.5, ("bowl of salad", "green salad",
             "mixed salad", "caesar salad", "greek salad", "fresh salad", "plate of salad",
             "coleslaw"), ("dining",), ("edible", "round"), ("white",)),
    Category("spaghetti", spaghetti, (0.251, 0.251, 0.0687), 0.7, ("plate of pasta", "pasta plate",
             "pasta dish", "plate of spaghetti", "spaghetti bolognese", "spaghetti and meatballs",
             "pasta", "bowl of pasta", "spaghetti plate", "bowl of spaghetti", "penne",
             "fettuccine"), ("dining",), ("edible", "round", "big"), ("white",)),
    Category("curry", curry, (0.156, 0.156, 0.0719), 0.7, ("bowl of curry", "chicken curry",
             "curry and rice", "curry bowl", "dal", "tikka masala", "curry rice", "bowl of dal",
             "balti dish", "dal bowl", "bowl of daal", "daal", "balti"), ("dining",),
             ("edible", "round"), ("white",)),
    Category("stew", stew, (0.163, 0.163, 0.0623), 0.75, ("bowl of stew", "beef stew", "goulash",
             "bowl of chili", "chili con carne", "hotpot", "stew bowl"), ("dining",), ("edible",
             "round"), ()),
)  # fmt: skip
"""The module's categories."""
