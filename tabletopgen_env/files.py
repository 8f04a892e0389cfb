"""JSON of this package's files, read value by value."""

from __future__ import annotations

from typing import Any, NoReturn


def typed(value: Any, kind: type) -> Any:
    """Return a value that is of exactly this type.

    Raises:
        TypeError: it is of another.
    """
    if type(value) is not kind:
        raise TypeError(f"{value!r} should be of type {kind.__name__}")
    return value


def no_constant(constant: str) -> NoReturn:
    """Refuse NaN and infinities; the ``parse_constant`` of ``json.loads``.

    Raises:
        ValueError: always.
    """
    raise ValueError(f"{constant} is not a finite number")
