"""No test waits for ever: what waits for a thread, a process or a lock says how long."""

import ast
import tomllib
from pathlib import Path

TESTS = Path(__file__).parent
WAITS = ("wait", "join", "communicate", "acquire", "result")
"""Calls that wait for as long as it takes if they are given nothing."""

STARTS = ("run", "check_call", "check_output", "call")
"""Functions of ``subprocess`` that wait for what they start."""


def endless(code: str) -> list[int]:
    """Return the lines of the calls that may wait forever."""
    found = []
    for node in ast.walk(ast.parse(code)):
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute):
            continue
        owner, name = ast.unparse(node.func.value), node.func.attr
        bare = name in WAITS and not node.args and not node.keywords
        timed = any(k.arg in ("timeout", None) for k in node.keywords)
        starts = owner == "subprocess" and name in STARTS and not timed
        if (bare and owner != "os" and not timed) or starts:
            found.append(node.lineno)
    return found


def test_endless_waits_are_found() -> None:
    code = "a.join()\na.join(3)\nsubprocess.run([])\nsubprocess.run([], timeout=3)\np.wait()"
    assert endless(code) == [1, 3, 5]


def test_no_test_waits_for_ever() -> None:
    found = {
        f"{path.relative_to(TESTS)}:{line}"
        for path in sorted(TESTS.rglob("*.py"))
        for line in endless(path.read_text(encoding="utf-8"))
    }
    assert not found


def test_every_test_has_a_limit() -> None:
    settings = tomllib.loads((TESTS.parent / "pyproject.toml").read_text(encoding="utf-8"))
    assert 0 < settings["tool"]["pytest"]["ini_options"]["timeout"] <= 600
