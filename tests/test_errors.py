"""What errors and commands show of foreign texts."""

from __future__ import annotations

import pickle
import subprocess
import sys

from generator.errors import InputError, StorageError
from generator.terminal import escaped


def test_what_is_shown_holds_no_controls():
    shown = escaped("a\x1b[2Jb\x9bc\nd\u202ee\r\t\ud800 \u00e9 杯")
    assert shown == "a\\x1b[2Jb\\x9bc\nd\\u202ee\\r\\t\\ud800 \u00e9 杯"


def test_what_an_error_quotes_reaches_no_terminal():
    error = InputError("It is '\x1b[2J', 'é'.\nUse another.")
    assert str(error) == "It is '\\x1b[2J', 'é'.\nUse another."
    assert str(InputError(str(error))) == str(error) == str(pickle.loads(pickle.dumps(error)))
    assert str(StorageError("No \x07.")) == "No \\x07." and str(InputError()) == ""


def test_a_reader_that_stops_ends_a_command_quietly() -> None:
    code = (
        "from generator.terminal import piped\n"
        "raise SystemExit(piped(lambda: print('x' * 10, *range(100_000), sep='\\n') or 0))"
    )
    with subprocess.Popen(
        [sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as run:
        assert run.stdout is not None and run.stderr is not None
        assert run.stdout.readline() == "xxxxxxxxxx\n"
        run.stdout.close()
        assert run.stderr.read() == "" and run.wait(30) == 141
