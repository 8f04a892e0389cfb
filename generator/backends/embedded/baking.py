"""Paint a mesh with the pixels of one picture: what the camera saw, and what it must look like.

Visible texels take the picture's colours. Hidden ones take the colour of the mirrored place on the
object where that was seen, else their own base colour recoloured like the parts that were seen,
else the nearest seen colour.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float, Int, UInt8
from scipy import ndimage, spatial

from ...render.raster import rasterise
from ...scene import Mesh
from .projection import Projection
from .unwrap import Atlas, face_normals, unwrap

_GRAZING = 0.13  # cosine below which a surface shows too few pixels to be painted from them
_PALETTE = 8


@dataclass(frozen=True, eq=False)
class Surface:
    """The surface points of an atlas' texels, in the object frame."""

    point: Float[np.ndarray, "t 3"]
    normal: Float[np.ndarray, "t 3"]


def opaque_colors(
    crop: UInt8[np.ndarray, "h w 4"],
) -> tuple[UInt8[np.ndarray, "h w 3"], Bool[np.ndarray, "h w"]]:
    """Return the crop's colours carried over its soft edge and beyond, and its mask."""
    mask = crop[..., 3] > 127
    core = cv2.erode(mask.astype(np.uint8), np.ones((3, 3), np.uint8), borderValue=0) > 0
    core = core if core.sum() > 16 else mask
    rows, columns = ndimage.distance_transform_edt(~core, return_distances=False, return_indices=True)
    return crop[rows, columns, :3], mask


def surface_of(atlas: Atlas, vertices: Float[np.ndarray, "n 3"]) -> Surface:
    """Return where each texel of ``atlas`` lies, given the original vertices' positions."""
    placed = vertices[atlas.source]
    corner = placed[atlas.faces[atlas.face]]
    point = (corner * atlas.weights[:, :, None]).sum(1)
    return Surface(point, face_normals(placed, atlas.faces)[atlas.face])


def visible(
    surface: Surface,
    vertices: Float[np.ndarray, "n 3"],
    faces: Int[np.ndarray, "m 3"],
    projection: Projection,
) -> Bool[np.ndarray, "t"]:
    """Tell which surface points the camera sees well, the mesh itself being the only occluder."""
    corners = projection.corners(vertices, faces)
    owner, _, near = rasterise(corners, projection.width, projection.height)
    near = near.reshape(projection.height, projection.width)
    near = cv2.dilate(near, np.ones((3, 3)), borderType=cv2.BORDER_REPLICATE)
    sight = projection.position - surface.point
    cosine = (surface.normal * sight).sum(1) / np.linalg.norm(sight, axis=1)
    pixel = np.floor(projection.project(surface.point)).astype(int)
    x = pixel[:, 0].clip(0, projection.width - 1)
    y = pixel[:, 1].clip(0, projection.height - 1)
    depth = projection.to_camera(surface.point)[:, 2]
    size = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    front = 1.0 / np.maximum(near[y, x], 1e-9)
    slack = 0.012 * size / np.maximum(cosine, 0.15)
    return (cosine > _GRAZING) & (depth < front + np.minimum(slack, 0.06 * size))


def sample(
    image: UInt8[np.ndarray, "h w c"], pixels: Float[np.ndarray, "n 2"]
) -> Float[np.ndarray, "n c"]:
    """Sample an image bilinearly at ``pixels`` (centres at halves), clamped to its border."""
    height, width = image.shape[:2]
    where = np.clip(pixels - 0.5, 0, [width - 1, height - 1])
    low = np.minimum(where.astype(int), [max(width - 2, 0), max(height - 2, 0)])
    (fx, fy), (x, y) = (where - low).T[:, :, None], low.T
    right, below = np.minimum(x + 1, width - 1), np.minimum(y + 1, height - 1)
    upper = image[y, x] * (1 - fx) + image[y, right] * fx
    lower = image[below, x] * (1 - fx) + image[below, right] * fx
    return upper * (1 - fy) + lower * fy


def recolor(
    base: Float[np.ndarray, "t 3"], seen: Bool[np.ndarray, "t"], colors: Float[np.ndarray, "t 3"]
) -> tuple[Float[np.ndarray, "t 3"], float]:
    """Carry the seen parts' colours over to all texels with the same base colour.

    Base colours are grouped; each group moves by the difference of its seen median to its base
    median (groups never seen move like the nearest one). Also returns how well the groups explain
    the seen colours: the share of their variance, in [0, 1].
    """
    group, centers = _palette(base)
    shift = np.zeros_like(centers)
    known = np.zeros(len(centers), bool)
    for k in range(len(centers)):
        own = seen & (group == k)
        if own.sum() >= 12:
            shift[k] = np.median(colors[own], 0) - np.median(base[own], 0)
            known[k] = True
    if not known.any():
        return base, 0.0
    gap = np.linalg.norm(centers[:, None] - centers[None, known], axis=-1)
    shift = np.where(known[:, None], shift, shift[known][gap.argmin(1)] * 0.5)
    painted = np.clip(base + shift[group], 0, 255)
    rest = ((colors[seen] - painted[seen]) ** 2).sum()
    total = ((colors[seen] - colors[seen].mean(0)) ** 2).sum()
    return painted, float(np.clip(1 - rest / max(total, 1e-9), 0, 1))


def _palette(base: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Group colours around at most ``_PALETTE`` centres found by farthest-first search."""
    stride = base[:: max(1, len(base) // 4000)]
    centers = [np.median(stride, 0)]
    gap = np.linalg.norm(stride - centers[0], axis=1)
    while len(centers) < _PALETTE and np.quantile(gap, 0.995) > 28:
        centers.append(stride[int(np.argsort(gap)[int(0.995 * (len(gap) - 1))])])
        gap = np.minimum(gap, np.linalg.norm(stride - centers[-1], axis=1))
    table = np.array(centers)
    return spatial.cKDTree(table).query(base)[1], table


def mirrored(
    surface: Surface,
    seen: Bool[np.ndarray, "t"],
    planes: tuple[Float[np.ndarray, "4"], ...],
    reach: float,
) -> Int[np.ndarray, "t"]:
    """Return per texel a seen texel at its mirrored place (itself if seen), or -1.

    ``planes`` are (unit normal, offset) in the object frame, tried in order; pairs of them
    compose. ``reach`` is how far the mirrored place may miss the surface.
    """
    match = np.where(seen, np.arange(len(seen)), -1)
    if not seen.any():
        return match
    index = np.flatnonzero(seen)
    weight = 4 * reach
    tree = spatial.cKDTree(np.hstack([surface.point[index], weight * surface.normal[index]]))
    turns = [(p,) for p in planes] + [(p, q) for i, p in enumerate(planes) for q in planes[i + 1 :]]
    for turn in turns:
        todo = np.flatnonzero(match < 0)
        point, normal = surface.point[todo], surface.normal[todo]
        for plane in turn:
            point = point - 2 * (point @ plane[:3] - plane[3])[:, None] * plane[:3]
            normal = normal - 2 * (normal @ plane[:3])[:, None] * plane[:3]
        gap, found = tree.query(np.hstack([point, weight * normal]), distance_upper_bound=2 * reach)
        hit = np.isfinite(gap)
        match[todo[hit]] = index[found[hit]]
    return match


def paint(
    vertices: Float[np.ndarray, "n 3"],
    faces: Int[np.ndarray, "m 3"],
    crop: UInt8[np.ndarray, "h w 4"],
    projection: Projection,
    planes: tuple[Float[np.ndarray, "4"], ...],
    size: int = 384,
) -> tuple[Atlas, UInt8[np.ndarray, "s s 3"]]:
    """Unwrap a mesh (vertices in the object frame) and paint all of it from one crop."""
    atlas = unwrap(vertices, faces, size)
    surface = surface_of(atlas, vertices)
    image, _ = opaque_colors(crop)
    seen = visible(surface, vertices, faces, projection)
    colors = sample(image, projection.project(surface.point))
    painted = fill_hidden(surface, seen, colors, planes, float(np.ptp(vertices, axis=0).max()))
    return atlas, lay_out(atlas, painted)


def fill_hidden(
    surface: Surface,
    seen: Bool[np.ndarray, "t"],
    colors: Float[np.ndarray, "t 3"],
    planes: tuple[Float[np.ndarray, "4"], ...],
    size: float,
) -> Float[np.ndarray, "t 3"]:
    """Return all texels' colours from those seen, by mirroring, then by nearness."""
    if not seen.any():
        return colors
    match = mirrored(surface, seen, planes, 0.02 * size)
    painted = colors[np.maximum(match, 0)]
    lost = np.flatnonzero(match < 0)
    if len(lost):
        index = np.flatnonzero(seen)
        tree = spatial.cKDTree(np.hstack([surface.point[index], 0.3 * size * surface.normal[index]]))
        asked = np.hstack([surface.point[lost], 0.3 * size * surface.normal[lost]])
        near = tree.query(asked, k=min(12, len(index)))[1].reshape(len(lost), -1)
        painted[lost] = np.median(colors[index[near]], axis=1)
        under = lost[surface.normal[lost, 2] < -0.7]
        painted[under] = np.median(colors[seen], 0) * 0.8
    return painted


def lay_out(atlas: Atlas, colors: Float[np.ndarray, "t 3"]) -> UInt8[np.ndarray, "s s 3"]:
    """Write texel colours into a texture and spread them over the gutters."""
    texture = np.zeros((atlas.size * atlas.size, 3), np.uint8)
    texture[atlas.texel] = np.clip(np.round(colors), 0, 255).astype(np.uint8)
    empty = np.ones(atlas.size * atlas.size, bool)
    empty[atlas.texel] = False
    side = (atlas.size, atlas.size)
    rows, columns = ndimage.distance_transform_edt(
        empty.reshape(side), return_distances=False, return_indices=True
    )
    return texture.reshape(*side, 3)[rows, columns]


def textured(
    atlas: Atlas,
    vertices: Float[np.ndarray, "n 3"],
    texture: UInt8[np.ndarray, "s s 3"],
    opacity: float = 1.0,
) -> Mesh:
    """Return the mesh of ``atlas`` with the given positions of the original vertices."""
    return Mesh(vertices[atlas.source], atlas.faces, atlas.uv, texture, opacity)
