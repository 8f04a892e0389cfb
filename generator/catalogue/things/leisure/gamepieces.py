"""Pieces of games: men, stones, tiles, cards, tokens, darts."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, resting_ball
from ...build.outlines import smooth
from ...build.recipes import open_vessel
from ...build.shape import Shape, shape
from ...build.solids import block, box, ellipsoid, lathe, prism
from ...build.variants import keep_still
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look
from .boardgames import Print

PIECES = ("red", "blue", "green", "yellow", "black", "white", "orange", "purple")


def _disc_piece(r: float, h: float, palette: tuple[str, ...]) -> Callable[[Look], Shape]:
    """A turned disc with a raised rim: a draughtsman or a counter."""

    def make(look: Look) -> Shape:
        k = look.between(0.9, 1.1)
        a, b = r * k, h * k
        body = lathe([(0, 0), (0.94 * a, 0), (a, 0.2 * b), (a, 0.8 * b), (0.94 * a, b),
                      (0.76 * a, b), (0.7 * a, 0.8 * b), (0.5 * a, 0.8 * b), (0.45 * a, 0.9 * b),
                      (0, 0.9 * b)], 28)  # fmt: skip
        tile = look.surface(look.color(*palette), look.pick(["plastic", "wood"]))
        return shape([(body, tile)], [cylinder_part(a, b)])

    return make


def go_stone(look: Look) -> Shape:
    """A lens-shaped go stone."""
    k = look.between(0.95, 1.1)
    stone = ellipsoid(0.022 * k, 0.022 * k, 0.0095 * k, 24, 12).move(z=0.00475 * k)
    tile = textures.speckles(look.rng, look.color("black", "white"), 4, 32)
    return shape([(stone, tile)], [resting_ball(0.022 * k, 0.022 * k, 0.0095 * k)])


def _tile_piece(
    x: float, y: float, h: float, draw: Print, palette: tuple[str, ...], back: bool = False
) -> Callable[[Look], Shape]:
    """A tile lying face up, ``draw`` on its face; with ``back``, a coloured underside."""

    def make(look: Look) -> Shape:
        k = look.between(0.95, 1.08)
        color = look.color(*palette)
        a, b, c = x * k, y * k, h * k
        body = block(a, b, c, 0.1 * min(a, b), 0.08 * c)
        face = box(0.86 * a, 0.86 * b, 0.0004).move(z=c - 0.0003)
        pieces = [(body, look.surface(color, "plastic")), (face, draw(look, color))]
        if back:
            under = block(1.002 * a, 1.002 * b, 0.4 * c, 0.1 * min(a, b))
            pieces.append((under, textures.plain(look.own_color("green", "blue", "orange"))))
        return shape(pieces, [box_part(a, b, c)])

    return make


def _letter(look: Look, color: RGB) -> textures.Tile:
    image = prints.canvas(64, 64, color)
    letter = look.pick(list("ABCDEHLMNORSTUWZ"))
    prints.write(image, letter, 0.46, 0.46, 0.5, readable_on(color), bold=True)
    prints.write(image, str(int(look.rng.integers(1, 9))), 0.82, 0.84, 0.2, readable_on(color))
    return image


def _mahjong(look: Look, color: RGB) -> textures.Tile:
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


def _domino(look: Look, color: RGB) -> textures.Tile:
    ink = readable_on(color)
    halves = [prints.pips(int(n), color, ink) for n in look.rng.integers(1, 7, 2)]
    image = np.concatenate(halves, axis=1).copy()
    prints.fill(image, 0.49, 0.08, 0.02, 0.84, ink)
    return image


def _card_face(look: Look, color: RGB) -> textures.Tile:
    ink: RGB = (190, 30, 40) if look.chance(0.5) else (28, 28, 32)
    image = prints.canvas(96, 136, (250, 249, 244))
    rank = look.pick(["A", "K", "Q", "J", "7", "10", "2", "9"])
    prints.write(image, rank, 0.15, 0.11, 0.13, ink, bold=True)
    image = image[::-1, ::-1].copy()
    prints.write(image, rank, 0.15, 0.11, 0.13, ink, bold=True)
    mark = [(0.5, 0.3), (0.68, 0.5), (0.5, 0.7), (0.32, 0.5)]
    prints.polygon(image, mark, ink)
    return image


def puzzle_piece(look: Look) -> Shape:
    """One piece of a jigsaw: a square with knobs and hollows."""
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
    skin = textures.speckles(look.rng, color, 10, 48)
    knobs = [box(0.013 * k, 0.005 * k, h).move(y=0.0205 * k).turn(2, a) for a in (0, np.pi)]
    return shape(
        [(body, skin)], [box_part(0.02 * k, 0.03 * k, h), box_part(0.03 * k, 0.012 * k, h),
                         *[hull_of(s) for s in knobs]])  # fmt: skip


def meeple(look: Look) -> Shape:
    """A little wooden man of a board game, standing."""
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


def game_pawn(look: Look) -> Shape:
    """A halma man: a cone with a ball for its head."""
    k = look.between(0.9, 1.2)
    a = np.linspace(-1.1, np.pi / 2, 8)
    head = np.column_stack([0.005 * np.cos(a), 0.0215 + 0.005 * np.sin(a)])
    head[-1, 0] = 0
    profile = [(0, 0), (0.0075, 0), (0.0075, 0.002), (0.0055, 0.006), *map(tuple, head)]
    body = lathe(np.array(profile) * k, 22)
    tile = look.surface(look.color(*PIECES), look.pick(["wood", "plastic"]))
    return shape([(body, tile)], [cylinder_part(0.0074 * k, 0.0025 * k), hull_of(body)])


def dice_cup(look: Look) -> Shape:
    """An open leather cup for shaking dice."""
    k = look.between(0.94, 1.08)
    side = [(0.034 * k, 0), (0.04 * k, 0.088 * k), (0.042 * k, 0.092 * k)]
    body, parts = open_vessel(side, 0.003, 0.005)
    color = look.color("brown", "black", "maroon", "tan", "green")
    skin = textures.spots(look.rng, color, tint_color(color, 0.75), 0.1)
    seam = textures.plain(tint_color(color, 0.6))
    return shape([(body, textures.stack((seam, 0.06), (skin, 0.4), (seam, 0.08), (skin, 0.46)))],
                 parts)  # fmt: skip


def dart(look: Look) -> Shape:
    """A dart lying: point, metal barrel, shaft, four flights."""
    k = look.between(0.94, 1.08)
    z = 0.0135 * k
    rod = lathe(
        np.array(
            [
                (0, 0),
                (0.0005, 0),
                (0.0012, 0.03),
                (0.0032, 0.034),
                (0.0036, 0.055),
                (0.0032, 0.08),
                (0.0018, 0.083),
                (0.0016, 0.15),
                (0, 0.15),
            ]
        )
        * k,
        14,
    )
    rod = rod.turn(1, np.pi / 2).move(x=-0.075 * k, z=z)
    flight = prism(np.array([(0.035, 0.001), (0.075, 0.001), (0.07, 0.018), (0.05, 0.018)]) * k,
                   -0.0004, 0.0004)  # fmt: skip
    color = look.color("red", "blue", "green", "yellow", "black", "orange")
    skin = textures.stripes([color, color, tint_color(color, 1.5)], 2)
    wings = [flight.turn(0, a + np.pi / 4).move(z=z) for a in np.arange(4) * np.pi / 2]
    lean = np.arctan2(0.0105 * k, 0.11 * k) * 0.9
    tilted = [s.move(x=-0.06 * k, z=-z).turn(1, lean).move(x=0.06 * k, z=z) for s in (rod, *wings)]
    low = min(float(s.bounds[0, 2]) for s in tilted)
    rod, *wings = (s.move(z=-low) for s in tilted)
    return shape([(rod, textures.brushed_metal(look.rng, (186, 180, 164))),
                  *[(w, skin) for w in wings]], [hull_of(rod), hull_of(*wings)])  # fmt: skip


CATEGORIES = (
    Category("checkers_piece", _disc_piece(0.017, 0.008, ("red", "black", "white", "wooden")),
             (0.034, 0.034, 0.008), 0.006, ("checker", "draughtsman", "checkers disc",
                 "draughts piece", "backgammon piece", "game counter", "othello disc",
                 "connect four disc", "reversi disc", "crokinole disc", "carrom disc"), ("games",),
             ("flat", "round"), ("red", "black")),
    Category("go_stone", go_stone, (0.0225, 0.0225, 0.0097), 0.006, ("go piece", "gomoku stone"),
             ("games",), ("round",), ("black", "white"), 0.6),
    Category("letter_tile", _tile_piece(0.019, 0.019, 0.0045, _letter, ("cream", "wooden",
             "ivory")), (0.019, 0.019, 0.0045), 0.0025, ("scrabble tile", "scrabble letter",
             "alphabet tile", "scrabble piece", "number tile", "wooden letter", "house number"),
             ("games",), ("flat",), ("cream",)),
    Category("mahjong_tile", _tile_piece(0.026, 0.036, 0.02, _mahjong, ("ivory", "white"), True),
             (0.026, 0.036, 0.02), 0.022, ("mah jong tile", "mahjong piece"), ("games",), (),
             ("ivory",)),
    Category("domino", _tile_piece(0.048, 0.024, 0.008, _domino, ("white", "black", "ivory")),
             (0.048, 0.024, 0.008), 0.012, ("domino tile", "domino piece", "single domino",
                 "pai gow tile", "dominoe"),
             ("games",), ("flat",), ("white", "black")),
    Category("playing_card", _tile_piece(0.063, 0.088, 0.0012, _card_face, ("white", "cream")),
             (0.063, 0.088, 0.0012), 0.002, ("single card", "ace of spades", "ace",
                 "loose card", "face card", "joker", "ace of hearts", "two of hearts",
             "three of hearts", "four of hearts", "five of hearts", "six of hearts",
             "seven of hearts", "eight of hearts", "nine of hearts", "ten of hearts",
             "jack of hearts", "queen of hearts", "king of hearts", "two of spades",
             "three of spades", "four of spades", "five of spades", "six of spades",
             "seven of spades", "eight of spades", "nine of spades", "ten of spades",
             "jack of spades", "queen of spades", "king of spades", "ace of diamonds",
             "two of diamonds", "three of diamonds", "four of diamonds", "five of diamonds",
             "six of diamonds", "seven of diamonds", "eight of diamonds", "nine of diamonds",
             "ten of diamonds", "jack of diamonds", "queen of diamonds", "king of diamonds",
             "ace of clubs", "two of clubs", "three of clubs", "four of clubs", "five of clubs",
             "six of clubs", "seven of clubs", "eight of clubs", "nine of clubs",
             "ten of clubs", "jack of clubs", "queen of clubs", "king of clubs", "joker card",
             "uno card", "cut card", "red card", "yellow card", "optical illusion card",
             "report card"),
             ("games",), ("flat",), ("white",), 0.55,
             "lying flat"),
    Category("puzzle_piece", puzzle_piece, (0.0296, 0.0473, 0.0035), 0.003, ("jigsaw piece",
             "jigsaw puzzle piece", "piece of a puzzle", "push fit piece"), ("games",), ("flat",)),
    Category("meeple", meeple, (0.0178, 0.0105, 0.018), 0.002, ("game token", "token",
             "wooden meeple", "game figure", "game piece"), ("games",), (), ("red", "blue")),
    Category("game_pawn", game_pawn, (0.0158, 0.0158, 0.0278), 0.003, ("halma piece",
             "ludo piece", "ludo pawn", "board game pawn", "pawn token"), ("games",), ("round",),
             ("red", "yellow")),
    Category("dice_cup", dice_cup, (0.085, 0.085, 0.093), 0.09, ("dice shaker", "cup for dice"),
             ("games",), ("container", "round"), ("brown",)),
    Category("dart", keep_still(dart), (0.15, 0.027, 0.027), 0.022, ("steel dart",
             "throwing dart"), ("games",),
             (), ("red",)),
)  # fmt: skip
"""The module's categories."""
