"""Rule-based planning of scenes from texts (Sec. 3, Fig. 20) with grammar, synonyms and themes."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from types import MappingProxyType

import numpy as np

from tabletop_objects import CATEGORIES

from ..errors import InputError
from ..scene import TABLE, Density, PlannedGroup, PlannedObject, Relation, ScenePlan
from ..stand_ins import GENERIC, stand_in_size
from . import relations
from .drafts import Draft, Grouping, Reading
from .furniture import plan_table
from .reader import EXAMPLE, read_text
from .semantics import contents
from .semantics.tone import read_tone
from .theme_content import PlaceSetting, fill, place_settings, relate_by_habit, setting_of
from .themes import DEFAULT_TABLES, THEMES
from .vessel_sizes import grow_carriers
from .words.dictionary import warn_of_stand_ins

_OWN = 3
"""Minimum number of kinds of objects in a prompt that is assumed to describe a complete table."""

_FULL: Mapping[Density, tuple[int, int]] = MappingProxyType(
    {"sparse": (3, 4), "normal": (5, 7), "dense": (10, 13)}
)
"""Minimum and maximum number of objects for a prompt that only states a theme."""


def plan_scene(prompt: str, seed: int, density: Density | None = None) -> ScenePlan:
    """Plan the tabletop scene that an English text describes.

    Explicit objects, counts, attributes and relations are kept exactly. If a text only names a kind
    of table ("an office desk") or is vague ("some tools"), typical objects are added: up to seven,
    or as many as ``density`` implies (if it is None, it is inferred from words such as
    "cluttered"). A noun outside the catalogue becomes a "generic" object with a warning. The same
    text and seed give the same plan.

    Raises:
        InputError: The text is empty, too long or not English, names nothing that belongs on a
            table, or has impossible counts or contradictory relations.
    """
    rng = np.random.default_rng([int(seed) & 0xFFFFFFFF, 11])
    read = read_text(prompt, rng)
    reading, tone = read.reading, read_tone(prompt, read.sentences)
    _check_content(prompt, reading, tone.theme)
    objects, groups = relate_by_habit(*_plan_objects(reading))
    full = density or tone.density
    name = tone.theme or _default_theme(reading, empty=not (objects or reading.people))
    _check_bare(reading, objects)
    people = reading.people or (0 if reading.seated else tone.people)
    setting = _setting(name, people, reading, objects)
    if setting:
        more, seated = place_settings(people, setting, objects, reading.excluded)
        objects, groups = [*objects, *more], [*groups, *seated]
    elif name and (not objects or (tone.setting and reading.vague and len(objects) < 6)):
        fewest, most = _FULL[full]
        if objects:
            fewest = most = min(most, len(objects) + 3)
        objects = fill(objects, THEMES[name], (fewest, most), reading.excluded, rng)
    table = plan_table(reading, THEMES[name] if name else None, len(objects), rng)
    objects = relations.place_supports(grow_carriers(objects))
    objects, doubts = relations.check_relations(objects)
    told = [*reading.warnings, *_warn_of_lengths(reading), *warn_of_stand_ins(objects), *doubts]
    warnings = tuple(dict.fromkeys(told))
    return ScenePlan(prompt, table, tuple(objects), tone.style, warnings, tuple(groups), full)


# ------------------------------------------------------------------------------------- checks


def _check_content(prompt: str, reading: Reading, theme: str | None) -> None:
    known = any(draft.category or draft.family for draft in reading.objects)
    if known or reading.table or theme or reading.people:
        return
    words = ", ".join(repr(draft.noun) for draft in reading.objects[:4])
    found = f" ({words} are unknown)" if words else ""
    raise InputError(
        f"There is no known object or kind of table in {prompt.strip()[:60]!r}{found}. Name "
        f"objects and the table they are on, for example {EXAMPLE}, or a kind of table: 'an office "
        "desk'."
    )


def _check_bare(reading: Reading, objects: Sequence[PlannedObject]) -> None:
    """Raise an error if the text leaves nothing on the table."""
    bare = any({"empty", "bare"} & set(noun.words) for noun in reading.table)
    if not objects and (reading.objects or bare):
        raise InputError(
            "The prompt leaves nothing on the table; a scene needs at least one object. Name one, "
            f"for example {EXAMPLE}."
        )


# -------------------------------------------------------------------------------------- themes


def _setting(
    name: str | None, people: int, reading: Reading, objects: Sequence[PlannedObject]
) -> PlaceSetting | None:
    """Return the place setting for several people, or None if the table has none."""
    if people < 2:
        return None
    setting = setting_of(THEMES[name], objects, people) if name else None
    if setting is not None or not reading.people:
        return setting
    own = {o.category for o in objects}
    food = any("edible" in CATEGORIES[key].roles for key in own & CATEGORIES.keys())
    games = len(own) > 1 and not food  # "a meeting for five with notebooks and pens"
    if not name and not reading.laid and (games or len(own) >= _OWN):
        reading.warnings.append(
            f"No places are laid for {people} people because the prompt does not describe a meal."
        )
        return None
    return setting_of(THEMES["dining"], objects, people)


def _default_theme(reading: Reading, *, empty: bool) -> str | None:
    """Return a table noun's default theme; "table" itself has one only if there are no objects."""
    heads = [noun.words[-1] for noun in reading.table if noun.kind == "table"]
    heads = [head for head in heads if empty or head not in ("table", "tabletop")]
    return next((DEFAULT_TABLES[head] for head in heads if head in DEFAULT_TABLES), None)


# ------------------------------------------------------------------------------------- objects


def _plan_objects(reading: Reading) -> tuple[list[PlannedObject], list[PlannedGroup]]:
    """Name the drafted objects and resolve references; return the objects and their groups."""
    drafts = [d for d in reading.objects if (d.category or d.noun) not in reading.banned]
    taken: Counter[str] = Counter()
    names: dict[int, str] = {}
    for draft in drafts:
        stem = draft.category or re.sub(r"[^a-z0-9]+", "_", draft.noun).strip("_") or "object"
        stem = "object" if stem == "table" else stem
        taken[stem] += 1
        names[id(draft)] = f"{stem}_{taken[stem]}"
    objects = [
        PlannedObject(
            names[id(d)], contents.full_name(d), d.category or GENERIC, dict(d.attributes),
            tuple(
                Relation(relations.kind(kind), names[id(to)] if isinstance(to, Draft) else to)
                for kind, to in d.relations
                if isinstance(to, str) or id(to) in names
            ),
            _size(d), "" if d.category else d.family,
        )
        for d in drafts
    ]  # fmt: skip
    groups = [
        PlannedGroup(
            "column" if g.kind == "row" and _is_along_side(g) else g.kind,
            tuple(names[id(d)] for d in g.members if id(d) in names),
            names.get(id(g.around)) if g.around else None, g.seat,
        )
        for g in reading.groupings
    ]  # fmt: skip
    return objects, [group for group in groups if len(group.members) + bool(group.around) > 1]


def _is_along_side(group: Grouping) -> bool:
    """Return whether a row is on the left or right of the table, and so runs from front to back."""
    places = [{kind for kind, to in d.relations if to == TABLE} for d in group.members]
    one_side = places[0] in ({"left_of"}, {"right_of"})
    return len(places) > 2 and one_side and all(place == places[0] for place in places)


_LENGTHS = 0.01, 0.6  # minimum and maximum length of an object on a table, metres


def _warn_of_lengths(reading: Reading) -> list[str]:
    return [
        f"A {d.noun} of {max(d.lengths):g} m does not belong on a table; it is "
        f"{np.clip(max(d.lengths), *_LENGTHS):g} m long."
        for d in reading.objects
        if d.lengths and not _LENGTHS[0] <= max(d.lengths) <= _LENGTHS[1]
    ]


def _size(draft: Draft) -> tuple[float, float, float] | None:
    """Return the extent from a length in the text, or from the family of an unknown noun."""
    if not draft.lengths:
        return None if draft.category else stand_in_size(draft.family, draft.attributes)
    known = CATEGORIES[draft.category].size if draft.category else stand_in_size(draft.family)
    factor = float(np.clip(max(draft.lengths), *_LENGTHS)) / max(known)
    return float(known[0] * factor), float(known[1] * factor), float(known[2] * factor)
