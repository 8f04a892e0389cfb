"""Statistics per column of numeric rows: range, mean, standard deviation and quantiles."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float, Shaped, UInt8

QUANTILES: Mapping[str, float] = {"q01": 0.01, "q10": 0.10, "q50": 0.50, "q90": 0.90, "q99": 0.99}
"""The quantiles of a summary, by name."""

_MOST_NUMBERS = 1 << 22  # pixels sampled per picture stream and episode


@dataclass(frozen=True, eq=False)
class RowSummary:
    """Statistics of ``count`` rows, each an array with one entry for each of ``d`` columns.

    ``std`` is the population's standard deviation; ``quantiles`` are in the order of ``QUANTILES``.
    """

    minimum: Float[np.ndarray, "d"]
    maximum: Float[np.ndarray, "d"]
    mean: Float[np.ndarray, "d"]
    std: Float[np.ndarray, "d"]
    quantiles: Float[np.ndarray, "5 d"]
    count: int

    def figures(self) -> dict[str, Any]:
        """Return min, max, mean, std, count and the quantiles as JSON lists."""
        quantiles = dict(zip(QUANTILES, self.quantiles.tolist(), strict=True))
        return {
            "min": self.minimum.tolist(),
            "max": self.maximum.tolist(),
            "mean": self.mean.tolist(),
            "std": self.std.tolist(),
            "count": [self.count],
            **quantiles,
        }

    @classmethod
    def of_figures(cls, figures: Mapping[str, Any]) -> RowSummary:
        """Return the summary with the given ``figures``.

        Raises:
            KeyError, TypeError, ValueError: the figures are invalid.
        """
        names = ("min", "max", "mean", "std", *QUANTILES)
        rows = np.array([figures[name] for name in names], np.float64)
        (count,) = figures["count"]
        low, high, mean, spread = rows[:4]
        return cls(low, high, mean, spread, rows[4:], int(count))


def summarize(rows: Shaped[np.ndarray, "t *d"]) -> RowSummary:
    """Summarise one or more rows of numbers or booleans."""
    table = np.asarray(rows, np.float64).reshape(len(rows), -1)
    quantiles = np.quantile(table, list(QUANTILES.values()), axis=0)
    return RowSummary(table.min(0), table.max(0), table.mean(0), table.std(0), quantiles, len(rows))


def summarize_colors(pictures: UInt8[np.ndarray, "t h w c"]) -> RowSummary:
    """Summarise pictures per channel, in [0, 1]; ``count`` is the number of pictures."""
    levels = np.arange(256) / 255.0
    channels = pictures.reshape(-1, pictures.shape[-1]).T
    counts = np.stack([np.bincount(channel, minlength=256) for channel in channels])
    shares = counts / counts.sum(1, keepdims=True)
    mean = shares @ levels
    spread = np.sqrt(np.maximum(shares @ levels**2 - mean**2, 0.0))
    below = np.cumsum(counts, 1)
    wanted = np.array(list(QUANTILES.values()))[:, None] * below[:, -1]
    ranks = np.array([np.searchsorted(b, w) for b, w in zip(below, wanted.T, strict=True)]).T
    seen = counts > 0
    low, high = seen.argmax(1), 255 - seen[:, ::-1].argmax(1)
    return RowSummary(levels[low], levels[high], mean, spread, levels[ranks], len(pictures))


def summarize_depth(pictures: Float[np.ndarray, "t h w"]) -> RowSummary:
    """Summarise depth pictures as one channel in metres; large streams are subsampled."""
    numbers = pictures.reshape(-1, 1)
    few = summarize(numbers[:: -(-len(numbers) // _MOST_NUMBERS)])
    return RowSummary(few.minimum, few.maximum, few.mean, few.std, few.quantiles, len(pictures))


def merge(summaries: Sequence[RowSummary]) -> RowSummary:
    """Merge summaries; quantiles are averaged, weighted by row counts.

    Range, mean and deviation are exact. Exact quantiles cannot be computed from quantiles; LeRobot
    uses the mean as well when it merges episodes.
    """
    counts = np.array([s.count for s in summaries], np.float64)
    shares = counts / counts.sum()
    means = np.stack([s.mean for s in summaries])
    mean = shares @ means
    spread = shares @ (np.stack([s.std**2 for s in summaries]) + (means - mean) ** 2)
    return RowSummary(
        np.min([s.minimum for s in summaries], axis=0),
        np.max([s.maximum for s in summaries], axis=0),
        mean,
        np.sqrt(spread),
        np.tensordot(shares, np.stack([s.quantiles for s in summaries]), 1),
        int(counts.sum()),
    )


class Summaries:
    """The summaries of a dataset, by name; its episodes are added one by one."""

    def __init__(self) -> None:
        self._known: dict[str, RowSummary] = {}

    def add(self, summaries: Mapping[str, RowSummary]) -> None:
        """Add the summaries of one more episode."""
        for name, summary in summaries.items():
            known = self._known.get(name)
            self._known[name] = summary if known is None else merge([known, summary])

    def figures(self) -> dict[str, dict[str, Any]]:
        """Return all statistics as JSON values, by name."""
        return {name: summary.figures() for name, summary in self._known.items()}
