"""Counts of objects: stated later in the text, or for one half of a group."""

from __future__ import annotations

from abc import ABC
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from ..drafts import MAX_OBJECTS, Draft, Group
from ..syntax.phrases.tree import Description, Post
from .relations import Relater


@dataclass(eq=False)
class CountReader(Relater, ABC):
    """Tracks counts of groups.

    ``_uncounted`` is the last group whose count the text has not stated yet; ``_halves`` are
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
        """Return the objects that are targets of relations."""
        return [to for d in self.reading.objects for _, to in d.relations if isinstance(to, Draft)]

    def _halve(self, group: Group, said: Sequence[Post]) -> Group:
        """Return half of a group, and remember its attributes in case the count changes."""
        if group is self._uncounted:
            posts = [post for post in said if isinstance(post, Description) and post.each]
            self._halves = [post.each[0] for post in posts]
        half = group[: max(1, len(group) // 2)]
        for draft in half:
            draft.told = True
        return half

    def _rest(self) -> Group:
        """Return the members of the last group not mentioned yet, while others were."""
        mentioned = self._context.mentioned
        alone = [group[0] for group in mentioned if len(group) == 1]
        several = [group for group in mentioned if len(group) > 1]
        split = [g for g in several if any(d.told or d in alone for d in g)] or several
        return [d for group in split[-1:] for d in group if not d.told and d not in alone]

    def _count_claimed(self, claimed: Group, count: int) -> Group | None:
        """Return the group of "all mugs" with the count that the text states after them.

        None if the text names other objects, or a single one while the group has positions already.
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
