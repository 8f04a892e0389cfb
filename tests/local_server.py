"""Local servers for tests: a request handler, served until the test is done."""

import contextlib
import socket
import sys
import threading
from collections.abc import Callable, Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any


class Server(ThreadingHTTPServer):
    """A server that ignores disconnected clients."""

    daemon_threads = True

    def handle_error(self, *request: Any) -> None:
        if not isinstance(sys.exception(), ConnectionError):
            super().handle_error(*request)


def sent_to(handler: BaseHTTPRequestHandler) -> bytes:
    """Return the body of a request.

    Raises:
        ConnectionError: the client went away before it was whole, as one that is killed does.
    """
    size = int(handler.headers.get("content-length", 0))
    body = handler.rfile.read(size)
    if len(body) < size:
        raise ConnectionError(f"{len(body)} of {size} bytes came")
    return body


@contextlib.contextmanager
def local_server(handler: type[BaseHTTPRequestHandler]) -> Iterator[str]:
    """Serve on a free local port; yield the address, ``http://127.0.0.1:PORT``."""
    server = Server(("127.0.0.1", 0), handler)
    thread = threading.Thread(target=server.serve_forever, args=(0.01,), daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}"
    finally:
        server.shutdown()
        server.server_close()
        thread.join(60)


@contextlib.contextmanager
def raw_server(talk: Callable[[socket.socket], None]) -> Iterator[str]:
    """Call ``talk`` for each raw connection; yield the address.

    Connections are cut at the end of the test: who still talks then gets an ``OSError``.
    """
    open_: list[socket.socket] = []
    threads: list[threading.Thread] = []

    def serve(line: socket.socket) -> None:
        with line, contextlib.suppress(OSError):
            talk(line)

    def accept() -> None:
        with contextlib.suppress(OSError):
            while True:
                line, _ = listening.accept()
                line.settimeout(10)
                open_.append(line)
                threads.append(threading.Thread(target=serve, args=(line,), daemon=True))
                threads[-1].start()

    with socket.create_server(("127.0.0.1", 0)) as listening:
        thread = threading.Thread(target=accept, daemon=True)
        thread.start()
        try:
            yield f"http://127.0.0.1:{listening.getsockname()[1]}"
        finally:
            with contextlib.suppress(OSError):
                listening.shutdown(socket.SHUT_RDWR)
            for line in open_:
                with contextlib.suppress(OSError):
                    line.shutdown(socket.SHUT_RDWR)
            for one in (thread, *threads):
                one.join(10)
