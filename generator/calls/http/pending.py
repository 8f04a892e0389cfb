"""Calls in background threads, so that waiting for them can be interrupted."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future
from typing import TypeVar

T = TypeVar("T")


def begin(work: Callable[[], T]) -> Future[T]:
    """Run ``work`` in a daemon thread and return its future; process exit does not wait for it."""
    pending: Future[T] = Future()

    def run() -> None:
        try:
            pending.set_result(work())
        except BaseException as error:
            pending.set_exception(error)

    threading.Thread(target=run, name="call", daemon=True).start()
    return pending


class Deadline:
    """The time when callers stop waiting for pending calls; any thread may move it earlier."""

    def __init__(self) -> None:
        self.until: float | None = None
        """The deadline, in seconds of ``time.monotonic``; None means no deadline."""

    def bring_forward(self, until: float) -> None:
        """Move the deadline to ``until``, unless it is already earlier."""
        self.until = until if self.until is None else min(until, self.until)
