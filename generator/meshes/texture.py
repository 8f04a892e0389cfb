"""One texture for a foreign mesh: its own if possible, otherwise one baked from its colours."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from jaxtyping import Float, Int
from scipy.spatial import KDTree

from ..scene import Mesh
from ..scene.triangles import Faces, Vertices, areas, face_normals
from .reading.surface import ColoredSurface
from .reading.textures import MOST_TEXTURE
from .texture_bake import Texels, apply_texture, lay_out
from .unwrap import Atlas, unwrap

_SAMPLES = 60_000  # sample points for finding the nearest triangles, besides one per triangle
_MOST_SAMPLES = 400_000  # maximum number of triangles that are given a sample point each
_AT_ONCE = 100_000  # number of texels per batch
_NEAR = 4  # number of candidate triangles per texel
_FACING = 0.02  # distance penalty for triangles that face away, as a fraction of the diagonal
_ROOM = 40  # minimum number of texels per face, including its gutter, if no faces share a chart
_SLACK = 1e-3  # tolerance for texture coordinates outside [0, 1]


def own_texture(surface: ColoredSurface) -> Mesh | None:
    """Return the surface if one plain colour or unrepeated picture covers it, or else None."""
    used, faces = np.unique(surface.faces, return_inverse=True)
    faces = faces.reshape(-1, 3)
    vertices, uv = surface.vertices[used], surface.uv[used]
    if (surface.picture < 0).all():
        colors = surface.colors[used]
        if np.ptp(colors.astype(int), axis=0).max() > 2:
            return None
        plain = np.broadcast_to(colors[0], (4, 4, 3))
        return Mesh(vertices, faces, np.full((len(used), 2), 0.5), plain, surface.opacity)
    one = (surface.picture == surface.picture[0]).all()
    if not one or uv.min() < -_SLACK or uv.max() > 1 + _SLACK:
        return None
    picture = surface.pictures[surface.picture[0]]
    return Mesh(vertices, faces, uv.clip(0, 1), picture, surface.opacity)


def painted_faces(surface: ColoredSurface, size: int) -> Mesh:
    """Return a surface with all of its materials in one new texture of ``size`` texels per side."""
    atlas = unwrap(surface.vertices, surface.faces, size)
    colors = [surface.colors_at(atlas.face[k], atlas.weights[k]) for k in _chunks(atlas)]
    texture = lay_out(atlas, np.concatenate(colors))
    return apply_texture(atlas, surface.vertices, texture, surface.opacity)


def painted_shape(vertices: Vertices, faces: Faces, surface: ColoredSurface, size: int) -> Mesh:
    """Return a shape textured with the nearest colours of ``surface``, whose faces may differ."""
    atlas = unwrap(vertices, faces, size)
    nearby, normals, colors = Nearby.of(surface), face_normals(vertices, faces), []
    for part in _chunks(atlas):
        face = atlas.face[part]
        point = (vertices[faces[face]] * atlas.weights[part, :, None]).sum(1)
        colors.append(surface.colors_at(*nearby.places(point, normals[face])))
    return apply_texture(atlas, vertices, lay_out(atlas, np.concatenate(colors)), surface.opacity)


def best_size(surface: ColoredSurface, maximum: int, faces: int) -> int:
    """Return the best side, in texels, for a new texture that ``faces`` faces share.

    It is as fine as the source pictures, at least 512 and at most ``maximum``, unless the faces
    need more space.
    """
    sides = [np.sqrt(picture.shape[0] * picture.shape[1]) for picture in surface.pictures]
    size = int(min(maximum, max(512.0, *(2.0 ** round(np.log2(side)) for side in (*sides, 1.0)))))
    while size < MOST_TEXTURE and _ROOM * faces > size * size:
        size *= 2
    return min(size, MOST_TEXTURE)


@dataclass(frozen=True, eq=False)
class Nearby:
    """A surface with a search structure for nearest points.

    ``samples`` are points on the whole surface; ``owner`` and ``normals`` are the face and the unit
    normal of each.
    """

    surface: ColoredSurface
    owner: Int[np.ndarray, "s"]
    samples: Float[np.ndarray, "s 3"]
    normals: Float[np.ndarray, "s 3"]

    @classmethod
    def of(cls, surface: ColoredSurface) -> Nearby:
        """Return a surface with points sampled from it."""
        owner, samples = _spread(surface)
        return cls(surface, owner, samples, face_normals(surface.vertices, surface.faces[owner]))

    @cached_property
    def reach(self) -> float:
        """The distance penalty for triangles that face the opposite way."""
        return _FACING * float(np.linalg.norm(np.ptp(self.samples, axis=0)))

    @cached_property
    def tree(self) -> KDTree:
        """The search tree of the samples, by position and normal."""
        return KDTree(np.hstack([self.samples, self.reach * self.normals]))

    def places(self, point: Texels, normal: Texels) -> tuple[Int[np.ndarray, "t"], Texels]:
        """Return the face nearest to each point, and the barycentric weights of the position on it.

        Among faces at similar distances, one with a similar normal is chosen. This distinguishes
        the two sides of a thin wall.
        """
        near = min(_NEAR, len(self.samples))
        _, found = self.tree.query(np.hstack([point, self.reach * normal]), k=near)
        best = np.full(len(point), np.inf)
        face = np.zeros(len(point), np.int64)
        weights = np.zeros((len(point), 3))
        for sample in np.reshape(found, (len(point), -1)).T:
            at = self.owner[sample]
            place, gap = _closest(point, self.surface.vertices[self.surface.faces[at]])
            gap += self.reach**2 * (1 - (self.normals[sample] * normal).sum(1))
            better = gap < best
            best[better], face[better], weights[better] = gap[better], at[better], place[better]
        return face, weights


def _chunks(atlas: Atlas) -> Iterator[slice]:
    """Yield the texels of an atlas in batches, which limits the memory used."""
    for first in range(0, len(atlas.face), _AT_ONCE):
        yield slice(first, first + _AT_ONCE)


def _spread(surface: ColoredSurface) -> tuple[Int[np.ndarray, "s"], Float[np.ndarray, "s 3"]]:
    """Return points spread by area, and their faces; if faces are few, each has a point."""
    faces = surface.faces
    area = areas(surface.vertices, faces)
    if len(faces) <= _MOST_SAMPLES:
        count = 1 + (area / area.sum() * _SAMPLES).astype(np.int64)
        owner = np.repeat(np.arange(len(faces)), count)
    else:
        steps = (np.arange(_MOST_SAMPLES) + 0.5) / _MOST_SAMPLES
        owner = np.searchsorted(np.cumsum(area) / area.sum(), steps).clip(0, len(faces) - 1)
    first = np.append(True, owner[1:] != owner[:-1])
    u, v = np.random.default_rng(0).random((2, len(owner)))
    over = u + v > 1
    u, v = np.where(over, 1 - u, u), np.where(over, 1 - v, v)
    u[first] = v[first] = 1 / 3
    a, b, c = surface.vertices[faces[owner]].transpose(1, 0, 2)
    return owner, a + u[:, None] * (b - a) + v[:, None] * (c - a)


def _closest(
    point: Texels, triangle: Float[np.ndarray, "t 3 3"]
) -> tuple[Texels, Float[np.ndarray, "t"]]:
    """Return each triangle's approximately nearest point as weights, and its squared distance."""
    # This is the foot of the perpendicular, clamped to the triangle along its sides.
    a, b, c = triangle.transpose(1, 0, 2)
    ab, ac, ap = b - a, c - a, point - a
    d00, d01, d11 = (ab * ab).sum(1), (ab * ac).sum(1), (ac * ac).sum(1)
    d20, d21 = (ap * ab).sum(1), (ap * ac).sum(1)
    area = np.maximum(d00 * d11 - d01 * d01, 1e-30)
    v, w = (d11 * d20 - d01 * d21) / area, (d00 * d21 - d01 * d20) / area
    weights = np.clip(np.column_stack([1 - v - w, v, w]), 0, None)
    weights /= weights.sum(1, keepdims=True)
    foot = (triangle * weights[:, :, None]).sum(1)
    return weights, ((foot - point) ** 2).sum(1)
