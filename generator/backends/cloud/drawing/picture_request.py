"""Requests to image models, in the two API formats that servers support.

"openai": images/generations draws, and images/edits edits the pictures, which it receives with a
mask in a multipart form; the answer is base64. "seedream": images/generations does both, with the
pictures as ``data:`` URIs in the field ``image``; the answer is base64 or a URL.
"""

from __future__ import annotations

import base64
import binascii
import hashlib
import json
import re
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
import openai
from jaxtyping import UInt8

from ....calls.http.address import check_link
from ....calls.store import Used
from ....errors import UnusableError
from ....io.pictures import encode_png
from ..server import configuration
from ..server.client import Rejected, Server
from ..server.typed_question import data_uri
from .pictures import RGBA, decode_answer

Form = Literal["openai", "seedream"]

_SIZES = ((1024, 1024), (1536, 1024), (1024, 1536))
"""Sizes that OpenAI's image models support, as (width, height)."""

RATIOS: dict[Form, tuple[float, float]] = {"openai": (2 / 3, 1.5), "seedream": (0.4, 2.5)}
"""Minimum and maximum aspect ratio (width over height) of a picture."""

_SEEDREAM = {"response_format": "b64_json", "watermark": False,
             "sequential_image_generation": "disabled"}  # fmt: skip
"""Request options for Seedream other than text and size."""

_FAITHFUL = re.compile(r"gpt-image-([2-9]|1-mini)")
"""Models that reject ``input_fidelity``: in GPT Image 2 and newer versions, the fidelity is always
high (checked on 2026-11-28)."""

_OPAQUE = re.compile(r"gpt-image-[2-9]")
"""Models that reject ``background``: GPT Image 2 and newer versions cannot draw transparency."""

_LONG = 2048  # pixels of the longer side, for servers that accept any size
_BLOCKED = re.compile(
    r"moderation|content[_ ]policy|safety system|(?<!case)(?<!case[-_ ])(?<!in)sensitive"
)


class _Unusable(ValueError):
    """An answer without a usable picture."""


@dataclass
class Tolerated:
    """Options that a server has rejected as unknown."""

    unknown: set[str] = field(default_factory=set)
    lock: threading.Lock = field(default_factory=threading.Lock, repr=False)


@dataclass(frozen=True)
class Painter:
    """An image model, the format of its requests, and the options that its server rejects."""

    server: Server
    form: Form
    tolerated: Tolerated

    def paint(
        self,
        question: str,
        text: str,
        ratio: float,
        pictures: Sequence[UInt8[np.ndarray, "_ _ 3"]] = (),
        keep: UInt8[np.ndarray, "_ _ 4"] | None = None,
        *,
        clear: bool = False,
        used: Used | None = None,
    ) -> RGBA:
        """Return a picture that the model draws or edits.

        ``question`` names the call in errors and in the ledger. ``ratio`` is width over height; the
        closest ratio that the server supports is requested. The first of ``pictures`` is edited and
        stays unchanged where ``keep`` is opaque; if the server supports no mask, only the text
        expresses this. ``clear`` requests a transparent background, which not all servers support.
        ``used`` collects the answers to all drawings for one question; if this one is unusable,
        they are removed together with it.

        Raises:
            UnusableError: the model refuses, or its answer is not a picture.
            BackendError: the call failed.
        """
        files = [encode_png(picture) for picture in pictures]
        options: dict[str, Any] = {"size": self._size(ratio)}
        if self.form == "openai" and files:
            options |= _editing(self.server.model, keep, clear)
            request = self._edit(files, text)
        else:
            options |= _SEEDREAM if self.form == "seedream" else {}
            request = self._generation([data_uri(file) for file in files], text)
        meant, message = _meaning(text, options, files), ""
        used = used or Used(self.server.session.store)
        with used.dropped_on(UnusableError):
            # the URL may have expired, or a single answer may be unusable
            for memo in ("yes", "renew"):
                data = self._tolerant(question, request, options, used, meant, memo)
                try:
                    return self._picture(question, data, used, memo)
                except _Unusable as error:
                    message = str(error)
            raise self.server.unusable(question, message)

    def _generation(self, pictures: list[str], text: str) -> Callable[..., Any]:
        named = ("size", "response_format")

        def request(client: openai.OpenAI, headers: dict[str, str], options: dict[str, Any]) -> Any:
            extra: dict[str, Any] = {k: v for k, v in options.items() if k not in named}
            if pictures:
                extra["image"] = pictures if len(pictures) > 1 else pictures[0]
            return client.images.with_raw_response.generate(
                model=self.server.model,
                prompt=text,
                n=1 if self.form == "openai" else openai.omit,
                extra_headers=headers,
                extra_body=extra or None,
                **{k: v for k, v in options.items() if k in named},
            )

        return request

    def _edit(self, pictures: list[bytes], text: str) -> Callable[..., Any]:
        files = [(f"{k}.png", p, "image/png") for k, p in enumerate(pictures, start=1)]

        def request(client: openai.OpenAI, headers: dict[str, str], options: dict[str, Any]) -> Any:
            return client.images.with_raw_response.edit(
                model=self.server.model,
                prompt=text,
                image=files if len(files) > 1 else files[0],
                extra_headers=headers,
                **options,
            )

        return request

    def _tolerant(
        self,
        question: str,
        request: Callable[..., Any],
        options: dict[str, Any],
        used: Used,
        meant: str,
        memo: str,
    ) -> dict[str, Any]:
        """Make a call without the options that the server rejects; later calls omit them too."""
        left = {k: v for k, v in options.items() if k not in self.tolerated.unknown}
        while True:
            try:
                data = self.server.call(
                    question, lambda c, h, sent=left: request(c, h, sent), used, meant, memo
                )
            except Rejected as error:
                said = str(error).replace(self.server.model, "").lower()
                if _BLOCKED.search(said):
                    raise self.server.unusable(question, f"the model refuses: {error}") from None
                named = [k for k in left if k in said]
                if not left:
                    raise
                dropped = named or left  # all of them if the server names none
                left = {k: v for k, v in left.items() if k not in dropped}
                continue
            with self.tolerated.lock:
                self.tolerated.unknown.update(set(options) - set(left))
            return data

    def _size(self, ratio: float) -> str:
        if self.form == "openai":
            width, height = min(_SIZES, key=lambda s: abs(np.log(s[0] / s[1] / ratio)))
            return f"{width}x{height}"
        ratio = float(np.clip(ratio, *RATIOS[self.form]))
        width, height = _LONG * min(1.0, ratio), _LONG * min(1.0, 1 / ratio)
        return f"{round(width / 16) * 16}x{round(height / 16) * 16}"

    def _picture(self, question: str, data: dict[str, Any], used: Used, memo: str) -> RGBA:
        try:
            first = data["data"][0]
            coded, address = first.get("b64_json"), first.get("url")
        except (KeyError, IndexError, TypeError, AttributeError):
            raise _Unusable("the answer contains no picture.") from None
        if isinstance(address, str) and address.startswith("data:"):
            coded = coded or address.partition(",")[2]
        if not isinstance(coded, str | None) or not isinstance(address, str | None):
            raise _Unusable("the answer contains no picture: b64_json and url must be strings.")
        if not coded and not address:
            message = self.server.quote(str(first.get("error") or "neither b64_json nor url"))
            raise _Unusable(f"the answer contains no picture: {message}.")
        try:
            whole = base64.b64decode(coded, validate=True) if coded else None
        except (binascii.Error, TypeError, ValueError):
            raise _Unusable("the picture is not valid base64.") from None
        if whole is None:
            whole = self._fetch(question, str(address), used, memo)
        try:
            return decode_answer(whole)
        except UnusableError as error:
            raise _Unusable(str(error)) from None

    def _fetch(self, question: str, address: str, used: Used, memo: str) -> bytes:
        """Download a picture from its URL, without sending the key.

        It is stored under the drawing that ``used`` recorded last, because a server may give all
        pictures the same URL.
        """
        server = self.server
        try:
            check_link(address, "the picture's address", UnusableError)
        except UnusableError as error:  # no immediate retry, which would be billed again
            raise server.unusable(question, str(error)) from None
        host = configuration.host(address)
        if not configuration.may_fetch(address, server.base_url):
            raise server.failure(
                question,
                f"the picture is at {host or 'no host'!r}, from which downloads are not "
                "allowed. If that host is trusted, add it to TABLETOPGEN_CLOUD_IMAGE_HOSTS.",
            )
        headers = server.headers(question, used.keys[-1], memo)
        with server.session.client(f"cloud/{server.name}", address, timeout=120.0) as http:
            response = http.get(address, headers=headers)
            status, data = response.status_code, response.content
        used.add(response.headers)
        if status != 200:
            raise _Unusable(
                f"the picture could not be downloaded: {host} returned status {status}."
            )
        return data


def _editing(model: str, keep: UInt8[np.ndarray, "h w 4"] | None, clear: bool) -> dict[str, Any]:
    """Return the options of an edit request to OpenAI's image models; see ``Painter.paint``."""
    options: dict[str, Any] = {} if _FAITHFUL.search(model) else {"input_fidelity": "high"}
    if clear and not _OPAQUE.search(model):
        options["background"] = "transparent"
    if keep is not None:
        options["mask"] = ("mask.png", encode_png(keep), "image/png")
    return options


def _meaning(text: str, options: Mapping[str, Any], pictures: Sequence[bytes]) -> str:
    """Return a digest of a request's text, pictures and options, including unsupported options."""
    files = [*pictures, *(value[1] for value in options.values() if isinstance(value, tuple))]
    words = {name: value for name, value in options.items() if not isinstance(value, tuple)}
    digests = [hashlib.sha256(file).hexdigest() for file in files]
    return hashlib.sha256(json.dumps([text, words, digests]).encode()).hexdigest()
