"""A pool of scenes that is renewed in the background while training goes on."""

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
"""How many scenes are renewed a minute, unless said otherwise."""


@dataclass(eq=False)
class RefreshingScenes:
    """Draws uniformly from a pool that background processes keep renewing.

    The oldest scene goes as a new one comes. With ``per_minute`` a draw never waits for a new
    scene: it takes over what is finished, orders what is due, and draws from what is there, so that
    what a policy sees depends on the clock and on how fast the processes are. With ``every_resets``
    it depends on neither: the same seed gives the same scenes at the same draws, a failed scene
    included; scenes are made ahead, and a draw at which one is due waits for it if it is not done.
    (A process that the system kills costs its scene, and that run its repeatability, with a
    warning.) Several slots of a vector environment draw in the order of their resets, which is
    fixed only where they are reset by one thread.

    Only the first draw makes its pool itself, about a second a scene, where ``initial`` gives it
    none. Where processes die or scenes cannot be made, the pool stays as it is, with one warning,
    and new ones are tried after ever longer pauses, with ``every_resets`` at the next draw that is
    due; see ``failures``.

    Each process takes 150 to 300 MB at nice 10. All ends with ``close``, or with the process that
    drew; the next draw begins anew, and so does a pickled or forked copy. Threads of your own draw
    through ``SharedScenes``.

    Attributes:
        fresh: where new scenes come from: a ``FreshScenes``, or what that takes as ``prompts``.
        size: how many scenes the pool holds.
        per_minute: how many scenes are renewed a minute; None for ``PER_MINUTE`` if
            ``every_resets`` is None, too. The processes may not keep up with a high rate.
        every_resets: renew a scene every so many draws instead, in step with them.
        workers: how many scenes are made at a time, each by a process.
        initial: the first pool, at most ``size`` drawn from it: a ``FixedScenes``, or what names
            one ("starter", a list of bundles).
        synchronous: renew in this very process, as part of the draws that are due, without other
            processes: slow. Needs ``every_resets``.
        seed: of the scenes made; None takes it from the first draw's generator.

    Raises:
        InputError: settings out of their range, or that do not go together.
        BundleError: ``initial`` names no bundle.
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
                "RefreshingScenes is renewed either per_minute or every_resets, got "
                f"{self.per_minute} and {self.every_resets}"
                + (" with synchronous=True." if self.synchronous else ".")
            )
        if self.per_minute is not None and not 0 < self.per_minute < np.inf:
            raise InputError(f"per_minute is a positive number of scenes, got {self.per_minute}.")
        if self.every_resets is not None and self.every_resets < 1:
            raise InputError(f"every_resets is a number from 1 up, got {self.every_resets}.")
        if self.synchronous and self.every_resets is None:
            raise InputError("synchronous=True renews every_resets; per_minute is no fixed count.")
        if self.initial is not None and not isinstance(self.initial, FixedScenes):
            self.initial = fixed_scenes(self.initial)

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw one scene of the present pool, all equally likely.

        Raises:
            InputError: a text cannot be planned.
            SceneError: the first pool could not be made, or is all lost.
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
        """The scenes in the pool, the oldest first; none before the first draw."""
        return tuple(self._pool.refs) if self._pool else ()

    @property
    def renewals(self) -> int:
        """How many scenes have been renewed."""
        return self._pool.renewals if self._pool else 0

    @property
    def failures(self) -> int:
        """How often a scene could not be made or a process died."""
        return self._pool.failures if self._pool else 0

    @property
    def pids(self) -> tuple[int, ...]:
        """The ids of the processes that are running."""
        return self._pool.background.pids if self._pool and self._pool.background else ()

    def admitting(self, rule: SplitRule) -> RefreshingScenes:
        """Return the source of only those scenes that a rule admits, at first and later on.

        Where that leaves none of the first ones, the first pool is made.
        """
        fresh, initial = self._parts()
        some = initial is not None and any(admits(rule, ref) for ref in initial.refs)
        kept = initial.admitting(rule) if initial is not None and some else None
        return dataclasses.replace(self, fresh=fresh.admitting(rule), initial=kept)

    def close(self) -> None:
        """End the processes and delete what they made. May be called twice."""
        if self._pool is not None and self._pool.background is not None:
            self._pool.background.close()
        self._pool = None

    def _parts(self) -> tuple[FreshScenes, FixedScenes | None]:
        """Return ``fresh`` and ``initial`` as ``__post_init__`` has left them."""
        assert isinstance(self.fresh, FreshScenes)
        assert self.initial is None or isinstance(self.initial, FixedScenes)
        return self.fresh, self.initial

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_pool": None}
