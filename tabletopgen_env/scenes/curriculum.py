"""Scenes of the difficulty at which the policy learns most now."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from generator.errors import InputError
from generator.scene import Scene

from .difficulty import difficulty
from .fixed import Bundle, is_there
from .lookup import CURRICULUM, FixedChoice, fixed_scenes, on_demand
from .sampler import DifficultySampler
from .source import HeldRef, Remembered, SceneRef, SceneSource, close, record
from .splits import SplitRule, admitting

_NEW = 4.0  # weight of a scene that was not drawn yet


@dataclass(eq=False)
class CurriculumScenes:
    """Draws scenes of another source by their difficulty and by how episodes there have ended.

    It holds the ``size`` scenes last met. For each draw the source draws one more, and of all held
    one is chosen: a bin of difficulty by ``sampler``, then a scene of it. One that was not drawn
    yet counts four times as much, since most is learned of what is new.
    ``record`` is told how each episode ended, and at which scene, so that episodes in flight at the
    same time count where they belong.

    At most one scene is made or loaded for a draw, for ``difficulty.difficulty``, and none whose
    reference says how difficult it is. Of a source that makes scenes when they are drawn, the
    scenes held stay in memory.

    Attributes:
        source: where scenes come from: a ``SceneSource``, or fixed ones as ``resolve`` takes them.
        sampler: the success rates by difficulty, which change, and what is drawn by them.
        size: how many scenes are held.

    Raises:
        InputError: settings out of their range.
    """

    source: SceneSource | FixedChoice
    sampler: DifficultySampler = field(default_factory=DifficultySampler)
    size: int = 32
    _source: SceneSource = field(init=False, repr=False)
    _held: list[SceneRef] = field(default_factory=list, init=False, repr=False)
    _drawn: set[str] = field(default_factory=set[str], init=False, repr=False)
    _known: Remembered[float] = field(default_factory=Remembered, init=False, repr=False)

    def __post_init__(self) -> None:
        if isinstance(self.source, SceneSource):
            self._source = self.source
        elif on_demand(self.source):
            raise InputError(
                f"CurriculumScenes takes no {self.source!r}; pass scenes="
                f"'{CURRICULUM}:{self.source}', or a SceneSource."
            )
        else:
            self._source = fixed_scenes(self.source)
        if self.size < 1:
            raise InputError(f"A curriculum needs size to be at least 1, got {self.size}.")

    @property
    def scenes(self) -> SceneSource:
        """The source of the scenes that it chooses among."""
        return self._source

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw a scene; its reference says how difficult it is."""
        self._meet(self._source.draw(rng))
        bins = self.sampler.bins(np.array([ref.difficulty for ref in self._held], float))
        weights = np.array([1.0 if ref.key in self._drawn else _NEW for ref in self._held])
        amounts = np.bincount(bins, weights, minlength=len(self.sampler.counts))
        [chosen] = self.sampler.sample(rng, 1, amounts)
        within = weights * (bins == chosen)
        ref = self._held[int(rng.choice(len(within), p=within / within.sum()))]
        self._drawn.add(ref.key)
        return ref

    def record(self, ref: SceneRef, success: bool) -> None:
        """Take the end of an episode at a scene into account."""
        record(self._source, ref, success)
        if ref.difficulty is not None:
            self.sampler.record(self.sampler.bins(ref.difficulty), success)

    def admitting(self, rule: SplitRule) -> CurriculumScenes:
        """Return the curriculum over only those scenes that a rule admits, with nothing learned."""
        new = dataclasses.replace(self.sampler)
        return dataclasses.replace(self, source=admitting(self._source, rule), sampler=new)

    def close(self) -> None:
        """Close the source."""
        close(self._source)

    def _meet(self, drawn: SceneRef) -> None:
        """Hold a scene, once; let go those that are gone, and the one met longest ago."""
        others = [ref for ref in self._held if ref.key != drawn.key and is_there(ref)]
        [met] = [ref for ref in self._held if ref.key == drawn.key] or [self._rate(drawn)]
        self._held = [*others, met][-self.size :]
        self._drawn &= {ref.key for ref in self._held}

    def _rate(self, ref: SceneRef) -> SceneRef:
        """Return the reference with its difficulty."""
        if ref.difficulty is not None:
            return ref
        if not isinstance(ref, HeldRef) and not isinstance(ref.load, Bundle):
            ref = SceneRef(ref.key, _Made(ref.load))
        return ref.rate(self._known.of(ref, lambda each: difficulty(each.load())))


@dataclass(eq=False)
class _Made:
    """Makes a scene once, and keeps it."""

    make: Callable[[], Scene]
    scene: Scene | None = None

    def __call__(self) -> Scene:
        self.scene = self.scene or self.make()
        return self.scene
