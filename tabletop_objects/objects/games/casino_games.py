"""Objects of the ``games`` theme: casino games."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import facing, limb, side_view
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...kit.surfaces import RGB, Look, readable_on, tint_color
from .board_games import board

CHIP = ("red", "blue", "green", "black", "white", "purple", "yellow")


def _chip_face(color: RGB, word: str) -> surfaces.Tile:
    image = prints.canvas(128, 128, color)
    for n in range(6):
        a = np.pi / 3 * n
        wedge = [(0.5 + r * np.cos(a + s), 0.5 + r * np.sin(a + s))
                 for r, s in ((0.34, -0.2), (0.56, -0.17), (0.56, 0.17), (0.34, 0.2))]  # fmt: skip
        prints.polygon(image, wedge, (248, 246, 240) if sum(color) < 640 else (60, 60, 70))
    prints.disc(image, 0.5, 0.5, 0.32, tint_color(color, 0.8), 0.3)
    prints.write(image, word, 0.5, 0.5, 0.2, readable_on(color), bold=True)
    return image


def _chip_edge(color: RGB) -> surfaces.Tile:
    other: RGB = (248, 246, 240) if sum(color) < 640 else (60, 60, 70)
    return surfaces.stripes([color, other, color], 6, upright=True, side=72)


@category("poker_chip", size=(0.0407, 0.0407, 0.00369), mass=0.011, material="plastic",
          aliases=("casino chip", "red chip", "blue chip", "black chip", "white chip", "green chip",
          "betting chip", "gaming chip", "gambling chip"), themes=("games",),
          roles=("flat", "round"), colors=("red", "blue"), state="lying flat")  # fmt: skip
def poker_chip(look: Look) -> Shape:
    """One casino chip with a dashed rim and its value."""
    r, t = look.between(0.0185, 0.022), look.between(0.003, 0.0042)
    color = look.color(*CHIP)
    word = look.pick(["5", "10", "25", "50", "100", "1"])
    disc, face = cylinder(r, t, 36), cylinder(0.995 * r, 0.0004, 36).move(z=t - 0.0002)
    return shape(
        [(disc, _chip_edge(color)), (face, _chip_face(color, word))], [cylinder_part(r, t + 0.0002)]
    )


@category("casino_plaque", size=(0.0882, 0.0581, 0.0045), mass=0.025, material="plastic",
          aliases=("gaming plaque",), themes=("games",), roles=("flat",), colors=("blue",),
          state="lying flat")  # fmt: skip
def casino_plaque(look: Look) -> Shape:
    """A rectangular casino plaque with its value in a frame."""
    k, color = (look.between(0.9, 1.15), look.color("blue", "crimson", "green", "purple", "black",
                                                    "gold"))  # fmt: skip
    body = block(0.085 * k, 0.056 * k, 0.0042, 0.006 * k, 0.0006)
    image = prints.canvas(176, 116, color)
    prints.fill(image, 0.06, 0.09, 0.88, 0.82, (226, 190, 96))
    prints.fill(image, 0.085, 0.13, 0.83, 0.74, tint_color(color, 0.8))
    prints.write(image, look.pick(["1000", "500", "5000", "$ 1000"]), 0.5, 0.5, 0.3,
                 (246, 226, 160), bold=True)  # fmt: skip
    face = box(0.079 * k, 0.05 * k, 0.0004).move(z=0.0041)
    return shape([(body, surfaces.marble(look.rng, color, tint_color(color, 1.3))), (face, image)],
                 [box_part(0.085 * k, 0.056 * k, 0.0044)])  # fmt: skip


@category("chip_case", size=(0.291, 0.275, 0.236), mass=2.5, material="metal", assembled=True,
          aliases=("poker chip case", "poker set", "poker case", "poker chip set",
          "casino chip case"), themes=("games",), roles=("big",), colors=("silver",))  # fmt: skip
def chip_case(look: Look) -> Shape:
    """An open metal case with its lid up, and with chips, cards and dice in its tray."""
    k, color = look.between(0.85, 1.05), look.color("silver", "black", "silver", "maroon")
    x, y, h = 0.3 * k, 0.2 * k, 0.05 * k
    base = block(x, y, h, 0.008, 0.002)
    lid = block(x, 0.03 * k, y, 0.008).turn(0, -0.18).move(y=y / 2 + 0.012 * k, z=h - 0.006)
    felt = box(0.93 * x, 0.9 * y, 0.001).move(z=h - 0.0004)
    inside = box(0.92 * x, 0.001, 0.9 * y).turn(0, -0.18).move(y=y / 2 - 0.004 * k, z=h + 0.008 * k)
    rows = []
    for n in range(5):
        hue = look.own_color(*CHIP[:5])
        edge = surfaces.stripes([hue, (248, 246, 240), hue, hue], 14, side=128)
        roll = cylinder(0.0175 * k, 0.145 * k, 20).turn(0, -np.pi / 2)
        rows.append((roll.move((n - 2.4) * 0.04 * k, -0.078 * k, h + 0.003 * k), edge))
    cards = box(0.034 * k, 0.055 * k, 0.012 * k).move(0.122 * k, -0.03 * k, h)
    dice = [box(0.012 * k, 0.012 * k, 0.012 * k).move(0.122 * k, y0 * k, h) for y0 in (0.03, 0.05)]
    latch = [box(0.02 * k, 0.004, 0.014 * k).move(s * 0.09 * k, -y / 2, 0.6 * h) for s in (-1, 1)]
    grip = tube([(-0.03 * k, -y / 2, 0.5 * h), (-0.03 * k, -y / 2 - 0.016, 0.5 * h),
                 (0.03 * k, -y / 2 - 0.016, 0.5 * h), (0.03 * k, -y / 2, 0.5 * h)], 0.004,
                 8)  # fmt: skip
    metal = look.surface(color, "aluminum")
    lining = surfaces.plain((34, 34, 38))
    return shape([(join([base, lid]), metal), (felt, lining), (inside, lining), *rows,
                  (cards, prints.canvas(32, 32, (196, 40, 44))), (join(dice),
                      surfaces.plain((246, 244, 238))),
                  (join([*latch, grip]), surfaces.plain((90, 92, 98)))],
                 [hull_of(base), hull_of(lid), hull_of(*[s for s, _ in rows])])  # fmt: skip


@category("roulette_wheel", size=(0.281, 0.281, 0.0724), mass=1.5, material="wood", assembled=True,
          aliases=("roulette", "roulette game", "mini roulette wheel"), themes=("games",),
          roles=("round", "big"), colors=("brown",))  # fmt: skip
def roulette_wheel(look: Look) -> Shape:
    """A roulette wheel: a wooden bowl, a ring of red and black pockets and a turret."""
    r, color = look.between(0.12, 0.16), look.color("brown", "maroon", "wooden", "black")
    h = 0.3 * r
    bowl = lathe([(0, 0), (0.7 * r, 0), (0.8 * r, 0.1 * h), (r, 0.8 * h), (r, h), (0.94 * r, h),
                  (0.74 * r, 0.66 * h), (0, 0.66 * h)], 40)  # fmt: skip
    image = prints.canvas(296, 64, (24, 24, 26))
    for n in range(37):
        hue: RGB = (34, 130, 70) if n == 0 else ((196, 34, 40) if n % 2 else (24, 24, 26))
        prints.fill(image, n / 37, 0, 1 / 37, 1, hue)
        prints.fill(image, n / 37, 0, 0.003, 1, (226, 200, 130))
        prints.fill(image, n / 37 + 0.009, 0.22, 0.009, 0.24, (246, 244, 236))
    ring = lathe([(0.5 * r, 0.66 * h), (0.74 * r, 0.66 * h), (0.74 * r, 0.72 * h),
                  (0.5 * r, 0.78 * h)], 37,
                 v=[0, 0.0, 0.02, 0.98], loop=True)  # fmt: skip
    cone = lathe([(0, 0.66 * h), (0.5 * r, 0.66 * h), (0.5 * r, 0.8 * h), (0.2 * r, 1.05 * h),
                  (0, 1.05 * h)], 32)  # fmt: skip
    spire = lathe([(0, h), (0.09 * r, h), (0.05 * r, 1.3 * h), (0.1 * r, 1.45 * h),
                   (0.03 * r, 1.7 * h),
                   (0, 1.72 * h)], 16)  # fmt: skip
    arms = [ellipsoid(0.3 * r, 0.05 * r, 0.05 * r, 10, 6).move(0.14 * r, 0, 1.35 * h).turn(2, a)
            for a in np.pi / 2 * np.arange(4)]  # fmt: skip
    ball = ellipsoid(0.07 * r, 0.07 * r, 0.07 * r, 12, 8).move(0.66 * r, 0.1 * r, 0.78 * h)
    wood = look.surface(color, "wood")
    return shape([(bowl, wood), (ring, image),
                  (cone, surfaces.wood(look.rng, tint_color(color, 1.2))),
                  (join([spire, *arms]), surfaces.brushed_metal(look.rng, (212, 172, 82))),
                  (ball, surfaces.plain((248, 248, 246)))], [hull_of(bowl),
                      hull_of(cone, spire)])  # fmt: skip


@category("prize_wheel", size=(0.245, 0.13, 0.303), mass=0.9, material="wood", assembled=True,
          aliases=("big six wheel", "wheel of fortune", "fortune wheel", "lucky wheel",
          "spinning prize wheel"), themes=("games",), roles=("tall",),
          colors=("wooden",))  # fmt: skip
def prize_wheel(look: Look) -> Shape:
    """An upright wheel of fortune on a stand, with coloured sectors and a pointer on top."""
    r, color = look.between(0.11, 0.14), look.color("wooden", "black", "white", "red")
    t, z = 0.012, r + 0.035
    wheel = facing(cylinder(r, t, 48)).move(y=t / 2, z=z)
    image, count = prints.canvas(224, 224, (240, 238, 233)), look.pick([10, 12, 16])
    hues: tuple[RGB, ...] = ((204, 52, 48), (244, 206, 62), (52, 104, 190), (70, 150, 80),
                             (238, 132, 38))  # fmt: skip
    for n in range(count):
        a = 2 * np.pi * np.linspace(n / count, (n + 1) / count, 6)
        prints.polygon(image, [(0.5, 0.5), *[(0.5 + 0.5 * np.cos(v),
                                              0.5 + 0.5 * np.sin(v)) for v in a]],
                       hues[n % 5 if n < count - 1 else 2])  # fmt: skip
        prints.disc(
            image, 0.5 + 0.36 * np.cos(a[3]), 0.5 + 0.36 * np.sin(a[3]), 0.04, (250, 248, 240)
        )
    prints.disc(image, 0.5, 0.5, 0.08, (50, 44, 40))
    face = facing(cylinder(0.97 * r, 0.0008, 48)).move(y=-t / 2, z=z)
    pegs = [facing(cylinder(0.0035, 0.012, 6)).move(0.93 * r * np.cos(a), -t / 2,
                                                    z + 0.93 * r * np.sin(a))
            for a in 2 * np.pi * np.arange(count) / count]  # fmt: skip
    post = box(0.03, 0.018, z + r + 0.012).move(y=0.017)
    foot = block(1.2 * r, 0.13, 0.014, 0.01)
    flap = side_view(np.array([(-0.01, 0.03), (0, 0), (0.01, 0.03)]), 0.006).move(
        y=-0.006, z=z + 0.94 * r
    )
    wood = look.surface(color, "wood")
    return shape([(join([wheel, post, foot]), wood), (face, image),
                  (join([*pegs, flap]), surfaces.plain((206, 172, 96)))],
                 [hull_of(foot), hull_of(post), hull_of(wheel)])  # fmt: skip


@category("slot_machine", size=(0.163, 0.121, 0.242), mass=1.2, material="metal", assembled=True,
          aliases=("toy slot machine", "one-armed bandit", "one armed bandit", "fruit machine",
          "slots"), themes=("games",), roles=("tall",), colors=("red",))  # fmt: skip
def slot_machine(look: Look) -> Shape:
    """A slot machine with three reels in a window, a tray and a lever with a red ball."""
    k, color = look.between(0.85, 1.1), look.color("red", "red", "gold", "blue", "purple", "silver")
    side = np.array([(-0.055, 0), (0.05, 0), (0.05, 0.19), (0.02, 0.215), (-0.03, 0.215),
                     (-0.036, 0.1),
                     (-0.055, 0.07)]) * k  # fmt: skip
    body = prism(side, -0.07 * k, 0.07 * k).turn(0, np.pi / 2).turn(2, np.pi / 2)
    image = prints.canvas(192, 96, (60, 40, 30))
    signs = ("7", "BAR", "o", "$", "7")
    for n in range(3):
        prints.fill(image, 0.04 + 0.32 * n, 0.08, 0.28, 0.84, (250, 248, 240))
        cell = image[:, int(192 * (0.04 + 0.32 * n)) : int(192 * (0.32 + 0.32 * n))]
        sign = look.pick(list(signs))
        if sign == "o":
            prints.disc(cell, 0.4, 0.6, 0.16, (200, 30, 44))
            prints.disc(cell, 0.66, 0.52, 0.15, (200, 30, 44))
        else:
            prints.write(cell, sign, 0.5, 0.5, 0.44, (200, 30, 44), bold=True)
    window = box(0.11 * k, 0.002, 0.055 * k).turn(0, -0.05).move(y=-0.035 * k, z=0.115 * k)
    top = prints.canvas(128, 48, (246, 206, 62))
    prints.write(
        top, look.pick(["JACKPOT", "LUCKY 7", "WIN"]), 0.5, 0.5, 0.42, (180, 30, 40), bold=True
    )
    crown = facing(prism(rectangle(0.1 * k, 0.04 * k, 0.018 * k), 0, 0.016 * k)).move(
        y=0.008 * k, z=0.235 * k
    )
    plate = box(0.084 * k, 0.001, 0.028 * k).move(y=-0.0085 * k, z=0.221 * k)
    tray = box(0.1 * k, 0.03 * k, 0.018 * k).move(y=-0.062 * k, z=0.012 * k)
    lever = limb([(0.068 * k, 0, 0.09 * k), (0.088 * k, -0.004, 0.1 * k),
                  (0.09 * k, -0.006, 0.17 * k)],
                 [0.006 * k, 0.004 * k, 0.004 * k], 8)  # fmt: skip
    knob = ellipsoid(0.024 * k, 0.024 * k, 0.024 * k, 14, 9).move(0.09 * k, -0.006, 0.178 * k)
    tile = look.surface(color, "plastic")
    chrome = surfaces.brushed_metal(look.rng, (206, 210, 214))
    return shape([(join([body, crown]), tile), (window, image), (plate, top),
                  (join([tray, lever]), chrome),
                  (knob, surfaces.plain((206, 40, 44)))],
                 [hull_of(body), hull_of(crown), hull_of(tray), hull_of(lever, knob)])  # fmt: skip


@category("croupier_rake", size=(0.438, 0.116, 0.022), mass=0.12, material="wood", assembled=True,
          aliases=("croupier's rake", "casino rake", "roulette rake"), themes=("games",),
          roles=("big",), colors=("wooden",), state="lying flat")  # fmt: skip
def croupier_rake(look: Look) -> Shape:
    """A croupier's rake lying flat: a long, thin stick with a flat wooden blade."""
    k, color = look.between(0.9, 1.05), look.color("wooden", "black", "brown")
    stick = tube([(-0.2 * k, 0, 0.005), (0.24 * k, 0, 0.005)], 0.005, 10)
    blade = box(0.014, 0.12 * k, 0.022).move(x=0.245 * k)
    wood = look.surface(color, "wood")
    return shape([(stick, wood), (blade, wood)], [hull_of(stick), hull_of(blade)])


@category("poker_chips", size=(0.0895, 0.0642, 0.0279), mass=0.2, material="plastic",
          assembled=True, aliases=("casino chips", "stack of poker chips", "gambling chips",
          "betting chips", "stacks of poker chips", "gaming chips"), themes=("games",),
          roles=("flat",), colors=("red", "blue"))  # fmt: skip
def poker_chips(look: Look) -> Shape:
    """Two to four stacks of poker chips in different colours."""
    r, t = look.between(0.0185, 0.0205), 0.0034
    color = look.color("red", "blue", "green", "black", "purple", "orange")
    others = [look.own_color("white", "red", "blue", "green", "black", "purple", "yellow")
              for _ in range(3)]  # fmt: skip
    edge_count = 6
    pieces, parts = [], []
    places = [(0.0, 0.0), (2.12 * r, 0.3 * r), (0.95 * r, -1.95 * r), (-1.15 * r, -1.8 * r)]
    for n in range(int(look.rng.integers(2, 5))):
        tone = color if n == 0 else others[n - 1]
        mark: RGB = (244, 242, 236) if sum(tone) < 560 else (40, 44, 60)
        side = surfaces.stripes([mark, tone, tone, tone], edge_count, upright=True, side=96)
        high = int(look.rng.integers(3, 11))
        stack = np.concatenate([np.concatenate([side,
                                                np.tile((np.array(tone) * 0.5).astype(np.uint8),
                                                        (10, 96, 1))])
                                for _ in range(high)])  # fmt: skip
        stack = surfaces.fit(stack, min(24 * high, 192), 96)
        face = prints.canvas(96, 96, tone)
        for k in range(edge_count):
            a = 2 * np.pi * k / edge_count
            way = [(0.5 + s * np.cos(a), 0.5 + s * np.sin(a)) for s in (0.36, 0.52)]
            prints.stroke(face, way, 0.1, mark)
        prints.disc(face, 0.5, 0.5, 0.33, mark, 0.3)
        prints.write(
            face, look.pick(["5", "10", "25", "50", "100"]), 0.5, 0.5, 0.26, mark, bold=True
        )
        x, y = places[n]
        turn = look.between(0, 1)
        chip = cylinder(r, t * high, 36).turn(2, turn).move(x, y)
        top = cylinder(0.985 * r, 0.0004, 32).turn(2, turn).move(x, y, t * high - 0.0001)
        pieces += [(chip, stack), (top, face)]
        parts.append(cylinder_part(r, t * high, (x, y, 0)))
    return shape(pieces, parts)


def roulette(look: Look, color: RGB) -> surfaces.Tile:
    """Return the betting layout of a roulette table."""
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


def blackjack(look: Look, color: RGB) -> surfaces.Tile:
    """Return the arcs and boxes of a blackjack table."""
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


CATEGORIES = (
    Category("roulette_layout", board(0.42, 0.19, roulette, ("green", "teal", "navy"), "felt"),
             size=(0.413, 0.187, 0.0033), mass=0.2, material="fabric",
             aliases=("roulette cloth", "roulette mat", "roulette felt", "roulette table layout"),
             themes=("games",), roles=("flat", "support", "big"), colors=("green",),
             state="lying flat"),
    Category("blackjack_felt", board(0.4, 0.25, blackjack, ("green", "crimson", "navy"), "felt"),
             size=(0.396, 0.248, 0.0033), mass=0.2, material="fabric", aliases=("blackjack mat",
             "casino felt", "poker mat", "blackjack layout", "gaming felt", "poker felt"),
             themes=("games",), roles=("flat", "support", "big"), colors=("green",),
             state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
