"""Objects of the ``toys`` theme: blocks."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import arc
from ...kit.parts import box_part, hull_of
from ...kit.primitives import at_box, side_view
from ...kit.shapes import Category, Pieces, Shape, category, from_pieces, shape
from ...kit.solids import Solid, block, box, cylinder, join, prism
from ...kit.surfaces import Look, tint_color
from .shapes import Made, body, paint, same


@category("magnetic_tile", size=(0.075, 0.075, 0.006), mass=0.03, material="plastic",
          aliases=("magna tile", "magnet tile", "magnetic building tile"), themes=("toys",),
          roles=("flat",), colors=("red", "blue"))  # fmt: skip
@from_pieces(bodies=(0, 1))
def magnetic_tile(look: Look) -> Pieces:
    """A transparent square tile in a coloured frame."""
    color = look.color("red", "blue", "green", "yellow", "orange", "purple")
    frame = [at_box(0.075, 0.006, 0.006, (0, s * 0.0345, 0)) for s in (-1, 1)]
    frame += [at_box(0.006, 0.063, 0.006, (s * 0.0345, 0, 0)) for s in (-1, 1)]
    pane = at_box(0.064, 0.064, 0.003, (0, 0, 0.0015))
    bars = [at_box(0.064, 0.003, 0.0035, (0, 0, 0.0015)), at_box(0.003, 0.064, 0.0035,
                                                                 (0, 0, 0.0015))]  # fmt: skip
    return [(join(frame), surfaces.plain(color)), (pane, surfaces.plain(tint_color(color, 1.45))),
            (join(bars), surfaces.plain(tint_color(color, 1.1)))]  # fmt: skip


def _arch(k: float) -> Made:
    curve = arc((0, 0), 0.022, np.pi, 0, 12)
    outline = np.concatenate([[(-0.04, 0)], curve, [(0.04, 0), (0.04, 0.04), (-0.04, 0.04)]])
    outline = outline[[*range(1, len(outline)), 0]] * k
    legs = [box(0.018 * k, 0.03 * k, 0.04 * k).move(x=s * 0.031 * k) for s in (-1, 1)]
    top = box(0.08 * k, 0.03 * k, 0.018 * k).move(z=0.022 * k)
    return [side_view(outline, 0.03 * k)], [*legs, top]


def _cells(*cells: tuple[int, int]) -> Callable[[float], Made]:
    """Return a function that makes a flat block of cubes at the grid positions ``cells``."""

    def make_hulls(k: float) -> Made:
        s = 0.025 * k
        x0, y0 = np.mean(cells, axis=0)
        return same(*[box(s, s, s).move((x - x0) * s, (y - y0) * s) for x, y in cells])

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


@category("foam_brick", size=(0.078, 0.052, 0.05), mass=0.028, material="rubber",
          aliases=("foam block", "foam cube"), themes=("toys",), colors=("red",))  # fmt: skip
def foam_brick(look: Look) -> Shape:
    """A brick of soft foam."""
    k = look.between(0.94, 1.06)
    color = look.color("red", "orange", "terracotta", "blue", "yellow")
    foam = surfaces.spots(look.rng, color, tint_color(color, 0.7), 0.12)
    body = block(0.078 * k, 0.052 * k, 0.05 * k, 0.004, 0.002)
    return shape([(body, foam)], [hull_of(body)])


BRIGHT = ("red", "blue", "yellow", "green", "orange", "violet", "pink", "teal", "lime")


@category("toy_block", size=(0.042, 0.042, 0.042), mass=0.045, material="wood",
          aliases=("letter block", "wooden block", "block", "alphabet block", "wood block cube",
          "counting cube", "stacked block", "letter e block", "soft block", "building blocks",
          "base ten block"), themes=("toys",),
          colors=("red", "blue", "yellow", "green", "orange", "violet", "pink", "teal", "lime"),
          common=True)  # fmt: skip
def toy_block(look: Look) -> Shape:
    """A wooden letter block, painted if a colour is requested."""
    side = look.between(0.038, 0.046)
    color, bare = look.color(*BRIGHT), (232.0, 208.0, 166.0)
    ground, ink = (color, bare) if "color" in look.attributes else (bare, color)
    face = prints.canvas(96, 96, ground)
    for at in (0.0, 0.91):
        prints.fill(face, at, 0, 0.09, 1, color)
        prints.fill(face, 0, at, 1, 0.09, color)
    prints.write(face, look.pick(list("ABCDEGKMR")), 0.5, 0.5, 0.5, ink, bold=True)
    return shape([(box(side, side, side), face)], [box_part(side, side, side)])


@category("building_brick", size=(0.05, 0.0316, 0.0228), mass=0.012, material="plastic",
          aliases=("toy brick", "lego brick", "lego", "brick", "building block"),
          themes=("toys", "craft"),
          colors=("red", "blue", "yellow", "green", "orange", "violet", "pink", "teal", "lime"),
          common=True)  # fmt: skip
def building_brick(look: Look) -> Shape:
    """A plastic building brick with studs."""
    columns = int(look.rng.integers(2, 5))
    pitch, h = 0.016, 0.0192
    tile = surfaces.speckles(look.rng, look.color(*BRIGHT, "white"), 3)
    x, y = columns * pitch - 0.0004, 2 * pitch - 0.0004
    studs = [cylinder(0.0048, 0.0036, 12).move(pitch * (i - (columns - 1) / 2), pitch * (j - 0.5),
                                               h) for i in range(columns)
             for j in range(2)]  # fmt: skip
    top = box_part(x - 0.006, y - 0.006, 0.0036, (0, 0, h))
    return shape([(box(x, y, h), tile), (join(studs), tile)], [box_part(x, y, h), top])


def _letter(*cells: tuple[int, int]) -> list[Solid]:
    s = 0.022
    return [box(s, s, s).move((x - 1) * s, (y - 0.5) * s) for x, y in cells]


CATEGORIES = (
    Category("arch_block", paint(_arch), size=(0.08, 0.03, 0.04), mass=0.045, material="wood",
             aliases=("arch", "bridge block", "arch shaped block", "toy bridge", "wooden arch"),
             themes=("toys",), colors=("red", "blue")),
    Category("l_block", paint(_cells((0, 0), (1, 0), (2, 0), (2, 1))), size=(0.075, 0.05, 0.025),
             mass=0.04, material="wood", aliases=("l shaped block", "l piece", "l-block",
             "l-shaped block", "tetris block", "tetris piece"), themes=("toys",),
             colors=("orange", "blue")),
    Category("t_block", paint(_cells((0, 0), (1, 0), (2, 0), (1, 1))), size=(0.075, 0.05, 0.025),
             mass=0.04, material="wood",
             aliases=("t shaped block", "t piece", "t-block", "t-shaped block"), themes=("toys",),
             colors=("purple", "red")),
    Category("cross_block", paint(_cells((0, 1), (1, 1), (2, 1), (1, 0), (1, 2))),
             size=(0.075, 0.075, 0.025), mass=0.05, material="wood",
             aliases=("plus block", "cross shaped block", "plus sign block"), themes=("toys",),
             colors=("red", "green")),
    Category("star_block", paint(_star), size=(0.065, 0.0615, 0.02), mass=0.03, material="wood",
             aliases=("star shaped block", "wooden star", "star piece"), themes=("toys",),
             colors=("yellow",)),
    Category("heart_block", paint(_heart), size=(0.0576, 0.052, 0.02), mass=0.03, material="wood",
             aliases=("heart", "heart shaped block", "wooden heart"), themes=("toys",),
             colors=("red", "pink")),
    Category("peg", paint(lambda k: same(cylinder(0.009 * k, 0.05 * k, 20, bevel=0.001))),
             size=(0.018, 0.018, 0.05), mass=0.01, material="wood", aliases=("round peg",
             "wooden peg", "cylindrical peg", "tent stake", "tent peg", "bodkin peg"),
             themes=("toys",), roles=("round",), colors=("red", "blue")),
    Category("square_peg",
             paint(lambda k: same(block(0.018 * k, 0.018 * k, 0.05 * k, 0.001, 0.001))),
             size=(0.018, 0.018, 0.05), mass=0.012, material="wood",
             aliases=("cuboid peg", "square stick"), themes=("toys",), colors=("red", "blue")),
    Category("u_block",
             from_pieces()(body(lambda: _letter((0, 0), (1, 0), (2, 0), (0, 1), (2, 1)))),
             size=(0.066, 0.044, 0.022), mass=0.05, material="wood",
             aliases=("u shaped block", "u piece", "u-block", "c block"), themes=("toys",),
             colors=("blue", "red")),
    Category("s_block", from_pieces()(body(lambda: _letter((0, 0), (1, 0), (1, 1), (2, 1)))),
             size=(0.066, 0.044, 0.022), mass=0.04, material="wood",
             aliases=("s shaped block", "s piece", "s-block"), themes=("toys",),
             colors=("green", "red")),
    Category("z_block", from_pieces()(body(lambda: _letter((0, 1), (1, 1), (1, 0), (2, 0)))),
             size=(0.066, 0.044, 0.022), mass=0.04, material="wood",
             aliases=("z shaped block", "z piece", "z-block"), themes=("toys",),
             colors=("red", "blue")),
    Category("bar_block", from_pieces()(body(lambda: [box(0.12, 0.02, 0.02)])),
             size=(0.12, 0.02, 0.02), mass=0.05, material="wood",
             aliases=("bar", "square bar", "long bar", "rectangular bar"), themes=("toys",),
             colors=("wooden", "silver")),
)  # fmt: skip
"""Objects that share their drawing functions."""
