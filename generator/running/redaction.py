"""Secrets out of texts: keys never reach a message, a log, a file."""

from __future__ import annotations

import base64
import re
from collections.abc import Iterable
from urllib.parse import parse_qsl, quote, urlencode, urlsplit, urlunsplit

REDACTED = "[redacted]"

_SHAPES = (
    re.compile(r"(?i)(?<=\bbearer )[^\s\"',;]+"),
    re.compile(r"(?i)(?<=\bbasic )[A-Za-z0-9+/=_-]{8,}"),
    re.compile(r"\b(?:sk|pk|hf|r8|gsk|xai|rk)[-_][A-Za-z0-9*._-]{8,}"),
    re.compile(r"\bAKID[A-Za-z0-9]{12,}"),
    re.compile(r"(?i)(?<=signature=)[^\s&\"',;]+"),
)
_SECRET = re.compile(
    r"(?i)^(?:.*[-_])?(?:key|apikey|token|secret|signature|sig|credential|password|expires)$"
    r"|^q-|^x-amz-|^x-goog-|^x-tos-|^ossaccesskeyid$|^awsaccesskeyid$"
)


def redacted(text: str, secrets: Iterable[str] = ()) -> str:
    """Return ``text`` without the secrets given, and without what is shaped like a key.

    A secret is found as it is, quoted for a URL, escaped in JSON, or in base64 by itself.
    """
    for secret in sorted({s for s in secrets if s.strip()}, key=len, reverse=True):
        encoded = base64.b64encode(secret.encode()).decode()
        escaped = secret.replace("\\", "\\\\").replace('"', '\\"')
        for form in (secret, quote(secret, safe=""), escaped, encoded):
            text = text.replace(form, REDACTED)
    for shape in _SHAPES:
        text = shape.sub(REDACTED, text)
    return text


def plain_url(url: str) -> str:
    """Return ``url`` without user, fragment, and parameters that are signatures, keys or dates.

    Links to one file that were signed at different times become the same.
    """
    parts = urlsplit(url)
    asked = [(k, v) for k, v in parse_qsl(parts.query, keep_blank_values=True)]
    kept = urlencode([(k, v) for k, v in asked if not _SECRET.search(k)])
    return urlunsplit((parts.scheme, parts.netloc.rpartition("@")[2], parts.path, kept, ""))
