"""One key, sent to a server that repeats it wherever it can: found nowhere afterwards."""

from __future__ import annotations

import logging
import traceback
from collections.abc import Iterator
from pathlib import Path

import openai
import pytest
from paid_server import CHAT, KEY, PRICES, Asked, Says, ask, serving, session

from generator.errors import BackendError
from generator.running.store import CallStore

ECHO = {"error": {"message": f"Incorrect API key provided: {KEY}", "code": "invalid_api_key"}}


def chain(error: BaseException | None) -> Iterator[BaseException]:
    while error is not None:
        yield error
        error = error.__cause__ or error.__context__


def held(error: BaseException) -> str:
    """Everything that a log of an exception may show, attributes included."""
    texts = ["".join(traceback.format_exception(error))]
    for link in chain(error):
        texts += [repr(link), str(vars(link)), str(getattr(link, "body", ""))]
        texts.append(getattr(getattr(link, "response", None), "text", ""))
    return "\n".join(texts)


def server_errors() -> list[Says]:
    page = f"<html>{KEY}</html>".encode()
    return [
        Says(ECHO, status=401),
        Says(ECHO, status=500),
        Says(f"not {KEY}".encode(), status=503, kind="text/plain"),
        Says(page, kind="text/html"),
        Says(f'{{"{KEY}'.encode()),
        Says(ECHO, cut=4),
        Says(hang_up=True),
        Says(status=302, headers=(("location", "http://else.invalid/chat"),)),
        Says(status=429, headers=(("retry-after", "9999"),)),
    ]


def test_no_key_in_errors_logs_store_or_ledger(
    tmp_path: Path, caplog: pytest.LogCaptureFixture, capfd: pytest.CaptureFixture[str]
) -> None:
    caplog.set_level(logging.DEBUG)
    for name in ("httpx2", "httpcore2", "openai", "generator"):
        logging.getLogger(name).setLevel(logging.DEBUG)
    shared = session(store=CallStore(tmp_path / "calls"), attempts=2)
    errors = []
    for says in server_errors():
        with serving([says]) as server, shared.client("cloud", server.url) as client:
            sdk = openai.OpenAI(
                api_key=KEY, base_url=f"{server.url}/v1", http_client=client, max_retries=0
            )
            with pytest.raises((openai.APIError, BackendError)) as caught:
                sdk.chat.completions.create(
                    model="m", messages=[{"role": "user", "content": "what is there?"}]
                )
            errors.append(caught.value)
            assert server.asked[0].headers["authorization"] == f"Bearer {KEY}"  # it was sent
    with serving([Says()]) as server:
        ask(shared, server.url)
    shared.account.save(tmp_path, PRICES)
    assert len(shared.account.entries) > len(errors)
    places = {
        "errors": "\n".join(held(error) for error in errors),
        "logs": "\n".join(r.getMessage() + str(vars(r)) for r in caplog.records),
        "output": "".join(capfd.readouterr()),
        "ledger": (tmp_path / "ledger.json").read_text() + shared.account.text(),
        "session": repr(shared) + repr(vars(shared)),
        "store": "".join(
            p.read_bytes().decode("latin-1") + str(p)
            for p in (tmp_path / "calls").rglob("*")
            if p.is_file()
        ),
    }
    assert "chat/completions" in places["logs"] and "choices" in places["store"]
    assert [place for place, text in places.items() if KEY in text] == []


def test_the_search_can_fail() -> None:
    error = BackendError("wrapped")
    error.__context__ = ValueError(KEY)
    assert KEY in held(error)


def test_the_sdk_gets_answers_and_refusals_through_a_session() -> None:
    def script(asked: Asked, k: int) -> Says:
        return Says(ECHO, status=400) if b"json_schema" in asked.body else Says()

    shared = session()
    with serving(script) as server, shared.client("cloud", f"{server.url}/v1") as client:
        sdk = openai.OpenAI(
            api_key=KEY, base_url=f"{server.url}/v1", http_client=client, max_retries=0
        )
        create = sdk.chat.completions.create
        told = {"x-tabletopgen-question": "list_objects"}
        done = create(model="m", messages=[], extra_headers=told)
        assert done.choices[0].message.content == CHAT["choices"][0]["message"]["content"]
        with pytest.raises(openai.BadRequestError, match="redacted"):
            create(
                model="m", messages=[], extra_headers=told,
                response_format={"type": "json_schema", "json_schema": {"name": "a", "schema": {}}},
            )  # fmt: skip
        sdk.images.edit(model="i", image=[b"one", b"two"], prompt="p", extra_headers=told)
    assert [(e.question, e.model, e.outcome) for e in shared.account.entries] == [
        ("list_objects", "m", "answered"),
        ("list_objects", "m", "failed"),
        ("list_objects", "i", "answered"),
    ]
    assert b"multipart" not in server.asked[2].body and b"one" in server.asked[2].body
