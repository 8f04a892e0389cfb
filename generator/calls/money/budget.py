"""A budget that several processes and later runs share."""

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

_MAX_HELD = 10_000  # calls in flight


@dataclass(frozen=True)
class Spent:
    """Spending from the budget with the identifier ``mark``.

    ``money`` is the total of the calls with a known price, ``unpriced`` the number of the others,
    and ``held`` the maximum cost of the calls in flight.
    """

    mark: str
    currency: str
    money: float = 0.0
    unpriced: int = 0
    held: float = 0.0


@dataclass(frozen=True)
class SharedBudget:
    """A reference to the budget of a folder, which can be pickled and sent to other processes.

    Attributes:
        folder: absolute path of the database's folder.
        mark: identifier of the budget, see ``Spent``.
        keeper: the process that accesses the database.
        owner: the process that makes reservations, see ``spending``.
    """

    folder: Path
    mark: str
    keeper: Keeper = LOCAL
    owner: str = ""

    @classmethod
    def open(cls, folder: str | Path, currency: str) -> SharedBudget:
        """Return the budget of a folder; a new one has no spending.

        Raises:
            InputError: earlier spending was in another currency.
            StorageError: the folder is not writable, or the database is not readable.
        """
        home = Path(folder).absolute()
        LOCAL.create(home)
        known = LOCAL.transact(home, _open, home, currency)
        if known.currency != currency:
            raise InputError(
                f"{home / FILE} records spending in {known.currency}, but the price table is in "
                f"{currency}. Use a price table in {known.currency}, or another folder."
            )
        return cls(home, known.mark)

    def total(self) -> Spent:
        """Return the spending, which includes reservations of processes that have ended.

        Raises:
            StorageError: on this machine, the folder is not the one in which the budget was opened.
        """
        return self._transact(_total)

    @contextlib.contextmanager
    def spending(self) -> Iterator[SharedBudget]:
        """Yield the budget for one process, whose threads may reserve and settle concurrently.

        Raises:
            StorageError: as ``total``.
        """
        self.total()
        with self.keeper.owning(self.folder) as owner:
            yield replace(self, owner=owner)

    def reserve(self, maximum: float | None, budget: float | None, what: str) -> int | None:
        """Reserve the maximum cost of a call and return the reservation's number.

        The result is None if other calls must finish first, and 0 if the call is free.

        ``maximum`` is None if the cost is unknown. ``budget`` applies to all calls of all
        processes; None means no limit. ``what`` names the call in error messages.

        Raises:
            BudgetError: the call might exceed the budget.
            StorageError: the database cannot be read or written.
        """
        return 0 if maximum == 0 else self._transact(_reserve, maximum, budget, what)

    def settle(self, number: int, money: float | None) -> None:
        """Replace a reservation with the actual cost of its call, or None if the cost is unknown.

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
    """Return the spending of a folder's budget, creating the budget if necessary."""
    if database.execute("SELECT 1 FROM spent").fetchone() is None:
        new = (secrets.token_hex(8), currency)
        database.execute("INSERT INTO spent VALUES (?, ?, 0.0, 0)", new)
    return _read(database, folder)


def _total(database: sqlite3.Connection, shared: SharedBudget) -> Spent:
    """Return the spending, including reservations of dead owners."""
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
            f"{what}: not sent. {spent.unpriced} calls of earlier runs in this folder have no "
            f"known price, so the budget of {budget:g} cannot be enforced. Use another folder "
            "(received answers are kept), or remove the budget."
        )
    if budget is not None and spent.money + asked > budget:
        raise BudgetError(
            f"{what}: not sent. It may cost {asked:.4f}, and {spent.money:.4f} of the budget of "
            f"{budget:g} for all scenes is spent. Received answers are kept; raise the budget "
            "to resume."
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
    """Return the spending in a database; raise StorageError if its content is invalid."""
    rows = database.execute("SELECT * FROM spent LIMIT 2").fetchall()
    held = database.execute("SELECT owner, money FROM held LIMIT ?", (_MAX_HELD + 1,)).fetchall()
    if not rows:
        raise _elsewhere(folder)
    mark, currency, money, unpriced = rows[0]
    amounts = [amount for _, amount in held if amount is not None]
    try:
        for text in (mark, currency):
            printable(text, "One of its names", StorageError, max_length=64)
        owned = all(isinstance(owner, str) for owner, _ in held)
        if not (owned and all(map(is_number, (money, *amounts))) and is_count(unpriced)):
            raise StorageError("The amounts must be non-negative numbers.")
        if len(rows) > 1 or len(held) > _MAX_HELD:
            raise StorageError(
                f"The database has {len(rows)} budgets and {len(held)} calls in flight; at most 1 "
                f"and {_MAX_HELD} are allowed."
            )
    except StorageError as error:
        raise damage_error(folder / FILE, str(error)) from error
    return Spent(mark, currency, money, unpriced, sum(amounts))


def _elsewhere(folder: Path) -> StorageError:
    return StorageError(
        f"On this machine, {folder} is not the folder in which the batch was started: it has no "
        "record of the batch's budget. Restart the batch on the machine that has the folder."
    )
