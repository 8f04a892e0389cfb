"""Certification of bundles: which tasks the scripted expert solves on a bundle's table.

For each *instance* (a task, its preset, target and goal) of a bundle's scene, up to a maximum, the
expert plays one episode from the scene's own state, as environments do by default, and the others
from perturbed initial states (``randomization="starts"``). Instances of which it solves all of at
least ``STARTS`` episodes are certified; after a failure, no more episodes of the instance are
played. ``certificate.json`` stores the numbers of successes, with the digest of the scene, the
terms and the package versions.

A success is ``info["success"]`` held for ``episodes.HOLD`` steps within the registered time limit
of the task.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import closing
from dataclasses import replace
from itertools import chain, repeat
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from generator.errors import BundleError, SceneError, TabletopError, require_number
from generator.jobs.pools import pool_of
from generator.scene.provenance import versions

from ..episodes import Held
from ..goals.goal import SPOT
from ..robot.panda import Panda
from ..scenes.fixed import bundle_ref
from ..tasks.names import NAMES, TaskName
from ..tasks.registry import task_named
from ..world.worlds import Masters
from .certificate import (
    Certificate,
    TaskInstance,
    Terms,
    read_certificate,
    scene_digest,
    write_certificate,
)

if TYPE_CHECKING:
    from ..env import TabletopEnv
    from ..tasks.task import Episode, Task
    from ..world.world import World

DEFAULT = Terms()
"""The terms of the shipped certificates."""

STARTING = "starts"
"""The perturbation of initial states: see ``randomization``."""

VERSIONS = ("tabletopgen", "mujoco", "numpy")
"""The packages whose versions a certificate records."""

_DRAWS = 40
_FAILURES = 8  # consecutive draws without a new instance after which the search ends


def certify(
    path: str | Path, terms: Terms = DEFAULT, workers: int = 1, ray: str | None = None
) -> Certificate:
    """Run the expert on the instances of a bundle's scene; write and return the certificate.

    The number of processes, ``workers``, does not change the certificate. If ``ray`` is the address
    of a Ray cluster, the processes run there; all its machines must have access to the bundle, and
    this machine writes the certificate.

    Raises:
        InputError: ``workers`` is out of range.
        BackendError: Ray is not available.
        BundleError: the bundle cannot be read.
        StorageError: the certificate cannot be written.
        SceneError: a process ended unexpectedly.
    """
    [(_, made)] = certify_all([Path(path)], terms, workers, ray)
    if isinstance(made, TabletopError):
        raise made
    return made


def certify_all(
    paths: Sequence[Path], terms: Terms = DEFAULT, workers: int = 1, ray: str | None = None
) -> Iterator[tuple[Path, Certificate | TabletopError]]:
    """Certify bundles as ``certify`` does; yield each bundle with its certificate or the error.

    A bundle that cannot be certified is yielded with its error. If interrupted, it keeps the
    certificates already written.

    Raises:
        InputError: ``workers`` is out of range.
        BackendError: Ray is not available.
        SceneError: a process ended unexpectedly.
    """
    require_number("workers", workers, minimum=1, maximum=1024, integer=True)
    jobs = [(path, task, terms) for path in paths for task in terms.tasks]
    listed = iter(_in_turn(jobs, workers, ray))
    for path in paths:
        yield path, _write(path, terms, [next(listed) for _ in terms.tasks])


def _write(path: Path, terms: Terms, listed: Sequence[_Listed]) -> Certificate | TabletopError:
    """Write a bundle's certificate from the results of its jobs; return it, or the error."""
    instances: list[TaskInstance] = []
    for found in listed:
        if isinstance(found, TabletopError):
            return found
        instances += found
    try:
        made = Certificate(scene_digest(path), terms, versions(VERSIONS), tuple(instances))
        write_certificate(path, made)
        return made
    except TabletopError as error:
        return error


def is_certified(path: Path, terms: Terms = DEFAULT) -> bool:
    """Return whether a bundle has a valid certificate for these terms, from any package version."""
    try:
        found = read_certificate(path)
    except BundleError:
        return False
    return found is not None and found.terms == terms


_Job = tuple[Path, str, Terms]
_Listed = tuple[TaskInstance, ...] | TabletopError


def _in_turn(jobs: Sequence[_Job], workers: int, ray: str | None) -> Iterator[_Listed]:
    """Run the jobs, in separate processes if requested, and yield their results in order."""
    if len(jobs) < 2 or (workers == 1 and ray is None):
        yield from map(_play, jobs)
        return
    with closing(pool_of(min(workers, len(jobs)), ray)) as pool:
        yield from pool.map(_play, jobs)


# ------------------------------------------------------------------------------------- instances


def names(task: str) -> tuple[TaskName, ...]:
    """Return a task's name, followed by the names of its presets."""
    from ..tasks.sequence import PRESETS

    presets = PRESETS if task == "Sequence" else ()
    return (TaskName(task), *(TaskName(task, preset) for preset in presets))


def find_instances(world: World, task: Task, seed: int, maximum: int) -> tuple[TaskInstance, ...]:
    """Return up to ``maximum`` distinct instances of a task, sampled on a table."""
    found: dict[tuple[Any, ...], TaskInstance] = {}
    failures = 0
    for number in range(_DRAWS):
        world.reset()
        try:
            drawn = task.sample(world, np.random.default_rng((seed, number)))
        except SceneError:
            failures += 1
            if failures == _FAILURES:
                break
            continue
        failures = 0
        instance = instance_of(task, drawn)
        found.setdefault((instance.target, instance.goal), instance)
        if len(found) == maximum or not instance.options:  # as drawn, if there are no others
            break
    return tuple(found.values())


def instance_of(task: Task, episode: Episode) -> TaskInstance:
    """Return the task instance of an episode; ``task`` must be a task of this package."""
    assert task.listed_as is not None
    name, preset = task.listed_as
    first = episode.goals[0]
    if name == "Sequence":
        return TaskInstance(name, None, None, preset=preset)
    if name == "Tidy":
        return TaskInstance(name, None, first.reference)
    # the goals: move the second object aside, the first there, the second to the first's place
    if name == "Swap":
        return TaskInstance(name, episode.goals[1].target, first.target)
    if first.reference is not None:
        return TaskInstance(name, first.target, first.reference)
    drawn = None if first.spot is None or name == "Reach" else SPOT
    return TaskInstance(name, first.target, drawn)


# --------------------------------------------------------------------------------------- playing


def _play(job: _Job) -> _Listed:
    """Return the result of ``_instances`` for a job, or the error that occurred."""
    try:
        return _instances(*job)
    except TabletopError as error:
        return error


def _instances(folder: Path, task: str, terms: Terms) -> tuple[TaskInstance, ...]:
    """Return the instances of a task on a table, with the expert's results."""
    masters = Masters(Panda(), 1)
    world = masters.twin(bundle_ref(folder))
    found: list[TaskInstance] = []
    for name in names(task):
        instances = find_instances(world, task_named(*name), terms.seed, terms.most)
        if not instances:
            continue
        with (
            closing(environment_of(folder, name, masters, None)) as own,
            closing(environment_of(folder, name, masters, STARTING)) as perturbed,
        ):
            for instance in instances:
                rng = np.random.default_rng((terms.seed, NAMES.index(task), len(found)))
                starts = chain([own], repeat(perturbed, terms.episodes - 1))
                found.append(_try(starts, instance, rng))
    return tuple(found)


def played_again(
    folder: Path, instances: Sequence[TaskInstance], episodes: int, seed: int
) -> Iterator[TaskInstance]:
    """Yield each instance of a bundle with the expert's results on ``episodes`` new episodes.

    All episodes start from perturbed states and are played despite failures. ``seed`` draws them;
    use a different seed from the certificate's to get other initial states.

    Raises:
        BundleError: the bundle cannot be read.
    """
    masters = Masters(Panda(), 1)
    for number, instance in enumerate(instances):
        rng = np.random.default_rng((seed, len(NAMES), number))
        with closing(environment_of(folder, instance.name, masters, STARTING)) as env:
            solved = sum(has_solved(env, instance, rng) for _ in range(episodes))
        yield replace(instance, successes=solved, episodes=episodes)


def _try(
    starts: Iterable[TabletopEnv], instance: TaskInstance, rng: np.random.Generator
) -> TaskInstance:
    """Play an instance once in each environment of ``starts`` until the expert fails."""
    solved = played = 0
    for env in starts:
        played += 1
        if not has_solved(env, instance, rng):
            break
        solved += 1
    return replace(instance, successes=solved, episodes=played)


def has_solved(env: TabletopEnv, instance: TaskInstance, rng: np.random.Generator) -> bool:
    """Play one episode; return whether the expert solved it."""
    import gymnasium

    from ..expert.run import TaskExpert

    limit = gymnasium.spec(f"TabletopGen/{instance.task}-v0").max_episode_steps
    assert limit is not None
    try:
        env.reset(seed=int(rng.integers(2**31)), options=instance.options)
        expert = TaskExpert(env)
        expert.reset()
    except SceneError:
        return False
    held = Held()
    return any(held.after(env.step(expert.act())[4]) for _ in range(limit))


def environment_of(
    folder: Path, name: TaskName, masters: Masters, randomization: str | None
) -> TabletopEnv:
    """Return an environment for all instances of a task on a bundle's table."""
    from ..env import make_env

    task, preset = name
    return make_env(
        folder, task=task, preset=preset, certified=False, masters=masters,
        randomization=randomization,
    )  # fmt: skip
