"""Evaluation of a plan's relations in the settled scene: whether they hold, and by what margin.

Supports are determined from contacts; containment and positions from the shapes of the objects at
rest. The intended placements are not used. ``foresee`` evaluates placements before settling.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from ..geometry import (
    convex_outline,
    inside_margin,
    quaternion_matrix,
    rotation_z,
    yaw_quaternion,
)
from ..physics.simulation import ON_TABLE, Simulation
from ..scene import (
    TABLE,
    Model,
    Placement,
    PlannedObject,
    Pose,
    Relation,
    RelationOutcome,
    Scene,
    ScenePlan,
)
from .footprint import rim_distance
from .furniture import outline_of
from .scores import SIDES, table_sides
from .seats import seats

NEAR = 0.15
"""Maximum gap between two objects that count as next to each other, in metres."""

_TOUCH = 1e-3  # maximum distance between touching objects, metres
_EDGE = 0.12  # maximum distance from the rim of an object that counts as at the edge, metres
_CLEAR = 0.01  # minimum offset of an object that counts as on one side of another, metres
_FOOT = 0.1  # height of the part that counts as an object's foot, as a fraction of its height
_RIM = 0.04  # maximum height above the rim of a contained object's centre, metres


@dataclass(frozen=True, eq=False)
class _Thing:
    """An object at rest, in metres: its outline seen from above, base position and height range."""

    center: Float[np.ndarray, "3"]
    outline: Float[np.ndarray, "k 2"]
    low: float
    high: float
    foot: Float[np.ndarray, "2"]

    @property
    def half(self) -> Float[np.ndarray, "2"]:
        return np.ptp(self.outline, axis=0) / 2

    @property
    def middle(self) -> Float[np.ndarray, "2"]:
        return (self.outline.min(0) + self.outline.max(0)) / 2


@dataclass(frozen=True, eq=False)
class Rest:
    """Positions, in metres, of objects on a tabletop, and contacts by name, including ``TABLE``."""

    size: Float[np.ndarray, "2"]
    outline: Float[np.ndarray, "k 2"]
    things: dict[str, _Thing]
    touching: dict[str, frozenset[str]]


def observe(scene: Scene) -> Rest:
    """Return the positions and contacts in the settled scene."""
    simulation = Simulation(scene)
    simulation.place([o.pose for o in scene.objects])
    names = [o.name for o in scene.objects]
    found: dict[str, set[str]] = {name: set() for name in names}
    for a, b in simulation.contacts(margin=_TOUCH).pairs.tolist():
        one, other = (names[k] if k >= 0 else TABLE if k == ON_TABLE else "" for k in (a, b))
        for name, partner in ((one, other), (other, one)):
            if name in found and partner:
                found[name].add(partner)
    things = {o.name: _rest(o.model, o.scale, o.pose) for o in scene.objects}
    touching = {name: frozenset(others) for name, others in found.items()}
    return Rest(scene.table.scale[:2], scene.table.outline, things, touching)


def foresee(placements: Sequence[Placement], models: Mapping[str, Model], table: Model) -> Rest:
    """Return the positions and contacts that result if objects stay on their intended supports."""
    things = {
        p.name: _rest(models[p.name], p.scale, Pose(p.translation, yaw_quaternion(p.yaw)))
        for p in placements
    }
    touching = {p.name: frozenset({p.on}) for p in placements}
    return Rest(table.size[:2], outline_of(table), things, touching)


def check_relations(plan: ScenePlan, rest: Rest) -> tuple[RelationOutcome, ...]:
    """Return the outcome of every relation in the plan between objects that exist."""
    turns = _turns(plan, rest.size)
    out = []
    for planned in plan.objects:
        for relation in planned.relations:
            if planned.name in rest.things and relation.target in (TABLE, *rest.things):
                margin = float(_margin(planned, relation, rest, turns))
                out.append(
                    RelationOutcome(
                        planned.name, relation.kind, relation.target, margin > 0, round(margin, 4)
                    )
                )
    return tuple(out)


def record_relations(scene: Scene, rest: Rest | None = None) -> Scene:
    """Return a settled scene with corrected supports and with relation outcomes in its report.

    ``rest`` is the observation of the scene if it has already been made. If a scene has no report,
    only its supports are corrected.
    """
    rest = observe(scene) if rest is None else rest
    outcomes = () if scene.plan is None else check_relations(scene.plan, rest)
    scene = correct_supports(scene, rest)
    if scene.report is None:
        return scene
    return scene.replace(report=replace(scene.report, relations=outcomes))


def list_unmet(scene: Scene) -> list[RelationOutcome]:
    """Return the recorded relations of a scene that do not hold."""
    return [] if scene.report is None else [o for o in scene.report.relations if not o.holds]


def warn_unmet(scene: Scene) -> Scene:
    """Return the scene with a warning for each relation that does not hold."""
    messages = [describe_unmet(outcome, scene) for outcome in list_unmet(scene)]
    warnings = tuple(dict.fromkeys([*scene.provenance.warnings, *messages]))
    return scene.replace(provenance=replace(scene.provenance, warnings=warnings))


def describe_unmet(outcome: RelationOutcome, scene: Scene) -> str:
    """Return a warning that a relation does not hold."""
    kind = outcome.kind.replace("_", " ")
    if outcome.kind in ("center", "edge"):
        kind = f"at the {outcome.kind} of"
    on = scene.object(outcome.name).placement.on
    return f"{outcome.name} is not {kind} {outcome.target}; it rests on {on}."


def correct_supports(scene: Scene, rest: Rest) -> Scene:
    """Return the scene with each object's support set to what the object actually rests on."""
    meant = {o.name: o.placement.on for o in scene.objects}
    objects = []
    for thing in scene.objects:
        on = thing.placement.on
        if on == TABLE or not _is_carried(thing.name, on, rest, thing.placement.inside):
            below = [
                n
                for n in rest.touching[thing.name]
                if n != TABLE
                and meant[n] != thing.name
                and rest.things[n].center[2] < rest.things[thing.name].center[2]
            ]
            table = TABLE in rest.touching[thing.name] or not below
            real = TABLE if table else min(below, key=lambda n: rest.things[n].center[2])
            if real != on or thing.placement.inside:
                thing = replace(thing, placement=replace(thing.placement, on=real, inside=False))
        objects.append(thing)
    return scene.replace(objects=tuple(objects))


# -------------------------------------------------------------------------------------- measures


def _rest(model: Model, scale: Float[np.ndarray, "3"], pose: Pose) -> _Thing:
    turn = quaternion_matrix(pose.quaternion)
    points = np.asarray(model.mesh.vertices, float) * scale @ turn.T + pose.position
    low, high = float(points[:, 2].min()), float(points[:, 2].max())
    foot = points[points[:, 2] <= low + _FOOT * (high - low), :2].mean(0)
    return _Thing(np.asarray(pose.position), convex_outline(points[:, :2]), low, high, foot)


def _margin(
    planned: PlannedObject, relation: Relation, rest: Rest, turns: dict[str, tuple[int, float]]
) -> float:
    """Return a relation's margin in metres; a relation with a margin of 0 or less does not hold."""
    own = rest.things[planned.name]
    if relation.target == TABLE:
        return _table_margin(own, relation, rest, table_sides(planned.relations))
    target = rest.things[relation.target]
    if relation.kind in ("on", "in"):
        return _support_margin(planned.name, relation, rest)
    if relation.kind in SIDES:
        way = np.array(SIDES[relation.kind][2])
        mine, theirs = turns.get(planned.name), turns.get(relation.target)
        if mine is not None and mine == theirs:
            way = rotation_z(mine[1])[:2, :2] @ way
        across = np.array([-way[1], way[0]])
        offset = own.middle - target.middle
        reach = float((own.half + target.half) @ np.abs(across))
        return float(offset @ way - max(0.0, abs(offset @ across) - reach)) - _CLEAR
    return NEAR - _gap(own, target)


def _support_margin(name: str, relation: Relation, rest: Rest) -> float:
    """Return how far inside its support the object's centre is; negative if it is not supported."""
    own, target = rest.things[name], rest.things[relation.target]
    inside = float(inside_margin(own.center[None, :2], target.outline)[0])
    if not _is_carried(name, relation.target, rest, relation.kind == "in"):
        return min(inside, -1e-3)
    return max(inside, 1e-3)


def _is_carried(name: str, support: str, rest: Rest, inside: bool) -> bool:
    """Return whether an object rests on (or in) another, directly or through other objects."""
    own, target = rest.things[name], rest.things[support]
    if inside:
        either = np.stack([own.center[:2], own.foot])
        within = float(inside_margin(either, target.outline).max()) > 0
        deep = own.center[2] < target.high + _RIM or own.low < target.high - 1e-3
        if not (within and deep and own.low < target.high + _CLEAR):
            return False
    seen, open_ends = {name}, [name]
    while open_ends:
        at = open_ends.pop()
        for other in rest.touching[at] - seen:
            if other == support:
                return own.center[2] > target.low and (inside or own.low > target.low + 1e-4)
            if other != TABLE and TABLE not in rest.touching[other]:
                seen.add(other)
                open_ends.append(other)
    return False


def _gap(one: _Thing, other: _Thing) -> float:
    """Return the distance, in metres, between two bounding boxes seen from above."""
    apart = np.abs(one.middle - other.middle) - one.half - other.half
    return float(np.hypot(*np.clip(apart, 0, None)))


def _table_margin(own: _Thing, relation: Relation, rest: Rest, sides: Sequence[str]) -> float:
    width, depth = (float(v) for v in rest.size)
    x, y = own.middle
    if relation.kind in SIDES:
        return float(own.middle @ np.array(SIDES[relation.kind][2])) - _CLEAR
    if relation.kind == "center":
        return min(0.15 * width - abs(x), 0.2 * depth - abs(y))
    if relation.kind == "edge" and sides:
        ways = [np.array(SIDES[side][2]) for side in sides]
        half = own.half
        gaps = [
            float(rim_distance(own.middle[None], way, rest.outline)[0]) - float(half @ np.abs(way))
            for way in ways
        ]
        return _EDGE - max(gaps)
    if relation.kind == "edge":
        return _EDGE - float(inside_margin(own.outline, rest.outline).min())
    return 1e-3


def _turns(plan: ScenePlan, extent: Float[np.ndarray, "2"]) -> dict[str, tuple[int, float]]:
    """Return the seat index and the turn (radians) of each object in a place setting."""
    found: dict[str, tuple[int, float]] = {}
    for group in plan.groups:
        if group.seat is not None:
            number, count = group.seat
            size = float(extent[0]), float(extent[1])
            turn = seats(count, plan.table.outline, size)[number].turn
            found |= dict.fromkeys(group.members, (number, turn))
    return found
