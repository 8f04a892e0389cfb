"""Notification of waiting tasks about changes to the studio's state."""

from __future__ import annotations

import asyncio


class Changes:
    """A notifier that wakes the waiting tasks of one event loop at each change and at shutdown.

    Attributes:
        closed: whether the studio has ended; waiters then stop.
    """

    def __init__(self) -> None:
        self.closed = False
        self._next = asyncio.Event()

    def close(self) -> None:
        """Signal that the studio is shutting down."""
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
        """Wait until the studio shuts down."""
        while not self.closed:
            await self.next().wait()
