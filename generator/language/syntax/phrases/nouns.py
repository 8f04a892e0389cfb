"""Noun phrases: numbers, describing words, and the noun last."""

from __future__ import annotations

from collections.abc import Sequence

from ..text import function_words as fw
from ..text.tokens import Token
from .endings import ends_here
from .heads import noun_of
from .introductions import PhraseStart, is_describing, may_continue, read_introduction
from .tree import Noun


def read_noun(tokens: Sequence[Token], start: int) -> tuple[Noun | None, int]:
    """Return the noun phrase that starts at a token and where it ends; None where there is none."""
    run = PhraseStart(first=start)
    i = read_introduction(tokens, start, run)
    i = i if run.closed else _content(tokens, i, run)
    if i == start:
        return None, start
    noun = noun_of(run)
    noun.span = tokens[start].span[0], tokens[i - 1].span[1]
    return noun, i


# ------------------------------------------------------------------------------------ content


def _content(tokens: Sequence[Token], i: int, run: PhraseStart) -> int:
    """Read describing words and the noun; return where they end."""
    while i < len(tokens):
        token = tokens[i]
        if token.tag == "name":
            run.name = tuple(w.text for w in token.words)
            run.words += run.name
            return i + 1
        if token.tag == "arranged" and len(token.words) == 1 and may_continue(tokens, i + 1):
            if any(token.words[0].text == w for w in ("ordered", "sorted", "aligned", "inside")):
                break
            run.arrangement = run.arrangement or token.value
            run.words.append(token.text)
            i += 1
        elif token.tag == "posture" and may_continue(tokens, i + 1) and not run.name:
            if any(not is_describing(word) for word in run.words):
                break
            run.posture = str(token.value)
            i += 1
        elif token.tag == "number" and not run.words and not run.numbers:
            run.numbers.append(float(token.value))
            i += 1
        elif token.tag == "possessive":
            i += 1
        elif token.tag == "word" and not ends_here(tokens, i, run):
            run.words.append(token.text)
            i += 1
        elif step := _joined_adjectives(tokens, i, run):
            i += step
        else:
            break
    return i


def _joined_adjectives(tokens: Sequence[Token], i: int, run: PhraseStart) -> int:
    """Read the comma or "and" between describing words: "red, green and blue cubes"."""
    if tokens[i].tag not in ("comma", "and") or not run.words:
        return 0
    if not all(is_describing(w) or w in fw.SIDES for w in run.words):
        return 0
    k = i + 1
    if k < len(tokens) and tokens[i].tag == "comma" and tokens[k].tag == "and":
        k += 1
    described = 0
    while k < len(tokens) and tokens[k].tag == "word" and is_describing(tokens[k].text):
        described += 1
        k += 1
    if not described or k >= len(tokens):
        return 0
    more = tokens[k].tag in ("comma", "and") or tokens[k].tag in ("word", "name")
    if not more or (tokens[k].tag == "word" and ends_here(tokens, k, run)):
        return 0
    start = i + 1 + (tokens[i].tag == "comma" and tokens[i + 1].tag == "and")
    if ends_here(tokens, start, PhraseStart()):
        return 0  # "empty and clean," of which the last may be a verb
    run.variants.append(list(run.words))
    run.words = []
    return start - i


# ---------------------------------------------------------------------------------- the noun
