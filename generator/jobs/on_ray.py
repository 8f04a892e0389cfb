"""A Ray cluster as the worker pool of a batch, and the actor that owns its database of money."""

from __future__ import annotations

import contextlib
import logging
import os
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..calls.money.database import LOCAL, T
from ..errors import BackendError
from .workers import WorkerDied

_USAGE = "RAY_USAGE_STATS_ENABLED"  # else Ray tells its makers that it was started


class RayPool:
    """At most ``width`` tasks of a Ray cluster, a CPU each; its machines share the batch's folder.

    ``address`` is as ``ray.init`` takes it; "local" starts Ray here, with ``width`` CPUs.

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
        asked = os.environ.get(_USAGE)
        os.environ.setdefault(_USAGE, "0")
        try:
            ray.init(address=address, log_to_driver=False, logging_level=logging.ERROR, **cpus)
        except (ConnectionError, ValueError, RuntimeError) as error:
            raise BackendError(f"No Ray at {address!r}: {error}") from error
        finally:
            if asked is None:
                del os.environ[_USAGE]
        self._call = ray.remote(num_cpus=1, max_retries=0)(_call)
        self.keeper = RayKeeper(_keeping_actor(ray))

    def submit(self, function: Callable[..., Any], *args: Any) -> Future[Any]:
        """Have a worker call a function; ``WorkerDied`` says that its process ended."""
        result: Future[Any] = Future()
        reference = self._call.remote(function, *args)
        name = reference.task_id().hex()

        def pass_on(done: Future[Any]) -> None:
            error: Any = done.exception()
            if error is None:
                result.set_result(done.result())
            elif isinstance(error, self._ray.exceptions.RayTaskError):
                result.set_exception(error.cause)
            else:
                self.keeper.actor.release.remote(name)
                result.set_exception(WorkerDied(f"Ray's worker died: {type(error).__name__}."))

        reference.future().add_done_callback(pass_on)
        return result

    def close(self, grace: float = 0.0) -> None:
        """Leave the cluster: unfinished tasks are dropped, whatever ``grace``."""
        self._ray.shutdown()


@dataclass(frozen=True)
class RayKeeper:
    """Has the actor work on databases of money; can be sent to all machines of the cluster."""

    actor: Any

    def create(self, folder: Path) -> None:
        """Make a folder's database, unless there is one."""
        self._ask("create", folder)

    def transact(self, folder: Path, operation: Callable[..., T], *args: Any) -> T:
        """Return ``operation(connection, *args)``, done in one transaction."""
        return self._ask("transact", folder, operation, *args)

    @contextlib.contextmanager
    def owning(self, folder: Path) -> Iterator[str]:
        """Name an owner of reservations: this task, alive until the block or its worker ends."""
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
    """The one process that works on the databases of a cluster's batch."""

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
    """Start the actor on this machine, where the databases are."""
    from ray.util.scheduling_strategies import NodeAffinitySchedulingStrategy  # pyright: ignore[reportMissingImports]

    here = NodeAffinitySchedulingStrategy(ray.get_runtime_context().get_node_id(), soft=False)
    return ray.remote(num_cpus=0)(_KeepingActor).options(scheduling_strategy=here).remote()


def _call(function: Callable[..., Any], *args: Any) -> Any:
    return function(*args)
