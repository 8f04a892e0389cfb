"""Objects of the ``toys`` theme: puzzles."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import steel
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import at_box, ball, drum
from ...kit.shapes import Shape, category, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, torus
from ...kit.surfaces import RGB, Look, plain, tint_color

PAINTS = ("red", "blue", "green", "yellow", "orange", "purple", "wooden", "teal", "pink")
WOODEN = ("wooden", "tan", "beige", "wooden", "brown")


@category("pegboard", size=(0.165, 0.165, 0.038), mass=0.25, material="wood", assembled=True,
          aliases=("peg board", "peg game", "mastermind", "hole board", "nine-peg hole board",
          "nine peg hole board", "nine-hole peg board"), themes=("toys",), roles=("flat",),
          colors=("wooden",))  # fmt: skip
def pegboard(look: Look) -> Shape:
    """A board with a grid of holes and a few coloured pegs."""
    side, n = look.between(0.15, 0.18), 6
    color = look.color("wooden", "beige", "white", "wooden", "sky")
    ground = surfaces.fit(look.surface(color, "wood"), 160, 160).copy()
    for i in range(n):
        for j in range(n):
            prints.disc(ground, (i + 0.5) / n, (j + 0.5) / n, 0.032, tint_color(color, 0.35))
    pieces = [(block(side, side, 0.014, 0.006, 0.001), ground)]
    parts = [box_part(side, side, 0.014)]
    for place in look.rng.permutation(n * n)[:7]:
        x, y = ((place % n + 0.5) / n - 0.5) * side, ((place // n + 0.5) / n - 0.5) * side
        peg = cylinder(0.0055, 0.026, 14, bevel=0.001).move(x, y, 0.012)
        pieces.append((peg, surfaces.plain(look.own_color(*PAINTS))))
        parts.append(cylinder_part(0.0055, 0.026, (x, y, 0.012)))
    return shape(pieces, parts)


@category("tower_of_hanoi", size=(0.22, 0.078, 0.096), mass=0.25, material="wood", assembled=True,
          aliases=("hanoi tower", "towers of hanoi", "stacking pegs", "hanoi puzzle"),
          themes=("toys",), colors=("wooden",))  # fmt: skip
def tower_of_hanoi(look: Look) -> Shape:
    """Three posts on a base, with coloured discs ordered by size on the first post."""
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
        pieces.append((disc, surfaces.speckles(look.rng, tone, 4, 32)))
        parts.append(hull_of(disc))
    return shape(pieces, parts)


@category("puzzle_cube", size=(0.058, 0.058, 0.058), mass=0.09, material="plastic",
          aliases=("rubik's cube", "rubiks cube", "magic cube", "rubik cube"),
          themes=("toys", "office"), common=True)  # fmt: skip
def puzzle_cube(look: Look) -> Shape:
    """A scrambled 3x3 puzzle cube."""
    side = 0.057
    paints: tuple[RGB, ...] = (
        (200, 40, 40), (40, 90, 190), (245, 245, 240),
        (245, 205, 50), (50, 150, 70), (240, 130, 40),
    )  # fmt: skip
    pieces = [(box(side, side, side), surfaces.plain((26, 26, 28)))]
    places = [
        (0.0, -side / 2, 0), (0.0, side / 2, np.pi), (-side / 2, 0.0, -np.pi / 2),
        (side / 2, 0.0, np.pi / 2),
    ]  # fmt: skip
    plate = box(0.97 * side, 0.0008, 0.97 * side)
    for x, y, turn in places:
        pieces.append((plate.turn(2, turn).move(x, y, 0.015 * side), _stickers(look, paints)))
    top = box(0.97 * side, 0.97 * side, 0.0004).move(z=side)
    pieces.append((top, _stickers(look, paints)))
    return shape(pieces, [box_part(side, side, side)])


def _stickers(look: Look, paints: tuple[RGB, ...]) -> surfaces.Tile:
    image = prints.canvas(96, 96, (26, 26, 28))
    for i in range(3):
        for j in range(3):
            paint = paints[int(look.rng.integers(len(paints)))]
            prints.fill(image, 0.03 + 0.32 * i, 0.03 + 0.32 * j, 0.29, 0.29, paint)
    return image


BRIGHT = ("red", "blue", "yellow", "green", "orange", "violet", "pink", "teal", "lime")


@category("stacking_rings", size=(0.09, 0.09, 0.137), mass=0.22, material="plastic",
          aliases=("ring stacker", "stacking toy", "stacking ring tower", "stacking ring toy"),
          themes=("toys",), roles=("round",), common=True)  # fmt: skip
def stacking_rings(look: Look) -> Shape:
    """A baby's stacking toy: a cone of coloured rings on a peg."""
    pieces: list[tuple[Solid, surfaces.Tile]] = [
        (cylinder(0.045, 0.012, 28, bevel=0.003), surfaces.wood(look.rng, (214, 176, 124)))
    ]
    start, pastel = int(look.rng.integers(len(BRIGHT))), look.pick([1.0, 1.0, 1.4])
    for k in range(5):
        color = tint_color(look.own_color(BRIGHT[(start + k) % len(BRIGHT)]), pastel)
        ring = torus(0.03 - 0.004 * k, 0.0115, 26, 10).move(z=0.0225 + 0.0205 * k)
        pieces.append((ring, surfaces.speckles(look.rng, color, 3)))
    pieces.append((ellipsoid(0.026, 0.026, 0.026, 16, 10).move(z=0.124), pieces[0][1]))
    pieces.append((cylinder(0.012, 0.11, 14).move(z=0.01), pieces[0][1]))
    body = lathe([(0, 0), (0.041, 0.0), (0.041, 0.034), (0.013, 0.136), (0, 0.136)], 12)
    return shape(pieces, [cylinder_part(0.045, 0.012), hull_of(body.move(z=0.001))])


@category("marble_maze", size=(0.192, 0.192, 0.0288), mass=0.5, material="wood",
          aliases=("labyrinth", "ball maze", "labyrinth game", "wooden maze", "maze", "maze game"),
          themes=("toys", "games"), roles=("big",), colors=("wooden",))  # fmt: skip
def marble_maze(look: Look) -> Shape:
    """A shallow box with low walls, holes and a steel ball."""
    color = look.color("wooden", "tan", "blue", "red")
    k = look.between(0.85, 1.15)
    floor, s = at_box(0.2, 0.2, 0.008), 0.2
    rims = [at_box(s, 0.01, 0.03, (0, t * 0.095, 0)) for t in (-1, 1)] + [
        at_box(0.01, s, 0.03, (t * 0.095, 0, 0)) for t in (-1, 1)
    ]
    walls = []
    for x, y, u, v in ((-0.05, 0.05, 0.08, 0.006), (0.03, 0.06, 0.006, 0.06), (0.055, 0.01, 0.07,
    0.006), (-0.06, -0.01, 0.006,
                       0.07), (-0.02, -0.03, 0.07, 0.006), (0.04, -0.055, 0.006, 0.06), (-0.03,
                       -0.07, 0.06, 0.006)):  # fmt: skip
        walls.append(at_box(u, v, 0.012, (x, y, 0.007)))
    holes = [drum(0.0085, 0.0006, (x, y, 0.0078), sides=14) for x,
             y in ((-0.07, 0.075), (0.0, 0.02), (0.07, 0.04), (0.07, -0.07), (-0.035, -0.05),
                   (0.01, -0.06), (-0.08, 0.02))]  # fmt: skip
    marble = ball(0.014, 0.014, 0.014, (-0.03, 0.025, 0.0148), 12)
    wood = look.surface(color, "wood")
    return put_down([(floor, surfaces.wood(look.rng, (226, 196, 150))), (join(rims), wood),
                     (join(walls), plain(tint_color(color, 0.7))),
                     (join(holes), plain((24, 22, 20))), (marble, steel(look))], floor, *rims,
                    join(walls[:1]), factor=k)  # fmt: skip
