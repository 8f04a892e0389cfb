"""Changes of a studio's state, that many wait for."""

from __future__ import annotations

import asyncio


class Changes:
    """Lets many wait for the next change, in one event loop, until the studio ends.

    Attributes:
        closed: whether it ends; who waits then stops.
    """

    def __init__(self) -> None:
        self.closed = False
        self._next = asyncio.Event()

    def close(self) -> None:
        """Say that the studio ends."""
        self.closed = True
        self.notify()

    def notify(self) -> None:
        """Say that something changed."""
        self._next.set()
        self._next = asyncio.Event()

    def next(self) -> asyncio.Event:
        """Return what is set by the next change."""
        return self._next

    async def wait_closed(self) -> None:
        """Wait until the studio ends."""
        while not self.closed:
            await self.next().wait()
