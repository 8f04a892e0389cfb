"""Listening: a port that is this server's, and serving until Ctrl-C."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import sys
import threading
import webbrowser
from collections.abc import Callable, Iterator
from types import FrameType

import uvicorn
from starlette.types import ASGIApp

from generator.errors import BackendError

from .guard import Access

_GRACE = 2  # seconds that answers under way have at the end


@contextlib.contextmanager
def bind(host: str, port: int) -> Iterator[socket.socket]:
    """Yield a socket that listens.

    Raises:
        BackendError: the port is taken, or the host is not this machine's.
    """
    try:
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        listening = socket.create_server((host, port), family=family, backlog=128)
    except (OSError, OverflowError) as error:
        raise BackendError(
            f"Port {port} of {host} cannot be used ({getattr(error, 'strerror', None) or error}). "
            "Choose another --port, or 0 for any that is free."
        ) from error
    with listening:
        yield listening


class _Server(uvicorn.Server):
    """Tells the application at once that the process is to end, not once all answers are sent."""

    def __init__(self, config: uvicorn.Config, stop: Callable[[], None]) -> None:
        super().__init__(config)
        self._stop = stop

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        self._stop()
        super().handle_exit(sig, frame)


def serve(
    app: ASGIApp, listening: socket.socket, access: Access, browse: bool, stop: Callable[[], None]
) -> None:
    """Answer requests until the process is interrupted; then call ``stop`` and end.

    Raises:
        BackendError: the application cannot begin.
    """
    config = uvicorn.Config(
        app, log_level="warning", access_log=False, server_header=False, proxy_headers=False,
        ws="none", http="h11", loop="asyncio", lifespan="on", timeout_keep_alive=30,
        timeout_graceful_shutdown=_GRACE, limit_concurrency=512,
    )  # fmt: skip
    print(f"Open {access.link}", flush=True)
    for study in access.studies:
        print(f"Raters of study {study} open {access.study_link(study)}", flush=True)
    print("Ctrl-C ends the studio; jobs that run then begin again with the next one.",
          file=sys.stderr)  # fmt: skip
    if browse:
        threading.Thread(target=webbrowser.open, args=(access.link,), daemon=True).start()
    server = _Server(config, stop)
    with contextlib.suppress(KeyboardInterrupt):
        asyncio.run(server.serve(sockets=[listening]))
    if not server.started:
        raise BackendError("The studio could not begin; what is above says why.")
