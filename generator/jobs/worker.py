"""A worker process of a pool: ``python -m generator.jobs.worker FOLDER``; see ``workers``.

It reads pickles from standard input, first an initialisation function and then tasks, and writes
each task's result to standard output. When the input ends, the pool was closed or its process has
died; the worker then exits immediately and removes FOLDER, unless FOLDER is empty.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import queue
import shutil
import signal
import sys
import threading
import time
from pathlib import Path
from typing import BinaryIO

import cloudpickle

_EXIT_TIME = 5.0  # seconds until the main thread must have ended the process by itself

_Tasks = queue.SimpleQueue[bytes | None]


def main() -> None:
    """Run tasks until the input ends."""
    folder = Path(sys.argv[1]) if sys.argv[1] else None
    given, answers = _take_pipes()
    tasks: _Tasks = queue.SimpleQueue()
    busy = threading.Event()
    threading.Thread(target=_listen, args=(given, tasks, busy, folder), daemon=True).start()
    with contextlib.suppress(KeyboardInterrupt):
        begin = pickle.loads(tasks.get() or cloudpickle.dumps(None))
        if begin is not None:
            begin()
        while (packed := tasks.get()) is not None:
            busy.set()
            answer = answer_task(packed)
            busy.clear()
            pickle.dump(answer, answers)
            answers.flush()
    _remove(folder)


def answer_task(packed: bytes) -> bytes:
    """Run a pickled task; return a pickled pair: whether it succeeded, and its result or error."""
    try:
        function, args = pickle.loads(packed)
        return cloudpickle.dumps((True, function(*args)))
    except Exception as error:
        with contextlib.suppress(Exception):  # not all exceptions can be pickled
            failure = cloudpickle.dumps((False, error))
            pickle.loads(failure)
            return failure
        return cloudpickle.dumps((False, RuntimeError(f"{type(error).__name__}: {error}")))


def _take_pipes() -> tuple[BinaryIO, BinaryIO]:
    """Return standard input and output, detached from tasks and their child processes."""
    given, answers = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    with Path(os.devnull).open("rb") as nothing:
        os.dup2(nothing.fileno(), 0)
    os.dup2(2, 1)
    return given, answers


def _listen(given: BinaryIO, tasks: _Tasks, busy: threading.Event, folder: Path | None) -> None:
    """Receive tasks; when the input ends, terminate this process and its children."""
    with contextlib.suppress(EOFError, OSError, pickle.UnpicklingError):
        while True:
            tasks.put(pickle.load(given))
    tasks.put(None)
    if not busy.is_set():
        time.sleep(_EXIT_TIME)
    _remove(folder)
    with contextlib.suppress(OSError):
        os.killpg(os.getpid(), signal.SIGKILL)
    os._exit(0)


def _remove(folder: Path | None) -> None:
    while folder is not None and folder.is_dir():  # another thread may be writing into it
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    main()
