"""Lookup of catalogue categories by exact name, then by reviewed synonym; no fuzzy matching."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection, Mapping
from functools import cache
from types import MappingProxyType

from tabletop_objects import CATEGORIES

from .vocabulary import COLLECTIVES, PARTS, PLACES, SYNONYMS, TABLE_NOUNS

IRREGULAR: Mapping[str, str] = MappingProxyType(
    {
        "knives": "knife", "loaves": "loaf", "leaves": "leaf", "mice": "mouse", "dice": "die",
        "tomatoes": "tomato", "potatoes": "potato", "mangoes": "mango", "people": "person",
        "cookies": "cookie", "shelves": "shelf", "children": "child", "lenses": "lens",
        "movies": "movie", "brownies": "brownie", "axes": "axe", "smoothies": "smoothie",
        "halves": "half", "kiwis": "kiwi", "skis": "ski", "taxis": "taxi", "zucchinis": "zucchini",
        "geese": "goose", "feet": "foot", "teeth": "tooth", "scarves": "scarf", "wolves": "wolf",
        "calves": "calf", "hooves": "hoof", "elves": "elf", "menus": "menu", "quizzes": "quiz",
        "canvases": "canvas", "men": "man", "women": "woman", "chilies": "chili",
        "chillies": "chilli", "cds": "cd", "dvds": "dvd", "leds": "led", "pcs": "pc", "tvs": "tv",
        "atlases": "atlas", "buses": "bus", "irises": "iris", "cacti": "cactus", "fungi": "fungus",
        "cactuses": "cactus", "crocuses": "crocus", "octopuses": "octopus", "lotuses": "lotus",
    }
)  # fmt: skip

_SINGULAR = frozenset({"canvas", "atlas", "gas", "christmas", "pancreas", "madras", "thermos"})
"""Singular nouns that end like a plural."""

PLURAL_ONLY = frozenset(
    {"tweezers", "forceps", "scissors", "pliers", "tongs", "goggles", "spectacles", "sunglasses",
     "eyeglasses", "binoculars", "headphones", "earphones", "earbuds", "earmuffs", "defenders",
     "trousers", "jeans", "shorts", "pants", "tights", "leggings", "pyjamas", "pajamas",
     "clippers", "nippers", "shears", "secateurs", "pincers", "snips", "strippers",
     "calipers", "callipers", "scales", "overalls", "dungarees", "braces", "pruners", "loppers",
     "muffs"}
)  # fmt: skip
"""Plural nouns that name a single object: "a pair of tweezers" is one object."""


def tokens(text: str) -> list[str]:
    """Split a text into lower-case words, numbers and punctuation, dropping accents and "'s".

    A range of numbers ("2-3") becomes its upper bound.
    """
    plain = unicodedata.normalize("NFKD", text.lower().replace("’", "'"))
    plain = "".join(c for c in plain if not unicodedata.combining(c))
    plain = re.sub(r"(?<=[a-z])'s?\b", "", plain).replace("&", " and ")
    plain = re.sub(r"(?<=\d),(?=\d{3}\b)", "", plain)
    plain = re.sub(r"\b\d+ ?[-–] ?(?=\d)", "", plain)
    return re.findall(r"(?<![\w.])-\d+|\d+(?:\.\d+)?(?:e\d+)?|[a-z]+|[,.;:!?\n()]", plain)


def singular(word: str) -> str:
    """Apply rules to convert an English noun to the singular ("boxes" becomes "box")."""
    if word in IRREGULAR:
        return IRREGULAR[word]
    if len(word) < 4 or not word.endswith("s") or word.endswith(("ss", "us", "is")):
        return word
    if word in _SINGULAR or word in PLURAL_ONLY:
        return word
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if word.endswith(("ches", "shes", "xes", "sses", "zzes")):
        return word[:-2]
    return word[:-1]


@cache
def _index() -> Mapping[str, str]:
    """Map every known noun to its category key; the catalogue's own names take precedence."""
    index = {alias: c.key for c in reversed(list(CATEGORIES.values())) for alias in c.aliases}
    index |= {c.noun: c.key for c in CATEGORIES.values()}
    for _ in range(2):  # a synonym may lead to another synonym
        for word, meaning in SYNONYMS:
            if word not in index and meaning in index:
                index[word] = index[meaning]
    index = {" ".join(tokens(word)): key for word, key in index.items()}
    pairs = [word for word in index if word.count(" ") == 1]
    index = {word.replace(" ", ""): index[word] for word in pairs} | index  # "chessboard"
    return MappingProxyType({word: key for word, key in index.items() if word not in NEVER_OBJECTS})


NEVER_OBJECTS = PARTS | TABLE_NOUNS
"""Words that never name an object, even if they are aliases in the catalogue."""


def _forms(words: tuple[str, ...]) -> tuple[str, ...]:
    """Return a noun's possible forms: as written or with its last, first or both words singular."""
    cut = words[-1] in PLURAL_ONLY
    last = (*words[:-1], words[-1][:-1] if cut else singular(words[-1]))
    first = (singular(words[0]), *words[1:])
    both = (singular(words[0]), *last[1:]) if len(words) > 1 else last
    return tuple(dict.fromkeys(" ".join(form) for form in (words, last, first, both)))


def category_of(words: tuple[str, ...]) -> str | None:
    """Return the key of the category that exactly these words name, or None."""
    index = _index()
    return next((index[form] for form in _forms(words) if form in index), None)


def is_plural(words: tuple[str, ...]) -> bool:
    """Return whether a noun means several objects ("mugs", but not "scissors" or "glass")."""
    written = " ".join(words)
    index = _index()
    single = " ".join((*words[:-1], singular(words[-1])))
    if written in index and written != "dice":
        named = CATEGORIES[index[written]].noun == written  # "grapes" are one object
        return not named and single != written and index.get(single) == index[written]
    return any(singular(word) != word for word in (words[0], words[-1]))


def collective_of(words: tuple[str, ...]) -> tuple[str, ...]:
    """Return the categories that a word for a mixed group stands for, or an empty tuple."""
    members = COLLECTIVES.get(" ".join(words), ())
    keys = (category_of(tuple(member.split())) for member in members)
    return tuple(key for key in keys if key is not None)


def is_phrase_start(words: tuple[str, ...]) -> bool:
    """Return whether words that include "of" or "and" form a single noun."""
    return bool({"of", "and"} & set(words)) and (
        category_of(words) is not None or " ".join(words) in COLLECTIVES
    )


def is_setting(word: str) -> bool:
    """Return whether a word names a place or an aspect of the picture rather than an object."""
    return word in PLACES or singular(word) in PLACES


def names() -> Collection[str]:
    """Return all nouns that name a category."""
    return _index().keys()


@cache
def vocabulary() -> frozenset[str]:
    """Return all single words that occur in known nouns."""
    names = [*_index(), *COLLECTIVES, *TABLE_NOUNS]
    return frozenset(word for name in names for word in name.split())
