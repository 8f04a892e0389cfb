"""The embedded reasoner: rules and geometry in place of a multimodal language model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from tabletop_objects import find_category

from ...geometry import mask_box
from ...language.planner import plan_scene
from ...scene import (
    TABLE,
    Instance,
    LayoutBox,
    Mesh,
    Proportions,
    Reference,
    SizePrior,
    Stacking,
    View,
)
from ..protocols import Instances, Sizes
from . import poses
from .eye.proportions import proportion_clues
from .eye.weights import load_proportions, load_weights
from .plane.measure import apparent_scale, sized_extent, usual_solid, whole_box
from .plane.plane import TablePlane
from .segmenter import GENERIC
from .supports import stack
from .survey import Survey, solid_size, survey

_TAU = 0.25  # tolerance of proportions, as in the RMA-Score
_HEIGHT = 0.74
"""The default height of a table in metres."""


@dataclass(frozen=True)
class EmbeddedReasoner:
    """A reasoner that uses rules and the geometry of the table plane instead of a language model.

    The two questions of ``PoseGuesser`` are answered by a naive reading of the picture (see
    ``poses``).
    """

    plan_scene = staticmethod(plan_scene)

    def list_objects(self, reference: Reference) -> tuple[str, ...]:
        """Return the plan's nouns, one per expected object, or "object" if there is no plan."""
        if reference.plan is None:
            return (TABLE, GENERIC)
        return (TABLE, *(thing.noun for thing in reference.plan.objects))

    def estimate_view(self, reference: Reference, table: Instance) -> View:
        """Return the camera estimated from depth or, without depth, from the tabletop's outline."""
        return survey(reference, (table,)).plane.view

    def estimate_sizes(self, reference: Reference, instances: Instances, view: View) -> Sizes:
        """Return catalogue sizes for known words, and measured sizes for others.

        The table's length is chosen so that most known objects get their usual size, within the
        limits of tables. An object's size is measured if depth shows it.
        """
        known = survey(reference, instances)
        plane, solids = known.plane, known.solids
        stacking = stack(instances, _holds, solids)
        things = [instance for instance in instances if instance.name != TABLE]
        priors = {thing.name: _usual_size(reference, thing) for thing in things}
        planned = reference.plan is not None  # the plan states the expected shapes
        unseen = [t for t in things if t.name not in solids and not (planned and priors[t.name])]
        seen = _proportions(reference, instances, unseen, plane)
        sizes: dict[str, SizePrior] = {}
        looks: list[tuple[float, float]] = []
        for thing in things:
            name, prior = thing.name, priors[thing.name]
            if name in solids:
                sizes[name] = solid_size(thing, solids, stacking, prior)
            elif prior is not None:
                sizes[name] = replace(prior, seen=seen.get(name))
                if (category := find_category(thing.label)) is not None:
                    solid = usual_solid(category.key)
                    looks.append(apparent_scale(whole_box(thing), solid, plane))
        metric = planned or reference.depth is not None
        factor = 1.0 if metric else _table_factor(looks)
        for thing in things:
            if thing.name not in sizes:
                look = seen[thing.name]
                extent = sized_extent(whole_box(thing), look.extent, plane)
                sizes[thing.name] = SizePrior(thing.name, extent * factor, seen=look)
        return {
            TABLE: _table_size(reference, known, factor),
            **{thing.name: sizes[thing.name] for thing in things},
        }

    def review_orientation(
        self, mesh: Mesh, instance: Instance, size: SizePrior
    ) -> tuple[tuple[str, int], ...]:
        """Return no rotation, because the embedded modeler builds its meshes upright."""
        return ()

    def stacking_order(
        self, reference: Reference, instances: Instances, view: View
    ) -> Mapping[str, Stacking]:
        """Return the support of each object: from depth, or else from the masks (``supports``)."""
        solids = survey(reference, instances).solids if reference.depth is not None else {}
        return stack(instances, _holds, solids)

    def guess_rotations(
        self, reference: Reference, instances: Instances, sizes: Sizes, view: View
    ) -> Mapping[str, float]:
        """Return the yaw along each mask's long axis, rounded to 15 degrees (see ``poses``)."""
        return poses.guess_rotations(instances, sizes, view)

    def guess_layout(
        self, reference: Reference, instances: Instances, sizes: Sizes, view: View
    ) -> Mapping[str, LayoutBox]:
        """Return positions interpolated in the table's box, and usual sizes (see ``poses``)."""
        return poses.guess_layout(instances, sizes, view)


def _proportions(
    reference: Reference, instances: Instances, asked: Sequence[Instance], plane: TablePlane
) -> dict[str, Proportions]:
    """Return the detector's estimates of the proportions of the objects in ``asked``, by name."""
    masks = [np.asarray(instance.mask) for instance in asked]
    tabletop = np.any([np.asarray(instance.mask) for instance in instances], axis=0).sum()
    clues = proportion_clues(
        load_weights().eye,
        np.ascontiguousarray(reference.image),
        masks,
        [plane.elevation_at(mask_box(mask)) for mask in masks],
        float(tabletop),
    )
    told = load_proportions().tell(clues)
    return {instance.name: one for instance, one in zip(asked, told, strict=True)}


def _holds(label: str) -> bool:
    found = find_category(label)
    return found is not None and found.container


def _usual_size(reference: Reference, instance: Instance) -> SizePrior | None:
    """Return the size given by the prompt or the catalogue, or None for unknown words."""
    planned = reference.plan.objects if reference.plan else ()
    asked = next((p for p in planned if p.noun == instance.label), None)
    found = find_category(asked.category if asked else instance.label)
    state = found.state if found else "as shown"
    if asked is not None and asked.size is not None:
        return SizePrior(instance.name, np.array(asked.size), state)
    return None if found is None else SizePrior(instance.name, np.array(found.size), state)


def _table_factor(looks: list[tuple[float, float]]) -> float:
    """Return the factor by which a usual table is scaled to give known objects their usual size.

    ``looks`` are the results of ``apparent_scale`` on the usual table. The factor is the median,
    weighted by the agreement of the shapes as in Eq. 6. The usual table counts as two objects,
    because its size is better known than that of an object whose name is a guess.
    """
    voices = np.array([*looks, (1.0, 0.0), (1.0, 0.0)])
    voices = voices[np.argsort(-voices[:, 0], kind="stable")]
    weight = np.cumsum(1 / (1 + (voices[:, 1] / _TAU) ** 2))
    middle = int(np.searchsorted(weight, weight[-1] / 2))
    return float(np.clip(1 / voices[middle, 0], 0.5, 2.0))


def _table_size(reference: Reference, known: Survey, factor: float) -> SizePrior:
    plane = known.plane
    extent = np.array([plane.size[0] * factor, plane.size[1] * factor, known.height or _HEIGHT])
    if reference.plan is not None:
        extent = np.array(reference.plan.table.size)
    outline = plane.top() * (extent[:2] / plane.size)
    return SizePrior(TABLE, extent, outline=outline)
