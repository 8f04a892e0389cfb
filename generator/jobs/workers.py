"""The worker pool: processes that run the tasks of batches, fresh scenes, recording, certifying.

A worker is a Python process of its own (``worker``), driven by a thread here. It is neither a
``multiprocessing`` process nor part of a ``ProcessPoolExecutor``: those run the user's script
again, cannot be started by the daemonic processes of vector environments, and one death breaks a
whole pool. Here a death fails one task, and the next task gets a new worker.

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
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import Future
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType
from typing import Any, TypeVar

import cloudpickle

from ..errors import SceneError
from .task_pool import TaskPool

T = TypeVar("T")

_SINGLE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
_EXIT_TIME = 5.0  # seconds that a worker without a task has to exit


class WorkerDied(SceneError):
    """A worker process ended abruptly, could not be started, or took too long.

    ``how`` it ended, where that is known: "was killed (SIGKILL)".
    """

    how: str = ""


class WorkerPool(TaskPool):
    """At most ``width`` worker processes, started as tasks come.

    Each computes on one thread, unless OMP_NUM_THREADS and its like say otherwise. Ctrl-C is only
    for the process that owns the pool: see ``close``. A forked copy of a pool owns nothing and must
    not be used. ``begin``, picklable, is called once in each process, before its first task.
    ``folder`` is a temporary one that ends with the pool; the workers' standard error goes there.
    ``descriptors`` are those of open files that the workers inherit, by the same numbers; they may
    be closed here once ``width`` tasks were submitted. ``environment`` are variables that they have
    besides this process's.
    """

    def __init__(
        self,
        width: int,
        *,
        begin: Callable[[], object] | None = None,
        folder: Path | None = None,
        descriptors: Iterable[int] = (),
        environment: Mapping[str, str] = MappingProxyType({}),
    ) -> None:
        self.width = width
        self._state = _State(
            cloudpickle.dumps(begin), folder, tuple(descriptors), dict(environment)
        )
        self._finalizer = weakref.finalize(self, _end, self._state)

    @property
    def pids(self) -> tuple[int, ...]:
        """The ids of the processes that run."""
        processes = [worker.process for worker in self._state.workers]
        return tuple(p.pid for p in processes if p is not None and p.poll() is None)

    def submit(
        self, function: Callable[..., T], *args: Any, timeout: float | None = None
    ) -> Future[T]:
        """See ``TaskPool``; ``timeout`` kills the worker, and what it has started."""
        state, task = self._state, _Task(cloudpickle.dumps((function, args)), timeout)
        if len(state.workers) < self.width:
            worker = _Worker(state, len(state.workers))
            state.workers.append(worker)
            with contextlib.suppress(OSError):  # the task tells of it
                worker.start()
            threading.Thread(target=_serve, args=(state.tasks, worker), daemon=True).start()
        state.tasks.put(task)
        return task.future

    def close(self, grace: float = 0.0) -> None:
        """End the processes and remove the folder; may be called twice.

        ``grace`` are the seconds that running tasks have to end, once they are interrupted as by
        Ctrl-C; 0 kills them. An interrupt of this call ends the wait.
        """
        busy = [w.process for w in self._state.workers if w.busy and w.process] if grace else []
        try:
            self._state.cancel()
            for process in busy:
                with contextlib.suppress(OSError):
                    process.send_signal(signal.SIGINT)
            _wait(busy, grace)
        finally:
            self._finalizer()


@dataclass(frozen=True, eq=False)
class _Task:
    packed: bytes
    timeout: float | None
    future: Future[Any] = field(default_factory=Future)


@dataclass(eq=False)
class _State:
    """What must not outlive the pool; threads refer to this, never to the pool."""

    begin: bytes
    folder: Path | None
    descriptors: tuple[int, ...] = ()
    environment: Mapping[str, str] = field(default_factory=dict)
    owner: int = field(default_factory=os.getpid)
    tasks: queue.SimpleQueue[_Task | None] = field(default_factory=queue.SimpleQueue)
    workers: list[_Worker] = field(default_factory=list)

    def cancel(self) -> None:
        """Cancel the tasks that no worker has begun."""
        with contextlib.suppress(queue.Empty):
            while True:
                if task := self.tasks.get_nowait():
                    task.future.cancel()


@dataclass(eq=False)
class _Worker:
    """One process at a time. ``busy``: it has a task; ``proven``: it has done one."""

    state: _State
    number: int
    process: subprocess.Popen[bytes] | None = None
    busy: bool = False
    proven: bool = False

    def start(self) -> None:
        """Start the process in a session of its own, with this process's modules."""
        path = os.pathsep.join(entry or str(Path.cwd()) for entry in sys.path)
        alone = {name: os.environ.get(name, "1") for name in _SINGLE_THREAD}
        folder = self.state.folder
        with contextlib.ExitStack() as opened:
            errors = None
            if folder is not None:
                folder.mkdir(exist_ok=True)  # who cleans temporary folders may have taken it
                errors = opened.enter_context((folder / f"{self.number}.log").open("wb"))
            self.process = subprocess.Popen(
                [sys.executable, "-P", "-m", f"{__package__}.worker", str(folder or "")],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=errors, bufsize=0,
                env={**os.environ, **alone, "PYTHONPATH": path, **self.state.environment},
                start_new_session=True,
                pass_fds=self.state.descriptors,
            )  # fmt: skip
        self.proven = False
        _send(self.process, self.state.begin)

    def run(self, task: _Task) -> Any:
        """Return what the task returns, or raise what it raises, or ``WorkerDied``."""
        if self.process is None or (self.proven and self.process.poll() is not None):
            self.discard()  # it died without a task
            try:
                self.start()
            except OSError as error:
                raise WorkerDied(
                    f"A task was not begun: no process could be started ({error})."
                ) from error
        process = self.process
        assert process is not None
        late = threading.Event()
        timer = threading.Timer(task.timeout or 0.0, lambda: (late.set(), _kill(process)))
        timer.daemon = True
        if task.timeout is not None:
            timer.start()
        try:
            _send(process, task.packed)
            packed = _receive(process)
        except (OSError, EOFError, ValueError, pickle.UnpicklingError) as error:
            code = self.discard()
            how = f"was given up after {task.timeout:g} s" if late.is_set() else _death(code)
            how += self._last_words()
            died = WorkerDied(
                f"A worker process ended abruptly: it {how}. Use fewer workers if memory is short."
            )
            died.how = how
            raise died from error
        finally:
            timer.cancel()
            if task.timeout is not None:
                timer.join()  # one that fired a moment ago must not kill under the next task
        self.proven = True
        well, value = pickle.loads(packed)  # by our own process
        if not well:
            raise value
        return value

    def discard(self) -> int:
        """Kill the process, and have none; return its exit code. Only for the thread that serves.

        Other threads kill the process (``_kill``) and leave the worker alone: it may be about to
        have another one.
        """
        process, self.process = self.process, None
        return 0 if process is None else _kill(process)

    def _last_words(self) -> str:
        """Return the last line that the process wrote to its standard error."""
        with contextlib.suppress(OSError):
            if self.state.folder is not None:
                text = (self.state.folder / f"{self.number}.log").read_text(errors="replace")
                if said := [line.strip() for line in text.split("\n") if line.strip()]:
                    return f": {said[-1][:300]}"
        return ""


def _serve(tasks: queue.SimpleQueue[_Task | None], worker: _Worker) -> None:
    """Hand one task after another to a worker: what a thread of a pool does."""
    while (task := tasks.get()) is not None:
        if not task.future.set_running_or_notify_cancel():
            continue
        worker.busy, result, failure = True, None, None
        try:
            result = worker.run(task)
        except BaseException as error:
            failure = error
        worker.busy = False
        if failure is None:
            task.future.set_result(result)
        else:
            task.future.set_exception(failure)
        del task, result, failure  # the thread keeps nothing


def _end(state: _State) -> None:
    """End a pool: workers without a task exit, others are killed. A forked copy only hangs up."""
    processes = [worker.process for worker in state.workers if worker.process is not None]
    if os.getpid() != state.owner:
        for process in processes:
            _hang_up(process)
            process.returncode = 0  # another process's child: nothing to wait for
        return
    state.cancel()
    for worker in state.workers:
        state.tasks.put(None)
        process = worker.process
        if process is not None and worker.busy:
            _kill(process)
        elif process is not None and process.stdin is not None:
            with contextlib.suppress(OSError):
                process.stdin.close()
    _wait(processes, _EXIT_TIME)
    for process in [*processes, *(worker.process for worker in state.workers)]:
        if process is not None:
            _kill(process)
    if state.folder is not None:
        shutil.rmtree(state.folder, ignore_errors=True)


def _wait(processes: Iterable[subprocess.Popen[bytes]], seconds: float) -> None:
    """Wait until processes have ended, no longer than so many seconds."""
    until = time.monotonic() + seconds
    for process in processes:
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(max(0.0, until - time.monotonic()))


def _send(process: subprocess.Popen[bytes], packed: bytes) -> None:
    assert process.stdin is not None
    left = memoryview(pickle.dumps(packed))
    while left:
        left = left[process.stdin.write(left) :]


def _receive(process: subprocess.Popen[bytes]) -> bytes:
    assert process.stdout is not None
    with os.fdopen(os.dup(process.stdout.fileno()), "rb") as answers:
        return pickle.load(answers)  # no more than this one is under way


def _kill(process: subprocess.Popen[bytes]) -> int:
    """Kill a worker's process and what it has started, which are a session; return its exit code.

    Any thread may do it, and more than one at once.
    """
    if process.poll() is None:
        with contextlib.suppress(OSError):
            os.killpg(process.pid, signal.SIGKILL)
        process.kill()
    code = process.wait()
    _hang_up(process)
    return code


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
