"""Objects of a theme, and place settings, for tables that the text does not fully describe."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np

from tabletop_objects import CATEGORIES
from tabletop_objects.kit.surfaces import SIZE_FACTORS

from ..errors import InputError, choices
from ..scene import OutlineKind, PlannedGroup, PlannedObject, PlannedTable, Relation, RelationKind
from . import lexicon, relations
from .drafts import MAX_OBJECTS, Reading
from .furniture import plan_table
from .themes import THEMES, Theme

Thing = tuple[str | None, RelationKind | None, str | None]
"""A category, a relation and the related category; the latter two are None if there is none."""


def fill(
    objects: Sequence[PlannedObject],
    theme: Theme,
    count: tuple[int, int],
    excluded: Collection[str],
    rng: np.random.Generator,
    extras: Sequence[Thing] = (),
) -> list[PlannedObject]:
    """Add objects of a theme with their relations until the table has enough objects.

    ``count`` is the minimum and maximum number of objects; the number is drawn from ``rng``, and is
    smaller if the theme is exhausted. ``extras`` are drawn like those objects of the theme that are
    not in its core.
    """
    things = [thing(entry) for entry in theme.things]
    core = [] if objects else things[: theme.core]
    others = [*(t for t in things if t not in core), *extras]
    order = [others[i] for i in rng.permutation(len(others))]
    low, high = count
    enough = low if low == high else int(rng.integers(low, high + 1))
    present = Counter(o.category for o in objects)
    out = list(objects)
    for key, kind, to in [*core, *order]:
        if len(out) >= enough:
            break
        if key is None or key in excluded or present[key]:
            continue
        goal = to if to == "table" else next((o.name for o in out if o.category == to), None)
        if kind in ("on", "in") and goal is None:
            continue
        relation = (Relation(kind, goal),) if kind and goal else ()
        out.append(PlannedObject(f"{key}_1", key.replace("_", " "), key, {}, relation))
        present[key] += 1
    return out


HABITS: tuple[tuple[str, RelationKind, tuple[str, ...]], ...] = (
    ("keyboard", "in_front_of", ("monitor",)),
    ("wrist_rest", "in_front_of", ("keyboard",)),
    ("computer_mouse", "right_of", ("wrist_rest", "keyboard", "laptop")),
)
"""Usual positions of objects if the text does not state any."""


def relate_by_habit(
    objects: Sequence[PlannedObject], groups: Sequence[PlannedGroup]
) -> tuple[list[PlannedObject], list[PlannedGroup]]:
    """Return the objects and groups of a text with the usual relations added.

    Only objects without relations get one. If there are several monitors, they stand side by side.
    """
    by_kind: dict[str, list[PlannedObject]] = {}
    for planned in objects:
        by_kind.setdefault(planned.category, []).append(planned)
    related = {r.target for o in objects for r in o.relations}
    found = {o.name: o for o in objects}
    for key, kind, targets in HABITS:
        to = next((by_kind[t][0].name for t in targets if t in by_kind), None)
        for planned in by_kind.get(key, [])[:1]:
            if to is not None and not planned.relations and planned.name not in related:
                found[planned.name] = replace(planned, relations=(Relation(kind, to),))
    screens = [o.name for o in by_kind.get("monitor", []) if not o.relations]
    grouped = {name for group in groups for name in group.members}
    rows = [PlannedGroup("row", tuple(screens))] if len(screens) > 1 else []
    return list(found.values()), [*groups, *(g for g in rows if not grouped & set(g.members))]


def thing(entry: str) -> Thing:
    """Parse "mug right_of laptop" into category keys, with None for nouns not in the catalogue."""
    words = entry.split()
    at = next((i for i, w in enumerate(words) if w in relations.KINDS), len(words))
    key = lexicon.category_of(tuple(words[:at]))
    if at == len(words):
        return key, None, None
    to = words[at + 1 :]
    return (
        key,
        relations.kind(words[at]),
        ("table" if to == ["table"] else lexicon.category_of(tuple(to))),
    )


def read_need(phrase: str) -> PlannedObject | None:
    """Parse a needed object, with an optional size and a name; return None if it is unknown.

    "small cucumber" is the category cucumber with size "small".
    """
    size, _, rest = phrase.partition(" ")
    noun = rest if size in SIZE_FACTORS and rest else phrase
    key = lexicon.category_of(tuple(noun.split()))
    attributes = {} if noun == phrase else {"size": size}
    return None if key is None else PlannedObject(f"{key}_1", noun, key, attributes)


def supply(
    objects: Sequence[PlannedObject],
    theme: str,
    needs: Sequence[Sequence[str]],
    rng: np.random.Generator,
) -> list[PlannedObject]:
    """Add one object for each need, drawn from the need's options that are not yet present.

    Objects of the theme are preferred. If all objects of a need are already present, nothing is
    added.
    """
    listed = {thing(entry)[0] for entry in THEMES[theme].things}
    out = list(objects)
    for phrases in needs:
        there = {o.noun for o in out}
        known = (read_need(phrase) for phrase in phrases)
        free = [o for o in known if o is not None and o.noun not in there]
        of_theme = [
            o for o in free if o.category in listed or theme in CATEGORIES[o.category].themes
        ]
        fit = of_theme or free
        if fit:
            drawn = fit[int(rng.integers(len(fit)))]
            same = sum(o.category == drawn.category for o in out)
            out.append(replace(drawn, name=f"{drawn.category}_{same + 1}"))
    return out


def furnish(
    theme: str,
    count: int,
    rng: np.random.Generator,
    outline: OutlineKind | None = None,
    needs: Sequence[Sequence[str]] = (),
) -> tuple[PlannedTable, list[PlannedObject]]:
    """Choose a table of a theme and ``count`` objects for it at random, without a text.

    The objects are those in the core of the theme, then others that the theme lists or that the
    catalogue assigns to it. There are fewer if the theme is exhausted. If ``outline`` is None, a
    usual shape is drawn. The last objects fill the ``needs`` (see ``supply``), after at least one
    other object.

    Raises:
        InputError: The theme does not exist.
    """
    if theme not in THEMES:
        raise InputError(f"Unknown theme {theme!r}." + choices(theme, THEMES))
    found = THEMES[theme]
    listed = {thing(entry)[0] for entry in found.things}
    extras: list[Thing] = [
        (key, None, None)
        for key, category in CATEGORIES.items()
        if category.common and theme in category.themes and key not in listed
    ]
    own = count if not needs else max(count - len(needs), 1)
    objects = supply(fill((), found, (own, own), (), rng, extras), theme, needs, rng)
    shaped = found if outline is None else replace(found, outlines=(outline,))
    return plan_table(Reading(), shaped, len(objects), rng), objects


@dataclass(frozen=True)
class PlaceSetting:
    """One person's place setting: objects, their relations to the first one, and a centrepiece."""

    things: tuple[tuple[str, RelationKind | None], ...]
    center: str


SETTINGS: Mapping[str, PlaceSetting] = MappingProxyType(
    {
        "plate": PlaceSetting(
            (("plate", None), ("fork", "left_of"), ("knife", "right_of"), ("glass", "behind")),
            "candle",
        ),
        "teacup": PlaceSetting(
            (("saucer", None), ("teacup", "on"), ("spoon", "right_of")), "teapot"
        ),
    }
)
"""Place settings, by the object in a theme that implies them."""


def setting_of(theme: Theme, objects: Sequence[PlannedObject], people: int) -> PlaceSetting | None:
    """Return the place setting of a ``theme``, or None if the text describes its own."""
    there = Counter(o.category for o in objects)
    for thing, setting in SETTINGS.items():
        if any(entry.startswith(f"{thing} ") for entry in theme.things):
            own = any(there[key] >= people for key in (thing, "fork", "knife", "spoon"))
            return None if own else setting
    return None


def place_settings(
    people: int, setting: PlaceSetting, objects: Sequence[PlannedObject], excluded: set[str]
) -> tuple[list[PlannedObject], list[PlannedGroup]]:
    """Lay a table for a number of people; return the objects and the group at each seat.

    If the table would be too full, each person gets only the setting's first objects.
    """
    taken = Counter(o.category for o in objects)
    room = MAX_OBJECTS - len(objects) - 1
    share = min(len(setting.things), room // people)
    out: list[PlannedObject] = []
    groups: list[PlannedGroup] = []
    for person in range(people):
        names: list[str] = []
        for word, where in setting.things[:share]:
            key = lexicon.category_of((word,))
            if key is None or key in excluded or taken[key] >= people:
                continue
            name = f"{key}_{taken[key] + person + 1}"
            relation = (Relation(where, names[0]),) if where and names else ()
            names.append(name)
            out.append(PlannedObject(name, word, key, {}, relation))
        on_others = {o.name for o in out if any(r.kind == "on" for r in o.relations)}
        members = tuple(name for name in names if name not in on_others)
        groups.append(PlannedGroup("setting", members, seat=(person, people)))
    center = lexicon.category_of((setting.center,))
    if center and center not in excluded and not objects:
        relation = (Relation("center"),)
        out.append(PlannedObject(f"{center}_1", setting.center, center, {}, relation))
    return out, groups
