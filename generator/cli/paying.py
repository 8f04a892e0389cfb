"""What commands that ask servers say of it: which calls, at what price."""

from __future__ import annotations

import hashlib
import json
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import DryRunError, InputError, escaped
from ..io.reading import read_regular
from ..scene.provenance import plain
from .choosing import Roles, lines_of

if TYPE_CHECKING:
    from ..calls import Session

VARIABLE = "TABLETOPGEN_CALLS"
"""Environment variable naming the folder where answers of servers are kept."""

_MOST_BYTES = 2**30  # of a file that decides a scene


def calls_folder(calls: Path | None) -> Path:
    """Return where answers of servers are kept: in ``calls``, else where this user's are."""
    import platformdirs

    usual = os.environ.get(VARIABLE) or Path(platformdirs.user_cache_dir("tabletopgen")) / "calls"
    return Path(calls or usual)


def open_session(
    calls: Path | None, prices: Path | None, budget: float | None, dry: bool
) -> Session:
    """Return a session that keeps answers in ``calls_folder(calls)``."""
    from ..calls import Session
    from ..calls.money.prices import Prices
    from ..calls.store import CallStore

    return Session(
        store=CallStore(calls_folder(calls)),
        prices=Prices.shipped() if prices is None else Prices.load(prices),
        budget=budget,
        dry=dry,
    )


def scene_key(*decisive: Any) -> str:
    """Return what names a scene in ``answering``, by all that decides it; of files, the content."""
    values = [_content(value) if isinstance(value, Path) else value for value in decisive]
    text = json.dumps(plain(values), sort_keys=True, default=str)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def _content(path: Path) -> str:
    try:
        content = read_regular(path, "The file", InputError, max_bytes=_MOST_BYTES)
        return hashlib.sha256(content).hexdigest()
    except InputError:  # who needs it tells of it
        return str(path)


@contextmanager
def answering(session: Session, scene: str) -> Iterator[None]:
    """Have a session know what earlier runs of a scene spent, and end its calls with the command.

    Where the command fails, what it cost is told on standard error. A dry run that came to a call
    is no failure of its own, but ends the command likewise.

    Raises:
        StorageError: what was spent cannot be read.
        InputError: it was in another currency than that of the price table.
    """
    spending = session.resume(scene)
    assert spending is not None
    try:
        yield
    except BaseException as error:
        session.stop.set()
        spent = session.account.text(session.prices.currency)
        if spent and not isinstance(error, DryRunError):
            told = f"{spent}\nWhat was answered is kept; {spending.path} says what was spent."
            print(escaped(told), file=sys.stderr)
        raise


def paid(session: Session, made: Path) -> bool:
    """Return whether the bundle ``made`` is to get a ledger: one that has none, or has to grow."""
    from ..calls.money.account import LEDGER

    entries = session.account.entries
    now = any(entry.outcome != "cached" and not entry.earlier for entry in entries)
    return now or (any(e.earlier for e in entries) and not (made / LEDGER).exists())


def told(error: DryRunError, roles: Roles | None, as_json: bool) -> int:
    """Print who answers, and what a dry run came to; return the exit code of success."""
    from .printing import emit

    calls = str(error).splitlines()
    rest = "Nothing was sent; what comes after depends on the answers."
    if not calls:
        rest = "No server would be asked. Nothing was made; leave out --dry-run for that."
    facts = {"dry_run": calls} | ({"backends": roles} if roles else {})
    emit(facts, as_json, lambda: [*lines_of(roles or {}), *calls, rest])
    return 0
