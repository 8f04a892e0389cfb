"""Connections on which every wait ends by a deadline: names, TCP, TLS, proxies, reads, writes.

The time limits of an HTTP library hold for one read each, so that a server which sends a byte now
and then is waited for without end. Here all of a call shares one ``Pace``.
"""

from __future__ import annotations

import contextlib
import socket
import ssl
import time
import urllib.request
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Any
from urllib.parse import unquote

import httpcore2
import httpx2

from ...errors import BackendError
from ...io.reading import split_url
from .flight import Flight

MOST_HEAD = 256 * 2**10
"""Bytes that may come before the body of an answer: headers, hints and what proxies say."""

_FRAMES = 4  # times its size that a body may take on the wire, and a head's worth: chunks, records
_PIECE = 2**16
_PROXIES = ("http", "https", "socks5", "socks5h")


@dataclass
class Pace:
    """What a call has left: seconds until ``until``, by ``time.monotonic``, and bytes to read."""

    until: float
    bytes: int = MOST_HEAD

    def left(self, most: float | None, late: type[Exception]) -> float:
        """Return the seconds that a wait may take, at most ``most``; raises ``late`` if none."""
        left = self.until - time.monotonic()
        if left <= 0:
            raise late("The time of the call is over.")
        return left if most is None else min(left, most)

    def read(self, count: int) -> None:
        """Hear that so many bytes came.

        Raises:
            httpcore2.ReadError: there were to be fewer.
        """
        self.bytes -= count
        if self.bytes < 0:
            raise httpcore2.ReadError("more came than an answer has")


class _Stream(httpcore2.NetworkStream):
    """A connection that can be encrypted: once, or again behind a proxy that speaks TLS itself."""

    def start_tls(
        self,
        ssl_context: ssl.SSLContext,
        server_hostname: str | None = None,
        timeout: float | None = None,
    ) -> httpcore2.NetworkStream:
        """Return the connection encrypted."""
        return _secured(self, ssl_context, server_hostname, timeout)


class Line(_Stream):
    """A TCP connection that keeps to a pace."""

    def __init__(self, sock: socket.socket, pace: Pace) -> None:
        self._sock, self._pace = sock, pace

    def read(self, max_bytes: int, timeout: float | None = None) -> bytes:
        """Return what comes next; b"" at the end."""
        self._sock.settimeout(self._pace.left(timeout, httpcore2.ReadTimeout))
        with _told(httpcore2.ReadTimeout, httpcore2.ReadError):
            data = self._sock.recv(max_bytes)
        self._pace.read(len(data))
        return data

    def write(self, buffer: bytes, timeout: float | None = None) -> None:
        """Send all of it."""
        view = memoryview(buffer)
        while view:
            self._sock.settimeout(self._pace.left(timeout, httpcore2.WriteTimeout))
            with _told(httpcore2.WriteTimeout, httpcore2.WriteError):
                view = view[self._sock.send(view) :]

    def close(self) -> None:
        """Hang up."""
        self._sock.close()

    def get_extra_info(self, info: str) -> Any:
        """Return what ``httpcore2`` asks of a connection."""
        return self._sock if info == "socket" else None


class Secured(_Stream):
    """TLS over another connection, whose pace it keeps to in each round of its handshake."""

    def __init__(
        self, under: httpcore2.NetworkStream, context: ssl.SSLContext, host: str | None
    ) -> None:
        self._under = under
        self._incoming, self._outgoing = ssl.MemoryBIO(), ssl.MemoryBIO()
        self._tls = context.wrap_bio(self._incoming, self._outgoing, server_hostname=host)

    def shake_hands(self, timeout: float | None) -> None:
        """Agree on keys."""
        with _told(httpcore2.ConnectTimeout, httpcore2.ConnectError):
            self._do(self._tls.do_handshake, timeout)

    def read(self, max_bytes: int, timeout: float | None = None) -> bytes:
        """Return what comes next; b"" at the end."""
        with _told(httpcore2.ReadTimeout, httpcore2.ReadError):
            try:
                return self._do(lambda: self._tls.read(max_bytes), timeout)
            except (ssl.SSLZeroReturnError, ssl.SSLEOFError):
                return b""

    def write(self, buffer: bytes, timeout: float | None = None) -> None:
        """Send all of it."""
        view = memoryview(buffer)
        with _told(httpcore2.WriteTimeout, httpcore2.WriteError):
            while view:
                piece = view[:_PIECE]
                view = view[self._do(lambda piece=piece: self._tls.write(piece), timeout) :]

    def _do(self, step: Callable[[], Any], timeout: float | None) -> Any:
        """Do a step of TLS, with as much to and fro as it needs."""
        while True:
            try:
                done, result = True, step()
            except ssl.SSLWantReadError:
                done, result = False, None
            finally:  # an alert, too, if it failed
                if self._outgoing.pending:
                    self._under.write(self._outgoing.read(), timeout)
            if done:
                return result
            data = self._under.read(_PIECE, timeout)
            if data:
                self._incoming.write(data)
            else:
                self._incoming.write_eof()

    def close(self) -> None:
        """Hang up."""
        self._under.close()

    def get_extra_info(self, info: str) -> Any:
        """Return what ``httpcore2`` asks of a connection."""
        return self._tls if info == "ssl_object" else self._under.get_extra_info(info)


class Dialer(httpcore2.NetworkBackend):
    """Makes connections that keep to a pace."""

    def __init__(self, pace: Pace) -> None:
        self._pace = pace

    def connect_tcp(
        self,
        host: str,
        port: int,
        timeout: float | None = None,
        local_address: str | None = None,
        socket_options: Iterable[Any] | None = None,
    ) -> httpcore2.NetworkStream:
        """Return a connection to the first of a host's addresses that takes it."""
        until = time.monotonic() + self._pace.left(timeout, httpcore2.ConnectTimeout)
        found = Flight(lambda: socket.getaddrinfo(host, port, type=socket.SOCK_STREAM))
        if not found.landed(until - time.monotonic()):
            raise httpcore2.ConnectTimeout("The address of the host was not found in time.")
        with _told(httpcore2.ConnectTimeout, httpcore2.ConnectError):
            return Line(_connected(found.result(), until), self._pace)

    def connect_unix_socket(
        self, path: str, timeout: float | None = None, socket_options: Iterable[Any] | None = None
    ) -> httpcore2.NetworkStream:
        """Refuse: servers are asked over the network."""
        raise httpcore2.ConnectError("Sockets in files are not spoken to.")


class Wire(httpx2.BaseTransport):
    """The connections of one call, redirects included, to be closed after it."""

    def __init__(
        self, until: float, most_bytes: int, trust: ssl.SSLContext, proxy: str | None = None
    ) -> None:
        """Connect as soon as something is sent.

        Args:
            until: when all of it must be over, by ``time.monotonic``.
            most_bytes: what an answer may have.
            trust: the certificates that servers are held against.
            proxy: the address of a proxy; see ``proxy_for``.
        """
        self._pace = Pace(until)
        self._most = _FRAMES * most_bytes
        self._pool = httpcore2.ConnectionPool(
            ssl_context=trust, max_keepalive_connections=0, network_backend=Dialer(self._pace),
            proxy=None if proxy is None else _proxy(proxy, trust),
        )  # fmt: skip

    def handle_request(self, request: httpx2.Request) -> httpx2.Response:
        """Send a request; the answer's body is still to be read."""
        url = request.url
        sent = httpcore2.Request(
            request.method,
            httpcore2.URL(
                scheme=url.raw_scheme, host=url.raw_host, port=url.port, target=url.raw_path
            ),
            headers=request.headers.raw, content=request.read(), extensions=request.extensions,
        )  # fmt: skip
        self._pace.bytes = MOST_HEAD
        with _translated():
            answer = self._pool.handle_request(sent)
        self._pace.bytes += self._most
        return httpx2.Response(answer.status, headers=answer.headers, stream=_Body(answer))

    def close(self) -> None:
        """Hang up."""
        self._pool.close()


class _Body(httpx2.SyncByteStream):
    """The body of an answer, its errors those of ``httpx2``."""

    def __init__(self, answer: httpcore2.Response) -> None:
        self._answer = answer

    def __iter__(self) -> Iterator[bytes]:
        with _translated():
            yield from self._answer.iter_stream()

    def close(self) -> None:
        self._answer.close()


def proxy_for(scheme: str, host: str) -> str | None:
    """Return the proxy that the environment names for a host (HTTPS_PROXY and its like), or None.

    Raises:
        BackendError: it is of a kind that is not spoken, or its address is none.
    """
    named = urllib.request.getproxies()
    proxy = named.get(scheme) or named.get("all")
    if not proxy or urllib.request.proxy_bypass(host):
        return None
    proxy = proxy if "://" in proxy else f"http://{proxy}"
    kind = proxy.partition("://")[0].lower()
    if kind not in _PROXIES:
        raise BackendError(
            f"The environment names a proxy of the kind {kind[:20]!r}. Name one of "
            f"{', '.join(_PROXIES)}."
        )
    if kind.startswith("socks") and find_spec("socksio") is None:
        raise BackendError(
            "The environment names a SOCKS proxy, which needs socksio. Run: pip install socksio"
        )
    split_url("http" + proxy[len(kind) :], "The proxy that the environment names", BackendError)
    return proxy


def _proxy(address: str, trust: ssl.SSLContext) -> httpcore2.Proxy:
    kind, _, rest = address.partition("://")
    parts = split_url(f"http://{rest}", "The proxy that the environment names", BackendError)
    auth = None
    if parts.username is not None:
        auth = unquote(parts.username), unquote(parts.password or "")
    kind, host = kind.lower(), (parts.hostname or "").encode()
    usual = {"http": 80, "https": 443}.get(kind, 1080)
    url = httpcore2.URL(scheme=kind.encode(), host=host, port=parts.port or usual, target=b"/")
    return httpcore2.Proxy(url, auth=auth, ssl_context=trust if kind == "https" else None)


def _secured(
    under: httpcore2.NetworkStream,
    context: ssl.SSLContext,
    host: str | None,
    timeout: float | None,
) -> Secured:
    try:
        with _told(httpcore2.ConnectTimeout, httpcore2.ConnectError):
            line = Secured(under, context, host)
        line.shake_hands(timeout)
    except BaseException:
        under.close()
        raise
    return line


def _connected(places: list[Any], until: float) -> socket.socket:
    """Return a socket that is connected to the first of some addresses that takes it."""
    last: OSError = TimeoutError("no address")
    for k, (family, kind, protocol, _, place) in enumerate(places):
        # One that takes no call leaves the others time to.
        left = (until - time.monotonic()) / (len(places) - k)
        if left <= 0:
            break
        sock = socket.socket(family, kind, protocol)
        try:
            sock.settimeout(left)
            sock.connect(place)
            sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        except OSError as error:
            sock.close()
            last = error
        else:
            return sock
    raise last


@contextlib.contextmanager
def _told(late: type[Exception], other: type[Exception]) -> Iterator[None]:
    """Raise what sockets and TLS raise as errors of ``httpcore2``."""
    try:
        yield
    except httpcore2.TimeoutException as error:  # of the connection that lies under this one
        raise late(str(error)) from error
    except TimeoutError as error:
        raise late("The time of the call is over.") from error
    except (OSError, ValueError, httpcore2.NetworkError) as error:  # ValueError: no such host name
        raise other(str(error)) from error


@contextlib.contextmanager
def _translated() -> Iterator[None]:
    """Raise errors of ``httpcore2`` as those of the same name of ``httpx2``."""
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
