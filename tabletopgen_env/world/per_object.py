"""Lazily computed properties of a scene's objects."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from generator.scene import Object, Scene

T = TypeVar("T")


class PerObject(dict[str, T]):
    """The results of ``find`` by object name, each computed on first access and then cached."""

    def __init__(self, scene: Scene, find: Callable[[Object], T]) -> None:
        super().__init__()
        self._scene, self._find = scene, find

    def __missing__(self, name: str) -> T:
        """Compute a missing value; concurrent threads compute equal values."""
        found = self[name] = self._find(self._scene.object(name))
        return found
