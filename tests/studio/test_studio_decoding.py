"""Uploads are decoded in children, which end with whoever waits for them."""

import contextlib
import os
import signal
import socket
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from bounded import LONG, until
from hostile_pictures import encoded, noise, repeated_scans
from starlette.testclient import TestClient
from studio_clients import Studio, queue, run_studio, wait_for

SOON = 15.0  # seconds: twenty times what it takes on an idle machine
LARGE = (3000, 3000)

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="children are found in /proc")


def test_scans_by_the_thousand_are_refused_before_decoding(client: TestClient) -> None:
    answer = client.post("/api/pictures", content=repeated_scans(3000))
    assert answer.status_code == 422
    assert "scans" in answer.json()["error"]


def decoders(studio: Studio) -> list[int]:
    """Return the decoder processes of a studio."""
    listed = Path(f"/proc/{studio.process.pid}/task").glob("*/children")
    found: list[int] = []
    for task in listed:
        with contextlib.suppress(OSError):
            found += map(int, task.read_text().split())
    return [pid for pid in found if b"generator.sandbox" in _command(pid)]


def _command(pid: int) -> bytes:
    with contextlib.suppress(OSError):
        return Path(f"/proc/{pid}/cmdline").read_bytes()
    return b""


@contextlib.contextmanager
def stuck_uploads(studio: Studio, count: int) -> Iterator[list[socket.socket]]:
    """Clients whose uploads are decoded by stopped children."""
    with contextlib.ExitStack() as stack:
        lines, stopped = [], set[int]()
        for k in range(count):
            body = encoded(noise(*LARGE, k), "PNG")
            head = (
                f"POST /api/pictures HTTP/1.1\r\nHost: {studio.host}\r\n"
                f"Authorization: Bearer {studio.token}\r\nContent-Length: {len(body)}\r\n\r\n"
            )
            address = "127.0.0.1", studio.port
            lines.append(stack.enter_context(socket.create_connection(address, timeout=LONG)))
            lines[-1].sendall(head.encode() + body)
            end = time.monotonic() + LONG
            while not (new := {*decoders(studio)} - stopped):
                assert time.monotonic() < end, "nothing decodes"
            for pid in new:
                os.kill(pid, signal.SIGSTOP)
            stopped |= new
        assert len(stopped) == count
        yield lines


@pytest.mark.slow
def test_clients_that_go_away_free_their_permits(tmp_path: Path, store: Path) -> None:
    with run_studio(tmp_path / "studio") as studio:
        with stuck_uploads(studio, 2):
            assert len(decoders(studio)) == 2
        until(lambda: not decoders(studio), SOON)
        small = encoded(noise(320, 200), "PNG")
        with studio.connect() as client:
            assert client.post("/api/pictures", content=small, timeout=SOON).status_code == 201
        kept = [p for p in (tmp_path / "studio" / "pictures").iterdir() if p.suffix == ".png"]
        assert len(kept) == 1


@pytest.mark.slow
def test_a_studio_ends_soon_while_it_decodes_and_works(tmp_path: Path, store: Path) -> None:
    with run_studio(tmp_path / "studio", "--workers", "2") as studio:
        job = queue(studio.client, "an office desk with a laptop, a mug and twelve books")
        wait_for(studio.client, job, "running")
        view = threading.Thread(target=_view, args=(studio,), daemon=True)
        view.start()
        with stuck_uploads(studio, 2):
            began = time.monotonic()
            studio.process.send_signal(signal.SIGINT)
            assert studio.process.wait(SOON) == 0
            print(f"ended after {time.monotonic() - began:.2f} s")
        assert studio.process.stderr is not None
        assert "Traceback" not in studio.process.stderr.read()
        view.join(LONG)


def _view(studio: Studio) -> None:
    """Request a scene's view, which a thread of the studio prepares."""
    with contextlib.suppress(Exception), studio.connect() as client:
        scene = client.get("/api/scenes").json()["scenes"][0]["id"]
        client.get(f"/api/scenes/{scene}/view.json")
