"""Repair of foreign meshes: loose, duplicate and inside-out triangles, holes, and thin sheets.

The steps are as follows: coincident vertices are merged; slivers, duplicate faces, crumbs and fins
are removed (``clean``); faces are turned outwards; small holes are closed (``fill_holes``). A mesh
with more than 1 % of flawed edges after that is rejected (``check_surface``).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import trimesh
from jaxtyping import Bool, Float, Int
from scipy import sparse
from scipy.sparse.csgraph import connected_components

from ..errors import BackendError
from ..physics.parts import THINNEST
from ..scene.triangles import Faces, Vertices, areas, pieces, weld_index
from .reading.surface import ColoredSurface

_CRUMB = 5e-4  # fraction of the total area below which a loose piece is removed
_SHEET = 0.5  # fraction of faces with a coincident back face, above which a mesh is a sheet
_GAP = 0.2  # maximum length of the rim of a hole to close, as a fraction of the diagonal
_FIN = 0.05  # maximum fraction of the total area in pieces removed at edges of three faces
_FLAWED = 0.01  # maximum fraction of flawed edges
_FLAT = 1e-3  # fraction of the longest side below which a mesh counts as flat


def clean(surface: ColoredSurface, what: str) -> ColoredSurface:
    """Return a surface without slivers, duplicate faces, small loose pieces and fins.

    A crumb is a piece with less than 0.05 % of the area. Fins are attached to edges that two other
    faces share, and have at most 5 % of the area in total. Two faces with the same vertices but
    different colours form an inner wall, and both are removed. If most faces are duplicated in this
    way, the mesh is a sheet, and one face of each pair is kept.

    Raises:
        BackendError: nothing is left, or the surface is flat.
    """
    surface = surface.keep(_sound(surface.vertices, surface.faces, weld_index(surface.vertices)))
    if not len(surface.faces):
        raise BackendError(f"{what} has only zero-area triangles. Export a mesh with faces.")
    used = surface.vertices[surface.faces].reshape(-1, 3)
    extent = np.ptp(used, axis=0)
    if extent.min() < _FLAT * extent.max():
        raise BackendError(f"{what} is flat: its extent is {extent.tolist()}. Give it thickness.")
    return surface


def welded_shape(vertices: Float[np.ndarray, "v 3"], faces: Faces) -> tuple[Vertices, Faces]:
    """Return a shape with coincident vertices merged and unused ones removed."""
    weld = weld_index(vertices)
    used, joined = np.unique(weld[faces], return_inverse=True)
    first = np.unique(weld, return_index=True)[1]
    return np.asarray(vertices, np.float64)[first[used]], joined.reshape(-1, 3)


def tidy(vertices: Vertices, faces: Faces) -> Int[np.ndarray, "k 3"]:
    """Return the faces of a welded shape, cleaned as by ``clean``."""
    return faces[_sound(vertices, faces, np.arange(len(vertices)))]


def inside_out(vertices: Vertices, faces: Faces) -> Bool[np.ndarray, "m"]:
    """Return which faces must be flipped so that all of them face outwards (found by trimesh)."""
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    if mesh.is_watertight and mesh.is_winding_consistent:  # walls of cavities may face inwards
        return np.full(len(faces), mesh.volume < 0)
    trimesh.repair.fix_normals(mesh, multibody=True)
    return (mesh.faces != faces).any(1)


def fill_holes(
    vertices: Vertices, faces: Faces
) -> tuple[Float[np.ndarray, "k 3"], Int[np.ndarray, "j 3"]]:
    """Close holes with a rim of at most a fifth of the diagonal; a bowl's opening stays open.

    Each hole is closed by a fan around its centre, even if holes share a corner; single triangles
    are skipped. The filling in trimesh is not used, since it is limited by the number of a rim's
    vertices and would close open boxes.
    """
    sides, edge, total = _edges(faces)
    rim = total[edge] == 1
    rim &= ~_single_sides(rim)
    start, end = sides[rim].T
    if not len(start):
        return vertices, faces
    rim = _loops(start, end)
    start, end, rim = (found[rim >= 0] for found in (start, end, rim))
    total = np.bincount(rim, np.linalg.norm(vertices[start] - vertices[end], axis=1))
    diagonal = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    small = (total > 0) & (total < _GAP * diagonal)
    chosen = small[rim]
    if not chosen.any():
        return vertices, faces
    number = np.cumsum(small) - 1
    corners = np.bincount(rim)[small]
    middle = [np.bincount(rim, vertices[start, k])[small] / corners for k in range(3)]
    fans = np.column_stack([end[chosen], start[chosen], len(vertices) + number[rim[chosen]]])
    return np.vstack([vertices, np.column_stack(middle)]), np.vstack([faces, fans])


def check_surface(faces: Faces, what: str) -> None:
    """Check that the repaired mesh is a surface.

    At most 1 % of all edges may be flawed. A sound edge joins two consistently oriented faces or
    two such pairs (where objects touch), or belongs to a rim that runs around an opening and meets
    no other rim. All other edges are flawed: those of three or more faces, those of two faces with
    opposite orientations, the rims of single triangles, and rims that meet.

    Raises:
        BackendError: more than 1 % of the edges are flawed.
    """
    torn, uneven = flaws(faces)
    if torn + uneven > _FLAWED:
        raise BackendError(
            f"{what} is not a surface: after repair, {torn:.1%} of its edges have one face, and "
            f"{uneven:.1%} have three or more, or faces of opposite orientation; the limit is "
            f"{_FLAWED:.0%} in total. Merge its vertices, or make it manifold (Blender: Mesh, "
            "Clean Up)."
        )


def flaws(faces: Faces) -> tuple[float, float]:
    """Return the fractions of torn edges and of edges whose faces do not form pairs."""
    sides, edge, total = _edges(faces)
    net = np.abs(np.bincount(edge, np.where(sides[:, 0] < sides[:, 1], 1, -1)))
    uneven = ((total > 2) & (total % 2 == 1)) | ((total == 2) & (net > 0))
    rim = total[edge] == 1
    starts = np.bincount(sides[rim, 0], minlength=int(faces.max()) + 1)
    ends = np.bincount(sides[rim, 1], minlength=int(faces.max()) + 1)
    meeting = (starts != 1) | (ends != 1)
    torn = rim & (_single_sides(rim) | meeting[sides].any(1))
    return float(torn.sum() / len(total)), float(uneven.sum() / len(total))


def _edges(
    faces: Faces,
) -> tuple[Int[np.ndarray, "s 2"], Int[np.ndarray, "s"], Int[np.ndarray, "e"]]:
    """Return the half-edges, the edge of each, and the number of half-edges of each edge."""
    sides = np.concatenate([faces[:, [k, (k + 1) % 3]] for k in range(3)]).astype(np.int64)
    _, edge, total = np.unique(_edge_keys(faces), return_inverse=True, return_counts=True)
    return sides, edge.reshape(-1), total


def _edge_keys(faces: Faces) -> Int[np.ndarray, "s"]:
    """Return a number for each half-edge, equal for half-edges on the same edge."""
    radix = int(faces.max()) + 1
    keys = np.empty((3, len(faces)), np.int64)
    for k in range(3):
        one, other = faces[:, k], faces[:, (k + 1) % 3]
        keys[k] = np.minimum(one, other) * radix + np.maximum(one, other)
    return keys.reshape(-1)


def _sound(vertices: Vertices, faces: Faces, weld: Int[np.ndarray, "n"]) -> Bool[np.ndarray, "m"]:
    """Return which faces to keep, excluding slivers, duplicates, small loose parts and fins."""
    corner = weld[faces]
    kept = np.flatnonzero((corner != np.roll(corner, 1, axis=1)).all(1))
    area = areas(vertices, faces)
    for stays in (_single, _sizable, _finless):
        if len(kept):
            kept = kept[stays(corner[kept], area[kept])]
    sound = np.zeros(len(faces), bool)
    sound[kept] = True
    return sound


def _finless(faces: Faces, area: Float[np.ndarray, "m"]) -> Bool[np.ndarray, "m"]:
    """Return the faces to keep so that no small part is attached to edges shared by three faces."""
    # The faces of a piece are connected by edges of two faces. Pieces with a free rim are removed
    # first, and smaller before larger ones; those that are then attached by sound edges are kept.
    total = np.unique(_edge_keys(faces), return_counts=True)[1]
    odd = (total > 2) & (total % 2 == 1)
    if not odd.any():
        return np.ones(len(faces), bool)
    _, edge, total = _edges(faces)
    owner = np.tile(np.arange(len(faces)), 3)
    order = np.argsort(edge, kind="stable")
    pairs = owner[order[total[edge[order]] == 2]].reshape(-1, 2)
    links = sparse.coo_matrix((np.ones(len(pairs), np.int8), pairs.T), shape=(len(faces),) * 2)
    count, piece = connected_components(links, directed=False)
    area = np.bincount(piece, area)
    free = np.bincount(piece[owner], total[edge] == 1) > 0
    by_piece = np.argsort(piece[owner], kind="stable")
    starts = np.searchsorted(piece[owner][by_piece], np.arange(count + 1))
    gone = np.zeros(count, bool)
    room = _FIN * float(area.sum())
    hanging = np.unique(piece[owner][odd[edge]])
    for k in hanging[np.lexsort((area[hanging], ~free[hanging]))]:
        own = edge[by_piece[starts[k] : starts[k + 1]]]
        if area[k] <= room and ((total[own] > 2) & (total[own] % 2 == 1)).any():
            np.subtract.at(total, own, 1)
            gone[k] = True
            room -= float(area[k])
    return ~gone[piece]


def _single_sides(rim: Bool[np.ndarray, "s"]) -> Bool[np.ndarray, "s"]:
    """Return which half-edges belong to faces with only rim half-edges, as marked by ``rim``."""
    return np.tile(rim.reshape(3, -1).all(0), 3)


def _loops(start: Int[np.ndarray, "k"], end: Int[np.ndarray, "k"]) -> Int[np.ndarray, "k"]:
    """Return the loop to which each rim half-edge belongs, or -1; loops visit each vertex once."""
    ahead: dict[int, list[int]] = {}
    for side, corner in enumerate(start.tolist()):
        ahead.setdefault(corner, []).append(side)
    ends, loop, count = end.tolist(), np.full(len(start), -1), 0
    for first in start.tolist():
        way: list[int] = []
        corners, place = [first], {first: 0}
        while way or ahead.get(first):
            sides = ahead.get(corners[-1])
            if not sides:  # open paths do not belong to any loop
                way.pop()
                del place[corners.pop()]
                continue
            way.append(sides.pop())
            there = ends[way[-1]]
            if there not in place:
                place[there] = len(corners)
                corners.append(there)
                continue
            back = place[there]
            loop[way[back:]] = count
            count += 1
            for corner in corners[back + 1 :]:
                del place[corner]
            del way[back:], corners[back + 1 :]
    return loop


def _single(corner: Faces, _: Float[np.ndarray, "m"]) -> Bool[np.ndarray, "m"]:
    """Return which of the faces with the same vertices to keep."""
    group = _group(np.sort(corner, axis=1))
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


def _group(rows: Int[np.ndarray, "m k"]) -> Int[np.ndarray, "m"]:
    """Return a number for each row, equal for equal rows, in the order of the rows."""
    group = np.zeros(len(rows), np.int64)
    for column in rows.T:
        group = np.unique(group * (int(column.max()) + 1) + column, return_inverse=True)[1]
        group = group.reshape(-1)
    return group


def _sizable(corner: Faces, area: Float[np.ndarray, "m"]) -> Bool[np.ndarray, "m"]:
    """Return which faces belong to a connected piece with sufficient area."""
    piece = pieces(corner, int(corner.max()) + 1)[corner[:, 0]]
    area = np.bincount(piece, area)
    return (area > _CRUMB * area.sum())[piece]


_SHARE = 1.5e-3  # thickness of sheets, as a fraction of the longest side; repair rejects 2/3 of it
_THIN_SHARE = 0.05  # fraction of the longest side below which a thin mesh counts as a sheet
_SAME = 1e-6  # fraction of the longest side up to which both sides of a sheet are merged


def thicken(surface: ColoredSurface) -> tuple[ColoredSurface, float]:
    """Return a thickened sheet and its new thickness, or any other surface unchanged and 0.

    A sheet is thinner, along some direction, than ``physics.parts.THINNEST`` or than 0.15 % of its
    longest side. If it has two sides, they are moved apart along that direction; a single layer
    becomes two layers with a rim.
    """
    used = surface.vertices[np.unique(surface.faces)]
    middle = used.mean(0)
    normal = _normal(used - middle)
    along = (surface.vertices - middle) @ normal
    low, high = float(((used - middle) @ normal).min()), float(((used - middle) @ normal).max())
    longest = float(np.ptp(used, axis=0).max())
    wanted = max(THINNEST, _SHARE * longest)
    if high - low >= min(wanted, _THIN_SHARE * longest):
        return surface, 0.0
    if high - low > _SAME * longest:
        shift = (along - (low + high) / 2) * (wanted / (high - low) - 1)
        return replace(surface, vertices=surface.vertices + shift[:, None] * normal), wanted
    return _extrude(surface, normal * wanted / 2), wanted


def _normal(points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "3"]:
    """Return the direction of least extent, or the axis to which it is nearly parallel, if any."""
    normal = np.linalg.eigh(points.T @ points)[1][:, 0]
    axis = int(np.abs(normal).argmax())
    return np.eye(3)[axis] if abs(normal[axis]) > 1 - 1e-6 else normal


def _extrude(surface: ColoredSurface, half: Float[np.ndarray, "3"]) -> ColoredSurface:
    """Return a layer as two layers, ``half`` above and below it, joined by a rim."""
    count, faces = len(surface.vertices), surface.faces
    sides, owner = _rim(surface)
    if len(faces) and np.cross(*np.diff(surface.vertices[faces[0]], axis=0)) @ half < 0:
        half = -half  # the first layer faces outwards
    a, b = sides.T
    rim = np.concatenate([
        np.column_stack([b, a, a + count]), np.column_stack([b, a + count, b + count]),
    ])  # fmt: skip
    return replace(
        surface,
        vertices=np.concatenate([surface.vertices + half, surface.vertices - half]),
        faces=np.concatenate([faces, faces[:, ::-1] + count, rim]),
        uv=np.concatenate([surface.uv] * 2),
        colors=np.concatenate([surface.colors] * 2),
        picture=np.concatenate([surface.picture, surface.picture, *[surface.picture[owner]] * 2]),
    )


def _rim(surface: ColoredSurface) -> tuple[Int[np.ndarray, "k 2"], Int[np.ndarray, "k"]]:
    """Return the half-edges that belong to only one face, and these faces."""
    sides = np.concatenate([surface.faces[:, [k, (k + 1) % 3]] for k in range(3)]).astype(np.int64)
    welded = np.sort(weld_index(surface.vertices)[sides], axis=1)
    _, edge, total = np.unique(welded, axis=0, return_inverse=True, return_counts=True)
    alone = total[edge.reshape(-1)] == 1
    owner = np.tile(np.arange(len(surface.faces)), 3)
    return sides[alone], owner[alone]
