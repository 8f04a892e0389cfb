"""From tokens to clauses: lists of objects, their modifiers, and predicates."""

from __future__ import annotations

from dataclasses import replace

from tabletop_objects import CATEGORIES

from ..phrases.nouns import read_noun
from ..phrases.tree import (
    Arranged,
    Carry,
    Clause,
    Lack,
    Location,
    Noun,
    Post,
    Sentence,
    is_everything,
)
from ..text import function_words as fw
from .cursor import ENDS
from .openings import OpeningReader, is_seat, people_of


class Parser(OpeningReader):
    """A recursive descent parser of sentences; the tokens that it skips are in ``skipped``."""

    def sentences(self) -> list[Sentence]:
        """Return all sentences."""
        found = []
        while self.i < len(self.tokens):
            if self._tag() in ENDS:
                self.i += 1
                continue
            found.append(self._sentence())
        return [sentence for sentence in found if sentence.clauses]

    def _sentence(self) -> Sentence:
        clauses: list[Clause] = []
        stated = any(token.tag not in ENDS for token in self.tokens[: self.i])
        self._task = "goal" if self._text() in ("goal", "task") and self._tag(1) in (
            "colon", "dash") else ""  # fmt: skip
        self.i += 2 * bool(self._task)
        if not stated:
            self._task = ""  # a goal without a task describes the scene
        while not self._ended():
            before = self.i
            clause = self._clause()
            if clause is not None:
                clauses.append(clause)
            clauses += self._pending
            self._pending = []
            while self._tag() in ("comma", "and", "dash", "close", "open", "colon"):
                self.i += 1
            if self.i == before:
                self.skipped.append(self.tokens[self.i])
                self.i += 1
        return Sentence(clauses)

    def _clause(self) -> Clause | None:
        if zone := self._heading_line():
            self._heading = Location("at", zone)
        if self._tag(1) == "relation" and self._text() in fw.PARTICIPLES:
            self.i += 1  # "sitting on it: ..."
        if (told := self._pronoun_clause()) is not None:
            aim = self._task
            return replace(told, predicate=[_as_aim(p) if aim else p for p in told.predicate])
        arrangement = self._opening() or self._listing()
        people = self._everyone() or self._people()
        lead = self._lead()
        if lead is None and people == 0:
            people = self._people()
        if people == 0 and self._text() == "for" and (self.i == 0 or self._tag(-1) in ENDS):
            noun, end = read_noun(self.tokens, self.i + 1)
            if noun is not None:  # "for the cat I need two bowls"
                self.i = end + (self.tokens[end].tag == "comma" if end < len(self.tokens) else 0)
                self._opening()
        self._skip(fw.BE | fw.STARTERS)
        subjects = self._items(None, "with")
        if self._ordered:
            arrangement, self._ordered = arrangement or Arranged("row", "listed"), False
        if arrangement is not None and subjects:
            if arrangement.order == "listed":
                subjects[-1].post.append(arrangement)
            else:
                subjects[0].post.insert(0, arrangement)
        if subjects and self._tag() == "comma" and self._text(1) in fw.BE:
            self.i += 1  # "two cars, a red and a green one, are parked ..."
        if (
            subjects
            and subjects[-1].each
            and self._text() in ("gets", "receives", "needs", "wants")
        ):
            self.i += 1  # "every plate gets its own glass"
            subjects[-1].post.append(Carry("with", tuple(self._items(subjects[-1], "with"))))
        predicate: list[Post] = []
        at_end = 0 if people else self._people()
        people = people or at_end
        if subjects and (guests := people_of(subjects[-1])):
            self._seats, self._guests = True, guests  # "board meeting, five people"
            subjects = subjects[:-1]
        if len(subjects) == 1 and self._tag() == "colon" and (laid := self._seats_named(subjects)):
            self.i += 1
            return Clause(self._items(None, "with"), people=laid)
        if at_end and subjects and is_seat(subjects[-1]) and self._tag() == "carry":
            return self._places(subjects, at_end)
        loose = all(noun.kind in ("setting", "title") for noun in subjects)
        if people and loose and self._tag() in ("colon", "dash"):
            self.i += 1
            subjects = self._items(None, "with")
        if subjects and self._tag() == "dash" and self._tag(1) == "no":
            self.i += 1  # "saw - not available"
        if subjects and self._is_left_out():
            listed = len(subjects) > 1 and "comma" in subjects[-1].joint
            if listed:  # "a cup, a plate, and the bowl has to be gone"
                self._pending.append(Clause([], [Lack((subjects[-1],))]))
                return Clause(subjects[:-1], [], lead, people)
            brought = [i for s in subjects for p in s.post if isinstance(p, Carry) for i in p.items]
            return Clause([], [Lack((*subjects, *brought))])
        if self._is_predicate(subjects):
            self.i += 1
            if self._tag() == "word" and self._text() in fw.PRONOUNS:
                self.i += 1  # "watches them from the corner"
            self._posts(None, predicate)
        single = self._text() in fw.SINGULAR
        if self._text() in fw.BE or self._tag() == "relative":
            self.i += 1
            self._skip(fw.BE | fw.PARTICIPLES | {"being"})
            self._posts(None, predicate)
            if not predicate and not self._ended() and self._tag() not in ("comma", "and"):
                predicate += self._complement()
                self._posts(None, predicate)
        elif not subjects:
            self._posts(None, predicate)
        if self._tag() in ("colon", "dash") and lead is None:
            self._read_headed(subjects, predicate)
        if len(subjects) == 1 and not predicate and lead is None and self._is_fragment(subjects[0]):
            subjects[0].kind = "abstract"
        if lead is None and self._heading is not None and subjects:
            lead = self._heading
        if not subjects and not predicate and lead is None and not people:
            return None
        aimed = not subjects or subjects[0].kind == "pronoun" or self._task == "goal"
        if self._task and aimed:
            predicate = [_as_aim(post) for post in predicate]  # "and put it in the basket"
            for noun in subjects:
                noun.post = [_as_aim(post) for post in noun.post]
        apart = single or (subjects and _is_rest(subjects[-1]))
        if apart and predicate and len(subjects) > 1 and "comma" in subjects[-1].joint:
            self._pending.append(Clause(subjects[-1:], predicate))
            return Clause(subjects[:-1], [], lead, people)
        return Clause(subjects, predicate, lead, people)

    def _places(self, subjects: list[Noun], people: int) -> Clause:
        """Parse "places for five with plates only" as the last item of a list."""
        self.i += 1
        laid = Clause(self._items(None, "with"), people=people)
        self._skip({"only"})
        if len(subjects) == 1:
            return laid
        self._pending.append(laid)
        return Clause(subjects[:-1])

    def _read_headed(self, subjects: list[Noun], predicate: list[Post]) -> None:
        """Parse "an office desk: a laptop, a mug", whose list belongs to the heading."""
        told = ("setting", "abstract", "title", "adjective")
        if subjects and all(noun.kind in told for noun in subjects[:-1]):
            del subjects[:-1]  # "a still life, everything on a cloth: ..."
        if len(subjects) == 1 and self._read_everything(subjects, predicate):
            return
        if len(subjects) != 1 or predicate:
            return
        first = subjects[0]
        named = first.kind == "vague" or (first.kind == "setting" and not first.determined)
        if (_is_title(first) or named) and self._starts_noun(1):
            first.kind = "title"
            if not first.post:
                return  # a separate clause follows
        roles = CATEGORIES[first.category].roles if first.category else ()
        if {"container", "support"} & {*roles} and not first.plural and self._starts_noun(1):
            self.i += 1
            first.post.append(Carry("hold", tuple(self._items(first, "hold"))))
            return
        if first.kind in ("table", "setting", "title"):
            self.i += 1
            arranged = [post for post in first.post if isinstance(post, Arranged)]
            items = self._items(subjects[0], "with")
            if items:
                items[-1].post += arranged
                first.post = [post for post in first.post if post not in arranged]
                first.post.append(Carry("with", tuple(items)))

    def _read_everything(self, subjects: list[Noun], predicate: list[Post]) -> bool:
        """Parse "everything except the fork is on the tray: a plate, a fork and a knife"."""
        first = subjects[0]
        places = [p for p in (*first.post, *predicate) if isinstance(p, Location)]
        if not is_everything(first) or not places or not self._starts_noun(1):
            return False
        self.i += 1
        items = self._items(None, "with")
        apart = [i for p in first.post if isinstance(p, Lack) for i in p.items]
        left = [item for item in items if any(_is_same(item, other) for other in apart)]
        subjects[:] = [item for item in items if item not in left]
        predicate[:] = [*(p for p in places if p not in predicate), *predicate]
        if left:
            self._pending.append(Clause(left))
        return True


def _is_rest(noun: Noun) -> bool:
    """Return whether a phrase means the objects not yet mentioned: "the others", "the rest"."""
    return noun.kind == "member" and noun.definite and noun.other and noun.plural


def _is_same(noun: Noun, other: Noun) -> bool:
    return noun.head == other.head and noun.category == other.category


def _as_aim(post: Post) -> Post:
    """Return a place as the goal to which a robot moves an object."""
    return replace(post, kind="aim") if isinstance(post, Location) else post


def _is_title(noun: Noun) -> bool:
    """Return whether a phrase before a colon is only a title: "Shaving kit: ..."."""
    if noun.determined or noun.kind not in ("thing", "abstract"):
        return False
    roles = CATEGORIES[noun.category].roles if noun.category else ()
    return not ({"container", "support"} & {*roles}) and not noun.post
