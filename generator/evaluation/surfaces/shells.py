"""Closed surfaces of visual meshes, depths of points inside them, and nearest triangles.

A mesh is split into its connected pieces, the *shells*. A body is the union of its shells, so no
boolean operations are needed for a handle that is sunk into a cup's wall or for a hundred keys on a
keyboard. Distances are exact: a tree of boxes finds the nearest triangle, and the angle-weighted
normal of the nearest face, edge or corner distinguishes outside from inside (J. Baerentzen and H.
Aanaes, "Signed distance computation using the angle weighted pseudonormal", TVCG 2005). This fails
where a surface lies on itself, as do the two sides of a sheet, and for pieces that are not closed.
Points that pass this test are therefore also tested with the winding number (A. Van Oosterom and J.
Strackee, "The solid angle of a plane triangle", 1983).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree

from ...geometry import quaternion_matrix
from ...physics.inertia import weld
from ...scene import Mesh
from ...scene.triangles import closed

_LEAF = 4  # number of triangles per box of the tree
_CHUNK = 400_000  # number of point-triangle or point-box pairs processed at once


@dataclass(frozen=True, eq=False)
class SurfaceShell:
    """A connected piece of a surface in world coordinates (metres); triangles are in spatial order.

    ``normals`` are the outward pseudonormals of each triangle's face, its edges 01, 12, 20 and its
    corners. ``boxes`` are the levels of the tree (minimum and maximum corners), root first.
    """

    corners: Float[np.ndarray, "m 3 3"]
    normals: Float[np.ndarray, "m 7 3"]
    closed: bool
    boxes: tuple[Float[np.ndarray, "_ 2 3"], ...]
    points: KDTree

    @property
    def bounds(self) -> Float[np.ndarray, "2 3"]:
        """The minimum and the maximum corner."""
        return self.boxes[0][0]

    def nearest(
        self, points: Float[np.ndarray, "p 3"]
    ) -> tuple[Float[np.ndarray, "p 3"], Int[np.ndarray, "p"], Int[np.ndarray, "p"]]:
        """Return the shell's point nearest to each given point, and its triangle and feature.

        Features are numbered as in ``normals``: 0 is the face, 1 to 3 are edges, 4 to 6 are
        corners.
        """
        place, face = np.zeros_like(points), np.zeros(len(points), np.int64)
        feature = np.zeros(len(points), np.int64)
        step = max(1, _CHUNK // 64)
        for start in range(0, len(points), step):
            part = slice(start, start + step)
            place[part], face[part], feature[part] = self._nearest(points[part])
        return place, face, feature

    def depths(
        self, points: Float[np.ndarray, "p 3"]
    ) -> tuple[Float[np.ndarray, "p"], Int[np.ndarray, "p"]]:
        """Return the depths of points in metres, negative outside, and the nearest triangles.

        For a point outside the shell's box, the distance to the box is returned as a lower bound,
        and the triangle is -1.
        """
        low, high = self.bounds
        away = np.maximum(np.maximum(low - points, points - high), 0.0)
        depth = -np.linalg.norm(away, axis=1)
        face = np.full(len(points), -1)
        near = np.flatnonzero((away == 0).all(1))
        if len(near):
            place, face[near], feature = self.nearest(points[near])
            offset = points[near] - place
            length = np.linalg.norm(offset, axis=1)
            inside = np.ones(len(near), bool)
            if self.closed:
                inside = np.einsum("pk,pk->p", offset, self.normals[face[near], feature]) < 0
            inside[inside] = self._encloses(points[near[inside]])
            depth[near] = np.where(inside, length, -length)
        return depth, face

    def _nearest(
        self, points: Float[np.ndarray, "p 3"]
    ) -> tuple[Float[np.ndarray, "p 3"], Int[np.ndarray, "p"], Int[np.ndarray, "p"]]:
        limit = self.points.query(points)[0] ** 2 * (1 + 1e-9) + 1e-18
        owner, node = np.arange(len(points)), np.zeros(len(points), np.int64)
        for boxes in self.boxes[1:]:
            owner, node = np.repeat(owner, 2), np.repeat(2 * node, 2)
            node[1::2] += 1
            box, point = boxes[node], points[owner]
            away = np.maximum(np.maximum(box[:, 0] - point, point - box[:, 1]), 0.0)
            kept = np.einsum("pk,pk->p", away, away) <= limit[owner]
            owner, node = owner[kept], node[kept]
        face = (_LEAF * node[:, None] + np.arange(_LEAF)).ravel()
        owner = np.repeat(owner, _LEAF)
        real = face < len(self.corners)
        owner, face = owner[real], face[real]
        place, feature = nearest_on_triangles(points[owner], self.corners[face])
        away = points[owner] - place
        square = np.einsum("pk,pk->p", away, away)
        order = np.lexsort((square, owner))
        first = order[np.searchsorted(owner[order], np.arange(len(points)))]
        return place[first], face[first], feature[first]

    def _encloses(self, points: Float[np.ndarray, "p 3"]) -> Bool[np.ndarray, "p"]:
        step = max(1, _CHUNK // len(self.corners))
        turns = [
            solid_angles(points[k : k + step], self.corners) for k in range(0, len(points), step)
        ]
        return np.concatenate([np.empty(0), *turns]) > 0.5


def shells(
    mesh: Mesh,
    scale: Float[np.ndarray, "3"],
    position: Float[np.ndarray, "3"],
    quaternion: Float[np.ndarray, "4"],
) -> tuple[SurfaceShell, ...]:
    """Return the shells of a canonical mesh at ``scale`` (its extent in metres) and a world pose.

    Texture seams are joined. Pairs of faces that lie back to back are removed, since they bound no
    volume. A closed piece that is turned inside out is filled as a cavity if another piece contains
    it; otherwise it is inverted.
    """
    vertices, faces = weld(mesh)
    vertices = (vertices * scale) @ quaternion_matrix(quaternion).T + position
    faces = _outer(faces)
    if not len(faces):
        return ()
    count = len(vertices)
    links = (np.concatenate([faces[:, 0], faces[:, 1]]), np.concatenate([faces[:, 1], faces[:, 2]]))
    graph = coo_matrix((np.ones(len(links[0])), links), (count, count))
    label = connected_components(graph, directed=False)[1][faces[:, 0]]
    order = np.argsort(label, kind="stable")
    pieces = np.split(faces[order], np.flatnonzero(np.diff(label[order])) + 1)
    made = [(_shell(vertices, piece), _volume(vertices[piece])) for piece in pieces]
    filled = [shell for shell, volume in made if not (shell.closed and volume < 0)]
    for (shell, volume), piece in zip(made, pieces, strict=True):
        if shell.closed and volume < 0 and not any(_holds(f, shell) for f in filled):
            filled.append(_shell(vertices, piece[:, ::-1]))
    return tuple(filled)


def _shell(vertices: Float[np.ndarray, "n 3"], faces: Int[np.ndarray, "m 3"]) -> SurfaceShell:
    corners = vertices[faces]
    middle = corners.mean(1)
    order = np.argsort(_morton(middle), kind="stable")
    faces, corners = faces[order], corners[order]
    leaves = 1 << max(0, int(np.ceil(np.log2(len(faces) / _LEAF))))
    boxes = np.empty((leaves, 2, 3))
    boxes[:, 0], boxes[:, 1] = np.inf, -np.inf
    leaf = np.arange(len(faces)) // _LEAF
    np.minimum.at(boxes[:, 0], leaf, corners.min(1))
    np.maximum.at(boxes[:, 1], leaf, corners.max(1))
    levels = [boxes]
    while len(levels[0]) > 1:
        pairs = levels[0].reshape(-1, 2, 2, 3)
        levels.insert(0, np.stack([pairs[:, :, 0].min(1), pairs[:, :, 1].max(1)], 1))
    used = np.unique(faces)
    return SurfaceShell(
        corners, pseudonormals(vertices, faces), closed(faces), tuple(levels),
        KDTree(vertices[used]),
    )  # fmt: skip


def _outer(faces: Int[np.ndarray, "m 3"]) -> Int[np.ndarray, "k 3"]:
    """Return the faces, omitting pairs of coincident faces with opposite orientations."""
    key = np.sort(faces, axis=1)
    _, group = np.unique(key, axis=0, return_inverse=True)
    group = group.reshape(-1)
    second = faces[np.arange(len(faces)), (np.argmin(faces, axis=1) + 1) % 3]
    sense = np.where(second == key[:, 1], 1, -1)
    balance = np.bincount(group, weights=sense)
    return faces[balance[group] != 0]


def _holds(outer: SurfaceShell, inner: SurfaceShell) -> bool:
    return outer.closed and bool((outer.depths(inner.corners[:1, 0])[0] > 0).all())


def _volume(corners: Float[np.ndarray, "m 3 3"]) -> float:
    a, b, c = corners.transpose(1, 0, 2)
    middle = corners.mean((0, 1))
    return float(np.einsum("mk,mk->", a - middle, np.cross(b - middle, c - middle))) / 6


def _morton(points: Float[np.ndarray, "m 3"]) -> Int[np.ndarray, "m"]:
    """Return the Z-order (Morton) codes of points."""
    low = points.min(0)
    span = max(float(np.ptp(points, axis=0).max()), 1e-12)
    cells = np.clip((points - low) / span * 1023, 0, 1023).astype(np.int64)
    code = np.zeros(len(points), np.int64)
    for bit in range(10):
        for axis in range(3):
            code |= ((cells[:, axis] >> bit) & 1) << (3 * bit + axis)
    return code


def nearest_on_triangles(
    points: Float[np.ndarray, "p 3"], corners: Float[np.ndarray, "p 3 3"]
) -> tuple[Float[np.ndarray, "p 3"], Int[np.ndarray, "p"]]:
    """Return, for each row, the triangle's point nearest to the given point, and its feature.

    Feature 0 is the face, 1 to 3 are the edges 01, 12, 20, and 4 to 6 are the corners. The Voronoi
    regions of the triangle determine the feature (C. Ericson, "Real-Time Collision Detection",
    2005, 5.1.5).
    """
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    ab, ac, ap, bp, cp = b - a, c - a, points - a, points - b, points - c
    d1, d2 = _dot(ab, ap), _dot(ac, ap)
    d3, d4 = _dot(ab, bp), _dot(ac, bp)
    d5, d6 = _dot(ab, cp), _dot(ac, cp)
    va, vb, vc = d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2
    regions = [
        (d1 <= 0) & (d2 <= 0),
        (d3 >= 0) & (d4 <= d3),
        (d6 >= 0) & (d5 <= d6),
        (vc <= 0) & (d1 >= 0) & (d3 <= 0),
        (va <= 0) & (d4 >= d3) & (d5 >= d6),
        (vb <= 0) & (d2 >= 0) & (d6 <= 0),
    ]
    feature = np.select(regions, [4, 5, 6, 1, 2, 3], 0)
    whole = np.where(feature == 0, va + vb + vc, 1.0)
    whole = np.where(np.abs(whole) < 1e-300, 1.0, whole)
    on_ab = _share(d1, d1 - d3)
    on_bc = _share(d4 - d3, (d4 - d3) + (d5 - d6))
    on_ac = _share(d2, d2 - d6)
    zero, one = np.zeros_like(d1), np.ones_like(d1)
    v = np.choose(feature, [vb / whole, on_ab, 1 - on_bc, zero, zero, one, zero])
    w = np.choose(feature, [vc / whole, zero, on_bc, on_ac, zero, zero, one])
    return a + v[:, None] * ab + w[:, None] * ac, feature


def pseudonormals(
    vertices: Float[np.ndarray, "n 3"], faces: Int[np.ndarray, "m 3"]
) -> Float[np.ndarray, "m 7 3"]:
    """Return the outward normals of each triangle's face, edges 01, 12 and 20, and corners.

    The normal of an edge is the sum of the unit normals of its faces; the normal of a corner is the
    sum of those of its faces, weighted by angle.
    """
    corners = vertices[faces]
    sides = np.roll(corners, -1, axis=1) - corners
    normal = np.cross(sides[:, 0], -sides[:, 2])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    units = sides / np.maximum(np.linalg.norm(sides, axis=2, keepdims=True), 1e-300)
    cosine = -np.einsum("mck,mck->mc", units, np.roll(units, 1, axis=1))
    angle = np.arccos(np.clip(cosine, -1, 1))
    at_corner = np.zeros_like(vertices)
    np.add.at(at_corner, faces.ravel(), (angle[:, :, None] * normal[:, None]).reshape(-1, 3))
    ends = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], -1), axis=-1).reshape(-1, 2)
    _, edge = np.unique(ends @ [len(vertices), 1], return_inverse=True)
    at_edge = np.zeros((int(edge.max()) + 1, 3))
    np.add.at(at_edge, edge, np.repeat(normal, 3, axis=0))
    return np.concatenate([normal[:, None], at_edge[edge.reshape(-1, 3)], at_corner[faces]], axis=1)


def solid_angles(
    points: Float[np.ndarray, "p 3"], corners: Float[np.ndarray, "m 3 3"]
) -> Float[np.ndarray, "p"]:
    """Return the winding number of a triangle mesh about each point: 1 inside a closed surface."""
    a, b, c = (corners[None, :, k] - points[:, None] for k in range(3))
    la, lb, lc = (np.linalg.norm(side, axis=2) for side in (a, b, c))
    volume = _dot(a, np.cross(b, c))
    rest = la * lb * lc + _dot(a, b) * lc + _dot(b, c) * la + _dot(c, a) * lb
    return np.arctan2(volume, rest).sum(1) / (2 * np.pi)


def bisect(corners: Float[np.ndarray, "m 3 3"]) -> Float[np.ndarray, "n 3 3"]:
    """Split every triangle in two at the midpoint of its longest side."""
    sides = np.roll(corners, -1, axis=1) - corners
    longest = np.argmax(np.einsum("mck,mck->mc", sides, sides), axis=1)
    rows = np.arange(len(corners))
    p, q, r = (corners[rows, (longest + k) % 3] for k in range(3))
    middle = (p + q) / 2
    return np.concatenate([np.stack([p, middle, r], 1), np.stack([middle, q, r], 1)])


def _dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.einsum("...k,...k->...", a, b)


def _share(part: np.ndarray, total: np.ndarray) -> np.ndarray:
    return np.clip(part / np.where(total == 0, 1.0, total), 0.0, 1.0)
