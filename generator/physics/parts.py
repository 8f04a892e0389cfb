"""Convex parts in metres: a model's scaled parts, or a convex decomposition of its mesh."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from ..geometry import convex_outline, inside_margin, quaternion_matrix
from ..scene import ConvexPart, Model, Object, Pose
from ..scene.triangles import Faces, Vertices
from .cover import covering

if TYPE_CHECKING:
    from .decomposition import CutBudget

THINNEST = 4e-4
"""Minimum thickness of a part along an axis, in metres. Parts that are thinner, and sheets that are
thin in any direction, are enlarged about their centre."""

_HAIR = 2e-4  # metres
_ROOM = 1.5e-3  # parts within the widest foot, or at most this far beyond it, are raised, metres


def scale_part(part: ConvexPart, scale: Float[np.ndarray, "3"]) -> ConvexPart:
    """Return a canonical part at ``scale`` in metres, rounded to a micrometre."""
    vertices = part.vertices * scale
    low, high = vertices.min(0), vertices.max(0)
    thin = high - low < THINNEST
    if thin.any():
        side = np.where(vertices > (low + high) / 2, 0.5, -0.5) * THINNEST
        vertices = np.where(thin, (low + high) / 2 + side, vertices)
    spread = np.linalg.svd(vertices - vertices.mean(0), compute_uv=False)
    if spread[-1] < 1e-5:  # a sheet that may be thin in any direction
        grown = np.stack(np.meshgrid(*[(-THINNEST / 2, THINNEST / 2)] * 3), -1).reshape(-1, 3)
        vertices = (vertices[:, None] + grown).reshape(-1, 3)
    return ConvexPart(vertices.round(6), part.kind, part.axis)


def model_parts(
    model: Model, scale: Float[np.ndarray, "3"], budget: CutBudget | None = None
) -> tuple[ConvexPart, ...]:
    """Return the unmodified convex parts of ``model`` at ``scale`` (its extent in metres).

    A mesh without parts is decomposed within a ``budget`` that several meshes share.

    Raises:
        SceneError: the mesh has no parts and cannot be decomposed.
    """
    from .decomposition import decompose

    parts = model.parts or decompose(model.mesh, scale, budget=budget)
    return tuple(scale_part(part, scale) for part in parts)


def body_parts(
    model: Model, scale: Float[np.ndarray, "3"], budget: CutBudget | None = None
) -> tuple[ConvexPart, ...]:
    """Return the collision shape of ``model`` at ``scale``: parts that cover the visual mesh.

    ``budget`` is shared by all meshes that may have to be decomposed.

    Raises:
        SceneError: the mesh has no parts and cannot be decomposed.
    """
    vertices = model.mesh.vertices.astype(np.float64) * scale
    parts = model_parts(model, scale, budget)
    return _cover(_Shape(_digest(parts, vertices, model.mesh.faces), parts, vertices,
                         model.mesh.faces))  # fmt: skip


@dataclass(frozen=True)
class _Shape:
    """Convex parts and the mesh that they should cover, in metres; only ``digest`` is compared."""

    digest: bytes
    parts: tuple[ConvexPart, ...] = field(compare=False)
    vertices: Vertices = field(compare=False)
    faces: Faces = field(compare=False)


def _digest(parts: Sequence[ConvexPart], vertices: Vertices, faces: Faces) -> bytes:
    digest = hashlib.sha256(str([(p.kind, p.axis, len(p.vertices)) for p in parts]).encode())
    for array in (*(p.vertices for p in parts), vertices, faces):
        digest.update(f"{array.shape}{array.dtype}".encode())
        digest.update(array.tobytes())
    return digest.digest()


@lru_cache(maxsize=128)
def _cover(shape: _Shape) -> tuple[ConvexPart, ...]:
    """Return the parts, grown to contain their mesh; objects of equal shape share the result."""
    covered = covering(shape.parts, shape.vertices, shape.faces)
    return on_base([scale_part(part, np.ones(3)) for part in covered])


def on_base(parts: Sequence[ConvexPart]) -> tuple[ConvexPart, ...]:
    """Slightly raise the undersides of parts that are beside the widest part at the bottom.

    The wedges of a mug's wall end at the height of its bottom, so each of them would add contacts
    with the table. These would take most of a simulation step, and are redundant because of the
    bottom's edge.
    """
    low = min(float(part.vertices[:, 2].min()) for part in parts)
    feet = [part.vertices[part.vertices[:, 2] < low + _HAIR / 2, :2] for part in parts]
    widest = max(feet, key=lambda foot: float(np.prod(np.ptp(foot, axis=0))) if len(foot) else 0.0)
    if len(widest) < 3 or np.linalg.matrix_rank(widest - widest[0], 1e-4) < 2:
        return tuple(parts)
    outline, based = convex_outline(widest), []
    for part, foot in zip(parts, feet, strict=True):
        beside = foot is not widest and len(foot) and inside_margin(foot, outline).min() > -_ROOM
        upright = part.kind in ("hull", "box") or (part.kind == "cylinder" and part.axis == 2)
        if beside and upright:  # other parts would no longer be of the same kind
            heights = np.maximum(part.vertices[:, 2], low + _HAIR)
            part = replace(part, vertices=np.column_stack([part.vertices[:, :2], heights]))
        based.append(part)
    return tuple(based)


def lowest(thing: Object) -> float:
    """Return the height of an upright object's lowest collision point, relative to its origin."""
    return min(float(part.vertices[:, 2].min()) for part in thing.parts)


def highest(thing: Object) -> float:
    """Return the height of an upright object's highest collision point, relative to its origin."""
    return max(float(part.vertices[:, 2].max()) for part in thing.parts)


def base(thing: Object, pose: Pose) -> Float[np.ndarray, "n 2"]:
    """Return the world (x, y) of vertices in an object's lowest tenth and of its centre of mass."""
    points = np.concatenate([part.vertices for part in thing.parts])
    cut = points[:, 2].min() + 0.1 * np.ptp(points[:, 2])
    points = np.concatenate([points[points[:, 2] <= cut], thing.com[None]])
    return (points @ quaternion_matrix(pose.quaternion).T)[:, :2] + pose.position[:2]
