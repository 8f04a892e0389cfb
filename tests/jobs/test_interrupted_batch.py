"""Ctrl-C in a batch: calls under way may be answered, no new ones are made, twice ends all."""

from __future__ import annotations

import signal
import threading
import time
from pathlib import Path

import pytest
from asking_maker import AskingMaker
from bounded import until
from calls.paid_server import Asked, Says, Served, serving

from generator import jobs as batch
from generator.calls.store import CallStore

pytestmark = pytest.mark.slow

HUNG = 60.0
"""Seconds that nobody waits for."""


def interrupt(server: Served, times: int) -> None:
    """Interrupt the main thread once two calls are under way."""

    def send() -> None:
        until(lambda: len(server.asked) >= 2)
        for _ in range(times):
            time.sleep(0.5)
            signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)

    threading.Thread(target=send, daemon=True).start()


@pytest.mark.parametrize(("delay", "times", "kept"), [(1.5, 1, 2), (HUNG, 2, 0)])
def test_an_interrupted_batch(delay: float, times: int, kept: int, tmp_path: Path) -> None:
    over = threading.Event()

    def script(asked: Asked, k: int) -> Says:
        over.wait(delay)
        return Says()

    with serving(script) as server:
        make = AskingMaker(server.url, str(tmp_path / "calls"))
        interrupt(server, times)
        began = time.monotonic()
        with pytest.raises(KeyboardInterrupt):
            batch.run(["one", "two", "three"], tmp_path / "out", make, workers=2)
        assert time.monotonic() - began < HUNG / 2
        assert len(server.asked) == 2, "no new ones"
        over.set()
    assert len(CallStore(tmp_path / "calls")) == kept
    assert not [path for path in (tmp_path / "out").iterdir() if path.name != ".batch"]
