"""Noun phrases that name objects, either existing or new ones."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from tabletop_objects import CATEGORIES

from ...scene import TABLE
from ..drafts import MAX_OBJECTS, Draft, Group
from ..lexicon import singular
from ..syntax.phrases.tree import (
    VARIED,
    Arranged,
    Description,
    Location,
    Noun,
    Post,
)
from ..syntax.text import function_words as fw
from ..vessel_sizes import LOOSE
from ..vocabulary import MEANT_WITH
from .references import find_referred
from .relations import Relater

_ONE_PIECE = frozenset(("pancakes", "paper_stack", "napkins", "playing_cards", "sticky_notes"))
"""Categories that already are a stack or a heap."""

_HEAPED = frozenset(("pancakes", "paper_stack"))
"""Categories of which several form a heap without being called one: "three pancakes"."""

_SEATS = frozenset(
    {"chair", "stool", "armchair", "sofa", "couch", "bench", "seat", "bed", "barstool"}
)
"""Furniture for sitting at a table."""

_FOOD = frozenset({"food", "fruit", "vegetable", "snack"})

_SIDE_OF = {"left": "left_of", "right": "right_of"}

_COLORFUL = ("colored", "coloured", "colorful", "colourful")


@dataclass(eq=False)
class CountReader(Relater, ABC):
    """Keeps track of the sizes of groups.

    ``_uncounted`` is the last group whose count the text has not yet stated; ``_halves`` are the
    attributes stated for one half of it.
    """

    _uncounted: Group = field(default_factory=list)
    _halves: list[Mapping[str, str]] = field(default_factory=list)
    _said: Sequence[Post] = ()  # predicate of the current clause

    def _recount(self, count: int) -> None:
        """Change the number of objects in the last uncounted group."""
        group = self._uncounted
        if not group or not 1 <= count <= MAX_OBJECTS:
            return
        like = group[-1]
        while len(group) < count:
            copy = self.reading.add(like.noun, like.category, like.attributes, family=like.family)
            copy.relations = list(like.relations)
            group.append(copy)
        gone = [
            draft for draft in group[count:] if all(d is not draft for d in self._find_related())
        ]
        self.reading.objects[:] = [d for d in self.reading.objects if all(d is not g for g in gone)]
        del group[count:]
        for attributes in self._halves:
            for draft in group[: len(group) // 2]:
                draft.attributes.update(attributes)

    def _find_related(self) -> Group:
        """Return the objects that are the targets of relations."""
        return [to for d in self.reading.objects for _, to in d.relations if isinstance(to, Draft)]

    def _halve(self, group: Group, said: Sequence[Post]) -> Group:
        """Return half of a group, and remember its attributes in case the group's count changes."""
        if group is self._uncounted:
            posts = [post for post in said if isinstance(post, Description) and post.each]
            self._halves = [post.each[0] for post in posts]
        half = group[: max(1, len(group) // 2)]
        for draft in half:
            draft.told = True
        return half

    def _rest(self) -> Group:
        """Return the members of the last group that are not yet mentioned, if others have been."""
        mentioned = self._context.mentioned
        alone = [group[0] for group in mentioned if len(group) == 1]
        several = [group for group in mentioned if len(group) > 1]
        split = [g for g in several if any(d.told or d in alone for d in g)] or several
        return [d for group in split[-1:] for d in group if not d.told and d not in alone]

    def _count_claimed(self, claimed: Group, count: int) -> Group | None:
        """Return the group that "all mugs" refers to, with the count stated after these words.

        Returns None if the text names other objects, or only one although the group already has
        positions.
        """
        group = self._uncounted
        if not claimed or claimed[0] not in group:
            return None
        placed = any(draft.relations or draft in self._find_related() for draft in group)
        if count == 1 and placed:
            return None
        self._recount(count)
        for draft in group:
            draft.implied = False
        return group


@dataclass(eq=False)
class ThingReader(CountReader, ABC):
    """Finds the objects that a noun phrase refers to."""

    _fresh: Group = field(default_factory=list)  # the objects introduced last
    _started: int = 0  # how many objects the previous sentences have named

    def _thing(self, noun: Noun) -> Group:
        """Return the objects that a noun phrase refers to, either existing or new ones."""
        if noun.kind == "collective":
            return self._collective(noun)
        known = any(d.category == noun.category for d in self.reading.objects if noun.category)
        arranged = noun.definite and not known and noun.head in fw.GROUPS
        if arranged and (found := self._arranged_as(fw.GROUPS[noun.head])):
            return found
        if noun.definite or noun.other or noun.each:
            known = self.reading.objects[self._seated or 0 :]
            found = find_referred(noun, known, self._context.subject)
            if noun.each and not found:
                found = [d for d in known if d.noun == noun.head]
            if found and not (noun.other and not noun.definite):
                return found
        bare = not noun.determined and noun.kind == "thing" and not noun.variants
        placed = any(isinstance(post, Location | Arranged) for post in noun.post)
        if bare and placed and self._started:
            known = [d for d in self.reading.objects[: self._started] if d.counted]
            if found := find_referred(replace(noun, definite=True), known):
                return found
        return self._introduce(noun)

    def _collective(self, noun: Noun) -> Group:
        if noun.definite and noun.count == 2:
            return []  # "both tools"
        if noun.definite and (known := self._find_collected(noun)):
            return known
        members = [m for m in noun.members if m not in self.reading.excluded]
        if noun.head.endswith(("setting", "settings")) and (noun.count or 1) > 1:
            self.reading.people = self.reading.people or int(noun.count or 1)
            return []
        self.reading.vague = self.reading.vague or not noun.head.startswith("salt")
        return [
            self.reading.add(category.replace("_", " "), category, noun.attributes)
            for category in members
        ]

    def _find_collected(self, noun: Noun) -> Group:
        """Return the existing objects that "the cutlery" or "all the fruit" refers to."""
        food = singular(noun.head.split()[-1]) in _FOOD
        return [
            d for d in self.reading.objects
            if d.category in noun.members
            or (food and d.category is not None and "edible" in CATEGORIES[d.category].roles)
        ]  # fmt: skip

    def _introduce(self, noun: Noun) -> Group:
        if noun.category is None and noun.head.split()[-1] in _SEATS:
            self.reading.warnings.append(
                f"The {noun.head} stands at the table, not on it; it is left out."
            )
            return []
        claimed = [d for d in self.reading.objects if d.implied and _claims(d, noun)]
        if claimed and noun.count and not (noun.definite or noun.variants or noun.each):
            counted = self._count_claimed(claimed, int(noun.count))
            if counted is not None:
                for draft in counted:
                    draft.attributes.update(noun.attributes)
                return counted
        if claimed and not noun.definite and (noun.count or 1) == 1 and not noun.plural:
            claimed[0].implied = False
            claimed[0].attributes.update(noun.attributes)
            return claimed[:1]
        there = {draft.category for draft in self.reading.objects}
        loose = noun.category in LOOSE.values()  # crisps in a bowl, whatever other objects exist
        meant = () if loose else MEANT_WITH.get(singular(noun.head), ())
        category = next((key for other, key in meant if other in there), noun.category)
        head = noun.head if category == noun.category else str(category).replace("_", " ")
        if category == "playing_cards" and singular(noun.head) == "card" and (noun.count or 1) > 1:
            category = "playing_card"  # "five cards" do not form a deck
            noun = replace(noun, category=category)
        single = noun.category in _ONE_PIECE and (
            noun.arrangement is not None or noun.category in _HEAPED
        )
        count = 1 if single else len(noun.variants) or self.reading.number(noun, self.rng)
        if claimed and not noun.definite and count > 1 and not noun.variants:
            claimed[0].implied = False  # "weigh the red pepper: three peppers ..."
            count -= 1
        else:
            claimed = []
        first = noun.each and count == 1 and noun.count is None  # "each plate" of a table for six
        if (noun.seated or first) and self._seated is None:
            count *= max(self.reading.people, self._guests, 1)
        group = [
            self.reading.add(
                head, category,
                {**noun.attributes, **(noun.variants[k] if noun.variants else {})},
                lengths=noun.lengths, family=noun.family, implied=noun.definite,
                position=noun.position,
            )
            for k in range(count)
        ]  # fmt: skip
        side = _SIDE_OF.get(noun.position or "") if noun.definite else None
        for draft in group if side else ():  # "the left plate", which has not been described
            draft.relate(str(side), TABLE)
        group = [*claimed, *group]
        self._fresh = group
        for draft in group:
            draft.counted = noun.determined
        if noun.count is None and noun.amount is None and len(group) > 1 and not noun.variants:
            self._uncounted = group
        if noun.arrangement is not None:
            self._arrange(Arranged(noun.arrangement), group)
        if noun.attributes.get("state") in _COLORFUL and "color" not in noun.attributes:
            self._post(Description(VARIED["color"]), group, noun)
        return group

    def _arranged_as(self, kind: str) -> Group:
        """Return the objects in the last arrangement of a kind: "the pyramid", "this circle"."""
        for grouping in reversed(self.reading.groupings):
            members = list(grouping.members)
            if grouping.kind == kind and all(d not in self._context.subject for d in members):
                return members
        stacked = [d for d in self.reading.objects if d.stacked_under is not None]
        above = {id(d.stacked_under) for d in stacked}
        bottoms = [d for d in stacked if id(d) not in above and d not in self._context.subject]
        return bottoms[-1:] if kind in ("stack", "heap") else []

    @abstractmethod
    def _posts(self, noun: Noun, group: Group) -> None:
        """Interpret everything that follows a noun phrase."""

    @abstractmethod
    def _post(self, post: Post, group: Group, noun: Noun | None) -> None:
        """Interpret one modifier of a group."""


def _claims(draft: Draft, noun: Noun) -> bool:
    alike = draft.category == noun.category and (noun.category or draft.noun == noun.head)
    color = draft.attributes.get("color")
    clash = color is not None and noun.attributes.get("color", color) != color
    return bool(alike) and not clash
