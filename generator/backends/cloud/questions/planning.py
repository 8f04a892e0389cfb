"""A planned scene out of its answer: numbers become names, words become catalogue keys."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from ....catalogue import category
from ....errors import InputError
from ....scene import TABLE, PlannedObject, PlannedTable, Relation, ScenePlan
from ..server.answers import PlanAnswer, RelationAnswer, ThingAnswer
from ..server.reading import Wrong

_MOST = 2000  # characters of a text


def checked_text(text: object) -> str:
    """Return a user's text without space around it (InputError: no text, empty, or too long)."""
    if not isinstance(text, str):
        raise InputError(f"A text or a ScenePlan is needed, got {type(text).__name__}.")
    if not any(c.isalpha() for c in text):
        raise InputError(
            "The text holds no words. Describe a tabletop, for example 'a desk with a lamp'."
        )
    if len(text) > _MOST:
        raise InputError(
            f"The text has {len(text)} characters; at most {_MOST} are read. Describe one table in "
            "a few sentences."
        )
    return text.strip()


def to_plan(prompt: str, answer: PlanAnswer) -> ScenePlan:
    """Return the plan of an answer (Wrong, InputError: it contradicts itself)."""
    names = _names(answer)
    objects = tuple(_thing(thing, names) for thing in answer.things)
    table = answer.table
    if table.legs == "trestle" and table.outline in ("triangle", "oval", "round"):
        raise Wrong(f"a {table.outline} table has no trestle legs; choose others.")
    size = (table.length_cm / 100, table.width_cm / 100, table.height_cm / 100)
    return ScenePlan(
        prompt,
        PlannedTable(table.outline, table.material.lower(), table.legs, size, table.color),
        objects,
        answer.style,
    )


def _names(answer: PlanAnswer) -> dict[int, str]:
    """Return each number's name: "mug_1" for the first mug."""
    names: dict[int, str] = {}
    stems: list[str] = []
    for thing in answer.things:
        if thing.id in names:
            raise Wrong(f"the number {thing.id} is given twice. Each thing has its own.")
        stems.append(re.sub(r"[^0-9a-z]+", "_", _noun(thing.noun)).strip("_") or "object")
        names[thing.id] = f"{stems[-1]}_{stems.count(stems[-1])}"
    return names


def _noun(word: str) -> str:
    return " ".join(word.lower().split())


def _thing(thing: ThingAnswer, names: dict[int, str]) -> PlannedObject:
    fields = {
        "color": thing.color, "material": thing.material,
        "size": thing.size_word, "state": thing.state,
    }  # fmt: skip
    size = thing.size_cm
    return PlannedObject(
        names[thing.id],
        _noun(thing.noun),
        _category_key(thing.noun),
        {k: v for k, v in fields.items() if v},
        tuple(_relation(thing, relation, names) for relation in thing.relations),
        (size[0] / 100, size[1] / 100, size[2] / 100) if size else None,
    )


def _relation(thing: ThingAnswer, relation: RelationAnswer, names: dict[int, str]) -> Relation:
    if relation.target and relation.target not in names:
        raise Wrong(f"thing {thing.id} is related to number {relation.target}, which is no thing.")
    if relation.target and relation.kind in ("center", "edge"):
        raise Wrong(f"thing {thing.id} is {relation.kind!r} of a thing; only of 0, the table.")
    if not relation.target and relation.kind == "in":
        raise Wrong(f"thing {thing.id} is in the table; things are on the table, 0.")
    rests = [r for r in thing.relations if r.kind in ("on", "in")]
    if len({r.target for r in rests}) > 1:
        raise Wrong(f"thing {thing.id} is on or in more than one other.")
    return Relation(relation.kind, names[relation.target] if relation.target else TABLE)


def _category_key(noun: str) -> str:
    """Return the catalogue's key for a noun, or for its last words; "generic" if it has none."""
    words = _noun(noun).split()
    for first in range(len(words)):
        try:
            return category(" ".join(words[first:])).key
        except InputError:
            continue
    return "generic"


def in_words(plan: ScenePlan) -> tuple[str, str]:
    """Return a plan's table, and its things line by line, as an image model is told them."""
    table = plan.table
    length, width, height = (round(100 * v) for v in table.size)
    color = f"{table.color} " if table.color else ""
    top = (
        f"a {table.outline} {color}{table.material} table, {length} cm long, {width} cm deep and "
        f"{height} cm high, with {table.legs} legs"
    )
    called = _descriptions(plan)
    lines = []
    for number, thing in enumerate(plan.objects, start=1):
        size = f", {in_cm(thing.size)}" if thing.size else ""
        where = "; ".join(_PLACES[r.kind].format(called[r.target]) for r in thing.relations)
        lines.append(f"{number}. {called[thing.name]}{size}{': ' + where if where else ''}")
    return top, "\n".join(lines)


_PLACES = {
    "left_of": "to the left of {}",
    "right_of": "to the right of {}",
    "in_front_of": "in front of {}",
    "behind": "behind {}",
    "on": "on {}",
    "in": "inside {}",
    "next_to": "beside {}",
    "center": "in the middle of {}",
    "edge": "near the edge of {}",
}


def _descriptions(plan: ScenePlan) -> dict[str, str]:
    """Return how each thing is called: with its looks, and its number where nouns repeat."""
    nouns = [thing.noun for thing in plan.objects]
    called = {TABLE: "the table"}
    for thing in plan.objects:
        looks = [thing.attributes[k] for k in ("size", "state", "color", "material")
                 if k in thing.attributes]  # fmt: skip
        which = ""
        if nouns.count(thing.noun) > 1:
            earlier = [t.name for t in plan.objects if t.noun == thing.noun]
            which = f" (number {earlier.index(thing.name) + 1} of {len(earlier)})"
        called[thing.name] = f"the {' '.join([*looks, thing.noun])}{which}"
    return called


def in_cm(size: Sequence[float] | np.ndarray) -> str:
    """Return a size, metres, in words."""
    return " by ".join(f"{100 * v:.3g}" for v in size) + " cm"
