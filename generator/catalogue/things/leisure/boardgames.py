"""Boards and pieces of games: draughts, go, mahjong, letter tiles, jigsaws, darts."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, resting_ball
from ...build.hollow import open_vessel
from ...build.outlines import ellipse, smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, lathe, prism
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

Print = Callable[[Look, RGB], textures.Tile]

PIECES = ("red", "blue", "green", "yellow", "black", "white", "orange", "purple")


def _board(side: float, draw: Print, palette: tuple[str, ...]) -> Callable[[Look], Shape]:
    """A flat square board with a print and a rim; its men are drawn by ``draw`` too."""

    def made(look: Look) -> Shape:
        k = look.between(0.94, 1.06) * side
        color = look.color(*palette)
        body = block(k, k, 0.012, 0.004, 0.001)
        face = box(0.96 * k, 0.96 * k, 0.0006).move(z=0.0118)
        wood = look.surface(tint_color(color, 0.8), "wood")
        return shape([(body, wood), (face, draw(look, color))], [box_part(k, k, 0.0122)])

    return made


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
        y = (np.mean(rows) - 3.5) * side / 8
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


def _disc_piece(r: float, h: float, palette: tuple[str, ...]) -> Callable[[Look], Shape]:
    """A turned disc with a raised rim: a draughtsman or a counter."""

    def made(look: Look) -> Shape:
        k = look.between(0.9, 1.1)
        a, b = r * k, h * k
        body = lathe([(0, 0), (0.94 * a, 0), (a, 0.2 * b), (a, 0.8 * b), (0.94 * a, b),
                      (0.76 * a, b), (0.7 * a, 0.8 * b), (0.5 * a, 0.8 * b), (0.45 * a, 0.9 * b),
                      (0, 0.9 * b)], 28)  # fmt: skip
        tile = look.surface(look.color(*palette), look.pick(["plastic", "wood"]))
        return shape([(body, tile)], [cylinder_part(a, b)])

    return made


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

    def made(look: Look) -> Shape:
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

    return made


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


def _game_box(titles: tuple[str, ...], puzzle: bool) -> Callable[[Look], Shape]:
    """A flat lidded box with a big picture and a title."""

    def made(look: Look) -> Shape:
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

    return made


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
    Category("checkers_piece", _disc_piece(0.017, 0.008, ("red", "black", "white", "wooden")),
             (0.034, 0.034, 0.008), 0.006, ("checker", "draughtsman", "checkers disc",
             "draughts piece", "backgammon piece", "game counter"), ("games",),
             ("flat", "round"), ("red", "black")),
    Category("go_stone", go_stone, (0.0225, 0.0225, 0.0097), 0.006, ("go piece", "gomoku stone"),
             ("games",), ("round",), ("black", "white"), 0.6),
    Category("letter_tile", _tile_piece(0.019, 0.019, 0.0045, _letter, ("cream", "wooden",
             "ivory")), (0.019, 0.019, 0.0045), 0.0025, ("scrabble tile", "scrabble letter",
             "alphabet tile", "scrabble piece"), ("games",), ("flat",), ("cream",)),
    Category("mahjong_tile", _tile_piece(0.026, 0.036, 0.02, _mahjong, ("ivory", "white"), True),
             (0.026, 0.036, 0.02), 0.022, ("mah jong tile", "mahjong piece"), ("games",), (),
             ("ivory",)),
    Category("domino", _tile_piece(0.048, 0.024, 0.008, _domino, ("white", "black", "ivory")),
             (0.048, 0.024, 0.008), 0.012, ("domino tile", "domino piece", "single domino"),
             ("games",), ("flat",), ("white", "black")),
    Category("playing_card", _tile_piece(0.063, 0.088, 0.0012, _card_face, ("white", "cream")),
             (0.063, 0.088, 0.0012), 0.002, ("single card", "ace of spades", "ace",
             "loose card", "face card", "joker"), ("games",), ("flat",), ("white",), 0.55,
             "lying flat"),
    Category("puzzle_piece", puzzle_piece, (0.0296, 0.0473, 0.0035), 0.003, ("jigsaw piece",
             "jigsaw puzzle piece", "piece of a puzzle"), ("games",), ("flat",)),
    Category("jigsaw_puzzle", _game_box(("PUZZLE", "1000 PIECES", "JIGSAW", "500 PIECES"), True),
             (0.265, 0.22, 0.0525), 0.7, ("jigsaw", "puzzle", "puzzle box", "jigsaw box",
             "jigsaw puzzle box", "box of puzzle pieces"), ("games",), ("flat", "support", "big")),
    Category("board_game", _game_box(("KINGDOMS", "QUEST", "TRADERS", "CASTLE", "EXPLORERS",
             "FAMILY GAME"), False), (0.265, 0.22, 0.0525), 1.1, ("game box", "boxed game",
             "board game box", "family game", "boardgame", "party game"), ("games",),
             ("flat", "support", "big")),
    Category("meeple", meeple, (0.0178, 0.0105, 0.018), 0.002, ("game token", "token",
             "wooden meeple", "game figure", "game piece"), ("games",), (), ("red", "blue")),
    Category("game_pawn", game_pawn, (0.0158, 0.0158, 0.0278), 0.003, ("halma piece",
             "ludo piece", "ludo pawn", "board game pawn", "pawn token"), ("games",), ("round",),
             ("red", "yellow")),
    Category("dice_cup", dice_cup, (0.085, 0.085, 0.093), 0.09, ("dice shaker", "cup for dice"),
             ("games",), ("container", "round"), ("brown",)),
    Category("dartboard", dartboard, (0.34, 0.34, 0.0254), 1.2, ("dart board",), ("games",),
             ("flat", "round", "big")),
    Category("dart", dart, (0.15, 0.027, 0.027), 0.022, ("steel dart", "throwing dart"), ("games",),
             (), ("red",)),
)  # fmt: skip
"""The module's categories."""
