"""Units: rows, columns, circles, fans and heaps of objects placed together, and place settings.

A unit is placed on the table as a whole, according to the hull of its members. Within the unit each
member has a fixed offset and yaw.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from tabletop_objects import CATEGORIES

from ..geometry import convex_outline, rotation_z
from ..scene import PlannedGroup, PlannedObject, PlannedTable, Relation
from .footprint import BACK, DIRECTIONS, FRONT, LEFT, RIGHT, Footprint
from .heaps import Pile, pile_heap, pile_pyramid
from .seats import Seat, seats

SPACING = 0.02
"""Gap between neighbours in a unit, in metres; larger than the minimum gap between footprints."""

_GAP = 0.016  # gap between the objects of a place setting, metres


@dataclass(frozen=True, eq=False)
class Unit:
    """A group of objects, with their positions relative to its centre.

    Attributes:
        planned: object that represents the unit, with the first member's name and all members'
            relations to other objects.
        offsets: positions of the members relative to the unit's centre, metres.
        turns: angle added to each member's yaw, radians.
        shape: hull of all members.
        below: names of the members that each member not directly on the table lies on.
        seat: the seat of a place setting, else None.
    """

    planned: PlannedObject
    offsets: Mapping[str, Float[np.ndarray, "2"]]
    turns: Mapping[str, float]
    shape: Footprint
    below: Mapping[str, tuple[str, ...]]
    seat: Seat | None = None


def units_of(
    groups: Sequence[PlannedGroup],
    objects: Mapping[str, PlannedObject],
    shapes: Mapping[str, Footprint],
    table: PlannedTable,
    rng: np.random.Generator,
) -> list[Unit]:
    """Return the units of a plan; each object belongs to at most one.

    ``objects`` are the objects on the table, and ``shapes`` are their footprints, including
    everything that they carry. ``table`` determines the seats.
    """
    taken: set[str] = set()
    found = []
    for group in groups:
        members = [name for name in group.members if name in objects and name not in taken]
        around = group.around if group.around in objects and group.around not in taken else None
        if len(members) + (around is not None) < 2 or group.kind not in _ARRANGERS:
            continue
        taken |= {*members, *([around] if around else [])}
        seat = None
        if group.seat is not None:
            number, count = group.seat
            seat = seats(count, table.outline, table.size[:2])[number]
        found.append(_unit(group, members, around, objects, shapes, seat, rng))
    return found


def _unit(
    group: PlannedGroup,
    members: list[str],
    around: str | None,
    objects: Mapping[str, PlannedObject],
    shapes: Mapping[str, Footprint],
    seat: Seat | None,
    rng: np.random.Generator,
) -> Unit:
    own = [shapes[name] for name in members]
    inner = shapes[around] if around else None
    pile = _pile(group, members, own, objects)
    if group.kind == "setting":
        offsets = _setting(members, objects, shapes)
        turns = [0.0] * len(members)
    elif pile is not None:
        offsets, turns = list(pile.offsets), [float(t) for t in rng.normal(0, 0.2, len(members))]
    else:
        offsets, turns = _ARRANGERS[group.kind](own, inner, rng)
    places = dict(zip(members, offsets, strict=True))
    angles = dict(zip(members, turns, strict=True))
    if around:
        places[around], angles[around] = np.zeros(2), 0.0
    places, angles, shape = _center(places, angles, shapes, 0.0 if seat is None else seat.turn)
    below = {
        members[k]: tuple(members[i] for i in under)
        for k, under in enumerate(pile.below if pile else ())
        if under
    }
    return Unit(_merge(places, objects), places, angles, shape, below, seat)


def _pile(
    group: PlannedGroup,
    members: Sequence[str],
    shapes: Sequence[Footprint],
    objects: Mapping[str, PlannedObject],
) -> Pile | None:
    """Return how the objects of a group are piled, or None if all of them are on the table."""
    if group.kind == "heap":
        return pile_heap(shapes)
    if group.kind == "pyramid":
        first = objects[members[0]].category
        return pile_pyramid(shapes, balls=first in CATEGORIES and CATEGORIES[first].ball)
    return None


def _center(
    places: Mapping[str, Float[np.ndarray, "2"]],
    turns: Mapping[str, float],
    shapes: Mapping[str, Footprint],
    turn: float,
) -> tuple[dict[str, Float[np.ndarray, "2"]], dict[str, float], Footprint]:
    """Return the members' centred offsets, their turns and their hull, all rotated by ``turn``."""
    matrix = rotation_z(turn)[:2, :2]
    corners = [shapes[n].outline @ rotation_z(turns[n])[:2, :2].T + places[n] for n in places]
    points = np.concatenate(corners)
    middle = (points.min(0) + points.max(0)) / 2
    outline = convex_outline((points - middle) @ matrix.T)
    reach = (outline @ DIRECTIONS.T).max(0)
    height = max(shapes[name].height for name in places)
    centered = {name: matrix @ (place - middle) for name, place in places.items()}
    return centered, {n: t + turn for n, t in turns.items()}, Footprint(outline, reach, height)


def _merge(
    places: Mapping[str, Float[np.ndarray, "2"]], objects: Mapping[str, PlannedObject]
) -> PlannedObject:
    """Return the first member, with all members' relations to objects outside the group."""
    relations: list[Relation] = []
    for name in places:
        relations += [
            r for r in objects[name].relations if r.target not in places and r not in relations
        ]
    first = objects[next(iter(places))]
    return replace(first, relations=tuple(relations))


Arrangement = tuple[list[Float[np.ndarray, "2"]], list[float]]
Arranger = Callable[[Sequence[Footprint], Footprint | None, np.random.Generator], Arrangement]


def _row(
    shapes: Sequence[Footprint], inner: Footprint | None, rng: np.random.Generator
) -> Arrangement:
    """Arrange members side by side along x, with their front edges aligned."""
    offsets, x = [], 0.0
    for k, shape in enumerate(shapes):
        x += float(shape.reach[LEFT]) + (min(SPACING, 0.3 * float(shape.half[0])) if k else 0.0)
        offsets.append(np.array([x, float(shape.reach[FRONT])]))
        x += float(shape.reach[RIGHT])
    return offsets, [0.0] * len(shapes)


def _column(
    shapes: Sequence[Footprint], inner: Footprint | None, rng: np.random.Generator
) -> Arrangement:
    """Arrange members one behind the other along y, with the first in front."""
    offsets, y = [], 0.0
    for k, shape in enumerate(shapes):
        y += float(shape.reach[FRONT]) + (SPACING if k else 0.0)
        offsets.append(np.array([0.0, y]))
        y += float(shape.reach[BACK])
    return offsets, [0.0] * len(shapes)


def _grid(
    shapes: Sequence[Footprint], inner: Footprint | None, rng: np.random.Generator
) -> Arrangement:
    """Arrange members in a grid of equal cells, about as wide as it is deep."""
    cell = np.max([2 * shape.reach[[RIGHT, BACK]] for shape in shapes], axis=0) + SPACING
    width = int(np.ceil(np.sqrt(len(shapes))))
    offsets = [cell * np.array([k % width, k // width]) for k in range(len(shapes))]
    return offsets, [0.0] * len(shapes)


def _circle(
    shapes: Sequence[Footprint], inner: Footprint | None, rng: np.random.Generator
) -> Arrangement:
    """Arrange members evenly around a centre."""
    widest = max(float(shape.reach.max()) for shape in shapes)
    count = len(shapes)
    needed = (widest + SPACING / 2) / np.sin(np.pi / count) if count > 1 else 0.0
    radius = max(needed, (float(inner.reach.max()) if inner else 0.0) + widest + SPACING)
    start = float(rng.uniform(0, 2 * np.pi)) if inner is None else -np.pi / 2
    angles = start + 2 * np.pi * np.arange(count) / count
    return [radius * np.array([np.cos(a), np.sin(a)]) for a in angles], [0.0] * count


def _group(
    shapes: Sequence[Footprint], inner: Footprint | None, rng: np.random.Generator
) -> Arrangement:
    """Arrange members close together, each as near to the centre as the previous ones allow."""
    offsets: list[np.ndarray] = []
    for shape in shapes:
        if not offsets:
            offsets.append(np.zeros(2))
            continue
        best: np.ndarray | None = None
        for angle in rng.uniform(0, 2 * np.pi, 24):
            way = np.array([np.cos(angle), np.sin(angle)])
            far = max(
                float(place @ way) + float(other.reach.max()) + float(shape.reach.max())
                for place, other in zip(offsets, shapes, strict=False)
            )
            steps = np.linspace(0.0, far + SPACING, 60)
            free = [
                s for s in steps
                if all(_apart(shape, s * way, other, place) >= SPACING
                       for place, other in zip(offsets, shapes, strict=False))
            ]  # fmt: skip
            if free and (best is None or free[0] < float(np.hypot(*best))):
                best = free[0] * way
        offsets.append(best if best is not None else np.array([far + SPACING, 0.0]))
    return offsets, [float(t) for t in rng.normal(0, 0.2, len(shapes))]


def _apart(
    one: Footprint, at: Float[np.ndarray, "2"], other: Footprint, there: Float[np.ndarray, "2"]
) -> float:
    blocked = one.reach + np.roll(other.reach, len(DIRECTIONS) // 2)
    return float(((there - at) @ DIRECTIONS.T - blocked).max())


def _setting(
    members: Sequence[str],
    objects: Mapping[str, PlannedObject],
    shapes: Mapping[str, Footprint],
) -> list[Float[np.ndarray, "2"]]:
    """Return the positions in a place setting relative to its first object, seen from the seat."""
    first = members[0]
    edges = {"left_of": -float(shapes[first].reach[LEFT]), "right_of": shapes[first].reach[RIGHT]}
    places = {first: np.zeros(2)}
    ends = {side: float(value) for side, value in edges.items()}
    behind = float(shapes[first].reach[BACK])
    base = -float(shapes[first].reach[FRONT])
    for name in members[1:]:
        shape = shapes[name]
        kinds = {r.kind: r.target for r in objects[name].relations if r.target in members}
        side = next((k for k in ("left_of", "right_of") if k in kinds), None)
        if side == "left_of":
            x = ends[side] - _GAP - float(shape.reach[RIGHT])
            ends[side] = x - float(shape.reach[LEFT])
        elif side == "right_of":
            x = ends[side] + _GAP + float(shape.reach[LEFT])
            ends[side] = x + float(shape.reach[RIGHT])
        else:
            target = next(iter(kinds.values()), first)
            x = float(places.get(target, places[first])[0])
            y = behind + _GAP + float(shape.reach[FRONT])
            if target == first:
                behind = y + float(shape.reach[BACK])
            places[name] = np.array([x, y])
            continue
        places[name] = np.array([x, max(base + float(shape.reach[FRONT]), -0.02)])
    return [places[name] for name in members]


_ARRANGERS: Mapping[str, Arranger] = {
    "row": _row, "column": _column, "grid": _grid, "circle": _circle, "group": _group,
    "heap": _group, "pyramid": _group, "fan": _row, "setting": _row,
}  # fmt: skip
