"""Scenes that worker processes make in the background; only ``next_end`` waits for them."""

from __future__ import annotations

import os
import shutil
import tempfile
import time
from collections import deque
from concurrent.futures import Future, wait
from dataclasses import dataclass
from pathlib import Path

from generator.bundle import save
from generator.errors import StorageError
from generator.jobs.workers import WorkerDied, WorkerPool

from ..difficulty import difficulty
from .recipe import SceneRecipe

TIMEOUT = 1800.0
"""Seconds after which a scene that is not done is given up."""

LONGEST_REST = 300.0
"""Longest pause after failures in a row, seconds."""

NICENESS = 10
"""How far the processes step back for others."""


@dataclass(frozen=True)
class MadeScene:
    """A scene that is done: its bundle, alone in a folder of its own, and how hard it is."""

    recipe: SceneRecipe
    bundle: Path
    difficulty: float


@dataclass(frozen=True)
class FailedScene:
    """A scene that cannot be had, and why."""

    recipe: SceneRecipe
    reason: str


class Background:
    """Scenes in the making, ``count`` at a time, each in a process, in a temporary folder.

    ``rest`` is the pause after a failure, seconds, which doubles with each further one in a row;
    after ``timeout`` seconds a scene that is not done is given up.

    Raises:
        StorageError: there is no place for temporary files.
    """

    def __init__(self, count: int, *, rest: float = 0.5, timeout: float = TIMEOUT) -> None:
        try:
            self.folder = Path(tempfile.mkdtemp(prefix="tabletopgen-"))
        except OSError as error:
            raise StorageError(
                f"No temporary folder for new scenes: {error.strerror or error}. Set TMPDIR."
            ) from error
        self._workers = WorkerPool(count, begin=_step_back, folder=self.folder)
        self._waiting: deque[SceneRecipe] = deque()
        self._pending: dict[Future[MadeScene], tuple[SceneRecipe, Path]] = {}
        self._started = self._failures = 0
        self._rest, self._timeout, self._resting_until = rest, timeout, 0.0

    @property
    def pids(self) -> tuple[int, ...]:
        """The ids of the processes that run."""
        return self._workers.pids

    @property
    def width(self) -> int:
        """How many scenes are made at a time."""
        return self._workers.width

    @property
    def open(self) -> int:
        """How many scenes are ordered and not done."""
        return len(self._waiting) + len(self._pending)

    def order(self, recipe: SceneRecipe) -> None:
        """Have a scene made, in its turn."""
        self._waiting.append(recipe)

    def collect(self) -> list[MadeScene | FailedScene]:
        """Return what has ended since the last call, and hand out what waits."""
        ended = [self._result(future) for future in list(self._pending) if future.done()]
        for end in ended:
            self._failures = self._failures + 1 if isinstance(end, FailedScene) else 0
        if ended and self._failures:
            rest = min(self._rest * 2.0 ** (self._failures - 1), LONGEST_REST)
            self._resting_until = time.monotonic() + rest
        if time.monotonic() >= self._resting_until:
            self.hand_out()
        return ended

    def hand_out(self) -> None:
        """Start what waits, as far as there are processes for it."""
        while self._waiting and len(self._pending) < self.width:
            self._start(self._waiting.popleft())

    def next_end(self) -> MadeScene | FailedScene:
        """Return what has come of the earliest order that is open, once it has ended."""
        self.hand_out()
        future = next(iter(self._pending))
        wait([future])
        return self._result(future)

    def close(self) -> None:
        """End the processes and remove what they have made. May be called twice."""
        self._waiting.clear()
        self._workers.close()

    def _start(self, recipe: SceneRecipe) -> None:
        folder = self.folder / f"{self._started:06d}"
        self._started += 1
        future = self._workers.submit(_make, recipe, folder, timeout=self._timeout)
        self._pending[future] = recipe, folder

    def _result(self, future: Future[MadeScene]) -> MadeScene | FailedScene:
        recipe, folder = self._pending.pop(future)
        try:
            return future.result()
        except Exception as error:
            shutil.rmtree(folder, ignore_errors=True)
            kind = "" if isinstance(error, WorkerDied) else f"{type(error).__name__}: "
            return FailedScene(recipe, f"{kind}{error}")


def _step_back() -> None:
    if hasattr(os, "nice"):
        os.nice(NICENESS)


def _make(recipe: SceneRecipe, folder: Path) -> MadeScene:
    """Make a scene and save it as a bundle in a folder."""
    scene = recipe.make()
    path = save(scene, folder, allow_failed=True)  # recipes judge what needs judging
    return MadeScene(recipe, path, difficulty(scene))
