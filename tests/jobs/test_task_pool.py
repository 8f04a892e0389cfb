"""Properties of all pools: ordered results, limited lookahead, one-time setup per process."""

import itertools
import sys
from concurrent.futures import Future
from typing import Any

import cloudpickle
import pytest

from generator.errors import BackendError
from generator.jobs.pools import pool_of
from generator.jobs.task_pool import TaskPool, call_once
from generator.jobs.workers import WorkerPool


class Here(TaskPool):
    """Runs tasks immediately, and counts them."""

    width = 2

    def __init__(self) -> None:
        self.begun = 0

    def submit(self, function: Any, *args: Any, timeout: float | None = None) -> Future[Any]:
        self.begun += 1
        done = Future[Any]()
        done.set_result(function(*args))
        return done

    def close(self, grace: float = 0.0) -> None: ...


def test_results_come_in_order_and_without_end() -> None:
    pool = Here()
    results = pool.map(lambda k: k * k, itertools.count())
    assert list(itertools.islice(results, 5)) == [0, 1, 4, 9, 16]
    assert pool.begun < 20, "tasks are given out a few at a time"


def test_few_items_are_all_begun_at_once() -> None:
    pool = Here()
    assert next(pool.map(str, range(4))) == "0"
    assert pool.begun == 4


def test_what_is_made_once_is_the_same_for_all_tasks() -> None:
    packed = cloudpickle.dumps(object)
    assert call_once(packed) is call_once(packed)
    assert call_once(packed) is not call_once(cloudpickle.dumps(list))


def test_without_an_address_processes_of_this_machine_work() -> None:
    pool = pool_of(3)
    assert isinstance(pool, WorkerPool) and pool.width == 3
    pool.close()


def test_a_missing_ray_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ray", None)
    with pytest.raises(BackendError, match=r"pip install 'tabletopgen\[ray\]'"):
        pool_of(2, "auto")
