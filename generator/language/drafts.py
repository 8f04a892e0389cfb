"""Intermediate results of reading a text: drafts of objects, the table, and warnings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from tabletop_objects import CATEGORIES

from ..errors import InputError
from ..scene import GroupKind
from .relations import body_size, fits, is_shallow
from .syntax.phrases.tree import Noun
from .vessel_sizes import cut_category, is_lit, largest_size, open_category

MAX_OBJECTS = 40
"""Maximum number of objects on any table."""


@dataclass(eq=False)
class Draft:
    """An object during parsing; ``relations`` pairs each kind with a target (Draft or "table")."""

    noun: str
    category: str | None
    attributes: dict[str, str]
    lengths: tuple[float, ...] = ()
    family: str = ""
    relations: list[tuple[str, Draft | str]] = field(default_factory=list)
    provisional: bool = False
    implied: bool = False
    stacked_under: Draft | None = None
    position: str | None = None
    contents: str = ""
    told: bool = False
    placed: bool = False  # the text states the object's position
    counted: bool = False  # the object is introduced by an article or a number
    also: str = ""  # alternative noun: the tube of a "tube of paint"

    def relate(self, kind: str, target: Draft | str) -> None:
        """Add a relation; it replaces any relation that was only assumed."""
        if self.provisional:
            self.relations.clear()
            self.provisional = False
        if (kind, target) not in self.relations:
            self.relations.append((kind, target))


Group = list[Draft]


@dataclass(frozen=True, eq=False)
class Grouping:
    """Objects arranged as a group, such as a row, a heap or a circle around something."""

    kind: GroupKind
    members: tuple[Draft, ...]
    around: Draft | None = None
    seat: tuple[int, int] | None = None


@dataclass(eq=False)
class Reading:
    """Everything that has been read from the text so far."""

    objects: list[Draft] = field(default_factory=list)
    table: list[Noun] = field(default_factory=list)
    table_parts: list[Noun] = field(default_factory=list)
    excluded: set[str] = field(default_factory=set)
    banned: set[str] = field(default_factory=set)
    groupings: list[Grouping] = field(default_factory=list)
    people: int = 0  # number of seats to lay with the theme's setting, or 0 if not stated
    seated: bool = False  # the text states what each person gets
    laid: bool = False  # the people belong to the table: "a table for four"
    warnings: list[str] = field(default_factory=list)
    lost: list[str] = field(default_factory=list)  # phrases that were not understood
    vague: bool = False

    def number(self, noun: Noun, rng: np.random.Generator) -> int:
        """Return the number of objects in a noun phrase; vague amounts are drawn at random.

        Raises:
            InputError: The number is not a positive integer, or exceeds the capacity of a table.
        """
        if noun.count is not None:
            if noun.count < 1 or noun.count % 1 > 0:
                raise InputError(
                    f"{phrase_text(noun)!r}: the number of objects must be a whole number of at "
                    "least 1."
                )
            if noun.count > MAX_OBJECTS - len(self.objects):
                raise InputError(
                    f"{phrase_text(noun)!r} is too many: a table holds at most {MAX_OBJECTS} "
                    "objects in total. Use fewer."
                )
            return int(noun.count)
        if noun.amount is None and not noun.plural:
            return 1
        low, high = noun.amount or (2, 3)
        if noun.amount == (2, 3) and not noun.plural:  # "some bread"
            return 1
        return int(rng.integers(low, high + 1))

    def add(
        self,
        noun: str,
        category: str | None,
        attributes: dict[str, str],
        *,
        lengths: tuple[float, ...] = (),
        family: str = "",
        implied: bool = False,
        position: str | None = None,
    ) -> Draft:
        """Add one object.

        Raises:
            InputError: The table is full.
        """
        if len(self.objects) >= MAX_OBJECTS:
            raise InputError(
                f"The prompt describes more than {MAX_OBJECTS} objects, the maximum of a table. "
                "Use fewer."
            )
        kept = {k: v for k, v in attributes.items() if k != "stack"}
        self.objects.append(
            Draft(noun, category, kept, lengths, family, implied=implied, position=position)
        )
        return self.objects[-1]


def phrase_text(noun: Noun) -> str:
    """Return a noun phrase approximately as it was written."""
    amount = f"{noun.count:g} " if noun.count is not None else ""
    return amount + " ".join(noun.words)


def shares(kind: str, group: Group, targets: Sequence[Draft | str]) -> bool:
    """Return whether "an apple and a pear on a plate" may mean that the apple is on the plate too.

    For relations other than "on" and "in", this is possible unless the first object already has a
    relation.
    """
    target = targets[0]
    if isinstance(target, str) or kind not in ("on", "in"):
        return not any(d.relations for d in group)
    if any(not d.category for d in (group[0], target)):
        return False
    outer = CATEGORIES[open_category(str(target.category))]
    room = largest_size(outer.key)
    return all(
        fits(kind, body_size(str(d.category)), room, outer.container) and not d.relations
        for d in group
    )


_CARRIERS = frozenset(
    {"basket", "bowl", "open_box", "pot", "tray", "tool_caddy", "empty_pencil_holder",
     "open_suitcase", "open_lunch_box", "open_jar", "empty_vase", "crate"}
)  # fmt: skip
"""Categories of objects that are made to hold others: "a basket with pears" contains them."""


def assumed_relation(draft: Draft, owner: Draft, held: bool) -> str:
    """Return how an object attached to an owner is placed by default: "in", "on" or "next_to"."""
    if owner.category is None:
        return "in" if held else "next_to"
    if is_lit(draft.category or "", owner.category):
        return "in"
    outer = CATEGORIES[open_category(owner.category, owner.noun, draft.category or "")]
    if draft.category is None:
        return "next_to" if not held else "in" if outer.container else "on"
    inner = body_size(cut_category(draft.category, outer.key, 0))
    if outer.holder is not None and outer.holder.takes(CATEGORIES[draft.category].size):
        return "in"
    open_to = held or min(inner) < 0.06 or outer.key in _CARRIERS
    room = largest_size(outer.key)
    laid = is_shallow(room) and "support" in outer.roles
    if fits("in", inner, room, outer.container) and open_to and not laid:
        return "in"
    if "support" in outer.roles and (held or max(inner[:2]) < 0.8 * min(room[:2])):
        return "on"
    return "next_to"
