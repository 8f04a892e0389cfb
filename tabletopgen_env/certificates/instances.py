"""Sampling of an episode's task instance, preferably a certified one."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from generator.errors import BundleError, InputError, SceneError

from .certificate import FILE, STARTS, Certificate, read_certificate

if TYPE_CHECKING:
    from ..tasks.names import TaskName
    from ..tasks.task import Episode, Task
    from ..world.world import World


def sample_episode(
    task: Task,
    world: World,
    rng: np.random.Generator,
    options: Mapping[str, Any],
    certified: bool,
) -> tuple[Episode, bool]:
    """Draw an episode; return it and whether its task instance is certified.

    If ``certified`` is true and ``options`` contains neither a target nor a goal, one of the
    certified instances of the bundle is drawn uniformly. A bundle without a certificate, or with
    one for other tasks, is sampled freely.

    Raises:
        SceneError: the scene has no valid task, or no certified one.
        InputError: the requested target or goal does not exist.
        BundleError: the certificate is damaged.
    """
    target, goal = options.get("target"), options.get("goal")
    asked = target is not None or goal is not None
    certificate = certificate_of(world) if certified and not asked else None
    name = task.listed_as
    if certificate is None or name is None or name.task not in certificate.terms.tasks:
        return task.sample(world, rng, target, goal), False
    listed = [instance for instance in certificate.instances if instance.name == name]
    if not listed:
        # raises an error with the reason, without using the episode's generator
        task.sample(world, np.random.default_rng(0))
    solved = [instance for instance in listed if instance.certified]
    if not solved:
        raise _nothing_certified(world, name, len(listed), certificate.terms.episodes)
    instance = solved[int(rng.integers(len(solved)))]
    try:
        return task.sample(world, rng, instance.target, instance.goal), True
    except InputError as error:
        raise BundleError(
            f"{world.bundle}: {FILE} lists an impossible instance: {error} Remove it, or "
            "certify the bundle again."
        ) from error


def certificate_of(world: World) -> Certificate | None:
    """Return the certificate of a world's bundle, or None if it has none; the result is cached.

    Raises:
        BundleError: the certificate is damaged.
    """
    if world.bundle is None:
        return None
    if FILE not in world.cached:
        world.cached[FILE] = read_certificate(world.bundle)
    return world.cached[FILE]


def _nothing_certified(world: World, name: TaskName, listed: int, episodes: int) -> SceneError:
    """Return the error for a scene that has valid tasks, none of which is certified."""
    asked = name.task + (f" with the preset {name.preset!r}" if name.preset else "")
    if not listed:
        why = f"the certificate has no instance of {asked}"
    elif episodes < STARTS:
        why = (
            f"the certificate was made with {episodes} episodes per instance, but fewer than "
            f"{STARTS} certify nothing"
        )
    else:
        why = (
            f"of {listed} instances of {asked}, the expert solved none in all of at least "
            f"{STARTS} episodes"
        )
    return SceneError(
        f"Scene {world.scene.name!r} has no certified task: {why}. Use other scenes, or create "
        "the environment with certified=False."
    )
