"""A budget that several processes share, also in later runs."""

from __future__ import annotations

import contextlib
import secrets
import sqlite3
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from ...errors import BudgetError, InputError, StorageError
from ...io.bounded import is_count, is_number, printable
from .database import FILE, LOCAL, Keeper, NoDatabaseError, T, damage_error, is_alive

_MAX_HELD = 10_000  # calls under way at once


@dataclass(frozen=True)
class Spent:
    """What was spent of the budget ``mark``.

    ``money`` is of the calls whose price is known, ``unpriced`` counts the others, and ``held`` is
    the most that calls under way may cost.
    """

    mark: str
    currency: str
    money: float = 0.0
    unpriced: int = 0
    held: float = 0.0


@dataclass(frozen=True)
class SharedBudget:
    """Names the budget of a folder; can be pickled and sent to the processes that spend from it.

    Attributes:
        folder: where its database is; absolute.
        mark: that of the budget there, see ``Spent``.
        keeper: who works on the database.
        owner: who reserves, see ``spending``.
    """

    folder: Path
    mark: str
    keeper: Keeper = LOCAL
    owner: str = ""

    @classmethod
    def open(cls, folder: str | Path, currency: str) -> SharedBudget:
        """Return the budget of a folder; a new one has nothing spent.

        Raises:
            InputError: what was spent from it was in another currency.
            StorageError: the folder cannot be written, or its database be read.
        """
        home = Path(folder).absolute()
        LOCAL.create(home)
        known = LOCAL.transact(home, _open, home, currency)
        if known.currency != currency:
            raise InputError(
                f"{home / FILE} has what was spent in {known.currency}, and the price table is in "
                f"{currency}. Use one in {known.currency}, or another folder."
            )
        return cls(home, known.mark)

    def total(self) -> Spent:
        """Return what was spent; reservations of processes that have ended are.

        Raises:
            StorageError: here the folder is not the one that the budget was opened in.
        """
        return self._transact(_total)

    @contextlib.contextmanager
    def spending(self) -> Iterator[SharedBudget]:
        """Yield it for one process, whose threads may reserve and settle at once.

        Raises:
            StorageError: as of ``total``.
        """
        self.total()
        with self.keeper.owning(self.folder) as owner:
            yield replace(self, owner=owner)

    def reserve(self, maximum: float | None, budget: float | None, what: str) -> int | None:
        """Set aside what a call may cost at most; return the number of the reservation.

        None means: wait until other calls have ended. A call that is free gets the number 0.

        ``maximum`` is None where nobody knows; ``budget`` is for all calls of all processes, None
        for no limit; ``what`` names the call in the message.

        Raises:
            BudgetError: it might exceed the budget.
            StorageError: the database cannot be read or written.
        """
        return 0 if maximum == 0 else self._transact(_reserve, maximum, budget, what)

    def settle(self, number: int, money: float | None) -> None:
        """Spend what a call cost, in place of its reservation; None: nobody knows.

        Raises:
            StorageError: the database cannot be read or written.
        """
        if number or money != 0:
            self._transact(_settle, number, money)

    def _transact(self, operation: Callable[..., T], *args: Any) -> T:
        try:
            return self.keeper.transact(self.folder, operation, self, *args)
        except NoDatabaseError as error:
            raise _elsewhere(self.folder) from error


def _open(database: sqlite3.Connection, folder: Path, currency: str) -> Spent:
    """Return what was spent of a folder's budget, begun if there is none."""
    if database.execute("SELECT 1 FROM spent").fetchone() is None:
        new = (secrets.token_hex(8), currency)
        database.execute("INSERT INTO spent VALUES (?, ?, 0.0, 0)", new)
    return _read(database, folder)


def _total(database: sqlite3.Connection, shared: SharedBudget) -> Spent:
    """Return what was spent, reservations of dead owners included."""
    if _read(database, shared.folder).mark != shared.mark:
        raise _elsewhere(shared.folder)
    held = database.execute("SELECT * FROM held").fetchall()
    others = {owner for _, owner, _ in held if not shared.owner or owner != shared.owner}
    dead = {owner for owner in others if not is_alive(shared.folder, owner)}
    for call, owner, money in held:
        if owner in dead:
            _spend(database, call, money)
    return _read(database, shared.folder)


def _reserve(
    database: sqlite3.Connection,
    shared: SharedBudget,
    maximum: float | None,
    budget: float | None,
    what: str,
) -> int | None:
    spent, asked = _total(database, shared), maximum or 0.0
    if budget is not None and spent.unpriced:
        raise BudgetError(
            f"{what}: not sent, for {spent.unpriced} calls of earlier runs into this folder have "
            f"no known price, so the budget of {budget:g} cannot be kept. Use another folder "
            "(what was answered is kept), or give no budget."
        )
    if budget is not None and spent.money + asked > budget:
        raise BudgetError(
            f"{what}: not sent, for it may cost {asked:.4f}. Of the budget of {budget:g} for all "
            f"scenes, {spent.money:.4f} is spent. What was answered is kept; raise the budget to "
            "resume."
        )
    if budget is not None and spent.money + spent.held + asked > budget:
        return None
    values = (shared.owner, maximum)
    return database.execute("INSERT INTO held (owner, money) VALUES (?, ?)", values).lastrowid


def _settle(
    database: sqlite3.Connection, shared: SharedBudget, number: int, money: float | None
) -> None:
    _total(database, shared)
    _spend(database, number, money)


def _spend(database: sqlite3.Connection, call: int, money: float | None) -> None:
    database.execute("DELETE FROM held WHERE call = ?", (call,))
    added = (money or 0.0, money is None)
    database.execute("UPDATE spent SET money = money + ?, unpriced = unpriced + ?", added)


def _read(database: sqlite3.Connection, folder: Path) -> Spent:
    """Return what a database says of its budget; StorageError if it was never written so."""
    rows = database.execute("SELECT * FROM spent LIMIT 2").fetchall()
    held = database.execute("SELECT owner, money FROM held LIMIT ?", (_MAX_HELD + 1,)).fetchall()
    if not rows:
        raise _elsewhere(folder)
    mark, currency, money, unpriced = rows[0]
    amounts = [amount for _, amount in held if amount is not None]
    try:
        for text in (mark, currency):
            printable(text, "A name in it", StorageError, max_length=64)
        owned = all(isinstance(owner, str) for owner, _ in held)
        if not (owned and all(map(is_number, (money, *amounts))) and is_count(unpriced)):
            raise StorageError("Its amounts have to be numbers from 0 on.")
        if len(rows) > 1 or len(held) > _MAX_HELD:
            raise StorageError(f"It has {len(rows)} budgets and {len(held)} calls under way.")
    except StorageError as error:
        raise damage_error(folder / FILE, str(error)) from error
    return Spent(mark, currency, money, unpriced, sum(amounts))


def _elsewhere(folder: Path) -> StorageError:
    return StorageError(
        f"{folder} is here not the folder that the batch was started with: its sum of money is "
        "missing. Start it again on the machine that has the folder."
    )
