"""Words outside the catalogue: the family of objects that a noun names, and parts of speech.

The tables of nouns and words are derived from WordNet by ``research.language.families``; its
licence is in NOTICE. ``substituted.txt`` lists aliases and synonyms that really mean a different
object.
"""

from __future__ import annotations

import gzip
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from types import MappingProxyType

from ...scene import PlannedObject
from ...stand_ins import GENERIC
from ..lexicon import category_of, singular

_TABLES = files("generator.language") / "words"


@dataclass(frozen=True)
class NounEntry:
    """The dictionary entry of a noun.

    Attributes:
        noun: the noun in the singular.
        family: kind of object ("appliance"); "" for a noun that is not an object, "place" for a
            room or a building, "person".
        category: the catalogue's category that includes it ("stein" is a mug), or None.
    """

    noun: str
    family: str
    category: str | None = None

    @property
    def is_thing(self) -> bool:
        """Whether the noun names an object that can stand on a table."""
        return self.family not in ("", "place", "person")


@cache
def _nouns() -> Mapping[str, NounEntry]:
    table = {}
    for line in (_TABLES / "nouns.tsv").read_text().splitlines():
        noun, family, category = line.split("\t")
        table[noun] = NounEntry(noun, family, category or None)
    return MappingProxyType(table)


@cache
def _english() -> frozenset[str]:
    return frozenset(gzip.decompress((_TABLES / "english.txt.gz").read_bytes()).decode().split())


def entry_of(words: tuple[str, ...]) -> NounEntry | None:
    """Return the dictionary entry of the longest known suffix of a noun phrase, or None."""
    for start in range(max(0, len(words) - 3), len(words)):
        tail = words[start:]
        for form in (tail, (*tail[:-1], singular(tail[-1]))):
            found = _nouns().get(" ".join(form))
            if found is not None:
                return found
    return None


@cache
def _substitutes() -> frozenset[str]:
    return frozenset((_TABLES / "substituted.txt").read_text().splitlines())


def is_substituted(noun: str, category: str) -> bool:
    """Return whether a noun is represented by a category that is really a different object."""
    if noun.replace(" ", "") == category.replace("_", ""):
        return False  # a chessboard
    whole, words = tuple(noun.split()), tuple(noun.split(" of ")[0].split())
    tails = (whole, *(words[k:] for k in range(len(words))))
    known = next((tail for tail in tails if category_of(tail) is not None), None)
    return known is None or " ".join(known) in _substitutes()


def is_english(word: str) -> bool:
    """Return whether a word is English, in the singular or plural."""
    known = _english()
    if word in known or singular(word) in known or len(word) < 3 or word in IRREGULAR:
        return True
    stems = [word.removesuffix(end) for end in ("ed", "ing", "er", "est", "ly", "d", "r", "st")]
    return any(stem != word and (stem in known or f"{stem}e" in known) for stem in stems)


def classify(words: tuple[str, ...]) -> tuple[str | None, str]:
    """Return the category of a noun phrase and "", or None and the phrase's family.

    The longest suffix that the catalogue or the dictionary knows is used; the catalogue takes
    precedence.
    """
    tails = [words[start:] for start in range(len(words))]
    named = next((tail for tail in tails if category_of(tail) is not None), ())
    entry = entry_of(words)
    if entry is not None and entry.is_thing and len(entry.noun.split()) > len(named):
        return entry.category, "" if entry.category else entry.family
    return category_of(named) if named else None, ""


def warn_of_stand_ins(objects: Sequence[PlannedObject]) -> list[str]:
    """Return a warning for each noun that is represented by a different object."""
    unknown = dict.fromkeys(o.noun for o in objects if o.category == GENERIC)
    shown = dict.fromkeys((o.noun, o.category) for o in objects if o.category != GENERIC)
    return [
        *(f"The catalogue has no {noun!r}; it is shown as a plain shape of plausible size."
          for noun in unknown),
        *(f"The catalogue has no {noun!r}; it is shown as {key.replace('_', ' ')!r}."
          for noun, key in shown if is_substituted(noun, key)),
    ]  # fmt: skip


IRREGULAR = frozenset(
    ["stood", "lay", "lain", "sat", "hung", "held", "kept", "set", "left", "stuck", "worn", "drawn",
     "thrown", "sunk", "bent", "broken", "eaten", "drunk", "fallen", "gone", "came", "went", "got",
     "gotten", "built", "brought", "bought", "caught", "found", "forgotten", "given", "grown",
     "hidden", "known", "laid", "led", "lent", "lost", "made", "meant", "met", "paid", "ran",
     "said", "seen", "sent", "shown", "shut", "slid", "spilt", "split", "taken", "taught", "told",
     "took", "ate", "began", "blew", "chose", "drank", "drew", "drove", "fell", "felt", "flew",
     "forgot", "froze", "grew", "hid", "knew", "lit", "rode", "rose", "sang", "shook", "slept",
     "sold", "spent", "spoke", "stole", "swam", "swept", "swung", "thought", "threw", "tore",
     "woke", "won", "wore", "wrote", "wound", "woven", "written", "wrapped"]
)  # fmt: skip
"""Irregular forms of words."""


@cache
def _table(name: str) -> frozenset[str]:
    packed = (files("generator.language") / "words" / f"{name}.txt.gz").read_bytes()
    return frozenset(gzip.decompress(packed).decode().split())


def is_adjective(word: str) -> bool:
    """Return whether a word is only an adjective: "shallow", "fluffy"."""
    return word in _table("adjectives")


@cache
def is_verb(word: str) -> bool:
    """Return whether a word is a form of a verb: infinitive, -s, -ed or -ing."""
    return word in IRREGULAR or any(stem in _table("verbs") for stem in _stems(word))


def is_finite(word: str) -> bool:
    """Return whether a word is a verb in the third person: "gets", "watches"."""
    return word.endswith("s") and not word.endswith("ss") and is_verb(word)


def _stems(word: str) -> list[str]:
    stems = [word]
    for end in ("s", "es", "d", "ed", "ing"):
        if word.endswith(end) and len(word) > len(end) + 2:
            stem = word.removesuffix(end)
            stems += [stem, f"{stem}e"]
            if len(stem) > 3 and stem[-1] == stem[-2]:  # "dropped"
                stems.append(stem[:-1])
    if word.endswith(("ies", "ied")):
        stems.append(f"{word[:-3]}y")
    return stems
