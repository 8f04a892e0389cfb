"""A call under way, in a thread of its own: whoever waits for it can be interrupted."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future, wait
from typing import Generic, TypeVar

T = TypeVar("T")


class Flight(Generic[T]):
    """Work that has begun, and that the process does not wait for when it ends."""

    def __init__(self, work: Callable[[], T]) -> None:
        """Begin ``work``."""
        self._future: Future[T] = Future()

        def fly() -> None:
            try:
                self._future.set_result(work())
            except BaseException as error:
                self._future.set_exception(error)

        threading.Thread(target=fly, name="call", daemon=True).start()

    def landed(self, seconds: float) -> bool:
        """Return whether the work is done, after at most so many seconds."""
        return bool(wait([self._future], seconds).done)

    def result(self) -> T:
        """Return what came of it, or raise that."""
        return self._future.result()


class Haste:
    """Whether those who wait for calls under way should give up soon; told from any thread."""

    def __init__(self) -> None:
        self._until: float | None = None

    def ask(self, until: float) -> None:
        """Let calls under way end until then, by the clock of ``time.monotonic``, and no longer."""
        self._until = until if self._until is None else min(until, self._until)

    @property
    def until(self) -> float | None:
        """When to give up; None: never."""
        return self._until
