"""Remarks that do not describe the table: "I hate it", "the iron? Leave it"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ...words.dictionary import entry_of, is_verb
from ..clauses.cursor import ENDS
from ..phrases.introductions import is_describing
from ..phrases.nouns import read_noun
from ..phrases.zones import read_zone
from ..text import function_words as fw
from ..text.tokens import Token

_SPEAKERS = frozenset(["i", "we", "he", "she", "you", "my", "our", "his", "her"])
_WANTING = frozenset(
    ["want", "wants", "need", "needs", "like", "love", "have", "has", "had", "see", "put", "place",
     "set", "imagine", "picture", "require", "prefer", "request", "think", "get", "make", "add",
     "wish", "keep", "ask", "give", "show", "do", "create", "generate", "build", "draw", "use",
     "take", "bring", "choose", "would", "could", "can", "should", "will", "please", "find",
     "left", "leave", "d", "ll"]
)  # fmt: skip
"""Verbs that express requests."""

_MODIFYING = frozenset(
    ["really", "just", "also", "am", "was", "were", "is", "are", "always", "never", "only", "do",
     "m", "re", "ve", "been", "about", "to", "going", "gonna", "trying", "be", "often", "usually",
     "now", "not", "d", "ll", "would", "will"]
)  # fmt: skip
_MODALS = frozenset(["can", "could", "would", "will", "might"])
_ASKED = frozenset(["you", "we", "i", "someone", "somebody", "u"])
_PAUSES = ("comma", "dash", "close", "open", "colon", *ENDS)


def drop_talk(tokens: Sequence[Token]) -> tuple[list[Token], list[str]]:
    """Return tokens without clauses that request nothing, and the text of those clauses."""
    out: list[Token] = []
    lost: list[str] = []
    i = 0
    while i < len(tokens):
        if tokens[i].text in _MODALS and i + 1 < len(tokens) and tokens[i + 1].text in _ASKED:
            i += 2
            continue
        if robot := _robot([token.text for token in tokens[i : i + 8]]):
            out.append(Token("task", tokens[i].words))
            i += robot
            continue
        if (skipped := _end_of_skip(tokens, i)) > i:
            i = skipped
            continue
        if (end := _left_out_end(tokens, i)) > i:
            out += [Token("no", tokens[i].words, "no"), *tokens[i + 1 : end]]
            i = end + 1
            continue
        if contrast := _contrast(tokens, i):
            apart = bool(out) and out[-1].tag == "comma"
            if apart:
                out.pop()
            out += [Token("open", contrast.words), contrast, Token("close", contrast.words)]
            i += 4
            i += apart and i < len(tokens) and tokens[i].tag == "comma"
            continue
        if tokens[i].text == "but" and out and out[-1].text in ("everything", "all", "things"):
            out.append(Token("no", tokens[i].words, "no"))  # "everything but the pen"
            i += 1
            continue
        if _is_also(tokens, i):
            i = _join_subject(out, tokens, i + 2)
            continue
        if tokens[i].text in _ADVERBS:
            apart = bool(out) and out[-1].tag == "comma"
            i += 1
            i += apart and i < len(tokens) and tokens[i].tag == "comma"
            continue
        if tokens[i].text in _LINKING and out and out[-1].tag == "comma":
            out.pop()  # "the bottle, however, is behind it"
            i += 1 + (i + 1 < len(tokens) and tokens[i + 1].tag == "comma")
            continue
        if tokens[i].text == "please" and out and out[-1].tag == "comma":
            out.pop()  # "one cup, please: ..."
            i += 1
            continue
        fresh = not out or out[-1].tag in _PAUSES or out[-1].tag == "and"
        end = _talk_end(tokens, i) if fresh else i
        if end > i:
            lost.append(" ".join(token.text for token in tokens[i:end]))
            i = end
        else:
            out.append(tokens[i])
            i += 1
    return _read_answers(_open_brackets(out)), lost


def _contrast(tokens: Sequence[Token], i: int) -> Token | None:
    """Return the affirmed word in "not black but white", or None for other phrases."""
    if tokens[i].tag != "no" or i + 3 >= len(tokens) or tokens[i + 2].text != "but":
        return None
    told = all(is_describing(tokens[k].text) for k in (i + 1, i + 3))
    return tokens[i + 3] if told and tokens[i + 3].tag == "word" else None


def _left_out_end(tokens: Sequence[Token], i: int) -> int:
    """Return where the objects in "leave the shoes out" end, or ``i`` for other phrases."""
    if tokens[i].text not in ("leave", "keep", "take"):
        return i
    noun, end = read_noun(tokens, i + 1)
    out = end < len(tokens) and tokens[end].text in ("out", "off", "away")
    ended = end + 1 >= len(tokens) or tokens[end + 1].tag in (*_PAUSES, "and")
    return end if noun is not None and out and ended else i  # not "leave it out on the desk"


def _is_also(tokens: Sequence[Token], i: int) -> bool:
    """Return whether "so does" or "as do" comes next, which means the same as "and"."""
    if tokens[i].text not in ("so", "as") or i + 2 >= len(tokens):
        return False
    verb = tokens[i + 1].text in ("do", "does", "is", "are")
    noun, end = read_noun(tokens, i + 2) if verb else (None, 0)
    placed = end < len(tokens) and tokens[end].tag in ("relation", "here")
    return noun is not None and not placed and read_zone(tokens, end) is None


_ADVERBS = frozenset(
    ["obviously", "naturally", "clearly", "preferably", "ideally", "basically", "literally",
     "maybe", "perhaps", "possibly", "certainly", "surely", "hopefully"]
)  # fmt: skip
"""Adverbs that do not affect the plan."""

_PICTURES = frozenset(["picture", "photo", "image", "shot", "render", "scene"])

_LINKING = frozenset(["however", "though", "meanwhile", "instead", "therefore"])


def _join_subject(out: list[Token], tokens: Sequence[Token], i: int) -> int:
    """Add the objects after "so does" to their sentence's subject; return where they end."""
    start = max((k + 1 for k, token in enumerate(out) if token.tag in ENDS), default=0)
    verb = next((k for k in range(start, len(out)) if out[k].text in fw.BE), len(out))
    end = i
    while end < len(tokens) and tokens[end].tag not in _PAUSES:
        end += 1
    while verb == len(out) and out and out[-1].tag in ("and", "comma"):
        out.pop()
        verb = len(out)
    joined = [Token("and", tokens[i].words, "and"), *tokens[i:end]]
    if verb < len(out):
        while out[-1].tag in ("and", "comma"):
            out.pop()
        out[verb] = Token("word", (replace(out[verb].words[0], text="are"),), "are")
    out[verb:verb] = joined
    return end


def _open_brackets(tokens: list[Token]) -> list[Token]:
    """Return tokens in which statements in brackets become sentences."""
    out = list(tokens)
    for i, token in enumerate(tokens):
        if token.tag != "open":
            continue
        end = next((k for k in range(i, len(tokens)) if tokens[k].tag == "close"), None)
        if end is not None and any(
            t.text in ("is", "are", "stand", "stands") for t in tokens[i:end]
        ):
            out[i] = Token("stop", token.words)
            out[end] = Token("stop", tokens[end].words)
    return out


_DOING = (["has", "to"], ["needs", "to"], ["should"], ["must"], ["can"], ["will"], ["is", "to"],
          ["shall"])  # fmt: skip


def _robot(texts: Sequence[str]) -> int:
    """Return the number of words in "the robot has to" and similar phrases, or 0 for others."""
    if texts[:2] not in (["the", "robot"], ["the", "gripper"], ["a", "robot"]):
        return 0
    k = 2 + (texts[2:3] in (["arm"], ["gripper"], ["hand"]))
    return next((k + len(verb) for verb in _DOING if texts[k : k + len(verb)] == verb), 0)


def _end_of_skip(tokens: Sequence[Token], i: int) -> int:
    """Return where "if possible", "otherwise any mug" or "not on the table but" ends."""
    texts = [token.text for token in tokens[i : i + 10]]
    if skipped := _robot(texts):
        return i + skipped
    bound = next((b for b in fw.BOUNDS if tuple(" ".join(texts).split()[: len(b)]) == b), ())
    k = i
    while bound and sum(len(token.words) for token in tokens[i:k]) < len(bound):
        k += 1
    if bound and _is_number(tokens[k : k + 1]):
        return k  # "no more than three books and at least two pens"
    if texts[:2] == ["nothing", "else"]:  # "nothing else goes in it: the hat is ..."
        marks = [k for k in range(i, len(tokens)) if tokens[k].tag in ("colon", "comma", *ENDS)]
        if marks and tokens[marks[0]].tag == "colon":
            return marks[0]
    if texts[:1] == ["nothing"] and (found := {"except", "but"} & {*texts[1:]}):
        return i + min(texts.index(word) for word in found) + 1  # "nothing else except a card"
    if texts[:3] in (["in", "the", "order"], ["in", "this", "order"], ["in", "that", "order"]):
        k = i + 3
        while k < len(tokens) and tokens[k].tag not in _PAUSES:
            k += 1
        return k
    if texts[:2] == ["in", "turn"]:
        return i + 2
    if texts[:1] in (["a"], ["an"]) and {*texts[1:2]} & _PICTURES and texts[2:3] == ["for"]:
        pause = next((k for k in range(i, len(tokens)) if tokens[k].tag in _PAUSES), i)
        told = tokens[pause].tag in ("colon", "dash")  # "a picture for her invite: ..."
        return pause if told else i
    if texts[:1] == ["as"] and texts[1:2] in (["a"], ["an"]):  # "a mug as a distractor"
        noun, end = read_noun(tokens, i + 1)
        aim = noun is not None and noun.category is None and noun.kind in ("thing", "abstract")
        return end if aim and texts[2:3] not in (["centerpiece"], ["centrepiece"]) else i
    if texts[:2] in (["rotate", "it"], ["turn", "it"]):
        k = i + 2
        while k < len(tokens) and tokens[k].tag not in (*_PAUSES, "and"):
            k += 1
        return k
    if texts[:2] in (["if", "possible"], ["if", "needed"], ["where", "possible"]):
        return i + 2
    if texts[:1] in (["since"], ["because"]) and "," in texts:
        return i + texts.index(",") + 1
    if texts[:1] in (["otherwise"], ["else"]):
        k = i + 1
        while k < len(tokens) and tokens[k].tag not in (*_PAUSES, "and"):
            k += 1
        return k
    if tokens[i].tag == "no" and "but" in texts[1:]:
        end = texts.index("but")
        marks = [token.tag for token in tokens[i + 1 : i + end]]
        after = tokens[i + end + 1].tag if i + end + 1 < len(tokens) else ""
        denied = marks[:1] == ["relation"]  # the grammar handles "not on it but beside it"
        plain = not denied and not any(tag in (*_PAUSES, "and") for tag in marks)
        if plain and after == "relation":
            return i + end + 1
    return i


def _talk_end(tokens: Sequence[Token], i: int) -> int:
    """Return the end of a clause that is only a remark, or ``i`` for other clauses."""
    k = i
    while k < len(tokens) and tokens[k].text in (
        "because",
        "since",
        "as",
        "so",
        "but",
        "oh",
        "if",
        "what",
    ):
        k += 1
    if k >= len(tokens) or tokens[k].text not in _SPEAKERS:
        return i
    if i < k and tokens[k - 1].text == "what":
        ends = [n for n in range(k, len(tokens)) if tokens[n].text in ("is", "are", ":")]
        stops = [n for n in range(k, len(tokens)) if tokens[n].tag in ENDS]
        return ends[0] + 1 if ends and ends[0] < min(stops, default=len(tokens)) else i
    owned = tokens[k].text in ("my", "our", "his", "her")
    k += 1
    helped = 0
    if owned:
        if k >= len(tokens) or not _is_person(tokens[k].text):
            return i
        whose = k + 1 < len(tokens) and tokens[k + 1].tag == "possessive"
        named = read_noun(tokens, k + 2)[0] if whose else None
        helped = int(whose and (named is None or named.category is None))  # "my mate's ill"
        k += 1 + whose
    planned = any(t.text in ("about", "going", "gonna", "trying") for t in tokens[k : k + 3])
    while k < len(tokens) and tokens[k].text in _MODIFYING:
        k, helped = k + 1, helped + 1
    if k >= len(tokens) or tokens[k].tag != "word":
        return i
    word = tokens[k].text
    if (word in _WANTING and not planned) or not (planned or is_verb(word) or (owned and helped)):
        return i
    while k < len(tokens) and tokens[k].tag not in _PAUSES:
        k += 1
        if k < len(tokens) and tokens[k].tag == "carry":
            break  # "we are making a bar with four mugs"
        if k < len(tokens) and tokens[k].tag == "and":
            break
    return k


def _is_person(word: str) -> bool:
    entry = entry_of((word,))
    return entry is not None and entry.family == "person"


_DENYING = frozenset(["no", "none", "leave", "skip", "forget", "not", "nope", "never", "drop"])


def _read_answers(tokens: list[Token]) -> list[Token]:
    """Interpret "remote control? Yes, on the right" and "the iron? Leave it in the cupboard"."""
    out: list[Token] = []
    i = 0
    while i < len(tokens):
        texts = [token.text for token in tokens[i : i + 4]]
        unwanted = (
            texts[:1] and texts[0] in ("we", "i") and any(w in ("need", "want") for w in texts[2:4])
        )
        if unwanted and tokens[i + 1].tag == "no" and (start := _asked_about(out)) is not None:
            out.insert(start, Token("no", tokens[i + 1].words, "no"))  # "salt we do not need"
            i += 2 + (texts.index("need") if "need" in texts else texts.index("want")) - 1
            continue
        asked = tokens[i].text == "?" and i + 1 < len(tokens)
        start = _asked_about(out) if asked else None
        if start is None:
            out.append(tokens[i])
            i += 1
            continue
        answer = tokens[i + 1]
        if answer.text in _DENYING or answer.tag == "no":
            out.insert(start, Token("no", answer.words, "no"))
            i += 1
            while i < len(tokens) and tokens[i].tag not in ENDS:
                i += 1
        elif answer.text in ("yes", "sure", "yeah", "yep"):
            i += 2
            while i < len(tokens) and tokens[i].tag == "comma":
                i += 1
        elif answer.text in ("only", "just") and _is_number(tokens[i + 2 : i + 3]):
            out.insert(start, tokens[i + 2])
            i += 3
            while i < len(tokens) and tokens[i].text in ("pair", "of", "set", "one", "ones"):
                i += 1
        else:
            out.append(tokens[i])
            i += 1
    return out


_ASKABLE = ("thing", "collective")


def _is_number(tokens: Sequence[Token]) -> bool:
    return bool(tokens) and (tokens[0].tag == "number" or tokens[0].text in fw.NUMBERS)


def _asked_about(tokens: Sequence[Token]) -> int | None:
    """Return the start of the last sentence if it is a single noun phrase."""
    start = max((k + 1 for k, token in enumerate(tokens) if token.tag in ENDS), default=0)
    if not start < len(tokens) <= start + 5:
        return None
    noun, end = read_noun(tokens, start)
    return start if noun is not None and end == len(tokens) and noun.kind in _ASKABLE else None
