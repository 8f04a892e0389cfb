"""Certificates: what the scripted expert has been seen to do at a table.

For each *instance* (a task, its target and goal) that a bundle's scene offers, up to a bound, the
expert plays some episodes from perturbed starts: the arm's joints are off by up to 0.06 rad, things
that stand free by up to 3 mm and 3 degrees. ``certificate.json``, beside the bundle's own files,
keeps how many it solved, with the digest of the scene, the seed and the versions it was made with.
Bundles do not list it, so that they stay what they were.

A success is ``info["success"]`` held for ``episodes.HOLD`` steps within the time limit of the
task's id.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from generator.bundle import load
from generator.errors import InputError, SceneError, choices, require_number
from generator.geometry import inside_margin, quaternion_matrix, yaw_quaternion

from .certificate import (
    MOST_EPISODES,
    MOST_INSTANCES,
    Certificate,
    Instance,
    Point,
    scene_digest,
    write_certificate,
)
from .certificate import certified_instances as certified_instances
from .episodes import Held
from .tasks import NAMES

if TYPE_CHECKING:
    from .env import TabletopEnv
    from .tasks.task import Episode
    from .world import World

JOINT_JITTER = 0.06
"""How far the arm's joints are off at the start, radians."""

SHIFT, TURN = 0.003, float(np.deg2rad(3.0))
"""How far things that stand free are off at the start, metres and radians."""

_DRAWS = 40
_VERSIONS = ("tabletopgen", "mujoco", "numpy")


def certify(
    path: str | Path,
    tasks: Sequence[str] = NAMES,
    episodes: int = 10,
    workers: int = 1,
    seed: int = 0,
    most: int = 8,
) -> Certificate:
    """Let the expert play what a bundle's scene offers, write the certificate and return it.

    Args:
        path: the bundle.
        tasks: names of tasks.
        episodes: how many of each instance.
        workers: processes.
        seed: the same seed gives the same certificate.
        most: how many instances of each task at most.

    Raises:
        InputError: an unknown task, or a number out of range.
        BundleError: the bundle cannot be read.
        StorageError: the certificate cannot be written.
    """
    _check(tasks, episodes, workers, most)
    folder = Path(path)
    load(folder)  # damaged bundles are not certified
    found = [i for task in tasks for i in offered(folder, task, seed, most)]
    jobs = [(folder, instance, episodes, (seed, k)) for k, instance in enumerate(found)]
    if workers > 1 and len(jobs) > 1:
        with ProcessPoolExecutor(workers) as pool:
            seen = list(pool.map(_played, jobs))
    else:
        seen = [_played(job) for job in jobs]
    versions = {name: metadata.version(name) for name in _VERSIONS}
    certificate = Certificate(scene_digest(folder), seed, versions, tuple(seen))
    write_certificate(folder, certificate)
    return certificate


# ------------------------------------------------------------------------------------- instances


def offered(folder: Path, task: str, seed: int, most: int) -> tuple[Instance, ...]:
    """Return up to ``most`` different instances of a task that its sampling draws at a table."""
    env = _env(folder, task)
    found: dict[tuple[Any, ...], Instance] = {}
    try:
        for k in range(_DRAWS):
            try:
                env.reset(seed=_seed(seed, k))
            except SceneError:
                break
            instance = _instance(task, env.episode)
            kind = (instance.target, _kind(instance.goal))
            if kind not in found and len(found) < most:
                found[kind] = instance
    finally:
        env.close()
    return tuple(found.values())


def _kind(goal: str | Point | None) -> Any:
    """Return what tells goals apart: points of the table are all alike, but 20 cm apart."""
    return goal if goal is None or isinstance(goal, str) else tuple(round(v / 0.2) for v in goal)


def _instance(task: str, episode: Episode) -> Instance:
    """Return the instance that an episode plays."""
    first = episode.goals[0]
    if task == "Sequence":
        return Instance(task, None, None)
    if task == "Tidy":
        return Instance(task, None, first.reference)
    if task == "Swap":  # its goals: the second aside, the first there, the second here
        return Instance(task, episode.goals[1].target, first.target)
    if first.reference is not None:
        return Instance(task, first.target, first.reference)
    if first.spot is None:
        return Instance(task, first.target, None)
    point = first.spot if task == "Reach" else first.spot[:2]
    return Instance(task, first.target, tuple(round(float(v), 4) for v in point))


# --------------------------------------------------------------------------------------- playing


def _played(job: tuple[Path, Instance, int, tuple[int, int]]) -> Instance:
    """Return an instance with how often the expert solved it."""
    folder, instance, episodes, seeds = job
    env = _env(folder, instance.task)
    rng = np.random.default_rng(seeds)
    try:
        solved = sum(_solved(env, instance, rng) for _ in range(episodes))
    finally:
        env.close()
    return replace(instance, successes=solved, episodes=episodes)


def _solved(env: TabletopEnv, instance: Instance, rng: np.random.Generator) -> bool:
    """Play one episode from a perturbed start; return whether it was a success."""
    from .expert.run import TaskExpert

    try:
        env.reset(seed=int(rng.integers(2**31)), options=instance.options)
        perturb(env, rng)
        expert = TaskExpert(env)
        expert.reset()
    except SceneError:
        return False
    held = Held()
    return any(held.after(env.step(expert.act())[4]) for _ in range(_limit(instance.task)))


def perturb(env: TabletopEnv, rng: np.random.Generator) -> None:
    """Put the arm and the things that stand free a little off, after ``reset``."""
    import mujoco

    world = env.world
    joints = world.arm_qpos
    world.data.qpos[joints] += rng.uniform(-JOINT_JITTER, JOINT_JITTER, len(joints))
    world.data.ctrl[world.actuators[:7]] = world.data.qpos[joints]
    for name in _standing_free(world):
        obj = world.scene.object(name)
        shift = np.array([*rng.uniform(-SHIFT, SHIFT, 2), 0.0])
        turned = np.empty(4)
        spin = yaw_quaternion(float(rng.uniform(-TURN, TURN)))
        mujoco.mju_mulQuat(turned, spin, np.asarray(obj.pose.quaternion, float))
        world.teleport(name, obj.pose.position + shift, turned)
    mujoco.mj_forward(world.model, world.data)
    env.controller.reset(world)


def _standing_free(world: World) -> Iterator[str]:
    """Yield the things on the table itself that carry nothing and touch nothing else."""
    loaded = {o.placement.on for o in world.scene.objects}
    for obj in world.scene.objects:
        level = quaternion_matrix(obj.pose.quaternion)[2]
        if obj.placement.on != "table" or obj.name in loaded or np.abs(level).max() < 0.999:
            continue
        own = world.footprints[obj.name]
        radius = float(np.linalg.norm(own - obj.pose.position[:2], axis=1).max())
        room = 2 * (SHIFT + TURN * radius)
        edge = inside_margin(own, world.scene.table.outline).min() > room
        others = (world.footprints[o] for o in world.names if o != obj.name)
        if edge and all(
            inside_margin(own, other).max() < -room
            and inside_margin(np.asarray(other), own).max() < -room
            for other in others
        ):
            yield obj.name


def _env(folder: Path, task: str) -> TabletopEnv:
    from .env import make_env

    return make_env(folder, task=task, certified=False)


def _limit(task: str) -> int:
    import gymnasium

    limit = gymnasium.spec(f"TabletopGen/{task}-v0").max_episode_steps
    assert limit is not None
    return limit


def _seed(seed: int, number: int) -> int:
    return int(np.random.default_rng((seed, number)).integers(2**31))


def _check(tasks: Sequence[str], episodes: int, workers: int, most: int) -> None:
    for task in tasks:
        if task not in NAMES:
            raise InputError(f"Unknown task {task!r}." + choices(str(task), NAMES))
    for name, value, limit in (
        ("episodes", episodes, MOST_EPISODES),
        ("workers", workers, 1024),
        ("most", most, MOST_INSTANCES // len(NAMES)),
    ):
        require_number(f"certify needs {name}", value, least=1, most=limit, whole=True)
