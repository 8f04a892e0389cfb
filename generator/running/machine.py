"""Which addresses are on this machine: no proxy, no key and no price there."""

from __future__ import annotations

import ipaddress


def local(host: str) -> bool:
    """Return whether a host, as a URL names it, is this machine."""
    if host == "localhost" or host.endswith(".localhost"):
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False
