"""How many threads a process computes on."""

from __future__ import annotations

import os

import pytest

from generator import cores


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
