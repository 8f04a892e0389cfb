"""JSON of this package's files, read value by value."""

from __future__ import annotations

from typing import Any


def check_type(value: Any, kind: type) -> Any:
    """Return a value that is of exactly this type.

    Raises:
        TypeError: it is of another.
    """
    if type(value) is not kind:
        raise TypeError(f"{value!r} should be of type {kind.__name__}")
    return value
