"""What errors and commands show of foreign texts."""

import os
import pickle
import shlex
import subprocess
import sys

import pytest

from generator.errors import InputError, StorageError, escape


def test_what_is_shown_holds_no_controls():
    shown = escape("a\x1b[2Jb\x9bc\nd\u202ee\r\t\ud800 \u00e9\u00a0杯\u3000")
    assert shown == "a\\x1b[2Jb\\x9bc\nd\\u202ee\\r\\t\\ud800 \u00e9\u00a0杯\u3000"


def test_what_an_error_quotes_reaches_no_terminal():
    error = InputError("It is '\x1b[2J', 'é'.\nUse another.")
    assert str(error) == "It is '\\x1b[2J', 'é'.\nUse another."
    assert str(InputError(str(error))) == str(error) == str(pickle.loads(pickle.dumps(error)))
    assert str(StorageError("No \x07.")) == "No \\x07." and str(InputError()) == ""


RUN = """
import sys
from generator.io.terminal import run_piped
def run():
    {}
    return 0
raise SystemExit(run_piped(run))
"""


def ended(body: str, shell: str) -> subprocess.CompletedProcess[str]:
    """Run a command with this body under a shell's redirection."""
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONUNBUFFERED"}
    command = shlex.join([sys.executable, "-c", RUN.format(body)])
    return subprocess.run(
        ["bash", "-c", f"set -o pipefail; {command} {shell}"],
        capture_output=True, text=True, env=environment, timeout=60,
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(
    ("body", "shell", "code", "said"),
    [
        ("print(*range(100_000), sep='\\n')", "| head -1", 141, ""),
        ("import time; time.sleep(0.5); print('few')", "| true", 141, ""),
        ("import time; time.sleep(0.5); print('few'); sys.exit(0)", "| true", 141, ""),
        ("print('few')", ">&-", 0, ""),
        ("print('few')", "> /dev/full", 5, "error: the output could not be written"),
        ("print('few'); raise BrokenPipeError('of a worker')", "", 1, "of a worker"),
        ("print('few'); sys.exit(3)", "", 3, ""),
    ],
)
def test_what_is_printed_and_not_read_ends_a_command_quietly(
    body: str, shell: str, code: int, said: str
) -> None:
    run = ended(body, shell)
    assert run.returncode == code, run.stderr
    assert said in run.stderr and bool(said) == bool(run.stderr)
