"""Bits of board games: tiles, racks, houses, towers, spinners, stands of discs, sticks."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.forms import facing, side_view
from ...build.outlines import ellipse
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, open_box, prism, tube
from ...build.variants import keep_still
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

HUES: tuple[RGB, ...] = ((204, 52, 48), (52, 104, 190), (70, 150, 80), (244, 206, 62),
                         (238, 132, 38), (124, 70, 150), (230, 120, 170))  # fmt: skip


def hex_tile(look: Look) -> Shape:
    """A six-sided tile of landscape: a field of one colour with trees, sheaves or hills."""
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
    return shape([(body, textures.plain((236, 222, 180))), (face, image)], [hull_of(body, face)])


def game_house(look: Look) -> Shape:
    """A tiny house with a pitched roof, or a longer hotel."""
    long = look.pick([0.013, 0.013, 0.02]) * look.between(0.9, 1.2)
    w, h = 0.012 * look.between(0.9, 1.1), 0.008
    color = look.color("green", "red", "blue", "yellow")
    side = [(-w / 2, 0), (w / 2, 0), (w / 2, h), (0.58 * w, h), (0, 1.75 * h), (-0.58 * w, h),
            (-w / 2, h)]  # fmt: skip
    body = side_view(np.array(side), long)
    return shape([(body, textures.speckles(look.rng, color, 3, 32))],
                 [box_part(w, long, h), hull_of(body.bend(_roof(h)))])  # fmt: skip


def _roof(h: float):
    return lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], h)])


def tile_rack(look: Look) -> Shape:
    """A wooden rack with a sloping face, letter tiles leaning on it."""
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


def dice_tower(look: Look) -> Shape:
    """A dice tower: a square shaft with a crenellated top and a walled tray before it."""
    k, color = look.between(0.9, 1.1), look.color("wooden", "brown", "black", "maroon", "gray")
    x, y, h = 0.075 * k, 0.07 * k, 0.16 * k
    back = 0.045 * k
    shaft = [s.move(y=back) for s in open_box(x, y, h, 0.005, 0.004)]
    teeth = [box(0.014 * k, 0.006, 0.014 * k).move(i * x / 2.6, back + j * y / 2.15, h)
             for i in (-1, 0, 1) for j in (-1, 1)]  # fmt: skip
    arch = [facing(prism(np.concatenate([[(-0.024 * k, 0), (0.024 * k, 0)], [
        (0.024 * k * np.cos(a), 0.03 * k + 0.02 * k * np.sin(a)) for a in np.linspace(0, np.pi,
            8)]]),
        0, 0.001)).move(y=back - y / 2, z=0.004)]  # fmt: skip
    tray = [
        s.move(y=back - y / 2 - 0.045 * k)
        for s in open_box(0.1 * k, 0.09 * k, 0.022 * k, 0.005, 0.004)
    ]
    felt = box(0.09 * k, 0.08 * k, 0.001).move(y=back - y / 2 - 0.045 * k, z=0.004)
    tile = look.surface(color, "wood")
    seams = [box(x + 0.002, y + 0.002, 0.0015).move(y=back, z=z * h) for z in (0.25, 0.5, 0.75)]
    return shape([(join([*shaft, *teeth, *tray]), tile),
                  (join(seams), textures.plain(tint_color(color, 0.6))),
                  (join(arch), textures.plain((24, 22, 22))),
                  (felt, textures.plain((150, 40, 44)))],
                 [hull_of(*shaft), *[hull_of(s) for s in tray]])  # fmt: skip


def game_spinner(look: Look) -> Shape:
    """A card with a wheel of colours and an arrow that turns on a pin."""
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
    dark = textures.plain((34, 34, 40))
    return shape([(body, textures.plain(tint_color(color, 0.8))), (face, image), (arrow, dark),
                  (pin, dark)],
                 [box_part(side, side, 0.0044), hull_of(pin, arrow)])  # fmt: skip


def connect_four(look: Look) -> Shape:
    """An upright grid of seven columns with red and yellow discs, on two feet."""
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
    paints: dict[str, RGB] = {
        "red": (206, 44, 44),
        "yellow": (246, 208, 60),
        "none": (236, 238, 240),
    }
    skin = textures.speckles(look.rng, color, 3, 32)
    return shape([(join([wall, *feet, *posts]), skin),
                  *((join(g), textures.plain(paints[kind])) for kind, g in discs.items() if g)],
                 [hull_of(wall), *[hull_of(s) for s in (*feet, *posts)]])  # fmt: skip


def shogi_piece(look: Look) -> Shape:
    """A shogi piece: a wooden wedge pointed like an arrow with ink signs."""
    k, color = look.between(0.9, 1.15), look.color("tan", "wooden", "beige", "amber")
    outline = (
        np.array([(-0.5, -0.55), (0.5, -0.55), (0.4, 0.32), (0, 0.6), (-0.4, 0.32)]) * 0.027 * k
    )
    body = prism(outline, 0, 0.009 * k)
    body = body.bend(lambda p: p * np.column_stack([
        np.ones((len(p), 2)), 0.75 - 0.4 * p[:, 1] / (0.027 * k)]))  # fmt: skip
    image = textures.fit(textures.wood(look.rng, color), 96, 80).copy()
    ink: RGB = (34, 30, 28)
    for y in (0.42, 0.62, 0.8):
        prints.stroke(image, [(0.32, y), (0.68, y - 0.03)], 0.035, ink)
    prints.stroke(image, [(0.5, 0.3), (0.47, 0.88)], 0.04, ink)
    prints.stroke(image, [(0.38, 0.7), (0.62, 0.86)], 0.03, ink)
    return shape([(body, image)], [hull_of(body)])


def tangram(look: Look) -> Shape:
    """A tangram: seven coloured pieces laid into a square."""
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


def tangram_piece(look: Look) -> Shape:
    """One flat piece of a tangram: a triangle, square or slanted square."""
    k, t = look.between(0.03, 0.045), look.between(0.004, 0.008)
    corners = look.pick([[(-1, -0.5), (1, -0.5), (0, 0.5)], [(-0.7, -0.7), (0.7, -0.7), (0.7, 0.7),
        (-0.7, 0.7)],
                         [(-1.2, -0.5), (0.4, -0.5), (1.2, 0.5), (-0.4, 0.5)],
                         [(-1.4, -0.7), (1.4, -0.7), (0, 0.7)]])  # fmt: skip
    color = look.color("red", "blue", "green", "yellow", "orange", "purple")
    solid = prism(np.array(corners) * k, 0, t, 0.0005)
    return shape([(solid, look.surface(color, "plastic"))], [hull_of(solid)])


def pick_up_stick(look: Look) -> Shape:
    """A thin pointed stick of the game, banded in colours, lying."""
    long, r = look.between(0.16, 0.19), look.between(0.0015, 0.002)
    color = look.color("red", "blue", "green", "yellow", "wooden")
    stick = lathe([(0, 0), (0.9 * r, 0.012), (r, 0.02), (r, long - 0.02), (0.9 * r, long - 0.012),
                   (0, long)], 8).turn(1, np.pi / 2).move(-long / 2, 0, r)  # fmt: skip
    bands = textures.stack((textures.plain((226, 196, 146)), 0.1), (textures.plain(color), 0.14),
                           (textures.plain((226, 196, 146)), 0.5), (textures.plain(color), 0.14),
                           (textures.plain((226, 196, 146)), 0.12))  # fmt: skip
    return shape([(stick, bands)], [hull_of(stick)])


def crazy_game(look: Look) -> Shape:
    """A game of skill: a see-through tube on a base, pierced by sticks, marbles on them."""
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
    tile = textures.speckles(look.rng, color, 3, 32)
    return shape([(join([base, cap]), tile), (wall, image), (join(sticks),
        textures.plain((236, 120, 40)))],
                 [hull_of(base), hull_of(wall, cap)])  # fmt: skip


_G, _F = ("games",), ("flat",)
CATEGORIES = (
    Category("hex_tile", hex_tile, (0.0829, 0.0718, 0.00362), 0.006, ("catan tile",
        "settlers tile",
             "terrain tile", "hexagon tile"), _G, _F, ("green",), state="lying flat"),
    Category("game_house", game_house, (0.0134, 0.0157, 0.014), 0.002, ("monopoly house",
        "monopoly hotel"), _G, (), ("green",)),
    Category("tile_rack", tile_rack, (0.2, 0.04, 0.028), 0.05, ("scrabble rack",
             "scrabble tile rack", "domino rack", "rummy rack"), _G, (), ("wooden",)),
    Category("dice_tower", dice_tower, (0.1, 0.161, 0.174), 0.4, ("tower for dice",), _G, ("tall",),
             ("wooden",)),
    Category("game_spinner", game_spinner, (0.125, 0.125, 0.0125), 0.03,
             ("spinner", "arrow spinner",
             "twister spinner", "board game spinner", "spinner wheel"), _G, _F, ("white",),
             state="lying flat"),
    Category("connect_four", connect_four, (0.25, 0.102, 0.244), 0.5, ("connect 4", "four in a row",
             "connect four game", "connect four grid", "four in a row game"), _G, ("tall",),
             ("blue",)),
    Category("shogi_piece", shogi_piece, (0.0269, 0.0309, 0.00868), 0.003,
             ("shogi tile", "japanese chess piece"),
             _G, _F, ("tan",), state="lying flat"),
    Category("tangram", tangram, (0.118, 0.118, 0.00684), 0.06, ("tangram puzzle", "tangram set"),
             _G, _F,
             ("red",), state="lying flat"),
    Category("tangram_piece", tangram_piece, (0.075, 0.0429, 0.00659), 0.008,
             ("tan piece", "tangram tile"), _G,
             _F, ("red",), state="lying flat"),
    Category("pick_up_stick", keep_still(pick_up_stick), (0.175, 0.0033, 0.0033), 0.001,
             ("pickup stick",
             "mikado stick", "pick-up stick", "spillikin"), _G, (), ("red",), state="lying flat"),
    Category("kerplunk", crazy_game, (0.158, 0.158, 0.294), 0.4, ("marble drop game",
        "kerplunk game"), _G,
             ("tall", "round"), ("yellow",)),
)  # fmt: skip
"""The module's categories."""
