"""What a source of scenes is, and the references it draws."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np

from generator.scene import Scene


@dataclass(frozen=True, eq=False)
class SceneRef:
    """One scene that can be loaded. Equal ``key`` means the same scene.

    ``difficulty``, in [0, 1], is how hard it is to work at, where that is known without loading.
    """

    key: str
    load: Callable[[], Scene]
    difficulty: float | None = None


@runtime_checkable
class SceneSource(Protocol):
    """Anything that can draw a scene.

    A source may have more; what is there is used:

    - ``refs``: a sequence of the scenes at hand, any of which it could draw now;
    - ``admitting(rule)``: returns the source of only those of its scenes that a ``Rule`` admits;
    - ``record(success)``: is told at the end of an episode whether the task succeeded;
    - ``close()``: ends what it has running. May be called twice; the next draw starts it anew.
    """

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw the next scene with ``rng``."""
        ...


def record(source: SceneSource, success: bool) -> None:
    """Tell a source how an episode ended, if it wants to know."""
    told = getattr(source, "record", None)
    if told is not None:
        told(success)


def close(source: SceneSource) -> None:
    """End what a source has running, if it can have anything running."""
    closing = getattr(source, "close", None)
    if closing is not None:
        closing()
