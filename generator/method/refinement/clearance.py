"""The cost that keeps objects apart and on the table, computed from outlines at shared heights."""

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

_CORNERS = 16  # maximum number of corners of an outline
_LEAST = 1e-3  # minimum height range that two objects share, metres
_FOUND = 0.2  # weight of an overlap that existed at the start
_DEEP = 0.02  # depth of overlap beyond which the cost saturates, metres
_TOP = 0.01  # thickness of the layer below the highest point that counts as a table's top, metres
_SLACK = 1e-4  # metres


@dataclass(frozen=True, eq=False)
class Crowd:
    """``m`` pairs of objects that could collide, and the tabletop's outline.

    ``first`` and ``second`` are the rows of each pair's objects; ``one`` and ``other`` are the
    outlines of these about the objects' centres, at yaw 0 and the initial sizes, metres. Both are
    convex, counter-clockwise, and padded with repeated points. ``least`` is the initial gap of a
    pair, at most 0.
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
        """Return how far, in metres, objects overlap or extend off the table.

        An initial overlap has a lower weight unless it grows, and its cost saturates with depth.
        There are two reasons: outlines are larger than objects, and if an object was assumed to
        stand beside the one that actually supports it, no small motion can separate them.
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
    """Return outlines rotated by ``yaw`` (radians), scaled by ``grow`` and centred at ``place``."""
    import torch

    c, s = yaw.cos()[:, None], yaw.sin()[:, None]
    x, y = shape.unbind(2)
    turned = torch.stack([c * x - s * y, s * x + c * y], 2)
    return turned * grow[:, None, None] + place[:, None]


def gaps(a: Float[Tensor, "m k 2"], b: Float[Tensor, "m k 2"]) -> Float[Tensor, "m"]:
    """Return each pair's gap in metres: the maximum over the edge normals of both convex outlines.

    A negative value is the minimum displacement that separates the two. If two edges separate them
    equally well, one of the edges gets the whole gradient; otherwise coincident outlines would not
    be pushed apart.
    """
    import torch

    return torch.stack([_beyond(a, b), _beyond(b, a)]).max(0).values


def _beyond(a: Float[Tensor, "m k 2"], b: Float[Tensor, "m j 2"]) -> Float[Tensor, "m"]:
    """Return the largest signed gap from ``a`` to ``b`` along the edge normals of ``a``."""
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
    """Return the pairs of objects that must stay apart.

    ``chains`` lists the names of all direct and indirect supports of each object. An object may
    overlap its supports; any other two objects are compared at the heights that they share.
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
    """Return the lower and the upper limit, in metres, of the heights that both objects occupy."""
    low, high = ([p.translation[2] + s * p.scale[2] / 2 for p in (a, b)] for s in (-1, 1))
    return max(low), min(high)


def _footprint(
    mesh: Mesh, placement: Placement, low: float, high: float
) -> Float[np.ndarray, "k 2"]:
    """Return an object's outline between two heights (metres), in its own axes."""
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
    """Return the points' convex outline, or a thin box if they are collinear."""
    try:
        return convex_outline(points)
    except InputError:
        low, high = points.min(0) - _SLACK, points.max(0) + _SLACK
        return np.array([low, [high[0], low[1]], high, [low[0], high[1]]])


def _simplify(outline: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "k 2"]:
    """Return the outline with ``_CORNERS`` corners, dropping minor ones or repeating the last."""
    while len(outline) > _CORNERS:
        before, after = outline - np.roll(outline, 1, 0), np.roll(outline, -1, 0) - outline
        lost = np.abs(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0])
        outline = np.delete(outline, lost.argmin(), 0)
    return np.concatenate([outline, np.repeat(outline[-1:], _CORNERS - len(outline), 0)])


def _tabletop(model: Model | None, scale: Float[np.ndarray, "3"]) -> Float[np.ndarray, "k 2"]:
    """Return the tabletop's outline about its centre in metres, or its box if there is no model."""
    half = np.asarray(scale)[:2] / 2
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half
    if model is not None:
        points = np.asarray(model.mesh.vertices, float) * scale
        corners = points[points[:, 2] > points[:, 2].max() - _TOP, :2]
    return _outline(corners)
