"""Creation of suites: tables are drawn, certified, and selected by difficulty.

Tables are examined in the order of their seeds until each split has the required number per level.
The selection depends only on the seeds, not on the number of processes. Intermediate results are
stored in a folder, from which the same draft can be resumed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from itertools import count
from pathlib import Path

from generator.bundle import load, load_digest, save
from generator.errors import InputError, SceneError, require
from generator.jobs.pools import pool_of

from ..certificates.certificate import Terms, read_certificate
from ..certificates.certify import certify, is_certified
from ..scenes import difficulty
from .instances import LISTED, Split, SuiteTable, TaskSuites

FIRST = 2**29
"""First seed of listed tables, far beyond the seeds that "fresh" draws."""

Say = Callable[[str], None]


@dataclass(frozen=True)
class Quota:
    """The number of tables of each level in a draft, and the range of seeds to search.

    Attributes:
        test: test tables per level.
        validation: validation tables per level.
        first: first seed.
        most: maximum number of drawn tables.
    """

    test: int = 4
    validation: int = 1
    first: int = FIRST
    most: int = 400

    def __post_init__(self) -> None:
        require(self, "test", "validation", "first", minimum=0, integer=True)
        require(self, "most", minimum=1, integer=True)

    def of(self, split: Split) -> int:
        """Return the number of tables per level in a split."""
        return {"train": 0, "validation": self.validation, "test": self.test}[split]


def draft(
    suites: TaskSuites, folder: Path, quota: Quota, workers: int = 1, say: Say = print
) -> TaskSuites:
    """Return the suites with newly drawn tables in place of ``suites.tables``.

    For each level, the test tables come first, then the validation tables.

    Args:
        suites: all settings but the tables.
        folder: folder for tables until they are certified.
        quota: number of tables.
        workers: processes that draw and certify.
        say: receives a message for each table.

    Raises:
        InputError: a number is out of range.
        SceneError: there are not enough tables among ``quota.most``.
    """
    drawn = _Drawn(suites, folder / suites.task.lower(), quota)
    taken: dict[int, SuiteTable] = {}
    with closing(pool_of(workers)) as pool:
        rated = pool.map(drawn.rate, drawn.seeds())
        waiting: list[tuple[int, float]] = []
        while missing := _missing(suites, quota, taken.values()):
            chosen = _choose(suites, missing, waiting, rated)
            if not chosen:
                raise SceneError(
                    f"Too few of the {quota.most} tables drawn for {suites.task} were solved. "
                    f"Tables still missing by level: {dict(missing)}. Draw more tables, or change "
                    "the levels."
                )
            found = pool.map(drawn.certify, [seed for seed, _ in chosen])
            for (seed, hard), table in zip(chosen, found, strict=True):
                level = suites.level(hard)
                solved = 0 if table is None else len(table.solvable)
                say(f"{suites.task} {seed}: {level} {hard:.3f}, {solved} instances")
                if table is not None and solved:
                    taken[seed] = table
    return replace(suites, tables=tuple(_assign(suites, quota, taken)))


@dataclass(frozen=True)
class _Drawn:
    """The tables of a draft, each in a folder named after its seed."""

    suites: TaskSuites
    folder: Path
    quota: Quota

    def seeds(self) -> Iterator[int]:
        """Yield the seeds of the tables to examine, all of which are held out."""
        rule, found = self.suites.rule("test"), 0
        for seed in count(self.quota.first):
            if found == self.quota.most:
                return
            recipe = self.suites.recipe(seed)
            if rule.admits(lambda recipe=recipe: recipe.identity, frozenset):
                found += 1
                yield seed

    def rate(self, seed: int) -> tuple[int, float | None]:
        """Return the seed and the difficulty of a table; the latter is None if generation fails."""
        try:
            return seed, difficulty(load(self.bundle(seed)))
        except SceneError:
            return seed, None

    def bundle(self, seed: int) -> Path:
        """Return the bundle of a table, generating it if it is missing."""
        place = self.folder / str(seed)
        there = [path for path in place.glob("*") if (path / "scene.json").is_file()]
        return there[0] if there else save(self.suites.recipe(seed).make(), place)

    def certify(self, seed: int) -> SuiteTable | None:
        """Certify a table with the expert; return the table, or None if certification fails."""
        terms: Terms = self.suites.terms
        try:
            bundle = self.bundle(seed)
            if not is_certified(bundle, terms):
                certify(bundle, terms)
            certificate = read_certificate(bundle)
            assert certificate is not None
            hard = round(difficulty(load(bundle)), 6)
            return SuiteTable("test", seed, load_digest(bundle), hard, certificate.instances)
        except (InputError, SceneError):
            return None


def _missing(suites: TaskSuites, quota: Quota, taken: Iterable[SuiteTable]) -> Mapping[str, int]:
    """Return the number of missing tables per level, omitting complete levels."""
    have = Counter(suites.level(table.difficulty) for table in taken)
    each = sum(quota.of(split) for split in LISTED)
    wanted = {level.name: each - have[level.name] for level in suites.levels}
    return {name: number for name, number in wanted.items() if number > 0}


def _choose(
    suites: TaskSuites,
    missing: Mapping[str, int],
    waiting: list[tuple[int, float]],
    rated: Iterator[tuple[int, float | None]],
) -> Sequence[tuple[int, float]]:
    """Return the next tables of each incomplete level; the other tables stay in ``waiting``."""
    left = Counter(missing)
    chosen: list[tuple[int, float]] = []

    def take(seed: int, hard: float) -> bool:
        level = suites.level(hard)
        if left[level] <= 0:
            return False
        left[level] -= 1
        chosen.append((seed, hard))
        return True

    waiting[:] = [each for each in waiting if not take(*each)]
    while any(number > 0 for number in left.values()):
        seed, hard = next(rated, (None, None))
        if seed is None:
            break
        if hard is not None and not take(seed, hard):
            waiting.append((seed, hard))
    return chosen


def _assign(
    suites: TaskSuites, quota: Quota, taken: Mapping[int, SuiteTable]
) -> Iterator[SuiteTable]:
    """Yield the tables with their splits; the first tables of each level are test tables."""
    splits: tuple[Split, ...] = ("validation", "test")
    for split in splits:
        for level in suites.levels:
            own = [taken[s] for s in sorted(taken) if suites.level(taken[s].difficulty) == level[0]]
            first = 0 if split == "test" else quota.test
            yield from (replace(t, split=split) for t in own[first : first + quota.of(split)])
