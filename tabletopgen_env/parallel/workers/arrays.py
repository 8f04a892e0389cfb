"""What slots are told and what they show, a row a slot, in arrays that processes can share."""

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
"""Returns an array of a shape and a type, all zeros: ``numpy.zeros``, or ``SharedBlock.take``."""

_LINE = 64  # bytes of a cache line, at which each array begins


@dataclass(frozen=True, eq=False)
class SlotArrays:
    """Rows of n slots.

    Attributes:
        actions: what they are to do next; sound, clipped to their space.
        observations: what they saw last: an array, or a dict of them as their space; of texts an
            array of type "U".
        rewards, terminated, truncated: what their last step gave.
        playing: whether they have an episode.
        over: whether their episode is over, so that they are to be reset.
    """

    actions: Float[np.ndarray, "n a"]
    observations: Any
    rewards: Float[np.ndarray, "n"]
    terminated: Bool[np.ndarray, "n"]
    truncated: Bool[np.ndarray, "n"]
    playing: Bool[np.ndarray, "n"]
    over: Bool[np.ndarray, "n"]

    def rows(self, part: slice) -> SlotArrays:
        """Return the rows of some slots; they are the same memory."""
        return SlotArrays(*(_each(lambda a: a[part], getattr(self, f.name)) for f in fields(self)))

    def show(self, k: int, observation: Any) -> None:
        """Write down what slot ``k`` sees."""
        if isinstance(self.observations, dict):
            for key, array in self.observations.items():
                array[k] = observation[key]
        else:
            self.observations[k] = observation

    def observe(self) -> Any:
        """Return what all slots see, as new arrays; texts as a tuple."""
        return _each(_copy, self.observations)


def lay_out(take: Take, count: int, observation: spaces.Space, action: spaces.Box) -> SlotArrays:
    """Return the arrays of ``count`` slots, whose spaces these are.

    Raises:
        TypeError: an observation that is neither a ``Box`` nor a ``Text``, nor a ``Dict`` of them.
    """

    def take_part(space: spaces.Space) -> np.ndarray:
        if isinstance(space, spaces.Text):
            return take((count,), f"U{space.max_length}")
        if not isinstance(space, spaces.Box):
            raise TypeError(f"Observations are boxes and texts, or dicts of them, not {space}.")
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
    """Return what ``work`` returns of an array, or of each of a dict of them."""
    return {k: work(v) for k, v in part.items()} if isinstance(part, dict) else work(part)


class SharedBlock:
    """Memory for arrays that several processes write to, by an open file without a name.

    Nothing of it is left behind, however the processes end, and ``/dev/shm``, small in containers,
    has no part in it. Who takes the same arrays in the same order has the same memory.

    Args:
        file: the open file, of zeros; it may be closed afterwards.
        size: bytes.
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
    """Return an open file without a name, of ``size`` zeros; in memory where the system can."""
    if hasattr(os, "memfd_create"):
        file = os.memfd_create("tabletopgen")
    else:
        with tempfile.TemporaryFile() as opened:
            file = os.dup(opened.fileno())
    os.ftruncate(file, size)
    return file


def pad(size: int) -> int:
    """Return the bytes that an array of ``size`` bytes takes up in a block."""
    return -(-size // _LINE) * _LINE
