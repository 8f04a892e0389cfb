"""Paid calls over real HTTP: cached, retried, bounded, and refused with a reason."""

import email.utils
import gzip
import os
import sys
import time
import traceback
from pathlib import Path
from typing import Any

import httpx2
import pytest
from bounded import running, until
from paid_server import CHAT, KEY, Asked, Says, ask, serving, session

from generator.calls import Session
from generator.calls.http.retries import RetryPolicy
from generator.calls.money.budget import SharedBudget
from generator.calls.money.ledger import Account
from generator.calls.money.prices import Price, Prices
from generator.calls.store import CallStore, Used
from generator.errors import BackendError, BudgetError, DryRunError, UnusableError


def outcomes(shared: Any) -> list[str]:
    return [entry.outcome for entry in shared.account.entries]


def test_an_answer_is_entered_with_its_tokens_and_money() -> None:
    shared = session()
    with serving([Says()]) as server:
        assert ask(shared, server.url).json() == CHAT
    (entry,) = shared.account.entries
    assert (entry.server, entry.question, entry.model) == ("cloud", "plan_scene", "m")
    assert (entry.tokens_in, entry.tokens_out) == (1_000, 2_000)
    assert entry.money == pytest.approx(0.021)
    assert entry.seconds > 0


def test_the_headers_that_say_what_for_are_not_sent() -> None:
    with serving([Says()]) as server:
        ask(session(), server.url)
    (asked,) = server.asked
    assert asked.headers["authorization"] == f"Bearer {KEY}"
    assert not [name for name in asked.headers if "tabletopgen-" in name]


def test_images_are_counted_and_paid_for() -> None:
    shared = session()
    with serving([Says({"data": [{"b64_json": "AAAA"}, {"url": "http://x/y.png"}]})]) as server:
        ask(shared, server.url, model="i", question="draw")
    (entry,) = shared.account.entries
    assert (entry.images, entry.money) == (2, 1.0)


def test_a_kept_answer_is_not_paid_for_again(tmp_path: Path) -> None:
    with serving([Says(), Says({"other": 1})]) as server:
        first, second = session(store=CallStore(tmp_path)), session(store=CallStore(tmp_path))
        a = ask(first, server.url)
        b = ask(second, server.url)
        assert (a.json(), a.headers, a.status_code) == (b.json(), b.headers, b.status_code)
        assert len(server.asked) == 1
        assert outcomes(first) == ["answered"] and outcomes(second) == ["cached"]
        assert second.account.money == 0.0
        assert ask(second, server.url, "something else").json() == {"other": 1}


def test_another_key_is_no_other_question(tmp_path: Path) -> None:
    shared = session(store=CallStore(tmp_path))
    with (
        serving([Says()]) as server,
        shared.client("cloud", server.url, secrets=("one", "two")) as client,
    ):
        for key in ("one", "two"):
            client.post("/v1", json={"a": 1}, headers={"authorization": f"Bearer {key}"})
        assert len(server.asked) == 1


def test_a_form_is_the_same_whatever_its_boundary(tmp_path: Path) -> None:
    shared = session(store=CallStore(tmp_path))
    with serving([Says()]) as server, shared.client("cloud", server.url) as client:
        for picture in (b"one", b"one", b"two"):
            client.post("/v1", data={"prompt": "p", "n": "1"}, files={"image": picture})
    bodies = [asked.body for asked in server.asked]
    assert len(bodies) == 2
    assert b"one" in bodies[0] and b"two" in bodies[1]


def test_what_changes_is_not_kept_and_what_is_of_no_use_is_renewed(tmp_path: Path) -> None:
    shared = session(store=CallStore(tmp_path))
    with serving(lambda asked, k: Says({"k": k})) as server:
        polls = [ask(shared, server.url, memo="no").json()["k"] for _ in range(2)]
        jobs = [ask(shared, server.url, memo=m).json()["k"] for m in (None, None, "renew", None)]
        assert polls == [0, 1]
        assert jobs == [2, 2, 3, 3]
        with pytest.raises(BackendError, match="Did you mean 'renew'"):
            ask(shared, server.url, memo="renw")


@pytest.mark.parametrize(
    "told", [{"error": {"code": 400}}, {"error": "x"}, {"Response": {"Error": {"C": 1}}}]
)
def test_an_error_told_with_status_200_is_not_kept(tmp_path: Path, told: dict) -> None:
    shared = session(store=CallStore(tmp_path))
    with serving([Says(told), Says()]) as server:
        assert ask(shared, server.url).json() == told
        assert ask(shared, server.url).json() == CHAT
    assert outcomes(shared) == ["failed", "answered"]


def test_requests_that_mean_the_same_have_one_answer(tmp_path: Path) -> None:
    shared = session(store=CallStore(tmp_path))

    def told(body: dict, meant: str, path: str = "/v1") -> int:
        headers = {"x-tabletopgen-meant": meant}
        with shared.client("cloud", server.url) as client:
            return client.post(path, json=body, headers=headers).json()["k"]

    with serving(lambda asked, k: Says({"k": k})) as server:
        assert [told({"a": 1}, "x"), told({"b": 2}, "x"), told({"a": 1}, "y")] == [0, 0, 1]
        assert told({"a": 1}, "x", "/v2") == 2
    assert not any("x-tabletopgen-meant" in asked.headers for asked in server.asked)


def test_an_attempt_is_signed_anew() -> None:
    signed = iter(["first", "second", "third"])
    with (
        serving([Says(status=503), Says()]) as server,
        session().client("cloud", server.url, sign=lambda r: {"x-stamp": next(signed)}) as client,
    ):
        assert client.post("/v1", json={}).json() == CHAT
    assert [asked.headers["x-stamp"] for asked in server.asked] == ["first", "second"]


def test_an_answer_that_broke_off_in_an_error_is_paid_for_as_far_as_it_came() -> None:
    shared = session(attempts=1)
    told = {"choices": [], "usage": CHAT["usage"], "error": {"message": "upstream went away"}}
    with serving([Says(body=told), Says(body={"error": {"message": "busy"}})]) as server:
        for text in "ab":
            ask(shared, server.url, text)
    assert [entry.outcome for entry in shared.account.entries] == ["failed", "failed"]
    assert [entry.money for entry in shared.account.entries] == [pytest.approx(0.021), 0.0]


def test_a_fault_of_the_program_is_entered_and_holds_no_key(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def fault(*given: Any) -> None:
        raise RuntimeError(f"{given[1].headers}")

    monkeypatch.setattr("generator.calls.transport.exchange", fault)
    shared = session()
    with serving([Says()]) as server, pytest.raises(BackendError, match="RuntimeError") as caught:
        ask(shared, server.url)
    assert str(caught.value).startswith("cloud, plan_scene (m): the call was aborted")
    assert KEY not in "".join(traceback.format_exception(caught.value))
    (entry,) = shared.account.entries
    assert entry.outcome == "failed" and (entry.money or 0.0) > 0.02


def test_a_code_of_any_length_is_read() -> None:
    told = {"error": {"code": "9" * 5000}}
    with serving([Says(body=told)]) as server:
        assert ask(session(), server.url).status_code == 200


def test_what_cannot_be_signed_costs_nothing(tmp_path: Path) -> None:
    def sign(request: httpx2.Request) -> dict[str, str]:
        raise OSError("no clock")

    shared_budget = SharedBudget.open(tmp_path, "USD")
    with serving([Says()]) as server, shared_budget.spending() as spender:
        shared = session(
            budget=1.0, account=Account(spender), prices=Prices(models={"m": Price(call=0.5)})
        )
        with pytest.raises(OSError, match="no clock"):
            ask(shared, server.url, sign=sign)
        assert server.asked == []
    assert shared.account.money == shared_budget.total().money == 0.0
    assert shared_budget.total().held == 0.0


def test_answers_of_no_use_are_dropped(tmp_path: Path) -> None:
    store = CallStore(tmp_path)
    shared = session(store=store)
    with serving([Says()]) as server:
        used, other = Used(store), Used(store)
        for text in ("one", "two", "three"):
            used.add(ask(shared, server.url, text).headers)
        other.add(ask(shared, server.url, "other").headers)
        used.drop(last=True)
        assert len(store) == 3
        with pytest.raises(BackendError), used.dropped_on(UnusableError):
            raise BackendError("no answer came")
        assert len(store) == 3
        with pytest.raises(UnusableError), used.dropped_on(UnusableError):
            raise UnusableError("nonsense came")
    assert len(store) == 1 and store.get(other.keys[0]) is not None
    assert shared.account.money == pytest.approx(4 * 0.021)


@pytest.mark.slow
@pytest.mark.parametrize(
    "first",
    [
        Says({"error": {"message": "upstream", "code": 502}}),
        Says({"error": {"message": "upstream", "code": "429"}}),
        Says(status=429),
        Says(status=500),
        Says(status=503, body=b"<html>busy</html>", kind="text/html"),
        Says(hang_up=True),
        Says(cut=5),
        Says(b'{"choices": [', kind="application/json"),
    ],
    ids=[
        "502 in 200", "429 in 200", "429", "500", "503 as HTML", "reset", "truncated",
        "half JSON",
    ],
)  # fmt: skip
def test_what_may_pass_is_tried_again(first: Says) -> None:
    shared = session()
    with serving([first, first, Says()]) as server:
        assert ask(shared, server.url).json() == CHAT
        assert len(server.asked) == 3
    assert outcomes(shared) == ["failed", "failed", "answered"]


def test_an_answer_that_broke_off_counts_with_the_most_it_can_have_cost() -> None:
    shared = session()
    with serving([Says(cut=5), Says(status=500), Says()]) as server:
        ask(shared, server.url)
    broken, refused, whole = shared.account.entries
    assert broken.money is not None and 0.04 < broken.money < 0.041
    assert refused.money == 0.0
    assert whole.money == pytest.approx(0.021)


@pytest.mark.slow
@pytest.mark.parametrize("dated", [False, True])
def test_a_server_that_says_how_long_to_wait_is_obeyed(dated: bool) -> None:
    wait = email.utils.formatdate(time.time() + 2, usegmt=True) if dated else "0.3"
    with serving([Says(status=429, headers=(("retry-after", wait),)), Says()]) as server:
        began = time.monotonic()
        ask(session(), server.url)
        assert time.monotonic() - began >= 0.3
        assert len(server.asked) == 2


ZIPPED = Says(
    gzip.compress(bytes(200_000)), headers=(("content-encoding", "gzip"),), kind="model/g"
)
PAGE = b"<!DOCTYPE html><title>Log in</title>"
LOGIN = r"HTML page.*Log in.*address"


@pytest.mark.parametrize(
    ("says", "kind", "told"),
    [
        (Says(status=429, headers=(("retry-after", "3600"),)), BackendError,
         r"plan_scene.*wait of 3600 s.*5 s"),
        (Says({"error": {"code": "insufficient_quota", "message": "You exceeded your quota"}},
              status=429), BackendError, "exceeded your quota"),
        (Says(bytes(200_000), kind="a/b"), UnusableError, "the limit of 100000 bytes"),
        (ZIPPED, UnusableError, "the limit of 100000 bytes"),
        (Says(PAGE, kind="text/html"), UnusableError, LOGIN),
        (Says(PAGE, status=404, kind="text/html"), UnusableError, LOGIN),
        (Says(b"\n<html>no</html>", kind="image/png"), BackendError, "HTML page"),
    ],
    ids=["an hour", "quota", "too large", "zipped", "page", "page, 404", "page as image"],
)  # fmt: skip
def test_what_no_further_try_mends_is_asked_once_and_not_kept(
    says: Says, kind: type[BackendError], told: str, tmp_path: Path
) -> None:
    store = CallStore(tmp_path)
    with serving([says]) as server, pytest.raises(kind, match=told):
        ask(session(store=store), server.url, most_bytes=100_000)
    assert len(server.asked) == 1 and len(store) == 0


def test_what_no_wait_mends_is_answered_at_once() -> None:
    shared = session()
    refusal = {"error": {"message": f"Incorrect API key: {KEY}."}}
    with serving([Says(refusal, status=401)]) as server:
        answer = ask(shared, server.url)
        assert answer.status_code == 401 and len(server.asked) == 1
    assert answer.json() == {"error": {"message": "Incorrect API key: [redacted]."}}
    assert outcomes(shared) == ["failed"] and shared.account.money == 0.0


def test_a_server_that_keeps_failing_is_told_with_its_words() -> None:
    shared = session(attempts=3)
    with (
        serving([Says({"error": "out of memory"}, status=500)]) as server,
        pytest.raises(BackendError) as caught,
    ):
        ask(shared, server.url)
    told = str(caught.value)
    assert all(w in told for w in ("cloud", "plan_scene", "3 attempts", "500", "out of memory"))
    assert len(server.asked) == 3 and outcomes(shared) == ["failed"] * 3


def test_a_dead_server_is_told() -> None:
    with serving([Says()]) as server:
        pass
    with pytest.raises(BackendError, match=r"cloud, plan_scene.*cannot be reached"):
        ask(session(attempts=2), server.url)


@pytest.mark.slow
@pytest.mark.parametrize("slow", [Says(delay=4.0), Says(drip=0.05)], ids=["hangs", "drips"])
def test_an_attempt_ends_after_its_time(slow: Says) -> None:
    with serving([slow, Says()]) as server:
        shared = session()
        assert ask(shared, server.url, timeout=1.5).json() == CHAT
    assert outcomes(shared) == ["failed", "answered"]


@pytest.mark.slow
@pytest.mark.parametrize("slow", [Says(delay=0.4), Says(status=504)], ids=["hangs", "gateway"])
def test_what_was_waited_for_in_vain_is_sent_once_more_and_counts_each_time(slow: Says) -> None:
    shared = session()
    with serving([slow]) as server, pytest.raises(BackendError, match="after 2 attempts"):
        ask(shared, server.url, timeout=0.1)
    assert len(server.asked) == 2
    assert shared.account.money == pytest.approx(0.08, abs=0.002)


def test_a_page_of_a_gateway_counts_too_and_looking_does_not() -> None:
    shared = session(attempts=1)
    page = Says(b"<html>Bad gateway</html>", status=502, kind="text/html")
    with serving([page]) as server:
        with pytest.raises(BackendError, match="HTML"):
            ask(shared, server.url)
        paid = shared.account.money
        with shared.client("cloud", server.url) as client, pytest.raises(BackendError):
            client.get("/job", headers={"x-tabletopgen-model": "m"})
    assert shared.account.money == paid > 0.04


def test_the_key_is_not_carried_to_another_server() -> None:
    with serving([Says()]) as other:
        to = (("location", f"{other.url}/v1/chat"),)
        with (
            serving([Says(status=307, headers=to)]) as server,
            pytest.raises(BackendError, match=r"another server, .*not followed"),
        ):
            ask(session(), server.url)
        assert other.asked == []
        with (
            session().client("cloud", server.url) as client,
            pytest.raises(BackendError, match="Open a client for that server"),
        ):
            client.get(f"{other.url}/file.glb")
        assert other.asked == []


def test_a_redirect_within_the_server_is_followed() -> None:
    def script(asked: Asked, k: int) -> Says:
        moved = Says(status=307, headers=(("location", "/v2/chat"),))
        return Says() if asked.path == "/v2/chat" else moved

    with serving(script) as server:
        assert ask(session(), server.url).json() == CHAT
    assert server.asked[0].body == server.asked[1].body != b""


@pytest.mark.parametrize(
    ("status", "words"), [(302, "drop the request's body"), (308, "more than 3")]
)
def test_a_redirect_that_leads_nowhere_is_told(status: int, words: str) -> None:
    around = Says(status=status, headers=(("location", "/v1/chat"),))
    with serving([around]), serving([around]) as server, pytest.raises(BackendError, match=words):
        ask(session(), server.url)


def test_a_server_that_fails_too_often_is_left_alone() -> None:
    shared = session(attempts=2, retry_policy=RetryPolicy(first=0.001, failures=3, rest=60))
    with serving([Says(status=500)]) as server:
        with pytest.raises(BackendError, match="after 2 attempts"):
            ask(shared, server.url)
        with pytest.raises(BackendError, match=r"plan_scene.*not sent.*failed 3 times in a row"):
            ask(shared, server.url)
        with pytest.raises(BackendError, match="not contacted"):
            ask(shared, server.url, "something else")
        assert len(server.asked) == 3
    with serving([Says()]) as other:
        assert ask(shared, other.url).json() == CHAT


@pytest.mark.parametrize("wait", [(), (("retry-after", "0"),)], ids=["unsaid", "retry-after"])
def test_a_bad_moment_befalls_calls_at_once_and_all_are_tried_again(
    wait: tuple[tuple[str, str], ...],
) -> None:
    usual = Session()
    quick = RetryPolicy(first=0.01, longest=0.02, failures=usual.retry_policy.failures)
    shared = session(retry_policy=quick, workers=usual.workers, attempts=usual.attempts)
    busy = 2 * usual.workers  # answers: all fail twice

    def script(asked: Asked, k: int) -> Says:
        return Says(status=503, headers=wait) if k < busy else Says()

    with serving(script) as server:
        items = [str(k) for k in range(usual.workers)]
        answers = shared.each(lambda text: ask(shared, server.url, text).json(), items)
    assert answers == [CHAT] * len(items)


def test_a_server_that_says_when_it_will_work_is_not_left_alone() -> None:
    shared = session(attempts=2, retry_policy=RetryPolicy(first=0.001, failures=2, rest=60))
    later = Says(status=503, headers=(("retry-after", "0"),))
    with serving([later, later, Says()]) as server:
        with pytest.raises(BackendError, match="after 2 attempts"):
            ask(shared, server.url)
        assert ask(shared, server.url).json() == CHAT


def test_the_budget_ends_calls_before_it_is_exceeded() -> None:
    shared = session(budget=0.07)
    with serving([Says()]) as server:
        for text in "ab":
            ask(shared, server.url, text)  # 0.021 each, at most about 0.04
        with pytest.raises(
            BudgetError, match=r"plan_scene.*0\.0420 of the budget of 0\.07 is spent"
        ):
            ask(shared, server.url, "c")
        assert len(server.asked) == 2
    assert shared.account.money <= 0.07


def test_what_is_kept_costs_nothing_of_the_budget(tmp_path: Path) -> None:
    with serving([Says()]) as server:
        ask(session(store=CallStore(tmp_path)), server.url)
        again = session(store=CallStore(tmp_path), budget=0.0)
        assert ask(again, server.url).json() == CHAT


def test_a_model_without_a_price_is_free_on_this_machine_alone() -> None:
    shared = session(prices=Prices(), budget=0.0)
    with serving([Says()]) as server:
        assert ask(shared, server.url).json() == CHAT
        assert shared.account.entries[0].money == 0.0
    with pytest.raises(BudgetError, match="price of the call is unknown"):
        ask(shared, "http://cloud.invalid")


def test_looking_is_free() -> None:
    shared = session(budget=0.0)
    with (
        serving([Says(b"glb", kind="model/gltf-binary")]) as server,
        shared.client("cloud", server.url) as client,
    ):
        assert client.get("/a.glb", headers={"x-tabletopgen-model": "m"}).content == b"glb"
    (entry,) = shared.account.entries
    assert (entry.question, entry.money) == ("GET /a.glb", 0.0)


def test_a_dry_run_sends_nothing_but_uses_what_is_kept(tmp_path: Path) -> None:
    with serving([Says()]) as server:
        ask(session(store=CallStore(tmp_path)), server.url)
        dry = session(store=CallStore(tmp_path), dry=True)
        assert ask(dry, server.url).json() == CHAT
        with pytest.raises(
            DryRunError, match=r"cloud, plan_scene \(m\), for at most 0\.04\d\d USD"
        ):
            ask(dry, server.url, "something else")
        assert len(server.asked) == 1


def test_a_disk_that_refuses_loses_no_answer(tmp_path: Path) -> None:
    (tmp_path / "calls").write_text("no folder")
    shared = session(store=CallStore(tmp_path / "calls"))
    with serving([Says()]) as server:
        assert ask(shared, server.url).json() == CHAT
        assert ask(shared, server.url, "and now?").json() == CHAT
    (note,) = shared.account.notes
    assert "cannot be written" in note


def test_addresses_are_checked() -> None:
    for wrong in ("api.example.com", "ftp://x", "http://", "http://x:99999"):
        with pytest.raises(BackendError, match="https://host/path"):
            session().client("cloud", wrong)


@pytest.mark.parametrize(
    "url",
    ["http://me:hunter2@host/v1", "http://me:hun/ter2@host", "gpu://me:hunter2@host", "me:ter2@h"],
)
def test_a_password_in_an_address_is_refused_and_not_shown(url: str) -> None:
    with pytest.raises(BackendError, match=r"cloud: its address .*\[redacted\]@h") as caught:
        session().client("cloud", url)
    assert "ter2" not in str(caught.value)


@pytest.mark.parametrize("key", [KEY, "sk-shaped-like-a-key-1"])
def test_a_key_in_an_address_is_refused(key: str) -> None:
    with (
        serving([Says()]) as server,
        session().client("cloud", server.url, secrets=(key,)) as client,
        pytest.raises(BackendError, match="Send the key in a header") as caught,
    ):
        client.get(f"/models?k={key}")
    assert key not in str(caught.value) and server.asked == []


CHILD = """
import sys
from paid_server import ask, session
from generator.calls.store import CallStore
for text in "abc":
    ask(session(store=CallStore(sys.argv[1])), sys.argv[2], text)
"""


@pytest.mark.slow
def test_what_a_killed_process_paid_for_is_not_paid_for_again(tmp_path: Path) -> None:
    with serving(lambda asked, k: Says({"k": k}, delay=30.0 if k == 2 else 0.0)) as server:
        path = os.pathsep.join([str(Path(__file__).parent), *sys.path])
        command = [sys.executable, "-c", CHILD, str(tmp_path), server.url]
        with running(*command, env={**os.environ, "PYTHONPATH": path}) as child:
            until(lambda: len(server.asked) >= 3 or child.poll() is not None)
        shared = session(store=CallStore(tmp_path))
        again = [ask(shared, server.url, text).json()["k"] for text in "abc"]
    assert again == [0, 1, 3]
    assert len(server.asked) == 4
