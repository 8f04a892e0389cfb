"""Fewer triangles for the same shape, and the proof that it is the same."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from jaxtyping import Bool, Float, Int

from ..errors import BackendError
from ..render.scanlines import nearest
from ..scene.triangles import closed
from .pixels import mask_iou

_TRIES = (1, 2, 4)  # times the wanted number of faces
_OVERLAP = 0.97  # least overlap of the silhouettes before and after
_VOLUME = 0.05  # largest change of the volume of closed meshes
_SIDE = 128  # pixels of a silhouette
_AT_ONCE = 100_000  # faces worked on together
_CARE = 3  # of 0 to 10; from 5 on, the rims of cups become jagged

_SIGHTS = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], float)

Vertices = Float[np.ndarray, "n 3"]
Faces = Int[np.ndarray, "m 3"]


def reduce(vertices: Vertices, faces: Faces, maximum: int, what: str) -> tuple[Vertices, Faces]:
    """Return a shape with about ``maximum`` triangles, up to four times as many if it needs them.

    By quadric error. It is held against the shape it was made of: silhouettes from four sides
    overlap by 97 % or more, and the volume of a closed one changes by 5 % at most.

    Raises:
        BackendError: the shape does not survive it.
    """
    before = list(silhouettes(vertices, faces, vertices))
    solid = volume(vertices, faces)
    said = ""
    for times in _TRIES:
        if times * maximum >= len(faces):
            return vertices, faces
        fewer = _simplify(vertices, faces, times * maximum)
        if len(fewer[1]) > _TRIES[-1] * maximum:
            said = f"no fewer than {len(fewer[1])} can hold it"
            continue
        after = silhouettes(*fewer, vertices)
        overlap = min(mask_iou(a, b) for a, b in zip(before, after, strict=True))
        change = abs(volume(*fewer) / solid - 1) if solid else 0.0
        if overlap >= _OVERLAP and change <= _VOLUME:
            return fewer
        said = f"silhouettes overlap by {overlap:.0%}, the volume changes by {change:.0%}"
    raise BackendError(
        f"{what} has {len(faces)} triangles and does not keep its shape with "
        f"{_TRIES[-1] * maximum}: {said}. Reduce it yourself, or allow more (faces)."
    )


def silhouettes(
    vertices: Vertices, faces: Faces, frame: Vertices
) -> Iterator[Bool[np.ndarray, "s s"]]:
    """Yield what a shape covers along four directions, scaled so that ``frame`` fits."""
    for sight in _SIGHTS:
        forward = sight / np.linalg.norm(sight)
        right = np.cross(forward, np.roll(forward, 1) if sight.sum() < 2 else [0.0, 0.0, 1.0])
        right /= np.linalg.norm(right)
        axes = np.stack([right, np.cross(forward, right)])
        flat = frame @ axes.T
        low, span = flat.min(0), float(np.ptp(flat, axis=0).max())
        pixels = (vertices @ axes.T - low) / span * (_SIDE - 2) + 1
        pixels = np.concatenate([pixels, np.ones((len(pixels), 1))], axis=1)
        covered = np.zeros(_SIDE * _SIDE, bool)
        for first in range(0, len(faces), _AT_ONCE):
            corners = pixels[faces[first : first + _AT_ONCE]]
            covered |= nearest(corners, _SIDE, _SIDE)[0] >= 0
        yield covered.reshape(_SIDE, _SIDE)


def volume(vertices: Vertices, faces: Faces) -> float:
    """Return the volume that a closed shape encloses; 0 for an open one."""
    if not closed(faces):
        return 0.0
    centred, total = vertices - vertices.mean(0), 0.0
    for first in range(0, len(faces), _AT_ONCE):
        a, b, c = centred[faces[first : first + _AT_ONCE]].transpose(1, 0, 2)
        total += float(np.einsum("ij,ij->", a, np.cross(b, c)))
    return abs(total) / 6


def _simplify(vertices: Vertices, faces: Faces, count: int) -> tuple[Vertices, Faces]:
    import fast_simplification

    span = float(np.ptp(vertices, axis=0).max())
    made = fast_simplification.simplify(
        vertices / span, faces.astype(np.int32), target_count=count, agg=_CARE
    )
    return np.asarray(made[0], np.float64) * span, np.asarray(made[1], np.int64)
