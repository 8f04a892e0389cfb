"""One paid call: its budget, its entry in the ledger, and its retries."""

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

_LATE = 1  # maximum retries after a timeout; each attempt may have been billed

Sign = Callable[[httpx2.Request], Mapping[str, str]]


@dataclass(eq=False, repr=False)
class PaidCall:
    """One call, retried until it succeeds or fails for good.

    ``request`` is the request for the question ``asked``. Messages never contain ``secrets``.
    ``send`` starts one attempt; ``sign`` returns the headers that sign a request, computed for each
    attempt. ``interrupt`` is an interrupt that arrived during the wait for the answer; it is raised
    once the answer is stored.
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
            BackendError: the call failed; BudgetError, DryRunError and StoppedError are subclasses.
        """
        if self.session.dry:
            most, currency = self.asked.most, self.session.prices.currency
            price = "at an unknown price"
            if most is not None:
                price = f"for at most {most:.4f} {currency}"
            raise DryRunError(f"Would call {self.asked}, {price}.")
        self._line, self._late = self.breaker.line(), 0
        result = tenacity.Retrying(
            retry=tenacity.retry_if_result(lambda result: isinstance(result, Trouble)),
            stop=lambda s: s.attempt_number >= self.session.attempts or self._late > _LATE,
            wait=self._wait,
            sleep=self.session.pause,
            retry_error_callback=self._give_up,
        )(self._attempt)
        assert isinstance(result, Reply)  # otherwise ``_give_up`` has raised an error
        return result

    def _attempt(self) -> Reply | Trouble:
        """Send the request once; return the answer, or a failure that a retry may fix."""
        self.session.check()
        self.breaker.check(str(self.asked))
        result = self._pay()
        if isinstance(result, Reply):
            self.breaker.record_success()
            return result
        if self.interrupt is not None:
            raise self.interrupt
        reason = redact(result.reason, self.secrets)
        if result.alive:
            self.breaker.record_success()
        else:
            self.breaker.record_failure(reason, self._line)
        if not result.again:
            kind = UnusableError if result.unusable else BackendError
            raise kind(f"{self.asked}: the call failed. {reason}")
        self._late += result.late
        return result

    def _pay(self) -> Reply | Trouble:
        """Send the request once, within the budget, and record it in the ledger."""
        session, asked, account = self.session, self.asked, self.session.account
        lost = entry_of(asked, "failed", 0.0, asked.most)
        with account.reserving(
            asked.most, session.budget, str(asked), session.check, asked.model or f"@{asked.at}"
        ) as enter:
            try:
                if self.sign is not None:  # only now, because signatures expire quickly
                    self.request.headers.update(self.sign(self.request))
                record = account.record(lost, asked.key, must=session.budget is not None)
            except BaseException as error:
                enter(dataclasses.replace(lost, money=0.0))
                if not isinstance(error, StorageError):
                    raise
                raise StorageError(
                    f"{asked}: not sent, because its cost cannot be recorded for the budget. "
                    f"{error}"
                ) from error
            began = time.monotonic()

            def end(outcome: Outcome, money: float | None, spent: Usage = NOTHING) -> None:
                entry = entry_of(asked, outcome, time.monotonic() - began, money, spent)
                record(entry)
                enter(entry)

            call = self.send(self.request, self.secrets)
            try:
                self.interrupt = session.wait_for(call)
                result = call.result()
            except BaseException as error:  # the server may still answer the call and bill it
                end("failed", asked.most)
                if isinstance(error, TabletopError) or not isinstance(error, Exception):
                    raise
                raise BackendError(
                    f"{asked}: the call was aborted by an unexpected {type(error).__name__}, a "
                    "bug in this program. Received answers are kept."
                ) from None
            spent = NOTHING if isinstance(result, Trouble) else usage(result.payload)
            if isinstance(result, Trouble):
                end("failed", asked.most if result.charged else 0.0)
            elif not result.good or failed(result.payload):  # some answers break off in the middle
                begun = spent.tokens_in or spent.tokens_out
                end("failed", asked.money(spent) if begun else 0.0, spent)
            else:
                end("answered", asked.money(spent), spent)
        return result

    def _wait(self, state: tenacity.RetryCallState) -> float:
        """Return the wait before the next attempt in seconds."""
        assert state.outcome is not None
        policy, wanted = self.session.retry_policy, retry_after(state.outcome.result().wait)
        if wanted is None:
            return policy.draw(state.attempt_number - 1)
        if wanted > policy.obeyed:
            raise BackendError(
                f"{self.asked}: the server requested a wait of {wanted:.0f} s, which exceeds "
                f"the maximum of {policy.obeyed:g} s. Received answers are kept; run the "
                "command again later."
            )
        return wanted + policy.pause(0, 0.0) / 10  # a margin after the requested wait

    def _give_up(self, state: tenacity.RetryCallState) -> Any:
        """Raise the error of a call whose last attempt failed."""
        assert state.outcome is not None
        k, reason = state.attempt_number, redact(state.outcome.result().reason, self.secrets)
        attempts = f"{k} attempts" if k > 1 else "1 attempt"
        raise BackendError(
            f"{self.asked}: the call failed after {attempts}. {reason} Received answers are kept; "
            "check that the server is running, and try again."
        )


def entry_of(
    asked: Question, outcome: Outcome, seconds: float, money: float | None, spent: Usage = NOTHING
) -> Entry:
    """Return the ledger entry of a call."""
    return Entry(
        asked.server, asked.name, asked.model, outcome, seconds,
        spent.tokens_in, spent.tokens_out, spent.images, money, at=asked.at,
    )  # fmt: skip
