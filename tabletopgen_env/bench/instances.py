"""What a suite holds: tables by their seeds and digests, and what is to be done at each."""

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
"""What tables are for: to train at, to choose a policy by, and to report."""

LISTED: tuple[Split, ...] = ("validation", "test")
"""The splits whose tables are listed; tables to train at are a range of seeds."""

Condition = Literal["plain", "random"]
"""Whether episodes of an instance start alike, or with ``TaskSuites.randomization``."""

RANDOM = "-random"
"""Ends the name of a suite with randomisation."""


class SuiteLevel(NamedTuple):
    """A range of difficulty, ``low`` included, ``high`` not; see ``scenes.difficulty``."""

    name: str
    low: float
    high: float

    def holds(self, difficulty: float) -> bool:
        """Tell whether a difficulty is in the range."""
        return self.low <= difficulty < self.high


@dataclass(frozen=True)
class SuiteTable:
    """A table of a suite.

    Attributes:
        split: what it is for.
        seed: what its scene is drawn by, from ``TaskSuites.distribution``.
        digest: of its scene, as ``generator.bundle.digest`` says.
        difficulty: how hard it is to work at, in [0, 1].
        instances: what there is to do, with how often the expert did it; see ``certificates``.
    """

    split: Split
    seed: int
    digest: str
    difficulty: float
    instances: tuple[TaskInstance, ...]

    @property
    def solvable(self) -> tuple[TaskInstance, ...]:
        """The instances that are played: those that the expert solved from all starts."""
        return tuple(i for i in self.instances if i.certified and i.preset is None)


@dataclass(frozen=True)
class SuiteEpisode:
    """One episode of a suite: an instance at a table, and the seed of all that is drawn there."""

    table: SuiteTable
    level: str
    instance: TaskInstance
    number: int
    seed: int


@dataclass(frozen=True)
class TaskSuites:
    """The suites of one task: what its tables and episodes are, the same for every policy.

    Attributes:
        version: of the suites.
        task: the task.
        control_hz: actions per second.
        time_limit: steps of an episode.
        hold: steps in a row for which success has to hold.
        randomization: of the suites with randomisation.
        episodes: of each instance, by condition.
        distribution: what tables are drawn from.
        levels: the ranges of difficulty, from easy to hard.
        training: seeds of tables to train at are below this number.
        share: of all tables, those that are held out by digest; see ``scenes.splits``. Listed
            tables are held out, tables to train at are not.
        terms: what the certificates of the tables were made for.
        versions: of the packages that the tables were made with.
        tables: the listed ones.
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
        """Return what decides the table of a seed."""
        return SceneRecipe(self.distribution, seed)

    def rule(self, split: Split) -> SplitRule:
        """Return the rule that all tables of a split keep to."""
        return SplitRule("train" if split == "train" else "held_out", share=self.share)

    def level(self, difficulty: float) -> str:
        """Return the name of the range of a difficulty; the last of what is beyond all."""
        held = (level.name for level in self.levels if level.holds(difficulty))
        return next(held, self.levels[-1].name)

    def suites(self) -> tuple[Suite, ...]:
        """Return the suites that can be played."""
        return tuple(Suite(self, s, c) for s in LISTED for c in ("plain", "random"))


@dataclass(frozen=True)
class Suite:
    """One suite: the tables of a split, with or without randomisation."""

    of: TaskSuites
    split: Split
    condition: Condition

    @property
    def name(self) -> str:
        """What it is called: "lift-test" or "lift-test-random"."""
        random = RANDOM if self.condition == "random" else ""
        return f"{self.of.task.lower()}-{self.split}{random}"

    @property
    def tables(self) -> tuple[SuiteTable, ...]:
        """Its tables."""
        return tuple(table for table in self.of.tables if table.split == self.split)

    @property
    def settings(self) -> Mapping[str, Any]:
        """The keywords of an environment that are the suite's, not a policy's."""
        return MappingProxyType(
            {
                "control_hz": self.of.control_hz,
                "randomization": self.of.randomization if self.condition == "random" else None,
                "certified": False,
            }
        )

    def episodes(self) -> tuple[SuiteEpisode, ...]:
        """Return its episodes, table by table."""
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
        """Return an episode's seed, which no other table, instance or order changes."""
        parts = (
            self.of.version, self.of.task, self.condition, table.digest, instance.target,
            instance.goal, number,
        )  # fmt: skip
        hashed = hashlib.sha256("/".join(map(str, parts)).encode()).digest()
        return int.from_bytes(hashed[:4], "big") >> 1


def suite_of(suites: TaskSuites, split: str, random: bool) -> Suite:
    """Return the suite of a split, with or without randomisation.

    Raises:
        InputError: there is no such split, or its tables are not listed.
    """
    if split == "train":
        raise InputError(
            f"{suites.task.lower()}-train is to train at, and lists no episodes. Train with "
            f"bench.training.training_tables({suites.task!r}), and run a suite of "
            f"{' or '.join(LISTED)}."
        )
    for suite in suites.suites():
        if (suite.split, suite.condition == "random") == (split, random):
            return suite
    raise InputError(f"There is no split {split!r}; there are train, {', '.join(LISTED)}.")
