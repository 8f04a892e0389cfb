"""Objects of the ``games`` theme: game pieces."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import ellipse, smooth
from ...kit.parts import box_part, cylinder_part, hull_of, resting_ball
from ...kit.primitives import press_flat, side_view
from ...kit.shapes import Category, Shape, category, keep_still, shape
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism
from ...kit.surfaces import RGB, Look, readable_on, tint_color
from ..toys.shapes import paint, same

Head = Callable[[float, float], list[Solid]]
"""Makes what stands on a body of radius r and height h."""


COLORS = ("cream", "black", "white", "brown", "charcoal", "tan")


def _body(r: float, h: float, neck: float) -> list[tuple[float, float]]:
    """Return the profile of a turned chess piece up to the height ``h``: foot, waist and collar."""
    return [(0, 0), (r, 0), (r, 0.14 * r), (0.94 * r, 0.34 * r), (0.78 * r, 0.5 * r),
            (0.8 * r, 0.62 * r), (0.55 * r, 0.9 * r), (neck * r, 0.62 * h), (neck * r, 0.86 * h),
            (1.75 * neck * r, 0.9 * h), (1.75 * neck * r, 0.94 * h), (neck * r, h)]  # fmt: skip


def _pawn(r: float, h: float) -> list[Solid]:
    return [ellipsoid(1.15 * r, 1.15 * r, 1.15 * r, 18, 12).move(z=h + 0.4 * r)]


def _rook(r: float, h: float) -> list[Solid]:
    tower = lathe(
        [(0, h - 0.002), (0.62 * r, h - 0.002), (0.74 * r, h + 0.6 * r), (0, h + 0.6 * r)], 24
    )
    teeth = [box(0.26 * r, 0.34 * r, 0.34 * r).move(0.6 * r, 0, h + 0.58 * r).turn(2, a)
             for a in 2 * np.pi * np.arange(6) / 6]  # fmt: skip
    return [tower, *teeth]


def _bishop(r: float, h: float) -> list[Solid]:
    hat = lathe([(0, h - 0.002), (0.4 * r, h), (0.6 * r, h + 0.5 * r), (0.44 * r, h + 1.0 * r),
                 (0.12 * r, h + 1.4 * r), (0, h + 1.42 * r)], 22)  # fmt: skip
    slit = box(0.7 * r, 0.1 * r, 0.5 * r).turn(1, -0.6).move(0.3 * r, 0, h + 0.75 * r)
    return [hat, slit, ellipsoid(0.26 * r, 0.26 * r, 0.26 * r, 12, 8).move(z=h + 1.5 * r)]


def _queen(r: float, h: float) -> list[Solid]:
    cup = lathe([(0, h - 0.002), (0.4 * r, h), (0.5 * r, h + 0.6 * r), (0.8 * r, h + 1.1 * r),
                 (0.5 * r, h + 1.05 * r), (0, h + 1.2 * r)], 24)  # fmt: skip
    tips = [ellipsoid(0.28 * r, 0.28 * r, 0.3 * r, 8, 6).move(0.7 * r, 0, h + 1.14 * r).turn(2, a)
            for a in 2 * np.pi * np.arange(8) / 8]  # fmt: skip
    return [cup, *tips, ellipsoid(0.4 * r, 0.4 * r, 0.4 * r, 12, 8).move(z=h + 1.3 * r)]


def _king(r: float, h: float) -> list[Solid]:
    cup = lathe([(0, h - 0.002), (0.42 * r, h), (0.56 * r, h + 0.7 * r), (0.74 * r, h + 1.1 * r),
                 (0.4 * r, h + 1.3 * r), (0, h + 1.34 * r)], 24)  # fmt: skip
    return [cup, box(0.2 * r, 0.2 * r, 0.8 * r).move(z=h + 1.3 * r),
            box(0.6 * r, 0.2 * r, 0.2 * r).move(z=h + 1.68 * r)]  # fmt: skip


def _knight(r: float, h: float) -> list[Solid]:
    side = smooth([(-0.5, 0), (0.62, 0), (0.78, 0.7), (0.66, 1.3), (0.3, 1.75), (0.22, 2.05),
                   (0.02, 1.82), (-0.5, 1.5), (-0.92, 1.1), (-0.86, 0.85), (-0.6, 0.85),
                   (-0.2, 0.95), (-0.38, 0.5)], 3)  # fmt: skip
    head = side_view(side * r, 0.56 * r).move(z=h - 0.02 * r)
    ears = [box(0.14 * r, 0.16 * r, 0.3 * r).move(0.24 * r, s * 0.17 * r, h + 1.84 * r)
            for s in (-1, 1)]  # fmt: skip
    return [head, *ears]


def man(height: float, neck: float, head: Head) -> Callable[[Look], Shape]:
    """Return the shape function of a chess piece of about the given body height, in metres."""

    def make(look: Look) -> Shape:
        r = look.between(0.0145, 0.0175)
        h = height * r / 0.016 * look.between(0.94, 1.08)
        body = lathe([*_body(r, h, neck), (0, h)], 24)
        tile = look.surface(look.color(*COLORS), look.pick(["plastic", "wood", "plastic"]))
        top = head(r, h)
        return shape([(body, tile), (join(top), tile)],
                     [cylinder_part(0.99 * r, 0.2 * r), hull_of(body), hull_of(*top)])  # fmt: skip

    return make


HUES: tuple[RGB, ...] = ((204, 52, 48), (52, 104, 190), (70, 150, 80), (244, 206, 62),
                         (238, 132, 38), (124, 70, 150), (230, 120, 170))  # fmt: skip


@category("hex_tile", size=(0.0829, 0.0718, 0.00362), mass=0.006, material="paper",
          aliases=("catan tile", "settlers tile", "terrain tile", "hexagon tile"),
          themes=("games",), roles=("flat",), colors=("green",), state="lying flat")  # fmt: skip
def hex_tile(look: Look) -> Shape:
    """A hexagonal landscape tile of one colour with trees, sheaves or hills."""
    r, t = look.between(0.036, 0.045), look.between(0.0025, 0.004)
    color = look.color("green", "lime", "mustard", "terracotta", "gray", "tan", "sky")
    outline = ellipse(2 * r, 2 * r, 6)
    image = prints.canvas(144, 126, color)
    for _ in range(15):
        x, y = look.rng.uniform(0.14, 0.86, 2)
        tone = tint_color(color, look.between(0.6, 1.3))
        prints.polygon(image, [(x - 0.06, y + 0.06), (x, y - 0.08), (x + 0.06, y + 0.06)], tone)
    prints.disc(image, 0.5, 0.5, 0.15, (246, 236, 206))
    prints.write(image, str(look.pick([2, 3, 4, 5, 6, 8, 9, 10, 11, 12])), 0.5, 0.5, 0.16,
                 (60, 40, 34), bold=True)  # fmt: skip
    body, face = prism(outline, 0, t), prism(outline * 0.93, t - 0.0003, t + 0.0003)
    return shape([(body, surfaces.plain((236, 222, 180))), (face, image)], [hull_of(body, face)])


@category("game_house", size=(0.0134, 0.0157, 0.014), mass=0.002, material="plastic",
          aliases=("monopoly house", "monopoly hotel"), themes=("games",),
          colors=("green",))  # fmt: skip
def game_house(look: Look) -> Shape:
    """A tiny house with a pitched roof, or a longer hotel."""
    long = look.pick([0.013, 0.013, 0.02]) * look.between(0.9, 1.2)
    w, h = 0.012 * look.between(0.9, 1.1), 0.008
    color = look.color("green", "red", "blue", "yellow")
    side = [(-w / 2, 0), (w / 2, 0), (w / 2, h), (0.58 * w, h), (0, 1.75 * h), (-0.58 * w, h),
            (-w / 2, h)]  # fmt: skip
    body = side_view(np.array(side), long)
    return shape([(body, surfaces.speckles(look.rng, color, 3, 32))],
                 [box_part(w, long, h), hull_of(body.bend(_roof(h)))])  # fmt: skip


def _roof(h: float):
    return lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], h)])


@category("tile_rack", size=(0.2, 0.04, 0.028), mass=0.05, material="wood",
          aliases=("scrabble rack", "scrabble tile rack", "domino rack", "rummy rack"),
          themes=("games",), colors=("wooden",))  # fmt: skip
def tile_rack(look: Look) -> Shape:
    """A wooden rack with a sloping face and letter tiles leaning on it."""
    long, color = look.between(0.18, 0.22), look.color("wooden", "tan", "brown", "maroon")
    side = np.array([(-0.02, 0), (0.02, 0), (0.02, 0.008), (0.008, 0.026), (0.002, 0.026),
                     (-0.009, 0.01), (-0.009, 0.013), (-0.02, 0.013)])  # fmt: skip
    body = prism(side, -long / 2, long / 2).turn(0, np.pi / 2).turn(2, np.pi / 2)
    pieces = [(body, look.surface(color, "wood"))]
    if look.chance(0.7):
        for k in range(7):
            image = prints.canvas(48, 48, (240, 222, 176))
            prints.write(
                image, look.pick(list("AEIRSTNLO")), 0.5, 0.5, 0.56, (40, 34, 30), bold=True
            )
            tile = box(0.019, 0.0038, 0.019).turn(0, -0.6).move((k - 3) * 0.0215, -0.009, 0.0125)
            pieces.append((tile, image))
    low = body.bend(lambda p: np.minimum(p, [9, 9, 0.013]))
    return shape(pieces, [hull_of(low), hull_of(body)])


@category("game_spinner", size=(0.125, 0.125, 0.0125), mass=0.03, material="paper",
          aliases=("spinner", "arrow spinner", "twister spinner", "board game spinner",
          "spinner wheel"), themes=("games",), roles=("flat",), colors=("white",),
          state="lying flat")  # fmt: skip
def game_spinner(look: Look) -> Shape:
    """A card with a coloured wheel and an arrow that spins on a pin."""
    side, color = look.between(0.11, 0.14), look.color("white", "sky", "yellow", "mint")
    body = block(side, side, 0.004, 0.008)
    image, count = prints.canvas(176, 176, color), look.pick([4, 6, 8])
    start = int(look.rng.integers(7))
    for n in range(count):
        a = 2 * np.pi * np.linspace(n / count, (n + 1) / count, 8)
        rim = [(0.5 + 0.44 * np.cos(t), 0.5 + 0.44 * np.sin(t)) for t in a]
        prints.polygon(image, [(0.5, 0.5), *rim], HUES[(n + start) % 7 if n < 7 else 5])
    face = box(0.96 * side, 0.96 * side, 0.0005).move(z=0.0038)
    arrow = prism(np.array([(-0.2, -0.035), (0.2, -0.035), (0.2, -0.09), (0.4, 0), (0.2, 0.09),
                            (0.2, 0.035), (-0.2, 0.035)]) * side, 0.0075, 0.009)  # fmt: skip
    arrow = arrow.turn(2, look.between(0, 6.3))
    pin = cylinder(0.006, 0.0085, 16, top=0.005).move(z=0.004)
    dark = surfaces.plain((34, 34, 40))
    return shape([(body, surfaces.plain(tint_color(color, 0.8))), (face, image), (arrow, dark),
                  (pin, dark)],
                 [box_part(side, side, 0.0044), hull_of(pin, arrow)])  # fmt: skip


@category("shogi_piece", size=(0.0269, 0.0309, 0.00868), mass=0.003, material="wood",
          aliases=("shogi tile", "japanese chess piece"), themes=("games",), roles=("flat",),
          colors=("tan",), state="lying flat")  # fmt: skip
def shogi_piece(look: Look) -> Shape:
    """A shogi piece: a pointed wooden wedge with ink characters."""
    k, color = look.between(0.9, 1.15), look.color("tan", "wooden", "beige", "amber")
    outline = (
        np.array([(-0.5, -0.55), (0.5, -0.55), (0.4, 0.32), (0, 0.6), (-0.4, 0.32)]) * 0.027 * k
    )
    body = prism(outline, 0, 0.009 * k)
    body = body.bend(lambda p: p * np.column_stack([
        np.ones((len(p), 2)), 0.75 - 0.4 * p[:, 1] / (0.027 * k)]))  # fmt: skip
    image = surfaces.fit(surfaces.wood(look.rng, color), 96, 80).copy()
    ink: RGB = (34, 30, 28)
    for y in (0.42, 0.62, 0.8):
        prints.stroke(image, [(0.32, y), (0.68, y - 0.03)], 0.035, ink)
    prints.stroke(image, [(0.5, 0.3), (0.47, 0.88)], 0.04, ink)
    prints.stroke(image, [(0.38, 0.7), (0.62, 0.86)], 0.03, ink)
    return shape([(body, image)], [hull_of(body)])


@category("tangram_piece", size=(0.075, 0.0429, 0.00659), mass=0.008, material="plastic",
          aliases=("tan piece", "tangram tile"), themes=("games",), roles=("flat",),
          colors=("red",), state="lying flat")  # fmt: skip
def tangram_piece(look: Look) -> Shape:
    """One flat piece of a tangram: a triangle, a square or a parallelogram."""
    k, t = look.between(0.03, 0.045), look.between(0.004, 0.008)
    corners = look.pick([[(-1, -0.5), (1, -0.5), (0, 0.5)], [(-0.7, -0.7), (0.7, -0.7), (0.7, 0.7),
        (-0.7, 0.7)],
                         [(-1.2, -0.5), (0.4, -0.5), (1.2, 0.5), (-0.4, 0.5)],
                         [(-1.4, -0.7), (1.4, -0.7), (0, 0.7)]])  # fmt: skip
    color = look.color("red", "blue", "green", "yellow", "orange", "purple")
    solid = prism(np.array(corners) * k, 0, t, 0.0005)
    return shape([(solid, look.surface(color, "plastic"))], [hull_of(solid)])


@category("pick_up_stick", size=(0.175, 0.0033, 0.0033), mass=0.001, material="wood",
          aliases=("pickup stick", "mikado stick", "pick-up stick", "spillikin"), themes=("games",),
          colors=("red",), state="lying flat")  # fmt: skip
@keep_still
def pick_up_stick(look: Look) -> Shape:
    """A thin, pointed pick-up stick with coloured bands, lying flat."""
    long, r = look.between(0.16, 0.19), look.between(0.0015, 0.002)
    color = look.color("red", "blue", "green", "yellow", "wooden")
    stick = lathe([(0, 0), (0.9 * r, 0.012), (r, 0.02), (r, long - 0.02), (0.9 * r, long - 0.012),
                   (0, long)], 8).turn(1, np.pi / 2).move(-long / 2, 0, r)  # fmt: skip
    bands = surfaces.stack((surfaces.plain((226, 196, 146)), 0.1), (surfaces.plain(color), 0.14),
                           (surfaces.plain((226, 196, 146)), 0.5), (surfaces.plain(color), 0.14),
                           (surfaces.plain((226, 196, 146)), 0.12))  # fmt: skip
    return shape([(stick, bands)], [hull_of(stick)])


WOODEN = ("wooden", "tan", "beige", "wooden", "brown")
Print = Callable[[Look, RGB], surfaces.Tile]
PIECES = ("red", "blue", "green", "yellow", "black", "white", "orange", "purple")


def _disc_piece(r: float, h: float, palette: tuple[str, ...]) -> Callable[[Look], Shape]:
    """A turned disc with a raised rim: a draughts piece or a counter."""

    def make(look: Look) -> Shape:
        k = look.between(0.9, 1.1)
        a, b = r * k, h * k
        body = lathe([(0, 0), (0.94 * a, 0), (a, 0.2 * b), (a, 0.8 * b), (0.94 * a, b),
                      (0.76 * a, b), (0.7 * a, 0.8 * b), (0.5 * a, 0.8 * b), (0.45 * a, 0.9 * b),
                      (0, 0.9 * b)], 28)  # fmt: skip
        tile = look.surface(look.color(*palette), look.pick(["plastic", "wood"]))
        return shape([(body, tile)], [cylinder_part(a, b)])

    return make


@category("go_stone", size=(0.0225, 0.0225, 0.0097), mass=0.006, material="glass", friction=0.6,
          aliases=("go piece", "gomoku stone"), themes=("games",), roles=("round",),
          colors=("black", "white"))  # fmt: skip
def go_stone(look: Look) -> Shape:
    """A lens-shaped go stone."""
    k = look.between(0.95, 1.1)
    stone = ellipsoid(0.022 * k, 0.022 * k, 0.0095 * k, 24, 12).move(z=0.00475 * k)
    tile = surfaces.speckles(look.rng, look.color("black", "white"), 4, 32)
    return shape([(stone, tile)], [resting_ball(0.022 * k, 0.022 * k, 0.0095 * k)])


def tile_piece(
    x: float, y: float, h: float, draw: Print, palette: tuple[str, ...], back: bool = False
) -> Callable[[Look], Shape]:
    """A tile lying face up; ``draw`` prints its face and ``back`` colours its underside."""

    def make(look: Look) -> Shape:
        k = look.between(0.95, 1.08)
        color = look.color(*palette)
        a, b, c = x * k, y * k, h * k
        body = block(a, b, c, 0.1 * min(a, b), 0.08 * c)
        face = box(0.86 * a, 0.86 * b, 0.0004).move(z=c - 0.0003)
        pieces = [(body, look.surface(color, "plastic")), (face, draw(look, color))]
        if back:
            under = block(1.002 * a, 1.002 * b, 0.4 * c, 0.1 * min(a, b))
            pieces.append((under, surfaces.plain(look.own_color("green", "blue", "orange"))))
        return shape(pieces, [box_part(a, b, c)])

    return make


def _letter(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(64, 64, color)
    letter = look.pick(list("ABCDEHLMNORSTUWZ"))
    prints.write(image, letter, 0.46, 0.46, 0.5, readable_on(color), bold=True)
    prints.write(image, str(int(look.rng.integers(1, 9))), 0.82, 0.84, 0.2, readable_on(color))
    return image


def _mahjong(look: Look, color: RGB) -> surfaces.Tile:
    image = prints.canvas(72, 96, color)
    count = int(look.rng.integers(1, 10))
    inks: tuple[RGB, ...] = ((190, 44, 44), (40, 110, 70), (40, 70, 150))
    if look.chance(0.5):
        across = 1 if count < 3 else 2 if count < 7 else 3
        for n in range(count):
            x = (n % across + 0.5) / across
            y = (n // across + 0.5) / -(-count // across)
            prints.disc(image, x, y, 0.11, inks[n % 3])
            prints.disc(image, x, y, 0.055, color)
    else:
        for n in range(min(count, 6)):
            x, y = (n % 3 + 0.5) / 3, 0.28 + 0.44 * (n // 3)
            prints.stroke(image, [(x, y - 0.16), (x, y + 0.16)], 0.07, inks[1 + n % 2])
            prints.disc(image, x, y, 0.04, inks[0])
    return image


def _domino(look: Look, color: RGB) -> surfaces.Tile:
    ink = readable_on(color)
    halves = [prints.pips(int(n), color, ink) for n in look.rng.integers(1, 7, 2)]
    image = np.concatenate(halves, axis=1).copy()
    prints.fill(image, 0.49, 0.08, 0.02, 0.84, ink)
    return image


@category("puzzle_piece", size=(0.0296, 0.0473, 0.0035), mass=0.003, material="paper",
          aliases=("jigsaw piece", "jigsaw puzzle piece", "piece of a puzzle", "push fit piece"),
          themes=("games",), roles=("flat",))  # fmt: skip
def puzzle_piece(look: Look) -> Shape:
    """One piece of a jigsaw puzzle: a square with tabs and blanks."""
    k = look.between(0.9, 1.15)
    knob = smooth([(0.12, 0), (0.09, 0.1), (0.17, 0.2), (0, 0.3), (-0.17, 0.2), (-0.09, 0.1),
                   (-0.12, 0)], 4)  # fmt: skip
    outline = []
    for n, sign in enumerate((1, -1, 1, -1)):
        a = n * np.pi / 2
        turn = np.array([[np.cos(a), np.sin(a)], [-np.sin(a), np.cos(a)]])
        side = np.add(np.concatenate([[(0.5, 0)], knob * [1, sign]]), (0, 0.5))
        outline.append(side @ turn)
    points = np.concatenate(outline) * 0.03 * k
    h = 0.0035
    color = look.color("sky", "green", "yellow", "red", "orange", "purple", "blue")
    body = prism(points, 0, h)
    skin = surfaces.speckles(look.rng, color, 10, 48)
    knobs = [box(0.013 * k, 0.005 * k, h).move(y=0.0205 * k).turn(2, a) for a in (0, np.pi)]
    return shape(
        [(body, skin)], [box_part(0.02 * k, 0.03 * k, h), box_part(0.03 * k, 0.012 * k, h),
                         *[hull_of(s) for s in knobs]])  # fmt: skip


@category("meeple", size=(0.0178, 0.0105, 0.018), mass=0.002, material="wood",
          aliases=("game token", "token", "wooden meeple", "game figure", "game piece"),
          themes=("games",), colors=("red", "blue"))  # fmt: skip
def meeple(look: Look) -> Shape:
    """A small wooden meeple, standing upright."""
    k = look.between(0.9, 1.2)
    right = [(0.003, 0), (0.008, 0), (0.0035, 0.0075), (0.0085, 0.0085), (0.0085, 0.0105),
             (0.0035, 0.0125), (0.0032, 0.0155), (0.0015, 0.0172)]  # fmt: skip
    outline = np.array([(0, 0.003), *right, *[(-x, z) for x, z in right[::-1]]]) * k
    body = prism(outline, -0.005 * k, 0.005 * k).turn(0, np.pi / 2)
    tile = look.surface(look.color(*PIECES), "wood")
    foot = box(0.016 * k, 0.01 * k, 0.007 * k)
    top = box(0.0155 * k, 0.0096 * k, 0.005 * k).move(z=0.007 * k)
    head = box(0.006 * k, 0.0096 * k, 0.005 * k).move(z=0.012 * k)
    return shape([(body, tile)], [hull_of(s) for s in (foot, top, head)])


@category("game_pawn", size=(0.0158, 0.0158, 0.0278), mass=0.003, material="wood",
          aliases=("halma piece", "ludo piece", "ludo pawn", "board game pawn", "pawn token"),
          themes=("games",), roles=("round",), colors=("red", "yellow"))  # fmt: skip
def game_pawn(look: Look) -> Shape:
    """A game pawn: a cone with a ball as its head."""
    k = look.between(0.9, 1.2)
    a = np.linspace(-1.1, np.pi / 2, 8)
    head = np.column_stack([0.005 * np.cos(a), 0.0215 + 0.005 * np.sin(a)])
    head[-1, 0] = 0
    profile = [(0, 0), (0.0075, 0), (0.0075, 0.002), (0.0055, 0.006), *map(tuple, head)]
    body = lathe(np.array(profile) * k, 22)
    tile = look.surface(look.color(*PIECES), look.pick(["wood", "plastic"]))
    return shape([(body, tile)], [cylinder_part(0.0074 * k, 0.0025 * k), hull_of(body)])


@category("dart", size=(0.15, 0.027, 0.027), mass=0.022, material="metal", assembled=True,
          aliases=("steel dart", "throwing dart"), themes=("games",), colors=("red",))  # fmt: skip
@keep_still
def dart(look: Look) -> Shape:
    """A dart lying flat, with a point, a metal barrel, a shaft and four flights."""
    k = look.between(0.94, 1.08)
    z = 0.0135 * k
    rod = lathe(np.array([(0, 0), (0.0005, 0), (0.0012, 0.03), (0.0032, 0.034), (0.0036, 0.055),
                          (0.0032, 0.08), (0.0018, 0.083), (0.0016, 0.15), (0, 0.15)]) * k,
                14)  # fmt: skip
    rod = rod.turn(1, np.pi / 2).move(x=-0.075 * k, z=z)
    flight = prism(np.array([(0.035, 0.001), (0.075, 0.001), (0.07, 0.018), (0.05, 0.018)]) * k,
                   -0.0004, 0.0004)  # fmt: skip
    color = look.color("red", "blue", "green", "yellow", "black", "orange")
    skin = surfaces.stripes([color, color, tint_color(color, 1.5)], 2)
    wings = [flight.turn(0, a + np.pi / 4).move(z=z) for a in np.arange(4) * np.pi / 2]
    lean = np.arctan2(0.0105 * k, 0.11 * k) * 0.9
    tilted = [s.move(x=-0.06 * k, z=-z).turn(1, lean).move(x=0.06 * k, z=z) for s in (rod, *wings)]
    low = min(float(s.bounds[0, 2]) for s in tilted)
    rod, *wings = (s.move(z=-low) for s in tilted)
    return shape([(rod, surfaces.brushed_metal(look.rng, (186, 180, 164))),
                  *[(w, skin) for w in wings]], [hull_of(rod), hull_of(*wings)])  # fmt: skip


@category("chess_piece", size=(0.032, 0.032, 0.05), mass=0.035, material="wood",
          aliases=("chessman", "chessman of lewis"), themes=("games",), roles=("round",),
          colors=("cream", "black"), common=True)  # fmt: skip
def chess_piece(look: Look) -> Shape:
    """A chess piece shaped like a pawn, a bishop or a rook."""
    wood = look.surface(look.color("cream", "black", "brown", "white", "crimson", "tan"),
                        look.pick(["plastic", "wood"]))  # fmt: skip
    kind = int(look.rng.integers(3))
    r, h = 0.016, (0.042, 0.06, 0.048)[kind]
    neck = [(0, 0), (r, 0), (r, 0.006), (0.8 * r, 0.011), (0.42 * r, 0.5 * h), (0.62 * r, 0.62 * h)]
    if kind == 2:
        head = [(0.72 * r, 0.66 * h), (0.72 * r, h), (0, h)]
    else:
        angles = np.linspace(-0.9, np.pi / 2, 7)
        ball = np.column_stack([0.6 * r * np.cos(angles), 0.8 * h + 0.2 * h * np.sin(angles)])
        head = [tuple(p) for p in ball[:-1]] + [(0, h)]
    body = lathe([*neck, *head], 20)
    return shape([(body, wood)], [cylinder_part(r, 0.008), hull_of(body)])


@category("dominoes", size=(0.121, 0.0533, 0.0382), mass=0.08, material="plastic", assembled=True,
          aliases=("domino tiles", "row of dominoes", "domino set", "mahjong tiles",
          "stack of dominoes", "pile of dominoes", "line of dominoes", "box of dominoes"),
          themes=("games", "toys"), colors=("ivory", "black"), noun="set of dominoes")  # fmt: skip
def dominoes(look: Look) -> Shape:
    """A chain of dominoes lying on the table, or a row of standing dominoes."""
    x, y, h = 0.024, 0.048, 0.0085
    color = look.color("ivory", "white", "black", "ivory", "red", "wooden", "teal")
    ink: RGB = (34, 34, 38) if sum(color) > 380 else (246, 244, 238)
    skin = surfaces.speckles(look.rng, color, 4, 32)

    def face() -> surfaces.Tile:
        halves = []
        for n in look.rng.integers(1, 7, 2):
            half = prints.pips(int(n), color, ink)
            halves.append(surfaces.fit(half, 64, 64))
        image = np.concatenate(halves)
        prints.fill(image, 0.08, 0.492, 0.84, 0.016, ink)
        return image

    pieces, parts = [], []
    top = box(0.96 * x, 0.97 * y, 0.0004)
    if look.chance(0.5):
        at, turn = np.zeros(2), 0.0
        for n in range(int(look.rng.integers(4, 7))):
            one = block(x, y, h, 0.002, 0.001).turn(2, np.pi / 2 + turn).move(at[0], at[1])
            pieces += [(one, skin), (top.move(z=h - 0.0001).turn(2, np.pi / 2 + turn)
                                     .move(at[0], at[1]), face())]  # fmt: skip
            parts.append(hull_of(one))
            at = at + 1.02 * y * np.array([np.cos(turn), np.sin(turn)])
            if n == 2 and look.chance(0.6):
                at = at - 1.02 * y * np.array([np.cos(turn), np.sin(turn)]) + np.array(
                    [0.75 * y, 0.27 * y])  # fmt: skip
                turn = np.pi / 2
                at = at + np.array([0, -0.02 * y])
    else:
        count = int(look.rng.integers(4, 8))
        for n in range(count):
            u = (n - (count - 1) / 2) * 0.024
            one = block(x, y, h, 0.002, 0.001).turn(0, np.pi / 2).turn(2, -np.pi / 2)
            sign = top.move(z=h - 0.0001).turn(0, np.pi / 2).turn(2, -np.pi / 2)
            way = 0.004 * np.sin(1.2 * n)
            pieces += [(one.move(u, way, y / 2), skin), (sign.move(u, way, y / 2), face())]
            parts.append(hull_of(one.move(u, way, y / 2)))
    return shape(pieces, parts)


@category("marbles", size=(0.075, 0.07, 0.017), mass=0.04, material="glass", assembled=True,
          aliases=("glass marbles", "handful of marbles", "glass marble", "toy marbles",
          "toy marble", "glass beads", "bead string"), themes=("games", "toys"),
          colors=("blue", "green"))  # fmt: skip
def marbles(look: Look) -> Shape:
    """A handful of glass marbles close together."""
    color = look.color("blue", "green", "red", "amber", "violet", "cyan", "orange")
    pieces, parts = [], []
    for n in range(int(look.rng.integers(4, 8))):
        d = look.between(0.015, 0.018)
        away, turn = 0.0115 * np.sqrt(3 * n) if n else 0.0, 2.4 * n
        tone = (color if n == 0 else look.own_color("blue", "green", "red", "amber", "violet",
                                                    "white", "teal"))  # fmt: skip
        swirl = surfaces.marble(look.rng, tone, tint_color(tone, 1.7), 64)
        ball = press_flat(ellipsoid(d, d, d, 18, 12), 0.485 * d)
        at = (away * np.cos(turn), away * np.sin(turn))
        pieces.append((ball.move(*at), swirl))
        part = resting_ball(d, d, 0.98 * d)
        parts.append(type(part)(part.vertices + np.array([*at, 0])))
    return shape(pieces, parts)


@category("bingo_dauber", size=(0.0381, 0.0384, 0.11), mass=0.09, material="plastic",
          aliases=("dauber", "bingo marker", "bingo dabber"), themes=("games",),
          roles=("tall", "round"), colors=("red",))  # fmt: skip
def bingo_dauber(look: Look) -> Shape:
    """A wide bottle of bingo ink with a cap and a printed sleeve."""
    r, h = look.between(0.018, 0.021), look.between(0.1, 0.12)
    color = look.color("red", "blue", "green", "purple", "pink", "orange")
    body = lathe([(0, 0), (r, 0), (r, 0.66 * h), (0.8 * r, 0.72 * h), (0, 0.72 * h)], 26,
                 v=[0, 0.05, 0.8, 0.9, 1])  # fmt: skip
    image = prints.canvas(192, 96, color)
    prints.fill(image, 0, 0.3, 1, 0.46, (248, 246, 240))
    prints.write(image, "BINGO", 0.5, 0.52, 0.26, color, bold=True)
    for n in range(9):
        prints.disc(image, 0.02 + 0.12 * n, 0.17, 0.06, tint_color(color, 1.5))
    cap = lathe([(0, 0.7 * h), (0.84 * r, 0.7 * h), (0.78 * r, 0.96 * h), (0.6 * r, h), (0, h)], 22)
    return shape([(body, image), (cap, surfaces.plain(tint_color(color, 0.75)))],
                 [hull_of(body), hull_of(cap)])  # fmt: skip


CATEGORIES = (
    Category("chess_king", man(0.05, 0.34, _king), size=(0.0323, 0.0323, 0.0811), mass=0.05,
             material="wood", assembled=True, aliases=("king", "king chess piece"),
             themes=("games",), roles=("round",), colors=("cream", "black")),
    Category("chess_queen", man(0.046, 0.34, _queen), size=(0.0323, 0.0323, 0.0743), mass=0.045,
             material="wood", assembled=True, aliases=("queen", "queen chess piece"),
             themes=("games",), roles=("round",), colors=("cream", "black")),
    Category("chess_bishop", man(0.036, 0.32, _bishop), size=(0.0323, 0.0323, 0.0624), mass=0.035,
             material="wood", aliases=("bishop", "bishop chess piece"), themes=("games",),
             roles=("round",), colors=("cream", "black")),
    Category("chess_knight", man(0.02, 0.6, _knight), size=(0.0323, 0.0323, 0.0551), mass=0.035,
             material="wood", aliases=("knight", "knight chess piece"), themes=("games",),
             roles=("round",), colors=("cream", "black")),
    Category("chess_rook", man(0.028, 0.46, _rook), size=(0.0323, 0.0323, 0.044), mass=0.035,
             material="wood", aliases=("rook", "chess castle", "rook chess piece"),
             themes=("games",), roles=("round",), colors=("cream", "black")),
    Category("chess_pawn", man(0.024, 0.32, _pawn), size=(0.0323, 0.0323, 0.0397), mass=0.02,
             material="wood", aliases=("pawn", "pawn chess piece"), themes=("games",),
             roles=("round",), colors=("cream", "black")),
    Category("jenga_block",
             paint(lambda k: same(box(0.075 * k, 0.025 * k, 0.015 * k)), WOODEN, ("wood",)),
             size=(0.075, 0.025, 0.015), mass=0.018, material="wood",
             aliases=("jenga piece", "wooden bar", "plank block"), themes=("games",),
             roles=("flat",), colors=("wooden",)),
    Category("checkers_piece", _disc_piece(0.017, 0.008, ("red", "black", "white", "wooden")),
             size=(0.034, 0.034, 0.008), mass=0.006, material="plastic", aliases=("checker",
             "draughtsman", "checkers disc", "draughts piece", "backgammon piece", "game counter",
             "othello disc", "connect four disc", "reversi disc", "crokinole disc", "carrom disc"),
             themes=("games",), roles=("flat", "round"), colors=("red", "black")),
    Category("letter_tile", tile_piece(0.019, 0.019, 0.0045, _letter, ("cream", "wooden", "ivory")),
             size=(0.019, 0.019, 0.0045), mass=0.0025, material="wood", aliases=("scrabble tile",
             "scrabble letter", "alphabet tile", "scrabble piece", "number tile", "wooden letter",
             "house number"), themes=("games",), roles=("flat",), colors=("cream",)),
    Category("mahjong_tile", tile_piece(0.026, 0.036, 0.02, _mahjong, ("ivory", "white"), True),
             size=(0.026, 0.036, 0.02), mass=0.022, material="plastic",
             aliases=("mah jong tile", "mahjong piece"), themes=("games",), colors=("ivory",)),
    Category("domino", tile_piece(0.048, 0.024, 0.008, _domino, ("white", "black", "ivory")),
             size=(0.048, 0.024, 0.008), mass=0.012, material="plastic",
             aliases=("domino tile", "domino piece", "single domino", "pai gow tile", "dominoe"),
             themes=("games",), roles=("flat",), colors=("white", "black")),
)  # fmt: skip
"""Objects that share their drawing functions."""
