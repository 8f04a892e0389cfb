"""How noun phrases begin: articles, numbers, lengths and "a stack of"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from ...lexicon import category_of
from ...vocabulary import COLORS, MATERIALS, SHADES, SIZES, STATES
from ...words.dictionary import is_adjective
from ..text import function_words as fw
from ..text.numbers import SPELT
from ..text.tokens import Token
from .tree import Arrangement

MORE = frozenset({
    "medium", "sized", "middle", "smallest", "largest", "biggest", "tallest", "shortest", "opened",
    "shut", "empty", "topmost", "uppermost",
})  # fmt: skip


_DEGREES = frozenset({
    "whole", "about", "around", "exactly", "approximately", "roughly", "only", "just", "nearly",
    "at", "least", "most",
})  # fmt: skip
_FURTHER = frozenset({"more", "extra", "additional", "further"})


_EXTENTS = ("tall", "high", "long", "wide", "deep", "across", "diameter", "thick")
_UPRIGHT = ("tall", "high")
_MADE = (("out", "of"), ("from",), ("made", "of"), ("made", "from"), ("made", "out", "of"),
         ("built", "of"), ("built", "from"), ("using",))  # fmt: skip
"""Words between an arrangement and its objects: "a pyramid out of six blocks"."""


@dataclass
class PhraseStart:
    """The state of a noun phrase while its introduction is parsed."""

    numbers: list[float] = field(default_factory=list)
    described: bool = False  # "a 300 page book": the number follows "a"
    amount: tuple[int, int] | None = None
    article: bool = False
    pair: bool = False
    definite: bool = False
    other: bool = False
    each: bool = False
    ordinal: int = 0
    closed: bool = False
    groups: float = 0.0
    arrangement: Arrangement | None = None
    posture: str = ""
    several: bool = False  # "the others"
    portion: bool = False  # "a slice of": singular, whatever the form of the noun
    words: list[str] = field(default_factory=list)
    variants: list[list[str]] = field(default_factory=list)
    lengths: list[float] = field(default_factory=list)
    upright: bool = False  # "20 cm tall"
    name: tuple[str, ...] = ()
    first: int = 0


def read_introduction(tokens: Sequence[Token], i: int, run: PhraseStart) -> int:
    """Parse articles, numbers, lengths and "a stack of"; return where they end."""
    while i < len(tokens) and not run.closed:
        token = tokens[i]
        step = (
            0
            if token.text == "both"
            else (
                _weight(tokens, i)
                or _measure(tokens, i, run)
                or _group(tokens, i, run)
                or _number(tokens, i, run)
            )
        )
        if step:
            i += step
        elif token.tag == "each":
            run.each = True
            i += 1 + _is_of(tokens, i + 1)
        elif token.tag != "word":
            break
        elif (
            token.text == "both"
            and tokens[i + 1 : i + 2]
            and (tokens[i + 1].text in fw.DEFINITE | fw.INDEFINITE)
        ):
            i += 1  # "both the soup and the sauce", "both the cups"
        elif token.text == "both" and may_continue(tokens, i + 1):
            run.definite, run.numbers = True, [2.0]
            i += 1
        elif token.text in fw.DEFINITE:
            run.definite = True
            run.numbers = run.numbers if tokens[i - 1].text == "both" else []  # "two of the three"
            i += 1
        elif token.text == "same" and run.definite:
            i += 1
        elif token.text == "own" and run.definite:  # "its own glass" is a new one
            run.definite, run.article = False, True
            i += 1
        elif token.text == "all" and may_continue(tokens, i + 1) and i == run.first:
            run.definite = True
            i += 1
        elif token.text in fw.INDEFINITE and run.numbers and run.definite:
            run.closed = True  # "between the two a bowl"
            break
        elif token.text in fw.INDEFINITE:
            run.article = True
            i += 1
        elif token.text in fw.ORDINALS and run.definite and not _names(tokens, i):
            run.ordinal = fw.ORDINALS[token.text]
            i += 1 + (i + 1 < len(tokens) and tokens[i + 1].text == "one")
            following = tokens[i] if i < len(tokens) else None
            if following is not None and (
                following.tag == "number"
                or (
                    following.text != "one"
                    and following.text in (*fw.NUMBERS, *fw.DEFINITE, "a", "an")
                )
            ):
                run.closed = True  # "the third two doughnuts"
                break
        elif token.text in ("other", "second", "third", "fourth") and run.article:
            run.other = True
            i += 1
            if i < len(tokens) and tokens[i].text in fw.DEFINITE | fw.INDEFINITE:
                run.closed = True  # "a third the lettuce"
                break
        elif token.text == "other" and run.definite:
            run.other = True
            i += 1
        elif token.text == "others" and run.definite:
            run.other = run.closed = run.several = True
            i += 1
        elif token.text in fw.AMOUNTS and may_continue(tokens, i + 1):
            run.amount = fw.AMOUNTS[token.text]
            i += 1 + _is_of(tokens, i + 1)
        elif token.text in _DEGREES or (token.text in _FURTHER and run.numbers):
            i += 1
        else:
            break
    return i


def _names(tokens: Sequence[Token], i: int) -> bool:
    """Return whether an ordinal is the first word of a name: "the first aid box"."""
    words = tuple(t.text for t in tokens[i : i + 3] if t.tag == "word")
    return any(category_of(words[:k]) is not None for k in (2, 3) if len(words) >= k)


def _is_of(tokens: Sequence[Token], i: int) -> int:
    return int(i < len(tokens) and tokens[i].tag == "of")


def may_continue(tokens: Sequence[Token], i: int) -> bool:
    """Return whether a noun may follow here, possibly after "of"."""
    i += _is_of(tokens, i)
    return i < len(tokens) and tokens[i].tag in ("word", "name", "number")


def _number(tokens: Sequence[Token], i: int, run: PhraseStart) -> int:
    """Parse "three", "half a dozen of", "2 x" and "2 by 3"; return the number of tokens."""
    value = _value(tokens[i])
    if (
        tokens[i].text == "another"
        and i + 1 < len(tokens)
        and (tokens[i + 1].text in fw.DEFINITE | fw.INDEFINITE)
    ):
        run.other, run.closed, run.numbers = True, True, [1.0]
        return 1
    if value is None:
        if tokens[i].text == "half" and [t.text for t in tokens[i + 1 : i + 3]] == ["a", "dozen"]:
            run.numbers = [6.0]
            return 3 + _is_of(tokens, i + 3)
        return 0
    run.pair = run.pair or tokens[i].text in ("pair", "pairs")
    run.other = run.other or tokens[i].text == "another"
    if tokens[i].text == "one" and not may_continue(tokens, i + 1) and run.definite:
        return 0
    run.described = run.described or (run.article and _is_figure(tokens[i]))
    run.numbers.append(value)
    following = [t.text for t in tokens[i + 1 : i + 3]]
    theirs = following in (["of", "them"], ["of", "these"], ["of", "those"])
    if theirs and not run.words:
        run.closed = True  # "one of them holds an egg"
        return 3
    step = 1
    joint = tokens[i + step].text if i + step < len(tokens) else ""
    crossed = joint == "by" and [t.tag for t in tokens[i + step + 1 : i + step + 2]] == ["number"]
    step += joint in ("x", "times") or crossed
    return step + _is_of(tokens, i + step)


def _value(token: Token) -> float | None:
    if token.tag == "number":
        return float(token.value)
    return fw.NUMBERS.get(token.text) if token.tag == "word" else None


def _is_figure(token: Token) -> bool:
    """Return whether a number is in digits or a word like "seven", but not one like "dozen"."""
    return token.tag == "number" or token.text in SPELT


def _measure(tokens: Sequence[Token], i: int, run: PhraseStart) -> int:
    """Parse "20 cm", "120 x 60 cm" and "30 cm tall"; return the number of tokens."""
    values: list[float] = []
    k = i
    while k < len(tokens) and tokens[k].tag == "number":
        values.append(float(tokens[k].value))
        k += 1
        if k < len(tokens) and tokens[k].text in ("x", "by"):
            k += 1
    if not values or k >= len(tokens):
        return 0
    unit = tokens[k].text
    if unit == "in" and k + 1 < len(tokens) and tokens[k + 1].text in _EXTENTS:
        unit = "inch"  # "12 in long"
    if unit not in fw.MEASURES:
        return 0
    run.lengths += [value * fw.MEASURES[unit] for value in values]
    k += 1
    upright = len(run.lengths) == 1 and k < len(tokens) and tokens[k].text in _UPRIGHT
    run.upright = upright
    while k < len(tokens) and tokens[k].text in (*_EXTENTS, "-", "in"):
        if tokens[k].text == "in" and (k + 1 >= len(tokens) or tokens[k + 1].text != "diameter"):
            break
        k += 1
    return k + _is_of(tokens, k) - i


def _weight(tokens: Sequence[Token], i: int) -> int:
    """Parse "500 g of" and "1 l"; return the number of tokens."""
    if tokens[i].tag != "number" or i + 1 >= len(tokens):
        return 0
    known = tokens[i + 1].text in fw.WEIGHTS
    return 2 + _is_of(tokens, i + 2) if known else 0


def _group(tokens: Sequence[Token], i: int, run: PhraseStart) -> int:
    """Parse "stack of" and "neat little pile of"; return the number of tokens."""
    k = i
    while k < len(tokens) and tokens[k].tag == "word" and is_describing(tokens[k].text):
        k += 1
    if k + 1 >= len(tokens) or tokens[k].tag != "word":
        return 0
    word = tokens[k].text
    if word not in fw.GROUPS:
        return 0
    kind = fw.GROUPS[word]
    following = tuple(t.text for t in tokens[k + 1 : k + 4])
    made = next((m for m in _MADE if following[: len(m)] == m), ())
    if tokens[k + 1].tag != "of" and not (made and kind != "group"):
        return 0
    k += max(len(made), 1) - 1
    run.portion = run.portion or word in ("slice", "piece", "portion", "serving", "sheet", "loaf",
                                          "slices", "pieces", "sheets", "servings")  # fmt: skip
    if kind != "group":
        run.arrangement = kind  # type: ignore[assignment]
    run.groups = multiply(run.numbers) or 1.0
    run.amount = fw.AMOUNTS.get(word, run.amount)
    many = run.portion or (run.amount is None and kind == "group" and run.groups > 1)
    many = many or (kind == "grid" and len(run.numbers) == 2)  # "a 3 x 3 grid of"
    run.numbers = run.numbers if many else []
    return k + 2 - i


def is_describing(word: str) -> bool:
    """Return whether a word only describes a colour, a material, a size or a state."""
    listed = any(word in words for words in (COLORS, SHADES, MATERIALS, SIZES, STATES, MORE))
    return listed or is_adjective(word) or (word.endswith("ly") and len(word) > 4)


def multiply(numbers: Sequence[float]) -> float | None:
    """Return the value of "twenty five", "two hundred" and "three pairs"."""
    total: float | None = None
    for value in numbers:
        if total is None:
            total = value
        elif 20 <= total < 100 and value < 10:
            total += value
        else:
            total = min(total * value, 1e12)
    return total
