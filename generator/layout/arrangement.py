"""Arrangement by relations: sampled candidates, hard limits and a score for natural positions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np
from jaxtyping import Float

from ..errors import SceneError
from ..scene import TABLE, Model, Placement, PlannedGroup, PlannedObject, Relation, ScenePlan
from .footprint import Footprint, footprint, margins
from .furniture import build_top, outline_of
from .orientation import natural_yaw
from .rest import MARGIN, State, cover_with, put_on, stand_on_table, stand_unit, support_of
from .scores import SIDES, Awaited, Neighbour, Request, violation
from .units import Unit, units_of

_TRIES = 12

GROWTH = (1.0, 1.15, 1.3)
"""Growth factors of the table, one per attempt."""

_STRAINED = 1.0
"""Violation of a relation (``Layout.strain``) at or above which a larger table is tried."""


@dataclass(frozen=True)
class Layout:
    """Placements of all objects, and warnings about requests that could not be satisfied.

    ``strain`` is the largest violation of any relation; see ``scores.violation``.
    """

    placements: tuple[Placement, ...]
    warnings: tuple[str, ...] = ()
    strain: float = 0.0


def arrange(
    plan: ScenePlan,
    models: Mapping[str, Model],
    table: Model,
    seed: int,
    yaws: Mapping[str, float] = MappingProxyType({}),
) -> Layout:
    """Place every planned object on the table, or on or in another object, in the world frame.

    Footprints keep a distance of ``GAP`` from each other and ``MARGIN`` from the table's edge.
    Several orders are tried; the arrangement with the lowest cost (violated relations, occlusion,
    crowding) is returned. ``yaws`` prescribes the yaws of some objects, in radians. The same input
    and seed give the same layout.

    Raises:
        SceneError: There is no free place for an object; the message names it.
    """
    outline = outline_of(table)
    best: State | None = None
    failed: str = ""
    for attempt in range(_TRIES):
        rng = np.random.default_rng([int(seed) & 0xFFFFFFFF, attempt, 3])
        state = State(density=plan.density)
        stuck = _place_all(plan, models, table, outline, rng, state, yaws)
        if stuck is not None:
            failed = stuck
        elif best is None or state.cost < best.cost:
            best = state
        if best is not None and (attempt >= 3 or best.cost < 0.05 * len(plan.objects)):
            break
    if best is None:
        raise SceneError(
            f"There is no free place for {failed} on the {plan.table.outline} table of "
            f"{table.size[0]:.2f} x {table.size[1]:.2f} m with {len(plan.objects)} objects. Use "
            "fewer or smaller objects, or a larger table."
        )
    _center(best, plan, outline)
    places = tuple(best.places[o.name] for o in plan.objects)
    return Layout(places, tuple(best.warnings), best.strain)


def arrange_more(
    plan: ScenePlan,
    placed: Mapping[str, Placement],
    models: Mapping[str, Model],
    table: Model,
    seed: int,
    yaws: Mapping[str, float] = MappingProxyType({}),
) -> Layout:
    """Place the objects of a plan that are not in ``placed``; those in ``placed`` do not move.

    ``placed`` may contain objects that are not in the plan; ``models`` contains the models of all
    objects, at their final sizes; ``yaws`` prescribes the yaws of some objects, in radians. An
    object without a free place is left out, with a warning. Only the new placements are returned.
    """
    outline = outline_of(table)
    rng = np.random.default_rng([int(seed) & 0xFFFFFFFF, 5])
    warnings: list[str] = []
    while True:
        state = State(
            dict(placed), {n: _standing(models[n], p) for n, p in placed.items()},
            density=plan.density,
        )  # fmt: skip
        stuck = _place_all(plan, models, table, outline, rng, state, yaws)
        if stuck is None:
            new = tuple(p for name, p in state.places.items() if name not in placed)
            return Layout(new, (*warnings, *state.warnings))
        warnings.append(f"There is no free place on the table for {stuck}.")
        plan = _without(plan, stuck, placed)


BROKEN = 1.5
"""Cost (see ``scores.violation``) at or above which a relation counts as violated."""


def unmet_relations(
    planned: PlannedObject,
    placement: Placement,
    placed: Mapping[str, Placement],
    models: Mapping[str, Model],
    table: Model,
) -> tuple[Relation, ...]:
    """Return the spatial relations of an object that its placement violates.

    The relations "on" and "in" are not checked.
    """
    own = _standing(models[planned.name], placement)
    near = {r.target: _standing(models[r.target], placed[r.target])
            for r in planned.relations if r.target in placed}  # fmt: skip
    request = Request(planned.relations, own.shape, near, outline_of(table))
    return tuple(
        r
        for r in planned.relations
        if r.kind not in ("on", "in") and violation(request, r, own.center[None])[0] >= BROKEN
    )


def _standing(model: Model, placement: Placement) -> Neighbour:
    return Neighbour(footprint(model, placement.yaw), placement.translation[:2])


def _without(plan: ScenePlan, name: str, placed: Mapping[str, Placement]) -> ScenePlan:
    """Return the plan without the given object and without the objects on or in it."""
    gone = {name}
    while more := {o.name for o in plan.objects if support_of(o) in gone} - gone - {*placed}:
        gone |= more
    objects = tuple(
        replace(o, relations=tuple(r for r in o.relations if r.target not in gone))
        for o in plan.objects
        if o.name not in gone
    )
    groups = tuple(
        replace(
            g, members=tuple(n for n in g.members if n not in gone),
            around=None if g.around in gone else g.around,
        )
        for g in plan.groups
    )  # fmt: skip
    return replace(plan, objects=objects, groups=groups)


def _place_all(
    plan: ScenePlan,
    models: Mapping[str, Model],
    table: Model,
    outline: Float[np.ndarray, "k 2"],
    rng: np.random.Generator,
    state: State,
    yaws: Mapping[str, float] = MappingProxyType({}),
) -> str | None:
    """Place all remaining objects; return the name of the first one that has no free place."""
    supports = {o.name: support_of(o) for o in plan.objects}
    missing = [o for o in plan.objects if o.name not in state.places]
    standing = [o for o in missing if supports[o.name] is None]
    above = [o for o in missing if supports[o.name] is not None]
    shapes = {name: there.shape for name, there in state.neighbours.items()}
    facing = {o.name: natural_yaw(o, models[o.name], plan, rng) for o in missing} | {**yaws}
    shapes |= {o.name: footprint(models[o.name], facing[o.name]) for o in missing}
    on_table = {o.name: o for o in standing}
    carrying = {name: cover_with(name, shapes, above) for name in on_table}
    sized = replace(plan.table, size=(*map(float, table.size),))
    groups = [_take_supports(group, supports) for group in plan.groups]
    units = {u.planned.name: u for u in units_of(groups, on_table, carrying, sized, rng)}
    inside = {name for unit in units.values() for name in unit.offsets}
    alone = [o for o in standing if o.name not in inside]
    wholes = [unit.planned for unit in units.values()]
    state.awaited = _find_awaited(alone, wholes, units, shapes)
    for planned in _order([*alone, *wholes], models, rng, units):
        unit = units.get(planned.name)
        if unit is not None:
            if not stand_unit(unit, models, table, outline, rng, state, shapes, carrying):
                return planned.name
        elif not stand_on_table(planned, models, table, outline, rng, state, shapes, above):
            return planned.name
    while above:
        ready = [o for o in above if supports[o.name] in state.places]
        ready.sort(key=lambda o: _rank(o, models[o.name]))
        later = {o.name for o in ready}
        ready.sort(key=lambda o: any(r.target in later for r in o.relations))
        for planned in ready:
            support = str(supports[planned.name])
            if not put_on(planned, support, plan, models, rng, state, shapes):
                beside = _beside(planned, support)
                state.warnings.append(
                    f"{planned.name} does not fit on or in {support}, so it was placed next to "
                    f"{support} instead."
                )
                state.cost += 1.0
                if not stand_on_table(beside, models, table, outline, rng, state, shapes, []):
                    return planned.name
        above = [o for o in above if o not in ready]
    return None


def _find_awaited(
    alone: Sequence[PlannedObject],
    wholes: Sequence[PlannedObject],
    units: Mapping[str, Unit],
    shapes: Mapping[str, Footprint],
) -> dict[str, list[Awaited]]:
    """Return, for each object or unit, the objects that will be placed beside it later."""
    whose = {name: (unit.planned.name, at) for unit in units.values()
             for name, at in unit.offsets.items()}  # fmt: skip
    sizes = {**{o.name: shapes[o.name] for o in alone}, **{n: u.shape for n, u in units.items()}}
    upcoming: dict[str, list[Awaited]] = {}
    for planned in (*alone, *wholes):
        for relation in planned.relations:
            target = relation.target
            if relation.kind not in SIDES or target not in shapes:
                continue
            owner, offset = whose.get(target, (target, np.zeros(2)))
            if owner != planned.name:
                upcoming.setdefault(owner, []).append(
                    Awaited(relation.kind, sizes[planned.name], shapes[target], offset)
                )
    return upcoming


def _rank(planned: PlannedObject, model: Model) -> float:
    """Return the sort key of an object on or in another; the longest in a vessel comes first."""
    inside = any(r.kind == "in" for r in planned.relations)
    return -float(model.size.max()) if inside else 0.0


def _take_supports(group: PlannedGroup, supports: Mapping[str, str | None]) -> PlannedGroup:
    """Replace the members of a group by their supports; for example, cups become their saucers."""

    def bottom(name: str) -> str:
        below = supports.get(name)
        return name if below is None else bottom(below)

    around = None if group.around is None else bottom(group.around)
    members = tuple(dict.fromkeys(bottom(name) for name in group.members))
    return replace(group, members=members, around=around)


def _center(state: State, plan: ScenePlan, outline: Float[np.ndarray, "k 2"]) -> None:
    """Move all objects towards the table's centre, slightly to the front, if relations allow it."""
    kinds = {r.kind for o in plan.objects for r in o.relations if r.target == TABLE}
    fixed = bool(kinds & {"center", "edge"})
    free = np.array(
        [not fixed and not kinds & {"left_of", "right_of"},
         not fixed and not kinds & {"behind", "in_front_of"}], float
    )  # fmt: skip
    standing = [n for name, n in state.neighbours.items() if state.places[name].on == TABLE]
    low = np.min([n.center - n.shape.half for n in standing], axis=0)
    high = np.max([n.center + n.shape.half for n in standing], axis=0)
    for share in (0.85, 0.6, 0.35, 0.15):
        move = -share * free * ((low + high) / 2 + [0.0, 0.05 * np.ptp(outline[:, 1])])
        inside = min(float(margins(n.shape, (n.center + move)[None], outline)[0]) for n in standing)
        if inside >= MARGIN:
            break
    else:
        return
    for name, place in state.places.items():
        state.places[name] = replace(place, translation=place.translation + np.append(move, 0.0))


def _beside(planned: PlannedObject, support: str) -> PlannedObject:
    relations = tuple(
        replace(r, kind="next_to") if r.target == support else r for r in planned.relations
    )
    return replace(planned, relations=relations)


def _order(
    objects: list[PlannedObject],
    models: Mapping[str, Model],
    rng: np.random.Generator,
    units: Mapping[str, Unit],
) -> list[PlannedObject]:
    """Order objects: targets of relations before others, and larger objects before smaller ones.

    Place settings come before everything else, since their places are fixed.
    """
    size = {o.name: float(models[o.name].size[:2].max()) * rng.uniform(0.7, 1.3) for o in objects}
    for name, unit in units.items():
        size[name] = 10.0 if unit.seat is not None else 2 * float(unit.shape.half.max())
    waiting = sorted(objects, key=lambda o: -size[o.name])
    names = {o.name for o in objects} | {name for u in units.values() for name in u.offsets}
    done: list[PlannedObject] = []
    while waiting:
        placed = {o.name for o in done}
        placed |= {name for o in done if o.name in units for name in units[o.name].offsets}
        ready = [
            o
            for o in waiting
            if all(r.target in placed or r.target not in names for r in o.relations)
        ]
        named = [r.target for o in waiting for r in o.relations]
        chosen = ready[0] if ready else max(waiting, key=lambda o: named.count(o.name))
        done.append(chosen)
        waiting.remove(chosen)
    return done


def lay_out(
    plan: ScenePlan,
    models: Mapping[str, Model],
    seed: int,
    yaws: Mapping[str, float] = MappingProxyType({}),
) -> tuple[Layout, Model]:
    """Arrange the models on the plan's table, or on a larger one if they do not fit.

    ``yaws`` prescribes the yaws of some objects, in radians.

    Raises:
        SceneError: The objects do not fit on any plausible table.
    """
    error: SceneError | None = None
    best: tuple[Layout, Model] | None = None
    for growth in GROWTH:
        try:
            table = build_top(plan, models, seed, growth)
            layout = arrange(plan, models, table, seed, yaws)
        except SceneError as failed:
            error = failed
            continue
        if best is None or layout.strain < best[0].strain:
            best = layout, table
        if layout.strain < _STRAINED:
            break
    if best is None:
        raise error or SceneError("No table size was tried.")
    return best
