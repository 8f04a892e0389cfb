"""Scenes that become harder as the policy succeeds."""

from __future__ import annotations

import dataclasses
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache

import numpy as np

from generator.errors import InputError

from .choosing import SceneChoice, resolve
from .difficulty import difficulty
from .fixed import is_there
from .source import HeldRef, Remembered, SceneRef, SceneSource, close, record
from .splitting import SplitRule, admitting

LOOKS = 32
"""How many of the scenes that a source has at hand are compared for a draw."""

LOOKS_AT_UNMADE = 4
"""How many are, where each must first be made."""


@dataclass(eq=False)
class CurriculumScenes:
    """Draws scenes of another source from a window of difficulty that follows the success rate.

    The window is in ranks: of the scenes at hand, ordered by difficulty, it takes a share
    ``width``, from the easiest at level 0 to the hardest at level 1. ``record`` is told how each
    episode ended. Of the last ``episodes``, all since the level last moved, the share that
    succeeded moves it: ``raise_at`` or more one ``step`` up, ``lower_at`` or less one down.

    A scene whose reference says no difficulty is loaded once for ``difficulty.difficulty``. So wrap
    fixed or refreshing scenes: of a source that makes scenes when they are drawn,
    ``LOOKS_AT_UNMADE`` are made for every draw.

    Attributes:
        source: where scenes come from; anything ``resolve`` takes.
        width: the window's share of the scenes, in (0, 1].
        level: where the window is, in [0, 1]; it moves.
        step: how far the level moves at a time, in (0, 1].
        episodes: how many episodes the success rate is taken over.
        raise_at, lower_at: success rates that move the level, 0 <= lower_at < raise_at <= 1.

    Raises:
        InputError: settings out of their range.
    """

    source: SceneChoice
    width: float = 0.3
    level: float = 0.0
    step: float = 0.05
    episodes: int = 20
    raise_at: float = 0.7
    lower_at: float = 0.3
    _source: SceneSource = field(init=False, repr=False)
    _results: deque[bool] = field(default_factory=deque, init=False, repr=False)
    _known: Remembered[float] = field(default_factory=Remembered, init=False, repr=False)

    def __post_init__(self) -> None:
        self._source = resolve(self.source)
        if not (0 < self.width <= 1 and 0 <= self.level <= 1 and 0 < self.step <= 1):
            raise InputError(
                "A curriculum needs width and step in (0, 1] and level in [0, 1], got "
                f"{self.width}, {self.step} and {self.level}."
            )
        if self.episodes < 1 or not 0 <= self.lower_at < self.raise_at <= 1:
            raise InputError(
                "A curriculum needs at least one episode and 0 <= lower_at < raise_at <= 1, got "
                f"{self.episodes}, {self.lower_at} and {self.raise_at}."
            )

    @property
    def window(self) -> tuple[float, float]:
        """The least and the highest rank drawn now, as shares: 0 is the easiest scene at hand."""
        low = self.level * (1 - self.width)
        return low, low + self.width

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw a scene inside the window, all equally likely."""
        ranked = sorted(self._candidates(rng), key=self._difficulty)
        ends = np.round(np.array(self.window) * len(ranked), 6)
        first = min(int(ends[0]), len(ranked) - 1)
        last = max(int(np.ceil(ends[1])), first + 1)
        return ranked[int(rng.integers(first, last))]

    def record(self, success: bool) -> None:
        """Take the end of an episode into account."""
        record(self._source, success)
        self._results.append(bool(success))
        if len(self._results) < self.episodes:
            return
        rate = sum(self._results) / len(self._results)
        self._results.popleft()
        change = self.step * (int(rate >= self.raise_at) - int(rate <= self.lower_at))
        if change:
            self.level = float(np.clip(self.level + change, 0, 1))
            self._results.clear()

    def admitting(self, rule: SplitRule) -> CurriculumScenes:
        """Return the curriculum over only those scenes that a rule admits."""
        return dataclasses.replace(self, source=admitting(self._source, rule))

    def close(self) -> None:
        """Close the source."""
        close(self._source)

    def _candidates(self, rng: np.random.Generator) -> list[SceneRef]:
        """Return some scenes that could be drawn now."""
        drawn = self._source.draw(rng)
        at_hand: Sequence[SceneRef] | None = getattr(self._source, "refs", None)
        if at_hand is None:
            more = [self._source.draw(rng) for _ in range(LOOKS_AT_UNMADE - 1)]
            return [
                ref if isinstance(ref, HeldRef) else dataclasses.replace(ref, load=cache(ref.load))
                for ref in (drawn, *more)  # each is made but once
            ]
        order = rng.permutation(len(at_hand))[:LOOKS]
        return [ref for k in order if is_there(ref := at_hand[k])] or [drawn]

    def _difficulty(self, ref: SceneRef) -> float:
        if ref.difficulty is not None:
            return ref.difficulty
        return self._known.of(ref, lambda ref: difficulty(ref.load()))
