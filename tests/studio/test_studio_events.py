"""The stream of events: numbered, resumed, with heartbeats; who does not read is dropped."""

import asyncio
import json
from pathlib import Path
from typing import Any

import pytest
from bounded import LONG

from tabletopgen_web.studio.contracts import FigureRow, StageRow
from tabletopgen_web.studio.folder import StudioFolder
from tabletopgen_web.studio.queue.jobs import JobStore
from tabletopgen_web.studio.routes import events
from tabletopgen_web.studio.server.services import StudioServices

JOB = {"kind": "compose", "text": "a mug"}


class Reader:
    """An ASGI client that reads ``most`` pieces and then stops."""

    def __init__(self, most: int = 10**6) -> None:
        self.said, self._most = b"", most
        self.left = asyncio.get_running_loop().create_future()

    async def receive(self) -> dict[str, Any]:
        await asyncio.wait_for(asyncio.shield(self.left), LONG)
        return {"type": "http.disconnect"}

    async def send(self, message: Any) -> None:
        if self._most == 0:
            await asyncio.sleep(LONG)
        self._most -= 1
        self.said += message.get("body", b"")

    @property
    def numbers(self) -> list[int]:
        return [int(x[4:]) for x in self.said.decode().splitlines() if x.startswith("id: ")]

    async def until(self, words: bytes) -> None:
        async with asyncio.timeout(20):
            while words not in self.said:
                await asyncio.sleep(0.005)


def listen(services: StudioServices, reader: Reader, since: int = 0) -> asyncio.Task[None]:
    stream = events.EventStream(services, since)
    scope = {"type": "http"}
    return asyncio.create_task(stream(scope, reader.receive, reader.send))


@pytest.fixture
def services(tmp_path: Path) -> StudioServices:
    folder = StudioFolder(tmp_path)
    folder.make()
    return StudioServices(folder, 1, {}, JobStore(folder.database))


def run(work: Any) -> None:
    async def bounded() -> None:
        async with asyncio.timeout(60):
            await work

    asyncio.run(bounded())


def test_events_come_as_they_happen_and_once_each(services: StudioServices) -> None:
    async def work() -> None:
        early, late, first = Reader(), Reader(), services.store.add(JOB)
        listening = listen(services, early)
        await early.until(b"queued")
        services.store.take()
        services.store.note_stage(first.id, StageRow("drawing", 1, 2))
        services.store.note_figure(first.id, FigureRow("a.png", "drawing", "/u"))
        await early.until(b"a.png")
        resumed = listen(services, late, since=2)
        await late.until(b"a.png")
        assert early.numbers == [1, 2, 3, 4] and late.numbers == [3, 4]
        early.left.set_result(None)
        await listening
        services.store.finish(first.id, "done")
        await late.until(b"done")
        assert early.numbers == [1, 2, 3, 4] and late.numbers == [3, 4, 5]
        last = json.loads(late.said.decode().split("data: ")[-1])
        assert (last["job"], last["type"], last["state"], last["seq"]) == (
            first.id, "state", "done", 5)  # fmt: skip
        late.left.set_result(None)
        await resumed

    run(work())


def test_who_does_not_read_is_dropped_and_nobody_waits(
    services: StudioServices, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(events, "SLOW", 0.1)

    async def work() -> None:
        stuck, reading = Reader(most=2), Reader()
        dropped, other = listen(services, stuck), listen(services, reading)
        services.store.add(JOB)
        await reading.until(b"queued")
        await dropped
        assert not services.listeners.locked()
        reading.left.set_result(None)
        await other

    run(work())


def test_silence_is_filled(services: StudioServices, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(events, "HEARTBEAT", 0.02)

    async def work() -> None:
        reader = Reader()
        listening = listen(services, reader)
        await reader.until(b": still here\n\n: still here\n\n")
        services.store.add(JOB)
        await reader.until(b"queued")
        reader.left.set_result(None)
        await listening

    run(work())


def test_many_old_events_come_in_pieces(services: StudioServices) -> None:
    async def work() -> None:
        job = services.store.add(JOB).id
        for number in range(700):
            services.store.note_log(job, f"line {number}\n")
        reader = Reader()
        listening = listen(services, reader)
        await reader.until(b"line 699")
        assert reader.numbers == list(range(1, 702))
        reader.left.set_result(None)
        await listening

    run(work())
