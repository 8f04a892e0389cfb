"""Waits with timeouts for threads, processes and conditions."""

import contextlib
import select
import subprocess
import threading
import time
from collections.abc import Callable, Iterator
from typing import IO, Any

LONG = 120.0
"""Seconds after which something is taken to hang; anything waited for takes far less."""


def until(happened: Callable[[], Any], seconds: float = LONG) -> None:
    """Wait until a condition holds."""
    end = time.monotonic() + seconds
    while not happened():
        assert time.monotonic() < end, f"it did not happen in {seconds:g} s"
        time.sleep(0.01)


def join(*threads: threading.Thread) -> None:
    """Wait until all threads have ended."""
    end = time.monotonic() + LONG
    for thread in threads:
        thread.join(max(0.0, end - time.monotonic()))
        assert not thread.is_alive(), f"{thread.name} did not end in {LONG:g} s"


def at_once(*works: Callable[[], object]) -> None:
    """Run several functions at the same time, each in its own thread, and wait for all."""
    threads = [threading.Thread(target=work, daemon=True) for work in works]
    for thread in threads:
        thread.start()
    join(*threads)


def line_of(process: subprocess.Popen[Any]) -> Any:
    """Return the next flushed line of a process's output; only one call may be active."""
    stream: IO[Any] | None = process.stdout
    assert stream is not None
    assert select.select([stream], [], [], LONG)[0], f"nothing was printed in {LONG:g} s"
    return stream.readline()


@contextlib.contextmanager
def running(*command: object, **settings: Any) -> Iterator[subprocess.Popen[Any]]:
    """Run a process in the context; kill its remains afterwards."""
    process = subprocess.Popen(list(map(str, command)), **settings)
    try:
        yield process
    finally:
        process.kill()
        process.communicate(timeout=LONG)
