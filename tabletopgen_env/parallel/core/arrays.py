"""Helpers for NumPy and torch arrays: namespaces, and functions absent from the array API."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from array_api_compat import array_namespace, device
from jaxtyping import Float

Array = Any
"""A NumPy array or a torch tensor."""


def namespace(array: Array) -> Any:
    """Return the array API namespace of an array; NumPy is returned directly, for speed."""
    return np if isinstance(array, np.ndarray) else array_namespace(array)


def like(values: Float[np.ndarray, "..."], other: Array) -> Array:
    """Convert numbers to an array with the namespace, dtype and device of another array."""
    return namespace(other).asarray(np.array(values), dtype=other.dtype, device=device(other))


def take_rows(values: Array, index: Array) -> Array:
    """Return ``values[w, index[w, g]]`` for (n, k, ...) values and (n, g) indices: (n, g, ...)."""
    xp = namespace(values)
    worlds = xp.arange(values.shape[0], device=device(values))
    return values[worlds[:, None], index]


def apply(matrices: Array, vectors: Array) -> Array:
    """Multiply (..., 3, 3) matrices by (..., 3) vectors."""
    return (matrices @ vectors[..., None])[..., 0]


def wrap(angles: Array) -> Array:
    """Wrap angles (radians) to [-pi, pi)."""
    return (angles + math.pi) % (2 * math.pi) - math.pi


def yaw_of(rotations: Array) -> Array:
    """Return the yaw angles of the rotations' x axes about +z, in radians in [-pi, pi]."""
    return namespace(rotations).atan2(rotations[..., 1, 0], rotations[..., 0, 0])


def squares(vectors: Array) -> Array:
    """Return the squared lengths of (..., 3) vectors."""
    return namespace(vectors).sum(vectors * vectors, axis=-1)
