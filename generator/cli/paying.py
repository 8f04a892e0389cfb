"""What commands that ask servers say of it: which calls, at what price."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import DryRunError

if TYPE_CHECKING:
    from ..running import Session

VARIABLE = "TABLETOPGEN_CALLS"
"""Environment variable naming the folder where answers of servers are kept."""


def calls_folder(calls: Path | None) -> Path:
    """Return where answers of servers are kept: in ``calls``, else where this user's are."""
    import platformdirs

    usual = os.environ.get(VARIABLE) or Path(platformdirs.user_cache_dir("tabletopgen")) / "calls"
    return Path(calls or usual)


def open_session(
    calls: Path | None, prices: Path | None, budget: float | None, dry: bool
) -> Session:
    """Return a session that keeps answers in ``calls_folder(calls)``."""
    from ..running import Session
    from ..running.prices import Prices
    from ..running.store import CallStore

    return Session(
        store=CallStore(calls_folder(calls)),
        prices=Prices.shipped() if prices is None else Prices.load(prices),
        budget=budget,
        dry=dry,
    )


@contextmanager
def answering(session: Session) -> Iterator[None]:
    """End a session's calls with the command; where it fails, tell on standard error what it cost.

    A dry run that came to a call is no failure of its own, but ends the command likewise.
    """
    try:
        yield
    except BaseException as error:
        session.stop.set()
        spent = session.account.text(session.prices.currency)
        if spent and not isinstance(error, DryRunError):
            print(f"{spent}\nWhat was answered is kept.", file=sys.stderr)
        raise


def paid(session: Session) -> bool:
    """Return whether anything was asked of a server, rather than of the store alone."""
    return any(entry.outcome != "cached" for entry in session.account.entries)


def told(error: DryRunError, as_json: bool) -> int:
    """Print what a dry run came to; return the exit code of success."""
    from .printing import emit

    calls = str(error).splitlines()
    rest = "Nothing was sent; what comes after depends on the answers."
    if not calls:
        rest = "No server would be asked. Nothing was made; leave out --dry-run for that."
    emit({"dry_run": calls}, as_json, lambda: [*calls, rest])
    return 0
