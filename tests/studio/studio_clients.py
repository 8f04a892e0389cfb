"""Clients of a studio: of an application in this process, and of a server in another."""

import contextlib
import json
import re
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import httpx2
from bounded import LONG, line_of, running
from starlette.testclient import TestClient

from tabletopgen_web.studio.folder import StudioFolder
from tabletopgen_web.studio.server.application import make_application
from tabletopgen_web.studio.server.guard import Access
from tabletopgen_web.study.page_data import StudyPage

TOKEN = "the-token-of-the-tests"
ACCESS = Access("127.0.0.1", 8123, TOKEN)
BEARER = {"authorization": f"Bearer {TOKEN}"}
OVER = ("done", "failed", "cancelled", "interrupted")


def rater_token(study: str) -> str:
    return f"the-raters-of-{study}"


@contextlib.contextmanager
def open_client(
    folder: Path, static: Path, workers: int = 1, *, studies: Sequence[StudyPage] = ()
) -> Iterator[TestClient]:
    """Open a client with the token for an application that runs in the context."""
    place = StudioFolder(folder)
    access = replace(ACCESS, studies={page.study: rater_token(page.study) for page in studies})
    with place.locking():
        app = make_application(
            place, access, static, workers, studies={page.study: page for page in studies}
        )
        with TestClient(
            app, base_url=ACCESS.address, headers=BEARER, raise_server_exceptions=False
        ) as client:
            yield client


def wait_for(client: Any, job: str, *states: str) -> dict[str, Any]:
    """Wait until a job is in one of the states, by default finished; return it."""
    end = time.monotonic() + LONG
    while True:
        row = client.get(f"/api/jobs/{job}").json()
        if row["state"] in (states or OVER):
            return row
        assert time.monotonic() < end, f"the job is {row}"
        time.sleep(0.02)


def wait_until(happened: Callable[[], Any], what: str, seconds: float = LONG) -> Any:
    end = time.monotonic() + seconds
    while not (found := happened()):
        assert time.monotonic() < end, f"{what} did not happen in {seconds:g} s"
        time.sleep(0.02)
    return found


def queue(client: Any, text: str = "quick", **more: Any) -> str:
    """Queue a job; return its id."""
    answer = client.post("/api/jobs", json={"kind": "compose", "text": text, **more})
    assert answer.status_code == 201, answer.text
    return answer.json()["id"]


@dataclass
class Studio:
    """A studio in its own process."""

    process: subprocess.Popen[str]
    port: int
    token: str
    client: httpx2.Client = field(init=False)

    def __post_init__(self) -> None:
        self.client = self.connect()

    @property
    def host(self) -> str:
        return f"127.0.0.1:{self.port}"

    def connect(self, **more: Any) -> httpx2.Client:
        headers = {"authorization": f"Bearer {self.token}"}
        return httpx2.Client(
            base_url=f"http://{self.host}", headers=headers, timeout=LONG, trust_env=False, **more
        )


LAUNCH = """
import sys
from pathlib import Path
from tabletopgen_web import frontend
frontend.STATIC, frontend.PAGES = Path(sys.argv.pop(1)), ("studio.html",)
from generator.cli import main
main()
"""
"""``tabletopgen`` with a page of the tests' own, so that nothing has to be built."""


def studio_command(page: Path, *options: str) -> list[str]:
    """Return the command line of a studio whose page is in a folder, created if missing."""
    page.mkdir(parents=True, exist_ok=True)
    (page / "studio.html").write_text("<!doctype html><html><title>Studio</title></html>")
    return [sys.executable, "-c", LAUNCH, str(page), "studio", "--no-browser", *options]


@contextlib.contextmanager
def run_studio(folder: Path, *options: str) -> Iterator[Studio]:
    """Run ``tabletopgen studio`` in the context; kill it afterwards if it still runs."""
    command = studio_command(folder.parent / "page", "--folder", str(folder), *options)
    with running(*command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        line = line_of(process)
        found = re.fullmatch(r"Open http://127\.0\.0\.1:(\d+)/\?token=(\S+)\n", line)
        if found is None:
            raise AssertionError(f"{line!r} {process.communicate(timeout=LONG)}")
        studio = Studio(process, int(found[1]), found[2])
        with studio.client:
            yield studio


class Listener:
    """Listens to the events of a studio in its own thread."""

    def __init__(self, studio: Studio, since: int = 0) -> None:
        self.events: list[dict[str, Any]] = []
        self._client = studio.connect()
        headers = {"last-event-id": str(since)} if since else {}
        self._thread = threading.Thread(target=self._listen, args=(headers,), daemon=True)
        self._thread.start()

    def _listen(self, headers: dict[str, str]) -> None:
        with (
            contextlib.suppress(httpx2.HTTPError, OSError),
            self._client.stream("GET", "/api/events", headers=headers) as answer,
        ):
            for line in answer.iter_lines():
                if line.startswith("data: "):
                    self.events.append(json.loads(line[6:]))

    def of(self, job: str) -> list[dict[str, Any]]:
        return [event for event in self.events if event["job"] == job]


def ask_raw(port: int, request: bytes, seconds: float = 20.0) -> bytes:
    """Send raw bytes; return the response until the connection is closed."""
    with socket.create_connection(("127.0.0.1", port), timeout=seconds) as line:
        line.sendall(request)
        said = b""
        with contextlib.suppress(OSError):
            while piece := line.recv(65536):
                said += piece
        return said
