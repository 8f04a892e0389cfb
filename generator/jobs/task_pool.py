"""The common interface of worker pools, and objects cached in their processes."""

from __future__ import annotations

import pickle
from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future
from functools import cache
from typing import Any, TypeVar

T = TypeVar("T")

_AHEAD = 4  # tasks submitted per worker before the first result is consumed


class TaskPool(ABC):
    """Runs tasks in other processes, up to ``width`` in parallel, in order of submission.

    Results do not depend on the process that runs a task. The death of a process fails its task
    only.
    """

    width: int

    @abstractmethod
    def submit(
        self, function: Callable[..., T], *args: Any, timeout: float | None = None
    ) -> Future[T]:
        """Run a function in a worker; the function, its arguments and its result must be picklable.

        The returned future has the function's result or exception, or ``WorkerDied``. ``timeout``
        is in seconds from the start of the task, after which its process is killed.
        """

    @abstractmethod
    def close(self, grace: float = 0.0) -> None:
        """Close the pool: cancel pending tasks and stop running ones. May be called twice.

        ``grace`` is the time in seconds that running tasks have to end after an interrupt, if the
        pool can interrupt them.
        """

    def map(self, function: Callable[[Any], T], items: Iterable[Any]) -> Iterator[T]:
        """Yield the function's results for all items, in order.

        Only enough tasks are submitted ahead to keep every worker busy.
        """
        pending = deque[Future[T]]()
        for item in items:
            pending.append(self.submit(function, item))
            if len(pending) >= _AHEAD * self.width:
                yield pending.popleft().result()
        while pending:
            yield pending.popleft().result()


@cache
def call_once(packed: bytes) -> Any:
    """Return the result of a pickled function, which is called once per process and then cached.

    Tasks use it to share objects that are slow to create, such as environments.
    """
    return pickle.loads(packed)()
