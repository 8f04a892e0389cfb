"""Tencent Cloud's request signature, TC3-HMAC-SHA256 (API 3.0, "Signature v3")."""

from __future__ import annotations

import hashlib
import hmac
from collections.abc import Mapping
from datetime import UTC, datetime

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
        key = _keyed(key, word)
    signature = _keyed(key, text).hex()
    return (
        f"{_METHOD} Credential={secret_id}/{scope}, SignedHeaders={_SIGNED}, Signature={signature}"
    )


def signed_headers(
    secret_id: str,
    secret_key: str,
    *,
    host: str,
    action: str,
    version: str,
    region: str,
    body: bytes,
    timestamp: int,
) -> Mapping[str, str]:
    """Return all headers of a signed call."""
    return {
        "Authorization": authorization(
            secret_id, secret_key, host=host, action=action, body=body, timestamp=timestamp
        ),
        "Content-Type": KIND,
        "Host": host,
        "X-TC-Action": action,
        "X-TC-Version": version,
        "X-TC-Region": region,
        "X-TC-Timestamp": str(timestamp),
    }


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def _keyed(key: bytes, text: str) -> bytes:
    return hmac.new(key, text.encode(), hashlib.sha256).digest()
