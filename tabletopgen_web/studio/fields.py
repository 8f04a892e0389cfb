"""Validation of the fields of JSON objects from untrusted sources."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from typing import Any

from generator.errors import InputError, choices, require_known, require_number, require_seed

MOST_SHOWN = 60
"""Maximum number of characters of an invalid value in a message."""

_LARGE = 10**15  # larger numbers overflow to infinity in messages


class Fields:
    """A validating reader of a JSON object's fields; ``end`` rejects fields that were not read.

    Raises:
        InputError: raised by each method if a value has another type or is out of range; the
            message names the field.
    """

    def __init__(self, payload: object, what: str) -> None:
        if not isinstance(payload, Mapping):
            raise InputError(f"{what} must be a JSON object, not {type(payload).__name__}.")
        self._payload: Mapping[str, Any] = payload
        self._what = what
        self._known: set[str] = set()

    def _get(self, name: str) -> Any:
        self._known.add(name)
        return self._payload.get(name)

    def text(self, name: str, max_length: int, *, multiline: bool = False) -> str:
        """Return a string that is neither missing nor blank."""
        found = self.optional_text(name, max_length, multiline=multiline)
        if found is None:
            raise InputError(f"{self._what}: {name} must be a string.")
        return found

    def optional_text(self, name: str, max_length: int, *, multiline: bool = False) -> str | None:
        """Return a string, or None if it is missing or null."""
        found = self._get(name)
        if found is None:
            return None
        _check_text(found, name, max_length, multiline)
        return found

    def seed(self) -> int:
        """Return the field ``seed``, or 0 if it is missing."""
        found = self._get("seed")
        if found is None:
            return 0
        require_seed(found)
        return found

    def number(self, name: str, minimum: float, maximum: float) -> float | None:
        """Return a number, or None if it is missing or null."""
        found = self._get(name)
        if found is None:
            return None
        return _check_number(found, f"{self._what}: {name}", minimum, maximum)

    def choice(self, name: str, known: Collection[str]) -> str:
        """Return the field's value, which must be one of the strings in ``known``."""
        found = self.optional_choice(name, known)
        if found is None:
            raise InputError(f"{self._what}: {name} is missing.{choices('', known)}")
        return found

    def optional_choice(self, name: str, known: Collection[str]) -> str | None:
        """Return one of the strings in ``known``, or None if the field is missing or null."""
        found = self._get(name)
        if found is None:
            return None
        if not isinstance(found, str):
            raise InputError(f"{name} must be a string, not {type(found).__name__}.")
        require_known(found[:MOST_SHOWN], known, f"{self._what}: {name} cannot be")
        return found

    def texts(self, name: str, max_count: int, max_length: int) -> tuple[str, ...]:
        """Return a list of strings, or an empty one if the field is missing."""
        found = self._get(name)
        if found is None:
            return ()
        if not isinstance(found, list) or len(found) > max_count:
            raise InputError(f"{name} must be a list of at most {max_count} strings.")
        for each in found:
            _check_text(each, name, max_length, multiline=False)
        return tuple(found)

    def pair(self, name: str, size: float) -> tuple[float, float] | None:
        """Return two numbers in [-``size``, ``size``], or None if they are missing or null."""
        found = self._get(name)
        if found is None:
            return None
        if not isinstance(found, list) or len(found) != 2:
            raise InputError(f"{name} must be a list of two numbers.")
        first, second = (_check_number(v, f"each number of {name}", -size, size) for v in found)
        return first, second

    def end(self) -> None:
        """Reject fields that were not read."""
        for name in self._payload:
            if name not in self._known:
                hint = choices(name[:MOST_SHOWN], self._known)
                raise InputError(f"{self._what} has no field {name[:MOST_SHOWN]!r}.{hint}")


def _check_text(found: object, name: str, max_length: int, multiline: bool) -> None:
    if not isinstance(found, str):
        raise InputError(f"{name} must be a string, not {type(found).__name__}.")
    if not found.strip():
        raise InputError(f"{name} is empty.")
    if len(found) > max_length:
        raise InputError(f"{name} has {len(found)} characters; the maximum is {max_length}.")
    shown = found.replace("\n", " ").replace("\r", " ").replace("\t", " ") if multiline else found
    if not shown.isprintable():
        raise InputError(f"{name} contains non-printable characters.")


def _check_number(found: object, what: str, minimum: float, maximum: float) -> float:
    shown = found if type(found) in (int, float) else type(found).__name__
    if isinstance(shown, int) and abs(shown) > _LARGE:
        shown = math.inf
    require_number(what, shown, minimum=minimum, maximum=maximum)
    return float(shown)  # type: ignore[arg-type]
