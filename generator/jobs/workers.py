"""The worker pool: processes that run the tasks of batches, fresh scenes, recording, certifying.

A worker is a Python process of its own (``worker``), driven by a thread
here. It is neither a ``multiprocessing`` process nor part of a ``ProcessPoolExecutor``: those run
the user's script again, cannot be started by the daemonic processes of vector environments, and one
death breaks a whole pool. Here a death fails one task, and the next task gets a new worker.

Tasks and results are pickled (``cloudpickle`` sends along what a script defines) and travel through
the worker's standard input and output. The input ends with the process that owns the pool, however
that ends: then the worker exits, with all it has started.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import queue
import shutil
import signal
import subprocess
import sys
import threading
import time
import weakref
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

import cloudpickle

from ..errors import SceneError

T = TypeVar("T")

SINGLE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
"""Environment variables that are 1 in workers, unless they are set: others compute beside them."""

_EXIT_TIME = 5.0  # seconds that a worker without a task has to exit


class WorkerDied(SceneError):
    """A worker process ended abruptly, could not be started, or took too long."""


class WorkerPool:
    """At most ``width`` worker processes, started as tasks come.

    They ignore Ctrl-C, which is for the process that owns the pool: see ``close``. A forked copy of
    a pool owns nothing and must not be used.

    Args:
        width: number of tasks at a time.
        begin: called once in each process, before its first task; picklable.
        folder: a temporary folder that ends with the pool; the workers' standard error goes there.
    """

    def __init__(
        self, width: int, *, begin: Callable[[], object] | None = None, folder: Path | None = None
    ) -> None:
        self.width = width
        self._state = _State(cloudpickle.dumps(begin), folder)
        self._finalizer = weakref.finalize(self, _end, self._state)

    @property
    def pids(self) -> tuple[int, ...]:
        """The ids of the processes that run."""
        running = [w.process for w in self._state.workers if w.process and w.process.poll() is None]
        return tuple(process.pid for process in running)

    def submit(
        self, function: Callable[..., T], *args: Any, timeout: float | None = None
    ) -> Future[T]:
        """Have a worker call a picklable function; its result must be picklable, too.

        Args:
            function: what to call.
            args: its arguments.
            timeout: seconds after which the worker is killed.

        Returns:
            The pending result: what the function returns or raises, or ``WorkerDied``.
        """
        state, future = self._state, Future()
        if len(state.workers) < self.width:
            worker = _Worker(len(state.workers), state.begin, state.folder)
            state.workers.append(worker)
            with contextlib.suppress(OSError):  # told by the task
                worker.start()
            threading.Thread(target=_serve, args=(state.tasks, worker), daemon=True).start()
        state.tasks.put(_Task(cloudpickle.dumps((function, args)), timeout, future))
        return future

    def map(self, function: Callable[[Any], T], items: Iterable[Any]) -> Iterator[T]:
        """Yield the function's result for every item, in their order."""
        for future in [self.submit(function, item) for item in items]:
            yield future.result()

    def close(self, grace: float = 0.0) -> None:
        """End the processes and remove the folder; may be called twice.

        Args:
            grace: seconds that running tasks have to end, once they are interrupted as by Ctrl-C;
                0 kills them. An interrupt of this call ends the wait.
        """
        try:
            if grace and self._finalizer.alive:
                self._state.interrupt(grace)
        finally:
            self._finalizer()


@dataclass(frozen=True, eq=False)
class _Task:
    packed: bytes
    timeout: float | None
    future: Future[Any]


@dataclass(eq=False)
class _State:
    """What must not outlive the pool; its threads hold parts of it, never the pool."""

    begin: bytes
    folder: Path | None
    owner: int = field(default_factory=os.getpid)
    tasks: queue.SimpleQueue[_Task | None] = field(default_factory=queue.SimpleQueue)
    workers: list[_Worker] = field(default_factory=list)

    def cancel(self) -> None:
        """Cancel the tasks that no worker has begun."""
        with contextlib.suppress(queue.Empty):
            while True:
                if task := self.tasks.get_nowait():
                    task.future.cancel()

    def interrupt(self, grace: float) -> None:
        """Interrupt the running tasks, and wait for the end of their processes."""
        self.cancel()
        until = time.monotonic() + grace
        busy = [w.process for w in self.workers if w.busy and w.process is not None]
        for process in busy:
            with contextlib.suppress(OSError, ValueError):  # ValueError: Windows
                process.send_signal(signal.SIGINT)
        for process in busy:
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(max(0.0, until - time.monotonic()))


@dataclass(eq=False)
class _Worker:
    """One process, replaced when it dies. ``busy``: it has a task. ``tried``: it has done one."""

    number: int
    begin: bytes
    folder: Path | None
    process: subprocess.Popen[bytes] | None = None
    busy: bool = False
    tried: bool = False

    @property
    def log(self) -> Path | None:
        """Where its standard error goes; None: where that of this process goes."""
        return None if self.folder is None else self.folder / f"{self.number}.log"

    def start(self) -> None:
        """Start the process: in a session of its own, with this process's modules.

        Raises:
            OSError: it cannot be started.
        """
        path = os.pathsep.join(entry or str(Path.cwd()) for entry in sys.path)
        alone = {name: os.environ.get(name, "1") for name in SINGLE_THREAD}
        if self.folder is not None:
            self.folder.mkdir(exist_ok=True)  # who cleans temporary folders may have taken it
        with contextlib.ExitStack() as opened:
            errors = None if self.log is None else opened.enter_context(self.log.open("wb"))
            self.process = subprocess.Popen(
                [sys.executable, "-P", "-m", f"{__package__}.worker", str(self.folder or "")],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=errors, bufsize=0,
                env={**os.environ, **alone, "PYTHONPATH": path}, start_new_session=True,
            )  # fmt: skip
        self.tried = False
        self._send(self.begin)

    def run(self, task: _Task) -> Any:
        """Return what the task returns, or raise what it raises.

        Raises:
            WorkerDied: the process did not answer, or could not be started.
        """
        if self.process is None or (self.tried and self.process.poll() is not None):
            self.kill()  # it died without a task
            try:
                self.start()
            except OSError as error:
                raise WorkerDied(
                    f"A task was not begun: no process could be started ({error})."
                ) from error
        late = threading.Event()
        try:
            with _killed_after(task.timeout, self, late):
                self._send(task.packed)
                packed = self._receive()
        except (OSError, EOFError, pickle.UnpicklingError) as error:
            code = self.kill()
            how = f"was given up after {task.timeout:g} s" if late.is_set() else _death(code)
            raise WorkerDied(
                f"A worker process ended abruptly: it {how}{self._last_words()}. Use fewer workers "
                "if memory is short."
            ) from error
        self.tried = True
        well, value = pickle.loads(packed)  # by our own process
        if well:
            return value
        raise value

    def _send(self, packed: bytes) -> None:
        assert self.process is not None and self.process.stdin is not None
        left = memoryview(pickle.dumps(packed))
        while left:
            left = left[self.process.stdin.write(left) :]

    def _receive(self) -> bytes:
        assert self.process is not None and self.process.stdout is not None
        with os.fdopen(os.dup(self.process.stdout.fileno()), "rb") as answers:
            return pickle.load(answers)  # no more than this one is under way

    def kill(self) -> int:
        """Kill the process and what it has started, which are a session of their own.

        Returns:
            How it ended: see ``subprocess.Popen.returncode``.
        """
        process = self.process
        if process is None:
            return 0
        if process.poll() is None:
            if hasattr(os, "killpg"):
                with contextlib.suppress(OSError):
                    os.killpg(process.pid, signal.SIGKILL)
            process.kill()
        code = process.wait()
        _hang_up(process)
        self.process = None
        return code

    def _last_words(self) -> str:
        """Return the last line that the process wrote to its standard error."""
        with contextlib.suppress(OSError):
            lines = self.log.read_text(errors="replace").split("\n") if self.log else ()
            if said := [line.strip() for line in lines if line.strip()]:
                return f": {said[-1][:300]}"
        return ""


def _hang_up(process: subprocess.Popen[bytes]) -> None:
    """Close this end of the pipes."""
    for pipe in (process.stdin, process.stdout):
        if pipe is not None:
            with contextlib.suppress(OSError):
                pipe.close()


def _death(code: int) -> str:
    if code >= 0:
        return f"ended with code {code}"
    with contextlib.suppress(ValueError):
        return f"was killed ({signal.Signals(-code).name})"
    return f"was killed (signal {-code})"


def _serve(tasks: queue.SimpleQueue[_Task | None], worker: _Worker) -> None:
    """Hand one task after another to a worker: what a thread of a pool does."""
    while (task := tasks.get()) is not None:
        if not task.future.set_running_or_notify_cancel():
            continue
        worker.busy = True
        try:
            result = worker.run(task)
        except BaseException as error:
            worker.busy = False
            task.future.set_exception(error)
        else:
            worker.busy = False
            task.future.set_result(result)
        del task  # nor does the thread hold the result


@contextlib.contextmanager
def _killed_after(timeout: float | None, worker: _Worker, late: threading.Event) -> Iterator[None]:
    """Kill a worker that is still at it after ``timeout`` seconds, and set ``late``."""
    timer = threading.Timer(timeout or 0.0, lambda: (late.set(), worker.kill()))
    timer.daemon = True
    if timeout is not None:
        timer.start()
    try:
        yield
    finally:
        timer.cancel()


def _end(state: _State) -> None:
    """End a pool: workers without a task exit, others are killed. A forked copy only hangs up."""
    if os.getpid() != state.owner:
        for worker in state.workers:
            if worker.process is not None:
                _hang_up(worker.process)
                worker.process.returncode = 0  # another process's child: nothing to wait for
        return
    state.cancel()
    for worker in state.workers:
        state.tasks.put(None)
        if worker.busy:
            worker.kill()
        elif worker.process is not None and worker.process.stdin is not None:
            with contextlib.suppress(OSError):
                worker.process.stdin.close()
    until = time.monotonic() + _EXIT_TIME
    for worker in state.workers:
        if (process := worker.process) is not None:
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(max(0.0, until - time.monotonic()))
            worker.kill()
    if state.folder is not None:
        shutil.rmtree(state.folder, ignore_errors=True)
