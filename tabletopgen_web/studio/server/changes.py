"""Notification of waiting tasks about changes to the studio's state."""

from __future__ import annotations

import asyncio


class Changes:
    """Lets many tasks in one event loop wait for the next change, until the studio ends.

    Attributes:
        closed: whether the studio has ended; waiters then stop.
    """

    def __init__(self) -> None:
        self.closed = False
        self._next = asyncio.Event()

    def close(self) -> None:
        """Signal the end of the studio."""
        self.closed = True
        self.notify()

    def notify(self) -> None:
        """Signal a change."""
        self._next.set()
        self._next = asyncio.Event()

    def next(self) -> asyncio.Event:
        """Return the event that the next change sets."""
        return self._next

    async def wait_closed(self) -> None:
        """Wait until the studio ends."""
        while not self.closed:
            await self.next().wait()
