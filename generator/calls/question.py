"""The content of a request: its question, its key in the call store, and its maximum cost."""

from __future__ import annotations

import hashlib
import json
import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Literal

import httpx2

from ..errors import BackendError, choices
from ..io.bounded import parse_object
from .http.address import local
from .http.redaction import plain_url
from .money.prices import Price, Prices

QUESTION, MODEL, MEMO = "x-tabletopgen-question", "x-tabletopgen-model", "x-tabletopgen-memo"
MEANT, FREE = "x-tabletopgen-meant", "x-tabletopgen-free"

Memo = Literal["yes", "no", "renew"]

_MEANT = ("x-tc-action", "x-tc-version", "x-tc-region")  # headers that are part of the question
_MEMOS: Mapping[str, Memo] = {"yes": "yes", "no": "no", "renew": "renew"}
_DIGITS = 12  # digits of the largest number of tokens or images
_BYTES = 3  # bytes of text per token; conservatively low, so that costs are not underestimated
_LONGEST_WORD = 4096  # characters; longer words are base64-encoded files
_ANSWER = 16_384  # tokens of a generated image, which requests do not limit
_TALK = 131_072  # tokens of an unlimited chat answer, including the model's reasoning


@dataclass(frozen=True)
class Question:
    """One call: its question, its model, its key in the call store, and its price.

    ``at`` is the server's host, with its port if it has one.
    """

    server: str
    name: str
    model: str
    key: str
    memo: Memo
    price: Price | None
    most: float | None
    at: str = ""

    def __str__(self) -> str:
        """Return the name that messages use for the call."""
        return f"{self.server}, {self.name}" + f" ({self.model})" * bool(self.model)

    def money(self, usage: Usage) -> float | None:
        """Return the cost of an answer, or None if its price is unknown.

        If tokens are billed and the answer does not report their number, the maximum cost is
        returned.
        """
        if self.price is None or self.most is None:
            return None
        if not self.price.told(usage.tokens_in, usage.tokens_out):
            return self.most
        return self.price.of(usage.tokens_in, usage.tokens_out, usage.images)


@dataclass(frozen=True)
class Usage:
    """Token and image counts that an answer reports."""

    tokens_in: int = 0
    tokens_out: int = 0
    images: int = 0


NOTHING = Usage()
"""The usage that is recorded for an answer without usage data."""


def question(request: httpx2.Request, server: str, prices: Prices) -> Question:
    """Return a request's ``Question``, and remove the internal headers that describe it.

    Raises:
        BackendError: ``x-tabletopgen-memo`` is not "yes", "no" or "renew".
    """
    name = request.headers.pop(QUESTION, "") or f"{request.method} {request.url.path}"
    model = request.headers.pop(MODEL, "")
    memo = request.headers.pop(MEMO, "yes")
    if memo not in _MEMOS:
        raise BackendError(
            (f'{server}, {name}: the header {MEMO} must be "yes", "no" or "renew", got {memo!r}.')
            + choices(memo, _MEMOS)
        )
    body = request.read()
    meant = request.headers.pop(MEANT, "")
    free = request.headers.pop(FREE, "") == "yes"
    key = _key(request, meant.encode() or body, model)
    payload = _payload(request, body)
    model = model or str(payload.get("model", ""))
    at = request.url.netloc.decode()
    price = prices.price(model, at)
    price, most = (Price(), 0.0) if free else _price(request, payload, body, price)
    return Question(server, name, model, key, _MEMOS[memo], price, most, at)


def usage(payload: Any) -> Usage:
    """Return the usage that the JSON of an answer reports.

    Reasoning tokens are billed too; some servers count them only in the total.
    """
    if not isinstance(payload, dict):
        return NOTHING
    told, data = payload.get("usage"), payload.get("data")
    told = told if isinstance(told, dict) else {}
    data = data if isinstance(data, list) else []
    images = [d for d in data if isinstance(d, dict) and (d.get("b64_json") or d.get("url"))]
    tokens_in = _count(told.get("prompt_tokens", told.get("input_tokens")))
    tokens_out = _count(told.get("completion_tokens", told.get("output_tokens")))
    tokens_out = max(tokens_out, _count(told.get("total_tokens")) - tokens_in)
    return Usage(tokens_in, tokens_out, len(images))


def failed(payload: Any) -> bool:
    """Return whether the JSON of an answer with status 2xx reports an error."""
    if not isinstance(payload, dict):
        return False
    inner = payload.get("Response")
    return bool(payload.get("error") or (isinstance(inner, dict) and inner.get("Error")))


def _key(request: httpx2.Request, body: bytes, model: str) -> str:
    """Return the sha256 of the question, excluding keys, signatures and random boundaries."""
    kind = request.headers.get("content-type", "")
    boundary = re.search(r'boundary="?([^";,]+)', kind)
    if boundary:
        body = body.replace(boundary[1].encode(), b"boundary")
        kind = kind.replace(boundary[1], "boundary")
    meant = {name: request.headers[name] for name in _MEANT if name in request.headers}
    head = [request.method, plain_url(str(request.url)), kind, model, meant]
    return hashlib.sha256(json.dumps(head).encode() + b"\n" + body).hexdigest()


def _payload(request: httpx2.Request, body: bytes) -> Mapping[str, Any]:
    """Return the fields of a request's body: its JSON, or the short fields of a form."""
    kind = request.headers.get("content-type", "")
    if "json" in kind:
        try:
            return parse_object(body, "The question", BackendError)
        except BackendError:
            return {}
    if "multipart" in kind:
        field = re.compile(rb'name="([\w\[\]]+)"\r\n(?:[^\r\n]+\r\n)*\r\n([^\r\n]{0,200})\r\n')
        return {k.decode(): v.decode("utf-8", "replace") for k, v in field.findall(body)}
    return {}


def _price(
    request: httpx2.Request, payload: Mapping[str, Any], body: bytes, price: Price | None
) -> tuple[Price | None, float | None]:
    """Return a call's price and its maximum cost, or None for values that are unknown.

    Status requests are free, and so are unlisted models on this machine.
    """
    if request.method in ("GET", "HEAD") or (price is None and local(request.url.host)):
        return Price(), 0.0
    if price is None:
        return None, None
    number = max(1, _count(payload.get("n")))
    bounds = ("max_completion_tokens", "max_output_tokens", "max_tokens")
    unbound = _TALK if "messages" in payload else _ANSWER
    bound = next((_count(payload[b]) for b in bounds if payload.get(b)), unbound)
    texts = list(_texts(payload))
    words = sum(len(t.encode()) // _BYTES + 1 for t in texts if not _is_file(t))
    pictures = sum(map(_is_file, texts)) + body.count(b"filename=")
    tokens = words + math.ceil(pictures * price.picture)
    return price, price.of(tokens, number * bound, number)


def _is_file(text: str) -> bool:
    long = len(text) > _LONGEST_WORD and text.isascii() and " " not in text
    return long or text.startswith("data:image/")


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, Mapping):
        for name, inner in value.items():
            yield str(name)
            yield from _texts(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from _texts(inner)
    else:
        yield str(value)


def _count(value: Any) -> int:
    """Parse a count as servers and forms write it, or return 0 if it is invalid."""
    if isinstance(value, str) and len(value) > _DIGITS:
        return 0
    try:
        return min(max(0, int(value)), 10**_DIGITS)
    except (TypeError, ValueError, OverflowError):
        return 0
