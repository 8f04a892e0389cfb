"""What is printed: texts that may be foreign, and readers that stop reading."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable


def escaped(text: str) -> str:
    """Return a text that may be foreign as a terminal can show it: its lines, no controls."""
    return "".join(c if c.isprintable() or c == "\n" else repr(c)[1:-1] for c in text)


def piped(run: Callable[[], int]) -> int:
    """Run a command; end it quietly where nobody reads on what it prints, as ``| head`` does."""
    try:
        code = run()
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # for the flush at the end
        return 128 + 13  # as of a process that SIGPIPE ends
    return code
