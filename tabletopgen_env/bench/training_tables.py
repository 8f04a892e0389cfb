"""Tables to train at: those of a suite's distribution that are never in a validation or test suite.

They are a range of seeds on the training side of the split that listed tables are held out of, the
same that ``scenes="fresh"`` draws from in training.
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
"""How many tables are made for one of the right difficulty."""


def training_tables(task: str, level: str | None = None) -> SceneSource:
    """Return the source of the tables to train at for a task, or of those of one level.

    Raises:
        InputError: no suites of such a task, or no such level.
    """
    if task not in tasks():
        raise InputError(f"There are no suites of {task!r}; there are {', '.join(tasks())}.")
    suites = shipped_suites(task)
    fresh = FreshScenes(suites.distribution, suites.training, rules=(suites.rule("train"),))
    if level is None:
        return fresh
    found = {own.name: own for own in suites.levels}
    if level not in found:
        raise InputError(f"There is no level {level!r}; there are {', '.join(found)}.")
    return LevelScenes(fresh, found[level])


@dataclass(frozen=True)
class LevelScenes:
    """Those of fresh scenes that are of one level of difficulty, found by making others, too."""

    fresh: FreshScenes
    level: SuiteLevel

    def draw(self, rng: np.random.Generator) -> SceneRef:
        """Draw until a table is of the level.

        Raises:
            SceneError: none of ``DRAWS`` tables is.
        """
        for _ in range(DRAWS):
            ref = self.fresh.draw(rng)
            try:
                scene = ref.load()
            except SceneError:
                continue
            if self.level.holds(hard := difficulty(scene)):
                return HeldRef(scene, hard)
        raise SceneError(f"None of {DRAWS} tables is {self.level.name}.")
