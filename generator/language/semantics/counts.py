"""How many there are of what a text names: said after all, or a half of them."""

from __future__ import annotations

from abc import ABC
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from ..drafts import MAX_OBJECTS, Draft, Group
from ..syntax.phrases.tree import Description, Post
from .relations import Relater


@dataclass(eq=False)
class CountReader(Relater, ABC):
    """Keeps count.

    ``_uncounted`` are the last several things of which the text has not said how many they are;
    ``_halves`` is what was said of a half of them.
    """

    _uncounted: Group = field(default_factory=list)
    _halves: list[Mapping[str, str]] = field(default_factory=list)
    _said: Sequence[Post] = ()  # what the verb of the clause says that is being read

    def _recount(self, count: int) -> None:
        """Have as many of the last things that were not counted as the text says after all."""
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
        """Return the things that others are related to."""
        return [to for d in self.reading.objects for _, to in d.relations if isinstance(to, Draft)]

    def _halve(self, group: Group, said: Sequence[Post]) -> Group:
        """Return half of a group; what is said of it is so, however many there are in the end."""
        if group is self._uncounted:
            posts = [post for post in said if isinstance(post, Description) and post.each]
            self._halves = [post.each[0] for post in posts]
        half = group[: max(1, len(group) // 2)]
        for draft in half:
            draft.told = True
        return half

    def _rest(self) -> Group:
        """Return those of the last several of which nothing was said while it was of others."""
        mentioned = self._context.mentioned
        alone = [group[0] for group in mentioned if len(group) == 1]
        several = [group for group in mentioned if len(group) > 1]
        split = [g for g in several if any(d.told or d in alone for d in g)] or several
        return [d for group in split[-1:] for d in group if not d.told and d not in alone]

    def _count_claimed(self, claimed: Group, count: int) -> Group | None:
        """Return as many of "all mugs" as the text says after them that there are.

        None where it names other things, or one of several that have their place.
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
