"""The part of a session's state that its calls use: settings, waits and stops."""

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

_SLICE = 0.05  # seconds between checks for a stop


@dataclass(frozen=True, eq=False)
class SessionState:
    """The fields of a ``Session`` (documented there) and the waits of its calls."""

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
        """Check that a budget can be enforced for a model: its price is known, or it runs locally.

        If the store holds answers, it may be able to answer every call, so no error is raised here;
        the first call that must be paid for is refused instead.

        Raises:
            BudgetError: the price is unknown; the message starts with ``what`` and explains how to
                add a price.
        """
        at = urlsplit(base_url)
        if self.budget is None or self.dry or local(at.hostname or ""):
            return
        may_replay = self.store is not None and not self.store.is_empty()
        if self.prices.price(model, at.netloc) is None and not may_replay:
            raise unknown_price(what, self.budget, model or f"@{at.netloc}")

    def wait_for(self, call: Future[Any]) -> BaseException | None:
        """Wait for a pending call; return any interrupt during the wait, to be raised later.

        Raises:
            StoppedError: the session stopped, and the call did not end within ``grace`` seconds.
            KeyboardInterrupt: the same happened in the main thread, or a second interrupt arrived.
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
                    "Stopped before a call in flight was answered. Received answers are kept."
                )

    def _announce_grace(self) -> float:
        """Log the grace period after an interrupt; return its end."""
        logging.getLogger(__name__).warning(
            "Interrupted: waiting up to %g s for calls in flight, so that answers already paid "
            "for are kept. Interrupt again to exit immediately.", self.grace,
        )  # fmt: skip
        return time.monotonic() + self.grace

    def check(self) -> None:
        """Raise StoppedError if the session, or the work that this thread belongs to, has ended."""
        if self.stop.is_set():
            raise StoppedError("Stopped before all calls were sent. Received answers are kept.")
        if any(halt.is_set() for halt in self._halts()):
            raise StoppedError("Stopped because a concurrent call failed.")

    def pause(self, seconds: float) -> None:
        """Wait ``seconds``, unless the session stops; see ``check``."""
        while seconds > 0:
            self.check()
            self.stop.wait(min(seconds, _SLICE))
            seconds -= _SLICE
        self.check()

    def _halts(self) -> tuple[threading.Event, ...]:
        return getattr(self._scope, "halts", ())

    def _deadlines(self) -> tuple[Deadline, ...]:
        return getattr(self._scope, "deadlines", ())
