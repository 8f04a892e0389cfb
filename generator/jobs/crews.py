"""Who does the work of a batch: processes of this machine, or Ray's."""

from __future__ import annotations

import _thread
import logging
import os
import signal
import threading
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.connection import wait as wait_for
from types import FrameType
from typing import Any, Protocol

from ..errors import BackendError, StoppedError
from .records import Outcome

Task = Callable[[], Outcome]
"""A call of ``records.work``, picklable."""

GRACE = 10.0
"""Seconds in which an interrupted process comes to an end: more than a session's ``grace``."""

_ABRUPT = (
    "The process that made it ended abruptly: killed, or out of memory. A script starts a batch "
    "under `if __name__ == '__main__':`."
)
_ALONE = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")  # threads of a process
_UNWATCHED = "RAY_USAGE_STATS_ENABLED"  # else Ray tells its makers that it was started


class Died(Exception):
    """A process died at its work; ``certain`` says that it was this task's."""

    def __init__(self, message: str, *, certain: bool) -> None:
        super().__init__(message)
        self.certain = certain


class Crew(Protocol):
    """Processes that are given tasks and asked what came of them."""

    width: int
    """How many tasks are done at a time."""

    def give(self, task: Task) -> Any:
        """Have a task done; return what stands for it.

        Raises:
            Died: a process is dead, and nothing is done before ``renew``.
        """
        ...

    def first(self, given: list[Any]) -> Any:
        """Wait until one of several tasks is done; return which."""
        ...

    def result(self, given: Any) -> Outcome:
        """Return what came of a task that is done.

        Raises:
            Died: its process is dead, or one that did another task.
            StorageError: see ``records.work``.
        """
        ...

    def renew(self) -> None:
        """Go on after a death, without what was given before."""
        ...

    def close(self, *, now: bool) -> None:
        """End; ``now`` interrupts the tasks that are being done."""
        ...


class Processes:
    """A pool of spawned processes, a thread each; they end with this one, however that ends.

    Two lines lead to them. Where the first is cut, who is at a task is interrupted, as by Ctrl-C:
    calls of servers that are under way may be answered. Where the second is, all end at once.
    """

    def __init__(self, width: int) -> None:
        self.width = width
        self._start()

    def _start(self) -> None:
        context = get_context("spawn")
        (work, self._work), (life, self._life) = (context.Pipe(duplex=False) for _ in range(2))
        self._ends = (work, life)
        self._pool = ProcessPoolExecutor(self.width, context, _begin, self._ends)

    def renew(self) -> None:
        """Start anew: one death breaks a whole pool."""
        self.close(now=True)
        self._start()

    def give(self, task: Task) -> Future[Outcome]:
        """Have a task done.

        Raises:
            Died: a process ended, at its work or without any.
        """
        with _environment(dict.fromkeys(_ALONE, "1")):
            try:
                return self._pool.submit(_worked, task)
            except BrokenProcessPool as error:
                raise Died(_ABRUPT, certain=False) from error

    def first(self, given: list[Future[Outcome]]) -> Future[Outcome]:
        """Wait until one of several tasks is done."""
        return next(iter(wait(given, return_when=FIRST_COMPLETED).done))

    def result(self, given: Future[Outcome]) -> Outcome:
        """Return what came of a task that is done."""
        try:
            return given.result()
        except BrokenProcessPool as error:
            raise Died(_ABRUPT, certain=False) from error

    def close(self, *, now: bool) -> None:
        """End the processes; interrupted itself, it ends them at once."""
        if now:
            self._work.close()
        try:
            self._pool.shutdown(wait=True, cancel_futures=True)
        finally:
            for end in (self._work, self._life, *self._ends):
                end.close()


class OnRay:
    """Tasks of a Ray cluster, a CPU each; its machines share the batch's folder.

    Args:
        address: as ``ray.init`` takes it; "local" starts Ray here, with ``width`` CPUs.
        width: how many tasks are done at a time.

    Raises:
        BackendError: Ray is not installed, or there is none at the address.
    """

    def __init__(self, address: str, width: int) -> None:
        try:
            import ray  # pyright: ignore[reportMissingImports]
        except ImportError as error:
            raise BackendError(
                "Ray is not installed. Run: pip install 'tabletopgen[ray]'"
            ) from error
        self._ray, self.width = ray, width
        cpus = {"num_cpus": width, "include_dashboard": False} if address == "local" else {}
        try:
            with _environment({_UNWATCHED: "0"}):
                ray.init(address=address, log_to_driver=False, logging_level=logging.ERROR, **cpus)
        except (ConnectionError, ValueError, RuntimeError) as error:
            raise BackendError(f"No Ray at {address!r}: {error}") from error
        self._work = ray.remote(num_cpus=1, max_retries=0)(_done)

    def give(self, task: Task) -> Any:
        """Have a task done."""
        return self._work.remote(task)

    def first(self, given: list[Any]) -> Any:
        """Wait until one of several tasks is done."""
        return self._ray.wait(given, num_returns=1)[0][0]

    def result(self, given: Any) -> Outcome:
        """Return what came of a task that is done."""
        errors = self._ray.exceptions
        try:
            return self._ray.get(given)
        except errors.RayTaskError as error:
            raise error.cause from error
        except errors.RayError as error:
            told = f"Ray's process that made it is dead: {type(error).__name__}."
            raise Died(told, certain=True) from error

    def renew(self) -> None:
        """Go on: Ray replaces its processes."""

    def close(self, *, now: bool) -> None:
        """Leave the cluster; what it was given and is not done is dropped."""
        self._ray.shutdown()


def _done(task: Task) -> Outcome:
    return task()


class _Heed:
    """What a process of a pool makes of SIGINT: Ctrl-C is its parent's affair, until that says so.

    ``over``: the parent was interrupted. ``busy``: a task is being done.
    """

    def __init__(self) -> None:
        self.over = self.busy = False

    def __call__(self, number: int, frame: FrameType | None) -> None:
        if self.over and self.busy:
            raise KeyboardInterrupt


def _begin(work: Connection, life: Connection) -> None:
    """Begin a process; it works as long as the one line is there, and lives as long as the other.

    Once the first is cut it is left by its pool when it has nothing to do, at the latest after
    ``GRACE``.
    """
    heed, main = _Heed(), threading.main_thread().ident
    signal.signal(signal.SIGINT, heed)

    def listen() -> None:
        if life not in wait_for([work, life]):
            heed.over = True
            if main is not None and hasattr(signal, "pthread_kill"):
                signal.pthread_kill(main, signal.SIGINT)  # also where it waits in the system
            else:
                _thread.interrupt_main()
            wait_for([life], GRACE)
        os._exit(1)

    threading.Thread(target=listen, daemon=True).start()


def _worked(task: Task) -> Outcome:
    """Do a task in a process of a pool.

    Raises:
        StoppedError: its parent was interrupted.
    """
    heed = signal.getsignal(signal.SIGINT)
    assert isinstance(heed, _Heed)
    heed.busy = True
    try:
        if heed.over:
            raise KeyboardInterrupt
        return task()
    except KeyboardInterrupt:
        raise StoppedError("Interrupted.") from None
    finally:
        heed.busy = False


@contextmanager
def _environment(usual: Mapping[str, str]) -> Iterator[None]:
    """Meanwhile, processes that are started find these variables, unless they are set already."""
    added = {name: value for name, value in usual.items() if name not in os.environ}
    os.environ.update(added)
    try:
        yield
    finally:
        for name in added:
            del os.environ[name]
