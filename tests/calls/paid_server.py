"""A local server with responses defined by a test, which counts requests."""

import json
import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler
from pathlib import Path
from typing import Any

import pytest
from bounded import until
from local_server import local_server

from generator.backends import select
from generator.calls import Session
from generator.calls.http.retries import RetryPolicy
from generator.calls.money.prices import Price, Prices

KEY = "marker-key-5d1f0c"
"""The secret that nothing may hold."""

HASTY = RetryPolicy(first=0.004, longest=0.02, obeyed=5.0, failures=50, rest=60.0)
PRICES = Prices("2026-01-01", "USD", {"m": Price(input=1.0, output=10.0), "i": Price(image=0.5)})

CHAT = {
    "choices": [{"index": 0, "message": {"role": "assistant", "content": "yes"}}],
    "usage": {"prompt_tokens": 1_000, "completion_tokens": 2_000},
}
"""An answer of 0.021 by ``PRICES``."""


@dataclass(frozen=True)
class Says:
    """One response: status, body (JSON unless bytes), headers; optionally wrong or late."""

    body: Any = field(default_factory=lambda: CHAT)
    status: int = 200
    headers: tuple[tuple[str, str], ...] = ()
    kind: str = "application/json"
    cut: int = 0
    """Bytes of the body that never come."""
    delay: float = 0.0
    drip: float = 0.0
    """Seconds between the bytes of the body."""
    hang_up: bool = False


@dataclass(frozen=True)
class Asked:
    method: str
    path: str
    headers: dict[str, str]
    body: bytes


@dataclass
class Served:
    """A running server: its address, and all requests."""

    url: str
    asked: list[Asked] = field(default_factory=list)


Script = Callable[[Asked, int], Says]
"""What to say to a request; the number counts requests from 0."""


@contextmanager
def serving(script: Script | list[Says]) -> Iterator[Served]:
    """Serve responses by a rule, or in sequence, repeating the last."""
    if isinstance(script, list):
        answers = script
        script = lambda asked, k: answers[min(k, len(answers) - 1)]  # noqa: E731
    lock = threading.Lock()

    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def answer(self) -> None:
            length = int(self.headers.get("content-length", 0))
            headers = {k.lower(): v for k, v in self.headers.items()}
            asked = Asked(self.command, self.path, headers, self.rfile.read(length))
            with lock:
                number = len(served.asked)
                served.asked.append(asked)
            try:
                self.say(script(asked, number))
            except OSError:  # the client has left
                self.close_connection = True

        def say(self, says: Says) -> None:
            time.sleep(says.delay)
            if says.hang_up:
                self.close_connection = True
                return
            body = says.body if isinstance(says.body, bytes) else json.dumps(says.body).encode()
            self.send_response(says.status)
            self.send_header("content-type", says.kind)
            for name, value in says.headers:
                self.send_header(name, value)
            self.send_header("content-length", str(len(body)))
            self.end_headers()
            body = body[: len(body) - says.cut]
            for byte in body if says.drip else ():
                self.wfile.write(bytes([byte]))
                self.wfile.flush()
                time.sleep(says.drip)
            if not says.drip:
                self.wfile.write(body)
            self.close_connection = self.close_connection or bool(says.cut)

        do_GET = do_POST = answer

        def log_message(self, *args: Any) -> None:
            pass

    with local_server(Handler) as url:
        served = Served(url)
        yield served


def interrupt(server: Served, calls: int, times: int = 1, pause: float = 0.3) -> None:
    """Interrupt the main thread when the given number of calls are active."""

    def send() -> None:
        until(lambda: len(server.asked) >= calls)
        for _ in range(times):
            time.sleep(pause)
            signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)

    threading.Thread(target=send, daemon=True).start()


@dataclass(frozen=True)
class Remote:
    """Backend without answers; its session comes from a command or a process of a batch."""

    session: Session = field(default_factory=Session, repr=False, compare=False)

    def plan_scene(self, *known: Any) -> Any:
        raise AssertionError

    list_objects = estimate_view = estimate_sizes = review_orientation = plan_scene
    stacking_order = draw = complete = top_view = segment = model = features = plan_scene


def remote_backend(patch: pytest.MonkeyPatch, folder: Path) -> Path:
    """Register ``Remote`` as the backend "remote"; return a price table for its requests."""
    roles = dict.fromkeys(select.PROTOCOLS, f"{__name__}:Remote")
    patch.setattr(select, "TABLE", {**select.TABLE, "remote": roles})
    table = folder / "prices.toml"
    table.write_text('date = "2026-01-01"\ncurrency = "EUR"\n[models.m]\noutput = 10.0\n')
    return table


def session(**settings: Any) -> Session:
    """Return a session with short timeouts and the prices of the tests."""
    return Session(**{"prices": PRICES, "retry_policy": HASTY, **settings})


def ask(
    shared: Session,
    url: str,
    text: str = "what is there?",
    *,
    question: str = "plan_scene",
    model: str = "m",
    memo: str | None = None,
    path: str = "/v1/chat",
    **client: Any,
) -> Any:
    """Send one question to a server; return the response."""
    headers = {"x-tabletopgen-question": question, "authorization": f"Bearer {KEY}"}
    if memo is not None:
        headers["x-tabletopgen-memo"] = memo
    payload = {"model": model, "max_tokens": 4_000, "messages": [{"role": "user", "content": text}]}
    with shared.client("cloud", url, **{"timeout": 5.0, **client}) as opened:
        return opened.post(path, json=payload, headers=headers)
