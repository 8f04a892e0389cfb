"""Endless server responses: each call ends at its timeout."""

import gzip
import shutil
import socket
import ssl
import subprocess
import threading
import time
import zlib
from collections.abc import Callable, Iterator
from itertools import repeat
from pathlib import Path

import pytest
from local_server import raw_server
from paid_server import CHAT, Says, ask, serving, session

from generator.calls.http import connections
from generator.calls.http.connections import proxy_for
from generator.errors import BackendError, TabletopError, UnusableError

TIMEOUT = 0.5
SPARE = 10.0
"""Seconds that a machine with much to do may take besides; the servers here never end."""
HEAD = b"HTTP/1.1 200 OK\r\ncontent-type: application/json\r\n"
CHUNKED = HEAD + b"transfer-encoding: chunked\r\n\r\n"

Talk = Callable[[socket.socket], None]


def drips(start: bytes, pieces: Callable[[], Iterator[bytes]], seconds: float = 0.05) -> Talk:
    """Serve ``start``, followed by endless pieces."""

    def talk(line: socket.socket) -> None:
        line.recv(65536)
        line.sendall(start)
        for piece in pieces():
            line.sendall(piece)
            if seconds:
                time.sleep(seconds)

    return talk


def counted(form: str) -> Callable[[], Iterator[bytes]]:
    return lambda: (form.format(k).encode() for k in range(10**9))


ENDLESS = {
    "a status line, byte by byte": drips(b"HTTP/1.1 200 ", lambda: repeat(b"O")),
    "a header, byte by byte": drips(HEAD + b"x-a: ", lambda: repeat(b"a")),
    "hints, slowly": drips(b"", lambda: repeat(b"HTTP/1.1 103 Early Hints\r\n\r\n")),
    "hints, fast": drips(b"", lambda: repeat(b"HTTP/1.1 103 Early Hints\r\n\r\n" * 50), 0),
    "headers, slowly": drips(HEAD, counted("x-{}: 1\r\n")),
    "headers, fast": drips(HEAD, counted("x-{}: 1\r\n"), 0),
    "one header, fast": drips(HEAD + b"x-a: ", lambda: repeat(b"a" * 4096), 0),
    "a chunk's extension": drips(
        CHUNKED + b"1;x=", lambda: repeat(b"a")
    ),
    "chunks with extensions": drips(CHUNKED, lambda: repeat(b"1;x=aaaaaaaaaa\r\n1\r\n"), 0),
    "chunks, slowly": drips(
        CHUNKED, lambda: repeat(b"1\r\n1\r\n")
    ),
    "trailers": drips(
        CHUNKED + b"0\r\n", counted("x-{}: 1\r\n")
    ),
    "a body, byte by byte": drips(HEAD + b"content-length: 99999\r\n\r\n", lambda: repeat(b"1")),
    "a body without an end": drips(HEAD + b"\r\n", lambda: repeat(b"1")),
    "nothing": lambda line: [line.recv(65536) for _ in range(2)] and None,
    "redirects": drips(
        b"", lambda: repeat(b"HTTP/1.1 307 On\r\nlocation: /on\r\ncontent-length: 0\r\n\r\n")
    ),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("talk", ENDLESS.values(), ids=ENDLESS)
def test_a_server_without_an_end_is_left_in_time(talk: Talk) -> None:
    before = set(threading.enumerate())
    shared = session(attempts=1)
    with raw_server(talk) as url:
        began = time.monotonic()
        with pytest.raises(BackendError, match="cloud, plan_scene"):
            ask(shared, url, timeout=TIMEOUT, most_bytes=2**20)
        assert time.monotonic() - began < TIMEOUT + SPARE
    assert not [t for t in set(threading.enumerate()) - before if t.name == "call"]
    assert [entry.outcome for entry in shared.account.entries] == ["failed"]


@pytest.mark.slow
def test_a_handshake_byte_by_byte_is_left_in_time() -> None:
    def talk(line: socket.socket) -> None:
        line.recv(65536)
        line.sendall(b"\x16\x03\x03\x40\x00")
        while True:
            line.sendall(b"\x00")
            time.sleep(0.05)

    with raw_server(talk) as url:
        began = time.monotonic()
        with pytest.raises(BackendError, match="did not accept the connection"):
            ask(session(attempts=1), url.replace("http:", "https:"), timeout=TIMEOUT)
        assert time.monotonic() - began < TIMEOUT + SPARE


@pytest.mark.slow
def test_a_name_that_is_looked_up_for_ever_is_left_in_time(monkeypatch: pytest.MonkeyPatch) -> None:
    asked, done = threading.Event(), threading.Event()

    def lookup(*given: object, **more: object) -> list:
        asked.set()
        done.wait(60)
        return []

    monkeypatch.setattr("socket.getaddrinfo", lookup)
    began = time.monotonic()
    try:
        with pytest.raises(BackendError, match="did not accept the connection"):
            ask(session(attempts=1), "http://127.0.0.1:9", timeout=TIMEOUT)
    finally:
        done.set()
    assert asked.is_set()
    assert time.monotonic() - began < TIMEOUT + SPARE


@pytest.mark.slow
def test_an_address_that_takes_no_call_leaves_time_to_the_next(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """As in a network without IPv6, for a host that lists an IPv6 address first."""
    waited = []

    class Deaf(socket.socket):
        def connect(self, address: tuple[str, int]) -> None:
            if address[0] == "127.0.0.2":
                waited.append(self.gettimeout())
                time.sleep(self.gettimeout() or 60)
                raise TimeoutError
            super().connect(address)

    with socket.create_server(("127.0.0.1", 0)) as heard:
        port, places = heard.getsockname()[1], ("127.0.0.2", "127.0.0.1")
        monkeypatch.setattr("socket.socket", Deaf)
        connections.connect_any(places, port, time.monotonic() + TIMEOUT).close()
    assert 0 < waited[0] <= TIMEOUT / 2


@pytest.mark.slow
def test_a_redirect_is_bounded_by_the_time_of_the_call() -> None:
    def script(asked: object, k: int) -> Says:
        return Says(status=307, headers=(("location", "/on"),), delay=0.3)

    with serving(script) as server:
        began = time.monotonic()
        with pytest.raises(BackendError, match="did not respond within"):
            ask(session(attempts=1), server.url, timeout=TIMEOUT)
        assert time.monotonic() - began < TIMEOUT + SPARE
    assert len(server.asked) == 2


@pytest.mark.parametrize(
    "location",
    [
        "http://[::1", "https://a\u2100b/x", "http://xn--a/", "file:///etc/passwd", "//:0",
        "http://127.0.0.1:99999999/", "http://user:pass@{host}/x", "http://{host}\\@other/",
        "javascript:x", "\x01", "http://" + "a" * 60_000,
    ],
)  # fmt: skip
def test_a_redirect_to_no_address_is_told(location: str) -> None:
    def script(asked: object, k: int) -> Says:
        host = server.url.partition("//")[2]
        where = location.replace("{host}", host).encode().decode("latin-1")
        return Says(status=307, headers=(("location", where),)) if k == 0 else Says()

    with serving(script) as server, pytest.raises(BackendError, match=r"redirects to|ended early"):
        ask(session(attempts=1), server.url)
    assert len(server.asked) == 1


@pytest.mark.parametrize("how", ["gzip", "deflate", "bare deflate"])
def test_a_compressed_answer_is_decompressed(how: str) -> None:
    plain = b'{"choices": []}'
    packed = {
        "gzip": gzip.compress(plain),
        "deflate": zlib.compress(plain),
        "bare deflate": zlib.compress(plain)[2:-4],
    }[how]
    said = Says(packed, headers=(("content-encoding", how.split()[-1]),))
    with serving([said]) as server:
        assert ask(session(), server.url).json() == {"choices": []}


def test_what_was_compressed_twice_or_oddly_is_not_decompressed() -> None:
    bomb = gzip.compress(gzip.compress(bytes(10_000_000)))
    for packed in ("gzip, gzip", "br", "zstd"):
        said = Says(bomb, headers=(("content-encoding", packed),))
        with serving([said]) as server, pytest.raises(UnusableError, match="uses the compression"):
            ask(session(), server.url)


def test_a_compressed_answer_that_is_cut_or_damaged_broke_off() -> None:
    for body in (gzip.compress(b"{}")[:-4], b"no gzip at all"):
        said = Says(body, headers=(("content-encoding", "gzip"),))
        with serving([said]) as server, pytest.raises(BackendError, match="ended early"):
            ask(session(attempts=1), server.url)


@pytest.mark.parametrize("kind", ["text/plain; charset=idna", "text/plain; charset=undefined"])
def test_a_server_does_not_choose_how_its_text_is_decoded(kind: str) -> None:
    with serving([Says(b"{}", kind=kind)]) as server:
        assert ask(session(), server.url).text == "{}"


@pytest.mark.parametrize("body", [b"[" * 100_000, b'{"a":' * 5_000, b'{"a": NaN}', b"1" * 9999])
def test_an_answer_that_is_no_bounded_json_is_told(body: bytes) -> None:
    with serving([Says(body)]) as server, pytest.raises(BackendError, match="not valid JSON"):
        ask(session(attempts=1), server.url)


def test_a_count_of_any_size_is_entered() -> None:
    usage = {"prompt_tokens": int("9" * 4000), "completion_tokens": "8" * 9999}
    shared = session()
    with serving([Says({**CHAT, "usage": usage})]) as server:
        ask(shared, server.url)
    (entry,) = shared.account.entries
    assert (entry.tokens_in, entry.tokens_out) == (10**12, 0)


def test_a_refusal_of_any_size_is_shown_in_time_and_without_the_key() -> None:
    key = "sk-" + "k" * 40
    body = b"sk-" * 300_000 + key.encode()
    shared = session(attempts=1)
    with (
        serving([Says(body, status=400, kind="text/plain")]) as server,
        shared.client("cloud", server.url, secrets=(key,)) as client,
    ):
        began = time.monotonic()
        told = client.post("/v1", json={}).text
        assert time.monotonic() - began < 10
    assert len(told) < 20_000 and key not in told


def test_an_https_server_is_spoken_to(tmp_path: Path) -> None:
    if shutil.which("openssl") is None:
        pytest.skip("no openssl to make a certificate with")
    pem = tmp_path / "server.pem"
    subprocess.run(
        ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256",
         "-nodes", "-days", "2", "-subj", "/CN=localhost", "-addext",
         "subjectAltName=IP:127.0.0.1", "-keyout", str(pem), "-out", str(tmp_path / "cert.pem")],
        check=True, capture_output=True, timeout=60,
    )  # fmt: skip
    server = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    server.load_cert_chain(tmp_path / "cert.pem", pem)
    body = b'{"long": "' + b"x" * 300_000 + b'"}'

    def talk(line: socket.socket) -> None:
        with server.wrap_socket(line, server_side=True) as tls:
            asked = b""
            while b"what is there?" not in asked:
                asked += tls.recv(65536)
            tls.sendall(HEAD + b"content-length: %d\r\n\r\n" % len(body) + body)

    with raw_server(talk) as url:
        shared, address = session(attempts=1), url.replace("http:", "https:")
        with pytest.raises(BackendError, match=r"cannot be reached.*certificate"):
            ask(shared, address)
        shared.trust.load_verify_locations(tmp_path / "cert.pem")
        assert len(ask(shared, address).content) == len(body)


def test_the_proxy_of_the_environment_is_used(monkeypatch: pytest.MonkeyPatch) -> None:
    heard: list[bytes] = []

    def talk(line: socket.socket) -> None:
        heard.append(line.recv(65536))
        line.sendall(HEAD + b"content-length: 2\r\n\r\n{}")

    with raw_server(talk) as url:
        monkeypatch.setenv("http_proxy", url.replace("//", "//me:secret@"))
        monkeypatch.setenv("no_proxy", "elsewhere.test")
        assert proxy_for("http", "elsewhere.test") is None
        assert ask(session(), "http://models.test").content == b"{}"
    assert heard[0].startswith(b"POST http://models.test/v1/chat ")
    assert b"proxy-authorization: basic" in heard[0].lower()


@pytest.mark.parametrize("proxy", ["socks5://h:1", "ftp://h", "http://[::1", "http://h:99999"])
def test_a_proxy_that_cannot_be_used_is_told(monkeypatch: pytest.MonkeyPatch, proxy: str) -> None:
    monkeypatch.setenv("https_proxy", proxy)
    with pytest.raises(TabletopError, match="proxy"):
        session().client("cloud", "https://models.test")
