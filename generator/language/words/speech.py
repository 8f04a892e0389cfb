"""Parts of speech: which words are verbs, or adjectives, more often than nouns."""

from __future__ import annotations

import gzip
from functools import cache
from importlib.resources import files

IRREGULAR = frozenset(
    ["stood", "lay", "lain", "sat", "hung", "held", "kept", "set", "left", "stuck", "worn", "drawn",
     "thrown", "sunk", "bent", "broken", "eaten", "drunk", "fallen", "gone", "came", "went", "got",
     "gotten", "built", "brought", "bought", "caught", "found", "forgotten", "given", "grown",
     "hidden", "known", "laid", "led", "lent", "lost", "made", "meant", "met", "paid", "ran",
     "said", "seen", "sent", "shown", "shut", "slid", "spilt", "split", "taken", "taught", "told",
     "took", "ate", "began", "blew", "chose", "drank", "drew", "drove", "fell", "felt", "flew",
     "forgot", "froze", "grew", "hid", "knew", "lit", "rode", "rose", "sang", "shook", "slept",
     "sold", "spent", "spoke", "stole", "swam", "swept", "swung", "thought", "threw", "tore",
     "woke", "won", "wore", "wrote", "wound", "woven", "written", "wrapped"]
)  # fmt: skip
"""Forms that no rule makes."""


@cache
def _table(name: str) -> frozenset[str]:
    packed = (files("generator.language") / "words" / f"{name}.txt.gz").read_bytes()
    return frozenset(gzip.decompress(packed).decode().split())


def is_adjective(word: str) -> bool:
    """Tell whether a word only describes: "shallow", "fluffy"."""
    return word in _table("adjectives")


@cache
def is_verb(word: str) -> bool:
    """Tell whether a word is a form of a verb, in the infinitive, with -s, -ed or -ing."""
    return word in IRREGULAR or any(stem in _table("verbs") for stem in _stems(word))


def is_finite(word: str) -> bool:
    """Tell whether a word is a verb's form of the third person: "gets", "watches"."""
    return word.endswith("s") and not word.endswith("ss") and is_verb(word)


def _stems(word: str) -> list[str]:
    stems = [word]
    for end in ("s", "es", "d", "ed", "ing"):
        if word.endswith(end) and len(word) > len(end) + 2:
            stem = word.removesuffix(end)
            stems += [stem, f"{stem}e"]
            if len(stem) > 3 and stem[-1] == stem[-2]:  # "dropped"
                stems.append(stem[:-1])
    if word.endswith(("ies", "ied")):
        stems.append(f"{word[:-3]}y")
    return stems
