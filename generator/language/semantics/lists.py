"""Lists of noun phrases, in which modifiers of the last item may apply to all items."""

from __future__ import annotations

from abc import ABC
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from ...errors import InputError
from ...scene import TABLE
from ..drafts import Draft, Group, shares
from ..syntax.phrases.tree import Arranged, Carry, Location, Noun, Zone
from .attachments import CarryReader
from .links import link
from .references import Target

TURNED = InputError(
    "The prompt puts the table on an object, but objects stand on the table. Reverse this, for "
    "example 'a mug on the table'."
)


@dataclass(eq=False)
class ListInterpreter(CarryReader, ABC):
    """Interprets lists of noun phrases."""

    def _attach_lead(self, place: Location, targets: Target, groups: Sequence[Target]) -> None:
        for group in groups:
            if group == TABLE and place.kind in ("on", "in"):
                raise TURNED
            own = isinstance(group, list) and group[0].placed
            if isinstance(group, list) and not (own or _is_on_placed(group[0])):
                self._attach(place, targets, group)

    def _list(self, nouns: Sequence[Noun], owner: Target | None) -> list[Target]:
        """Interpret a list; modifiers of the last item may apply to all the other items too."""
        found: list[Target] = []
        context = self._context
        parallel, context.parallel = context.parallel, None
        for k, noun in enumerate(nouns):
            target = self._noun(noun, owner)
            if target is None:
                brings = any(isinstance(post, Carry) for post in noun.post)
                if noun.family == "place" and not brings and noun.kind == "setting":
                    self.reading.lost.append(" ".join(noun.words))  # "a house on a table"
                continue
            found.append(target)
            if isinstance(target, list):
                if context.topic is None and owner is None:
                    context.topic = target
                self._share(nouns[: k + 1], noun, found)
        context.parallel = parallel
        for place in nouns[-1].post if nouns else ():
            if isinstance(place, Location) and place.whole and len(found) > 1:  # "all on a tray"
                self._place_all(place, found)
        self._arrange_all(nouns, found)
        return found

    def _arrange_all(self, nouns: Sequence[Noun], found: Sequence[Target]) -> None:
        """Arrange all items of "an apple, a pear and a peach in a row", not only the last one."""
        posts = [post for post in nouns[-1].post if isinstance(post, Arranged)] if nouns else []
        groups = [group for group in found if isinstance(group, list)]
        if not posts or len(groups) < 2:
            return
        if any(post.order == "listed" for post in posts):
            self._line_up(groups)
        elif all(len(g) == 1 and all(to == TABLE for _, to in g[0].relations) for g in groups):
            self._arrange(posts[0], [draft for group in groups for draft in group])
        zones = [p for p in nouns[-1].post
                 if isinstance(p, Location) and isinstance(p.target, Zone)]  # fmt: skip
        for place in zones:  # "a clock, a vase and a frame in a row at the back edge"
            for group in groups[:-1]:
                if not group[0].placed:
                    self._attach(place, TABLE, group)

    def _line_up(self, groups: Sequence[Group]) -> None:
        """Put groups side by side in the order of the text."""
        firsts = [group[:1] for group in groups if not is_supported(group[0])]
        for one, other in pairwise(firsts):
            link("left_of", one, other, self.reading.warnings)
        if len(firsts) > 1:
            self._arrange(Arranged("row"), [draft for group in firsts for draft in group])

    def _gather(self, place: Location, found: Sequence[Target]) -> None:
        """Arrange "an apple, a pear and a plum around a bowl" as a single circle."""
        last = [group for group in found[-1:] if isinstance(group, list)]
        inner = [to for d in last[0] for _, to in d.relations if isinstance(to, Draft)][:1]
        ring = [d for group in found if isinstance(group, list) for d in group]
        free = [d for d in ring if not d.relations or d in last[0]]
        if inner and len(free) > len(last[0]) and all(d is not inner[0] for d in free):
            self._attach(place, inner, free)

    def _place_all(self, place: Location, found: Sequence[Target]) -> None:
        """Give all objects of a list the position of the last one."""
        last = found[-1]
        if not isinstance(last, list):
            return
        if isinstance(place.target, Zone):
            targets: Target = TABLE
        else:
            targets = [to for kind, to in last[0].relations
                       if kind == place.kind and isinstance(to, Draft)]  # fmt: skip
        for group in found[:-1]:
            if targets and isinstance(group, list):
                self._attach(replace(place, whole=False), targets, group)

    def _share(self, nouns: Sequence[Noun], last: Noun, found: Sequence[Target]) -> None:
        """Apply the position in "an apple and a pear on a plate" to both objects."""
        places = [post for post in last.post if isinstance(post, Location)]
        if last.joint != "and" or len(nouns) < 2 or not places or len(found) < 2:
            return
        if places[0].kind == "around":
            self._gather(places[0], found)
            return
        other = found[-2]
        previous = nouns[-2]
        if not isinstance(other, list) or previous.post:
            return
        if isinstance(places[0].target, Zone):
            if all(not draft.relations for draft in other):
                self._attach(places[0], TABLE, other)
            return
        if places[0].each or (isinstance(places[0].target, Noun) and places[0].target.each):
            self._attach(places[0], self._context.parallel or [], other)
            return
        listed = any(not noun.post for noun in nouns[:-2])
        drafts = found[-1]
        assert isinstance(drafts, list)
        for kind, target in list(drafts[0].relations):
            if target is not TABLE and all(target is not d for d in other):
                targets = [to for d in drafts for k, to in d.relations if k == kind]
                if listed and kind in ("on", "in"):
                    continue
                if shares(kind, other, targets):
                    link(kind, other, targets[:1], self.reading.warnings)


def is_supported(draft: Draft) -> bool:
    """Return whether an object is on or in another."""
    return any(kind in ("on", "in") and to != TABLE for kind, to in draft.relations)


def _is_on_placed(draft: Draft) -> bool:
    """Return whether an object's support already has a position."""
    return any(
        kind in ("on", "in") and isinstance(to, Draft) and to.placed for kind, to in draft.relations
    )
