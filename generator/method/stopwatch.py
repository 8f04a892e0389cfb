"""Times of the stages. They never reach a bundle: the same input gives the same bytes."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any


@dataclass(frozen=True)
class Seconds:
    """Wall-clock and CPU seconds.

    ``cpu`` counts all threads of this process, but not what processes that it started used.
    """

    wall: float
    cpu: float


Watch = Callable[[str, Mapping[str, Any]], None]
"""Called as a stage ends: its name, and all that was found until then, by name."""


class Stopwatch:
    """Goes through stages in order, notifies listeners, and records the seconds of each.

    ``progress`` is called as each stage begins, with its name, its number, and how many there are;
    ``watch`` as each ends. Seconds spent in ``watch`` count for no stage.
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
        """End the stage under way, which found ``found``, and begin the next."""
        self._begun = self._end(found)
        if self._progress is not None:
            number = len(self._spent) + 1
            self._progress(self._stages[number - 1], number, len(self._stages))

    def stop(self, **found: Any) -> Mapping[str, Seconds]:
        """End the last stage, which found ``found``; return the seconds of each, in order."""
        self._end(found)
        return MappingProxyType(dict(zip(self._stages, self._spent, strict=False)))

    def _end(self, found: Mapping[str, Any]) -> tuple[float, float]:
        """End the stage under way, if there is one; return when the next begins."""
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
