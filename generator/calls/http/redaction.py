"""Secrets out of texts: keys never reach a message, a log, a file."""

from __future__ import annotations

import base64
import json
import re
from collections.abc import Iterable
from urllib.parse import parse_qsl, quote, urlencode, urlunsplit

from ...errors import BackendError
from ...io.bounded import split_url

REDACTED = "[redacted]"

_SHORT = 8  # characters: a key has more, a word in its place ("EMPTY") need not

_READ = 2**16  # bytes of an answer that are looked through for what of it is shown
_CUT = 256  # of them at its end may be part of a key that is cut in two
_WIDER = 6  # times its length that a key may have where it is escaped

_NOTHING = re.compile(r"(?!)")
_SHAPES = (
    re.compile(r"(?i)(?<=\bbearer )[^\s\"',;]+"),
    re.compile(r"(?i)(?<=\bbasic )[A-Za-z0-9+/=_-]{8,}"),
    # as long as keys are, for models have names like "xai-grok-4-fast"
    re.compile(r"\b(?:sk|pk|rk)[-_](?=[A-Za-z*._-]{0,200}[0-9*])[A-Za-z0-9*._-]{16,}"),
    re.compile(r"\b(?:hf_|r8_|gsk_|xai-)[A-Za-z0-9*]{30,}"),
    re.compile(r"\bAKID[A-Za-z0-9]{12,}"),
    re.compile(r"(?i)(?<=signature=)[^\s&\"',;]+"),
)
_SIGNED = re.compile(
    r"(?i)^(?:x-(?:amz|goog|tos|oss|cos)-|q-(?:ak|sign|key|header|url)|(?:signature|sig|expires)$"
    r"|(?:oss|aws)accesskeyid$|googleaccessid$)"
)
"""Parameters of signed links: how they are signed, not what they lead to."""


def redact(text: str, secrets: Iterable[str] = ()) -> str:
    """Return ``text`` without the secrets given, and without what is shaped like a key.

    A secret is found as it is, quoted for a URL, escaped in JSON, or in base64 by itself; one of
    fewer than 8 characters only where it is a word by itself, or it would garble others.
    """
    for secret in sorted(set(secrets), key=len, reverse=True):
        text = _pattern_of(secret).sub(REDACTED, text)
    for shape in _SHAPES:
        text = shape.sub(REDACTED, text)
    return text


def excerpt(said: bytes | str, most: int, secrets: Iterable[str] = ()) -> str:
    """Return how a server's words begin: at most ``most`` characters, without secrets.

    Terminal controls are replaced. However long it is, no more than 64 KiB are looked at.
    """
    secrets = tuple(secrets)
    text = said[:_READ] if isinstance(said, str) else said[:_READ].decode("utf-8", "replace")
    if len(said) > _READ:  # a key that is cut in two could not be found any more
        text = text[: -(_CUT + _WIDER * max(map(len, secrets), default=0))]
    text = redact(text, secrets)[:most]
    return "".join(c if c.isprintable() or c in "\n\r\t" else "?" for c in text)


def holds(text: str, secrets: Iterable[str]) -> bool:
    """Return whether a text holds one of the secrets, in any of the forms that are redacted."""
    return any(_pattern_of(secret).search(text) for secret in secrets)


def plain_url(url: str) -> str:
    """Return ``url`` without user, fragment, and the parameters that sign it.

    Links to one file that were signed at different times become the same.

    Raises:
        BackendError: it is no http(s) URL.
    """
    parts = split_url(url, "The address of a call", BackendError)
    asked = parse_qsl(parts.query, keep_blank_values=True)
    kept = urlencode([(name, value) for name, value in asked if not _SIGNED.search(name)])
    return urlunsplit((parts.scheme, parts.netloc.rpartition("@")[2], parts.path, kept, ""))


def _pattern_of(secret: str) -> re.Pattern[str]:
    """Return what finds a secret in each of its forms."""
    if not secret.strip():
        return _NOTHING
    encoded = base64.b64encode(secret.encode()).decode()
    forms = (secret, quote(secret, safe=""), json.dumps(secret)[1:-1], encoded)
    # the longest first, or what is left of it would stay
    found = "|".join(re.escape(form) for form in sorted(set(forms), key=len, reverse=True))
    return re.compile(rf"(?<!\w)(?:{found})(?!\w)" if len(secret) < _SHORT else found)
