"""Tables that the text says are set: place settings, and shared objects in the middle."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from ...scene import TABLE
from ..drafts import Group, Grouping
from ..syntax.phrases.tree import EVERYONE, Carry, Clause, Location, Noun, Post, Zone
from .lists import ListInterpreter, is_supported
from .references import Context, Target

_SOME_PEOPLE = 4
"""Number of people that "everyone" means if the text does not state it."""


@dataclass(eq=False)
class SeatReader(ListInterpreter, ABC):
    """Reads place settings."""

    def _people(self, clause: Clause) -> None:
        """Interpret a text such as "set the table for four: a plate, a fork on the left"."""
        loose = ("setting", "vague", "table", "collective", "abstract", "adjective", "title")
        people = clause.people
        if people == EVERYONE:
            people = self.reading.people or self._guests or _SOME_PEOPLE
        self._guests = people
        if all(noun.kind in loose for noun in clause.subjects):
            self._lay_table(clause, people)
            return
        heads = [noun.head for noun in clause.subjects if noun.kind == "thing" and noun.post]
        laid = any(noun.category in _TABLEWARE for noun in clause.subjects)
        self.reading.seated = self.reading.seated or laid
        central = any(map(_is_central, clause.subjects))
        counted = all(noun.count is not None for noun in clause.subjects)
        common = not laid and central and counted  # "poker for two: a deck in the middle, ..."
        once = common or len(heads) > len(set(heads))  # "a plate on either end"
        if once and clause.people != EVERYONE:
            self._list(clause.subjects, None)
            return
        shared = [noun for noun in clause.subjects if _is_central(noun)]
        own = [noun for noun in clause.subjects if noun not in shared]
        if clause.people == EVERYONE:
            self.reading.people = 0
        for noun in own:  # "cups and saucers": one for each person
            if noun.plural and noun.count is None and noun.amount is None:
                noun.count, noun.plural = 1.0, False
        self._lay(people, lambda: self._list(own, None))
        self._list(shared, None)

    def _lay_table(self, clause: Clause, people: int) -> None:
        """Interpret "a table set for two: a plate and a fork" as one of each per person."""
        tables = [noun for noun in clause.subjects if noun.kind == "table"]
        self.reading.laid = self.reading.laid or bool(tables) or not clause.subjects
        brought = [p for noun in tables for p in noun.post if isinstance(p, Carry)]
        for noun in tables:
            self._table(replace(noun, post=[p for p in noun.post if p not in brought]))
        if not self._lay_brought([item for post in brought for item in post.items], people):
            self.reading.people = self.reading.people or people
            for post in brought:
                self._carry(post, TABLE, None)
        for post in clause.predicate:
            self._predicate(post, [], [TABLE], True)

    def _lay_brought(self, items: Sequence[Noun], people: int) -> bool:
        """Lay "with a plate and a fork" for each person; return whether it is a place setting."""
        own = [item for item in items if item.category in _TABLEWARE]
        first = any(item.category in _FIRST for item in own)
        if people < 2 or not first or not all(map(_is_one_each, own)):
            return False
        self._people(Clause(own, people=people))
        self._list([item for item in items if item not in own], TABLE)
        return True

    def _lay(self, people: int, read: Callable[[], Sequence[Target]]) -> None:
        """Lay the objects from ``read`` for each person; "left" is relative to the first object."""
        for seat in range(people):
            start = len(self.reading.objects)
            context, self._context = self._context, Context()
            self._seated, self._side = start, None
            read()
            self._seated, self._context = None, context
            members = self.reading.objects[start:]
            saucer = next((d for d in members if d.category == "saucer"), None)
            for draft in members:
                if saucer is not None and draft.category in ("mug", "teacup"):
                    draft.relate("on", saucer)
            for draft in members[1:]:
                if not draft.relations:
                    draft.relations.append(("right_of", members[0]))
            standing = tuple(d for d in members if not is_supported(d))
            if people == 1 and any(to == TABLE for d in members for _, to in d.relations):
                return  # the text states a position on the table
            self.reading.groupings.append(Grouping("setting", standing, seat=(seat, people)))

    @abstractmethod
    def _table(self, noun: Noun) -> str:
        """Interpret the modifiers of the table."""

    @abstractmethod
    def _predicate(
        self, post: Post, things: Sequence[Group], groups: Sequence[Target], bare: bool
    ) -> None:
        """Interpret a predicate that applies to objects."""


_TABLEWARE = frozenset(
    ["plate", "bowl", "fork", "knife", "spoon", "glass", "wine_glass", "mug", "teacup", "saucer",
     "placemat", "chopsticks", "champagne_flute", "place_card", "paper_plate", "paper_cup",
     "plastic_cup", "serving_platter", "teaspoon", "butter_knife", "menu_card"]
)  # fmt: skip
"""Categories of objects of which each person gets one."""


_FIRST = frozenset(["plate", "bowl", "saucer", "placemat", "paper_plate"])
"""Categories of objects of which everyone gets one at a set table."""


def _is_one_each(noun: Noun) -> bool:
    """Return whether an item is laid once per person: a plate is, but a plate of cookies is not."""
    filled = any(isinstance(post, Carry) for post in noun.post)
    return _is_central(noun) or (not filled and noun.count in (None, 1))


def _is_central(noun: Noun) -> bool:
    """Return whether an object is shared and stands in the middle of the table."""
    return any(
        isinstance(post, Location)
        and isinstance(post.target, Zone)
        and (post.target.x, post.target.y) == (0, 0)
        for post in noun.post
    )
