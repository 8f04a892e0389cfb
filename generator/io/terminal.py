"""Handling of closed pipes and full disks when standard output is written."""

from __future__ import annotations

import errno
import os
import select
import sys
from collections.abc import Callable

_UNREAD = 128 + 13  # exit code of a process that SIGPIPE ends
_UNWRITTEN = 5  # exit code of a StorageError


def run_piped(run: Callable[[], int]) -> int:
    """Run a command and return its exit code, or an error code if its output cannot be written.

    The command ends quietly if the reader closes the pipe, as ``| head`` does, and prints an error
    if the disk is full. All other errors of ``run`` are propagated.
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
        os.dup2(nowhere, sys.stdout.fileno())  # for the flush at process exit
        os.close(nowhere)
        if unread:
            return _UNREAD
        print(f"error: the output could not be written: {error.strerror}.", file=sys.stderr)
        return _UNWRITTEN


def _is_unread() -> bool:
    """Return whether standard output is a pipe whose reader has closed it."""
    try:
        watched = select.poll()
        watched.register(sys.stdout.fileno(), 0)
        return bool(watched.poll(0))
    except (OSError, ValueError):  # no file
        return False
