"""Caches of compiled worlds: ``WorldCache`` for one environment, ``Masters`` for many."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from generator.errors import InputError, require_number

from ..robot.panda import Panda
from ..scenes import SceneRef
from ..scenes.fixed import folder
from .world import World

KEPT = 16
"""Default number of cached compiled worlds."""


class WorldCache:
    """A cache of the ``size`` most recently used worlds, keyed by scene; a reset never recompiles.

    New worlds, with ``robot`` at the table, are copied from ``masters``; if that is None, each is
    compiled.
    """

    def __init__(self, robot: Panda, size: int, masters: Masters | None = None) -> None:
        self._robot = robot
        self._size = size
        self._masters = masters
        self._worlds: OrderedDict[str, World] = OrderedDict()

    def get(self, ref: SceneRef, on_drop: Callable[[World], None]) -> World:
        """Return the world of ``ref``; ``on_drop`` receives each world evicted from the cache."""
        world = self._worlds.get(ref.key)
        if world is None:
            world = self._masters.twin(ref) if self._masters else _world(ref, self._robot)
            self._worlds[ref.key] = world
            while len(self._worlds) > self._size:
                on_drop(self._worlds.popitem(last=False)[1])
        self._worlds.move_to_end(ref.key)
        return world

    def __getstate__(self) -> dict[str, Any]:
        """Return the state to be pickled: an empty cache."""
        return {**self.__dict__, "_worlds": OrderedDict()}


def _world(ref: SceneRef, robot: Panda) -> World:
    return World(ref.load(), robot, bundle=folder(ref))


@dataclass(eq=False)
class _Master:
    """A world to be copied but never stepped; ``world`` is None until it is compiled."""

    lock: threading.Lock = field(default_factory=threading.Lock)
    world: World | None = None


class Masters:
    """A cache of the ``size`` most recently used scenes, compiled once with ``robot``, then copied.

    The methods are thread-safe. Each copy has its own model, since environments write to it.
    """

    def __init__(self, robot: Panda, size: int = KEPT) -> None:
        self._robot = robot
        self._size = size
        self._lock = threading.Lock()
        self._masters: OrderedDict[str, _Master] = OrderedDict()

    def twin(self, ref: SceneRef) -> World:
        """Return a new world of ``ref``."""
        with self._lock:
            master = self._masters.setdefault(ref.key, _Master())
            self._masters.move_to_end(ref.key)
            while len(self._masters) > self._size:
                self._masters.popitem(last=False)
        with master.lock:
            if master.world is None:
                master.world = _world(ref, self._robot)
            return master.world.twin()

    def __getstate__(self) -> dict[str, Any]:
        """Return the state to be pickled: an empty cache without a lock."""
        return {"_robot": self._robot, "_size": self._size}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__init__(state["_robot"], state["_size"])


@dataclass(frozen=True)
class WorldConfig:
    """Settings of an environment's worlds and their cache.

    Args:
        robot: the robot; None for ``Panda()``.
        cache: maximum number of cached compiled worlds, at least 1.
        masters: compiled worlds to copy, shared with other environments; None to compile.

    Raises:
        InputError: the robot is not a ``Panda``, or the cache is out of range.
    """

    robot: Panda | None = None
    cache: int = KEPT
    masters: Masters | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.robot, Panda | None):
            raise InputError(
                f"robot must be a Panda (tabletopgen_env.robot.panda) or None, got {self.robot!r}."
            )
        require_number("cache", self.cache, minimum=1, integer=True)

    @property
    def arm(self) -> Panda:
        """The robot, by default ``Panda()``."""
        return self.robot or Panda()

    def worlds(self) -> WorldCache:
        """Return an empty cache of worlds."""
        return WorldCache(self.arm, self.cache, self.masters)
