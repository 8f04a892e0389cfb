"""The pool on a Ray cluster of two nodes: equal to processes, even if workers fail."""

import logging
import os
import pickle
import sys
import time
from collections.abc import Iterator
from concurrent.futures import CancelledError, Future
from contextlib import closing
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from bounded import LONG
from ray_cluster import two_nodes

from generator.errors import BackendError, InputError
from generator.jobs.pools import pool_of
from generator.jobs.task_pool import TaskPool, call_once
from generator.jobs.workers import WorkerDied

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def cluster() -> Iterator[str]:
    with two_nodes(Path(__file__).parent) as address:
        yield address


@pytest.fixture(params=["processes", "Ray"])
def pool(request: pytest.FixtureRequest) -> Iterator[TaskPool]:
    ray = request.getfixturevalue("cluster") if request.param == "Ray" else None
    with closing(pool_of(2, ray)) as made:
        yield made


def result(future: Future[Any]) -> Any:
    return future.result(LONG)


def square(number: int) -> int:
    time.sleep(0.1 * (number == 0))
    return number * number


def refuse(text: str) -> None:
    raise InputError(f"no {text}")


def end(code: int) -> None:
    os._exit(code)


def arrays() -> dict[str, np.ndarray]:
    return {"zeros": np.zeros(300_000)}


def stamp() -> tuple[int, float]:
    return os.getpid(), time.monotonic()


def test_results_come_in_order(pool: TaskPool) -> None:
    assert list(pool.map(square, range(6))) == [0, 1, 4, 9, 16, 25]
    assert list(pool.map(square, [])) == []


def test_an_error_is_the_same_as_here(pool: TaskPool) -> None:
    with pytest.raises(InputError, match=r"^no tea$"):
        result(pool.submit(refuse, "tea"))


class Local:
    """Can be pickled but not unpickled."""

    def __reduce__(self) -> Any:
        return end_of_pickle, ()


def end_of_pickle() -> None:
    raise ValueError("not here")


def test_what_cannot_be_unpickled_is_an_error(pool: TaskPool) -> None:
    with pytest.raises(ValueError, match="not here"):
        result(pool.submit(Local))
    assert result(pool.submit(square, 2)) == 4


def test_arrays_come_as_own_copies(pool: TaskPool) -> None:
    """Arrays in Ray's object store would be read-only."""
    made = result(pool.submit(arrays))["zeros"]
    made += 1
    assert made.sum() == 300_000


def test_a_death_fails_one_task(pool: TaskPool) -> None:
    futures = [pool.submit(end, 9), *(pool.submit(square, k) for k in range(3))]
    with pytest.raises(WorkerDied, match="ended abruptly"):
        result(futures[0])
    assert [result(f) for f in futures[1:]] == [0, 1, 4]


def test_a_task_that_takes_too_long_is_given_up(pool: TaskPool) -> None:
    with pytest.raises(WorkerDied, match="exceeded its limit of 1 s"):
        result(pool.submit(time.sleep, 2 * LONG, timeout=1.0))
    assert result(pool.submit(square, 3, timeout=LONG)) == 9


def test_tasks_of_a_process_share_what_is_made_once(pool: TaskPool) -> None:
    import cloudpickle

    make = cloudpickle.dumps(stamp)
    made = list(pool.map(call_once, [make] * 8))
    assert len(set(made)) == len({pid for pid, _ in made}) <= 4


def test_at_most_its_width_runs(cluster: str) -> None:
    def span() -> tuple[float, float]:
        start = time.monotonic()
        time.sleep(0.3)
        return start, time.monotonic()

    with closing(pool_of(1, cluster)) as pool:
        spans = sorted(result(f) for f in [pool.submit(span) for _ in range(3)])
    assert all(ended <= begun for (_, ended), (begun, _) in pairwise(spans))


def test_both_nodes_work_and_are_told(cluster: str, caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level(logging.INFO, "generator.jobs"), closing(pool_of(2, cluster)) as pool:
        assert list(pool.map(time.sleep, [0.2] * 8)) == [None] * 8
        pool.close()
    told = [record.args for record in caplog.records]
    assert len({node for _, node in told}) == 2
    assert sum(count for count, _ in told) == 8


def test_closing_cancels_what_waits(pool: TaskPool) -> None:
    futures = [pool.submit(time.sleep, LONG) for _ in range(4)]
    pool.close()
    with pytest.raises(CancelledError):
        result(futures[3])
    pool.close()


def test_a_connection_of_the_callers_own_is_used_and_kept(cluster: str) -> None:
    import ray

    ray.init(address=cluster, log_to_driver=False)
    try:
        with closing(pool_of(2, "nobody:1")) as pool:
            assert list(pool.map(square, range(3))) == [0, 1, 4]
            pool.submit(time.sleep, 2 * LONG)
        assert ray.is_initialized()
        with closing(pool_of(2, cluster)) as pool:  # the sleeper's place is free
            assert list(pool.map(square, range(3))) == [0, 1, 4]
    finally:
        ray.shutdown()


def test_other_versions_are_refused(cluster: str, monkeypatch: pytest.MonkeyPatch) -> None:
    from generator.jobs import on_ray

    own = on_ray.versions(("tabletopgen", "mujoco", "numpy"))
    monkeypatch.setattr(on_ray, "versions", lambda names: {**own, "mujoco": "1.0"})
    with (
        closing(pool_of(1, cluster)) as pool,
        pytest.raises(BackendError, match=r"has mujoco .*, not 1\.0\. Install the same"),
    ):
        result(pool.submit(square, 1))


def test_a_task_that_ray_takes_no_more_fails_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    answer: Future[Any] = Future()

    class Reference:
        def future(self) -> Any:
            return answer

    class Calls:
        taken = 0

        def remote(self, *task: Any) -> Any:
            self.taken += 1
            if self.taken > 1:
                raise ConnectionError("Ray is gone")
            return Reference()

    errors = SimpleNamespace(RayError=ZeroDivisionError, RayTaskError=ZeroDivisionError)
    stub = SimpleNamespace(
        is_initialized=lambda: True, exceptions=errors, cancel=lambda *_, **__: None,
        remote=lambda **_: lambda _: Calls(),
    )  # fmt: skip
    monkeypatch.setitem(sys.modules, "ray", stub)
    with closing(pool_of(1, "anywhere")) as pool:
        first, second = pool.submit(square, 2), pool.submit(square, 3)
        answer.set_result(("here", pickle.dumps((True, 4))))
        assert result(first) == 4
        with pytest.raises(ConnectionError, match="Ray is gone"):
            result(second)


def test_no_cluster_is_told() -> None:
    pytest.importorskip("ray")
    with pytest.raises(BackendError, match=r"No Ray cluster at '127\.0\.0\.1:9'"):
        pool_of(1, "127.0.0.1:9")
