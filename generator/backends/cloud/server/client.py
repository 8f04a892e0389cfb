"""One call to a server through the ``openai`` package, and what may go wrong with it in words."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import openai

from ....calls.http.redaction import excerpt, redact
from ....calls.session import Session
from ....calls.store import Used
from ....errors import BackendError, TabletopError, UnusableError
from ....io.bounded import parse_json
from . import configuration
from .configuration import Purpose

_TIMEOUT: Mapping[Purpose, float] = {"chat": 180.0, "image": 300.0}
"""Seconds that an answer may take."""

_SHOWN = 300  # characters of a server's own words in a message


class Rejected(UnusableError):
    """The server found fault with the request itself: asked otherwise, it may answer."""


@dataclass(frozen=True)
class Server:
    """A model on a server, and how it is called. ``purpose`` chooses the key's variable."""

    base_url: str
    model: str
    purpose: Purpose
    session: Session = field(repr=False, compare=False)

    @property
    def name(self) -> str:
        """The provider's name, or host and port."""
        return configuration.server_name(self.base_url)

    def call(
        self,
        question: str,
        request: Callable[[openai.OpenAI, dict[str, str]], Any],
        used: Used,
        meant: str,
        memo: str = "yes",
    ) -> dict[str, Any]:
        """Return the JSON that a request is answered with.

        Errors and the account name ``question``. ``request`` makes the call, given the client and
        headers to send, and returns the raw response; ``used`` takes note of it. Two calls that
        have the same meaning, ``meant``, have the same answer, unless ``memo`` is "renew".

        Raises:
            Rejected: status 400, 413 or 422.
            UnusableError: the answer is no JSON object.
            BackendError: no key, or the call failed.
        """
        answer = self._send(question, request, used, meant, memo)
        if isinstance(answer, TabletopError):  # raised where nothing that it leads to has a key
            raise answer.with_traceback(None)
        return self._json(question, answer)

    def _send(
        self,
        question: str,
        request: Callable[[openai.OpenAI, dict[str, str]], Any],
        used: Used,
        meant: str,
        memo: str,
    ) -> str | TabletopError:
        """Return the text that a request is answered with, or why there is none."""
        asker = f"cloud ({self.model} at {self.name}): {question}"
        key = configuration.key(self.base_url, self.purpose, asker)
        headers = {"Authorization": f"Bearer {key}", **self.headers(question, meant, memo)}
        try:
            with self.session.client(
                f"cloud/{self.name}", self.base_url, timeout=_TIMEOUT[self.purpose],
                secrets=(key,), headers=configuration.own_headers(self.base_url),
            ) as http:  # fmt: skip
                client = openai.OpenAI(
                    api_key=key, base_url=self.base_url, http_client=http, max_retries=0
                )
                answer = request(client, headers)
                used.add(answer.headers)
                return answer.text
        except TabletopError as error:
            return error
        except openai.APIStatusError as error:
            return self._refusal(question, error)
        except openai.APIConnectionError as error:
            return self._connection_error(question, error)
        except openai.OpenAIError as error:
            return self.failure(question, str(error))

    def headers(self, question: str, meant: str, memo: str) -> dict[str, str]:
        """Return the headers that tell the session about a call; see ``call``."""
        return {
            "x-tabletopgen-question": question, "x-tabletopgen-model": self.model,
            "x-tabletopgen-memo": memo, "x-tabletopgen-meant": meant,
        }  # fmt: skip

    def unusable(self, question: str, what: str) -> UnusableError:
        """Return the error that says who answered which question in a way that is of no use."""
        return UnusableError(self._message(question, what))

    def failure(self, question: str, what: str) -> BackendError:
        """Return the error that says who could not answer which question, and why."""
        return BackendError(self._message(question, what))

    def quote(self, text: str, maximum: int = _SHOWN) -> str:
        """Quote what a server said on one line of ``maximum`` characters, without keys."""
        keys = configuration.keys(self.base_url, self.purpose)
        text = " ".join(excerpt(text, 10 * maximum, keys).split())
        return repr(text if len(text) <= maximum else text[: maximum - 3] + "...")

    def _message(self, question: str, what: str, how: str = "failed") -> str:
        text = f"cloud ({self.model} at {self.name}): {question} {how}: {what}"
        return redact(text, configuration.keys(self.base_url, self.purpose))

    def _json(self, question: str, text: str) -> dict[str, Any]:
        try:
            found = parse_json(text, "The answer", UnusableError)
        except UnusableError:
            kind = "HTML" if text.lstrip()[:1] == "<" else "no JSON"
            raise self.unusable(
                question,
                f"the answer is {kind} ({self.quote(text, 80)}). Is {self.base_url} the address "
                "of the API (it often ends in /v1)?",
            ) from None
        if not isinstance(found, dict):
            raise self.unusable(question, f"the answer is no JSON object: {self.quote(text, 80)}.")
        if found.get("error"):
            raise self.failure(question, f"the server says {self.quote(_error_message(found))}.")
        return found

    def _refusal(self, question: str, error: openai.APIStatusError) -> BackendError:
        said = self.quote(_error_message(error.body) or error.message)
        message = f"status {error.status_code}, {said}."
        if error.status_code in (400, 413, 422):
            return Rejected(self._message(question, message, "was rejected"))
        todo = ""
        if error.status_code in (401, 403):
            variables = configuration.key_variables(self.base_url, self.purpose)
            todo = f" Check the key in {' or '.join(variables)} and what it may use."
        elif error.status_code == 404:
            variable = f"TABLETOPGEN_CLOUD_{self.purpose.upper()}_MODEL"
            todo = f" Does {self.base_url} have the model {self.model!r}? Set {variable}."
        return self.failure(question, message + todo)

    def _connection_error(self, question: str, error: openai.APIConnectionError) -> TabletopError:
        first = cause = error.__cause__
        while cause is not None:
            if isinstance(cause, TabletopError):  # the session's own, which says it all
                return cause
            cause = cause.__cause__
        message = str(error) if first is None else f"{type(first).__name__}: {first}"
        return self.failure(
            question,
            f"no answer from {self.base_url} ({self.quote(message)}). Is the server there?",
        )


def _error_message(body: object) -> str:
    """Return the message in an error's body, wherever servers put it."""
    while isinstance(body, dict):
        body = body.get("error") or body.get("message") or body.get("detail") or ""
    return "" if body is None else str(body)
