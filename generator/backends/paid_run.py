"""What runs that ask backends share: who answers, where responses lie, what earlier runs spent."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ..calls import Session
from ..calls.money.ledger import LEDGER
from ..errors import DryRunError, InputError
from ..io.bounded import read_regular
from ..scene.provenance import plain
from .mix import Mix
from .select import Backends

VARIABLE = "TABLETOPGEN_CALLS"
"""Environment variable naming the folder of cached responses."""

_MOST_BYTES = 2**30  # of a file that decides a scene


def roles_of(mix: Mix, backends: Backends) -> dict[str, dict[str, Any]]:
    """Return for each role who it is by name, and the settings that decide its answers."""
    names, settings = mix.roles(), backends.identity()
    return {
        role: {"name": names[role], **{k: v for k, v in settings[role].items() if k != "class"}}
        for role in names
    }


def calls_folder(calls: Path | None = None) -> Path:
    """Return where responses are cached: in ``calls``, else where this user's are."""
    import platformdirs

    usual = os.environ.get(VARIABLE) or Path(platformdirs.user_cache_dir("tabletopgen")) / "calls"
    return Path(calls or usual)


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
def answering(session: Session, scene: str, tell: Callable[[str], None]) -> Iterator[None]:
    """Have a session know what earlier runs of a scene spent, and end its calls with the run.

    Where the run fails, ``tell`` is given what it cost; see ``Session.resume``.
    """
    spending = session.resume(scene)
    assert spending is not None
    try:
        yield
    except BaseException as error:
        session.stop.set()
        spent = session.account.text(session.prices.currency)
        if spent and not isinstance(error, DryRunError):
            tell(f"{spent}\nWhat was answered is kept; {spending.path} says what was spent.")
        raise


def save_ledger(session: Session, made: Path) -> None:
    """Write the ledger of the bundle ``made``: one that has none, or has to grow."""
    entries = session.account.entries
    now = any(entry.outcome != "cached" and not entry.earlier for entry in entries)
    if now or (any(e.earlier for e in entries) and not (made / LEDGER).exists()):
        session.account.save(made, session.prices)
