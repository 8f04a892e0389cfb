"""Tiny suites: toy tables on disk under the names that suites expect, and a composed one."""

from pathlib import Path

import pytest
from tiny_suites import ANYWHERE, suites_of
from toy import toy_object, toy_scene

from generator.bundle import digest, save
from generator.physics.gate import judge
from tabletopgen_env.bench.instances import SuiteTable, TaskSuites
from tabletopgen_env.bench.suites import write_suites
from tabletopgen_env.bench.tables import name_of


@pytest.fixture(scope="session")
def store(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of two toy tables."""
    return tmp_path_factory.mktemp("tables")


@pytest.fixture(scope="session")
def reach(store: Path) -> TaskSuites:
    """Suites of Reach at two toy tables, one of them hard."""
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
