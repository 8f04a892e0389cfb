"""A question to a chat model with a typed answer: schema, reading, checking, asking again.

A server is asked for an answer by schema (``json_schema``), then for any JSON (``json_object``),
then by the prompt's own words; which of them it takes is learned from its first rejection and kept
as long as the backend. Answers are kept by what was asked, whatever form the server took; those of
a question that ends in an error for what they say are dropped.
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
"""How often at most a question is asked again with what was wrong with the answer."""

ANSWER = 16_384
"""Tokens that an answer may have, thoughts included: a budget counts on it."""

_LONGEST = 2**20  # characters of an answer, whatever a server makes of that

_BOUNDS = ("max_completion_tokens", "max_tokens", "")
"""How a request says that; older servers know only the second, small models allow neither."""

_FORMS = ("json_schema", "json_object", "words")

A = TypeVar("A", bound=ModelAnswer)
T = TypeVar("T")
Picture = UInt8[np.ndarray, "_ _ 3"]


@dataclass
class Manners:
    """What a server has been found to take: the form of answers, and whether a seed."""

    form: int = 0
    seed: bool = True
    bound: int = 0
    lock: threading.Lock = field(default_factory=threading.Lock, repr=False)

    def gentler(self, form: int, seed: bool, said: str) -> tuple[int, bool] | None:
        """Return what to try after a rejection of ``form`` and ``seed``; None: nothing is left."""
        if seed and "seed" in said.lower():
            return form, False
        if form + 1 < len(_FORMS):
            return form + 1, seed
        return (form, False) if seed else None

    def learn(self, form: int, seed: bool) -> None:
        """Keep what a server took."""
        with self.lock:
            self.form, self.seed = max(self.form, form), self.seed and seed


@dataclass(frozen=True)
class Chat:
    """A chat model, and how its server likes to be asked."""

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
        """Return what ``accept`` makes of the answer to a question about pictures.

        Errors and the account name ``question``; to ``text`` the schema of ``answer`` is added, and
        pictures are shown after it, in their order. What ``accept`` raises as ``Wrong`` or
        ``InputError`` goes back to the model.

        Raises:
            UnusableError: the model refuses, or no answer after ``REASKS`` more tries can be used.
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
                f"{1 + REASKS} answers could not be used. What was wrong with the last: {problem} "
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
                said = str(error).replace(self.server.model, "")  # whose name may hold "seed"
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
        """Return the text of a chat completion (UnusableError: none, refused, or cut off)."""
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
                f"the answer is no chat completion: {self.server.quote(json.dumps(data), 120)}.",
            ) from None
        if refusal or end == "content_filter":
            quoted = self.server.quote(str(refusal or content or "no reason given"))
            raise self.server.unusable(question, f"the model refuses: {quoted}.")
        if end == "length":
            raise self.server.unusable(
                question,
                f"the answer was cut off at a limit of tokens: the server's own, or the {ANSWER} "
                "that an answer may have. Use another model.",
            )
        said = str(content)
        if len(said) > _LONGEST:
            raise self.server.unusable(
                question, f"the answer has {len(said)} characters; at most {_LONGEST} are read."
            )
        return said


def data_uri(png: bytes) -> str:
    """Return a PNG as a ``data:`` URI."""
    return "data:image/png;base64," + base64.b64encode(png).decode()


def _picture_part(picture: Picture) -> dict[str, Any]:
    url = data_uri(encode_png(picture))
    return {"type": "image_url", "image_url": {"url": url, "detail": "high"}}


def _faults(error: ValidationError) -> str:
    """Return what is wrong with an answer: at most six places, without a copy of its values."""
    found = [
        f"{'.'.join(str(part) for part in fault['loc']) or 'the answer'}: {fault['msg']}"
        for fault in error.errors(include_url=False, include_context=False, include_input=False)
    ]
    return "; ".join(found[:6]) + "."
