"""Ctrl-C during calls: no new calls, pending ones may finish; a second Ctrl-C ends all."""

import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from bounded import running, until
from paid_server import Asked, Says, Served, ask, interrupt, serving, session

from generator.calls.store import CallStore
from generator.errors import StoppedError

pytestmark = pytest.mark.slow

HUNG = 30.0
"""Seconds that nobody waits for."""


@contextmanager
def hanging(first: float = HUNG) -> Iterator[tuple[Served, threading.Event]]:
    """Serve responses after ``first`` seconds, or when the event is set."""
    over = threading.Event()

    def script(asked: Asked, k: int) -> Says:
        over.wait(first)
        return Says({"k": k})

    with serving(script) as server:
        try:
            yield server, over
        finally:
            over.set()


def one(shared, url: str) -> None:
    ask(shared, url, "1", timeout=HUNG)


def some(shared, url: str) -> None:
    shared.each(lambda text: ask(shared, url, text, timeout=HUNG), list("12345678"))


@pytest.mark.parametrize(("work", "calls"), [(one, 1), (some, 2)])
def test_an_answer_that_comes_soon_is_kept(work: Callable, calls: int, tmp_path: Path) -> None:
    shared = session(store=CallStore(tmp_path), workers=2, grace=HUNG)
    with hanging(0.8) as (server, _):
        interrupt(server, calls)
        with pytest.raises(KeyboardInterrupt):
            work(shared, server.url)
        assert len(server.asked) == calls, "no new ones"
        assert len(CallStore(tmp_path)) == calls
    assert [e.outcome for e in shared.account.entries] == ["answered"] * calls


@pytest.mark.parametrize(("work", "calls"), [(one, 1), (some, 2)])
@pytest.mark.parametrize(("grace", "times"), [(0.2, 1), (HUNG, 2)], ids=["one", "a second one"])
def test_an_answer_that_does_not_come_is_given_up_and_counts(
    work: Callable, calls: int, grace: float, times: int
) -> None:
    """After the grace period for the first interrupt, at once for a second one."""
    shared = session(workers=2, grace=grace)
    with hanging() as (server, _):
        interrupt(server, calls, times)
        began = time.monotonic()
        with pytest.raises(KeyboardInterrupt):
            work(shared, server.url)
        assert time.monotonic() - began < HUNG / 2
    assert [e.outcome for e in shared.account.entries] == ["failed"] * calls
    assert shared.account.money > 0.04 * calls


def test_stop_gives_up_what_is_under_way() -> None:
    shared = session(grace=0.2)
    with hanging() as (server, _):
        threading.Timer(0.2, shared.stop.set).start()
        began = time.monotonic()
        with pytest.raises(StoppedError, match="in flight"):
            one(shared, server.url)
        assert time.monotonic() - began < HUNG / 2


def test_a_failure_beside_it_gives_up_nothing(tmp_path: Path) -> None:
    shared = session(store=CallStore(tmp_path), workers=2, grace=0.0)

    def work(text: str) -> None:
        if text == "bad":
            until(lambda: server.asked)
            raise StoppedError("no")
        ask(shared, server.url, text)

    with hanging(0.5) as (server, _), pytest.raises(StoppedError):
        shared.each(work, ["good", "bad"])
    assert len(CallStore(tmp_path)) == 1


CHILD = """
import sys
from paid_server import session
from test_interrupts import some
from generator.cli import interrupts
interrupts.heed()
try:
    some(session(), sys.argv[1])
except KeyboardInterrupt:
    interrupts.ignore()
    raise SystemExit(130)
"""


def test_the_process_ends_with_the_second_interrupt() -> None:
    path = os.pathsep.join([str(Path(__file__).parent), *sys.path])
    with hanging() as (server, _):
        command = [sys.executable, "-c", CHILD, server.url]
        with running(*command, env={**os.environ, "PYTHONPATH": path}) as child:
            until(lambda: len(server.asked) >= 8)
            began = time.monotonic()
            for _ in range(2):
                child.send_signal(signal.SIGINT)
                time.sleep(0.3)
            assert child.wait(HUNG / 2) == 130
            assert time.monotonic() - began < HUNG / 2
