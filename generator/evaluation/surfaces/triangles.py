"""Triangles in space: nearest points, outward normals of their features, the angle they fill."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int


def nearest_on_triangles(
    points: Float[np.ndarray, "p 3"], corners: Float[np.ndarray, "p 3 3"]
) -> tuple[Float[np.ndarray, "p 3"], Int[np.ndarray, "p"]]:
    """Return the point of each triangle nearest to the point of the same row, and its feature.

    Features: 0 the face, 1 to 3 the edges 01, 12, 20, 4 to 6 the corners. By the regions of the
    triangle's plane that its edges and their normals bound (C. Ericson, "Real-Time Collision
    Detection", 2005, 5.1.5).
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
    """Return for each triangle the outward normals of its face, edges 01, 12, 20 and corners.

    An edge's is the sum of its faces' unit normals, a corner's their sum weighed by their angles.
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
    """Return how often the triangles wind about each point: 1 inside a closed outward surface."""
    a, b, c = (corners[None, :, k] - points[:, None] for k in range(3))
    la, lb, lc = (np.linalg.norm(side, axis=2) for side in (a, b, c))
    volume = _dot(a, np.cross(b, c))
    rest = la * lb * lc + _dot(a, b) * lc + _dot(b, c) * la + _dot(c, a) * lb
    return np.arctan2(volume, rest).sum(1) / (2 * np.pi)


def bisect(corners: Float[np.ndarray, "m 3 3"]) -> Float[np.ndarray, "n 3 3"]:
    """Return every triangle cut in two across the middle of its longest side."""
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
