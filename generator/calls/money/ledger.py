"""The ledger: what was asked, how long it took, and what it cost."""

from __future__ import annotations

import contextlib
import dataclasses
import json
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from ...errors import BudgetError, StorageError
from ...io.files import write_whole
from .budget import SharedBudget
from .entries import Entry, LedgerRow, rows_of, table
from .prices import Prices, unknown_price
from .scene_cost import Spending

LEDGER = "ledger.json"
"""The file that lies beside what a bundle lists."""

_POLL = 0.1  # seconds between two looks at whether to stop


class Account:
    """The calls of one scene, entered by any thread.

    With a ``shared`` budget, see ``SharedBudget.spending``, a budget is that of all processes.
    """

    def __init__(self, shared: SharedBudget | None = None) -> None:
        self._shared = shared
        self._ended = threading.Condition()
        self._entries: list[Entry] = []
        self._notes: list[str] = []
        self._reserved: dict[int, float] = {}
        self._calls = 0
        self._spending: Spending | None = None

    def resume(self, spending: Spending, prices: Prices | None = None) -> None:
        """Enter what earlier runs of this scene spent, and write there what this one does.

        To be called before any call. What was spent earlier counts for a budget, too. Answers of
        unknown price are priced by ``prices`` if they can be; else no budget can be kept.

        Raises:
            StorageError: the file is there, and cannot be read.
            InputError: what was spent was in another currency.
        """
        entries = [_price(entry, prices) for entry in spending.earlier()]
        with self._ended:
            self._spending = spending
            self._entries[:0] = entries
        if entries:
            money = sum(entry.money or 0.0 for entry in entries)
            unknown = sum(entry.money is None for entry in entries)
            rest = f", and {unknown} of their calls have no known price" * bool(unknown)
            self.note(f"Of this, {money:.4f} was spent by earlier runs of the same scene{rest}.")

    def record(self, sent: Entry, key: str, *, must: bool = False) -> Callable[[Entry], None]:
        """Write down a call that is about to be sent; returns what writes down how it ended.

        ``sent`` is how the call of that question's ``key`` counts if nobody says how it ended.

        Raises:
            StorageError: the disk refuses, and ``must`` says that the call may not be sent then, as
                with a budget. Else, and at its end, that is noted.
        """
        spending, calls = self._spending, list[int]()

        def write(entry: Entry, must: bool = False) -> None:
            if spending is None or sent.money == 0:
                return
            try:
                calls.append(spending.write(key, entry, *calls[:1]))
            except StorageError as error:  # an answer must not be lost for it
                if must:
                    raise
                self.note(str(error))

        write(sent, must)
        return write

    def add(self, entry: Entry) -> None:
        """Enter a call."""
        with self._ended:
            self._entries.append(entry)

    def note(self, text: str) -> None:
        """Keep a remark that the summary ends with; the same one is kept once."""
        with self._ended:
            if text not in self._notes:
                self._notes.append(text)

    @property
    def entries(self) -> tuple[Entry, ...]:
        """All calls, in the order they ended."""
        with self._ended:
            return tuple(self._entries)

    @property
    def notes(self) -> tuple[str, ...]:
        """The remarks."""
        with self._ended:
            return tuple(self._notes)

    @property
    def money(self) -> float:
        """What the calls cost whose price is known."""
        return sum(entry.money or 0.0 for entry in self.entries)

    @property
    def unpriced(self) -> int:
        """How many calls there are whose price is not known."""
        return sum(entry.money is None for entry in self.entries)

    @contextlib.contextmanager
    def reserving(
        self,
        maximum: float | None,
        budget: float | None,
        what: str,
        check: Callable[[], None] = lambda: None,
        model: str = "MODEL",
    ) -> Iterator[Callable[[Entry], None]]:
        """Set aside what a call may cost while it runs; yields what enters the call instead.

        Where the budget would do but for calls under way, they are waited for: most cost less
        than they might. ``check`` is called now and then meanwhile, and may raise. ``maximum`` is
        None where it is not known, ``budget`` None for no limit; ``what`` names the call in the
        message, ``model`` what the price table lacks then.

        Raises:
            BudgetError: it might exceed the budget, or nobody knows.
        """
        if budget is not None and maximum is None:
            raise unknown_price(what, budget, model)
        if budget is not None and maximum and self._shared is None:  # a shared one has its own sum
            self._check_earlier(what, budget)
        with self._ended:
            while (reservation := self._reserve(maximum, budget, what)) is None:
                check()
                self._ended.wait(_POLL)
        open_ = [reservation]

        def enter(entry: Entry | None) -> None:
            with self._ended:
                if open_:
                    self._settle(open_.pop(), maximum if entry is None else entry.money)
                if entry is not None:
                    self._entries.append(entry)
                self._ended.notify_all()

        try:
            yield enter
        finally:
            enter(None)  # a call that nobody entered broke off, and may have been answered

    def _check_earlier(self, what: str, budget: float) -> None:
        """Refuse a call where nobody knows what earlier ones cost."""
        unknown = [entry for entry in self.entries if entry.earlier and entry.money is None]
        if unknown and self._spending is not None:
            names = {entry.model or f"@{entry.at}" for entry in unknown if entry.model or entry.at}
            models = [f'[models."{name}"]' for name in sorted(names)]
            raise BudgetError(
                f"{what}: not sent, for earlier runs of the same scene made {len(unknown)} calls "
                f"whose price is not known, so the budget of {budget:g} cannot be kept. Add "
                f"{', '.join(models) or 'their models'} to the price table, or remove "
                f"{self._spending.path} for them to count as nothing. Calls that broke off can "
                "only be removed."
            )

    def _reserve(self, maximum: float | None, budget: float | None, what: str) -> int | None:
        """Set aside what a call may cost; None if others have to end first."""
        if self._shared is not None:
            return self._shared.reserve(maximum, budget, what)
        asked, spent = maximum or 0.0, self.money
        if budget is None or not asked or spent + sum(self._reserved.values()) + asked <= budget:
            self._calls += 1
            self._reserved[self._calls] = asked
            return self._calls
        if spent + asked > budget:
            raise BudgetError(
                f"{what}: not sent, for it may cost {asked:.4f}. Of the budget of {budget:g}, "
                f"{spent:.4f} is spent. What was answered is kept; raise the budget to go on."
            )
        return None

    def _settle(self, reservation: int, money: float | None) -> None:
        """Put what a call cost in place of its reservation."""
        self._reserved.pop(reservation, None)
        if self._shared is not None:
            try:
                self._shared.settle(reservation, money)
            except StorageError as error:  # it stays reserved; the answer must not be lost
                self.note(str(error))

    def summary(self) -> tuple[LedgerRow, ...]:
        """Return a row for each question, server and model, in the order first asked."""
        return rows_of(self.entries)

    def text(self, currency: str = "USD") -> str:
        """Return the summary as a table for people; "" if nothing was asked."""
        told = table(self.entries, currency)
        return "\n".join([told, *(f"note: {note}" for note in self.notes)]) if told else ""

    def facts(self, prices: Prices) -> dict[str, Any]:
        """Return the ledger as JSON values."""
        return {
            "currency": prices.currency,
            "prices_of": prices.date,
            "money": self.money,
            "unpriced": self.unpriced,
            "summary": [dataclasses.asdict(row) for row in self.summary()],
            "calls": [dataclasses.asdict(entry) for entry in self.entries],
            "notes": list(self.notes),
        }

    def save(self, folder: str | Path, prices: Prices) -> Path:
        """Write ``ledger.json`` into a folder, whole or not at all; return its path.

        Raises:
            StorageError: it cannot be written.
        """
        path = Path(folder) / LEDGER
        text = json.dumps(self.facts(prices), indent=2)
        write_whole(path, text, "The ledger", "Choose another folder.")
        return path


def _price(entry: Entry, prices: Prices | None) -> Entry:
    """Return an answer of unknown price with that of its model, if that is known by now."""
    if entry.money is not None or entry.outcome != "answered" or prices is None:
        return entry
    price = prices.price(entry.model, entry.at)
    if price is None or not price.told(entry.tokens_in, entry.tokens_out):
        return entry
    money = price.of(entry.tokens_in, entry.tokens_out, entry.images)
    return dataclasses.replace(entry, money=money)
