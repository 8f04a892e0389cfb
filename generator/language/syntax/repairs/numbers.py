"""Numbers in a text that its interpretation does not use, such as masses and percentages.

Every number in digits, with its sign, exponent and unit, is compared with the interpretation:
counts, numbers of people, and lengths. Numbers of parts ("a pot with 2 handles") have no effect,
whether in words or in digits. Ages, years, hours, ordinals, numbers of list items and numbers in
names ("WD-40", "iPhone 15") are not quantities.
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

_TIMES = (10, 12, 20, 100, 1000)  # units that a fraction can have
_SPELT = re.compile(rf"(?i)(?<![\w-])(?:{'|'.join(SPELT)})(?![\w-])")
_UNCOUNTED = ("part", "setting")
_NO_QUANTITY = ("title", "abstract")


@dataclass(frozen=True)
class NumberUse:
    """The unused numbers and the ranges in a text, in order of appearance.

    Attributes:
        unused: numbers that the interpretation does not use.
        ranges: ranges of which the interpretation uses the lower bound.
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
    """Return which quantities in a text are used.

    Args:
        text: the whole text.
        spelt: its tokens.
        said: the tokens after corrections, without remarks.
        sentences: the parsed tokens.
        people: numbers of people at the table.
        objects: number of objects on the table; larger counts are not used.
    """
    quantities = _quantities(sentences, people, objects)
    withdrawn = _places_of(spelt) - _places_of(said)  # taken back by the text, or part of a remark
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
    """Counts and lengths in the interpretation, and the noun phrases with their spans."""

    nouns: tuple[Noun, ...]
    counts: frozenset[float]
    lengths: tuple[float, ...]

    def use(self, number: WrittenNumber) -> bool:
        """Return whether the interpretation uses a number."""
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
    """Return the quantities in sentences, except those of parts and zones."""
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
    """Return the counts in noun phrases and their modifiers."""
    counts = {n.count for n in nouns if n.count is not None and (n.words or n.count % 1 == 0)}
    counts |= {float(n) for noun in nouns for n in noun.amount or ()}
    for post in posts:
        counts |= {post.count} if isinstance(post, Counted) else _alike(post.each)
    return counts | {count for noun in nouns for count in _alike(noun.variants)}


def _spelt_unused(text: str, nouns: Iterable[Noun]) -> Iterator[WrittenNumber]:
    """Yield spelled-out part counts ("three handles") and numbers in names ("ten euro note")."""
    for noun in nouns:
        start, end = noun.span
        found = _SPELT.search(text, start, end)
        described = noun.count == 1 and text[start : start + 2].lower() in ("a ", "an")
        if found and (noun.kind == "part" or described):
            yield WrittenNumber(found.group(), *found.span(), fw.NUMBERS[found.group().lower()])


def _places_of(tokens: Sequence[Token]) -> set[int]:
    """Return the positions of tokens in the text."""
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
    """Return whether a noun phrase has this count, possibly multiplied by another number."""
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
    """Return the numbers of objects that share a description, as in "2 blue, 3 white"."""
    return set(map(float, Counter(tuple(sorted(each.items())) for each in variants).values()))


def _kept_lengths(noun: Noun) -> tuple[float, ...]:
    """Return the lengths of a noun that determine a size: only the largest, except for tables."""
    if noun.kind == "table" or not noun.lengths:
        return noun.lengths
    return (max(noun.lengths),)


# ------------------------------------------------------------------------------------ all of it


def _nouns(sentence: Sentence) -> Iterator[Noun]:
    """Yield the noun phrases of a sentence, including nested ones."""
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
    """Return descriptions and counts, except counts after nouns that have a count of their own."""
    posts = [*predicate]
    for noun in nouns:
        posts += [p for p in noun.post if not isinstance(p, Counted) or noun.count is None]
    return [post for post in posts if isinstance(post, Counted | Description)]
