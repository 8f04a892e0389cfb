"""A small HTTP server in a thread."""

from __future__ import annotations

import contextlib
import json
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler

from local_server import local_server, sent_to

from generator.calls.http.retries import RetryPolicy
from generator.calls.session import Session
from generator.calls.store import CallStore


@dataclass(frozen=True)
class Call:
    method: str
    path: str
    headers: dict[str, str]
    body: bytes

    @property
    def json(self) -> dict:
        return json.loads(self.body)


@dataclass(frozen=True)
class Answer:
    """A response.

    ``hang`` is awaited first.
    """

    status: int = 200
    body: bytes = b""
    kind: str = "application/octet-stream"
    length: int | None = None
    hang: threading.Event | None = None

    @classmethod
    def of(cls, told: object, status: int = 200) -> Answer:
        return cls(status, json.dumps(told).encode(), "application/json")


@dataclass
class Served:
    url: str
    calls: list[Call] = field(default_factory=list)


@contextlib.contextmanager
def serving(
    answer: Callable[[Call], Answer], sent: Callable[[Call, bytes], None] = lambda *_: None
) -> Iterator[Served]:
    """Serve the responses of ``answer``; ``sent`` is called with each response once it is sent."""
    served = Served("")

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            headers = {name.lower(): value for name, value in self.headers.items()}
            call = Call(self.command, self.path, headers, sent_to(self))
            served.calls.append(call)
            made = answer(call)
            if made.hang is not None:
                made.hang.wait(30)
            with contextlib.suppress(OSError):
                self.send_response(made.status)
                self.send_header("content-type", made.kind)
                length = len(made.body) if made.length is None else made.length
                self.send_header("content-length", str(length))
                self.end_headers()
                self.wfile.write(made.body)
                sent(call, made.body)

        do_POST = do_GET

        def log_message(self, *_: object) -> None:
            pass

    with local_server(Handler) as served.url:
        yield served


def quick(store: CallStore | None = None, attempts: int = 1) -> Session:
    """Return a session with short timeouts."""
    return Session(
        store=store, attempts=attempts, retry_policy=RetryPolicy(first=0.01, longest=0.02)
    )
