"""How many threads a process computes on."""

import os
import threading
import time

import pytest
import torch
from bounded import LONG, at_once

from generator import threads as cores


def test_blocks_of_several_threads_do_not_mix() -> None:
    before, seen, lasts = torch.get_num_threads(), [], threading.Barrier(3)
    torch.set_num_threads(3)

    def work() -> None:
        lasts.wait(LONG)
        for _ in range(20):
            with cores.single_thread(), cores.single_thread():
                time.sleep(0.001)
                seen.append(torch.get_num_threads())

    try:
        at_once(*[work] * 3)
        assert seen == [1] * 60
        assert torch.get_num_threads() == 3
        fresh: list[int] = []
        at_once(lambda: fresh.append(torch.get_num_threads()))
        assert fresh == [3], "what new threads begin with"
    finally:
        torch.set_num_threads(before)


def test_processors_are_those_this_process_may_use() -> None:
    assert 1 <= cores.cores() <= (os.cpu_count() or 1)


@pytest.mark.parametrize(
    "told, threads",
    [("1", 1), (" 3 ", 3), ("4,2", 4), ("", None), ("0", None), ("-1", None), ("many", None)],
)
def test_threads_are_those_of_openmp(
    told: str, threads: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("OMP_NUM_THREADS", told)
    assert cores.threads() == (threads or cores.cores())
    monkeypatch.delenv("OMP_NUM_THREADS")
    assert cores.threads() == cores.cores()
