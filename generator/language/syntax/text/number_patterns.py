"""Patterns of numbers as they are written in a text. Data only."""

from __future__ import annotations

import re
from collections.abc import Mapping
from types import MappingProxyType

from . import function_words as fw

SPELT = ("two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven",
         "twelve", "fifteen", "twenty", "thirty", "forty", "fifty")  # fmt: skip
"""Numbers in one word that measure and bound ranges."""

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
"""Words whose number is part of a name."""

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
"""What numbers are besides plain ones: kinds and patterns, the first that fits wins."""

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
