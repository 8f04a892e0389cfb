"""Numbers that belong to names, as the words around them tell."""

from __future__ import annotations

import re

from . import function_words as fw
from .number_patterns import NAMES, SPELT

AGE = re.compile(r"(?i)[ -]?years?[ -]olds?\b|[ -]?s\b(?!\s?[-–])")
YEAR = re.compile(r"1[5-9]\d\d|20\d\d")
_ITEM = re.compile(r"(?:^|[\n;,:.(]|\s)\s*$")
_NAMED = re.compile(r"(?:\b[A-Z]\w*|\b(?:[Vv]ersion|[Mm]odel)\.?)\s$")
_GLUED = re.compile(r"(?!X\b)[A-Z]{1,2}\b|[kdcp]\b")
_SINGULAR = ("a", "an", "one", "1")
_CAPITAL = re.compile(
    r"(?P<determiner>\b(?:[Aa]n?|[Tt]he|[Tt]his|[Mm]y|[Yy]our|[Hh]is|[Hh]er|[Oo]ur|[Tt]heir|"
    rf"[Oo]ne|{'|'.join(SPELT)}|\d+)) (?P<words>(?:[\w-]+ ){{0,2}}?[A-Z][\w-]*) $"
)
_CONTEXT = 80
_SMALL = frozenset(
    word
    for phrases in (fw.CARRIES, fw.RELATIONS, fw.BE, fw.STARTERS, fw.FILLERS, fw.DEFINITE,
                    fw.INDEFINITE, fw.JOINING, fw.RELATIVE, fw.AMOUNTS)
    for phrase in phrases
    for word in phrase.split()
)  # fmt: skip
"""Words that are no nouns."""


def ends_name(text: str, found: re.Match[str]) -> int | None:
    """Return how many letters follow digits that belong to a name; None where they do not.

    In "4K monitor" they begin a name; in "a Boeing 747 model" a determiner and a capital come
    before them, and no plural of which they would be the count comes after.
    """
    if found["unit"] or found["power"] or found["sign"]:
        return None
    before, after = words_before(text, found), text[found.end() :]
    glued = _GLUED.match(after)
    if glued and not text.isupper():
        return glued.end()
    named = _CAPITAL.search(before)
    if named is None or re.match(r"\s?[x×]\b|[-/]", after):
        return None
    words = named["words"].split()
    plural = words[-1].endswith("s") and words[-1].lower() not in NAMES
    if plural or any(word.lower() in _SMALL for word in words):
        return None
    several = named["determiner"].lower() not in _SINGULAR
    counts = re.match(r"\s\w*s\b", after) is not None
    return None if counts and not several else 0


def is_name(text: str, found: re.Match[str]) -> bool:
    """Tell whether digits are no quantity: an age, a year, a number of an item, or of a name."""
    before, after = text[: found.start("digits")], text[found.end() :]
    if (found["unit"] or "").strip(' "') or found["power"]:
        return False
    digits = found["digits"]
    if AGE.match(after) or YEAR.fullmatch(digits) or re.match(r"[A-Za-z]*[A-Z]|up\b", after):
        return True  # "5-year-old", "1990", "7up"
    if re.match(r"[.)](?:\s|$)", after) and _ITEM.search(before) and "(" not in before[-2:]:
        return after[0] == ")" or not before.rpartition("\n")[2].strip()  # of a list
    sentence = re.split(r"[.!?\n]\s*", before)[-1].strip()
    named = _NAMED.search(before)
    return named is not None and named.group().strip() != sentence


def noun_before(before: str) -> bool:
    """Tell whether a noun stands right before, so that a list goes on."""
    last = re.search(r"([a-z]+)\s*$", before, re.IGNORECASE)
    return last is not None and last[1].lower() not in _SMALL


def words_before(text: str, found: re.Match[str]) -> str:
    """Return the last words before a number."""
    return text[max(0, found.start() - _CONTEXT) : found.start()]
