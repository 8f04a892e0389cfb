"""A text and the required content of its table; ``dev.json`` and ``test.json`` have one per line.

Texts were written and divided into the two halves before any run: theme by theme, easy ones first,
each into the half with fewer of its level and theme so far. ``more.json`` contains texts written
later for development: seven sets by writers who did not know the parser.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
HALVES = ("dev", "test")
MANY = 99
"""The upper end of an unbounded count."""

Names = str | tuple[str, ...]
"""One pattern, or several with objects of each."""


@dataclass(frozen=True)
class ExpectedThing:
    """Objects that the table must show: ``least`` to ``most`` whose name matches ``any``.

    ``word`` is the author's own word for them. ``cm`` is the range of the longest side,
    centimetres.
    """

    word: str
    any: str
    least: int
    most: int
    cm: tuple[float, float] | None = None
    colour: str | None = None


@dataclass(frozen=True)
class ExpectedRelation:
    """A relation of objects ``a`` to objects ``b``, or to the table if ``b`` is None.

    ``how`` is the number of ``a`` that must satisfy it: None for all, "some" for at least one, or a
    minimum number.
    """

    a: Names
    kind: str
    b: Names | None = None
    how: int | str | None = None


@dataclass(frozen=True)
class Case:
    """A text with its theme, its level, and all requirements on its table."""

    id: str
    theme: str
    level: str
    text: str
    objects: tuple[ExpectedThing, ...]
    relations: tuple[ExpectedRelation, ...] = ()
    absent: tuple[str, ...] = ()
    also: tuple[str, ...] = ()
    terms_may_warn: tuple[str, ...] = ()


def matches(pattern: str, words: str) -> bool:
    """Return whether a name contains the pattern as whole words, in singular or plural."""
    return re.search(rf"\b(?:{pattern})(?:s|es)?\b", plain(words)) is not None


def plain(words: str) -> str:
    """Return words in lower case, without numbers at the end of names, with hyphens as spaces."""
    return re.sub(r"[_\-]+|\b\d+\b", " ", words.lower().replace("_", " ")).strip()


def cases_of(half: str, folder: Path = HERE) -> list[Case]:
    """Return the cases of a half, of "both", or those of "more"."""
    halves = HALVES if half == "both" else (half,)
    lists = [json.loads((folder / f"{h}.json").read_text(encoding="utf-8")) for h in halves]
    return [case_of(entry) for entries in lists for entry in entries]


def case_of(entry: dict[str, Any]) -> Case:
    """Return a case from its entry in the file."""
    return Case(
        id=entry["id"],
        theme=entry["theme"],
        level=entry["level"],
        text=entry["text"],
        objects=tuple(_clause(o) for o in entry["objects"]),
        relations=tuple(_relation(*r) for r in entry.get("relations", ())),
        absent=tuple(entry.get("absent", ())),
        also=tuple(entry.get("also", ())),
        terms_may_warn=tuple(entry.get("terms_may_warn", ())),
    )


def _clause(entry: dict[str, Any]) -> ExpectedThing:
    count = entry["count"]
    least, most = (count, count) if isinstance(count, int) else count
    cm = (float(entry["cm"][0]), float(entry["cm"][1])) if "cm" in entry else None
    word = entry.get("word", entry["any"])
    return ExpectedThing(word, entry["any"], least, most, cm, entry.get("colour"))


def _relation(
    a: str | list[str], kind: str, b: str | list[str] | None = None, how: int | str | None = None
) -> ExpectedRelation:
    return ExpectedRelation(_names(a), kind, None if b is None else _names(b), how)


def _names(entry: str | list[str]) -> Names:
    return entry if isinstance(entry, str) else tuple(entry)
