"""Cancellation of a request when its client disconnects or the studio shuts down."""

from __future__ import annotations

import asyncio
import contextlib
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from .changes import Changes

_T = TypeVar("_T")

_GRACE = 0.5  # seconds for requests to finish when the studio ends


async def run_while_wanted(
    request: Request, changes: Changes, work: Callable[[threading.Event], _T]
) -> _T:
    """Run ``work(cancelled)`` in a thread once the request's body is read; return its result.

    The event is set when the client disconnects, the studio ends, or this task is cancelled; the
    work must end soon after. The call returns or raises only after the work has ended, unless the
    task is cancelled.

    Raises:
        ClientDisconnect: the work was cancelled.
    """
    cancelled = threading.Event()
    working = asyncio.ensure_future(asyncio.to_thread(work, cancelled))
    watching = [
        asyncio.create_task(_disconnect(request)),
        asyncio.create_task(changes.wait_closed()),
    ]
    try:
        await asyncio.wait([working, *watching], return_when=asyncio.FIRST_COMPLETED)
        if working.done():
            return working.result()
        cancelled.set()
        with contextlib.suppress(Exception):  # the error of interrupted work
            await working
        raise ClientDisconnect
    finally:
        cancelled.set()
        for task in watching:
            task.cancel()


async def _disconnect(request: Request) -> None:
    while (await request.receive())["type"] != "http.disconnect":
        pass


class EndingRequests:
    """A wrapper of the application that ends requests with an error if the studio shuts down."""

    def __init__(self, app: ASGIApp, changes: Changes) -> None:
        self._app, self._changes = app, changes

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Handle a request."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        started = False

        async def send_noted(message: Message) -> None:
            nonlocal started
            started = True
            await send(message)

        working = asyncio.ensure_future(self._app(scope, receive, send_noted))
        closing = asyncio.create_task(self._changes.wait_closed())
        try:
            await asyncio.wait([working, closing], return_when=asyncio.FIRST_COMPLETED)
            await asyncio.wait([working], timeout=None if working.done() else _GRACE)
            working.cancel()
            await working
        except asyncio.CancelledError:
            if not self._changes.closed:
                raise
            if not started:
                await JSONResponse({"error": "The studio is shutting down."}, 503)(
                    scope, receive, send
                )
        finally:
            closing.cancel()
            working.cancel()


class StudioThreads(ThreadPoolExecutor):
    """The threads of requests. The studio does not wait for them when it shuts down."""

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Reject new work."""
        super().shutdown(wait=False, cancel_futures=True)

    def wait_idle(self, seconds: float) -> bool:
        """Return whether all threads end within the given seconds after a shutdown."""
        end = time.monotonic() + seconds
        for thread in tuple(self._threads):
            thread.join(max(0.0, end - time.monotonic()))
        return not any(thread.is_alive() for thread in self._threads)
