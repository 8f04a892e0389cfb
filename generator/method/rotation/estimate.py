"""Estimation of the rotation of each instance in a picture."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from jaxtyping import Bool

from ...backends.protocols import Encoder
from ...errors import InputError, choices
from ...render.crop import hiders
from ...scene import TABLE, Instance, Model, Reference, Rotation, View
from ...threads import single_thread, threads
from .config import RotationConfig
from .objective import make_objectives
from .prior import prior_yaw
from .results import RotationAnswer
from .search import search


def estimate_rotations(
    reference: Reference,
    instances: tuple[Instance, ...],
    models: Mapping[str, Model],
    view: View,
    encoder: Encoder,
    config: RotationConfig | None = None,
    seed: int = 0,
) -> dict[str, Rotation]:
    """Estimate the yaw r_i of every instance except the table, whose yaw is 0 by definition.

    A model's own orientation, if it has one, decides between yaws that the picture cannot
    distinguish (``prior``). On CUDA all instances form one batch; on a CPU each is searched in its
    own thread.

    Raises:
        InputError: an instance has no model or no visible pixels.
    """
    config = config or RotationConfig()
    height, width = reference.image.shape[:2]
    things = [i for i in instances if i.name != TABLE]
    for instance in things:
        if instance.name not in models:
            raise InputError(f"Instance {instance.name!r} has no model. Create the models first.")
    hidden = [hiders(instance, things) for instance in things]

    def search_group(group: Sequence[int]) -> list[RotationAnswer]:
        levels = make_objectives(
            [models[things[k].name] for k in group],
            [things[k] for k in group],
            view, encoder, config, (width, height), seed,
            [hidden[k] for k in group],
        )  # fmt: skip
        return search(levels, [prior_yaw(models[things[k].name]) for k in group])

    with single_thread():
        if config.device == "cpu":
            with ThreadPoolExecutor(min(threads(), max(len(things), 1))) as pool:
                found = [
                    rows[0] for rows in pool.map(search_group, [[k] for k in range(len(things))])
                ]
        else:
            found = search_group(range(len(things))) if things else []
    return {t.name: _rotation(t.name, rows) for t, rows in zip(things, found, strict=True)}


def estimate_rotation(
    reference: Reference,
    instances: tuple[Instance, ...],
    name: str,
    model: Model,
    view: View,
    encoder: Encoder,
    config: RotationConfig,
    seed: int = 0,
) -> Rotation:
    """Estimate the yaw r_i of one instance that has a model; see ``estimate_rotations``.

    Raises:
        InputError: there is no such instance, or it has no visible pixels.
    """
    height, width = reference.image.shape[:2]
    things = [i for i in instances if i.name != TABLE]
    instance = next((i for i in things if i.name == name), None)
    if instance is None:
        raise InputError(
            f"No instance is named {name!r}." + choices(name, (i.name for i in things))
        )
    return optimise_rotation(
        model, instance, view, encoder, config, (width, height), seed, hiders(instance, things)
    )


def optimise_rotation(
    model: Model,
    instance: Instance,
    view: View,
    encoder: Encoder,
    config: RotationConfig,
    image_size: tuple[int, int],
    seed: int = 0,
    hidden: Bool[np.ndarray, "h w"] | None = None,
) -> Rotation:
    """Estimate one object's yaw by a coarse search and gradient descent from the best candidates.

    Returns the best yaw in [-pi, pi) with its loss, and all refined (yaw, loss) pairs, best first.
    ``model.size`` gives the proportions; ``model.orientation``, if set, is an additional start, and
    decides if the picture is ambiguous. The crop's alpha is S; ``encoder`` computes Phi;
    ``image_size`` is (width, height) of the reference image, pixels; ``seed`` is the seed of the
    surface samples; ``hidden`` marks the pixels where the object may be occluded.

    Raises:
        InputError: the crop is empty or the model has no surface.
    """
    with single_thread():
        levels = make_objectives(
            [model], [instance], view, encoder, config, image_size, seed, [hidden]
        )
        (found,) = search(levels, [prior_yaw(model)])
    return _rotation(instance.name, found)


def _rotation(name: str, answer: RotationAnswer) -> Rotation:
    candidates = tuple((found.yaw, found.loss) for found in answer.looks[0])
    return Rotation(
        name, *candidates[0], candidates,
        answer.margin, answer.width, answer.symmetric, answer.order,
    )  # fmt: skip
