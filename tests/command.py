"""The command line, run in the test's process."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, NamedTuple

import pytest

from generator import cli


def command(*args: str) -> int:
    try:
        return cli.run(list(args))
    except SystemExit as stop:  # wrong usage, or --help
        return int(stop.code or 0)


class Shown(NamedTuple):
    out: str
    err: str

    @property
    def facts(self) -> Any:
        return json.loads(self.out)


@dataclass(frozen=True)
class Shell:
    """Runs commands that end with an exit code, and returns their output."""

    capsys: pytest.CaptureFixture[str]
    before: tuple[str, ...] = ()
    """Words that every command begins with."""

    def of(self, *words: str) -> Shell:
        return Shell(self.capsys, words)

    def __call__(self, *args: str, code: int = 0) -> Shown:
        self.capsys.readouterr()  # output of earlier commands
        assert command(*self.before, *args) == code
        return Shown(*self.capsys.readouterr())
