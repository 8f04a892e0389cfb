"""CPU time that several calls share."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass
class CpuBudget:
    """Seconds of CPU time that are left for the calls of one input, such as all files of a folder.

    A call that ends at a limit, or in a crash, counts as all the time that it was allowed. The
    budget decides whether another call is made, never what a call returns.
    """

    left: float

    def charge(self, seconds: float) -> None:
        """Take the time of a call from what is left."""
        self.left = max(0.0, self.left - seconds)
