"""Permitted behaviour of a case: the package's errors, and output that is safe for terminals.

Used by the targets, inside a worker.
"""

import contextlib
import io
import unicodedata
from collections.abc import Callable, Iterator
from typing import Any
from unittest import mock

from generator.errors import TabletopError

MOST_MESSAGE = 20_000
"""Characters that an error's message may have."""


class Unfit(AssertionError):
    """Text that must not reach a terminal, or a forbidden result."""


def accepts(*calls: Callable[[], Any]) -> bool:
    """Make every call; return whether none was refused.

    Raises:
        Exception: what no call may raise.
    """
    good = True
    for call in calls:
        try:
            call()
        except TabletopError as error:
            check_printable(str(error), "a message")
            good = False
    return good


def accepts_any(*calls: Callable[[], Any]) -> bool:
    """Make every call; return whether one was not refused; see ``accepts``."""
    taken = [accepts(call) for call in calls]
    return any(taken)


@contextlib.contextmanager
def reading(apart: bool) -> Iterator[None]:
    """Read foreign files in child processes (``apart``), as for users, or in this process.

    The same code runs in both; a child takes most of the time of a small case, though it is forked.
    """
    from generator.sandbox import runner

    from .forking import forked_children

    inside = mock.patch.object(runner, "is_inside", lambda: True)
    with forked_children() if apart else inside:
        yield


def command(*arguments: str) -> bool:
    """Run a ``tabletopgen`` command; return whether it succeeded.

    Raises:
        Unfit: it prints what a terminal obeys.
        Exception: what no command may raise.
    """
    from generator import cli

    return _printed(lambda: cli.run(list(arguments)))


def _printed(run: Callable[[], int]) -> bool:
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
        try:
            code = run()
        except SystemExit as stop:
            code = stop.code if isinstance(stop.code, int) else 2
    check_printable(out.getvalue(), "what is printed")
    return not code


def check_printable(text: str, what: str) -> None:
    """Check that a text has no effect on a terminal, can be encoded, and is short.

    Raises:
        Unfit: it does.
    """
    for letter in text:
        if letter not in "\n\t" and unicodedata.category(letter) in ("Cc", "Cs"):
            raise Unfit(f"{what} holds {letter!r}: {text[:300]!r}")
    if len(text) > 50 * MOST_MESSAGE:
        raise Unfit(f"{what} has {len(text)} characters: {text[:300]!r}")
