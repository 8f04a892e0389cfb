"""A record on disk of one scene's call costs, which later runs of the scene read.

A row is written before a call is sent, with its maximum cost, and updated to the actual cost when
the call ends. A run that is killed therefore leaves a record of all possible spending.
"""

from __future__ import annotations

import dataclasses
import json
import sqlite3
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, get_args

from ...errors import InputError, StorageError
from ...io.bounded import is_count, is_number, parse_object
from ..http.redaction import redact
from .database import FILE, LOCAL, Keeper, NoDatabaseError, damage_error
from .entries import Entry, Outcome


@dataclass(frozen=True)
class Spending:
    """The calls of one scene in a folder's database, shared by threads and processes.

    A run reads the calls of earlier runs, but not those of concurrent ones.

    Attributes:
        folder: the folder of a call store; the database is created with the first call, accessible
            only to its owner.
        scene: name of the scene.
        currency: currency of all amounts.
        keeper: the process that accesses the database.
    """

    folder: Path
    scene: str
    currency: str = "USD"
    keeper: Keeper = LOCAL

    @property
    def path(self) -> Path:
        """The path of the database file."""
        return self.folder / FILE

    def earlier(self) -> tuple[Entry, ...]:
        """Return the calls of earlier runs, in the order in which they were sent.

        Raises:
            StorageError: a database exists but cannot be read. Such a database never counts as
                empty.
            InputError: earlier spending was in another currency.
        """
        try:
            rows = self.keeper.transact(self.folder, _earlier, self.scene)
        except NoDatabaseError:
            return ()
        found = [_read(facts, self.path) for (facts,) in rows]
        for currency, _ in found:
            if currency != self.currency:
                raise InputError(
                    f"{self.path} records costs in {currency!r:.80}, but the price table is in "
                    f"{self.currency}. Use a price table in that currency."
                )
        return tuple(entry for _, entry in found)

    def write(self, key: str, entry: Entry, call: int | None = None) -> int:
        """Record the cost of a call and return its number.

        ``key`` is the key of its question, under which the answer is stored. ``call`` is the call's
        number once it has ended, or None for a call that is about to be sent.

        Raises:
            StorageError: the disk fails.
        """
        told = {"key": key, "time": round(time.time(), 3), "currency": self.currency}
        facts = redact(json.dumps({**told, **dataclasses.asdict(entry)}))
        self.keeper.create(self.folder)
        return self.keeper.transact(self.folder, _write, self.scene, facts, call)


def _earlier(database: sqlite3.Connection, scene: str) -> list[tuple[Any]]:
    return database.execute(
        "SELECT facts FROM calls WHERE scene = ? ORDER BY call", (scene,)
    ).fetchall()


def _write(database: sqlite3.Connection, scene: str, facts: str, call: int | None) -> int:
    return database.execute(
        "INSERT OR REPLACE INTO calls VALUES (?, ?, ?)", (call, scene, facts)
    ).lastrowid  # type: ignore[return-value]


def _read(facts: Any, path: Path) -> tuple[str, Entry]:
    """Return the currency and the call of a row; raise StorageError if its cost is invalid.

    Other values of the wrong type are dropped, so that the cost still counts.
    """
    try:
        told = parse_object(str(facts).encode(), "A call", StorageError)
    except (StorageError, UnicodeError) as error:
        raise damage_error(path, str(error)) from error
    fine = {name: value for name, value in told.items() if name in _FITS and _FITS[name](value)}
    if missing := {"currency", "server", "question", "money"} - set(fine):
        raise damage_error(path, f"A call has no valid {', '.join(sorted(missing))}.")
    known = {f.name for f in dataclasses.fields(Entry)}
    entry = Entry(**{name: value for name, value in fine.items() if name in known})
    return fine["currency"], dataclasses.replace(entry, earlier=True)


_FITS: Mapping[str, Callable[[Any], bool]] = MappingProxyType({
    **dict.fromkeys(
        ("currency", "server", "question", "model", "at"), lambda value: isinstance(value, str)
    ),
    **dict.fromkeys(("tokens_in", "tokens_out", "images"), is_count),
    "seconds": is_number,
    "money": lambda value: value is None or is_number(value),
    "outcome": lambda value: value in get_args(Outcome),
})  # fmt: skip
"""Functions that check the values of a recorded call, by name."""
