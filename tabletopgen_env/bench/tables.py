"""The tables of suites on disk: found by name and digest, or regenerated bit-identically."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import closing
from functools import partial
from pathlib import Path
from platform import machine

import platformdirs

from generator.bundle import digest, load_digest, save
from generator.errors import BundleError, SceneError, require_number
from generator.io.files import check_folder
from generator.jobs.pools import PoolOptions, pool_of
from generator.jobs.workers import WorkerPool
from generator.scene import Scene
from generator.scene.provenance import versions

from ..certificates.certificate import Certificate, scene_digest, write_certificate
from .instances import SuiteTable, TaskSuites

_CERTIFIED_BY = ("tabletopgen", "mujoco", "numpy")

_KERNELS = {"OPENBLAS_CORETYPE": "Haswell"} if machine() in ("x86_64", "AMD64") else {}
"""Environment variable that makes the OpenBLAS of NumPy and SciPy round as it does on processors
with AVX2 only, on which the shipped suites were generated. With AVX-512, OpenBLAS uses other
kernels.
"""


def store_of(folder: Path | None) -> Path:
    """Return the folder of the tables: ``folder``, or "bench" in the user's cache.

    It is separate from ``assets_cache``, so that no name or glob used in training finds test
    tables.
    """
    return Path(platformdirs.user_cache_dir("tabletopgen")) / "bench" if folder is None else folder


def name_of(suites: TaskSuites, table: SuiteTable) -> str:
    """Return the scene name of a table, such as "bench-v1-lift-test-536870912"."""
    return f"bench-{suites.version}-{suites.task.lower()}-{table.split}-{table.seed}"


def find_table(suites: TaskSuites, table: SuiteTable, folder: Path | None = None) -> Path | None:
    """Return the bundle of a table, or None if it does not exist.

    Raises:
        BundleError: it has a different digest, or is damaged.
    """
    place, name = store_of(folder), name_of(suites, table)
    found = sorted(p for p in place.glob(f"{name}-*") if (p / "scene.json").is_file())
    for path in found:
        if load_digest(path) == table.digest:
            return path
    if found:
        raise BundleError(
            f"{found[0]} is not the table {table.digest} of the suite, but "
            f"{load_digest(found[0])}. Remove it; `tabletopgen bench make` generates it again."
        )
    return None


def make_tables(
    suites: TaskSuites,
    tables: Sequence[SuiteTable],
    folder: Path | None = None,
    pool: PoolOptions = PoolOptions(),  # noqa: B008
) -> Generator[Path, None, None]:
    """Yield the bundles of tables, in order; missing ones are generated.

    Each gets its certificate, which records what the expert solved on it.

    Raises:
        InputError: there are no workers.
        SceneError: a regenerated table differs from the suite's.
        BundleError: an existing table differs from the suite's.
        StorageError: the folder cannot be written.
    """
    require_number("--workers", pool.workers, minimum=1, maximum=1024, integer=True)
    place = store_of(folder)
    check_folder(place)
    make = partial(_make, suites, place)
    if pool.workers == 1 and pool.ray is None:
        yield from map(make, tables)
        return
    with closing(pool_of(pool.workers, pool.ray)) as workers:
        yield from workers.map(make, tables)


def _make(suites: TaskSuites, place: Path, table: SuiteTable) -> Path:
    """Return the bundle of a table, generating it if it is missing."""
    path = find_table(suites, table, place)
    if path is None:
        path = save(_compose(suites, table), place)
    made_with = {name: suites.versions[name] for name in _CERTIFIED_BY if name in suites.versions}
    certificate = Certificate(scene_digest(path), suites.terms, made_with, table.instances)
    write_certificate(path, certificate)
    return path


def _compose(suites: TaskSuites, table: SuiteTable) -> Scene:
    """Compose a table's scene; if its digest is wrong, retry with the suite's BLAS kernels."""
    recipe, name = suites.recipe(table.seed), name_of(suites, table)
    scene = recipe.make().replace(name=name)
    if (found := digest(scene)) == table.digest:
        return scene
    with closing(WorkerPool(1, environment=_KERNELS)) as pool:
        scene = pool.submit(recipe.make).result().replace(name=name)
    if digest(scene) == table.digest:
        return scene
    raise SceneError(
        f"The table {table.digest} of {suites.task.lower()}-{table.split} is not reproduced on "
        f"this machine, which generates {found} instead. {_difference(suites)}"
    )


def _difference(suites: TaskSuites) -> str:
    """Describe the probable reason why a table is generated differently on this machine."""
    here = versions(suites.versions)
    other = [f"{k} {v}, here {here[k]}" for k, v in suites.versions.items() if here[k] != v]
    if not other:
        return "The package has changed, or this processor computes differently."
    return f"The suite was generated with {'; '.join(other)}. Install these versions."
