"""Seconds of stages: all that was begun, in order, nothing in between lost."""

import itertools
from collections.abc import Mapping
from typing import Any

import pytest

from generator.method import stopwatch as ledger
from generator.method.stopwatch import Seconds, Stopwatch


class Clock:
    """Fake of the module ``time`` whose wall clock advances with each call."""

    def __init__(self) -> None:
        self.walls = itertools.accumulate(itertools.count(1))  # 1, 3, 6, 10 ...
        self.looks = itertools.count()

    def perf_counter(self) -> float:
        return float(next(self.walls))

    def process_time(self) -> float:
        return next(self.looks) / 2


def test_stages_share_all_the_time_between_the_first_step_and_the_stop(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(ledger, "time", Clock())
    heard = []
    clock = Stopwatch(("a", "b", "c"), lambda *told: heard.append(told))
    clock.step()
    clock.step()
    clock.step()
    seconds = clock.stop()
    assert heard == [("a", 1, 3), ("b", 2, 3), ("c", 3, 3)]
    assert list(seconds.items()) == [
        ("a", Seconds(2, 0.5)), ("b", Seconds(3, 0.5)), ("c", Seconds(4, 0.5)),
    ]  # fmt: skip


def test_a_watch_hears_of_each_stage_that_ends_and_costs_it_nothing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    clock = Clock()
    monkeypatch.setattr(ledger, "time", clock)
    heard = []

    def watch(stage: str, found: Mapping[str, Any]) -> None:
        heard.append((stage, dict(found)))
        clock.perf_counter()

    watched = Stopwatch(("a", "b", "c"), watch=watch)
    watched.step()
    assert heard == []
    watched.step(cup=1)
    watched.step()
    seconds = watched.stop(cup=2, lid=3)
    assert heard == [("a", {"cup": 1}), ("b", {"cup": 1}), ("c", {"cup": 2, "lid": 3})]
    assert [s.wall for s in seconds.values()] == [3 - 1, 15 - 10, 36 - 28], "6, 21: the watch's"


def test_what_was_not_begun_has_no_seconds() -> None:
    clock = Stopwatch(("a", "b"))
    clock.step()
    assert list(clock.stop()) == ["a"]
    assert dict(Stopwatch(("a",)).stop()) == {}
