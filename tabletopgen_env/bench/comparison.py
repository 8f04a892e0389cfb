"""Episode-by-episode comparison of each result of a suite with the first one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from generator.errors import InputError

from ..statistics import newcombe_paired
from .results import BenchResult


@dataclass(frozen=True)
class PairedDifference:
    """The difference between a result and a baseline on the same episodes.

    Attributes:
        gained: episodes that only this result solved.
        lost: episodes that only the baseline solved.
        share: difference of the success rates.
        interval: its 95 % interval; see ``statistics.newcombe_paired``.
    """

    gained: int
    lost: int
    share: float
    interval: tuple[float, float]


def difference(result: BenchResult, baseline: BenchResult) -> PairedDifference:
    """Compute the difference between a result and a baseline.

    Raises:
        InputError: the results belong to different suites.
    """
    for name in ("suite", "version", "suites"):
        if (own := getattr(result, name)) != (other := getattr(baseline, name)):
            raise InputError(
                f"Results can only be compared on the same suite: {result.player.name} has "
                f"{name} {own[:40]!r}, and {baseline.player.name} has {other[:40]!r}."
            )
    before = {row.key: row.solved for row in baseline.episodes}
    if before.keys() != {row.key for row in result.episodes}:
        raise InputError(
            f"The results of {result.player.name} and {baseline.player.name} list different "
            f"episodes of {result.suite}. Run the suite again."
        )
    pairs = [(row.solved, before[row.key]) for row in result.episodes]
    both, one, other, neither = (
        pairs.count(pair) for pair in ((True, True), (True, False), (False, True), (False, False))
    )
    interval = newcombe_paired(both, one, other, neither)
    return PairedDifference(one, other, (one - other) / len(pairs), interval)


def compare(results: Sequence[BenchResult]) -> list[tuple[str, ...]]:
    """Return the rows of a comparison table, with its header; the first result is the baseline.

    Raises:
        InputError: there are no results, or they belong to different suites.
    """
    if not results:
        raise InputError("Specify at least one result to compare.")
    levels = list(dict.fromkeys(row.level for row in results[0].episodes))
    head = ("policy", "solved", "share", "95 %", *levels, "difference", "95 %", "gained", "lost")
    return [head, *(_row(r, results[0], levels, k == 0) for k, r in enumerate(results))]


def percent(share: float) -> str:
    """Format a fraction as a percentage, such as "97.5"."""
    return f"{100 * share:.1f}"


def span(interval: tuple[float, float]) -> str:
    """Format an interval, such as "94.1 to 99.0"."""
    return " to ".join(map(percent, interval))


def _row(
    result: BenchResult, baseline: BenchResult, levels: Sequence[str], first: bool
) -> tuple[str, ...]:
    own = difference(result, baseline)
    apart = (f"{100 * own.share:+.1f}", span(own.interval), f"{own.gained}", f"{own.lost}")
    return (
        result.player.title,
        f"{result.solved} of {len(result.episodes)}",
        f"{percent(result.share)} %",
        span(result.interval),
        *(" of ".join(map(str, result.of_level(level))) for level in levels),
        *(("",) * 4 if first else apart),
    )
