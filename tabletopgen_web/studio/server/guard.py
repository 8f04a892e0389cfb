"""Access control for the page at the printed address and for programs with the token.

Raters of a study have a separate token, which gives access only to the study's page and to sending
answers.

Every request must use this server's own host name (which prevents DNS rebinding), and requests that
change something must come from its own page. The headers of every response forbid embedding,
content-type sniffing, caching and referrers.
"""

from __future__ import annotations

import html
import ipaddress
import secrets
from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from urllib.parse import parse_qs, urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import cookie_parser
from starlette.responses import HTMLResponse, JSONResponse, RedirectResponse, Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

HEADERS: Mapping[str, str] = MappingProxyType(
    {
        "content-security-policy": (
            "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self' blob:; "
            "connect-src 'self' blob:; img-src 'self' blob: data:; style-src 'self'; "
            "font-src 'self'; media-src 'self' blob:; base-uri 'none'; form-action 'none'; "
            "frame-ancestors 'none'"
        ),
        "x-content-type-options": "nosniff",
        "referrer-policy": "no-referrer",
        "cache-control": "no-store",
        "cross-origin-opener-policy": "same-origin",
        "cross-origin-embedder-policy": "require-corp",
        "cross-origin-resource-policy": "same-origin",
    }
)
"""Headers of every response; the page of a study has its own content security policy."""

WORKER = "/assets/worker-"
"""Path prefix of the physics worker's script, which has its own content security policy."""

_WORKER_POLICY = (  # MuJoCo's bindings create functions from strings
    "default-src 'none'; script-src 'self' 'unsafe-eval' 'wasm-unsafe-eval'; connect-src 'self'"
)

_SAFE = ("GET", "HEAD")

_STUDY_TITLE = "User study"  # raters must not learn the name of a method


@dataclass(frozen=True)
class Access:
    """The server's address and access token.

    ``studies`` are the tokens of raters by study. ``ticket`` is valid once, because other users of
    this machine can see the command line of a browser, including the address.
    """

    host: str
    port: int
    token: str
    studies: Mapping[str, str] = field(default_factory=dict)
    ticket: str | None = None

    @property
    def address(self) -> str:
        """The server's address on this machine, without the token."""
        known = {"0.0.0.0": "127.0.0.1", "::": "::1"}.get(self.host, self.host)
        host = f"[{known}]" if ":" in known else known
        return f"http://{host}:{self.port}/"

    @property
    def link(self) -> str:
        """The address to open in a browser, including the token."""
        return f"{self.address}?token={self.token}"

    @property
    def ticket_link(self) -> str:
        """The address to pass on the browser's command line, with a ticket that is valid once."""
        return f"{self.address}?ticket={self.ticket}"

    @property
    def cookie(self) -> str:
        """The name of the cookie; browsers share cookies between all ports of a host."""
        return f"tabletopgen-studio-{self.port}"

    def study_link(self, study: str) -> str:
        """Return the address for the raters of a study, including their token."""
        return f"{self.address}study/{study}?token={self.studies[study]}"

    def study_cookie(self, study: str) -> str:
        """Return the name of the cookie of a study's raters."""
        return f"study-{study}-{self.port}"

    def study_asked(self, scope: Scope) -> str | None:
        """Return the study of a rater's request, or None if raters may not make this request."""
        begin, end = ("/study/", "") if scope["method"] in _SAFE else ("/api/studies/", "/answers")
        study = scope["path"].removeprefix(begin).removesuffix(end)
        if scope["method"] not in (*_SAFE, "POST") or scope["path"] != f"{begin}{study}{end}":
            return None
        return study if study in self.studies else None

    @property
    def is_local(self) -> bool:
        """Whether the server is reachable only from this machine."""
        return _is_loopback(self.host)

    def knows(self, token: str, study: str | None = None) -> bool:
        """Return whether a token is valid for the studio, or for the raters of a given study."""
        known = self.token if study is None else self.studies[study]
        return secrets.compare_digest(token.encode("utf-8", "replace"), known.encode())

    def is_own(self, netloc: str) -> bool:
        """Return whether ``host:port`` from a request refers to this server."""
        try:
            parts = urlsplit(f"//{netloc}")
            host, port = (parts.hostname or "").lower(), parts.port or 80
        except ValueError:
            return False
        if port != self.port or parts.netloc != netloc or "@" in netloc or not host:
            return False
        if host == "localhost" or host == self.host.lower() or _is_loopback(host):
            return True
        return not self.is_local and _is_ip(host)


class StudioGuard:
    """A wrapper of the application; see the module docstring."""

    def __init__(self, app: ASGIApp, access: Access) -> None:
        self._app, self._access = app, access
        self._ticket = access.ticket  # None once it is used

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Handle a request, or forward it."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
            return

        async def send_guarded(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                for name, value in HEADERS.items():
                    headers.setdefault(name, value)
                if scope["path"].startswith(WORKER):
                    headers["content-security-policy"] = _WORKER_POLICY
            await send(message)

        if scope["type"] != "http":
            await send({"type": "websocket.close", "code": 1008})
            return
        answer = self._refuse(scope)
        await (self._app if answer is None else answer)(scope, receive, send_guarded)

    def _refuse(self, scope: Scope) -> Response | None:
        """Return the response to a request that is refused or redirected, or None to forward it."""
        headers = Headers(scope=scope)
        hosts = headers.getlist("host")
        if len(hosts) != 1 or not self._access.is_own(hosts[0]):
            return _no("Unknown host name. Open the address printed by the server.")
        origins, safe = headers.getlist("origin"), scope["method"] in _SAFE
        own = len(origins) == 1 and origins[0] == f"http://{hosts[0]}"
        if (origins or not safe) and not own and not (not origins and self._bears(headers)):
            return _no("Only the studio's own page may send this request.")
        study = self._access.study_asked(scope)
        page = safe and (scope["path"] == "/" or scope["path"].startswith("/study/"))
        if page and (scope["path"] == "/" or study is not None):
            query = parse_qs(scope["query_string"].decode("latin-1"))
            if given := query.get("token", []):
                return self._open(given, study)
            if study is None and (given := query.get("ticket", [])):
                return self._open_once(given, headers)
        if self._bears(headers) or self._has_cookie(headers, None):
            return None
        if study is not None and self._has_cookie(headers, study):
            return None
        if page and scope["path"] != "/":
            return _show("Open the complete address that you received.", _STUDY_TITLE)
        words = "Open the address printed by the studio, which includes the token."
        return _show(words) if page else _no(words)

    def _open(self, given: list[str], study: str | None) -> Response:
        """Exchange the token in an address for a cookie."""
        if len(given) != 1 or not self._access.knows(given[0], study):
            if study is not None:
                return _show("This address is incomplete or no longer valid. Ask the sender for a "
                "new address.", _STUDY_TITLE)  # fmt: skip
            return _show(
                "This token does not belong to this studio. Each start of the studio creates a new "
                "token: open the address printed last."
            )
        if study is None:
            answer = RedirectResponse("/", status_code=303)
            name, token, site = self._access.cookie, self._access.token, "strict"
        else:
            answer = RedirectResponse(f"/study/{study}", status_code=303)
            name, token = self._access.study_cookie(study), self._access.studies[study]
            site = "lax"  # strict ones are not sent after links from other pages
        answer.set_cookie(name, token, httponly=True, samesite=site, path="/")
        return answer

    def _open_once(self, given: list[str], headers: Headers) -> Response:
        """Exchange the single-use ticket in an address for a cookie."""
        ticket = (self._ticket or "").encode()
        if ticket and secrets.compare_digest(given[0].encode("utf-8", "replace"), ticket):
            self._ticket = None
            return self._open([self._access.token], None)
        if self._has_cookie(headers, None):
            return RedirectResponse("/", status_code=303)
        return _show("This address can be used only once. Open the address printed by the studio.")

    def _bears(self, headers: Headers) -> bool:
        given = headers.getlist("authorization")
        scheme, _, token = (given[0] if len(given) == 1 else "").partition(" ")
        return scheme.lower() == "bearer" and self._access.knows(token)

    def _has_cookie(self, headers: Headers, study: str | None) -> bool:
        access = self._access
        name = access.cookie if study is None else access.study_cookie(study)
        kept = cookie_parser("; ".join(headers.getlist("cookie")))
        return access.knows(kept.get(name, ""), study)


def _no(message: str) -> Response:
    return JSONResponse({"error": message}, status_code=403)


def _show(message: str, title: str = "TabletopGen studio") -> Response:
    """Return an HTML error page with a title and a message."""
    return HTMLResponse(
        f"<!doctype html><html lang=en><title>{title}</title><h1>{title}</h1>"
        f"<p>{html.escape(message)}</p></html>", status_code=403)  # fmt: skip


def _is_ip(host: str) -> bool:
    try:
        ipaddress.ip_address(host)
    except ValueError:
        return False
    return True


def _is_loopback(host: str) -> bool:
    return host == "localhost" or (_is_ip(host) and ipaddress.ip_address(host).is_loopback)
