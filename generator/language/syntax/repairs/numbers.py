"""Numbers of a text that its reading does not use: masses, percentages, powers, distances, ...

Every number that is written in digits, with its sign, exponent and unit, is compared with what was
read: how many there are, for how many people, and how long things are. Numbers of parts ("a pot
with 2 handles") decide nothing, in words as in digits. Ages, years, hours, ordinals, numbers of
list items and numbers in names ("WD-40", "iPhone 15") are no quantities.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from ..phrases.tree import (
    Carry,
    Counted,
    Description,
    Lack,
    Location,
    Noun,
    Post,
    Sentence,
    Zone,
)
from ..text import function_words as fw
from ..text.figures import WrittenNumber, written_numbers
from ..text.numbers import SPELT
from ..text.tokens import Token

_TIMES = (10, 12, 20, 100, 1000)  # what fractions are counted in
_SPELT = re.compile(rf"(?i)(?<![\w-])(?:{'|'.join(SPELT)})(?![\w-])")
_UNCOUNTED = ("part", "setting")
_NO_QUANTITY = ("title", "abstract")


@dataclass(frozen=True)
class NumberUse:
    """What became of the numbers of a text, each in its order.

    Attributes:
        unused: numbers that the reading does not use.
        ranges: ranges of which it uses the lower bound.
    """

    unused: tuple[WrittenNumber, ...]
    ranges: tuple[WrittenNumber, ...]


def check_numbers(
    text: str,
    spelt: Sequence[Token],
    said: Sequence[Token],
    sentences: Sequence[Sentence],
    people: Iterable[int],
    objects: int,
) -> NumberUse:
    """Return which numbers of a text that are quantities were used.

    Args:
        text: the whole text.
        spelt: its tokens.
        said: the tokens that are left after corrections and without what is only talk.
        sentences: what was read of them.
        people: for how many people the table is.
        objects: how many there are on it; no larger count is used.
    """
    quantities = _quantities(sentences, people, objects)
    withdrawn = _places_of(spelt) - _places_of(said)  # taken back, or talk about the text
    numbers = [
        number
        for number in written_numbers(text)
        if number.role != "name" and not withdrawn.intersection(range(number.start, number.end))
    ]
    unused = [n for n in numbers if n.role == "aside" or not quantities.use(n)]
    ranges = [n for n in numbers if n.role == "range" and n not in unused]
    written = {place for n in numbers for place in range(n.start, n.end)}
    unused += [n for n in _spelt_unused(text, quantities.nouns) if n.start not in written]
    unused.sort(key=lambda number: number.start)
    return NumberUse(tuple(unused), tuple(ranges))


@dataclass(frozen=True)
class _Quantities:
    """Counts and lengths that were read, and the noun phrases with their places."""

    nouns: tuple[Noun, ...]
    counts: frozenset[float]
    lengths: tuple[float, ...]

    def use(self, number: WrittenNumber) -> bool:
        """Tell whether the reading uses a number."""
        around = [n for n in self.nouns if n.span[0] < number.end and number.start < n.span[1]]
        if any(noun.kind in _UNCOUNTED for noun in around):
            return False
        if number.unit:  # "20 cm", "5 dollars"
            coins = any(number.unit in n.words and n.count == number.value for n in around)
            return coins or _is_length(number, self.lengths)
        if any(noun.kind in _NO_QUANTITY for noun in around):
            return True
        return _is_count(number, around, self.counts) or _is_length(number, self.lengths)


def _quantities(sentences: Sequence[Sentence], people: Iterable[int], objects: int) -> _Quantities:
    """Return the quantities of sentences; those of parts and places are not used."""
    nouns = tuple(
        noun
        for sentence in sentences
        for noun in _nouns(sentence)
        if (noun.count or 0) <= objects or noun.kind in _UNCOUNTED
    )
    counted = [noun for noun in nouns if noun.kind not in _UNCOUNTED]
    posts = [post for s in sentences for c in s.clauses for post in _posts_of(c.predicate, counted)]
    counts = _read_counts(counted, posts)
    lengths = [v for noun in counted for v in _kept_lengths(noun)]
    lengths += [v for post in posts if isinstance(post, Description) for v in post.lengths]
    return _Quantities(
        nouns, frozenset({c for c in counts if c <= objects} | set(map(float, people))),
        tuple(lengths),
    )  # fmt: skip


def _read_counts(nouns: Sequence[Noun], posts: Sequence[Counted | Description]) -> set[float]:
    """Return how many there are of what noun phrases and what is said of them name."""
    counts = {n.count for n in nouns if n.count is not None and (n.words or n.count % 1 == 0)}
    counts |= {float(n) for noun in nouns for n in noun.amount or ()}
    for post in posts:
        counts |= {post.count} if isinstance(post, Counted) else _alike(post.each)
    return counts | {count for noun in nouns for count in _alike(noun.variants)}


def _spelt_unused(text: str, nouns: Iterable[Noun]) -> Iterator[WrittenNumber]:
    """Yield numbers in words that count parts ("three handles") or describe ("a ten euro note")."""
    for noun in nouns:
        start, end = noun.span
        found = _SPELT.search(text, start, end)
        described = noun.count == 1 and text[start : start + 2].lower() in ("a ", "an")
        if found and (noun.kind == "part" or described):
            yield WrittenNumber(found.group(), *found.span(), fw.NUMBERS[found.group().lower()])


def _places_of(tokens: Sequence[Token]) -> set[int]:
    """Return the places in the text at which tokens stand."""
    return {place for token in tokens for place in range(*token.span)}


def _is_count(number: WrittenNumber, around: Sequence[Noun], elsewhere: Iterable[float]) -> bool:
    if number.text in ("1/2", "½"):
        return any("half" in noun.words for noun in around)
    if number.value is None:
        return False
    if any(_counts(noun, number.value) for noun in around):
        return True
    if any(noun.kind == "thing" and noun.count is not None for noun in around):
        return False
    return number.value in elsewhere


def _counts(noun: Noun, value: float) -> bool:
    """Tell whether a noun phrase counts its things by a number, perhaps times another."""
    if value in (noun.amount or ()) or abs(noun.ordinal) == value:
        return True
    count = noun.count or 0.0
    if value % 1:  # "1.5 dozen", "1.5e1"
        return any(abs(times * value - count) < 1e-9 for times in _TIMES)
    return 0 < value <= count and count % value == 0


def _is_length(number: WrittenNumber, lengths: Sequence[float]) -> bool:
    if number.value is None or not lengths:
        return False
    factors = [fw.MEASURES[number.unit]] if number.unit in fw.MEASURES else []
    factors += [] if number.unit else list(set(fw.MEASURES.values()))  # "120 x 60 cm"
    return any(abs(number.value * f - v) <= 2e-3 * v for f in factors for v in lengths)


def _alike(variants: Sequence[Mapping[str, str]]) -> set[float]:
    """Return how many of several things are described alike: "2 blue, 3 white"."""
    return set(map(float, Counter(tuple(sorted(each.items())) for each in variants).values()))


def _kept_lengths(noun: Noun) -> tuple[float, ...]:
    """Return the lengths of a noun that decide a size: of a thing's, the largest alone."""
    if noun.kind == "table" or not noun.lengths:
        return noun.lengths
    return (max(noun.lengths),)


# ------------------------------------------------------------------------------------ all of it


def _nouns(sentence: Sentence) -> Iterator[Noun]:
    """Yield the noun phrases of a sentence, with those that belong to others."""
    for clause in sentence.clauses:
        for noun in clause.subjects:
            yield from _with_inner(noun)
        for post in (*clause.predicate, *([clause.lead] if clause.lead else [])):
            yield from _nouns_of(post)


def _with_inner(noun: Noun) -> Iterator[Noun]:
    yield noun
    for post in noun.post:
        yield from _nouns_of(post)


def _nouns_of(post: Post) -> Iterator[Noun]:
    if isinstance(post, Location):
        if not isinstance(post.target, Zone):
            yield from _with_inner(post.target)
        if post.table is not None:
            yield from _with_inner(post.table)
    elif isinstance(post, Carry | Lack):
        for noun in post.items:
            yield from _with_inner(noun)
        if isinstance(post, Lack) and post.place is not None:
            yield from _nouns_of(post.place)


def _posts_of(predicate: Sequence[Post], nouns: Sequence[Noun]) -> list[Counted | Description]:
    """Return descriptions and counts; "a mug (2)" has its count before."""
    posts = [*predicate]
    for noun in nouns:
        posts += [p for p in noun.post if not isinstance(p, Counted) or noun.count is None]
    return [post for post in posts if isinstance(post, Counted | Description)]
