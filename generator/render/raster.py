"""A small software renderer: z-buffer, textures, one shadowed sun, glass. NumPy alone, no GL.

It draws reference images, previews and contact sheets wherever Python runs, always the same bytes
for the same input, and gives depth and instance ids beside the picture.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float, Int, UInt8

from ..geometry import Camera, quaternion_matrix
from ..scene import Mesh
from ..threads import threads
from .backdrop import Backdrop
from .scanlines import nearest, rasterise
from .shading import Light, corner_normals, sample_texture, shade

BACKGROUND = -1
"""Instance id of pixels that show nothing."""

_TAPS = tuple(
    (r * np.cos(t), r * np.sin(t))
    for r, t in [(0.0, 0.0)]
    + [(0.5, np.pi / 2 * (k + 0.25)) for k in range(4)]
    + [(1.0, np.pi / 3 * k) for k in range(6)]
)  # where a soft shadow is sampled, in units of its softness

_PIECE = 1 << 14  # pixels shaded at once: they fit into a processor's cache


@dataclass(frozen=True, eq=False)
class Item:
    """A textured mesh in the world frame (metres) with the id its pixels get (>= 0)."""

    vertices: Float[np.ndarray, "n 3"]
    faces: Int[np.ndarray, "m 3"]
    uv: Float[np.ndarray, "n 2"]
    texture: UInt8[np.ndarray, "th tw 3"]
    id: int = 0
    opacity: float = 1.0


@dataclass(frozen=True, eq=False)
class Rendered:
    """A picture with its depth (metres along the optical axis, inf at nothing) and ids."""

    image: UInt8[np.ndarray, "h w 3"]
    depth: Float[np.ndarray, "h w"]
    ids: Int[np.ndarray, "h w"]


def place(
    mesh: Mesh,
    scale: Float[np.ndarray, "3"],
    position: Float[np.ndarray, "3"],
    quaternion: Float[np.ndarray, "4"],
    id: int = 0,
) -> Item:
    """Scale a canonical mesh to metres and put it at a world pose (wxyz quaternion)."""
    vertices = (mesh.vertices * np.asarray(scale)) @ quaternion_matrix(quaternion).T
    return Item(vertices + position, mesh.faces, mesh.uv, mesh.texture, id, mesh.opacity)


@dataclass(frozen=True, eq=False)
class _Hits:
    """The nearest surface per pixel: item (-1 none), face, barycentric weights, depth."""

    item: Int[np.ndarray, "p"]
    face: Int[np.ndarray, "p"]
    weights: Float[np.ndarray, "p 3"]
    depth: Float[np.ndarray, "p"]


def _trace(items: Sequence[Item], camera: Camera, width: int, height: int) -> _Hits:
    """Find what each pixel of a ``width`` x ``height`` image sees."""
    factor = width / camera.width
    blocks, face_item, face_index = [], [], []
    for k, item in enumerate(items):
        p = camera.to_camera(item.vertices)
        xy = p[:, :2] / np.maximum(p[:, 2:], 1e-6) * camera.focal * factor
        xy += camera.center * factor
        block = np.concatenate([xy, 1.0 / np.maximum(p[:, 2:], 1e-6)], 1)[item.faces]
        ahead = np.flatnonzero((p[item.faces, 2] > 1e-3).all(1))
        blocks.append(block[ahead])
        face_item.append(np.full(len(ahead), k))
        face_index.append(ahead)
    corners = np.concatenate(blocks) if blocks else np.zeros((0, 3, 3))
    owner, weights, near = rasterise(corners, width, height)
    hit = owner >= 0
    item_of, face_of = np.full(len(owner), -1), np.zeros(len(owner), np.int64)
    if hit.any():
        item_of[hit] = np.concatenate(face_item)[owner[hit]]
        face_of[hit] = np.concatenate(face_index)[owner[hit]]
        weights[hit] *= corners[owner[hit], :, 2]  # perspective-correct
        weights[hit] /= weights[hit].sum(1, keepdims=True)
    depth = np.full(len(owner), np.inf)
    depth[hit] = 1.0 / near[hit]
    return _Hits(item_of, face_of, weights, depth)


class _Shadow:
    """Which points the sun sees: an orthographic depth map around the items."""

    def __init__(self, items: Sequence[Item], light: Light, size: int = 1024) -> None:
        forward = -light.direction
        side = np.cross(forward, [0.0, 1.0, 0.0])
        side /= np.linalg.norm(side)
        self._axes = np.stack([side, np.cross(forward, side), forward])
        points = np.concatenate([item.vertices for item in items]) @ self._axes.T
        self._low, high = points.min(0), points.max(0)
        self._scale = (size - 8) / max(float((high - self._low)[:2].max()), 1e-6)
        self._size = size
        blocks = [self._pixels(item.vertices)[item.faces] for item in items if item.opacity >= 1]
        corners = np.concatenate(blocks) if blocks else np.zeros((0, 3, 3))
        self._top = float(high[2]) + 1.0
        corners = np.concatenate([corners[..., :2], self._top - corners[..., 2:]], -1)
        self._map = nearest(corners, size, size)[1]
        self._softness = light.softness

    def _pixels(self, points: np.ndarray) -> np.ndarray:
        p = points @ self._axes.T
        p[:, :2] = (p[:, :2] - self._low[:2]) * self._scale + 4
        return p

    def lit_share(
        self, points: Float[np.ndarray, "p 3"], normals: Float[np.ndarray, "p 3"]
    ) -> Float[np.ndarray, "p"]:
        """Return the lit share of each point in [0, 1]; points off the map are lit."""
        p = self._pixels(points)  # the bias grows with the slope: no surface shades itself
        cosine = np.clip(np.abs(normals @ self._axes[2]), 0.15, 1)
        bias = 0.002 + self._softness * np.sqrt(1 - cosine**2) / cosine * 1.5
        closeness = self._top - p[:, 2] + bias
        reach = max(1.0, self._softness * self._scale)
        total = np.zeros(len(points))
        for dx, dy in _TAPS:
            x, y = (p[:, 0] + dx * reach).astype(np.int64), (p[:, 1] + dy * reach).astype(np.int64)
            on = (x >= 0) & (y >= 0) & (x < self._size) & (y < self._size)
            total += ~on | (closeness >= self._map[np.where(on, y * self._size + x, 0)])
        return total / len(_TAPS)


def _colors(
    items: Sequence[Item], hits: _Hits, camera: Camera, light: Light, shadow: _Shadow | None
) -> Float[np.ndarray, "p 3"]:
    """Shade every hit pixel, on threads; colours are in [0, 1], zero where nothing was hit."""
    color = np.zeros((len(hits.item), 3))

    def paint(item: Item, normals: Float[np.ndarray, "m 3 3"], own: Int[np.ndarray, "k"]) -> None:
        face, w = hits.face[own], hits.weights[own][:, :, None]
        point = (item.vertices[item.faces[face]] * w).sum(1)
        normal = (normals[face] * w).sum(1)
        albedo = sample_texture(item.texture, (item.uv[item.faces[face]] * w).sum(1))
        lit = np.ones(len(own)) if shadow is None else shadow.lit_share(point, normal)
        color[own] = shade(albedo, normal, camera.position - point, lit, light)

    pieces = []
    for k, item in enumerate(items):
        own = np.flatnonzero(hits.item == k)
        if len(own):
            normals = corner_normals(item.vertices, item.faces)
            parts = np.split(own, range(_PIECE, len(own), _PIECE))
            pieces += [(item, normals, part) for part in parts]
    _at_once(paint, pieces)
    return color


def _at_once(work: Callable[..., None], pieces: Sequence[tuple[Any, ...]]) -> None:
    """Do work on pieces, which end with their pixels, on threads.

    Of few pixels, a pool would cost more than it saves.
    """
    if sum(len(piece[-1]) for piece in pieces) <= 2 * _PIECE:
        for piece in pieces:
            work(*piece)
        return
    with ThreadPoolExecutor(threads()) as pool:
        for done in [pool.submit(work, *piece) for piece in pieces]:
            done.result()


def _centers(samples: Int[np.ndarray, "k"], camera: Camera, width: int) -> np.ndarray:
    """Return where the samples of a picture that is ``width`` samples wide lie, in pixels."""
    return (np.stack([samples % width, samples // width], 1) + 0.5) * (camera.width / width)


def _ground_shade(
    hits: _Hits, camera: Camera, width: int, shadow: _Shadow, strength: float
) -> Float[np.ndarray, "p"]:
    """Return the factor by which the shadow on the floor z = 0 darkens the background."""
    factor = np.ones(len(hits.item))

    def darken(part: Int[np.ndarray, "k"]) -> None:
        points = camera.on_plane(_centers(part, camera, width), 0.0)
        seen = np.isfinite(points).all(1)
        up = np.broadcast_to([0.0, 0.0, 1.0], points[seen].shape)
        factor[part[seen]] = 1 - strength * (1 - shadow.lit_share(points[seen], up))

    empty = np.flatnonzero(hits.item < 0)
    _at_once(darken, [(part,) for part in np.split(empty, range(_PIECE, len(empty), _PIECE))])
    return factor


def render(
    items: Sequence[Item],
    camera: Camera,
    *,
    light: Light | None = None,
    background: tuple[int, int, int] = (255, 255, 255),
    supersample: int = 2,
    shadows: bool = True,
    ground_shadow: float = 0.0,
    backdrop: Backdrop | None = None,
) -> Rendered:
    """Draw ``items``, meshes in the world frame, as ``camera`` sees them.

    Items with ``opacity`` below 1 are blended in front. ``supersample`` is samples per pixel and
    axis (1 is fast, 2 or 3 smooth); ``background`` the colour of empty pixels; ``ground_shadow``
    how strongly shadows darken it as if a floor lay at z = 0; ``backdrop`` floor and haze in place
    of it.
    """
    light = light or Light()
    width, height = camera.width * supersample, camera.height * supersample
    solid = [item for item in items if item.opacity >= 1]
    glass = [item for item in items if item.opacity < 1]
    shadow = _Shadow(solid, light) if shadows and solid else None
    hits = _trace(solid, camera, width, height)
    color = _colors(solid, hits, camera, light, shadow)
    empty = hits.item < 0
    color[empty] = np.asarray(background) / 255.0
    if shadow is not None and ground_shadow > 0:
        color *= _ground_shade(hits, camera, width, shadow, ground_shadow)[:, None]
    ids = np.where(empty, BACKGROUND, np.array([i.id for i in solid] + [0])[hits.item])
    depth = hits.depth
    if backdrop is not None:
        behind = np.flatnonzero(empty)
        pixels = _centers(behind, camera, width)
        lit = None if shadow is None else shadow.lit_share
        color[behind], depth[behind] = backdrop.sample(camera, pixels, light, lit)
        ids[behind] = np.where(np.isfinite(depth[behind]), backdrop.id, BACKGROUND)
    if glass:
        layer = _trace(glass, camera, width, height)
        front = np.flatnonzero((layer.item >= 0) & (layer.depth < depth))
        opacity = np.array([i.opacity for i in glass])[layer.item[front]][:, None]
        over = _colors(glass, layer, camera, light, None)[front]
        color[front] = opacity * over + (1 - opacity) * color[front]
        ids[front] = np.array([i.id for i in glass])[layer.item[front]]
        depth = np.where((layer.item >= 0) & (layer.depth < depth), layer.depth, depth)
    return _resolve(color, depth, ids, camera, supersample)


def _resolve(
    color: np.ndarray, depth: np.ndarray, ids: np.ndarray, camera: Camera, samples: int
) -> Rendered:
    """Average the samples' colours; depth and ids are those of one sample near the centre."""
    h, w, s = camera.height, camera.width, samples
    mean = color.reshape(h, s, w, s, 3).mean((1, 3))
    image = np.clip(mean * 255.0 + 0.5, 0, 255).astype(np.uint8)
    pick = (slice(s // 2, None, s), slice(s // 2, None, s))
    return Rendered(
        image,
        depth.reshape(h * s, w * s)[pick].astype(np.float32),
        ids.reshape(h * s, w * s)[pick].astype(np.int32),
    )
