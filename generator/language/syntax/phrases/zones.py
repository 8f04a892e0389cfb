"""Zones: "in the far left corner", "on the right side of the desk", "centrally"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from ...vocabulary import TABLE_NOUNS
from ..text import function_words as fw
from ..text.tokens import Token
from .tree import Zone

_BEFORE = frozenset(
    {"in", "on", "at", "to", "near", "along", "towards", "toward", "by", "from", "into", "onto",
     "close", "against"}
)  # fmt: skip
_ARTICLES = frozenset({"the", "a", "an", "one", "its", "each", "this", "that"})
_DEGREES = frozenset(
    {"very", "far", "extreme", "just", "right", "slightly", "dead", "exact", "more", "upper",
     "lower", "hand"}
)  # fmt: skip
_ALL_FOUR = frozenset({"four", "4", "two", "2", "both", "all", "opposite"})
_ALONE = frozenset(["centrally", "centered", "central"])
_TOPS = frozenset(["surface", "tabletop", "top", "area", "workspace", "scene", "image", "picture"])


@dataclass(frozen=True)
class FoundZone:
    """A zone found in the tokens.

    Attributes:
        zone: the part of the table.
        end: index of the token after it.
        of: whether "of" follows, so that the zone may be part of an object other than the table.
        table: first and end token of the table's name, if present.
        aside: whether it is a phrase such as "to the left".
        loose: whether "on the left" has no "side", "corner" or "of the table" and may thus refer to
            an object.
    """

    zone: Zone
    end: int
    of: bool = False
    loose: bool = False
    aside: bool = False
    table: tuple[int, int] | None = None


def read_zone(tokens: Sequence[Token], start: int, *, heading: bool = False) -> FoundZone | None:
    """Return the zone that starts at a token, or None.

    ``heading`` allows a zone without a preposition: "left side with a lamp", "back: a plant".
    """
    i = start
    while _text(tokens, i) in ("just", "right", "slightly", "further", *fw.PARTICLES) and _text(
        tokens, i + 1
    ).split()[:1] in ([word] for word in _BEFORE):
        i += 1
    if _text(tokens, i) in _ALONE and not _is_noun(tokens, i + 1):
        return FoundZone(Zone(0, 0), i + 1)
    if alone := _stands_alone(tokens, i):
        return alone
    if _text(tokens, i) == "as" and _text(tokens, i + 2) in ("centerpiece", "centrepiece"):
        return FoundZone(Zone(0, 0), i + 3)
    introduced = _text(tokens, i).split()[-1:] != [] and _text(tokens, i).split()[0] in _BEFORE
    if introduced:
        if len(tokens[i].words) > 1 and _text(tokens, i) != "close to":
            return None
        i += 1
        i += _text(tokens, i) == "to"
    elif not heading and not _is_corner(tokens, i):
        return None
    article = _text(tokens, i) in _ARTICLES or _tag(tokens, i) == "each"
    one = i + 1 + (_text(tokens, i + 1) in ("front", "back", "left", "right", "far", "near"))
    every = _tag(tokens, i) == "each" and _text(tokens, one) == "corner"
    i += article
    if _text(tokens, i) in _ALL_FOUR and _text(tokens, i + 1) in ("corners", "sides", "ends"):
        i += 1
    owned = _text(tokens, i) in TABLE_NOUNS and _tag(tokens, i + 1) == "possessive"
    i += 2 * owned
    found = _sides(tokens, i, heading=heading, owned=owned)
    if every and found is not None and not found.of:
        return replace(found, zone=replace(found.zone, spread=True))
    if found is not None and _text(tokens, start) == "along":
        return replace(found, loose=False)
    aside = found is not None and found.loose and _text(tokens, start) == "to"
    return replace(found, aside=True) if found is not None and aside else found


_MIDDLE = frozenset(["centre", "center", "middle"])


def _stands_alone(tokens: Sequence[Token], i: int) -> FoundZone | None:
    """Parse "dead centre", "centre stage", and just "left" or "centre" after an object."""
    k = i + (_text(tokens, i) in ("dead", "smack", "right", "bang", "front"))
    if _text(tokens, k) in _MIDDLE and (k > i or _text(tokens, k + 1) == "stage"):
        end = k + 1 + (_text(tokens, k + 1) == "stage")
        if not _is_noun(tokens, end) and _tag(tokens, end) != "of":
            y = -1 if _text(tokens, i) == "front" else 0
            return FoundZone(Zone(0, y), end)
    if _text(tokens, i) in ("nearer", "closer", "nearest", "closest", "near", "close"):
        k = i + 1 + (_text(tokens, i + 1) == "to")
        k += _text(tokens, k) == "the"
        if _text(tokens, k) in ("me", "us", "viewer", "camera", "you"):
            return FoundZone(Zone(None, -1), k + 1)
    word, ended = _text(tokens, i), _tag(tokens, i + 1) in ("stop", "line", "", "comma", "close")
    if i and ended and word in (*_MIDDLE, "left", "right") and _tag(tokens, i - 1) in _NAMING:
        return FoundZone(Zone(*fw.SIDES[word]), i + 1)
    return None


_NAMING = frozenset(["word", "name", "close", "arranged"])


def _is_corner(tokens: Sequence[Token], i: int) -> bool:
    """Return whether "front right", without a preposition, is a zone here."""
    sides = [fw.SIDES.get(_text(tokens, k), (None, None)) for k in (i, i + 1)]
    named = next((k for k in (i + 1, i + 2) if _text(tokens, k) in fw.ZONE_NOUNS), 0)
    if named and all(_text(tokens, k) in fw.SIDES for k in range(i, named)):
        return _tag(tokens, named + 1) in ("stop", "line", "", "comma", "close")
    ended = _tag(tokens, i + 2) in ("stop", "line", "", "comma", "and", "close")
    return ended and any(x for x, _ in sides) and any(y for _, y in sides)


def _sides(tokens: Sequence[Token], i: int, *, heading: bool, owned: bool) -> FoundZone | None:
    words: list[str] = []
    while (word := _text(tokens, i)) in fw.SIDES or word in _DEGREES:
        words.append(word)
        i += 1
        if word in fw.SIDES and _tag(tokens, i) == "and" and _text(tokens, i + 1) in fw.SIDES:
            both = {word, _text(tokens, i + 1)} == {"left", "right"} and len(words) == 1
            if both and _text(tokens, i + 2) in fw.ZONE_NOUNS:
                end = i + 3
                of = _after_table(tokens, end + 1) if _tag(tokens, end) == "of" else None
                return FoundZone(Zone(0, None, spread=True), of or end)
            return None
        i += _tag(tokens, i) == "dash"
    noun = _text(tokens, i)
    row = heading and noun == "row" and bool(words)
    i_noun = (noun in fw.ZONE_NOUNS or row) and not (words and _is_thing(tokens, i))
    i += i_noun
    sides = [word for word in words if word in fw.SIDES]
    if not i_noun and (not sides or sides == ["far"] or sides == ["near"]):
        return None
    if not sides and noun not in fw.EDGES:
        return None
    of = _tag(tokens, i) == "of"
    if of:
        end = _after_table(tokens, i + 1)
        if end is None:
            return FoundZone(_zone(sides, noun), i, of=True)
        return FoundZone(_zone(sides, noun), end, table=(i + 1, end))
    if not i_noun and not heading and (_is_noun(tokens, i) or _text(tokens, i) in ("one", "ones")):
        return None
    if heading and not i_noun and _tag(tokens, i) not in ("colon", "dash", "line"):
        return None
    return FoundZone(_zone(sides, noun), i, loose=not i_noun and not owned and len(sides) == 1)


def _zone(sides: Sequence[str], noun: str) -> Zone:
    found = [fw.SIDES[side] for side in sides]
    if len(found) > 1:  # "back middle": the middle of the back; "far left": both
        found = [f for f in found if f != (0, 0)] if len(set(found)) > 1 else found
        middle = len(found) < len(sides)
    else:
        middle = False
    x = next((x for x, _ in found if x is not None), None)
    y = next((y for _, y in found if y is not None), None)
    if middle:
        x, y = (0 if x is None else x), (0 if y is None else y)
    spread = noun in ("corners", "ends") and (x is None or y is None)
    return Zone(x, y, noun in fw.EDGES, spread)


def _after_table(tokens: Sequence[Token], i: int) -> int | None:
    """Return the end of "the wooden table", or None for other phrases."""
    i += _text(tokens, i) in _ARTICLES
    for k in range(i, min(i + 4, len(tokens))):
        word = _text(tokens, k)
        if word in TABLE_NOUNS or word in _TOPS:
            return k + 1
        if _tag(tokens, k) != "word":
            return None
    return None


def _text(tokens: Sequence[Token], i: int) -> str:
    return tokens[i].text if 0 <= i < len(tokens) else ""


def _tag(tokens: Sequence[Token], i: int) -> str:
    return tokens[i].tag if 0 <= i < len(tokens) else ""


def _is_noun(tokens: Sequence[Token], i: int) -> bool:
    """Return whether a word that can be part of a noun phrase continues it here."""
    if _tag(tokens, i) == "name":
        return True
    word = _text(tokens, i)
    stops = fw.BE | fw.PARTICIPLES | fw.FILLERS | fw.DEFINITE | fw.INDEFINITE | fw.STARTERS
    return _tag(tokens, i) == "word" and word not in stops and word not in fw.NUMBERS


def _is_thing(tokens: Sequence[Token], i: int) -> bool:
    """Return whether a zone's noun is really the first word of an object ("side plate")."""
    return _tag(tokens, i + 1) == "word" and _text(tokens, i + 1) in ("plate", "table", "lamp")
