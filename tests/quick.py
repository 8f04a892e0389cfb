"""``--quick`` leaves out the tests that ``durations.json`` lists as long.

``pytest -m "not slow" --record-durations`` writes the list anew, on an idle machine.
"""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path

import pytest

DURATIONS = Path(__file__).with_name("durations.json")
LONG = 0.5
"""Seconds from which a test function, all its parameters together, is left out."""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--quick", action="store_true", help="leave out long tests")
    parser.addoption("--record-durations", action="store_true", help="list long tests anew")


def pytest_configure(config: pytest.Config) -> None:
    if config.getoption("--record-durations"):
        config.pluginmanager.register(_Recorder())


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if not config.getoption("--quick"):
        return
    long = json.loads(DURATIONS.read_bytes())
    left_out = [item for item in items if _function(item.nodeid) in long]
    config.hook.pytest_deselected(items=left_out)
    items[:] = [item for item in items if _function(item.nodeid) not in long]


class _Recorder:
    """Adds up the time of each test function, and writes the long ones."""

    def __init__(self) -> None:
        self.seconds: Counter[str] = Counter()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self.seconds[_function(report.nodeid)] += report.duration

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        if not hasattr(session.config, "workerinput"):  # the controller has all reports
            write_durations(self.seconds)


def write_durations(seconds: Counter[str], path: Path = DURATIONS) -> None:
    """Write the functions that take at least ``LONG`` seconds."""
    long = {name: round(s, 1) for name, s in sorted(seconds.items()) if s >= LONG}
    path.write_text(json.dumps(long, indent=0) + "\n", encoding="utf-8")


def _function(node: str) -> str:
    """Return the id of a test without its parameters."""
    return node.split("[")[0]
