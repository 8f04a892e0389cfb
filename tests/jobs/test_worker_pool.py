"""A task that exceeds its timeout fails alone, whatever the timer thread does."""

import threading
import time
from contextlib import closing
from typing import Any

import pytest

from generator.jobs import workers
from generator.jobs.workers import WorkerDied, WorkerPool

LONG = 60.0


def test_a_task_done_as_its_time_ends_leaves_the_next_one_alone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    receive, kill, answered = workers._receive, workers._kill, threading.Event()

    def receive_and_say(process: Any) -> bytes:
        packed = receive(process)
        if late.is_set():
            answered.set()
        return packed

    def kill_after_the_answer(process: Any) -> int:
        if isinstance(threading.current_thread(), threading.Timer):
            late.set()
            assert answered.wait(LONG)
            time.sleep(0.2)
        return kill(process)

    late = threading.Event()
    monkeypatch.setattr(workers, "_receive", receive_and_say)
    monkeypatch.setattr(workers, "_kill", kill_after_the_answer)
    with closing(WorkerPool(1)) as pool:
        assert pool.submit(pow, 2, 2).result(LONG) == 4  # the process runs
        assert pool.submit(time.sleep, 1.0, timeout=0.2).result(LONG) is None
        assert late.is_set()
        assert [pool.submit(pow, 3, 2).result(LONG) for _ in range(2)] == [9, 9]
        assert len(pool.pids) == 1


def test_many_tasks_given_up_in_a_row_each_fail_alone() -> None:
    with closing(WorkerPool(2)) as pool:
        slow = [pool.submit(time.sleep, LONG, timeout=0.3) for _ in range(6)]
        quick = [pool.submit(pow, k, 2) for k in range(6)]
        for future in slow:
            with pytest.raises(WorkerDied, match=r"exceeded its limit of 0\.3 s"):
                future.result(LONG)
        assert [future.result(LONG) for future in quick] == [k * k for k in range(6)]
