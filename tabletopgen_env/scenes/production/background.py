"""Generation of scenes by background processes; only ``next_end`` waits for them."""

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
"""Time limit for the generation of a scene, in seconds."""

LONGEST_REST = 300.0
"""Maximum pause after consecutive failures, in seconds."""

NICENESS = 10
"""Nice value of the processes."""


@dataclass(frozen=True)
class MadeScene:
    """A completed scene: its bundle in a separate folder, and its difficulty."""

    recipe: SceneRecipe
    bundle: Path
    difficulty: float


@dataclass(frozen=True)
class FailedScene:
    """A scene that could not be generated, and the reason."""

    recipe: SceneRecipe
    reason: str


class Background:
    """A generator of scenes in up to ``count`` processes, which write to a temporary folder.

    ``rest`` is the pause in seconds after a failure, doubled for each consecutive failure; scenes
    that take longer than ``timeout`` seconds are cancelled.

    Raises:
        StorageError: no temporary folder can be created.
    """

    def __init__(self, count: int, *, rest: float = 0.5, timeout: float = TIMEOUT) -> None:
        try:
            self.folder = Path(tempfile.mkdtemp(prefix="tabletopgen-"))
        except OSError as error:
            raise StorageError(
                f"A temporary folder for new scenes cannot be created: {error.strerror or error}. "
                "Set TMPDIR to a folder with free space."
            ) from error
        self._workers = WorkerPool(count, begin=_step_back, folder=self.folder)
        self._waiting: deque[SceneRecipe] = deque()
        self._pending: dict[Future[MadeScene], tuple[SceneRecipe, Path]] = {}
        self._started = self._failures = 0
        self._rest, self._timeout, self._resting_until = rest, timeout, 0.0

    @property
    def pids(self) -> tuple[int, ...]:
        """The ids of the running processes."""
        return self._workers.pids

    @property
    def width(self) -> int:
        """The number of scenes generated at the same time."""
        return self._workers.width

    @property
    def open(self) -> int:
        """The number of pending orders."""
        return len(self._waiting) + len(self._pending)

    def order(self, recipe: SceneRecipe) -> None:
        """Queue the generation of a scene."""
        self._waiting.append(recipe)

    def collect(self) -> list[MadeScene | FailedScene]:
        """Return the results since the last call, and start queued orders."""
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
        """Start queued orders on free processes."""
        while self._waiting and len(self._pending) < self.width:
            self._start(self._waiting.popleft())

    def next_end(self) -> MadeScene | FailedScene:
        """Wait for the earliest pending order, and return its result."""
        self.hand_out()
        future = next(iter(self._pending))
        wait([future])
        return self._result(future)

    def close(self) -> None:
        """End the processes and remove their files. Repeated calls are allowed."""
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
    """Generate a scene and save it as a bundle in a folder."""
    scene = recipe.make()
    path = save(scene, folder, allow_failed=True)  # recipes run the gate where it is necessary
    return MadeScene(recipe, path, difficulty(scene))
