"""Addresses of servers: what is one, which are near, and that no password is part of them."""

from __future__ import annotations

import ipaddress
import re
from urllib.parse import urlsplit

from ..errors import BackendError

_USER = re.compile(r"^([a-z]+://)?.*@", re.DOTALL)
_NEAR = (".local", ".lan", ".internal", ".home.arpa")  # names that only a network of one's own has


def checked_address(url: str, what: str, hint: str = "") -> str:
    """Return a server's address without a slash at its end.

    Args:
        url: the address.
        what: begins the message, such as "cloud: the base URL".
        hint: ends it: where to correct the address, or where keys belong.

    Raises:
        BackendError: it is no http(s) address, or holds a user name or a password. Those would be
            in every message, and in what is kept of a scene.
    """
    try:
        parts = urlsplit(url)
        fine = parts.scheme in ("http", "https") and bool(parts.hostname) and parts.port != 0
        named = "@" in parts.netloc
    except ValueError:
        fine = named = False
    hint = f" {hint}" * bool(hint)
    shown = _USER.sub(r"\1[redacted]@", url)
    if named:
        raise BackendError(
            f"{what} {shown!r} holds a user name or a password, which are not sent. Leave them "
            f"out.{hint}"
        )
    if not fine:
        raise BackendError(f"{what} must look like https://host/path, got {shown!r}.{hint}")
    return url.rstrip("/")


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
