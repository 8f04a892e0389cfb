"""Validation of server addresses, which must have no password, and detection of local hosts."""

from __future__ import annotations

import ipaddress
import re
from urllib.parse import SplitResult

from ...errors import BackendError, TabletopError
from ...io.bounded import MAX_URL_LENGTH, split_url

_USER = re.compile(r"^([a-z]+://)?.*@", re.DOTALL)
# suffixes of names that exist only in private networks
_NEAR = (".local", ".lan", ".internal", ".home.arpa")


def checked_address(url: str, what: str, hint: str = "") -> str:
    """Return a server's address without a trailing slash.

    ``what`` is the start of error messages ("cloud: the base URL") and ``hint`` the end: where to
    correct the address, or where keys belong.

    Raises:
        BackendError: the address is not http(s), or it contains a user name or a password, which
            would then appear in all messages and in stored scenes.
    """
    try:
        parts = split_url(url, what, BackendError)
        fine, named = _resolvable(url, parts.hostname), "@" in parts.netloc
    except BackendError:
        fine = named = False
    hint = f" {hint}" if hint else ""
    if not isinstance(url, str):
        raise BackendError(f"{what} must be a string, not {type(url).__name__}.{hint}")
    shown = _USER.sub(r"\1[redacted]@", url[:MAX_URL_LENGTH])
    if named:
        raise BackendError(
            f"{what} {shown!r} contains a user name or a password, which are not supported. "
            f"Remove them.{hint}"
        )
    if not fine:
        raise BackendError(f"{what} must have the form https://host/path, got {shown!r}.{hint}")
    return url.rstrip("/")


def check_link(url: object, what: str, error: type[TabletopError]) -> SplitResult:
    """Check and split a file's URL in a server's answer: it must be http(s), without a user name.

    The caller decides whether the host may be contacted. ``what`` is the start of error messages,
    which omit the URL because it may be signed.

    Raises:
        TabletopError: ``error``, if it is not such a URL.
    """
    parts = split_url(url, what, error)
    if "@" in parts.netloc:
        raise error(f"{what} contains a user name or a password.")
    if not _resolvable(str(url), parts.hostname):
        raise error(f"{what} has an invalid host name.")
    return parts


def _resolvable(url: str, host: str | None) -> bool:
    """Return whether the HTTP library accepts an address; True if the library is not installed."""
    try:
        import httpx2
    except ImportError:
        return True
    try:
        found = httpx2.URL(url)
        # the host as displayed and the host as sent
        named = found.raw_host.decode() if found.host else ""
        return named.lower() == host
    except (httpx2.InvalidURL, ValueError):
        return False


def local(host: str) -> bool:
    """Return whether a host name refers to this machine."""
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
    """Return whether a host name refers to this machine or to a private network."""
    try:
        return ipaddress.ip_address(host).is_private
    except ValueError:
        return local(host) or "." not in host or host.endswith(_NEAR)
