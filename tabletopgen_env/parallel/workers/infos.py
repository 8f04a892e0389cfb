"""Infos of many slots in Gymnasium's vector format, and their transfer between processes.

An info is a nested dict whose *leaves* are numbers and other values, mostly strings. The numbers of
slot k, in the order of its leaves, are column k of a shared array. The list of leaves and the other
values are sent only when they have changed, which is rare between steps.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from gymnasium.vector import VectorEnv
from jaxtyping import Float

NUMBERS = 64
"""Maximum number of values per slot in the shared array; further values are sent with each step."""

_KINDS: Mapping[type, type] = {float: float, np.float64: float, int: int, bool: bool}
_FIXED = (str, bytes, type(None), np.generic, *_KINDS)  # types with immutable values
_LARGEST = 2**53  # floats represent integers exactly up to here

Leaf = tuple[tuple[str, ...], type | None]
"""The path of a value in a slot's info, and the value's type if it is a number, otherwise None."""


@dataclass(frozen=True, eq=False)
class InfoChange:
    """A slot's changed info without its numbers: the paths of all leaves, and the other values."""

    slot: int
    leaves: tuple[Leaf, ...]
    others: list[Any]


def merge(count: int, infos: Iterable[tuple[int, dict[str, Any]]]) -> dict[str, Any]:
    """Merge the infos of some of ``count`` slots into Gymnasium's vector format."""
    vector: VectorEnv = VectorEnv()
    vector.num_envs = count
    merged: dict[str, Any] = {}
    for k, info in infos:
        merged = vector._add_info(merged, info, k)
    return merged


class InfoWriter:
    """A writer of the numbers in infos; column k of ``numbers`` belongs to slot ``first`` + k."""

    def __init__(self, numbers: Float[np.ndarray, "m n"], first: int) -> None:
        self._numbers = numbers
        self._first = first
        self._sent: list[InfoChange | None] = [None] * numbers.shape[1]

    def write(self, k: int, info: dict[str, Any]) -> InfoChange | None:
        """Write the numbers in an info to column ``k``; return the other changes, or None."""
        leaves: list[Leaf] = []
        numbers: list[float] = []
        others: list[Any] = []
        _take_apart(info, (), leaves, numbers, others)
        self._numbers[: len(numbers), k] = numbers
        change, sent = InfoChange(self._first + k, tuple(leaves), others), self._sent[k]
        if sent is not None and sent.leaves == change.leaves and _same(sent.others, others):
            return None
        self._sent[k] = change
        return change


class InfoReader:
    """A reader of the infos that ``InfoWriter`` objects have written and sent."""

    def __init__(self, numbers: Float[np.ndarray, "m n"]) -> None:
        self._numbers = numbers
        self._known: list[InfoChange | None] = [None] * numbers.shape[1]
        self._form: dict[str, Any] | None = None

    def take(self, changes: Iterable[InfoChange]) -> None:
        """Apply the changes."""
        for change in changes:
            self._known[change.slot] = change
            self._form = None

    def read(self, slots: Iterable[int]) -> dict[str, Any]:
        """Return the merged infos of some slots."""
        return merge(len(self._known), ((k, self._read_one(k)) for k in slots))

    def read_all(self) -> dict[str, Any]:
        """Return the merged infos of all slots."""
        if self._form is None:
            infos = self.read(range(len(self._known)))
            alike = len({change and change.leaves for change in self._known}) == 1
            if not alike:
                return infos
            self._form = self._form_of(infos)
        return _fill(self._form, self._numbers)

    def _read_one(self, k: int) -> dict[str, Any]:
        """Return the info of slot ``k``."""
        change = self._known[k]
        assert change is not None
        numbers, others = iter(self._numbers[:, k].tolist()), iter(change.others)
        info: dict[str, Any] = {}
        for path, kind in change.leaves:
            value = next(others) if kind is None else kind(next(numbers))
            _inner(info, path)[path[-1]] = value
        return info

    def _form_of(self, infos: dict[str, Any]) -> dict[str, Any]:
        """Return the structure of infos, with arrays of numbers replaced by their row and type."""
        change = self._known[0]
        assert change is not None
        numbers = [(path, kind) for path, kind in change.leaves if kind is not None]
        for row, (path, kind) in enumerate(numbers):
            _inner(infos, path)[path[-1]] = row, kind
        return infos


def _take_apart(
    info: Mapping[str, Any],
    path: tuple[str, ...],
    leaves: list[Leaf],
    numbers: list[float],
    others: list[Any],
) -> None:
    """Append the paths (below ``path``), numbers and other values of an info to the three lists."""
    for key, value in info.items():
        kind = _KINDS.get(type(value))
        exact = kind is not int or abs(value) <= _LARGEST
        if kind is not None and exact and len(numbers) < NUMBERS:
            numbers.append(value)
        elif isinstance(value, dict) and value and key != "final_obs":
            _take_apart(value, (*path, key), leaves, numbers, others)
            continue
        else:
            kind = None
            others.append(value)
        leaves.append(((*path, key), kind))


def _inner(info: dict[str, Any], path: Sequence[str]) -> dict[str, Any]:
    """Return the dict that holds the leaf at a path, creating it if it is missing."""
    for key in path[:-1]:
        info = info.setdefault(key, {})
    return info


def _same(before: Sequence[Any], after: Sequence[Any]) -> bool:
    """Return whether values are certainly equal and cannot have been changed in place."""
    return len(before) == len(after) and all(map(_equal, before, after))


def _equal(a: Any, b: Any) -> bool:
    if type(a) is not type(b):
        return False
    if isinstance(a, tuple):
        return _same(a, b)
    return isinstance(a, _FIXED) and bool(a == b)


def _fill(form: dict[str, Any], numbers: Float[np.ndarray, "m n"]) -> dict[str, Any]:
    """Return infos of the given structure, with new arrays filled with the current numbers."""
    filled: dict[str, Any] = {}
    for key, part in form.items():
        if isinstance(part, dict):
            filled[key] = _fill(part, numbers)
        elif isinstance(part, tuple):
            row, kind = part
            filled[key] = numbers[row].astype(kind)
        else:
            filled[key] = part.copy()
    return filled
