"""A curriculum: scenes of the difficulty at which the policy currently learns most."""

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

_NEW = 4.0  # weight of a scene not drawn before


@dataclass(eq=False)
class CurriculumScenes:
    """Scenes from another source, drawn by difficulty and by the results of earlier episodes.

    It holds the ``size`` most recent scenes. Each draw adds one more scene of the source, then
    chooses among the held ones: first a bin of difficulty by ``sampler``, then a scene in it.
    Scenes not drawn before have four times the weight, since new scenes teach most. ``record``
    receives the result of each episode with its scene, so that concurrent episodes count for the
    right bins.

    Each draw generates or loads at most one scene, to compute ``difficulty.difficulty``, and none
    if its reference includes the difficulty. For a source that generates scenes on demand, the held
    scenes stay in memory.

    Attributes:
        source: the source: a ``SceneSource``, or fixed scenes as for ``resolve``.
        sampler: success rates by difficulty, updated in place, and the distribution of draws.
        size: number of held scenes.

    Raises:
        InputError: a setting is out of range.
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
                f"CurriculumScenes does not accept {self.source!r}; pass "
                f"scenes='{CURRICULUM}:{self.source}', or a SceneSource."
            )
        else:
            self._source = fixed_scenes(self.source)
        if self.size < 1:
            raise InputError(f"The size of a curriculum must be at least 1, got {self.size}.")

    @property
    def scenes(self) -> SceneSource:
        """The underlying source."""
        return self._source

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw a scene; the returned reference includes its difficulty."""
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
        """Record the result of an episode on a scene."""
        record(self._source, ref, success)
        if ref.difficulty is not None:
            self.sampler.record(self.sampler.bins(ref.difficulty), success)

    def admitting(self, rule: SplitRule) -> CurriculumScenes:
        """Return a new curriculum, without results, over the scenes that a rule admits."""
        new = dataclasses.replace(self.sampler)
        return dataclasses.replace(self, source=admitting(self._source, rule), sampler=new)

    def close(self) -> None:
        """Close the source."""
        close(self._source)

    def _meet(self, drawn: SceneRef) -> None:
        """Store a scene once; drop deleted scenes and the oldest ones beyond ``size``."""
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
    """A loader that generates its scene only once."""

    make: Callable[[], Scene]
    scene: Scene | None = None

    def __call__(self) -> Scene:
        self.scene = self.scene or self.make()
        return self.scene
