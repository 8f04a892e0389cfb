"""Extension of convex parts until they contain the visual mesh.

A shape's convex parts are often coarser than its mesh: a ring of wedges has chords where the wall
is round, and a hull has few vertices. Objects whose meshes extend beyond their parts appear to sink
into each other. This module extends the nearest part's hull to the uncovered points; points far
from every part get additional hulls. Other objects may come to rest on surfaces that are open from
above. There, hulls extend at most a millimetre beyond the mesh, so that a bowl stays hollow.

A hull gets only the vertices that it needs. The farthest point outside each of its faces is added
repeatedly, until none is left (after C. Barber et al., "The quickhull algorithm for convex hulls",
1996).
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.ndimage import maximum_filter
from scipy.spatial import ConvexHull, QhullError

from ..scene import ConvexPart
from ..scene.triangles import Faces, Vertices, pieces, scaled_normals
from .mjcf import primitive_kind

Points = Float[np.ndarray, "n 3"]

TOLERANCE = 2.5e-4
"""Maximum distance of a vertex from the parts, in metres: half the depth of a visible overlap."""

_REACH = 6e-3  # maximum growth of a part, metres; points farther away get additional hulls
_ROUNDS = 8  # maximum number of growth rounds per hull
_BURIED = 1e-3  # maximum depth to which growth may cover the mesh, metres
_OVERHANG = 3e-3  # points that are this far below the top of their column are covered, metres
_HOLLOW = 0.01  # height above a surface from which a hull fills a hollow, metres
_MUCH = 1e-3  # uncovered distance at which a _LARGE convex piece gets its own hull, metres
_LARGE = 0.3  # as a fraction of the shape's longest side
_FEW = 48  # number of vertices up to which no thinning is needed
_WAYS = np.array([*itertools.product((-1.0, 0.0, 1.0), repeat=3)])
_CONVEX = 0.9  # minimum ratio of a convex piece's volume to the volume of its hull
_SPECK = np.stack(np.meshgrid(*[(-2e-4, 2e-4)] * 3), -1).reshape(-1, 3)


def covering(
    parts: Sequence[ConvexPart], vertices: Vertices, faces: Faces
) -> tuple[ConvexPart, ...]:
    """Return grown ``parts`` and new hulls that together contain the mesh to within ``TOLERANCE``.

    A connected piece of the mesh that is convex and uncovered gets its own hull; parts inside such
    a hull are dropped. Everything is in metres and in a common frame.
    """
    places, index = np.unique(vertices.round(6), axis=0, return_inverse=True)
    faces = index.reshape(-1)[faces]
    drawn, normals, owner = _surface(places, faces)
    lacking = _lacking(parts, drawn)
    if not len(lacking):
        return tuple(parts)
    out = _distances(parts, drawn[lacking])
    if hulls := _convex_pieces(places, faces, lacking, out.min(0)):
        spare = [(_distances(hulls, p.vertices).min(0) <= _MUCH).all() for p in parts]
        parts = [p for p, drop in zip(parts, spare, strict=True) if not drop] + hulls
        lacking = _lacking(parts, drawn)
        if not len(lacking):
            return tuple(parts)
        out = _distances(parts, drawn[lacking])
    sky = _Sky.over(drawn)
    bare = drawn[_seen_from_above(drawn, normals, sky)]
    bare = bare[_lacking(parts, bare, _BURIED / 2)]
    grown = list(parts)
    near, depth = out.argmin(0), out.min(0)
    for k in np.unique(near[depth <= _REACH]):
        mine = lacking[(near == k) & (depth <= _REACH)]
        if primitive_kind(parts[k]) != "mesh":  # a hull would lose its roundness
            from_it = outside(parts[k], drawn)
            mine = np.flatnonzero((from_it > -2 * TOLERANCE) & (from_it <= _REACH))
        grown[k] = _grown_where_solid(parts[k], drawn[mine], normals[mine], bare)
        out[k] = outside(grown[k], drawn[lacking])
    bad = np.zeros(len(drawn), bool)
    bad[lacking[out.min(0) > TOLERANCE]] = True
    left = np.asarray(bad[: len(places)][faces].any(1))
    left[owner[bad[len(places) :]]] = True
    return (*grown, *_patches(places, faces[left], bare, sky))


def _lacking(
    parts: Sequence[ConvexPart], points: Points, depth: float = -TOLERANCE
) -> Int[np.ndarray, "k"]:
    """Return the indices of the points that no part contains at a depth of at least ``depth``."""
    left, at = np.arange(len(points)), points
    for part in parts:
        near = np.flatnonzero(_deep_in_box(part, at, depth))
        within = near[outside(part, at[near]) < -depth]
        if len(within):
            left = np.delete(left, within)
            at = points[left]
    return left


def _deep_in_box(part: ConvexPart, points: Points, depth: float) -> Bool[np.ndarray, "n"]:
    """Return which points are deeper than ``depth`` inside a part's bounding box."""
    (x, y, z), (low, high) = points.T, part.bounds
    (x0, y0, z0), (x1, y1, z1) = low + depth, high - depth
    return (x > x0) & (x < x1) & (y > y0) & (y < y1) & (z > z0) & (z < z1)


def _distances(parts: Sequence[ConvexPart], points: Points) -> Float[np.ndarray, "p n"]:
    return np.stack([outside(part, points) for part in parts])


def _surface(
    places: Vertices, faces: Faces
) -> tuple[Float[np.ndarray, "k 3"], Float[np.ndarray, "k 3"], Int[np.ndarray, "e"]]:
    """Return the vertices plus points on long edges, all normals, and the edge points' faces."""
    # Parts may contain both ends of an edge but not its middle.
    turn = scaled_normals(places[faces])
    normals = np.zeros_like(places)
    for k in range(3):
        np.add.at(normals, faces[:, k], turn)
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    beside = np.tile(np.arange(len(faces)), 3)
    length = np.linalg.norm(places[edges[:, 1]] - places[edges[:, 0]], axis=1)
    long = (edges[:, 0] < edges[:, 1]) & (length > np.ptp(places, axis=0).max() / 16)
    start, end = places[edges[long]].transpose(1, 0, 2)
    steps = np.linspace(0, 1, 9)[1:-1, None]
    between = (start[:, None] + (end - start)[:, None] * steps).reshape(-1, 3)
    owner = np.repeat(beside[long], len(steps))
    return np.concatenate([places, between]), np.concatenate([normals, turn[owner]]), owner


@dataclass(frozen=True, eq=False)
class _Sky:
    """Maximum height of the visual mesh in each grid cell, or -inf in cells without samples."""

    low: Float[np.ndarray, "2"]
    cell: float
    top: Float[np.ndarray, "49 49"]

    @classmethod
    def over(cls, drawn: Points) -> _Sky:
        low, cell = drawn[:, :2].min(0), float(np.ptp(drawn, axis=0).max()) / 48
        top = np.full((49, 49), -np.inf)
        np.maximum.at(top, tuple(((drawn[:, :2] - low) / cell).astype(int).T), drawn[:, 2])
        return cls(low, cell, top)

    def height(self, points: Points) -> Float[np.ndarray, "n"]:
        """Return the height of the surface at the given points."""
        return self.top[tuple(((points[:, :2] - self.low) / self.cell).astype(int).T)]

    def fills(self, part: ConvexPart) -> bool:
        """Return whether a part fills space that is open from above, like a lid on a jar."""
        corners = part.vertices
        one, other = np.triu_indices(len(corners), 1)
        middles = (corners[one] + corners[other]) / 2
        cells = ((middles[:, :2] - self.low) / self.cell).astype(int)
        top = self.around[tuple(cells.T)]
        return bool((np.isfinite(top) & (middles[:, 2] > top + _HOLLOW)).any())

    @cached_property
    def around(self) -> Float[np.ndarray, "49 49"]:
        """Maximum height within two cells of each cell, which bridges gaps in the grid."""
        return maximum_filter(self.top, 5, mode="nearest")


def _seen_from_above(drawn: Points, normals: Points, sky: _Sky) -> Bool[np.ndarray, "n"]:
    """Return which points face upwards with nothing above them, so that objects may rest there."""
    steep = normals[:, 2] < 0.3 * np.linalg.norm(normals, axis=1)
    return ~steep & (drawn[:, 2] > sky.height(drawn) - _OVERHANG)


def _convex_pieces(
    places: Vertices, faces: Faces, lacking: Int[np.ndarray, "k"], depth: Float[np.ndarray, "k"]
) -> list[ConvexPart]:
    """Return the hulls of connected components of the mesh that are convex and clearly uncovered.

    ``depth`` is the distance from the parts to each of the ``lacking`` points.
    """
    piece = pieces(faces, len(places))
    corners = lacking < len(places)
    worst = np.zeros(int(piece.max()) + 1)
    np.maximum.at(worst, piece[lacking[corners]], depth[corners])
    hulls = []
    longest = _LARGE * float(np.ptp(places, axis=0).max())
    for k in np.flatnonzero(worst > _MUCH):
        points, triangles = places[piece == k], places[faces[piece[faces[:, 0]] == k]]
        if worst[k] <= _REACH and np.ptp(points, axis=0).max() < longest:
            continue
        volume = float(np.linalg.det(triangles).sum()) / 6
        try:
            hull = ConvexHull(points)
        except QhullError:  # flat
            continue
        if volume > _CONVEX * hull.volume:
            hulls.append(_thin(points[hull.vertices]))
    return hulls


def _thin(corners: Points) -> ConvexPart:
    """Return the hull of the extreme points ``corners``, with redundant points removed."""
    if len(corners) <= _FEW:
        return ConvexPart(corners.round(6))
    start = corners[np.unique((corners @ _WAYS.T).argmax(0))]
    try:
        return _grow(ConvexPart(start), corners)
    except QhullError:  # the corners form a sheet with coplanar extreme vertices
        return ConvexPart(corners.round(6))


def outside(part: ConvexPart, points: Points) -> Float[np.ndarray, "n"]:
    """Return the signed distance in metres of ``points`` from a part, negative inside.

    Near an edge or a corner, it is the distance from the farthest plane, which is a lower bound.
    """
    low, high = part.bounds
    middle, half = (low + high) / 2, (high - low) / 2
    kind = primitive_kind(part)
    if kind == "cylinder":
        radius = float(np.delete(half, part.axis).mean())
        across = np.linalg.norm(np.delete(points - middle, part.axis, axis=1), axis=1) - radius
        return np.maximum(across, np.abs(points - middle)[:, part.axis] - half[part.axis])
    if kind in ("sphere", "ellipsoid"):
        return (np.linalg.norm((points - middle) / half, axis=1) - 1) * float(half.min())
    if kind == "box":
        return (np.abs(points - middle) - half).max(1)
    return _heights(points, _hull(part)[1]).max(0)


def _heights(points: Points, planes: Float[np.ndarray, "k 4"]) -> Float[np.ndarray, "k n"]:
    """Return the signed distances of points from planes, in metres."""
    found = planes[:, :3] @ points.T
    found += planes[:, 3:]  # in place, because allocating another array would take most of the time
    return found


@lru_cache(maxsize=1024)
def _hull(part: ConvexPart) -> tuple[Int[np.ndarray, "c"], Float[np.ndarray, "k 4"]]:
    """Return the indices of a hull's vertices, and the planes of its faces.

    Each plane is an outward normal and an offset, metres.
    """
    hull = ConvexHull(part.vertices)
    return hull.vertices, hull.equations


def _grow(part: ConvexPart, lacking: Points) -> ConvexPart:
    """Return the part, extended by a few of the points ``lacking`` so that it contains them all."""
    extreme, planes = _hull(part)
    corners, left = part.vertices[extreme], lacking
    for k in range(_ROUNDS):
        if k:
            hull = ConvexHull(corners)
            corners, planes = corners[hull.vertices], hull.equations
        height = _heights(left, planes)
        own, farthest = height.argmax(0), height.max(0)
        keep = farthest > TOLERANCE
        if not keep.any():
            break
        left, own, farthest = left[keep], own[keep], farthest[keep]
        order = np.lexsort((-farthest, own))
        first = order[np.diff(own[order], prepend=-1) > 0]
        corners = np.concatenate([corners, left[first]])
    return ConvexPart(corners.round(6))


def _grown_where_solid(
    part: ConvexPart, lacking: Points, normals: Points, bare: Float[np.ndarray, "k 3"]
) -> ConvexPart:
    """Return the part, extended by the points that do not make it cover other visible surfaces."""
    axis = np.abs(normals).argmax(1)
    facing = 2 * axis + (normals[np.arange(len(axis)), axis] > 0)
    for way in np.unique(facing):  # the points on one side of the surface at a time
        wider = _grow(part, lacking[facing == way])
        if not _buries(wider, bare):
            part = wider
    return part


def _buries(part: ConvexPart, bare: Float[np.ndarray, "k 3"]) -> bool:
    """Return whether any of the surface points ``bare`` is deep inside a part."""
    inside = bare[_deep_in_box(part, bare, _BURIED)]
    return bool(len(inside)) and bool((outside(part, inside) < -_BURIED).any())


def _patches(
    places: Vertices, faces: Faces, bare: Float[np.ndarray, "k 3"], sky: _Sky, halvings: int = 4
) -> list[ConvexPart]:
    """Return hulls of groups of triangles, split until no hull covers ``bare`` or fills a hollow.

    Triangles are split along their longest side.
    """
    if not len(faces):
        return []
    points = places[np.unique(faces)]
    try:
        hull = _thin(points[ConvexHull(points).vertices])
    except QhullError:  # flat
        hull = ConvexPart((points[:, None] + _SPECK).reshape(-1, 3).round(6))
    in_the_way = halvings > 0 and len(faces) > 2 and _buries(hull, bare)
    if len(faces) == 1 or not (in_the_way or sky.fills(hull)):
        return [hull]
    middles = places[faces].mean(1)
    axis = int(np.ptp(middles, axis=0).argmax())
    first = np.argsort(middles[:, axis], kind="stable")[: len(faces) // 2]
    half = np.zeros(len(faces), bool)
    half[first] = True
    halves = (faces[half], faces[~half])
    return [p for few in halves for p in _patches(places, few, bare, sky, halvings - 1)]
