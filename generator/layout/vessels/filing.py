"""Flat things in a box: on their edges in a row, all leaning against one end, as records are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from ...scene import Model
from .cavities import SECTORS, Cavity

_LEAN = np.deg2rad(9.0)  # towards the end
_SQUARE = 1.2  # how much farther a box's corners are from its middle than its sides
_FLAT = 0.22  # thickness to width of what is filed
_LEAST = 0.1  # metres that it is wide
_GAP = 8e-4  # metres between things


@dataclass(frozen=True)
class _Box:
    """Half of a box's room along a row of things and across it; it runs along x (0) or y (1)."""

    length: float
    width: float
    axis: int


def _boxes(cavity: Cavity) -> list[_Box]:
    """Return the two ways in which a row may run in a rectangular vessel; none in a round one."""
    radii = cavity.radii[0]
    across, corner = radii[:: SECTORS // 4], radii[SECTORS // 8 :: SECTORS // 4]
    if corner.min() < _SQUARE * across.min():
        return []
    x, y = float(min(across[0], across[2])), float(min(across[1], across[3]))
    return sorted([_Box(x, y, 0), _Box(y, x, 1)], key=lambda box: -box.length)


def is_flat(model: Model) -> bool:
    """Tell whether a lying thing is as flat and wide as a book or a record."""
    x, y, z = (float(v) for v in model.size)
    return z < _FLAT * min(x, y) and min(x, y) > _LEAST


def file_away(
    things: Mapping[str, Model], cavity: Cavity
) -> dict[str, tuple[Float[np.ndarray, "3 3"], Float[np.ndarray, "3"]]] | None:
    """Return how each of flat lying things is turned in a box, and where its middle then is.

    None where the box is round, or has no room for the row.
    """
    sizes = [np.sort(np.asarray(m.size, float)) for m in things.values()]
    thick = sum(float(size[0]) for size in sizes) / np.cos(_LEAN) + _GAP * len(sizes)
    for box in _boxes(cavity):
        for side in (1, 2):  # how high things stand: on the longer edge, or on the shorter one
            tall = max(min(float(size[side]), cavity.depth) for size in sizes)
            wide = max(float(size[3 - side]) for size in sizes)
            start = _start(box, wide, cavity)
            room = 1.9 * box.length - tall * np.sin(_LEAN) - start
            if wide <= 2 * box.width - 2 * _GAP and thick <= room:
                return _row(things, side, replace(box, length=box.length - start), cavity, tall)
    return None


def _start(box: _Box, wide: float, cavity: Cavity) -> float:
    """Return how far from the end a row has room for its width: boxes have posts in corners."""
    for start in np.linspace(0.0, 0.2 * box.length, 12):
        ends = np.array([[start - box.length, s * wide / 2, z] for s in (-1, 1)
                         for z in (cavity.floor, cavity.rim)])  # fmt: skip
        if box.axis:
            ends[:, :2] = ends[:, 1::-1] * [-1, 1]
        ends[:, :2] += cavity.middle
        away = np.hypot(*(ends[:, :2] - cavity.middle).T)
        if (away <= cavity.wall(ends) + _GAP).all():
            return float(start)
    return 0.2 * box.length


def _row(
    things: Mapping[str, Model],
    side: int,
    box: _Box,
    cavity: Cavity,
    tall: float,
) -> dict[str, tuple[Float[np.ndarray, "3 3"], Float[np.ndarray, "3"]]]:
    c, s = np.cos(_LEAN), np.sin(_LEAN)
    tip = np.array([[c, 0.0, -s], [0.0, 1.0, 0.0], [s, 0.0, c]])  # +z leans towards -x
    quarter = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    into = quarter if box.axis else np.eye(3)
    at = -box.length + tall * s + _GAP
    found = {}
    for name, model in things.items():
        size = np.sort(np.asarray(model.size, float))
        upright = _on_edge(model, side)
        foot = np.array([at + size[0] / 2 / c, 0.0, cavity.floor + size[0] / 2 * s + _GAP])
        middle = foot + tip @ [0.0, 0.0, size[side] / 2]
        found[name] = (into @ tip @ upright, into @ middle + [*cavity.middle, 0.0])
        at += size[0] / c + _GAP
    return found


def _on_edge(model: Model, side: int) -> Float[np.ndarray, "3 3"]:
    """Return the turn that stands a lying thing as high as its ``side``, its face to +x."""
    face = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])  # z to x, x down
    if (model.size[0] <= model.size[1]) == (side == 1):
        return face
    return face @ np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
