"""Heaps and pyramids: objects close together, some on top of others."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from jaxtyping import Float

from .footprint import Footprint

_GAP = 0.002  # gap between neighbours in a layer, metres
_ROUND = 1.4  # maximum ratio of length to width of objects in a lattice
_SHARE = 4  # one object in this many lies on others


@dataclass(frozen=True, eq=False)
class Pile:
    """Positions of the members of a heap or pyramid.

    Attributes:
        offsets: position of each member relative to the middle of the lowest layer, metres.
        below: for each member, the indices of those it lies on; empty in the lowest layer.
    """

    offsets: tuple[Float[np.ndarray, "2"], ...]
    below: tuple[tuple[int, ...], ...]


def pile_heap(shapes: Sequence[Footprint]) -> Pile | None:
    """Return the positions in a heap: a dense layer, with a quarter of the objects on top of it.

    Returns None if the objects are too long for a lattice.
    """
    pitch = _pitch(shapes)
    if pitch is None:
        return None
    above = len(shapes) // _SHARE
    places = _lattice(pitch, len(shapes))
    base = places[: len(shapes) - above]
    hollows = [
        three for three in combinations(range(len(base)), 3)
        if max(float(np.hypot(*(base[i] - base[k]))) for i, k in combinations(three, 2))
        < 1.01 * pitch
    ]  # fmt: skip
    hollows.sort(key=lambda three: float(np.hypot(*np.mean(base[list(three)], axis=0))))
    tops: list[tuple[int, int, int]] = []
    for three in hollows:
        middle = np.mean(base[list(three)], axis=0)
        free = all(
            np.hypot(*(middle - np.mean(base[list(other)], axis=0))) > 0.99 * pitch
            for other in tops
        )
        if free and len(tops) < above:
            tops.append(three)
    lying = len(shapes) - len(tops)
    offsets = (*places[:lying], *(np.mean(base[list(three)], axis=0) for three in tops))
    return Pile(offsets, ((),) * lying + tuple(tops))


def pile_pyramid(shapes: Sequence[Footprint], *, balls: bool) -> Pile | None:
    """Return the positions in a pyramid of rows (3, 2, 1) or of triangles of balls (6, 3, 1).

    Members left over from complete rows widen the lowest row; balls that cannot form a complete
    pyramid form a heap. Returns None if the objects are too long.
    """
    flat = not balls
    if balls and len(shapes) not in (4, 10, 20):
        return pile_heap(shapes)
    pitch = _pitch(shapes)
    if pitch is None:
        return None
    layers: list[int] = []
    size = 1
    while sum(layers) + _layer(size, flat) <= len(shapes):
        layers.append(_layer(size, flat))
        size += 1
    rest = len(shapes) - sum(layers)
    side = len(layers)
    offsets: list[Float[np.ndarray, "2"]] = []
    below: list[tuple[int, ...]] = []
    previous: dict[tuple[int, int], int] = {}
    for level in range(side):
        width = side - level
        cells = [(i, j) for j in range(1 if flat else width) for i in range(width - j)]
        here: dict[tuple[int, int], int] = {}
        for i, j in cells:
            x = pitch * (i + 0.5 * j + 0.5 * level - (side - 1) / 2)
            y = 0.0 if flat else pitch * np.sqrt(3) * (j / 2 + level / 6 - (side - 1) / 6)
            here[i, j] = len(offsets)
            offsets.append(np.array([x, y]))
            under = [(i, j), (i + 1, j)] if flat else [(i, j), (i + 1, j), (i, j + 1)]
            below.append(tuple(previous[cell] for cell in under) if level else ())
        previous = here
        for k in range(0 if level else rest):
            x = pitch * (side + k - (side - 1) / 2)
            offsets.append(np.array([x, offsets[0][1]]))
            below.append(())
    return Pile(tuple(offsets), tuple(below))


def _layer(size: int, flat: bool) -> int:
    return size if flat else size * (size + 1) // 2


def _pitch(shapes: Sequence[Footprint]) -> float | None:
    """Return the distance between neighbours, or None for long objects."""
    halves = np.array([shape.half for shape in shapes])
    if (halves.max(1) > _ROUND * halves.min(1)).any():
        return None
    return float(2 * halves.max() + _GAP)


def _lattice(pitch: float, count: int) -> Float[np.ndarray, "n 2"]:
    """Return the first positions of a triangular lattice centred on one of its triangles."""
    reach = int(np.ceil(np.sqrt(count))) + 2
    a, b = np.meshgrid(np.arange(-reach, reach + 1), np.arange(-reach, reach + 1))
    points = np.column_stack([(a + b / 2).ravel(), (b * np.sqrt(3) / 2).ravel()]) * pitch
    points -= pitch * np.array([0.5, np.sqrt(3) / 6])
    order = np.lexsort((points[:, 1], points[:, 0], np.hypot(*points.T).round(6)))
    return points[order[:count]]
