"""Ctrl-C that lets a training end without a loss."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any


class StopAsked(Exception):
    """Ctrl-C, raised where a training can end without a loss."""


@contextmanager
def heeding(say: Callable[[str], None]) -> Iterator[threading.Event]:
    """Give an event that the first Ctrl-C sets; the second does what it always does.

    In another thread than the main one nothing is heeded.
    """
    stop = threading.Event()
    if threading.current_thread() is not threading.main_thread():
        yield stop
        return
    before = signal.getsignal(signal.SIGINT)

    def note(number: int, frame: Any) -> None:
        stop.set()
        signal.signal(signal.SIGINT, before)
        say("Ending after what has begun; Ctrl-C again ends at once.")

    signal.signal(signal.SIGINT, note)
    try:
        yield stop
    finally:
        signal.signal(signal.SIGINT, before)
