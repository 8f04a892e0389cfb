"""Positions where objects rest: on the table, or on or in other objects."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from jaxtyping import Float

from tabletop_objects import CATEGORIES

from ..geometry import rotation_z
from ..scene import TABLE, Density, Model, Placement, PlannedObject, ScenePlan, Slot
from .fields import HeightField, field_of
from .footprint import Footprint, footprint, gaps, margins
from .scores import Awaited, Neighbour, Request, proposals, score, violation
from .seats import seat_center
from .units import Unit

MARGIN = 0.02
"""Minimum distance between a footprint and the table's edge, in metres."""
GAP = 0.014
"""Minimum gap between two footprints, in metres."""


@dataclass(eq=False)
class State:
    """The state of one layout attempt.

    ``awaited`` maps an object's name to the objects that will be placed beside it later; ``strain``
    is the largest violation of a spatial relation.
    """

    places: dict[str, Placement] = field(default_factory=dict)
    neighbours: dict[str, Neighbour] = field(default_factory=dict)
    fields: dict[str, HeightField] = field(default_factory=dict)
    density: Density = "normal"
    warnings: list[str] = field(default_factory=list)
    awaited: Mapping[str, Sequence[Awaited]] = field(default_factory=dict)
    cost: float = 0.0
    strain: float = 0.0


def support_of(planned: PlannedObject) -> str | None:
    """Return the object on or in which a planned object stands, or None if it is the table."""
    return next(
        (r.target for r in planned.relations if r.kind in ("on", "in") and r.target != TABLE), None
    )


def put_on(
    planned: PlannedObject,
    support: str,
    plan: ScenePlan,
    models: Mapping[str, Model],
    rng: np.random.Generator,
    state: State,
    shapes: dict[str, Footprint],
) -> bool:
    """Lower an object onto or into its support, at the position where it rests lowest.

    If the support has a slot for it, like a rack, the object goes into that slot.
    """
    base = state.places[support]
    slot = next((s for s in models[support].slots if s.name == planned.name), None)
    if slot is not None:
        _put_in_slot(planned.name, slot, models[planned.name], base, state, shapes)
        return True
    inside = any(r.kind == "in" and r.target == support for r in planned.relations)
    sharing = [o.name for o in plan.objects if support_of(o) == support]
    alone = len(sharing) == 1
    siblings = [p for p in state.places.values() if p.on == support]
    below = [placed_triangles(models[p.name], p) for p in (base, *siblings)]
    top = float(below[0][..., 2].max())
    model = models[planned.name]
    if not inside:  # an object is roughly aligned with the one it stands on
        shapes[planned.name] = footprint(model, base.yaw + float(rng.normal(0, 0.07)))
    shape = shapes[planned.name]
    ground = state.fields.get(support) or field_of(models[support], base)
    for turn in _TURNS if inside and _is_long(model) else (0.0,):
        yaw = shape.yaw + turn
        height, empty = ground.resting(model, yaw)
        cost = _resting_cost(planned, support, ground, height, empty, alone, base, shapes, state)
        if inside and len(sharing) in _FEW and _rolls(planned):
            cost += _crowding(shape, ground, base, cost.shape)
        for cell in _best_cells(cost):
            start = np.array([*ground.place(cell), height[cell] + 0.5 * model.size[2]])
            placement = lower(
                model, Placement(planned.name, yaw, start, model.size, support, inside), below
            )
            if not inside or sunk(placement, top, heaped=bool(siblings)):
                shapes[planned.name] = footprint(model, yaw)
                state.places[planned.name] = placement
                state.neighbours[planned.name] = Neighbour(
                    shapes[planned.name], placement.translation[:2]
                )
                state.fields[support] = ground.with_thing(model, placement)
                return True
    return False


def _put_in_slot(
    name: str,
    slot: Slot,
    model: Model,
    base: Placement,
    state: State,
    shapes: dict[str, Footprint],
) -> None:
    """Put an object into its slot in a holder at ``base``."""
    yaw = base.yaw + slot.yaw
    at = base.translation + rotation_z(base.yaw) @ (slot.at * base.scale)
    at = at + np.array([0.0, 0.0, float(model.size[2]) / 2])
    shapes[name] = footprint(model, yaw)
    state.places[name] = Placement(name, yaw, at, model.size, base.name, True)
    state.neighbours[name] = Neighbour(shapes[name], at[:2])


_TURNS = (0.0, np.pi / 3, -np.pi / 3, np.pi / 2)
"""Alternative yaws of an object in a vessel, in radians."""


def _is_long(model: Model) -> bool:
    return float(model.size[:2].max()) > 1.8 * float(model.size[:2].min())


_FULL = 0.85
"""Maximum total length of two objects side by side, as a fraction of their support's length."""

_SLENDER = 2.5
"""Ratio of height to width above which upright objects in a vessel may stand close together."""

_BESIDE = 0.02
"""Cost of violating a relation to an object on the same support, in metres of height."""

_OVERHANG = 0.35
"""Maximum fraction of an object's underside that may overhang its support."""


def _resting_cost(
    planned: PlannedObject,
    support: str,
    ground: HeightField,
    height: Float[np.ndarray, "nx ny"],
    empty: Float[np.ndarray, "nx ny"],
    alone: bool,
    base: Placement,
    shapes: Mapping[str, Footprint],
    state: State,
) -> Float[np.ndarray, "nx ny"]:
    """Return the cost of each position on or in a support, or inf where the object cannot stand.

    Low positions are preferred, and those far from other objects or, for a single object, those
    near the middle.
    """
    nx, ny = height.shape
    grid = np.stack(np.meshgrid(np.arange(nx), np.arange(ny), indexing="ij"), -1)
    centers = (ground.origin + ground.step * grid).reshape(-1, 2)
    cost = np.where(np.isneginf(height) | np.isneginf(ground.top), np.inf, height).ravel()
    overhang = 0.08 if _rolls(planned) else _OVERHANG
    cost = cost + 0.2 * np.clip(empty.ravel() - overhang, 0, None)
    away = np.hypot(*(centers - base.translation[:2]).T)
    cost += (0.2 if alone else 0.01) * away
    shape = shapes[planned.name]
    siblings = [place for place in state.places.values() if place.on == support]
    mouth = _FULL * float(np.ptp(shapes[support].outline, axis=0).max())
    slender = shape.height > _SLENDER * 2 * float(shape.half.max())
    slack = 1.5 * float(shape.half.min()) if slender else 0.0  # stems may lean past each other
    for place in siblings:
        both = 2 * float(shape.half.min() + shapes[place.name].half.min())
        full = both > mouth and shape.height < shape.half.min()  # like shirts laid in a suitcase
        if not full:  # otherwise one would lie on top of the other
            room = gaps(shape, centers, shapes[place.name], place.translation[:2])
            room = room + slack
            cost += np.clip(0.003 - room, 0, None) * 4 + np.clip(0.03 - room, 0, None) * 0.15
    there = {p.name: Neighbour(shapes[p.name], p.translation[:2]) for p in siblings}
    request = Request(planned.relations, shape, there, shapes[support].outline)
    for relation in planned.relations:
        if relation.target in there:
            cost += _BESIDE * np.clip(violation(request, relation, centers), 0, 5)
    return cost.reshape(nx, ny)


_FEW = (2, 3)
"""Numbers of round objects that lie side by side in a vessel; with more objects, one lies in the
centre."""


def _rolls(planned: PlannedObject) -> bool:
    return planned.category in CATEGORIES and "round" in CATEGORIES[planned.category].roles


def _crowding(
    shape: Footprint, ground: HeightField, base: Placement, cells: tuple[int, ...]
) -> Float[np.ndarray, "nx ny"]:
    """Return how far, in metres, an object on each cell would extend over the support's centre."""
    grid = np.stack(np.meshgrid(*map(np.arange, cells), indexing="ij"), -1)
    centers = ground.origin + ground.step * grid
    away = np.linalg.norm(centers - base.translation[:2], axis=-1)
    return np.clip(0.9 * float(shape.reach.max()) - away, 0, None)


def _best_cells(cost: Float[np.ndarray, "nx ny"]) -> list[tuple[int, int]]:
    """Return some of the cheapest cells, in ascending order of cost."""
    order = np.argsort(cost, axis=None, kind="stable")[:400:100]
    cells = [divmod(int(k), cost.shape[1]) for k in order]
    return [cell for cell in cells if np.isfinite(cost[cell])]


def sunk(placement: Placement, rim: float, *, heaped: bool) -> bool:
    """Return whether an object is in a vessel or ``heaped`` on its contents, but not on its rim."""
    bottom = placement.translation[2] - placement.scale[2] / 2
    return bool(bottom < rim + (0.3 * placement.scale[2] if heaped else -0.004))


# ----------------------------------------------------------------------------- on the table


def cover_with(
    name: str, shapes: Mapping[str, Footprint], above: Sequence[PlannedObject]
) -> Footprint:
    """Return the footprint of an object together with the objects on it."""
    own = shapes[name]
    for other in above:
        if support_of(other) == name:
            own = own.covering(shapes[other.name])
    return own


def stand_unit(
    unit: Unit,
    models: Mapping[str, Model],
    table: Model,
    outline: Float[np.ndarray, "k 2"],
    rng: np.random.Generator,
    state: State,
    shapes: dict[str, Footprint],
    carrying: Mapping[str, Footprint],
) -> bool:
    """Place a unit on the table; return whether a free place was found."""
    if unit.seat is not None:
        center = seat_center(unit.seat, unit.shape, outline)
        for other in state.neighbours.values():
            if float(gaps(unit.shape, center[None], other.shape, other.center)[0]) < GAP / 2:
                return False
    else:
        found = _best_place(unit.planned, unit.shape, outline, rng, state)
        if found is None:
            return False
        center = found
    for name, offset in unit.offsets.items():
        model, yaw = models[name], shapes[name].yaw + unit.turns[name]
        shapes[name] = footprint(model, yaw)
        place = center + offset
        turned = shapes[name] if carrying[name] is shapes[name] else carrying[name]
        state.neighbours[name] = Neighbour(turned, place)
        height = float(table.size[2] + model.size[2] / 2)
        state.places[name] = Placement(name, yaw, np.array([*place, height]), model.size)
        under = unit.below.get(name, ())
        if under:
            surfaces = [placed_triangles(models[n], state.places[n]) for n in under]
            lying = lower(models[name], state.places[name], surfaces)
            state.places[name] = replace(lying, on=under[0])
    return True


def stand_on_table(
    planned: PlannedObject,
    models: Mapping[str, Model],
    table: Model,
    outline: Float[np.ndarray, "k 2"],
    rng: np.random.Generator,
    state: State,
    shapes: Mapping[str, Footprint],
    above: list[PlannedObject],
) -> bool:
    """Place an object at the best free place on the tabletop; return whether there was one."""
    model, shape = models[planned.name], shapes[planned.name]
    own = cover_with(planned.name, shapes, above)
    center = _best_place(planned, own, outline, rng, state)
    if center is None:
        return False
    state.neighbours[planned.name] = Neighbour(own, center)
    height = float(table.size[2] + model.size[2] / 2)
    state.places[planned.name] = Placement(
        planned.name, shape.yaw, np.array([*center, height]), model.size
    )
    return True


def _best_place(
    planned: PlannedObject,
    own: Footprint,
    outline: Float[np.ndarray, "k 2"],
    rng: np.random.Generator,
    state: State,
) -> Float[np.ndarray, "2"] | None:
    """Return the best free place on the tabletop, or None; its cost is added to ``state.cost``."""
    near = {r.target: state.neighbours[r.target] for r in planned.relations
            if r.target in state.neighbours}  # fmt: skip
    awaited = tuple(state.awaited.get(planned.name, ()))
    request = Request(planned.relations, own, near, outline, state.density, awaited)
    centers = proposals(request, rng)
    free = margins(own, centers, outline) >= MARGIN
    room = np.full(len(centers), 0.2)
    for other in state.neighbours.values():
        room = np.minimum(room, gaps(own, centers, other.shape, other.center))
    free &= room >= GAP
    if not free.any():
        return None
    costs = score(request, centers[free], room[free], list(state.neighbours.values()))
    pick = int(np.argmin(costs + rng.uniform(0, 0.03, len(costs))))
    center = centers[free][pick]
    state.cost += float(costs[pick])
    broken = [float(violation(request, r, center[None])[0]) for r in planned.relations]
    state.strain = max(state.strain, *broken, 0.0)
    return center


_GRID = 15


def placed_triangles(model: Model, placement: Placement) -> Float[np.ndarray, "m 3 3"]:
    """Return the model's triangles in the world frame."""
    points = model.mesh.vertices * placement.scale @ rotation_z(placement.yaw).T
    return (points + placement.translation)[model.mesh.faces]


def surface(
    corners: Float[np.ndarray, "m 3 3"], points: Float[np.ndarray, "p 2"], *, upper: bool
) -> Float[np.ndarray, "p"]:
    """Return the top (or bottom) z of triangles at each point; -inf (or inf) if there are none."""
    none = -np.inf if upper else np.inf
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    low, high = points.min(0), points.max(0)
    flat = corners[..., :2]
    near = (flat.max(1) >= low).all(1) & (flat.min(1) <= high).all(1) & (np.abs(area) > 1e-12)
    a, b, c, area = a[near], b[near], c[near], area[near]
    x, y = points[:, :1], points[:, 1:]
    w0 = ((b[:, 0] - x) * (c[:, 1] - y) - (b[:, 1] - y) * (c[:, 0] - x)) / area
    w1 = ((c[:, 0] - x) * (a[:, 1] - y) - (c[:, 1] - y) * (a[:, 0] - x)) / area
    w2 = 1 - w0 - w1
    inside = (w0 >= -1e-9) & (w1 >= -1e-9) & (w2 >= -1e-9)
    z = np.where(inside, w0 * a[:, 2] + w1 * b[:, 2] + w2 * c[:, 2], none)
    if not z.shape[1]:
        return np.full(len(points), none)
    return z.max(1) if upper else z.min(1)


def lower(
    model: Model, placement: Placement, below: Sequence[Float[np.ndarray, "_m 3 3"]]
) -> Placement:
    """Return the placement lowered (or raised) until the model touches the surfaces below it.

    If there is nothing below, the height is unchanged. Surfaces are compared on a grid of points
    under the model, so for smooth shapes the contact is exact to a fraction of a millimetre.
    """
    own = placed_triangles(model, placement)
    low, high = own[..., :2].min((0, 1)), own[..., :2].max((0, 1))
    steps = (np.arange(_GRID) + 0.5) / _GRID
    grid = np.stack(np.meshgrid(steps, steps), -1).reshape(-1, 2) * (high - low) + low
    bottom = surface(own, grid, upper=False)
    top = np.max([surface(other, grid, upper=True) for other in below], axis=0)
    both = np.isfinite(bottom) & np.isfinite(top)
    if not both.any():
        return placement
    lift = float((top[both] - bottom[both]).max())
    return Placement(
        placement.name,
        placement.yaw,
        placement.translation + np.array([0.0, 0.0, lift]),
        placement.scale,
        placement.on,
        placement.inside,
    )
