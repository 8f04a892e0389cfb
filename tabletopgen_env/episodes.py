"""When an episode is a success: the same for certificates, demonstrations and benchmarks."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

HOLD = 10
"""Steps in a row for which ``info["success"]`` has to hold."""


class Held:
    """Tells when a success has held; made for one episode and told of each of its steps.

    Args:
        steps: for how many steps in a row it has to hold.
    """

    def __init__(self, steps: int = HOLD) -> None:
        self._steps = steps
        self._in_a_row = 0

    def after(self, info: Mapping[str, Any]) -> bool:
        """Return whether success has held, now that a step gave ``info``."""
        self._in_a_row = self._in_a_row + 1 if info["success"] else 0
        return self._in_a_row >= self._steps
