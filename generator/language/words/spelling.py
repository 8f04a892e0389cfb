"""Misspelt words read as what they most likely are."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from rapidfuzz.distance import OSA

from ...catalogue import CATEGORIES
from ..parsing import lexicon
from ..syntax.words import Word
from .dictionary import is_english

_SHORTEST = 4

_SHAPES = frozenset(
    {"square", "circle", "round", "middle", "corner", "centre", "center", "table", "behind",
     "front", "right", "between", "around", "wooden", "yellow", "purple", "orange", "three",
     "seven", "eight", "twelve", "dozen", "together", "beside"}
)  # fmt: skip
"""Words other than nouns that are often misspelt."""


def correct(
    words: Sequence[Word], known: Collection[str]
) -> tuple[tuple[Word, ...], dict[str, str]]:
    """Return words with the misspelt ones corrected, and what was corrected to what.

    A word that is neither English nor in ``known`` is read as the word of the catalogue that is
    nearest to it, one edit away (two for long words). Of several, the one counts whose things
    belong with the others of the text.
    """
    strange = {
        w.text for w in words
        if w.kind == "word" and len(w.text) >= _SHORTEST
        and not (w.text in known or lexicon.singular(w.text) in known or is_english(w.text))
    }  # fmt: skip
    if not strange:
        return tuple(words), {}
    themes = {
        theme
        for word in words
        if word.text not in strange and (key := lexicon.category_of((word.text,)))
        for theme in CATEGORIES[key].themes
    }
    found = {
        word: best
        for word in sorted(strange)
        if (best := _nearest(word, themes)) not in (None, word)
    }
    return tuple(replace(w, text=found.get(w.text, w.text)) for w in words), found


def _nearest(word: str, themes: set[str]) -> str | None:
    """Return the catalogue's word that a strange one is a misspelling of, or None."""
    limit = 1 if len(word) < 7 else 2
    plural = word.endswith("s") and not word.endswith("ss")
    ranked = []
    for candidate in sorted(lexicon.vocabulary() | _SHAPES):
        for form in (candidate, f"{candidate}s") if plural else (candidate,):
            if abs(len(form) - len(word)) > limit or len(form) < 3:
                continue
            distance = OSA.distance(word, form, score_cutoff=limit)
            if distance <= limit:
                first = form[0] != word[0]
                known = candidate not in _SHAPES
                ranked.append((distance, first, known, -_count_shared(candidate, themes), form))
    return min(ranked)[-1] if ranked else None


def _count_shared(word: str, themes: set[str]) -> int:
    key = lexicon.category_of((word,))
    return len(themes.intersection(CATEGORIES[key].themes)) if key else -1
