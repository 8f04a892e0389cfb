"""What is found out about a scene's objects, each when it is first asked for."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from generator.scene import Object, Scene

T = TypeVar("T")


class PerObject(dict[str, T]):
    """What ``find`` says of each object of a scene, by name; it holds what was asked for."""

    def __init__(self, scene: Scene, find: Callable[[Object], T]) -> None:
        super().__init__()
        self._scene, self._find = scene, find

    def __missing__(self, name: str) -> T:
        """Find it; two threads at once find the same."""
        found = self[name] = self._find(self._scene.object(name))
        return found
