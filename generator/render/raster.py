"""A small NumPy renderer without OpenGL: z-buffer, textures, sun with shadows, and glass.

It draws reference images, previews and contact sheets on any machine that runs Python, with
identical bytes for identical input, and returns depth and instance ids with the picture.
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
from .scanlines import barycentric, nearest
from .shading import Light, corner_normals, interpolate, sample_texture, shade
from .shadow import Shadow

BACKGROUND = -1
"""Instance id of empty pixels."""

_PIECE = 1 << 14  # number of pixels shaded at once, chosen to fit into the processor's cache


@dataclass(frozen=True, eq=False)
class Item:
    """A textured mesh in the world frame (metres) with the id of its pixels (>= 0)."""

    vertices: Float[np.ndarray, "n 3"]
    faces: Int[np.ndarray, "m 3"]
    uv: Float[np.ndarray, "n 2"]
    texture: UInt8[np.ndarray, "th tw 3"]
    id: int = 0
    opacity: float = 1.0


@dataclass(frozen=True, eq=False)
class Rendered:
    """A picture with depth (metres along the optical axis, inf in empty pixels) and ids."""

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
    """Scale a canonical mesh to metres and place it at a world pose (wxyz quaternion)."""
    vertices = (mesh.vertices * np.asarray(scale)) @ quaternion_matrix(quaternion).T
    return Item(vertices + position, mesh.faces, mesh.uv, mesh.texture, id, mesh.opacity)


@dataclass(frozen=True, eq=False)
class _Hits:
    """Surfaces hit by the samples of a picture; ``pixel`` contains the sorted sample indices.

    Each hit has an item, a face and barycentric weights. ``depth`` covers all samples and is inf
    where there is no hit.
    """

    pixel: Int[np.ndarray, "k"]
    item: Int[np.ndarray, "k"]
    face: Int[np.ndarray, "k"]
    weights: Float[np.ndarray, "3 k"]
    depth: Float[np.ndarray, "p"]


def _trace(items: Sequence[Item], camera: Camera, width: int, height: int) -> _Hits:
    """Return the surfaces hit by the samples of a ``width`` x ``height`` image."""
    factor = width / camera.width
    blocks, face_item, face_index = [], [], []
    for k, item in enumerate(items):
        p = camera.to_camera(item.vertices)
        xy = p[:, :2] / np.maximum(p[:, 2:], 1e-6) * camera.focal * factor
        xy += camera.center * factor
        block = np.concatenate([xy, 1.0 / np.maximum(p[:, 2:], 1e-6)], 1)[item.faces]
        ahead = np.flatnonzero((p[item.faces, 2] > 1e-3).all(1))
        blocks.append(block[ahead])
        face_item.append(np.full(len(ahead), k, np.min_scalar_type(len(items))))
        face_index.append(ahead)
    depth = np.full(width * height, np.inf)
    if not blocks:
        none = np.zeros(0, np.int64)
        return _Hits(none, none, none, np.zeros((3, 0)), depth)
    corners = np.concatenate(blocks)
    owner, near = nearest(corners, width, height)
    pixel = np.flatnonzero(owner >= 0)
    triangle = owner[pixel]
    weights = barycentric(corners[..., :2], triangle, pixel, width)
    for k in range(3):
        weights[k] *= corners[:, k, 2][triangle]  # perspective-correct
    weights /= (weights[0] + weights[1]) + weights[2]
    depth[pixel] = 1.0 / near[pixel]
    item_of, face_of = np.concatenate(face_item)[triangle], np.concatenate(face_index)[triangle]
    return _Hits(pixel, item_of, face_of, weights, depth)


def _colors(
    items: Sequence[Item], hits: _Hits, camera: Camera, light: Light, shadow: Shadow | None
) -> Float[np.ndarray, "3 k"]:
    """Shade all hits in parallel threads; colours are in [0, 1]."""
    color = np.empty((3, len(hits.item)))

    def paint(item: Item, normals: Float[np.ndarray, "m 3 3"], own: Int[np.ndarray, "k"]) -> None:
        face, w = hits.face[own], np.take(hits.weights, own, axis=1)
        corner = np.take(item.faces, face, axis=0)  # faster than indexing with arrays
        point = interpolate(np.take(item.vertices, corner, axis=0), w)
        normal = interpolate(np.take(normals, face, axis=0), w)
        albedo = sample_texture(item.texture, interpolate(np.take(item.uv, corner, axis=0), w))
        lit = np.ones(len(own)) if shadow is None else shadow.lit_share(point, normal)
        shaded = shade(albedo, normal, camera.position - point, lit, light)
        for k in range(3):
            color[k, own] = shaded[:, k]

    pieces = []
    order = np.argsort(hits.item, kind="stable")
    counts = np.bincount(hits.item, minlength=len(items))
    for item, end, count in zip(items, np.cumsum(counts), counts, strict=True):
        if count:
            own = order[end - count : end]
            normals = corner_normals(item.vertices, item.faces)
            parts = np.split(own, range(_PIECE, len(own), _PIECE))
            pieces += [(item, normals, part) for part in parts]
    _at_once(paint, pieces)
    return color


def _at_once(work: Callable[..., None], pieces: Sequence[tuple[Any, ...]]) -> None:
    """Call ``work(*piece)`` in parallel for each piece, whose last item is an array of pixels.

    If there are few pixels, starting a pool would cost more time than it saves.
    """
    if sum(len(piece[-1]) for piece in pieces) <= 2 * _PIECE:
        for piece in pieces:
            work(*piece)
        return
    with ThreadPoolExecutor(threads()) as pool:
        for done in [pool.submit(work, *piece) for piece in pieces]:
            done.result()


def _centers(samples: Int[np.ndarray, "k"], camera: Camera, width: int) -> np.ndarray:
    """Return the pixel positions of the samples of a picture that is ``width`` samples wide."""
    return (np.stack([samples % width, samples // width], 1) + 0.5) * (camera.width / width)


def _shade_ground(
    color: Float[np.ndarray, "3 p"],
    empty: Int[np.ndarray, "k"],
    camera: Camera,
    width: int,
    shadow: Shadow,
    strength: float,
) -> None:
    """Darken empty samples where shadows fall on the floor z = 0."""

    def darken(part: Int[np.ndarray, "k"]) -> None:
        points = camera.on_plane(_centers(part, camera, width), 0.0)
        seen = np.isfinite(points[:, 2])
        if not seen.all():
            part, points = part[seen], points[seen]
        lit = shadow.lit_share(points, np.broadcast_to([0.0, 0.0, 1.0], points.shape))
        dark = np.flatnonzero(lit < 1)
        factor = 1 - strength * (1 - lit[dark])
        for channel in color:
            channel[part[dark]] *= factor

    _at_once(darken, [(part,) for part in np.split(empty, range(_PIECE, len(empty), _PIECE))])


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
    """Draw ``items``, which are meshes in the world frame, as seen by ``camera``.

    Items with an ``opacity`` below 1 are blended with what is behind them. ``supersample`` is the
    number of samples per pixel along each axis (1 is fast; 2 or 3 gives smooth edges).
    ``background`` is the colour of empty pixels, and ``ground_shadow`` the strength of the shadows
    in them, which are cast on a floor at z = 0. ``backdrop`` draws a floor and haze instead of the
    background.
    """
    light = light or Light()
    width, height = camera.width * supersample, camera.height * supersample
    solid = [item for item in items if item.opacity >= 1]
    glass = [item for item in items if item.opacity < 1]
    shadow = None
    if shadows and solid:
        points = np.concatenate([item.vertices for item in solid])
        shadow = Shadow(points, [(item.vertices, item.faces) for item in solid], light)
    hits = _trace(solid, camera, width, height)
    depth = hits.depth
    color = np.repeat(np.asarray(background)[:, None] / 255.0, len(depth), axis=1)
    ids = np.full(len(depth), BACKGROUND)
    _lay(color, hits.pixel, _colors(solid, hits, camera, light, shadow))
    ids[hits.pixel] = np.array([i.id for i in solid], int)[hits.item]
    empty = np.flatnonzero(np.isinf(depth))
    if shadow is not None and ground_shadow > 0:
        _shade_ground(color, empty, camera, width, shadow, ground_shadow)
    if backdrop is not None:
        pixels = _centers(empty, camera, width)
        lit = None if shadow is None else shadow.lit_share
        behind, depth[empty] = backdrop.sample(camera, pixels, light, lit)
        _lay(color, empty, behind.T)
        ids[empty] = np.where(np.isfinite(depth[empty]), backdrop.id, BACKGROUND)
    if glass:
        layer = _trace(glass, camera, width, height)
        front = np.flatnonzero(layer.depth[layer.pixel] < depth[layer.pixel])
        pixel, of = layer.pixel[front], layer.item[front]
        opacity = np.array([i.opacity for i in glass])[of]
        over = _colors(glass, layer, camera, light, None)[:, front]
        _lay(color, pixel, opacity * over + (1 - opacity) * color[:, pixel])
        ids[pixel] = np.array([i.id for i in glass])[of]
        depth[pixel] = layer.depth[pixel]
    return _resolve(color, depth, ids, camera, supersample)


def _lay(
    color: Float[np.ndarray, "3 p"], samples: Int[np.ndarray, "k"], new: Float[np.ndarray, "3 k"]
) -> None:
    """Write the colours ``new`` of ``samples`` into ``color``, channel by channel."""
    for channel, values in zip(color, new, strict=True):
        channel[samples] = values


def _resolve(
    color: Float[np.ndarray, "3 p"],
    depth: Float[np.ndarray, "p"],
    ids: Int[np.ndarray, "p"],
    camera: Camera,
    samples: int,
) -> Rendered:
    """Average the samples' colours; take depth and ids from one sample near the pixel's centre."""
    h, w, s = camera.height, camera.width, samples
    image = np.empty((h, w, 3), np.uint8)
    for k, channel in enumerate(color):
        grid = channel.reshape(h, s, w, s)
        total = sum(grid[:, i, :, j] for i in range(s) for j in range(s))
        image[..., k] = np.clip(total / s**2 * 255.0 + 0.5, 0, 255)
    pick = (slice(s // 2, None, s), slice(s // 2, None, s))
    return Rendered(
        image,
        depth.reshape(h * s, w * s)[pick].astype(np.float32),
        ids.reshape(h * s, w * s)[pick].astype(np.int32),
    )
