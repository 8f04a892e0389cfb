"""Col_O and Col_S (Sec. 4.1): overlaps of visual meshes, and their depths.

The visual meshes are measured, not the convex parts used in simulation. The *depth* of an overlap
is the larger of two lengths: the maximum depth of a point of either surface inside the other body
(its distance to that body's surface), and the diameter of a ball that fits into both. The ball is
tested at points within walls, and detects coincident objects, whose surfaces touch. Two boxes
pushed 3 mm into each other have a depth of 3 mm, and so has the tip of a spoon 3 mm inside a mug's
wall. A spoon that stands in the hollow of a mug is not inside any body, so it does not collide. Two
sheets that are both thinner than the threshold can cross undetected, since no point of either is
that deep in the other.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...errors import InputError
from ...scene import TABLE, Scene
from .shells import SurfaceShell, bisect, nearest_on_triangles, shells

THRESHOLD = 5e-4
"""Maximum depth of a contact, in metres; deeper overlaps are collisions."""

_TOLERANCE, _SHARE = 2e-5, 0.02  # absolute and relative tolerances of depths
_MAX_PIECES = 30_000  # number of triangle pieces examined per iteration
_CORES, _LENGTHS = 48, (5e-4, 1e-3, 2e-3, 4e-3, 8e-3, 1.6e-2)

Body = tuple[SurfaceShell, ...]
_UPRIGHT = np.array([1.0, 0.0, 0.0, 0.0])


@dataclass(frozen=True)
class Overlap:
    """Two overlapping objects: their names, and the depth in metres."""

    a: str
    b: str
    depth: float


@dataclass(frozen=True)
class Collisions:
    """The overlaps of one scene.

    ``pairs`` is the number of pairs of objects, not counting the table; ``overlaps`` are those
    between objects, and ``sunk`` are those between objects and the table.
    """

    pairs: int
    overlaps: tuple[Overlap, ...]
    sunk: tuple[Overlap, ...]
    threshold: float = THRESHOLD

    @property
    def col_o(self) -> float:
        """The fraction of pairs of objects that collide, or 0 if there are no pairs."""
        return len(self.overlaps) / self.pairs if self.pairs else 0.0

    @property
    def col_s(self) -> bool:
        """Whether the scene has any collision, including with the table."""
        return bool(self.overlaps or self.sunk)

    def facts(self) -> dict[str, Any]:
        """Return the values as JSON, with depths in millimetres."""
        return {
            "pairs": self.pairs,
            "col_o": round(self.col_o, 6),
            "col_s": self.col_s,
            "threshold_mm": round(1e3 * self.threshold, 4),
            "overlaps": [_fact(o) for o in self.overlaps],
            "sunk_into_table": [_fact(o) for o in self.sunk],
        }


@dataclass(frozen=True)
class Rates:
    """Col_O and Col_S of several scenes, as fractions in [0, 1].

    ``col_o`` refers to all pairs of all scenes.
    """

    scenes: int
    pairs: int
    col_o: float
    col_s: float


def collisions(scene: Scene, threshold: float = THRESHOLD) -> Collisions:
    """Return a settled scene's overlaps that are deeper than ``threshold`` metres.

    Raises:
        InputError: The threshold is not a positive length.
    """
    if not (np.isfinite(threshold) and threshold > 0):
        raise InputError(f"The collision threshold must be a positive length, got {threshold!r} m.")
    bodies = [
        (o.name, shells(o.model.mesh, o.scale, o.pose.position, o.pose.quaternion))
        for o in scene.objects
    ]
    middle = np.array([0, 0, scene.table.height / 2])
    table = shells(scene.table.model.mesh, scene.table.scale, middle, _UPRIGHT)
    overlaps, sunk = [], []
    for k, (name, own) in enumerate(bodies):
        if depth := overlap_depth(own, table, threshold):
            sunk.append(Overlap(name, TABLE, depth))
        for other, there in bodies[:k]:
            if depth := overlap_depth(there, own, threshold):
                overlaps.append(Overlap(other, name, depth))
    count = len(bodies)
    return Collisions(count * (count - 1) // 2, tuple(overlaps), tuple(sunk), threshold)


def rates(found: Iterable[Collisions]) -> Rates:
    """Return the collision rates of several scenes (both columns of Table 1).

    Raises:
        InputError: There are no scenes.
    """
    every = list(found)
    if not every:
        raise InputError("Collision rates need at least one scene.")
    pairs = sum(c.pairs for c in every)
    col_o = sum(len(c.overlaps) for c in every) / pairs if pairs else 0.0
    return Rates(len(every), pairs, col_o, sum(c.col_s for c in every) / len(every))


def overlap_depth(a: Body, b: Body, minimum: float = THRESHOLD) -> float:
    """Return the overlap depth of two bodies in metres, or 0 if it is at most ``minimum``."""
    deepest = 0.0
    for one in a:
        for other in b:
            if _boxes_overlap(one, other) <= minimum:
                continue
            deepest = max(deepest, _core_depth(one, other), _core_depth(other, one))
            deepest = _surface_depth(one, other, minimum, deepest)
            deepest = _surface_depth(other, one, minimum, deepest)
    return deepest if deepest > minimum else 0.0


def _boxes_overlap(a: SurfaceShell, b: SurfaceShell) -> float:
    """Return the shortest distance that separates the bounding boxes; no depth can exceed it."""
    (low_a, high_a), (low_b, high_b) = a.bounds, b.bounds
    return float(min((high_a - low_b).min(), (high_b - low_a).min()))


def _surface_depth(
    surface: SurfaceShell, inside: SurfaceShell, minimum: float, best: float
) -> float:
    """Return the maximum depth of ``surface`` in ``inside``, or ``best`` if that is larger."""
    # Branch and bound over pieces of triangles. The depth of a point in a piece is at most that of
    # the piece's middle plus its radius. It is also at most the maximum distance of the piece's
    # corners from any one triangle of the other surface, since that distance is convex.
    low, high = inside.bounds
    pieces = surface.corners
    meets = (pieces.max(1) > low + minimum) & (pieces.min(1) < high - minimum)
    pieces = pieces[meets.all(1)]
    if len(pieces):
        best = max(best, float(inside.depths(pieces.reshape(-1, 3))[0].max()))
    while len(pieces):
        middle = pieces.mean(1)
        radius = np.linalg.norm(pieces - middle[:, None], axis=2).max(1)
        depth, face = inside.depths(middle)
        best = max(best, float(depth.max()))
        bound = depth + radius
        goal = max(best * (1 + _SHARE), minimum) + _TOLERANCE
        open_ = np.flatnonzero((bound > goal) & (face >= 0))
        corners, facing = pieces[open_].transpose(1, 0, 2), inside.corners[face[open_]]
        far = [np.linalg.norm(c - nearest_on_triangles(c, facing)[0], axis=1) for c in corners]
        bound[open_] = np.minimum(bound[open_], np.max(far, axis=0, initial=0.0))
        kept = np.flatnonzero(bound > goal)
        kept = kept[np.argsort(-bound[kept], kind="stable")[:_MAX_PIECES]]
        pieces = bisect(pieces[kept])
    return best


def _core_depth(a: SurfaceShell, b: SurfaceShell) -> float:
    """Return the diameter of the largest sampled ball that is in both bodies, centred in ``a``."""
    if not (a.closed and b.closed):
        return 0.0
    picked = np.linspace(0, len(a.corners) - 1, min(_CORES, len(a.corners))).astype(int)
    middle, inward = a.corners[picked].mean(1), -a.normals[picked, 0]
    points = np.concatenate([middle + length * inward for length in _LENGTHS])
    low, high = b.bounds
    points = points[((points > low) & (points < high)).all(1)]
    if not len(points):
        return 0.0
    there = b.depths(points)[0]
    points, there = points[there > 0], there[there > 0]
    return 2 * float(np.minimum(a.depths(points)[0], there).max(initial=0.0))


def _fact(overlap: Overlap) -> dict[str, Any]:
    return {"a": overlap.a, "b": overlap.b, "depth_mm": round(1e3 * overlap.depth, 3)}


def colliding(found: Collisions) -> Sequence[str]:
    """Return the sorted, unique names of the objects that overlap."""
    pairs = [{o.a, o.b} for o in (*found.overlaps, *found.sunk)]
    return sorted(set().union(*pairs) - {TABLE})
