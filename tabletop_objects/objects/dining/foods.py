"""Objects of the ``dining`` theme: dishes and other food."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile, skin
from ...kit.outlines import arc, rectangle
from ...kit.parts import cylinder_part, flat_foot, hull_above, hull_of, open_vessel
from ...kit.primitives import ball, bent_rod, crockery, lobe, scatter
from ...kit.shapes import Pieces, Shape, category, serve, settle, shape, vary
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...kit.surfaces import RGB, Look, speck, tint_color
from ..coffee.cakes import _wedge
from ..coffee.pastries import edge, stack


@category("samosa", size=(0.0847, 0.08, 0.0591), mass=0.06, material="food",
          aliases=("vegetable samosa", "somosa", "sambusa"), themes=("dining",), roles=("edible",),
          colors=("amber",))  # fmt: skip
def samosa(look: Look) -> Shape:
    """A plump fried pyramid of pastry with a crimped seam."""
    k = look.between(0.9, 1.1)
    tri = np.array([(-0.046, -0.03), (0.046, -0.03), (0, 0.05)]) * k
    ring = edge(tri, 6) * 0.72 + 0.28 * 0.042 * k * _unit(edge(tri, 6))
    levels = [(0.82, 0), (1.0, 0.01), (0.95, 0.022), (0.62, 0.042), (0.25, 0.056), (0.06, 0.06)]
    body = stack(ring, [(f, z * k) for f, z in levels])
    fried = surfaces.spots(look.rng, tint_color(look.color("amber", "copper"), 0.95),
                           (150, 84, 34), 0.28)  # fmt: skip
    return shape([(body, fried)], [hull_of(body)])


def _unit(p: np.ndarray) -> np.ndarray:
    return p / np.linalg.norm(p, axis=1, keepdims=True)


@category("borek", size=(0.115, 0.12, 0.0194), mass=0.15, material="food",
          aliases=("burek", "bourekas", "spinach pie spiral", "filo pastry coil"),
          themes=("dining",), roles=("edible", "flat"), state="lying flat")  # fmt: skip
@vary()
def borek(look: Look) -> Shape:
    """A borek: a spiral of filled filo pastry."""
    r = look.between(0.055, 0.07)
    t = np.linspace(0.8, 5.4 * np.pi, 60)
    away = 0.86 * r * t / t[-1]
    path = np.column_stack([away * np.cos(t), away * np.sin(t), np.zeros(60)])
    roll = tube(path, 0.17 * r, 8)
    gold = surfaces.spots(look.rng, (220, 154, 78), (160, 90, 38), 0.3)
    return settle([(roll, gold)], 0.12)


@category("yorkshire_pudding", size=(0.0904, 0.0913, 0.0465), mass=0.04, material="food",
          aliases=("popover", "yorkshire pud"), themes=("dining",), roles=("edible", "round"),
          colors=("amber",))  # fmt: skip
def yorkshire_pudding(look: Look) -> Shape:
    """A risen, crisp, hollow Yorkshire pudding."""
    r, h = look.between(0.04, 0.05), look.between(0.042, 0.052)
    cup = lathe([(0, 0), (0.62 * r, 0), (0.72 * r, 0.3 * h), (0.95 * r, 0.62 * h), (r, 0.86 * h),
                 (0.85 * r, h), (0.66 * r, 0.92 * h), (0.5 * r, 0.6 * h), (0, 0.46 * h)],
                22)  # fmt: skip
    a = look.between(0, 6)
    wavy = cup.bend(lambda p: p * np.column_stack([np.ones((len(p), 2)), 1 + 0.09 * np.sin(
        3 * np.arctan2(p[:, 1], p[:, 0]) + a)]))  # fmt: skip
    return settle([(wavy, skin(look, (226, 166, 84), (140, 80, 34), 1.1))], 0.02)


@category("poppadom", size=(0.165, 0.165, 0.0155), mass=0.015, material="food",
          aliases=("papadum", "papad", "poppadum", "papadam", "popadom"), themes=("dining",),
          roles=("edible", "flat", "round"), colors=("amber",), state="lying flat")  # fmt: skip
def poppadom(look: Look) -> Shape:
    """A thin, blistered, wavy poppadom."""
    r = look.between(0.075, 0.09)
    disc = lathe([(0, 0), (0.5 * r, 0), (r, 0.002), (r, 0.0036), (0.5 * r, 0.0026), (0, 0.0026)],
                 36)  # fmt: skip
    wavy = disc.bend(
        lambda p: (
            p
            + np.column_stack(
                [
                    0 * p[:, :2],
                    0.12
                    * (np.hypot(p[:, 0], p[:, 1]) / r) ** 2
                    * 0.05
                    * (1 + np.sin(4 * np.arctan2(p[:, 1], p[:, 0]))),
                ]
            )
        )
    )
    blister = [ellipsoid(d, d, 0.003, 8, 4).move(a, b, 0.0028) for a, b, d in (
        (look.between(-0.55, 0.55) * r, look.between(-0.55, 0.55) * r, look.between(0.008, 0.018))
        for _ in range(16))]  # fmt: skip
    tone = look.color("amber", "tan")
    return shape([(wavy, surfaces.spots(look.rng, tint_color(tone, 1.2), tint_color(tone, 0.8),
                                        0.12)),
                  (join(blister), surfaces.plain(tint_color(tone, 1.35)))],
                 [hull_of(wavy)])  # fmt: skip


@category("cracker", size=(0.059, 0.0591, 0.00579), mass=0.006, material="food",
          aliases=("cheese cracker", "water biscuit", "cream cracker", "oatcake", "saltine",
          "rice cracker", "rice cake", "crispbread"), themes=("dining",), roles=("edible", "flat"),
          colors=("tan",), state="lying flat")  # fmt: skip
def cracker(look: Look) -> Shape:
    """A thin, round or square cracker with holes."""
    r, h = look.between(0.027, 0.034), look.between(0.0048, 0.006)
    round_ = look.chance(0.5)
    body = cylinder(r, h, 30, bevel=0.001) if round_ else prism(
        rectangle(2 * r, 2 * r, 0.004), 0, h, 0.001)  # fmt: skip
    holes = [cylinder(0.0013, 0.0006, 6).move(0.4 * r * i, 0.4 * r * j, h - 0.0003)
             for i in (-1.6, -0.55, 0.55, 1.6) for j in (-1.6, -0.55, 0.55, 1.6)
             if not round_ or abs(i) + abs(j) < 3]  # fmt: skip
    gold = skin(look, tint_color(look.color("tan", "amber"), 1.1), (196, 136, 70), 0.7)
    part = cylinder_part(r, h) if round_ else hull_of(body)
    return shape([(body, gold), (join(holes), surfaces.plain((150, 100, 54)))], [part])


@category("tofu_dish", size=(0.158, 0.158, 0.064), mass=0.6, material="ceramic",
          aliases=("mapo tofu", "bowl of tofu", "tofu stew", "tofu soup", "fried tofu dish"),
          themes=("dining",), roles=("edible", "round"), colors=("white",))  # fmt: skip
def tofu_dish(look: Look) -> Shape:
    """A bowl of tofu cubes in a red or brown sauce with spring onions."""
    r, h = look.between(0.075, 0.085), look.between(0.055, 0.065)
    color = look.color("white", "navy", "teal", "black", "cream")
    dish = crockery(r, h)
    sauce = cylinder(0.86 * r, 0.004, 30).move(z=0.7 * h)
    tone = look.pick([(160, 44, 22), (112, 62, 30), (176, 66, 26)])
    cubes = [box(0.021, 0.021, 0.017).turn(2, 1.1 * n).move(0.66 * r * np.sqrt((n + 0.4) / 13)
                                                            * np.cos(2.4 * n), 0.66 * r
                                                            * np.sqrt((n + 0.4) / 13)
                                                            * np.sin(2.4 * n), 0.68 * h + 0.003
                                                            * (n % 3))
             for n in range(13)]  # fmt: skip
    onion = scatter(look, 0.55 * r, 22, (0.005, 0.007), 0.7 * h + 0.02, stretch=(1, 1, 0.4))
    food = [(sauce, surfaces.spots(look.rng, tone, tint_color(tone, 0.7), 0.2)),
            (join(cubes), surfaces.speckles(look.rng, (246, 240, 222), 6)),
            (onion, surfaces.plain((96, 160, 70)))]  # fmt: skip
    return serve(look, dish, look.surface(color, "ceramic"), food)


@category("pineapple_hedgehog", size=(0.192, 0.191, 0.0991), mass=0.6, material="food",
          assembled=True,
          aliases=("cheese and pineapple hedgehog", "cheese hedgehog", "cheese and pineapple"),
          themes=("dining",), roles=("edible", "round"), colors=("silver",))  # fmt: skip
def pineapple_hedgehog(look: Look) -> Shape:
    """Half a melon wrapped in foil, with cocktail sticks of cheese and pineapple."""
    r = look.between(0.062, 0.072)
    dome = lathe([(0, 0), (r, 0), (0.96 * r, 0.3 * r), (0.7 * r, 0.72 * r), (0.3 * r, 0.93 * r),
                  (0, 0.96 * r)], 28)  # fmt: skip
    sticks, cheese, fruit = [], [], []
    for n in range(26):
        up = 1 - 0.86 * (n + 0.5) / 26
        flat = np.sqrt(1 - up * up)
        way = np.array([flat * np.cos(2.4 * n), flat * np.sin(2.4 * n), up])
        a, b = way * r * 0.92, way * r * 1.5
        sticks.append(tube([a, b], 0.001, 5))
        cheese.append(box(0.014, 0.014, 0.012).turn(2, n).move(*(way * r * 1.2)))
        fruit.append(ball(0.014, 0.014, 0.012, tuple(way * r * 1.42), 7))
    foil = surfaces.brushed_metal(look.rng, look.color("silver", "silver", "green"))
    return shape([(dome, foil), (join(sticks), surfaces.plain((222, 188, 136))),
                  (join(cheese), surfaces.plain((246, 196, 84))),
                  (join(fruit), surfaces.plain((248, 226, 96)))],
                 [hull_of(dome), hull_above(*cheese, *fruit)])  # fmt: skip


@category("mashed_potatoes", size=(0.155, 0.155, 0.0865), mass=0.6, material="ceramic",
          aliases=("mashed potato", "bowl of mash", "mash", "bowl of mashed potatoes",
          "potato mash", "potato puree"), themes=("dining",), roles=("edible", "round"),
          colors=("white",))  # fmt: skip
def mashed_potatoes(look: Look) -> Shape:
    """A bowl of mashed potato with butter melting on its peaks."""
    r, h, dish, tile = filled_bowl(look)
    peaks = [ellipsoid(1.0 * r, 0.9 * r, 0.5 * h, 16, 8).move(0.42 * r * np.cos(1.26 * n), 0.42 * r
                                                              * np.sin(1.26 * n), 0.9 * h)
             for n in range(5)]  # fmt: skip
    swirl = lathe([(0, 0.5 * h), (0.84 * r, 0.75 * h), (0.7 * r, 1.05 * h), (0.3 * r, 1.3 * h),
                   (0, 1.32 * h)], 26)  # fmt: skip
    pat = block(0.02, 0.017, 0.009, 0.002, 0.001).turn(2, 0.5).move(z=1.3 * h)
    melt = ellipsoid(0.044, 0.038, 0.006, 16, 6).move(z=1.31 * h)
    cream = surfaces.speckles(look.rng, look.pick([(246, 230, 168), (244, 224, 150)]), 8)
    herbs = scatter(look, 0.6 * r, 14, (0.004, 0.006), 1.02 * h, dome=0.26 * h,
                    stretch=(1, 0.6, 0.4))  # fmt: skip
    return serve(look, dish, tile, [(join([*peaks, swirl]), cream),
                                    (melt, surfaces.plain((252, 214, 90))),
                                    (pat, surfaces.plain((250, 226, 120))),
                                    (herbs, surfaces.plain((86, 146, 62)))])  # fmt: skip


@category("bowl_of_rice", size=(0.123, 0.123, 0.0669), mass=0.4, material="ceramic",
          aliases=("steamed rice", "cooked rice", "fried rice", "rice dish", "risotto",
          "plate of rice"), themes=("dining",), roles=("edible", "round"),
          colors=("white",))  # fmt: skip
def bowl_of_rice(look: Look) -> Shape:
    """A bowl heaped with steamed rice."""
    r, h, dish, tile = filled_bowl(look)
    k = look.between(0.7, 0.85)
    heap = lathe([(0, 0.5 * h), (0.86 * r, 0.78 * h), (0.7 * r, 1.12 * h), (0.36 * r, 1.34 * h),
                  (0, 1.4 * h)], 28)  # fmt: skip
    grains = scatter(look, 0.72 * r, 36, (0.006, 0.008), 0.98 * h, dome=0.38 * h,
                     stretch=(1, 0.45, 0.45))  # fmt: skip
    white = surfaces.spots(look.rng, (248, 246, 238), (228, 226, 216), 0.3)
    seeds = scatter(look, 0.3 * r, 8, (0.004, 0.005), 1.34 * h, stretch=(1, 0.7, 0.5))
    food = [(heap, white), (grains, surfaces.plain((252, 250, 244))),
            (seeds, surfaces.plain((46, 42, 42)))]  # fmt: skip
    made = serve(look, dish, tile, food)
    return made.scale(k)


@category("bowl_of_crisps", size=(0.17, 0.17, 0.09), mass=0.35, material="ceramic",
          aliases=("bowl of chips", "bowl of potato chips", "bowl of tortilla chips",
          "bowl of crisps"), themes=("dining",), roles=("edible", "round"),
          colors=("white",))  # fmt: skip
def bowl_of_crisps(look: Look) -> Shape:
    """A bowl heaped with golden crisps."""
    r, h, dish, tile = filled_bowl(look)
    one = ellipsoid(0.046, 0.036, 0.004, 12, 5).bend(
        lambda p: p + np.outer(p[:, 0] ** 2, [0.0, 0.0, 9.0])
    )
    chips = []
    for n in range(28):
        out, a = 0.8 * r * np.sqrt((n + 0.5) / 28), 2.4 * n
        high = 0.72 * h + 0.7 * h * (1 - (out / r) ** 2) * look.between(0.75, 1.05)
        lying = one.turn(0, look.between(-0.6, 0.6)).turn(1, look.between(-0.6, 0.6)).turn(2, a)
        chips.append(lying.move(out * np.cos(a), out * np.sin(a), high))
    mound = lathe([(0, 0.4 * h), (0.86 * r, 0.7 * h), (0.5 * r, 1.1 * h), (0, 1.25 * h)], 24)
    gold = look.pick([(238, 190, 96), (232, 178, 84)])
    skin = surfaces.spots(look.rng, gold, tint_color(gold, 0.75), 0.06)
    return serve(look, dish, tile, [(mound, surfaces.plain(tint_color(gold, 0.8))),
                                    (join(chips), skin)])  # fmt: skip


@category("dip", size=(0.118, 0.118, 0.0659), mass=0.3, material="ceramic", aliases=("hummus",
          "guacamole", "salsa", "bowl of dip", "bowl of hummus", "tzatziki", "bowl of salsa",
          "bowl of guacamole"), themes=("dining",), roles=("edible", "round"),
          colors=("white",))  # fmt: skip
def dip(look: Look) -> Shape:
    """A small bowl of swirled dip with a few crisps stuck in it."""
    r, h, dish, tile = filled_bowl(look)
    tone = look.pick([(146, 176, 84), (232, 206, 150), (196, 56, 38), (244, 238, 222)])
    body = lathe([(0, 0.4 * h), (0.6 * r, 0.4 * h), (0.88 * r, 0.8 * h), (0, 0.86 * h)], 30)
    t = np.linspace(0.6, 13, 50)
    swirl = tube(np.column_stack([0.06 * r * t * np.cos(t) * 0.9, 0.06 * r * t * np.sin(t) * 0.9,
                                  0.87 * h - 0.002 * t / 6]), 0.0034, 6)  # fmt: skip
    chips = [box(0.034, 0.034, 0.002).turn(2, np.pi / 4).turn(0, 1.2).turn(2, a).move(
        0.5 * r * np.cos(a + 1.2), 0.5 * r * np.sin(a + 1.2), 0.85 * h + 0.012)
        for a in (-0.3, 0.25)]  # fmt: skip
    smooth_ = surfaces.spots(look.rng, tone, tint_color(tone, 0.86), 0.1)
    food = [(body, smooth_), (swirl, smooth_),
            (join(chips), surfaces.spots(look.rng, (238, 196, 96), (206, 150, 60),
                                         0.2))]  # fmt: skip
    made = serve(look, dish, tile, food[:2])
    return shape([*((p.solid, p.tile) for p in made.pieces), food[2]],
                 [*made.parts, hull_above(*chips)]).scale(0.75)  # fmt: skip


GREEN: RGB = (96, 158, 62)


def filled_bowl(look: Look, *palette: str) -> tuple[float, float, Solid, surfaces.Tile]:
    """Return the radius, height, solid and tile of a bowl."""
    r, h = look.between(0.072, 0.085), look.between(0.055, 0.066)
    color = look.color(*(palette or ("white", "white", "navy", "cream", "teal", "red", "black")))
    inside = look.surface(tint_color(color, 1.3), "ceramic")
    tile = surfaces.stack((glaze_tile(look, color), 62), (inside, 38), side=128)
    return r, h, crockery(r, h), tile


def _plate(look: Look) -> tuple[float, float, Solid, surfaces.Tile]:
    r, h = look.between(0.118, 0.135), look.between(0.022, 0.027)
    color = look.color("white", "white", "cream", "sky", "charcoal", "sage")
    return r, h, crockery(r, h, deep=False), look.surface(color, "ceramic")


def _strands(look: Look, radius: float, z: float, dome: float, thick: float, count: int) -> Solid:
    """Return tangled noodles on a disc at height ``z``."""
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
    """Return the filling of a bowl up to height ``z``."""
    return lathe([(0, low), (0.6 * r, low), (0.88 * r, z), (0, z)], 30)


@category("noodles", size=(0.2, 0.159, 0.0752), mass=0.7, material="ceramic", assembled=True,
          aliases=("bowl of noodles", "noodle bowl", "noodle", "chow mein", "fried noodles",
          "pad thai", "plate of noodles", "udon", "noodle dish", "bowl of udon"),
          themes=("dining",), roles=("edible", "round"), colors=("white", "navy"))  # fmt: skip
def noodles(look: Look) -> Shape:
    """A bowl of fried noodles with vegetables, and chopsticks lying across it."""
    r, h, dish, tile = filled_bowl(look)
    tone = look.pick([(232, 190, 100), (214, 160, 84), (240, 214, 140)])
    bed = lathe([(0, 0.5 * h), (0.84 * r, 0.8 * h), (0.5 * r, 1.02 * h), (0, 1.1 * h)], 26)
    nest = _strands(look, 0.84 * r, 0.84 * h, 0.3 * h, 0.0024, 11)
    greens = scatter(look, 0.5 * r, 7, (0.014, 0.02), 0.98 * h, dome=0.2 * h,
                     stretch=(1, 0.5, 0.4))  # fmt: skip
    sticks = [tube([(-0.6 * r, -0.1 * r + 0.14 * r * s, 1.18 * h),
                    (1.5 * r, 0.35 * r + 0.1 * r * s, 1.14 * h)], [0.0017, 0.0034], 6)
              for s in (-1, 1)]  # fmt: skip
    food = [(bed, surfaces.spots(look.rng, tone, tint_color(tone, 0.7), 0.25)),
            (nest, surfaces.plain(tint_color(tone, 1.08))),
            (greens, surfaces.speckles(look.rng, GREEN, 16))]  # fmt: skip
    made = serve(look, dish, tile, food)
    wood = look.own_color("wooden", "maroon", "black")
    both = join(sticks)
    return shape([*((p.solid, p.tile) for p in made.pieces), (both, surfaces.plain(wood))],
                 [*made.parts, hull_of(both)])  # fmt: skip


@category("ramen", size=(0.158, 0.158, 0.079), mass=0.85, material="ceramic",
          aliases=("bowl of ramen", "noodle soup", "pho", "ramen bowl", "bowl of pho", "miso soup",
          "laksa"), themes=("dining",), roles=("edible", "round"),
          colors=("black", "red"))  # fmt: skip
def ramen(look: Look) -> Shape:
    """A bowl of noodle soup topped with half an egg, seaweed, spring onions and meat."""
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
        (broth, surfaces.spots(look.rng, soup, tint_color(soup, 1.25), 0.05)),
        (nest, surfaces.plain((244, 216, 140))), (egg, surfaces.plain((250, 248, 240))),
        (yolk, surfaces.plain((242, 150, 40))), (nori, surfaces.plain((34, 44, 38))),
        (join(meat), surfaces.spots(look.rng, (206, 140, 110), (240, 214, 190), 0.3)),
        (onion.move(-0.15 * r, -0.4 * r), surfaces.plain((120, 190, 80))),
    ]  # fmt: skip
    return serve(look, dish, tile, food)


@category("salad", size=(0.153, 0.153, 0.081), mass=0.5, material="ceramic",
          aliases=("bowl of salad", "green salad", "mixed salad", "caesar salad", "greek salad",
          "fresh salad", "plate of salad", "coleslaw"), themes=("dining",),
          roles=("edible", "round"), colors=("white",))  # fmt: skip
def salad(look: Look) -> Shape:
    """A bowl heaped with leaves, tomatoes, cucumber and onions."""
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
    food = [(bed, surfaces.plain((86, 130, 56))),
            (join(leaves), surfaces.speckles(look.rng, (124, 178, 68), 18)),
            (join(dark), surfaces.speckles(look.rng, (70, 126, 56), 14)),
            (join(red), surfaces.speckles(look.rng, (208, 46, 36), 6)),
            (join(discs), surfaces.stack((surfaces.plain((66, 120, 60)), 1),
                                         (surfaces.plain((206, 224, 160)), 2)))]  # fmt: skip
    return serve(look, dish, tile, food)


@category("spaghetti", size=(0.251, 0.251, 0.0687), mass=0.7, material="ceramic",
          aliases=("plate of pasta", "pasta plate", "pasta dish", "plate of spaghetti",
          "spaghetti bolognese", "spaghetti and meatballs", "pasta", "bowl of pasta",
          "spaghetti plate", "bowl of spaghetti", "penne", "fettuccine"), themes=("dining",),
          roles=("edible", "round", "big"), colors=("white",))  # fmt: skip
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
    food = [(bed, surfaces.plain((232, 196, 110))), (nest, surfaces.plain((246, 216, 130))),
            (sauce, surfaces.spots(look.rng, tone, tint_color(tone, 0.7), 0.2)),
            (top, surfaces.spots(look.rng, (118, 68, 40), (80, 46, 28), 0.2)),
            (leaf, surfaces.plain((60, 130, 56)))]  # fmt: skip
    return serve(look, dish, tile, food)


def _curry(look: Look, tone: RGB, rice: bool) -> Pieces:
    z = 0.8
    chunks = scatter(look, 0.62, 10, (0.2, 0.3), z, stretch=(1, 0.8, 0.5))
    pool = lathe([(0, 0.4), (0.6, 0.4), (0.88, z), (0, z)], 30)
    pieces: Pieces = [(pool, surfaces.spots(look.rng, tone, tint_color(tone, 1.2), 0.08)),
                      (chunks, surfaces.spots(look.rng, tint_color(tone, 0.85), (226, 176, 90),
                                              0.25))]  # fmt: skip
    if rice:
        heap = ellipsoid(1.0, 1.5, 0.8, 20, 10).move(x=-0.4, z=z - 0.05)
        pieces.append((heap.bend(lambda p: (p / np.maximum(np.hypot(p[:, :1], p[:, 1:2]) / 0.87, 1)
                                            * [1, 1, 0] + p * [0, 0, 1])),
                       surfaces.spots(look.rng, (248, 246, 238), (226, 222, 210),
                                      0.3)))  # fmt: skip
    herb = scatter(look, 0.25, 4, (0.16, 0.2), z + 0.12, stretch=(1, 0.5, 0.25))
    return [*pieces, (herb.move(0.3, 0.1), surfaces.plain((66, 140, 60)))]


@category("curry", size=(0.156, 0.156, 0.0719), mass=0.7, material="ceramic",
          aliases=("bowl of curry", "chicken curry", "curry and rice", "curry bowl", "dal",
          "tikka masala", "curry rice", "bowl of dal", "balti dish", "dal bowl", "bowl of daal",
          "daal", "balti"), themes=("dining",), roles=("edible", "round"),
          colors=("white",))  # fmt: skip
def curry(look: Look) -> Shape:
    """A bowl of curry with rice on one side."""
    r, h, dish, tile = filled_bowl(look)
    tone = look.pick([(206, 130, 34), (176, 72, 30), (120, 140, 60), (220, 150, 50)])
    food = [(s.scale(r, r, h), t) for s, t in _curry(look, tone, True)]
    return serve(look, dish, tile, food)


@category("stew", size=(0.163, 0.163, 0.0623), mass=0.75, material="ceramic",
          aliases=("bowl of stew", "beef stew", "goulash", "bowl of chili", "chili con carne",
          "hotpot", "stew bowl"), themes=("dining",), roles=("edible", "round"))  # fmt: skip
def stew(look: Look) -> Shape:
    """A bowl of stew with meat, carrots and potatoes in a brown gravy."""
    r, h, dish, tile = filled_bowl(look, "terracotta", "cream", "navy", "charcoal")
    food = [(s.scale(r, r, h), t) for s, t in _curry(look, (134, 70, 34), False)]
    carrots = scatter(look, 0.6 * r, 6, (0.016, 0.02), 0.84 * h, stretch=(1, 1, 0.6))
    food.append((carrots.turn(2, 0.8), surfaces.plain((232, 124, 40))))
    return serve(look, dish, tile, food)


@category("onion_ring", size=(0.0771, 0.0775, 0.0132), mass=0.02, material="food",
          aliases=("fried onion ring", "fried calamari"), themes=("dining",),
          roles=("edible", "round", "flat"), colors=("amber",), state="lying flat")  # fmt: skip
def onion_ring(look: Look) -> Shape:
    """A breaded onion ring lying flat."""
    r, t = look.between(0.026, 0.034), look.between(0.0075, 0.0095)
    ring = torus(r, t, 30, 10)
    crumb = surfaces.spots(look.rng, look.color("amber", "tan", "golden"), (166, 96, 36), 0.3)
    return settle([(ring, crumb)], 0.15)


@category("dumpling", size=(0.0652, 0.0368, 0.0277), mass=0.025, material="food", aliases=("gyoza",
          "potsticker", "dim sum", "wonton", "pierogi", "steamed dumpling", "xiao long bao", "bao",
          "bao bun", "ravioli", "momo"), themes=("dining",), roles=("edible",),
          colors=("cream",))  # fmt: skip
def dumpling(look: Look) -> Shape:
    """A folded dumpling with its pleated seam up, or a round steamed one."""
    color = look.color("cream", "ivory", "beige", "tan")
    tile = skin(look, color, tint_color(color, 0.88), 0.7)
    if look.chance(0.6):
        x, h = look.between(0.062, 0.074), look.between(0.03, 0.036)
        a = np.linspace(0, np.pi, 13)
        path = np.column_stack([-0.5 * x * np.cos(a), 0.012 * np.sin(a) - 0.006, 0.3 * h + 0 * a])
        radii = 0.46 * h * (0.28 + 0.72 * np.sin(a))
        body = tube(path, radii, 14)
        seam = tube(path + np.column_stack([0 * a, 0 * a, 0.2 * h + 0.5 * radii]),
                    0.0028 + 0 * a, 8)  # fmt: skip
        folds = [ellipsoid(0.0062, 0.011, 0.008, 8, 6).move(*(path[n] + [0, -0.002, 0.16 * h
                 + 0.52 * radii[n]])) for n in range(2, 11)]  # fmt: skip
        return settle([(join([body, seam, *folds]), tile)], 0.15)
    r, h = look.between(0.022, 0.028), look.between(0.028, 0.034)
    body = lobe(lathe([(0, 0), (0.85 * r, 0), (r, 0.3 * h), (0.8 * r, 0.66 * h),
                       (0.32 * r, 0.9 * h),
                       (0.2 * r, h), (0, 0.94 * h)], 60), 16, 0.09)  # fmt: skip
    return shape([(body, tile)], [hull_of(body)])


@category("spring_roll", size=(0.0956, 0.0262, 0.0225), mass=0.04, material="food",
          aliases=("egg roll", "lumpia", "summer roll"), themes=("dining",), roles=("edible",),
          colors=("amber",), state="lying flat")  # fmt: skip
def spring_roll(look: Look) -> Shape:
    """A fried spring roll with the edge of its wrapper visible, lying flat."""
    long, r = look.between(0.085, 0.11), look.between(0.012, 0.015)
    body = bent_rod(long, r, blunt=10)
    edge = tube([(s * 0.47 * long, 0.5 * r * s, 0.86 * r) for s in (-1, 0, 1)], 0.0016, 6)
    color = look.color("amber", "golden", "tan")
    crisp = surfaces.spots(look.rng, color, tint_color(color, 0.72), 0.12)
    return settle([(body, crisp), (edge, surfaces.plain(tint_color(color, 0.75)))], 0.12)


@category("taco", size=(0.132, 0.028, 0.0735), mass=0.12, material="food",
          aliases=("beef taco", "taco shell", "gordita", "fajita"), themes=("dining",),
          roles=("edible",), colors=("golden",))  # fmt: skip
def taco(look: Look) -> Shape:
    """A folded taco with meat, lettuce and tomato, standing on its fold."""
    r, t = look.between(0.06, 0.07), 0.003
    half = np.concatenate([arc((0, 0), r, 0, np.pi, 18)])
    gap = look.between(0.012, 0.015)
    walls = []
    for s in (-1, 1):
        wall = prism(half, 0, t).turn(0, np.pi / 2)
        low = wall.move(y=t / 2).turn(0, np.pi).move(z=r)
        walls.append(low.turn(0, s * 0.14).move(y=s * (gap - 0.002)))
    floor = bent_rod(1.2 * r, 0.011, blunt=4).move(z=0.012)
    shell = skin(look, look.color("golden", "amber", "tan"), (196, 140, 60), 0.7)
    meat = bent_rod(1.75 * r, 0.014, blunt=3).move(z=r - 0.014)
    green = [
        ellipsoid(0.03, 0.012, 0.014, 8, 5)
        .turn(2, look.between(-0.5, 0.5))
        .move((n - 3) * 0.25 * r, look.between(-0.004, 0.004), r + 0.001)
        for n in range(7)
    ]
    red = [box(0.008, 0.008, 0.008).turn(2, n).move((n - 2) * 0.36 * r, 0.004 * (-1) ** n,
           r + 0.004) for n in range(5)]  # fmt: skip
    made = [(join([*walls, floor]), shell), (meat, surfaces.spots(look.rng, (112, 66, 40),
            (70, 40, 26), 0.3)), (join(green), surfaces.speckles(look.rng, (120, 172, 66), 12)),
            (join(red), surfaces.plain((206, 56, 40)))]  # fmt: skip
    return settle(made, 0.06)


@category("burrito", size=(0.157, 0.0583, 0.0445), mass=0.3, material="food", aliases=("wrap",
          "kebab wrap", "sandwich wrap", "shawarma", "tortilla wrap", "chicken wrap", "doner kebab",
          "gyros", "chimichanga"), themes=("dining",), roles=("edible",),
          state="lying flat")  # fmt: skip
def burrito(look: Look) -> Shape:
    """A burrito cut open at its left end, with foil or paper around the right end."""
    long, r = look.between(0.14, 0.17), look.between(0.026, 0.031)
    body = bent_rod(long, r, blunt=9, squash=0.88)
    face = cylinder(0.86 * r, 0.004, 24).turn(1, np.pi / 2).scale(1, 1, 0.88).move(-0.502 * long)
    fill = speck(speck(speck(surfaces.spots(look.rng, (176, 110, 60), (96, 56, 34), 0.25), look.rng,
                 (206, 52, 40), 16, 12), look.rng, (110, 164, 66), 16, 12), look.rng,
                 (246, 240, 220), 22, 10)  # fmt: skip
    color = look.color("cream", "beige", "ivory")
    wrap = surfaces.spots(look.rng, color, (190, 150, 96), 0.1)
    foil = bent_rod(0.55 * long, 1.03 * r, blunt=9, squash=0.89).move(x=0.24 * long)
    paper = look.pick([surfaces.brushed_metal(look.rng, (200, 203, 208)),
                       surfaces.plain((226, 206, 170))])  # fmt: skip
    return settle([(body, wrap), (face, fill), (foil, paper)], 0.12)


@category("flatbread", size=(0.197, 0.197, 0.00835), mass=0.08, material="food",
          aliases=("tortilla", "naan", "pita", "pitta", "pita bread", "naan bread", "flat bread",
          "crepe", "chapati", "pitta bread", "roti", "paratha", "lavash", "lahmacun",
          "paratha bread"), themes=("dining",), roles=("edible", "flat", "round", "support"),
          colors=("cream",), state="lying flat")  # fmt: skip
def flatbread(look: Look) -> Shape:
    """A round flatbread with brown spots."""
    r, h = look.between(0.085, 0.11), look.between(0.006, 0.01)
    phase = look.between(0, 6)
    body = cylinder(r, h, 40, bevel=0.4 * h).bend(
        lambda p: (
            p
            * np.column_stack(
                [f := 1 + 0.025 * np.sin(3 * np.arctan2(p[:, 1], p[:, 0]) + phase), f, 0 * f + 1]
            )
        )
    )
    color = look.color("cream", "beige", "tan")
    face = surfaces.spots(look.rng, color, tint_color(color, 0.9), 0.2)
    y, x = np.mgrid[0:128, 0:128]
    for _ in range(16):
        a, b, d = look.rng.uniform(8, 120), look.rng.uniform(8, 120), look.rng.uniform(3, 9)
        face[np.hypot(x - a, y - b) < d] = np.array((176, 118, 62), np.uint8)
    return shape([(body, face)], [cylinder_part(0.97 * r, h)])


@category("pizza_slice", size=(0.123, 0.171, 0.0219), mass=0.12, material="food",
          aliases=("slice of pizza", "piece of pizza"), themes=("dining",),
          roles=("edible", "flat"), colors=("red",), state="lying flat")  # fmt: skip
def pizza_slice(look: Look) -> Shape:
    """A slice of pizza with its crust at the back."""
    r, angle = look.between(0.15, 0.18), look.between(0.68, 0.82)
    base = _wedge(r, angle, 0, 0.008)
    cheese = _wedge(0.9 * r, 0.93 * angle, 0.0076, 0.0105).move(y=-0.045 * r)
    a = np.linspace(np.pi / 2 - 0.47 * angle, np.pi / 2 + 0.47 * angle, 11)
    at = np.column_stack([0.95 * r * np.cos(a), 0.95 * r * np.sin(a) - 0.55 * r, 0.011 + 0 * a])
    crust = tube(at, 0.0115, 10)
    melt = surfaces.spots(look.rng, (242, 200, 96), (214, 120, 60), 0.2)
    color = look.color("crimson", "red", "maroon", "olive")
    places = [(0, 0.32), (-0.14, 0.6), (0.13, 0.64), (0.0, 0.78), (-0.02, 0.5)]
    discs = [cylinder(0.013, 0.002, 18, bevel=0.0005).move(u * r, (v - 0.55) * r, 0.0098)
             for u, v in places]  # fmt: skip
    return shape([(join([base, crust]), skin(look, (206, 152, 86), (150, 92, 44))),
                  (cheese, melt), (join(discs), surfaces.plain(color))],
                 [hull_of(base, cheese), hull_above(crust)])  # fmt: skip


@category("lasagna", size=(0.0962, 0.0791, 0.0465), mass=0.25, material="food",
          aliases=("lasagne", "moussaka", "piece of lasagna"), themes=("dining",),
          roles=("edible",))  # fmt: skip
def lasagna(look: Look) -> Shape:
    """A square of lasagne with layers of pasta, sauce and browned cheese."""
    x, y, h = look.between(0.085, 0.105), look.between(0.07, 0.085), look.between(0.036, 0.045)
    pasta, meat = surfaces.plain((240, 210, 140)), surfaces.spots(
        look.rng, (172, 60, 34), (110, 40, 24), 0.25)  # fmt: skip
    side = surfaces.stack(*[(pasta, 1), (meat, 2.2)] * 4, side=128)
    top = surfaces.spots(look.rng, (244, 206, 110), (190, 96, 40), 0.18)
    lid = block(1.02 * x, 1.02 * y, 0.006, 0.006, 0.002).move(z=h - 0.002)
    leaf = scatter(look, 0.016, 3, (0.018, 0.02), h + 0.0045, stretch=(1, 0.5, 0.2))
    return shape([(box(x, y, h), side), (lid, top), (leaf, surfaces.plain((70, 136, 58)))],
                 [hull_of(box(x, y, h), lid)])  # fmt: skip


@category("sandwich", size=(0.137, 0.11, 0.039), mass=0.13, material="food",
          aliases=("toastie", "toasted sandwich"), themes=("dining", "office"),
          roles=("edible", "flat"), colors=("beige",), state="lying flat", common=True)  # fmt: skip
def sandwich(look: Look) -> Shape:
    """A triangular sandwich, lying flat."""
    crumb = surfaces.speckles(look.rng, look.color("beige", "cream", "tan"), 6)
    corner = np.array([(-0.065, -0.045), (0.065, -0.045), (0.0, 0.06)])
    layers = [(0.0, 0.013, 1.0, crumb)]
    fills = (("green", 0.013, 0.017, 1.05), ("red", 0.017, 0.022, 0.97),
             ("yellow", 0.022, 0.026, 1.02))  # fmt: skip
    for name, low, high, grow in fills:
        layers.append((low, high, grow, surfaces.speckles(look.rng, look.own_color(name), 9)))
    layers.append((0.026, 0.039, 1.0, crumb))
    pieces = [(prism(corner * g, low, high, 0.001), tile) for low, high, g, tile in layers]
    return shape(pieces, [hull_of(*(p for p, _ in pieces))])


CRUST: RGB = (206, 152, 86)


@category("pizza", size=(0.29, 0.29, 0.028), mass=0.7, material="food",
          aliases=("pepperoni pizza", "whole pizza"), themes=("dining", "food"),
          roles=("round", "flat", "big", "edible"), state="lying flat", common=True)  # fmt: skip
def pizza(look: Look) -> Shape:
    """A round sliced pizza, with or without a board."""
    r = look.between(0.12, 0.155)
    sauce = surfaces.noise(look.rng, 192, 192, (7, 7), 3)[..., None]
    cheese = np.where(sauce > -0.25, (240, 200, 104), (202, 82, 46)) + sauce * 12
    face = np.clip(cheese, 0, 255).astype(np.uint8)
    toppings: list[RGB] = [(178, 40, 34), (64, 116, 48), (46, 40, 44), (236, 222, 190)]
    first = look.own_color("crimson", "red", "maroon")
    spots = int(look.rng.integers(9, 15))
    for k in range(spots):
        a, away = 2.4 * k, 0.41 * np.sqrt((k + 0.5) / spots)
        prints.disc(
            face, 0.5 + away * np.cos(a), 0.5 + away * np.sin(a), 0.055, tint_color(first, 0.8)
        )
        prints.disc(face, 0.5 + away * np.cos(a), 0.5 + away * np.sin(a), 0.046, first)
    for color in toppings[1 : int(look.rng.integers(2, 5))]:
        face = speck(face, look.rng, color, 26, 6)
    for k in range(4):
        t = np.linspace(-0.5, 0.5, 300)
        rows = (96 + 188 * t * np.sin(np.pi * k / 4 + 0.3)).astype(int)
        face[rows, (96 + 188 * t * np.cos(np.pi * k / 4 + 0.3)).astype(int)] = (120, 66, 30)
    crust = skin(look, CRUST, (150, 92, 44))
    base = cylinder(r, 0.01, 40, bevel=0.003)
    rim = torus(0.94 * r, 0.0105, 40, 8).scale(1, 1, 0.85).move(z=0.012)
    top = cylinder(0.9 * r, 0.004, 40).move(z=0.0095)
    pieces = [(join([base, rim]), crust), (top, face)]
    if look.chance(0.5):
        return shape(pieces, [cylinder_part(r, 0.0155)])
    board = cylinder(1.12 * r, 0.014, 40, bevel=0.002)
    wood = surfaces.wood(look.rng, look.own_color("wooden", "tan", "beige"))
    pieces = [(solid.move(z=0.0135), tile) for solid, tile in pieces] + [(board, wood)]
    return shape(pieces, [cylinder_part(1.12 * r, 0.014), cylinder_part(r, 0.016, (0, 0, 0.0135))])


def _bun(look: Look) -> surfaces.Tile:
    return skin(look, look.own_color("amber", "tan", "copper"), (160, 96, 44), 0.6)


def _drooping(p: np.ndarray, r: float) -> np.ndarray:
    """Return the points, with those outside the radius ``r`` bent downwards."""
    beyond = np.maximum(np.hypot(p[:, 0], p[:, 1]) - r, 0)
    return np.column_stack([p[:, :2], p[:, 2] - 0.7 * beyond])


@category("burger", size=(0.108, 0.108, 0.08), mass=0.28, material="food",
          aliases=("hamburger", "cheeseburger", "beef burger"), themes=("dining", "food"),
          roles=("round", "edible"), common=True)  # fmt: skip
def burger(look: Look) -> Shape:
    """A hamburger with a bun, lettuce, tomato, cheese and a patty."""
    r = look.between(0.042, 0.055)
    bread = _bun(look)
    layers: list[tuple[Solid, surfaces.Tile]] = [(cylinder(r, 0.016, 28, bevel=0.005), bread)]
    z = 0.015
    patty = surfaces.spots(look.rng, (98, 58, 36), (62, 34, 22), 0.15)
    for _ in range(2 if look.chance(0.3) else 1):
        layers.append((cylinder(1.04 * r, 0.014, 26, bevel=0.004).move(z=z), patty))
        z += 0.013
        flat = prism(rectangle(1.62 * r, 1.62 * r, 0.002, 1), z, z + 0.003).turn(2, 0.5)
        layers.append((flat.bend(lambda p: _drooping(p, r)), surfaces.plain((244, 184, 62))))
        z += 0.002
    tomato = cylinder(0.98 * r, 0.005, 24, bevel=0.001).move(z=z)
    wave = lobe(cylinder(1.13 * r, 0.004, 48, bevel=0.001), 13, 0.16).move(z=z + 0.004)
    wavy = wave.bend(lambda p: p + np.column_stack([np.zeros((len(p), 2)), 0.0025 * np.sin(
        9 * np.arctan2(p[:, 1], p[:, 0])) * (np.hypot(p[:, 0], p[:, 1]) > 0.6 * r)]))  # fmt: skip
    layers += [(tomato, surfaces.plain((200, 52, 40))),
               (wavy, surfaces.speckles(
                   look.rng, look.own_color("green", "lime"), 14))]  # fmt: skip
    z += 0.007
    a = np.linspace(0, np.pi / 2, 8)
    curve = np.column_stack([1.03 * r * np.cos(a), 0.006 + 0.62 * r * np.sin(a)])[:-1]
    dome = lathe([(0, 0), (0.95 * r, 0), *curve, (0, 0.006 + 0.62 * r)], 28)
    seeds = []
    for _ in range(26):
        lift, turn = look.rng.uniform(0.5, 1.45), look.rng.uniform(0, 6.3)
        at = np.array([1.03 * r * np.cos(lift) * np.cos(turn), 1.03 * r * np.cos(lift)
                       * np.sin(turn), 0.0065 + 0.62 * r * np.sin(lift)])  # fmt: skip
        seeds.append(ellipsoid(0.0042, 0.0028, 0.0022, 6, 4).turn(2, turn).move(*at))
    layers += [(dome.move(z=z), bread),
               (join(seeds).move(z=z), surfaces.plain((244, 228, 180)))]  # fmt: skip
    return shape(layers, [cylinder_part(r, z), hull_of(dome.move(z=z))])


@category("hot_dog", size=(0.165, 0.065, 0.05), mass=0.13, material="food", aliases=("hotdog",),
          themes=("dining", "food"), roles=("edible",), state="lying flat",
          common=True)  # fmt: skip
def hot_dog(look: Look) -> Shape:
    """A sausage in a split bun with a line of mustard or ketchup."""
    length, r = look.between(0.14, 0.17), look.between(0.018, 0.022)
    bread = _bun(look)
    halves = [
        ellipsoid(length, 1.7 * r, 2.1 * r, 22, 12).turn(0, s * 0.25).move(y=s * 0.78 * r, z=r)
        for s in (-1, 1)
    ]
    base = ellipsoid(0.94 * length, 2.6 * r, 1.1 * r, 22, 10).move(z=0.5 * r)
    x = np.linspace(-0.54, 0.54, 9) * length
    lift = 1.55 * r + 0.25 * r * (2 * x / length) ** 2
    sausage = tube(np.column_stack([x, 0 * x, lift]),
                   0.6 * r * np.array([0.3, 0.85, 1, 1, 1, 1, 1, 0.85, 0.3]), 14)  # fmt: skip
    t = np.linspace(-0.44, 0.44, 60)
    wave = np.column_stack([t * length, 0.3 * r * np.sin(2 * np.pi * 7 * t),
                            2.16 * r + 0.25 * r * (2 * t) ** 2])  # fmt: skip
    line = tube(wave, 0.0022, 6)
    meat = skin(look, look.own_color("terracotta", "copper", "maroon"), (128, 54, 34))
    bun = join([*halves, base])
    return shape(
        [(bun, bread), (sausage, meat),
         (line, surfaces.plain(look.own_color("yellow", "red", "mustard")))],
        [flat_foot(bun.vertices), hull_of(sausage)],
    )  # fmt: skip


@category("fries", size=(0.072, 0.042, 0.125), mass=0.14, material="paper", aliases=("french fries",
          "chip cup", "box of fries", "french fry", "paper cone of chips", "cone of chips",
          "cone of fries"), themes=("dining", "food"), roles=("edible",), colors=("red", "white"),
          common=True)  # fmt: skip
def fries(look: Look) -> Shape:
    """A paper cup of French fries."""
    w, h = look.between(0.06, 0.075), look.between(0.07, 0.09)
    color = look.color("red", "white", "yellow", "blue", "tan")
    paper = surfaces.stripes([color, look.own_color("white", "yellow", "cream")], 5, upright=True)
    if look.chance(0.5):
        paper = prints.canvas(64, 64, color)
        prints.disc(paper, 0.5, 0.55, 0.22, look.own_color("yellow", "white", "red"))
    cup = box(w, 0.55 * w, h).bend(lambda p: p * np.column_stack(
        [0.74 + 0.26 * p[:, 2] / h, 0.74 + 0.26 * p[:, 2] / h, np.ones(len(p))]))  # fmt: skip
    sticks = []
    for k in range(26):
        x = ((k % 9) - 4) / 4 * 0.4 * w + look.rng.uniform(-2, 2) * 1e-3
        y = (k // 9 - 1) * 0.14 * w
        lift = look.between(0.28, 0.62) * h
        stick = box(0.0085, 0.0085, lift + 0.02).turn(1, 0.34 * x / w + look.rng.normal(0, 0.07))
        sticks.append(stick.turn(0, look.rng.normal(0, 0.07)).move(x, y, h - 0.02))
    gold = surfaces.gradient((206, 150, 60), (246, 208, 108), look.rng)
    top = hull_of(*[s.bend(lambda p: np.minimum(p, [1, 1, 1.42 * h])) for s in sticks])
    return shape([(cup, paper), (join(sticks), gold)], [hull_of(cup), top])


@category("soup", size=(0.16, 0.16, 0.057), mass=0.6, material="ceramic", hollow=True,
          aliases=("bowl of soup", "broth"), themes=("dining", "food"), roles=("round", "edible"),
          colors=("white",))  # fmt: skip
def soup(look: Look) -> Shape:
    """A bowl of tomato, pumpkin, noodle or vegetable soup, with herbs or cream."""
    r, h = look.between(0.072, 0.088), look.between(0.05, 0.062)
    color = look.color("white", "white", "cream", "teal", "terracotta", "navy", "black", "sage")
    t = np.linspace(0, np.pi / 2, 7)
    side = [((0.5 + 0.5 * np.sin(a)) * r, h * (1 - np.cos(a)) ** 0.9) for a in t]
    body, parts = open_vessel(side, 0.0045, 0.006, 32)
    inside = look.surface(tint_color(color, 1.4), "ceramic")
    level = 0.76 * h
    wide = float(np.interp(level, [z for _, z in side], [x for x, _ in side])) - 0.004
    tone = look.pick([(206, 66, 36), (228, 140, 50), (206, 170, 90), (130, 146, 70), (150, 90, 54)])
    broth = surfaces.spots(look.rng, tone, tint_color(tone, 1.25), 0.08)
    liquid = lathe([(0, 0.0065), (0.5 * wide, 0.0065), (wide, level), (0, level)], 28)
    pieces = [(body, surfaces.stack((glaze_tile(look, color), 50), (inside, 50), side=192)),
              (liquid, broth)]  # fmt: skip
    bits: dict[RGB, list[Solid]] = {}
    palette: list[RGB] = [(80, 140, 60), (236, 140, 40), (250, 244, 230), (60, 110, 50)]
    for k in range(int(look.rng.integers(6, 14))):
        away, turn = 0.72 * wide * np.sqrt(look.rng.random()), look.rng.uniform(0, 6.28)
        bit = block(look.between(0.007, 0.013), 0.008, 0.004, 0.002, 0.001).turn(2, turn)
        bit = bit.move(away * np.cos(turn), away * np.sin(turn), level - 0.002)
        bits.setdefault(palette[k % len(palette)], []).append(bit)
    if look.chance(0.4):
        swirl = torus(0.35 * wide, 0.004, 24, 6).scale(1, 1, 0.5).move(z=level)
        bits.setdefault((250, 244, 230), []).append(swirl)
    pieces += [(join(some), surfaces.plain(tint)) for tint, some in bits.items()]
    return shape(pieces, [*parts, cylinder_part(0.94 * wide, 0.6 * h, (0, 0, 0.16 * h))])
