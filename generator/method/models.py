"""Canonical model generation (Sec. 3.2): image to 3D, then canonical coordinate alignment."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping

import numpy as np
from jaxtyping import Float

from ..backends.protocols import Each, Modeler, Reasoner, in_turn
from ..errors import BackendError, choices
from ..geometry import ray_view
from ..scene import Instance, Model, Reference, SizePrior, View
from ..scene.quarter_turns import turn

SQUARISH = 1.15
"""Ratio of the longer to the shorter side below which length and width are not distinguished."""

STRETCH = 1.8
"""Maximum factor by which a measured size may change a model's proportions."""


def make_models(
    reference: Reference,
    instances: tuple[Instance, ...],
    sizes: Mapping[str, SizePrior],
    view: View,
    modeler: Modeler,
    reasoner: Reasoner,
    *,
    model_each: Each = in_turn,
    review_each: Each = in_turn,
) -> dict[str, Model]:
    """Return a canonical model m_i for every instance, by name.

    The modeler receives each instance with the view along the ray through the centre of its box.
    The raw models m'_i are then turned upright as the reasoner says (Fig. 23). ``model_each`` and
    ``review_each`` run the queries to the modeler and to the reasoner for all instances.

    Raises:
        BackendError: an instance has no size.
    """
    height, width = reference.image.shape[:2]
    for instance in instances:
        if instance.name not in sizes:
            raise BackendError(
                f"The reasoner returned no size for {instance.name!r}."
                + choices(instance.name, sizes)
            )

    def model(instance: Instance) -> Model:
        own = ray_view(view, (instance.box[:2] + instance.box[2:]) / 2, width, height)
        return modeler.model(instance, sizes[instance.name], own)

    def review(pair: tuple[Instance, Model]) -> Model:
        instance, raw = pair
        return align_canonically(raw, instance, sizes[instance.name], reasoner)

    raw = model_each(model, instances)
    models = review_each(review, list(zip(instances, raw, strict=True)))
    return dict(zip((i.name for i in instances), models, strict=True))


def align_canonically(raw: Model, instance: Instance, size: SizePrior, reasoner: Reasoner) -> Model:
    """Rotate a model so that +z is up and x and y match the size's length and width (Sec. 3.2).

    The reasoner receives the mesh in the model's own proportions, since the canonical mesh fills a
    cube.
    """
    extent = np.asarray(raw.size, np.float32)
    shown = dataclasses.replace(raw.mesh, vertices=raw.mesh.vertices * extent)
    model = turn(raw, reasoner.review_orientation(shown, instance, size))
    model = turn(model, size_axes_turn(model.size, size.extent))
    if size.measured:
        model = dataclasses.replace(model, size=measured_size(model, size.extent))
    return dataclasses.replace(model, name=instance.name, label=instance.label)


def measured_size(model: Model, extent: Float[np.ndarray, "3"]) -> Float[np.ndarray, "3"]:
    """Return a model's size (metres), corrected by the measured ``extent`` (length, width, height).

    The longer horizontal side is the length. A proportion that would change by more than
    ``STRETCH`` is changed by only that factor, since the picture or the measurement is probably
    wrong. If a catalogue shape appears square in the measured view but is not, its longer side,
    such as a mug's handle, is along the line of sight. That side then keeps its ratio to the other.
    """
    have = np.asarray(model.size)
    long = int(have[1] > have[0])
    sides = np.sort(extent[:2])
    want = np.array([*(sides if long else sides[::-1]), extent[2]])
    ratio = have[long] / have[1 - long]
    if model.category != "generic" and sides[1] < SQUARISH * sides[0] and ratio > SQUARISH:
        want[long] = sides[0] * ratio
    stretch = np.log(want / have)
    usual = float(np.median(stretch))
    return have * np.exp(np.clip(stretch, usual - np.log(STRETCH), usual + np.log(STRETCH)))


def size_axes_turn(
    have: Float[np.ndarray, "3"], want: Float[np.ndarray, "3"]
) -> tuple[tuple[str, int], ...]:
    """Return the quarter turn about z that aligns the longer horizontal sides, or () if aligned."""
    own, asked = np.log(have[0] / have[1]), np.log(want[0] / want[1])
    clear = min(abs(own), abs(asked)) > np.log(SQUARISH)
    return (("z", 90),) if clear and own * asked < 0 else ()
