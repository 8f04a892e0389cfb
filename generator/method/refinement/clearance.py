"""Keeps things apart and on the table, by their footprints at shared heights."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, Int

from ...errors import InputError
from ...geometry import convex_outline
from ...scene import TABLE, Mesh, Model, Placement

if TYPE_CHECKING:
    from torch import Tensor

_CORNERS = 16  # of an outline, at most
_LEAST = 1e-3  # metres of height that two things share
_FOUND = 0.2  # weight of an overlap that was there before
_DEEP = 0.02  # metres of it beyond which it hardly counts
_TOP = 0.01  # metres below its highest point, a table's top ends
_SLACK = 1e-4  # metres


@dataclass(frozen=True, eq=False)
class Crowd:
    """``m`` pairs of things that could collide, and the tabletop's outline.

    ``first`` and ``second`` are their rows, ``one`` and ``other`` their outlines about their
    centres at yaw 0 and the sizes they begin with, metres; both are convex, counter-clockwise, and
    end in repeated points. ``least`` is how far apart a pair was, 0 at most.
    """

    first: Int[Tensor, "m"]
    second: Int[Tensor, "m"]
    one: Float[Tensor, "m k 2"]
    other: Float[Tensor, "m k 2"]
    least: Float[Tensor, "m"]
    table: Float[Tensor, "k 2"]

    def cost(
        self, place: Float[Tensor, "n 2"], yaw: Float[Tensor, "n"], grow: Float[Tensor, "n"]
    ) -> Tensor:
        """Return by how much things come into one another or leave the table, metres.

        An overlap that was there before counts for less, unless it grows, and the less the deeper
        it is: outlines are fuller than things, and no small move frees a thing of what it stands on
        but was taken to stand beside.
        """
        a, b = (
            placed_outlines(shape, place[rows], yaw[rows], grow[rows])
            for shape, rows in ((self.one, self.first), (self.other, self.second))
        )
        apart = gaps(a, b)
        deeper = (self.least - apart).clamp_min(0).sum()
        shallow = 1 - ((apart / _DEEP).clamp_max(0)).exp()
        beyond = _beyond(self.table.expand(len(place), -1, -1), place[:, None]).clamp_min(0).sum()
        return deeper + _FOUND * _DEEP * shallow.sum() + beyond


def placed_outlines(
    shape: Float[Tensor, "m k 2"],
    place: Float[Tensor, "m 2"],
    yaw: Float[Tensor, "m"],
    grow: Float[Tensor, "m"],
) -> Float[Tensor, "m k 2"]:
    """Return outlines turned by ``yaw`` (radians), ``grow`` times as large, about ``place``."""
    import torch

    c, s = yaw.cos()[:, None], yaw.sin()[:, None]
    x, y = shape.unbind(2)
    turned = torch.stack([c * x - s * y, s * x + c * y], 2)
    return turned * grow[:, None, None] + place[:, None]


def gaps(a: Float[Tensor, "m k 2"], b: Float[Tensor, "m k 2"]) -> Float[Tensor, "m"]:
    """Return how far apart convex outlines are along the best edge of either, metres.

    Below 0 it is how far one must at least be moved to be free of the other. Of edges that part
    the two equally well, one has the whole gradient: else what coincides would not be pushed.
    """
    import torch

    return torch.stack([_beyond(a, b), _beyond(b, a)]).max(0).values


def _beyond(a: Float[Tensor, "m k 2"], b: Float[Tensor, "m j 2"]) -> Float[Tensor, "m"]:
    """Return by how much all of ``b`` lies beyond the edge of ``a`` that parts the two best."""
    import torch

    along = a.roll(-1, 1) - a
    length = (along.square().sum(2) + 1e-18).sqrt()
    outward = torch.stack([along[..., 1], -along[..., 0]], 2) / length[..., None]
    ahead = ((b[:, None] - a[:, :, None]) * outward[:, :, None]).sum(3).amin(2)
    return torch.where(length > 1e-6, ahead, -torch.inf).max(1).values


def make_crowd(
    placements: Sequence[Placement],
    chains: Sequence[Collection[str]],
    models: Mapping[str, Model],
    table_scale: Float[np.ndarray, "3"],
) -> Crowd:
    """Return what must stay apart of things as they are placed.

    ``chains`` are the names of all that each one stands on or in. A thing may come into its own;
    of two others, the parts at heights that both have are held apart.
    """
    import torch

    rows: list[tuple[int, int]] = []
    shapes: list[list[np.ndarray]] = []
    for (i, a), (j, b) in combinations(enumerate(placements), 2):
        low, high = _shared_heights(a, b)
        if a.name in chains[j] or b.name in chains[i] or high - low < _LEAST:
            continue
        rows.append((i, j))
        shapes.append([_footprint(models[p.name].mesh, p, low, high) for p in (a, b)])

    def tensor(array: object) -> Tensor:
        return torch.as_tensor(np.asarray(array), dtype=torch.float32)

    one, other = tensor(np.array(shapes).reshape(-1, 2, _CORNERS, 2)).unbind(1)
    first, second = torch.tensor(rows, dtype=torch.long).reshape(-1, 2).unbind(1)
    place = tensor(np.array([p.translation[:2] for p in placements]))
    yaw = tensor([p.yaw for p in placements])
    same = torch.ones(len(rows))
    a = placed_outlines(one, place[first], yaw[first], same)
    b = placed_outlines(other, place[second], yaw[second], same)
    table = tensor(_tabletop(models.get(TABLE), table_scale))
    return Crowd(first, second, one, other, gaps(a, b).clamp_max(0), table)


def _shared_heights(a: Placement, b: Placement) -> tuple[float, float]:
    """Return the lowest and highest height that both things have, metres."""
    low, high = ([p.translation[2] + s * p.scale[2] / 2 for p in (a, b)] for s in (-1, 1))
    return max(low), min(high)


def _footprint(
    mesh: Mesh, placement: Placement, low: float, high: float
) -> Float[np.ndarray, "k 2"]:
    """Return the outline of what a thing has between two heights (metres) in its own axes."""
    corners = np.asarray(mesh.vertices, float) * placement.scale
    z = corners[:, 2] + placement.translation[2]
    ends = np.concatenate([mesh.faces[:, [k, (k + 1) % 3]] for k in range(3)])
    points = [corners[(z >= low - _SLACK) & (z <= high + _SLACK), :2]]
    for level in (low, high):
        a, b = ends[(z[ends[:, 0]] < level) & (z[ends[:, 1]] > level)].T
        share = ((level - z[a]) / (z[b] - z[a]))[:, None]
        points.append((corners[a] + share * (corners[b] - corners[a]))[:, :2])
    return _simplify(_outline(np.concatenate(points)))


def _outline(points: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "k 2"]:
    """Return the convex outline; of points in a line, a box a hair wide."""
    try:
        return convex_outline(points)
    except InputError:
        low, high = points.min(0) - _SLACK, points.max(0) + _SLACK
        return np.array([low, [high[0], low[1]], high, [low[0], high[1]]])


def _simplify(outline: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "k 2"]:
    """Return the outline with ``_CORNERS`` corners; the least go, or the last is repeated."""
    while len(outline) > _CORNERS:
        before, after = outline - np.roll(outline, 1, 0), np.roll(outline, -1, 0) - outline
        lost = np.abs(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0])
        outline = np.delete(outline, lost.argmin(), 0)
    return np.concatenate([outline, np.repeat(outline[-1:], _CORNERS - len(outline), 0)])


def _tabletop(model: Model | None, scale: Float[np.ndarray, "3"]) -> Float[np.ndarray, "k 2"]:
    """Return the tabletop's outline about its middle, metres; its box if it has no model."""
    half = np.asarray(scale)[:2] / 2
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half
    if model is not None:
        points = np.asarray(model.mesh.vertices, float) * scale
        corners = points[points[:, 2] > points[:, 2].max() - _TOP, :2]
    return _outline(corners)
