"""Tables laid for people: what each of them gets, and what stands in the middle."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

from ..scene import PlannedGroup, PlannedObject, Relation, RelationKind
from .drafts import MAX_OBJECTS
from .parsing import lexicon
from .themes import Theme


@dataclass(frozen=True)
class PlaceSetting:
    """What is laid for each person: things and their relation to the first, and a centrepiece."""

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
"""How tables are laid, by the thing of a theme that says so."""


def setting_of(theme: Theme, objects: Sequence[PlannedObject], people: int) -> PlaceSetting | None:
    """Return how a table of ``theme`` is laid for people, unless the text has laid it already."""
    there = Counter(o.category for o in objects)
    for thing, setting in SETTINGS.items():
        if any(entry.startswith(f"{thing} ") for entry in theme.things):
            own = any(there[key] >= people for key in (thing, "fork", "knife", "spoon"))
            return None if own else setting
    return None


def place_settings(
    people: int, setting: PlaceSetting, objects: Sequence[PlannedObject], excluded: set[str]
) -> tuple[list[PlannedObject], list[PlannedGroup]]:
    """Lay a table for so many people; return what is laid, and what belongs to each seat.

    Where a table for all of them would be too full, each gets the first three things only.
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
