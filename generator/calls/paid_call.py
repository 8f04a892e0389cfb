"""One paid question: its budget, its place in the ledger, and its attempts."""

from __future__ import annotations

import dataclasses
import time
from collections.abc import Callable, Mapping
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any

import httpx2
import tenacity

from ..errors import BackendError, DryRunError, StorageError, TabletopError, UnusableError
from .http.exchange import Reply, Trouble
from .http.redaction import redact
from .http.retries import Breaker, retry_after
from .money.entries import Entry, Outcome
from .question import NOTHING, Question, Usage, failed, usage
from .state import SessionState

_LATE = 1  # how often a call is sent again that was waited for in vain: each may have been paid for

Sign = Callable[[httpx2.Request], Mapping[str, str]]


@dataclass(eq=False, repr=False)
class PaidCall:
    """One question, sent until it is answered.

    ``request`` asks what ``asked`` says; no message may hold ``secrets``. ``send`` begins one
    attempt; ``sign`` gives the headers that sign a request, for each attempt anew. ``interrupt``
    came while the answer was waited for, and is to be raised once that is kept.
    """

    session: SessionState
    breaker: Breaker
    request: httpx2.Request
    asked: Question
    secrets: tuple[str, ...]
    send: Callable[[httpx2.Request, tuple[str, ...]], Future[Reply | Trouble]]
    sign: Sign | None = None
    interrupt: BaseException | None = None

    def answer(self) -> Reply:
        """Return the server's answer.

        Raises:
            BackendError: there is none; BudgetError, DryRunError and StoppedError are such.
        """
        if self.session.dry:
            most, currency = self.asked.most, self.session.prices.currency
            price = "at a price that is not known"
            if most is not None:
                price = f"for at most {most:.4f} {currency}"
            raise DryRunError(f"Would ask {self.asked}, {price}.")
        self._line, self._late = self.breaker.line(), 0
        told = tenacity.Retrying(
            retry=tenacity.retry_if_result(lambda told: isinstance(told, Trouble)),
            stop=lambda s: s.attempt_number >= self.session.attempts or self._late > _LATE,
            wait=self._wait,
            sleep=self.session.pause,
            retry_error_callback=self._give_up,
        )(self._attempt)
        assert isinstance(told, Reply)  # else ``_give_up`` has raised
        return told

    def _attempt(self) -> Reply | Trouble:
        """Send the request once; return the answer, or why there is none, if another may help."""
        self.session.check()
        self.breaker.check(str(self.asked))
        told = self._pay()
        if isinstance(told, Reply):
            self.breaker.record_success()
            return told
        if self.interrupt is not None:
            raise self.interrupt
        reason = redact(told.reason, self.secrets)
        if told.alive:
            self.breaker.record_success()
        else:
            self.breaker.record_failure(reason, self._line)
        if not told.again:
            kind = UnusableError if told.unusable else BackendError
            raise kind(f"{self.asked}: no answer. {reason}")
        self._late += told.late
        return told

    def _pay(self) -> Reply | Trouble:
        """Send the request once, within the budget, and enter it in the ledger."""
        session, asked, account = self.session, self.asked, self.session.account
        lost = entry_of(asked, "failed", 0.0, asked.most)
        with account.reserving(
            asked.most, session.budget, str(asked), session.check, asked.model or f"@{asked.at}"
        ) as enter:
            try:
                if self.sign is not None:  # not earlier: what is signed is soon too old
                    self.request.headers.update(self.sign(self.request))
                record = account.record(lost, asked.key, must=session.budget is not None)
            except BaseException as error:
                enter(dataclasses.replace(lost, money=0.0))
                if not isinstance(error, StorageError):
                    raise
                raise StorageError(
                    f"{asked}: not sent, for a budget is to be kept. {error}"
                ) from error
            began = time.monotonic()

            def end(outcome: Outcome, money: float | None, spent: Usage = NOTHING) -> None:
                entry = entry_of(asked, outcome, time.monotonic() - began, money, spent)
                record(entry)
                enter(entry)

            call = self.send(self.request, self.secrets)
            try:
                self.interrupt = session.wait_for(call)
                told = call.result()
            except BaseException as error:  # it may be answered, and paid for, all the same
                end("failed", asked.most)
                if isinstance(error, TabletopError) or not isinstance(error, Exception):
                    raise
                raise BackendError(
                    f"{asked}: the call broke off by a {type(error).__name__}, a fault of this "
                    "program. What was answered before is kept."
                ) from None
            spent = NOTHING if isinstance(told, Trouble) else usage(told.payload)
            if isinstance(told, Trouble):
                end("failed", asked.most if told.charged else 0.0)
            elif not told.good or failed(told.payload):  # some answers break off in the middle
                begun = spent.tokens_in or spent.tokens_out
                end("failed", asked.money(spent) if begun else 0.0, spent)
            else:
                end("answered", asked.money(spent), spent)
        return told

    def _wait(self, state: tenacity.RetryCallState) -> float:
        """Return how long to wait before the next attempt."""
        assert state.outcome is not None
        policy, wanted = self.session.retry_policy, retry_after(state.outcome.result().wait)
        if wanted is None:
            return policy.draw(state.attempt_number - 1)
        if wanted > policy.obeyed:
            raise BackendError(
                f"{self.asked}: the server asks to wait {wanted:.0f} s, more than the "
                f"{policy.obeyed:g} s that are waited. What was answered is kept; run it again "
                "then."
            )
        return wanted + policy.pause(0, 0.0) / 10  # not at the very moment that ends the wait

    def _give_up(self, state: tenacity.RetryCallState) -> Any:
        """Raise the error of a question that had its last attempt."""
        assert state.outcome is not None
        k, reason = state.attempt_number, redact(state.outcome.result().reason, self.secrets)
        times = f"{k} times" if k > 1 else "once"
        raise BackendError(
            f"{self.asked}: no answer, asked {times}. {reason} What was answered before is kept; "
            "see whether the server runs, and try again."
        )


def entry_of(
    asked: Question, outcome: Outcome, seconds: float, money: float | None, spent: Usage = NOTHING
) -> Entry:
    """Return the ledger's entry of a call."""
    return Entry(
        asked.server, asked.name, asked.model, outcome, seconds,
        spent.tokens_in, spent.tokens_out, spent.images, money, at=asked.at,
    )  # fmt: skip
