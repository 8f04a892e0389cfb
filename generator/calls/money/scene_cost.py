"""What the calls of one scene cost, on disk, so that the next run of it knows.

A row is written before a call is sent, with the most that it can cost, and changed to what it did
cost when it has ended. So a run that is killed leaves what it has spent, and what it may have.
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
    """The calls of one scene in the database of a folder; threads and processes may share it.

    A run knows of those that began before it, but not what others spend from then on.

    Attributes:
        folder: that of a call store; the database is made, for its owner alone, with the first
            call.
        scene: names the scene.
        currency: of the money.
        keeper: who works on the database.
    """

    folder: Path
    scene: str
    currency: str = "USD"
    keeper: Keeper = LOCAL

    @property
    def path(self) -> Path:
        """The database's file."""
        return self.folder / FILE

    def earlier(self) -> tuple[Entry, ...]:
        """Return the calls of earlier runs, in the order they were sent.

        Raises:
            StorageError: there is a database, and it cannot be read. It is never taken for nothing.
            InputError: what was spent was in another currency.
        """
        try:
            rows = self.keeper.transact(self.folder, _earlier, self.scene)
        except NoDatabaseError:
            return ()
        found = [_read(facts, self.path) for (facts,) in rows]
        for currency, _ in found:
            if currency != self.currency:
                raise InputError(
                    f"{self.path} has what calls cost in {currency!r:.80}, and the price table is "
                    f"in {self.currency}. Use one in that."
                )
        return tuple(entry for _, entry in found)

    def write(self, key: str, entry: Entry, call: int | None = None) -> int:
        """Write down what a call costs; return its number.

        ``key`` is its question's, under which the answer is kept. ``call`` is its number, once it
        has ended; None for one that is about to be sent.

        Raises:
            StorageError: the disk refuses.
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
    """Return the currency and the call of a row; StorageError if it does not say what was spent.

    What else is of the wrong kind is left out, so that the money counts.
    """
    try:
        told = parse_object(str(facts).encode(), "A call", StorageError)
    except (StorageError, UnicodeError) as error:
        raise damage_error(path, str(error)) from error
    fine = {name: value for name, value in told.items() if name in _FITS and _FITS[name](value)}
    if not {"currency", "server", "question", "money"} <= set(fine):
        raise damage_error(path, f"A call has the values {sorted(told)!r:.200}.")
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
"""What the values of a call have to be."""
