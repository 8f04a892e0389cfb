"""Scene sources, the references they draw, and a source shared by threads."""

from __future__ import annotations

import threading
import weakref
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Generic, Protocol, TypeVar, runtime_checkable

import numpy as np

from generator.scene import Scene

T = TypeVar("T")

_REMEMBERED = 10_000


@dataclass(frozen=True, eq=False)
class SceneRef:
    """One scene that can be loaded. Equal ``key`` means the same scene.

    ``difficulty``, in [0, 1], is how hard it is to work at, where that is known without loading.
    """

    key: str
    load: Callable[[], Scene]
    difficulty: float | None = None

    def rate(self, difficulty: float) -> SceneRef:
        """Return the reference with how hard the scene is."""
        return replace(self, difficulty=difficulty)


class HeldRef(SceneRef):
    """A scene in memory, known by being the very same one; a copy elsewhere is another."""

    def __init__(self, scene: Scene, difficulty: float | None = None) -> None:
        super().__init__(f"scene:{id(scene)}", lambda: scene, difficulty)

    def rate(self, difficulty: float) -> HeldRef:
        """Return the reference with how hard the scene is."""
        return HeldRef(self.load(), difficulty)

    def __reduce__(self) -> tuple[type[HeldRef], tuple[Scene, float | None]]:
        return HeldRef, (self.load(), self.difficulty)


class Remembered(Generic[T]):
    """What was found out about scenes, each once, of some ten thousand; a copy knows nothing.

    Of a scene in memory it is kept as long as the scene, whose key another may have afterwards.
    """

    def __init__(self) -> None:
        self._known: dict[str, tuple[Callable[[], Scene | None], T]] = {}

    def of(self, ref: SceneRef, find: Callable[[SceneRef], T]) -> T:
        """Return what ``find`` says of a scene, or has said."""
        scene = ref.load() if isinstance(ref, HeldRef) else None
        known = self._known.get(ref.key)
        if known is None or known[0]() is not scene:
            if len(self._known) >= _REMEMBERED:
                self._known.clear()
            known = ((lambda: None) if scene is None else weakref.ref(scene)), find(ref)
            self._known[ref.key] = known
        return known[1]

    def __reduce__(self) -> tuple[type[Remembered[T]], tuple[()]]:
        return type(self), ()


@runtime_checkable
class SceneSource(Protocol):
    """Anything that can draw a scene.

    A source may have more; what is there is used:

    - ``refs``: a sequence of the scenes at hand, any of which it could draw now;
    - ``admitting(rule)``: returns the source of only those of its scenes that a ``Rule`` admits;
    - ``record(ref, success)``: is told at the end of an episode whether the task succeeded, and
      the reference that ``draw`` gave for it: several episodes may be under way at the same time;
    - ``close()``: ends what it has running. May be called twice; the next draw starts it anew.
    """

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw the next scene with ``rng``."""
        ...


def record(source: SceneSource, ref: SceneRef, success: bool) -> None:
    """Tell a source how an episode at a scene of its ended, if it wants to know."""
    if (told := getattr(source, "record", None)) is not None:
        told(ref, success)


def close(source: SceneSource) -> None:
    """End what a source has running, if it can have anything running."""
    if (closing := getattr(source, "close", None)) is not None:
        closing()


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
