"""The head noun of a phrase: its kind, category, number and attributes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from tabletop_objects import CATEGORIES

from ... import lexicon
from ...vocabulary import (
    COLORS,
    LOOSE_NOUNS,
    MATERIALS,
    OCCASIONS,
    PARTS,
    SHADES,
    SIZES,
    STATES,
    TABLE_NOUNS,
    VAGUE_THINGS,
)
from ...words.dictionary import entry_of, is_english, is_verb
from ..text import function_words as fw
from .endings import STOPS
from .introductions import MORE, PhraseStart, is_describing, multiply
from .tree import Noun, NounKind

_COMPOUNDED = frozenset(["rest", "stand", "set", "kit", "press", "mount", "guard", "control"])
"""Nouns that name an object only as part of a compound: "foot rest"."""

_AMOUNTS = {"heap": (5, 5), "pyramid": (6, 6)}
"""Assumed number of objects in an arrangement without a stated number; 3 in all others."""

_POSITIONS = frozenset(
    ["left", "right", "back", "front", "middle", "center", "centre", "top", "bottom", "upper",
     "lower", "topmost", "uppermost"]
)  # fmt: skip
"""Words that single out one of several similar objects: "the left plate"."""

_PORTIONS = frozenset(
    ["half", "slice", "piece", "wedge", "chunk", "segment", "strip", "quarter", "stick"]
)

_BODIES = frozenset({"body", "unit", "model", "type"})

_FIGURES = frozenset(
    ["toy", "plastic", "ceramic", "porcelain", "wooden", "bronze", "lego", "tin", "miniature",
     "little", "tiny", "clay", "chess", "felt", "knitted", "stuffed", "plush"]
)  # fmt: skip
"""Words which indicate that a person is a figure: "a plastic soldier"."""

_VERBAL = ("ed", "ing", "ly")


def noun_of(run: PhraseStart) -> Noun:
    """Build the noun phrase from a parsed introduction and the words that follow."""
    cut_plural = _cut_portion(run)
    words = tuple(run.words)
    kind, head, category, family = _head(words, run.name, definite=run.definite)
    counted = run.article or run.definite or run.numbers or run.amount or run.each or run.groups
    robot = run.definite and words in (("robot",), ("robot", "arm"), ("agent",), ("manipulator",))
    if robot or (words and words[0] in fw.NOBODY):
        kind, category = "setting", None
    if kind == "thing" and not category and not (family or counted) and is_verb(words[-1]):
        kind = "abstract"
    if kind == "adjective" and run.groups and words and words[-1] in MATERIALS:
        kind, head, category, family = _look_up(words[-1:])  # "a piece of fabric"
        category = category or lexicon.category_of(words[-1:])
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
    if kind == "thing" and category and not run.name:
        noun = " ".join((*_compound(modifiers), noun))
    plural = glasses or (bool(head) and lexicon.is_plural(tuple(run.words[-len(head) :])))
    plural = plural or cut_plural or run.several
    if run.described and not plural and not (run.lengths or run.groups):
        count = 1.0
    if run.posture:
        attributes["posture"] = run.posture
    variants = _variants(run, attributes, plural, count)
    if run.variants and not variants:
        attributes = _two_colored(run, attributes)
    if run.arrangement is None and "stacked" in modifiers and plural:
        run.arrangement = "stack"
    paired = lexicon.PLURAL_ONLY | {"cutters"} if run.pair else lexicon.PLURAL_ONLY
    single = bool(head) and run.words[-1:] == [head[-1]] and head[-1] in paired
    if single:
        plural = False
        count = count / 2 if run.pair and count is not None else count
    if run.groups and count is None and amount is None and not run.portion:
        many = _AMOUNTS.get(run.arrangement or "", (3, 3))
        if run.arrangement == "pyramid" and category and CATEGORIES[category].ball:
            many = (4, 4)
        count, amount = (None, many) if plural else (run.groups, None)
        run.arrangement = run.arrangement if plural else None
    return Noun(
        kind, words, (0, 0), noun, category, count, amount,
        definite=run.definite, other=run.other, each=run.each, plural=plural,
        attributes=attributes, variants=variants,
        members=lexicon.collective_of(head) if kind == "collective" else (),
        lengths=tuple(run.lengths), arrangement=run.arrangement,
        position=next((word for word in modifiers if word in _POSITIONS), None),
        ordinal=run.ordinal,
        family=family, upright=run.upright,
    )  # fmt: skip


def _cut_portion(run: PhraseStart) -> bool:
    """Cut off the portion in "lemon halves" and "tomato slices"; return whether it was plural."""
    if len(run.words) < 2 or lexicon.singular(run.words[-1]) not in _PORTIONS:
        return False
    whole = tuple(run.words)
    if any(lexicon.category_of(whole[k:]) for k in range(len(whole) - 1)):
        return False
    key = lexicon.category_of(whole[-2:-1])
    if key is None or "edible" not in CATEGORIES[key].roles:
        return False
    return lexicon.singular(run.words.pop()) != whole[-1]


def _head(
    words: tuple[str, ...], name: tuple[str, ...], *, definite: bool = False
) -> tuple[NounKind, tuple[str, ...], str | None, str]:
    """Return the kind of noun, its head (the longest known suffix), its category and its family."""
    if name:
        if lexicon.collective_of(name):
            return "collective", name, None, ""
        return "thing", name, lexicon.category_of(name), ""
    if not words:
        return "member", (), None, ""
    if words[-1] in fw.GROUPS and definite and not lexicon.category_of(words[-1:]):
        return "thing", words[-1:], None, ""  # "behind the stack"
    last = words[-1]
    if " ".join(words[-2:]) in OCCASIONS:
        return "setting", words[-2:], None, ""
    if last in ("one", "ones") and len(words) > 1:
        return "member", (last,), None, ""
    for start in range(len(words)):
        tail = words[start:]
        named_so = start and not is_describing(words[start - 1]) and len(tail) == 1
        if lexicon.collective_of(tail) and not named_so:
            return "collective", tail, None, ""
        if _only_describes(tail):
            continue
        if " ".join(tail) not in TABLE_NOUNS and (key := lexicon.category_of(tail)):
            strange = not all(is_describing(word) or word in fw.SIDES for word in words[:start])
            if not (strange and len(tail) == 1 and lexicon.singular(last) in LOOSE_NOUNS):
                return "thing", tail, key, ""
    kinds: tuple[tuple[NounKind, bool], ...] = (
        ("table", last in TABLE_NOUNS), ("vague", last in VAGUE_THINGS),
        ("part", last in PARTS or lexicon.singular(last) in PARTS),
        ("setting", lexicon.is_setting(last)),
    )  # fmt: skip
    for kind, holds in kinds:
        if holds:
            return kind, (last,), None, ""
    if all(is_describing(word) or word in fw.SIDES for word in words):
        return "adjective", (), None, ""
    return _look_up(words)


def _compound(modifiers: Sequence[str]) -> tuple[str, ...]:
    """Return the nouns before a head, such as "bleach cleanser" in "bleach cleanser bottle"."""
    start = len(modifiers)
    while start and not is_describing(word := modifiers[start - 1]):
        if word in fw.SIDES or word in fw.SUPERLATIVES or word in fw.ORDINALS or word in STOPS:
            break
        start -= 1
    return tuple(modifiers[start:])


def _only_describes(tail: tuple[str, ...]) -> bool:
    """Return whether the first word of a name only describes, like the colour in "green apple"."""
    key = lexicon.category_of(tail[1:]) if len(tail) > 1 and tail[0] in COLORS else None
    return key is not None and key == lexicon.category_of(tail)


def _look_up(words: tuple[str, ...]) -> tuple[NounKind, tuple[str, ...], str | None, str]:
    """Return the dictionary entry of a noun phrase that the catalogue lacks."""
    entry = entry_of(words)
    last = words[-1]
    strange = len(words) > 1 and not is_describing(words[-2])
    if last in fw.NO_NOUNS or (last in fw.FORMS and not lexicon.category_of((last,))):
        return "abstract", words[-1:], None, ""
    if entry is None and (last in fw.AMOUNTS or (last.endswith(_VERBAL) and is_english(last))):
        return "abstract", words[-1:], None, ""
    before = lexicon.category_of(words[-2:-1]) if len(words) > 1 else None
    if last in _BODIES and before is not None:
        return "thing", words[-2:-1], before, ""  # "a camera body"
    if entry is None:
        return "thing", words[-2:] if strange else words[-1:], None, ""
    head = words[-max(len(entry.noun.split()), 1 + strange) :]
    if not entry.family and strange and entry.noun in _COMPOUNDED:
        return "thing", head, None, "block"
    if entry.is_thing or (entry.family == "person" and _FIGURES & {*words[:-1]}):
        return "thing", head, entry.category, entry.family
    return "setting" if entry.family == "place" else "abstract", head, None, entry.family


def _count(run: PhraseStart) -> tuple[float | None, tuple[int, int] | None]:
    if run.amount is not None:
        return None, run.amount
    total = multiply(run.numbers)
    if total is None and run.article and not run.groups:
        total = 1.0
    return total, None


def attributes_of(modifiers: Sequence[str]) -> dict[str, str]:
    """Return the "color", "material", "size" and "state" that describing words state."""
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
        elif word in STATES or word in MORE:
            if found.get("state") == "half":  # "half open"
                del found["state"]
            found.setdefault("state", word)
    return found


def _variants(
    run: PhraseStart, last: Mapping[str, str], plural: bool, count: float | None
) -> tuple[Mapping[str, str], ...]:
    """Return the attributes of individual objects: "red, green and blue cubes" are three."""
    if not run.variants or not (plural or not any(not is_describing(w) for w in run.words)):
        return ()
    each = (*(attributes_of(words) for words in run.variants), dict(last))
    distinct = all(attributes.keys() == each[0].keys() for attributes in each) and len(
        {tuple(sorted(a.items())) for a in each}
    ) == len(each)
    return each if distinct and (count is None or count == len(each)) else ()


def _two_colored(run: PhraseStart, last: Mapping[str, str]) -> dict[str, str]:
    """Return the attributes of "a yellow and white mug", with a second colour."""
    merged: dict[str, str] = {}
    for attributes in (*(attributes_of(words) for words in run.variants), last):
        for key, value in attributes.items():
            if key == "color" and merged.get("color", value) != value:
                merged.setdefault("accent", value)
            else:
                merged.setdefault(key, value)
    return merged
