"""Forms that many small things share: bent rods, heaps, plates of food, put down flat."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from ...scene import ConvexPart
from ..surfaces.look import Look
from ..surfaces.textures import Tile
from .collision import hull_part
from .outlines import smooth
from .shape import Shape, shape
from .solids import Solid, ellipsoid, join, lathe, tube

Pieces = list[tuple[Solid, Tile]]


def settle(
    pieces: Pieces, flat: float = 0.06, *, hulls: Sequence[Sequence[int]] | None = None
) -> Shape:
    """Return pieces put down on the table, the lowest share ``flat`` of them pressed flat.

    ``hulls`` names the pieces that each collision part holds; one part of all by default.
    """
    low = min(float(s.bounds[0, 2]) for s, _ in pieces)
    high = max(float(s.bounds[1, 2]) for s, _ in pieces)
    down = low + flat * (high - low)
    moved = [(s.move(z=-down), tile) for s, tile in pieces]
    groups = [range(len(pieces))] if hulls is None else hulls
    return shape(moved, [hull_above(*(moved[k][0] for k in group)) for group in groups])


def hull_above(*solids: Solid) -> ConvexPart:
    """Return the hull of solids, those points under the table lifted onto it."""
    points = np.concatenate([s.vertices for s in solids])
    return hull_part(np.column_stack([points[:, :2], np.maximum(points[:, 2], 0)]))


def limb(path: Any, radii: Sequence[float], sides: int = 10, squash: float = 1.0) -> Solid:
    """Return a rod through the points ``path`` with a radius at each of them."""
    wide = smooth(np.array(radii, float)[:, None], 4)[:, 0]
    return tube(smooth(path, 4), np.maximum(wide, 0.0003), sides, squash=squash)


def rod(
    length: float,
    r: float,
    *,
    bend: float = 0.0,
    blunt: float = 6.0,
    taper: float = 0.0,
    sides: int = 14,
    squash: float = 1.0,
) -> Solid:
    """Return a rod along x with rounded ends, bent to +y, thinner to the left with ``taper``.

    ``blunt`` is 2 for an ellipsoid and more for blunter ends.
    """
    u = np.sin(np.linspace(-np.pi / 2, np.pi / 2, 15))
    radii = r * np.maximum(1 - np.abs(u) ** blunt, 0.0025) ** 0.5 * (1 + taper * u)
    path = np.column_stack([0.5 * length * u, bend * (u**2 - 0.5), 0 * u])
    return tube(path, radii, sides, squash=squash)


def scatter(
    look: Look,
    radius: float,
    count: int,
    d: tuple[float, float],
    height: float,
    *,
    dome: float = 0.0,
    stretch: tuple[float, float, float] = (1.0, 1.0, 1.0),
) -> Solid:
    """Return ``count`` small ellipsoids strewn over a disc at ``height``, heaped by ``dome``."""
    made = []
    for k in range(count):
        away, turn = radius * np.sqrt((k + 0.5) / count), 2.4 * k
        size = look.between(*d)
        up = dome * (1 - (away / radius) ** 2)
        x, y, z = (size * s for s in stretch)
        one = ellipsoid(x, y, z, 8, 5)
        made.append(one.turn(2, look.between(0, 6.3)).move(away * np.cos(turn),
                    away * np.sin(turn), height + up))  # fmt: skip
    return join(made)


def crockery(r: float, h: float, *, deep: bool = True) -> Solid:
    """Return a round dish on z = 0: a deep bowl, or a shallow plate with a rim."""
    if deep:
        side = [(0.45 * r, 0), (0.48 * r, 0.06 * h), (0.76 * r, 0.34 * h), (0.93 * r, 0.7 * h),
                (r, h), (0.96 * r, h), (0.88 * r, 0.68 * h), (0.7 * r, 0.4 * h)]  # fmt: skip
        floor = 0.3 * h
    else:
        side = [(0.58 * r, 0), (0.6 * r, 0.12 * h), (0.72 * r, 0.3 * h), (r, h - 0.003),
                (r, h), (0.7 * r, 0.5 * h)]  # fmt: skip
        floor = 0.4 * h
    return lathe([(0, 0), *side, (0, floor)], 32)


def serve(
    look: Look,
    dish: Solid,
    glaze: Tile,
    food: Iterable[tuple[Solid, Tile]],
) -> Shape:
    """Return food on a dish; the dish is one collision part, the food another."""
    food = list(food)
    return shape([(dish, glaze), *food], [hull_above(dish), hull_above(*(s for s, _ in food))])


def stretch_parts(parts: Iterable[ConvexPart], x: float, y: float) -> tuple[ConvexPart, ...]:
    """Return collision parts stretched along x and y, as their solid is."""
    return tuple(ConvexPart(p.vertices * np.array([x, y, 1.0])) for p in parts)


def lift_parts(parts: Iterable[ConvexPart], z: float) -> tuple[ConvexPart, ...]:
    """Return collision parts raised by ``z``."""
    return tuple(ConvexPart(p.vertices + np.array([0, 0, z]), p.kind, p.axis) for p in parts)
