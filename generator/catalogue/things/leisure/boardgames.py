"""Boards and pieces of games: draughts, go, mahjong, letter tiles, jigsaws, darts."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part
from ...build.outlines import ellipse
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, prism
from ...build.variants import in_sizes
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

Print = Callable[[Look, RGB], textures.Tile]


def _board(side: float, draw: Print, palette: tuple[str, ...]) -> Callable[[Look], Shape]:
    """A flat square board with a print and a rim; its men are drawn by ``draw`` too."""

    def make(look: Look) -> Shape:
        k = look.between(0.94, 1.06) * side
        color = look.color(*palette)
        body = block(k, k, 0.012, 0.004, 0.001)
        face = box(0.96 * k, 0.96 * k, 0.0006).move(z=0.0118)
        wood = look.surface(tint_color(color, 0.8), "wood")
        return shape([(body, wood), (face, draw(look, color))], [box_part(k, k, 0.0122)])

    return make


def _squares(look: Look, color: RGB) -> textures.Tile:
    dark = tint_color(look.own_color("black", "brown", "red", "green"), 0.9)
    image = prints.canvas(192, 192, tint_color(color, 1.4))
    for i in range(8):
        for j in range(8):
            if (i + j) % 2:
                prints.fill(image, i / 8, j / 8, 1 / 8, 1 / 8, dark)
    return image


def checkers_set(look: Look) -> Shape:
    """A draughts board with its men set up."""
    made = _board(0.3, _squares, ("wooden", "tan", "beige", "red"))(look)
    side = 0.288
    pieces = [(p.solid, p.tile) for p in made.pieces]
    parts = list(made.parts)
    pale, deep = look.own_color("white", "cream", "tan"), look.own_color("red", "black", "brown")
    for rows, color in (((0, 1, 2), pale), ((5, 6, 7), deep)):
        tile = textures.plain(color)
        for j in rows:
            for i in range(8):
                if (i + j) % 2:
                    at = ((i - 3.5) * side / 8, (j - 3.5) * side / 8, 0.012)
                    pieces.append((cylinder(0.0135, 0.006, 14, bevel=0.001).move(*at), tile))
        y = (float(np.mean(rows)) - 3.5) * side / 8
        parts.append(box_part(side - 0.012, 0.1, 0.006, (0, y, 0.012)))
    return shape(pieces, parts)


def _go(look: Look, color: RGB) -> textures.Tile:
    ground = textures.fit(textures.wood(look.rng, color), 192, 192)
    lines = textures.grid((40, 32, 26), (255, 255, 255), 14, 14, 192)
    image = np.where(lines < 120, lines, ground).astype(np.uint8)
    spots = look.rng.permutation(13 * 13)[:34]
    for n, place in enumerate(spots):
        tone = (28, 28, 30) if n % 2 else (246, 246, 242)
        at = (place % 13 + 1) / 14, (place // 13 + 1) / 14
        prints.disc(image, *at, 0.035, tint_color(tone, 0.75))
        prints.disc(image, *at, 0.03, tone)
    return image


def _points(look: Look, color: RGB) -> textures.Tile:
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


def _ludo(look: Look, color: RGB) -> textures.Tile:
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


def _letters(look: Look, color: RGB) -> textures.Tile:
    image = textures.grid((250, 248, 240), tint_color(color, 1.3), 15, 15, 210)
    image = textures.fit(image, 210, 210).copy()
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


def _snakes(look: Look, color: RGB) -> textures.Tile:
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
    """A flat lidded box with a big picture and a title."""

    def make(look: Look) -> Shape:
        x, y, h = look.between(0.24, 0.29), look.between(0.2, 0.24), look.between(0.045, 0.06)
        color = look.color("blue", "red", "green", "orange", "purple", "teal", "yellow")
        cover = prints.landscape(look.rng, 192, 160) if puzzle else prints.artwork(
            look.rng, 192, 160)  # fmt: skip
        cover = textures.fit(cover, 160, 192).copy()
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
            [(box(0.985 * x, 0.985 * y, 0.4 * h), textures.plain((236, 232, 224))),
             (box(x, y, 0.8 * h).move(z=0.2 * h), sign),
             (box(x, y, 0.0006).move(z=h - 0.0003), cover)],
            [box_part(x, y, h)])  # fmt: skip

    return make


def dartboard(look: Look) -> Shape:
    """A dartboard lying flat, its coloured fields up."""
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
    return shape([(cylinder(r, h, 40, bevel=0.002), textures.plain((34, 34, 36))), (face, image)],
                 [cylinder_part(r, h)])  # fmt: skip


CATEGORIES = (
    Category("checkers_set", checkers_set, (0.3, 0.3, 0.018), 0.7, ("checkers", "checkerboard",
             "draughts", "checkers board", "draughts board", "checker board", "chequers"),
             ("games",), ("flat", "big"), ("wooden",)),
    Category("go_board", _board(0.3, _go, ("wooden", "tan", "amber")), (0.3, 0.3, 0.0124), 0.9,
             ("go game", "baduk board", "gomoku board"), ("games",), ("flat", "big"),
             ("wooden",)),
    Category("backgammon_board", _board(0.3, _points, ("wooden", "green", "maroon")),
             (0.3, 0.3, 0.0124), 0.9, ("backgammon", "backgammon set"), ("games",),
             ("flat", "big"), ("wooden",)),
    Category("ludo_board", _board(0.28, _ludo, ("cream", "sky", "white")), (0.28, 0.28, 0.0124),
             0.6, ("ludo", "ludo game", "parcheesi"), ("games",), ("flat", "big")),
    Category("scrabble_board", _board(0.3, _letters, ("sage", "beige", "teal")),
             (0.3, 0.3, 0.0124), 0.8, ("scrabble", "scrabble game", "word game"), ("games",),
             ("flat", "big")),
    Category("snakes_and_ladders", _board(0.28, _snakes, ("yellow", "sky", "mint")),
             (0.28, 0.28, 0.0124), 0.5, ("chutes and ladders", "snakes and ladders board"),
             ("games",), ("flat", "big")),
    Category("jigsaw_puzzle", _game_box(("PUZZLE", "1000 PIECES", "JIGSAW", "500 PIECES"), True),
             (0.265, 0.22, 0.0525), 0.7, ("jigsaw", "puzzle", "puzzle box", "jigsaw box",
             "jigsaw puzzle box", "box of puzzle pieces"), ("games",), ("flat", "support", "big")),
    Category("board_game", _game_box(("KINGDOMS", "QUEST", "TRADERS", "CASTLE", "EXPLORERS",
             "FAMILY GAME"), False), (0.265, 0.22, 0.0525), 1.1, ("game box", "boxed game",
                 "board game box", "family game", "boardgame", "party game", "battleship game",
                 "operation game", "mouse trap game", "buckaroo", "battleship",
                 "guess who", "guess who board", "hungry hippos", "model kit"), ("games",),
             ("flat", "support", "big")),
    Category("dartboard", in_sizes(dartboard, 0.15), (0.34, 0.34, 0.0254), 1.2, ("dart board",),
             ("games",),
             ("flat", "round", "big")),
)  # fmt: skip
"""The module's categories."""
