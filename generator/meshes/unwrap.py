"""Unwrapping: a triangle mesh is cut into charts, which are packed into one square texture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int
from scipy import sparse

from ..render.scanlines import rasterise
from ..scene.triangles import face_normals, weld_index

_GUTTER = 2.0  # number of texels between charts


@dataclass(frozen=True, eq=False)
class Atlas:
    """A mesh with new texture coordinates, and the surface point of each texel.

    ``source`` is the original vertex of each vertex. For each covered texel, ``texel`` is its flat
    index (row 0 at the top), ``face`` is its triangle, and ``weights`` is its barycentric position
    on that triangle.
    """

    source: Int[np.ndarray, "n"]
    faces: Int[np.ndarray, "m 3"]
    uv: Float[np.ndarray, "n 2"]
    size: int
    texel: Int[np.ndarray, "t"]
    face: Int[np.ndarray, "t"]
    weights: Float[np.ndarray, "t 3"]


def _charts(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return each face's chart and dominant direction (0 to 5: -x +x -y +y -z +z)."""
    normal = face_normals(vertices, faces)
    # A slight bias keeps the faces of a 45-degree bevel together.
    axis = np.abs(normal * [1.0, 1.001, 1.002]).argmax(1)
    side = axis * 2 + (np.take_along_axis(normal, axis[:, None], 1)[:, 0] > 0)
    corner = weld_index(vertices)[faces]
    pairs = np.sort(np.concatenate([corner[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    owner = np.tile(np.arange(len(faces)), 3)
    order = np.lexsort((pairs[:, 1], pairs[:, 0]))
    pairs, owner = pairs[order], owner[order]
    same = (pairs[1:] == pairs[:-1]).all(1) & (side[owner[1:]] == side[owner[:-1]])
    links = sparse.coo_matrix(
        (np.ones(same.sum()), (owner[1:][same], owner[:-1][same])), shape=(len(faces),) * 2
    )
    return sparse.csgraph.connected_components(links, directed=False)[1], side


def _pack(sizes: Float[np.ndarray, "c 2"], size: int) -> tuple[float, Float[np.ndarray, "c 2"]]:
    """Return the largest scale at which rectangles fit into a square in rows, and their corners."""
    order = np.argsort(-sizes[:, 1], kind="stable")
    # If there are many charts, the gutters alone may exceed the texture.
    gutter = min(_GUTTER, size / (4.0 * np.ceil(np.sqrt(len(sizes)))))
    scale = float(np.sqrt(size * size / np.maximum((sizes[:, 0] * sizes[:, 1]).sum(), 1e-12)))
    while True:
        corners = np.zeros_like(sizes)
        x = y = shelf = 0.0
        for k in order:
            w, h = sizes[k] * scale + 2 * gutter
            if x + w > size:
                x, y, shelf = 0.0, y + shelf, 0.0
            corners[k] = x + gutter, y + gutter
            x, shelf = x + w, max(shelf, h)
            if w > size:
                y = np.inf
        if y + shelf <= size:
            return scale, corners
        scale *= 0.95


def unwrap(vertices: Float[np.ndarray, "n 3"], faces: Int[np.ndarray, "m 3"], size: int) -> Atlas:
    """Unwrap a mesh: connected faces with similar directions form a chart, projected on a plane.

    ``vertices`` are in true proportions; ``size`` is the texture's side in texels.
    """
    chart, side = _charts(vertices, faces)
    count = int(chart.max()) + 1
    planes = np.array([[1, 2], [0, 2], [0, 1]])[side // 2]
    flat = np.take_along_axis(vertices[faces], planes[:, None, :].repeat(3, 1), axis=2)
    low, high = np.full((count, 2), np.inf), np.full((count, 2), -np.inf)
    np.minimum.at(low, chart, flat.min(1))
    np.maximum.at(high, chart, flat.max(1))
    scale, corner = _pack(high - low, size)
    place = (flat - low[chart][:, None]) * scale + corner[chart][:, None]
    key = np.column_stack([faces.ravel(), np.repeat(chart, 3)])
    kept, index, inverse = np.unique(key, axis=0, return_index=True, return_inverse=True)
    texels = place.reshape(-1, 2)[index]
    triangles = inverse.reshape(-1, 3)
    corners = np.concatenate([texels, np.ones((len(texels), 1))], 1)[triangles]
    owner, weights, _ = rasterise(corners, size, size)
    covered = np.flatnonzero(owner >= 0)
    uv = np.column_stack([texels[:, 0], size - texels[:, 1]]) / size
    return Atlas(kept[:, 0], triangles, uv, size, covered, owner[covered], weights[covered])
