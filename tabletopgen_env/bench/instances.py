"""The contents of a suite: tables with their seeds, digests and task instances."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Literal, NamedTuple

from generator.errors import InputError
from generator.language.distribution import SceneDistribution

from ..certificates.certificate import TaskInstance, Terms
from ..randomization import Randomization
from ..scenes import SceneRecipe, SplitRule

Split = Literal["train", "validation", "test"]
"""What tables are used for: training, model selection, or final results."""

LISTED: tuple[Split, ...] = ("validation", "test")
"""The splits whose tables are listed; training tables are given by a range of seeds."""

Condition = Literal["plain", "random"]
"""Whether an instance's episodes all start alike or with ``TaskSuites.randomization``."""

RANDOM = "-random"
"""Suffix of the names of suites with randomisation."""


class SuiteLevel(NamedTuple):
    """A range of difficulties, [``low``, ``high``); see ``scenes.difficulty``."""

    name: str
    low: float
    high: float

    def holds(self, difficulty: float) -> bool:
        """Return whether a difficulty is in the range."""
        return self.low <= difficulty < self.high


@dataclass(frozen=True)
class SuiteTable:
    """A table of a suite.

    Attributes:
        split: what it is used for.
        seed: seed of its scene in ``TaskSuites.distribution``.
        digest: digest of its scene, see ``generator.bundle.digest``.
        difficulty: its difficulty, in [0, 1].
        instances: its task instances, with the expert's success rates; see ``certificates``.
    """

    split: Split
    seed: int
    digest: str
    difficulty: float
    instances: tuple[TaskInstance, ...]

    @property
    def solvable(self) -> tuple[TaskInstance, ...]:
        """The instances in the suite: those that the expert solved from all initial states."""
        return tuple(i for i in self.instances if i.certified and i.preset is None)


@dataclass(frozen=True)
class SuiteEpisode:
    """An episode of a suite: a task instance on a table, and the seed of all random draws."""

    table: SuiteTable
    level: str
    instance: TaskInstance
    number: int
    seed: int


@dataclass(frozen=True)
class TaskSuites:
    """The suites of one task, with tables and episodes that are the same for every policy.

    Attributes:
        version: version of the suites.
        task: the task.
        control_hz: actions per second.
        time_limit: maximum number of steps per episode.
        hold: number of consecutive steps for which success has to hold.
        randomization: randomisation of the suites that have one.
        episodes: number of episodes per instance, by condition.
        distribution: distribution of the tables.
        levels: the ranges of difficulty, from easy to hard.
        training: exclusive upper bound of the seeds of training tables.
        share: share of all tables that are held out by digest; see ``scenes.splits``. Listed tables
            are held out, training tables are not.
        terms: the conditions of the tables' certificates.
        versions: versions of the packages that the tables were generated with.
        tables: the listed tables.
    """

    version: str
    task: str
    control_hz: int
    time_limit: int
    hold: int
    randomization: Randomization
    episodes: Mapping[Condition, int]
    distribution: SceneDistribution
    levels: tuple[SuiteLevel, ...]
    training: int
    share: float
    terms: Terms
    versions: Mapping[str, str]
    tables: tuple[SuiteTable, ...]

    def recipe(self, seed: int) -> SceneRecipe:
        """Return the recipe of the table with the given seed."""
        return SceneRecipe(self.distribution, seed)

    def rule(self, split: Split) -> SplitRule:
        """Return the rule that all tables of a split obey."""
        return SplitRule("train" if split == "train" else "held_out", share=self.share)

    def level(self, difficulty: float) -> str:
        """Return the name of the level that contains a difficulty, or the last level's name."""
        held = (level.name for level in self.levels if level.holds(difficulty))
        return next(held, self.levels[-1].name)

    def suites(self) -> tuple[Suite, ...]:
        """Return the runnable suites."""
        return tuple(Suite(self, s, c) for s in LISTED for c in ("plain", "random"))


@dataclass(frozen=True)
class Suite:
    """A suite: the tables of a split, with or without randomisation."""

    of: TaskSuites
    split: Split
    condition: Condition

    @property
    def name(self) -> str:
        """The suite's name, such as "lift-test" or "lift-test-random"."""
        random = RANDOM if self.condition == "random" else ""
        return f"{self.of.task.lower()}-{self.split}{random}"

    @property
    def tables(self) -> tuple[SuiteTable, ...]:
        """The suite's tables."""
        return tuple(table for table in self.of.tables if table.split == self.split)

    @property
    def settings(self) -> Mapping[str, Any]:
        """The environment's keyword arguments that are set by the suite, not by the policy."""
        return MappingProxyType(
            {
                "control_hz": self.of.control_hz,
                "randomization": self.of.randomization if self.condition == "random" else None,
                "certified": False,
            }
        )

    def episodes(self) -> tuple[SuiteEpisode, ...]:
        """Return the suite's episodes, grouped by table."""
        return tuple(self._episodes())

    def _episodes(self) -> Iterator[SuiteEpisode]:
        for table in self.tables:
            level = self.of.level(table.difficulty)
            for instance in table.solvable:
                for number in range(self.of.episodes[self.condition]):
                    yield SuiteEpisode(
                        table, level, instance, number, self._seed(table, instance, number)
                    )

    def _seed(self, table: SuiteTable, instance: TaskInstance, number: int) -> int:
        """Return the seed of an episode, which does not depend on other tables or instances."""
        parts = (
            self.of.version, self.of.task, self.condition, table.digest, instance.target,
            instance.goal, number,
        )  # fmt: skip
        hashed = hashlib.sha256("/".join(map(str, parts)).encode()).digest()
        return int.from_bytes(hashed[:4], "big") >> 1


def suite_of(suites: TaskSuites, split: str, random: bool) -> Suite:
    """Return the suite of a split, with or without randomisation.

    Raises:
        InputError: the split does not exist, or its tables are not listed.
    """
    if split == "train":
        raise InputError(
            f"{suites.task.lower()}-train is for training and lists no episodes. Train with "
            f"bench.training.training_tables({suites.task!r}), and evaluate on "
            f"{' or '.join(LISTED)}."
        )
    for suite in suites.suites():
        if (suite.split, suite.condition == "random") == (split, random):
            return suite
    raise InputError(f"Unknown split {split!r}; the splits are train, {', '.join(LISTED)}.")
