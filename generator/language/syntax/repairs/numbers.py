"""Numbers of a text that its reading does not use: masses, percentages, powers, distances, ...

Every number that is written in digits, with its sign, exponent and unit, is compared with what was
read: how many there are, for how many people, and how long things are. What is no quantity is left
out: ages, years, hours, ordinals, numbers of list items and numbers in names ("WD-40", "iPhone
15").
"""

from __future__ import annotations

import re
import unicodedata
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
from ..text.tokens import Token

_OTHER_UNITS = (
    r"kg|kilos?|kilograms?|kilogrammes?|mg|g|grams?|grammes?|tonnes?|tons?|"
    r"oz|ounces?|lbs?|pounds?|ml|millilit(?:er|re)s?|cl|dl|l|lit(?:er|re)s?|pints?|gallons?|"
    r"degrees?|deg|radians?|rad|percent|per cent|watts?|w|kw|volts?|v|amps?|newtons?|n|hz|khz|mhz|"
    r"ghz|db|rpm|mah|gb|tb|mb|dollars?|euros?|cents?|kelvin|celsius|fahrenheit|hours?|minutes?|"
    r"seconds?|megapixels?|mp"
)
_LENGTHS = "|".join(sorted(fw.MEASURES, key=len, reverse=True))
_SPELT = "|".join(sorted((w for w, n in fw.NUMBERS.items() if n > 1), key=len, reverse=True))
_DIGITS = r"\d+(?:,\d{3})*(?:\.\d+)?"
_FRACTIONS = "½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞"
_SIGNS = r"%|°\s?[CF]?|℃|℉|[€£¥$]|[″”\"](?!\w)"
_NUMBER = re.compile(
    rf"""(?ix)
    (?P<name>(?<![a-z])[a-z]+[-_]?(?={_DIGITS}))?            # "WD-40", "PS5", "block_2"
    (?P<sign>[$€£¥]\s?|(?<![\w.)])[-−])?
    (?:
        (?<![\d.])(?P<digits>\d+,\d+(?=\s?(?:{_SIGNS}|(?:{_LENGTHS}|{_OTHER_UNITS})(?![a-z])))
                           |{_DIGITS}(?:(?:[ -]\d+)?/\d+|\s?[{_FRACTIONS}])?)
        (?P<power>\s?(?:[x×*]\s?10\s?)?(?:\^|\*\*)\s?[-+]?\d+|[⁰¹²³⁴-⁹]+|e[-+]\d+)?
        |(?<![\w-])(?P<spelt>(?:(?:{_SPELT})[ -])+)(?=(?:{_OTHER_UNITS})\b)(?!pint)
    )
    (?P<unit>\s?(?:{_SIGNS})|[ -]?(?:{_LENGTHS}|{_OTHER_UNITS})(?![a-z]))?
    """
)
_AGE = re.compile(r"(?i)[ -]?years?[ -]olds?\b|[ -]?(?:st|nd|rd|th|s)\b(?!\s?[-–])")
_HOUR = re.compile(r"(?i):[0-5]\d\b|\s?(?:[ap]\.?m\b|o'clock)|\s?[:]\d{1,2}\b")
_YEAR = re.compile(r"1[5-9]\d\d|20\d\d")
_ITEM = re.compile(r"(?:^|[\n;,:.(]|\s)\s*$")
_NAMED = re.compile(r"(?:\b[A-Z]\w*|\b(?:[Nn]o|[Nn]r|[Ss]ize|[Pp]age|[Vv]ersion|[Mm]odel)\.?)\s$")
_TIMES = (10, 12, 20, 100, 1000)  # what fractions are counted in
_NO_QUANTITY = ("setting", "title", "abstract")


@dataclass(frozen=True)
class WrittenNumber:
    """A number as it stands in a text.

    ``value`` is None where it is no plain number ("10^9"), ``unit`` "" where it has none.
    """

    text: str
    start: int
    end: int
    value: float | None
    unit: str = ""


def unused_numbers(
    text: str,
    spelt: Sequence[Token],
    said: Sequence[Token],
    sentences: Sequence[Sentence],
    people: Iterable[int],
) -> list[str]:
    """Return the numbers of a text that say something, and were not used, in its order.

    Args:
        text: the whole text.
        spelt: its tokens.
        said: the tokens that are left after corrections and without what is only talk.
        sentences: what was read of them.
        people: for how many people the table is.
    """
    nouns = [noun for sentence in sentences for noun in _nouns(sentence)]
    counts = {n.count for n in nouns if n.count is not None and (n.words or n.count % 1 == 0)}
    counts |= {float(n) for n in people}
    amounts = {float(n) for noun in nouns for n in noun.amount or ()}
    posts = [post for s in sentences for c in s.clauses for post in _posts_of(c.predicate, nouns)]
    for post in posts:
        counts |= {post.count} if isinstance(post, Counted) else _alike(post.each)
    counts |= {count for noun in nouns for count in _alike(noun.variants)}
    lengths = [v for noun in nouns for v in _kept_lengths(noun)]
    lengths += [v for post in posts if isinstance(post, Description) for v in post.lengths]
    withdrawn = _places_of(spelt) - _places_of(said)  # taken back, or talk about the text
    unused: list[str] = []
    for number in written_numbers(text):
        if withdrawn.intersection(range(number.start, number.end)):
            continue
        if number.unit:
            used = _is_length(number, lengths)
        else:
            around = [n for n in nouns if n.span[0] <= number.start and number.end <= n.span[1]]
            used = _is_count(number, around, counts | amounts) or _is_length(number, lengths)
            used = used or any(noun.kind in _NO_QUANTITY for noun in around)
        if not used:
            unused.append(number.text)
    return list(dict.fromkeys(unused))


def written_numbers(text: str) -> Iterator[WrittenNumber]:
    """Yield the quantities that a text has in digits, and those in words with a unit of mass etc.

    Lengths in words are read as numbers before.
    """
    for found in _NUMBER.finditer(text):
        if found["name"] or (found["digits"] and _is_name(text, found)):
            continue
        digits = found["digits"] or ""
        unit = (found["unit"] or "").strip(" -").lower() or (found["sign"] or "").strip("-− ")
        if unit == '"' and text[: found.start()].endswith('"'):  # a number between quotes
            unit = ""
        part = re.compile(r"-[a-z]+", re.IGNORECASE).match(text, found.end())  # "3-legged"
        yield WrittenNumber(
            found.group().strip(" -") + (part.group() if part else ""), *found.span(),
            None if found["power"] else _value(digits), unit,
        )  # fmt: skip


def _value(digits: str) -> float | None:
    """Return the value of "1,000", "2.5", "3 1/2" and "3½"; None of what is no such number."""
    whole = re.fullmatch(
        rf"(?P<whole>{_DIGITS})(?:[ -](?P<over>\d+)/(?P<under>\d+)|\s?(?P<sign>[{_FRACTIONS}]))?",
        digits,
    )
    if whole is None:
        return None
    part = unicodedata.numeric(whole["sign"]) if whole["sign"] else 0.0
    if whole["under"] and int(whole["under"][:9]):
        part = int(whole["over"][:9]) / int(whole["under"][:9])
    return float(whole["whole"].replace(",", "")) + part


def _is_name(text: str, found: re.Match[str]) -> bool:
    """Tell whether digits are no quantity: an age, a year, an hour, an ordinal, or of a name."""
    before, after = text[: found.start("digits")], text[found.end() :]
    if (found["unit"] or "").strip(' "') or found["power"]:
        return False
    digits = found["digits"]
    if _AGE.match(after) or _HOUR.match(after) or re.search(r"\d:$", before):
        return True
    if _YEAR.fullmatch(digits) or re.match(r"[A-Za-z]*[A-Z]|up\b", after):  # "1990", "4K", "7up"
        return True
    if re.match(r"[.)](?:\s|$)", after) and _ITEM.search(before) and "(" not in before[-2:]:
        return after[0] == ")" or not before.rpartition("\n")[2].strip()  # of a list
    sentence = re.split(r"[.!?\n]\s*", before)[-1].strip()
    named = _NAMED.search(before)
    return named is not None and named.group().strip() != sentence


def _places_of(tokens: Sequence[Token]) -> set[int]:
    """Return the places in the text at which tokens stand."""
    return {place for token in tokens for place in range(*token.span)}


def _is_count(
    number: WrittenNumber, around: Sequence[Noun], elsewhere: Iterable[float | None]
) -> bool:
    if number.value is None:
        return "/" in number.text and any("half" in noun.words for noun in around)
    if any(_counts(noun, number.value) for noun in around):
        return True
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
    posts = [*predicate, *(post for noun in nouns for post in noun.post)]
    return [post for post in posts if isinstance(post, Counted | Description)]
