"""Waits between retries, and a circuit breaker per server."""

from __future__ import annotations

import contextlib
import email.utils
import random
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime

from ...errors import BackendError, require


@dataclass(frozen=True)
class RetryPolicy:
    """Settings of retries; times are in seconds.

    The k-th wait is drawn uniformly between half of ``first * factor**k`` and all of it, at most
    ``longest``. A Retry-After header of up to ``obeyed`` seconds is obeyed; a longer one ends the
    call. After ``failures`` consecutive failures (see ``FailureStreak``), no call is sent to the
    server for ``rest`` seconds; then a single call tests whether it works again.

    Raises:
        InputError: a number is out of range.
    """

    first: float = 1.0
    factor: float = 2.0
    longest: float = 30.0
    obeyed: float = 120.0
    failures: int = 8
    rest: float = 30.0

    def __post_init__(self) -> None:
        require(self, "first", "longest", "obeyed", "rest", minimum=0)
        require(self, "factor", minimum=1)
        require(self, "failures", minimum=1, integer=True)

    def pause(self, k: int, share: float) -> float:
        """Return the wait after the k-th failure (k >= 0); ``share`` in [0, 1] is a random draw."""
        longest = min(self.first * self.factor ** min(k, 64), self.longest)
        return longest * (0.5 + 0.5 * share)

    def draw(self, k: int) -> float:
        """Return the wait after the k-th failure with a random draw."""
        return self.pause(k, random.random())


def retry_after(text: str | None, now: datetime | None = None) -> float | None:
    """Return the wait in seconds that a Retry-After header (a number or a date) requests.

    The result is None if the header is absent, unreadable or infinite.
    """
    if text is None:
        return None
    with contextlib.suppress(ValueError):
        seconds = float(text)
        return seconds if 0 <= seconds < float("inf") else None
    try:
        date = email.utils.parsedate_to_datetime(text)
        date = date if date.tzinfo else date.replace(tzinfo=UTC)
        return max(0.0, (date - (now or datetime.now(UTC))).total_seconds())
    except (ValueError, TypeError, IndexError, OverflowError):
        return None


@dataclass
class FailureStreak:
    """The consecutive failures before and during one call.

    Each concurrent call has its own streak, so that one outage, which fails all of them at once,
    counts once.
    """

    turn: int
    length: int


class Breaker:
    """A circuit breaker, shared by all threads, for one server; ``clock`` is in seconds."""

    def __init__(
        self, server: str, policy: RetryPolicy, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._server = server
        self._policy = policy
        self._clock = clock
        self._lock = threading.Lock()
        self._failures = 0
        self._turn = 0  # number of successful calls
        self._reason = ""
        self._closed_again = 0.0  # earliest time of the next trial call

    def check(self, what: str) -> None:
        """Raise an error if the server failed too often; ``what`` names the call in the message.

        Raises:
            BackendError: the server failed too often in a row, and its rest period is not over.
        """
        with self._lock:
            if self._failures < self._policy.failures:
                return
            left = self._closed_again - self._clock()
            if left > 0:
                raise BackendError(
                    f"{what}: not sent. {self._server} failed {self._failures} times in a row; "
                    f"last failure: {self._reason} The server is not contacted for another "
                    f"{left:.0f} s. Check that the server is running, then try again."
                )
            # only one trial call; the others wait for its outcome
            self._closed_again = self._clock() + self._policy.rest

    def line(self) -> FailureStreak:
        """Return the failure streak of a call that starts now."""
        with self._lock:
            return FailureStreak(self._turn, self._failures)

    def record_success(self) -> None:
        """Record that a call succeeded."""
        with self._lock:
            self._failures = 0
            self._turn += 1

    def record_failure(self, reason: str, line: FailureStreak) -> None:
        """Record a failed call with the streak ``line``; ``reason`` is a sentence for messages."""
        with self._lock:
            if line.turn != self._turn:
                line.turn, line.length = self._turn, 0
            line.length += 1
            self._failures = max(self._failures, line.length)
            self._reason = reason
            self._closed_again = self._clock() + self._policy.rest
