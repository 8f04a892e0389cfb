"""Which instance of its task an episode plays: one that is certified, where that is known."""

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
    """Draw an episode; return it and whether it plays a certified instance.

    Without a target or goal in ``options``, and if ``certified``, it is one that the bundle's
    certificate says the expert solves, all equally likely. A bundle without a certificate, or whose
    certificate was made for other tasks, is sampled freely.

    Raises:
        SceneError: the scene offers nothing to do, or nothing that is certified.
        InputError: what the options ask for does not exist.
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
        task.sample(world, np.random.default_rng(0))  # says why, without a draw of the episode's
    solved = [instance for instance in listed if instance.certified]
    if not solved:
        raise _nothing_certified(world, name, len(listed), certificate.terms.episodes)
    instance = solved[int(rng.integers(len(solved)))]
    try:
        return task.sample(world, rng, instance.target, instance.goal), True
    except InputError as error:
        raise BundleError(
            f"{world.bundle}: {FILE} lists what cannot be done there: {error} Remove it, or "
            "certify the bundle again."
        ) from error


def certificate_of(world: World) -> Certificate | None:
    """Return what the expert has been seen to do here, if the bundle has a certificate; read once.

    Raises:
        BundleError: it is damaged.
    """
    if world.bundle is None:
        return None
    if FILE not in world.cached:
        world.cached[FILE] = read_certificate(world.bundle)
    return world.cached[FILE]


def _nothing_certified(world: World, name: TaskName, listed: int, episodes: int) -> SceneError:
    """Return the error of a scene with something to do, but not for the expert."""
    asked = name.task + (f" with the preset {name.preset!r}" if name.preset else "")
    if not listed:
        why = f"its certificate lists nothing of {asked}"
    elif episodes < STARTS:
        why = (
            f"its certificate was made with {episodes} episodes an instance, and fewer than "
            f"{STARTS} certify nothing"
        )
    else:
        why = (
            f"of {listed} instances of {asked} the expert solved none from each of at least "
            f"{STARTS} starts"
        )
    return SceneError(
        f"Scene {world.scene.name!r} offers nothing certified: {why}. Use other scenes, or make "
        "the environment with certified=False."
    )
