"""A pool of scenes that is renewed in the background during training."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from generator.errors import InputError, require, require_seed
from generator.language.distribution import SceneDistribution

from .fixed import FixedScenes
from .fresh import FreshScenes
from .lookup import FixedChoice, fixed_scenes
from .production.pool import RenewalPace, ScenePool
from .source import SceneRef
from .splits import SplitRule, admits

PER_MINUTE = 6.0
"""Default number of scenes renewed per minute."""


@dataclass(eq=False)
class RefreshingScenes:
    """A source that draws uniformly from a pool renewed by background processes.

    A new scene replaces the oldest one. With ``per_minute`` a draw never waits for a new scene: it
    adds completed scenes, orders those that are due, and draws from the pool, so the scenes that a
    policy sees depend on timing. With ``every_resets`` they do not: equal seeds give equal scenes
    at equal draws, including failures. Scenes are generated in advance, and a draw waits only for a
    scene that is due but not complete. (If the system kills a process, its scene is lost, and so is
    the run's repeatability, with a warning.) Several slots of a vector environment draw in the
    order of their resets, which is only deterministic if one thread resets them.

    Without ``initial``, the first draw generates the pool itself, about a second per scene. If
    processes die or scenes cannot be generated, the pool stays unchanged, with one warning, and
    renewal is retried after increasing pauses, or, with ``every_resets``, at the next draw that is
    due; see ``failures``.

    Each process takes 150 to 300 MB and runs at nice 10. The processes end with ``close``, or with
    the process that drew; the next draw starts them again, also in a pickled or forked copy. For
    your own threads, use ``SharedScenes``.

    Attributes:
        fresh: source of new scenes: a ``FreshScenes``, or its argument ``prompts``.
        size: number of scenes in the pool.
        per_minute: number of scenes renewed per minute; None for ``PER_MINUTE`` unless
            ``every_resets`` is set. The processes may not keep up with a high rate.
        every_resets: number of draws per renewed scene, instead of ``per_minute``.
        workers: number of processes, each generating one scene at a time.
        initial: first pool, from which at most ``size`` scenes are drawn: a ``FixedScenes``, or the
            name of one ("starter", a list of bundles).
        synchronous: generate scenes in this process at the draws that are due, without other
            processes; slow. Needs ``every_resets``.
        seed: seed of the generated scenes; None takes it from the first draw's generator.

    Raises:
        InputError: a setting is out of range, or settings are inconsistent.
        BundleError: ``initial`` matches no bundle.
    """

    fresh: FreshScenes | str | Sequence[str] | SceneDistribution = field(
        default_factory=FreshScenes
    )
    size: int = 16
    per_minute: float | None = None
    every_resets: int | None = None
    workers: int = 1
    initial: FixedScenes | FixedChoice | None = None
    synchronous: bool = False
    seed: int | None = None
    _pool: ScenePool | None = field(default=None, init=False, repr=False)

    def __post_init__(self) -> None:
        if not isinstance(self.fresh, FreshScenes):
            self.fresh = FreshScenes(self.fresh)
        if self.per_minute is None and self.every_resets is None and not self.synchronous:
            self.per_minute = PER_MINUTE
        require(self, "size", "workers", minimum=1, integer=True)
        if self.seed is not None:
            require_seed(self.seed)
        if (self.per_minute is None) == (self.every_resets is None):
            raise InputError(
                "RefreshingScenes requires exactly one of per_minute and every_resets, got "
                f"{self.per_minute} and {self.every_resets}"
                + (" with synchronous=True." if self.synchronous else ".")
            )
        if self.per_minute is not None and not 0 < self.per_minute < np.inf:
            raise InputError(f"per_minute must be a positive number, got {self.per_minute}.")
        if self.every_resets is not None and self.every_resets < 1:
            raise InputError(f"every_resets must be at least 1, got {self.every_resets}.")
        if self.synchronous and self.every_resets is None:
            raise InputError("synchronous=True requires every_resets instead of per_minute.")
        if self.initial is not None and not isinstance(self.initial, FixedScenes):
            self.initial = fixed_scenes(self.initial)

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw one scene of the current pool uniformly.

        Raises:
            InputError: a text cannot be planned.
            SceneError: the first pool could not be generated, or is entirely lost.
        """
        if self._pool is None or self._pool.owner != os.getpid():
            fresh, initial = self._parts()
            seed = int(rng.integers(2**31)) if self.seed is None else self.seed
            pace = RenewalPace(self.per_minute, self.every_resets)
            workers = 0 if self.synchronous else self.workers
            self._pool = ScenePool(fresh, self.size, initial, pace, workers, seed)
        return self._pool.draw(rng)

    @property
    def refs(self) -> tuple[SceneRef, ...]:
        """The scenes in the pool, oldest first; empty before the first draw."""
        return tuple(self._pool.refs) if self._pool else ()

    @property
    def renewals(self) -> int:
        """The number of renewed scenes."""
        return self._pool.renewals if self._pool else 0

    @property
    def failures(self) -> int:
        """The number of failed scenes and dead processes."""
        return self._pool.failures if self._pool else 0

    @property
    def pids(self) -> tuple[int, ...]:
        """The ids of the running processes."""
        return self._pool.background.pids if self._pool and self._pool.background else ()

    def admitting(self, rule: SplitRule) -> RefreshingScenes:
        """Return a source of the scenes that a rule admits, initially and after renewal.

        If no initial scene is admitted, the first pool is generated.
        """
        fresh, initial = self._parts()
        some = initial is not None and any(admits(rule, ref) for ref in initial.refs)
        kept = initial.admitting(rule) if initial is not None and some else None
        return dataclasses.replace(self, fresh=fresh.admitting(rule), initial=kept)

    def close(self) -> None:
        """End the processes and delete their files. Repeated calls are allowed."""
        if self._pool is not None and self._pool.background is not None:
            self._pool.background.close()
        self._pool = None

    def _parts(self) -> tuple[FreshScenes, FixedScenes | None]:
        """Return ``fresh`` and ``initial`` with the types set by ``__post_init__``."""
        assert isinstance(self.fresh, FreshScenes)
        assert self.initial is None or isinstance(self.initial, FixedScenes)
        return self.fresh, self.initial

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_pool": None}
