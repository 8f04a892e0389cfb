"""How suites are made: tables are drawn, certified, and taken into a suite by their difficulty.

Tables are looked at in the order of their seeds until each split has its number of each level; what
is taken depends on the seeds alone, not on how many processes look. What is done is kept in a
folder, where the same draft resumes.
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
"""Seeds of listed tables are from here on, far beyond those that "fresh" draws by itself."""

Say = Callable[[str], None]


@dataclass(frozen=True)
class Quota:
    """How many tables of each level a draft takes, and from where on it looks for them.

    Attributes:
        test: tables of each level to test at.
        validation: tables of each level to choose a policy by.
        first: the seed from which on tables are drawn.
        most: how many tables are drawn at most.
    """

    test: int = 4
    validation: int = 1
    first: int = FIRST
    most: int = 400

    def __post_init__(self) -> None:
        require(self, "test", "validation", "first", minimum=0, integer=True)
        require(self, "most", minimum=1, integer=True)

    def of(self, split: Split) -> int:
        """Return the tables of each level in a split."""
        return {"train": 0, "validation": self.validation, "test": self.test}[split]


def draft(
    suites: TaskSuites, folder: Path, quota: Quota, workers: int = 1, say: Say = print
) -> TaskSuites:
    """Return suites with tables drawn for them; ``suites.tables`` are not looked at.

    Of each level the tables to test at come first, then those for validation.

    Args:
        suites: all but the tables.
        folder: where tables are kept until they are certified.
        quota: how many.
        workers: processes that draw and certify.
        say: is told of each table.

    Raises:
        InputError: a number out of range.
        SceneError: not enough tables among ``quota.most``.
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
                    f"Among {quota.most} tables drawn for {suites.task} too few are solved: "
                    f"{dict(missing)} are missing. Draw more tables, or change the levels."
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
    """The tables of a draft, each in a folder of its seed."""

    suites: TaskSuites
    folder: Path
    quota: Quota

    def seeds(self) -> Iterator[int]:
        """Yield the seeds of the tables that are looked at; all are held out."""
        rule, found = self.suites.rule("test"), 0
        for seed in count(self.quota.first):
            if found == self.quota.most:
                return
            recipe = self.suites.recipe(seed)
            if rule.admits(lambda recipe=recipe: recipe.identity, frozenset):
                found += 1
                yield seed

    def rate(self, seed: int) -> tuple[int, float | None]:
        """Make a table, if it is not there; return how hard it is, None if it cannot be made."""
        try:
            return seed, difficulty(load(self.bundle(seed)))
        except SceneError:
            return seed, None

    def bundle(self, seed: int) -> Path:
        """Return the bundle of a table, made if it is not there."""
        place = self.folder / str(seed)
        there = [path for path in place.glob("*") if (path / "scene.json").is_file()]
        return there[0] if there else save(self.suites.recipe(seed).make(), place)

    def certify(self, seed: int) -> SuiteTable | None:
        """Have the expert play a table; return it, None if that fails."""
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
    """Return how many tables of each level are missing, of those of which any are."""
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
    """Take the first tables of the levels that are missing; those of others keep waiting."""
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
    """Yield the tables, those of a level to test at first, sorted by split, level and seed."""
    splits: tuple[Split, ...] = ("validation", "test")
    for split in splits:
        for level in suites.levels:
            own = [taken[s] for s in sorted(taken) if suites.level(taken[s].difficulty) == level[0]]
            first = 0 if split == "test" else quota.test
            yield from (replace(t, split=split) for t in own[first : first + quota.of(split)])
