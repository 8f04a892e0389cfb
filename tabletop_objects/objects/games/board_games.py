"""Objects of the ``games`` theme: board games."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import ellipse
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import facing
from ...kit.shapes import Category, Shape, category, in_sizes, shape
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...kit.surfaces import RGB, Look, readable_on, tint_color

Print = Callable[[Look, RGB], surfaces.Tile]
BRIGHT: tuple[RGB, ...] = ((204, 52, 48), (52, 104, 190), (70, 150, 80), (244, 206, 62),
                           (238, 132, 38), (124, 70, 150), (120, 190, 220),
                           (230, 120, 170))  # fmt: skip


def properties(look: Look, color: RGB) -> surfaces.Tile:
    """Return a game board with coloured streets around its border."""
    image = prints.canvas(256, 256, tint_color(color, 1.5))
    prints.fill(image, 0.13, 0.13, 0.74, 0.74, tint_color(color, 1.3))
    for n in range(9):
        at = 0.13 + 0.74 * n / 9
        hue = BRIGHT[(n // 2) % 8]
        other = BRIGHT[(n // 2 + 4) % 8]
        if n % 4 != 3:
            prints.fill(image, at, 0.1, 0.08, 0.03, hue)
            prints.fill(image, at, 0.87, 0.08, 0.03, other)
            prints.fill(image, 0.1, at, 0.03, 0.08, BRIGHT[(n // 2 + 2) % 8])
            prints.fill(image, 0.87, at, 0.03, 0.08, BRIGHT[(n // 2 + 6) % 8])
    for n in range(10):
        at = 0.13 + 0.74 * n / 9
        for x, y, w, h in ((at, 0, 0.006, 0.13), (at, 0.87, 0.006, 0.13), (0, at, 0.13, 0.006),
                           (0.87, at, 0.13, 0.006)):  # fmt: skip
            prints.fill(image, x, y, w, h, (40, 40, 44))
    for at in (0.0, 0.13, 0.866, 0.994):
        prints.fill(image, at, 0, 0.006, 1, (40, 40, 44))
        prints.fill(image, 0, at, 1, 0.006, (40, 40, 44))
    prints.polygon(image, [(0.2, 0.66), (0.7, 0.16), (0.84, 0.3), (0.34, 0.8)], (204, 40, 44))
    prints.fill(image, 0.22, 0.22, 0.16, 0.12, (238, 132, 38))
    prints.fill(image, 0.62, 0.66, 0.16, 0.12, (120, 190, 220))
    return image


def track(look: Look, color: RGB) -> surfaces.Tile:
    """Return a game board with a spiral of coloured spaces."""
    image = prints.canvas(224, 224, tint_color(color, 1.35))
    for _ in range(7):
        x, y = look.rng.uniform(0.2, 0.8, 2)
        prints.disc(image, float(x), float(y), look.between(0.04, 0.09), tint_color(color, 1.1))
    turns, waves = look.between(1.6, 2.3), 46
    for n in range(waves):
        a = 2 * np.pi * turns * n / waves
        r = 0.44 - 0.34 * n / waves
        at = (0.5 + r * np.cos(a), 0.5 + r * np.sin(a))
        prints.disc(image, *at, 0.041, (40, 40, 46))
        prints.disc(image, *at, 0.035, BRIGHT[n % 6])
    prints.disc(image, 0.5, 0.5, 0.07, (250, 250, 246))
    prints.write(image, "FINISH", 0.5, 0.5, 0.04, (40, 40, 46), bold=True)
    return image


def rooms(look: Look, color: RGB) -> surfaces.Tile:
    """Return a game board with a house of named rooms."""
    image = prints.canvas(240, 240, (226, 206, 150))
    for n in range(25):
        prints.fill(image, n / 24, 0, 0.004, 1, (190, 168, 116))
        prints.fill(image, 0, n / 24, 1, 0.004, (190, 168, 116))
    words = ("HALL", "LOUNGE", "STUDY", "LIBRARY", "KITCHEN", "BALLROOM", "DINING", "BILLIARD")
    places = [(0.02, 0.02), (0.38, 0.02), (0.72, 0.02), (0.02, 0.37), (0.72, 0.37), (0.02, 0.72),
              (0.38, 0.72), (0.72, 0.72)]  # fmt: skip
    for (x, y), word, n in zip(places, words, range(8), strict=True):
        tone = tint_color(color, 0.75 + 0.07 * n) if n % 2 else BRIGHT[n % 6]
        prints.fill(image, x, y, 0.26, 0.26, (60, 44, 36))
        prints.fill(image, x + 0.01, y + 0.01, 0.24, 0.24, tint_color(tone, 1.2))
        prints.write(image[:, int(240 * x):int(240 * (x + 0.26))], word, 0.5, y + 0.13, 0.035,
                     (40, 34, 30), bold=True)  # fmt: skip
    prints.fill(image, 0.4, 0.38, 0.2, 0.26, (40, 36, 40))
    return image


def world(look: Look, color: RGB) -> surfaces.Tile:
    """Return a game board with continents of coloured countries."""
    image = prints.canvas(256, 176, tint_color(color, 1.35))
    shapes = [(0.19, 0.3, 0.16), (0.28, 0.68, 0.12), (0.5, 0.28, 0.1), (0.54, 0.6, 0.15),
              (0.72, 0.3, 0.2), (0.85, 0.76, 0.09)]  # fmt: skip
    for n, (x, y, r) in enumerate(shapes):
        for k in range(9):
            a = 2.4 * k
            at = (x + 0.5 * r * np.cos(a) * np.sqrt(k / 9), y + 0.75 * r * np.sin(a)
                  * np.sqrt(k / 9))  # fmt: skip
            prints.disc(image, *at, 0.55 * r, (50, 50, 54))
            prints.disc(image, *at, 0.55 * r - 0.008, tint_color(BRIGHT[n], 0.9 + 0.06 * (k % 4)))
    prints.fill(image, 0, 0, 1, 0.02, (60, 44, 36))
    prints.fill(image, 0, 0.98, 1, 0.02, (60, 44, 36))
    return image


def noughts(look: Look, color: RGB) -> surfaces.Tile:
    """Return a board with noughts and crosses."""
    ink = readable_on(color)
    image = prints.canvas(144, 144, color)
    for at in (1 / 3, 2 / 3):
        prints.fill(image, at - 0.012, 0.05, 0.024, 0.9, ink)
        prints.fill(image, 0.05, at - 0.012, 0.9, 0.024, ink)
    for n in range(9):
        x, y = (n % 3 + 0.5) / 3, (n // 3 + 0.5) / 3
        mark = int(look.rng.integers(3))
        if mark == 1:
            prints.disc(image, x, y, 0.1, (52, 104, 190), 0.068)
        elif mark == 2:
            for s in (-1, 1):
                prints.stroke(image, [(x - 0.09, y - 0.09 * s), (x + 0.09, y + 0.09 * s)], 0.034,
                              (204, 52, 48))  # fmt: skip
    return image


def mills(look: Look, color: RGB) -> surfaces.Tile:
    """Return a nine men's morris board: three nested squares with pieces on their corners."""
    ink = readable_on(color)
    image = surfaces.fit(surfaces.wood(look.rng, color), 176, 176).copy()
    for low in (0.1, 0.23, 0.36):
        for at in (low, 1 - low):
            prints.fill(image, at - 0.006, low, 0.012, 1 - 2 * low, ink)
            prints.fill(image, low, at - 0.006, 1 - 2 * low, 0.012, ink)
    for x, y in ((0.5, 0.1), (0.5, 0.64), (0.1, 0.5), (0.64, 0.5)):
        wide = (0.012, 0.26) if x == 0.5 else (0.26, 0.012)
        prints.fill(
            image, x - (0.006 if x == 0.5 else 0), y - (0 if x == 0.5 else 0.006), *wide, ink
        )
    for low in (0.1, 0.23, 0.36):
        for x in (low, 0.5, 1 - low):
            for y in (low, 0.5, 1 - low):
                if (x, y) != (0.5, 0.5):
                    man = look.rng.integers(5)
                    tone = {0: (246, 244, 236), 1: (30, 28, 28)}.get(int(man), ink)
                    prints.disc(image, x, y, 0.042 if man < 2 else 0.022, tone)
    return image


def holes(rows: int, columns: int, wide: int, tall: int) -> Print:
    """Return a function that draws a board with rows of drilled holes and a few pegs."""

    def draw(look: Look, color: RGB) -> surfaces.Tile:
        image = surfaces.fit(surfaces.wood(look.rng, color), tall, wide).copy()
        for j in range(rows):
            for i in range(columns):
                if columns > 12 and i % 6 == 5:
                    continue
                at = ((i + 0.8) / (columns + 0.6), (j + 0.7) / (rows + 0.4))
                prints.disc(image, *at, 0.16 / rows, (50, 38, 30))
                if look.chance(0.08):
                    prints.disc(image, *at, 0.22 / rows, BRIGHT[int(look.rng.integers(4))])
        return image

    return draw


def carrom(look: Look, color: RGB) -> surfaces.Tile:
    """Return a carrom board with corner pockets and a heap of pieces."""
    image = surfaces.fit(surfaces.wood(look.rng, tint_color(color, 1.2)), 224, 224).copy()
    dark: RGB = (50, 36, 30)
    for at in ((0.08, 0.08), (0.92, 0.08), (0.08, 0.92), (0.92, 0.92)):
        prints.disc(image, *at, 0.05, dark)
    for low in (0.2, 0.25):
        for at in (low, 1 - low):
            prints.fill(image, at - 0.004, 0.22, 0.008, 0.56, dark)
            prints.fill(image, 0.22, at - 0.004, 0.56, 0.008, dark)
    prints.disc(image, 0.5, 0.5, 0.14, dark, 0.13)
    for k in range(19):
        a, r = 2.4 * k, 0.024 * np.sqrt(k) * 1.15
        tone: RGB = (196, 42, 40) if k == 0 else ((240, 226, 190) if k % 2 else dark)
        prints.disc(image, 0.5 + r * np.cos(a), 0.5 + r * np.sin(a), 0.021, tone)
    return image


def star(look: Look, color: RGB) -> surfaces.Tile:
    """Return a board with a six-pointed star of holes."""
    image = prints.canvas(224, 224, tint_color(color, 1.3))
    for n in range(6):
        a = np.pi / 3 * n + np.pi / 6
        tip = (0.5 + 0.47 * np.cos(a), 0.5 + 0.47 * np.sin(a))
        sides = [(0.5 + 0.27 * np.cos(a + s), 0.5 + 0.27 * np.sin(a + s))
                 for s in (-np.pi / 6, np.pi / 6)]  # fmt: skip
        prints.polygon(image, [sides[0], tip, sides[1]], BRIGHT[n])
    for row in range(-8, 9):
        for col in range(-8, 9):
            x, y = 0.0565 * (col + 0.5 * (row % 2)), 0.049 * row
            a = (np.arctan2(y, x) - np.pi / 6) % (np.pi / 3) - np.pi / 6
            if np.hypot(x, y) < 0.245 or np.hypot(x, y) * np.cos(abs(a) - np.pi / 3) < 0.24 - 0.01:
                prints.disc(image, 0.5 + x, 0.5 + y, 0.018, (70, 50, 40))
                prints.disc(image, 0.5 + x, 0.5 + y, 0.014, (250, 246, 232))
    return image


def board(x: float, y: float, draw: Print, palette: tuple[str, ...], kind: str = "card"):
    """Return the shape function of a printed board of the given size."""

    def make(look: Look) -> Shape:
        k = look.between(0.92, 1.08)
        color = look.color(*palette)
        a, b, t = x * k, y * k, {"card": 0.005, "wood": 0.014, "felt": 0.003}[kind]
        body = block(a, b, t, 0.004, 0.15 * t)
        edge = look.surface(tint_color(color, 0.7), "wood" if kind == "wood" else "plastic")
        face = box(0.97 * a, 0.97 * b, 0.0006).move(z=t - 0.0003)
        return shape([(body, edge), (face, draw(look, color))], [box_part(a, b, t)])

    return make


@category("mancala_board", size=(0.396, 0.119, 0.0317), mass=0.7, material="wood", assembled=True,
          aliases=("mancala", "mancala game", "oware board"), themes=("games",),
          roles=("flat", "support", "big"), colors=("wooden",), state="lying flat")  # fmt: skip
def mancala_board(look: Look) -> Shape:
    """A mancala board with two rows of six pits, a store at each end and stones."""
    k = look.between(0.92, 1.08)
    x, y, h = 0.4 * k, 0.12 * k, 0.026 * k
    color = look.color("wooden", "tan", "brown", "maroon")
    body = block(x, y, h, 0.03 * k, 0.002)
    tile = look.surface(color, "wood")
    dark = surfaces.speckles(look.rng, tint_color(color, 0.62), 6)
    pits, stones = [], []
    for i in range(6):
        for j in (-1, 1):
            at = ((i - 2.5) * 0.048 * k, 0.027 * j * k)
            pits.append(cylinder(0.02 * k, 0.0008, 22).move(*at, h - 0.0004))
            stones += [ellipsoid(0.01, 0.009, 0.008, 7, 5).move(at[0] + 0.009 * np.cos(2.1 * n + i),
                       at[1] + 0.009 * np.sin(2.1 * n + i), h + 0.002)
                       for n in range(int(look.rng.integers(1, 5)))]  # fmt: skip
    pits += [prism(ellipse(0.04 * k, 0.09 * k, 24), 0, 0.0008).move(s * 0.168 * k, 0, h - 0.0004)
             for s in (-1, 1)]  # fmt: skip
    half = len(stones) // 2
    tones = look.rng.permutation(4)
    return shape([(body, tile), (join(pits), dark),
                  (join(stones[:half]), surfaces.plain(BRIGHT[tones[0]])),
                  (join(stones[half:]), surfaces.plain(BRIGHT[tones[1]]))],
                  [box_part(x, y, h)])  # fmt: skip


@category("marble_solitaire", size=(0.212, 0.212, 0.0304), mass=0.5, material="wood",
          aliases=("solitaire board", "peg solitaire", "marble board", "solitaire game"),
          themes=("games",), roles=("flat", "support"), colors=("wooden",),
          state="lying flat")  # fmt: skip
def marble_solitaire(look: Look) -> Shape:
    """A round solitaire board with a cross of marbles."""
    r = look.between(0.095, 0.115)
    h = 0.018
    color = look.color("wooden", "brown", "tan", "maroon")
    body = lathe([(0, 0), (0.92 * r, 0), (r, 0.4 * h), (r, 0.8 * h), (0.95 * r, h), (0.86 * r, h),
                  (0.84 * r, 0.8 * h), (0.8 * r, 0.8 * h), (0.78 * r, h), (0, h)], 36)  # fmt: skip
    d, groups = 0.0155, ([], [], [])
    pale = int(look.rng.integers(33))
    count = 0
    for i in range(-3, 4):
        for j in range(-3, 4):
            if min(abs(i), abs(j)) < 2:
                count += 1
                if count != pale:
                    ball = ellipsoid(d, d, d, 8, 6).move(0.21 * r * i, 0.21 * r * j, h + 0.3 * d)
                    groups[(i * 2 + j) % 3].append(ball)
    tones = look.rng.permutation(6)
    return shape([(body, look.surface(color, "wood")),
                  *((join(g), surfaces.spots(look.rng, BRIGHT[t], tint_color(BRIGHT[t], 1.5), 0.2))
                    for g, t in zip(groups, tones[:3], strict=True))],
                 [cylinder_part(0.92 * r, 0.4 * h), hull_of(body)])  # fmt: skip


HUES: tuple[RGB, ...] = ((204, 52, 48), (52, 104, 190), (70, 150, 80), (244, 206, 62),
                         (238, 132, 38), (124, 70, 150), (230, 120, 170))  # fmt: skip


@category("connect_four", size=(0.25, 0.102, 0.244), mass=0.5, material="plastic", assembled=True,
          aliases=("connect 4", "four in a row", "connect four game", "connect four grid",
          "four in a row game"), themes=("games",), roles=("tall",), colors=("blue",))  # fmt: skip
def connect_four(look: Look) -> Shape:
    """An upright Connect Four grid of seven columns with red and yellow discs, on two feet."""
    k, color = look.between(0.85, 1.1), look.color("blue", "blue", "navy", "teal")
    w, h, t, foot = 0.24 * k, 0.2 * k, 0.016 * k, 0.028 * k
    wall = box(w, t, h).move(z=foot)
    feet = [box(0.012, 0.1 * k, foot).move(x=s * (w / 2 - 0.006)) for s in (-1, 1)]
    posts = [box(0.012, 1.2 * t, h + foot + 0.012).move(x=s * (w / 2 - 0.003)) for s in (-1, 1)]
    discs: dict[str, list[Solid]] = {"red": [], "yellow": [], "none": []}
    filled = look.rng.integers(0, 6, 7)
    for i in range(7):
        for j in range(6):
            kind = ("red" if look.chance(0.5) else "yellow") if j < filled[i] else "none"
            disc = facing(cylinder(0.0125 * k, t + 0.0016, 14)).move(
                (i - 3) * 0.0325 * k, (t + 0.0016) / 2,
                foot + 0.018 * k + j * 0.0325 * k)  # fmt: skip
            discs[kind].append(disc)
    paints: dict[str, RGB] = {"red": (206, 44, 44), "yellow": (246, 208, 60),
                              "none": (236, 238, 240)}  # fmt: skip
    skin = surfaces.speckles(look.rng, color, 3, 32)
    return shape([(join([wall, *feet, *posts]), skin),
                  *((join(g), surfaces.plain(paints[kind])) for kind, g in discs.items() if g)],
                 [hull_of(wall), *[hull_of(s) for s in (*feet, *posts)]])  # fmt: skip


@category("tangram", size=(0.118, 0.118, 0.00684), mass=0.06, material="plastic",
          aliases=("tangram puzzle", "tangram set"), themes=("games",), roles=("flat",),
          colors=("red",), state="lying flat")  # fmt: skip
def tangram(look: Look) -> Shape:
    """A tangram: seven coloured pieces arranged in a square."""
    side, t = look.between(0.1, 0.14), look.between(0.004, 0.008)
    shapes = [[(0, 0), (4, 0), (2, 2)], [(0, 0), (2, 2), (0, 4)], [(4, 0), (4, 2), (3, 1)],
              [(2, 2), (3, 1), (4, 2), (3, 3)], [(2, 2), (3, 3), (1, 3)],
              [(0, 4), (1, 3), (3, 3), (2, 4)], [(4, 2), (4, 4), (2, 4)]]  # fmt: skip
    asked = "color" in look.attributes
    base, order = look.color("red", "blue", "green"), look.rng.permutation(7)
    pieces, parts = [], []
    for n, corners in enumerate(shapes):
        points = (np.array(corners, float) - 2) / 4 * side
        points = points.mean(0) + (points - points.mean(0)) * 0.95
        solid = prism(points, 0, t)
        hue = tint_color(base, 0.7 + 0.1 * n) if asked else HUES[order[n]]
        pieces.append((solid, look.surface(hue, "plastic")))
        parts.append(hull_of(solid))
    return shape(pieces, parts)


@category("kerplunk", size=(0.158, 0.158, 0.294), mass=0.4, material="plastic",
          aliases=("marble drop game", "kerplunk game"), themes=("games",), roles=("tall", "round"),
          colors=("yellow",))  # fmt: skip
def kerplunk(look: Look) -> Shape:
    """A KerPlunk game: a transparent tube on a base, pierced by sticks with marbles on them."""
    r, h = look.between(0.042, 0.05), look.between(0.2, 0.24)
    color = look.color("yellow", "red", "blue", "orange")
    base = lathe(
        [(0, 0), (1.7 * r, 0), (1.7 * r, 0.025), (1.2 * r, 0.03), (1.05 * r, 0.06), (0, 0.06)], 28
    )
    wall = cylinder(0.96 * r, h, 24).move(z=0.055)
    cap = cylinder(1.04 * r, 0.02, 24).move(z=h + 0.05)
    sticks = [tube([(-1.45 * r, 0, 0), (1.45 * r, 0, 0)], 0.0014, 5)
              .turn(2, 2.4 * k).move(0, 0, 0.12 + 0.0035 * (k % 5)) for k in range(14)]  # fmt: skip
    image = prints.canvas(192, 96, (214, 230, 236))
    for _ in range(34):
        x, y = look.rng.random(), look.rng.uniform(0.1, 0.5)
        prints.disc(image, x, y, 0.05, HUES[int(look.rng.integers(7))])
    tile = surfaces.speckles(look.rng, color, 3, 32)
    return shape([(join([base, cap]), tile), (wall, image), (join(sticks),
        surfaces.plain((236, 120, 40)))],
                 [hull_of(base), hull_of(wall, cap)])  # fmt: skip


@category("tumbling_tower", size=(0.08, 0.08, 0.24), mass=0.75, material="wood", aliases=("jenga",
          "jenga tower", "block tower", "tower of blocks", "stacking tower", "jenga block tower",
          "toy block tower"), themes=("games",), roles=("tall",), colors=("wooden",))  # fmt: skip
def tumbling_tower(look: Look) -> Shape:
    """A tower of wooden bars in layers of three, each layer at right angles to the next."""
    layers = int(look.rng.integers(14, 19))
    color = look.color("wooden", "tan", "beige")
    woods = [surfaces.wood(look.rng, tint_color(color, f), side=64) for f in (0.9, 1.0, 1.15)]
    bars: list[list[Solid]] = [[], [], []]
    for n in range(layers):
        for m in (-1, 0, 1):
            out = look.between(0.0, 0.008) if look.chance(0.25) else 0.0
            bar = box(0.075, 0.0244, 0.0148).move(x=out, y=0.025 * m).turn(2, n % 2 * np.pi / 2)
            bars[int(look.rng.integers(3))].append(bar.move(z=0.015 * n))
    parts = [box_part(0.075, 0.075, 0.015 * layers - 0.0002)]
    return shape([(join(b), w) for b, w in zip(bars, woods, strict=True) if b], parts)


_checkers_set_Print = Callable[[Look, RGB], surfaces.Tile]


def _board(
    side: float, draw: _checkers_set_Print, palette: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """Return the shape function of a square game board; ``draw`` draws its print and its pieces."""

    def make(look: Look) -> Shape:
        k = look.between(0.94, 1.06) * side
        color = look.color(*palette)
        body = block(k, k, 0.012, 0.004, 0.001)
        face = box(0.96 * k, 0.96 * k, 0.0006).move(z=0.0118)
        wood = look.surface(tint_color(color, 0.8), "wood")
        return shape([(body, wood), (face, draw(look, color))], [box_part(k, k, 0.0122)])

    return make


def _squares(look: Look, color: RGB) -> surfaces.Tile:
    dark = tint_color(look.own_color("black", "brown", "red", "green"), 0.9)
    image = prints.canvas(192, 192, tint_color(color, 1.4))
    for i in range(8):
        for j in range(8):
            if (i + j) % 2:
                prints.fill(image, i / 8, j / 8, 1 / 8, 1 / 8, dark)
    return image


@category("checkers_set", size=(0.3, 0.3, 0.018), mass=0.7, material="wood", assembled=True,
          aliases=("checkers", "checkerboard", "draughts", "checkers board", "draughts board",
          "checker board", "chequers"), themes=("games",), roles=("flat", "big"),
          colors=("wooden",))  # fmt: skip
def checkers_set(look: Look) -> Shape:
    """A draughts board with its pieces set up."""
    made = _board(0.3, _squares, ("wooden", "tan", "beige", "red"))(look)
    side = 0.288
    pieces = [(p.solid, p.tile) for p in made.pieces]
    parts = list(made.parts)
    pale, deep = look.own_color("white", "cream", "tan"), look.own_color("red", "black", "brown")
    for rows, color in (((0, 1, 2), pale), ((5, 6, 7), deep)):
        tile = surfaces.plain(color)
        for j in rows:
            for i in range(8):
                if (i + j) % 2:
                    at = ((i - 3.5) * side / 8, (j - 3.5) * side / 8, 0.012)
                    pieces.append((cylinder(0.0135, 0.006, 14, bevel=0.001).move(*at), tile))
        y = (float(np.mean(rows)) - 3.5) * side / 8
        parts.append(box_part(side - 0.012, 0.1, 0.006, (0, y, 0.012)))
    return shape(pieces, parts)


def _go(look: Look, color: RGB) -> surfaces.Tile:
    ground = surfaces.fit(surfaces.wood(look.rng, color), 192, 192)
    lines = surfaces.grid((40, 32, 26), (255, 255, 255), 14, 14, 192)
    image = np.where(lines < 120, lines, ground).astype(np.uint8)
    spots = look.rng.permutation(13 * 13)[:34]
    for n, place in enumerate(spots):
        tone = (28, 28, 30) if n % 2 else (246, 246, 242)
        at = (place % 13 + 1) / 14, (place // 13 + 1) / 14
        prints.disc(image, *at, 0.035, tint_color(tone, 0.75))
        prints.disc(image, *at, 0.03, tone)
    return image


def _points(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(192, 192, tint_color(color, 0.9))
    tones = look.own_color("crimson", "brown", "navy"), look.own_color("cream", "tan", "white")
    men = look.own_color("black", "brown"), look.own_color("white", "red")
    for n in range(12):
        x = 0.03 + 0.073 * n + (0.06 if n > 5 else 0.0)
        for m, (y, tip) in enumerate(((0.03, 0.44), (0.97, 0.56))):
            prints.polygon(image, [(x, y), (x + 0.07, y), (x + 0.035, tip)], tones[(n + m) % 2])
            for c in range(5 if n in (0, 6) else 3 if n == 4 else 0):
                way = 0.07 * c + 0.035
                at = (x + 0.035, y + way if m == 0 else y - way)
                prints.disc(image, *at, 0.034, (30, 26, 24))
                prints.disc(image, *at, 0.031, men[(m + n) % 2])
    prints.fill(image, 0.475, 0, 0.05, 1, tint_color(color, 0.6))
    return image


def _ludo(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(192, 192, tint_color(color, 1.6))
    tones: tuple[RGB, ...] = ((206, 48, 44), (60, 150, 80), (240, 200, 60), (50, 100, 190))
    for n, (x, y) in enumerate(((0.02, 0.02), (0.62, 0.02), (0.62, 0.62), (0.02, 0.62))):
        prints.fill(image, x, y, 0.36, 0.36, tones[n])
        prints.disc(image, x + 0.18, y + 0.18, 0.13, (248, 246, 240))
        for a in range(4):
            u, v = 0.06 * (a % 2 * 2 - 1), 0.06 * (a // 2 * 2 - 1)
            prints.disc(image, x + 0.18 + u, y + 0.18 + v, 0.035, tones[n])
    for n in range(15):
        for m in range(3):
            for x, y in ((0.4 + 0.0667 * m, n / 15), (n / 15, 0.4 + 0.0667 * m)):
                own = m == 1 and 0 < n < 14 and n not in (6, 7, 8)
                tone = tones[(1 if n < 7 else 3) if x >= 0.4 and x < 0.6 else
                             (0 if n < 7 else 2)] if own else (250, 249, 244)  # fmt: skip
                prints.fill(image, x + 0.004, y + 0.004, 0.056, 0.056, tone)
    prints.fill(image, 0.4, 0.4, 0.2, 0.2, (250, 249, 244))
    return image


def _letters(look: Look, color: RGB) -> surfaces.Tile:
    image = surfaces.grid((250, 248, 240), tint_color(color, 1.3), 15, 15, 210)
    image = surfaces.fit(image, 210, 210).copy()
    for n in range(15):
        for m in range(15):
            if (n == m or n + m == 14) and n not in (6, 8):
                prints.fill(image, n / 15 + 0.006, m / 15 + 0.006, 0.056, 0.056, (240, 160, 170))
            elif n % 7 == 0 and m % 7 == 0:
                prints.fill(image, n / 15 + 0.006, m / 15 + 0.006, 0.056, 0.056, (206, 60, 56))
            elif (3 * n + 5 * m) % 13 == 0:
                prints.fill(image, n / 15 + 0.006, m / 15 + 0.006, 0.056, 0.056, (110, 170, 220))
    for word, x, y, across in (
        ("TABLE", 4, 7, True),
        ("LEMON", 7, 7, False),
        ("RIVER", 3, 9, True),
    ):
        for n, letter in enumerate(word):
            u, v = (x + n, y) if across else (x, y + n)
            cell = image[v * 14 : v * 14 + 14, u * 14 : u * 14 + 14]
            cell[1:13, 1:13] = (240, 214, 160)
            prints.write(cell, letter, 0.5, 0.5, 0.6, (40, 34, 28))
    return image


def _snakes(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(200, 200, tint_color(color, 1.5))
    tones = [look.own_color("yellow", "sky", "pink"), look.own_color("mint", "orange"),
             look.own_color("cream", "white")]  # fmt: skip
    for n in range(100):
        x, y = n % 10 / 10, n // 10 / 10
        prints.fill(image, x + 0.004, y + 0.004, 0.092, 0.092, tones[(n % 10 + 2 * (n // 10)) % 3])
        cell = image[n // 10 * 20 : n // 10 * 20 + 20, n % 10 * 20 : n % 10 * 20 + 20]
        prints.write(cell, str(100 - n), 0.42, 0.4, 0.36, (60, 60, 66))
    for a, b in (((0.15, 0.9), (0.35, 0.4)), ((0.8, 0.65), (0.6, 0.1))):
        for side in (-0.025, 0.025):
            prints.stroke(image, [(a[0] + side, a[1]), (b[0] + side, b[1])], 0.015, (120, 78, 44))
        for t in np.linspace(0.05, 0.95, 8):
            x, y = a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])
            prints.stroke(image, [(x - 0.025, y), (x + 0.025, y)], 0.012, (120, 78, 44))
    for start, tone in (((0.25, 0.1), (60, 150, 70)), ((0.9, 0.2), (190, 60, 60))):
        t = np.linspace(0, 1, 24)
        xs = start[0] - 0.15 * t + 0.05 * np.sin(14 * t)
        prints.stroke(image, list(zip(xs, start[1] + 0.5 * t, strict=True)), 0.03, tone)
        prints.disc(image, *start, 0.03, tone)
    return image


def _game_box(titles: tuple[str, ...], puzzle: bool) -> Callable[[Look], Shape]:
    """A flat box with a lid, a big picture and a title."""

    def make(look: Look) -> Shape:
        x, y, h = look.between(0.24, 0.29), look.between(0.2, 0.24), look.between(0.045, 0.06)
        color = look.color("blue", "red", "green", "orange", "purple", "teal", "yellow")
        cover = prints.landscape(look.rng, 192, 160) if puzzle else prints.artwork(
            look.rng, 192, 160)  # fmt: skip
        cover = surfaces.fit(cover, 160, 192).copy()
        prints.fill(cover, 0.0, 0.04, 1, 0.24, color)
        word = look.pick(titles)
        prints.write(cover, word, 0.5, 0.16, 0.15, readable_on(color), bold=True)
        if puzzle:
            for n in range(1, 8):
                prints.fill(cover, n / 8, 0.32, 0.006, 0.68, (70, 70, 70))
            for n in range(1, 5):
                prints.fill(cover, 0, 0.32 + 0.136 * n, 1, 0.008, (70, 70, 70))
        sign = prints.canvas(160, 40, color)
        prints.write(sign, word, 0.5, 0.5, 0.5, readable_on(color), bold=True)
        return shape(
            [(box(0.985 * x, 0.985 * y, 0.4 * h), surfaces.plain((236, 232, 224))),
             (box(x, y, 0.8 * h).move(z=0.2 * h), sign),
             (box(x, y, 0.0006).move(z=h - 0.0003), cover)],
            [box_part(x, y, h)])  # fmt: skip

    return make


@category("dartboard", size=(0.34, 0.34, 0.0254), mass=1.2, material="paper",
          aliases=("dart board",), themes=("games",), roles=("flat", "round", "big"))  # fmt: skip
@in_sizes(0.15)
def dartboard(look: Look) -> Shape:
    """A dartboard lying flat with its coloured sectors up."""
    r, h = look.between(0.15, 0.19), 0.025
    image = prints.canvas(224, 224, (30, 30, 32))
    red, green = look.color("red", "crimson"), look.own_color("green", "teal")
    y, x = np.mgrid[0:224, 0:224] / 111.5 - 1
    away = np.hypot(x, y)
    odd = np.floor((np.arctan2(y, x) / np.pi * 10) + 0.5) % 2 > 0
    cream, black = np.array((236, 222, 190)), np.array((34, 34, 36))
    image[(away < 0.8)] = np.where(odd[..., None], cream, black)[away < 0.8].astype(np.uint8)
    for a, b in ((0.75, 0.8), (0.45, 0.5)):
        ring = (away < b) & (away > a)
        image[ring] = np.where(odd[..., None], green, red)[ring].astype(np.uint8)
    prints.disc(image, 0.5, 0.5, 0.045, green)
    prints.disc(image, 0.5, 0.5, 0.02, red)
    for n, score in enumerate((20, 1, 18, 4, 13, 6, 10, 15, 2, 17, 3, 19, 7, 16, 8, 11, 14, 9, 12,
                               5)):  # fmt: skip
        a = n * np.pi / 10
        u, v = 112 + 100 * np.sin(a), 112 - 100 * np.cos(a)
        cell = prints.canvas(24, 18, (30, 30, 32))
        prints.write(cell, str(score), 0.5, 0.5, 0.7, (240, 240, 236))
        top, left = int(np.clip(v - 9, 0, 206)), int(np.clip(u - 12, 0, 200))
        image[top : top + 18, left : left + 24] = np.maximum(
            image[top : top + 18, left : left + 24], cell)  # fmt: skip
    face = prism(ellipse(1.98 * r, 1.98 * r, 40), h - 0.0003, h + 0.0004)
    return shape([(cylinder(r, h, 40, bevel=0.002), surfaces.plain((34, 34, 36))), (face, image)],
                 [cylinder_part(r, h)])  # fmt: skip


@category("chess_board", size=(0.33, 0.33, 0.06), mass=1.2, material="wood", assembled=True,
          aliases=("chess", "chess set", "chess game"), themes=("games",), roles=("big",),
          colors=("brown", "black"), common=True)  # fmt: skip
def chess_board(look: Look) -> Shape:
    """A chess board with simple pieces set up on its first and last ranks."""
    side, h = look.between(0.28, 0.38), look.between(0.012, 0.022)
    dark, light = (
        look.color("brown", "black", "maroon", "green"),
        look.own_color("cream", "beige", "tan"),
    )
    image = prints.canvas(192, 192, tint_color(dark, 0.7))
    for i in range(8):
        for j in range(8):
            ink = dark if (i + j) % 2 else light
            prints.fill(image, 0.06 + 0.11 * i, 0.06 + 0.11 * j, 0.11, 0.11, ink)
    board = block(side, side, h, 0.004, 0.002)
    top = box(0.985 * side, 0.985 * side, 0.001).move(z=h - 0.0004)
    cell = 0.11 * side
    pieces = [(board, surfaces.wood(look.rng, tint_color(dark, 0.8))), (top, image)]
    parts = [box_part(side, side, h)]
    tall = 0.85 * cell
    if look.chance(0.75):
        pawn = lathe(
            [(0, 0), (0.3 * cell, 0), (0.3 * cell, 0.12 * tall), (0.12 * cell, 0.35 * tall),
             (0.12 * cell, 0.6 * tall), (0.21 * cell, 0.78 * tall), (0, tall)], 7,
        )  # fmt: skip
        king = lathe(
            [(0, 0), (0.34 * cell, 0), (0.15 * cell, 0.5 * tall), (0.15 * cell, 1.2 * tall),
             (0.24 * cell, 1.45 * tall), (0, 1.65 * tall)], 7,
        )  # fmt: skip
        for s, ink in ((-1, tint_color(light, 1.3)), (1, tint_color(dark, 0.55))):
            men = [m.move((k - 3.5) * cell, s * row * cell, h) for k in range(8)
                   for row, m in ((3.5, king), (2.5, pawn)) if look.chance(0.9)]  # fmt: skip
            pieces.append((join(men), surfaces.plain(ink)))
            parts.append(box_part(7.3 * cell, 1.4 * cell, 0.95 * tall, (0, s * 3.0 * cell, h)))
    return shape(pieces, parts)


CATEGORIES = (
    Category("monopoly_board", board(0.34, 0.34, properties, ("mint", "cream", "sage", "sky")),
             size=(0.335, 0.335, 0.0053), mass=0.5, material="paper",
             aliases=("monopoly", "monopoly game board", "property game board"), themes=("games",),
             roles=("flat", "support", "big"), colors=("mint",), state="lying flat"),
    Category("game_board", board(0.32, 0.32, track, ("sky", "yellow", "mint", "pink", "lavender")),
             size=(0.322, 0.322, 0.0053), mass=0.4, material="paper", aliases=("pictionary board",
             "trivial pursuit board", "board game mat", "track board", "candy land board"),
             themes=("games",), roles=("flat", "support", "big"), colors=("sky",),
             state="lying flat"),
    Category("cluedo_board", board(0.34, 0.34, rooms, ("terracotta", "teal", "olive")),
             size=(0.342, 0.342, 0.0053), mass=0.5, material="paper",
             aliases=("clue board", "cluedo", "mansion board"), themes=("games",),
             roles=("flat", "support", "big"), colors=("terracotta",), state="lying flat"),
    Category("risk_board", board(0.4, 0.27, world, ("sky", "teal", "navy")),
             size=(0.407, 0.275, 0.0053), mass=0.5, material="paper",
             aliases=("world domination board", "war game board", "risk game board"),
             themes=("games",), roles=("flat", "support", "big"), colors=("sky",),
             state="lying flat"),
    Category("tic_tac_toe_board",
             board(0.16, 0.16, noughts, ("wooden", "white", "tan", "sky"), "wood"),
             size=(0.161, 0.161, 0.0143), mass=0.2, material="wood", aliases=("tic tac toe",
             "tic-tac-toe", "noughts and crosses", "noughts and crosses board", "tic tac toe game"),
             themes=("games",), roles=("flat", "support"), colors=("wooden",), state="lying flat"),
    Category("mill_board", board(0.25, 0.25, mills, ("wooden", "tan", "beige"), "wood"),
             size=(0.241, 0.241, 0.0143), mass=0.5, material="wood",
             aliases=("nine men's morris board", "nine mens morris board", "nine men's morris",
             "morris board", "mill game"), themes=("games",), roles=("flat", "support", "big"),
             colors=("wooden",), state="lying flat"),
    Category("cribbage_board",
             board(0.3, 0.08, holes(5, 31, 320, 96), ("wooden", "maroon", "tan"), "wood"),
             size=(0.305, 0.0814, 0.0143), mass=0.25, material="wood",
             aliases=("crib board", "cribbage"), themes=("games",), roles=("flat", "support"),
             colors=("wooden",), state="lying flat"),
    Category("mastermind_board",
             board(0.2, 0.1, holes(4, 10, 256, 128), ("brown", "gray", "white"), "wood"),
             size=(0.2, 0.0998, 0.0143), mass=0.3, material="plastic",
             aliases=("mastermind game", "code breaker board"), themes=("games",),
             roles=("flat", "support"), colors=("brown",), state="lying flat"),
    Category("carrom_board", board(0.38, 0.38, carrom, ("wooden", "tan", "maroon"), "wood"),
             size=(0.37, 0.37, 0.0143), mass=1.2, material="wood",
             aliases=("crokinole board", "carrom"), themes=("games",),
             roles=("flat", "support", "big"), colors=("wooden",), state="lying flat"),
    Category("chinese_checkers_board", board(0.28, 0.28, star, ("cream", "wooden", "sky"), "wood"),
             size=(0.274, 0.274, 0.0143), mass=0.6, material="wood", aliases=("chinese checkers",
             "chinese chequers", "star halma board", "chinese chequers board"), themes=("games",),
             roles=("flat", "support", "big"), colors=("cream",), state="lying flat"),
    Category("go_board", _board(0.3, _go, ("wooden", "tan", "amber")), size=(0.3, 0.3, 0.0124),
             mass=0.9, material="wood", aliases=("go game", "baduk board", "gomoku board"),
             themes=("games",), roles=("flat", "big"), colors=("wooden",)),
    Category("backgammon_board", _board(0.3, _points, ("wooden", "green", "maroon")),
             size=(0.3, 0.3, 0.0124), mass=0.9, material="wood",
             aliases=("backgammon", "backgammon set"), themes=("games",), roles=("flat", "big"),
             colors=("wooden",)),
    Category("ludo_board", _board(0.28, _ludo, ("cream", "sky", "white")),
             size=(0.28, 0.28, 0.0124), mass=0.6, material="wood",
             aliases=("ludo", "ludo game", "parcheesi"), themes=("games",), roles=("flat", "big")),
    Category("scrabble_board", _board(0.3, _letters, ("sage", "beige", "teal")),
             size=(0.3, 0.3, 0.0124), mass=0.8, material="wood",
             aliases=("scrabble", "scrabble game", "word game"), themes=("games",),
             roles=("flat", "big")),
    Category("snakes_and_ladders", _board(0.28, _snakes, ("yellow", "sky", "mint")),
             size=(0.28, 0.28, 0.0124), mass=0.5, material="wood",
             aliases=("chutes and ladders", "snakes and ladders board"), themes=("games",),
             roles=("flat", "big")),
    Category("jigsaw_puzzle", _game_box(("PUZZLE", "1000 PIECES", "JIGSAW", "500 PIECES"), True),
             size=(0.265, 0.22, 0.0525), mass=0.7, material="paper", aliases=("jigsaw", "puzzle",
             "puzzle box", "jigsaw box", "jigsaw puzzle box", "box of puzzle pieces"),
             themes=("games",), roles=("flat", "support", "big")),
    Category("board_game", _game_box(("KINGDOMS", "QUEST", "TRADERS", "CASTLE", "EXPLORERS",
             "FAMILY GAME"), False), size=(0.265, 0.22, 0.0525), mass=1.1, material="paper",
             aliases=("game box", "boxed game", "board game box", "family game", "boardgame",
             "party game", "battleship game", "operation game", "mouse trap game", "buckaroo",
             "battleship", "guess who", "guess who board", "hungry hippos", "model kit"),
             themes=("games",), roles=("flat", "support", "big")),
)  # fmt: skip
"""Objects that share their drawing functions."""
