"""The transport of all paid HTTP calls: first the call store, then the server."""

from __future__ import annotations

import contextlib
import logging
import re
import ssl
from concurrent.futures import Future
from dataclasses import dataclass, replace

import httpx2

from ..errors import BackendError, StorageError
from .http.address import local, near
from .http.connections import Wire, proxy_for
from .http.exchange import COMPRESSIONS, Reply, Trouble, exchange
from .http.pending import begin
from .http.redaction import excerpt, holds
from .http.retries import Breaker
from .paid_call import PaidCall, Sign, entry_of
from .question import Question, failed, question
from .state import SessionState
from .store import KEY, StoredAnswer

_KEYS = ("authorization", "api-key", "x-api-key", "x-goog-api-key", "proxy-authorization")
_SENT = frozenset({
    "accept", "authorization", "connection", "content-length", "content-type",
    "host", "transfer-encoding", "user-agent",
})  # fmt: skip
_SIGNED_BY = "x-tc-"  # prefix of headers that a signature covers
_CONNECT = 30.0  # seconds for connecting, regardless of the server's processing time
_SAID = 2**14  # maximum characters of an error response passed to the caller
_KIND = re.compile(r"[\w.+-]{1,99}/[\w.+-]{1,99}", re.ASCII)
_LEAST = 6  # characters; shorter strings are not keys, and redacting them would garble words


@dataclass(eq=False, repr=False)
class PaidTransport(httpx2.BaseTransport):
    """Transport of one client's requests to the origin of ``base_url``; see ``Session.client``."""

    session: SessionState
    server: str
    base_url: str
    timeout: float
    most_bytes: int
    secrets: tuple[str, ...]
    headers: tuple[str, ...]
    sign: Sign | None
    trust: ssl.SSLContext

    def __post_init__(self) -> None:
        self._base = base = httpx2.URL(self.base_url)
        if self.secrets and base.scheme == "http" and not near(base.host):
            told = (
                f"{self.server}: the key would be sent to {base.host} unencrypted, where others "
                "can read it. Use an https address."
            )
            if told not in self.session.account.notes:
                self._warn(told)
        origin = f"{base.scheme}://{base.netloc.decode()}"
        breaker = Breaker(self.server, self.session.retry_policy)
        self._breaker = self.session.breakers.setdefault((self.server, origin), breaker)
        self._proxy = None if local(base.host) else proxy_for(base.scheme, base.host)

    def handle_request(self, request: httpx2.Request) -> httpx2.Response:
        """Return the response to a request, from the store or else from the server.

        Raises:
            BackendError: the call failed; BudgetError, DryRunError and StoppedError are subclasses.
        """
        asked = question(request, self.server, self.session.prices)
        secrets = (*self.secrets, *_keys(request))
        self._check_address(request, asked, secrets)
        store = None if asked.memo == "no" else self.session.store
        with contextlib.ExitStack() as held:
            if store is not None:
                held.enter_context(store.holding(asked.key, self.session.check))
            kept = store.get(asked.key) if store is not None and asked.memo == "yes" else None
            if kept is not None:
                self.session.account.add(entry_of(asked, "cached", 0.0, 0.0))
                return _response(kept, request, asked.key)
            call = PaidCall(
                self.session, self._breaker, self._sendable(request), asked, secrets, self._send,
                self.sign,
            )  # fmt: skip
            reply = call.answer()
            answer = StoredAnswer(reply.status, reply.content_type, reply.body)
            if store is not None and reply.good and not failed(reply.payload):
                try:
                    store.put(asked.key, answer)
                except StorageError as error:  # a disk failure must not lose the answer
                    self._warn(str(error))
            if call.interrupt is not None:
                raise call.interrupt
        if not reply.good:  # an error response may contain the key
            answer = replace(answer, body=excerpt(reply.body, _SAID, secrets).encode())
        return _response(answer, request, asked.key)

    def _warn(self, told: str) -> None:
        self.session.account.note(told)
        logging.getLogger(__name__).warning("%s", told)

    def _send(self, request: httpx2.Request, secrets: tuple[str, ...]) -> Future[Reply | Trouble]:
        """Send a request once in a background thread; return the future of its outcome."""

        def dial(until: float) -> Wire:
            return Wire(until, self.trust, self._proxy)

        return begin(lambda: exchange(dial, request, self.timeout, self.most_bytes, secrets))

    def _sendable(self, request: httpx2.Request) -> httpx2.Request:
        """Return a copy of a request with only the headers and timeouts meant for this server.

        The caller's own request stays unchanged, including its internal headers.
        """
        sent = _SENT | set(self.headers)
        headers = [
            (name, value)
            for name, value in request.headers.multi_items()
            if (name in sent or name.startswith(_SIGNED_BY))
            and (name != "authorization" or not self.secrets or holds(value, self.secrets))
        ] + [("accept-encoding", COMPRESSIONS)]
        given = request.extensions.get("timeout", {})
        most = dict.fromkeys(("connect", "read", "write", "pool"), self.timeout)
        most["connect"] = min(self.timeout, _CONNECT)
        times = {part: min(bound, given.get(part) or self.timeout) for part, bound in most.items()}
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
                f"{asked}: this client is restricted to {base.scheme}://{base.netloc.decode()} "
                f"and cannot call {url.scheme}://{url.netloc.decode()}. Open a client for that "
                "server."
            )
        if holds(url.query.decode("ascii", "replace"), secrets):
            raise BackendError(
                f"{asked}: the address contains a key, which logs would show. Send the key in a "
                "header."
            )


def _response(answer: StoredAnswer, request: httpx2.Request, key: str) -> httpx2.Response:
    """Return the client's response, which is identical from the store and from the server.

    Text is decoded as UTF-8, like JSON, regardless of the charset that a server declares.
    """
    kind = answer.content_type.partition(";")[0].strip()
    headers = {KEY: key, **({"content-type": kind} if _KIND.fullmatch(kind) else {})}
    return httpx2.Response(answer.status, headers=headers, content=answer.body, request=request)


def _keys(request: httpx2.Request) -> tuple[str, ...]:
    """Return the keys in a request's headers."""
    values = [request.headers.get(name, "") for name in _KEYS]
    words = (word for value in values for word in value.replace(",", " ").split())
    return tuple(word for word in words if len(word) >= _LEAST and word.lower() != "bearer")
