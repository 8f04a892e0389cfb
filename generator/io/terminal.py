"""What is printed: texts that may be foreign, and readers that stop reading."""

from __future__ import annotations

import errno
import os
import select
import sys
from collections.abc import Callable

_UNREAD = 128 + 13  # as of a process that SIGPIPE ends
_UNWRITTEN = 5  # as of a StorageError


def run_piped(run: Callable[[], int]) -> int:
    """Run a command; return its exit code, or one for what it printed and could not.

    It ends quietly where nobody reads on, as ``| head`` does, and says so where the disk is full.
    Any other error is as ``run`` raises it.
    """
    try:
        try:
            return run()
        finally:
            if sys.stdout is not None:
                sys.stdout.flush()
    except OSError as error:
        if sys.stdout is None:
            raise
        unread = isinstance(error, BrokenPipeError) and _is_unread()
        if not unread and (error.errno != errno.ENOSPC or error.filename is not None):
            raise
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())  # for the flush at the end of the process
        os.close(nowhere)
        if unread:
            return _UNREAD
        print(f"error: what was printed could not be written: {error.strerror}.", file=sys.stderr)
        return _UNWRITTEN


def _is_unread() -> bool:
    """Return whether standard output is a pipe that nobody reads any more."""
    try:
        watched = select.poll()
        watched.register(sys.stdout.fileno(), 0)
        return bool(watched.poll(0))
    except (OSError, ValueError):  # no file
        return False
