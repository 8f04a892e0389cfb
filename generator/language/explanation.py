"""Phrase-by-phrase explanation of how a text is interpreted."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np

from tabletop_objects import CATEGORIES

from ..scene.plan import PlannedObject
from .planner import plan_scene
from .reader import NOT_UNDERSTOOD, read_text
from .syntax.phrases.tree import (
    Arranged,
    Carry,
    Counted,
    Description,
    Lack,
    Location,
    Noun,
    Post,
    Zone,
)
from .vocabulary import SIZES

Role = Literal[
    "thing", "count", "attribute", "relation", "arrangement", "place", "table", "style",
    "setting", "absent", "note", "not understood",
]  # fmt: skip


@dataclass(frozen=True)
class Explained:
    """One phrase of a text, with its role and its meaning."""

    role: Role
    phrase: str
    meaning: str = ""


def explain(text: str, seed: int = 0) -> tuple[Explained, ...]:
    """Explain a text's phrases in order; the plan's warnings and the unused phrases follow.

    Raises:
        InputError: The text cannot be planned.
    """
    plan = plan_scene(text, seed)
    read = read_text(text, np.random.default_rng([int(seed) & 0xFFFFFFFF, 11]))
    rows: list[Explained] = []
    for sentence in read.sentences:
        for clause in sentence.clauses:
            if clause.lead is not None:
                rows += _post(clause.lead, "what follows", text)
            for noun in clause.subjects:
                rows += _noun(noun, text)
            subjects = ", ".join(noun.head for noun in clause.subjects) or "the same"
            for post in clause.predicate:
                rows += _post(post, subjects, text)
            if clause.people:
                rows.append(Explained("count", f"for {clause.people}", "people at the table"))
    if plan.style != "plain":
        rows.append(Explained("style", plan.style))
    notes = [warning for warning in plan.warnings if not warning.startswith(NOT_UNDERSTOOD)]
    rows += [Explained("note", "", note) for note in notes]
    rows += [Explained("not understood", phrase) for phrase in dict.fromkeys(read.reading.lost)]
    return tuple(dict.fromkeys(rows))


def summarize(text: str, seed: int = 0) -> str:
    """Return the plan as a single line: "A round table of oak: laptop, 2 × red mug.".

    Raises:
        InputError: The text cannot be planned.
    """
    plan = plan_scene(text, seed)
    table = plan.table
    made_of = " ".join(filter(None, (table.color, table.material)))
    things = Counter(_short(thing) for thing in plan.objects)
    listed = ", ".join(f"{n} × {words}" if n > 1 else words for words, n in things.items())
    outline = {"rectangle": "rectangular"}.get(table.outline, table.outline)
    article = "An" if outline[0] in "aeiou" else "A"
    return f"{article} {outline} table of {made_of}: {listed}."


def _short(thing: PlannedObject) -> str:
    said = [thing.attributes[key] for key in ("size", "color", "material")
            if key in thing.attributes]  # fmt: skip
    known = "" if thing.category in CATEGORIES else " (a plain stand-in)"
    return " ".join([*said, thing.noun]) + known


def _noun(noun: Noun, text: str) -> Iterator[Explained]:
    said = text[slice(*noun.span)].strip() or " ".join(noun.words)
    if noun.kind in ("thing", "collective"):
        yield Explained("thing", said, _meaning(noun))
        if noun.count is not None or noun.amount is not None or noun.each:
            amount = "each" if noun.each else _amount(noun)
            yield Explained("count", said, f"{amount} {noun.head}")
    elif noun.kind == "table":
        yield Explained("table", said)
    elif noun.kind in ("setting", "title", "vague", "part", "member"):
        yield Explained("setting", said)
    for key, value in noun.attributes.items():
        yield Explained("attribute", value, f"{key} of {noun.head or said}")
    for word in noun.words[: -len(noun.head.split()) or None]:
        if not _is_used(word, noun):
            yield Explained("not understood", word, f"of {noun.head or said}")
    if noun.arrangement is not None:
        yield Explained("arrangement", said, noun.arrangement)
    for post in noun.post:
        yield from _post(post, noun.head or said, text)


def _is_used(word: str, noun: Noun) -> bool:
    """Return whether a descriptive word applies to an object in the plan."""
    values = {part for value in noun.attributes.values() for part in value.split()}
    varied = {part for each in noun.variants for value in each.values() for part in value.split()}
    known = word in values | varied | SIZES.keys() or word == noun.position
    return known or noun.kind not in ("thing", "collective")


def _meaning(noun: Noun) -> str:
    if noun.members:
        return ", ".join(CATEGORIES[key].noun for key in noun.members)
    if noun.category is not None:
        return CATEGORIES[noun.category].noun
    return f"a stand-in ({noun.family or 'block'})"


def _amount(noun: Noun) -> str:
    if noun.count is not None:
        return f"{noun.count:g}"
    assert noun.amount is not None
    low, high = noun.amount
    return f"{low}" if low == high else f"{low} to {high}"


def _post(post: Post, subject: str, text: str) -> Iterator[Explained]:
    if isinstance(post, Location):
        if isinstance(post.target, Zone):
            yield Explained("place", _zone(post.target), f"of {subject}")
            return
        each = " each" if post.each else ""
        goal = " ".join(post.target.words) or post.target.head
        yield Explained("relation", f"{post.kind.replace('_', ' ')} {goal}", f"of {subject}{each}")
        if post.target.kind != "pronoun":
            yield from _noun(post.target, text)
    elif isinstance(post, Carry):
        for item in post.items:
            said = " ".join(item.words)
            yield Explained("relation", f"{post.how} {said}", f"of {subject}")
            yield from _noun(item, text)
    elif isinstance(post, Lack):
        for item in post.items:
            yield Explained("absent", " ".join(item.words), f"of {subject}")
        place = post.place
        if place is not None and isinstance(place.target, Noun):
            goal = " ".join(place.target.words) or place.target.head
            yield Explained("absent", f"{place.kind.replace('_', ' ')} {goal}", f"of {subject}")
    elif isinstance(post, Arranged):
        yield Explained("arrangement", post.kind, f"of {subject}")
    elif isinstance(post, Counted):
        yield Explained("count", f"{post.count:g}", f"of {subject}")
    else:
        yield from _description(post, subject)


def _description(post: Description, subject: str) -> Iterator[Explained]:
    for attributes in post.each:
        for key, value in attributes.items():
            yield Explained("attribute", value, f"{key} of {subject}")


def _zone(zone: Zone) -> str:
    words = [{-1: "left", 0: "middle", 1: "right"}[zone.x]] if zone.x is not None else []
    words += [{-1: "front", 0: "middle", 1: "back"}[zone.y]] if zone.y is not None else []
    return " ".join(dict.fromkeys([*words, *(["edge"] if zone.edge else [])]))
