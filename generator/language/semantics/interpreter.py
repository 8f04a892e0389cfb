"""From clauses to drafts of the scene: objects, the table, and relations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from ...errors import InputError
from ...scene import TABLE
from ..drafts import Group, Reading, phrase_text
from ..syntax.phrases.tree import (
    Arranged,
    Carry,
    Clause,
    Counted,
    Description,
    Lack,
    Location,
    Noun,
    Post,
    Sentence,
    Zone,
    is_everything,
    list_unread,
)
from .lists import TURNED, is_supported
from .place_settings import SeatReader
from .references import Target, antecedent, find_referred


@dataclass(eq=False)
class Interpreter(SeatReader):
    """Converts clauses into drafts.

    ``_named`` is the number of groups that previous sentences have named; ``_alone`` is true if the
    current sentence has only one clause.
    """

    _named: int = 0
    _alone: bool = False
    _latest: Group | None = None  # subject of the last clause in this sentence that has one

    def read(self, sentences: Sequence[Sentence]) -> Reading:
        """Interpret all sentences.

        Raises:
            InputError: Counts are impossible, there is a second table, or the table is on an
                object.
        """
        for sentence in sentences:
            context = self._context
            context.earlier = context.topic or context.earlier
            self._earlier_side, self._started = self._side, len(self.reading.objects)
            context.topic, context.parallel, self._side = None, None, None
            self._latest = None
            self._named, self._alone = len(context.mentioned), len(sentence.clauses) == 1
            for k, clause in enumerate(sentence.clauses):
                self._local = k > 0
                self._clause(clause)
        self.reading.lost += list_unread(sentences, self._read)
        told = [draft for draft in self._uncounted if draft.told]
        if (
            told and not self._halves and len(told) < len(self._uncounted)
        ):  # the text implies the count
            gone = [draft for draft in self._uncounted if not draft.told and not draft.relations]
            self.reading.objects[:] = [d for d in self.reading.objects if d not in gone]
        return self.reading

    def _clause(self, clause: Clause) -> None:
        if clause.people:
            self._people(clause)
            return
        lead = self._resolve(clause.lead, []) if clause.lead else None
        if clause.lead is not None and lead is None:  # the target is unknown
            known = [noun for noun in clause.subjects if noun.category or noun.family]
            clause = replace(clause, subjects=known, lead=None)
        self._said = clause.predicate
        spoken_of = self._spoken_of(clause)
        groups = self._list(clause.subjects, None) if spoken_of is None else [*spoken_of]
        things = [group for group in groups if isinstance(group, list)]
        if lead is not None and clause.lead is not None:
            self._attach_lead(clause.lead, lead, groups)
        bare = not clause.subjects or (not things and _is_pronoun(clause.subjects[0]))
        if bare and any(not isinstance(post, Lack) for post in clause.predicate):
            topic = self._topic()
            things = [topic] if isinstance(topic, list) else things
        for post in clause.predicate:
            if isinstance(post, Lack) and bare:
                self._lack(post, [])
            else:
                self._predicate(post, things, [TABLE] if bare and not things else groups, bare)
        told = bool(clause.predicate) and all(isinstance(p, Description) for p in clause.predicate)
        if told and len(things) == 1 and things[0] is self._uncounted:
            for draft in things[0]:
                draft.implied = True  # "cups are blue": the count may follow
        if things and not bare:
            self._context.recent, self._latest = things, things[0]
        firsts = [d for group in things for d in group if not is_supported(d)]
        self._context.listed = firsts if len(things) > 2 else []
        if isinstance(lead, list) and self._context.topic in (None, *things):
            self._context.topic = lead  # "next to it ... In front of it ...": the same antecedent
        if things and self._context.topic is None:
            self._context.topic = things[0]

    def _topic(self) -> Target | None:
        """Return the topic of a clause without a subject, or None if it is the table."""
        context = self._context
        if self._latest is not None and self._local:
            return self._latest
        if context.topic is not None:
            return context.topic
        named = context.mentioned[self._named :]
        if self._local:
            return named[-1] if named else None
        return context.earlier if self._alone else None

    def _spoken_of(self, clause: Clause) -> list[Group] | None:
        """Return the groups that a subject "it" or "they" refers to, or None for other subjects."""
        subject = clause.subjects[0] if len(clause.subjects) == 1 else None
        if subject is None or subject.kind != "pronoun" or subject.post:
            return None
        recent = self._context.recent
        if subject.plural and len(recent) > 1:
            return recent
        return [group for group in recent if (len(group) > 1) == subject.plural][:1] or None

    def _predicate(
        self, post: Post, things: Sequence[Group], groups: Sequence[Target], bare: bool
    ) -> None:
        if isinstance(post, Arranged):
            self._arrange(post, [draft for group in things for draft in group])
            return
        if isinstance(post, Location) and bare and not things:
            self._resolve(post, [])  # "dinner for two by candlelight"
            return
        if isinstance(post, Location) and TABLE in groups and not things:
            if isinstance(post.target, Noun) and post.kind in ("on", "in"):
                raise TURNED
            return
        if isinstance(post, Location) and len(things) > 1:
            everything = [draft for group in things for draft in group]
            target = self._resolve(post, everything)
            for group in things:
                if target is not None:
                    self._attach(post, target, group)
            return
        for group in things:
            each = len(post.each) if isinstance(post, Description) else 0
            if each > len(group) > 1 and group is self._uncounted:
                self._recount(each)  # "cups are red, green and blue"
            self._post(post, group, None)
        if isinstance(post, Location) and not groups and not things:
            self._resolve(post, [])
        if isinstance(post, Carry) and TABLE in groups:
            guests = self.reading.people if bare else 0
            if not self._lay_brought(post.items, guests):  # "a table for two with a plate each"
                self._carry(post, TABLE, None)
        known = not bare or any(noun.kind == "table" for noun in self.reading.table)
        if isinstance(post, Description) and TABLE in groups and known:
            self.reading.table.append(_describing(post))

    def _noun(self, noun: Noun, owner: Target | None) -> Target | None:
        """Interpret a noun phrase and its modifiers; return the objects that it refers to."""
        self._read.add(noun.span)
        if noun.kind == "table":
            return self._table(noun)
        if noun.kind == "pronoun":
            group = antecedent(noun, "", self._context)
            if isinstance(group, list):
                self._posts(noun, group)
            return group
        if noun.kind == "abstract":
            self.reading.lost.append(" ".join(noun.words))
        if noun.kind == "title":
            for post in noun.post:
                if isinstance(post, Carry):
                    self._list(post.items, None)
            return None
        shown = [p for p in noun.post if isinstance(p, Carry) and p.how == "of"]
        strange = noun.kind == "thing" and not noun.category and not noun.family
        if strange and shown and any(item.determined for item in shown[0].items):
            self.reading.lost.append(noun.head)  # "a packshot of three cans"
            first = shown[0].items[0]
            rest = [post for post in noun.post if post is not shown[0]]
            return self._noun(replace(first, post=[*first.post, *rest]), owner)
        if is_everything(noun) and self.reading.objects:
            return self._everything(noun)
        if noun.kind in ("setting", "vague", "abstract"):
            return self._loose(noun)
        if noun.kind == "part":
            if owner == TABLE:
                self.reading.table_parts.append(noun)
            return self._loose(noun)
        if noun.kind in ("member", "adjective"):
            return self._member(noun) or self._loose(noun)
        group = self._thing(noun)
        if group:
            self._context.mentioned.append(group)
            if noun.half and len(group) > 1:
                group = self._halve(group, self._said)
            self._posts(noun, group)
        return group or None

    def _everything(self, noun: Noun) -> Group:
        """Return the objects that "everything except the fork" refers to."""
        apart: Group = []
        for item in (i for post in noun.post if isinstance(post, Lack) for i in post.items):
            apart += find_referred(item, self.reading.objects)
        standing = [d for d in self.reading.objects if not is_supported(d) and d not in apart]
        self._posts(replace(noun, post=[p for p in noun.post if not isinstance(p, Lack)]), standing)
        return standing

    def _loose(self, noun: Noun) -> Target | None:
        """Interpret "a scene with" or "some things" as objects on the table."""
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
                "A scene has exactly one table, but the prompt describes several "
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
                    raise TURNED
                self._resolve(post, [])
        return TABLE

    def _posts(self, noun: Noun, group: Group) -> None:
        for post in noun.post:
            self._post(post, group, noun)

    def _post(self, post: Post, group: Group, noun: Noun | None) -> None:
        if isinstance(post, Location):
            target = self._resolve(post, group)
            if target is not None:
                self._attach(post, target, group)
                for draft in group:
                    draft.placed = draft.placed or post.kind not in ("on", "in")
        elif isinstance(post, Carry):
            if post.back != "between":
                self._carry(post, group, noun)
        elif isinstance(post, Lack):
            self._lack(post, group)
        elif isinstance(post, Arranged):
            self._arrange(post, group)
        elif isinstance(post, Counted):
            self._recount(int(post.count))
        else:
            if len(post.each) > len(group) == 1:
                return  # "a mug in different colours"
            for k, draft in enumerate(group):
                draft.attributes.update(post.each[k % len(post.each)])
                draft.lengths = post.lengths or draft.lengths

    def _resolve(self, place: Location, subject: Group) -> Target | None:
        """Interpret the noun phrase of a place's target; return None if the target is unknown."""
        context = self._context
        if isinstance(place.target, Zone):
            if place.table is not None and place.table.kind == "table":
                self._table(place.table)
            return TABLE
        noun = place.target
        self._read.add(noun.span)
        if place.kind == "otherside":
            return self._side[1] if self._side else None
        outer, context.subject = context.subject, subject
        try:
            if noun.kind == "pronoun":
                found = antecedent(noun, place.kind, context)
                sided = place.kind in ("left_of", "right_of", "in_front_of", "behind")
                return TABLE if found is None and sided else found  # "two cups in front"
            if place.each and len(subject) > 1 and _is_one(noun):
                return self._noun(replace(noun, count=float(len(subject))), None)
            if noun.each or (place.each and not noun.determined):
                found = [d for d in self.reading.objects if d.category == noun.category
                         and (noun.category or d.noun == noun.head)]  # fmt: skip
                if found:
                    return found
            part = noun.definite and noun.head in ("lid", "cap", "label", "rim")
            if part and not find_referred(noun, self.reading.objects, subject):
                whole = antecedent(_IT, place.kind, context)  # "on the lid"
                if whole is not None:
                    return whole
            bare = noun.kind == "thing" and not (noun.determined or noun.plural or noun.post)
            known = find_referred(replace(noun, definite=True), self.reading.objects, subject)
            if bare and known:  # "left of tray: ..."
                return known
            target = self._noun(noun, None)
        finally:
            context.subject = outer
        second = [post for post in noun.post if isinstance(post, Carry) and post.back == "between"]
        if second and isinstance(target, list):
            others = [self._noun(item, None) for item in second[0].items]
            target = target + [d for group in others if isinstance(group, list) for d in group]
        return target

    def _name_denied(self, noun: Noun, group: Group) -> None:
        """Add the object named by a negated place ("not on the book"), since it still exists."""
        context = self._context
        outer, context.subject = context.subject, group
        self._noun(noun, None)
        context.subject = outer


_IT = Noun("pronoun", ("it",), (0, 0), "it", definite=True)


def _is_pronoun(noun: Noun) -> bool:
    return noun.kind == "pronoun"


def _is_one(noun: Noun) -> bool:
    """Return whether a noun phrase introduces a single new object of a known kind."""
    several = (noun.count or 1) != 1 or noun.plural or noun.each
    return bool(noun.category) and not noun.definite and not several


def _describing(post: Description) -> Noun:
    words = tuple(word for each in post.each for value in each.values() for word in value.split())
    return Noun("adjective", words, (0, 0), attributes=dict(post.each[0]), lengths=post.lengths,
                upright=post.upright)  # fmt: skip
