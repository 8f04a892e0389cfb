"""Texturing of a mesh from one picture: visible parts are copied, hidden parts are inferred.

Visible texels get the picture's colours. A hidden texel gets the colour of the mirrored position on
the object if that is visible. Otherwise it gets its own base colour, recoloured like the visible
parts, or else the nearest visible colour.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float, Real, UInt8
from scipy.spatial import KDTree

from ..render.scanlines import nearest
from ..render.shading import corner_normals
from ..scene import Mesh
from ..scene.triangles import Faces, Vertices
from .pixels import nearest_inside
from .projection import Projection
from .shading import Shading, estimate_shading
from .unwrap import Atlas, unwrap

Texels = Float[np.ndarray, "t 3"]
Image = UInt8[np.ndarray, "h w 3"]
Plane = Float[np.ndarray, "4"]  # unit normal and offset

_GRAZING = 0.18  # minimum cosine of visible surfaces; below it, the pixels are too few
_MIRRORED = 0.35  # the same for points whose colour is copied to hidden ones
_PALETTE = 8
_LIKE = 22.0  # maximum difference, in grey levels, between mirrored points of a symmetric object


@dataclass(frozen=True, eq=False)
class SurfacePoints:
    """Points on an object's surface with their unit normals, in the object frame."""

    point: Texels
    normal: Texels

    def at(self, index: np.ndarray) -> SurfacePoints:
        """Return the points at ``index``."""
        return SurfacePoints(self.point[index], self.normal[index])

    def mirror(self, plane: Plane) -> SurfacePoints:
        """Return the points reflected in a plane."""
        n = plane[:3]
        away = (self.point @ n - plane[3])[:, None]
        return SurfacePoints(
            self.point - 2 * away * n, self.normal - 2 * (self.normal @ n)[:, None] * n
        )


def opaque_colors(crop: UInt8[np.ndarray, "h w 4"]) -> tuple[Image, Bool[np.ndarray, "h w"]]:
    """Return the crop's colours, extended over and beyond its translucent edge, and its mask."""
    mask = crop[..., 3] > 127
    core = cv2.erode(mask.astype(np.uint8), np.ones((3, 3), np.uint8), borderValue=0) > 0
    core = core if core.sum() > 16 else mask
    rows, columns = nearest_inside(core)
    return crop[rows, columns, :3], mask


def surface_of(atlas: Atlas, vertices: Vertices) -> SurfacePoints:
    """Return the surface point of each texel of ``atlas``, given the original vertices."""
    placed = vertices[atlas.source]
    corner = placed[atlas.faces[atlas.face]]
    point = (corner * atlas.weights[:, :, None]).sum(1)
    normal = (corner_normals(placed, atlas.faces)[atlas.face] * atlas.weights[:, :, None]).sum(1)
    return SurfacePoints(
        point, normal / np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-9)
    )


@dataclass(frozen=True, eq=False)
class CropView:
    """The camera's view of a mesh; ``near`` is the maximum 1/depth around each crop pixel."""

    projection: Projection
    near: Float[np.ndarray, "h w"]
    size: float

    @classmethod
    def of(cls, vertices: Vertices, faces: Faces, projection: Projection) -> CropView:
        """Return the view of a mesh that is given in the object frame."""
        corners = projection.corners(vertices, faces)
        near = nearest(corners, projection.width, projection.height)[1]
        near = near.reshape(projection.height, projection.width)
        near = cv2.dilate(near, np.ones((3, 3)), borderType=cv2.BORDER_REPLICATE)
        return cls(projection, near, float(np.linalg.norm(np.ptp(vertices, axis=0))))

    def sees(self, surface: SurfacePoints, minimum: float = _GRAZING) -> Bool[np.ndarray, "t"]:
        """Return which points are visible and face the camera at a cosine above ``minimum``."""
        view, pixel = self.projection, np.floor(self.projection.project(surface.point)).astype(int)
        line = view.position - surface.point
        cosine = (surface.normal * line).sum(1) / np.linalg.norm(line, axis=1)
        x, y = pixel[:, 0].clip(0, view.width - 1), pixel[:, 1].clip(0, view.height - 1)
        front = 1.0 / np.maximum(self.near[y, x], 1e-9)
        depth = view.to_camera(surface.point)[:, 2]
        slack = np.minimum(0.012 / np.maximum(cosine, 0.15), 0.06) * self.size
        return (cosine > minimum) & (np.abs(depth - front) < slack)


def sample(
    image: Real[np.ndarray, "h w c"], pixels: Float[np.ndarray, "n 2"]
) -> Float[np.ndarray, "n c"]:
    """Sample an image bilinearly at ``pixels`` (centres at half-integers), clamped to its edge."""
    height, width = image.shape[:2]
    where = np.clip(pixels - 0.5, 0, [width - 1, height - 1])
    low = np.minimum(where.astype(int), [max(width - 2, 0), max(height - 2, 0)])
    (fx, fy), (x, y) = (where - low).T[:, :, None], low.T
    right, below = np.minimum(x + 1, width - 1), np.minimum(y + 1, height - 1)
    upper = image[y, x] * (1 - fx) + image[y, right] * fx
    lower = image[below, x] * (1 - fx) + image[below, right] * fx
    return upper * (1 - fy) + lower * fy


def recolor(base: Texels, seen: Bool[np.ndarray, "t"], colors: Texels) -> tuple[Texels, float]:
    """Transfer the colours of the visible parts to all texels that have the same base colour.

    Base colours are clustered. Each cluster is shifted by the difference between its visible median
    and its base median; clusters without visible texels are shifted half as far as the nearest one
    with some. Also returns the fraction, in [0, 1], of the visible colours' variance that the
    clusters explain.
    """
    group, centers = _palette(base)
    shift = np.zeros_like(centers)
    known = np.zeros(len(centers), bool)
    for k in range(len(centers)):
        own = seen & (group == k)
        known[k] = own.sum() >= 12
        if known[k]:
            shift[k] = np.median(colors[own], 0) - np.median(base[own], 0)
    if not known.any():
        return base, 0.0
    gap = np.linalg.norm(centers[:, None] - centers[None, known], axis=-1)
    shift = np.where(known[:, None], shift, shift[known][gap.argmin(1)] * 0.5)
    painted = np.clip(base + shift[group], 0, 255)
    rest = ((colors[seen] - painted[seen]) ** 2).sum()
    total = ((colors[seen] - colors[seen].mean(0)) ** 2).sum()
    return painted, float(np.clip(1 - rest / max(total, 1e-9), 0, 1))


def _palette(base: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Cluster colours around at most ``_PALETTE`` centres, found by farthest-first search."""
    stride = base[:: max(1, len(base) // 4000)]
    centers = [np.median(stride, 0)]
    gap = np.linalg.norm(stride - centers[0], axis=1)
    while len(centers) < _PALETTE and np.quantile(gap, 0.995) > 28:
        centers.append(stride[int(np.argsort(gap)[int(0.995 * (len(gap) - 1))])])
        gap = np.minimum(gap, np.linalg.norm(stride - centers[-1], axis=1))
    table = np.array(centers)
    return np.asarray(KDTree(table).query(base)[1]), table


def paint(
    vertices: Vertices,
    faces: Faces,
    crop: UInt8[np.ndarray, "h w 4"],
    projection: Projection,
    planes: tuple[Plane, ...],
    size: int = 384,
    sure: bool = True,
) -> tuple[Atlas, UInt8[np.ndarray, "s s 3"]]:
    """Unwrap a mesh (vertices in the object frame) and texture all of it from a single crop.

    ``planes`` are the planes of the object's mirror symmetries. Unless they are ``sure``, those
    that the picture's colours contradict are ignored.
    """
    atlas = unwrap(vertices, faces, size)
    surface = surface_of(atlas, vertices)
    image, _ = opaque_colors(crop)
    sight = CropView.of(vertices, faces, projection)
    if not sure:
        planes = tuple(p for p in planes if agrees(surface, sight, image, p))
    colors = sample(image, projection.project(surface.point))
    shading = estimate_shading(colors, surface.normal, sight.sees(surface))
    colors, known = seen_colors(surface, sight, image, shading, planes)
    return atlas, lay_out(atlas, fill_nearest(surface, known, colors, sight.size))


def agrees(surface: SurfacePoints, sight: CropView, image: Image, plane: Plane) -> bool:
    """Return whether most pairs of a point and its mirror image, both visible, agree in colour."""
    twin = surface.mirror(plane)
    both = sight.sees(surface) & sight.sees(twin)
    if both.sum() < 0.02 * len(both):
        return True
    here, there = (sample(image, sight.projection.project(s.point[both])) for s in (surface, twin))
    return bool(np.median(np.abs(here - there).mean(1)) < _LIKE)


def seen_colors(
    surface: SurfacePoints,
    sight: CropView,
    image: Image,
    shading: Shading,
    planes: tuple[Plane, ...],
) -> tuple[Texels, Bool[np.ndarray, "t"]]:
    """Return the points' unshaded colours from the picture, and which points have a colour.

    A hidden point gets the colour of its mirror image in one of ``planes``, or in two of them in
    turn, if that image is visible.
    """
    colors = np.zeros((len(surface.point), 3))
    known = np.zeros(len(surface.point), bool)
    turns = [(), *((p,) for p in planes)]
    turns += [(p, q) for i, p in enumerate(planes) for q in planes[i + 1 :]]
    for turn in turns:
        todo = np.flatnonzero(~known)
        moved = surface.at(todo)
        for plane in turn:
            moved = moved.mirror(plane)
        hit = sight.sees(moved, _MIRRORED if turn else _GRAZING)
        found = sample(image, sight.projection.project(moved.point[hit]))
        colors[todo[hit]] = shading.remove(found, moved.normal[hit])
        known[todo[hit]] = True
    return colors, known


def fill_nearest(
    surface: SurfacePoints, known: Bool[np.ndarray, "t"], colors: Texels, size: float
) -> Texels:
    """Give unknown points the median colour of nearby known points with similar normals.

    Surfaces that face down get the object's median colour, darkened.
    """
    if known.all() or not known.any():
        return colors
    painted = colors.copy()
    index = np.flatnonzero(known)
    index = index[:: max(1, len(index) // 4000)]
    lost = np.flatnonzero(~known)
    scaled = np.hstack([surface.point, 0.3 * size * surface.normal])
    near = KDTree(scaled[index]).query(scaled[lost], k=min(5, len(index)))[1]
    painted[lost] = np.median(colors[index[near.reshape(len(lost), -1)]], axis=1)
    under = lost[surface.normal[lost, 2] < -0.7]
    painted[under] = np.median(colors[known], 0) * 0.9
    return painted


def lay_out(atlas: Atlas, colors: Texels) -> UInt8[np.ndarray, "s s 3"]:
    """Write texel colours into a texture and spread them over the gutters."""
    texture = np.zeros((atlas.size, atlas.size, 3), np.uint8)
    texture.reshape(-1, 3)[atlas.texel] = np.clip(np.round(colors), 0, 255).astype(np.uint8)
    filled = np.zeros((atlas.size, atlas.size), bool)
    filled.reshape(-1)[atlas.texel] = True
    return texture[nearest_inside(filled)]


def apply_texture(
    atlas: Atlas, vertices: Vertices, texture: UInt8[np.ndarray, "s s 3"], opacity: float = 1.0
) -> Mesh:
    """Return the textured mesh of ``atlas``, given the positions of the original vertices."""
    return Mesh(vertices[atlas.source], atlas.faces, atlas.uv, texture, opacity)
