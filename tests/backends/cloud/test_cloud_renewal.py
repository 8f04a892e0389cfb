"""Caching of invalid answers: none are cached if they ended the question, else all."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from backends.modelers.server import Answer, serving
from desk import VIEW, detections, instances, reference
from openai_server import IMAGES, Request, Running

from generator.backends.cloud.imager import REDRAWS, CloudImager
from generator.backends.cloud.reasoner import CloudReasoner
from generator.backends.embedded.imager import EmbeddedImager as EmbeddedImager
from generator.calls.http.retries import RetryPolicy
from generator.calls.money.prices import Price, Prices
from generator.calls.session import Session
from generator.calls.store import CallStore
from generator.errors import BackendError, BudgetError, DryRunError, UnusableError
from generator.io.pictures import encode_png
from generator.scene import PlannedObject, PlannedTable, ScenePlan, TopView

KINDS = json.dumps({"kinds": [{"noun": "mug", "count": 1}]})
NOUNS = ("table", "mug")
Ask = Callable[..., tuple[str, ...]]


def keeping(folder: Path, **settings: object) -> Session:
    """A session of a separate run with responses cached in ``folder``."""
    quick = RetryPolicy(first=0.01, longest=0.02, rest=0.05)
    return Session(**{"store": CallStore(folder), "retry_policy": quick, "attempts": 2, **settings})


@pytest.fixture
def ask(server: Running, tmp_path: Path) -> Ask:
    """Ask one question in a separate run."""
    return lambda **settings: CloudReasoner(session=keeping(tmp_path, **settings)).list_objects(
        reference()
    )


def said(content: str, end: str = "stop", refusal: str | None = None) -> dict:
    message = {"role": "assistant", "content": content, "refusal": refusal}
    return {"message": message, "finish_reason": end}


# --------------------------------------------------------------------------------- chat answers
@pytest.mark.slow
@pytest.mark.parametrize(
    "bad",
    [
        "nonsense",
        "I'm sorry, I can't help with that.",
        said("", refusal="No."),
        said("{", "length"),
        said("", "content_filter"),
    ],
    ids=["nonsense", "refusal", "refused by field", "length", "content_filter"],
)
def test_a_server_that_recovers_is_asked_again(server: Running, ask: Ask, bad: object) -> None:
    server.script.chat = lambda request: bad
    with pytest.raises(UnusableError):
        ask()
    calls = len(server.script.requests)
    server.script.chat = lambda request: KINDS
    assert ask() == NOUNS
    assert len(server.script.requests) == calls + 1
    assert ask() == NOUNS
    assert len(server.script.requests) == calls + 1


@pytest.mark.slow
@pytest.mark.parametrize(
    "first",
    [
        Answer(200, b"Service is starting", "text/plain"),
        Answer(200, b"", "application/json"),
        Answer.of("hello"),
        Answer.of({}),
        Answer.of({"choices": []}),
    ],
    ids=["text", "nothing", "a string", "an empty object", "no choice"],
)
def test_what_is_no_chat_completion_is_not_kept(
    ask: Ask, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, first: Answer
) -> None:
    answers = [first, Answer.of({"choices": [said(KINDS)]})]
    with serving(lambda call: answers[min(len(served.calls), 2) - 1]) as served:
        monkeypatch.setenv("TABLETOPGEN_CLOUD_BASE_URL", f"{served.url}/v1")
        with pytest.raises(UnusableError):
            ask()
        assert len(CallStore(tmp_path)) == 0
        assert ask() == NOUNS


def test_what_was_asked_again_and_ended_well_is_replayed(server: Running, ask: Ask) -> None:
    server.script.chat = lambda request: ["nonsense", KINDS][len(server.script.requests) - 1]
    assert ask() == NOUNS
    server.stop()
    assert ask(dry=True) == NOUNS


def test_what_a_call_that_failed_broke_off_goes_on(server: Running, ask: Ask) -> None:
    """The earlier answers were paid for: a resumed run does not pay for them again."""

    def nonsense(request: Request) -> str:
        server.script.failures.extend(["500"] * 2)
        return "nonsense"

    server.script.chat = nonsense
    with pytest.raises(BackendError, match="status 500"):
        ask()
    calls = len(server.script.requests)
    server.script.chat = lambda request: KINDS
    assert ask() == NOUNS
    assert len(server.script.requests) == calls + 1
    assert "nonsense" in str(server.script.requests[-1].body["messages"])


def test_money_spent_on_answers_that_were_dropped_is_in_the_ledger(
    server: Running, tmp_path: Path
) -> None:
    server.script.chat = lambda request: "nonsense"
    session = keeping(tmp_path)
    with pytest.raises(UnusableError):
        CloudReasoner(session=session).list_objects(reference())
    entries = session.account.entries
    assert [(e.outcome, e.tokens_in) for e in entries] == [("answered", 100)] * 4


@pytest.mark.parametrize(
    ("forms", "knows_seed", "calls"), [(("json_object",), True, 2), ((), False, 4)]
)
def test_a_form_that_was_rejected_needs_no_call_again(
    server: Running, ask: Ask, forms: tuple[str, ...], knows_seed: bool, calls: int
) -> None:
    server.script.chat = lambda request: KINDS
    server.script.forms, server.script.knows_seed = forms, knows_seed
    assert ask() == NOUNS
    assert len(server.script.requests) == calls
    server.stop()
    assert ask(dry=True) == NOUNS


def test_a_new_question_tries_the_forms_anew(
    server: Running, ask: Ask, reasoner: CloudReasoner
) -> None:
    server.script.chat = lambda request: KINDS
    server.script.forms = ()
    ask()
    server.script.forms = ("json_schema",)
    reasoner.list_objects(replace(reference(), prompt="another"))
    assert server.script.requests[-1].body["response_format"]["type"] == "json_schema"


# --------------------------------------------------------------------------------------- drawings
def complete(folder: Path, **settings: object) -> str:
    imager = CloudImager(session=keeping(folder, **settings))
    return imager.complete(reference(), detections()["pen_1"], ()).label


def unfit(request: Request) -> np.ndarray:
    return np.full((256, 256, 3), 200, np.uint8)


def fit(request: Request) -> np.ndarray:
    return request.body["images"][0]


@pytest.mark.slow
@pytest.mark.parametrize("address", ["", "/out/latest.png"])
def test_a_thing_that_was_never_drawn_is_drawn_by_the_next_run(
    server: Running, tmp_path: Path, address: str
) -> None:
    server.script.urls, server.script.address = bool(address), address
    server.script.paint = unfit
    with pytest.raises(UnusableError, match="3 drawings"):
        complete(tmp_path)
    server.script.paint = fit
    assert complete(tmp_path) == "pen"
    assert len(server.script.asked("edits")) == 1 + REDRAWS + 1


@pytest.mark.slow
def test_a_drawing_that_was_made_again_is_replayed(server: Running, tmp_path: Path) -> None:
    server.script.paint = lambda r: (unfit if len(server.script.requests) == 1 else fit)(r)
    assert complete(tmp_path) == "pen"
    server.stop()
    assert complete(tmp_path, dry=True) == "pen"


@pytest.mark.slow
def test_options_that_were_rejected_need_no_call_again(server: Running, tmp_path: Path) -> None:
    server.script.unknown = {"mask", "background"}
    server.script.paint = fit
    assert complete(tmp_path) == "pen"
    server.stop()
    assert complete(tmp_path, dry=True) == "pen"


def plan(text: str) -> ScenePlan:
    return ScenePlan(text, PlannedTable(), (PlannedObject("a_1", text, text),), "plain")


@pytest.mark.parametrize("first", ["good", "no picture"])
def test_one_address_for_every_drawing_gives_each_its_own(
    server: Running, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, first: str
) -> None:
    """Some servers return the same address, such as /out/latest.png, for every generation."""
    drawn: list[int] = []

    def answer(call) -> Answer:
        if call.method == "POST":
            drawn.append(40 * (len(drawn) + 1))
            return Answer.of({"data": [{"url": f"http://{call.headers['host']}/latest.png"}]})
        if first != "good" and len(drawn) == 1:
            return Answer(200, b"not yet", "image/png")
        picture = np.full((200, 256, 3), (drawn[-1], 0, 0), np.uint8)
        return Answer(200, encode_png(picture), "image/png")

    with serving(answer) as served:
        for _ in range(2):
            imager = CloudImager(f"{served.url}/v1", "seedream-x", session=keeping(tmp_path))
            reds = [int(imager.draw(plan(text), 0)[0, 0, 0]) for text in ("mug", "bowl")]
            assert reds == ([40, 80] if first == "good" else [80, 120])


# --------------------------------------------------------------------------------------- top view
VIEWED = json.dumps(
    {
        "from_above": True,
        "things": [
            {"id": n, "boxes": [[100 * n, 0, 100 * n + 90, 90]], "covered": False}
            for n in (1, 2, 3)
        ],
        "extra": [],
    }
)


@pytest.fixture
def geometry(monkeypatch: pytest.MonkeyPatch) -> None:
    """A fast geometric top view."""
    made = TopView(np.zeros((4, 6, 3), np.uint8), np.array([0, 0, 6, 4.0]), {})
    monkeypatch.setattr(EmbeddedImager, "top_view", lambda *known: made)


def top_view(session: Session) -> tuple[str, ...]:
    imager = CloudImager(session=session, fallback=EmbeddedImager())
    return imager.top_view(reference(), instances(), {}, {}, VIEW).warnings


@pytest.mark.slow
@pytest.mark.parametrize(
    ("failure", "page", "check", "why"),
    [
        ("moderation", False, VIEWED, "the model refuses"),
        ("html", False, VIEWED, "HTML page"),
        ("", True, VIEWED, "the picture is HTML"),
        ("", False, "no idea", "4 answers could not be used"),
        ("", False, "I'm sorry, I can't help with that.", "the model refuses"),
    ],
    ids=["refused", "a page", "a page as picture", "nonsense check", "refused check"],
)
def test_geometry_stands_in_for_a_top_view_that_cannot_be_had(
    server: Running, geometry: None, tmp_path: Path, failure: str, page: bool, check: str, why: str
) -> None:
    server.script.paint = lambda request: b"<html>hi</html>" if page else unfit(request)
    server.script.chat = lambda request: check
    server.script.failures.extend([failure] if failure else [])
    (warning,) = top_view(keeping(tmp_path))
    assert "rendered from geometry" in warning and why in warning
    server.script.paint, server.script.chat = unfit, lambda request: VIEWED
    assert top_view(keeping(tmp_path)) == ()  # and the next run has another try


def test_what_more_than_geometry_can_mend_ends_the_scene(
    server: Running, geometry: None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    server.script.paint, server.script.chat = unfit, lambda request: VIEWED
    with pytest.raises(DryRunError):
        top_view(keeping(tmp_path, dry=True))
    with pytest.raises(BudgetError):
        top_view(keeping(tmp_path, budget=0.1, prices=Prices(models={IMAGES: Price(image=1.0)})))
    server.script.failures.extend(["500"] * 2)
    with pytest.raises(BackendError, match="status 500"):
        top_view(keeping(tmp_path))
    monkeypatch.setenv("TABLETOPGEN_CLOUD_KEY", "another-key-0123")
    with pytest.raises(BackendError, match="Check the key"):
        top_view(keeping(tmp_path))
    monkeypatch.setenv("TABLETOPGEN_CLOUD_KEY", "")
    with pytest.raises(BackendError, match="top_view: no key"):
        top = CloudImager("https://gpu.example", session=keeping(tmp_path))
        top.top_view(reference(), instances(), {}, {}, VIEW)
    stopped = keeping(tmp_path)
    stopped.stop.set()
    with pytest.raises(BackendError, match="Stopped"):
        top_view(stopped)
