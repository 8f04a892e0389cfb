"""Consistency of planned relations: contradictions are errors, implausible ones are replaced."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import cast, get_args

from tabletop_objects import CATEGORIES
from tabletop_objects.values import Extent

from ..errors import InputError
from ..scene import TABLE, PlannedObject, Relation, RelationKind
from ..stand_ins import FAMILIES, GENERIC, stand_in_size

KINDS: frozenset[str] = frozenset(get_args(RelationKind))
OPPOSITE: Mapping[str, str] = {
    "left_of": "right_of", "right_of": "left_of", "behind": "in_front_of", "in_front_of": "behind",
}  # fmt: skip
_SUPPORTED = ("on", "in")


def kind(word: str) -> RelationKind:
    """Check that ``word`` is a relation kind, and return it.

    Raises:
        InputError: The word is not a relation kind.
    """
    if word not in KINDS:
        raise InputError(f"{word!r} is not a relation; relations are {', '.join(sorted(KINDS))}.")
    return cast(RelationKind, word)


def check_relations(objects: Sequence[PlannedObject]) -> tuple[list[PlannedObject], list[str]]:
    """Return the objects with consistent relations, and a warning for each changed relation.

    A relation "in" an object that is not a vessel becomes "on"; "in" or "on" an object that is too
    small becomes "next to"; "in the middle of" another object becomes "on" it, and "at the edge of"
    one "next to" it.

    Raises:
        InputError: An object is related to itself, has two supports, or is part of a cycle (a on b,
            b on a; a left of b, b left of a).
    """
    _check_circles(objects)
    by_name = {o.name: o for o in objects}
    warnings: list[str] = []
    out = []
    for planned in objects:
        kept = []
        for relation in planned.relations:
            better = _plausible(planned, relation, by_name)
            target = by_name.get(relation.target)
            if better.kind not in ("in", relation.kind) and relation.kind in _SUPPORTED and target:
                warnings.append(
                    f"A {planned.noun} does not fit {relation.kind} a {target.noun}; it is placed "
                    f"{better.kind.replace('_', ' ')} it."
                )
            kept.append(better)
        out.append(replace(planned, relations=tuple(dict.fromkeys(kept))))
    return out, list(dict.fromkeys(warnings))


_PLACED = (*OPPOSITE, "next_to")


def place_supports(objects: Sequence[PlannedObject]) -> list[PlannedObject]:
    """Transfer the relations of supported objects to their supports.

    In "a flask on a tile in front of the stand", the tile is in front of the stand. A support that
    has relations of its own keeps them.
    """
    under = {o.name: r.target for o in objects for r in o.relations
             if r.kind in _SUPPORTED and r.target != TABLE}  # fmt: skip
    found = {o.name: o for o in objects}

    def bottom(name: str) -> str:
        for _ in objects:
            name = under.get(name, name)
        return name

    for planned in objects:
        base = found.get(bottom(planned.name))
        if base is None or base.name == planned.name or base.relations:
            continue
        moved = [
            replace(r, target=bottom(r.target))
            for r in planned.relations
            if r.kind in _PLACED
            and r.target != TABLE
            and bottom(r.target) != base.name
            and all(
                back.target != base.name for back in found[bottom(r.target)].relations
            )  # no circle
        ]
        found[base.name] = replace(base, relations=tuple(dict.fromkeys(moved)))
    return [found[o.name] for o in objects]


def _check_circles(objects: Sequence[PlannedObject]) -> None:
    supports: dict[str, set[str]] = {}
    lefts: dict[str, set[str]] = {}
    fronts: dict[str, set[str]] = {}
    for planned in objects:
        for relation in planned.relations:
            a, b = planned.name, relation.target
            if a == b:
                raise InputError(f"The prompt places the {planned.noun} relative to itself.")
            if relation.kind in _SUPPORTED and b != TABLE:
                supports.setdefault(a, set()).add(b)
            elif relation.kind in OPPOSITE and b != TABLE:
                graph = lefts if relation.kind in ("left_of", "right_of") else fronts
                first, last = (a, b) if relation.kind in ("left_of", "in_front_of") else (b, a)
                graph.setdefault(first, set()).add(last)
        if len(supports.get(planned.name, ())) > 1:
            raise InputError(
                f"The prompt puts one {planned.noun} on or in two objects at once; name only one."
            )
    for graph, what in ((supports, "on"), (lefts, "left of"), (fronts, "in front of")):
        circle = _circle(graph)
        if circle:
            raise InputError(
                f"The relations contradict each other: {f' {what} '.join(circle)}. "
                "Change one of them."
            )


def _circle(graph: dict[str, set[str]]) -> list[str]:
    """Return the names along a cycle in a directed graph, or an empty list."""
    done: set[str] = set()

    def visit(name: str, path: list[str]) -> list[str]:
        if name in path:
            return [*path[path.index(name) :], name]
        if name in done:
            return []
        for following in sorted(graph.get(name, ())):
            found = visit(following, [*path, name])
            if found:
                return found
        done.add(name)
        return []

    return next((found for name in sorted(graph) if (found := visit(name, []))), [])


def size_of(planned: PlannedObject) -> tuple[float, float, float]:
    """Return a planned object's expected extent, in metres."""
    if planned.size is not None:
        return planned.size
    if planned.category == GENERIC:
        return stand_in_size(planned.family, planned.attributes)
    return CATEGORIES[planned.category].size


def is_container(planned: PlannedObject) -> bool:
    """Return whether other objects can be put into a planned object."""
    if "places" in planned.attributes:
        return True
    if planned.category == GENERIC:
        return planned.family in FAMILIES and FAMILIES[planned.family].container
    return CATEGORIES[planned.category].container


_STEMS: Mapping[str, float] = {
    "rose": 0.3, "tulip": 0.3, "daisy": 0.3, "sunflower": 0.2, "lily": 0.2, "carnation": 0.3,
    "lavender": 0.5, "posy": 0.2, "bouquet": 0.2, "orchid": 0.3, "dried_flower": 0.4,
    "spoon": 0.4, "wooden_spoon": 0.4,
    "spatula": 0.4, "whisk": 0.4, "ladle": 0.3, "fork": 0.6, "lollipop": 0.3, "hairbrush": 0.5,
    "paint_brush": 0.6, "makeup_brush": 0.6, "straw": 0.4, "skimmer": 0.3,
}  # fmt: skip
"""Width and height below the head of a long object in a vessel, as fractions of its own."""


def body_size(category: str) -> tuple[float, float, float]:
    """Return the extent, in metres, of the part that is in a vessel, such as a flower's stem."""
    x, y, z = CATEGORIES[category].size
    share = _STEMS.get(category, 1.0)
    return x, y * share, z * share


_FOOT: Mapping[str, float] = {"monitor": 0.42, "desk_lamp": 0.6, "globe": 0.7, "laptop": 0.9}
"""Width and depth of an object's foot, as fractions of its own."""


def standing_size(planned: PlannedObject) -> tuple[float, float, float]:
    """Return the length and width of an object's base and the object's full height, in metres."""
    x, y, z = size_of(planned)
    share = _FOOT.get(planned.category, 1.0)
    return x * share, y * share, z


def has_place(planned: PlannedObject, target: PlannedObject) -> bool:
    """Return whether a holder can have a slot for a planned object."""
    holder = None if target.category == GENERIC else CATEGORIES[target.category].holder
    if holder is None:
        return "places" in target.attributes
    return holder.takes(size_of(planned))


def put_in_size(planned: PlannedObject, vessel: tuple[float, float, float]) -> Extent:
    """Return an object's extent in a vessel; long objects stand with the head above the rim."""
    x, y, z = standing_size(planned)
    stem = _STEMS.get(planned.category, 1.0)
    if x < 0.85 * min(vessel[:2]) or (stem == 1.0 and x < 2.2 * max(y, z)):
        return x, y, z
    return z * stem, y * stem, x


_CLOSED = frozenset({"jar", "bottle", "can", "tea_tin", "milk_carton", "screw_box", "wine_bottle"})
"""Vessels with lids, into which nothing is put."""


def _plausible(
    planned: PlannedObject, relation: Relation, by_name: dict[str, PlannedObject]
) -> Relation:
    """Return the relation, or else the most similar plausible one."""
    if relation.target == TABLE:
        return relation
    target = by_name[relation.target]
    if relation.kind in ("center", "edge"):
        relation = Relation("on" if relation.kind == "center" else "next_to", target.name)
    if relation.kind not in _SUPPORTED:
        return relation
    if "places" in target.attributes and has_place(planned, target):
        return Relation("in", target.name)
    outer = size_of(target)
    inner = put_in_size(planned, outer) if relation.kind == "in" else standing_size(planned)
    container = is_container(target)
    if relation.kind == "in" and fits("in", inner, outer, container):
        return relation
    closed = not container and target.category in _CLOSED
    vessel = closed or (container and not is_shallow(outer))
    if fits("on", inner, outer, container) and not (relation.kind == "in" and vessel):
        return Relation("on", target.name)
    return Relation("next_to", target.name)


def is_shallow(extent: tuple[float, float, float]) -> bool:
    """Return whether objects lie on, rather than in, an object of this extent, such as a tray."""
    return extent[2] < 0.3 * min(extent[:2])


def fits(
    kind: str,
    inner: tuple[float, float, float],
    outer: tuple[float, float, float],
    container: bool,
) -> bool:
    """Return whether an object of size ``inner`` fits on or in one of size ``outer``, in metres."""
    narrow, middle, longest = sorted(inner)
    if kind == "in":
        mouth = 0.85 * min(outer[:2])
        upright = inner[2] == longest or narrow < 0.5 * mouth
        widest = middle if upright else max(inner[:2])
        on_edge = narrow < 0.15 * middle and middle <= 0.85 * max(outer[:2])
        return container and (widest <= mouth or on_edge) and longest < 2.8 * outer[2]
    return min(inner[:2]) <= 1.25 * min(outer[:2]) and max(inner[:2]) <= 1.6 * max(outer[:2])
