"""Binding of the port, and the server loop until Ctrl-C."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import sys
import threading
import webbrowser
from collections.abc import Callable, Iterator
from types import FrameType
from typing import cast

import uvicorn
from starlette.types import ASGIApp
from uvicorn.protocols.http.h11_impl import H11Protocol, RequestResponseCycle

from generator.errors import BackendError

from .cancellation import StudioThreads
from .guard import Access

_GRACE = 2  # seconds for pending responses at the end
_IDLE = 0.5  # further seconds for threads of requests
_HEAD = 15.0  # time limit of a request's head, seconds


@contextlib.contextmanager
def bind(host: str, port: int) -> Iterator[socket.socket]:
    """Yield a listening socket.

    Raises:
        BackendError: the port is taken, or the host is not an address of this machine.
    """
    try:
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        listening = socket.create_server((host, port), family=family, backlog=128)
    except (OSError, OverflowError) as error:
        raise BackendError(
            f"Port {port} of {host} cannot be used ({getattr(error, 'strerror', None) or error}). "
            "Choose another --port, or 0 for any free one."
        ) from error
    with listening:
        yield listening


class HastyProtocol(H11Protocol):
    """A protocol that frees connections on which no complete request head arrives in time."""

    def connection_made(self, transport: asyncio.Transport) -> None:
        """Start waiting for a request."""
        super().connection_made(transport)
        self._late: asyncio.TimerHandle | None = None
        self._wait()

    def data_received(self, data: bytes) -> None:
        """Process received data; wait until the head of a request is complete."""
        super().data_received(data)
        cycle = cast("RequestResponseCycle | None", self.cycle)
        if cycle is not None and not cycle.response_complete:
            self._stop_waiting()
        elif self._late is None:
            self._wait()

    def connection_lost(self, exc: Exception | None) -> None:
        """Stop waiting."""
        self._stop_waiting()
        super().connection_lost(exc)

    def _wait(self) -> None:
        self._late = self.loop.call_later(_HEAD, self.transport.close)

    def _stop_waiting(self) -> None:
        if self._late is not None:
            self._late.cancel()
            self._late = None


class _Server(uvicorn.Server):
    """A server that notifies the application of a shutdown before all responses are sent."""

    def __init__(self, config: uvicorn.Config, stop: Callable[[], None]) -> None:
        super().__init__(config)
        self._stop = stop

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        self._stop()
        super().handle_exit(sig, frame)


def serve(
    app: ASGIApp, listening: socket.socket, access: Access, browse: bool, stop: Callable[[], None]
) -> bool:
    """Serve requests until the process is interrupted; then call ``stop`` and end.

    Returns whether a thread of a request is still busy, which prevents a normal exit.

    Raises:
        BackendError: the application cannot start.
    """
    config = uvicorn.Config(
        app, log_level="warning", access_log=False, server_header=False, proxy_headers=False,
        ws="none", http=HastyProtocol, loop="asyncio", lifespan="on", timeout_keep_alive=30,
        timeout_graceful_shutdown=_GRACE, limit_concurrency=512,
    )  # fmt: skip
    print(f"Open {access.link}", flush=True)
    for study in access.studies:
        print(f"Address for raters of study {study}: {access.study_link(study)}", flush=True)
    print("Ctrl-C stops the studio; running jobs restart with the next one.",
          file=sys.stderr)  # fmt: skip
    if browse:
        opened = (access.ticket_link,)
        threading.Thread(target=webbrowser.open, args=opened, daemon=True).start()
    server, threads = _Server(config, stop), StudioThreads()

    async def answer_all() -> None:
        asyncio.get_running_loop().set_default_executor(threads)
        await server.serve(sockets=[listening])

    with contextlib.suppress(KeyboardInterrupt):
        asyncio.run(answer_all())
    if not server.started:
        raise BackendError("The studio could not start; see the messages above.")
    return not threads.wait_idle(_IDLE)
