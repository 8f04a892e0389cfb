"""Models of planned objects, and a table that is large enough for them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from jaxtyping import Float

import tabletop_objects as objects
from tabletop_objects.kit.parts import resting_ball
from tabletop_objects.kit.styles import STYLES
from tabletop_objects.values import write_room

from ..errors import SceneError
from ..geometry import convex_outline
from ..scene import ConvexPart, Density, Model, PlannedObject, PlannedTable, ScenePlan
from ..stand_ins import build_stand_in
from ..tables import build_table
from .cavities import find_cavity
from .footprint import footprint
from .holders import (
    LIES,
    file_in_box,
    fill_vessel,
    head_up,
    is_flat,
    leans,
    name_slots,
    room_of,
    stand_in_holder,
)
from .orientation import pose, stand_up
from .scores import SIDES

_FILLING: Mapping[Density, float] = {"sparse": 0.25, "normal": 0.42, "dense": 0.62}
"""Maximum fraction of the tabletop that the objects and their margins may cover."""

_MAX_GROWTH = 1.5  # maximum length of a table relative to the planned length
_ROOM = 0.035  # margin around each object, metres


def build_models(plan: ScenePlan, seed: int) -> dict[str, Model]:
    """Build a catalogue model for every planned object, each with its own seed.

    The plan's style is used if the catalogue has it.

    Identical planned objects ("two red mugs") share a seed and look alike. A long, thin object in a
    vessel stands and leans, like a pencil in a mug, unless the vessel is as wide as the object is
    long. Objects for which a rack or a carton has slots stand in these slots.
    """
    models: dict[str, Model] = {}
    seeds: dict[tuple[str, str, str], int] = {}
    seeds_of: dict[str, int] = {}
    standing = {o.name for o in plan.objects if any(r.kind == "in" for r in o.relations)}
    for planned in plan.objects:
        kind = (planned.category, planned.noun, str(sorted(planned.attributes.items())))
        number = seeds.setdefault(kind, len(seeds))
        if planned.name in standing:
            planned = replace(planned, attributes={**planned.attributes, "stands": "in a vessel"})
        built = _build(planned, style=plan.style, seed=seed * 1009 + number)
        seeds_of[planned.name] = seed * 1009 + number
        models[planned.name] = pose(built, planned.attributes.get("posture", ""))
    held: dict[str, list[PlannedObject]] = {}
    for planned in plan.objects:
        for relation in planned.relations:
            if relation.kind == "in" and relation.target in models:
                held.setdefault(relation.target, []).append(planned)
    for holder in plan.objects:
        if holder.name in held:
            rebuild = partial(_build, style=plan.style, seed=seeds_of[holder.name])
            models |= _put_in(holder, held[holder.name], models, rebuild)
    return models


def _put_in(
    target: PlannedObject,
    held: Sequence[PlannedObject],
    models: Mapping[str, Model],
    rebuild: Callable[[PlannedObject], Model],
) -> dict[str, Model]:
    """Return, by name, the models of a vessel or rack and of the objects that are put in it."""
    names = [planned.name for planned in held]
    if "places" not in target.attributes:
        return _put_in_vessel(target, held, models)
    kind = objects.CATEGORIES[target.category].holder
    if kind is None:
        return {n: replace(stand_up(models[n], 1.0), parts=_FITTED) for n in names}
    standing = {n: stand_in_holder(models[n], kind) for n in names}
    room = write_room(room_of(list(standing.values())))
    made = rebuild(replace(target, attributes={**target.attributes, "room": room}, size=None))
    return {**standing, target.name: name_slots(made, names)}


def _put_in_vessel(
    target: PlannedObject, held: Sequence[PlannedObject], models: Mapping[str, Model]
) -> dict[str, Model]:
    """Return the models in a vessel and the vessel's model by name; long objects stand and lean."""
    vessel = models[target.name]
    cavity = find_cavity(vessel)
    if cavity is None:
        return {p.name: stand_up(models[p.name], 3.0) for p in held}
    flat = {p.name: models[p.name] for p in held if is_flat(models[p.name])}
    wide = max((float(min(m.size[:2])) for m in flat.values()), default=0.0)
    if len(flat) == len(held) and (len(flat) > 2 or wide > LIES * cavity.mouth):
        filed = file_in_box(vessel, flat, cavity)
        if filed is not None:
            return {**filed[1], target.name: filed[0]}
    standing: dict[str, Model] = {}
    for planned in held:
        own = models[planned.name]
        if own.size[:2].max() > LIES * cavity.mouth or own.size[2] > own.size[:2].max():
            upright = stand_up(own, 1.7)
            standing[planned.name] = upright if upright is own else head_up(upright)
    long = {n: m for n, m in standing.items() if leans(m, cavity)}
    alone = {n: models[n].size[2] > models[n].size[:2].max() for n in long}
    vessel, leaning = fill_vessel(vessel, long, alone, may_grow=target.size is None)
    return {**standing, **leaning, target.name: vessel}


def find_fitted(plan: ScenePlan) -> set[str]:
    """Return the names of vessels with slots and of their contents, such as eggs in a carton."""
    vessels = {o.name for o in plan.objects if "places" in o.attributes}
    contents = {
        o.name for o in plan.objects
        if any(r.kind == "in" and r.target in vessels for r in o.relations)
    }  # fmt: skip
    return vessels | contents


_FITTED = (ConvexPart(resting_ball(1.0, 1.0, 1.0).vertices - [0.0, 0.0, 0.5]),)
"""Collision shape of a round object that stands in a slot, in the canonical frame."""


def _build(planned: PlannedObject, *, style: str, seed: int) -> Model:
    if planned.category == "generic":
        return build_stand_in(planned.family, planned.noun, seed, planned.attributes, planned.size)
    drawn = {"style": style} if style in STYLES else {}
    model = objects.build(planned.category, seed, attributes={**drawn, **planned.attributes})
    if planned.size is not None:
        factor = max(planned.size) / float(model.size.max())
        model = replace(model, size=model.size * factor)
    return replace(model, label=planned.noun)


def table_size(plan: ScenePlan, models: Mapping[str, Model], growth: float = 1.0) -> PlannedTable:
    """Return the planned table size, enlarged if the objects would otherwise be crowded.

    ``growth`` (at least 1) enlarges it further for another attempt.

    Raises:
        SceneError: Even the largest plausible table is too small.
    """
    standing = [o for o in plan.objects if not _supported(o)]
    area = sum(footprint(models[o.name], 0.0).area for o in standing)
    area += sum(2 * _ROOM * float(models[o.name].size[:2].sum()) + 4 * _ROOM**2 for o in standing)
    x, y, z = plan.table.size
    share = {"round": 0.785, "oval": 0.85, "triangle": 0.45}.get(plan.table.outline, 1.0)
    widest = max((float(models[o.name].size[0]) for o in standing), default=0.0)
    taken = _FILLING[plan.density] * x * y * share
    factor = max(1.0, float(np.sqrt(area / taken)), (widest + 0.1) / x)
    stretch = max(_chain(standing, models, axis) / (x, y)[axis] for axis in (0, 1))
    factor = max(factor, min(stretch, _MAX_GROWTH)) * growth
    if factor > max(_MAX_GROWTH, 2.4 / x):
        large = sorted(standing, key=lambda o: -models[o.name].size[:2].prod())[:3]
        raise SceneError(
            f"{len(standing)} objects do not fit on one {plan.table.outline} table of at most "
            f"{x * _MAX_GROWTH:.1f} m; the largest are {', '.join(o.name for o in large)}. Use "
            "fewer or smaller objects."
        )
    return replace(plan.table, size=(round(x * factor, 3), round(y * factor, 3), z))


def _chain(standing: Sequence[PlannedObject], models: Mapping[str, Model], axis: int) -> float:
    """Return the table length, in metres, that chains of side-by-side objects need along an axis.

    Objects that belong in the middle of the table need equal room on both sides.
    """
    half = {o.name: float(footprint(models[o.name], 0.0).half[axis]) for o in standing}
    beside = [
        (o.name, r.target, SIDES[r.kind][2][axis])
        for o in standing
        for r in o.relations
        if r.target in half and r.kind in SIDES and SIDES[r.kind][2][axis]
    ]
    reach = {(name, sign): room for name, room in half.items() for sign in (-1.0, 1.0)}
    for _ in standing[1:]:  # one iteration per link of the longest possible chain
        for name, target, sign in beside:
            further = half[target] + _ROOM + half[name] + reach[name, sign]
            reach[target, sign] = max(reach[target, sign], further)
    middle = {o.name for o in standing if any(r.kind == "center" for r in o.relations)}
    lengths = [
        2 * max(reach[n, -1.0], reach[n, 1.0]) if n in middle else reach[n, -1.0] + reach[n, 1.0]
        for n in half
    ]
    return max(lengths) + 2 * _ROOM if beside else 0.0


def _supported(planned: PlannedObject) -> bool:
    return any(r.kind in ("on", "in") and r.target != "table" for r in planned.relations)


def build_top(
    plan: ScenePlan, models: Mapping[str, Model], seed: int, growth: float = 1.0
) -> Model:
    """Build the plan's table at a size that is large enough for its objects.

    Raises:
        SceneError: No plausible table is large enough.
    """
    return build_table(table_size(plan, models, growth), seed)


def outline_of(table: Model) -> Float[np.ndarray, "k 2"]:
    """Return the convex, counter-clockwise outline of a table model's top, in metres."""
    points = table.mesh.vertices[table.mesh.vertices[:, 2] > 0.499]
    return convex_outline(points[:, :2] * table.size[:2])
