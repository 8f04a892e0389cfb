"""A sum of money on disk that several processes spend together, also in later runs.

``spent.json`` says what was spent, and what calls under way may cost at most, by who makes them;
it is changed under a lock, and written whole. Each spender holds a lock of its own as long as it
lives. What a dead one had set aside counts as spent: its calls may have been answered.
"""

from __future__ import annotations

import contextlib
import dataclasses
import json
import math
import re
import secrets
from collections.abc import Collection, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from filelock import FileLock, Timeout

from ...errors import BudgetError, InputError, StorageError
from ...io.files import remove_file, write_whole
from ...io.reading import (
    is_count,
    is_number,
    parse_object,
    printable,
    read_regular,
)

FILE = "spent.json"
"""Where a purse's folder keeps the sum."""

_SPENDERS = "spenders"
_NAME = re.compile(r"[0-9a-f]{16}")  # of a spender, see ``Purse.spending``
_MOST_BYTES = 2**20  # of the file
_MOST_SPENDERS = 1024  # that hold money at once
_PATIENCE = 60.0  # seconds: nobody holds the sum for long


@dataclass(frozen=True)
class Sum:
    """What was spent from a purse.

    Attributes:
        mark: tells this purse from all others.
        currency: of the money.
        money: of the calls whose price is known.
        unpriced: how many calls there were whose price is not.
        held: the most that each spender's calls under way may cost.
    """

    mark: str
    currency: str
    money: float = 0.0
    unpriced: int = 0
    held: dict[str, list[float]] = field(default_factory=dict)


@dataclass(frozen=True)
class Purse:
    """Names a sum on disk; can be pickled, and sent to the processes that spend from it.

    ``folder`` is absolute; ``mark`` is that of the sum there, see ``Sum``.
    """

    folder: Path
    mark: str

    @classmethod
    def open(cls, folder: str | Path, currency: str) -> Purse:
        """Return the purse of a folder, which is there; a new one has nothing spent.

        Raises:
            InputError: what was spent from it was in another currency.
            StorageError: the folder cannot be written, or the sum in it be read.
        """
        home = Path(folder).absolute()
        with _locked(home):
            known = _read(home)
            if known is None:
                known = Sum(secrets.token_hex(8), currency)
                _write(home, known)
        if known.currency != currency:
            raise InputError(
                f"{home / FILE} has what was spent in {known.currency}, and the price table is in "
                f"{currency}. Use one in {known.currency}, or another folder."
            )
        return cls(home, known.mark)

    def sum(self) -> Sum:
        """Return what was spent; calls under way are those of spenders that live."""
        with self._changing() as known:
            return known[0]

    @contextlib.contextmanager
    def spending(self) -> Iterator[Spender]:
        """Be one of those that spend from it.

        Raises:
            StorageError: here the folder is not the one that the purse was opened in.
        """
        name = secrets.token_hex(8)
        spenders = self.folder / _SPENDERS
        with self._changing():
            spenders.mkdir(exist_ok=True)
        try:
            with FileLock(spenders / _life(name), thread_local=False):
                yield Spender(self, name)
        finally:
            remove_file(spenders, _life(name))

    @contextlib.contextmanager
    def _changing(self, own: str = "") -> Iterator[list[Sum]]:
        """Yield the sum to be replaced in a list of one; what dead spenders held is spent.

        ``own`` is the spender that asks: alive, whatever a disk's locks make of it.
        """
        if not self.folder.is_dir():
            raise self._elsewhere()
        with _locked(self.folder):
            before = _read(self.folder)
            if before is None or before.mark != self.mark:
                raise self._elsewhere()
            dead = {name for name in before.held if name != own and self._dead(name)}
            known = [_buried(before, dead)]
            yield known
            if known[0] != before:
                _write(self.folder, known[0])

    def _dead(self, name: str) -> bool:
        """Tell whether nobody holds a spender's lock any more."""
        spenders = self.folder / _SPENDERS
        try:
            with FileLock(spenders / _life(name), timeout=0):
                pass
        except Timeout:
            return False
        remove_file(spenders, _life(name))
        return True

    def _elsewhere(self) -> StorageError:
        return StorageError(
            f"{self.folder} is here not the folder that the batch was started with: its sum of "
            "money is missing. Over Ray, a budget needs a folder that all machines share."
        )


@dataclass(frozen=True)
class Spender:
    """One process's part in a purse; its threads may use it at once."""

    purse: Purse
    name: str

    def hold(self, most: float, budget: float | None, what: str) -> bool:
        """Set aside what a call may cost at most; False: wait until other calls have ended.

        A call that is free needs no money. ``what`` names the call in the message.

        Raises:
            BudgetError: it might exceed the budget of all spenders.
            StorageError: the sum cannot be read or written.
        """
        if most == 0:
            return True
        with self.purse._changing(self.name) as known:
            spent = known[0]
            if budget is not None and spent.unpriced:
                raise BudgetError(
                    f"{what}: not sent, for {spent.unpriced} calls of earlier runs into this "
                    f"folder have no known price, so the budget of {budget:g} cannot be kept. Use "
                    "another folder (what was answered is kept), or give no budget."
                )
            held = sum(map(math.fsum, spent.held.values()))
            if budget is not None and spent.money + held + most > budget:
                if spent.money + most <= budget:
                    return False
                raise BudgetError(
                    f"{what}: not sent, for it may cost {most:.4f}. Of the budget of {budget:g} "
                    f"for all scenes, {spent.money:.4f} is spent. What was answered is kept; raise "
                    "the budget to go on."
                )
            own = [*spent.held.get(self.name, ()), most]
            known[0] = dataclasses.replace(spent, held={**spent.held, self.name: own})
        return True

    def settle(self, most: float, money: float | None) -> None:
        """Spend what a call cost, for which ``most`` was set aside; None: nobody knows.

        Raises:
            StorageError: the sum cannot be read or written.
        """
        if most == 0 and money == 0:
            return
        with self.purse._changing(self.name) as known:
            spent = known[0]
            own = list(spent.held.get(self.name, ()))
            if most in own:
                own.remove(most)
            rest = {k: v for k, v in spent.held.items() if k != self.name}
            known[0] = dataclasses.replace(
                spent,
                money=spent.money + (money or 0.0),
                unpriced=spent.unpriced + (money is None),
                held={**rest, self.name: own} if own else rest,
            )


def _life(name: str) -> str:
    """Return the name of the file that a spender locks as long as it lives."""
    return f"{name}.lock"


def _buried(known: Sum, names: Collection[str]) -> Sum:
    """Return the sum with what some spenders had set aside spent."""
    rest = {k: v for k, v in known.held.items() if k not in names}
    left = math.fsum(amount for name in names for amount in known.held[name])
    return dataclasses.replace(known, money=known.money + left, held=rest)


@contextlib.contextmanager
def _locked(folder: Path) -> Iterator[None]:
    try:
        with FileLock(folder / "spent.lock", timeout=_PATIENCE, poll_interval=0.01):
            yield
    except Timeout as error:
        raise StorageError(
            f"The sum of money in {folder} was not let go of for {_PATIENCE:g} s. See who holds "
            "spent.lock there."
        ) from error
    except StorageError:
        raise
    except OSError as error:
        raise StorageError(
            f"The sum of money in {folder} cannot be locked or written: "
            f"{error.strerror or error}. Free space there, or choose another folder."
        ) from error


def _read(folder: Path) -> Sum | None:
    """Return the sum that a folder holds, None if there is none.

    Raises:
        StorageError: it cannot be understood; it is never taken for nothing.
    """
    path = folder / FILE
    if (folder / _SPENDERS).is_symlink():
        raise StorageError(f"{folder / _SPENDERS} is a link; spenders are kept beside their sum.")
    try:
        raw = read_regular(path, "What was spent", StorageError, max_bytes=_MOST_BYTES)
    except StorageError as error:
        if isinstance(error.__cause__, FileNotFoundError) and not path.is_symlink():
            return None
        raise
    try:
        return _sum_of(parse_object(raw, "It", StorageError, unique=True))
    except StorageError as error:
        raise StorageError(
            f"{path} does not say what was spent: {error} Mend it: "
            '{"mark": "any", "currency": "USD", "money": 1.23}.'
        ) from error


def _sum_of(told: dict[str, Any]) -> Sum:
    """Return the sum that a file's values say.

    Raises:
        StorageError: they say none.
    """
    known = {f.name for f in dataclasses.fields(Sum)}
    if not {"mark", "currency"} <= set(told) <= known:
        raise StorageError(f"It has the values {sorted(told)!r:.200}.")
    for name in ("mark", "currency"):
        printable(told[name], f"Its {name}", StorageError, max_length=64)
    held, unpriced = told.get("held", {}), told.get("unpriced", 0)
    if not isinstance(held, dict) or not all(isinstance(v, list) for v in held.values()):
        raise StorageError("Its 'held' has to list the amounts of each spender.")
    if len(held) > _MOST_SPENDERS:
        raise StorageError(f"It has {len(held)} spenders; at most {_MOST_SPENDERS} are read.")
    if wrong := [name for name in held if not _NAME.fullmatch(name)]:
        raise StorageError(f"{wrong[0]!r:.80} is no spender: their names are 16 hex digits.")
    amounts = [told.get("money", 0.0), *(a for own in held.values() for a in own)]
    if not (all(map(is_number, amounts)) and is_count(unpriced)):
        raise StorageError("Its amounts have to be numbers from 0 on.")
    return Sum(**told)


def _write(folder: Path, told: Sum) -> None:
    text = json.dumps(dataclasses.asdict(told)) + "\n"
    advice = "Free space there, or choose another folder."
    write_whole(folder / FILE, text, "The sum of money spent", advice)
