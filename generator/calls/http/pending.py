"""A call in a thread of its own, so that whoever waits for it can be interrupted."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import Future
from typing import TypeVar

T = TypeVar("T")


def begin(work: Callable[[], T]) -> Future[T]:
    """Begin ``work`` and return its pending result; the end of the process does not wait for it."""
    pending: Future[T] = Future()

    def run() -> None:
        try:
            pending.set_result(work())
        except BaseException as error:
            pending.set_exception(error)

    threading.Thread(target=run, name="call", daemon=True).start()
    return pending


class Deadline:
    """When those who wait for pending calls give up; any thread may bring it forward."""

    def __init__(self) -> None:
        self.until: float | None = None
        """By the clock of ``time.monotonic``; None: never."""

    def bring_forward(self, until: float) -> None:
        """Give up at ``until``, or earlier if that was said."""
        self.until = until if self.until is None else min(until, self.until)
