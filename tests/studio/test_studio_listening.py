"""Connections: those on which nothing whole is asked end, others do not."""

import asyncio
import contextlib
import socket
import threading
from collections.abc import Iterator

import pytest
import uvicorn
from bounded import LONG, until

from tabletopgen_web.studio.server import listener

HEAD = 0.3  # seconds
SLOW = 4 * HEAD
REQUEST = b"GET /%b HTTP/1.1\r\nHost: x\r\n\r\n"


async def answer(scope, receive, send) -> None:
    if scope["path"] == "/slow":
        await asyncio.sleep(SLOW)
    headers = [(b"content-length", b"4")]
    await send({"type": "http.response.start", "status": 200, "headers": headers})
    await send({"type": "http.response.body", "body": b"done"})


@pytest.fixture
def port(monkeypatch: pytest.MonkeyPatch) -> Iterator[int]:
    monkeypatch.setattr(listener, "_HEAD", HEAD)
    with listener.bind("127.0.0.1", 0) as line:
        config = uvicorn.Config(
            answer, http=listener.HastyProtocol, loop="asyncio", lifespan="off", log_config=None
        )
        server = uvicorn.Server(config)
        thread = threading.Thread(target=lambda: server.run(sockets=[line]), daemon=True)
        thread.start()
        until(lambda: server.started, LONG)
        yield line.getsockname()[1]
        server.should_exit = True
        thread.join(LONG)


def ask(line: socket.socket, path: bytes = b"") -> None:
    """Request a path and read the complete response."""
    line.sendall(REQUEST % path)
    said = b""
    while not said.endswith(b"done"):
        piece = line.recv(1000)
        assert piece, "the connection was closed"
        said += piece


@contextlib.contextmanager
def connected(port: int) -> Iterator[socket.socket]:
    with socket.create_connection(("127.0.0.1", port), timeout=LONG) as line:
        yield line


@pytest.mark.parametrize("said", [b"", b"GET / HTTP/1.1\r\nHost:"])
def test_a_connection_that_asks_nothing_is_closed(port: int, said: bytes) -> None:
    with connected(port) as line:
        line.sendall(said)
        assert line.recv(1000) == b""


def test_a_second_request_that_never_ends_is_closed(port: int) -> None:
    with connected(port) as line:
        ask(line)
        line.sendall(b"GET / HT")
        assert line.recv(1000) == b""


def test_a_slow_answer_and_a_pause_between_requests_are_no_reason(port: int) -> None:
    with connected(port) as line:
        for path in (b"slow", b""):
            ask(line, path)
            threading.Event().wait(SLOW)
        ask(line)
