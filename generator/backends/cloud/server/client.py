"""Calls to a server through the ``openai`` package, with explanations of their failures."""

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
"""Time limit of an answer in seconds."""

_SHOWN = 300  # maximum characters of a server's message that are quoted


class Rejected(UnusableError):
    """The server rejected the request itself; a modified request may succeed."""


@dataclass(frozen=True)
class Server:
    """A model on a server. ``purpose`` selects the environment variable of the key."""

    base_url: str
    model: str
    purpose: Purpose
    session: Session = field(repr=False, compare=False)

    @property
    def name(self) -> str:
        """The provider's name, or the host and port."""
        return configuration.server_name(self.base_url)

    def call(
        self,
        question: str,
        request: Callable[[openai.OpenAI, dict[str, str]], Any],
        used: Used,
        meant: str,
        memo: str = "yes",
    ) -> dict[str, Any]:
        """Send a request and return the JSON of the answer.

        ``question`` names the call in errors and in the ledger. ``request`` makes the call, given
        the client and additional headers, and returns the raw response, which ``used`` records. Two
        calls with the same meaning ``meant`` share a stored answer, unless ``memo`` is "renew".

        Raises:
            Rejected: status 400, 413 or 422.
            UnusableError: the answer is not a JSON object.
            BackendError: there is no key, or the call failed.
        """
        answer = self._send(question, request, used, meant, memo)
        # raised here, so that no part of its traceback contains a key
        if isinstance(answer, TabletopError):
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
        """Return the text of the answer to a request, or the error if the call failed."""
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
        """Return the internal headers that tell the session about a call; see ``call``."""
        return {
            "x-tabletopgen-question": question, "x-tabletopgen-model": self.model,
            "x-tabletopgen-memo": memo, "x-tabletopgen-meant": meant,
        }  # fmt: skip

    def unusable(self, question: str, what: str) -> UnusableError:
        """Return the error for an unusable answer; it names the server and the question."""
        return UnusableError(self._message(question, what))

    def failure(self, question: str, what: str) -> BackendError:
        """Return the error for a failed call; it names the server and the question."""
        return BackendError(self._message(question, what))

    def quote(self, text: str, maximum: int = _SHOWN) -> str:
        """Quote a server's text on one line of at most ``maximum`` characters, without keys."""
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
                f"the answer is {kind} ({self.quote(text, 80)}). Check that {self.base_url} is "
                "the address of the API (it often ends in /v1).",
            ) from None
        if not isinstance(found, dict):
            raise self.unusable(
                question, f"the answer is not a JSON object: {self.quote(text, 80)}."
            )
        if found.get("error"):
            raise self.failure(question, f"the server reports {self.quote(_error_message(found))}.")
        return found

    def _refusal(self, question: str, error: openai.APIStatusError) -> BackendError:
        said = self.quote(_error_message(error.body) or error.message)
        message = f"status {error.status_code}, {said}."
        if error.status_code in (400, 413, 422):
            return Rejected(self._message(question, message, "was rejected"))
        todo = ""
        if error.status_code in (401, 403):
            variables = configuration.key_variables(self.base_url, self.purpose)
            todo = f" Check the key in {' or '.join(variables)} and its permissions."
        elif error.status_code == 404:
            variable = f"TABLETOPGEN_CLOUD_{self.purpose.upper()}_MODEL"
            todo = f" Check that {self.base_url} has the model {self.model!r}, or set {variable}."
        return self.failure(question, message + todo)

    def _connection_error(self, question: str, error: openai.APIConnectionError) -> TabletopError:
        first = cause = error.__cause__
        while cause is not None:
            if isinstance(cause, TabletopError):  # an error of the session is already complete
                return cause
            cause = cause.__cause__
        message = str(error) if first is None else f"{type(first).__name__}: {first}"
        return self.failure(
            question,
            f"no response from {self.base_url} ({self.quote(message)}). Check that the server is "
            "running.",
        )


def _error_message(body: object) -> str:
    """Return the message in an error response's body, from any of its usual places."""
    while isinstance(body, dict):
        body = body.get("error") or body.get("message") or body.get("detail") or ""
    return "" if body is None else str(body)
