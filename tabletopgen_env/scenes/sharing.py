"""One source of scenes for several threads."""

from __future__ import annotations

import threading
from typing import Any

import numpy as np

from .source import SceneRef, SceneSource, close, record


class SharedScenes:
    """A source that several threads may draw from: one at a time.

    What a draw gives may be gone by the time that it is loaded; an environment then draws again.
    A copy (``pickle``, ``copy.deepcopy``) shares a copy of the source.
    """

    def __init__(self, source: SceneSource) -> None:
        self._source = source
        self._lock = threading.Lock()

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw the next scene."""
        with self._lock:
            return self._source.draw(rng)

    def record(self, ref: SceneRef, success: bool) -> None:
        """Pass on how an episode at a scene ended."""
        with self._lock:
            record(self._source, ref, success)

    def close(self) -> None:
        """Close the source."""
        with self._lock:
            close(self._source)

    def __getstate__(self) -> dict[str, Any]:
        """Return what a copy keeps: no lock."""
        return {"_source": self._source}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__init__(state["_source"])
