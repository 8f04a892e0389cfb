"""Properties of the whole table: theme, style, density and number of people."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

from ...scene import Density
from .. import lexicon
from ..syntax.phrases.tree import Sentence, Span, find_denied, find_things
from ..themes import THEMES
from ..vocabulary import DRAWN, PEOPLE, STYLES
from .contents import DEPICTIONS

_REQUEST = re.compile(r"\b(?:can|could|would) (?:you|we|i)\b")
_SOME = "|".join(PEOPLE)
_PEOPLE = re.compile(
    rf"\b(?:(?:set |laid )?for ({_SOME})(?: (?:people|persons|guests|diners|children|kids))?"
    r"(?=\s*(?:[.,;]|$|with|and|on|in|at))"
    rf"|({_SOME})[ -](?:person|seat|seater))\b"
)

_DENSITIES: Mapping[str, Density] = MappingProxyType(
    {
        "cluttered": "dense", "crowded": "dense", "messy": "dense", "packed": "dense",
        "busy": "dense", "chaotic": "dense", "sparse": "sparse", "minimalist": "sparse",
        "minimal": "sparse", "uncluttered": "sparse", "spacious": "sparse",
    }
)  # fmt: skip
"""Words that describe how full a table is."""

_PICTURES = DEPICTIONS | {"picture_frame", "photo_print"}
_DENYING = frozenset(
    ["not", "no", "never", "without", "nothing", "hardly", "neither", "nor", "less", "isnt",
     "arent", "dont", "doesnt", "wasnt", "wont", "shouldnt", "cant", "anything"]
)  # fmt: skip
"""Words that deny the properties after them; "anything" precedes "but"."""
_TURNING = frozenset([*",.;:!?()\n", "but", "on", "in", "at", "of", "with", "and"])
"""Words at which the scope of a negation ends."""
_REACH = 3
_UNDRAWN = re.compile(
    r"\b(?:not|no|never|without|isnt|dont)\b(?: (?:in|a|an|any|the|want|draw))*\s*$"
)


@dataclass(frozen=True)
class Tone:
    """Properties of the whole table.

    Attributes:
        theme: kind of table, from any word in the text; None if there is none.
        setting: kind of table, from words that are not part of an object's name.
        style: visual style; "plain" if not stated.
        density: how full the table is.
        people: number of people; 0 if not stated.
    """

    theme: str | None
    setting: str | None
    style: str
    density: Density
    people: int


def read_tone(prompt: str, sentences: Sequence[Sentence]) -> Tone:
    """Return the properties that a text states, ignoring negations and the contents of pictures."""
    said = _blank(prompt, find_denied(sentences, _PICTURES))
    text, drawn = _split_style(_REQUEST.sub(" ", " ".join(lexicon.tokens(said))))
    people = next((PEOPLE[m.group(1) or m.group(2)] for m in _PEOPLE.finditer(text)), 0)
    words = _PEOPLE.sub(" ", text).split()
    unnamed = _REQUEST.sub(" ", " ".join(lexicon.tokens(_blank(said, find_things(sentences)))))
    true = _drop_denied(words)
    style = drawn or next((word for word in true if word in STYLES), "plain")
    full: list[Density] = [_DENSITIES[word] for word in true if word in _DENSITIES]
    density = full[0] if full else "normal"
    return Tone(find_theme(words), find_theme(unnamed.split()), style, density, people)


def _blank(text: str, spans: Iterable[Span]) -> str:
    for start, end in spans:
        text = text[:start] + " " * (end - start) + text[end:]
    return text


def _drop_denied(words: Sequence[str]) -> list[str]:
    """Return words without those that "not" denies: "not too messy", "anything but cluttered"."""
    reach, out = 0, []
    for k, word in enumerate(words):
        if word in _DENYING:
            reach = _REACH
        elif word in _TURNING and not (word == "but" and words[k - 1] == "anything"):
            reach = 0
        if reach <= 0:
            out.append(word)
        reach -= word not in _DENYING
    return out


def _split_style(text: str) -> tuple[str, str | None]:
    """Remove "cartoon style" or "low poly" from a text; return the rest and the style."""
    for phrase, drawn in DRAWN.items():
        found = re.search(rf"\b{phrase}\b(?: styled?\b)?", text)
        if found:
            denied = _UNDRAWN.search(text[: found.start()])
            return f"{text[: found.start()]} {text[found.end() :]}", None if denied else drawn
    return text, None


def find_theme(words: Sequence[str]) -> str | None:
    """Return the theme with the longest phrase that occurs in a text's lower-case words."""
    text = f" {' '.join(words)} "
    singular = f" {' '.join(lexicon.singular(w) for w in words)} "
    found = [
        (len(phrase), name)
        for name, theme in THEMES.items()
        for phrase in theme.words
        if f" {phrase} " in text or f" {phrase} " in singular
    ]
    return max(found, key=lambda pair: pair[0])[1] if found else None
