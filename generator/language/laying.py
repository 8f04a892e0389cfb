"""Tables laid for people: what each of them gets, and what stands in the middle."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

from ..scene import PlannedObject, Relation, RelationKind
from . import relations
from .parsing import lexicon
from .themes import Theme


@dataclass(frozen=True)
class Setting:
    """What is laid for each person: things and their relation to the first, and a centrepiece."""

    things: tuple[tuple[str, RelationKind | None], ...]
    center: str


SETTINGS: Mapping[str, Setting] = MappingProxyType(
    {
        "plate": Setting(
            (("plate", None), ("fork", "left_of"), ("knife", "right_of"), ("glass", "behind")),
            "candle",
        ),
        "teacup": Setting((("saucer", None), ("teacup", "on"), ("spoon", "right_of")), "teapot"),
    }
)
"""How tables are laid, by the thing of a theme that says so."""


def setting_of(theme: Theme, objects: Sequence[PlannedObject]) -> Setting | None:
    """Return how a table of ``theme`` is laid, unless the text has laid it already."""
    words = {o.noun for o in objects} | {o.category for o in objects}
    for thing, setting in SETTINGS.items():
        if any(entry.startswith(f"{thing} ") for entry in theme.things):
            return None if words & {thing, setting.things[0][0]} else setting
    return None


def place_settings(
    people: int, setting: Setting, objects: Sequence[PlannedObject], excluded: set[str]
) -> list[PlannedObject]:
    """Lay a table for each of at most four people; the fourth thing only for one or two."""
    taken = Counter(o.category for o in objects)
    out: list[PlannedObject] = []
    sides: tuple[RelationKind, ...] = ("in_front_of", "behind", "left_of", "right_of")
    for person, side in enumerate(sides[:people], start=1):
        first = ""
        for word, where in setting.things[: 4 if people < 3 else 3]:
            key = lexicon.category_of((word,))
            if key is None or key in excluded:
                continue
            if where and where in relations.OPPOSITE and side == "behind":  # as who sits there sees
                where = relations.kind(relations.OPPOSITE[where])
            name = f"{key}_{taken[key] + person}"
            first = first or name
            relation = Relation(side) if where is None or first == name else Relation(where, first)
            out.append(PlannedObject(name, word, key, {}, (relation,)))
    center = lexicon.category_of((setting.center,))
    if center and center not in excluded and not objects:
        relation = Relation("center")
        out.append(PlannedObject(f"{center}_1", setting.center, center, {}, (relation,)))
    return out
