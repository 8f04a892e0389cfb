"""Loose, doubled and inside-out triangles of a foreign mesh put right, and what cannot be."""

from __future__ import annotations

import numpy as np
import trimesh
from jaxtyping import Bool, Float, Int
from scipy import sparse
from scipy.sparse.csgraph import connected_components

from ...errors import BackendError
from ..embedded.unwrap import welded
from .surface import Surface

_CRUMB = 5e-4  # share of the whole area below which a loose piece is none
_SHEET = 0.5  # share of faces with a back of their own from which a mesh is a doubled sheet
_GAP = 0.2  # of the diagonal: length of rim of the largest hole that is closed
_TORN = 0.5  # share of edges without exactly two faces above which a mesh is no surface
_FLAT = 1e-3  # of the longest side: thinner things are flat

Faces = Int[np.ndarray, "m 3"]


def cleaned(surface: Surface, what: str) -> Surface:
    """Return a surface without slivers, doubled faces and loose crumbs.

    Two faces on the same corners that look apart are an inner wall, and both go; where most faces
    are so doubled, it is a sheet, and one of each stays.

    Raises:
        BackendError: nothing is left, or it is flat.
    """
    weld = welded(surface.vertices)
    corner = weld[surface.faces]
    surface = surface.kept((corner != np.roll(corner, 1, axis=1)).all(1))
    if len(surface.faces):
        surface = surface.kept(_single(weld[surface.faces]))
    if len(surface.faces):
        surface = surface.kept(_sizable(surface, weld[surface.faces]))
    if not len(surface.faces):
        raise BackendError(f"{what} has only triangles without area. Export a mesh with faces.")
    used = surface.vertices[surface.faces].reshape(-1, 3)
    extent = np.ptp(used, axis=0)
    if extent.min() < _FLAT * extent.max():
        raise BackendError(f"{what} is flat: its extent is {extent.tolist()}. Give it thickness.")
    return surface


def welded_shape(
    vertices: Float[np.ndarray, "v 3"], faces: Faces
) -> tuple[Float[np.ndarray, "n 3"], Faces]:
    """Return a shape with vertices at the same place made one, and unused ones left out."""
    weld = welded(vertices)
    used, joined = np.unique(weld[faces], return_inverse=True)
    first = np.unique(weld, return_index=True)[1]
    return np.asarray(vertices, np.float64)[first[used]], joined.reshape(-1, 3)


def inside_out(vertices: Float[np.ndarray, "n 3"], faces: Faces) -> Bool[np.ndarray, "m"]:
    """Return which faces must be turned over so that all look outwards (by trimesh)."""
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    if mesh.is_watertight and mesh.is_winding_consistent:  # a cavity's wall may face inwards
        return np.full(len(faces), mesh.volume < 0)
    trimesh.repair.fix_normals(mesh, multibody=True)
    return (mesh.faces != faces).any(1)


def filled(
    vertices: Float[np.ndarray, "n 3"], faces: Faces
) -> tuple[Float[np.ndarray, "n 3"], Faces]:
    """Close small holes by fans around their middle; a bowl's mouth stays open.

    trimesh's own filling goes by the number of a rim's corners, and puts lids on boxes.
    """
    start, end = _rims(faces)
    if not len(start):
        return vertices, faces
    size = len(vertices)
    links = sparse.coo_matrix((np.ones(len(start)), (start, end)), shape=(size, size))
    count, label = connected_components(links, directed=False)
    rim = label[start]
    length = np.linalg.norm(vertices[start] - vertices[end], axis=1)
    total = np.bincount(rim, length, count)
    ends = np.bincount(start, minlength=size) - np.bincount(end, minlength=size)
    loop = np.bincount(label, np.abs(ends), count) == 0
    diagonal = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    small = loop & (total > 0) & (total < _GAP * diagonal)
    chosen = small[rim]
    if not chosen.any():
        return vertices, faces
    number = np.cumsum(small) - 1
    corners = np.bincount(rim, minlength=count)[small]
    middle = [np.bincount(rim, vertices[start, k], count)[small] / corners for k in range(3)]
    fans = np.column_stack([end[chosen], start[chosen], size + number[rim[chosen]]])
    return np.vstack([vertices, np.column_stack(middle)]), np.vstack([faces, fans])


def check_surface(faces: Faces, what: str) -> None:
    """Refuse what is no surface even after its repair.

    Raises:
        BackendError: most edges do not join two faces.
    """
    counts = np.unique(_edges(faces), return_counts=True)[1]
    torn = float((counts != 2).mean())
    if torn > _TORN:
        raise BackendError(
            f"{what} is no surface: {torn:.0%} of its edges do not join exactly two faces. "
            "Merge its vertices, or make it manifold (Blender: Mesh, Clean Up)."
        )


def _edges(faces: Faces) -> Int[np.ndarray, "k"]:
    """Return one number per side of a face, the same for both directions."""
    ends = np.sort(np.concatenate([faces[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    return ends.astype(np.int64) @ [int(faces.max()) + 1, 1]


def _rims(faces: Faces) -> tuple[Int[np.ndarray, "k"], Int[np.ndarray, "k"]]:
    """Return where the sides begin and end that belong to one face alone."""
    sides = np.concatenate([faces[:, [k, (k + 1) % 3]] for k in range(3)])
    _, index, counts = np.unique(_edges(faces), return_inverse=True, return_counts=True)
    start, end = sides[counts[index.reshape(-1)] == 1].T
    return start, end


def _single(corner: Faces) -> Bool[np.ndarray, "m"]:
    """Tell which faces stay where several have the same corners."""
    group = _grouped(np.sort(corner, axis=1))
    if int(group.max()) + 1 == len(corner):
        return np.ones(len(corner), bool)
    lowest = corner.argmin(1)
    turned = np.take_along_axis(corner, (lowest[:, None] + np.arange(3)) % 3, axis=1)
    way = np.where(turned[:, 1] < turned[:, 2], 1, -1)
    first = np.zeros(len(corner), bool)
    first[np.unique(2 * group + (way > 0), return_index=True)[1]] = True
    both = np.bincount(group[first], minlength=group.max() + 1)[group] > 1
    if both.mean() > _SHEET:
        first[:] = False
        first[np.unique(group, return_index=True)[1]] = True
        return first
    return first & ~both


def _grouped(rows: Int[np.ndarray, "m k"]) -> Int[np.ndarray, "m"]:
    """Return a number for each row, the same for equal ones, in their order."""
    group = np.zeros(len(rows), np.int64)
    for column in rows.T:
        group = np.unique(group * (int(column.max()) + 1) + column, return_inverse=True)[1]
        group = group.reshape(-1)
    return group


def _sizable(surface: Surface, corner: Faces) -> Bool[np.ndarray, "m"]:
    """Tell which faces belong to a connected piece of some size."""
    size = int(corner.max()) + 1
    ends = np.concatenate([corner[:, [0, 1]], corner[:, [1, 2]]]).astype(np.int32)
    links = sparse.coo_matrix((np.ones(len(ends), np.int8), ends.T), shape=(size, size))
    piece = connected_components(links, directed=False)[1][corner[:, 0]]
    a, b, c = surface.vertices[surface.faces].transpose(1, 0, 2)
    area = np.bincount(piece, np.linalg.norm(np.cross(b - a, c - a), axis=1))
    return (area > _CRUMB * area.sum())[piece]
