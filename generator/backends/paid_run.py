"""Shared parts of runs that use servers: roles, cached responses, and earlier spending."""

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
from .select import Backends, Mix

VARIABLE = "TABLETOPGEN_CALLS"
"""Environment variable that sets the folder of cached responses."""

_MOST_BYTES = 2**30  # maximum size of a file that determines a scene


def roles_of(mix: Mix, backends: Backends) -> dict[str, dict[str, Any]]:
    """Return the backend of each role, with the settings that determine its answers."""
    names, settings = mix.roles(), backends.identity()
    return {
        role: {"name": names[role], **{k: v for k, v in settings[role].items() if k != "class"}}
        for role in names
    }


def calls_folder(calls: Path | None = None) -> Path:
    """Return the folder of cached responses: ``calls``, or else this user's default."""
    import platformdirs

    usual = os.environ.get(VARIABLE) or Path(platformdirs.user_cache_dir("tabletopgen")) / "calls"
    return Path(calls or usual)


def scene_key(*decisive: Any) -> str:
    """Return the name of a scene for ``answering``, derived from its inputs and file contents."""
    values = [_content(value) if isinstance(value, Path) else value for value in decisive]
    text = json.dumps(plain(values), sort_keys=True, default=str)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def _content(path: Path) -> str:
    try:
        content = read_regular(path, "The file", InputError, max_bytes=_MOST_BYTES)
        return hashlib.sha256(content).hexdigest()
    except InputError:  # the code that uses the file reports the error
        return str(path)


@contextmanager
def answering(session: Session, scene: str, tell: Callable[[str], None]) -> Iterator[None]:
    """Load a scene's earlier spending into a session, whose calls stop if the block fails.

    If the run fails, ``tell`` receives its costs; see ``Session.resume``.
    """
    spending = session.resume(scene)
    assert spending is not None
    try:
        yield
    except BaseException as error:
        session.stop.set()
        spent = session.account.text(session.prices.currency)
        if spent and not isinstance(error, DryRunError):
            tell(
                f"{spent}\nReceived answers are kept; the spending is recorded in {spending.path}."
            )
        raise


def save_ledger(session: Session, made: Path) -> None:
    """Write the ledger of the bundle ``made``, if it has none or there are new entries."""
    entries = session.account.entries
    now = any(entry.outcome != "cached" and not entry.earlier for entry in entries)
    if now or (any(e.earlier for e in entries) and not (made / LEDGER).exists()):
        session.account.save(made, session.prices)
