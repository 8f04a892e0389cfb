"""What all pools of workers have in common, and what their tasks may keep in a process."""

from __future__ import annotations

import pickle
from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future
from functools import cache
from typing import Any, TypeVar

T = TypeVar("T")

_AHEAD = 4  # tasks for each worker, given out before the first one's result is taken


class TaskPool(ABC):
    """Runs tasks in other processes, at most ``width`` at a time, in the order they come.

    Results do not depend on which process runs a task. A process that dies fails its task alone.
    """

    width: int

    @abstractmethod
    def submit(
        self, function: Callable[..., T], *args: Any, timeout: float | None = None
    ) -> Future[T]:
        """Have a worker call a function; both, and what it returns, must be picklable.

        The pending result is what the function returns or raises, or ``WorkerDied``; ``timeout``
        are the seconds, from the task's own start, after which its process is killed.
        """

    @abstractmethod
    def close(self, grace: float = 0.0) -> None:
        """End the pool: what has not begun is cancelled, the rest is stopped. May be called twice.

        ``grace`` are the seconds that running tasks have to end by themselves where the pool can
        interrupt them.
        """

    def map(self, function: Callable[[Any], T], items: Iterable[Any]) -> Iterator[T]:
        """Yield the function's result for every item, in their order.

        Only so many tasks are given out before their results are taken that no worker need wait.
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
    """Return what a pickled function returns, called at the first time in this process.

    Tasks share by it what takes long to make and need not be made for each, such as environments.
    """
    return pickle.loads(packed)()
