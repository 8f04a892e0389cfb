"""What all paid HTTP goes through: the store, the budget, the ledger, and another attempt."""

from __future__ import annotations

import contextlib
import dataclasses
import functools
import logging
import re
import ssl
import time
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NoReturn, Protocol

import httpx2
import tenacity

from ..errors import (
    BackendError,
    DryRunError,
    StorageError,
    TabletopError,
    UnusableError,
)
from .http.address import local, near
from .http.dialing import Wire, proxy_for
from .http.exchange import (
    UNPACKED,
    Reply,
    Trouble,
    exchange,
)
from .http.pending import PendingCall
from .http.redaction import excerpt, holds, redacted
from .http.waiting import Breakers, Line, RetryPolicy, retry_after
from .money.account import Account
from .money.entries import Entry, Outcome
from .money.prices import Prices
from .question import (
    NOTHING,
    Question,
    Usage,
    failed,
    question,
    usage,
)
from .store import Answer, CallStore
from .used import KEY

_KEYS = ("authorization", "api-key", "x-api-key", "x-goog-api-key", "proxy-authorization")
_SENT = frozenset({
    "accept", "authorization", "connection", "content-length", "content-type",
    "host", "transfer-encoding", "user-agent",
})  # fmt: skip
_SIGNED_BY = "x-tc-"  # headers of a call that a signature covers
_LATE = 1  # how often a call is sent again that was waited for in vain: each may have been paid for
_CONNECT = 30.0  # seconds in which a server takes a call, however long it may work on it
_SAID = 2**14  # characters of a refusal that whoever asked gets to see
_KIND = re.compile(r"[\w.+-]{1,99}/[\w.+-]{1,99}", re.ASCII)
_LEAST = 6  # characters: shorter ones are no keys, and would redact words

Sign = Callable[[httpx2.Request], Mapping[str, str]]


class Pacing(Protocol):
    """What the calls of a session share, as one call sees it; see ``Session``."""

    @property
    def store(self) -> CallStore | None: ...  # noqa: D102
    @property
    def account(self) -> Account: ...  # noqa: D102
    @property
    def prices(self) -> Prices: ...  # noqa: D102
    @property
    def budget(self) -> float | None: ...  # noqa: D102
    @property
    def attempts(self) -> int: ...  # noqa: D102
    @property
    def dry(self) -> bool: ...  # noqa: D102
    @property
    def retry_policy(self) -> RetryPolicy: ...  # noqa: D102
    @property
    def breakers(self) -> Breakers: ...  # noqa: D102

    def check(self) -> None:
        """Raise StoppedError if there is a reason to stop."""
        ...

    def pause(self, seconds: float) -> None:
        """Wait, unless there is a reason to stop."""
        ...

    def wait_for(self, call: PendingCall[Any]) -> BaseException | None:
        """Wait for a pending call; return what interrupted it."""
        ...


class PaidTransport(httpx2.BaseTransport):
    """Sends the requests of one client to one server; see ``Session.client``."""

    def __init__(
        self,
        session: Pacing,
        server: str,
        base_url: str,
        timeout: float,
        most_bytes: int,
        secrets: tuple[str, ...],
        headers: tuple[str, ...] = (),
        sign: Sign | None = None,
        *,
        trust: ssl.SSLContext,
    ) -> None:
        """Speak to the origin of ``base_url``; the rest is as in ``Session.client``."""
        self._session = session
        self._server = server
        self._base = httpx2.URL(base_url)
        self._timeout = timeout
        self._most_bytes = most_bytes
        self._secrets = secrets
        self._headers = _SENT | set(headers)
        self._sign = sign
        self._warn_of_open_keys()
        origin = f"{self._base.scheme}://{self._base.netloc.decode()}"
        self._breaker = session.breakers.of(server, origin, session.retry_policy)
        self._trust = trust
        here = local(self._base.host)
        self._proxy = None if here else proxy_for(self._base.scheme, self._base.host)

    def _warn_of_open_keys(self) -> None:
        if self._secrets and self._base.scheme == "http" and not near(self._base.host):
            told = (
                f"{self._server}: its key goes to {self._base.host} unencrypted, where everyone on "
                "the way can read it. Use an https address."
            )
            if told not in self._session.account.notes:
                self._session.account.note(told)
                logging.getLogger(__name__).warning("%s", told)

    def handle_request(self, request: httpx2.Request) -> httpx2.Response:
        """Answer a request from the store, else from the server.

        Raises:
            BackendError: there is no answer; BudgetError, DryRunError and StoppedError are such.
        """
        asked = question(request, self._server, self._session.prices)
        secrets = (*self._secrets, *_keys(request))
        self._check_address(request, asked, secrets)
        store = None if asked.memo == "no" else self._session.store
        with contextlib.ExitStack() as held:
            if store is not None:
                held.enter_context(store.holding(asked.key, self._session.check))
            kept = store.get(asked.key) if store is not None and asked.memo == "yes" else None
            if kept is not None:
                self._session.account.add(_entry(asked, "cached", 0.0, 0.0))
                return _response(kept.status, kept.content_type, kept.body, request, asked.key)
            interrupted = held.enter_context(_raised_later())
            reply = self._ask(request, asked, secrets, interrupted)
            if store is not None and reply.good and not failed(reply.payload):
                self._keep(asked, reply)
        body = reply.body if reply.good else _clean(reply.body, secrets)
        return _response(reply.status, reply.content_type, body, request, asked.key)

    def _dial(self, until: float) -> Wire:
        """Return the connections of one attempt."""
        return Wire(until, self._trust, self._proxy)

    def _sendable(self, request: httpx2.Request) -> httpx2.Request:
        """Return a request with no more headers than this server is to see, and its time bounded.

        Whoever made the request reads in his own what he asked for.
        """
        headers = [
            (name, value)
            for name, value in request.headers.multi_items()
            if (name in self._headers or name.startswith(_SIGNED_BY))
            and (name != "authorization" or not self._secrets or holds(value, self._secrets))
        ] + [("accept-encoding", UNPACKED)]
        times = _bounded(request.extensions.get("timeout", {}), self._timeout)
        return httpx2.Request(
            request.method, request.url, headers=headers, content=request.content,
            extensions={**request.extensions, "timeout": times},
        )  # fmt: skip

    def _check_address(
        self, request: httpx2.Request, asked: Question, secrets: tuple[str, ...]
    ) -> None:
        url, base = request.url, self._base
        if (url.scheme, url.host, url.port) != (base.scheme, base.host, base.port):
            raise BackendError(
                f"{asked}: this client is for {base.scheme}://{base.netloc.decode()} and does not "
                f"call {url.scheme}://{url.netloc.decode()}. Open a client for that server."
            )
        if holds(url.query.decode("ascii", "replace"), secrets):
            raise BackendError(
                f"{asked}: a key is part of the address, where logs would show it. "
                "Send it in a header."
            )

    def _ask(
        self,
        request: httpx2.Request,
        asked: Question,
        secrets: tuple[str, ...],
        interrupted: list[BaseException],
    ) -> Reply:
        """Send a request until it is answered; ``interrupted`` gets what to raise thereafter."""
        session = self._session
        if session.dry:
            raise DryRunError(_would(asked, session.prices.currency))
        attempt = functools.partial(
            self._judged_attempt, self._sendable(request), asked, secrets, interrupted,
            self._breaker.line(),
        )  # fmt: skip
        late: list[Trouble] = []
        retrying = tenacity.Retrying(
            retry=tenacity.retry_if_result(lambda told: isinstance(told, Trouble)),
            stop=lambda state: state.attempt_number >= session.attempts or len(late) > _LATE,
            wait=lambda state: self._wait(state, asked),
            sleep=session.pause,
            retry_error_callback=functools.partial(_give_up, asked, secrets),
        )
        told = retrying(attempt, late)
        assert isinstance(told, Reply)  # else ``_give_up`` has raised
        return told

    def _judged_attempt(
        self,
        request: httpx2.Request,
        asked: Question,
        secrets: tuple[str, ...],
        interrupted: list[BaseException],
        line: Line,
        late: list[Trouble],
    ) -> Reply | Trouble:
        """Send a request once, unless there is a reason not to; return what may be tried again."""
        self._session.check()
        self._breaker.check(str(asked))
        told, interrupt = self._attempt(request, asked, secrets)
        if isinstance(told, Reply):
            self._breaker.worked()
            interrupted.extend(filter(None, [interrupt]))
            return told
        if interrupt is not None:
            raise interrupt
        reason = redacted(told.reason, secrets)
        if told.alive:
            self._breaker.worked()
        else:
            self._breaker.failed(reason, line)
        if not told.again:
            kind = UnusableError if told.unusable else BackendError
            raise kind(f"{asked}: no answer. {reason}")
        late.extend([told] * told.late)
        return told

    def _attempt(
        self, request: httpx2.Request, asked: Question, secrets: tuple[str, ...]
    ) -> tuple[Reply | Trouble, BaseException | None]:
        """Send a request once, within the budget, and enter it in the ledger.

        Returns the answer, and the interrupt that came while it was waited for.
        """
        session, account = self._session, self._session.account
        lost = _entry(asked, "failed", 0.0, asked.most)
        with account.reserving(asked.most, session.budget, str(asked), session.check) as enter:
            try:
                if self._sign is not None:  # not earlier: what is signed is soon too old
                    request.headers.update(self._sign(request))
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
                entry = _entry(asked, outcome, time.monotonic() - began, money, spent)
                record(entry)
                enter(entry)

            sending = (self._dial, request, self._timeout, self._most_bytes, secrets)
            call = PendingCall(functools.partial(exchange, *sending))
            try:
                interrupt = session.wait_for(call)
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
        return told, interrupt

    def _wait(self, state: tenacity.RetryCallState, asked: Question) -> float:
        """Return how long to wait before the next attempt."""
        assert state.outcome is not None
        policy, wanted = self._session.retry_policy, retry_after(state.outcome.result().wait)
        if wanted is None:
            return policy.draw(state.attempt_number - 1)
        if wanted > policy.obeyed:
            raise BackendError(
                f"{asked}: the server asks to wait {wanted:.0f} s, more than the "
                f"{policy.obeyed:g} s that are waited. What was answered is kept; run it again "
                "then."
            )
        return wanted + policy.pause(0, 0.0) / 10  # not at the very moment that ends the wait

    def _keep(self, asked: Question, reply: Reply) -> None:
        """Keep an answer; a disk that refuses must not lose it."""
        assert self._session.store is not None
        try:
            self._session.store.put(asked.key, Answer(reply.status, reply.content_type, reply.body))
        except StorageError as error:
            self._session.account.note(str(error))
            logging.getLogger(__name__).warning("%s", error)


def _give_up(asked: Question, secrets: tuple[str, ...], state: tenacity.RetryCallState) -> NoReturn:
    """Raise the error of a question that had its last attempt."""
    assert state.outcome is not None
    k, reason = state.attempt_number, redacted(state.outcome.result().reason, secrets)
    times = f"{k} times" if k > 1 else "once"
    raise BackendError(
        f"{asked}: no answer, asked {times}. {reason} What was answered before is kept; see "
        "whether the server runs, and try again."
    )


@contextlib.contextmanager
def _raised_later() -> Iterator[list[BaseException]]:
    """Yield a list; what is put there is raised at the end, when an answer is kept."""
    later: list[BaseException] = []
    try:
        yield later
    finally:
        for error in later:
            raise error


def _entry(
    asked: Question, outcome: Outcome, seconds: float, money: float | None, spent: Usage = NOTHING
) -> Entry:
    return Entry(
        asked.server, asked.name, asked.model, outcome, seconds,
        spent.tokens_in, spent.tokens_out, spent.images, money, at=asked.at,
    )  # fmt: skip


def _response(
    status: int, content_type: str, body: bytes, request: httpx2.Request, key: str
) -> httpx2.Response:
    """Return a response as a client gets it, the same from the store as from the server.

    Text is UTF-8, as JSON's is: what else a server may call it would choose how it is decoded.
    """
    kind = content_type.partition(";")[0].strip()
    headers = {KEY: key, **({"content-type": kind} if _KIND.fullmatch(kind) else {})}
    return httpx2.Response(status, headers=headers, content=body, request=request)


def _keys(request: httpx2.Request) -> tuple[str, ...]:
    """Return the keys that a request's headers hold."""
    values = [request.headers.get(name, "") for name in _KEYS]
    words = (word for value in values for word in value.replace(",", " ").split())
    return tuple(word for word in words if len(word) >= _LEAST and word.lower() != "bearer")


def _clean(body: bytes, secrets: tuple[str, ...]) -> bytes:
    """Return the body of a refusal without the key that it may repeat."""
    return excerpt(body, _SAID, secrets).encode()


def _would(asked: Question, currency: str) -> str:
    """Return what a dry run says of a call."""
    if asked.most is None:
        return f"Would ask {asked}, at a price that is not known."
    return f"Would ask {asked}, for at most {asked.most:.4f} {currency}."


def _bounded(given: Mapping[str, float | None], timeout: float) -> dict[str, float]:
    """Return the times of a request's parts: none above ``timeout``, whatever its maker allows."""
    most = {"connect": min(timeout, _CONNECT), "read": timeout, "write": timeout, "pool": timeout}
    return {part: min(most[part], given.get(part) or timeout) for part in most}
