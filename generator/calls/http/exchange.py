"""One attempt at a call: send a request and read its response, limited in size and time."""

from __future__ import annotations

import time
import zlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import httpx2

from ...errors import UnusableError
from ...io.bounded import parse_json
from .redaction import excerpt

MOST_REDIRECTS = 3

_AGAIN = frozenset({408, 425, 429, 500, 502, 503, 504, 520, 521, 522, 523, 524, 529})
# the gateway timed out; the server behind it may still work on the call
_LATE = frozenset({504, 524})
_CHARGED = _LATE | {502, 520}  # likewise if the response of the server behind it broke off
_EXCERPT = 300  # maximum characters of a response quoted in a message
_PIECE = 2**18  # bytes decompressed at a time

COMPRESSIONS = "gzip, deflate"
"""Accepted compressions of a response, as the Accept-Encoding header lists them."""


@dataclass(frozen=True)
class Reply:
    """A complete response; ``payload`` is its parsed JSON, or None if it is not JSON."""

    status: int
    content_type: str
    body: bytes
    payload: Any = None
    wait: str | None = None

    @property
    def good(self) -> bool:
        """Whether the status is 2xx."""
        return 200 <= self.status < 300


@dataclass(frozen=True)
class Trouble:
    """The reason for a failed attempt, as a sentence.

    ``again``: a retry may succeed. ``charged``: the attempt may have been billed. ``alive``: the
    server works, or states when it will. ``late``: the attempt timed out. ``wait``: the Retry-After
    header. ``unusable``: the server returned an unusable response.
    """

    reason: str
    again: bool
    charged: bool = False
    alive: bool = False
    late: bool = False
    wait: str | None = None
    unusable: bool = False


def exchange(
    dial: Callable[[float], httpx2.BaseTransport],
    request: httpx2.Request,
    timeout: float,
    most_bytes: int,
    secrets: tuple[str, ...] = (),
) -> Reply | Trouble:
    """Send a request once and read its response; quotes of the response omit ``secrets``.

    ``dial`` opens the connections of one call, given its deadline in seconds of ``time.monotonic``.
    The call, including redirects and the body, ends within ``timeout`` seconds. Server and network
    failures raise nothing, because exceptions of the library contain the request and therefore the
    key.
    """
    until = time.monotonic() + timeout
    paid = request.method not in ("GET", "HEAD")
    try:
        with dial(until) as wire:
            reply = _read(wire, request, until, most_bytes)
    except (httpx2.ConnectTimeout, httpx2.PoolTimeout, httpx2.ConnectError, httpx2.ProxyError) as e:
        late = time.monotonic() >= until  # the connection was shut down at the deadline
        if late or not isinstance(e, httpx2.ConnectError | httpx2.ProxyError):
            connect = request.extensions["timeout"]["connect"]
            message = f"The server did not accept the connection within {connect:g} s."
            return Trouble(message, again=True)
        again = "certificate" not in str(e).lower()
        return Trouble(f"The server cannot be reached ({e}).", again=again)
    except (httpx2.TransportError, zlib.error, _TooSlow) as error:
        if isinstance(error, _TooSlow | httpx2.TimeoutException) or time.monotonic() >= until:
            message = f"The server did not respond within {timeout:g} s."
            return Trouble(message, again=True, charged=paid, late=True)
        if isinstance(error, httpx2.UnsupportedProtocol | httpx2.LocalProtocolError):
            return Trouble(f"The request cannot be sent ({error}).", again=False)
        cause = str(error)[:_EXCERPT] or type(error).__name__
        message = f"The server's response ended early ({cause})."
        return Trouble(message, again=True, charged=paid)
    return reply if isinstance(reply, Trouble) else _judge(reply, paid, secrets)


class _TooSlow(Exception):
    """The whole response took too long, although each piece arrived in time."""


def _read(
    wire: httpx2.BaseTransport, request: httpx2.Request, until: float, most_bytes: int
) -> Reply | Trouble:
    for _ in range(MOST_REDIRECTS + 1):
        response = wire.handle_request(request)
        try:
            if not response.has_redirect_location:
                return _body(response, until, most_bytes)
            target = _target(request.url, response.headers["location"])
        finally:
            response.close()
        if isinstance(target, Trouble):
            return target
        if request.method not in ("GET", "HEAD") and response.status_code not in (307, 308):
            return Trouble(
                f"The server redirects a {request.method} with status {response.status_code}, "
                "which would drop the request's body. Check the address.",
                again=False,
            )
        request = httpx2.Request(
            request.method, target, headers=request.headers, content=request.content,
            extensions=request.extensions,
        )  # fmt: skip
    return Trouble(f"The server redirected more than {MOST_REDIRECTS} times.", again=False)


def _target(url: httpx2.URL, location: str) -> httpx2.URL | Trouble:
    """Return the target of a redirect, or the reason not to follow it."""
    try:
        target = url.join(location)
        origin, where = _origin(target), f"{target.scheme}://{target.netloc.decode()}"
        bare = not target.userinfo
    except (httpx2.InvalidURL, ValueError):
        return Trouble("The server redirects to an invalid address.", again=False)
    if origin != _origin(url):
        return Trouble(
            f"The server redirects to another server, {where[:_EXCERPT]}. The redirect was not "
            "followed, because that server would receive the key. If it is the intended server, "
            "configure its address.",
            again=False,
        )
    if not bare:
        return Trouble("The server redirects to an address that contains a user name.", again=False)
    return target


def _body(response: httpx2.Response, until: float, most_bytes: int) -> Reply | Trouble:
    """Read a response piece by piece, up to ``most_bytes`` bytes."""
    encoding = response.headers.get("content-encoding", "").strip().lower()
    if encoding not in ("", "identity", "gzip", "x-gzip", "deflate"):
        message = (
            f"The server's response uses the compression {encoding[:40]!r}, which was not "
            "requested."
        )
        return Trouble(message, again=False, charged=response.is_success, alive=True, unusable=True)
    pieces, size = [], 0
    length = response.headers.get("content-length", "")
    if not (length.isdecimal() and (len(length) > 18 or int(length) > most_bytes)):
        for piece in _decompress(response.iter_raw(_PIECE), encoding):
            size += len(piece)
            pieces.append(piece)
            if size > most_bytes:
                break
            if time.monotonic() > until:
                raise _TooSlow
        else:
            kind = response.headers.get("content-type", "")
            wait = response.headers.get("retry-after")
            return Reply(response.status_code, kind, b"".join(pieces), wait=wait)
    message = f"The server's response exceeds the limit of {most_bytes} bytes."
    return Trouble(message, again=False, charged=response.is_success, alive=True, unusable=True)


def _decompress(raw: Iterator[bytes], encoding: str) -> Iterator[bytes]:
    """Yield the decompressed body in pieces of at most ``_PIECE`` bytes."""
    if encoding in ("", "identity"):
        yield from raw
        return
    decompressor = None
    for piece in raw:
        if decompressor is None:  # servers send "deflate" both with and without a header
            bare = encoding == "deflate" and piece[:1] and piece[0] & 15 != 8
            decompressor = zlib.decompressobj(-zlib.MAX_WBITS if bare else zlib.MAX_WBITS | 32)
        while piece and not decompressor.eof:
            yield decompressor.decompress(piece, _PIECE)
            piece = decompressor.unconsumed_tail
    if decompressor is not None:
        yield decompressor.flush()
        if not decompressor.eof:
            raise zlib.error("the compressed body is truncated")


def _judge(reply: Reply, paid: bool, secrets: tuple[str, ...]) -> Reply | Trouble:
    """Return the response with its JSON parsed, or the reason why it is unusable."""
    status, again = reply.status, reply.status in _AGAIN
    head = reply.body[:_EXCERPT].lstrip().lower()
    if "text/html" in reply.content_type or head.startswith((b"<!doctype html", b"<html")):
        message = (
            f"The server returned an HTML page (status {status}) instead of JSON or a file: "
            f"{_excerpt(reply.body, secrets)}. Check the address; a proxy or a web site may "
            "have responded."
        )
        trouble = _trouble(reply, status, paid, secrets)
        alive = trouble.alive or not again
        return replace(trouble, reason=message, alive=alive, unusable=not again)
    payload = None
    if "json" in reply.content_type and reply.body:
        try:
            payload = parse_json(reply.body, "It", UnusableError)
        except UnusableError:
            if reply.good:
                shown = _excerpt(reply.body, secrets)
                message = f"The server's response is not valid JSON: {shown}."
                return Trouble(message, again=True, charged=paid)
    passed_on = _code(payload) if reply.good else None
    if passed_on in _AGAIN:
        message = (
            f"The server returned an upstream error with code {passed_on}: "
            f"{_excerpt(reply.body, secrets)}."
        )
        return replace(_trouble(reply, passed_on, paid, secrets), reason=message)
    if again or status >= 500 or status < 200:
        spent = status == 429 and b"insufficient_quota" in reply.body
        trouble = _trouble(reply, status, paid, secrets)
        return replace(trouble, again=again and not spent)
    return Reply(status, reply.content_type, reply.body, payload)


def _trouble(reply: Reply, status: int, paid: bool, secrets: tuple[str, ...]) -> Trouble:
    """Return the failure that a response with an error status reports."""
    return Trouble(
        f"The server returned status {status}: {_excerpt(reply.body, secrets)}.",
        again=status in _AGAIN, charged=paid and status in _CHARGED, late=status in _LATE,
        alive=status == 429 or (status == 503 and reply.wait is not None), wait=reply.wait,
    )  # fmt: skip


def _code(payload: Any) -> int | None:
    """Return the status of an upstream error that a router reports in a response, or None."""
    error = payload.get("error") if isinstance(payload, dict) else None
    code = str(error.get("code")) if isinstance(error, dict) else ""
    return int(code) if code.isdecimal() and len(code) <= 3 else None


def _excerpt(body: bytes, secrets: tuple[str, ...]) -> str:
    """Return the start of a response, in quotes."""
    text = " ".join(excerpt(body, _EXCERPT, secrets).split())
    return repr(text) if text else "nothing"


def _origin(url: httpx2.URL) -> tuple[str, str, int | None]:
    return url.scheme, url.host, url.port
