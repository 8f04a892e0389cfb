"""The models a plan needs, and a table large enough for them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from jaxtyping import Float

from .. import catalogue
from ..catalogue.build.collision import resting_ball
from ..catalogue.build.styles import STYLES
from ..catalogue.stand_ins import build_stand_in
from ..errors import SceneError
from ..geometry import convex_outline
from ..scene import ConvexPart, Density, Model, PlannedObject, PlannedTable, ScenePlan
from .footprint import footprint
from .postures import pose, stand_up

_FILLING: Mapping[Density, float] = {"sparse": 0.25, "normal": 0.42, "dense": 0.62}
"""Share of a tabletop that objects and the room around them may take."""

_LARGEST = 1.5  # how much longer than planned a table may become
_ROOM = 0.035  # metres of free space counted around each object


def build_models(plan: ScenePlan, seed: int) -> dict[str, Model]:
    """Build a catalogue model for every planned object, each by its own seed.

    The plan's style decides how they are drawn, if it is one of the catalogue's.

    Equal planned things ("two red mugs") look alike, since they share the seed. A long thin thing
    that goes into a vessel stands upright, as a pencil does in a mug, unless the vessel is as wide
    as it is long, and so does an egg in the place that a carton has for it.
    """
    models: dict[str, Model] = {}
    seeds: dict[tuple[str, str, str], int] = {}
    holding = {r.target for o in plan.objects for r in o.relations if r.kind == "in"}
    for planned in plan.objects:
        kind = (planned.category, planned.noun, str(sorted(planned.attributes.items())))
        number = seeds.setdefault(kind, len(seeds))
        if planned.category == "vase" and planned.name in holding:  # without flowers of its own
            planned = replace(planned, attributes={"state": "empty", **planned.attributes})
        built = _build(planned, plan.style, seed * 1009 + number)
        models[planned.name] = pose(built, planned.attributes.get("posture", ""))
    by_name = {o.name: o for o in plan.objects}
    for planned in plan.objects:
        for relation in planned.relations:
            if relation.kind == "in" and relation.target in by_name:
                own = models[planned.name]
                fitted = "places" in by_name[relation.target].attributes
                mouth = float(models[relation.target].size[:2].min())
                if not fitted and own.size[0] < mouth / _LIES:
                    continue
                model = stand_up(own, 1.0 if fitted else 3.0)
                models[planned.name] = replace(model, parts=_FITTED) if fitted else model
    return models


def find_fitted(plan: ScenePlan) -> set[str]:
    """Return the things made for each other, as a carton with places and the eggs in them."""
    vessels = {o.name for o in plan.objects if "places" in o.attributes}
    contents = {
        o.name for o in plan.objects
        if any(r.kind == "in" and r.target in vessels for r in o.relations)
    }  # fmt: skip
    return vessels | contents


_LIES = 0.9  # share of its length that a vessel's mouth has where a long thing lies in it

_FITTED = (ConvexPart(resting_ball(1.0, 1.0, 1.0).vertices - [0.0, 0.0, 0.5]),)
"""Collision shape of a round thing that stands in its place, in the canonical frame."""


def _build(planned: PlannedObject, style: str, seed: int) -> Model:
    if planned.category == "generic":
        return build_stand_in(planned.family, planned.noun, seed, planned.attributes, planned.size)
    drawn = {"style": style} if style in STYLES else {}
    model = catalogue.build(planned.category, seed, attributes={**drawn, **planned.attributes})
    if planned.size is not None:
        factor = max(planned.size) / float(model.size.max())
        model = replace(model, size=model.size * factor)
    return replace(model, label=planned.noun)


def table_size(plan: ScenePlan, models: Mapping[str, Model], growth: float = 1.0) -> PlannedTable:
    """Return the planned table, enlarged if the objects would crowd it.

    ``growth`` (at least 1) enlarges it further, for another try.

    Raises:
        SceneError: even the largest plausible table would be too small.
    """
    standing = [o for o in plan.objects if not _supported(o)]
    area = sum(footprint(models[o.name], 0.0).area for o in standing)
    area += sum(2 * _ROOM * float(models[o.name].size[:2].sum()) + 4 * _ROOM**2 for o in standing)
    x, y, z = plan.table.size
    share = {"round": 0.785, "oval": 0.85, "triangle": 0.45}.get(plan.table.outline, 1.0)
    widest = max((float(models[o.name].size[0]) for o in standing), default=0.0)
    taken = _FILLING[plan.density] * x * y * share
    factor = max(1.0, float(np.sqrt(area / taken)), (widest + 0.1) / x)
    factor *= growth
    if factor > max(_LARGEST, 2.4 / x):
        large = sorted(standing, key=lambda o: -models[o.name].size[:2].prod())[:3]
        raise SceneError(
            f"{len(standing)} objects do not fit on one {plan.table.outline} table of at most "
            f"{x * _LARGEST:.1f} m; the largest are {', '.join(o.name for o in large)}. Ask for "
            "fewer or smaller things."
        )
    return replace(plan.table, size=(round(x * factor, 3), round(y * factor, 3), z))


def _supported(planned: PlannedObject) -> bool:
    return any(r.kind in ("on", "in") and r.target != "table" for r in planned.relations)


def build_top(
    plan: ScenePlan, models: Mapping[str, Model], seed: int, growth: float = 1.0
) -> Model:
    """Build the plan's table, large enough for its objects.

    Raises:
        SceneError: no plausible table is large enough.
    """
    return catalogue.build_table(table_size(plan, models, growth), seed)


def outline_of(table: Model) -> Float[np.ndarray, "k 2"]:
    """Return the convex outline of a table model's top, metres, counter-clockwise."""
    points = table.mesh.vertices[table.mesh.vertices[:, 2] > 0.499]
    return convex_outline(points[:, :2] * table.size[:2])
