"""Checked, read-only arrays for frozen values."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..errors import InputError


def frozen_array(
    value: Any, dtype: type[np.generic], shape: tuple[int | None, ...], what: str
) -> np.ndarray:
    """Return a read-only copy of ``value`` with ``dtype``, checked for shape and finiteness.

    ``None`` in ``shape`` accepts any length along that axis.

    Raises:
        InputError: wrong number of axes or length, or a NaN or infinity.
    """
    array = np.array(value, dtype=dtype)
    fits = array.ndim == len(shape) and all(
        want is None or want == have for want, have in zip(shape, array.shape, strict=True)
    )
    if not fits:
        wanted = "×".join("n" if n is None else str(n) for n in shape)
        raise InputError(f"{what} must have shape {wanted}, got {array.shape}.")
    if np.issubdtype(array.dtype, np.floating) and not np.isfinite(array).all():
        raise InputError(f"{what} holds NaN or infinity; every number must be finite.")
    array.setflags(write=False)
    return array


def freeze(instance: object, **arrays: np.ndarray) -> None:
    """Set array fields of a frozen dataclass while it is made."""
    for name, array in arrays.items():
        object.__setattr__(instance, name, array)
