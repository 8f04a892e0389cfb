"""The instruction as an entry of the observation: a text, tokens, or an embedding.

==============  =================================================================================
``"text"``      a ``spaces.Text`` of at most 256 printable ASCII characters; longer texts are
                truncated, and other characters become "?"
``"tokens"``    ``int32`` of 32 entries: a number from 1 to 4095 for each word, then zeros
``"embedding"`` ``float32`` of 64 entries, of norm 1 (0 if there is no word): the sum of words and
                their trigrams, each hashed to signed entries
==============  =================================================================================

Tokens and entries are hashes (CRC-32 of the word in lower case), so they need no vocabulary and are
the same on every machine; two words may collide. Similar texts have similar embeddings, but the
embeddings are not learned.
"""

from __future__ import annotations

import math
import re
import string
import sys
import warnings
import zlib
from typing import Any

import numpy as np
from gymnasium import spaces
from jaxtyping import Float, Int

from ..rendering.config import InstructionKind

MOST_CHARACTERS, MOST_TOKENS, VOCABULARY, EMBEDDING_SIZE = 256, 32, 4096, 64
"""Maximum characters of an instruction, tokens per row, token values, and embedding size."""

CHARACTERS = string.ascii_letters + string.digits + string.punctuation + " "
"""The permitted characters of an instruction."""

_WORDS = re.compile(r"[a-z0-9]+")
_PART = 3  # letters
_NUMBERS_ONLY = "stable_baselines3"


class InstructionText(spaces.Text):
    """The space of an instruction as text.

    It warns once if Stable-Baselines3 is loaded, because that library fails on ``spaces.Text`` with
    an unrelated message. The check runs on construction and when ``shape`` is read, as it is for
    every environment in that library, so the import order does not matter.
    """

    def __init__(self) -> None:
        super().__init__(MOST_CHARACTERS, min_length=0, charset=CHARACTERS)
        self._warned = False
        self._warn()

    @property
    def shape(self) -> None:
        """The shape: None, as for every text space."""
        self._warn()

    def _warn(self) -> None:
        if _NUMBERS_ONLY not in sys.modules or self._warned:
            return
        self._warned = True
        warnings.warn(
            "The observation contains the instruction as a string (spaces.Text), which "
            "Stable-Baselines3 cannot read. Create the environment with instruction='embedding', "
            "'tokens' or 'none'; info['instruction'] contains the string.",
            stacklevel=3,
        )


def instruction_space(kind: InstructionKind) -> spaces.Space[Any]:
    """Return the space of an instruction in the given form."""
    if kind == "text":
        return InstructionText()
    if kind == "tokens":
        return spaces.Box(0, VOCABULARY - 1, (MOST_TOKENS,), np.int32)
    return spaces.Box(-1.0, 1.0, (EMBEDDING_SIZE,), np.float32)


def show_instruction(kind: InstructionKind, text: str) -> str | np.ndarray:
    """Return an instruction as an element of its space."""
    if kind == "text":
        return "".join(c if c in CHARACTERS else "?" for c in text[:MOST_CHARACTERS])
    return tokens(text) if kind == "tokens" else embed(text)


def tokens(text: str) -> Int[np.ndarray, "32"]:
    """Return the tokens of the first 32 words, padded with zeros."""
    row = np.zeros(MOST_TOKENS, np.int32)
    words = _WORDS.findall(text.lower())[:MOST_TOKENS]
    row[: len(words)] = [1 + _hash(word) % (VOCABULARY - 1) for word in words]
    return row


def embed(text: str) -> Float[np.ndarray, "64"]:
    """Return the normalised sum of the signed hashes of the words and of their trigrams."""
    entries = np.zeros(EMBEDDING_SIZE)
    for word in _WORDS.findall(text.lower()):
        edged = f" {word} "
        parts = [edged[k : k + _PART] for k in range(len(edged) - _PART + 1)]
        for part, weight in ((word, 1.0), *((part, 1 / len(parts)) for part in parts)):
            code = _hash(part)
            entries[code % EMBEDDING_SIZE] += weight if code >> 31 else -weight
    length = math.sqrt(float(entries @ entries))
    return (entries / length if length else entries).astype(np.float32)


def _hash(part: str) -> int:
    return zlib.crc32(part.encode())
