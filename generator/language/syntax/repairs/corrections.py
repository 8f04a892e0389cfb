"""Corrections: "two cups - no, three", "on the left, or rather on the right"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..clauses.cursor import ENDS
from ..phrases.heads import attributes_of
from ..phrases.nouns import read_noun
from ..phrases.tree import Noun
from ..phrases.zones import read_zone
from ..text import function_words as fw
from ..text.tokens import Token

_MARKERS = tuple(
    tuple(phrase.split())
    for phrase in (
        "no wait", "wait no", "wait", "hm no", "hmm no", "er no", "uh no", "oh no", "ah no",
        "sorry", "no sorry", "i mean", "i meant", "or rather", "scratch that", "correction",
        "on second thought", "on second thoughts", "just kidding", "kidding", "hang on", "no",
        "oops",
        "no actually", "actually no", "actually", "not that", "my mistake", "strike that", "nah",
        "no hang on", "oh wait", "er", "better", "no make", "make", "change that", "change it",
        "no just", "forget that", "but forget that", "forget it",
    )
)  # fmt: skip
"""Phrases that take back or change the preceding words."""

_WEAK = frozenset(
    {("no",), ("make",), ("wait",), ("better",), ("er",), ("actually",), ("no", "make")}
)
"""Phrases that are corrections only if the words after them confirm it."""

_LED = frozenset(
    [
        "make",
        "that",
        "it",
        "them",
        "just",
        "put",
        "let",
        "is",
        "s",
        "say",
        "rather",
        "actually",
        "to",
        "be",
        "there",
        "should",
        "have",
        "us",
        "i",
        "mean",
        "want",
        "but",
        "instead",
        "please",
        "change",
    ]
)
"""Words between a marker and the corrected words."""

_INTERJECTIONS = frozenset(
    ["hm", "hmm", "oh", "er", "ah", "um", "well", "okay", "ok", "oops", "uh"]
)
_PAUSES = ("comma", "dash", "stop", "open", "close", "colon")


def correct_course(tokens: Sequence[Token]) -> list[Token]:
    """Apply all corrections in a text to its tokens."""
    out = list(tokens)
    i = 0
    while i < len(out):
        found = _marker(out, i)
        if found is None:
            i += 1
            continue
        start, end = found
        changed = _replace(out, start, end)
        if changed is None:
            i += 1
        else:
            out, i = changed, max(0, start - 1)
    return out


def _marker(tokens: Sequence[Token], i: int) -> tuple[int, int] | None:
    """Return where a correction (with its pauses) begins, and where the corrected words begin."""
    if i == 0 or tokens[i - 1].tag not in _PAUSES:
        return None
    words = _words(tokens, i)
    phrase = max((m for m in _MARKERS if words[: len(m)] == m), key=len, default=None)
    if phrase is None:
        return None
    end, seen = i, 0
    while seen < len(phrase):
        seen += len(tokens[end].words)
        end += 1
    paused = end < len(tokens) and tokens[end].tag in ("comma", "dash", "colon")
    if phrase in _WEAK and not paused and phrase != ("no", "make"):
        following = words[len(phrase) : len(phrase) + 1]
        if phrase == ("make",) and following not in (("that",), ("it",), ("them",)):
            return None
        if phrase in (("no",), ("better",), ("er",), ("wait",)) and following != ("make",):
            return None
    while end < len(tokens) and (
        tokens[end].tag in ("comma", "dash", "colon")
        or (tokens[end].tag == "word" and tokens[end].text in _LED)
    ):
        if tokens[end].text == "to" and read_zone(tokens, end) is not None:
            break
        end += 1
    if [t.text for t in tokens[end : end + 3]][:2] in (["too", "risky"], ["is", "too"]) or (
        end < len(tokens) and tokens[end - 1].tag not in _PAUSES and tokens[end].text == "too"
    ):  # "no, that is too risky: ..."
        pause = next((k for k in range(end, len(tokens)) if tokens[k].tag in _PAUSES), end)
        end = pause + 1
        while end < len(tokens) and tokens[end].text in _LED:
            end += 1
    again = _marker(tokens, end) if tokens[end - 1].tag in _PAUSES else None
    end = again[1] if again else end  # "no, scratch that, ..."
    start = i
    while start and (tokens[start - 1].tag in _PAUSES or tokens[start - 1].text in _INTERJECTIONS):
        start -= 1
    return (start, end) if start and end < len(tokens) and tokens[end].tag not in ENDS else None


def _words(tokens: Sequence[Token], i: int) -> tuple[str, ...]:
    """Return at most four words from a token onwards, stopping before the next punctuation mark."""
    words: list[str] = []
    for token in tokens[i : i + 4]:
        if token.tag in (*_PAUSES, *ENDS):
            break
        words += [word.text for word in token.words]
    return tuple(words)


def _replace(tokens: list[Token], start: int, right: int) -> list[Token] | None:
    """Return the tokens before ``start``, corrected, or None if nothing matches."""
    before, after = tokens[:start], tokens[right:]
    if after[0].tag == "no":  # "some ants - kidding, no ants"
        return [*before, Token("stop", after[0].words), *after]
    if after[0].tag in ("relation", "here", "arranged") or read_zone(after, 0) is not None:
        cut = _place_before(before)
        return None if cut is None else before[:cut] + _drop_pause(after)
    participle = after[0].tag == "word" and after[0].text in fw.PARTICIPLES
    if participle and len(after) > 1 and after[1].tag in ("relation", "arranged"):
        cut = _place_before(before)
        return None if cut is None else before[:cut] + _drop_pause(after)
    noun, end = read_noun(after, 0)
    if noun is None:
        return None
    if (
        end < len(after)
        and (after[end].tag == "no" or after[end].text in fw.BE)
        and (noun.kind not in ("member", "adjective"))
    ):  # "no wait, the lamp is not there any more"
        return [*before, Token("stop", after[0].words), *after]
    rest = _drop_pause(after[end:], first=True)
    if noun.attributes and noun.kind in ("adjective", "member"):
        return _repaint(before, noun, rest)
    if noun.kind in ("adjective", "member"):
        return _recount(before, after[:end], noun, None, rest)
    if noun.count is not None:
        counted = _recount(before, after[:end], noun, noun.head, rest)
        if counted is not None:
            return counted
    span = _last_noun(before)
    if span is None:
        return None
    if span[0] and before[span[0] - 1].tag == "no":  # "scrap the board, make it a deck of cards"
        return _swap(before, span, after[:end], rest)
    counted = [t for t in before[span[0] : span[1]] if t.tag == "number" or t.text in fw.NUMBERS]
    kept = counted if noun.plural and not noun.determined else []  # "four pears, I mean plums"
    return before[: span[0]] + kept + after[:end] + rest


def _swap(
    before: list[Token], span: tuple[int, int], new: list[Token], rest: list[Token]
) -> list[Token] | None:
    """Replace the earlier mention of an unwanted object; return None if there is no mention."""
    unwanted, _ = read_noun(before, span[0])
    named = [p for p in _nouns(before[: span[0] - 1]) if unwanted and p[2].head == unwanted.head]
    if not named:
        return None
    start, end, _ = named[-1]
    kept = before[end : span[0] - 1]
    while kept and kept[-1].tag in ("comma", "dash", "and"):
        kept.pop()
    return [*before[:start], *new, *kept, Token("stop", before[span[0] - 1].words), *rest]


def _drop_pause(tokens: list[Token], *, first: bool = False) -> list[Token]:
    """Remove the dash or bracket that closes an aside; if ``first``, check only the first token."""
    for k, token in enumerate(tokens):
        if token.tag in ENDS or (first and k):
            break
        if token.tag in ("dash", "close"):
            return tokens[:k] + tokens[k + 1 :]
    return tokens


def _place_before(before: Sequence[Token]) -> int | None:
    """Return where the last place or arrangement begins."""
    for k in range(len(before) - 1, 0, -1):
        if before[k].tag in ENDS and k < len(before) - 1:
            break
        if before[k].tag in ("relation", "here", "arranged") or (
            before[k].text in ("in", "on", "at", "to") and read_zone(before, k) is not None
        ):
            while k and (
                before[k - 1].tag in ("comma", "each")
                or before[k - 1].text in (*fw.PARTICIPLES, "one", *fw.BE)
            ):
                k -= 1
            return k
    return None


def _nouns(before: Sequence[Token]) -> list[tuple[int, int, Noun]]:
    """Return the noun phrases in tokens, each with its start and end."""
    found, k = [], 0
    while k < len(before):
        noun, end = read_noun(before, k)
        if noun is None or end <= k:
            k += 1
            continue
        found.append((k, end, noun))
        k = end
    return found


def _last_noun(before: Sequence[Token]) -> tuple[int, int] | None:
    phrases = [p for p in _nouns(before) if p[2].kind not in ("adjective", "member", "abstract")]
    return phrases[-1][:2] if phrases else None


def _recount(
    before: list[Token], said: Sequence[Token], noun: Noun, head: str | None, rest: list[Token]
) -> list[Token] | None:
    """Change the number of the last counted objects, or of those with a given head noun."""
    number = [t for t in said if t.tag == "number" or t.text in fw.NUMBERS or t.text in fw.AMOUNTS]
    if not number or (noun.count is None and noun.amount is None):
        return None
    phrases = [p for p in _nouns(before) if p[2].kind in ("thing", "collective")]
    if head is not None:
        phrases = [p for p in phrases if p[2].head == head]
    else:
        several = [p for p in phrases if p[2].plural or (p[2].count or 1) > 1]
        phrases = several or phrases
    if not phrases:
        return None
    start, end, _ = phrases[-1]
    said_so = [k for k in range(start, end) if before[k].tag == "number" or before[k].text in
               (*fw.NUMBERS, *fw.AMOUNTS)]  # fmt: skip
    articles = [k for k in range(start, end) if before[k].text in fw.INDEFINITE]
    old = (said_so or articles)[-1:]
    at = old[0] if old else start
    return before[:at] + list(number) + before[at + len(old) :] + rest


def _repaint(before: list[Token], noun: Noun, rest: list[Token]) -> list[Token] | None:
    """Change the colour, size or material of the last object that has one."""
    for start, end, _ in reversed(_nouns(before)):
        for k in range(start, end):
            kinds = set(attributes_of((before[k].text,))) & set(noun.attributes)
            if kinds:
                words = [w for w in noun.words if set(attributes_of((w,))) & kinds]
                new = [_word_token(before[k], w) for w in words]
                return before[:k] + new + before[k + 1 :] + rest
    return None


def _word_token(token: Token, word: str) -> Token:
    """Return a token at the same position with another word."""
    return Token("word", (replace(token.words[0], text=word),), word)
