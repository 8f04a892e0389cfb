"""The check of a result by ``bench check``, and its output."""

from __future__ import annotations

import secrets
import sys
from dataclasses import dataclass, field
from pathlib import Path

from generator.errors import InputError, escape, require_seed
from generator.jobs.pools import PoolOptions
from generator.scene.provenance import versions

from ..results import BenchResult, EpisodeRow, read_result
from ..run import PACKAGES
from ..suites import find_suite
from .figures import check_suite, doubts
from .marks import ReplayMark, mark_path, read_mark, remove_mark, write_mark
from .replay import EpisodeReplay, draw_places, player_of, replay


@dataclass(frozen=True)
class Check:
    """Settings of a check of results.

    Attributes:
        episodes: number of episodes to replay per result.
        seed: seed of the random choice of episodes; None for a different choice each time.
        policy: the player; None for the one named in the result.
        suite: the suite, if it is defined in your own file.
        tables: folder of the tables; None for "bench" in the user's cache.
        pool: worker processes that generate missing tables.
    """

    episodes: int = 5
    seed: int | None = None
    policy: str | None = None
    suite: str | None = None
    tables: Path | None = None
    pool: PoolOptions = field(default_factory=PoolOptions)


def check_result(path: Path, check: Check) -> bool:
    """Check a result, print the outcome and update its replay mark; return whether it passed.

    An existing mark that covers more episodes of the same result is kept.

    Raises:
        InputError: the result is invalid, its suite or policy is not found, or a number is out of
            range.
        SceneError: a table is generated differently here.
        BundleError: a table is damaged.
        StorageError: the mark cannot be written.
    """
    result = read_result(path)
    suite = find_suite(check.suite or result.suite)
    check_suite(result, suite)
    seed = secrets.randbelow(2**31) if check.seed is None else check.seed
    require_seed(seed)
    numbers = draw_places(check.episodes, result, seed)
    if found := doubts(result, suite):
        remove_mark(path)
        for doubt in found:
            _fail(path, str(doubt))
        return False
    player = player_of(result, suite, check.policy)
    failed = 0
    for again in replay(result, suite, player, numbers, check.tables, check.pool):
        if not again.agrees:
            failed += 1
            _fail(path, _difference(again))
    if failed:
        remove_mark(path)
        _fail(path, f"{failed} of {len(numbers)} episodes differ (seed {seed}){_others(result)}")
        return False
    mark = ReplayMark(result.digest, seed, numbers, versions(PACKAGES))
    kept = _stronger_mark(path, mark)
    if kept is None:
        write_mark(path, mark)
    marked = (
        "marked" if kept is None else (f"kept the existing mark for {len(kept.episodes)} episodes")
    )
    print(
        escape(
            f"{path}: {len(numbers)} of {len(result.episodes)} episodes replayed (seed {seed}), "
            f"all as listed; {marked} in {mark_path(path).name}"
        ),
        flush=True,
    )
    return True


def _stronger_mark(path: Path, mark: ReplayMark) -> ReplayMark | None:
    """Return a result's existing replay mark if it covers more episodes than ``mark``, or None."""
    try:
        there = read_mark(path, mark.result)
    except InputError:  # edited or damaged, so not a mark
        return None
    more = there is not None and len(there.episodes) > len(mark.episodes)
    return there if more else None


def _fail(path: Path, why: str) -> None:
    print(escape(f"{path}: {why}"), file=sys.stderr, flush=True)


def _difference(again: EpisodeReplay) -> str:
    """Describe how the outcome of a replayed episode differs from the listed one."""
    row = again.listed
    what = [part for part in (row.target, row.goal) if part]
    return (
        f"episode {again.number} (table {row.table}{', ' if what else ''}{', '.join(what)}, seed "
        f"{row.seed}) is {_outcome(again.played)}, but is listed as {_outcome(row)}"
    )


def _outcome(row: EpisodeRow) -> str:
    solved = "solved" if row.solved else "not solved"
    return f"{solved} in {row.steps} steps with a mean reward of {row.reward:g}"


def _others(result: BenchResult) -> str:
    """Describe the packages whose installed versions differ from those recorded in the result."""
    here = versions(PACKAGES)
    other = [f"{k} {v}, here {here[k]}" for k, v in result.versions.items() if here.get(k) != v]
    return f"; the result was made with {', '.join(other)}" if other else ""
