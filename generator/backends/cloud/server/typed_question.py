"""Questions to a chat model with typed answers: schema, parsing, validation and retries.

A server is asked for JSON that follows a schema (``json_schema``). If it rejects that, it is asked
for any JSON (``json_object``), and then by the prompt alone; the form that it accepts is remembered
for the backend's lifetime. Answers are stored by question, regardless of the form; if a question
fails because of the content of its answers, they are removed.
"""

from __future__ import annotations

import base64
import hashlib
import json
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np
from jaxtyping import UInt8
from pydantic import ValidationError

from ....calls.store import Used
from ....errors import InputError, UnusableError
from ....io.pictures import encode_png
from ..prompts import prompt
from .answers import ModelAnswer, strict_schema
from .client import Rejected, Server
from .json_text import Wrong, is_refusal, read_object

REASKS = 3
"""Maximum number of retries of a question; each states the fault of the previous answer."""

ANSWER = 16_384
"""Maximum tokens of an answer, including thoughts; budgets rely on it."""

_LONGEST = 2**20  # maximum characters of an answer, regardless of the server

_BOUNDS = ("max_completion_tokens", "max_tokens", "")
"""Request parameters that limit the tokens of an answer, tried in order; "" sets no limit."""

_FORMS = ("json_schema", "json_object", "words")

A = TypeVar("A", bound=ModelAnswer)
T = TypeVar("T")
Picture = UInt8[np.ndarray, "_ _ 3"]


@dataclass
class Manners:
    """Request features that a server accepts: an answer format and possibly a seed."""

    form: int = 0
    seed: bool = True
    bound: int = 0
    lock: threading.Lock = field(default_factory=threading.Lock, repr=False)

    def gentler(self, form: int, seed: bool, said: str) -> tuple[int, bool] | None:
        """Return the answer format and seed option to try next, or None if none are left."""
        if seed and "seed" in said.lower():
            return form, False
        if form + 1 < len(_FORMS):
            return form + 1, seed
        return (form, False) if seed else None

    def learn(self, form: int, seed: bool) -> None:
        """Record the features that a server accepted."""
        with self.lock:
            self.form, self.seed = max(self.form, form), self.seed and seed


@dataclass(frozen=True)
class Chat:
    """A chat model, and the request features that its server accepts."""

    server: Server
    manners: Manners
    seed: int = 0

    def ask(
        self,
        question: str,
        text: str,
        pictures: Sequence[Picture],
        answer: type[A],
        accept: Callable[[A], T],
    ) -> T:
        """Ask a question about pictures and return the result of ``accept`` for the answer.

        ``question`` names the call in errors and in the ledger. The schema of ``answer`` is
        appended to ``text``, and the pictures follow in their order. ``Wrong`` and ``InputError``
        raised by ``accept`` are sent back to the model.

        Raises:
            UnusableError: the model refuses, or no answer is usable after ``REASKS`` retries.
            BackendError: the call failed.
        """
        schema = strict_schema(answer)
        tail = prompt("answer", schema=json.dumps(schema))
        content: list[dict[str, Any]] = [{"type": "text", "text": f"{text}\n\n{tail}"}]
        content += [_picture_part(picture) for picture in pictures]
        messages: list[dict[str, Any]] = [{"role": "user", "content": content}]
        used, problem = Used(self.server.session.store), ""
        with used.dropped_on(UnusableError):
            for _ in range(1 + REASKS):
                said = self._reply(question, messages, schema, used)
                try:
                    return accept(answer.model_validate(read_object(said)))
                except ValidationError as error:
                    problem = _faults(error)
                except (Wrong, InputError) as error:
                    problem = str(error)
                if is_refusal(said):
                    raise self.server.unusable(
                        question, f"the model refuses: {self.server.quote(said)}."
                    )
                messages += [
                    {"role": "assistant", "content": said or "(nothing)"},
                    {"role": "user", "content": prompt("again", problem=problem)},
                ]
            raise self.server.unusable(
                question,
                f"{1 + REASKS} answers could not be used. Problem with the last answer: {problem} "
                "Try another model or seed.",
            )

    def _reply(
        self, question: str, messages: list[dict[str, Any]], schema: dict[str, Any], used: Used
    ) -> str:
        form, seed = self.manners.form, self.manners.seed
        while True:
            try:
                data = self._send(question, messages, schema, form, seed, used)
            except Rejected as error:
                # the model's name may contain "seed"
                said = str(error).replace(self.server.model, "")
                gentler = self.manners.gentler(form, seed, said)
                if gentler is None:
                    raise
                form, seed = gentler
                continue
            self.manners.learn(form, seed)
            return self._content(question, data)

    def _send(
        self,
        question: str,
        messages: list[dict[str, Any]],
        schema: dict[str, Any],
        form: int,
        seed: bool,
        used: Used,
    ) -> dict[str, Any]:
        strict = {"name": question, "schema": schema, "strict": True}
        body: dict[str, Any] = {"seed": self.seed} if seed else {}
        if _FORMS[form] == "json_schema":
            body["response_format"] = {"type": "json_schema", "json_schema": strict}
        elif _FORMS[form] == "json_object":
            body["response_format"] = {"type": "json_object"}
        asked = json.dumps([messages, schema, self.seed])
        meant = hashlib.sha256(asked.encode()).hexdigest()
        bound = self.manners.bound
        while True:
            more: dict[str, Any] = {_BOUNDS[bound]: ANSWER, **body} if _BOUNDS[bound] else body
            try:
                data = self.server.call(
                    question,
                    lambda client, headers, more=more: (
                        client.chat.completions.with_raw_response.create(
                            model=self.server.model,
                            messages=messages,  # type: ignore[arg-type]
                            extra_headers=headers,
                            **more,
                        )
                    ),
                    used,
                    meant,
                )
            except Rejected as error:
                if not (_BOUNDS[bound] and any(n in str(error) for n in _BOUNDS if n)):
                    raise
                bound += 1
                continue
            self.manners.bound = max(self.manners.bound, bound)
            return data

    def _content(self, question: str, data: dict[str, Any]) -> str:
        """Return the text of a chat completion.

        Raises:
            UnusableError: the text is missing or truncated, or the model refused.
        """
        try:
            choice = data["choices"][0]
            message = choice["message"]
            content = message.get("content") or ""
            if isinstance(content, list):
                content = "".join(p.get("text") or "" for p in content if isinstance(p, dict))
            refusal, end = message.get("refusal"), choice.get("finish_reason")
        except (KeyError, IndexError, TypeError, AttributeError):
            raise self.server.unusable(
                question,
                f"the answer is not a chat completion: {self.server.quote(json.dumps(data), 120)}.",
            ) from None
        if refusal or end == "content_filter":
            quoted = self.server.quote(str(refusal or content or "no reason given"))
            raise self.server.unusable(question, f"the model refuses: {quoted}.")
        if end == "length":
            raise self.server.unusable(
                question,
                "the answer was truncated at the server's token limit, or at this package's limit "
                f"of {ANSWER} tokens. Use another model.",
            )
        said = str(content)
        if len(said) > _LONGEST:
            raise self.server.unusable(
                question, f"the answer has {len(said)} characters; the limit is {_LONGEST}."
            )
        return said


def data_uri(png: bytes) -> str:
    """Return a PNG as a ``data:`` URI."""
    return "data:image/png;base64," + base64.b64encode(png).decode()


def _picture_part(picture: Picture) -> dict[str, Any]:
    url = data_uri(encode_png(picture))
    return {"type": "image_url", "image_url": {"url": url, "detail": "high"}}


def _faults(error: ValidationError) -> str:
    """Describe up to six validation errors of an answer, without quoting its values."""
    found = [
        f"{'.'.join(str(part) for part in fault['loc']) or 'the answer'}: {fault['msg']}"
        for fault in error.errors(include_url=False, include_context=False, include_input=False)
    ]
    return "; ".join(found[:6]) + "."
