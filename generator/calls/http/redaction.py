"""Redaction of secrets, so that keys never reach messages, logs or files."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Iterable
from urllib.parse import parse_qsl, quote, urlencode, urlunsplit

from ...errors import BackendError
from ...io.bounded import split_url

REDACTED = "[redacted]"

_SHORT = 8  # characters: keys are longer; placeholders such as "EMPTY" may be shorter

_READ = 2**16  # bytes of a response that are searched for an excerpt
_CUT = 256  # bytes at its end that may be part of a truncated key
_WIDER = 6  # maximum growth of a key by escaping, as a factor

_NOTHING = re.compile(r"(?!)")
_SHAPES = (
    re.compile(r"(?i)(?<=\bbearer )[^\s\"',;]+"),
    re.compile(r"(?i)(?<=\bbasic )[A-Za-z0-9+/=_-]{8,}"),
    # as long as a key, because models have names such as "xai-grok-4-fast"
    re.compile(r"\b(?:sk|pk|rk)[-_](?=[A-Za-z*._-]{0,200}[0-9*])[A-Za-z0-9*._-]{16,}"),
    re.compile(r"\b(?:hf_|r8_|gsk_|xai-)[A-Za-z0-9*]{30,}"),
    re.compile(r"\bAKID[A-Za-z0-9]{12,}"),
    re.compile(r"(?i)(?<=signature=)[^\s&\"',;]+"),
)
_SIGNED = re.compile(
    r"(?i)^(?:x-(?:amz|goog|tos|oss|cos)-|q-(?:ak|sign|key|header|url)|(?:signature|sig|expires)$"
    r"|(?:oss|aws)accesskeyid$|googleaccessid$)"
)
"""Query parameters that only sign a link and do not identify its target."""


def redact(text: str, secrets: Iterable[str] = ()) -> str:
    """Return ``text`` without the given secrets and without strings that look like keys.

    Secrets are detected verbatim, URL-quoted, JSON-escaped, and in base64. Those of fewer than 8
    characters are removed only as whole words, since they would garble other text.
    """
    for secret in sorted(set(secrets), key=len, reverse=True):
        text = _pattern_of(secret).sub(REDACTED, text)
    for shape in _SHAPES:
        text = shape.sub(REDACTED, text)
    return text


def excerpt(said: bytes | str, most: int, secrets: Iterable[str] = ()) -> str:
    """Return the first ``most`` characters of a server's response, without secrets.

    Terminal control characters are replaced. At most 64 KiB of the response are examined.
    """
    secrets = tuple(secrets)
    text = said[:_READ] if isinstance(said, str) else said[:_READ].decode("utf-8", "replace")
    if len(said) > _READ:  # a truncated key could no longer be detected
        text = text[: -(_CUT + _WIDER * max(map(len, secrets), default=0))]
    text = redact(text, secrets)[:most]
    return "".join(c if c.isprintable() or c in "\n\r\t" else "?" for c in text)


def holds(text: str, secrets: Iterable[str]) -> bool:
    """Return whether a text contains one of the secrets, in any form that ``redact`` detects."""
    return any(_pattern_of(secret).search(text) for secret in secrets)


def plain_url(url: str) -> str:
    """Return ``url`` without its user, fragment and signing parameters.

    Links to one file that were signed at different times become equal.

    Raises:
        BackendError: it is not an http(s) URL.
    """
    parts = split_url(url, "The address of a call", BackendError)
    asked = parse_qsl(parts.query, keep_blank_values=True)
    kept = urlencode([(name, value) for name, value in asked if not _SIGNED.search(name)])
    return urlunsplit((parts.scheme, parts.netloc.rpartition("@")[2], parts.path, kept, ""))


def _pattern_of(secret: str) -> re.Pattern[str]:
    """Return a pattern that matches all forms of a secret."""
    if not secret.strip():
        return _NOTHING
    encoded = base64.b64encode(secret.encode()).decode()
    forms = (secret, quote(secret, safe=""), json.dumps(secret)[1:-1], encoded)
    # longest first, so that no remainder of a longer form is left
    found = "|".join(re.escape(form) for form in sorted(set(forms), key=len, reverse=True))
    return re.compile(rf"(?<!\w)(?:{found})(?!\w)" if len(secret) < _SHORT else found)
