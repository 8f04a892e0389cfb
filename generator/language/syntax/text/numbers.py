"""Patterns of written numbers, and contexts in which a number is part of a name."""

from __future__ import annotations

import re
from collections.abc import Mapping
from types import MappingProxyType

from . import function_words as fw

SPELT = ("two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven",
         "twelve", "fifteen", "twenty", "thirty", "forty", "fifty")  # fmt: skip
"""Single-word numbers that can be used in measures and as bounds of ranges."""

_OTHER_UNITS = (
    r"kg|kilos?|kilograms?|kilogrammes?|mg|g|grams?|grammes?|tonnes?|tons?|"
    r"oz|ounces?|lbs?|pounds?|ml|millilit(?:er|re)s?|cl|dl|l|lit(?:er|re)s?|pints?|gallons?|"
    r"degrees?|deg|radians?|rad|percent|per cent|watts?|w|kw|volts?|v|amps?|newtons?|n|hz|khz|mhz|"
    r"ghz|db|rpm|mah|gb|tb|mb|dollars?|euros?|cents?|kelvin|celsius|fahrenheit|hours?|minutes?|"
    r"seconds?|megapixels?|mp"
)
_LENGTHS = "|".join(sorted(fw.MEASURES, key=len, reverse=True))
_SPELT = "|".join(sorted((w for w, n in fw.NUMBERS.items() if n > 1), key=len, reverse=True))
_BOUNDS = "|".join(
    ("one", *SPELT, "thirteen", "fourteen", "sixteen", "seventeen", "eighteen", "nineteen", "sixty",
     "seventy", "eighty", "ninety", "hundred", "dozen")
)  # fmt: skip
DIGITS = r"\d+(?:,\d{3})*(?:\.\d+)?"
FRACTIONS = "½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞"
SIGNS = r"%|°\s?[CF]?|℃|℉|[€£¥$]|[″”\"](?!\w)"
_UNITS = rf"\s?(?:{SIGNS})|[ -]?(?:{_LENGTHS}|{_OTHER_UNITS})(?![a-z])"
_BOUND = rf"(?:\d{{1,4}}(?:\.\d{{1,4}})?(?!\d)|(?:{_BOUNDS})(?![a-z]))"
_MONTHS = (
    "january|february|april|june|july|august|september|october|november|december|jan|feb|apr|jun|"
    "jul|aug|sept|sep|oct|nov|dec"
)
NAMES = ("page", "chapter", "volume", "version", "room", "route", "channel", "level", "windows",
         "iphone", "ipad", "playstation", "xbox", "galaxy", "pixel", "formula",
         "apollo")  # fmt: skip
"""Words that can be followed by a number that belongs to a name."""

SPECIAL: Mapping[str, str] = MappingProxyType(
    {
        "code": r"\d+(?:[-/:]\d+){2,}(?!\w)",  # "12/24/2020", "555-12-34"
        "clock": r"(?:\d{1,2}\s?(?:-|–|to)\s?)?\d{1,2}(?:[:.][0-5]\d)?\s?(?:[ap]\.m\.|[ap]m\b|"
                 r"o'clock\b)|\d{1,2}:[0-5]\d(?!\w)",  # "5 pm", "7-9 am", "7:30"
        "ratio": r"\d+:\d+(?!\w)",  # "3:1"
        "decade": r"(?:\d\d)?\d0['’]?s\b",  # "1950s"
        "date": rf"\d{{1,2}}(?:(?:st|nd|rd|th)(?:\s+of)?\s+(?:{_MONTHS}|march|may)|"
                rf"\s(?:{_MONTHS}))\b(?:\s\d{{4}}\b)?",  # "4th of July"
        "ordinal": r"\d+(?:st|nd|rd|th)\b(?!\s?[-–])",  # "2nd"
        "label": r"\#\s?\d+\b|\b(?:no|nr)\.\s?\d+\b|"
                 rf"\b(?:size|number)\s\d+\b(?!{_UNITS})",  # "#2", "No. 2"
        "labelled": rf"\b(?:{'|'.join(NAMES)})s?\s\d+(?:\s?[-–]\s?\d+)?\b"
                    rf"(?!\s?[x×]|\s?\w*s\b|{_UNITS})",  # "Windows 11"
        "sum": r"(?<!\+)\d{1,3}(?:\s?\+\s?\d{1,3})+(?![\w.])",  # "2+2"
        "restated": rf"(?P<once>{_BOUND})\s?\(\s?(?P<again>{_BOUND})\s?\)",  # "twelve (12)"
        "least": r"\d{1,4}\+(?=\s[a-z])",  # "5+ apples"
        "range": rf"(?<![-/])(?<!\d,)(?P<between>\bbetween\s)?(?P<low>{_BOUND})"
                 rf"(?P<to>[ ]?[-–—~][ ]?|[ ](?:to|or|and)[ ]|-to-)(?P<high>{_BOUND})"
                 rf"(?P<range_unit>{_UNITS})?(?![-–~/:^\d]|[.,]\d|[a-z])",  # "5-6", "two or three"
        "share": rf"(?P<part>{_BOUND})\sof\s(?=(?P<the>the\s)?(?P<whole>{_BOUND}))",  # "2 of 3"
        "turned": r"\d+\s(?:page|piece|tier|sided|legged|layer|ply|speed|storey|burner)(?=\s[a-z])",
        "thousands": rf"(?<!,)[1-9]\d{{0,2}}(?:\.\d{{3}})+(?![\w.])(?!{_UNITS})",  # "1.000"
    }
)  # fmt: skip
"""Kinds of numbers other than plain ones, with their patterns; the first match wins."""

_PLAIN = rf"""
    (?P<name>(?<![a-z])[a-z]+[-_]?(?={DIGITS}))?            # "WD-40", "PS5", "block_2"
    (?P<sign>[$€£¥]\s?|(?<![\w.)])[-−])?
    (?:
        (?<![\d.])(?P<digits>(?<!,)\d+,\d{{1,2}}(?![\d,]|\.\d)
                           |\d+,\d+(?=\s?(?:{SIGNS}|(?:{_LENGTHS}|{_OTHER_UNITS})(?![a-z])))
                           |{DIGITS}(?:(?:[ -]\d+)?/\d+|\s?[{FRACTIONS}])?
                           |[{FRACTIONS}])
        (?P<power>\s?(?:[x×*]\s?10\s?)?(?:\^|\*\*)\s?[-+]?\d+|[⁰¹²³⁴-⁹]+|e[-+]\d+)?
        |(?<![\w-])(?P<spelt>(?:(?:{_SPELT})[ -])+)(?=(?:{_OTHER_UNITS})\b)(?!pint)
    )
    (?P<unit>{_UNITS})?
"""
NUMBER = re.compile(_PLAIN, re.IGNORECASE | re.VERBOSE)
ANY = re.compile(
    r"(?<![\w.])(?:" + "|".join(f"(?P<{kind}>{p})" for kind, p in SPECIAL.items()) + ")|" + _PLAIN,
    re.IGNORECASE | re.VERBOSE,
)

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
"""Words that are not nouns."""


def ends_name(text: str, found: re.Match[str]) -> int | None:
    """Return how many letters after digits complete a name, or None if the digits are not in one.

    In "4K monitor" they begin a name; in "a Boeing 747 model" a determiner and a capitalised word
    precede them, and no plural follows that they could count.
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
    """Return whether digits are an age, a year, a list number or part of a name, not a quantity."""
    before, after = text[: found.start("digits")], text[found.end() :]
    if (found["unit"] or "").strip(' "') or found["power"]:
        return False
    digits = found["digits"]
    if AGE.match(after) or YEAR.fullmatch(digits) or re.match(r"[A-Za-z]*[A-Z]|up\b", after):
        return True  # "5-year-old", "1990", "7up"
    if re.match(r"[.)](?:\s|$)", after) and _ITEM.search(before) and "(" not in before[-2:]:
        return after[0] == ")" or not before.rpartition("\n")[2].strip()  # number of a list item
    sentence = re.split(r"[.!?\n]\s*", before)[-1].strip()
    named = _NAMED.search(before)
    return named is not None and named.group().strip() != sentence


def noun_before(before: str) -> bool:
    """Return whether ``before`` ends with a noun, so that a list continues."""
    last = re.search(r"([a-z]+)\s*$", before, re.IGNORECASE)
    return last is not None and last[1].lower() not in _SMALL


def words_before(text: str, found: re.Match[str]) -> str:
    """Return the last words before a number."""
    return text[max(0, found.start() - _CONTEXT) : found.start()]
