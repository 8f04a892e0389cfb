"""English to chunks: noun phrases and the connecting words between them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

from . import lexicon
from .vocabulary import (
    CARRIES,
    COLLECTIVES,
    COLORS,
    DEFINITE,
    FILLERS,
    GROUP_NOUNS,
    LOOSE_NOUNS,
    MATERIALS,
    NUMBERS,
    OTHERS,
    PARTS,
    PRONOUNS,
    RELATIONS,
    SHADES,
    SIZES,
    STATES,
    TABLE_NOUNS,
    VAGUE,
    VAGUE_THINGS,
    VERBS,
)

NounKind = Literal[
    "object", "unknown", "table", "pronoun", "place", "part", "group", "mixed", "amount",
    "adjective", "vague",
]  # fmt: skip
MEASURES: Mapping[str, float] = {
    "mm": 0.001, "millimeter": 0.001, "cm": 0.01, "centimeter": 0.01, "centimetre": 0.01,
    "m": 1.0, "meter": 1.0, "metre": 1.0, "inch": 0.0254,
}  # fmt: skip


@dataclass(frozen=True)
class NounPhrase:
    """A noun with what goes before it.

    ``count`` is None if the text gives no number; ``vague`` is the range of a vague one.
    ``lengths`` are metres given in the text ("20 cm tall"); ``members`` the categories of a
    mixed group ("cutlery").
    """

    kind: NounKind
    words: tuple[str, ...]
    noun: str = ""
    category: str | None = None
    count: float | None = None
    vague: tuple[int, int] | None = None
    definite: bool = False
    other: bool = False
    plural: bool = False
    attributes: dict[str, str] = field(default_factory=dict)
    members: tuple[str, ...] = ()
    lengths: tuple[float, ...] = ()

    @property
    def determined(self) -> bool:
        """Whether an article, a number or a vague amount introduces it."""
        return self.definite or self.count is not None or self.vague is not None


@dataclass(frozen=True)
class Chunk:
    """One piece of a sentence.

    ``kind``: "noun", "relation" (text = kind of relation, plus the target it carries), "carry"
    (with, hold, without), "and", "comma", "of", "stop", "are" or "gap".
    """

    kind: str
    text: str = ""
    noun: NounPhrase | None = None


def chunks(words: Sequence[str]) -> list[Chunk]:
    """Cut a tokenised text into chunks, longest phrase first."""
    out: list[Chunk] = []
    run: list[str] = []
    i = 0
    while i < len(words):
        step, chunk = _connector(words, i)
        starts = words[i] in DEFINITE or _is_number(words[i]) or words[i] in VAGUE
        if chunk is not None or (starts and any(_is_content(w) for w in run)):
            _flush(run, out)
        if chunk is not None:
            out.append(chunk)
        else:
            run.extend(words[i : i + step])
        i += step
    _flush(run, out)
    return out


def _connector(words: Sequence[str], i: int) -> tuple[int, Chunk | None]:
    """Return how many words to take at ``i`` and the chunk they make; None if they are a noun's."""
    for length in range(min(5, len(words) - i), 1, -1):
        if lexicon.is_phrase_start(tuple(words[i : i + length])):
            return length, None
    for length in range(min(6, len(words) - i), 0, -1):
        phrase = " ".join(words[i : i + length])
        if phrase in RELATIONS:
            return length, Chunk("relation", RELATIONS[phrase])
        if phrase in CARRIES:
            return length, Chunk("carry", CARRIES[phrase])
    return 1, _small_word(words[i])


def _small_word(word: str) -> Chunk | None:
    if word in ".;:!?\n()":
        return Chunk("stop")
    if word == ",":
        return Chunk("comma")
    if word in ("and", "plus", "or"):
        return Chunk("and")
    if word == "of":
        return Chunk("of")
    if word in PRONOUNS:
        return Chunk("noun", noun=NounPhrase("pronoun", (word,), definite=True))
    if word in ("is", "are", "each"):
        return Chunk("are", word)
    if word in VERBS or word in FILLERS:
        return Chunk("gap", word)
    return None


def _is_number(word: str) -> bool:
    return word in NUMBERS or word.lstrip("-")[:1].isdigit()


def _is_content(word: str) -> bool:
    counted = _is_number(word) or word in VAGUE or word in DEFINITE or word in ("half", "x")
    return not counted and word not in OTHERS


def _flush(run: list[str], out: list[Chunk]) -> None:
    if run:
        out.append(Chunk("noun", noun=noun_phrase(tuple(run))))
        run.clear()


# ------------------------------------------------------------------------------- noun phrases


def noun_phrase(run: tuple[str, ...]) -> NounPhrase:
    """Read a run of words without connectors: numbers, describing words, and the noun last."""
    lengths, run = _lengths(run)
    phrase = next((run[k:] for k in range(len(run)) if lexicon.is_phrase_start(run[k:])), ())
    content = tuple(w for w in run[: len(run) - len(phrase)] if _is_content(w))
    content = (*content, *phrase) if phrase else _trim(content)
    kind, head, category = _head(content)
    modifiers = content[: len(content) - len(head)] if head else content
    count, vague = _count([w for w in run if w not in head])
    if head == ("glasses",) and (count or vague):  # two glasses are for drinking
        head, category = ("glass",), lexicon.category_of(("glass",))
    attributes = attributes_of(modifiers)
    if category is None and kind == "unknown":
        head = content[-2:] if len(content) > 1 and _is_plain(content[-2]) else content[-1:]
    noun = " ".join((*head[:-1], lexicon.singular(head[-1]))) if head else ""
    if head and "of" in head:
        noun = " ".join((lexicon.singular(head[0]), *head[1:]))
    elif head and category and " ".join(head) != noun and lexicon.category_of(head) == category:
        noun = noun if lexicon.is_plural(head) else " ".join(head)
    return NounPhrase(
        kind, content, noun, category, count, vague,
        definite=bool(DEFINITE & set(run)), other=bool(OTHERS & set(run)),
        plural=bool(head) and lexicon.is_plural(head), attributes=attributes,
        members=lexicon.collective_of(head) if kind == "mixed" else (), lengths=lengths,
    )  # fmt: skip


def _trim(content: tuple[str, ...]) -> tuple[str, ...]:
    """Drop trailing words that only describe: "mug steaming gently", "table set"."""
    while len(content) > 1 and not any(
        lexicon.category_of(content[start:]) for start in range(len(content))
    ):
        last = content[-1]
        earlier = any(
            lexicon.category_of((w,)) or w in TABLE_NOUNS or w in GROUP_NOUNS for w in content[:-1]
        )
        describes = last in STATES or last in SIZES or last in SHADES or last in COLORS
        if (
            not earlier
            or not (describes or last.endswith(("ing", "ed", "ly")) or last in GROUP_NOUNS)
            or " ".join(content) in COLLECTIVES
        ):
            break
        content = content[:-1]
    return content


def _head(content: tuple[str, ...]) -> tuple[NounKind, tuple[str, ...], str | None]:
    """Find the head noun: the longest known ending, else the last word."""
    if not content:
        return "amount", (), None
    last = content[-1]
    for start in range(len(content)):
        tail = content[start:]
        if lexicon.collective_of(tail):
            return "mixed", tail, None
        if " ".join(tail) not in TABLE_NOUNS and (key := lexicon.category_of(tail)):
            strange = any(_is_strange(word) for word in content[:start])
            if not (strange and len(tail) == 1 and last in LOOSE_NOUNS):
                return "object", tail, key
    if last in TABLE_NOUNS:
        return "table", (last,), None
    if last in VAGUE_THINGS:
        return "vague", (last,), None
    if last in PARTS:
        return "part", (last,), None
    if lexicon.is_setting(last):
        return "place", (last,), None
    if last in GROUP_NOUNS:
        return "group", (last,), None
    if not any(_is_plain(word) for word in content):
        return "adjective", (), None
    return "unknown", (last,), None


def _is_strange(word: str) -> bool:
    """Tell whether a word before a noun may change what it means ("arduino board")."""
    return _is_plain(word) and word not in lexicon.vocabulary()


def _is_plain(word: str) -> bool:
    """Tell whether a word describes nothing known, so that it may be a noun."""
    known = (STATES, SIZES, COLORS, SHADES, MATERIALS)
    return not any(word in words for words in known) and not word.endswith("ly")


def attributes_of(modifiers: Sequence[str]) -> dict[str, str]:
    """Return the "color", "material", "size" and "state" that describing words name."""
    found: dict[str, str] = {}
    for before, word in zip((None, *modifiers), modifiers, strict=False):
        if word in COLORS and not (word in MATERIALS and "color" in found):
            shade = f"{before} " if before in SHADES else ""
            found.setdefault("color", shade + word)
        elif word in MATERIALS:
            found.setdefault("material", word)
        elif word in SIZES:
            found.setdefault("size", SIZES[word])
        elif word in STATES:
            found.setdefault("state", word)
    return found


def _count(run: Sequence[str]) -> tuple[float | None, tuple[int, int] | None]:
    """Return the exact count and the vague range that introduce a noun (either may be None)."""
    vague = next((VAGUE[w] for w in run if w in VAGUE), None)
    if vague is not None:
        return None, vague
    total: float | None = None
    for word in run:
        if not _is_number(word):
            continue
        value = min(float(NUMBERS.get(word, word)), 1e12)
        if total is None:
            total = value
        elif 20 <= total < 100 and value < 10:
            total += value
        else:
            total = min(total * value, 1e12)
    if total is not None and run and run[0] == "half" and "dozen" in run:
        total /= 2
    return total, None


def _lengths(run: tuple[str, ...]) -> tuple[tuple[float, ...], tuple[str, ...]]:
    """Take "20 cm" out of a run; "120 x 60 cm" gives two lengths."""
    lengths: list[float] = []
    rest: list[str] = []
    pending: list[float] = []
    for word in run:
        unit = MEASURES.get(word) or MEASURES.get(lexicon.singular(word))
        if word not in NUMBERS and _is_number(word):
            pending.append(min(float(word), 1e12))
        elif unit is not None and pending:
            lengths += [value * unit for value in pending]
            pending = []
        elif not (word in ("x", "by") and pending):
            rest += [f"{value:g}" for value in pending]
            pending = []
            rest.append(word)
    return tuple(lengths), tuple(rest + [f"{value:g}" for value in pending])
