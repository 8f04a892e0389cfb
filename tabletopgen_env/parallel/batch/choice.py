"""The choice of a deck's next episodes, either uniform or by a curriculum."""

from __future__ import annotations

import numpy as np
from jaxtyping import Bool, Float, Int
from numpy.typing import ArrayLike

from ...scenes import CurriculumScenes, DifficultySampler, SceneChoice
from ...scenes.lookup import graded_of


class EpisodeChoice:
    """The choice of a deck's episodes on the host, and a record of each world's current episode.

    ``sampler`` draws a bin of difficulty, weighted by the deck's number of episodes per bin; then
    one of the bin's episodes is drawn uniformly. Success rates stay with the sampler when the deck
    changes.

    Args:
        sampler: success rates by difficulty; a sampler with a single bin draws uniformly.
        worlds: number of worlds.
        seed: seed of the draws, until ``restart``.
    """

    def __init__(self, sampler: DifficultySampler, worlds: int, seed: int) -> None:
        self.sampler = sampler
        self._playing: Int[np.ndarray, "w"] = np.full(worlds, -1)
        self.hold(np.zeros(1))
        self.restart(seed)

    def restart(self, seed: int) -> None:
        """Reseed the draws, keeping the success rates."""
        self._rng = np.random.default_rng((seed, 9))

    def hold(self, difficulties: Float[np.ndarray, "e"]) -> None:
        """Switch to episodes of these difficulties; no world plays any of them yet."""
        self._bins = self.sampler.bins(difficulties)
        self._by_bin = np.argsort(self._bins, kind="stable")
        self._counts = np.bincount(self._bins, minlength=len(self.sampler.counts))
        self._playing[:] = -1

    def draw(self, worlds: Int[np.ndarray, "k"]) -> Int[np.ndarray, "k"]:
        """Draw an episode for each of the given worlds; return the episodes' rows in the deck."""
        bins = self.sampler.sample(self._rng, len(worlds), self._counts)
        within = (self._rng.random(len(worlds)) * self._counts[bins]).astype(int)
        rows = self._by_bin[(np.cumsum(self._counts) - self._counts)[bins] + within]
        self._playing[worlds] = rows
        return rows

    def forget(self, worlds: Int[np.ndarray, "k"]) -> None:
        """Mark worlds as playing an episode that was not drawn, so that no result is recorded."""
        self._playing[worlds] = -1

    def record(self, ended: Bool[np.ndarray, "w"], successes: ArrayLike) -> None:
        """Record the results of the worlds whose episode has ended."""
        told = np.asarray(ended, bool) & (self._playing >= 0)
        self.sampler.record(self._bins[self._playing[told]], np.asarray(successes)[told])


def sampler_of(scenes: SceneChoice) -> DifficultySampler:
    """Return a curriculum's difficulty sampler, or a sampler with a single bin for other scenes."""
    if isinstance(scenes, CurriculumScenes):
        return scenes.sampler
    if isinstance(scenes, str) and graded_of(scenes) is not None:
        return DifficultySampler()
    return DifficultySampler(edges=(0.0, 1.0), explore=1.0)
