"""The parse tree of a text (noun phrases, their modifiers and clauses), and its traversal."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

NounKind = Literal[
    "thing",  # a category of the catalogue, or an unknown object
    "collective",  # "cutlery": several categories
    "table",
    "pronoun",
    "part",  # part of an object: legs, lid, surface
    "setting",  # a room, a time, an occasion: not an object
    "title",  # "Shaving kit: ...": title of a list
    "vague",  # "things", "stuff"
    "abstract",  # not an object: "happiness"
    "member",  # "one", "the other", "two of them"
    "adjective",  # consists only of describing words
]
Arrangement = Literal[
    "stack", "heap", "pyramid", "row", "column", "circle", "fan", "scatter", "grid", "group"
]
How = Literal["with", "hold", "of"]
Span = tuple[int, int]


@dataclass(frozen=True)
class Zone:
    """A zone of the table, as seen from the front.

    Attributes:
        x: -1 left, 0 middle, 1 right; None if not stated.
        y: -1 front, 0 middle, 1 back; None if not stated.
        edge: whether the zone is at the edge there; without x and y, at any edge.
        spread: whether there is one object in each such zone: "in the corners".
    """

    x: int | None = None
    y: int | None = None
    edge: bool = False
    spread: bool = False


@dataclass(frozen=True)
class Location:
    """The place of an object: a relation to a noun phrase, or a zone of the table.

    ``each`` means that each subject has its own target ("each on a saucer"), or each target its own
    subject ("on every plate"). ``table`` holds the modifiers of the table that a zone mentions ("in
    the middle of a round table"). ``whole`` means that the place applies to the whole list ("...,
    all on a tray").
    """

    kind: str
    target: Noun | Zone
    each: bool = False
    table: Noun | None = None
    whole: bool = False


@dataclass(frozen=True)
class Carry:
    """Objects attached to another object by "with", "holding" or "of" (a bowl of apples).

    ``back`` is "on" or "in" if the list ends with "on it" or "in it" ("with an apple and a pear on
    it").
    """

    how: How
    items: tuple[Noun, ...]
    each: bool = False
    back: str | None = None


@dataclass(frozen=True)
class Lack:
    """Objects that an object lacks, or a ``place`` where the object is said not to be."""

    items: tuple[Noun, ...]
    place: Location | None = None


@dataclass(frozen=True)
class Arranged:
    """The arrangement of several objects.

    ``order``, if stated, is "size", "size down" (largest first), "color" or "listed" (from left to
    right in the order of the text).
    """

    kind: Arrangement
    order: str | None = None


@dataclass(frozen=True)
class Description:
    """Attributes that follow the noun: the same for all objects, or one entry for each object.

    ``lengths`` are lengths such as "20 cm long", in metres; ``upright`` means that they are
    heights.
    """

    each: tuple[Mapping[str, str], ...]
    lengths: tuple[float, ...] = ()
    upright: bool = False


@dataclass(frozen=True)
class Counted:
    """The count of a noun that was named without a number: "... (there are 5)"."""

    count: float


VARIED: Mapping[str, tuple[Mapping[str, str], ...]] = {
    "color": tuple({"color": word} for word in (
        "red", "blue", "yellow", "green", "white", "orange", "purple", "black")),
    "size": tuple({"size": word} for word in ("small", "medium", "large")),
}  # fmt: skip
"""Attributes that "in different colours" and "of various sizes" stand for, used in turn."""


Post = Location | Carry | Lack | Arranged | Description | Counted


@dataclass
class Noun:
    """A noun phrase with all its modifiers.

    Attributes:
        kind: sort of noun.
        words: describing words and the head, as written.
        span: position in the text.
        head: the noun in the singular ("teapot").
        category: key of the catalogue; None if there is none.
        count: the stated number; None if there is none.
        amount: range of a vague number ("a few").
        definite: whether it has "the" or "this".
        other: whether it has "the other" or "a second".
        each: whether it has "each" or "every".
        ordinal: index of one of several objects, from 1; -1 means the last, 0 that none is stated.
        plural: whether its form means several objects.
        attributes: maps "color", "material", "size", "state", ... to words.
        variants: attributes of individual objects ("red, green and blue cubes").
        members: categories of a collective.
        lengths: lengths in metres ("20 cm long").
        half: whether only half of the objects are meant ("half of the apples").
        upright: whether its only length is its height ("20 cm tall").
        arrangement: "a stack of", "stacked".
        position: "left", "right", ... ("the left plate").
        post: modifiers after the noun.
        seated: number of objects per person.
        joint: connector to the previous item in its list: "", "and", "comma".
        family: kind of object that represents a noun without a category ("appliance").
    """

    kind: NounKind
    words: tuple[str, ...]
    span: Span
    head: str = ""
    category: str | None = None
    count: float | None = None
    amount: tuple[int, int] | None = None
    definite: bool = False
    other: bool = False
    each: bool = False
    plural: bool = False
    attributes: dict[str, str] = field(default_factory=dict)
    variants: tuple[Mapping[str, str], ...] = ()
    members: tuple[str, ...] = ()
    lengths: tuple[float, ...] = ()
    arrangement: Arrangement | None = None
    position: str | None = None
    post: list[Post] = field(default_factory=list)
    ordinal: int = 0
    seated: bool = False
    joint: str = ""
    family: str = ""
    upright: bool = False
    half: bool = False

    @property
    def determined(self) -> bool:
        """Whether the phrase has an article, a number or a vague amount."""
        return self.definite or self.count is not None or self.amount is not None or self.each


def is_everything(noun: Noun) -> bool:
    """Return whether a phrase means all objects: "everything", "all things"."""
    return noun.words == ("everything",) or (
        noun.kind == "vague" and noun.definite and noun.plural and len(noun.words) == 1
    )


EVERYONE = -1
"""Value of ``Clause.people`` if the number of people was stated earlier."""


@dataclass
class Clause:
    """A list of objects and its predicate.

    Attributes:
        subjects: the list.
        predicate: modifiers that a verb adds to all of them ("... are on the tray").
        lead: the place that precedes them ("On the tray are ...").
        people: number of people for whom the objects are laid; 0 if not stated, ``EVERYONE`` for
            the number stated earlier.
    """

    subjects: list[Noun]
    predicate: list[Post] = field(default_factory=list)
    lead: Location | None = None
    people: int = 0


@dataclass
class Sentence:
    """The clauses of one sentence."""

    clauses: list[Clause]


def list_unread(sentences: Sequence[Sentence], read: Collection[Span]) -> list[str]:
    """Return the objects whose place was not interpreted, in the words of the sentences."""
    return [
        " ".join(noun.words)
        for noun in _nouns(sentences)
        if noun.kind == "thing" and noun.span not in read and noun.span != (0, 0)
    ]


def find_spans(noun: Noun) -> list[Span]:
    """Return the spans of a noun phrase and of all noun phrases that it contains."""
    return [inner.span for inner in _nouns_of(noun)]


def find_things(sentences: Sequence[Sentence]) -> list[Span]:
    """Return the spans of object names, such as "lab coat" but not "lab"."""
    return [noun.span for noun in _nouns(sentences) if noun.kind == "thing"]


def find_denied(sentences: Sequence[Sentence], pictures: Collection[str]) -> list[Span]:
    """Return the spans of denied objects and of objects that ``pictures`` depict."""
    shown = [
        item.span
        for noun in _nouns(sentences)
        if {noun.category, *noun.head.split()[-1:]} & {*pictures}
        for post in noun.post
        if isinstance(post, Carry) and post.how == "of"
        for carried in post.items
        for item in _nouns_of(carried)
    ]
    return [*shown, *(item.span for post in _posts(sentences) for item in _lacking(post))]


def _lacking(post: Post) -> Sequence[Noun]:
    return post.items if isinstance(post, Lack) else ()


def _posts(sentences: Sequence[Sentence]) -> Iterator[Post]:
    for noun in _nouns(sentences):
        yield from noun.post
    for sentence in sentences:
        for clause in sentence.clauses:
            yield from clause.predicate


def _nouns(sentences: Sequence[Sentence]) -> Iterator[Noun]:
    for sentence in sentences:
        for clause in sentence.clauses:
            for noun in clause.subjects:
                yield from _nouns_of(noun)
            lead = [clause.lead] if clause.lead is not None else []
            for post in (*lead, *clause.predicate):
                yield from _nouns_in(post)


def _nouns_of(noun: Noun) -> Iterator[Noun]:
    yield noun
    for post in noun.post:
        yield from _nouns_in(post)


def _nouns_in(post: Post) -> Iterator[Noun]:
    if isinstance(post, Location) and isinstance(post.target, Noun):
        yield from _nouns_of(post.target)
    elif isinstance(post, Carry):
        for item in post.items:
            yield from _nouns_of(item)
    elif isinstance(post, Lack) and post.place is not None:
        yield from _nouns_in(post.place)
