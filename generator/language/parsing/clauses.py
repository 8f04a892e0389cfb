"""What the rest of a sentence tells about where a relation or a list belongs."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from .grammar import Chunk


def returns(rest: Sequence[Chunk]) -> bool:
    """Tell whether the rest of a sentence puts things on or in "it"."""
    for chunk, following in pairwise(rest):
        if chunk.kind in ("stop", "carry"):  # "a board with a knife on it": the board
            return False
        if chunk.kind == "relation" and chunk.text in ("on", "in"):
            return following.noun is not None and following.noun.kind == "pronoun"
    return False


def closes(rest: Sequence[Chunk]) -> bool:
    """Tell whether a list inside a list ends here: "full of two apples, a pear and a lemon, a"."""
    return [chunk.kind for chunk in rest[:4]] == ["noun", "and", "noun", "comma"]


def is_fronted(chunks: Sequence[Chunk], i: int) -> bool:
    """Tell whether a relation opens a clause: ", to its left a book", "and behind it is a mug"."""
    if not i or chunks[i - 1].kind not in ("comma", "and"):
        return False
    rest = [c.noun for c in chunks[i + 1 : i + 5] if c.kind not in ("are", "gap")]
    if not chunks[i].text.partition(" ")[2]:  # its target comes first
        if not rest or rest[0] is None or not rest[0].definite:
            return False
        del rest[0]
    return bool(rest) and rest[0] is not None and rest[0].determined
