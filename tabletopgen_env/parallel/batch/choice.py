"""Which of a deck's episodes come next: all equally likely, or by a curriculum."""

from __future__ import annotations

import numpy as np
from jaxtyping import Bool, Float, Int
from numpy.typing import ArrayLike

from ...scenes import CurriculumScenes, DifficultySampler, SceneChoice
from ...scenes.lookup import graded_of


class EpisodeChoice:
    """Draws episodes of a deck, on the host, and remembers which world plays which.

    A bin of difficulty is drawn by ``sampler``, which knows how many episodes the deck has of each,
    then one of its episodes, all equally likely. What episodes came to stays with the sampler when
    another deck is held.

    Args:
        sampler: the success rates by difficulty; one with a single bin draws uniformly.
        worlds: how many worlds play.
        seed: of the draws, until ``restart``.
    """

    def __init__(self, sampler: DifficultySampler, worlds: int, seed: int) -> None:
        self.sampler = sampler
        self._playing: Int[np.ndarray, "w"] = np.full(worlds, -1)
        self.hold(np.zeros(1))
        self.restart(seed)

    def restart(self, seed: int) -> None:
        """Draw by a seed from now on; the success rates stay."""
        self._rng = np.random.default_rng((seed, 9))

    def hold(self, difficulties: Float[np.ndarray, "e"]) -> None:
        """Draw among episodes of these difficulties; no world plays one of them yet."""
        self._bins = self.sampler.bins(difficulties)
        self._by_bin = np.argsort(self._bins, kind="stable")
        self._counts = np.bincount(self._bins, minlength=len(self.sampler.counts))
        self._playing[:] = -1

    def draw(self, worlds: Int[np.ndarray, "k"]) -> Int[np.ndarray, "k"]:
        """Draw an episode for each of some worlds; return their rows in the deck."""
        bins = self.sampler.sample(self._rng, len(worlds), self._counts)
        within = (self._rng.random(len(worlds)) * self._counts[bins]).astype(int)
        rows = self._by_bin[(np.cumsum(self._counts) - self._counts)[bins] + within]
        self._playing[worlds] = rows
        return rows

    def forget(self, worlds: Int[np.ndarray, "k"]) -> None:
        """Let some worlds play what was not drawn: how they end is not recorded."""
        self._playing[worlds] = -1

    def record(self, ended: Bool[np.ndarray, "w"], successes: ArrayLike) -> None:
        """Take the ends of episodes into account, in the worlds of which one has ended."""
        told = np.asarray(ended, bool) & (self._playing >= 0)
        self.sampler.record(self._bins[self._playing[told]], np.asarray(successes)[told])


def sampler_of(scenes: SceneChoice) -> DifficultySampler:
    """Return the sampler that ``scenes`` mean, the curriculum's own; a single bin without one."""
    if isinstance(scenes, CurriculumScenes):
        return scenes.sampler
    if isinstance(scenes, str) and graded_of(scenes) is not None:
        return DifficultySampler()
    return DifficultySampler(edges=(0.0, 1.0), explore=1.0)
