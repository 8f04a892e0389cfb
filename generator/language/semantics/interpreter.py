"""Clauses to a draft of the scene: which things, which table, what relates to what."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from ...catalogue import CATEGORIES
from ...errors import InputError
from ...scene import TABLE
from ..drafts import Draft, Group, Grouping, Reading, assumed_relation, phrase_text, shares
from ..syntax.tree import (
    VARIED,
    Arranged,
    Carry,
    Clause,
    Description,
    Lack,
    Location,
    Noun,
    Post,
    Sentence,
    Zone,
)
from . import contents
from .linking import flank, link, stack
from .references import Context, Target, antecedent, find_referred

_ONE_PIECE = frozenset(("pancakes", "paper_stack", "napkins", "playing_cards", "sticky_notes"))
"""Categories that are a stack or a heap already."""

_HEAPED = frozenset(("pancakes", "paper_stack"))
"""Those of which several are one heap without a word for it: "three pancakes"."""

_COLORFUL = ("colored", "coloured", "colorful", "colourful")

_ZONES = {-1: ("left_of", "in_front_of"), 1: ("right_of", "behind")}


@dataclass(eq=False)
class Interpreter:
    """Turns clauses into drafts; vague numbers are drawn by ``rng``."""

    rng: np.random.Generator
    reading: Reading = field(default_factory=Reading)
    _context: Context = field(default_factory=Context)
    _side: tuple[str, Target] | None = None  # the last "left of X" of this sentence
    _seated: int | None = None  # the first object of the place setting that is being read

    def read(self, sentences: Sequence[Sentence]) -> Reading:
        """Read all sentences.

        Raises:
            InputError: impossible counts, a second table, the table on an object.
        """
        for sentence in sentences:
            context = self._context
            context.earlier = context.topic or context.earlier
            context.topic, context.parallel, self._side = None, None, None
            for clause in sentence.clauses:
                self._clause(clause)
        return self.reading

    def _clause(self, clause: Clause) -> None:
        if clause.people:
            self._people(clause)
            return
        lead = self._resolve(clause.lead, []) if clause.lead else None
        if clause.lead is not None and lead is None:
            return
        groups = self._list(clause.subjects, None)
        things = [group for group in groups if isinstance(group, list)]
        if lead is not None and clause.lead is not None:
            self._attach_lead(clause.lead, lead, groups)
        if not clause.subjects and clause.predicate:
            things = [self._context.topic] if isinstance(self._context.topic, list) else things
        for post in clause.predicate:
            self._predicate(post, things, groups)
        if things and self._context.topic is None:
            self._context.topic = things[0]

    def _attach_lead(self, place: Location, targets: Target, groups: Sequence[Target]) -> None:
        for group in groups:
            if group == TABLE and place.kind in ("on", "in"):
                raise _TURNED
            if isinstance(group, list):
                self._attach(place, targets, group)

    def _predicate(self, post: Post, things: Sequence[Group], groups: Sequence[Target]) -> None:
        if isinstance(post, Arranged):
            self._arrange(post, [draft for group in things for draft in group])
            return
        if isinstance(post, Location) and TABLE in groups and not things:
            if isinstance(post.target, Noun) and post.kind in ("on", "in"):
                raise _TURNED
            return
        for group in things:
            self._post(post, group, None)
        if isinstance(post, Location) and not groups and not things:
            self._resolve(post, [])  # "dinner for two by candlelight"
        if isinstance(post, Carry) and TABLE in groups:
            self._carry(post, TABLE, None)
        if isinstance(post, Description) and TABLE in groups:
            self.reading.table.append(_describing(post))

    # ---------------------------------------------------------------------------------- lists

    def _list(self, nouns: Sequence[Noun], owner: Target | None) -> list[Target]:
        """Read a list; what is said of its last item only may be said of the others, too."""
        found: list[Target] = []
        context = self._context
        parallel, context.parallel = context.parallel, None
        for k, noun in enumerate(nouns):
            target = self._noun(noun, owner)
            if target is None:
                continue
            found.append(target)
            if isinstance(target, list):
                if context.topic is None and owner is None:
                    context.topic = target
                self._share(nouns[: k + 1], noun, found)
        context.parallel = parallel
        return found

    def _share(self, nouns: Sequence[Noun], last: Noun, found: Sequence[Target]) -> None:
        """Give "an apple and a pear on a plate" one place."""
        places = [post for post in last.post if isinstance(post, Location)]
        if last.joint != "and" or len(nouns) < 2 or not places or len(found) < 2:
            return
        other = found[-2]
        previous = nouns[-2]
        if not isinstance(other, list) or previous.post:
            return
        listed = len(nouns) > 2
        drafts = found[-1]
        assert isinstance(drafts, list)
        for kind, target in list(drafts[0].relations):
            if target is not TABLE and all(target is not d for d in other):
                targets = [to for d in drafts for k, to in d.relations if k == kind]
                if listed and kind in ("on", "in"):
                    continue
                if shares(kind, other, targets):
                    link(kind, other, targets[:1], self.reading.warnings)

    # ---------------------------------------------------------------------------------- nouns

    def _noun(self, noun: Noun, owner: Target | None) -> Target | None:
        """Read a noun phrase with what follows it; return what it means."""
        if noun.kind == "table":
            return self._table(noun)
        if noun.kind == "pronoun":
            group = antecedent(noun, "", self._context)
            if isinstance(group, list):
                self._posts(noun, group)
            return group
        if noun.kind == "abstract":
            self.reading.lost.append(" ".join(noun.words))
        if noun.kind in ("setting", "vague", "abstract"):
            return self._loose(noun)
        if noun.kind == "part":
            if owner == TABLE:
                self.reading.table_parts.append(noun)
            return None
        if noun.kind in ("member", "adjective"):
            return self._member(noun)
        group = self._thing(noun)
        if group:
            self._context.mentioned.append(group)
            self._posts(noun, group)
        return group or None

    def _loose(self, noun: Noun) -> Target | None:
        """Read what follows "a scene with" or "some things": it stands on the table."""
        self.reading.vague = self.reading.vague or noun.kind == "vague"
        for post in noun.post:
            if isinstance(post, Carry):
                self._carry(post, TABLE, None)
            elif isinstance(post, Location) and isinstance(post.target, Noun):
                self._resolve(post, [])
            elif isinstance(post, Lack):
                self._lack(post, [])
        return None

    def _table(self, noun: Noun) -> str:
        if (noun.count or 1) > 1 or noun.amount or noun.plural:
            raise InputError(
                "A scene has exactly one table, the text asks for several "
                f"({phrase_text(noun)!r}). Describe one table."
            )
        self.reading.table.append(noun)
        for post in noun.post:
            if isinstance(post, Carry):
                self._carry(post, TABLE, None)
            elif isinstance(post, Lack):
                self._lack(post, [])
            elif isinstance(post, Description):
                self.reading.table.append(_describing(post))
            elif isinstance(post, Location) and isinstance(post.target, Noun):
                if post.kind in ("on", "in") and post.target.kind == "thing":
                    raise _TURNED
                self._resolve(post, [])
        return TABLE

    def _member(self, noun: Noun) -> Group | None:
        """Read "one on the plate", "the other behind it": single ones of the last group."""
        groups = [g for g in self._context.mentioned if len(g) > 1]
        if not groups or not noun.post:
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
        single = noun.category in _ONE_PIECE and (
            noun.arrangement is not None or noun.category in _HEAPED
        )
        count = 1 if single else len(noun.variants) or self.reading.number(noun, self.rng)
        group = [
            self.reading.add(
                noun.head, noun.category,
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

    # ---------------------------------------------------------------------------------- posts

    def _posts(self, noun: Noun, group: Group) -> None:
        for post in noun.post:
            self._post(post, group, noun)

    def _post(self, post: Post, group: Group, noun: Noun | None) -> None:
        if isinstance(post, Location):
            target = self._resolve(post, group)
            if target is not None:
                self._attach(post, target, group)
        elif isinstance(post, Carry):
            if post.back != "between":
                self._carry(post, group, noun)
        elif isinstance(post, Lack):
            self._lack(post, group)
        elif isinstance(post, Arranged):
            self._arrange(post, group)
        else:
            if len(post.each) > len(group) == 1:
                return  # "a mug in different colours"
            for k, draft in enumerate(group):
                draft.attributes.update(post.each[k % len(post.each)])

    def _lack(self, post: Lack, group: Group) -> None:
        for item in post.items:
            names = {item.category, *item.members} - {None}
            own = any(d.category in names for d in group)
            self.reading.excluded |= {str(n) for n in names}
            if not group or own:
                self.reading.banned |= {str(n) for n in names}

    def _arrange(self, post: Arranged, group: Group) -> None:
        if len(group) < 2:
            return
        if post.kind == "stack":
            stack(group)
        else:
            self.reading.groupings.append(Grouping(post.kind, tuple(group), order=post.order))

    def _carry(self, post: Carry, owner: Target, noun: Noun | None) -> None:
        """Read what a thing brings along, and put it where it fits until the text says more."""
        context = self._context
        outer, context.owner = context.owner, owner
        subject, context.subject = context.subject, []
        try:
            if post.how == "of" and noun is not None and isinstance(owner, list):
                self._contents(post, owner, noun)
                return
            items = post.items
            if isinstance(owner, list):
                items = tuple(item for item in items if not contents.decorates(item, owner))
            if isinstance(owner, list) and noun is not None and contents.fills(noun, items):
                contents.label(noun, items[0], owner)
                context.owner = outer
                self._posts(items[0], owner)
                return
            moved = _owners_places(owner, items, post.how)
            if moved and isinstance(owner, list):
                items = (*items[:-1], replace(items[-1], post=[
                    p for p in items[-1].post if p not in moved]))  # fmt: skip
            if isinstance(owner, list) and len(owner) > 1 and (post.each or post.how == "hold"):
                items = tuple(_times(item, len(owner)) for item in items)
            groups = self._list(items, owner)
            if isinstance(owner, list):
                for group in groups:
                    if isinstance(group, list):
                        self._assume(group, owner, post)
                context.owner = outer
                for place in moved:
                    self._post(place, owner, noun)
        finally:
            context.owner, context.subject = outer, subject

    def _contents(self, post: Carry, owner: Group, noun: Noun) -> None:
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
            kind = post.back or assumed_relation(draft, owner, held=post.how != "with")
            if (
                post.back in ("on", "in")
                and owner.category
                and CATEGORIES[owner.category].container
            ):
                kind = "in" if post.back == "in" else kind
            draft.relations.append((kind, owner))
            draft.provisional = True

    # ------------------------------------------------------------------------------- relations

    def _resolve(self, place: Location, subject: Group) -> Target | None:
        """Return what a place refers to, reading its noun phrase; None if it cannot be told."""
        context = self._context
        if isinstance(place.target, Zone):
            if place.table is not None and place.table.kind == "table":
                self._table(place.table)
            return TABLE
        noun = place.target
        outer, context.subject = context.subject, subject
        try:
            if noun.kind == "pronoun":
                return antecedent(noun, place.kind, context)
            if place.each and len(subject) > 1 and _is_one(noun):
                return self._noun(replace(noun, count=float(len(subject))), None)
            if noun.each or (place.each and not noun.determined):
                found = [d for d in self.reading.objects if d.category == noun.category
                         and (noun.category or d.noun == noun.head)]  # fmt: skip
                if found:
                    return found
            target = self._noun(noun, None)
        finally:
            context.subject = outer
        second = [post for post in noun.post if isinstance(post, Carry) and post.back == "between"]
        if second and isinstance(target, list):
            others = [self._noun(item, None) for item in second[0].items]
            target = target + [d for group in others if isinstance(group, list) for d in group]
        return target

    def _attach(self, place: Location, target: Target, group: Group) -> None:
        """Relate a group to what a place refers to."""
        context, kind = self._context, place.kind
        if self._seated is not None and kind == "on" and isinstance(target, list):
            flat = [d.category in CUTLERY for d in target]
            kind = "behind" if all(flat) else kind  # "the glass above the knife"
        if isinstance(place.target, Zone):
            self._zone(place.target, group, loose=kind == "beside")
            return
        if target == TABLE:
            if kind == "under":
                self.reading.warnings.append(
                    f"The {group[0].noun} cannot go under the table; it stands on it."
                )
            elif kind not in ("on", "in", "next_to", "at", "against", "around", "opposite"):
                for draft in group:
                    draft.relate(kind, TABLE)
            return
        assert isinstance(target, list)
        if any(draft is other for draft in group for other in target):
            raise InputError(
                f"The text relates the {group[0].noun} to itself; name two different objects."
            )
        if place.each or (isinstance(place.target, Noun) and place.target.each):
            self._one_each(group, target)
        self._drop_assumed(group, target)
        if kind in ("left_of", "right_of", "in_front_of", "behind"):
            self._side = kind, target
        if kind == "flank":
            flank(group, target, self.reading)
        elif kind in ("around", "surrounded"):
            inner, ring = (target, group) if kind == "around" else (group, target)
            laid = self.reading.groupings
            laid[:] = [g for g in laid if g.kind != "circle" or set(g.members) != set(ring)]
            laid.append(Grouping("circle", tuple(ring), around=inner[0]))
            link("next_to", ring, inner[:1], self.reading.warnings)
        else:
            link(kind, group, target, self.reading.warnings)
        context.parallel = target

    def _drop_assumed(self, group: Group, target: Group) -> None:
        """Drop what was assumed of things that the text relates to something else."""
        for draft in group:
            if draft.provisional and not any(draft.relations[0][1] is to for to in target):
                keep = draft.relations[0][0] in ("on", "in")
                if not keep:
                    draft.relations.clear()
                draft.provisional = False

    def _one_each(self, group: Group, targets: Group) -> None:
        """Multiply the subject so that each target gets its own ("on each plate")."""
        one, share = group[0], len(group)
        for _ in range(len(targets) * share - len(group) if share < len(targets) else 0):
            group.append(self.reading.add(one.noun, one.category, one.attributes))

    def _zone(self, zone: Zone, group: Group, *, loose: bool) -> None:
        """Put a group into a part of the table, or beside what was just spoken of."""
        if self._seated is not None and zone.x and not zone.edge:
            plate = self.reading.objects[self._seated]
            for draft in group:
                if draft is not plate:
                    draft.relate("left_of" if zone.x < 0 else "right_of", plate)
            return
        if loose and self._side is not None and zone.y is None and zone.x:
            kind, target = self._side
            if kind in ("left_of", "right_of") and isinstance(target, list):
                link("left_of" if zone.x < 0 else "right_of", group, target, self.reading.warnings)
                return
        for draft in group:
            if (zone.x, zone.y) == (0, 0):
                draft.relate("center", TABLE)
            for value, axis in ((zone.x, 0), (zone.y, 1)):
                if value:
                    draft.relate(_ZONES[value][axis], TABLE)
            if zone.edge and zone.x is None and zone.y is None:
                draft.relate("edge", TABLE)

    def _people(self, clause: Clause) -> None:
        """Read "set the table for four: a plate, a fork on the left"."""
        loose = ("setting", "vague", "table", "collective")
        if all(noun.kind in loose for noun in clause.subjects):
            self.reading.people = self.reading.people or clause.people
            return
        self._lay(clause.people, lambda: self._list(clause.subjects, None))

    def _lay(self, people: int, read: Callable[[], Sequence[Target]]) -> None:
        """Lay for each person what ``read`` reads; "on the left" is left of the first thing."""
        for seat in range(people):
            start = len(self.reading.objects)
            context, self._context = self._context, Context()
            self._seated, self._side = start, None
            read()
            self._seated, self._context = None, context
            members = self.reading.objects[start:]
            for draft in members[1:]:
                if not draft.relations:
                    draft.relations.append(("right_of", members[0]))
            standing = tuple(d for d in members if not _is_supported(d))
            self.reading.groupings.append(Grouping("setting", standing, seat=(seat, people)))


def _is_supported(draft: Draft) -> bool:
    return any(kind in ("on", "in") and to != TABLE for kind, to in draft.relations)


CUTLERY = frozenset({"fork", "knife", "spoon", "chopsticks"})
"""What lies beside a plate; a glass "above" it stands behind it."""

_DIRECTIONS = ("left_of", "right_of", "in_front_of", "behind", "next_to", "at")


def _owners_places(owner: Target, items: Sequence[Noun], how: str) -> list[Post]:
    """Return the places said of a thing in a vessel that are the vessel's.

    "A bowl with two eggs behind the pot": the bowl is behind the pot.
    """
    if not isinstance(owner, list) or not items:
        return []
    item = items[-1]
    if item.category is None or owner[0].category is None:
        return []
    inside = assumed_relation(Draft("", item.category, {}), owner[0], held=how != "with")
    if inside not in ("on", "in"):
        return []
    return [
        place
        for place in item.post
        if isinstance(place, Location)
        and place.kind in _DIRECTIONS
        and not (isinstance(place.target, Noun) and place.target.kind == "pronoun")
    ]


def _is_one(noun: Noun) -> bool:
    """Tell whether a noun phrase brings in one new thing of a known kind."""
    several = (noun.count or 1) != 1 or noun.plural or noun.each
    return bool(noun.category) and not noun.definite and not several


def _claims(draft: Draft, noun: Noun) -> bool:
    alike = draft.category == noun.category and (noun.category or draft.noun == noun.head)
    return bool(alike)


def _times(noun: Noun, owners: int) -> Noun:
    """Return a noun phrase for each of several owners: "three bowls of two apples"."""
    if noun.definite or noun.kind != "thing":
        return noun
    if noun.count is not None or not (noun.plural or noun.amount):
        return replace(noun, count=(noun.count or 1.0) * owners)
    return replace(noun, count=2.0 * owners, amount=None)


def _describing(post: Description) -> Noun:
    words = tuple(word for each in post.each for value in each.values() for word in value.split())
    return Noun("adjective", words, (0, 0), attributes=dict(post.each[0]))


_TURNED = InputError(
    "The text puts the table on an object; objects stand on the table. Turn it round, for example "
    "'a mug on the table'."
)
