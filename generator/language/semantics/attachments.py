"""Objects attached to another object by "with", "holding" or "of"."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace

from ..drafts import Draft, Group, assumed_relation
from ..syntax.phrases.tree import (
    Carry,
    Location,
    Noun,
    Post,
    Zone,
    find_spans,
)
from ..vessel_sizes import holds_things, is_lit
from . import contents
from .links import link, topmost
from .members import MemberReader
from .references import Target
from .relations import CUTLERY

_DIRECTIONS = ("left_of", "right_of", "in_front_of", "behind", "next_to", "at", "beside", "aside")


@dataclass(eq=False)
class CarryReader(MemberReader, ABC):
    """Reads attached objects, and assumes positions for them until the text states others."""

    def _carry(self, post: Carry, owner: Target, noun: Noun | None) -> None:
        """Read the objects attached to an owner, and by default put them where they fit."""
        context = self._context
        outer, context.owner = context.owner, owner
        subject, context.subject = context.subject, []
        try:
            if noun is not None and noun.kind == "member" and isinstance(owner, list):
                noun = replace(noun, category=owner[0].category, head=owner[0].noun)
            if post.how == "of" and noun is not None and isinstance(owner, list):
                self._contents(post, owner, noun)
                return
            items = post.items
            if isinstance(owner, list):
                looks = [item for item in items if contents.decorates(item, owner)]
                self._read.update(span for item in looks for span in find_spans(item))
                items = tuple(item for item in items if item not in looks)
            vessel = _vessel(owner, noun)
            if (
                isinstance(owner, list)
                and vessel is not None
                and (contents.fills(vessel, items) or contents.repeats(vessel, items))
            ):
                contents.label(vessel, items[0], owner)
                self._read.add(items[0].span)
                context.owner = outer
                self._posts(items[0], owner)
                return
            moved = _owners_places(owner, items, post.how, first=len(context.mentioned) < 2)
            if moved and isinstance(owner, list):
                items = (*items[:-1], replace(items[-1], post=[
                    p for p in items[-1].post if p not in moved]))  # fmt: skip
            joint = [] if moved else _joint_places(items, post.how, noun)
            items = tuple(contents.loosen(item, owner) for item in items)
            each = post.each or post.how == "hold" or (noun is not None and noun.each)
            each = each and not (isinstance(owner, list) and _is_pile(owner))
            lit = isinstance(owner, list) and any(
                is_lit(item.category or "", owner[0].category or "") for item in items
            )  # "three candlesticks with candles"
            if isinstance(owner, list) and len(owner) > 1 and lit:
                items = tuple(
                    replace(item, count=float(len(owner))) if item.count is None else item
                    for item in items
                )
            if isinstance(owner, list) and len(owner) > 1 and each:
                items = tuple(_times(item, len(owner)) for item in items)
            groups = self._list(items, owner)
            if isinstance(owner, list):
                for group in groups:
                    if isinstance(group, list):
                        self._assume(group, owner, post)
                        if joint and len(owner) == 1:
                            link("next_to", group, owner, self.reading.warnings)
                context.owner = outer
                for place in (*moved, *joint):
                    self._post(place, owner, noun)
        finally:
            context.owner, context.subject = outer, subject

    def _contents(self, post: Carry, owner: Group, noun: Noun) -> None:
        self._read.update(item.span for item in post.items)
        if post.each and len(post.items) == len(owner):  # "bottles of gin, rum and vermouth"
            for inner, draft in zip(post.items, owner, strict=True):
                contents.label(noun, inner, [draft])
            return
        for inner in post.items:
            if contents.labels(noun, inner):
                contents.label(noun, inner, owner)
                continue
            group = self._noun(_times(inner, len(owner)) if len(owner) > 1 else inner, owner)
            if isinstance(group, list):
                self._assume(group, owner, post)

    def _assume(self, group: Group, owners: Group, post: Carry) -> None:
        share = -(-len(group) // len(owners))
        for k, draft in enumerate(group):
            if draft.relations or any(draft is o for o in owners):
                continue
            owner = owners[min(k // share, len(owners) - 1)]
            if _is_pile(owners):
                top = topmost(owners[0])
                owner = top if isinstance(top, Draft) else owner
            kind = post.back or assumed_relation(draft, owner, held=post.how != "with")
            if post.back in ("on", "in") and owner.category and holds_things(owner.category):
                kind = "in" if post.back == "in" else kind
            draft.relations.append((kind, owner))
            draft.provisional = True

    @abstractmethod
    def _list(self, nouns: Sequence[Noun], owner: Target | None) -> list[Target]:
        """Interpret a list of noun phrases."""

    @abstractmethod
    def _noun(self, noun: Noun, owner: Target | None) -> Target | None:
        """Interpret a noun phrase and its modifiers; return the objects that it refers to."""


def _vessel(owner: Target, noun: Noun | None) -> Noun | None:
    """Return the noun phrase of a vessel, made from its draft if a verb precedes the contents."""
    if noun is not None or not isinstance(owner, list):
        return noun
    return Noun("thing", (owner[0].noun,), (0, 0), owner[0].noun, owner[0].category)


def _is_pile(group: Group) -> bool:
    """Return whether the objects form a stack, which carries others on top."""
    return len(group) > 1 and group[0].stacked_under is not None


def _owners_places(owner: Target, items: Sequence[Noun], how: str, *, first: bool) -> list[Post]:
    """Return the positions that are stated for the contents but actually apply to the vessel.

    In "a bowl with two eggs behind the pot", the bowl is behind the pot. In "a bowl with crisps
    behind it", so is the bowl, unless it is the ``first`` object of the text.
    """
    if not isinstance(owner, list) or not items:
        return []
    item = items[-1]
    if owner[0].category is None:
        return []
    inside = assumed_relation(Draft("", item.category, {}), owner[0], held=how != "with")
    if item.category is None and holds_things(owner[0].category):
        inside = "in"
    inside = "in" if how == "hold" else inside
    if inside not in ("on", "in") or item.category in CUTLERY:
        return []
    sided = [i for i in items if any(_is_side(p) for p in i.post)]
    if len(sided) > 1:
        return []  # "a tray with cups on the left and a teapot on the right"
    named = {i.head for i in items}
    if any(isinstance(p, Location) and isinstance(p.target, Noun) and p.target.head in named
           for p in item.post):  # fmt: skip
        return []  # "a tray: a plate, a mug to the right of the plate"
    loose = not first and not item.determined and inside == "in"
    return [
        place
        for place in item.post
        if isinstance(place, Location)
        and place.kind in _DIRECTIONS
        and (loose or not _is_pronoun(place.target) or (not first and _is_that(place.target)))
    ]


def _is_pronoun(target: Noun | Zone) -> bool:
    return isinstance(target, Noun) and target.kind == "pronoun"


def _is_that(target: Noun | Zone) -> bool:
    """Return whether a place is relative to "that", meaning the preceding object."""
    return isinstance(target, Noun) and _is_pronoun(target) and target.head == "that"


def _joint_places(items: Sequence[Noun], how: str, noun: Noun | None) -> Sequence[Location]:
    """Return the places of attached objects that also apply to their owner.

    In "a pitcher with two glasses in the back left corner", all are in the corner.
    """
    own = noun is None or any(isinstance(post, Location) for post in noun.post)
    if own or how != "with" or len(items) != 1:
        return []
    posts = items[-1].post
    return [p for p in posts if _is_side(p) and isinstance(p, Location) and p.kind == "at"][:1]


def _is_side(post: Post) -> bool:
    return isinstance(post, Location) and isinstance(post.target, Zone)


def _times(noun: Noun, owners: int) -> Noun:
    """Return a noun phrase with its count multiplied by ``owners``: "three bowls of two apples"."""
    if noun.definite or noun.kind != "thing":
        return noun
    if noun.count is not None or not (noun.plural or noun.amount):
        return replace(noun, count=(noun.count or 1.0) * owners)
    return replace(noun, count=2.0 * owners, amount=None)
