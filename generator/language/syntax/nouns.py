"""Noun phrases: numbers, describing words, and the noun last."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from ..parsing import lexicon
from ..parsing.vocabulary import (
    COLLECTIVES,
    COLORS,
    LOOSE_NOUNS,
    MATERIALS,
    PARTS,
    SHADES,
    SIZES,
    STATES,
    TABLE_NOUNS,
    VAGUE_THINGS,
)
from ..words.dictionary import entry_of
from . import function_words as fw
from .tokens import Token
from .tree import Arrangement, Noun, NounKind

_STOPS = fw.BE | fw.PARTICIPLES | fw.FILLERS | fw.RELATIVE


_MORE = frozenset({
    "medium", "sized", "middle", "smallest", "largest", "biggest", "tallest", "shortest", "opened",
    "shut", "upright", "sideways", "tipped", "overturned", "empty",
})  # fmt: skip


@dataclass
class _Run:
    """What is read of a noun phrase so far."""

    numbers: list[float] = field(default_factory=list)
    amount: tuple[int, int] | None = None
    article: bool = False
    definite: bool = False
    other: bool = False
    each: bool = False
    groups: float = 0.0
    arrangement: Arrangement | None = None
    portion: bool = False  # "a slice of": one, whatever the noun's form
    words: list[str] = field(default_factory=list)
    variants: list[list[str]] = field(default_factory=list)
    lengths: list[float] = field(default_factory=list)
    name: tuple[str, ...] = ()
    first: int = 0


def read_noun(tokens: Sequence[Token], start: int) -> tuple[Noun | None, int]:
    """Return the noun phrase that starts at a token and where it ends; None where there is none."""
    run = _Run(first=start)
    i = _introduction(tokens, start, run)
    i = _content(tokens, i, run)
    if i == start:
        return None, start
    noun = _noun(run)
    noun.span = tokens[start].span[0], tokens[i - 1].span[1]
    return noun, i


# ------------------------------------------------------------------------------- introduction


def _introduction(tokens: Sequence[Token], i: int, run: _Run) -> int:
    """Read articles, numbers, lengths and "a stack of"; return where they end."""
    while i < len(tokens):
        token = tokens[i]
        step = _measure(tokens, i, run) or _group(tokens, i, run) or _number(tokens, i, run)
        if step:
            i += step
        elif token.tag == "each":
            run.each = True
            i += 1 + _is_of(tokens, i + 1)
        elif token.tag != "word":
            break
        elif token.text in fw.DEFINITE:
            run.definite = True
            i += 1
        elif token.text in fw.INDEFINITE:
            run.article = True
            i += 1
        elif token.text in ("other", "second", "third") and (run.article or run.definite):
            run.other = True
            i += 1
        elif token.text in fw.AMOUNTS and _continues(tokens, i + 1):
            run.amount = fw.AMOUNTS[token.text]
            i += 1 + _is_of(tokens, i + 1)
        elif token.text in ("whole", "about", "around", "exactly", "approximately", "roughly",
                            "only", "just", "nearly", "at", "least", "most"):  # fmt: skip
            i += 1
        else:
            break
    return i


def _is_of(tokens: Sequence[Token], i: int) -> int:
    return int(i < len(tokens) and tokens[i].tag == "of")


def _continues(tokens: Sequence[Token], i: int) -> bool:
    """Tell whether a noun may follow here, perhaps after "of"."""
    i += _is_of(tokens, i)
    return i < len(tokens) and tokens[i].tag in ("word", "name", "number")


def _number(tokens: Sequence[Token], i: int, run: _Run) -> int:
    """Read "three", "2-3", "half a dozen of", "2 x"; return how many tokens they take."""
    value = _value(tokens[i])
    if value is None:
        if tokens[i].text == "half" and [t.text for t in tokens[i + 1 : i + 3]] == ["a", "dozen"]:
            run.numbers = [6.0]
            return 3 + _is_of(tokens, i + 3)
        return 0
    if tokens[i].text == "one" and not _continues(tokens, i + 1) and run.definite:
        return 0
    step = 1
    following = [t.text for t in tokens[i + 1 : i + 3]]
    upper = _value(tokens[i + 2]) if len(following) == 2 else None
    if following[:1] in (["-"], ["or"], ["to"]) and upper is not None and upper > value:
        run.amount = (int(value), int(min(upper, 1e6)))
        run.numbers = []
        step = 3
    else:
        run.numbers.append(value)
    if i + step < len(tokens) and tokens[i + step].text in ("x", "times"):
        step += 1
    return step + _is_of(tokens, i + step)


def _value(token: Token) -> float | None:
    if token.tag == "number":
        return float(token.value)
    return fw.NUMBERS.get(token.text) if token.tag == "word" else None


def _measure(tokens: Sequence[Token], i: int, run: _Run) -> int:
    """Read "20 cm", "120 x 60 cm" and "30 cm tall"; return how many tokens they take."""
    values: list[float] = []
    k = i
    while k < len(tokens) and tokens[k].tag == "number":
        values.append(float(tokens[k].value))
        k += 1
        if k < len(tokens) and tokens[k].text in ("x", "by"):
            k += 1
    if not values or k >= len(tokens) or tokens[k].text not in fw.MEASURES:
        return 0
    run.lengths += [value * fw.MEASURES[tokens[k].text] for value in values]
    k += 1
    while k < len(tokens) and tokens[k].text in ("tall", "high", "long", "wide", "deep", "across",
                                                 "diameter", "-", "in", "thick"):  # fmt: skip
        if tokens[k].text == "in" and (k + 1 >= len(tokens) or tokens[k + 1].text != "diameter"):
            break
        k += 1
    return k - i


def _group(tokens: Sequence[Token], i: int, run: _Run) -> int:
    """Read "stack of" and "neat little pile of"; return how many tokens they take."""
    k = i
    while k < len(tokens) and tokens[k].tag == "word" and _describes(tokens[k].text):
        k += 1
    if k + 1 >= len(tokens) or tokens[k].tag != "word" or tokens[k + 1].tag != "of":
        return 0
    word = tokens[k].text
    if word not in fw.GROUPS:
        return 0
    kind = fw.GROUPS[word]
    run.portion = run.portion or word in ("slice", "piece", "portion", "serving", "sheet", "loaf",
                                          "slices", "pieces", "sheets", "servings")  # fmt: skip
    if kind != "group":
        run.arrangement = kind  # type: ignore[assignment]
    run.groups = _total(run.numbers) or 1.0
    run.amount = fw.AMOUNTS.get(word, run.amount)
    many = run.portion or (run.amount is None and kind == "group" and run.groups > 1)
    run.numbers = run.numbers if many else []
    return k + 2 - i


def _describes(word: str) -> bool:
    """Tell whether a word only describes: a colour, a material, a size, a state."""
    return any(word in words for words in (COLORS, SHADES, MATERIALS, SIZES, STATES, _MORE)) or (
        word.endswith("ly") and len(word) > 4
    )


# ------------------------------------------------------------------------------------ content


def _content(tokens: Sequence[Token], i: int, run: _Run) -> int:
    """Read describing words and the noun; return where they end."""
    while i < len(tokens):
        token = tokens[i]
        if token.tag == "name":
            run.name = tuple(w.text for w in token.words)
            run.words += run.name
            return i + 1
        if token.tag == "arranged" and len(token.words) == 1 and _continues(tokens, i + 1):
            if any(token.words[0].text == w for w in ("ordered", "sorted", "aligned", "inside")):
                break
            run.arrangement = run.arrangement or token.value
            run.words.append(token.text)
            i += 1
        elif token.tag == "number" and not run.words and not run.numbers:
            run.numbers.append(float(token.value))
            i += 1
        elif token.tag == "possessive":
            i += 1
        elif token.tag == "word" and not _ends(tokens, i, run):
            run.words.append(token.text)
            i += 1
        elif step := _joined_adjectives(tokens, i, run):
            i += step
        else:
            break
    return i


def _ends(tokens: Sequence[Token], i: int, run: _Run) -> bool:
    """Tell whether a word is none of this noun phrase's any more."""
    word = tokens[i].text
    if word in fw.DEFINITE or word in fw.INDEFINITE or word in fw.PRONOUNS:
        return True
    nouns = [w for w in run.words if not _describes(w)]
    if word in fw.NUMBERS and nouns:
        return True
    if word in _STOPS or word in fw.STARTERS:
        following = tokens[i + 1] if i + 1 < len(tokens) else None
        ahead = following.text if following is not None and following.tag == "word" else ""
        extended, longer = (*run.words, word), (*run.words, word, ahead)
        named = any(
            lexicon.category_of(some[k:]) or lexicon.collective_of(some[k:])
            for some in (extended, longer)
            for k in range(len(extended))
        )
        closed = following is None or following.tag in ("comma", "stop", "line", "and", "close")
        if closed and nouns and word in fw.BE and not _is_known(run.words):
            return False  # "a wrist rest"
        if named and (nouns or following is None or following.text not in fw.DEFINITE):
            return False
        before_noun = not nouns and following is not None and following.tag in ("word", "name")
        describes = _describes(word) or word in ("standing", "hanging", "left", "right", "upright")
        return not (before_noun and describes)
    if nouns and (word.endswith(("ing", "ed")) or _describes(word)) and _is_known(run.words):
        extended = (*run.words, word)
        ahead = [*extended, *(t.text for t in tokens[i + 1 : i + 3] if t.tag == "word")]
        return not any(
            lexicon.category_of(tuple(ahead[k:end]))
            for end in range(len(extended), len(ahead) + 1)
            for k in range(len(run.words) + 1)
        )
    return False


def _is_known(words: Sequence[str]) -> bool:
    return any(
        lexicon.category_of(tuple(words[k:])) or " ".join(words[k:]) in TABLE_NOUNS
        for k in range(len(words))
    )


def _joined_adjectives(tokens: Sequence[Token], i: int, run: _Run) -> int:
    """Read the comma or "and" between describing words: "red, green and blue cubes"."""
    if tokens[i].tag not in ("comma", "and") or not run.words:
        return 0
    if not all(_describes(w) or w in fw.SIDES for w in run.words):
        return 0
    k = i + 1
    if k < len(tokens) and tokens[i].tag == "comma" and tokens[k].tag == "and":
        k += 1
    described = 0
    while k < len(tokens) and tokens[k].tag == "word" and _describes(tokens[k].text):
        described += 1
        k += 1
    if not described or k >= len(tokens):
        return 0
    more = tokens[k].tag in ("comma", "and") or tokens[k].tag in ("word", "name")
    if not more or (tokens[k].tag == "word" and _ends(tokens, k, run)):
        return 0
    start = i + 1 + (tokens[i].tag == "comma" and tokens[i + 1].tag == "and")
    run.variants.append(list(run.words))
    run.words = []
    return start - i


# ---------------------------------------------------------------------------------- the noun


def _noun(run: _Run) -> Noun:
    """Return the noun phrase of what was read."""
    words = tuple(run.words)
    kind, head, category, family = _head(words, run.name)
    modifiers = words[: len(words) - len(head)] if head else words
    count, amount = _count(run)
    glasses = False
    if head == ("glasses",) and not run.definite and (count or amount or not modifiers):
        head, category = ("glass",), lexicon.category_of(("glass",))
        glasses = True
    attributes = attributes_of(modifiers)
    noun = " ".join((*head[:-1], lexicon.singular(head[-1]))) if head else ""
    if head and "of" in head:
        noun = " ".join((lexicon.singular(head[0]), *head[1:]))
    elif head and category and " ".join(head) != noun and not lexicon.is_plural(head):
        noun = " ".join(head)
    plural = glasses or (bool(head) and lexicon.is_plural(tuple(run.words[-len(head) :])))
    variants = _variants(run, attributes, plural, count)
    if run.variants and not variants:
        attributes = _two_colored(run, attributes)
    if run.arrangement is None and "stacked" in modifiers and plural:
        run.arrangement = "stack"
    if run.groups and count is None and amount is None and not run.portion:
        count, amount = (None, (3, 3)) if plural else (run.groups, None)
        run.arrangement = run.arrangement if plural else None
    return Noun(
        kind, words, (0, 0), noun, category, count, amount,
        definite=run.definite, other=run.other, each=run.each, plural=plural,
        attributes=attributes, variants=variants,
        members=lexicon.collective_of(head) if kind == "collective" else (),
        lengths=tuple(run.lengths), arrangement=run.arrangement,
        position=next((w for w in modifiers if w in ("left", "right", "back", "front", "middle",
                                                     "center", "centre")), None),
        family=family,
    )  # fmt: skip


def _head(
    words: tuple[str, ...], name: tuple[str, ...]
) -> tuple[NounKind, tuple[str, ...], str | None, str]:
    """Return the kind of noun, its head (the longest known ending), its category and family."""
    if name:
        if lexicon.collective_of(name):
            return "collective", name, None, ""
        return "thing", name, lexicon.category_of(name), ""
    if not words:
        return "member", (), None, ""
    last = words[-1]
    for start in range(len(words)):
        tail = words[start:]
        if lexicon.collective_of(tail):
            return "collective", tail, None, ""
        if " ".join(tail) not in TABLE_NOUNS and (key := lexicon.category_of(tail)):
            strange = any(_is_strange(word) for word in words[:start])
            if not (strange and len(tail) == 1 and last in LOOSE_NOUNS):
                return "thing", tail, key, ""
    kinds: tuple[tuple[NounKind, bool], ...] = (
        ("table", last in TABLE_NOUNS), ("vague", last in VAGUE_THINGS),
        ("part", last in PARTS or lexicon.singular(last) in PARTS),
        ("setting", lexicon.is_setting(last)),
    )  # fmt: skip
    kind = next((kind for kind, holds in kinds if holds), None)
    if kind is not None:
        return kind, (last,), None, ""
    if all(_describes(word) or word in fw.SIDES for word in words):
        return "adjective", (), None, ""
    return _look_up(words)


def _look_up(words: tuple[str, ...]) -> tuple[NounKind, tuple[str, ...], str | None, str]:
    """Return what the dictionary knows of a noun phrase that the catalogue does not have."""
    entry = entry_of(words)
    strange = len(words) > 1 and not _describes(words[-2])
    if entry is None:
        return "thing", words[-2:] if strange else words[-1:], None, ""
    head = words[-max(len(entry.noun.split()), 1 + strange) :]
    if entry.is_thing:
        return "thing", head, entry.category, entry.family
    return "setting" if entry.family == "place" else "abstract", head, None, ""


def _is_strange(word: str) -> bool:
    """Tell whether a word before a noun may change what it means ("arduino board")."""
    return not _describes(word) and word not in lexicon.vocabulary()


def _count(run: _Run) -> tuple[float | None, tuple[int, int] | None]:
    if run.amount is not None:
        return None, run.amount
    total = _total(run.numbers)
    if total is None and run.article and not run.groups:
        total = 1.0
    return total, None


def _total(numbers: Sequence[float]) -> float | None:
    """Return "twenty five", "two hundred", "three pairs" as one number."""
    total: float | None = None
    for value in numbers:
        if total is None:
            total = value
        elif 20 <= total < 100 and value < 10:
            total += value
        else:
            total = min(total * value, 1e12)
    return total


def attributes_of(modifiers: Sequence[str]) -> dict[str, str]:
    """Return the "color", "material", "size" and "state" that describing words name."""
    found: dict[str, str] = {}
    for before, word in zip((None, *modifiers), modifiers, strict=False):
        if word in COLORS and not (word in MATERIALS and "color" in found):
            shade = f"{before} " if before in SHADES else ""
            found.setdefault("color", shade + word)
        elif word in MATERIALS:
            found.setdefault("material", word)
        elif word in SIZES:
            found.setdefault("size", SIZES[word])
        elif word == "medium":
            found.setdefault("size", "medium")
        elif word in STATES or word in _MORE:
            found.setdefault("state", word)
    return found


def _variants(
    run: _Run, last: Mapping[str, str], plural: bool, count: float | None
) -> tuple[Mapping[str, str], ...]:
    """Return the attributes of single ones: "red, green and blue cubes" are three."""
    if not run.variants or not (plural or not any(not _describes(w) for w in run.words)):
        return ()
    each = (*(attributes_of(words) for words in run.variants), dict(last))
    distinct = all(attributes.keys() == each[0].keys() for attributes in each) and len(
        {tuple(sorted(a.items())) for a in each}
    ) == len(each)
    return each if distinct and (count is None or count == len(each)) else ()


def _two_colored(run: _Run, last: Mapping[str, str]) -> dict[str, str]:
    """Return the attributes of "a yellow and white mug": a second colour beside the first."""
    merged: dict[str, str] = {}
    for attributes in (*(attributes_of(words) for words in run.variants), last):
        for key, value in attributes.items():
            if key == "color" and merged.get("color", value) != value:
                merged.setdefault("accent", value)
            else:
                merged.setdefault(key, value)
    return merged


def is_collective(words: Sequence[str]) -> bool:
    """Tell whether words name a mixed group."""
    return " ".join(words) in COLLECTIVES
