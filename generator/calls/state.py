"""What a call sees of its session: the settings, and how it waits and stops."""

from __future__ import annotations

import logging
import threading
import time
from concurrent.futures import Future, wait
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import urlsplit

from ..errors import StoppedError, require
from .http.address import local
from .http.pending import Deadline
from .http.retries import Breaker, RetryPolicy
from .money.ledger import Account
from .money.prices import Prices, unknown_price
from .store import CallStore

_SLICE = 0.05  # seconds between two looks at whether to stop


@dataclass(frozen=True, eq=False)
class SessionState:
    """The fields of a ``Session``, which says what they are, and the waits of its calls."""

    store: CallStore | None = None
    account: Account = field(default_factory=Account)
    prices: Prices = field(default_factory=Prices.default)
    budget: float | None = None
    workers: int = 8
    attempts: int = 5
    dry: bool = False
    stop: threading.Event = field(default_factory=threading.Event, repr=False)
    retry_policy: RetryPolicy = field(default_factory=RetryPolicy)
    grace: float = 5.0
    breakers: dict[tuple[str, str], Breaker] = field(default_factory=dict, init=False, repr=False)
    _scope: threading.local = field(default_factory=threading.local, init=False, repr=False)

    def __post_init__(self) -> None:
        require(self, "workers", "attempts", minimum=1, integer=True)
        if self.budget is not None:
            require(self, "budget", minimum=0)
        require(self, "grace", minimum=0)

    def check_price(self, model: str, base_url: str, what: str) -> None:
        """Check that a budget can be kept with a model: its price is known, or it runs here.

        Where the store holds answers, they may be all that is needed: then it is the first call to
        be paid for that is refused.

        Raises:
            BudgetError: it is not; the message begins with ``what`` and says how to add a price.
        """
        at = urlsplit(base_url)
        if self.budget is None or self.dry or local(at.hostname or ""):
            return
        may_replay = self.store is not None and not self.store.is_empty()
        if self.prices.price(model, at.netloc) is None and not may_replay:
            raise unknown_price(what, self.budget, model or f"@{at.netloc}")

    def wait_for(self, call: Future[Any]) -> BaseException | None:
        """Wait for a pending call; return the interrupt that came meanwhile, to raise it later.

        Raises:
            StoppedError: there is reason to stop, and it did not end within ``grace``.
            KeyboardInterrupt: the same for the main thread, or the second one.
        """
        own = Deadline()
        interrupt: BaseException | None = None
        while True:
            try:
                if wait([call], _SLICE).done:
                    return interrupt
            except KeyboardInterrupt as error:
                if interrupt is not None:
                    raise
                interrupt = error
                own.bring_forward(self._announce_grace())
            if self.stop.is_set():
                own.bring_forward(time.monotonic() + self.grace)
            deadlines = (own, *self._deadlines())
            if any(d.until is not None and time.monotonic() >= d.until for d in deadlines):
                raise interrupt or StoppedError(
                    "Stopped; a call under way had no answer yet. What was answered is kept."
                )

    def _announce_grace(self) -> float:
        """Tell an interrupted user what is waited for; return until when."""
        logging.getLogger(__name__).warning(
            "Interrupted: calls under way have %g s to be answered, so that what is paid for is "
            "kept. Interrupt again to end at once.", self.grace,
        )  # fmt: skip
        return time.monotonic() + self.grace

    def check(self) -> None:
        """Raise StoppedError if this session, or the work that this thread is part of, is over."""
        if self.stop.is_set():
            raise StoppedError("Stopped before all calls were made; what was answered is kept.")
        if any(halt.is_set() for halt in self._halts()):
            raise StoppedError("Given up, for a call beside this one failed.")

    def pause(self, seconds: float) -> None:
        """Wait, unless there is a reason to stop: see ``check``."""
        while seconds > 0:
            self.check()
            self.stop.wait(min(seconds, _SLICE))
            seconds -= _SLICE
        self.check()

    def _halts(self) -> tuple[threading.Event, ...]:
        return getattr(self._scope, "halts", ())

    def _deadlines(self) -> tuple[Deadline, ...]:
        return getattr(self._scope, "deadlines", ())
