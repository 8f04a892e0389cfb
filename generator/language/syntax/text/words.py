"""From text to words, numbers and punctuation marks, each with its span."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass
from typing import Literal

from .figures import settle_numbers
from .function_words import MEASURES, NUMBERS, ORDINALS
from .numbers import SPELT

WordKind = Literal["word", "number", "mark"]

_ABBREVIATIONS = {
    "w/o": "without", "w/": "with", "&": "and", "+": "and", "pls": "please", "plz": "please",
    "approx": "about", "ca": "about", "inc": "including", "incl": "including",
}  # fmt: skip
_PIECE = re.compile(
    r"""
    (?P<abbreviation>w/o\b|w/|[&+])
    |(?P<contraction>\b(?:there|it|that|here|what|where|who)'s\b|\b(?:i|you|we|they)'(?:ve|re|ll|d|m)\b)
    |(?P<negated>[a-z]+n't)
    |(?P<possessive>(?<=[a-z])'s?(?![a-z]))
    |(?P<circa>\b(?:ca|approx|incl|inc|max|min|no|nr)\.(?=\s*[\da-z]))
    |(?P<latin>\b(?:i\.\s?e\.?|e\.\s?g\.?|viz\.))
    |(?P<ordinal>(?<![\w.])[1-6](?:st|nd|rd|th)\b)
    |(?P<number>(?<![\w.])-?\d+(?:,\d{3})*(?:\.\d+)?(?:e\d+)?|(?<=\dx)\d+)
    |(?P<word>[a-z]+)
    |(?P<dash>\s[-–—]+\s|[–—])
    |(?P<mark>[,.;:!?()\n"/=])
    """,
    re.VERBOSE,
)
_CONTRACTED = {"s": "is", "ve": "have", "re": "are", "m": "am", "ll": "will", "d": "would"}
_RUN_TOGETHER = {
    "infront": ("in", "front"), "ontop": ("on", "top"), "nextto": ("next", "to"),
    "atleast": ("at", "least"), "alot": ("a", "lot"), "ontopof": ("on", "top", "of"),
    "infrontof": ("in", "front", "of"), "inbetween": ("in", "between"),
}  # fmt: skip
_ORDINALS = {place: word for word, place in ORDINALS.items()}
_TAG = re.compile(r"</?[A-Za-z][^<>\n]{0,80}>")
_PARTS = re.compile(
    r"(?i)\b(?:one|two|three|four|five|six|seven|eight|nine|ten|twelve|single|double|multi|\d+)-"
    r"(?:tier|tiered|tone|toned|piece|legged|sided|layer|layered|litre|liter|door|drawer|slice|"
    r"handled|pronged|armed|burner|cup|ply|speed|storey|part|stage|colour|coloured|color|colored|"
    r"year|level|ring|hole|string|button|key|arm|branch|wick|pack|page|card|star|"
    r"pointed|way|wheeled|headed|bladed)s?\b"
)
"""Words such as "two-tier" that describe a single object."""
_TIMES = re.compile(r"(?<=[a-z)])\s+[x×]\s?(\d{1,2})\b(?!\s?(?:[x×]|[cm]?m\b|in\b))", re.IGNORECASE)
"""Counts that follow the noun: "forks x4"."""
_SPELT_LENGTH = re.compile(
    rf"(?i)(?<![\w-])({'|'.join(SPELT)})[ -]"
    r"(?=(?:mm|cm|millimet(?:er|re)|centimet(?:er|re)|inch|f(?:oo|ee)t\b)(?:e?s)?\b)"
)
"""Lengths written in words: "ten centimetres"."""
_WITH = re.compile(r"(?<=[a-z,.)]) w (?=[a-z\d])")
_LEFTMOST = re.compile(r"(?i)\b(left|right)most\b(?=( (?:is|being|has|holds|stands|and)\b|,)?)")
_FOOT_LONG = re.compile(r"(?i)\bfoot[ -]long\b")
_PREDICATE = re.compile(
    r"(?i)\((?=[^()]{0,80}[_\d])"
    r"(on|in|inside|left_of|right_of|behind|in_front_of|next_to|near|under)\s+([a-z_]\w*)\s+([a-z_]\w*)\s*\)"
)
"""A fact in a planning language: "(on red_block blue_block)"."""
_AGE = re.compile(r"(?i)\b(?:the )?[a-z0-9]+(?:-| )years?(?:-| )olds?\b")
_JOINED_UP = re.compile(r"(?i)(?<=[a-z])(?<!upside)-(?:up|down|out|off)\b")
_BAKERS = re.compile(r"(?i)\bbaker[’']s dozen\b")
_VAGUE_COUNT = re.compile(r"(?i)\b(?:some|several|a few|a couple of) ?\( *(\d+)\)")
_LIKE = re.compile(
    r"(?i)\b[a-z]+-(?:shaped|sized|style|styled|themed|scented|flavoured|flavored|inspired|like|free)\b"
)
"""Suffixes of shapes and scents: "cat-shaped"."""
_AMOUNT = re.compile(r"(?i)\(\s*\d+(?:[.,]\d+)?\s*(?:ml|l|cl|dl|g|kg|oz|lb|lbs|w|v|gb|mb)\s*\)")
_SLASHED = re.compile(r"(?<![\d/.,])(?:(\d+)(?: +| ?- ?))?([1-9])/([2-8])(?![\d/])")
"""A fraction with a slash: "3 1/2", but not "1/2/3"."""
_BULLET = re.compile(r"(?m)^[ \t]*(?:[-*•‣·–]|\d+[.)])[ \t]+")


@dataclass(frozen=True)
class Word:
    r"""A lower-case word without accents, a number, or a punctuation mark.

    ``start`` and ``end`` are its span in the text. Marks are punctuation, "\n" for the end of a
    line, "'s" for a possessive, and "-" for a dash between parts of a sentence.
    """

    text: str
    start: int
    end: int
    kind: WordKind = "word"


def words_of(text: str) -> tuple[Word, ...]:
    """Return the words in a text; bullets and the numbers of list items become line ends."""
    text = settle_numbers(text)
    text = _TAG.sub(lambda found: " " * len(found.group()), text)
    text = _BAKERS.sub(lambda found: "13".ljust(len(found.group())), text)
    text = _VAGUE_COUNT.sub(lambda found: found[1].rjust(len(found.group())), text)
    text = _LIKE.sub(lambda found: " " * len(found.group()), text)
    facts = _facts_of(text)
    text = _PREDICATE.sub(lambda found: " " * len(found.group()), text)
    text = _SPELT_LENGTH.sub(lambda m: f"{NUMBERS[m[1].lower()]:g} ".ljust(len(m.group())), text)
    text = _WITH.sub(" w/", text)
    text = _LEFTMOST.sub(lambda m: (f"{m[1]} one" if m[2] else m[1]).ljust(len(m.group())), text)
    text = _FOOT_LONG.sub("1 ft long", text)
    text = _AMOUNT.sub(lambda found: " " * len(found.group()), text)
    text = _AGE.sub(lambda found: " " * len(found.group()), text)
    text = _JOINED_UP.sub(lambda found: " " * len(found.group()), text)
    text = _PARTS.sub(lambda found: " " * len(found.group()), text)
    text = _TIMES.sub(lambda found: f"({found[1]})".ljust(len(found.group())), text)
    text = _BULLET.sub(lambda found: "\n".ljust(len(found.group())), text)
    text = _SLASHED.sub(_fraction, text)
    plain, places = _plain(text)
    found = []
    for piece in _PIECE.finditer(plain):
        start, end = places[piece.start()], places[piece.end() - 1] + 1
        found += [Word(t, start, end, kind) for t, kind in _readings(piece)]
    return tuple(sorted([*found, *facts], key=lambda word: word.start) if facts else found)


def _facts_of(text: str) -> list[Word]:
    """Return "the red block on the blue block" for each "(on red_block blue_block)"."""
    found = []
    for fact in _PREDICATE.finditer(text):
        relation, one, other = (part.lower().replace("_", " ") for part in fact.groups())
        said = (",", "the", *one.split(), *relation.split(), "the", *other.split(), ",")
        found += [Word(w, *fact.span(), "mark" if w == "," else "word") for w in said]
    return found


def _readings(piece: re.Match[str]) -> list[tuple[str, WordKind]]:
    """Return the words in a piece of text after normalisation."""
    said, name = piece.group(), piece.lastgroup
    if name == "number":
        return [(said.replace(",", ""), "number")]
    if name == "ordinal":
        return [(_ORDINALS[int(said[0])], "word")]
    if name == "circa":
        return [(_ABBREVIATIONS.get(said[:-1], "about"), "word")]
    if name == "latin":
        corrects = said[0] == "i"  # "a thali, i.e. a round tray"
        return [(",", "mark"), *([("or", "word"), ("rather", "word")] if corrects else [])]
    if name == "dash":
        return [("-", "mark")]
    if name == "contraction":
        start, end = said.split("'")
        return [(start, "word"), (_CONTRACTED[end], "word")]
    if name == "possessive":
        return [("'s", "mark")]
    if name == "negated":
        return [("not", "word")]
    if name == "mark":
        return [({"/": ",", '"': "", "=": ":"}.get(said, said), "mark")] if said != '"' else []
    if said in _RUN_TOGETHER:
        return [(part, "word") for part in _RUN_TOGETHER[said]]
    return [(_ABBREVIATIONS.get(said, said), "word")]


def _fraction(found: re.Match[str]) -> str:
    """Replace "3 1/2" by "3½", padded to equal length; other fractions are unchanged."""
    sign = _FRACTIONS.get(int(found[2]) / int(found[3]))
    return found.group() if sign is None else f"{found[1] or ''}{sign}".ljust(len(found.group()))


_FRACTIONS = {
    unicodedata.numeric(sign): sign for sign in "½⅓⅔¼¾⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞"
}  # fmt: skip
_UNIT = re.compile(rf"\s*(?:{'|'.join(MEASURES)})\b", re.IGNORECASE)


def _decimal(letters: list[str], letter: str, rest: str) -> str:
    """Return a fraction sign as a decimal if it follows a number, or as "half" before an object."""
    value = f"{unicodedata.numeric(letter):.3g}"
    if letters and letters[-1].isdigit():
        return value[1:]
    return "half" if letter == "½" and not _UNIT.match(rest) else value


def _plain(text: str) -> tuple[str, list[int]]:
    """Return the text in lower case without accents, and each letter's original position."""
    letters: list[str] = []
    places: list[int] = []
    for place, letter in enumerate(text):
        letter = {"’": "'", "‘": "'", "×": "x", "\r": "\n", "\t": " "}.get(letter, letter)
        if letter in _FRACTIONS.values():
            letter = _decimal(letters, letter, text[place + 1 :])
        for part in unicodedata.normalize("NFKD", letter.lower()):
            if not unicodedata.combining(part):
                letters.append(part)
                places.append(place)
    return "".join(letters), places
