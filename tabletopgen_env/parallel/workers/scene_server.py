"""A single scene source that serves the slots of several processes.

A source whose draws depend only on the generator (``FixedScenes``, ``FreshScenes``) is copied to
each process. Any other source stays with the vector environment, so that its pool or curriculum is
common to all slots: a process sends it the slot's generator and receives a scene reference.
"""

from __future__ import annotations

import itertools
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import cloudpickle
import numpy as np

from generator.errors import InputError
from generator.language.distribution import Needs
from generator.scene import Scene

from ...scenes import (
    FixedScenes,
    FreshScenes,
    SceneChoice,
    SceneRef,
    SceneSource,
    SharedScenes,
    resolve,
)
from ...scenes.source import HeldRef, Remembered, record
from .pickling import make_portable

_KEPT = 4096  # lent references; each slot has one at a time


@dataclass(frozen=True)
class Wish:
    """A request to a scene source, either to draw a scene with ``rng`` or to record a result.

    ``key`` identifies the scene whose episode ended; ``success`` is its result.
    """

    rng: np.random.Generator | None = None
    key: str = ""
    success: bool = False


def is_lent(source: object) -> bool:
    """Return whether a source must stay in one process, as its draws need more than ``rng``."""
    return isinstance(source, SceneSource) and type(source) not in (FixedScenes, FreshScenes)


def shared_scene(
    scene: SceneChoice, needs: Needs, start: SceneChoice, processes: bool
) -> SceneChoice:
    """Return the ``reset`` option "scene" in a form that all slots can use.

    Slots draw one at a time from a source that must stay in one place.

    Raises:
        InputError: the scene is such a source or names one, and the slots are in several processes.
        BundleError: no bundle matches.
    """
    source = resolve(scene, needs, start)
    if not is_lent(source):
        return scene
    if processes:
        raise InputError(
            f"The option 'scene' cannot be a {type(source).__name__} for slots in several "
            "processes, since each process would have its own copy. Pass it as scenes= when "
            "creating the vector environment, or use fixed scenes."
        )
    return SharedScenes(source)


class AskedScenes:
    """A proxy for a scene source in another process; ``connect`` sets the function for requests.

    A copy must be connected before use.
    """

    def __init__(self) -> None:
        self._ask: Callable[[Wish], Any] | None = None

    def connect(self, ask: Callable[[Wish], Any]) -> None:
        """Set the function that sends a request and then returns the answer or raises the error."""
        self._ask = ask

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw the next scene."""
        assert self._ask is not None
        ref, state = self._ask(Wish(rng))
        rng.bit_generator.state = state
        return ref

    def record(self, ref: SceneRef, success: bool) -> None:
        """Forward the result of an episode."""
        assert self._ask is not None
        self._ask(Wish(key=ref.key, success=success))

    def __reduce__(self) -> tuple[type[AskedScenes], tuple[()]]:
        return type(self), ()


class LentScenes:
    """A scene source that serves requests from other processes."""

    def __init__(self, source: SceneSource) -> None:
        self._source = source
        self._names = Remembered[str]()
        self._numbers = itertools.count()
        self._lent: OrderedDict[str, SceneRef] = OrderedDict()

    def fulfil(self, wish: Wish) -> bytes:
        """Return the pickled answer to a request: whether it succeeded, and its value or error."""
        try:
            if wish.rng is None:
                if (lent := self._lent.get(wish.key)) is not None:
                    record(self._source, lent, wish.success)
                return cloudpickle.dumps((True, None))
            ref = self._source.draw(wish.rng)
            return self._pack(ref, wish.rng.bit_generator.state)
        except Exception as error:
            return cloudpickle.dumps((False, make_portable(error)))

    def _pack(self, ref: SceneRef, state: Any) -> bytes:
        """Pickle a reference; include the scene if other processes cannot load it."""
        if not isinstance(ref, HeldRef):
            self._keep(ref.key, ref)
            try:
                return cloudpickle.dumps((True, (ref, state)))
            except Exception:  # pickling may raise any exception
                sent = SceneRef(ref.key, _Sent(ref.load()), ref.difficulty)
        else:
            key = self._names.of(ref, lambda _: f"lent:{next(self._numbers)}")
            sent = SceneRef(key, _Sent(ref.load()), ref.difficulty)
            self._keep(key, ref)
        return cloudpickle.dumps((True, (sent, state)))

    def _keep(self, key: str, ref: SceneRef) -> None:
        """Keep a reference until its episode has ended; beyond a limit, drop the oldest one."""
        self._lent[key] = ref
        self._lent.move_to_end(key)
        while len(self._lent) > _KEPT:
            self._lent.popitem(last=False)


@dataclass(frozen=True, eq=False)
class _Sent:
    """A loader of the scene that was sent together with its reference."""

    scene: Scene

    def __call__(self) -> Scene:
        return self.scene
