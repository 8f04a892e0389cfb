"""Correction of misspelt words."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from dataclasses import replace
from functools import cache

from rapidfuzz.distance import OSA

from tabletop_objects import CATEGORIES

from .. import lexicon
from ..syntax.text.words import Word
from ..vocabulary import COLORS, PLACES
from .dictionary import is_english

_SHORTEST = 4
_SHORT = frozenset(
    ["the", "and", "with", "that", "this", "from", "want", "need", "please", "make", "there",
     "left", "right", "front", "behind", "between", "next", "beside", "under", "either", "side",
     "corner", "middle", "centre", "center", "table", "square", "circle", "round", "wooden",
     "three", "four", "five", "seven", "eight", "twelve", "dozen", "together", "around", "little",
     "small", "large", "standing", "lying", "stacked", "empty", "full", "holding", "each", "every",
     "without", "some", "front", "back", "inside", "top", "row", "line", "stack", "place", "one",
     "two", "half", "pair"]
)  # fmt: skip
"""Words, other than nouns, that are often misspelt."""


def correct(
    words: Sequence[Word], known: Collection[str]
) -> tuple[tuple[Word, ...], dict[str, str]]:
    """Return words with spelling mistakes corrected, and the corrections.

    A word that is neither English nor in ``known`` becomes the nearest word of the catalogue or of
    the grammar, at most one edit away (two for long words). If there are several such words, the
    one whose objects best match the others in the text is preferred. If a text contains misspelt
    words, a rare English word that is one edit away from a common one is corrected too.
    """
    strange = [w.text for w in words if _is_strange(w, known)]
    found = {word: best for word in sorted({*strange}) if (best := _best(word, words, strange))}
    if len(found) > 1:
        rare = {w.text for w in words if _is_rare(w, known)} - {*found}
        found |= {word: best for word in sorted(rare) if (best := _nearest(word, words, 1, set()))}
    found = {word: best for word, best in found.items() if best != word}
    after = [word.text for word in words[1:]]
    words = [
        replace(w, text="and") if w.text == "an" and {*after[k : k + 1]} & _AFTER_AND else w
        for k, w in enumerate(words)
    ]
    out: list[Word] = []
    for word in words:
        parts = found.get(word.text, word.text).split() if word.kind == "word" else [word.text]
        out += [replace(word, text=part) for part in parts]
    return tuple(out), found


_AFTER_AND = frozenset(["a", "an", "the", "two", "three", "some"])


def _is_strange(word: Word, known: Collection[str]) -> bool:
    text = word.text
    if word.kind != "word" or len(text) < _SHORTEST - 1 or _is_known(text, known):
        return False
    return not is_english(text)


def _is_rare(word: Word, known: Collection[str]) -> bool:
    return word.kind == "word" and len(word.text) >= _SHORTEST and not _is_known(word.text, known)


def _is_known(text: str, known: Collection[str]) -> bool:
    return text in known or lexicon.singular(text) in known


def _best(word: str, words: Sequence[Word], strange: Sequence[str]) -> str | None:
    """Return the correction of an unknown word: two separate words, or the nearest word."""
    if split := _split(word):
        return split
    themes = {
        theme
        for other in words
        if other.text not in strange and (key := lexicon.category_of((other.text,)))
        for theme in CATEGORIES[key].themes
    }
    return _nearest(word, words, 1 if len(word) < 7 else 2, themes)


def _split(word: str) -> str | None:
    """Split "sandtimer" into "sand timer"."""
    for at in range(3, len(word) - 2):
        if lexicon.category_of((word[:at], word[at:])) is not None:
            return f"{word[:at]} {word[at:]}"
    return None


@cache
def _candidates() -> tuple[str, ...]:
    joined = {name.replace(" ", "") for name in lexicon.names() if name.count(" ") == 1}
    words = lexicon.vocabulary() | _SHORT | COLORS | PLACES | joined
    return tuple(sorted(word for word in words if len(word) > 2))


def _nearest(word: str, words: Sequence[Word], limit: int, themes: set[str]) -> str | None:
    """Return the word that a misspelt word was probably meant to be, or None."""
    plural = word.endswith("s") and not word.endswith("ss")
    before = {a.text for a, b in itertools.pairwise(words) if b.text == word}
    ranked = []
    for candidate in _candidates():
        if len(word) < _SHORTEST and candidate not in _SHORT:
            continue
        several = plural and not candidate.endswith(("s", "y", "x"))
        for form in (candidate, f"{candidate}s") if several else (candidate,):
            if abs(len(form) - len(word)) > limit or len(form) < 3:
                continue
            distance = OSA.distance(word, form, score_cutoff=limit)
            if distance <= limit and (distance < 2 or _sound_alike(form[0], word[0])):
                named = not any(lexicon.category_of((first, form)) for first in before)
                mixed = sorted(form) != sorted(word)
                apart = abs(len(form) - len(word)) if distance > 1 else int(len(form) <= len(word))
                shared = -_count_shared(candidate, themes)
                first = form[0] != word[0]
                unknown = candidate not in _SHORT and not _means(candidate)
                cut = not form.startswith(word)
                ranked.append((distance, named, unknown, mixed, first, cut, apart, shared, form))
    best = min(ranked)[-1] if ranked else None
    return None if best == word else _whole(best)


def _sound_alike(a: str, b: str) -> bool:
    """Return whether words with different initial letters may sound alike, as in "kutlery"."""
    return a == b or any({a, b} <= set(group) for group in ("ckqs", "sz", "fpv", "gj", "iey", "uw"))


def _means(word: str) -> bool:
    return word in COLORS or word in PLACES or lexicon.category_of((word,)) is not None


def _whole(word: str | None) -> str | None:
    """Return "chess board" for "chessboard" if the two-word name is in the catalogue."""
    if word is None or lexicon.category_of((word,)) is not None or word in lexicon.vocabulary():
        return word
    return _split(word) or word


def _count_shared(word: str, themes: set[str]) -> int:
    key = lexicon.category_of((word,))
    return len(themes.intersection(CATEGORIES[key].themes)) if key else -1
