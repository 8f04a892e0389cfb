"""The current scenes of a ``RefreshingScenes``, and their renewal."""

from __future__ import annotations

import contextlib
import os
import shutil
import time
import warnings
from dataclasses import dataclass

import numpy as np

from generator.errors import SceneError

from ..fixed import Bundle, FixedScenes, is_there
from ..fresh import FreshScenes
from ..source import SceneRef
from .background import Background, FailedScene, MadeScene

MOST_FAILURES = 5
"""Maximum number of consecutive failures while the first pool is generated."""

REST = 60.0
"""Pause in seconds after an unsuccessful search for a new order, since searching takes time."""


@dataclass(frozen=True)
class RenewalPace:
    """Rate of renewal: scenes per minute, or draws per renewed scene."""

    per_minute: float | None
    every_resets: int | None

    def due(self, draws: int, seconds: float) -> float:
        """Return the renewals due at draw ``draws`` (from 0), ``seconds`` after the last draw."""
        if self.every_resets is not None:
            return float(draws > 0 and draws % self.every_resets == 0)
        return seconds * (self.per_minute or 0.0) / 60


class ScenePool:
    """At most ``size`` scenes, the oldest first, renewed from ``fresh`` with ``seed`` at ``pace``.

    The first scenes are ``initial``, or generated immediately; ``workers`` processes generate the
    others, or this process does if it is 0.

    Raises:
        InputError: a text cannot be planned.
        SceneError: the first pool cannot be generated.
    """

    def __init__(
        self,
        fresh: FreshScenes,
        size: int,
        initial: FixedScenes | None,
        pace: RenewalPace,
        workers: int,
        seed: int,
    ) -> None:
        fresh.check()
        self.owner = os.getpid()
        self.renewals = self.failures = 0
        self._fresh, self._size, self._pace, self._seed = fresh, size, pace, seed
        self._made = self._draws = 0
        self._owed = self._resting_until = 0.0
        self._last = time.monotonic()
        self._warned = False
        self.refs: list[SceneRef] = []
        if initial is None:
            self._fill()
        else:
            few = np.random.default_rng([seed, 1]).permutation(len(initial))[:size]
            self.refs = [initial.refs[k] for k in few]
        self.background = Background(workers) if workers else None

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Add completed scenes, order due renewals, and draw one of the scenes uniformly."""
        now = time.monotonic()
        due = self._pace.due(self._draws, now - self._last)
        self._draws, self._last = self._draws + 1, now
        self._owed = min(self._owed + due, self._size)
        if self.background is None:
            while self._owed >= 1:
                self._owed -= 1
                self._make_one()
        elif self._pace.every_resets is not None:
            self._keep_step(self.background, due > 0)
        else:
            if now >= self._resting_until:
                self._order(self.background)
            for end in self.background.collect():
                self._take(end)
        return self._pick(rng)

    # ---------------------------------------------------------------------------------- renewing

    def _keep_step(self, background: Background, due: bool) -> None:
        """Add the next requested scene if one is due, and queue requests for idle workers.

        The sequence of scenes is thus independent of the speed of the processes; a draw waits for a
        scene that is due but not complete.
        """
        if due and background.open:
            self._take(background.next_end())
        while background.open < background.width:
            try:
                background.order(self._fresh.recipe(self._next()))
            except SceneError as error:
                self._fail(str(error))
                break
        background.hand_out()

    def _order(self, background: Background) -> None:
        """Request missing or due scenes, but at most as many as the pool holds."""
        missing = self._size - len(self.refs) - background.open
        count = missing if missing > 0 else min(int(self._owed), self._size - background.open)
        self._owed = max(self._owed - count, 0.0)
        try:
            for _ in range(count):
                background.order(self._fresh.recipe(self._next()))
        except SceneError as error:
            self._resting_until = time.monotonic() + REST
            self._fail(str(error))

    def _take(self, end: MadeScene | FailedScene) -> None:
        if isinstance(end, FailedScene):
            return self._fail(end.reason)
        return self._add(SceneRef(end.recipe.key, Bundle(end.bundle), end.difficulty))

    def _add(self, ref: SceneRef) -> None:
        """Add a new scene, and drop the oldest one if the pool is full."""
        self.refs.append(ref)
        self.renewals += 1
        while len(self.refs) > self._size:
            self._drop(self.refs.pop(0))

    def _drop(self, ref: SceneRef) -> None:
        """Delete a scene generated by this pool, atomically for concurrent readers."""
        if self.background is not None and isinstance(ref.load, Bundle):
            job = ref.load.path.parent
            if job.parent == self.background.folder:
                gone = job.with_name(f"{job.name}.gone")
                with contextlib.suppress(OSError):  # another program may have deleted it
                    job.rename(gone)
                shutil.rmtree(gone, ignore_errors=True)

    def _make_one(self) -> None:
        try:
            self._add(self._here())
        except SceneError as error:
            self._fail(str(error))

    def _fill(self) -> None:
        """Generate a complete pool in this process."""
        failures = 0
        while len(self.refs) < self._size:
            try:
                self.refs.append(self._here())
                failures = 0
            except SceneError as error:
                failures += 1
                if failures == MOST_FAILURES:
                    raise SceneError(
                        f"The first pool could not be generated: {failures} consecutive scenes "
                        f"failed. {error}"
                    ) from error

    def _here(self) -> SceneRef:
        """Generate the next scene in this process."""
        recipe = self._fresh.recipe(self._next())
        scene = recipe.make()
        return SceneRef(recipe.key, lambda: scene)

    def _next(self) -> np.random.Generator:
        """Return the random generator of the next scene."""
        self._made += 1
        return np.random.default_rng([self._seed, 0, self._made])

    def _fail(self, reason: str) -> None:
        self.failures += 1
        if not self._warned:
            self._warned = True
            warnings.warn(
                f"The pool of scenes could not be renewed: {reason.rstrip('.')}. The current "
                "scenes stay in use and renewal is retried; further failures are only counted "
                "(RefreshingScenes.failures).",
                RuntimeWarning, stacklevel=4,
            )  # fmt: skip

    # ----------------------------------------------------------------------------------- drawing

    def _pick(self, rng: np.random.Generator) -> SceneRef:
        """Draw one of the scenes that still exist; if there are none, generate the pool again."""
        while self.refs:
            k = int(rng.integers(len(self.refs)))
            if is_there(self.refs[k]):
                return self.refs[k]
            gone = self.refs.pop(k)
            self._fail(f"the bundle {gone.key} no longer exists.")
        self._fill()
        return self.refs[int(rng.integers(len(self.refs)))]
