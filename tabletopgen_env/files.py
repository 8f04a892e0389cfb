"""Type checks for values of this package's JSON files."""

from __future__ import annotations

from typing import Any


def check_type(value: Any, kind: type) -> Any:
    """Check that a value is of exactly this type, and return the value.

    Raises:
        TypeError: the value has another type.
    """
    if type(value) is not kind:
        raise TypeError(f"{value!r} should be of type {kind.__name__}")
    return value
