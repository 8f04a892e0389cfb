"""Scene sources, their references, and a source shared by threads."""

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
    """A loadable scene. References with equal ``key`` refer to equal scenes.

    ``difficulty``, in [0, 1], is the scene's difficulty, if it is known without loading.
    """

    key: str
    load: Callable[[], Scene]
    difficulty: float | None = None

    def rate(self, difficulty: float) -> SceneRef:
        """Return a copy of the reference that stores the scene's difficulty."""
        return replace(self, difficulty=difficulty)


class HeldRef(SceneRef):
    """A scene in memory, identified by object identity; a copy is another scene."""

    def __init__(self, scene: Scene, difficulty: float | None = None) -> None:
        super().__init__(f"scene:{id(scene)}", lambda: scene, difficulty)

    def rate(self, difficulty: float) -> HeldRef:
        """Return a new reference to the scene that stores its difficulty."""
        return HeldRef(self.load(), difficulty)

    def __reduce__(self) -> tuple[type[HeldRef], tuple[Scene, float | None]]:
        return HeldRef, (self.load(), self.difficulty)


class Remembered(Generic[T]):
    """A cache of facts about up to 10,000 scenes; a copied cache is empty at first.

    Facts about a scene in memory live as long as the scene, since its key can be reused afterwards.
    """

    def __init__(self) -> None:
        self._known: dict[str, tuple[Callable[[], Scene | None], T]] = {}

    def of(self, ref: SceneRef, find: Callable[[SceneRef], T]) -> T:
        """Return the cached result of ``find`` for a scene, calling ``find`` if necessary."""
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
    """A source from which scenes can be drawn.

    The following members are optional:

    - ``refs``: a sequence of the available scenes, any of which can be drawn now;
    - ``admitting(rule)``: returns a source of the scenes that a ``Rule`` admits;
    - ``record(ref, success)``: called at the end of an episode with its success and the reference
      that ``draw`` returned for it; several episodes can run concurrently;
    - ``close()``: stops background work. Repeated calls are allowed; the next draw restarts it.
    """

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw the next scene with ``rng``."""
        ...


def record(source: SceneSource, ref: SceneRef, success: bool) -> None:
    """Report the result of an episode to its source, if the source records results."""
    if (told := getattr(source, "record", None)) is not None:
        told(ref, success)


def close(source: SceneSource) -> None:
    """Stop the background work of a source, if it has any."""
    if (closing := getattr(source, "close", None)) is not None:
        closing()


class SharedScenes:
    """A source that several threads can draw from, one at a time.

    A drawn scene may be gone by the time it is loaded; an environment then draws again. A copy
    (``pickle``, ``copy.deepcopy``) shares a copy of the source.
    """

    def __init__(self, source: SceneSource) -> None:
        self._source = source
        self._lock = threading.Lock()

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw the next scene."""
        with self._lock:
            return self._source.draw(rng)

    def record(self, ref: SceneRef, success: bool) -> None:
        """Forward the result of an episode."""
        with self._lock:
            record(self._source, ref, success)

    def close(self) -> None:
        """Close the source."""
        with self._lock:
            close(self._source)

    def __getstate__(self) -> dict[str, Any]:
        """Return the state to be pickled, without the lock."""
        return {"_source": self._source}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__init__(state["_source"])
