"""The cloud backend's servers, models and keys, read from fields or else from the environment.

========================================  ==========================================================
``TABLETOPGEN_CLOUD_BASE_URL``            the chat server, default ``https://api.openai.com/v1``
``TABLETOPGEN_CLOUD_KEY``                 its key; else the provider's own: ``OPENAI_API_KEY``,
                                          ``OPENROUTER_API_KEY`` or ``ARK_API_KEY``, by the host
``TABLETOPGEN_CLOUD_CHAT_MODEL``          the chat model; needed unless the server is OpenAI's
``TABLETOPGEN_CLOUD_IMAGE_BASE_URL``      the image server, default the chat server
``TABLETOPGEN_CLOUD_IMAGE_KEY``           its key; default as for chat, if it is the same host
``TABLETOPGEN_CLOUD_IMAGE_MODEL``         the image model; needed unless the server is OpenAI's
``TABLETOPGEN_CLOUD_IMAGE_HOSTS``         more hosts that pictures may be fetched from, by commas
========================================  ==========================================================

A key is read when a call is made, sent to its own host only, and never stored. A server on this
machine (Ollama, vLLM) needs none. Other settings that the ``openai`` package reads from the
environment are not sent (``OPENAI_CUSTOM_HEADERS``), or only to OpenAI (``OPENAI_ORG_ID``,
``OPENAI_PROJECT_ID``).
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal

from ....calls.http.address import checked_address, local
from ....errors import BackendError
from ....io.bounded import split_url

Purpose = Literal["chat", "image"]

OPENAI = "https://api.openai.com/v1"

DEFAULTS: Mapping[Purpose, str] = MappingProxyType(
    {"chat": "gpt-6-luna", "image": "gpt-image-2.6-sunburst"}
)
"""Default models on OpenAI's own server.

Checked on 2026-11-28 against the pages on developers.openai.com (models, prices, deprecations),
without a key. gpt-6-luna is the official replacement for gpt-4o and gpt-4.1, which are shut down on
2027-01-14; it accepts pictures and supports JSON schemas. gpt-image-1 was shut down on 2026-10-23;
gpt-image-1.5 and -mini are shut down on 2026-12-01. Of the 2.6 image models, sunburst is intended
for edits; flare is faster at the same prices.
"""

_PROVIDERS = {
    "api.openai.com": ("openai", "OPENAI_API_KEY"),
    "openrouter.ai": ("openrouter", "OPENROUTER_API_KEY"),
    "ark.cn-beijing.volces.com": ("ark", "ARK_API_KEY"),
    "ark.ap-southeast.bytepluses.com": ("ark", "ARK_API_KEY"),
}
"""The provider's name and the variable of its key, by host."""

_STORES = {
    "openai": (".blob.core.windows.net",),
    "ark": (".volces.com", ".bytepluses.com"),
}
"""Hosts where providers store the pictures that their answers link to."""


def chat_base_url() -> str:
    """Return the chat server's base URL from the environment, or else OpenAI's."""
    return os.environ.get("TABLETOPGEN_CLOUD_BASE_URL") or OPENAI


def image_base_url() -> str:
    """Return the image server's base URL from the environment, or else the chat server's."""
    return os.environ.get("TABLETOPGEN_CLOUD_IMAGE_BASE_URL") or chat_base_url()


def chat_model() -> str:
    """Return the chat model from the environment.

    Raises:
        BackendError: no model is set, and the server is not OpenAI's.
    """
    return _model("chat", chat_base_url())


def image_model() -> str:
    """Return the image model from the environment; see ``chat_model``."""
    return _model("image", image_base_url())


def _model(purpose: Purpose, url: str) -> str:
    variable = f"TABLETOPGEN_CLOUD_{purpose.upper()}_MODEL"
    if named := os.environ.get(variable):
        return named
    if host(url) == host(OPENAI):
        return DEFAULTS[purpose]
    raise BackendError(
        f"cloud: no {purpose} model is set for {url}. Set {variable} to a model of that server, "
        "or pass model=... to the backend's class."
    )


def checked_url(url: str) -> str:
    """Return a base URL without a trailing slash.

    Raises:
        BackendError: the URL is not http(s), or it contains a secret.
    """
    variables = "TABLETOPGEN_CLOUD_BASE_URL or TABLETOPGEN_CLOUD_IMAGE_BASE_URL"
    url = checked_address(
        url, "cloud: the base URL",
        f"Correct {variables}; pass keys in TABLETOPGEN_CLOUD_KEY.",
    )  # fmt: skip
    if split_url(url, "cloud: the base URL", BackendError).query:
        raise BackendError(
            f"cloud: the base URL of {host(url)} must not contain a query. Set "
            "TABLETOPGEN_CLOUD_KEY to pass a key."
        )
    return url


def host(url: str) -> str:
    """Return a URL's host in lower case, or "" if it is missing or the URL is invalid."""
    try:
        return split_url(url, "It", BackendError).hostname or ""
    except BackendError:
        return ""


def server_name(url: str) -> str:
    """Return the provider's name, or the host and port."""
    known = _PROVIDERS.get(host(url))
    return known[0] if known else split_url(url, "cloud: the URL", BackendError).netloc.lower()


def key(url: str, purpose: Purpose, what: str = "cloud") -> str:
    """Return the server key that ``what`` needs, or raise an error that names the variables."""
    if found := keys(url, purpose):
        return found[0]
    if local(host(url)):
        return "none-needed"
    raise BackendError(
        f"{what}: no key for {server_name(url)} ({url}). Set "
        f"{' or '.join(key_variables(url, purpose))}; the key is read from the environment only "
        "and never stored."
    )


def keys(url: str, purpose: Purpose) -> tuple[str, ...]:
    """Return the keys that are set for a server; messages must not contain them."""
    values = (os.environ.get(v, "").strip() for v in key_variables(url, purpose))
    return tuple(value for value in values if value)


def key_variables(url: str, purpose: Purpose) -> tuple[str, ...]:
    """Return the environment variables that may hold a server's key, in order of precedence.

    A provider's own key is sent only to that provider's hosts, and the chat server's key to no
    other host.
    """
    names = ["TABLETOPGEN_CLOUD_IMAGE_KEY"] if purpose == "image" else []
    if purpose == "chat" or host(url) == host(chat_base_url()):
        names.append("TABLETOPGEN_CLOUD_KEY")
    if host(url) in _PROVIDERS:
        names.append(_PROVIDERS[host(url)][1])
    return tuple(names)


def own_headers(url: str) -> tuple[str, ...]:
    """Return the names of headers that only OpenAI receives, or none if ``url`` is not OpenAI's."""
    return ("openai-organization", "openai-project") if host(url) == host(OPENAI) else ()


def may_fetch(address: str, server: str) -> bool:
    """Return whether a picture may be downloaded from a URL in an answer of ``server``.

    Allowed are https URLs on the server's own host, on its provider's storage, and on the hosts of
    ``TABLETOPGEN_CLOUD_IMAGE_HOSTS``, where a leading dot includes all subdomains. http is allowed
    only for servers that are themselves called over http.
    """
    try:
        parts, here = split_url(address, "The picture's address", BackendError), host(address)
        own = split_url(server, "cloud: the URL", BackendError)
    except BackendError:
        return False
    if parts.scheme != "https" and not (parts.scheme == "http" == own.scheme):
        return False
    if "@" in parts.netloc:
        return False
    if here == host(server):
        return parts.scheme == "https" or parts.netloc == own.netloc
    more = os.environ.get("TABLETOPGEN_CLOUD_IMAGE_HOSTS", "").lower().split(",")
    allowed = (*_STORES.get(server_name(server), ()), *(m.strip() for m in more if m.strip()))
    return any(here == a or (a.startswith(".") and here.endswith(a)) for a in allowed)
