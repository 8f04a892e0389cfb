"""The worker pool used by batches, scene servers, recording and certification.

A worker is a separate Python process (``worker``), driven by a thread of this one. It is neither a
``multiprocessing`` process nor part of a ``ProcessPoolExecutor``: those run the user's script
again, cannot be started by the daemonic processes of vector environments, and break the whole pool
when one process dies. Here a death fails one task, and the next task gets a new worker.

Tasks and results are pickled (``cloudpickle`` includes functions defined in scripts) and sent
through the worker's standard input and output. The input ends when the process that owns the pool
ends, for whatever reason; the worker then exits with all its child processes.
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
_EXIT_TIME = 5.0  # seconds that an idle worker has to exit


class WorkerDied(SceneError):
    """A worker process ended abruptly, could not be started, or took too long.

    ``how`` describes its end, if known, such as "was killed (SIGKILL)".
    """

    how: str = ""


class WorkerPool(TaskPool):
    """Up to ``width`` worker processes, started on demand.

    Each computes on one thread, unless OMP_NUM_THREADS or similar variables are set. Workers ignore
    Ctrl-C, which the process that owns the pool handles; see ``close``. A forked copy of a pool
    owns nothing and must not be used. ``begin``, which must be picklable, is called once in each
    process, before its first task. ``folder`` is temporary and removed with the pool; it contains
    the workers' standard error. ``descriptors`` are open files that the workers inherit under the
    same numbers; the caller may close them once ``width`` tasks have been submitted.
    ``environment`` adds variables to those of this process.
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
        """The ids of the running processes."""
        processes = [worker.process for worker in self._state.workers]
        return tuple(p.pid for p in processes if p is not None and p.poll() is None)

    def submit(
        self, function: Callable[..., T], *args: Any, timeout: float | None = None
    ) -> Future[T]:
        """See ``TaskPool``; after ``timeout``, the worker and its child processes are killed."""
        state, task = self._state, _Task(cloudpickle.dumps((function, args)), timeout)
        if len(state.workers) < self.width:
            worker = _Worker(state, len(state.workers))
            state.workers.append(worker)
            with contextlib.suppress(OSError):  # the task will report the error
                worker.start()
            threading.Thread(target=_serve, args=(state.tasks, worker), daemon=True).start()
        state.tasks.put(task)
        return task.future

    def close(self, grace: float = 0.0) -> None:
        """Close the processes and remove the folder; may be called twice.

        ``grace`` is the time in seconds that running tasks have after an interrupt (as by Ctrl-C);
        0 kills them. An interrupt during this call ends the wait.
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
    """The part of a pool that its threads refer to, so that they do not keep the pool alive."""

    begin: bytes
    folder: Path | None
    descriptors: tuple[int, ...] = ()
    environment: Mapping[str, str] = field(default_factory=dict)
    owner: int = field(default_factory=os.getpid)
    tasks: queue.SimpleQueue[_Task | None] = field(default_factory=queue.SimpleQueue)
    workers: list[_Worker] = field(default_factory=list)

    def cancel(self) -> None:
        """Cancel the tasks that no worker has started."""
        with contextlib.suppress(queue.Empty):
            while True:
                if task := self.tasks.get_nowait():
                    task.future.cancel()


@dataclass(eq=False)
class _Worker:
    """Runs one process at a time; ``busy`` during a task, and ``proven`` once it has run a task."""

    state: _State
    number: int
    process: subprocess.Popen[bytes] | None = None
    busy: bool = False
    proven: bool = False

    def start(self) -> None:
        """Start the process in its own session, with this process's module search path."""
        path = os.pathsep.join(entry or str(Path.cwd()) for entry in sys.path)
        alone = {name: os.environ.get(name, "1") for name in _SINGLE_THREAD}
        folder = self.state.folder
        with contextlib.ExitStack() as opened:
            errors = None
            if folder is not None:
                folder.mkdir(exist_ok=True)  # a cleaner of temporary folders may have removed it
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
        """Return the task's result, or raise its exception or ``WorkerDied``."""
        if self.process is None or (self.proven and self.process.poll() is not None):
            self.discard()  # it died between tasks
            try:
                self.start()
            except OSError as error:
                raise WorkerDied(
                    f"A task was not started because its process could not be started ({error})."
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
            how = f"exceeded its limit of {task.timeout:g} s" if late.is_set() else _death(code)
            how += self._last_words()
            died = WorkerDied(
                f"A worker process ended abruptly: it {how}. Use fewer workers if memory is short."
            )
            died.how = how
            raise died from error
        finally:
            timer.cancel()
            if task.timeout is not None:
                timer.join()  # a timer that has just fired must not kill the next task
        self.proven = True
        well, value = pickle.loads(packed)  # the data comes from our own process
        if not well:
            raise value
        return value

    def discard(self) -> int:
        """Kill and forget the process; return its exit code. Call this only in the serving thread.

        Other threads kill the process (``_kill``) without changing the worker, because it may be
        about to start another process.
        """
        process, self.process = self.process, None
        return 0 if process is None else _kill(process)

    def _last_words(self) -> str:
        """Return the last line of the process's standard error."""
        with contextlib.suppress(OSError):
            if self.state.folder is not None:
                text = (self.state.folder / f"{self.number}.log").read_text(errors="replace")
                if said := [line.strip() for line in text.split("\n") if line.strip()]:
                    return f": {said[-1][:300]}"
        return ""


def _serve(tasks: queue.SimpleQueue[_Task | None], worker: _Worker) -> None:
    """Run tasks in a worker one after another; the main loop of a pool's thread."""
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
        del task, result, failure  # release the references, which would otherwise outlive the task


def _end(state: _State) -> None:
    """Close a pool: idle workers exit, others are killed. A forked copy only closes its pipes."""
    processes = [worker.process for worker in state.workers if worker.process is not None]
    if os.getpid() != state.owner:
        for process in processes:
            _hang_up(process)
            process.returncode = 0  # a child of another process; nothing to wait for
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
    """Wait until the processes have ended, for at most ``seconds``."""
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
        return pickle.load(answers)  # at most this thread's task is running


def _kill(process: subprocess.Popen[bytes]) -> int:
    """Kill a worker's session, which includes its children; return the worker's exit code.

    This is thread-safe and may be called several times.
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
        return f"exited with code {code}"
    with contextlib.suppress(ValueError):
        return f"was killed ({signal.Signals(-code).name})"
    return f"was killed (signal {-code})"
