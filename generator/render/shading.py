"""Normals, texture sampling and lighting for the software renderer."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from jaxtyping import Float, Int, UInt8

from ..scene import frozen_array
from ..scene.triangles import scaled_normals, weld_index

_CREASE = np.cos(np.deg2rad(40.0))
_MAX_PAIRS = 64  # maximum mean number of corners per position; solids have about 6
_PIECE = 1 << 20  # number of pairs of corners processed at once


def _unit(v: np.ndarray) -> np.ndarray:
    """Normalise vectors along the last axis, faster than NumPy's norm for short vectors."""
    x, y, z = (v[..., k] for k in range(3))
    length = np.sqrt((x * x + y * y) + z * z)
    return v / np.maximum(length, 1e-12)[..., None]


@dataclass(frozen=True, eq=False)
class Light:
    """A sun and a sky; ``direction`` points towards the sun (normalised on construction).

    ``sun``, ``sky`` and ``gloss`` are intensities; ``softness`` is the width of the shadow edge in
    metres; ``tint`` multiplies the light's colour.
    """

    direction: Float[np.ndarray, "3"] = field(
        default_factory=lambda: np.array([-0.35, -0.45, 0.82])
    )
    sun: float = 0.42
    sky: float = 0.66
    gloss: float = 0.06
    softness: float = 0.018
    tint: tuple[float, float, float] = (1.0, 1.0, 1.0)

    def __post_init__(self) -> None:
        direction = _unit(np.asarray(self.direction, float))
        direction = frozen_array(direction, np.float64, (3,), "Light.direction")
        object.__setattr__(self, "direction", direction)


def corner_normals(
    vertices: Float[np.ndarray, "n 3"], faces: Int[np.ndarray, "m 3"]
) -> Float[np.ndarray, "m 3 3"]:
    """Return a unit normal for each face corner, smoothed across edges of less than 40 degrees.

    Vertices that share a position (texture seams) are smoothed together. If far more faces meet at
    the vertices than in any solid, face normals are used throughout.
    """
    scaled = scaled_normals(vertices[faces])
    flat = _unit(scaled)
    corner = weld_index(vertices)[faces.reshape(-1)]
    order = np.argsort(corner, kind="stable")
    counts = np.bincount(corner)
    starts = np.cumsum(counts) - counts
    repeats = counts[corner]
    pairs = np.cumsum(repeats)
    if pairs[-1] > _MAX_PAIRS * len(corner):
        return np.repeat(flat[:, None], 3, axis=1)
    cuts = np.searchsorted(pairs, np.arange(_PIECE, pairs[-1], _PIECE))
    total = np.empty((len(corner), 3))
    for some in np.split(np.arange(len(corner)), np.unique(cuts)):
        count = repeats[some]
        own = np.repeat(np.arange(len(some)), count)
        offset = np.arange(len(own)) - np.repeat(np.cumsum(count) - count, count)
        right = order[starts[corner[some]][own] + offset]
        alike = (flat[some[own] // 3] * flat[right // 3]).sum(1) > _CREASE
        for k in range(3):
            weights = scaled[right[alike] // 3, k]
            total[some, k] = np.bincount(own[alike], weights, minlength=len(some))
    return _unit(total).reshape(-1, 3, 3)


def interpolate(
    corners: Float[np.ndarray, "p 3 c"], weights: Float[np.ndarray, "3 p"]
) -> Float[np.ndarray, "p c"]:
    """Interpolate values given at the three corners of triangles with the given weights."""
    made = np.empty((len(corners), corners.shape[2]))
    for k in range(corners.shape[2]):
        a, b, c = corners[:, 0, k], corners[:, 1, k], corners[:, 2, k]
        made[:, k] = (a * weights[0] + b * weights[1]) + c * weights[2]
    return made


def sample_texture(
    texture: UInt8[np.ndarray, "th tw 3"], uv: Float[np.ndarray, "p 2"]
) -> Float[np.ndarray, "p 3"]:
    """Sample a texture bilinearly at ``uv`` (v up, clamped to [0, 1]); return values in [0, 1]."""
    height, width = texture.shape[:2]
    x = np.clip(uv[:, 0], 0, 1) * width - 0.5
    y = (1 - np.clip(uv[:, 1], 0, 1)) * height - 0.5
    x0, y0 = np.floor(x).astype(int), np.floor(y).astype(int)
    fx, fy = x - x0, y - y0
    left, right = np.clip(x0, 0, width - 1), np.clip(x0 + 1, 0, width - 1)
    top, bottom = np.clip(y0, 0, height - 1) * width, np.clip(y0 + 1, 0, height - 1) * width
    texels = texture.reshape(-1, 3)
    four = [np.take(texels, i + j, axis=0) for i in (top, bottom) for j in (left, right)]
    color = np.empty((len(uv), 3))
    for k in range(3):
        a, b, c, d = (texel[:, k] for texel in four)
        upper = a * (1 - fx) + b * fx
        lower = c * (1 - fx) + d * fx
        color[:, k] = (upper * (1 - fy) + lower * fy) / 255.0
    return color


def shade(
    albedo: Float[np.ndarray, "p 3"],
    normal: Float[np.ndarray, "p 3"],
    to_camera: Float[np.ndarray, "p 3"],
    lit: Float[np.ndarray, "p"],
    light: Light,
) -> Float[np.ndarray, "p 3"]:
    """Return Lambert shading with a sky and a highlight; ``lit`` is the sun's visible fraction."""
    n, view = _unit(normal), _unit(to_camera)
    n[_dot(n, view) < 0] *= -1
    facing = np.clip(n @ light.direction, 0, 1) * lit
    sky = light.sky * (0.84 + 0.16 * n[:, 2]) * (0.9 + 0.1 * lit)
    half = _unit(view + light.direction)
    gloss = light.gloss * np.clip(_dot(n, half), 0, 1) ** 40 * lit
    matt = sky + light.sun * facing
    color = np.empty((len(albedo), 3))
    for k, tint in enumerate(light.tint):
        color[:, k] = np.clip(albedo[:, k] * matt * tint + gloss, 0, 1)
    return color


def _dot(a: Float[np.ndarray, "p 3"], b: Float[np.ndarray, "p 3"]) -> Float[np.ndarray, "p"]:
    return (a[:, 0] * b[:, 0] + a[:, 1] * b[:, 1]) + a[:, 2] * b[:, 2]
