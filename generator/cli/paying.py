"""What commands that ask backends share: who answers, which calls are sent, at what price."""

from __future__ import annotations

import hashlib
import json
import os
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from tyro.conf import OmitArgPrefixes, arg

from ..backends import Backends, Mix
from ..calls import Session
from ..calls.money.ledger import LEDGER
from ..calls.money.prices import Prices
from ..calls.store import CallStore
from ..errors import DryRunError, InputError, escape
from ..io.reading import read_regular
from ..scene.provenance import plain
from .printing import emit

VARIABLE = "TABLETOPGEN_CALLS"
"""Environment variable naming the folder of cached responses."""

_MOST_BYTES = 2**30  # of a file that decides a scene

Chosen = OmitArgPrefixes[Annotated[Mix, arg(name="backend")]]
"""The type of a command's argument that makes these options."""

USUAL, NOBODY = Mix(), Mix(backend=None)
"""What commands use unless told otherwise: those that generate, and that can do without."""


def roles_of(mix: Mix, backends: Backends) -> dict[str, dict[str, Any]]:
    """Return for each role who it is by name, and the settings that decide its answers."""
    names, settings = mix.roles(), backends.identity()
    return {
        role: {"name": names[role], **{k: v for k, v in settings[role].items() if k != "class"}}
        for role in names
    }


def lines_of(roles: Mapping[str, Mapping[str, Any]]) -> list[str]:
    """Return ``roles_of`` as a line for each role."""
    lines = []
    for role, facts in roles.items():
        settings = ", ".join(f"{k}={v}" for k, v in facts.items() if k != "name" and v != "")
        lines.append(f"{role:<10} {facts['name']}" + (f" ({settings})" if settings else ""))
    return lines


@dataclass(frozen=True)
class CallOptions:
    """What requests to servers may cost, and where usable responses are cached.

    Attributes:
        budget: The most that the calls may cost; those of earlier runs of the same command
            are counted. A batch counts all runs into its folder, and all its workers.
        dry_run: Send nothing to servers and make nothing; print who answers what, and the first
            calls that would be made.
        calls: Folder of cached responses, so that none is billed twice; TABLETOPGEN_CALLS, else
            the user cache, if left out.
        prices: Price table (TOML); the shipped one if left out.
    """

    budget: float | None = None
    dry_run: bool = False
    calls: Path | None = None
    prices: Path | None = None

    def table(self) -> Prices:
        """Return the price table; InputError if the file cannot be used."""
        return Prices.default() if self.prices is None else Prices.load(self.prices)

    def session(self) -> Session:
        """Return a session with these settings."""
        store = CallStore(calls_folder(self.calls))
        return Session(store, prices=self.table(), budget=self.budget, dry=self.dry_run)


Calls = OmitArgPrefixes[CallOptions]
"""The type of a command's argument that makes these options."""

NO_CALLS = CallOptions()


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
def answering(session: Session, scene: str) -> Iterator[None]:
    """Have a session know what earlier runs of a scene spent, and end its calls with the command.

    Where the command fails, what it cost is told on standard error; see ``Session.resume``.
    """
    spending = session.resume(scene)
    assert spending is not None
    try:
        yield
    except BaseException as error:
        session.stop.set()
        spent = session.account.text(session.prices.currency)
        if spent and not isinstance(error, DryRunError):
            message = f"{spent}\nWhat was answered is kept; {spending.path} says what was spent."
            print(escape(message), file=sys.stderr)
        raise


def save_ledger(session: Session, made: Path) -> None:
    """Write the ledger of the bundle ``made``: one that has none, or has to grow."""
    entries = session.account.entries
    now = any(entry.outcome != "cached" and not entry.earlier for entry in entries)
    if now or (any(e.earlier for e in entries) and not (made / LEDGER).exists()):
        session.account.save(made, session.prices)


def print_dry_run(
    error: DryRunError, as_json: bool, mix: Mix = USUAL, backends: Backends | None = None
) -> int:
    """Print who answers, and what a dry run came to; return the exit code of success."""
    roles = {} if backends is None else roles_of(mix, backends)
    calls = str(error).splitlines()
    rest = "Nothing was sent; what comes after depends on the answers."
    if not calls:
        rest = "No server would be asked. Nothing was made; leave out --dry-run for that."
    facts = {"dry_run": calls} | ({"backends": roles} if roles else {})
    emit(facts, as_json, lambda: [*lines_of(roles), *calls, rest])
    return 0
