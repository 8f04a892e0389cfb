"""Objects of the ``office`` theme: various toys."""

from __future__ import annotations

from itertools import product

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import PAINTS, wood
from ...kit.outlines import arc
from ...kit.parts import box_part, hull_of
from ...kit.primitives import at_block, at_box, disc, plate
from ...kit.shapes import Pieces, Shape, category, from_pieces, shape
from ...kit.solids import block, ellipsoid, join, tube
from ...kit.surfaces import Look


@category("toy_chair", size=(0.05, 0.05, 0.11), mass=0.03, material="wood", assembled=True,
          aliases=("dollhouse chair", "miniature chair", "mini chair", "doll chair", "small chair",
          "wooden chair"), themes=("office",), colors=("wooden",))  # fmt: skip
@from_pieces()
def toy_chair(look: Look) -> Pieces:
    """A small chair with a seat, four legs and a back of slats."""
    tile = wood(look, "wooden", "white", "brown", "pink", "red")
    seat = at_block(0.05, 0.05, 0.006, 0.006, (0, 0, 0.045))
    legs = [disc(0.0035, 0.046, (x, y, 0), sides=10) for x in (-0.02, 0.02) for y in (-0.02, 0.02)]
    posts = [disc(0.0035, 0.06, (x, 0.021, 0.05), sides=10) for x in (-0.02, 0.02)]
    slats = [at_box(0.042, 0.004, 0.008, (0, 0.021, 0.066 + 0.018 * k)) for k in range(3)]
    return [(seat, tile), *((leg, tile) for leg in legs), (join([*posts, *slats]), tile)]


@category("newtons_cradle", size=(0.16, 0.115, 0.137), mass=0.5, material="metal", assembled=True,
          aliases=("newton's cradle", "newton cradle", "pendulum balls", "pendulum",
          "desk pendulum"), themes=("office",), roles=("tall",), colors=("silver",))  # fmt: skip
def newtons_cradle(look: Look) -> Shape:
    """A Newton's cradle: five steel balls hanging in a row from a frame."""
    k = look.between(0.85, 1.05)
    color = look.color("silver", "black", "gold", "charcoal")
    x, y, h = 0.15 * k, 0.11 * k, 0.14 * k
    base = block(1.12 * x, 1.1 * y, 0.014 * k, 0.008, 0.002)
    bars = [tube(np.array([(-x / 2, s * y / 2, 0.012), (-x / 2, s * y / 2, h),
        (x / 2, s * y / 2, h),
                           (x / 2, s * y / 2, 0.012)]), 0.0034 * k, 8)
                               for s in (-1, 1)]  # fmt: skip
    d = 0.022 * k
    balls, wires = [], []
    swing = look.between(0.3, 0.6) if look.chance(0.6) else 0.0
    for n in range(5):
        u = (n - 2) * d
        a = swing if n == 4 else 0.0
        at = np.array([u + np.sin(a) * 0.095 * k, 0, h - 0.095 * k * np.cos(a)])
        balls.append(ellipsoid(d, d, d, 16, 10).move(*at))
        wires += [tube([at, (u, s * y / 2, h)], 0.0006, 4) for s in (-1, 1)]
    wood = look.own_color("black", "brown", "wooden")
    return shape([(base, surfaces.wood(look.rng, wood)), (join(bars), look.surface(color, "metal")),
                  (join(balls), surfaces.brushed_metal(look.rng, (206, 208, 212))),
                  (join(wires), surfaces.plain((210, 210, 212)))],
                 [hull_of(base), *(box_part(x, 0.006 * k, 0.006 * k, (0, s * y / 2, h - 0.003 * k))
                                   for s in (-1, 1)),
                  *(box_part(0.0068 * k, 0.0068 * k, h - 0.004, (s * x / 2, t * y / 2, 0.002))
                    for s in (-1, 1) for t in (-1, 1)), hull_of(*balls)])  # fmt: skip


@category("fraction_circle", size=(0.116, 0.116, 0.005), mass=0.04, material="plastic",
          aliases=("fraction tile", "fraction disc", "fraction set", "algebra tile",
          "pie chart model"), themes=("office",), colors=("red",))  # fmt: skip
@from_pieces()
def fraction_circle(look: Look) -> Pieces:
    """A fraction circle: a disc cut into coloured wedges."""
    n = look.pick([4, 6, 8])
    pieces: Pieces = []
    for k in range(n):
        a, b = 2 * np.pi * k / n, 2 * np.pi * (k + 1) / n
        m = (a + b) / 2
        wedge = np.concatenate([[(0, 0)], arc((0, 0), 0.055, a, b, 8)]) + 0.003 * np.array(
            [np.cos(m), np.sin(m)]
        )
        tile = surfaces.plain(look.own_color(PAINTS[k % len(PAINTS)]))
        pieces.append((plate(wedge, 0.005), tile))
    return pieces


@category("linking_cubes", size=(0.12, 0.02, 0.0225), mass=0.03, material="plastic",
          aliases=("multilink cube", "unifix cube", "unifix cubes", "snap cube", "linking cube",
          "multilink cubes"), themes=("office",), colors=("red", "blue"))  # fmt: skip
@from_pieces()
def linking_cubes(look: Look) -> Pieces:
    """Six linking cubes joined into a rod."""
    s = 0.02
    pieces: Pieces = []
    for k in range(6):
        x = (k - 2.5) * s
        tile = surfaces.plain(look.color(*PAINTS))
        pieces.append((at_block(0.97 * s, s, s, 0.0015, (x, 0, 0)), tile))
        pieces.append((disc(0.005, 0.003, (x, 0, s - 0.0005)), tile))
    return pieces


@category("soma_cube", size=(0.06, 0.06, 0.06), mass=0.12, material="wood",
          aliases=("cube puzzle", "wooden cube puzzle", "burr puzzle", "3d puzzle"),
          themes=("office",), colors=("red",))  # fmt: skip
@from_pieces()
def soma_cube(look: Look) -> Pieces:
    """A Soma cube: a puzzle cube made of angular pieces."""
    s = 0.02
    tones = [look.own_color(*PAINTS) for _ in range(7)]
    pieces: Pieces = []
    for i, j, k in product(range(3), repeat=3):
        cube = at_box(0.96 * s, 0.96 * s, 0.98 * s, ((i - 1) * s, (j - 1) * s, k * s))
        pieces.append((cube, surfaces.plain(tones[(i + 2 * j * (k + 1) + (i * j)) % 7])))
    return pieces


@category("galton_board", size=(0.18, 0.09, 0.252), mass=0.6, material="wood",
          aliases=("bean machine", "quincunx", "plinko board", "pinball board"), themes=("office",),
          roles=("tall",), colors=("wooden",))  # fmt: skip
@from_pieces()
def galton_board(look: Look) -> Pieces:
    """A Galton board: a funnel, rows of pins and bins with a bell curve of beads."""
    image = prints.canvas(96, 144, (238, 232, 214))
    for row in range(9):
        for k in range(9 + row % 2):
            prints.disc(
                image, 0.1 + 0.1 * k - 0.05 * (row % 2), 0.24 + 0.045 * row, 0.009, (60, 60, 66)
            )
    tall = (0.03, 0.08, 0.16, 0.25, 0.29, 0.25, 0.16, 0.08, 0.03)
    bead = look.own_color("blue", "red", "teal")
    for k, h in enumerate(tall):
        prints.fill(image, 0.06 + 0.1 * k, 0.97 - h, 0.085, h, bead)
    prints.polygon(image, [(0.2, 0.05), (0.8, 0.05), (0.53, 0.18), (0.47, 0.18)], bead)
    tile = wood(look, "wooden", "brown", "black")
    body = at_box(0.16, 0.03, 0.24, (0, 0, 0.012))
    foot = at_box(0.18, 0.09, 0.012)
    return [(foot, tile), (body, tile), (at_box(0.145, 0.002, 0.225, (0, -0.0155, 0.019)), image)]
