"""What a text asks for (Fig. 12)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal, get_args

from tabletop_objects.values import VECTOR, frozen_array

from ..errors import InputError, choices

TABLE = "table"
"""Name of the table, as an instance and as a support."""

RelationKind = Literal[
    "left_of", "right_of", "in_front_of", "behind", "on", "in", "next_to", "center", "edge"
]
GroupKind = Literal[
    "row", "column", "circle", "fan", "heap", "pyramid", "scatter", "grid", "group", "setting"
]
Density = Literal["sparse", "normal", "dense"]
"""How full a table is: how far things stand apart, and how many a theme alone puts there."""

OutlineKind = Literal["rectangle", "square", "round", "oval", "triangle", "slatted"]


@dataclass(frozen=True)
class Relation:
    """Where a planned object goes: ``kind`` relative to ``target`` (an object name or "table")."""

    kind: RelationKind
    target: str = TABLE


@dataclass(frozen=True)
class PlannedObject:
    """One object a text asks for.

    ``name`` is unique ("mug_1"); ``noun`` is the word used; ``category`` is a catalogue key, or
    "generic" when no category fits. ``attributes`` maps "color", "material", "size" ("small",
    "large") and "state" to words. ``size`` is the extent in metres if the text fixed one.
    ``family`` is the kind of thing that stands for a "generic" object ("appliance"), if known.
    """

    name: str
    noun: str
    category: str
    attributes: Mapping[str, str] = field(default_factory=dict[str, str])
    relations: tuple[Relation, ...] = ()
    size: tuple[float, float, float] | None = None
    family: str = ""

    def __post_init__(self) -> None:
        if self.size is not None:
            _check_extent(self.size, f"PlannedObject {self.name!r}")
        for relation in self.relations:
            if relation.kind not in get_args(RelationKind):
                raise InputError(
                    f"{self.name!r} has an unknown relation {relation.kind!r}."
                    + choices(str(relation.kind), get_args(RelationKind))
                )


@dataclass(frozen=True)
class PlannedTable:
    """The table a text asks for. ``size`` is (length x, width y, height z) in metres."""

    outline: OutlineKind = "rectangle"
    material: str = "oak"
    legs: str = "straight"
    size: tuple[float, float, float] = (1.2, 0.7, 0.74)
    color: str | None = None

    def __post_init__(self) -> None:
        _check_extent(self.size, "PlannedTable")
        if self.outline not in get_args(OutlineKind):
            raise InputError(
                f"Unknown table outline {self.outline!r}."
                + choices(str(self.outline), get_args(OutlineKind))
            )


@dataclass(frozen=True)
class PlannedGroup:
    """Things that a text asks to be arranged as one; stacks are relations ("on").

    Attributes:
        kind: how they are arranged; "setting" is what is laid for one person.
        members: names of planned objects, in order.
        around: the object that a circle is laid around, if any.
        seat: of a setting, the number of the seat and how many there are.
    """

    kind: GroupKind
    members: tuple[str, ...]
    around: str | None = None
    seat: tuple[int, int] | None = None


@dataclass(frozen=True)
class ScenePlan:
    """What a text asks for (Sec. 3, Fig. 8): the table, its objects, a style; no coordinates."""

    prompt: str
    table: PlannedTable
    objects: tuple[PlannedObject, ...]
    style: str = "plain"
    warnings: tuple[str, ...] = ()
    groups: tuple[PlannedGroup, ...] = ()
    density: Density = "normal"

    def __post_init__(self) -> None:
        if self.density not in get_args(Density):
            raise InputError(
                f"Unknown density {self.density!r}." + choices(str(self.density), get_args(Density))
            )
        names = [planned.name for planned in self.objects]
        if len(set(names)) < len(names) or TABLE in names:
            raise InputError(f"Planned names must be unique and not {TABLE!r}: {names}.")
        for group in self.groups:
            strange = {*group.members, *([group.around] if group.around else [])} - {*names}
            if strange or group.kind not in get_args(GroupKind):
                raise InputError(
                    f"The plan's {group.kind!r} of {', '.join(group.members)} names what is not "
                    f"planned: {', '.join(sorted(strange)) or group.kind}."
                )
        on = {p.name: [r.target for r in p.relations if r.kind in ("on", "in")]
              for p in self.objects}  # fmt: skip
        for planned in self.objects:
            for target in (relation.target for relation in planned.relations):
                if target == planned.name or target not in (*names, TABLE):
                    raise InputError(
                        f"{planned.name!r} is related to {target!r}." + choices(target, names)
                    )
            below = set(on[planned.name])
            while (deeper := below.union(*(on.get(name, ()) for name in below))) != below:
                below = deeper
            if planned.name in below:
                raise InputError(f"{planned.name!r} stands on itself, by way of {sorted(below)}.")


def _check_extent(size: tuple[float, float, float], what: str) -> None:
    if (frozen_array(size, *VECTOR, f"{what}.size") <= 0).any():
        raise InputError(f"{what}: size must be positive metres, got {tuple(size)}.")
