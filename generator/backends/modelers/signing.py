"""Tencent Cloud's request signature, TC3-HMAC-SHA256 (API 3.0, "Signature v3")."""

from __future__ import annotations

import hashlib
import hmac
import time
from collections.abc import Mapping
from datetime import UTC, datetime
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import httpx2

KIND = "application/json; charset=utf-8"
"""Content type of a signed body."""

_SIGNED = "content-type;host;x-tc-action"
_METHOD = "TC3-HMAC-SHA256"


def authorization(
    secret_id: str, secret_key: str, *, host: str, action: str, body: bytes, timestamp: int
) -> str:
    """Return the Authorization header of a POST to the root of ``host``.

    The service is the host's first word. ``timestamp`` is in seconds of Unix time; the server
    takes it for five minutes.
    """
    service = host.partition(".")[0]
    day = datetime.fromtimestamp(timestamp, UTC).strftime("%Y-%m-%d")
    scope = f"{day}/{service}/tc3_request"
    headers = f"content-type:{KIND}\nhost:{host}\nx-tc-action:{action.lower()}\n"
    request = "\n".join(["POST", "/", "", headers, _SIGNED, _digest(body)])
    text = "\n".join([_METHOD, str(timestamp), scope, _digest(request.encode())])
    key = f"TC3{secret_key}".encode()
    for word in (day, service, "tc3_request"):
        key = _hmac(key, word)
    signature = _hmac(key, text).hex()
    return (
        f"{_METHOD} Credential={secret_id}/{scope}, SignedHeaders={_SIGNED}, Signature={signature}"
    )


def signature(request: httpx2.Request, secret_id: str, secret_key: str) -> Mapping[str, str]:
    """Return the headers that sign a request, which names host and action in its own, as of now."""
    timestamp = int(time.time())
    host, action = request.headers["host"], request.headers["x-tc-action"]
    signed = authorization(
        secret_id, secret_key, host=host, action=action, body=request.read(), timestamp=timestamp
    )
    return {"Authorization": signed, "X-TC-Timestamp": str(timestamp)}


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def _hmac(key: bytes, text: str) -> bytes:
    return hmac.new(key, text.encode(), hashlib.sha256).digest()
