"""Boards and mats of games, flat prints on wood, card or felt."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.outlines import ellipse
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .boardprints import (
    BRIGHT,
    Print,
    blackjack,
    carrom,
    holes,
    mills,
    noughts,
    properties,
    rooms,
    roulette,
    star,
    track,
    world,
)


def board(x: float, y: float, draw: Print, palette: tuple[str, ...], kind: str = "card"):
    """Return the shape function of a board of this size with a print."""

    def make(look: Look) -> Shape:
        k = look.between(0.92, 1.08)
        color = look.color(*palette)
        a, b, t = x * k, y * k, {"card": 0.005, "wood": 0.014, "felt": 0.003}[kind]
        body = block(a, b, t, 0.004, 0.15 * t)
        edge = look.surface(tint_color(color, 0.7), "wood" if kind == "wood" else "plastic")
        face = box(0.97 * a, 0.97 * b, 0.0006).move(z=t - 0.0003)
        return shape([(body, edge), (face, draw(look, color))], [box_part(a, b, t)])

    return make


def mancala(look: Look) -> Shape:
    """A mancala board: two rows of six pits and a store at each end, stones in them."""
    k = look.between(0.92, 1.08)
    x, y, h = 0.4 * k, 0.12 * k, 0.026 * k
    color = look.color("wooden", "tan", "brown", "maroon")
    body = block(x, y, h, 0.03 * k, 0.002)
    tile = look.surface(color, "wood")
    dark = textures.speckles(look.rng, tint_color(color, 0.62), 6)
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
                  (join(stones[:half]), textures.plain(BRIGHT[tones[0]])),
                  (join(stones[half:]), textures.plain(BRIGHT[tones[1]]))],
                  [box_part(x, y, h)])  # fmt: skip


def marble_solitaire(look: Look) -> Shape:
    """A round solitaire board with its cross of marbles."""
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
                  *((join(g), textures.spots(look.rng, BRIGHT[t], tint_color(BRIGHT[t], 1.5), 0.2))
                    for g, t in zip(groups, tones[:3], strict=True))],
                 [cylinder_part(0.92 * r, 0.4 * h), hull_of(body)])  # fmt: skip


_G = ("games",)
_F = ("flat", "support")


def _row(key: str, make, mass: float, size, big: bool, color: str, *aliases: str) -> Category:
    roles = (*_F, "big") if big else _F
    return Category(key, make, size, mass, aliases, _G, roles, (color,), state="lying flat")


CATEGORIES = (
    _row("monopoly_board", board(0.34, 0.34, properties, ("mint", "cream", "sage", "sky")), 0.5,
         (0.335, 0.335, 0.0053), True, "mint", "monopoly", "monopoly game board",
         "property game board"),
    _row("game_board", board(0.32, 0.32, track, ("sky", "yellow", "mint", "pink", "lavender")),
         0.4, (0.322, 0.322, 0.0053), True, "sky", "pictionary board", "trivial pursuit board",
         "board game mat",
         "track board", "candy land board"),
    _row("cluedo_board", board(0.34, 0.34, rooms, ("terracotta", "teal", "olive")), 0.5,
         (0.342, 0.342, 0.0053),
         True, "terracotta", "clue board", "cluedo", "mansion board"),
    _row("risk_board", board(0.4, 0.27, world, ("sky", "teal", "navy")), 0.5,
         (0.407, 0.275, 0.0053), True,
         "sky", "world domination board", "war game board", "risk game board"),
    _row("tic_tac_toe_board", board(0.16, 0.16, noughts, ("wooden", "white", "tan", "sky"),
         "wood"), 0.2, (0.161, 0.161, 0.0143), False, "wooden", "tic tac toe", "tic-tac-toe",
         "noughts and crosses", "noughts and crosses board", "tic tac toe game"),
    _row("mill_board", board(0.25, 0.25, mills, ("wooden", "tan", "beige"), "wood"), 0.5,
         (0.241, 0.241, 0.0143), True, "wooden", "nine men's morris board",
         "nine mens morris board",
         "nine men's morris", "morris board", "mill game"),
    _row("cribbage_board", board(0.3, 0.08, holes(5, 31, 320, 96), ("wooden", "maroon", "tan"),
         "wood"), 0.25, (0.305, 0.0814, 0.0143), False, "wooden", "crib board", "cribbage"),
    _row("mastermind_board", board(0.2, 0.1, holes(4, 10, 256, 128), ("brown", "gray", "white"),
         "wood"), 0.3, (0.2, 0.0998, 0.0143), False, "brown", "mastermind game",
         "code breaker board"),
    _row("carrom_board", board(0.38, 0.38, carrom, ("wooden", "tan", "maroon"), "wood"), 1.2,
         (0.37, 0.37, 0.0143), True, "wooden", "crokinole board", "carrom"),
    _row("chinese_checkers_board", board(0.28, 0.28, star, ("cream", "wooden", "sky"), "wood"),
         0.6, (0.274, 0.274, 0.0143), True, "cream", "chinese checkers", "chinese chequers",
         "star halma board",
         "chinese chequers board"),
    _row("roulette_layout", board(0.42, 0.19, roulette, ("green", "teal", "navy"), "felt"), 0.2,
         (0.413, 0.187, 0.0033), True, "green", "roulette cloth", "roulette mat", "roulette felt",
         "roulette table layout"),
    _row("blackjack_felt", board(0.4, 0.25, blackjack, ("green", "crimson", "navy"), "felt"), 0.2,
         (0.396, 0.248, 0.0033), True, "green", "blackjack mat", "casino felt", "poker mat",
         "blackjack layout",
         "gaming felt", "poker felt"),
    _row("mancala_board", mancala, 0.7, (0.396, 0.119, 0.0317), True, "wooden", "mancala",
         "mancala game",
         "oware board"),
    _row("marble_solitaire", marble_solitaire, 0.5, (0.212, 0.212, 0.0304), False, "wooden",
         "solitaire board",
         "peg solitaire", "marble board", "solitaire game"),
)  # fmt: skip
"""The module's categories."""
