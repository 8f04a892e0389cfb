"""Sampling of difficulties by learning potential, which is highest where half the episodes succeed.

It uses arrays only, so that any program that runs many episodes can use it: ``CurriculumScenes``
draws one scene at a time, and a batched environment draws the bins of all its episodes together.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from jaxtyping import Float, Int, Real
from numpy.typing import ArrayLike

from generator.errors import InputError

EDGES = (0.0, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 1.0)
"""Edges of the bins of difficulty. Nine in ten composed tables lie between 0.19 and 0.42."""


@dataclass(eq=False)
class DifficultySampler:
    """A sampler of difficulty bins by learning potential, based on running success rates.

    The rate of a bin is p = (s + 1) / (n + 2) for s successes in n episodes. Older episodes count
    less: half after ``halflife`` further episodes of the same bin. The potential is p (1 - p),
    which is highest where half of the episodes succeed, and for bins without episodes (S. Tzannetos
    et al., "Proximal curriculum for reinforcement learning agents", TMLR 2023). A bin with a share
    w of all items is drawn with probability ``explore`` w + (1 - ``explore``) w potential / sum of
    w potential, so that all items are equally likely at the start.

    Attributes:
        edges: b + 1 increasing edges of the bins; values outside belong to the first or last bin.
        explore: share of uniform draws, in (0, 1]; 1 draws uniformly.
        halflife: number of episodes of a bin after which an older one counts half; inf never
            forgets.
        counts: decayed number of episodes and of successes of each bin.

    Raises:
        InputError: a setting is out of range.
    """

    edges: tuple[float, ...] = EDGES
    explore: float = 0.2
    halflife: float = 30.0
    counts: Float[np.ndarray, "b 2"] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self.edges = tuple(float(edge) for edge in self.edges)
        if len(self.edges) < 2 or not (np.diff(self.edges) > 0).all():
            raise InputError(
                f"A curriculum must have at least two increasing edges, got {self.edges}."
            )
        if not 0 < self.explore <= 1 or not self.halflife > 0:
            raise InputError(
                "A curriculum must have explore in (0, 1] and a positive halflife, got "
                f"{self.explore} and {self.halflife}."
            )
        self.counts = np.zeros((len(self.edges) - 1, 2))

    @property
    def rates(self) -> Float[np.ndarray, "b"]:
        """The success rate of each bin, or 1/2 for bins without episodes."""
        return (self.counts[:, 1] + 1) / (self.counts[:, 0] + 2)

    def bins(self, difficulties: ArrayLike) -> Int[np.ndarray, "*n"]:
        """Return the bin of each difficulty."""
        found = np.searchsorted(self.edges[1:-1], np.asarray(difficulties, float), side="right")
        return np.asarray(found)

    def probabilities(self, amounts: Real[np.ndarray, "b"] | None = None) -> Float[np.ndarray, "b"]:
        """Return each bin's probability, given the number of items per bin (equal by default)."""
        held = np.ones(len(self.counts)) if amounts is None else np.asarray(amounts, float)
        potential = held * self.rates * (1 - self.rates)
        return self.explore * held / held.sum() + (1 - self.explore) * potential / potential.sum()

    def sample(
        self, rng: np.random.Generator, n: int, amounts: Real[np.ndarray, "b"] | None = None
    ) -> Int[np.ndarray, "n"]:
        """Draw ``n`` bins, weighted by the number of items in each; empty bins are never drawn."""
        return rng.choice(len(self.counts), size=n, p=self.probabilities(amounts))

    def record(self, bins: ArrayLike, successes: ArrayLike) -> None:
        """Record the results of simultaneous episodes; their order does not matter."""
        which = np.atleast_1d(np.asarray(bins, int))
        won = np.atleast_1d(np.asarray(successes, float))
        ended = np.bincount(which, minlength=len(self.counts))
        share = np.bincount(which, won, minlength=len(self.counts)) / np.maximum(ended, 1)
        forgotten = math.log(0.5) / self.halflife  # decay rate per episode
        kept = np.exp(ended * forgotten)
        # sum of the weights 1 + decay + decay² ...; without decay, the number of episodes
        fresh = np.expm1(ended * forgotten) / math.expm1(forgotten) if forgotten else ended
        self.counts = self.counts * kept[:, None] + (
            fresh[:, None] * np.stack([np.ones_like(share), share], axis=1)
        )
