"""Training tables: drawn from a suite's distribution, but never in a validation or test suite.

They are given by a range of seeds, without the tables that the split holds out; listed tables are
all held out. In training, ``scenes="fresh"`` draws from the same part of the split.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from generator.errors import InputError, SceneError

from ..scenes import FreshScenes, SceneRef, SceneSource, difficulty
from ..scenes.source import HeldRef
from .instances import SuiteLevel
from .suites import shipped_suites, tasks

DRAWS = 200
"""Maximum number of tables generated to find one of the required difficulty."""


def training_tables(task: str, level: str | None = None) -> SceneSource:
    """Return the source of training tables for a task, optionally limited to one level.

    Raises:
        InputError: there are no suites of the task, or the level does not exist.
    """
    if task not in tasks():
        raise InputError(f"No suites of {task!r}; available tasks: {', '.join(tasks())}.")
    suites = shipped_suites(task)
    fresh = FreshScenes(suites.distribution, suites.training, rules=(suites.rule("train"),))
    if level is None:
        return fresh
    found = {own.name: own for own in suites.levels}
    if level not in found:
        raise InputError(f"Unknown level {level!r}; the levels are {', '.join(found)}.")
    return LevelScenes(fresh, found[level])


@dataclass(frozen=True)
class LevelScenes:
    """Fresh scenes of one level of difficulty, found by rejection sampling."""

    fresh: FreshScenes
    level: SuiteLevel

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw tables until one is of the required level.

        Raises:
            SceneError: none of ``DRAWS`` tables has it.
        """
        for _ in range(DRAWS):
            ref = self.fresh.draw(rng)
            try:
                scene = ref.load()
            except SceneError:
                continue
            if self.level.holds(hard := difficulty(scene)):
                return HeldRef(scene, hard)
        raise SceneError(f"None of {DRAWS} generated tables has the level {self.level.name!r}.")
