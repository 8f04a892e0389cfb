"""Ctrl-C in a batch: pending calls may finish, no new ones start; a second one ends all."""

import threading
import time
from pathlib import Path

import pytest
from asking_maker import AskingMaker
from calls.paid_server import Asked, Says, interrupt, serving

from generator import jobs as batch
from generator.calls.store import CallStore

pytestmark = pytest.mark.slow

HUNG = 60.0
"""Seconds that nobody waits for."""


@pytest.mark.parametrize(("delay", "times", "kept"), [(1.5, 1, 2), (HUNG, 2, 0)])
def test_an_interrupted_batch(delay: float, times: int, kept: int, tmp_path: Path) -> None:
    over = threading.Event()

    def script(asked: Asked, k: int) -> Says:
        over.wait(delay)
        return Says()

    with serving(script) as server:
        make = AskingMaker(server.url, str(tmp_path / "calls"))
        interrupt(server, 2, times, pause=0.5)
        began = time.monotonic()
        with pytest.raises(KeyboardInterrupt):
            batch.run(["one", "two", "three"], tmp_path / "out", make, workers=2)
        assert time.monotonic() - began < HUNG / 2
        assert len(server.asked) == 2, "no new ones"
        over.set()
    assert len(CallStore(tmp_path / "calls")) == kept
    assert not [path for path in (tmp_path / "out").iterdir() if path.name != ".batch"]
