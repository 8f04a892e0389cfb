"""Handling of Ctrl-C in a recording: it interrupts episodes, but never the writing of files."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any

from .episodes import RecordedEpisode

_Playing = Callable[[Iterable[RecordedEpisode]], Iterator[RecordedEpisode]]


@contextmanager
def deferring() -> Iterator[_Playing]:
    """Defer Ctrl-C except while episodes are played; yield a wrapper for the episodes' iterator.

    Ctrl-C during the writing of an episode ends the iteration after that episode. Outside the main
    thread nothing is deferred.
    """
    if threading.current_thread() is not threading.main_thread():
        yield iter
        return
    stop, before = threading.Event(), signal.getsignal(signal.SIGINT)

    def note(number: int, frame: Any) -> None:
        stop.set()

    def playing(episodes: Iterable[RecordedEpisode]) -> Iterator[RecordedEpisode]:
        ahead = iter(episodes)
        while not stop.is_set():
            try:
                signal.signal(signal.SIGINT, before)
                episode = next(ahead)
            except (StopIteration, KeyboardInterrupt):
                return
            finally:
                signal.signal(signal.SIGINT, note)
            yield episode

    signal.signal(signal.SIGINT, note)
    try:
        yield playing
    finally:
        signal.signal(signal.SIGINT, before)
