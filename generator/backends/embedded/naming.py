"""What the things are called: the eye's guesses, weighed with size, or the words of a text."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float
from scipy.optimize import linear_sum_assignment

from ...catalogue import CATEGORIES, Category, category
from ...errors import InputError

_SURE = 0.35  # probability from which a thing gets its category's name
_LEADING = 0.6  # probability from which a thing helps to tell the table's scale
_SPREAD = 0.35  # of a thing's usual size, log: one standard deviation
_RARE = 1e-4  # probability that no category falls below


def known(word: str) -> Category | None:
    """Return the catalogue's category for a word, or None if it has none."""
    try:
        return category(word)
    except InputError:
        return None


def table_scale(
    names: Float[np.ndarray, "n k"], keys: Sequence[str], spans: Float[np.ndarray, "n"]
) -> float:
    """Return by how much measured sizes must grow so that surely named things have their usual one.

    Args:
        names: probabilities of each thing over ``keys`` and, last, "unknown".
        keys: category keys.
        spans: each thing's measured size, metres: the cube root of its extents' product.
    """
    ratios = [
        np.log(_usual_span(keys[int(p.argmax())]) / span)
        for p, span in zip(names, spans, strict=True)
        if p.argmax() < len(keys) and p.max() > _LEADING and span > 0
    ]
    return float(np.exp(np.clip(np.median(ratios), np.log(0.5), np.log(2.0)))) if ratios else 1.0


def weighed(
    names: Float[np.ndarray, "n k"], keys: Sequence[str], spans: Float[np.ndarray, "n"]
) -> Float[np.ndarray, "n k"]:
    """Return the probabilities after a look at the sizes (metres), which must be near the usual."""
    usual = np.array([_usual_span(key) for key in keys])
    off = np.log(np.maximum(spans, 1e-4))[:, None] - np.log(usual)[None]
    likely = np.concatenate([np.exp(-0.5 * (off / _SPREAD) ** 2), np.full((len(names), 1), 0.3)], 1)
    joint = names * np.maximum(likely, 1e-3)
    return joint / joint.sum(1, keepdims=True)


def free_labels(names: Float[np.ndarray, "n k"], keys: Sequence[str]) -> list[str | None]:
    """Return each thing's noun, or None where no category is likely enough."""
    best = names[:, :-1].argmax(1)
    return [
        CATEGORIES[keys[int(k)]].noun if p[k] > _SURE and p[k] > p[-1] else None
        for p, k in zip(names, best, strict=True)
    ]


def shape_word(width: float, height: float, share: float) -> str:
    """Return "tall", "flat", "round" or plain "object" after a mask's box and its filled share."""
    if height > 1.6 * width:
        return "tall object"
    if width > 1.6 * height:
        return "flat object"
    return "round object" if 0.72 < share < 0.86 else "object"


def assigned(
    names: Float[np.ndarray, "n k"],
    keys: Sequence[str],
    scores: Float[np.ndarray, "n"],
    wanted: Sequence[str],
) -> list[tuple[int, int]]:
    """Give each wanted word to one thing, all together as likely as possible.

    Returns:
        Pairs (thing, index into ``wanted``); words or things may be left over.
    """
    at = {key: k for k, key in enumerate(keys)}
    found = [known(word) for word in wanted]
    columns = [at.get(c.key, len(keys)) if c else len(keys) for c in found]
    likely = np.maximum(names[:, columns], _RARE)
    cost = -np.log(likely) - np.log(np.clip(scores, 0.05, 1.0))[:, None]
    return [(int(i), int(j)) for i, j in zip(*linear_sum_assignment(cost), strict=True)]


def _usual_span(key: str) -> float:
    return float(np.cbrt(np.prod(CATEGORIES[key].size)))
