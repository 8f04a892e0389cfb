"""A worker pool on a Ray cluster, and the actor that owns a batch's spending database."""

from __future__ import annotations

import contextlib
import logging
import os
import pickle
import signal
import socket
from collections import Counter, deque
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Future
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from threading import RLock
from typing import Any, TypeVar

import cloudpickle

from ..calls.money.database import LOCAL, T
from ..errors import BackendError
from ..scene.provenance import versions
from .task_pool import TaskPool
from .worker import answer_task
from .workers import WorkerDied

R = TypeVar("R")

_USAGE = "RAY_USAGE_STATS_ENABLED"  # otherwise Ray reports usage statistics
_KNOCK_TIME = 10.0  # connection timeout of a cluster in seconds
# packages that must have the same version on all machines
_ALIKE = ("tabletopgen", "mujoco", "numpy")


class RayPool(TaskPool):
    """Runs up to ``width`` tasks at a time on the machines of a Ray cluster, each on one CPU.

    ``address`` is an address for ``ray.init``; "local" starts Ray on this machine with ``width``
    CPUs. If this process is already connected to a cluster, that connection is used and stays open.
    Tasks run in this process's working directory if their machine has it.

    Raises:
        BackendError: Ray is not installed, or no cluster runs at the address.
    """

    def __init__(self, address: str, width: int) -> None:
        try:
            import ray  # pyright: ignore[reportMissingImports]
        except ImportError as error:
            raise BackendError(
                "Ray is not installed. Run: pip install 'tabletopgen[ray]'"
            ) from error
        self._ray, self.width = ray, width
        self._own = not ray.is_initialized()
        if self._own:
            _connect(ray, address, width)
        self._call = ray.remote(num_cpus=1, max_retries=0, scheduling_strategy="SPREAD")(_call)
        self._place = _Place(str(Path.cwd()), versions(_ALIKE))
        self._waiting: deque[_RayTask] = deque()
        self._running: dict[Any, _RayTask] = {}
        self._done = Counter[str]()
        self._lock = RLock()

    def submit(
        self, function: Callable[..., R], *args: Any, timeout: float | None = None
    ) -> Future[R]:
        """See ``TaskPool``; raises BackendError if a machine cannot run the task identically."""
        task = _RayTask(cloudpickle.dumps((function, args)), timeout)
        self._waiting.append(task)
        self._begin()
        return task.future

    @cached_property
    def keeper(self) -> RayKeeper:
        """Access to the spending databases through an actor on this machine."""
        return RayKeeper(_keeping_actor(self._ray))

    def close(self, grace: float = 0.0) -> None:
        """Cancel pending tasks, stop running ones (ignoring ``grace``) and disconnect from Ray."""
        with self._lock:
            for task in self._waiting:
                task.future.cancel()
            self._waiting.clear()
            running, done = [*self._running], Counter(self._done)
            self._done.clear()
        for machine, count in sorted(done.items()):
            logging.getLogger(__name__).info("Ray node %s ran %d tasks", machine, count)
        if self._own:
            self._ray.shutdown()
        else:
            for reference in running:
                self._ray.cancel(reference, force=True)

    def _begin(self) -> None:
        """Submit as many tasks to Ray as allowed."""
        with self._lock:
            while self._waiting and len(self._running) < self.width:
                task = self._waiting.popleft()
                if not task.future.set_running_or_notify_cancel():
                    continue
                try:
                    reference = self._call.remote(self._place, task.packed, task.timeout)
                except Exception as error:  # such as a lost connection
                    task.future.set_exception(self._failure(error, task.timeout))
                    continue
                self._running[reference] = task
                reference.future().add_done_callback(
                    lambda done, reference=reference: self._end(reference, done)
                )

    def _end(self, reference: Any, done: Future[tuple[str, bytes]]) -> None:
        """Set the result of a finished task, and submit the next one."""
        with self._lock:
            task = self._running.pop(reference)
        try:
            machine, packed = done.result()
            with self._lock:
                self._done[machine] += 1
            well, value = pickle.loads(packed)  # the data comes from our own process
        except Exception as error:
            well, value = False, self._failure(error, task.timeout)
            if "keeper" in self.__dict__:
                self.keeper.actor.release.remote(reference.task_id().hex())
        if well:
            task.future.set_result(value)
        else:
            task.future.set_exception(value)
        self._begin()

    def _failure(self, error: Exception, timeout: float | None) -> Exception:
        """Return the error for a task without a result."""
        if isinstance(error, self._ray.exceptions.RayTaskError):
            cause = getattr(error, "cause", error)
            return BackendError(f"A machine of the Ray cluster cannot run tasks: {cause}")
        if not isinstance(error, self._ray.exceptions.RayError):
            return error  # the result cannot be unpickled, or Ray accepts no more tasks
        late = "" if timeout is None else f", or exceeded its limit of {timeout:g} s"
        return WorkerDied(
            f"A worker process of Ray ended abruptly ({type(error).__name__}){late}. Use fewer "
            "workers if memory is short."
        )


@dataclass(frozen=True)
class _Place:
    """The working directory of tasks, and the package versions that they require."""

    folder: str
    versions: Mapping[str, str]


@dataclass(frozen=True, eq=False)
class _RayTask:
    packed: bytes
    timeout: float | None
    future: Future[Any] = field(default_factory=Future)


def _connect(ray: Any, address: str, width: int) -> None:
    """Connect this process to the cluster at an address, or start one."""
    cpus = {"num_cpus": width, "include_dashboard": False} if address == "local" else {}
    asked = os.environ.get(_USAGE)
    os.environ.setdefault(_USAGE, "0")
    try:
        _knock(address)
        ray.init(address=address, log_to_driver=False, logging_level=logging.ERROR, **cpus)
    except (OSError, ValueError, RuntimeError, ray.exceptions.RayError) as error:
        raise BackendError(f"No Ray cluster at {address!r}: {error}") from error
    finally:
        if asked is None:
            del os.environ[_USAGE]


def _knock(address: str) -> None:
    """Raise OSError if nothing listens at HOST:PORT; Ray would retry for minutes."""
    host, colon, port = address.rpartition(":")
    if colon and port.isdecimal() and "/" not in host:
        socket.create_connection((host.strip("[]"), int(port)), _KNOCK_TIME).close()


def _call(place: _Place, packed: bytes, timeout: float | None) -> tuple[str, bytes]:
    """Run a task in a Ray worker; return its node id and the result of ``answer_task``."""
    import ray  # pyright: ignore[reportMissingImports]

    machine = ray.get_runtime_context().get_node_id()
    own = versions(_ALIKE)
    if own != place.versions:
        other = ", ".join(f"{k} {v}, not {place.versions[k]}" for k, v in own.items()
                          if v != place.versions[k])  # fmt: skip
        raise BackendError(f"the machine has {other}. Install the same versions on all machines.")
    with contextlib.suppress(OSError):
        os.chdir(place.folder)
    signal.setitimer(signal.ITIMER_REAL, timeout or 0.0)  # whose signal terminates the process
    try:
        return machine, answer_task(packed)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)


@dataclass(frozen=True)
class RayKeeper:
    """Accesses spending databases through the actor; can be sent to all machines of the cluster."""

    actor: Any

    def create(self, folder: Path) -> None:
        """Create a folder's database if it does not exist."""
        self._ask("create", folder)

    def transact(self, folder: Path, operation: Callable[..., T], *args: Any) -> T:
        """Return ``operation(connection, *args)``, run in one transaction."""
        return self._ask("transact", folder, operation, *args)

    @contextlib.contextmanager
    def owning(self, folder: Path) -> Iterator[str]:
        """Yield the name of a new reservation owner that exists until the block or worker ends."""
        import ray  # pyright: ignore[reportMissingImports]

        name = ray.get_runtime_context().get_task_id()
        ray.get(self.actor.hold.remote(folder, name))
        try:
            yield name
        finally:
            ray.get(self.actor.release.remote(name))

    def _ask(self, method: str, *args: Any) -> Any:
        import ray  # pyright: ignore[reportMissingImports]

        try:
            return ray.get(self.actor.do.remote(method, *args))
        except ray.exceptions.RayTaskError as error:
            raise error.cause from None


class _KeepingActor:
    """The single process that accesses the spending databases of a batch on a cluster."""

    def __init__(self) -> None:
        self._owners: dict[str, contextlib.ExitStack] = {}

    def do(self, method: str, *args: Any) -> Any:
        return getattr(LOCAL, method)(*args)

    def hold(self, folder: Path, name: str) -> None:
        self._owners[name] = contextlib.ExitStack()
        self._owners[name].enter_context(LOCAL.owning(folder, name))

    def release(self, name: str) -> None:
        if (owner := self._owners.pop(name, None)) is not None:
            owner.close()


def _keeping_actor(ray: Any) -> Any:
    """Start the actor on this machine, which has the databases."""
    from ray.util.scheduling_strategies import NodeAffinitySchedulingStrategy  # pyright: ignore[reportMissingImports]

    here = NodeAffinitySchedulingStrategy(ray.get_runtime_context().get_node_id(), soft=False)
    return ray.remote(num_cpus=0)(_KeepingActor).options(scheduling_strategy=here).remote()
