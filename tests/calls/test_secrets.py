"""A key sent to a server that repeats it everywhere does not leak."""

import logging
import traceback
from pathlib import Path
from typing import Any

import httpx2
import openai
import pytest
from leaks import chain, everything
from paid_server import CHAT, KEY, PRICES, Asked, Says, ask, serving, session

from generator.calls.store import CallStore
from generator.errors import BackendError

ECHO = {"error": {"message": f"Incorrect API key provided: {KEY}", "code": "invalid_api_key"}}


def held(error: BaseException) -> str:
    """Return the content of an SDK error's log, and everything reachable from the package's
    error."""
    texts = ["".join(traceback.format_exception(error))]
    for link in chain(error):
        if isinstance(link, BackendError):
            texts += [repr(link), str(vars(link)), repr(link.__cause__), repr(link.__context__)]
        texts.append(str(getattr(link, "body", "")))
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


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.parametrize(
    "says",
    [
        lambda body: Says(body, status=500, kind="text/plain"),
        lambda body: Says(body, kind="text/html"),
        lambda body: Says(b'{"' + body),
        lambda body: Says({"error": {"message": body.decode(), "code": 500}}),
    ],
)
def test_a_key_that_a_quote_would_cut_in_two_is_found_all_the_same(says: Any) -> None:
    key = "gateway.7Fq2ZxLmN0pQrStUvWxYz123456789abcdef"
    for before in range(210, 300, 10):
        body = b"x" * before + b" " + key.encode()
        shared = session(attempts=1)
        with serving([says(body)]) as server, pytest.raises(BackendError) as caught:
            ask(shared, server.url, secrets=(key,))
        assert "gateway.7" not in str(caught.value)


def test_the_search_can_fail() -> None:
    error = BackendError("wrapped")
    error.__context__ = ValueError(KEY)
    assert KEY in everything(error)
    error.__cause__ = ValueError("beside")  # hides the context from a printed traceback
    assert KEY in everything(error)
    request = httpx2.Request("GET", "http://h", headers={"authorization": f"Bearer {KEY}"})
    assert KEY not in repr(request.headers)
    error = BackendError("wrapped")
    error.__context__ = httpx2.ReadError("broken", request=request)
    assert KEY in everything(error)


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


def test_what_the_environment_adds_is_not_sent(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OPENAI_ORG_ID", "org-private")
    monkeypatch.setenv("OPENAI_PROJECT_ID", "project-private")
    monkeypatch.setenv("OPENAI_CUSTOM_HEADERS", "Helicone-Auth: Bearer other\nCookie: c=1")
    sent = []
    with serving([Says()]) as server:
        for more in ((), ("openai-organization",)):
            with session().client("cloud", server.url, headers=more) as client:
                sdk = openai.OpenAI(api_key=KEY, base_url=server.url, http_client=client)
                sdk.chat.completions.create(model="m", messages=[])
            sent.append(server.asked[-1].headers)
    assert "org-private" not in str(sent[0]) and sent[1]["openai-organization"] == "org-private"
    for headers in sent:
        assert headers["authorization"] == f"Bearer {KEY}"
        assert not {"helicone-auth", "cookie", "openai-project"} & set(headers)
        assert not [name for name in headers if name.startswith("x-")]


def test_another_key_than_the_one_given_is_not_sent() -> None:
    with serving([Says()]) as server, session().client("s", server.url, secrets=(KEY,)) as client:
        client.get("/a", headers=[("authorization", f"Bearer {KEY}"), ("authorization", "other")])
        client.get("/b", headers={"authorization": "Bearer other"})
    assert [a.headers.get("authorization") for a in server.asked] == [f"Bearer {KEY}", None]


@pytest.mark.parametrize(
    ("url", "open_"),
    [
        ("http://gpu.example/v1", True),
        ("http://93.184.216.34/v1", True),
        ("https://gpu.example/v1", False),
        ("http://127.0.0.1:1/v1", False),
        ("http://192.168.1.9:8000", False),
        ("http://gpu-box:8000", False),
        ("http://gpu.local:8000", False),
    ],
)
def test_a_key_that_goes_over_the_net_unencrypted_is_warned_of_once(
    url: str, open_: bool, caplog: pytest.LogCaptureFixture
) -> None:
    shared = session()
    for _ in range(2):
        shared.client("cloud", url, secrets=(KEY,)).close()
    assert [("unencrypted" in note) for note in shared.account.notes] == [True] * open_
    assert len(caplog.records) == open_
    shared.client("maker", url).close()  # no key
    assert len(shared.account.notes) == open_
