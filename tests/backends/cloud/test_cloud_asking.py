"""One question over HTTP: fallback formats, retries, refusals, and failing servers."""

import json
from dataclasses import replace
from typing import Any

import httpx2
import numpy as np
import openai
import pytest
from desk import reference
from leaks import everything
from openai_server import KEY, Request, Running, from_uri, pixels

from generator.backends.cloud.reasoner import CloudReasoner
from generator.backends.cloud.server import client, configuration
from generator.backends.cloud.server.typed_question import ANSWER, REASKS
from generator.calls.money.prices import Price, Prices
from generator.calls.session import Session
from generator.calls.store import CallStore, Used
from generator.errors import BackendError, BudgetError, DryRunError

KINDS = json.dumps({"kinds": [{"noun": "Mug", "count": 2}, {"noun": "table", "count": 1}]})
NOUNS = ("table", "mug", "mug")


@pytest.fixture(autouse=True)
def answered(server: Running) -> None:
    """The server lists the objects by default."""
    server.script.chat = lambda request: KINDS


def forms(server: Running) -> list[str | None]:
    bodies = [r.body for r in server.script.asked("completions")]
    return [b["response_format"]["type"] if "response_format" in b else None for b in bodies]


def test_a_strict_schema_is_asked_for_first(server: Running, reasoner: CloudReasoner) -> None:
    assert reasoner.list_objects(reference()) == NOUNS
    (request,) = server.script.asked("completions")
    assert request.body["response_format"]["json_schema"]["strict"] is True
    assert request.body["model"] == reasoner.model
    assert not any(name.lower().startswith("x-tabletopgen") for name in request.headers)


def test_the_forms_a_server_knows_are_learned_once(
    server: Running, reasoner: CloudReasoner
) -> None:
    server.script.chat = lambda request: f"Sure!\n```json\n{KINDS}\n```"
    server.script.forms = ()
    assert reasoner.list_objects(reference()) == NOUNS
    assert forms(server) == ["json_schema", "json_object", None]
    assert reasoner.list_objects(replace(reference(), prompt="again")) == NOUNS
    assert forms(server)[3:] == [None]


def test_json_objects_are_enough(server: Running, reasoner: CloudReasoner) -> None:
    server.script.forms = ("json_object",)
    assert reasoner.list_objects(reference()) == NOUNS
    assert forms(server) == ["json_schema", "json_object"]


def test_a_server_that_takes_no_seed_gets_none(server: Running, reasoner: CloudReasoner) -> None:
    server.script.knows_seed = False
    assert reasoner.list_objects(reference()) == NOUNS
    assert forms(server) == ["json_schema", "json_schema"]
    assert ["seed" in r.body for r in server.script.requests] == [True, False]


@pytest.mark.parametrize("known", [("max_completion_tokens",), ("max_tokens",), ()])
def test_an_answer_has_a_bound_in_the_form_that_the_server_takes(
    server: Running, reasoner: CloudReasoner, known: tuple[str, ...]
) -> None:
    server.script.bounds = known
    for prompt in ("", "again"):
        assert reasoner.list_objects(replace(reference(), prompt=prompt)) == NOUNS
    told = [
        {k: v for k, v in r.body.items() if k.startswith("max")} for r in server.script.requests
    ]
    assert told[-1] == dict.fromkeys(known, ANSWER)
    tries = {"max_completion_tokens": 1, "max_tokens": 2}.get("".join(known), 3)
    assert len(told) == tries + 1, "learned once"


def test_what_an_answer_may_cost_is_bounded(reasoner: CloudReasoner) -> None:
    prices = Prices(models={reasoner.model: Price(output=1e6)})
    dry = replace(reasoner, session=Session(dry=True, prices=prices))
    with pytest.raises(DryRunError, match=f"at most {ANSWER}.0000 USD"):
        dry.list_objects(reference())


def test_a_wrong_answer_is_asked_again_with_what_is_wrong(
    server: Running, reasoner: CloudReasoner
) -> None:
    said = ['{"kinds": [{"noun": "mug", "count": 0}]}', "Two mugs.", KINDS]

    def chat(request: Request) -> str:
        return said[len(server.script.requests) - 1]

    server.script.chat = chat
    assert reasoner.list_objects(reference()) == NOUNS
    last = server.script.requests[-1].body["messages"]
    assert [m["role"] for m in last] == ["user", "assistant", "user", "assistant", "user"]
    assert last[1]["content"] == said[0]
    assert "kinds.0.count" in last[2]["content"]
    assert "greater than or equal to 1" in last[2]["content"]
    assert "no valid JSON object" in last[4]["content"]


@pytest.mark.parametrize(
    ("said", "told", "requests"),
    [
        ('{"kinds": []}', "4 answers could not be used", 1 + REASKS),
        ({"message": {"content": None, "refusal": "I will not."}, "finish_reason": "stop"},
         "the model refuses: .*I will not", 1),
        ({"message": {"content": "I will not."}, "finish_reason": "content_filter"},
         "the model refuses: .*I will not", 1),
        ("I'm sorry, I can't assist. I will not.", "the model refuses: .*I will not", 1),
        ({"message": {"content": KINDS[:9]}, "finish_reason": "length"}, ".*token limit", None),
    ],
    ids=["after so many answers", "refused by field", "filtered", "refused in words", "cut off"],
)  # fmt: skip
def test_what_cannot_be_used_is_given_up(
    server: Running, reasoner: CloudReasoner, said: object, told: str, requests: int | None
) -> None:
    server.script.chat = lambda request: said
    with pytest.raises(BackendError, match=f"list_objects failed: {told}"):
        reasoner.list_objects(reference())
    assert requests is None or len(server.script.requests) == requests


def test_content_in_parts_is_joined(server: Running, reasoner: CloudReasoner) -> None:
    parts = [{"type": "text", "text": KINDS[:9]}, {"type": "text", "text": KINDS[9:]}]
    server.script.chat = lambda r: {"message": {"content": parts}, "finish_reason": "stop"}
    assert reasoner.list_objects(reference()) == NOUNS


@pytest.mark.parametrize(
    "failures", [["429"], ["500", "429"], ["truncated"], ["wrong json"], ["error in 200"]]
)
def test_what_passes_is_waited_for(
    server: Running, reasoner: CloudReasoner, failures: list[str]
) -> None:
    server.script.failures.extend(failures)
    assert reasoner.list_objects(reference()) == NOUNS
    assert len(server.script.requests) == 1 + len(failures)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("failures", "message"),
    [
        (["500"] * 9, "status 500"),
        (["429"] * 9, "status 429"),
        (["html"] * 9, "HTML"),
        (["words"], r"no JSON \('All is well\.'\)\. Check that http.*the address of the API"),
        (["list"], r"not a JSON object: '\[1, 2\]'"),
        (["empty"] * 9, "not a chat completion"),
        (["error in 200"] * 9, "upstream is busy"),
    ],
)
def test_a_server_that_fails_is_named(
    server: Running, reasoner: CloudReasoner, failures: list[str], message: str
) -> None:
    server.script.failures.extend(failures)
    with pytest.raises(BackendError, match=message) as caught:
        reasoner.list_objects(reference())
    assert "cloud" in str(caught.value)
    assert "list_objects" in str(caught.value)
    assert KEY not in everything(caught.value)


def test_a_dead_server_is_named(server: Running, reasoner: CloudReasoner) -> None:
    server.stop()
    with pytest.raises(BackendError, match=r"cloud/127.0.0.1:\d+, list_objects") as caught:
        reasoner.list_objects(reference())
    assert KEY not in everything(caught.value)


@pytest.mark.slow
def test_a_server_that_hangs_is_not_waited_for_for_ever(
    server: Running, reasoner: CloudReasoner, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(client._TIMEOUT, "chat", 0.3)
    server.script.hang = 1.0
    server.script.failures.extend(["hang"] * 9)
    once = replace(reasoner, session=Session(attempts=1))
    with pytest.raises(BackendError, match=r"list_objects.*did not respond within 0.3 s"):
        once.list_objects(reference())


REQUEST = httpx2.Request("POST", "http://127.0.0.1/v1/chat/completions")
NO_CONNECTION = openai.APIConnectionError(request=REQUEST)


@pytest.mark.parametrize(
    ("error", "cause", "told"),
    [
        (NO_CONNECTION, BudgetError("over the budget of 1"), r"^over the budget of 1$"),
        (NO_CONNECTION, httpx2.ReadError(f"reset, {KEY}"),
         r"no response from http.*ReadError: reset, \[redacted\]"),
        (NO_CONNECTION, None, "no response from http.*Connection error"),
        (openai.OpenAIError("the header is too long"), None,
         "list_objects failed: the header is too long"),
    ],
    ids=("the session's own", "another", "none", "no failure of the connection"),
)  # fmt: skip
def test_what_the_sdk_finds_wrong_is_told(
    reasoner: CloudReasoner, error: Exception, cause: Exception | None, told: str
) -> None:
    """Depending on its version, the SDK wraps errors of the session as connection errors."""

    def ask(*_: Any) -> None:
        raise error from cause

    with pytest.raises(BackendError, match=told):
        reasoner.chat.server.call("list_objects", ask, Used(None), "meant")


def test_an_unknown_model_is_named(server: Running, session: Session) -> None:
    with pytest.raises(
        BackendError, match=r"has the model 'nosuch', or set TABLETOPGEN_CLOUD_CHAT"
    ):
        CloudReasoner(model="nosuch", session=session).list_objects(reference())


def test_a_wrong_key_is_not_repeated(
    reasoner: CloudReasoner, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TABLETOPGEN_CLOUD_KEY", "wrong-key-987654321")
    with pytest.raises(BackendError, match="Check the key in TABLETOPGEN_CLOUD_KEY") as caught:
        reasoner.list_objects(reference())
    assert "wrong-key-987654321" not in everything(caught.value)


def test_the_key_is_in_no_message_and_no_file(
    server: Running, reasoner: CloudReasoner, tmp_path, monkeypatch: pytest.MonkeyPatch
) -> None:
    server.script.chat = lambda request: f"I cannot; your key is {KEY}"
    kept = Session(store=CallStore(tmp_path))
    with pytest.raises(BackendError) as caught:
        replace(reasoner, session=kept).list_objects(reference())
    assert KEY not in everything(caught.value, frames=False) + repr(reasoner)
    twice = {"kinds": [{"noun": KEY, "count": 1}] * 2}
    server.script.chat = lambda request: json.dumps(twice)
    with pytest.raises(BackendError, match="listed twice") as caught:
        reasoner.list_objects(reference())
    assert KEY not in everything(caught.value, frames=False)
    server.script.chat = lambda request: KINDS
    replace(reasoner, session=kept, seed=1).list_objects(reference())
    assert not [p for p in tmp_path.rglob("*") if p.is_file() and b"Bearer" in p.read_bytes()]


@pytest.mark.parametrize("name", ["Authorization", "authorization"])
def test_the_key_is_ours_whatever_the_environment_says(
    server: Running, reasoner: CloudReasoner, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    added = f"{name}: Bearer sk-gateway-secret-999\nHelicone-Auth: Bearer sk-helicone-777777"
    monkeypatch.setenv("OPENAI_CUSTOM_HEADERS", added)
    monkeypatch.setenv("OPENAI_ORG_ID", "org-private")
    monkeypatch.setenv("OPENAI_PROJECT_ID", "proj-private")
    assert reasoner.list_objects(reference()) == NOUNS
    sent = {k.lower(): v for k, v in server.script.requests[0].headers.items()}
    assert sent["authorization"] == f"Bearer {KEY}"
    assert not {"helicone-auth", "openai-organization", "openai-project"} & set(sent)


def test_who_asks_is_told_to_openai_alone() -> None:
    own = configuration.own_headers(configuration.OPENAI)
    assert set(own) == {"openai-organization", "openai-project"}
    assert configuration.own_headers("https://api.openai.com.evil.example/v1") == ()


def test_a_key_that_a_message_cuts_off_is_in_no_part_of_it(
    server: Running, reasoner: CloudReasoner
) -> None:
    for room in range(250, 330, 4):
        told = reasoner.chat.server.quote("x" * room + f" {KEY} " + "y" * 300)
        assert KEY[:6] not in told


def test_an_answer_that_is_kept_is_not_asked_for_again(
    server: Running, reasoner: CloudReasoner, tmp_path
) -> None:
    for _ in range(2):
        kept = Session(store=CallStore(tmp_path))
        assert replace(reasoner, session=kept).list_objects(reference()) == NOUNS
    assert len(server.script.requests) == 1


def test_a_dry_run_sends_nothing(server: Running, reasoner: CloudReasoner) -> None:
    with pytest.raises(DryRunError, match="list_objects"):
        replace(reasoner, session=Session(dry=True)).list_objects(reference())
    assert not server.script.requests


def test_pictures_are_shown_as_they_are(server: Running, reasoner: CloudReasoner) -> None:
    reasoner.list_objects(reference())
    content = server.script.requests[0].body["messages"][0]["content"]
    (url,) = [p["image_url"]["url"] for p in content if p["type"] == "image_url"]
    np.testing.assert_array_equal(pixels(from_uri(url)), reference().image)
