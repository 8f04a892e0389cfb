"""Prompts for Grounding DINO, and the assignment of its outputs to words.

The network outputs, for each box, a logit per token of the prompt. The tokens of each word follow
from its position in the prompt, so each box gets one of the requested words, never a fragment or a
combination of words.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

if TYPE_CHECKING:
    from torch import Tensor


@dataclass(frozen=True)
class PhraseQuestion:
    """A prompt for some words; ``tokens`` are the positions of each word's tokens."""

    words: tuple[str, ...]
    text: str
    tokens: tuple[tuple[int, ...], ...]
    ids: tuple[int, ...]


def questions(
    words: Sequence[str], tokenizer: Any, most_words: int, most_tokens: int
) -> tuple[PhraseQuestion, ...]:
    """Return prompts that cover all words, within the limits on words and tokens per prompt.

    The words keep their order. A word that is too long for a prompt is truncated; words without
    letters are skipped.
    """
    made: list[PhraseQuestion] = []
    for word in words:
        alone = _question((word,), tokenizer)
        if not any(alone.tokens):
            continue
        longer = _question((*made[-1].words, word), tokenizer) if made else alone
        if made and len(longer.words) <= most_words and len(longer.ids) <= most_tokens:
            made[-1] = longer
        else:
            made.append(alone)
    return tuple(_cut(q, most_tokens) for q in made)


def best_words(
    logits: Float[Tensor, "q t"], question: PhraseQuestion
) -> tuple[Float[np.ndarray, "q"], np.ndarray]:
    """Return each box's score, and the index of its best word.

    The best word has the highest mean probability of its tokens; the score is the highest
    probability among them.
    """
    chances = logits.float().sigmoid().cpu().numpy()
    means = np.stack([chances[:, list(t)].mean(1) for t in question.tokens], 1)
    peaks = np.stack([chances[:, list(t)].max(1) for t in question.tokens], 1)
    best = means.argmax(1)
    return peaks[np.arange(len(best)), best].astype(float), best


def plain(word: str) -> str:
    """Return a word without dots and question marks, which separate the words of a prompt."""
    return " ".join(re.sub(r"[.?]+", " ", word.lower()).split())


def _question(words: tuple[str, ...], tokenizer: Any) -> PhraseQuestion:
    text, spans = "", []
    for word in words:
        spans.append((len(text), len(text) + len(plain(word))))
        text += f"{plain(word)}. "
    text = text.strip()
    coded = tokenizer(text, return_offsets_mapping=True)
    places = [
        tuple(k for k, (a, b) in enumerate(coded["offset_mapping"]) if low <= a < b <= high)
        for low, high in spans
    ]
    return PhraseQuestion(words, text, tuple(places), tuple(coded["input_ids"]))


def _cut(question: PhraseQuestion, maximum: int) -> PhraseQuestion:
    """Shorten a prompt to ``maximum`` tokens, keeping the last one, which ends the prompt."""
    if len(question.ids) <= maximum:
        return question
    ids = (*question.ids[: maximum - 1], question.ids[-1])
    tokens = tuple(tuple(k for k in t if k < maximum - 1) for t in question.tokens)
    return PhraseQuestion(question.words, question.text, tokens, ids)
