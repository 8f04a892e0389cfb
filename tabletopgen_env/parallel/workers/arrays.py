"""Actions, observations and flags in arrays that processes can share, with a row per slot."""

from __future__ import annotations

import mmap
import os
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from gymnasium import spaces
from jaxtyping import Bool, Float
from numpy.typing import DTypeLike

Take = Callable[[tuple[int, ...], DTypeLike], np.ndarray]
"""A function that returns a zero array of a shape and a dtype: ``numpy.zeros`` or
``SharedBlock.take``.
"""

_LINE = 64  # bytes of a cache line, the alignment of each array


@dataclass(frozen=True, eq=False)
class SlotArrays:
    """Arrays of actions, observations and flags, with one row for each of n slots.

    Attributes:
        actions: next actions, validated and clipped to their space.
        observations: last observations: an array, or a dict of arrays as in their space; strings
            are arrays of type "U".
        rewards, terminated, truncated: results of the last step.
        playing: whether each slot has an episode.
        over: whether the slot's episode is over, so that it must be reset.
    """

    actions: Float[np.ndarray, "n a"]
    observations: Any
    rewards: Float[np.ndarray, "n"]
    terminated: Bool[np.ndarray, "n"]
    truncated: Bool[np.ndarray, "n"]
    playing: Bool[np.ndarray, "n"]
    over: Bool[np.ndarray, "n"]

    def rows(self, part: slice) -> SlotArrays:
        """Return the rows of some slots as views."""
        return SlotArrays(*(_each(lambda a: a[part], getattr(self, f.name)) for f in fields(self)))

    def show(self, k: int, observation: Any) -> None:
        """Write the observation of slot ``k``."""
        if isinstance(self.observations, dict):
            for key, array in self.observations.items():
                array[k] = observation[key]
        else:
            self.observations[k] = observation

    def observe(self) -> Any:
        """Return the observations of all slots as new arrays; strings are returned as tuples."""
        return _each(_copy, self.observations)


def lay_out(take: Take, count: int, observation: spaces.Space, action: spaces.Box) -> SlotArrays:
    """Allocate the arrays of ``count`` slots with the given spaces.

    Raises:
        TypeError: an observation is neither a ``Box`` nor a ``Text``, nor a ``Dict`` of them.
    """

    def take_part(space: spaces.Space) -> np.ndarray:
        if isinstance(space, spaces.Text):
            return take((count,), f"U{space.max_length}")
        if not isinstance(space, spaces.Box):
            raise TypeError(
                f"Observation spaces must be Box or Text, or a Dict of these, not {space}."
            )
        return take((count, *space.shape), space.dtype)

    parts = observation.spaces if isinstance(observation, spaces.Dict) else observation
    flags = [take((count,), np.bool_) for _ in range(4)]
    return SlotArrays(
        take((count, *action.shape), np.float64), _each(take_part, parts),
        take((count,), np.float64), *flags,
    )  # fmt: skip


def _copy(array: np.ndarray) -> Any:
    return tuple(array.tolist()) if array.dtype.kind == "U" else array.copy()


def _each(work: Callable[[Any], Any], part: Any) -> Any:
    """Apply ``work`` to an array, or to each array of a dict."""
    return {k: work(v) for k, v in part.items()} if isinstance(part, dict) else work(part)


class SharedBlock:
    """Memory for arrays shared by several processes, in an open, unnamed file.

    The memory is released however the processes end, and ``/dev/shm``, which is small in
    containers, is not used. Processes that take the same arrays in the same order share their
    memory.

    Args:
        file: the open file, filled with zeros; it may be closed afterwards.
        size: size of the file, bytes.
    """

    def __init__(self, file: int, size: int) -> None:
        self._memory = mmap.mmap(file, size)
        self._end = 0

    def take(self, shape: tuple[int, ...], dtype: DTypeLike) -> np.ndarray:
        """Return the next array."""
        array = np.ndarray(shape, dtype, self._memory, self._end)
        self._end += pad(array.nbytes)
        return array


def open_memory(size: int) -> int:
    """Open an unnamed file of ``size`` zero bytes, in memory if the system supports it."""
    if hasattr(os, "memfd_create"):
        file = os.memfd_create("tabletopgen")
    else:
        with tempfile.TemporaryFile() as opened:
            file = os.dup(opened.fileno())
    os.ftruncate(file, size)
    return file


def pad(size: int) -> int:
    """Return the number of bytes that an array of ``size`` bytes occupies in a block."""
    return -(-size // _LINE) * _LINE
