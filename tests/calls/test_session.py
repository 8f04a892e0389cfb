"""Parallel work in a session, and its end."""

import sys
import threading
import time

import pytest
from bounded import join, until
from paid_server import Asked, Says, ask, serving, session

from generator.calls.http.retries import RetryPolicy
from generator.calls.store import CallStore
from generator.errors import BackendError, DryRunError, InputError, StoppedError

PATIENT = RetryPolicy(first=20.0, longest=20.0)


def test_results_come_in_order_and_at_once() -> None:
    gate = threading.Barrier(3)

    def work(k: int) -> int:
        gate.wait(5)  # passes only if three run at once
        time.sleep(0.01 * (3 - k))
        return 10 * k

    assert session(workers=3).each(work, range(3)) == [0, 10, 20]
    assert session().each(str, []) == []


def test_no_more_run_at_once_than_workers() -> None:
    inside, most = [], []

    def work(k: int) -> None:
        inside.append(k)
        most.append(len(inside))
        time.sleep(0.01)
        inside.remove(k)

    session(workers=2).each(work, range(6))
    assert max(most) <= 2
    own = []
    session(workers=1).each(lambda _: own.append(threading.current_thread()), range(3))
    assert set(own) == {threading.current_thread()}


def test_the_first_error_ends_what_waits_and_what_has_not_begun() -> None:
    begun = []

    def work(k: int) -> None:
        begun.append(k)
        if k == 1:
            raise BackendError("no")
        shared.pause(60)

    shared = session(workers=2)
    began = time.monotonic()
    with pytest.raises(BackendError, match=r"^no$"):
        shared.each(work, range(8))
    assert time.monotonic() - began < 30
    assert len(begun) < 8
    shared.pause(0.0)  # the session itself goes on


def test_work_within_work_ends_with_the_outer() -> None:
    shared = session(workers=2)

    def inner(k: int) -> None:
        shared.pause(60)

    def outer(k: int) -> None:
        if k:
            raise BackendError("no")
        shared.each(inner, range(2))

    began = time.monotonic()
    with pytest.raises(BackendError, match=r"^no$"):
        shared.each(outer, range(2))
    assert time.monotonic() - began < 30


def test_calls_answered_beside_a_failed_one_are_kept(tmp_path) -> None:
    shared = session(store=CallStore(tmp_path), workers=2)
    answered = threading.Event()

    def work(text: str) -> None:
        if text == "bad":
            answered.wait(5)
            raise BackendError("no")
        ask(shared, server.url, text)
        answered.set()

    with serving([Says()]) as server:
        with pytest.raises(BackendError):
            shared.each(work, ["good", "bad"])
        ask(shared, server.url, "good")
        assert len(server.asked) == 1


@pytest.mark.slow
def test_stop_ends_waits_and_calls_to_come() -> None:
    shared = session(retry_policy=PATIENT)

    def busy(asked: Asked, k: int) -> Says:
        threading.Timer(0.2, shared.stop.set).start()  # while the caller waits to ask again
        return Says(status=503)

    with serving(busy) as server:
        began = time.monotonic()
        with pytest.raises(StoppedError, match="kept"):
            ask(shared, server.url)
        assert time.monotonic() - began < 10
        with pytest.raises(StoppedError):
            ask(shared, server.url)
        assert len(server.asked) == 1
        with pytest.raises(StoppedError):
            shared.each(lambda text: ask(shared, server.url, text), "ab")


@pytest.mark.slow
def test_stop_ends_the_wait_for_a_question_that_another_asks(tmp_path) -> None:
    one, two = session(store=CallStore(tmp_path)), session(store=CallStore(tmp_path))
    with serving([Says(delay=0.5)]) as server:
        first = threading.Thread(target=ask, args=(one, server.url))
        first.start()
        until(lambda: server.asked)
        two.stop.set()
        with pytest.raises(StoppedError):
            ask(two, server.url)
        join(first)


def test_one_question_asked_at_once_is_paid_for_once(tmp_path) -> None:
    shared = session(store=CallStore(tmp_path))
    with serving([Says(delay=0.1)]) as server:
        shared.each(lambda _: ask(shared, server.url), range(4))
        assert len(server.asked) == 1
    assert sorted(e.outcome for e in shared.account.entries) == ["answered", *["cached"] * 3]


def test_a_dry_run_names_all_calls_of_many_things() -> None:
    shared = session(dry=True)

    def work(question: str) -> None:
        ask(shared, "http://127.0.0.1:9", question=question)

    with pytest.raises(DryRunError) as caught:
        shared.each(work, ["complete", "model", "model"])
    assert [line.split()[3] for line in str(caught.value).splitlines()] == ["complete", "model"]


def test_settings_are_checked() -> None:
    for settings, word in (
        ({"workers": 0}, "workers"),
        ({"attempts": 0}, "attempts"),
        ({"budget": -1.0}, "budget"),
        ({"budget": float("nan")}, "budget"),
    ):
        with pytest.raises(InputError, match=word):
            session(**settings)


def test_a_missing_extra_names_the_pip_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "httpx2", None)
    with pytest.raises(BackendError, match=r"cloud .*httpx2.* pip install 'tabletopgen\[cloud\]'"):
        session().client("cloud", "https://host")
