"""Simplification of meshes, with a check that their shape is preserved."""

from __future__ import annotations

from collections.abc import Iterator

import cv2
import numpy as np
from jaxtyping import Bool, Float, Int

from ..errors import BackendError
from ..scene.triangles import closed
from .pixels import mask_iou

_TRIES = (1, 2, 4)  # as multiples of the requested number of faces
_OVERLAP = 0.97  # minimum overlap of the silhouettes before and after
_VOLUME = 0.05  # maximum relative change of the volume of closed meshes
_SIDE = 128  # side of a silhouette picture, pixels
_AT_ONCE = 100_000  # number of faces per batch
_CARE = 3  # on a scale of 0 to 10; from 5 on, rims of cups become jagged
_CELLS = 1000, 500, 250  # cells along the longest side; the vertices in a cell are merged
_BITS = 4  # subpixel bits

_SIGHTS = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], float)

Vertices = Float[np.ndarray, "_ 3"]
Faces = Int[np.ndarray, "_ 3"]


def reduce(vertices: Vertices, faces: Faces, maximum: int, what: str) -> tuple[Vertices, Faces]:
    """Return a shape with about ``maximum`` triangles, or up to four times as many where needed.

    The shape is simplified by quadric error and compared with the original: silhouettes from four
    directions must overlap by at least 97 %, and the volume of a closed shape may change by at most
    5 %.

    Raises:
        BackendError: the shape is not preserved.
    """
    before = list(silhouettes(vertices, faces, vertices))
    solid = volume(vertices, faces)
    said = ""
    for times in _TRIES:
        if times * maximum >= len(faces):
            return vertices, faces
        fewer = _simplify(vertices, faces, times * maximum)
        for cells in _CELLS:
            if len(fewer[1]) <= _TRIES[-1] * maximum:
                break
            fewer = _simplify(*cluster(vertices, faces, cells), times * maximum)
        if len(fewer[1]) > _TRIES[-1] * maximum:
            said = "so few triangles cannot represent the mesh"
            continue
        after = silhouettes(*fewer, vertices)
        overlap = min(mask_iou(a, b) for a, b in zip(before, after, strict=True))
        change = abs(volume(*fewer) / solid - 1) if solid else 0.0
        if overlap >= _OVERLAP and change <= _VOLUME:
            return fewer
        said = f"silhouettes overlap by {overlap:.0%}, the volume changes by {change:.0%}"
    raise BackendError(
        f"{what} has {len(faces)} triangles and cannot be simplified to {_TRIES[-1] * maximum} "
        f"without losing its shape: {said}. Simplify the mesh yourself, or allow more triangles "
        "(faces)."
    )


def silhouettes(
    vertices: Vertices, faces: Faces, frame: Vertices
) -> Iterator[Bool[np.ndarray, "s s"]]:
    """Yield the pixels that a shape covers from four directions, scaled so that ``frame`` fits."""
    for sight in _SIGHTS:
        forward = sight / np.linalg.norm(sight)
        right = np.cross(forward, np.roll(forward, 1) if sight.sum() < 2 else [0.0, 0.0, 1.0])
        right /= np.linalg.norm(right)
        axes = np.stack([right, np.cross(forward, right)])
        flat = frame @ axes.T
        low, span = flat.min(0), float(np.ptp(flat, axis=0).max())
        pixels = (vertices @ axes.T - low) / span * (_SIDE - 2) + 1
        yield _cover(pixels, faces)


def _cover(pixels: Float[np.ndarray, "n 2"], faces: Faces) -> Bool[np.ndarray, "s s"]:
    """Return the cells that triangles cover; tiny triangles are represented by their vertices."""
    covered = np.zeros((_SIDE, _SIDE), np.uint8)
    for first in range(0, len(faces), _AT_ONCE):
        corners = pixels[faces[first : first + _AT_ONCE]]
        points = np.clip(np.floor(corners), 0, _SIDE - 1).astype(int).reshape(-1, 2)
        covered[points[:, 1], points[:, 0]] = 1
        large = np.ptp(corners, axis=1).max(1) > 1
        fixed = np.round((corners[large] - 0.5) * 2**_BITS).astype(np.int32)
        for triangle in fixed:
            cv2.fillConvexPoly(covered, triangle, 1, shift=_BITS)
    return covered > 0


def volume(vertices: Vertices, faces: Faces) -> float:
    """Return the volume of a closed shape, or 0 for an open one."""
    if not closed(faces):
        return 0.0
    centred, total = vertices - vertices.mean(0), 0.0
    for first in range(0, len(faces), _AT_ONCE):
        a, b, c = centred[faces[first : first + _AT_ONCE]].transpose(1, 0, 2)
        total += float(np.einsum("ij,ij->", a, np.cross(b, c)))
    return abs(total) / 6


def cluster(vertices: Vertices, faces: Faces, cells: int) -> tuple[Vertices, Faces]:
    """Return a shape in which the vertices in each cell of a grid are merged at their mean.

    Simplification by quadric error fails on evenly subdivided surfaces, since it rejects collapsed
    edges as flipped faces.
    """
    low, span = vertices.min(0), float(np.ptp(vertices, axis=0).max())
    cell = np.floor((vertices - low) / span * cells).astype(np.int64)
    _, owner, count = np.unique(cell, axis=0, return_inverse=True, return_counts=True)
    merged = np.zeros((len(count), 3))
    np.add.at(merged, owner.ravel(), vertices)
    kept = owner.ravel()[faces]
    whole = (kept != np.roll(kept, 1, axis=1)).all(1)
    return merged / count[:, None], kept[whole]


def _simplify(vertices: Vertices, faces: Faces, count: int) -> tuple[Vertices, Faces]:
    import fast_simplification

    if count >= len(faces):
        return vertices, faces
    span = float(np.ptp(vertices, axis=0).max())
    made = fast_simplification.simplify(
        vertices / span, faces.astype(np.int32), target_count=count, agg=_CARE
    )
    return np.asarray(made[0], np.float64) * span, np.asarray(made[1], np.int64)
