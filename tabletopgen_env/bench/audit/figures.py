"""Detection of results that no run of a suite can produce."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from generator.errors import InputError

from ..episode import SuiteOutcome
from ..instances import Suite
from ..results import BenchResult, EpisodeRow, row_of
from ..run import PACKAGES
from ..suites import digest_of

DoubtKind = Literal["too fast", "too long", "cut short", "reward too low", "reward too high",
                    "no versions"]  # fmt: skip

_ROUNDED = 1e-5  # rewards are rounded to 6 digits
_GIVES_UP = ("expert",)  # kinds of players that can end an episode early
_NOTHING = SuiteOutcome(False, 0, 0.0)


@dataclass(frozen=True)
class Doubt:
    """An impossible value in a result, and the number of episodes affected.

    Attributes:
        kind: the kind of the problem.
        count: number of affected episodes, or of packages for "no versions".
        value: the figure of the first affected episode.
        limit: the minimum or maximum possible value.
    """

    kind: DoubtKind
    count: int
    value: float = 0.0
    limit: float = 0.0

    def __str__(self) -> str:
        """Describe the problem in a sentence."""
        many = f"{self.count} episode{'s' if self.count > 1 else ''}"
        value, limit = f"{self.value:g}", f"{self.limit:g}"
        sentences: dict[DoubtKind, str] = {
            "too fast": f"{many} solved in {value} steps, but success must hold for {limit} steps",
            "too long": f"{many} of {value} steps, but the time limit is {limit}",
            "cut short": f"{many} ended without success after {value} of {limit} steps",
            "reward too low": (
                f"{many} solved with a mean reward of {value}, but the successful "
                f"steps alone give {limit}"
            ),
            "reward too high": f"{many} with a mean reward of {value}, which must be below {limit}",
            "no versions": f"{self.count} packages without a version",
        }
        return sentences[self.kind]


def suite_matches(result: BenchResult, suite: Suite) -> bool:
    """Return whether a result lists exactly the episodes of a suite, in the same order."""
    asked = [row_of(episode, _NOTHING) for episode in suite.episodes()]
    same = [(*r.key, r.level) for r in asked] == [(*r.key, r.level) for r in result.episodes]
    return same and (result.version, result.suites) == (suite.of.version, digest_of(suite.of))


def check_suite(result: BenchResult, suite: Suite) -> None:
    """Check that a result belongs to the current version of its suite.

    Raises:
        InputError: it does not.
    """
    if not suite_matches(result, suite):
        raise InputError(
            f"The result of {result.player.name} on {result.suite} lists different episodes than "
            f"the package's suite {suite.of.version}. Run the suite again."
        )


def doubts(result: BenchResult, suite: Suite) -> tuple[Doubt, ...]:
    """Return the impossible values in a suite's result; an unmodified result has none.

    An episode is solved once success has held for ``hold`` steps, during which the dense reward is
    exactly 1; otherwise it lasts until the time limit. The mean reward must agree with this.
    """
    found: dict[DoubtKind, Doubt] = {}
    for row in result.episodes:
        for doubt in _of_row(row, suite, result.player.kind in _GIVES_UP):
            first = found.get(doubt.kind, doubt)
            count = found[doubt.kind].count + 1 if doubt.kind in found else 1
            found[doubt.kind] = Doubt(doubt.kind, count, first.value, first.limit)
    missing = len({*PACKAGES} - {*result.versions})
    if missing:
        found["no versions"] = Doubt("no versions", missing)
    return tuple(found.values())


def _of_row(row: EpisodeRow, suite: Suite, gives_up: bool) -> Iterator[Doubt]:
    hold, limit = suite.of.hold, suite.of.time_limit
    if row.steps > limit:
        yield Doubt("too long", 1, row.steps, limit)
    if not row.solved:
        if row.steps < limit and not gives_up:
            yield Doubt("cut short", 1, row.steps, limit)
    elif row.steps < hold:
        yield Doubt("too fast", 1, row.steps, hold)
    elif row.reward < hold / row.steps - _ROUNDED:
        yield Doubt("reward too low", 1, row.reward, round(hold / row.steps, 4))
    if row.reward >= 1 and not (row.solved and row.steps == hold):
        yield Doubt("reward too high", 1, row.reward, 1.0)
