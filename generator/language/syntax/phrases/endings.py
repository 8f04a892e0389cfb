"""Where noun phrases end: verbs, prepositions and places that follow them."""

from __future__ import annotations

from collections.abc import Sequence

from ... import lexicon
from ...vocabulary import COLORS, MATERIALS, TABLE_NOUNS
from ...words.dictionary import IRREGULAR, entry_of, is_finite, is_verb
from ..text import function_words as fw
from ..text.tokens import Token
from .introductions import PhraseStart, is_describing
from .zones import read_zone

STOPS = fw.BE | fw.PARTICIPLES | fw.FILLERS | fw.RELATIVE

_CLOSING = frozenset({"comma", "stop", "line", "and", "colon", "dash", "open", "close"})
"""Tags of tokens that may follow the last word of a noun phrase."""


def ends_here(tokens: Sequence[Token], i: int, run: PhraseStart) -> bool:
    """Return whether a word no longer belongs to this noun phrase."""
    word = tokens[i].text
    telling = all(is_describing(w) or w in fw.SIDES for w in run.words)
    if word in ("one", "ones") and run.words and telling:
        return False
    if word in fw.DEFINITE or word in fw.INDEFINITE or word in fw.PRONOUNS:
        return True
    nouns = [w for w in run.words if not is_describing(w)]
    if not nouns and _is_said_of_stuff(tokens, i, run):
        return True
    if nouns and word in fw.PARTICLES:
        return True
    if word in fw.AMOUNTS and nouns and word not in ("lot", "mixed", "assorted", "various"):
        return True
    if (word in fw.NUMBERS and nouns) or word in fw.NEVER_INSIDE or _is_around(tokens, i, nouns):
        return True
    if word in STOPS or word in fw.STARTERS:
        following = tokens[i + 1] if i + 1 < len(tokens) else None
        ahead = following.text if following is not None and following.tag == "word" else ""
        extended, longer = (*run.words, word), (*run.words, word, ahead)
        third = tokens[i + 2].text if i + 2 < len(tokens) and tokens[i + 2].tag == "word" else ""
        ahead_tag = following.tag if following is not None else ""
        inverted = ahead in fw.INDEFINITE | fw.DEFINITE or ahead in fw.NUMBERS
        named_can = lexicon.category_of((*run.words[-1:], word)) is not None
        if (
            word in ("can", "must", "should", "could", "may")
            and nouns
            and not named_can
            and (ahead in fw.BE or (is_verb(ahead) and not lexicon.category_of((ahead,))))
        ):
            return True  # "the drill can go there"
        if word in fw.BE and inverted and (run.words or run.ordinal):
            return True  # "behind the biggest stands a roller"
        alone = not run.words and (run.numbers or run.ordinal or run.other) and word in fw.BE
        agrees = (run.numbers or [1.0])[0] == 1.0 or not word.endswith("s")
        placed = ahead_tag == "relation" or read_zone(tokens, i + 1) is not None
        if alone and placed and agrees:
            return True  # "one stands on a tray, both lie in it"
        before = len(run.words) if nouns and word in fw.BE else len(extended)
        named = any(
            lexicon.category_of(some[k:]) or lexicon.collective_of(some[k:])
            for some in (extended, longer, (*longer, third))
            for k in range(before)
        )  # a "cake stand", but a "bottle" that "stands"
        if named and word in fw.BE and nouns and word.endswith("s") and _is_single(run):
            return True
        closed = following is None or following.tag in _CLOSING | {"close"}
        named_so = run.article or (nouns and not _is_known(run.words))
        if closed and named_so and word in fw.BE:
            return False  # "a wrist rest", "on a stand"
        if named and (nouns or following is None or following.text not in fw.DEFINITE):
            return False
        before_noun = not nouns and following is not None and following.tag in ("word", "name")
        describes = is_describing(word) or word in (
            "standing", "hanging", "left", "right"
        )  # fmt: skip
        return not (before_noun and describes)
    if nouns and (_is_said_of(tokens, i, run) or _is_place(tokens, i, run)):
        return True
    closed = i + 1 >= len(tokens) or tokens[i + 1].tag in _CLOSING | {"colon"}
    if closed and word.endswith("ing") and entry_of((word,)) and word not in fw.PARTICIPLES:
        return False  # "a board meeting"
    if nouns and (word.endswith(("ing", "ed")) or is_describing(word)) and _is_known(run.words):
        extended = (*run.words, word)
        ahead = [*extended, *(t.text for t in tokens[i + 1 : i + 3] if t.tag == "word")]
        return not any(
            lexicon.category_of(tuple(ahead[k:end]))
            for end in range(len(extended), len(ahead) + 1)
            for k in range(len(run.words) + 1)
        )
    return False


def _is_said_of_stuff(tokens: Sequence[Token], i: int, run: PhraseStart) -> bool:
    """Return whether a participle follows a material noun, as in "a cloth folded in the corner"."""
    if not tokens[i].text.endswith(("ed", "en")) or not is_stuff(run.words):
        return False
    after = [token for token in tokens[i + 1 : i + 3] if token.text not in COLORS]
    return not after or after[0].tag != "word" or after[0].text in fw.PARTICIPLES


def is_stuff(words: Sequence[str]) -> bool:
    """Return whether the words end with a material that is also an object, such as "glass"."""
    return bool(words) and words[-1] in MATERIALS and bool(lexicon.category_of((words[-1],)))


def _is_around(tokens: Sequence[Token], i: int, nouns: Sequence[str]) -> bool:
    """Return whether "round" is a preposition, as in "six cups round it", not "round table"."""
    if tokens[i].text != "round" or not nouns or i + 1 >= len(tokens):
        return False
    following = tokens[i + 1].text
    return following in fw.DEFINITE | fw.INDEFINITE | fw.PRONOUNS


def _is_place(tokens: Sequence[Token], i: int, run: PhraseStart) -> bool:
    """Return whether "front left" or a final "centre" gives the place of the preceding noun."""
    opens = tokens[i].text in fw.SIDES or tokens[i].text in ("dead", "smack", "bang")
    if not opens or not _is_known(run.words):
        return False
    found = read_zone(tokens, i)
    return found is not None and not found.of


_OBJECTS = fw.DEFINITE | fw.INDEFINITE | fw.PRONOUNS | frozenset(fw.NUMBERS)


def _is_said_of(tokens: Sequence[Token], i: int, run: PhraseStart) -> bool:
    """Return whether a word is a verb whose subject is the preceding noun.

    Examples: "a gnome watches them", "the salad comes in a bowl", "books piled on it"; not "dinner
    plates on it".
    """
    word = tokens[i].text
    if lexicon.is_setting(word):
        return False  # "a fondue evening"
    ahead_of_it = i + 1 < len(tokens) and tokens[i + 1].text in ("it", "them", "him", "her")
    if not is_verb(word) and not (ahead_of_it and word.endswith("s") and _is_single(run)):
        return False
    following = tokens[i + 1] if i + 1 < len(tokens) else None
    ahead = following.text if following is not None and following.tag == "word" else ""
    for some in ((*run.words, word), (*run.words, word, ahead)):
        if any(lexicon.category_of(some[k:]) for k in range(len(run.words))):
            return False
    if following is not None and following.tag in ("word", "number"):
        return ahead in _OBJECTS and (is_finite(word) or _is_known(run.words))
    if lexicon.category_of((word,)) is not None:
        return is_finite(word) and run.article and following is not None
    ended = following is None or following.tag in _CLOSING
    if is_finite(word):
        return _is_single(run) and not ended
    participle = word.endswith(("ed", "ing", "en", "ung")) or word in IRREGULAR
    return participle and _is_known(run.words) and not ended


def _is_single(run: PhraseStart) -> bool:
    """Return whether a noun phrase began as singular, with "a", "the", "one" or "each"."""
    return run.each or run.article or run.definite or run.numbers == [1.0]


def _is_known(words: Sequence[str]) -> bool:
    return any(
        lexicon.category_of(tuple(words[k:])) or " ".join(words[k:]) in TABLE_NOUNS
        for k in range(len(words))
    )
