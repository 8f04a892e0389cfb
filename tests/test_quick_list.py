"""The list of long tests that ``make check`` leaves out names tests that exist."""

import json
from collections import Counter
from pathlib import Path

from quick import DURATIONS, LONG, write_durations

ROOT = Path(__file__).parents[1]


def test_listed_tests_exist() -> None:
    for node in json.loads(DURATIONS.read_bytes()):
        path, *_, name = node.split("::")
        assert f"def {name}(" in (ROOT / path).read_text(encoding="utf-8"), node


def test_only_long_tests_are_listed(tmp_path: Path) -> None:
    path = tmp_path / "durations.json"
    write_durations(Counter({"tests/a.py::test_long": LONG, "tests/a.py::test_short": 0.1}), path)
    assert json.loads(path.read_bytes()) == {"tests/a.py::test_long": LONG}
