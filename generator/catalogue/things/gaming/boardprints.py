"""Prints of game boards and mats."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

Print = Callable[[Look, RGB], textures.Tile]
BRIGHT: tuple[RGB, ...] = ((204, 52, 48), (52, 104, 190), (70, 150, 80), (244, 206, 62),
                           (238, 132, 38), (124, 70, 150), (120, 190, 220),
                           (230, 120, 170))  # fmt: skip


def properties(look: Look, color: RGB) -> textures.Tile:
    """Streets in colours round the rim."""
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


def track(look: Look, color: RGB) -> textures.Tile:
    """A spiral of coloured spaces."""
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


def rooms(look: Look, color: RGB) -> textures.Tile:
    """A house of named rooms."""
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


def world(look: Look, color: RGB) -> textures.Tile:
    """Continents of coloured countries."""
    image = prints.canvas(256, 176, tint_color(color, 1.35))
    shapes = [(0.19, 0.3, 0.16), (0.28, 0.68, 0.12), (0.5, 0.28, 0.1), (0.54, 0.6, 0.15),
              (0.72, 0.3, 0.2), (0.85, 0.76, 0.09)]  # fmt: skip
    for n, (x, y, r) in enumerate(shapes):
        for k in range(9):
            a = 2.4 * k
            at = (
                x + 0.5 * r * np.cos(a) * np.sqrt(k / 9),
                y + 0.75 * r * np.sin(a) * np.sqrt(k / 9),
            )
            prints.disc(image, *at, 0.55 * r, (50, 50, 54))
            prints.disc(image, *at, 0.55 * r - 0.008, tint_color(BRIGHT[n], 0.9 + 0.06 * (k % 4)))
    prints.fill(image, 0, 0, 1, 0.02, (60, 44, 36))
    prints.fill(image, 0, 0.98, 1, 0.02, (60, 44, 36))
    return image


def noughts(look: Look, color: RGB) -> textures.Tile:
    """Noughts and crosses."""
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


def mills(look: Look, color: RGB) -> textures.Tile:
    """Three squares with men on their corners."""
    ink = readable_on(color)
    image = textures.fit(textures.wood(look.rng, color), 176, 176).copy()
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
    """Rows of drilled holes, a few with pegs."""

    def draw(look: Look, color: RGB) -> textures.Tile:
        image = textures.fit(textures.wood(look.rng, color), tall, wide).copy()
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


def carrom(look: Look, color: RGB) -> textures.Tile:
    """Corner pockets and a heap of men."""
    image = textures.fit(textures.wood(look.rng, tint_color(color, 1.2)), 224, 224).copy()
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


def star(look: Look, color: RGB) -> textures.Tile:
    """A six-pointed star of holes."""
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


def roulette(look: Look, color: RGB) -> textures.Tile:
    """The bets of roulette."""
    image = prints.canvas(320, 144, color)
    line: RGB = (240, 226, 160)
    prints.fill(image, 0.03, 0.08, 0.07, 0.5, line)
    prints.fill(image, 0.035, 0.095, 0.06, 0.47, (40, 140, 70))
    for i in range(12):
        for j in range(3):
            x, y = 0.105 + 0.066 * i, 0.08 + 0.167 * j
            prints.fill(image, x, y, 0.064, 0.16, line)
            tone: RGB = (190, 34, 40) if (i + j) % 2 else (28, 28, 30)
            prints.fill(image, x + 0.003, y + 0.008, 0.058, 0.145, tone)
            cell = image[:, int(320 * x) : int(320 * (x + 0.064))]
            prints.write(cell, str(3 * i + 3 - j), 0.5, y + 0.08, 0.08, (250, 248, 240))
    for i in range(3):
        prints.fill(image, 0.105 + 0.264 * i, 0.6, 0.26, 0.14, line)
        prints.fill(image, 0.109 + 0.264 * i, 0.61, 0.252, 0.12, color)
    for i, tone in enumerate((color, color, (190, 34, 40), (28, 28, 30), color, color)):
        prints.fill(image, 0.105 + 0.132 * i, 0.76, 0.128, 0.16, line)
        prints.fill(image, 0.109 + 0.132 * i, 0.77, 0.12, 0.14, tone)
    return image


def blackjack(look: Look, color: RGB) -> textures.Tile:
    """Arcs and boxes of blackjack."""
    image = prints.canvas(288, 176, color)
    line: RGB = (246, 230, 150)
    for r in (0.98, 0.8):
        prints.disc(image, 0.5, -0.05, r, line, r - 0.012)
    prints.write(image, "BLACKJACK PAYS 3 TO 2", 0.5, 0.52, 0.09, line, bold=True)
    for k in range(5):
        a = np.pi * (0.22 + 0.14 * k)
        x, y = 0.5 + 0.52 * np.cos(a), -0.05 + 0.9 * np.sin(a)
        prints.fill(image, x - 0.04, y - 0.09, 0.08, 0.18, line)
        prints.fill(image, x - 0.036, y - 0.08, 0.072, 0.16, color)
    return image
