"""Numbers as written in a text, and their replacements for the grammar.

A number that neither counts nor measures ("24/7", "5°", "$5", "#2", "Windows 11", "1950s") is
blanked before parsing, so that it never becomes a count. A range, a sum and a decimal comma are
replaced by a single number. Replacements preserve the length of the text and thus the positions of
words.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

from . import function_words as fw
from .numbers import (
    AGE,
    ANY,
    DIGITS,
    FRACTIONS,
    NUMBER,
    SIGNS,
    SPECIAL,
    YEAR,
    ends_name,
    is_name,
    noun_before,
    words_before,
)

Role = Literal["count", "range", "aside", "name"]


@dataclass(frozen=True)
class WrittenNumber:
    """A number as it is written in a text.

    Attributes:
        text: the number with its unit, as written.
        start: where it starts in the text.
        end: where it ends in the text.
        value: None if it is not a plain number ("10^9"); the lower bound of a range.
        unit: "" if it has none.
        role: a "count" may count or measure, as may the lower bound of a "range"; an "aside" does
            neither; a "name" is not a quantity.
        read: replacement for the grammar; None means the text itself.
    """

    text: str
    start: int
    end: int
    value: float | None = None
    unit: str = ""
    role: Role = "count"
    read: str | None = None


_ROLES: Mapping[str, Role] = MappingProxyType(
    {"code": "aside", "clock": "name", "ratio": "aside", "decade": "name", "date": "name",
     "label": "name", "turned": "aside"}
)  # fmt: skip
"""Roles of those kinds of number that are blanked completely."""

_SCALE = re.compile(r"(?i)\b(?:scale|ratio)(?:\s(?:of|is))?\s*$")
_PART = re.compile(r"(?i)-[a-z]+")
_FULL = re.compile(r"(?i) (?:full|filled|empty)\b(?! (?:of|with)\b)")


def written_numbers(text: str) -> Iterator[WrittenNumber]:
    """Yield the numbers in a text: digits, and ranges, masses and similar quantities in words."""
    place = 0
    while found := ANY.search(text, place):
        kind = next((k for k in SPECIAL if found[k] is not None), None)
        number = _special(kind, text, found) if kind else _plain(text, found)
        if number is None and kind:
            again = NUMBER.match(text, found.start())
            number = _plain(text, again) if again else None
            place = again.end() if again else found.start() + 1
        else:
            place = found.end()
        if number is not None:
            yield number


def settle_numbers(text: str) -> str:
    """Return a text with its numbers replaced for the grammar; its length is unchanged."""
    parts: list[str] = []
    place = 0
    for number in written_numbers(text):
        if number.read is not None:
            parts += [text[place : number.start], number.read]
            place = number.end
    return "".join(parts) + text[place:]


# ------------------------------------------------------------------------------------ kinds


def _special(kind: str, text: str, found: re.Match[str]) -> WrittenNumber | None:
    """Return a number of a special kind, or None if it is a plain number."""
    if kind not in _ROLES:
        return _READERS[kind](text, found)
    scaled = kind == "clock" and (
        _SCALE.search(words_before(text, found)) or text[found.end() :].startswith(" scale")
    )
    return _blank(found, "aside" if scaled else _ROLES[kind])


def _blank(found: re.Match[str], role: Role) -> WrittenNumber:
    return WrittenNumber(found.group(), *found.span(), role=role, read=" " * len(found.group()))


def _ordinal(text: str, found: re.Match[str]) -> WrittenNumber:
    """Parse "2nd", which the grammar reads as "second"; ordinals above "6th" are blanked out."""
    if 1 <= int(found.group()[:-2][:9]) <= max(fw.ORDINALS.values()):
        return WrittenNumber(found.group(), *found.span(), role="name")
    return _blank(found, "aside")


def _label(text: str, found: re.Match[str]) -> WrittenNumber:
    """Parse "Windows 11", keeping the name without its number."""
    said = found.group()
    name = said.rstrip("0123456789 -–")
    return WrittenNumber(said, *found.span(), role="name", read=name.ljust(len(said)))


def _sum(text: str, found: re.Match[str]) -> WrittenNumber | None:
    """Parse "2+2" as 4; "plates 2 + 2 mugs" is a list."""
    said = found.group()
    if " " in said and noun_before(words_before(text, found)):
        return None
    total = sum(int(part) for part in said.split("+"))
    if len(str(total)) > len(said):
        return None
    return WrittenNumber(said, *found.span(), float(total), read=str(total).rjust(len(said)))


def _range(text: str, found: re.Match[str]) -> WrittenNumber | None:
    """Parse "5-6", "two or three" and "between 2 and 3" as the lower bound."""
    said, low, high, unit = found.group(), found["low"], found["high"], found["range_unit"] or ""
    joined = found["to"].strip()
    spaced = found["to"] in (" - ", " – ", " — ", " ~ ")
    if (joined == "and") != bool(found["between"]):
        return None
    if spaced and noun_before(words_before(text, found)):
        return None  # "a plate 2 - 3 mugs"
    first, last = _bound(low), _bound(high)
    if first == last or (joined in "-–—~" and not low[0].isdigit() and first > last):
        return None  # "twenty-five"
    if all(YEAR.fullmatch(bound) for bound in (low, high)):
        return _blank(found, "name")
    sign = unit.strip(" -").lower()
    if re.match(SIGNS, sign) or words_before(text, found).endswith(tuple("$€£¥")):
        return _blank(found, "aside")
    least = min(first, last) if unit or min(first, last) >= 1 else max(first, last)
    read = (low if least == first else high).rjust(len(said) - len(unit)) + unit
    role: Role = "name" if AGE.match(text, found.end()) else "range"
    return WrittenNumber(said, *found.span(), least, sign, role, read)


def _restatement(text: str, found: re.Match[str]) -> WrittenNumber | None:
    """Parse "twelve (12)" as one number."""
    value = _bound(found["once"])
    if value != _bound(found["again"]):
        return None
    read = found["once"].ljust(len(found.group()))
    return WrittenNumber(found.group(), *found.span(), value, read=read)


def _least(text: str, found: re.Match[str]) -> WrittenNumber:
    """Parse "5+" as 5."""
    said = found.group()
    return WrittenNumber(said, *found.span(), float(said[:-1]), "", "range", said[:-1] + " ")


def _share(text: str, found: re.Match[str]) -> WrittenNumber | None:
    """Parse "2 of 3 mugs" as all of them; the grammar itself handles "two of the three"."""
    part, whole = found["part"], found["whole"]
    spelt = found["the"] and not part[0].isdigit()
    if spelt or _bound(part) > _bound(whole):
        return None
    return WrittenNumber(part, *found.span(), _bound(part), "", "aside", " " * len(found.group()))


def _thousands(text: str, found: re.Match[str]) -> WrittenNumber:
    """Parse "1.000" as a thousand."""
    said = found.group()
    plain = said.replace(".", "")
    return WrittenNumber(said, *found.span(), float(plain), read=plain.rjust(len(said)))


_READERS: Mapping[str, Callable[[str, re.Match[str]], WrittenNumber | None]] = MappingProxyType(
    {"ordinal": _ordinal, "labelled": _label, "sum": _sum, "range": _range, "share": _share,
     "restated": _restatement, "least": _least, "thousands": _thousands}
)  # fmt: skip


def _bound(said: str) -> float:
    return float(said) if said[0].isdigit() else float(fw.NUMBERS[said.lower()])


# ------------------------------------------------------------------------------------ plain ones


def _plain(text: str, found: re.Match[str]) -> WrittenNumber | None:
    """Return a plain number, or None if the digits are part of a word ("PS5")."""
    if found["name"]:
        return None
    digits = found["digits"] or ""
    start, end = found.span()
    if digits and (length := ends_name(text, found)) is not None:
        end = found.end("digits") + length
        return WrittenNumber(text[start:end], start, end, role="name", read=" " * (end - start))
    if digits and is_name(text, found):
        return WrittenNumber(found.group(), start, end, role="name")
    unit = (found["unit"] or "").strip(" -").lower() or (found["sign"] or "").strip("-− ")
    if unit == '"' and text[:start].endswith('"'):  # a number between quotes
        unit = ""
    part = _PART.match(text, end)
    said = found.group().strip(" -") + (part.group() if part else "")
    if found["power"]:
        return WrittenNumber(said, start, end, None, unit)
    role, read = _role(text, found, unit)
    if role == "aside" and (full := _FULL.match(text, end)):
        end, read = full.end(), " " * (full.end() - start)
    return WrittenNumber(said, start, end, _value(digits), unit, role, read)


def _role(text: str, found: re.Match[str], unit: str) -> tuple[Role, str | None]:
    """Return the role of a plain number, and its replacement for the grammar."""
    said, digits = found.group(), found["digits"] or ""
    blank = " " * len(said)
    if unit and re.match(SIGNS, unit):
        return "aside", blank  # "$5", "5°", "50%"
    if digits and unit and unit not in fw.MEASURES and unit not in fw.WEIGHTS:
        plural = unit.endswith("s") and len(unit) > 3
        if plural or not re.match(r"[ -]?[A-Za-z]", text[found.end() :]):
            return "count", None  # "20 euros"
        kept = found["unit"] if unit in ("dollar", "euro", "cent") else ""
        return "aside", kept.rjust(len(said))  # "a 45 rpm record", "a 20 euro note"
    if _is_fraction(digits) and unit not in fw.MEASURES:
        return "aside", blank  # "24/7", "3/4 of a cake"
    if re.fullmatch(r"\d+,\d{1,2}", digits):
        return "count", said.replace(",", ".")
    return "count", None


def _is_fraction(digits: str) -> bool:
    """Return whether digits are just a fraction other than "1/2", which describes objects."""
    alone = re.fullmatch(rf"\d+/\d+|[{FRACTIONS}]", digits) is not None
    return alone and digits not in ("1/2", "½")


def _value(digits: str) -> float | None:
    """Return the value of "1,000", "2.5", "2,5", "3 1/2" and "3½", or None for other texts."""
    if re.fullmatch(r"\d+,\d{1,2}", digits):
        return float(digits.replace(",", "."))
    if digits and digits in FRACTIONS:
        return unicodedata.numeric(digits)
    whole = re.fullmatch(
        rf"(?P<whole>{DIGITS})(?:[ -](?P<over>\d+)/(?P<under>\d+)|\s?(?P<sign>[{FRACTIONS}]))?",
        digits,
    )
    if whole is None:
        return None
    part = unicodedata.numeric(whole["sign"]) if whole["sign"] else 0.0
    if whole["under"] and int(whole["under"][:9]):
        part = int(whole["over"][:9]) / int(whole["under"][:9])
    return float(whole["whole"].replace(",", "")) + part
