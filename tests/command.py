"""The command line, run within the test's own process."""

from __future__ import annotations

from generator import cli


def command(*args: str) -> int:
    """Run a command; return its exit code."""
    try:
        return cli.run(list(args))
    except SystemExit as stop:  # wrong usage, or --help
        return int(stop.code or 0)
