"""Change a catalogue table to a picture's: its slab's thickness, its corners, which way it faces.

All of it in the canonical unit box, so that the table keeps the size it was built with.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import shapely
from jaxtyping import Bool, Int

from ...scene import ConvexPart, Mesh, Model
from .solids import hull_ring, prism

_LEGROOM = 0.12  # most of the height that the slab takes in the catalogue
_ARC = 8  # segments of a quarter turn


def top_faces(mesh: Mesh) -> Bool[np.ndarray, "m"]:
    """Tell which faces belong to the top: the slab down from the highest horizontal faces."""
    return (mesh.vertices[mesh.faces, 2] > slab_bottom(mesh) - 1e-3).all(1)


def slab_bottom(mesh: Mesh) -> float:
    """Return the height of a canonical table's underside of the top."""
    heights = np.sort(np.unique(np.round(mesh.vertices[:, 2], 4)))[::-1]
    wide = [
        z for z in heights[1:]
        if np.ptp(mesh.vertices[np.abs(mesh.vertices[:, 2] - z) < 1e-3, 0]) > 0.9
    ]  # fmt: skip
    bottom = wide[0] if wide else heights[0]
    return float(max(bottom, 0.5 - _LEGROOM))


def turned_about(model: Model) -> Model:
    """Return a table turned by half a turn."""
    half = np.array([-1.0, -1.0, 1.0])
    m = model.mesh
    parts = tuple(dataclasses.replace(p, vertices=p.vertices * half) for p in model.parts)
    mesh = Mesh(m.vertices * half, m.faces, m.uv, m.texture, m.opacity)
    return dataclasses.replace(model, mesh=mesh, parts=parts)


def with_thickness(model: Model, thickness: float) -> Model:
    """Return a table whose top is ``thickness`` metres thick; legs end where it begins."""
    m, old = model.mesh, slab_bottom(model.mesh)
    new = 0.5 - float(np.clip(thickness / model.size[2], 1e-3, 0.5))

    def moved(points: np.ndarray) -> np.ndarray:
        z = np.interp(points[:, 2], [-0.5, old, 0.5], [-0.5, new, 0.5])
        return np.column_stack([points[:, :2], z])

    parts = tuple(dataclasses.replace(p, vertices=moved(p.vertices)) for p in model.parts)
    mesh = Mesh(moved(m.vertices), m.faces, m.uv, m.texture, m.opacity)
    return dataclasses.replace(model, mesh=mesh, parts=parts)


def with_corners(model: Model, radius: float) -> Model:
    """Return a rectangular table whose top has corners rounded by ``radius`` metres.

    The texture stays where it was on the top.
    """
    m, bottom = model.mesh, slab_bottom(model.mesh)
    top = top_faces(m)
    used: Int[np.ndarray, "k"] = np.unique(m.faces[top])
    level = used[np.abs(m.vertices[used, 2] - 0.5) < 1e-3]
    ones = np.ones((len(level), 1))
    onto = np.linalg.lstsq(np.hstack([m.vertices[level, :2], ones]), m.uv[level], rcond=None)[0]
    length, width = float(model.size[0]), float(model.size[1])
    slab = prism(_rounded(length, width, radius), 1.0)
    vertices = slab.vertices / [length, width, 1.0]
    vertices[:, 2] = bottom + (0.5 - bottom) * vertices[:, 2]
    uv = np.hstack([vertices[:, :2], np.ones((len(vertices), 1))]) @ onto
    low, high = m.uv[used].min(0), m.uv[used].max(0)
    mesh = Mesh(
        np.concatenate([m.vertices, vertices]),
        np.concatenate([m.faces[~top], slab.faces + len(m.vertices)]),
        np.concatenate([m.uv, np.clip(uv, low, high)]),
        m.texture,
        m.opacity,
    )
    ring = np.asarray(hull_ring(_rounded(length, width, radius, 3)).coords)[:-1] / [length, width]
    plate = np.concatenate([np.insert(ring, 2, z, axis=1) for z in (bottom, 0.5)])
    parts = tuple(p for p in model.parts if p.bounds[0, 2] < bottom - 1e-3)
    return dataclasses.replace(model, mesh=_compact(mesh), parts=(ConvexPart(plate), *parts))


def _rounded(length: float, width: float, radius: float, segments: int = _ARC) -> shapely.Polygon:
    """Return a rectangle about the origin with rounded corners."""
    radius = min(radius, 0.499 * length, 0.499 * width)
    x, y = length / 2 - radius, width / 2 - radius
    return shapely.box(-x, -y, x, y).buffer(radius, quad_segs=segments)


def _compact(mesh: Mesh) -> Mesh:
    """Return a mesh without the vertices that no face uses."""
    used, faces = np.unique(mesh.faces, return_inverse=True)
    return Mesh(
        mesh.vertices[used], faces.reshape(-1, 3), mesh.uv[used], mesh.texture, mesh.opacity
    )
