"""Functions of the vertices and faces of a triangle mesh."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int

Vertices = Float[np.ndarray, "n 3"]
Faces = Int[np.ndarray, "m 3"]

_AT_ONCE = 100_000  # number of faces processed at once


def weld_index(vertices: Vertices) -> Int[np.ndarray, "n"]:
    """Return an index for each vertex, equal for all vertices at the same position."""
    span = max(float(np.ptp(vertices, axis=0).max()), 1e-9)
    keys = np.round(vertices / span * 1e5).astype(np.int64)
    x, y, z = (keys - keys.min(0)).T  # each is below 2**17
    return np.unique((x << 40) + (y << 20) + z, return_inverse=True)[1].reshape(-1)


def scaled_normals(triangles: Float[np.ndarray, "m 3 3"]) -> Float[np.ndarray, "m 3"]:
    """Return each triangle's normal, scaled to twice the triangle's area."""
    a, b, c = triangles.transpose(1, 0, 2)
    return np.cross(b - a, c - a)


def face_normals(vertices: Vertices, faces: Faces) -> Float[np.ndarray, "m 3"]:
    """Return the unit normal of each face (zero for degenerate faces)."""
    normal = scaled_normals(vertices[faces])
    return normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)


def areas(vertices: Vertices, faces: Faces) -> Float[np.ndarray, "m"]:
    """Return twice the area of each face."""
    doubled = np.zeros(len(faces))
    for first in range(0, len(faces), _AT_ONCE):
        part = slice(first, first + _AT_ONCE)
        doubled[part] = np.linalg.norm(scaled_normals(vertices[faces[part]]), axis=1)
    return doubled


def pieces(faces: Faces, count: int) -> Int[np.ndarray, "n"]:
    """Return the zero-based index of the connected component of each of ``count`` vertices."""
    from scipy import sparse

    ends = faces[:, [0, 1, 1, 2]].reshape(-1, 2).T.astype(np.int32)
    links = sparse.coo_matrix((np.ones(ends.shape[1], np.int8), ends), shape=(count, count))
    return sparse.csgraph.connected_components(links, directed=False)[1]


def closed(faces: Faces) -> bool:
    """Return whether every edge is used equally often in both directions."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).astype(np.int64)
    radix = int(edges.max()) + 1
    there, back = edges @ [radix, 1], edges @ [1, radix]
    return bool(np.array_equal(np.sort(there), np.sort(back)))
