"""Tables that a text lays: what each person gets, and what stands in the middle for all."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from ...scene import TABLE
from ..drafts import Group, Grouping
from ..syntax.phrases.tree import EVERYONE, Clause, Location, Noun, Post, Zone
from .listing import ListInterpreter, is_supported
from .references import Context, Target

_SOME_PEOPLE = 4
"""For how many "everyone" is where the text does not say it."""


@dataclass(eq=False)
class SeatReader(ListInterpreter, ABC):
    """Reads for whom things are laid."""

    def _people(self, clause: Clause) -> None:
        """Read "set the table for four: a plate, a fork on the left"."""
        loose = ("setting", "vague", "table", "collective", "abstract", "adjective", "title")
        people = clause.people
        if people == EVERYONE:
            people = self.reading.people or self._guests or _SOME_PEOPLE
        self._guests = self.reading.guests = people
        if all(noun.kind in loose for noun in clause.subjects):
            self.reading.people = self.reading.people or people
            tables = [noun for noun in clause.subjects if noun.kind == "table"]
            self.reading.laid = self.reading.laid or bool(tables) or not clause.subjects
            for noun in tables:
                self._table(noun)
            for post in clause.predicate:
                self._predicate(post, [], [TABLE], True)
            return
        heads = [noun.head for noun in clause.subjects if noun.kind == "thing" and noun.post]
        laid = any(noun.category in _TABLEWARE for noun in clause.subjects)
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
        for noun in own:  # "cups and saucers": one for each
            if noun.plural and noun.count is None and noun.amount is None:
                noun.count, noun.plural = 1.0, False
        self._lay(people, lambda: self._list(own, None))
        self._list(shared, None)

    def _lay(self, people: int, read: Callable[[], Sequence[Target]]) -> None:
        """Lay for each person what ``read`` reads; "on the left" is left of the first thing."""
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
                return  # the text says where on the table it is laid
            self.reading.groupings.append(Grouping("setting", standing, seat=(seat, people)))

    @abstractmethod
    def _table(self, noun: Noun) -> str:
        """Read what is said of the table."""

    @abstractmethod
    def _predicate(
        self, post: Post, things: Sequence[Group], groups: Sequence[Target], bare: bool
    ) -> None:
        """Read what a verb says of things."""


_TABLEWARE = frozenset(
    ["plate", "bowl", "fork", "knife", "spoon", "glass", "wine_glass", "mug", "teacup", "saucer",
     "placemat", "chopsticks", "champagne_flute", "place_card", "paper_plate", "paper_cup",
     "plastic_cup", "serving_platter", "teaspoon", "butter_knife", "menu_card"]
)  # fmt: skip
"""What each person gets."""


def _is_central(noun: Noun) -> bool:
    """Tell whether a thing stands in the middle of the table, for all."""
    return any(
        isinstance(post, Location)
        and isinstance(post.target, Zone)
        and (post.target.x, post.target.y) == (0, 0)
        for post in noun.post
    )
