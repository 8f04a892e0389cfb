"""Noun phrases: numbers, describing words and finally the noun."""

from __future__ import annotations

from collections.abc import Sequence

from ..text import function_words as fw
from ..text.tokens import Token
from .endings import ends_here, is_stuff
from .heads import noun_of
from .introductions import PhraseStart, is_describing, may_continue, read_introduction
from .tree import Noun


def read_noun(tokens: Sequence[Token], start: int) -> tuple[Noun | None, int]:
    """Return the noun phrase that starts at a token, and its end, or None if there is none."""
    if (some := _share(tokens, start)) is not None:
        return some
    run = PhraseStart(first=start)
    i = read_introduction(tokens, start, run)
    i = i if run.closed else _content(tokens, i, run)
    if i == start:
        return None, start
    following = tokens[i].text if i < len(tokens) else ""
    run.described = run.described and following not in ("set", "sets")  # "a seven mug set"
    noun = noun_of(run)
    noun.span = tokens[start].span[0], tokens[i - 1].span[1]
    return noun, i


def _share(tokens: Sequence[Token], start: int) -> tuple[Noun, int] | None:
    """Parse "half of the apples", "half of them", "the other half" and "the rest"."""
    texts = [token.text for token in tokens[start : start + 5]]
    for phrase in _REMAINDER:
        if tuple(texts[: len(phrase)]) == phrase:
            end = start + len(phrase)
            end += 2 * (texts[len(phrase) : len(phrase) + 2] in (["of", "them"], ["of", "these"]))
            if end < len(tokens) and tokens[end].text in fw.BE | {"all", "both"}:
                span = tokens[start].span[0], tokens[end - 1].span[1]
                return Noun("member", (), span, definite=True, plural=True, other=True), end
    if texts[:1] != ["half"]:
        return None
    k = start + 1 + (texts[1:2] == ["of"])
    if k >= len(tokens) or tokens[k].text not in fw.DEFINITE | fw.PLURAL_PRONOUNS:
        return None
    if tokens[k].text in fw.PLURAL_PRONOUNS and (k + 1 == len(tokens) or tokens[k].text == "them"):
        span = tokens[start].span[0], tokens[k].span[1]
        return Noun("member", (), span, definite=True, plural=True, half=True), k + 1
    noun, end = read_noun(tokens, k)
    if noun is None or noun.kind != "thing" or not noun.plural:
        return None
    noun.half, noun.span = True, (tokens[start].span[0], noun.span[1])
    return noun, end


_REMAINDER = (("the", "rest"), ("the", "remainder"), ("the", "other", "half"))


# ------------------------------------------------------------------------------------ content


def _content(tokens: Sequence[Token], i: int, run: PhraseStart) -> int:
    """Parse the describing words and the noun; return where they end."""
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
    """Parse the comma or "and" between describing words: "red, green and blue cubes"."""
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
        return 0  # "empty and clean," where the last word may be a verb
    if is_stuff(run.words) and not _noun_follows(tokens, k):
        return 0  # "a glass, empty, and a plate", but "a glass, steel and oak table"
    run.variants.append(list(run.words))
    run.words = []
    return start - i


def _noun_follows(tokens: Sequence[Token], k: int) -> bool:
    """Return whether a noun follows the describing words, with or without commas."""
    while k < len(tokens) and (tokens[k].tag in ("comma", "and") or is_describing(tokens[k].text)):
        k += 1
    if k == len(tokens):
        return False
    named = tokens[k].tag == "name"
    return named or (tokens[k].tag == "word" and not ends_here(tokens, k, PhraseStart()))


# ---------------------------------------------------------------------------------- the noun
