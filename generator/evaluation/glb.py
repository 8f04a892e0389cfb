"""Foreign meshes: a GLB file as one textured mesh of ours, in the file's own units and axes."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
import trimesh
from jaxtyping import Float, Int, UInt8
from PIL import Image

from ..backends.modelers.flattening import flattened
from ..backends.modelers.inspection import inspect_glb
from ..errors import BackendError, InputError
from ..scene import Mesh

MOST_FACES = 400_000
"""Larger meshes are refused."""

_MOST_TEXTURE = 2048  # longest side of a texture kept
_GREY = (190, 190, 190)


def read_glb(raw: bytes, what: str) -> Mesh:
    """Return everything in a GLB file as one mesh, node transforms applied.

    Of materials only the base colour counts: a texture if there is one such material, otherwise
    each face in one colour. Nothing outside the file is opened.

    Args:
        raw: the file's content.
        what: how messages call it.

    Raises:
        InputError: no GLB, a damaged one, one without triangles or with NaN, or a too large one.
    """
    if raw[:4] != b"glTF":
        raise InputError(f"{what} is not a GLB file. Save each object as binary glTF.")
    try:
        plain = flattened(raw, inspect_glb(raw, what, MOST_FACES))
    except BackendError as error:
        raise InputError(str(error)) from error
    try:
        loaded = trimesh.load_scene(io.BytesIO(plain), file_type="glb")
        parts = [g for g in loaded.dump() if isinstance(g, trimesh.Trimesh) and len(g.faces)]
    except Exception as error:  # whatever a parser may stumble over in a foreign file
        raise InputError(
            f"{what} cannot be read as GLB ({type(error).__name__}: {error}). Export it again."
        ) from error
    count = sum(len(part.faces) for part in parts)
    if not 0 < count <= MOST_FACES:
        raise InputError(f"{what} has {count} triangles; 1 to {MOST_FACES} are read.")
    for part in parts:
        if part.vertices.shape[1:] != (3,) or part.faces.shape[1:] != (3,):
            raise InputError(f"{what} is damaged: its vertices are no points in space.")
        if not np.isfinite(part.vertices).all():
            raise InputError(f"{what} holds NaN or infinity; every vertex must be finite.")
        if not 0 <= part.faces.min() <= part.faces.max() < len(part.vertices):
            raise InputError(f"{what} is damaged: faces name vertices that are not there.")
    if len(parts) > 1 or _image(parts[0]) is None:
        return _colored(parts)
    try:
        return _textured(parts[0])
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as error:
        raise InputError(f"{what} has a texture that cannot be used ({error}).") from error


def _textured(part: trimesh.Trimesh) -> Mesh:
    image = _image(part).convert("RGB")
    image.thumbnail((_MOST_TEXTURE, _MOST_TEXTURE))
    visual: Any = part.visual
    uv = np.nan_to_num(np.asarray(visual.uv, float))
    uv = np.where((uv < 0) | (uv > 1), uv % 1.0, uv)
    return Mesh(np.asarray(part.vertices), np.asarray(part.faces), uv, np.asarray(image, np.uint8))


def _image(part: trimesh.Trimesh) -> Any:
    """Return the base colour texture of a mesh that has one with places for its vertices."""
    uv = getattr(part.visual, "uv", None)
    material = getattr(part.visual, "material", None)
    image = getattr(material, "baseColorTexture", None) or getattr(material, "image", None)
    return image if image is not None and uv is not None and len(uv) == len(part.vertices) else None


def _colored(parts: list[trimesh.Trimesh]) -> Mesh:
    """Return parts as one mesh whose texture is a palette; each face shows one of its texels."""
    corners = np.concatenate([np.asarray(p.vertices)[p.faces] for p in parts]).reshape(-1, 3)
    texture, index = _palette(np.concatenate([_face_colors(p) for p in parts]))
    width = texture.shape[1]
    uv = np.column_stack([(index + 0.5) / width, np.full(len(index), 0.5)]).repeat(3, axis=0)
    return Mesh(corners, np.arange(len(corners)).reshape(-1, 3), uv, texture)


def _face_colors(part: trimesh.Trimesh) -> UInt8[np.ndarray, "m 3"]:
    try:
        visual: Any = part.visual
        if _image(part) is not None:
            visual = visual.to_color()
            return np.asarray(visual.vertex_colors)[part.faces, :3].mean(1).astype(np.uint8)
        base = getattr(getattr(visual, "material", None), "main_color", None)
        colors = np.asarray(base if base is not None else visual.face_colors, np.uint8)
        return np.broadcast_to(np.atleast_2d(colors)[:, :3], (len(part.faces), 3))
    except Exception:  # foreign materials; the shape is what counts
        return np.broadcast_to(np.array(_GREY, np.uint8), (len(part.faces), 3))


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
