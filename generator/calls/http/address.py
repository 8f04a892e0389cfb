"""Addresses of servers: what is one, which are near, and that no password is part of them."""

from __future__ import annotations

import ipaddress
import re
from urllib.parse import SplitResult

from ...errors import BackendError, TabletopError
from ...io.bounded import MAX_URL_LENGTH, split_url

_USER = re.compile(r"^([a-z]+://)?.*@", re.DOTALL)
_NEAR = (".local", ".lan", ".internal", ".home.arpa")  # names that only a network of one's own has


def checked_address(url: str, what: str, hint: str = "") -> str:
    """Return a server's address without a slash at its end.

    ``what`` begins the message of an error ("cloud: the base URL"), ``hint`` ends it: where to
    correct the address, or where keys belong.

    Raises:
        BackendError: it is no http(s) address, or holds a user name or a password, which would be
            in every message, and in what is kept of a scene.
    """
    try:
        parts = split_url(url, what, BackendError)
        fine, named = _resolvable(url, parts.hostname), "@" in parts.netloc
    except BackendError:
        fine = named = False
    hint = f" {hint}" if hint else ""
    if not isinstance(url, str):
        raise BackendError(f"{what} must be a text, not {type(url).__name__}.{hint}")
    shown = _USER.sub(r"\1[redacted]@", url[:MAX_URL_LENGTH])
    if named:
        raise BackendError(
            f"{what} {shown!r} holds a user name or a password, which are not sent. Leave them "
            f"out.{hint}"
        )
    if not fine:
        raise BackendError(f"{what} must look like https://host/path, got {shown!r}.{hint}")
    return url.rstrip("/")


def check_link(url: object, what: str, error: type[TabletopError]) -> SplitResult:
    """Check and split the address of a file that a server's answer names: http(s), without a user.

    Whether the host may be asked is for the caller to say. ``what`` begins the message, which does
    not repeat the address: it may be signed.

    Raises:
        TabletopError: ``error``, if it is not such an address.
    """
    parts = split_url(url, what, error)
    if "@" in parts.netloc:
        raise error(f"{what} holds a user name or a password.")
    if not _resolvable(str(url), parts.hostname):
        raise error(f"{what} has a host that is no name.")
    return parts


def _resolvable(url: str, host: str | None) -> bool:
    """Return whether the HTTP library, where it is installed, takes an address as one."""
    try:
        import httpx2
    except ImportError:
        return True
    try:
        found = httpx2.URL(url)
        named = found.raw_host.decode() if found.host else ""  # the one it shows, one that is sent
        return named.lower() == host
    except (httpx2.InvalidURL, ValueError):
        return False


def local(host: str) -> bool:
    """Return whether a host is this machine."""
    name = host.removesuffix(".")
    if name == "localhost" or name.endswith(".localhost"):
        return True
    try:
        found = ipaddress.ip_address(host)
    except ValueError:
        return False
    found = getattr(found, "ipv4_mapped", None) or found
    return found.is_loopback or found.is_unspecified


def near(host: str) -> bool:
    """Return whether a host is this machine, or in a private network as far as its name tells."""
    try:
        return ipaddress.ip_address(host).is_private
    except ValueError:
        return local(host) or "." not in host or host.endswith(_NEAR)
