"""Job events as server-sent events; clients that read too slowly are disconnected."""

from __future__ import annotations

import asyncio
import json

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route
from starlette.types import Receive, Scope, Send

from generator.errors import InputError

from ..contracts import encode
from ..refusals import RefusedError
from ..server.services import StudioServices, services_of

HEARTBEAT = 15.0
"""Seconds without an event after which a comment is sent."""

SLOW = 10.0
"""Maximum seconds for a client to read a message."""


async def listen(request: Request) -> Response:
    """Stream the events after ``since``, or after the client's last event, and then new ones."""
    services = services_of(request)
    if services.listeners.locked():
        raise RefusedError(503, "Too many pages are connected to this studio. Close some of them.")
    position = request.headers.get("last-event-id") or request.query_params.get("since") or "0"
    if not position.isascii() or not position.isdecimal() or len(position) > 15:
        raise InputError(f"since must be the number of an event, not {position[:40]!r}.")
    since = int(position)
    if since > services.store.last_event:  # of another studio's folder
        since = 0
    return EventStream(services, since)


class EventStream(Response):
    """A stream of events until the client disconnects or reads too slowly."""

    def __init__(self, services: StudioServices, since: int) -> None:
        super().__init__(media_type="text/event-stream; charset=utf-8")
        self._services, self._since = services, since

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Handle the request."""
        headers = [(k, v) for k, v in self.raw_headers if k != b"content-length"]
        await send({"type": "http.response.start", "status": 200, "headers": headers})
        async with self._services.listeners:
            sending = asyncio.create_task(self._send(send))
            leaving = asyncio.create_task(_wait_for_leaving(receive))
            try:
                await asyncio.wait([sending, leaving], return_when=asyncio.FIRST_COMPLETED)
            finally:
                for task in (sending, leaving):
                    task.cancel()
                await asyncio.gather(sending, leaving, return_exceptions=True)

    async def _send(self, send: Send) -> None:
        await _write(send, b"retry: 1000\n\n")
        while True:
            change = self._services.changes.next()
            events = self._services.store.events(self._since)
            if self._services.changes.closed:
                await send({"type": "http.response.body", "body": b"", "more_body": False})
                return
            if events:
                lines = [f"id: {e.seq}\ndata: {json.dumps(encode(e))}\n\n" for e in events]
                await _write(send, "".join(lines).encode())
                self._since = events[-1].seq
                continue
            try:
                await asyncio.wait_for(change.wait(), HEARTBEAT)
            except TimeoutError:
                await _write(send, b": still here\n\n")


async def _write(send: Send, content: bytes) -> None:
    async with asyncio.timeout(SLOW):
        await send({"type": "http.response.body", "body": content, "more_body": True})


async def _wait_for_leaving(receive: Receive) -> None:
    while (await receive())["type"] != "http.disconnect":
        pass


ROUTES = (Route("/api/events", listen, methods=["GET"]),)
