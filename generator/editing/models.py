"""The model of an object that an edit requests: from the catalogue, or drawn and modelled (Fig. 7).

Without backends, objects come from the catalogue, as in composed scenes. With backends, the object
is made as in the paper: it is drawn by itself, cut out, modelled and turned upright, and its yaw in
the drawing is estimated.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from tabletop_objects import CATEGORIES
from tabletop_objects.kit.styles import STYLES

from ..backends import Backends
from ..errors import InputError, choices
from ..generation import Config
from ..layout import build_models, natural_yaw
from ..method.extraction import extract
from ..method.models import make_models
from ..method.rotation import estimate_rotations
from ..scene import TABLE, Instance, Model, PlannedObject, PlannedTable, Reference, Scene, ScenePlan

EASEL = PlannedTable(size=(0.5, 0.4, 0.74))
"""Table for drawing a new object: so small that the object appears large."""


@dataclass(frozen=True, eq=False)
class MadeModel:
    """A new model at its usual size, and the yaw (radians) that turns its front to the viewer."""

    model: Model
    yaw: float


def make(
    planned: PlannedObject,
    style: str,
    supports: Sequence[PlannedObject],
    backends: Backends | None,
    config: Config,
    seed: int,
) -> MadeModel:
    """Make the model of a planned object; ``supports`` are the targets of its relations.

    Raises:
        InputError: The catalogue has no such object.
        BackendError: A backend failed.
        SceneError: The object is not visible in its drawing.
    """
    if backends is not None:
        return _draw(planned, style, backends, config, seed)
    plan = ScenePlan(planned.noun, PlannedTable(), (planned, *supports), style)
    check_known(planned)
    model = build_models(plan, seed)[planned.name]
    rng = np.random.default_rng([int(seed) & 0xFFFFFFFF, 23])
    return MadeModel(model, natural_yaw(planned, model, plan, rng))


def check_known(planned: PlannedObject) -> None:
    """Check that the catalogue contains the object.

    Raises:
        InputError: It does not.
    """
    if planned.category not in CATEGORIES:
        nouns = {c.noun for c in CATEGORIES.values()}
        near = choices(planned.noun, nouns).split(" Available:")[0]
        raise InputError(
            f"The catalogue has no {planned.noun!r}.{near} It has {len(nouns)} kinds of objects; "
            "to make others, use backends for the imager and the modeler."
        )


def check_style(style: str) -> None:
    """Check that the catalogue has the style.

    Raises:
        InputError: It does not.
    """
    if style not in ("plain", *STYLES):
        raise InputError(f"Unknown style {style!r}." + choices(style, ("plain", *STYLES)))


def remodel(
    scene: Scene,
    planned: PlannedObject,
    style: str,
    backends: Backends | None,
    config: Config,
    seed: int,
) -> Model:
    """Remake the model of a scene's object in another style, at the same size.

    Objects of a composed scene keep their other attributes.

    Raises:
        InputError, BackendError, SceneError: As for ``make``.
    """
    thing = scene.object(planned.name)
    model = _same_look(scene, planned, style) if backends is None else None
    model = model or make(planned, style, (), backends, config, seed).model
    factor = float(thing.scale.max() / model.size.max())
    return replace(model, size=model.size * factor, label=thing.label)


def _same_look(scene: Scene, planned: PlannedObject, style: str) -> Model | None:
    """Return the restyled model, or None if plan and seed do not reproduce the current model."""
    plan, seed = scene.plan, scene.provenance.seed
    if plan is None or scene.provenance.kind != "compose":
        return None
    if planned.name not in {o.name for o in plan.objects}:
        return None
    before, now = build_models(plan, seed)[planned.name], scene.object(planned.name).model
    other = before.mesh.vertices.shape != now.mesh.vertices.shape
    if other or not np.allclose(before.size, now.size, atol=1e-4):
        return None
    return build_models(replace(plan, style=style), seed)[planned.name]


def _draw(
    planned: PlannedObject, style: str, backends: Backends, config: Config, seed: int
) -> MadeModel:
    """Draw an object alone on a small table and reconstruct its model (Secs. 3 to 3.3)."""
    b = backends
    alone = replace(planned, relations=())
    plan = ScenePlan(_phrase(alone, style), EASEL, (alone,), style)
    reference = Reference(b.imager.draw(plan, seed), plan.prompt, plan)
    reference, found = extract(
        reference, b.reasoner, b.segmenter, b.imager, seed, config.extraction,
        complete_each=b.each("imager"),
    )  # fmt: skip
    table, instance = found[0], _pick(found[1:], planned)
    view = b.reasoner.estimate_view(reference, table)
    sizes = b.reasoner.estimate_sizes(reference, found, view)
    models = make_models(reference, (instance,), sizes, view, b.modeler, b.reasoner)
    turns = estimate_rotations(
        reference, (instance,), models, view, b.encoder, config.rotation, seed
    )
    model = replace(models[instance.name], name=planned.name, label=planned.noun)
    return MadeModel(model, turns[instance.name].yaw)


def _pick(found: Sequence[Instance], planned: PlannedObject) -> Instance:
    """Return the largest instance with the object's noun, or the largest of all if none has it."""
    named = [i for i in found if i.label == planned.noun and i.name != TABLE]
    return max(named or found, key=lambda i: int(i.mask.sum()))


def _phrase(planned: PlannedObject, style: str) -> str:
    words = [*planned.attributes.values(), planned.noun]
    return "a " + " ".join(words) + (f" in {style} style" if style != "plain" else "")
