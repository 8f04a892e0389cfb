"""Timing of the pipeline's stages; bundles, which must be reproducible, omit the times."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any


@dataclass(frozen=True)
class Seconds:
    """Wall-clock and CPU seconds.

    ``cpu`` counts all threads of this process, but not its child processes.
    """

    wall: float
    cpu: float


Watch = Callable[[str, Mapping[str, Any]], None]
"""A callback at the end of a stage; receives its name and all results so far, by name."""


class Stopwatch:
    """Stopwatch that steps through stages in order, notifies listeners, and times each stage.

    ``progress`` is called at the start of each stage with its name, its number and the number of
    stages; ``watch`` is called at the end of each stage. Time spent in ``watch`` is not counted.
    """

    def __init__(
        self,
        stages: Sequence[str],
        progress: Callable[[str, int, int], None] | None = None,
        watch: Watch | None = None,
    ) -> None:
        self._stages = tuple(stages)
        self._progress, self._watch = progress, watch
        self._begun: tuple[float, float] | None = None
        self._spent: list[Seconds] = []
        self._found: dict[str, Any] = {}

    def step(self, **found: Any) -> None:
        """End the current stage, report its results ``found``, and begin the next stage."""
        self._begun = self._end(found)
        if self._progress is not None:
            number = len(self._spent) + 1
            self._progress(self._stages[number - 1], number, len(self._stages))

    def stop(self, **found: Any) -> Mapping[str, Seconds]:
        """End the last stage, report its results ``found``, and return each stage's seconds."""
        self._end(found)
        return MappingProxyType(dict(zip(self._stages, self._spent, strict=False)))

    def _end(self, found: Mapping[str, Any]) -> tuple[float, float]:
        """End the current stage, if there is one; return the start time of the next."""
        now = time.perf_counter(), time.process_time()
        if self._begun is None:
            return now
        self._spent.append(Seconds(now[0] - self._begun[0], now[1] - self._begun[1]))
        self._begun = None
        self._found |= found
        if self._watch is None:
            return now
        self._watch(self._stages[len(self._spent) - 1], MappingProxyType(dict(self._found)))
        return time.perf_counter(), time.process_time()
