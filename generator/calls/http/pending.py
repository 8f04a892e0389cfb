"""A call in a thread of its own, so that whoever waits for it can be interrupted."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future, wait
from typing import Generic, TypeVar

T = TypeVar("T")


class PendingCall(Generic[T]):
    """Work that has begun; the end of the process does not wait for it."""

    def __init__(self, work: Callable[[], T]) -> None:
        """Begin ``work``."""
        self._future: Future[T] = Future()

        def run() -> None:
            try:
                self._future.set_result(work())
            except BaseException as error:
                self._future.set_exception(error)

        threading.Thread(target=run, name="call", daemon=True).start()

    def is_done(self, seconds: float) -> bool:
        """Return whether the work is done, after at most so many seconds."""
        return bool(wait([self._future], seconds).done)

    def result(self) -> T:
        """Return the result, or raise the error, once it is done."""
        return self._future.result()


class Deadline:
    """When those who wait for pending calls give up; any thread may bring it forward."""

    def __init__(self) -> None:
        self.until: float | None = None
        """By the clock of ``time.monotonic``; None: never."""

    def bring_forward(self, until: float) -> None:
        """Give up at ``until``, or earlier if that was said."""
        self.until = until if self.until is None else min(until, self.until)
