"""Foreign meshes: a GLB file as one textured mesh of ours, in the file's own units and axes."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int, UInt8

from ..errors import BackendError, InputError
from ..meshes.reading.loading import load_surface
from ..meshes.reading.surface import ColoredSurface
from ..scene import Mesh

MOST_FACES = 400_000
"""Larger meshes are refused."""


def read_glb(raw: bytes, what: str) -> Mesh:
    """Return everything in a GLB file as one mesh, node transforms applied; ``what`` names it.

    Of materials only the base colour counts: a texture if all faces show the same one, otherwise
    each face in one colour. Nothing outside the file is opened.

    Raises:
        InputError: no GLB, a damaged one, one without triangles or with NaN, or a too large one.
    """
    if raw[:4] != b"glTF":
        raise InputError(f"{what} is not a GLB file. Save each object as binary glTF.")
    try:
        surface = load_surface(raw, what, "glb", most_faces=MOST_FACES)
    except BackendError as error:
        raise InputError(str(error)) from error
    if len(surface.pictures) != 1 or (surface.picture != 0).any():
        return _color(surface)
    uv = np.where((surface.uv < 0) | (surface.uv > 1), surface.uv % 1.0, surface.uv)
    return Mesh(surface.vertices, surface.faces, uv, surface.pictures[0])


def _color(surface: ColoredSurface) -> Mesh:
    """Return a mesh whose texture is a palette; each face shows one of its texels."""
    corners = surface.vertices[surface.faces].reshape(-1, 3)
    count = len(surface.faces)
    colors = surface.colors_at(np.arange(count), np.full((count, 3), 1 / 3))
    texture, index = _palette(np.clip(np.round(colors), 0, 255).astype(np.uint8))
    width = texture.shape[1]
    uv = np.column_stack([(index + 0.5) / width, np.full(len(index), 0.5)]).repeat(3, axis=0)
    return Mesh(corners, np.arange(len(corners)).reshape(-1, 3), uv, texture)


def _palette(
    colors: UInt8[np.ndarray, "m 3"],
) -> tuple[UInt8[np.ndarray, "1 k 3"], Int[np.ndarray, "m"]]:
    """Return up to 512 colours as a texture of one row, and each face's column."""
    coarse = (colors >> 5).astype(np.int64) @ [64, 8, 1]
    cells, index = np.unique(coarse, return_inverse=True)
    sums: Float[np.ndarray, "k 3"] = np.zeros((len(cells), 3))
    np.add.at(sums, index, colors)
    mean = sums / np.bincount(index)[:, None]
    return mean.round().astype(np.uint8)[None], index
