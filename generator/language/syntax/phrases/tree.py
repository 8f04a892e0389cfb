"""Parse tree of a text: noun phrases, their modifiers, clauses; traversal of all phrases."""

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
    "adjective",  # only describing words
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
        edge: at the edge there; without x and y, at any edge.
        spread: one object in each: "in the corners".
    """

    x: int | None = None
    y: int | None = None
    edge: bool = False
    spread: bool = False


@dataclass(frozen=True)
class Location:
    """Place of an object: a relation to a noun phrase, or a zone of the table.

    ``each``: each subject has its own target ("each on a saucer"), or each target its own subject
    ("on every plate"). ``table``: modifiers of the table in a zone ("in the middle of a round
    table"). ``whole``: applies to the whole list ("..., all on a tray").
    """

    kind: str
    target: Noun | Zone
    each: bool = False
    table: Noun | None = None
    whole: bool = False


@dataclass(frozen=True)
class Carry:
    """Objects attached to an object by "with", "holding" or "of" (a bowl of apples).

    ``back`` is "on" or "in" for lists that end accordingly ("with an apple and a pear on it").
    """

    how: How
    items: tuple[Noun, ...]
    each: bool = False
    back: str | None = None


@dataclass(frozen=True)
class Lack:
    """Objects that an object lacks; ``place``: a place that is denied."""

    items: tuple[Noun, ...]
    place: Location | None = None


@dataclass(frozen=True)
class Arranged:
    """Arrangement of several objects.

    ``order`` is "size", "size down" (largest first), "color" or "listed" (from left to right in the
    order of the text), if stated.
    """

    kind: Arrangement
    order: str | None = None


@dataclass(frozen=True)
class Description:
    """Attributes after the noun: the same for all, or one entry for each object.

    ``lengths``: "20 cm long", metres; ``upright`` if they are heights.
    """

    each: tuple[Mapping[str, str], ...]
    lengths: tuple[float, ...] = ()
    upright: bool = False


@dataclass(frozen=True)
class Counted:
    """Count of a noun that was named without a number: "... (there are 5)"."""

    count: float


VARIED: Mapping[str, tuple[Mapping[str, str], ...]] = {
    "color": tuple({"color": word} for word in (
        "red", "blue", "yellow", "green", "white", "orange", "purple", "black")),
    "size": tuple({"size": word} for word in ("small", "medium", "large")),
}  # fmt: skip
"""Attributes for "in different colours" and "of various sizes", used in turn."""


Post = Location | Carry | Lack | Arranged | Description | Counted


@dataclass
class Noun:
    """A noun phrase with all its modifiers.

    Attributes:
        kind: sort of noun.
        words: describing words and head, as written.
        span: position in the text.
        head: the noun in the singular ("teapot").
        category: key of the catalogue; None if there is none.
        count: the stated number; None if there is none.
        amount: range of a vague number ("a few").
        definite: "the", "this".
        other: "the other", "a second".
        each: "each", "every".
        ordinal: index of one of several, from 1; -1 for the last; 0 if not stated.
        plural: several objects by its form.
        attributes: maps "color", "material", "size", "state", ... to words.
        variants: attributes of individual objects ("red, green and blue cubes").
        members: categories of a collective.
        lengths: lengths in metres ("20 cm long").
        half: whether only half of them are meant ("half of the apples").
        upright: whether its only length is its height ("20 cm tall").
        arrangement: "a stack of", "stacked".
        position: "left", "right", ... ("the left plate").
        post: modifiers after the noun.
        seated: number per person.
        joint: connector to the previous item of its list: "", "and", "comma".
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
"""Value of ``Clause.people`` if their number was stated earlier."""


@dataclass
class Clause:
    """A list of objects and its predicate.

    Attributes:
        subjects: the list.
        predicate: modifiers by a verb for all of them ("... are on the tray").
        lead: the place before them ("On the tray are ...").
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
    """Return the objects of the sentences, as written, whose place was not interpreted."""
    return [
        " ".join(noun.words)
        for noun in _nouns(sentences)
        if noun.kind == "thing" and noun.span not in read and noun.span != (0, 0)
    ]


def find_spans(noun: Noun) -> list[Span]:
    """Return the spans of a noun phrase and of all noun phrases in it."""
    return [inner.span for inner in _nouns_of(noun)]


def find_things(sentences: Sequence[Sentence]) -> list[Span]:
    """Return the spans of object names: of a lab coat, but not of a lab."""
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
