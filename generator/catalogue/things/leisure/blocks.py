"""Building blocks of plain geometry: cubes, cylinders, arches, pegs, towers."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, resting_ball, ring_parts
from ...build.forms import side_view
from ...build.outlines import arc, ellipse
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

PAINTS = ("red", "blue", "green", "yellow", "orange", "purple", "wooden", "teal", "pink")
WOODEN = ("wooden", "tan", "beige", "wooden", "brown")

Made = tuple[list[Solid], list[Solid]]
"""What is drawn, and the solids whose hulls it collides with."""


def _paint(
    make: Callable[[float], Made],
    palette: tuple[str, ...] = PAINTS,
    default: tuple[str, ...] = ("plastic", "wood"),
) -> Callable[[Look], Shape]:
    """Return a block's shape function from ``make``, which takes a scale."""

    def make_block(look: Look) -> Shape:
        k = look.between(0.9, 1.12)
        drawn, hulls = make(k)
        tile = look.surface(look.color(*palette), look.pick(default))
        return shape([(s, tile) for s in drawn], [hull_of(s) for s in hulls])

    return make_block


def _same(*solids: Solid) -> Made:
    return list(solids), list(solids)


def _polygon(sides: int, radius: float, height: float, start: float = 0.0) -> Made:
    outline = ellipse(2 * radius, 2 * radius, sides, start)
    return _same(prism(outline, 0, height, 0.001))


def _slope(k: float) -> Made:
    return _same(side_view(np.array([(-0.03, 0), (0.03, 0), (-0.03, 0.04)]) * k, 0.04 * k))


def _roof(k: float) -> Made:
    return _same(side_view(np.array([(-0.025, 0), (0.025, 0), (0, 0.0433)]) * k, 0.06 * k))


def _pyramid(k: float) -> Made:
    return _same(cylinder(0.04 * k, 0.05 * k, 4, top=0.0004).turn(2, np.pi / 4))


def _cone(k: float) -> Made:
    return _same(cylinder(0.026 * k, 0.06 * k, 32, top=0.0006))


def _half_round(k: float) -> Made:
    curve = arc((0, 0), 0.03, 0, np.pi, 14)
    return _same(side_view(curve * k, 0.04 * k))


def _arch(k: float) -> Made:
    curve = arc((0, 0), 0.022, np.pi, 0, 12)
    outline = np.concatenate([[(-0.04, 0)], curve, [(0.04, 0), (0.04, 0.04), (-0.04, 0.04)]])
    outline = outline[[*range(1, len(outline)), 0]] * k
    legs = [box(0.018 * k, 0.03 * k, 0.04 * k).move(x=s * 0.031 * k) for s in (-1, 1)]
    top = box(0.08 * k, 0.03 * k, 0.018 * k).move(z=0.022 * k)
    return [side_view(outline, 0.03 * k)], [*legs, top]


def _cells(*cells: tuple[int, int]) -> Callable[[float], Made]:
    """A flat block of square cells (x, y)."""

    def make_hulls(k: float) -> Made:
        s = 0.025 * k
        x0, y0 = np.mean(cells, axis=0)
        return _same(*[box(s, s, s).move((x - x0) * s, (y - y0) * s) for x, y in cells])

    return make_hulls


def _star(k: float) -> Made:
    a = np.pi / 2 + np.arange(10) * np.pi / 5
    r = np.where(np.arange(10) % 2, 0.015, 0.034) * k
    points = np.column_stack([r * np.cos(a), r * np.sin(a)])
    rays = [prism(points[[n - 1, n, (n + 1) % 10]], 0, 0.02 * k) for n in range(0, 10, 2)]
    return [prism(points, 0, 0.02 * k)], [*rays, prism(points[1::2], 0, 0.02 * k)]


def _heart(k: float) -> Made:
    t = np.linspace(0, 2 * np.pi, 32, endpoint=False)
    outline = np.column_stack([16 * np.sin(t) ** 3, 13 * np.cos(t) - 5 * np.cos(2 * t)
                               - 2 * np.cos(3 * t) - np.cos(4 * t)])[::-1] * 0.0018 * k  # fmt: skip
    sides = [outline[outline[:, 0] * s >= -1e-9] for s in (-1, 1)]
    halves = []
    for side in sides:
        middle = side.mean(0)
        turn = np.argsort(np.arctan2(*(side - middle).T[::-1]))
        halves.append(prism(side[turn], 0, 0.02 * k))
    return [prism(outline, 0, 0.02 * k)], halves


def _ring(outer: float, inner: float, height: float) -> Callable[[Look], Shape]:
    """A ring or a length of tube with a round section."""

    def make_shape(look: Look) -> Shape:
        k = look.between(0.9, 1.12)
        a, b, h = outer * k, inner * k, height * k
        c = min(0.3 * h, 0.3 * (a - b))
        profile = [(b, c), (b + c, 0), (a - c, 0), (a, c), (a, h - c), (a - c, h), (b + c, h),
                   (b, h - c)]  # fmt: skip
        tile = look.surface(look.color(*PAINTS), look.pick(["plastic", "wood"]))
        return shape(
            [(lathe(profile, 36, loop=True), tile)],
            ring_parts([(a - c, 0), (a, c), (a, h - c), (a - c, h)], [(b, h), (b, 0)], 10),
        )

    return make_shape


def sphere(look: Look) -> Shape:
    """A smooth ball of one colour."""
    d = look.between(0.045, 0.055)
    tile = look.surface(look.color(*PAINTS), look.pick(["plastic", "wood"]))
    return shape([(ellipsoid(d, d, d, 32, 20).move(z=d / 2), tile)], [resting_ball(d, d, d)])


def foam_brick(look: Look) -> Shape:
    """A brick of soft foam."""
    k = look.between(0.94, 1.06)
    color = look.color("red", "orange", "terracotta", "blue", "yellow")
    foam = textures.spots(look.rng, color, tint_color(color, 0.7), 0.12)
    body = block(0.078 * k, 0.052 * k, 0.05 * k, 0.004, 0.002)
    return shape([(body, foam)], [hull_of(body)])


def pegboard(look: Look) -> Shape:
    """A board with a grid of holes, a few coloured pegs in them."""
    side, n = look.between(0.15, 0.18), 6
    color = look.color("wooden", "beige", "white", "wooden", "sky")
    ground = textures.fit(look.surface(color, "wood"), 160, 160).copy()
    for i in range(n):
        for j in range(n):
            prints.disc(ground, (i + 0.5) / n, (j + 0.5) / n, 0.032, tint_color(color, 0.35))
    pieces = [(block(side, side, 0.014, 0.006, 0.001), ground)]
    parts = [box_part(side, side, 0.014)]
    for place in look.rng.permutation(n * n)[:7]:
        x, y = ((place % n + 0.5) / n - 0.5) * side, ((place // n + 0.5) / n - 0.5) * side
        peg = cylinder(0.0055, 0.026, 14, bevel=0.001).move(x, y, 0.012)
        pieces.append((peg, textures.plain(look.own_color(*PAINTS))))
        parts.append(cylinder_part(0.0055, 0.026, (x, y, 0.012)))
    return shape(pieces, parts)


def tower_of_hanoi(look: Look) -> Shape:
    """Three posts on a base, coloured discs by size on the first one."""
    k = look.between(0.9, 1.1)
    color = look.color(*WOODEN)
    wood = look.surface(color, "wood")
    base = block(0.22 * k, 0.078 * k, 0.012 * k, 0.008, 0.002)
    pieces, parts = [(base, wood)], [hull_of(base)]
    for n in (-1, 0, 1):
        post = cylinder(0.004 * k, 0.085 * k, 14, bevel=0.001).move(x=0.072 * k * n, z=0.011 * k)
        pieces.append((post, wood))
        parts.append(hull_of(post))
    for n in range(5):
        disc = cylinder((0.034 - 0.005 * n) * k, 0.011 * k, 28, bevel=0.0015)
        disc = disc.move(x=-0.072 * k, z=(0.0122 + 0.0112 * n) * k)
        tone = look.own_color(*PAINTS[n % len(PAINTS) :][:1])
        pieces.append((disc, textures.speckles(look.rng, tone, 4, 32)))
        parts.append(hull_of(disc))
    return shape(pieces, parts)


def shape_sorter(look: Look) -> Shape:
    """A toddler's box with holes of different shapes in its lid and sides."""
    side = look.between(0.135, 0.16)
    color = look.color("wooden", "yellow", "blue", "wooden", "red", "teal")
    dark = tint_color(color, 0.3)
    lid = textures.fit(look.surface(color, "wood"), 128, 128).copy()
    prints.disc(lid, 0.28, 0.28, 0.13, dark)
    prints.fill(lid, 0.6, 0.16, 0.25, 0.25, dark)
    prints.polygon(lid, [(0.28, 0.56), (0.44, 0.84), (0.12, 0.84)], dark)
    turns = np.arange(10) * np.pi / 5
    ray = np.where(np.arange(10) % 2, 0.07, 0.17)
    prints.polygon(
        lid,
        [(0.72 + r * np.sin(a), 0.7 - r * np.cos(a)) for r, a in zip(ray, turns, strict=True)],
        dark,
    )
    body = box(side, side, 0.86 * side)
    top = block(1.02 * side, 1.02 * side, 0.01, 0.004).move(z=0.86 * side)
    paint = textures.speckles(look.rng, look.own_color("red", "blue", "green", "orange"), 4, 32)
    return shape([(body, np.roll(lid, 64, 1)), (top, paint),
                  (box(0.98 * side, 0.98 * side, 0.0005).move(z=0.86 * side + 0.0098), lid)],
                 [box_part(side, side, 0.86 * side), hull_of(top)])  # fmt: skip


def tumbling_tower(look: Look) -> Shape:
    """A tower of wooden bars, three in each layer, the layers crossed."""
    layers = int(look.rng.integers(14, 19))
    color = look.color("wooden", "tan", "beige")
    woods = [textures.wood(look.rng, tint_color(color, f), side=64) for f in (0.9, 1.0, 1.15)]
    bars: list[list[Solid]] = [[], [], []]
    for n in range(layers):
        for m in (-1, 0, 1):
            out = look.between(0.0, 0.008) if look.chance(0.25) else 0.0
            bar = box(0.075, 0.0244, 0.0148).move(x=out, y=0.025 * m).turn(2, n % 2 * np.pi / 2)
            bars[int(look.rng.integers(3))].append(bar.move(z=0.015 * n))
    parts = [box_part(0.075, 0.075, 0.015 * layers - 0.0002)]
    return shape([(join(b), w) for b, w in zip(bars, woods, strict=True) if b], parts)


CATEGORIES = (
    Category("cube", _paint(lambda k: _same(block(0.05 * k, 0.05 * k, 0.05 * k, 0.0015, 0.001))),
             (0.05, 0.05, 0.05), 0.09, ("plain cube", "colored cube", "coloured cube",
             "cube block", "cubic block"), ("toys",), (), ("red", "blue", "green", "yellow")),
    Category("cuboid", _paint(lambda k: _same(block(0.08 * k, 0.04 * k, 0.03 * k, 0.0015,
             0.001))), (0.08, 0.04, 0.03), 0.07, ("rectangular block", "rectangular prism",
             "block brick", "cuboid block", "long block", "cuisenaire rod", "blade bank",
             "match striker"), ("toys",), (),
             ("red", "blue")),
    Category("cylinder", _paint(lambda k: _same(cylinder(0.022 * k, 0.055 * k, 32,
             bevel=0.001))), (0.044, 0.044, 0.055), 0.06, ("cylinder block",
             "cylindrical block", "round block"), ("toys",), ("round",), ("red", "blue")),
    Category("sphere", sphere, (0.05, 0.05, 0.05), 0.06, ("orb", "plain ball"), ("toys",),
             ("round",), ("red", "blue")),
    Category("cone", _paint(_cone), (0.052, 0.052, 0.06), 0.035, ("cone block",), ("toys",),
             ("round",), ("orange", "red")),
    Category("pyramid", _paint(_pyramid), (0.0566, 0.0566, 0.05), 0.04, ("pyramid block",
             "square pyramid"), ("toys",), (), ("yellow", "red")),
    Category("wedge", _paint(_slope), (0.06, 0.04, 0.04), 0.035, ("wedge block", "ramp block",
             "ramp",
             "door stop", "doorstop", "door wedge"), ("toys",), (), ("green", "blue")),
    Category("triangular_prism", _paint(_roof), (0.05, 0.06, 0.0433), 0.045,
             ("triangle block", "triangular block", "roof block", "triangle prism"), ("toys",),
             (), ("red", "green")),
    Category("hexagonal_prism", _paint(lambda k: _polygon(6, 0.027 * k, 0.04 * k)),
             (0.054, 0.0468, 0.04), 0.05, ("hexagon block", "hexagonal block", "hex block",
             "hexagon prism", "hexagon"), ("toys",), (), ("purple", "yellow")),
    Category("half_cylinder", _paint(_half_round), (0.06, 0.04, 0.03), 0.04,
             ("semicircle block", "half round block", "half circle block", "semi cylinder"),
             ("toys",), (), ("blue", "red")),
    Category("arch_block", _paint(_arch), (0.08, 0.03, 0.04), 0.045, ("arch", "bridge block",
             "arch shaped block", "toy bridge", "wooden arch"), ("toys",), (), ("red", "blue")),
    Category("l_block", _paint(_cells((0, 0), (1, 0), (2, 0), (2, 1))), (0.075, 0.05, 0.025),
             0.04, ("l shaped block", "l piece", "l-block", "l-shaped block", "tetris block",
             "tetris piece"), ("toys",), (), ("orange", "blue")),
    Category("t_block", _paint(_cells((0, 0), (1, 0), (2, 0), (1, 1))), (0.075, 0.05, 0.025),
             0.04, ("t shaped block", "t piece", "t-block", "t-shaped block"), ("toys",), (),
             ("purple", "red")),
    Category("cross_block", _paint(_cells((0, 1), (1, 1), (2, 1), (1, 0), (1, 2))),
             (0.075, 0.075, 0.025), 0.05, ("plus block", "cross shaped block", "plus sign block"),
             ("toys",), (), ("red", "green")),
    Category("star_block", _paint(_star), (0.065, 0.0615, 0.02), 0.03, ("star shaped block",
             "wooden star", "star piece"), ("toys",), (), ("yellow",)),
    Category("heart_block", _paint(_heart), (0.0576, 0.052, 0.02), 0.03, ("heart",
             "heart shaped block", "wooden heart"), ("toys",), (), ("red", "pink")),
    Category("torus", _ring(0.036, 0.018, 0.018), (0.072, 0.072, 0.018), 0.035, ("ring block",
             "toroid", "toy ring", "wooden ring", "plastic ring", "rubber ring", "ring toss ring",
             "quoit", "stacking ring", "rope quoit", "wooden quoit", "ring shaped block"), ("toys",
             ),
             ("round", "flat"), ("red", "blue")),
    Category("hollow_cylinder", _ring(0.022, 0.016, 0.07), (0.044, 0.044, 0.07), 0.035,
             ("tube", "hollow tube", "plastic tube"), ("toys",), ("round",),
             ("blue", "red")),
    Category("peg", _paint(lambda k: _same(cylinder(0.009 * k, 0.05 * k, 20, bevel=0.001))),
             (0.018, 0.018, 0.05), 0.01, ("round peg", "wooden peg", "cylindrical peg",
             "tent stake", "tent peg", "bodkin peg"),
             ("toys",), ("round",), ("red", "blue")),
    Category("square_peg", _paint(lambda k: _same(block(0.018 * k, 0.018 * k, 0.05 * k, 0.001,
             0.001))), (0.018, 0.018, 0.05), 0.012, ("cuboid peg", "square stick"), ("toys",), (),
             ("red", "blue")),
    Category("foam_brick", foam_brick, (0.078, 0.052, 0.05), 0.028, ("foam block", "foam cube"),
        ("toys",), (), ("red",)),
    Category("pegboard", pegboard, (0.165, 0.165, 0.038), 0.25, ("peg board",
             "peg game", "mastermind", "hole board", "nine-peg hole board", "nine peg hole board",
             "nine-hole peg board"), ("toys",), ("flat",), ("wooden",)),
    Category("tower_of_hanoi", tower_of_hanoi, (0.22, 0.078, 0.096), 0.25, ("hanoi tower",
             "towers of hanoi", "stacking pegs", "hanoi puzzle"), ("toys",), (), ("wooden",)),
    Category("shape_sorter", shape_sorter, (0.15, 0.15, 0.138), 0.6, ("shape sorting box",
             "shape box", "sorting box", "shape sorting cube", "sorting cube", "shape sorter toy",
             "activity cube"),
             ("toys",), ("big",), ("wooden",)),
    Category("tumbling_tower", tumbling_tower, (0.08, 0.08, 0.24), 0.75, ("jenga",
             "jenga tower", "block tower", "tower of blocks", "stacking tower",
             "jenga block tower", "toy block tower"), ("games",), ("tall",), ("wooden",)),
    Category("jenga_block", _paint(lambda k: _same(box(0.075 * k, 0.025 * k, 0.015 * k)),
             WOODEN, ("wood",)), (0.075, 0.025, 0.015), 0.018, ("jenga piece", "wooden bar",
             "plank block"), ("games",), ("flat",), ("wooden",)),
)  # fmt: skip
"""The module's categories."""
