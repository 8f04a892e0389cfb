"""Suites of a task with tables of a test."""

from generator.language.distribution import SceneDistribution
from generator.scene.provenance import versions
from tabletopgen_env.bench.instances import SuiteLevel, SuiteTable, TaskSuites
from tabletopgen_env.certificates.certificate import TaskInstance, Terms
from tabletopgen_env.randomization import Randomization

LEVELS = (SuiteLevel("easy", 0.0, 0.2), SuiteLevel("hard", 0.2, 1.0))
ANYWHERE = (TaskInstance("Reach", None, None, 30, 30), TaskInstance("Reach", "x", None, 3, 4))


def suites_of(task: str, *tables: SuiteTable, limit: int = 12) -> TaskSuites:
    """Return suites of a task with the given tables and short episodes."""
    return TaskSuites(
        version="tiny", task=task, control_hz=20, time_limit=limit, hold=2,
        randomization=Randomization(start_joints=0.06, mass=(0.8, 1.2)),
        episodes={"plain": 2, "random": 3},
        distribution=SceneDistribution(("office",), (1, 2)), levels=LEVELS, training=50, share=0.2,
        terms=Terms((task,), 30, 2), versions=versions(), tables=tables,
    )  # fmt: skip
