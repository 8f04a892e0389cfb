"""What all paid HTTP goes through: the call store, then the server."""

from __future__ import annotations

import contextlib
import functools
import logging
import re
import ssl
from collections.abc import Mapping

import httpx2

from ..errors import BackendError, StorageError
from .http.address import local, near
from .http.dialing import Wire, proxy_for
from .http.exchange import UNPACKED, Reply, Trouble, exchange
from .http.pending import PendingCall
from .http.redaction import excerpt, holds
from .paid_call import PaidCall, SessionState, Sign, entry_of
from .question import Question, failed, question
from .store import StoredAnswer
from .used import KEY

_KEYS = ("authorization", "api-key", "x-api-key", "x-goog-api-key", "proxy-authorization")
_SENT = frozenset({
    "accept", "authorization", "connection", "content-length", "content-type",
    "host", "transfer-encoding", "user-agent",
})  # fmt: skip
_SIGNED_BY = "x-tc-"  # headers of a call that a signature covers
_CONNECT = 30.0  # seconds in which a server takes a call, however long it may work on it
_SAID = 2**14  # characters of a refusal that whoever asked gets to see
_KIND = re.compile(r"[\w.+-]{1,99}/[\w.+-]{1,99}", re.ASCII)
_LEAST = 6  # characters: shorter ones are no keys, and would redact words


class PaidTransport(httpx2.BaseTransport):
    """Sends the requests of one client to one server; see ``Session.client``."""

    def __init__(
        self,
        session: SessionState,
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
                self._session.account.add(entry_of(asked, "cached", 0.0, 0.0))
                return _response(kept.status, kept.content_type, kept.body, request, asked.key)
            call = PaidCall(
                self._session, self._breaker, self._sendable(request), asked, secrets, self._send,
                self._sign,
            )  # fmt: skip
            reply = call.answer()
            if store is not None and reply.good and not failed(reply.payload):
                self._keep(asked, reply)
            if call.interrupt is not None:
                raise call.interrupt
        body = reply.body if reply.good else _clean(reply.body, secrets)
        return _response(reply.status, reply.content_type, body, request, asked.key)

    def _send(
        self, request: httpx2.Request, secrets: tuple[str, ...]
    ) -> PendingCall[Reply | Trouble]:
        """Begin one attempt."""

        def dial(until: float) -> Wire:
            return Wire(until, self._trust, self._proxy)

        sending = (dial, request, self._timeout, self._most_bytes, secrets)
        return PendingCall(functools.partial(exchange, *sending))

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
        times = _bound(request.extensions.get("timeout", {}), self._timeout)
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

    def _keep(self, asked: Question, reply: Reply) -> None:
        """Keep an answer; a disk that refuses must not lose it."""
        assert self._session.store is not None
        try:
            self._session.store.put(
                asked.key, StoredAnswer(reply.status, reply.content_type, reply.body)
            )
        except StorageError as error:
            self._session.account.note(str(error))
            logging.getLogger(__name__).warning("%s", error)


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


def _bound(given: Mapping[str, float | None], timeout: float) -> dict[str, float]:
    """Return the times of a request's parts: none above ``timeout``, whatever its maker allows."""
    most = {"connect": min(timeout, _CONNECT), "read": timeout, "write": timeout, "pool": timeout}
    return {part: min(most[part], given.get(part) or timeout) for part in most}
