"""Conversion of an answer to a scene plan: numbers become names, and words become categories."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from ....errors import InputError
from ....language.relations import check_relations
from ....language.vessel_sizes import grow_carriers
from ....language.words.dictionary import classify, warn_of_stand_ins
from ....language.words.foreign import is_in_other_script
from ....scene import TABLE, PlannedGroup, PlannedObject, PlannedTable, Relation, ScenePlan
from ....stand_ins import GENERIC, stand_in_size
from ..server.answers import GroupAnswer, PlanAnswer, RelationAnswer, ThingAnswer
from ..server.json_text import Wrong

_MOST = 2000  # characters per text
_LONGEST = 0.6  # maximum length of an object in metres, as in the embedded planner


def checked_text(text: object) -> str:
    """Return a user's prompt without surrounding whitespace.

    Raises:
        InputError: it is not a string, is empty, or is too long.
    """
    if not isinstance(text, str):
        raise InputError(f"Expected a prompt or a ScenePlan, got {type(text).__name__}.")
    if not any(c.isalpha() for c in text):
        raise InputError(
            "The prompt contains no words. Describe a tabletop, for example 'a desk with a lamp'."
        )
    if len(text) > _MOST:
        raise InputError(
            f"The prompt has {len(text)} characters; the limit is {_MOST}. Describe one table in "
            "a few sentences."
        )
    return text.strip()


def to_plan(prompt: str, answer: PlanAnswer) -> ScenePlan:
    """Convert a chat model's answer to a plan in the same form as the embedded planner's.

    Carriers are enlarged for their contents, impossible relations are dropped, and warnings list
    the stand-ins for objects that the catalogue lacks.

    Raises:
        Wrong, InputError: the answer contradicts itself.
    """
    table = answer.table
    if table.legs == "trestle" and table.outline in ("triangle", "oval", "round"):
        raise Wrong(f"a {table.outline} table cannot have trestle legs; choose other legs.")
    names = _names(answer)
    listed = [_thing(thing, names) for thing in answer.things]
    objects, doubts = check_relations(grow_carriers([_shorten(thing) for thing in listed]))
    cut = [_warn_of_length(thing) for thing in listed if thing.size and max(thing.size) > _LONGEST]
    size = (table.length_cm / 100, table.width_cm / 100, table.height_cm / 100)
    return ScenePlan(
        prompt,
        PlannedTable(table.outline, table.material.lower(), table.legs, size, table.color),
        tuple(objects),
        answer.style,
        tuple(dict.fromkeys([*cut, *warn_of_stand_ins(objects), *doubts])),
        tuple(_groups(answer, names)),
    )


def _names(answer: PlanAnswer) -> dict[int, str]:
    """Return the name for each object number, such as "mug_1" for the first mug."""
    names: dict[int, str] = {}
    stems: list[str] = []
    for thing in answer.things:
        if thing.id in names:
            raise Wrong(f"two objects have the number {thing.id}; each must have its own number.")
        if is_in_other_script(thing.noun):
            raise Wrong(f"the noun {thing.noun!r} of object {thing.id} must be in English.")
        stem = re.sub(r"[^0-9a-z]+", "_", _noun(thing.noun)).strip("_") or "object"
        stems.append("object" if stem == TABLE else stem)
        names[thing.id] = f"{stems[-1]}_{stems.count(stems[-1])}"
    return names


def _noun(word: str) -> str:
    return " ".join(word.lower().split())


def _thing(thing: ThingAnswer, names: dict[int, str]) -> PlannedObject:
    noun = _noun(thing.noun)
    category, family = classify(tuple(re.findall(r"[a-z]+", noun)))
    state = thing.state
    if thing.contents:
        state, noun = f"with {thing.contents}", f"{noun} of {thing.contents}"
    fields = {
        "color": thing.color, "accent": thing.accent, "material": thing.material,
        "size": thing.size_word, "state": state,
        "posture": thing.posture,
    }  # fmt: skip
    attributes = {k: v for k, v in fields.items() if v}
    size = None if category else stand_in_size(family, attributes)
    if thing.size_cm:
        size = (thing.size_cm[0] / 100, thing.size_cm[1] / 100, thing.size_cm[2] / 100)
    return PlannedObject(
        names[thing.id], noun, category or GENERIC, attributes,
        tuple(_relation(thing, relation, names) for relation in thing.relations),
        size, "" if category else family,
    )  # fmt: skip


def _shorten(thing: PlannedObject) -> PlannedObject:
    """Return an object scaled down to the maximum length on a table."""
    if thing.size is None or max(thing.size) <= _LONGEST:
        return thing
    x, y, z = (float(v) for v in np.asarray(thing.size) * _LONGEST / max(thing.size))
    return replace(thing, size=(x, y, z))


def _warn_of_length(thing: PlannedObject) -> str:
    longest = max(thing.size or (0.0,))
    return (
        f"A {thing.noun} of {longest:g} m is too long for a table; it was scaled to {_LONGEST:g} m."
    )


def _relation(thing: ThingAnswer, relation: RelationAnswer, names: dict[int, str]) -> Relation:
    if relation.target and relation.target not in names:
        raise Wrong(f"object {thing.id} is related to {relation.target}, which is not an object.")
    if relation.target and relation.kind in ("center", "edge"):
        raise Wrong(
            f"the relation {relation.kind!r} of object {thing.id} must be to the table, number 0."
        )
    if not relation.target and relation.kind == "in":
        raise Wrong(f"object {thing.id} cannot be 'in' the table (0); it can only be 'on' it.")
    rests = [r for r in thing.relations if r.kind in ("on", "in")]
    if len({r.target for r in rests}) > 1:
        raise Wrong(f"object {thing.id} is on or in several objects; only one is allowed.")
    return Relation(relation.kind, names[relation.target] if relation.target else TABLE)


# ----------------------------------------------------------------------------------------- groups


def _groups(answer: PlanAnswer, names: dict[int, str]) -> Iterable[PlannedGroup]:
    """Yield the groups, each of at least two objects.

    Raises:
        Wrong: the groups contradict the objects.
    """
    taken: set[int] = set()
    laid: set[int] = set()
    for group in answer.groups:
        told = [*group.things, *([group.around] if group.around else [])]
        where = f"the {group.kind} of objects {', '.join(map(str, told))}"
        if strange := sorted({*told} - {*names}):
            raise Wrong(f"{where} contains {strange[0]}, which is not the number of an object.")
        if len({*told}) < len(told) or taken & {*told}:
            raise Wrong(f"{where} contains an object twice, or one of another group.")
        taken |= {*told}
        _check_group(group, where, laid, answer)
        if len(told) > 1:
            seat = None if group.seat is None else (group.seat.number - 1, group.seat.count)
            around = names[group.around] if group.around else None
            yield PlannedGroup(group.kind, tuple(names[n] for n in group.things), around, seat)


def _check_group(group: GroupAnswer, where: str, laid: set[int], answer: PlanAnswer) -> None:
    """Raise Wrong if a group's fields do not match its kind; ``laid`` collects the used seats."""
    if group.around is not None and group.kind != "circle":
        raise Wrong(f"{where} cannot have 'around'; only a circle can.")
    if (group.seat is not None) != (group.kind == "setting"):
        raise Wrong(f"{where}: a setting must have a seat, and other groups must not.")
    if group.seat is None:
        return
    counts = {g.seat.count for g in answer.groups if g.seat is not None}
    if len(counts) > 1 or group.seat.number > group.seat.count or group.seat.number in laid:
        raise Wrong(
            f"{where}: the seats must be numbered from 1 to their count, each number once, and all "
            "settings must have the same count of seats."
        )
    laid.add(group.seat.number)
