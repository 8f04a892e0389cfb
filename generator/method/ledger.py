"""Times of the stages. They never reach a bundle: the same input gives the same bytes."""

from __future__ import annotations

import itertools
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType


@dataclass(frozen=True)
class Seconds:
    """Wall-clock and CPU seconds.

    ``cpu`` counts all threads of this process, but not what processes that it started used.
    """

    wall: float
    cpu: float


class Stopwatch:
    """Goes through stages in order, notifies a listener, and records the seconds of each."""

    def __init__(
        self, stages: Sequence[str], progress: Callable[[str, int, int], None] | None = None
    ) -> None:
        """``progress`` is called with each stage's name, its number, and how many there are."""
        self._stages = tuple(stages)
        self._progress = progress
        self._marks: list[tuple[float, float]] = []

    def step(self) -> None:
        """Begin the next stage."""
        self._marks.append((time.perf_counter(), time.process_time()))
        if self._progress is not None:
            number = len(self._marks)
            self._progress(self._stages[number - 1], number, len(self._stages))

    def stop(self) -> Mapping[str, Seconds]:
        """Return the seconds of every started stage, in order."""
        marks = [*self._marks, (time.perf_counter(), time.process_time())]
        spent = [Seconds(b[0] - a[0], b[1] - a[1]) for a, b in itertools.pairwise(marks)]
        return MappingProxyType(dict(zip(self._stages, spent, strict=False)))
