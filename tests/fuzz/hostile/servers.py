"""A local server on raw sockets, which may send anything but HTTP, at any time."""

import contextlib
import json
import random
import socket
import threading
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field

TICK = 0.05
"""Seconds between two pieces of what is sent slowly."""

LONGEST = 60.0
"""Seconds after which even what has no end is given up."""


@dataclass
class Talk:
    """One connection: its request, and a way to respond slowly within the case's lifetime."""

    peer: socket.socket
    over: threading.Event
    method: str = ""
    path: str = ""
    headers: Mapping[str, str] = field(default_factory=dict)
    body: bytes = b""

    def send(self, content: bytes) -> None:
        self.peer.sendall(content)

    def wait(self, seconds: float) -> bool:
        """Wait; return whether the case is over."""
        return self.over.wait(seconds)

    def drip(self, content: bytes, pause: float = TICK) -> None:
        for k in range(len(content)):
            self.send(content[k : k + 1])
            if self.wait(pause):
                return

    def forever(self, content: bytes, pause: float = TICK) -> None:
        for _ in range(int(LONGEST / max(pause, 0.001))):
            self.send(content)
            if self.wait(pause):
                return


Behaviour = Callable[[Talk], None]


@contextlib.contextmanager
def serving(behaviour: Behaviour) -> Iterator[str]:
    """Serve connections by a behaviour; yield the address, ``http://127.0.0.1:PORT``."""
    over = threading.Event()
    with socket.create_server(("127.0.0.1", 0)) as server:
        server.settimeout(0.1)
        thread = threading.Thread(target=_accept, args=(server, behaviour, over), daemon=True)
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.getsockname()[1]}"
        finally:
            over.set()
            with contextlib.suppress(OSError):
                server.shutdown(socket.SHUT_RDWR)  # no need to wait for its next check
            thread.join(5)


def _accept(server: socket.socket, behaviour: Behaviour, over: threading.Event) -> None:
    while not over.is_set():
        try:
            peer, _ = server.accept()
        except OSError:
            continue
        talk = Talk(peer, over)
        threading.Thread(target=_answer, args=(talk, behaviour), daemon=True).start()


def _answer(talk: Talk, behaviour: Behaviour) -> None:
    with talk.peer, contextlib.suppress(OSError, ValueError):
        talk.peer.settimeout(LONGEST)
        if _read(talk):
            behaviour(talk)


def _read(talk: Talk) -> bool:
    """Read a request; return whether it was complete."""
    raw = b""
    while b"\r\n\r\n" not in raw:
        piece = talk.peer.recv(65_536)
        if not piece:
            return False
        raw += piece
    head, _, talk.body = raw.partition(b"\r\n\r\n")
    first, *lines = head.decode("latin-1").split("\r\n")
    talk.method, talk.path, *_ = first.split(" ")
    pairs = (line.partition(":") for line in lines)
    talk.headers = {name.lower(): value.strip() for name, _, value in pairs}
    missing = int(talk.headers.get("content-length", 0)) - len(talk.body)
    while missing > 0:
        piece = talk.peer.recv(65_536)
        if not piece:
            return False
        talk.body += piece
        missing -= len(piece)
    return True


def whole(
    body: bytes, status: str = "200 OK", kind: str = "application/json", more: bytes = b""
) -> bytes:
    head = (
        f"HTTP/1.1 {status}\r\ncontent-type: {kind}\r\ncontent-length: {len(body)}\r\n"
        "connection: close\r\n"
    )
    return head.encode("latin-1", "replace") + more + b"\r\n" + body


def telling(content: bytes, status: str = "200 OK", kind: str = "application/json") -> Behaviour:
    """Return the behaviour of a server with one response to all requests."""
    return lambda talk: talk.send(whole(content, status, kind))


def hostile(rng: random.Random, good: bytes, kind: str) -> Behaviour:
    """Return a behaviour that is slow, endless, cut off or not HTTP."""
    import gzip
    import zlib

    packed = gzip.compress(bytes(200 * 2**20), 6) if rng.random() < 0.03 else gzip.compress(good)
    location = rng.choice((
        b"/", b"//", b"http://[::1", b"https://a\xe2\x84\x80b/x", b"http://127.0.0.1:1/x", b"",
        b"file:///etc/passwd", b"/\x1b[2J", b"\xff\xfe", b"ftp://x/", b"http://:80/", b"?" * 9000,
        b"http://127.0.0.1:99999/", b"http://user:secret@127.0.0.1/", b"http://\x00/",
    ))  # fmt: skip
    status = rng.choice((b"301", b"302", b"303", b"307", b"308", b"300", b"304"))
    moved = b"HTTP/1.1 " + status + b" Moved\r\nlocation: " + location
    moved += b"\r\ncontent-length: 0\r\n\r\n"
    head = b"HTTP/1.1 200 OK\r\ncontent-type: " + kind.encode() + b"\r\n"
    size = rng.choice((b"-1", b"0", b"5", b"999999999999", b"1e3", b"x", b"", b"5, 6", b"\xb2",
                       b"+3", b"1" * 4000))  # fmt: skip
    sent = rng.choice((
        b"", b"\r\n\r\n", b"garbage\r\n\r\n", b"HTTP/9.9 200\r\n\r\n", b"HTTP/1.1 99999 x\r\n\r\n",
        b"HTTP/1.1 200 OK\r\n" + b"x: y\r\n" * 50_000 + b"\r\n", b"HTTP/1.1 \x1b[2J x\r\n\r\n",
        b"HTTP/1.1 200 OK\r\nx: " + b"y" * 300_000 + b"\r\n\r\n", b"HTTP/1.1 200 OK\r\n : \r\n\r\n",
        head + b"content-length: " + size + b"\r\n\r\n" + good,
        head + b"content-length: 5\r\ncontent-length: 6\r\n\r\n" + good,
        head + b"content-length: " + str(len(good) * 2).encode() + b"\r\n\r\n" + good,
        head + b"transfer-encoding: chunked\r\n\r\nzz\r\n" + good,
        head + b"transfer-encoding: chunked\r\n\r\nffffffffffffffff\r\n" + good,
        head + b"transfer-encoding: chunked\r\n\r\n5\r\nab",
        head + b"transfer-encoding: chunked\r\n\r\n5;" + b"x" * 100_000 + b"\r\nabcde\r\n0\r\n\r\n",
        head + b"transfer-encoding: gzip, chunked\r\n\r\n0\r\n\r\n",
        head + b"transfer-encoding: chunked\r\ncontent-length: 3\r\n\r\n3\r\nabc\r\n0\r\n\r\n",
        head + b"content-encoding: gzip\r\nconnection: close\r\n\r\n" + packed,
        head + b"content-encoding: gzip\r\nconnection: close\r\n\r\n" + packed[: len(packed) // 2],
        head + b"content-encoding: deflate, gzip, br, zstd\r\n\r\n" + zlib.compress(good),
        head + b"content-encoding: gzip\r\n\r\n" + good,
        whole(good, rng.choice(("404 x", "500 x", "429 x", "503 x", "204 x", "101 x", "401 x")),
              kind, rng.choice((b"", b"retry-after: 1e9\r\n", b"retry-after: nan\r\n",
                                b"retry-after: -5\r\n", b"retry-after: \xff\r\n"))),
        whole(good, kind=rng.choice(("text/html", "\x1b[2J", "application/json; charset=x",
                                     "multipart/x", "application/json; charset=utf-7", ""))),
        whole(good, more=b"set-cookie: " + b"x" * 5000 + b"\r\n"), whole(good), moved,
    ))  # fmt: skip
    slow: tuple[Behaviour, ...] = (
        lambda talk: talk.forever(b"HTTP/1.1 103 Early Hints\r\nlink: x\r\n\r\n"),
        lambda talk: talk.forever(b"HTTP/1.1 100 Continue\r\n\r\n", 0.001),
        lambda talk: (talk.send(b"HTTP/1.1 200 OK\r\n"), talk.forever(b"x: y\r\n"))[1],
        lambda talk: talk.drip(b"HTTP/1.1 200 OK\r\nx: " + b"y" * 1000),
        lambda talk: (talk.send(head + b"\r\n"), talk.forever(b" "))[1],
        lambda talk: (talk.send(head + b"\r\n"), talk.forever(b" " * 2**20, 0.0))[1],
        lambda talk: (talk.send(head + b"transfer-encoding: chunked\r\n\r\n"),
                      talk.forever(b"1\r\n \r\n"))[1],
        lambda talk: (talk.send(head + b"transfer-encoding: chunked\r\n\r\n"),
                      talk.forever(b"1" * 10))[1],
        lambda talk: (talk.send(head + b"content-length: 500\r\n\r\n"), talk.drip(good * 500))[1],
        lambda talk: (talk.wait(LONGEST), None)[1],
        lambda talk: talk.forever(b"\r\n"),
        lambda talk: (talk.send(head + b"content-encoding: gzip\r\n\r\n"),
                      talk.forever(packed))[1],
    )  # fmt: skip
    if rng.random() < 0.3:
        return rng.choice(slow)
    pieces = rng.random() < 0.1
    return lambda talk: talk.drip(sent, 0.0001) if pieces else talk.send(sent)


def encoded(value: object) -> bytes:
    return json.dumps(value).encode()
