"""Strictly typed conversion of JSON values according to the annotations of dataclass fields."""

from __future__ import annotations

import contextlib
import dataclasses
import itertools
import types
import typing
from collections.abc import Mapping, Set
from functools import cache
from typing import Any, Literal, Union, get_args, get_origin

import numpy as np

from ..errors import BundleError

_MOST_INTEGER = 2**64


def arguments(
    kind: type, entry: object, what: str, optional: Set[str] = frozenset(), **written: Any
) -> dict[str, Any]:
    """Return a JSON object as dataclass arguments, with all fields present and of the right types.

    ``what`` is the object's position, for messages: "objects[3]". ``optional`` fields may be
    absent, for example from earlier bundles; they then have their default values. ``written`` maps
    fields that have another type in JSON to that type, or to None if they are never written.

    Raises:
        BundleError: a field is missing, unknown or of another type.
        InputError: a value violates its own constraints.
    """
    hints = {k: hint for k, hint in (_hints(kind) | written).items() if hint is not None}
    return _fields(hints, hints.keys() - optional, entry, what)


def _fields(
    hints: Mapping[str, Any], required: Set[str], entry: object, what: str
) -> dict[str, Any]:
    """Return the fields of a JSON object, which must be known and have the right types."""
    if not isinstance(entry, dict):
        raise BundleError(f"{what} must be a JSON object, not {type(entry).__name__}.")
    values = typing.cast("dict[str, Any]", entry)
    if unknown := sorted(values.keys() - hints.keys()):
        raise BundleError(f"{what} has an unknown field {unknown[0][:80]!r}.")
    if missing := sorted(required - values.keys()):
        raise BundleError(f"{what} has no {missing[0]!r}.")
    return {k: _convert(hints[k], v, f"{what}.{k}") for k, v in values.items()}


def _convert(kind: Any, value: Any, what: str) -> Any:
    """Return a JSON value as ``kind``, the annotation of a dataclass field."""
    origin, inner = get_origin(kind), get_args(kind)
    if kind is Any:
        return value
    if origin in (Union, types.UnionType):
        plain = next(k for k in inner if k is not type(None))
        return None if value is None and type(None) in inner else _convert(plain, value, what)
    if origin is Literal:
        if not any(type(value) is type(known) and value == known for known in inner):
            raise BundleError(
                f"{what} must be one of {', '.join(map(str, inner))}, got {repr(value)[:80]}."
            )
        return value
    if origin is tuple:
        return _tuple(inner, value, what)
    if origin is not None and issubclass(origin, Mapping):
        if not isinstance(value, dict):
            raise BundleError(f"{what} must be a JSON object, not {type(value).__name__}.")
        entries = typing.cast("dict[str, Any]", value).items()
        return {k: _convert(inner[1], v, f"{what}[{k[:40]!r}]") for k, v in entries}
    if getattr(kind, "array_type", None) is np.ndarray:
        return numbers(value, what)
    if dataclasses.is_dataclass(kind):
        make = typing.cast("type[object]", kind)
        hints = _hints(make)
        return make(**_fields(hints, hints.keys() - default_fields(make), value, what))
    return _scalar(kind, value, what)


def numbers(value: object, what: str) -> np.ndarray:
    """Return nested lists of numbers, which must not be ragged, as an array."""
    leaves: list[Any] = typing.cast("list[Any]", value if isinstance(value, list) else [None])
    while {type(leaf) for leaf in leaves} == {list}:
        leaves = list(itertools.chain.from_iterable(leaves))
    # Types are checked first, since in an array of texts each entry is as long as the longest.
    array = None
    if {type(leaf) for leaf in leaves} <= {int, float}:
        with contextlib.suppress(ValueError, OverflowError):
            array = np.array(value, np.float64)
    if array is None:
        raise BundleError(f"{what} must be (nested) lists of numbers.")
    return array


def _tuple(inner: tuple[Any, ...], value: Any, what: str) -> tuple[Any, ...]:
    variadic = len(inner) == 2 and inner[1] is Ellipsis
    values = typing.cast("list[Any]", value) if isinstance(value, list) else None
    if values is None or not (variadic or len(values) == len(inner)):
        raise BundleError(f"{what} must be a list{'' if variadic else f' of {len(inner)}'}.")
    kinds = [inner[0]] * len(values) if variadic else inner
    return tuple(
        _convert(k, v, f"{what}[{i}]") for i, (k, v) in enumerate(zip(kinds, values, strict=True))
    )


def _scalar(kind: type, value: Any, what: str) -> Any:
    if kind is float and type(value) in (int, float) and abs(value) < 1e300:
        return value
    if type(value) is not kind or (kind is int and abs(value) >= _MOST_INTEGER):
        raise BundleError(f"{what} must be {kind.__name__}, not {repr(value)[:80]}.")
    return value


@cache
def _hints(kind: type) -> dict[str, Any]:
    hints = typing.get_type_hints(kind)
    return {field.name: hints[field.name] for field in dataclasses.fields(kind) if field.init}


@cache
def default_fields(kind: type) -> frozenset[str]:
    """Return the names of a dataclass's fields that have default values."""
    empty = dataclasses.MISSING
    return frozenset(
        f.name
        for f in dataclasses.fields(kind)
        if f.init and (f.default is not empty or f.default_factory is not empty)
    )
