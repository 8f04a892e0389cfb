"""From words to the tokens of the grammar: the longest meaningful phrase wins."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from ... import lexicon
from . import function_words as fw
from .words import Word


@dataclass(frozen=True)
class Token:
    """One or more words that have a common meaning.

    ``tag`` is one of "relation", "here", "carry", "no", "arranged", "order", "posture", "be",
    "and", "comma", "stop", "colon", "open", "close", "of", "relative", "each", "word", "number".
    ``value`` is the meaning of the phrase.
    """

    tag: str
    words: tuple[Word, ...]
    value: Any = None

    @property
    def text(self) -> str:
        """The words, joined by spaces."""
        return " ".join(word.text for word in self.words)

    @property
    def span(self) -> tuple[int, int]:
        """The start and the end of the token in the text."""
        return self.words[0].start, self.words[-1].end


_MARKS: Mapping[str, str] = {
    ",": "comma", ".": "stop", ";": "stop", "!": "stop", "?": "stop", "\n": "line", ":": "colon",
    "(": "open", ")": "close", "-": "dash", "'s": "possessive",
}  # fmt: skip


@cache
def _phrases() -> Mapping[tuple[str, ...], tuple[str, str]]:
    """Return each phrase of function words with its tag and its meaning."""
    table: dict[tuple[str, ...], tuple[str, str]] = {}
    for tag, phrases in (
        ("relation", fw.RELATIONS), ("here", fw.HERE), ("carry", fw.CARRIES),
        ("arranged", fw.ARRANGED), ("order", fw.ORDERS), ("posture", fw.POSTURES),
    ):  # fmt: skip
        for phrase, meaning in phrases.items():
            table.setdefault(tuple(phrase.split()), (tag, meaning))
    table = _forms() | table
    table |= {tuple(phrase.split()): ("no", phrase) for phrase in (*fw.NEGATED, *fw.NEGATIONS)}
    table |= {(word,): ("and", word) for word in fw.JOINING}
    table |= {(word,): ("relative", word) for word in ("which", "who", "whose")}
    table |= {(word,): ("each", word) for word in fw.EACH}
    table[("of",)] = ("of", "of")
    return table


def _forms() -> dict[tuple[str, ...], tuple[str, str]]:
    """Return arrangement phrases such as "in a straight line" and "forming one circle"."""
    return {
        (*verb, *article, noun): ("arranged", fw.GROUPS[noun])
        for verb in map(tuple, map(str.split, fw.FORMING))
        for article in map(tuple, map(str.split, fw.FORM_ARTICLES))
        for noun in fw.FORMS
    }


_LONGEST = 6


def tokens_of(words: Sequence[Word], is_noun: Any) -> list[Token]:
    """Return the tokens for words.

    ``is_noun`` returns whether words, including function words, name one object ("salt and pepper
    shakers"); the words of such a name remain separate tokens.
    """
    out: list[Token] = []
    i = 0
    while i < len(words):
        word = words[i]
        if word.kind == "mark":
            out.append(Token(_MARKS[word.text], (word,), word.text))
            i += 1
            continue
        if word.kind == "number":
            out.append(Token("number", (word,), min(float(word.text), 1e12)))
            i += 1
            continue
        if length := _name_length(words, i, is_noun):
            out.append(Token("name", tuple(words[i : i + length])))
            i += length
            continue
        length, tag, value = _phrase(words, i)
        out.append(Token(tag, tuple(words[i : i + length]), value))
        i += length
    return out


def _name_length(words: Sequence[Word], i: int, is_noun: Any) -> int:
    """Return how many words from ``i`` onwards form an object's name with a function word in it."""
    for length in range(min(_LONGEST, len(words) - i), 1, -1):
        run = words[i : i + length]
        if all(w.kind == "word" for w in run) and is_noun(tuple(w.text for w in run)):
            more = words[i + length : i + length + 1]
            pair = tuple(w.text for w in (*run[-1:], *more))
            listed = more and more[0].kind == "mark" and more[0].text == ","
            if listed and run[1].text == "of" and run[0].text != lexicon.singular(run[0].text):
                return 0  # "bottles of gin, rum and vermouth"
            if run[-2].text == "of" and len(pair) == 2 and lexicon.category_of(pair):
                return 0  # "a bag of coffee beans"
            return length
    return 0


def _phrase(words: Sequence[Word], i: int) -> tuple[int, str, Any]:
    table = _phrases()
    for length in range(min(_LONGEST, len(words) - i), 0, -1):
        run = words[i : i + length]
        if all(w.kind == "word" for w in run):
            found = table.get(tuple(w.text for w in run))
            if found is not None:
                return length, *found
    return 1, "word", words[i].text


def list_skipped(tokens: Sequence[Token]) -> list[str]:
    """Return those words of skipped tokens that have a meaning."""
    empty = small_words() | fw.FILLERS
    return [t.text for t in tokens if t.tag in ("word", "name") and t.text not in empty]


@cache
def small_words() -> frozenset[str]:
    """Return all words used by the grammar."""
    sets = (fw.NUMBERS, fw.AMOUNTS, fw.DEFINITE, fw.INDEFINITE, fw.PRONOUNS, fw.BE, fw.PARTICIPLES,
            fw.STARTERS, fw.FILLERS, fw.RELATIVE, fw.PEOPLE_WORDS, fw.MEASURES, fw.SIDES,
            fw.ZONE_NOUNS, fw.GROUPS, fw.ORDINALS)  # fmt: skip
    words = {word for known in sets for word in known}
    return frozenset(words | {word for phrase in _phrases() for word in phrase})
