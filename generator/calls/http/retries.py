"""How long to wait before a call is sent again, and when not to send at all."""

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
    """How calls are tried again; all in seconds but ``factor`` and ``failures``.

    The k-th wait is drawn evenly from half to all of ``first * factor**k``, at most ``longest``.
    A Retry-After is obeyed up to ``obeyed``; a server that asks for more is not waited for. After
    ``failures`` in a row, see ``FailureStreak``, a server is left alone for ``rest``; then one call
    tries it.

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
        """Return the wait after the k-th failure, k from 0; ``share`` in [0, 1] is the draw."""
        longest = min(self.first * self.factor ** min(k, 64), self.longest)
        return longest * (0.5 + 0.5 * share)

    def draw(self, k: int) -> float:
        """Return the wait after the k-th failure, drawn at random."""
        return self.pause(k, random.random())


def retry_after(text: str | None, now: datetime | None = None) -> float | None:
    """Return the seconds that a Retry-After header asks for, by a number or a date.

    None if it is absent, unreadable or infinite.
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
    """The failures in a row that one call stands at the end of: earlier calls' and its own.

    Calls at once have one each, so that a server's bad moment, which befalls all, counts once.
    """

    turn: int
    length: int


class Breaker:
    """Keeps the calls of all threads from one server that does not work; ``clock`` in seconds."""

    def __init__(
        self, server: str, policy: RetryPolicy, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._server = server
        self._policy = policy
        self._clock = clock
        self._lock = threading.Lock()
        self._failures = 0
        self._turn = 0  # grows as a call is answered
        self._reason = ""
        self._closed_again = 0.0  # when the next call may try

    def check(self, what: str) -> None:
        """Let a call through, or not; ``what`` names it in the message.

        Raises:
            BackendError: the server failed too often in a row, and has not rested yet.
        """
        with self._lock:
            if self._failures < self._policy.failures:
                return
            left = self._closed_again - self._clock()
            if left > 0:
                raise BackendError(
                    f"{what}: not sent. {self._server} failed {self._failures} times in a row, "
                    f"last: {self._reason} It is left alone for {left:.0f} s more. "
                    "See whether it runs, then try again."
                )
            self._closed_again = self._clock() + self._policy.rest  # others wait for this one

    def line(self) -> FailureStreak:
        """Return the line of a call that begins now."""
        with self._lock:
            return FailureStreak(self._turn, self._failures)

    def record_success(self) -> None:
        """Hear that a call was answered."""
        with self._lock:
            self._failures = 0
            self._turn += 1

    def record_failure(self, reason: str, line: FailureStreak) -> None:
        """Hear that the call of a line was not; ``reason`` is a sentence for messages."""
        with self._lock:
            if line.turn != self._turn:
                line.turn, line.length = self._turn, 0
            line.length += 1
            self._failures = max(self._failures, line.length)
            self._reason = reason
            self._closed_again = self._clock() + self._policy.rest
