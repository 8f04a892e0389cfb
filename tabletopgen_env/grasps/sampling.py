"""Sampling of grasp labels for an object or for all objects of a bundle."""

from __future__ import annotations

import contextlib
import hashlib
import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import platformdirs

import assets_cache
from generator.bundle import load, load_fingerprint
from generator.errors import BundleError, InputError, StorageError, require_number
from generator.io.bounded import parse_object, read_regular
from generator.io.files import remove_tree, write_whole
from generator.jobs.pools import PoolOptions, pool_of
from generator.scene.provenance import versions

from .candidates import GraspCandidate, find_candidates
from .labels import (
    FILE,
    GraspFile,
    GraspLabels,
    GraspTerms,
    decode_labels,
    encode_labels,
    read_file,
    write_file,
)

if TYPE_CHECKING:
    from generator.scene import Object


USUAL = GraspTerms()
"""Default settings of labels."""

_VERSIONS = ("tabletopgen", "mujoco", "numpy", "scipy")
_MAX_KEPT = 2**20  # maximum size of the labels of one object, bytes
_ALONE = PoolOptions()


def sample_grasps(thing: Object, terms: GraspTerms = USUAL) -> GraspLabels:
    """Return the grasp labels of an object of a scene, best first.

    The labels depend only on its shape, mass and friction and on ``terms``, not on its pose.

    Raises:
        SceneError: MuJoCo cannot compile the object.
    """
    rng = np.random.default_rng((terms.seed, 0))
    found = rate_grasps(thing, find_candidates(thing, terms.count, terms.directions, rng), terms)
    order = np.lexsort((np.arange(len(found)), -found.lifted, -found.quality))
    return found.pick(order)


def rate_grasps(
    thing: Object, grasps: Sequence[GraspCandidate], terms: GraspTerms = USUAL
) -> GraspLabels:
    """Return the labels of given grasps of an object, in the same order; see ``sample_grasps``."""
    from .trials import STAGES, GraspBench

    bench = GraspBench(thing)
    passed, widths = np.zeros((len(grasps), terms.trials), int), np.zeros(len(grasps))
    for number, grasp in enumerate(grasps):
        rng = np.random.default_rng((terms.seed, 1, number))
        tried = [bench.try_grasp(grasp, rng) for _ in range(terms.trials)]
        passed[number] = [trial.passed for trial in tried]
        held = [trial.width for trial in tried if trial.passed == len(STAGES)]
        widths[number] = np.median(held) if held else grasp.width
    return GraspLabels(
        np.array([grasp.position for grasp in grasps]).reshape(-1, 3),
        np.array([_quaternion(grasp) for grasp in grasps]).reshape(-1, 4),
        widths,
        np.array([grasp.opening for grasp in grasps]),
        (passed == len(STAGES)).mean(1),
        (passed > STAGES.index("lift")).mean(1),
    )


def _quaternion(grasp: GraspCandidate) -> np.ndarray:
    from scipy.spatial.transform import Rotation

    return Rotation.from_matrix(grasp.rotation).as_quat(canonical=True, scalar_first=True)


def is_labelled(path: Path, terms: GraspTerms = USUAL) -> bool:
    """Return whether a bundle has valid labels with these settings, from any package version."""
    try:
        found = read_file(path)
    except BundleError:
        return False
    return found is not None and found.terms == terms


def label_bundle(
    path: str | Path,
    terms: GraspTerms = USUAL,
    pool: PoolOptions = _ALONE,
    report: Callable[[int, int, str], None] = lambda done, total, name: None,
) -> GraspFile:
    """Label all objects of a bundle, write the labels into it and return them.

    The result does not depend on ``pool``. Finished objects are cached until all are done, so that
    after an interruption the next call with the same settings resumes. ``report`` receives the
    number of finished objects, the total, and the name of the last one.

    Raises:
        InputError: ``pool`` is out of range, or the bundle ships with the package.
        BackendError: Ray is not available.
        BundleError: the bundle cannot be read.
        SceneError: an object cannot be compiled, or a process ended abruptly.
        StorageError: the bundle is not writable.
    """
    require_number("workers", pool.workers, minimum=1, maximum=1024, integer=True)
    folder = Path(path)
    assets_cache.check_own(folder)
    scene, fingerprint = load(folder), load_fingerprint(folder)
    begun = _Begun(fingerprint, terms)
    labels = {o.name: kept for o in scene.objects if (kept := begun.read(o.name)) is not None}
    waiting = [thing for thing in scene.objects if thing.name not in labels]
    report(len(labels), len(scene.objects), "")
    for name, found in _in_turn(waiting, terms, pool):
        labels[name] = found
        begun.write(name, found)
        report(len(labels), len(scene.objects), name)
    if load_fingerprint(folder) != fingerprint:
        raise BundleError(f"{folder} was replaced during labelling. Label it again.")
    made = GraspFile(fingerprint, terms, versions(_VERSIONS), labels)
    write_file(folder, made)
    begun.remove()
    written = read_file(folder)
    if written is None:
        raise StorageError(f"{folder / FILE} was removed while it was being written.")
    return written


def _in_turn(
    things: Sequence[Object], terms: GraspTerms, pool: PoolOptions
) -> Iterator[tuple[str, GraspLabels]]:
    """Yield the name and the labels of each object, in order."""
    jobs = [(thing, terms) for thing in things]
    if len(jobs) < 2 or (pool.workers == 1 and pool.ray is None):
        for thing in things:
            yield thing.name, sample_grasps(thing, terms)
        return
    with closing(pool_of(min(pool.workers, len(jobs)), pool.ray)) as running:
        for thing, found in zip(things, running.map(_label, jobs), strict=True):
            yield thing.name, found


def _label(job: tuple[Object, GraspTerms]) -> GraspLabels:
    return sample_grasps(*job)


class _Begun:
    """A cache of the labels of a bundle's finished objects, kept until all objects are done."""

    def __init__(self, scene: str, terms: GraspTerms) -> None:
        made_with = {"scene": scene, "terms": asdict(terms), "versions": versions(_VERSIONS)}
        text = json.dumps(made_with, sort_keys=True)
        self._root = Path(platformdirs.user_cache_dir("tabletopgen")) / "grasps"
        self._name = hashlib.sha256(text.encode()).hexdigest()[:24]

    def read(self, name: str) -> GraspLabels | None:
        """Return the cached labels of an object, or None if there are no valid ones."""
        with contextlib.suppress(StorageError, ValueError, TypeError, KeyError, InputError):
            what = "The cached labels"
            raw = read_regular(self._file(name), what, StorageError, max_bytes=_MAX_KEPT)
            return decode_labels(parse_object(raw, what, StorageError))
        return None

    def write(self, name: str, labels: GraspLabels) -> None:
        """Cache the labels of an object; errors are ignored, since the cache only saves time."""
        with contextlib.suppress(OSError, StorageError):
            file = self._file(name)
            file.parent.mkdir(parents=True, exist_ok=True)
            text = json.dumps(encode_labels(labels), allow_nan=False)
            write_whole(file, text, "The cached labels", "")

    def remove(self) -> None:
        """Remove all cached labels."""
        with contextlib.suppress(StorageError):
            remove_tree(self._root, self._name)

    def _file(self, name: str) -> Path:
        return self._root / self._name / f"{hashlib.sha256(name.encode()).hexdigest()[:24]}.json"
