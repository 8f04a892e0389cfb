"""More fruit and vegetables, and sweet or cooked things."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, flat_foot, hull_of, hull_part, resting_ball
from ...build.forms import above, blade, lobe
from ...build.outlines import smooth
from ...build.recipes import open_vessel
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, cylinder, ellipsoid, join, lathe, loft, torus, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look


def _crease(solid: Solid, deep: float) -> Solid:
    """Return a round fruit with one furrow from stalk to tip, towards the viewer."""

    def furrow(p: np.ndarray) -> np.ndarray:
        turn = np.arctan2(p[:, 1], p[:, 0]) + np.pi / 2 + 0.35
        factor = 1 - deep * np.exp(-((np.angle(np.exp(1j * turn)) / 0.3) ** 2))
        return p * np.column_stack([factor, factor, np.ones(len(p))])

    return solid.bend(furrow)


def _fruit(d: float, tall: float, dip: float = 0.12) -> Solid:
    """Return a round fruit of diameter ``d`` standing on a flat spot, dented at its stalk."""
    t = np.linspace(-np.pi / 2, np.pi / 2, 17)
    r, z = 0.5 * d * np.cos(t), 0.5 * tall * (1 + np.sin(t))
    z = z - dip * tall * np.exp(-((r / (0.16 * d)) ** 2)) * (np.sin(t) > 0)
    r[[0, -1]] = 0
    return lathe(np.column_stack([r, z]), 28).move(z=-0.02 * tall)


def _furrow(skin: textures.Tile) -> textures.Tile:
    """Return a fruit's skin with a darker line where ``_creased`` has its furrow."""
    made = skin.copy()
    wide = made.shape[1]
    at = int(0.444 * wide)
    made[:, at - 1 : at + 2] = (made[:, at - 1 : at + 2] * 0.85).astype(np.uint8)
    return made


def peach(look: Look) -> Shape:
    """A peach, nectarine or apricot with its furrow, a stalk and maybe a leaf."""
    d = look.between(0.058, 0.078)
    color = look.color("coral", "orange", "golden", "coral", "amber")
    blush = look.pick([(206, 60, 60), (220, 90, 70), (186, 40, 60)])
    skin = _furrow(textures.gradient(color, blush, look.rng, 9))
    body = _crease(_fruit(d, 0.94 * d), 0.15).bend(above)
    stalk = tube([(0, 0, 0.76 * d), (0.002, 0, 0.9 * d)], 0.002, 7)
    pieces = [(body, skin), (stalk, textures.plain((96, 70, 44)))]
    if look.chance(0.5):
        leaf = blade([(0, 0, 0.86 * d), (0.02, 0.005, 0.96 * d), (0.045, 0.01, 0.9 * d)], 0.022)
        pieces.append((leaf, textures.leaf(look.rng, look.own_color("green", "green", "olive"))))
    return shape(pieces, [resting_ball(0.97 * d, 0.95 * d, 0.9 * d)])


def plum(look: Look) -> Shape:
    """A plum: purple, red or yellow, with a bloom on its skin."""
    d = look.between(0.042, 0.055)
    color = look.color("purple", "indigo", "maroon", "crimson", "mustard")
    skin = _furrow(
        textures.gradient(tint_color(color, 0.75), tint_color(color, 1.15), look.rng, 10)
    )
    body = _crease(_fruit(d, look.between(1.0, 1.15) * d, 0.08), 0.14).bend(above)
    stalk = tube([(0, 0, 0.9 * d), (0.004, 0, 1.14 * d)], 0.0013, 6)
    return shape([(body, skin), (stalk, textures.plain((110, 96, 50)))],
                 [resting_ball(0.96 * d, 0.94 * d, float(body.bounds[1, 2]))])  # fmt: skip


def mango(look: Look) -> Shape:
    """A mango lying on its side: a kidney of green, yellow and red."""
    k = look.between(0.9, 1.12)
    color = look.color("golden", "yellow", "green", "orange", "olive")
    skin = textures.gradient(color, look.pick([(200, 70, 50), (220, 110, 50), (110, 140, 60)]),
                             look.rng, 10)  # fmt: skip
    t = np.linspace(-1, 1, 15)
    path = np.column_stack([0.055 * k * t, 0.012 * k * t**2, 0.035 * k + 0 * t])
    wide = 0.034 * k * np.sqrt(np.clip(1 - t**2, 0.0, 1)) * (1.04 - 0.16 * t)
    body = tube(path, np.maximum(wide, 0.002), 20, squash=0.98).bend(above)
    stalk = tube([(-0.054 * k, 0.012 * k, 0.035 * k), (-0.061 * k, 0.014 * k, 0.038 * k)], 0.003, 7)
    return shape([(body, skin), (stalk, textures.plain((96, 74, 46)))],
                 [flat_foot(body.vertices, 0.1)])  # fmt: skip


def kiwi(look: Look) -> Shape:
    """A kiwi fruit: whole and furry, or a half showing green flesh and seeds."""
    k = look.between(0.9, 1.1)
    brown = look.color("brown", "bronze", "olive")
    fur = textures.scratches(look.rng, brown, tint_color(brown, 1.25), 260)
    if look.chance(0.2):
        body = ellipsoid(0.062 * k, 0.046 * k, 0.044 * k, 24, 14).move(z=0.021 * k).bend(above)
        end = cylinder(0.004, 0.004, 10).turn(1, np.pi / 2).move(x=0.029 * k, z=0.021 * k)
        return shape([(body, fur), (end, textures.plain((70, 50, 34)))],
                     [resting_ball(0.06 * k, 0.045 * k, 0.042 * k)])  # fmt: skip
    r = 0.024 * k
    cup = lathe([(0, 0), (0.5 * r, 0), (0.85 * r, 0.3 * r), (r, 0.9 * r), (0.97 * r, 0.98 * r),
                 (0, 0.98 * r)], 26)  # fmt: skip
    v, u = np.mgrid[0:96, 0:96] / 96 - 0.5 + 0.5 / 96
    away, turn = np.hypot(u, v), np.arctan2(v, u)
    flesh = np.empty((96, 96, 3))
    flesh[:] = (132, 176, 54)
    flesh[away < 0.4] = (150, 194, 66)
    rays = (away < 0.4) & (away > 0.14) & (np.sin(26 * turn) > 0.55)
    flesh[rays] = (178, 212, 104)
    flesh[(away < 0.26) & (away > 0.17) & (np.sin(30 * turn) > 0.5)] = (34, 30, 24)
    flesh[away < 0.12] = (226, 232, 176)
    face = cylinder(0.96 * r, 0.001, 28).move(z=0.98 * r - 0.0004)
    return shape([(cup, fur), (face, flesh.astype(np.uint8))], [hull_of(cup)])


def eggplant(look: Look) -> Shape:
    """An aubergine lying: a dark glossy club with a green cap."""
    k = look.between(0.88, 1.12)
    color = look.color("purple", "indigo", "indigo", "maroon", "violet")
    skin = textures.gradient(tint_color(color, 0.5), tint_color(color, 0.7), look.rng, 4)
    t = np.linspace(0, 1, 16)
    wide = 0.037 * k * np.sqrt(np.clip(1 - (2 * t - 1) ** 4, 0.002, 1)) * (1 - 0.42 * t)
    path = np.column_stack([0.2 * k * (t - 0.5), 0.012 * k * np.sin(np.pi * t),
                            0.036 * k - 0.013 * k * t])  # fmt: skip
    body = tube(path, wide, 20).bend(above)
    leaf = textures.speckles(look.rng, (96, 136, 62), 10)
    end = np.array([0.1 * k, 0, 0.023 * k])
    cap = lobe(lathe([(0, 0), (0.021 * k, 0), (0.019 * k, 0.012 * k), (0.006 * k, 0.022 * k),
                       (0, 0.022 * k)], 40), 5, 0.6)  # fmt: skip
    cap = cap.turn(1, np.pi / 2).move(*(end - [0.018 * k, 0, 0]))
    bend, tip = np.array([0.02 * k, 0.002, 0.004]), np.array([0.034 * k, 0.006, 0.012])
    stalk = tube(smooth([end, end + bend, end + tip], 3), 0.005 * k, 8)
    x = body.vertices[:, 0]
    return shape([(body, skin), (join([cap, stalk]), leaf)],
                 [flat_foot(body.vertices[x < 0.02 * k], 0.1),
                  hull_part(body.vertices[x > -0.02 * k]),
                  hull_of(stalk)])  # fmt: skip


def cherries(look: Look) -> Shape:
    """Two or three cherries joined at their stalks."""
    d = look.between(0.021, 0.025)
    color = look.color("crimson", "red", "maroon", "crimson", "golden")
    skin = textures.gradient(tint_color(color, 0.8), tint_color(color, 1.1), look.rng, 6)
    count = look.pick([2, 2, 3])
    fruits, stalks, parts = [], [], []
    knot = np.array([0.004, 0.03, 0.036])
    for k in range(count):
        x, y = (k - (count - 1) / 2) * 1.25 * d, -0.006 * (k % 2) - 0.01
        fruit = _fruit(d, 0.93 * d, 0.14).bend(above).move(x, y)
        fruits.append(fruit)
        top = np.array([x, y, 0.76 * d])
        stalks.append(
            tube(smooth([top, top + np.array([0.001, 0.004, 0.014]), knot], 4), 0.0009, 5)
        )
        ball = resting_ball(0.97 * d, 0.97 * d, 0.86 * d)
        parts.append(type(ball)(ball.vertices + np.array([x, y, 0])))
    leaf = blade(
        [knot, knot + np.array([0.02, 0.012, 0.003]), knot + np.array([0.045, 0.016, -0.008])],
        0.022,
    )
    pieces = [(join(fruits), skin), (join(stalks), textures.plain((104, 120, 52)))]
    if look.chance(0.6):
        pieces.append((leaf, textures.leaf(look.rng, (76, 134, 62))))
    return shape(pieces, parts)


def ice_cream(look: Look) -> Shape:
    """Scoops of ice cream in a glass dish, with a wafer, sauce or a cherry."""
    tones: dict[str, RGB] = {"vanilla": (246, 234, 196), "strawberry": (240, 168, 180),
                             "chocolate": (112, 72, 50), "mint": (176, 220, 190),
                             "mango": (246, 196, 90), "berry": (170, 120, 180)}  # fmt: skip
    r, h = look.between(0.044, 0.052), look.between(0.06, 0.085)
    color = look.color("clear", "white", "sky", "pink", "mint", "yellow")
    side = [(0.72 * r, 0), (0.2 * r, 0.16 * h), (0.2 * r, 0.34 * h), (0.62 * r, 0.5 * h),
            (0.92 * r, 0.76 * h), (r, h)]  # fmt: skip
    dish = lathe([(0, 0), *side, (0.94 * r, h), (0.8 * r, 0.8 * h), (0, 0.7 * h)], 30)
    pieces = [(dish, textures.plain(tint_color(color, 1.15)))]
    names = list(tones)
    places = [(-0.36, 0.1, 0.0), (0.36, 0.1, 0.0), (0.0, -0.28, 0.0), (0.0, 0.05, 0.62)]
    balls = []
    for a, b, lift in places[: look.pick([3, 4])]:
        tone = tones[look.pick(names)]
        ball = ellipsoid(1.02 * r, 1.02 * r, 0.96 * r, 18, 12)
        ball = ball.move(a * r, b * r, h + (0.16 + lift) * r)
        balls.append(ball)
        pieces.append((ball, textures.spots(look.rng, tone, tint_color(tone, 0.86), 0.12)))
    top = max(float(b.bounds[1, 2]) for b in balls)
    kind = look.pick(["wafer", "cherry", "plain"])
    if kind == "wafer":
        wafer = block(0.03, 0.006, 0.085, 0.004).turn(1, 0.35).move(0.4 * r, 0.35 * r, h)
        pieces.append((wafer, textures.grid((176, 116, 56), (222, 168, 98), 10, 5, 64, 3)))
    elif kind == "cherry":
        cherry = ellipsoid(0.02, 0.02, 0.02, 14, 8).move(0, -0.05 * r, top + 0.005)
        pieces.append((cherry, textures.plain((190, 24, 40))))
    return shape(pieces, [cylinder_part(0.72 * r, 0.1 * h), hull_part(dish.vertices),
                          hull_part(np.concatenate([b.vertices for b in balls]))])  # fmt: skip


def soup(look: Look) -> Shape:
    """A bowl of soup: tomato, pumpkin, noodle or vegetable, with herbs or cream."""
    r, h = look.between(0.072, 0.088), look.between(0.05, 0.062)
    color = look.color("white", "white", "cream", "teal", "terracotta", "navy", "black", "sage")
    t = np.linspace(0, np.pi / 2, 7)
    side = [((0.5 + 0.5 * np.sin(a)) * r, h * (1 - np.cos(a)) ** 0.9) for a in t]
    body, parts = open_vessel(side, 0.0045, 0.006, 32)
    inside = look.surface(tint_color(color, 1.4), "ceramic")
    level = 0.76 * h
    wide = float(np.interp(level, [z for _, z in side], [x for x, _ in side])) - 0.004
    tone = look.pick([(206, 66, 36), (228, 140, 50), (206, 170, 90), (130, 146, 70), (150, 90, 54)])
    broth = textures.spots(look.rng, tone, tint_color(tone, 1.25), 0.08)
    liquid = lathe([(0, 0.0065), (0.5 * wide, 0.0065), (wide, level), (0, level)], 28)
    pieces = [(body, textures.stack((glaze_tile(look, color), 50), (inside, 50), side=192)),
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
    pieces += [(join(some), textures.plain(tint)) for tint, some in bits.items()]
    return shape(pieces, [*parts, cylinder_part(0.94 * wide, 0.6 * h, (0, 0, 0.16 * h))])


def steak(look: Look) -> Shape:
    """A steak lying flat: grilled, with dark stripes, or raw, with a rim of fat."""
    k = look.between(0.9, 1.1)
    raw = look.chance(0.4)
    color = look.color("red", "crimson") if raw else look.color("brown", "maroon", "bronze")
    t = np.linspace(0, 2 * np.pi, 36, endpoint=False)
    away = (
        1
        + 0.13 * np.cos(2 * t + 0.6)
        + 0.07 * np.sin(3 * t)
        - 0.12 * np.exp(-((t - 2.1) ** 2) / 0.1)
    )
    outline = np.column_stack([0.066 * k * away * np.cos(t), 0.047 * k * away * np.sin(t)])
    meat = textures.spots(look.rng, color, tint_color(color, 0.7), 0.25).copy()
    if raw:
        meat = textures.marble(look.rng, color, (238, 206, 196))
    else:
        for row in range(10, 128, 24):
            for j in range(128):
                meat[(row + j // 3) % 128 : (row + j // 3) % 128 + 5, j] = (46, 28, 22)
    h = look.between(0.018, 0.026)
    rings = [(0.93, 0.0), (1.0, 0.3 * h), (0.99, 0.7 * h), (0.9, h)]
    body = loft(
        np.stack([np.column_stack([outline * s, np.full(36, z)]) for s, z in rings]), outline
    )
    fat = tube(np.column_stack([outline[3:16] * 1.0, np.full(13, 0.5 * h)]), 0.42 * h, 8)
    tone = (242, 226, 206) if raw else (206, 160, 100)
    return shape([(body, meat), (fat, textures.plain(tone))], [hull_of(body)])


def sushi_rolls(look: Look) -> Shape:
    """Three to five sushi rolls standing in a row: rice in seaweed round a filling."""
    r, h = look.between(0.017, 0.022), look.between(0.022, 0.028)
    color = look.color("orange", "coral", "green", "crimson", "yellow", "lime")
    rice = textures.spots(look.rng, (248, 246, 238), (226, 222, 208), 0.3)
    nori = textures.speckles(look.rng, (34, 46, 38), 8)
    inside_out = look.chance(0.3)
    pieces: list[tuple[Solid, textures.Tile]] = []
    parts = []
    count = int(look.rng.integers(3, 6))
    for k in range(count):
        x, y = (k - (count - 1) / 2) * 2.25 * r, 0.003 * (-1) ** k
        band = lathe([(0.88 * r, 0), (r, 0.001), (r, h - 0.001), (0.88 * r, h)], 24, loop=True)
        core = lathe([(0, 0), (0.89 * r, 0), (0.89 * r, h), (0, h + 0.001)], 22)
        fill = cylinder(0.4 * r, 0.003, 14).move(z=h)
        other = cylinder(0.17 * r, 0.0034, 10).move(0.24 * r, 0.1 * r, h)
        outer = textures.spots(look.rng, (248, 246, 238), (232, 120, 50), 0.2)
        pieces += [(band.move(x, y), outer if inside_out else nori), (core.move(x, y), rice),
                   (fill.move(x, y), textures.speckles(look.rng, color, 8, 32)),
                   (other.move(x, y), textures.plain((120, 170, 70)))]  # fmt: skip
        parts.append(cylinder_part(r, h, (x, y, 0)))
    return shape(pieces, parts)


CATEGORIES = (
    Category("peach", peach, (0.0758, 0.0683, 0.0671), 0.15, ("nectarine", "apricot",
             "plastic peach"), ("kitchen",
             "food"), ("round", "edible"), ("coral",)),
    Category("plum", plum, (0.048, 0.047, 0.055), 0.07, ("damson",), ("kitchen", "food"),
             ("round", "edible"), ("purple",)),
    Category("mango", mango, (0.118, 0.07, 0.07), 0.3, (), ("kitchen", "food"),
             ("edible",), ("golden",), state="lying flat"),
    Category("kiwi", kiwi, (0.0536, 0.0471, 0.0311), 0.06, ("kiwi fruit", "kiwifruit",
             "kiwi half"), ("kitchen", "food"), ("edible",), ("brown",), state="lying flat"),
    Category("eggplant", eggplant, (0.237, 0.0665, 0.065), 0.3, ("aubergine", "brinjal"),
             ("kitchen", "food"), ("edible",), ("purple",), state="lying flat"),
    Category("cherries", cherries, (0.0686, 0.071, 0.0399), 0.02, ("cherry", "pair of cherries",
             "bunch of cherries"), ("kitchen", "food"), ("edible",), ("crimson",),
             state="lying flat"),
    Category("ice_cream", ice_cream, (0.0994, 0.0981, 0.116), 0.3, ("gelato", "ice cream bowl",
             "sundae",
             "ice cream sundae",
             "bowl of ice cream", "cup of ice cream", "ice cream cup", "frozen yogurt",
             "affogato"), ("dining",
             "food"), ("edible", "tall"), ("pink", "white")),
    Category("soup", soup, (0.16, 0.16, 0.057), 0.6, ("bowl of soup", "broth"), ("dining", "food"),
             ("round", "edible"),
             ("white",)),
    Category("steak", steak, (0.151, 0.0943, 0.0214), 0.25, ("beef steak", "meat", "beef",
             "piece of meat", "beefsteak", "raw steak", "grilled steak",
             "meat slice"), ("dining", "food"), ("flat", "edible"), ("brown",),
             state="lying flat"),
    Category("sushi_rolls", sushi_rolls, (0.151, 0.0458, 0.0288), 0.1, ("maki rolls",
             "row of sushi"), ("dining", "food"),
             ("edible",), ("orange",)),
)  # fmt: skip
"""The module's categories."""
