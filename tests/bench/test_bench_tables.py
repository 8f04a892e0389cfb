"""Tables are found by name and digest, regenerated bit for bit, and certified."""

import dataclasses
import os
from pathlib import Path
from platform import machine

import pytest
from tiny_suites import ANYWHERE, suites_of

import assets_cache
from generator.bundle import digest, load_digest
from generator.errors import BundleError, InputError, MissingError, SceneError
from generator.jobs.pools import PoolOptions
from tabletopgen_env.bench import tables
from tabletopgen_env.bench.instances import SuiteTable, TaskSuites
from tabletopgen_env.bench.suites import shipped_suites
from tabletopgen_env.certificates.certificate import read_certificate


@pytest.fixture(scope="module")
def composed() -> TaskSuites:
    """Suites with one table that is composed."""
    blank = suites_of("Reach")
    made = digest(blank.recipe(7).make())
    return suites_of("Reach", SuiteTable("test", 7, made, 0.1, ANYWHERE))


def test_a_table_is_made_again(composed: TaskSuites, tmp_path: Path) -> None:
    (table,) = composed.tables
    assert tables.find_table(composed, table, tmp_path) is None
    (path,) = tables.make_tables(composed, composed.tables, tmp_path)
    assert load_digest(path) == table.digest
    assert path.name.startswith("bench-tiny-reach-test-7-")
    certificate = read_certificate(path)
    assert certificate is not None and certificate.instances == ANYWHERE
    before = (path / "scene.json").stat().st_mtime_ns
    assert list(tables.make_tables(composed, composed.tables, tmp_path)) == [path]
    assert (path / "scene.json").stat().st_mtime_ns == before


def test_the_search_by_name_does_not_find_tables_in_the_cache(
    composed: TaskSuites, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("TABLETOPGEN_CACHE", raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    (path,) = tables.make_tables(composed, composed.tables)
    assert path.parent == tmp_path / "tabletopgen" / "bench"
    assert tables.find_table(composed, composed.tables[0]) == path
    assert assets_cache.entries() and path not in assets_cache.entries()
    with pytest.raises(MissingError):
        assets_cache.find("bench-tiny-*")


@pytest.mark.skipif(machine() not in ("x86_64", "AMD64"), reason="OpenBLAS has other kernels")
def test_a_table_that_this_processor_computes_otherwise_is_made_as_the_makers_did(
    composed: TaskSuites, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pool = tables.WorkerPool(1, environment=tables._KERNELS)
    try:
        assert pool.submit(os.getenv, "OPENBLAS_CORETYPE").result(60) == "Haswell"
        made = pool.submit(composed.recipe(7).make).result(60)
    finally:
        pool.close()
    table = dataclasses.replace(composed.tables[0], digest=digest(made))
    digests = iter(["0" * 12])  # of what is made here first
    monkeypatch.setattr(tables, "digest", lambda scene: next(digests, None) or digest(scene))
    (path,) = tables.make_tables(composed, (table,), tmp_path)
    assert load_digest(path) == table.digest


def test_another_table_than_the_suite_says_is_refused(composed: TaskSuites, tmp_path: Path) -> None:
    wrong = dataclasses.replace(composed.tables[0], digest="0" * 12)
    with pytest.raises(SceneError, match=r"instead.*package has changed"):
        list(tables.make_tables(composed, (wrong,), tmp_path))
    assert not list(tmp_path.iterdir())
    older = dataclasses.replace(composed, versions={"mujoco": "1.0", "numpy": "2.0"})
    with pytest.raises(SceneError, match=r"generated with mujoco 1\.0, here .*Install these"):
        list(tables.make_tables(older, (wrong,), tmp_path))


def test_a_table_in_the_place_of_another_is_refused(store: Path, reach: TaskSuites) -> None:
    table = reach.tables[0]
    assert tables.find_table(reach, table, store) is not None
    with pytest.raises(BundleError, match="is not the table 000000000000"):
        tables.find_table(reach, dataclasses.replace(table, digest="0" * 12), store)


def test_no_worker_is_refused(reach: TaskSuites, store: Path) -> None:
    with pytest.raises(InputError, match="--workers"):
        list(tables.make_tables(reach, reach.tables, store, PoolOptions(0)))


@pytest.mark.slow
@pytest.mark.parametrize("task", ["Lift", "Stack"])
def test_a_shipped_table_is_made_again(task: str, tmp_path: Path) -> None:
    suites = shipped_suites(task)
    (path,) = tables.make_tables(suites, suites.tables[:1], tmp_path)
    assert load_digest(path) == suites.tables[0].digest
