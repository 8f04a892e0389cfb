"""Parse tree of a text: noun phrases, their modifiers, clauses; a walk over all phrases."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

NounKind = Literal[
    "thing",  # a category of the catalogue, or a word that may be a thing
    "collective",  # "cutlery": several categories
    "table",
    "pronoun",
    "part",  # of a thing: legs, lid, surface
    "setting",  # a room, an hour, an occasion: no thing
    "title",  # "Shaving kit: ...": what a list is about
    "vague",  # "things", "stuff"
    "abstract",  # what is no thing: "happiness"
    "member",  # "one", "the other", "two of them"
    "adjective",  # describing words alone
]
Arrangement = Literal[
    "stack", "heap", "pyramid", "row", "column", "circle", "fan", "scatter", "grid", "group"
]
How = Literal["with", "hold", "of"]
Span = tuple[int, int]


@dataclass(frozen=True)
class Zone:
    """A place on the table, seen from in front of it.

    Attributes:
        x: -1 left, 0 middle, 1 right; None where it is not said.
        y: -1 front, 0 middle, 1 back; None where it is not said.
        edge: at the edge there; alone, at any edge.
        spread: one thing in each: "in the corners".
    """

    x: int | None = None
    y: int | None = None
    edge: bool = False
    spread: bool = False


@dataclass(frozen=True)
class Location:
    """Where a thing is: a relation to a noun phrase, or a zone of the table.

    ``each``: every single one of the subjects has its own ("each on a saucer") or every target
    its own subject ("on every plate"). ``table``: what is said of the table in a zone ("in the
    middle of a round table"). ``whole``: said of all that is listed ("..., all on a tray").
    """

    kind: str
    target: Noun | Zone
    each: bool = False
    table: Noun | None = None
    whole: bool = False


@dataclass(frozen=True)
class Carry:
    """What a thing brings along: "with", "holding" or "of" (a bowl of apples).

    ``back`` is "on" or "in" where the list ends so ("with an apple and a pear on it").
    """

    how: How
    items: tuple[Noun, ...]
    each: bool = False
    back: str | None = None


@dataclass(frozen=True)
class Lack:
    """What a thing is said to be without; ``place``: where it is said not to be."""

    items: tuple[Noun, ...]
    place: Location | None = None


@dataclass(frozen=True)
class Arranged:
    """How several things are arranged.

    ``order`` is "size", "size down" (the largest first), "color" or "listed" (from left to right
    as they are named) where it is said.
    """

    kind: Arrangement
    order: str | None = None


@dataclass(frozen=True)
class Description:
    """Attributes said after the noun: all the same, or one after the other for each.

    ``lengths``: "20 cm long", metres; ``upright`` where they are its height.
    """

    each: tuple[Mapping[str, str], ...]
    lengths: tuple[float, ...] = ()
    upright: bool = False


@dataclass(frozen=True)
class Counted:
    """How many there are of what was named without a number: "... (there are 5)"."""

    count: float


VARIED: Mapping[str, tuple[Mapping[str, str], ...]] = {
    "color": tuple({"color": word} for word in (
        "red", "blue", "yellow", "green", "white", "orange", "purple", "black")),
    "size": tuple({"size": word} for word in ("small", "medium", "large")),
}  # fmt: skip
"""What "in different colours" and "of various sizes" mean, one after the other."""


Post = Location | Carry | Lack | Arranged | Description | Counted


@dataclass
class Noun:
    """A noun phrase with all that is said of it.

    Attributes:
        kind: what sort of noun it is.
        words: its describing words and head, as they were said.
        span: where it stands in the text.
        head: the noun in the singular ("teapot").
        category: key of the catalogue; None where it has none.
        count: the number that is said; None where none is.
        amount: range of a vague number ("a few").
        definite: "the", "this".
        other: "the other", "a second".
        each: "each", "every".
        ordinal: which one of several, from 1 on; -1 the last; 0 where it is not said.
        plural: several things by its form.
        attributes: "color", "material", "size", "state", ... to words.
        variants: attributes of single ones ("red, green and blue cubes").
        members: categories of a collective.
        lengths: lengths in metres ("20 cm long").
        half: whether half of them are meant ("half of the apples").
        upright: whether its one length is its height ("20 cm tall").
        arrangement: "a stack of", "stacked".
        position: "left", "right", ... ("the left plate").
        post: what follows the noun and belongs to it.
        seated: so many for each person.
        joint: how it is joined to the item before it in its list: "", "and", "comma".
        family: kind of thing that stands for one without a category ("appliance").
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
        """Whether an article, a number or a vague amount introduces it."""
        return self.definite or self.count is not None or self.amount is not None or self.each


def is_everything(noun: Noun) -> bool:
    """Tell whether a phrase means all there is: "everything", "all things"."""
    return noun.words == ("everything",) or (
        noun.kind == "vague" and noun.definite and noun.plural and len(noun.words) == 1
    )


EVERYONE = -1
"""People of whom the text has said before how many they are."""


@dataclass
class Clause:
    """A list of things and what is said of all of them.

    Attributes:
        subjects: the list.
        predicate: what a verb says of all of them ("... are on the tray").
        lead: the place said before them ("On the tray are ...").
        people: for how many the things are laid; 0 where it is not said, ``EVERYONE`` for as many
            as were said before.
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
    """Return the things of the sentences, in the text's words, whose place was never read."""
    return [
        " ".join(noun.words)
        for noun in _nouns(sentences)
        if noun.kind == "thing" and noun.span not in read and noun.span != (0, 0)
    ]


def find_spans(noun: Noun) -> list[Span]:
    """Return where a noun phrase and all those in it stand."""
    return [inner.span for inner in _nouns_of(noun)]


def find_things(sentences: Sequence[Sentence]) -> list[Span]:
    """Return where the names of things stand: of a lab coat, no lab."""
    return [noun.span for noun in _nouns(sentences) if noun.kind == "thing"]


def find_denied(sentences: Sequence[Sentence], pictures: Collection[str]) -> list[Span]:
    """Return where stands what is not there, and what ``pictures`` only show."""
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
