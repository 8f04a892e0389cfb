"""Reading of a text in stages: words, spelling, tokens, clauses, and their meaning."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from ..errors import InputError
from . import lexicon
from .drafts import MAX_OBJECTS, Reading
from .semantics.interpreter import Interpreter
from .syntax.clauses.parser import Parser
from .syntax.phrases.tree import Sentence
from .syntax.repairs.corrections import correct_course
from .syntax.repairs.numbers import NumberUse, check_numbers
from .syntax.repairs.talk import drop_talk
from .syntax.text.tokens import list_skipped, small_words, tokens_of
from .syntax.text.words import words_of
from .vocabulary import (
    COLORS,
    DEFINITE,
    DRAWN,
    FILLERS,
    LEGS,
    MATERIALS,
    NUMBERS,
    OUTLINES,
    PLACES,
    STATES,
    VAGUE,
    VERBS,
)
from .words.dictionary import is_english
from .words.foreign import is_foreign
from .words.spelling import correct

MAX_CHARACTERS = 2000
"""Maximum length of a prompt, in characters."""

NOT_UNDERSTOOD = "Not understood: "
"""Start of every warning about a phrase that was not understood."""

OTHER_LANGUAGE = (
    "The embedded planner only reads English, and this text is not English. Write it in English, "
    "or let a cloud reasoner plan it: 'tabletopgen generate TEXT --reasoner cloud', in Python "
    "Backends.select(reasoner='cloud')."
)
"""Error message for a prompt in a language other than English."""

EXAMPLE = "'a laptop, a red mug to the right of it and two books on a wooden desk'"
_ENGLISH = VERBS | FILLERS | DEFINITE | STATES | COLORS | MATERIALS | PLACES | {
    "and", "on", "in", "with", "of", "left", "right", "behind", "front", "next", "between",
    *NUMBERS, *VAGUE,
}  # fmt: skip


@dataclass(frozen=True)
class ReadText:
    """The result of reading a text.

    Attributes:
        sentences: its clauses and noun phrases, each with its position in the text.
        reading: the requested objects, and the phrases that were not understood.
        fixes: misspelt words and their corrections.
    """

    sentences: tuple[Sentence, ...]
    reading: Reading
    fixes: Mapping[str, str]


def read_text(prompt: str, rng: np.random.Generator) -> ReadText:
    """Read an English text; vague numbers are drawn from ``rng``.

    Raises:
        InputError: The text is empty, too long or not English, or has impossible counts or a second
            table.
    """
    check_text(prompt)
    spelt, fixes = correct(words_of(_undrawn(prompt)), _known_words())
    written = tokens_of(spelt, lexicon.is_phrase_start)
    tokens, talk = drop_talk(correct_course(written))
    parser = Parser(tokens)
    sentences = parser.sentences()
    try:
        reading = Interpreter(rng).read(sentences)
    except InputError as error:
        use = check_numbers(prompt, written, tokens, sentences, (), MAX_OBJECTS)
        raise _with_unread(error, use) from error
    reading.lost += talk
    reading.lost += [*parser.lost, *list_skipped(parser.skipped)]
    reading.warnings += [f"Read {word!r} as {best!r}." for word, best in fixes.items()]
    reading.warnings += [f"{NOT_UNDERSTOOD}{phrase!r}." for phrase in dict.fromkeys(reading.lost)]
    people = (reading.people, *(clause.people for s in sentences for clause in s.clauses))
    use = check_numbers(prompt, written, tokens, sentences, people, len(reading.objects))
    reading.warnings += _number_warnings(use, reading.lost)
    return ReadText(tuple(sentences), reading, fixes)


def _number_warnings(use: NumberUse, lost: Sequence[str]) -> list[str]:
    """Return a warning for each unused number and each range.

    Numbers in phrases that were not understood are not mentioned.
    """
    lost_text = " ".join(lost).lower()
    named = (re.search(rf"(?<!\w){re.escape(n.text.lower())}(?!\w)", lost_text) for n in use.unused)
    unused = dict.fromkeys(
        n.text for n, found in zip(use.unused, named, strict=True) if found is None
    )
    ranges = {n.text: n.value for n in use.ranges}
    return [
        *(f"The number {text!r} was not used." for text in unused),
        *(f"The range {text!r} is read as {value:g}." for text, value in ranges.items()),
    ]


def _with_unread(error: InputError, use: NumberUse) -> InputError:
    """Add the numbers that could not be read to an error's message, if they may have caused it."""
    spoiling = (n for n in use.unused if n.role == "count" and (n.value is None or n.unit))
    unread = dict.fromkeys(n.text for n in spoiling)
    if not unread:
        return error
    names = ", ".join(map(repr, unread))
    return InputError(f"{error} Some numbers cannot be read: try again without {names}.")


def check_text(prompt: str) -> None:
    """Check that a text is English and neither empty nor too long.

    Raises:
        InputError: The text is empty, too long, without words or not English.
    """
    if not isinstance(prompt, str):
        raise InputError(f"Expected a prompt or a ScenePlan, got {type(prompt).__name__}.")
    if not prompt.strip():
        raise InputError(f"The prompt is empty. Describe a tabletop, for example {EXAMPLE}.")
    if len(prompt) > MAX_CHARACTERS:
        raise InputError(
            f"The prompt has {len(prompt)} characters; at most {MAX_CHARACTERS} are allowed. "
            "Describe one table in a few sentences."
        )
    letters = [c for c in prompt if c.isalpha()]
    if not letters:
        raise InputError(
            f"The prompt contains no words. Describe a tabletop, for example {EXAMPLE}."
        )
    if is_foreign(prompt) or not _has_english(prompt):
        raise InputError(OTHER_LANGUAGE)


def _has_english(prompt: str) -> bool:
    """Return whether any word, even misspelt, is known to the planner or found in a dictionary."""
    known = _known_words()
    words = [w for w in lexicon.tokens(prompt) if w.isalpha()]
    if any(word in known or lexicon.singular(word) in known for word in words):
        return True
    dictionary = any(len(word) > 2 and is_english(word) for word in words)
    return dictionary or bool(correct(words_of(prompt), known)[1])


@cache
def _known_words() -> frozenset[str]:
    return frozenset(_ENGLISH | small_words() | {*LEGS, *OUTLINES} | lexicon.vocabulary())


def _undrawn(prompt: str) -> str:
    """Return a text with "cartoon style" and similar phrases replaced by spaces."""
    for phrase in DRAWN:
        pattern = rf"(?i)\b{phrase.replace(' ', '[ -]')}\b(?:[ -]styled?\b)?"
        found = re.search(pattern, prompt)
        if found:
            return prompt[: found.start()] + " " * len(found.group()) + prompt[found.end() :]
    return prompt
