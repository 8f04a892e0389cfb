"""Noun phrases for things: those there are, or new ones."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

from ..drafts import Draft, Group
from ..parsing.vocabulary import MEANT_WITH
from ..syntax.tree import (
    VARIED,
    Arranged,
    Description,
    Noun,
    Post,
)
from .references import find_referred
from .relating import Relater

_ONE_PIECE = frozenset(("pancakes", "paper_stack", "napkins", "playing_cards", "sticky_notes"))
"""Categories that are a stack or a heap already."""

_HEAPED = frozenset(("pancakes", "paper_stack"))
"""Those of which several are one heap without a word for it: "three pancakes"."""

_COLORFUL = ("colored", "coloured", "colorful", "colourful")


@dataclass(eq=False)
class ThingReader(Relater, ABC):
    """Reads which things a noun phrase means."""

    def _thing(self, noun: Noun) -> Group:
        """Return the objects a noun phrase means: those there are, or new ones."""
        if noun.kind == "collective":
            return self._collective(noun)
        if noun.definite or noun.other or noun.each:
            known = self.reading.objects[self._seated or 0 :]
            found = find_referred(noun, known, self._context.subject)
            if noun.each and not found:
                found = [d for d in self.reading.objects if d.noun == noun.head]
            if found and not (noun.other and not noun.definite):
                return found
        return self._introduce(noun)

    def _collective(self, noun: Noun) -> Group:
        members = [m for m in noun.members if m not in self.reading.excluded]
        if noun.head.endswith(("setting", "settings")) and (noun.count or 1) > 1:
            self.reading.people = self.reading.people or int(noun.count or 1)
            return []
        self.reading.vague = self.reading.vague or not noun.head.startswith("salt")
        return [
            self.reading.add(category.replace("_", " "), category, noun.attributes)
            for category in members
        ]

    def _introduce(self, noun: Noun) -> Group:
        claimed = [d for d in self.reading.objects if d.implied and _claims(d, noun)]
        if claimed and not noun.definite and (noun.count or 1) == 1 and not noun.plural:
            claimed[0].implied = False
            claimed[0].attributes.update(noun.attributes)
            return claimed[:1]
        there = {draft.category for draft in self.reading.objects}
        meant = MEANT_WITH.get(noun.head, ())
        category = next((key for other, key in meant if other in there), noun.category)
        head = noun.head if category == noun.category else str(category).replace("_", " ")
        single = noun.category in _ONE_PIECE and (
            noun.arrangement is not None or noun.category in _HEAPED
        )
        count = 1 if single else len(noun.variants) or self.reading.number(noun, self.rng)
        group = [
            self.reading.add(
                head, category,
                {**noun.attributes, **(noun.variants[k] if noun.variants else {})},
                lengths=noun.lengths, family=noun.family, implied=noun.definite,
                position=noun.position,
            )
            for k in range(count)
        ]  # fmt: skip
        if noun.arrangement is not None:
            self._arrange(Arranged(noun.arrangement), group)
        if noun.attributes.get("state") in _COLORFUL and "color" not in noun.attributes:
            self._post(Description(VARIED["color"]), group, noun)
        return group

    def _member(self, noun: Noun) -> Group | None:
        """Read "one on the plate", "the other behind it": single ones of the last group."""
        if noun.definite and noun.attributes:  # "the red one"
            wanted = noun.attributes.items()
            known = [d for d in self.reading.objects if wanted <= d.attributes.items()]
            self._posts(noun, known[-1:])
            return known[-1:] or None
        groups = [g for g in self._context.mentioned if len(g) > 1]
        if noun.attributes and not groups and self._context.mentioned:  # "a small green one"
            like = self._context.mentioned[-1][0]
            bare = like.noun.split()[-1]
            made = self.reading.add(bare, like.category, noun.attributes, family=like.family)
            self._posts(noun, [made])
            return [made]
        if not groups or not (noun.post or noun.attributes):
            return None
        free = [d for d in groups[-1] if not d.told]
        count = len(free) if noun.other and noun.plural else int(noun.count or 1)
        chosen = free[:count]
        for draft in chosen:
            draft.told = True
            draft.attributes.update(noun.attributes)
        if chosen:
            self._posts(noun, chosen)
        return chosen or None

    @abstractmethod
    def _posts(self, noun: Noun, group: Group) -> None:
        """Read all that follows a noun phrase."""

    @abstractmethod
    def _post(self, post: Post, group: Group, noun: Noun | None) -> None:
        """Read one thing that is said of a group."""


def _claims(draft: Draft, noun: Noun) -> bool:
    alike = draft.category == noun.category and (noun.category or draft.noun == noun.head)
    return bool(alike)
