"""Checked, read-only arrays for frozen values."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..errors import InputError

FARTHEST = 1000.0
"""No place, size or distance of a scene is larger, metres."""

SMALLEST = 1e-6
"""No extent of a thing is smaller, metres."""

ArrayKind = tuple[type[np.generic], tuple[int | None, ...]]
"""A type of numbers and a shape; None is any length."""

VECTOR: ArrayKind = (np.float64, (3,))
POINTS: ArrayKind = (np.float64, (None, 3))
OUTLINE: ArrayKind = (np.float64, (None, 2))
BOX: ArrayKind = (np.float64, (4,))
MASK: ArrayKind = (np.bool_, (None, None))
PICTURE: ArrayKind = (np.uint8, (None, None, 3))


def frozen_array(
    value: Any,
    dtype: type[np.generic],
    shape: tuple[int | None, ...],
    what: str,
    *,
    maximum: float | None = None,
) -> np.ndarray:
    """Return a read-only copy of ``value`` with ``dtype``, checked for shape and finiteness.

    What is such an array already, and a view of no other, needs no copy. ``None`` in ``shape``
    accepts any length along that axis; ``maximum`` bounds the numbers' size.

    Raises:
        InputError: wrong number of axes or length, a NaN or infinity, or a number out of bounds.
    """
    array = value if _is_frozen(value, dtype) else np.array(value, dtype=dtype)
    if array.shape != shape and not _fits(array.shape, shape):
        wanted = "×".join("n" if n is None else str(n) for n in shape)
        raise InputError(f"{what} must have shape {wanted}, got {array.shape}.")
    if array.dtype.kind == "f" and not np.isfinite(array).all():
        raise InputError(f"{what} holds NaN or infinity; every number must be finite.")
    if maximum is not None and array.size and np.abs(array).max() > maximum:
        raise InputError(f"{what} holds numbers beyond {maximum:g}: at most that is simulated.")
    array.setflags(write=False)
    return array


def _is_frozen(value: Any, dtype: type[np.generic]) -> bool:
    return (
        type(value) is np.ndarray
        and value.dtype == dtype
        and value.base is None
        and not value.flags.writeable
    )


def _fits(have: tuple[int, ...], wanted: tuple[int | None, ...]) -> bool:
    return len(have) == len(wanted) and all(
        want is None or want == size for want, size in zip(wanted, have, strict=True)
    )


def freeze(instance: object, maximum: float | None = None, /, **kinds: ArrayKind) -> None:
    """Make fields of a frozen dataclass read-only arrays of such kinds; see ``frozen_array``."""
    for name, (dtype, shape) in kinds.items():
        what = f"{type(instance).__name__}.{name}"
        array = frozen_array(getattr(instance, name), dtype, shape, what, maximum=maximum)
        object.__setattr__(instance, name, array)
