"""One scene source for the slots of several processes: it is asked for each scene.

A source whose draws depend on the generator alone (``FixedScenes``, ``FreshScenes``) is copied to
each process. Any other stays where the vector environment is, so that it is renewed, or made
harder, for all slots together: a process sends it the slot's generator, and is sent the reference.
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

_KEPT = 4096  # references that are lent; each slot has one at a time


@dataclass(frozen=True)
class Wish:
    """What a process wants of the source: a scene, drawn with ``rng``, or that it records.

    ``key`` is of the scene whose episode ended, with ``success`` or without.
    """

    rng: np.random.Generator | None = None
    key: str = ""
    success: bool = False


def is_lent(source: object) -> bool:
    """Tell whether a source is to stay in one place: its draws depend on more than a generator."""
    return isinstance(source, SceneSource) and type(source) not in (FixedScenes, FreshScenes)


def shared_scene(
    scene: SceneChoice, needs: Needs, start: SceneChoice, processes: bool
) -> SceneChoice:
    """Return the option "scene" of a reset as all slots may be given it.

    A source that has to stay in one place is drawn from by one slot at a time.

    Raises:
        InputError: it is such a source, or means one, and the slots are in several processes.
        BundleError: no bundle fits.
    """
    source = resolve(scene, needs, start)
    if not is_lent(source):
        return scene
    if processes:
        raise InputError(
            f"The option 'scene' cannot be a {type(source).__name__} for slots in several "
            "processes, each of which would have its own. Pass it as scenes= when the vector "
            "environment is made, or name fixed scenes."
        )
    return SharedScenes(source)


class AskedScenes:
    """The scenes of a source in another process; ``connect`` says how it is asked.

    A copy has to be connected first.
    """

    def __init__(self) -> None:
        self._ask: Callable[[Wish], Any] | None = None

    def connect(self, ask: Callable[[Wish], Any]) -> None:
        """Ask by a function, which returns the answer or raises its error."""
        self._ask = ask

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw the next scene."""
        assert self._ask is not None
        ref, state = self._ask(Wish(rng))
        rng.bit_generator.state = state
        return ref

    def record(self, ref: SceneRef, success: bool) -> None:
        """Pass on how an episode at a scene ended."""
        assert self._ask is not None
        self._ask(Wish(key=ref.key, success=success))

    def __reduce__(self) -> tuple[type[AskedScenes], tuple[()]]:
        return type(self), ()


class LentScenes:
    """A source as it is lent to other processes."""

    def __init__(self, source: SceneSource) -> None:
        self._source = source
        self._names = Remembered[str]()
        self._numbers = itertools.count()
        self._lent: OrderedDict[str, SceneRef] = OrderedDict()

    def fulfil(self, wish: Wish) -> bytes:
        """Return the packed answer: whether it went well, and what ``AskedScenes`` wants."""
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
        """Pack a reference; a scene in memory, or that only this process can load, goes along."""
        if not isinstance(ref, HeldRef):
            self._keep(ref.key, ref)
            try:
                return cloudpickle.dumps((True, (ref, state)))
            except Exception:  # whatever its function holds on to
                sent = SceneRef(ref.key, _Sent(ref.load()), ref.difficulty)
        else:
            key = self._names.of(ref, lambda _: f"lent:{next(self._numbers)}")
            sent = SceneRef(key, _Sent(ref.load()), ref.difficulty)
            self._keep(key, ref)
        return cloudpickle.dumps((True, (sent, state)))

    def _keep(self, key: str, ref: SceneRef) -> None:
        """Keep a reference until its episode has ended; the oldest of very many is forgotten."""
        self._lent[key] = ref
        self._lent.move_to_end(key)
        while len(self._lent) > _KEPT:
            self._lent.popitem(last=False)


@dataclass(frozen=True, eq=False)
class _Sent:
    """Loads a scene that was sent along."""

    scene: Scene

    def __call__(self) -> Scene:
        return self.scene
