"""The ledger: the calls of a scene, their durations and their costs."""

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
"""Name of a bundle's ledger file, which ``scene.json`` does not list."""

_POLL = 0.1  # seconds between checks for a stop


class Account:
    """The calls of one scene, recorded by any thread.

    With a ``shared`` budget (see ``SharedBudget.spending``), budgets apply to all processes
    together.
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
        """Load the spending of this scene's earlier runs, and add this run's calls to its record.

        Call this before any other call. Earlier spending counts towards the budget. Answers of
        unknown price are priced by ``prices`` if possible; otherwise a budget cannot be enforced.

        Raises:
            StorageError: the file exists but cannot be read.
            InputError: earlier spending was in another currency.
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
        """Record a call that is about to be sent; return a function that records its outcome.

        ``sent`` is the entry that counts for the question with this ``key`` if no outcome is
        recorded.

        Raises:
            StorageError: the disk fails and ``must`` forbids an unrecorded call, as with a budget.
                Otherwise, and when the outcome is recorded, a disk failure is only noted.
        """
        spending, calls = self._spending, list[int]()

        def write(entry: Entry, must: bool = False) -> None:
            if spending is None or sent.money == 0:
                return
            try:
                calls.append(spending.write(key, entry, *calls[:1]))
            except StorageError as error:  # a disk failure must not lose an answer
                if must:
                    raise
                self.note(str(error))

        write(sent, must)
        return write

    def add(self, entry: Entry) -> None:
        """Add a call to the ledger."""
        with self._ended:
            self._entries.append(entry)

    def note(self, text: str) -> None:
        """Add a remark to the end of the summary; duplicates are ignored."""
        with self._ended:
            if text not in self._notes:
                self._notes.append(text)

    @property
    def entries(self) -> tuple[Entry, ...]:
        """All calls, in the order in which they ended."""
        with self._ended:
            return tuple(self._entries)

    @property
    def notes(self) -> tuple[str, ...]:
        """All remarks."""
        with self._ended:
            return tuple(self._notes)

    @property
    def money(self) -> float:
        """The total cost of the calls with a known price."""
        return sum(entry.money or 0.0 for entry in self.entries)

    @property
    def unpriced(self) -> int:
        """The number of calls without a known price."""
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
        """Reserve the maximum cost of a call while it runs; yield a function that adds the call.

        If the budget suffices only without the calls in flight, the reservation waits for them,
        since most calls cost less than their maximum. ``check`` is called periodically meanwhile
        and may raise. ``maximum`` is None if the cost is unknown, ``budget`` is None for no limit.
        ``what`` names the call in error messages, and ``model`` the entry that the price table
        lacks.

        Raises:
            BudgetError: the call might exceed the budget, or its cost is unknown.
        """
        if budget is not None and maximum is None:
            raise unknown_price(what, budget, model)
        # a shared budget includes earlier runs
        if budget is not None and maximum and self._shared is None:
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
            enter(None)  # a call without an entry broke off, but may have been answered

    def _check_earlier(self, what: str, budget: float) -> None:
        """Raise an error if the costs of earlier calls are unknown."""
        unknown = [entry for entry in self.entries if entry.earlier and entry.money is None]
        if unknown and self._spending is not None:
            names = {entry.model or f"@{entry.at}" for entry in unknown if entry.model or entry.at}
            models = [f'[models."{name}"]' for name in sorted(names)]
            raise BudgetError(
                f"{what}: not sent. Earlier runs of the same scene made {len(unknown)} calls "
                f"whose price is not known, so the budget of {budget:g} cannot be enforced. Add "
                f"{', '.join(models) or 'their models'} to the price table, or remove "
                f"{self._spending.path}, which discards its record of spending. The price of "
                "calls that were interrupted cannot be added."
            )

    def _reserve(self, maximum: float | None, budget: float | None, what: str) -> int | None:
        """Reserve the maximum cost of a call; return None if other calls must finish first."""
        if self._shared is not None:
            return self._shared.reserve(maximum, budget, what)
        asked, spent = maximum or 0.0, self.money
        if budget is None or not asked or spent + sum(self._reserved.values()) + asked <= budget:
            self._calls += 1
            self._reserved[self._calls] = asked
            return self._calls
        if spent + asked > budget:
            raise BudgetError(
                f"{what}: not sent. It may cost {asked:.4f}, and {spent:.4f} of the budget of "
                f"{budget:g} is spent. Received answers are kept; raise the budget to resume."
            )
        return None

    def _settle(self, reservation: int, money: float | None) -> None:
        """Replace a reservation with the actual cost of its call."""
        self._reserved.pop(reservation, None)
        if self._shared is not None:
            try:
                self._shared.settle(reservation, money)
            except StorageError as error:  # the reservation stays; the answer must not be lost
                self.note(str(error))

    def summary(self) -> tuple[LedgerRow, ...]:
        """Return one row per question, server and model, in the order of their first calls."""
        return rows_of(self.entries)

    def text(self, currency: str = "USD") -> str:
        """Return the summary as a text table, or "" if there were no calls."""
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
        """Write ``ledger.json`` into a folder atomically and return its path.

        Raises:
            StorageError: the file cannot be written.
        """
        path = Path(folder) / LEDGER
        text = json.dumps(self.facts(prices), indent=2)
        write_whole(path, text, "The ledger", "Choose another folder.")
        return path


def _price(entry: Entry, prices: Prices | None) -> Entry:
    """Return an entry with its cost, if that was unknown and the model's price is now known."""
    if entry.money is not None or entry.outcome != "answered" or prices is None:
        return entry
    price = prices.price(entry.model, entry.at)
    if price is None or not price.told(entry.tokens_in, entry.tokens_out):
        return entry
    money = price.of(entry.tokens_in, entry.tokens_out, entry.images)
    return dataclasses.replace(entry, money=money)
