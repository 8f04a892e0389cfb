"""Tea, sake and ice by the piece: strainers, tea bags, sugar and ice cubes, sake cups."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, ring_parts
from ...build.forms import side_view
from ...build.outlines import smooth
from ...build.recipes import open_vessel
from ...build.settled import hull_above, limb, settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, ellipsoid, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look


def tea_strainer(look: Look) -> Shape:
    """A small strainer of fine mesh with a handle, lying, or a tea ball on its chain."""
    steel = look.surface(look.color("silver", "silver", "gold", "copper"), "metal")
    mesh = textures.grid((120, 124, 128), (206, 209, 213), 30, 44, 96)
    if look.chance(0.4):
        d = look.between(0.042, 0.05)
        ball = ellipsoid(d, d, d, 26, 16)
        seam = torus(0.5 * d, 0.0022, 30, 6)
        links = [
            torus(0.004, 0.0011, 10, 5)
            .turn(0, np.pi / 2 * (k % 2))
            .move(0.55 * d + 0.0062 * k, 0.3 * d * np.sin(0.35 * k), -0.42 * d + 0.0035)
            for k in range(12)
        ]
        return settle([(ball, mesh), (join([seam, *links]), steel)], 0.07, hulls=[[0], [1]])
    r, h = look.between(0.027, 0.033), look.between(0.022, 0.028)
    t = np.linspace(0.3, np.pi / 2, 5)
    outer = [(r * np.sin(a), h * (1 - np.cos(a))) for a in t]
    low = outer[0][1]
    outer = [(x, z - low) for x, z in outer]
    inner = [(x - 0.0014, max(z, 0.0016)) for x, z in outer]
    cup = lathe([(0, 0), *outer, *inner[::-1], (0, 0.0016)], 28)
    rim = torus(r, 0.0022, 30, 6).move(z=h - low)
    bar = limb([(r, 0, h - low), (r + 0.03, 0, h - low), (r + 0.085, 0, 0.002),
                (r + 0.09, 0, 0.002)], [0.003, 0.004, 0.0045, 0.002], 10, 0.5)  # fmt: skip
    walls = ring_parts([outer[0], outer[2], outer[4]], [inner[4], inner[0]], 12)
    return shape([(cup, mesh), (join([rim, bar]), steel)],
                 [*walls, cylinder_part(outer[0][0], 0.002), hull_above(bar)])  # fmt: skip


def tea_bag(look: Look) -> Shape:
    """A tea bag lying flat, its string and paper tag beside it."""
    x, y, h = look.between(0.048, 0.056), look.between(0.058, 0.066), look.between(0.008, 0.011)
    color = look.color("cream", "beige", "tan")
    bag = ellipsoid(x, y, h, 20, 10).bend(lambda p: np.column_stack([
        np.sign(p[:, 0]) * np.abs(p[:, 0] / (x / 2)) ** 0.4 * x / 2,
        np.sign(p[:, 1]) * np.abs(p[:, 1] / (y / 2)) ** 0.4 * y / 2, p[:, 2]]))  # fmt: skip
    leaf = textures.spots(look.rng, tint_color(color, 0.85), (120, 78, 40), 0.3)
    hem = box(x, 0.003, 0.0016).move(y=0.49 * y, z=-0.0008)
    string = tube(smooth([(0, 0.5 * y, 0), (0.3 * x, 0.7 * y, -0.3 * h),
                          (0.9 * x, 0.6 * y, -0.42 * h),
                          (1.0 * x, 0.2 * y, -0.42 * h)], 5), 0.0006, 5)  # fmt: skip
    tag = box(0.024, 0.026, 0.0012).move(1.0 * x, 0.02 * y, -0.44 * h)
    print_ = prints.canvas(64, 64, look.own_color("green", "red", "yellow", "orange", "purple"))
    prints.write(print_, "TEA", 0.5, 0.5, 0.34, (250, 250, 244), bold=True)
    return settle([(bag, leaf), (join([hem, string]), textures.plain((244, 240, 230))),
                   (tag, print_)], 0.06, hulls=[[0], [2]])  # fmt: skip


def sugar_cube(look: Look) -> Shape:
    """A cube of sugar, white or brown."""
    x = look.between(0.014, 0.017)
    color = look.color("white", "white", "tan", "brown")
    grain = textures.spots(look.rng, color, tint_color(color, 0.9), 0.3)
    z = x * look.between(0.75, 1.0)
    return shape([(block(x, x, z, 0.0014, 0.0008), grain)], [box_part(x, x, z)])


def ice_cube(look: Look) -> Shape:
    """A clear cube of ice, its middle milky."""
    x = look.between(0.021, 0.0255)
    color = look.color("clear", "sky", "clear", "white")
    tile = textures.gradient(tint_color(color, 1.05), tint_color(color, 1.5), look.rng, 10)
    body = block(x, x, 0.94 * x, 0.18 * x, 0.12 * x)
    core = ellipsoid(0.4 * x, 0.4 * x, 0.36 * x, 12, 8).move(z=0.47 * x)
    return shape([(body, tile), (core, textures.plain((250, 252, 253)))], [hull_of(body)],
                 opacity=0.72)  # fmt: skip


def ice_cube_tray(look: Look) -> Shape:
    """A tray of twelve or more pockets for ice, some with ice in them."""
    columns, rows = look.pick([6, 7, 8]), 2
    pitch, h = look.between(0.034, 0.038), look.between(0.028, 0.034)
    x, y = columns * pitch + 0.012, rows * pitch + 0.012
    color = look.color("sky", "white", "blue", "teal", "pink", "green", "orange")
    skin = look.surface(color, "plastic")
    at = [((i - (columns - 1) / 2) * pitch, (j - 0.5) * pitch) for i in range(columns)
          for j in range(rows)]  # fmt: skip
    bottom = block(x - 0.006, y - 0.006, 0.006, 0.008)
    walls = [box(x, 0.005, h - 0.005).move(y=(k / rows - 0.5) * (y - 0.006), z=0.005)
             for k in range(rows + 1)]  # fmt: skip
    walls += [box(0.005, y, h - 0.005).move(x=(k / columns - 0.5) * (x - 0.006), z=0.005)
              for k in range(columns + 1)]  # fmt: skip
    pieces = [(join([bottom, *walls]), skin)]
    parts = [box_part(x - 0.006, y - 0.006, 0.006)]
    parts += [box_part(x, 0.005, h - 0.005, (0, (k / rows - 0.5) * (y - 0.006), 0.005))
              for k in range(rows + 1)]  # fmt: skip
    parts += [box_part(0.005, y, h - 0.005, ((k / columns - 0.5) * (x - 0.006), 0, 0.005))
              for k in range(columns + 1)]  # fmt: skip
    if look.chance(0.6):
        cubes = [block(0.8 * pitch, 0.8 * pitch, h - 0.008, 0.006, 0.002).move(a, b, 0.005)
                 for a, b in at]  # fmt: skip
        pieces.append((join(cubes), textures.gradient((206, 226, 236), (246, 250, 252), look.rng)))
        parts.append(box_part(x - 0.02, y - 0.02, h - 0.008, (0, 0, 0.005)))
    return shape(pieces, parts)


def sake_bottle(look: Look) -> Shape:
    """A small china flask for sake with a narrow neck."""
    r, h = look.between(0.033, 0.039), look.between(0.13, 0.155)
    color = look.color("white", "navy", "black", "sage", "sky", "terracotta", "cream")
    side = smooth([(0.72 * r, 0), (0.95 * r, 0.16 * h), (r, 0.42 * h), (0.72 * r, 0.66 * h),
                   (0.36 * r, 0.8 * h), (0.42 * r, 0.92 * h), (0.62 * r, h)], 3)  # fmt: skip
    body = lathe([(0, 0), *side, (0.5 * r, h), (0.3 * r, 0.9 * h), (0, 0.88 * h)], 30)
    low = hull_of(body.bend(lambda p: np.minimum(p, [1, 1, 0.62 * h])))
    return shape([(body, glaze_tile(look, color))],
                 [low, cylinder_part(0.4 * r, 0.38 * h, (0, 0, 0.62 * h))])  # fmt: skip


def sake_cup(look: Look) -> Shape:
    """A tiny cup without an ear, for sake or green tea."""
    r, h = look.between(0.024, 0.03), look.between(0.034, 0.046)
    color = look.color("white", "navy", "black", "sage", "sky", "terracotta", "cream")
    plain = look.surface(color, "ceramic")
    body, parts = open_vessel([(0.62 * r, 0), (0.8 * r, 0.25 * h), (0.95 * r, 0.65 * h), (r, h)],
                              0.0026, 0.004)  # fmt: skip
    return shape([(body, textures.stack((glaze_tile(look, color), 50), (plain, 50), side=160))],
                 parts)  # fmt: skip


def chopstick_rest(look: Look) -> Shape:
    """A small curved china rest for chopsticks."""
    x, y, h = look.between(0.045, 0.058), look.between(0.015, 0.019), look.between(0.012, 0.016)
    color = look.color("white", "navy", "sage", "black", "sky", "red", "terracotta")
    u = np.linspace(-1, 1, 17)
    top = 0.5 * h + 0.5 * h * u**2
    line = np.concatenate([np.column_stack([u, 0 * u]), np.column_stack([u, top])[::-1]])
    body = side_view(line * [x / 2, 1], y)
    halves = [hull_of(side_view(np.array([(0, 0), (s, 0), (s, h), (0, 0.5 * h)])[:: int(s)] * [
        x / 2, 1], y)) for s in (1.0, -1.0)]  # fmt: skip
    return shape([(body, glaze_tile(look, color))], halves)


def tea_cosy(look: Look) -> Shape:
    """A quilted or knitted cosy for a teapot, a bobble on top."""
    x, h = look.between(0.2, 0.24), look.between(0.17, 0.2)
    color = look.color("red", "teal", "pink", "cream", "navy", "mustard", "sage")
    t = np.linspace(0, np.pi / 2, 8)
    arch = np.column_stack([0.5 * np.cos(t) ** 0.6, 0.05 + 0.95 * np.sin(t)])[:-1]
    body = lathe([(0, 0), (0.5, 0), *arch, (0, 1)], 36).scale(x, 0.6 * x, h)
    bobble = ellipsoid(0.04, 0.04, 0.036, 16, 10).move(z=h + 0.012)
    band = lathe([(0.49, 0.0), (0.515, 0.0), (0.515, 0.08), (0.49, 0.08)], 36, loop=True)
    knit = look.pick([textures.knitting(look.rng, color), textures.fabric(
        look.rng, color, look.own_color("white", "cream"))])  # fmt: skip
    other = textures.knitting(look.rng, look.own_color("white", "cream", "navy", "red"))
    return shape([(body, knit), (band.scale(x, 0.6 * x, h), other), (bobble, other)],
                 [hull_of(body), hull_of(bobble)])  # fmt: skip


CATEGORIES = (
    Category("tea_strainer", tea_strainer, (0.146, 0.0599, 0.0303), 0.03, ("tea infuser",
             "tea ball", "tea filter", "tea sieve", "loose leaf strainer"), ("tea",), (),
             ("silver",), state="lying flat"),
    Category("tea_bag", tea_bag, (0.0893, 0.0759, 0.00882), 0.003, ("teabag", "bag of tea",
             "tea sachet", "used tea bag"), ("tea",), ("flat",), ("cream",), state="lying flat"),
    Category("sugar_cube", sugar_cube, (0.0155, 0.0155, 0.0134), 0.004, ("cube of sugar",
             "lump of sugar", "sugar lump"), ("coffee", "tea"), ("edible",), ("white",)),
    Category("ice_cube", ice_cube, (0.0231, 0.0231, 0.0217), 0.011, ("ice", "cube of ice",
             "block of ice", "lump of ice"), ("dining",), (), ("clear",)),
    Category("ice_cube_tray", ice_cube_tray, (0.253, 0.0837, 0.0305), 0.12, ("ice tray",
             "ice cube mould", "ice cube mold"), ("kitchen",), (), ("sky", "white")),
    Category("sake_bottle", sake_bottle, (0.0724, 0.0728, 0.141), 0.25, ("tokkuri", "sake flask",
             "sake decanter", "sake"), ("dining",), ("tall", "round"), ("white", "navy")),
    Category("sake_cup", sake_cup, (0.0519, 0.0519, 0.0405), 0.06, ("ochoko", "sake glass",
             "yunomi", "green tea cup", "japanese tea cup", "finjan", "arabic coffee cup"),
             ("dining", "tea"), ("container", "round"), ("white", "navy")),
    Category("chopstick_rest", chopstick_rest, (0.0533, 0.0172, 0.0138), 0.02, ("chopsticks rest",
             "chopstick holder", "hashioki", "knife rest"), ("dining",), (), ("white",)),
    Category("tea_cosy", tea_cosy, (0.221, 0.132, 0.217), 0.1, ("tea cozy", "teapot cosy",
             "teapot cozy", "teapot cover"), ("tea",), ("big",), ("red", "teal")),
)  # fmt: skip
"""The module's categories."""
