"""Objects of the ``games`` theme: dice."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from jaxtyping import Float

from ...kit import prints, surfaces
from ...kit.parts import hull_of, hull_part, open_vessel
from ...kit.primitives import facing
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import Solid, box, join, open_box, prism
from ...kit.surfaces import Look, readable_on, tint_color

PHI = (1 + np.sqrt(5)) / 2
COLORS = ("red", "blue", "green", "purple", "black", "teal", "orange", "white", "yellow", "pink")


def _signs(*triples: tuple[float, float, float]) -> Float[np.ndarray, "n 3"]:
    """Return all sign changes and cyclic permutations of the given triples."""
    made = {tuple(np.round(np.roll(np.array(t) * [i, j, k], n), 9))
            for t in triples for i in (-1, 1) for j in (-1, 1) for k in (-1,
                1) for n in range(3)}  # fmt: skip
    return np.array(sorted(made), float)


def _kite_ends() -> Float[np.ndarray, "n 3"]:
    """Return the corners of a ten-sided die: two apexes and a zigzag belt of ten points."""
    a = np.pi / 5 * np.arange(10)
    belt = np.column_stack([np.cos(a), np.sin(a), 0.105 * (-1.0) ** np.arange(10)])
    return np.array([*belt, (0, 0, 1.0), (0, 0, -1.0)])


def _sides(corners: np.ndarray) -> list[np.ndarray]:
    """Return the corners of each flat face, counter-clockwise seen from outside."""
    from scipy.spatial import ConvexHull

    hull = ConvexHull(corners)
    planes: dict[tuple[float, ...], set[int]] = {}
    for simplex, plane in zip(hull.simplices, hull.equations, strict=True):
        key = next((p for p in planes if np.abs(np.array(p) - plane[:3]).max() < 0.05), None)
        planes.setdefault(key or tuple(plane[:3]), set()).update(int(k) for k in simplex)
    made = []
    for normal, chosen in sorted(planes.items()):
        points = corners[sorted(chosen)]
        middle = points.mean(0)
        u = points[0] - middle
        v = np.cross(np.array(normal), u)
        order = np.argsort(np.arctan2((points - middle) @ v, (points - middle) @ u))
        made.append(points[order])
    return made


def _die(corners: np.ndarray, size: float) -> Callable[[Look], Shape]:
    """Return the shape function of a die with the given corners, resting on one face."""

    def make(look: Look) -> Shape:
        color = look.color(*COLORS)
        ink = readable_on(color)
        k = size * look.between(0.9, 1.2) / 2 / np.linalg.norm(corners, axis=1).max()
        sides = _sides(corners)
        # Turn the first face down.
        down = np.cross(sides[0][1] - sides[0][0], sides[0][2] - sides[0][1])
        down = down / np.linalg.norm(down)
        turn = _turn_to(down, np.array([0.0, 0.0, -1.0]))
        pieces, low = [], float((sides[0] @ turn.T)[:, 2].min())
        figures = look.rng.permutation(len(sides)) + 1
        columns = int(np.ceil(np.sqrt(len(sides))))
        image = prints.canvas(64 * columns, 64 * columns, color)
        solids = []
        for n, side in enumerate(sides):
            points = (side @ turn.T - [0, 0, low]) * k
            middle = points.mean(0)
            cell = image[64 * (n // columns):64 * (n // columns + 1),
                         64 * (n % columns):64 * (n % columns + 1)]  # fmt: skip
            figure = str(int(figures[n]))
            prints.write(cell, figure, 0.5, 0.5, 0.34 if len(sides) > 8 else 0.28, ink, bold=True)
            u = points[0] - middle
            v = np.cross(np.cross(points[1] - points[0], points[2] - points[1]), u)
            u, v = u / np.linalg.norm(u), v / np.linalg.norm(v)
            reach = np.linalg.norm(points - middle, axis=1).max()
            flat = np.column_stack([(points - middle) @ v, (points - middle) @ u]) * [-1, 1]
            uv = 0.5 + 0.49 * flat / reach
            uv = np.add(uv, (n % columns, columns - 1 - n // columns)) / columns
            vertices = np.concatenate([middle[None], points])
            around = 1 + np.arange(len(points))
            faces = np.column_stack([np.zeros_like(around), around, np.roll(around, -1)])
            heart = np.add((0.5, 0.5), (n % columns, columns - 1 - n // columns)) / columns
            solids.append((vertices, faces, np.concatenate([heart[None], uv])))
        start = np.cumsum([0, *[len(v) for v, _, _ in solids]])
        body = Solid(np.concatenate([v for v, _, _ in solids]),
                     np.concatenate([f + s for (_, f, _), s in zip(solids, start, strict=False)]),
                     np.clip(np.concatenate([t for _, _, t in solids]), 0, 1))  # fmt: skip
        pieces.append((body, image))
        return shape(pieces, [hull_part((corners @ turn.T - [0, 0, low]) * k)])

    return make


def _turn_to(a: np.ndarray, b: np.ndarray) -> Float[np.ndarray, "3 3"]:
    """Return the rotation that turns direction ``a`` into direction ``b``."""
    axis = np.cross(a, b)
    s, c = np.linalg.norm(axis), float(a @ b)
    if s < 1e-9:
        return np.diag([1.0, c, c])
    x, y, z = axis / s
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + s * skew + (1 - c) * skew @ skew


@category("dice_tower", size=(0.1, 0.161, 0.174), mass=0.4, material="wood", hollow=True,
          aliases=("tower for dice",), themes=("games",), roles=("tall",),
          colors=("wooden",))  # fmt: skip
def dice_tower(look: Look) -> Shape:
    """A dice tower: a square shaft with battlements and a walled tray in front."""
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
    tray = [s.move(y=back - y / 2 - 0.045 * k)
            for s in open_box(0.1 * k, 0.09 * k, 0.022 * k, 0.005, 0.004)]  # fmt: skip
    felt = box(0.09 * k, 0.08 * k, 0.001).move(y=back - y / 2 - 0.045 * k, z=0.004)
    tile = look.surface(color, "wood")
    seams = [box(x + 0.002, y + 0.002, 0.0015).move(y=back, z=z * h) for z in (0.25, 0.5, 0.75)]
    return shape([(join([*shaft, *teeth, *tray]), tile),
                  (join(seams), surfaces.plain(tint_color(color, 0.6))),
                  (join(arch), surfaces.plain((24, 22, 22))),
                  (felt, surfaces.plain((150, 40, 44)))],
                 [hull_of(*shaft), *[hull_of(s) for s in tray]])  # fmt: skip


@category("dice_cup", size=(0.085, 0.085, 0.093), mass=0.09, material="leather", hollow=True,
          aliases=("dice shaker", "cup for dice"), themes=("games",), roles=("container", "round"),
          colors=("brown",))  # fmt: skip
def dice_cup(look: Look) -> Shape:
    """An open leather dice cup."""
    k = look.between(0.94, 1.08)
    side = [(0.034 * k, 0), (0.04 * k, 0.088 * k), (0.042 * k, 0.092 * k)]
    body, parts = open_vessel(side, 0.003, 0.005)
    color = look.color("brown", "black", "maroon", "tan", "green")
    skin = surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.1)
    seam = surfaces.plain(tint_color(color, 0.6))
    return shape([(body, surfaces.stack((seam, 0.06), (skin, 0.4), (seam, 0.08), (skin, 0.46)))],
                 parts)  # fmt: skip


CATEGORIES = (
    Category("twenty_sided_die", _die(_signs((0, 1, PHI)), 0.022), size=(0.0234, 0.0221, 0.0192),
             mass=0.006, material="plastic", aliases=("d20", "twenty-sided die",
             "twenty sided dice", "twenty-sided dice", "20 sided die", "20-sided die"),
             themes=("games", "toys"), colors=("red", "blue")),
    Category("twelve_sided_die", _die(_signs((1, 1, 1), (0, 1 / PHI, PHI)), 0.021),
             size=(0.0207, 0.0213, 0.0173), mass=0.006, material="plastic",
             aliases=("d12", "twelve-sided die", "12 sided die"), themes=("games", "toys"),
             colors=("red", "blue")),
    Category("ten_sided_die", _die(_kite_ends(), 0.021), size=(0.016, 0.0203, 0.0143), mass=0.005,
             material="plastic", aliases=("d10", "ten-sided die", "10 sided die", "percentile die"),
             themes=("games", "toys"), colors=("red", "blue")),
    Category("eight_sided_die", _die(_signs((0, 0, 1)), 0.02), size=(0.0173, 0.0173, 0.0127),
             mass=0.004, material="plastic", aliases=("d8", "eight-sided die", "8 sided die"),
             themes=("games", "toys"), colors=("red", "blue")),
    Category("four_sided_die",
             _die(np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], float), 0.024),
             size=(0.0201, 0.0201, 0.017), mass=0.003, material="plastic",
             aliases=("d4", "four-sided die", "4 sided die"), themes=("games", "toys"),
             colors=("red", "blue")),
)  # fmt: skip
"""Objects that share their drawing functions."""
