"""Connections with one deadline for every wait: DNS, TCP, TLS, proxies, reads and writes."""

from __future__ import annotations

import contextlib
import socket
import ssl
import threading
import time
import urllib.request
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import wait
from importlib.util import find_spec
from typing import Any
from urllib.parse import unquote

import httpcore2
import httpx2

from ...errors import BackendError
from ...io.bounded import split_url
from .pending import begin

_PROXIES = ("http", "https", "socks5", "socks5h")


class Dialer(httpcore2.NetworkBackend):
    """A network backend that shuts down its connections at a deadline (in ``time.monotonic`` time).

    The timeouts of HTTP libraries apply to single reads, so a server that sends a byte now and then
    could block a call forever.
    """

    def __init__(self, until: float) -> None:
        self._until = until
        self._sockets: list[socket.socket] = []
        self._watch = threading.Timer(max(0.0, until - time.monotonic()), self._shut_down)
        self._watch.daemon = True
        self._watch.start()

    def connect_tcp(
        self,
        host: str,
        port: int,
        timeout: float | None = None,
        local_address: str | None = None,
        socket_options: Iterable[Any] | None = None,
    ) -> httpcore2.NetworkStream:
        """Return a connection to the first address of a host that accepts one."""
        now = time.monotonic()
        until = self._until if timeout is None else min(self._until, now + timeout)
        found = begin(lambda: socket.getaddrinfo(host, port, type=socket.SOCK_STREAM))
        if not wait([found], until - now).done:
            raise httpcore2.ConnectTimeout("The host name was not resolved in time.")
        try:
            places = [str(place[4][0]) for place in found.result()]
        except (OSError, ValueError) as error:  # ValueError: invalid host name
            raise httpcore2.ConnectError(str(error)) from error
        stream = connect_any(places, port, until)
        # A duplicate, since TLS detaches the library's own socket.
        self._sockets.append(stream.get_extra_info("socket").dup())
        if time.monotonic() >= self._until:
            self._shut_down()
        return stream

    def close(self) -> None:
        """Stop watching the deadline."""
        self._watch.cancel()
        for copy in self._sockets:
            copy.close()

    def _shut_down(self) -> None:
        for copy in self._sockets:
            with contextlib.suppress(OSError):
                copy.shutdown(socket.SHUT_RDWR)


def connect_any(places: Sequence[str], port: int, until: float) -> httpcore2.NetworkStream:
    """Return a connection to the first address that accepts one; all addresses get equal time.

    Raises:
        httpcore2.ConnectTimeout: no address accepted before ``until``.
        httpcore2.ConnectError: the last address refused.
    """
    last: Exception = httpcore2.ConnectTimeout("The deadline of the call has passed.")
    for k, place in enumerate(places):
        left = (until - time.monotonic()) / (len(places) - k)
        if left <= 0:
            break
        try:
            return httpcore2.SyncBackend().connect_tcp(place, port, left)
        except (httpcore2.ConnectTimeout, httpcore2.ConnectError) as error:
            last = error
    raise last


class Wire(httpx2.BaseTransport):
    """The connections of one call, including its redirects; close them after the call.

    Args:
        until: deadline of the whole call, in seconds of ``time.monotonic``.
        trust: the certificates that verify servers.
        proxy: the address of a proxy; see ``proxy_for``.
    """

    def __init__(self, until: float, trust: ssl.SSLContext, proxy: str | None = None) -> None:
        self._dialer = Dialer(until)
        self._pool = httpcore2.ConnectionPool(
            ssl_context=trust, max_keepalive_connections=0, network_backend=self._dialer,
            proxy=None if proxy is None else _proxy(proxy, trust),
        )  # fmt: skip

    def handle_request(self, request: httpx2.Request) -> httpx2.Response:
        """Send a request and return the response with its body unread."""
        url = request.url
        sent = httpcore2.Request(
            request.method,
            httpcore2.URL(
                scheme=url.raw_scheme, host=url.raw_host, port=url.port, target=url.raw_path
            ),
            headers=request.headers.raw, content=request.read(), extensions=request.extensions,
        )  # fmt: skip
        with _raise_as_httpx2():
            answer = self._pool.handle_request(sent)
        return httpx2.Response(answer.status, headers=answer.headers, stream=_Body(answer))

    def close(self) -> None:
        """Close all connections."""
        self._pool.close()
        self._dialer.close()


class _Body(httpx2.SyncByteStream):
    """The body of a response, with errors translated to ``httpx2`` errors."""

    def __init__(self, answer: httpcore2.Response) -> None:
        self._answer = answer

    def __iter__(self) -> Iterator[bytes]:
        with _raise_as_httpx2():
            yield from self._answer.iter_stream()

    def close(self) -> None:
        self._answer.close()


def proxy_for(scheme: str, host: str) -> str | None:
    """Return the proxy for a host that the environment sets (in HTTPS_PROXY, for example), or None.

    Raises:
        BackendError: the kind of proxy is not supported, or its address is invalid.
    """
    named = urllib.request.getproxies()
    proxy = named.get(scheme) or named.get("all")
    if not proxy or urllib.request.proxy_bypass(host):
        return None
    proxy = proxy if "://" in proxy else f"http://{proxy}"
    kind = proxy.partition("://")[0].lower()
    if kind not in _PROXIES:
        raise BackendError(
            f"The environment sets a proxy of the unsupported kind {kind[:20]!r}. Use one of "
            f"{', '.join(_PROXIES)}."
        )
    if kind.startswith("socks") and find_spec("socksio") is None:
        raise BackendError(
            "The environment sets a SOCKS proxy, which needs socksio. Run: pip install socksio"
        )
    split_url("http" + proxy[len(kind) :], "The proxy set by the environment", BackendError)
    return proxy


def _proxy(address: str, trust: ssl.SSLContext) -> httpcore2.Proxy:
    kind, _, rest = address.partition("://")
    parts = split_url(f"http://{rest}", "The proxy set by the environment", BackendError)
    named = parts.username is not None
    auth = (unquote(parts.username or ""), unquote(parts.password or "")) if named else None
    kind, host = kind.lower(), (parts.hostname or "").encode()
    usual = {"http": 80, "https": 443}.get(kind, 1080)
    url = httpcore2.URL(scheme=kind.encode(), host=host, port=parts.port or usual, target=b"/")
    return httpcore2.Proxy(url, auth=auth, ssl_context=trust if kind == "https" else None)


@contextlib.contextmanager
def _raise_as_httpx2() -> Iterator[None]:
    """Translate ``httpcore2`` exceptions to the ``httpx2`` exceptions with the same names."""
    try:
        yield
    except (
        httpcore2.TimeoutException,
        httpcore2.NetworkError,
        httpcore2.ProtocolError,
        httpcore2.ProxyError,
        httpcore2.UnsupportedProtocol,
        httpcore2.ConnectionNotAvailable,
    ) as error:
        kind = getattr(httpx2, type(error).__name__, httpx2.TransportError)
        raise kind(str(error)) from error
