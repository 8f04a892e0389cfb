"""A budget that several processes share, also in later runs."""

from __future__ import annotations

import contextlib
import secrets
import sqlite3
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from ...errors import BudgetError, InputError, StorageError
from ...io.reading import is_count, is_number, printable
from .database import FILE, LOCAL, Keeper, NoDatabaseError, Operation, P, T, damaged, is_alive

_MAX_HELD = 10_000  # calls under way at once


@dataclass(frozen=True)
class Spent:
    """What was spent of a budget.

    Attributes:
        mark: tells this budget from all others.
        currency: of the money.
        money: of the calls whose price is known.
        unpriced: number of calls whose price is not.
        held: the most that calls under way may cost.
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
    """

    folder: Path
    mark: str
    keeper: Keeper = LOCAL

    @classmethod
    def open(cls, folder: str | Path, currency: str) -> SharedBudget:
        """Return the budget of a folder, which is there; a new one has nothing spent.

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

    def spent(self) -> Spent:
        """Return what was spent; reservations of processes that have ended are.

        Raises:
            StorageError: here the folder is not the one that the budget was opened in.
        """
        return self.transact(_spent, self.folder, self.mark)

    @contextlib.contextmanager
    def spending(self) -> Iterator[Spender]:
        """Be one of those that spend from it.

        Raises:
            StorageError: as of ``spent``.
        """
        self.spent()
        with self.keeper.owning(self.folder) as name:
            yield Spender(self, name)

    def transact(self, operation: Operation[P, T], *args: P.args, **more: P.kwargs) -> T:
        """Return what ``operation`` of the database does, in one transaction."""
        try:
            return self.keeper.transact(self.folder, operation, *args, **more)
        except NoDatabaseError as error:
            raise _elsewhere(self.folder) from error


@dataclass(frozen=True)
class Spender:
    """One process's part in a shared budget; its threads may use it at once."""

    shared: SharedBudget
    name: str

    def reserve(self, maximum: float | None, budget: float | None, what: str) -> int | None:
        """Set aside what a call may cost at most; return the reservation.

        None means: wait until other calls have ended. A call that is free needs no reservation.

        Args:
            maximum: what it may cost; None where nobody knows.
            budget: what all calls of all spenders may cost; None for no limit.
            what: names the call in the message.

        Raises:
            BudgetError: it might exceed the budget of all spenders.
            StorageError: the database cannot be read or written.
        """
        if maximum == 0:
            return 0
        shared = self.shared
        args = (shared.folder, shared.mark, self.name, maximum, budget, what)
        return shared.transact(_reserve, *args)

    def settle(self, reservation: int, money: float | None) -> None:
        """Spend what a call cost, in place of its reservation; None: nobody knows.

        Raises:
            StorageError: the database cannot be read or written.
        """
        if reservation or money != 0:
            shared = self.shared
            shared.transact(_settle, shared.folder, shared.mark, self.name, reservation, money)


def _open(database: sqlite3.Connection, folder: Path, currency: str) -> Spent:
    """Return what was spent of a folder's budget, begun if there is none."""
    if database.execute("SELECT 1 FROM spent").fetchone() is None:
        new = (secrets.token_hex(8), currency)
        database.execute("INSERT INTO spent VALUES (?, ?, 0.0, 0)", new)
    return _read(database, folder)


def _spent(database: sqlite3.Connection, folder: Path, mark: str, own: str | None = None) -> Spent:
    """Return what was spent, reservations of dead owners included.

    ``own`` is the owner that asks: alive, whatever the disk's locks make of it.
    """
    if _read(database, folder).mark != mark:
        raise _elsewhere(folder)
    for (owner,) in database.execute("SELECT DISTINCT owner FROM held").fetchall():
        if owner != own and not is_alive(folder, owner):
            dead = "SELECT call, money FROM held WHERE owner = ?"
            for call, money in database.execute(dead, (owner,)).fetchall():
                _spend(database, call, money)
    return _read(database, folder)


def _reserve(
    database: sqlite3.Connection,
    folder: Path,
    mark: str,
    owner: str,
    maximum: float | None,
    budget: float | None,
    what: str,
) -> int | None:
    spent = _spent(database, folder, mark, owner)
    if budget is not None and spent.unpriced:
        raise BudgetError(
            f"{what}: not sent, for {spent.unpriced} calls of earlier runs into this folder have "
            f"no known price, so the budget of {budget:g} cannot be kept. Use another folder "
            "(what was answered is kept), or give no budget."
        )
    if budget is not None and spent.money + (maximum or 0.0) > budget:
        raise BudgetError(
            f"{what}: not sent, for it may cost {maximum:.4f}. Of the budget of {budget:g} for all "
            f"scenes, {spent.money:.4f} is spent. What was answered is kept; raise the budget to "
            "go on."
        )
    if budget is not None and spent.money + spent.held + (maximum or 0.0) > budget:
        return None
    insert = "INSERT INTO held (owner, money) VALUES (?, ?)"
    return database.execute(insert, (owner, maximum)).lastrowid


def _settle(
    database: sqlite3.Connection,
    folder: Path,
    mark: str,
    owner: str,
    reservation: int,
    money: float | None,
) -> None:
    _spent(database, folder, mark, owner)
    _spend(database, reservation, money)


def _spend(database: sqlite3.Connection, call: int, money: float | None) -> None:
    database.execute("DELETE FROM held WHERE call = ?", (call,))
    added = (money or 0.0, money is None)
    database.execute("UPDATE spent SET money = money + ?, unpriced = unpriced + ?", added)


def _read(database: sqlite3.Connection, folder: Path) -> Spent:
    """Return what a database says of its budget, checked.

    Raises:
        StorageError: it is not what was ever written.
    """
    path = folder / FILE
    rows = database.execute("SELECT * FROM spent LIMIT 2").fetchall()
    held = database.execute("SELECT owner, money FROM held LIMIT ?", (_MAX_HELD + 1,)).fetchall()
    if len(rows) > 1 or len(held) > _MAX_HELD:
        raise damaged(path, f"It has {len(rows)} budgets and {len(held)} calls under way.")
    if not rows:
        raise _elsewhere(folder)
    mark, currency, money, unpriced = rows[0]
    try:
        printable(mark, "Its mark", StorageError, max_length=64)
        printable(currency, "Its currency", StorageError, max_length=64)
    except StorageError as error:
        raise damaged(path, str(error)) from error
    amounts = [money, *(amount for _, amount in held if amount is not None)]
    owners = all(isinstance(owner, str) for owner, _ in held)
    if not (all(map(is_number, amounts)) and is_count(unpriced) and owners):
        raise damaged(path, "Its amounts have to be numbers from 0 on.")
    return Spent(mark, currency, money, unpriced, sum(amounts[1:]))


def _elsewhere(folder: Path) -> StorageError:
    return StorageError(
        f"{folder} is here not the folder that the batch was started with: its sum of money is "
        "missing. Start it again on the machine that has the folder."
    )
