"""Candidate positions for an object, and their costs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from ..scene import TABLE, Density, Relation
from .footprint import BACK, FRONT, LEFT, RIGHT, Footprint, gaps, margins, rim_distance

SIDES: Mapping[str, tuple[int, int, tuple[float, float]]] = {
    "left_of": (LEFT, RIGHT, (-1.0, 0.0)),
    "right_of": (RIGHT, LEFT, (1.0, 0.0)),
    "behind": (BACK, FRONT, (0.0, 1.0)),
    "in_front_of": (FRONT, BACK, (0.0, -1.0)),
}
"""For each kind of relation, the direction indices of target and object, and the direction."""

_RELATED, _FREE = 120, 120  # numbers of candidates: proposed by relations, and all over the table
_SPACING: Mapping[Density, float] = {"sparse": 2.0, "normal": 1.0, "dense": 0.5}
"""Spacing of objects relative to the normal density."""

_BETWEEN = 0.025  # gap between an object and the one it stands beside, metres
_SIGHT = 0.7  # cotangent of the viewing elevation, 55 degrees


@dataclass(frozen=True, eq=False)
class Neighbour:
    """An object that has already been placed."""

    shape: Footprint
    center: Float[np.ndarray, "2"]


@dataclass(frozen=True, eq=False)
class Awaited:
    """An object to be placed beside the current one, described by its relation and its footprint.

    ``beside`` is the footprint of the object it refers to, and ``offset`` is the position of the
    latter relative to the current object's centre.
    """

    kind: str
    shape: Footprint
    beside: Footprint
    offset: Float[np.ndarray, "2"]


@dataclass(frozen=True, eq=False)
class Request:
    """An object to be placed; ``near`` maps names to the targets of its relations."""

    relations: tuple[Relation, ...]
    shape: Footprint
    near: Mapping[str, Neighbour]
    outline: Float[np.ndarray, "k 2"]
    density: Density = "normal"
    awaited: tuple[Awaited, ...] = ()

    @property
    def sides(self) -> tuple[str, ...]:
        """Sides of the table to which the object belongs; two of them define a corner."""
        return table_sides(self.relations)


def table_sides(relations: Sequence[Relation]) -> tuple[str, ...]:
    """Return the kinds of relations that name a side of the table."""
    return tuple(r.kind for r in relations if r.target == TABLE and r.kind in SIDES)


def proposals(request: Request, rng: np.random.Generator) -> Float[np.ndarray, "m 2"]:
    """Return candidate centres: some suggested by the relations, others spread over the table."""
    low, high = request.outline.min(0), request.outline.max(0)
    spread = rng.normal(0, 0.26, (_FREE // 2, 2)) * (high - low)
    anywhere = rng.uniform(low, high, (_FREE // 2, 2))
    sets = [spread, anywhere]
    for relation in request.relations:
        if relation.kind in SIDES and relation.target in request.near:
            sets.append(_beside(request, relation, rng))
        elif relation.kind == "next_to" and relation.target in request.near:
            sets.append(_around(request, relation, rng))
        elif relation.target == TABLE and relation.kind in SIDES:
            way = np.array(SIDES[relation.kind][2])
            sets.append(way * 0.3 * (high - low) + rng.normal(0, 0.1, (_RELATED, 2)) * (high - low))
        elif relation.kind == "center":
            sets.append(rng.normal(0, 0.03, (_RELATED, 2)))
        elif relation.kind == "edge":
            sets.append(_rim(request, rng))
    return np.concatenate(sets)


def _beside(request: Request, relation: Relation, rng: np.random.Generator) -> np.ndarray:
    target = request.near[relation.target]
    theirs, own, way = SIDES[relation.kind]
    distance = target.shape.reach[theirs] + request.shape.reach[own]
    steps = rng.uniform(0.016, 0.08, _RELATED)
    across = np.array([way[1], way[0]])
    slack = abs(float(target.shape.half @ across)) * 0.6 + 0.02
    aside = rng.normal(0, 0.6, _RELATED) * slack
    return target.center + np.outer(distance + steps, way) + np.outer(aside, across)


def _around(request: Request, relation: Relation, rng: np.random.Generator) -> np.ndarray:
    target = request.near[relation.target]
    angles = rng.uniform(0, 2 * np.pi, _RELATED)
    ways = np.column_stack([np.cos(angles), np.sin(angles)])
    blocked = target.shape.along(ways) + request.shape.along(-ways)
    return target.center + ways * (blocked + rng.uniform(0.016, 0.06, _RELATED))[:, None]


def _rim(request: Request, rng: np.random.Generator) -> np.ndarray:
    """Return centres a few centimetres inside the table's edge at the given sides."""
    low, high = request.outline.min(0), request.outline.max(0)
    if request.sides:
        ways = np.array([SIDES[side][2] for side in request.sides])
        spread = rng.normal(0, 0.12, (_RELATED, 2)) * (1 - np.abs(ways).sum(0).clip(max=1))
        centers = (0.3 * ways.sum(0) + spread) * (high - low)
        for side, way in zip(request.sides, ways, strict=True):
            free = rim_distance(centers, way, request.outline) - request.shape.reach[SIDES[side][0]]
            centers = centers + np.outer(free - rng.uniform(0.015, 0.05, _RELATED), way)
        return centers
    centers = rng.uniform(low, high, (_RELATED * 8, 2))
    inside = margins(request.shape, centers, request.outline)
    return centers[(inside > 0.02) & (inside < 0.05)][:_RELATED]


def score(
    request: Request,
    centers: Float[np.ndarray, "m 2"],
    room: Float[np.ndarray, "m"],
    others: Sequence[Neighbour],
) -> Float[np.ndarray, "m"]:
    """Return each centre's cost: violated relations weigh most, then occlusion, then crowding.

    ``room`` is the gap to the nearest neighbour, metres.
    """
    low, high = request.outline.min(0), request.outline.max(0)
    size = high - low
    cost = np.zeros(len(centers))
    for relation in request.relations:
        cost += 3.0 * violation(request, relation, centers)
    for awaited in request.awaited:
        cost += 1.5 * _crowded_out(awaited, centers, request.outline)
    cost += 0.9 * _hiding(request.shape, centers, others)
    far = _SPACING[request.density]
    cost += 0.5 * np.clip(0.05 * far - room, 0, None) / 0.05
    if request.relations:
        return cost
    tall = float(np.clip(request.shape.height / 0.25, 0, 1))
    wished = (0.42 * tall - 0.14) * size[1]
    cost += 0.5 * np.abs(centers[:, 1] - wished) / size[1]
    cost += 0.35 * np.clip(np.abs(centers[:, 0]) / size[0] - 0.25, 0, None)
    return cost + 0.3 * np.clip(room - 0.16 * far, 0, None) / 0.1


def _crowded_out(
    awaited: Awaited, centers: Float[np.ndarray, "m 2"], outline: Float[np.ndarray, "k 2"]
) -> Float[np.ndarray, "m"]:
    """Return the overhang of an object to be placed beside this one later, in units of 5 cm."""
    theirs, own, way = SIDES[awaited.kind]
    distance = awaited.beside.reach[theirs] + awaited.shape.reach[own] + _BETWEEN
    places = centers + awaited.offset + distance * np.array(way)
    return np.clip(_BETWEEN - margins(awaited.shape, places, outline), 0, None) / 0.05


def violation(
    request: Request, relation: Relation, centers: Float[np.ndarray, "m 2"]
) -> Float[np.ndarray, "m"]:
    """Return how strongly the object at each centre violates a relation, or 0 if it holds well."""
    size = np.ptp(request.outline, axis=0)
    if relation.target == TABLE:
        if relation.kind in SIDES:
            way = np.array(SIDES[relation.kind][2])
            wanted = 0.2 * float(np.abs(way) @ size)
            aside = np.abs(centers @ way[::-1]) / float(np.abs(way[::-1]) @ size)
            weight = 0.3 if len(request.sides) == 1 else 0.0
            return np.clip(wanted - centers @ way, 0, None) / wanted + weight * aside
        if relation.kind == "center":
            return np.hypot(*centers.T) / 0.1
        if relation.kind == "edge":
            inside = edge_gaps(request.shape, centers, request.outline, request.sides)
            return np.clip(inside - 0.05, 0, None).max(0) / 0.05
        return np.zeros(len(centers))
    target = request.near.get(relation.target)
    if target is None:
        return np.zeros(len(centers))
    apart = gaps(request.shape, centers, target.shape, target.center)
    far = np.clip(apart - 0.06, 0, None) / 0.1
    if relation.kind not in SIDES:
        return far
    theirs, own, way = SIDES[relation.kind]
    offset = centers - target.center
    along = offset @ np.array(way)
    clear = along - target.shape.reach[theirs] - request.shape.reach[own]
    aside = np.abs(offset @ np.array([way[1], way[0]]))
    allowed = 0.5 * float(target.shape.half @ np.abs([way[1], way[0]])) + 0.01
    return (
        np.clip(-clear, 0, None) / 0.02
        + 0.4 * np.clip(aside - allowed, 0, None) / 0.05
        + np.clip(aside - 0.9 * along, 0, None) / 0.03
        + 0.5 * far
    )


def edge_gaps(
    shape: Footprint,
    centers: Float[np.ndarray, "m 2"],
    outline: Float[np.ndarray, "k 2"],
    sides: Sequence[str],
) -> Float[np.ndarray, "s m"]:
    """Return the distance from a shape at each centre to the table's rim at each of ``sides``.

    If there are no sides, it is the distance to the nearest part of the rim.
    """
    if not sides:
        return margins(shape, centers, outline)[None]
    reach = [(SIDES[side][0], np.array(SIDES[side][2])) for side in sides]
    return np.stack([rim_distance(centers, way, outline) - shape.reach[k] for k, way in reach])


def _hiding(
    shape: Footprint, centers: Float[np.ndarray, "m 2"], others: Sequence[Neighbour]
) -> Float[np.ndarray, "m"]:
    """Return the fraction hidden from a viewer at the front and above, summed over object pairs."""
    total = np.zeros(len(centers))
    for other in others:
        offset = centers - other.center
        overlap = shape.half[0] + other.shape.half[0] - np.abs(offset[:, 0])
        for own, hidden, step in (
            (shape, other.shape, -offset[:, 1]),
            (other.shape, shape, offset[:, 1]),
        ):
            shade = own.half[1] + _SIGHT * (own.height - 0.4 * hidden.height)
            covered = np.clip(shade - (step - hidden.half[1]), 0, 2 * hidden.half[1])
            share = np.clip(overlap, 0, 2 * hidden.half[0]) * covered
            share /= max(4 * hidden.half[0] * hidden.half[1], 1e-6)
            total += np.where(step > 0, share, 0.0)
    return total
