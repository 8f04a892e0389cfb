"""Tiny suites: toy tables on disk under the names that suites look for, one that is composed."""

from pathlib import Path

import pytest
from toy import toy_object, toy_scene

from generator.bundle import digest, save
from generator.language.distribution import SceneDistribution
from generator.physics.gate import judge
from generator.scene.provenance import versions
from tabletopgen_env.bench.instances import SuiteLevel, SuiteTable, TaskSuites
from tabletopgen_env.bench.suites import write_suites
from tabletopgen_env.bench.tables import name_of
from tabletopgen_env.certificates.certificate import TaskInstance, Terms
from tabletopgen_env.randomization import Randomization

LEVELS = (SuiteLevel("easy", 0.0, 0.2), SuiteLevel("hard", 0.2, 1.0))
ANYWHERE = (TaskInstance("Reach", None, None, 30, 30), TaskInstance("Reach", "x", None, 3, 4))


def suites_of(task: str, *tables: SuiteTable, limit: int = 12) -> TaskSuites:
    """Return suites of a task with tables, and episodes that are short."""
    return TaskSuites(
        version="tiny", task=task, control_hz=20, time_limit=limit, hold=2,
        randomization=Randomization(start_joints=0.06, mass=(0.8, 1.2)),
        episodes={"plain": 2, "random": 3},
        distribution=SceneDistribution(("office",), (1, 2)), levels=LEVELS, training=50, share=0.2,
        terms=Terms((task,), 30, 2), versions=versions(), tables=tables,
    )  # fmt: skip


@pytest.fixture(scope="session")
def store(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of two toy tables."""
    return tmp_path_factory.mktemp("tables")


@pytest.fixture(scope="session")
def reach(store: Path) -> TaskSuites:
    """Suites of Reach at two toy tables, of which one is hard."""
    tables = []
    for seed, (size, difficulty) in enumerate([(0.04, 0.1), (0.05, 0.3)]):
        scene = toy_scene((toy_object("cube_1", (size,) * 3, (-0.1, 0.0)),))
        table = SuiteTable("test", seed, digest(scene), difficulty, ANYWHERE)
        scene = scene.replace(name=name_of(suites_of("Reach"), table), report=judge(scene))
        save(scene, store)
        tables.append(table)
    return suites_of("Reach", *tables)


@pytest.fixture(scope="session")
def suite_file(reach: TaskSuites, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The file of the toy suites."""
    path = tmp_path_factory.mktemp("suites") / "reach.json"
    write_suites(reach, path)
    return path
