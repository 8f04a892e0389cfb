"""The plan of a scene described by a prompt (Fig. 12)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal, get_args

from tabletop_objects.values import VECTOR, frozen_array

from ..errors import InputError, choices

TABLE = "table"
"""The table's name, both as an instance and as a support."""

RelationKind = Literal[
    "left_of", "right_of", "in_front_of", "behind", "on", "in", "next_to", "center", "edge"
]
GroupKind = Literal[
    "row", "column", "circle", "fan", "heap", "pyramid", "scatter", "grid", "group", "setting"
]
Density = Literal["sparse", "normal", "dense"]
"""How full a table is: the spacing of objects, and their number if only a theme is given."""

OutlineKind = Literal["rectangle", "square", "round", "oval", "triangle", "slatted"]


@dataclass(frozen=True)
class Relation:
    """A planned object's relation: its ``kind`` and its ``target``, an object name or "table"."""

    kind: RelationKind
    target: str = TABLE


@dataclass(frozen=True)
class PlannedObject:
    """An object requested by a prompt.

    ``name`` is unique ("mug_1"); ``noun`` is the word used; ``category`` is a catalogue key, or
    "generic" when no category fits. ``attributes`` maps "color", "material", "size" ("small",
    "large") and "state" to words. ``size`` is the extent in metres if the text specifies one.
    ``family`` is the kind of object that represents a "generic" one ("appliance"), if known.
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
    """The table requested by a prompt. ``size`` is (length x, width y, height z) in metres."""

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
    """Objects that a prompt arranges as a group; stacks are described by "on" relations instead.

    Attributes:
        kind: the arrangement; "setting" is a place setting for one person.
        members: names of planned objects, in order.
        around: the object at the centre of a circle, if any.
        seat: for a setting, the seat's number and the total number of seats.
    """

    kind: GroupKind
    members: tuple[str, ...]
    around: str | None = None
    seat: tuple[int, int] | None = None


@dataclass(frozen=True)
class ScenePlan:
    """The plan of a scene (Sec. 3, Fig. 8): its table, objects and style, without coordinates."""

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
            raise InputError(
                f"Planned names must be unique and must not be {TABLE!r}, got {names}."
            )
        for group in self.groups:
            strange = {*group.members, *([group.around] if group.around else [])} - {*names}
            if strange or group.kind not in get_args(GroupKind):
                raise InputError(
                    f"The plan's {group.kind!r} of {', '.join(group.members)} refers to objects "
                    f"that are not in the plan: {', '.join(sorted(strange)) or group.kind}."
                )
        on = {p.name: [r.target for r in p.relations if r.kind in ("on", "in")]
              for p in self.objects}  # fmt: skip
        for planned in self.objects:
            for target in (relation.target for relation in planned.relations):
                if target == planned.name or target not in (*names, TABLE):
                    raise InputError(
                        f"{planned.name!r} is related to {target!r}, which is not another object "
                        "of the plan." + choices(target, names)
                    )
            below = set(on[planned.name])
            while (deeper := below.union(*(on.get(name, ()) for name in below))) != below:
                below = deeper
            if planned.name in below:
                raise InputError(f"{planned.name!r} stands on itself through {sorted(below)}.")


def _check_extent(size: tuple[float, float, float], what: str) -> None:
    if (frozen_array(size, *VECTOR, f"{what}.size") <= 0).any():
        raise InputError(f"{what}: the size must be positive, in metres, got {tuple(size)}.")
