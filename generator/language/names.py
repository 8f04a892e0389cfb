"""What things are called: the eye's guesses, or the words of a text, weighed with sizes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from jaxtyping import Bool, Float
from scipy.optimize import linear_sum_assignment

from tabletop_objects import CATEGORIES, Category, find_category

from ..scene import Instance, SizePrior

_SURE = 0.55  # probability from which a thing gets its category's name
_SPREAD = 0.3  # of a thing's usual size, log: one standard deviation
_SHAPES = 0.4  # of its proportions in the picture, log
_BELIED = float(np.log(1.7))  # log of size over a kind's usual one that no name survives
_TABLES = 0.35  # of a table's usual size, log
_SHIFTS = np.linspace(-0.7, 0.7, 29)
_UNLIKE = 0.003  # likelihood of a size and shape that the category does not have
_ANY = 0.6  # and of any, for a thing of no category
_LIKE = 0.03  # probability from which a doubtful thing looks like a word
_SIZE_WEIGHT = 0.5  # of a size and shape against looks: both show a thing's proportions
_MOST_UNLIKE = 5.0  # cost at most of a size and shape that a word does not have
_NO_SIZE = 2.0  # and of those of a word, or a thing, that has none
_LEFT_OUT = 6.0  # cost of a doubtful thing without a word
_RARE = 1e-4  # probability that no category falls below


def find_kind(word: str) -> Category | None:
    """Return the category of a word, or of what it is a kind of: "mug of tea", "tin mug"."""
    parts = (word, word.split(" of ")[0], word.split(" ")[-1])
    return next((found for part in parts if (found := find_category(part))), None)


def weigh(
    names: Float[np.ndarray, "n k"],
    looks: Sequence[Mapping[int, tuple[float, float]] | None],
    metric: bool = False,
) -> Float[np.ndarray, "n k"]:
    """Return the probabilities after a look at sizes and shapes, on the likeliest table.

    All things share one table, so that one scale must do for all: it is chosen to make the names
    likeliest together, unless ``metric`` says that it was measured. A category that was not looked
    at is as likely as one that is unlike. What a thing is far too large or too small for, by the
    scale chosen, counts as "unknown", however much the thing looks like it. ``names`` are
    probabilities of each thing over the categories and, last, "unknown"; ``looks``, by category
    index, what ``apparent_scale`` returns on a table of usual size; None for a thing that the frame
    cuts.
    """
    shifts = np.zeros(1) if metric else _SHIFTS
    joint = [names * _likely(names, looks, shift) for shift in shifts]
    evidence = [np.log(j.sum(1)).sum() for j in joint] - 0.5 * (shifts / _TABLES) ** 2
    chosen = int(np.argmax(evidence))
    best = joint[chosen]
    for row, seen in zip(best, looks, strict=True):
        for column, (scale, _) in (seen or {}).items():
            if abs(np.log(scale) + shifts[chosen]) > _BELIED:
                row[-1] += row[column]
                row[column] = 0.0
    return best / best.sum(1, keepdims=True)


def _likely(
    names: Float[np.ndarray, "n k"],
    looks: Sequence[Mapping[int, tuple[float, float]] | None],
    shift: float,
) -> Float[np.ndarray, "n k"]:
    """Return how likely sizes and shapes are, by category, on a table of log scale ``shift``."""
    likely = np.full(names.shape, _UNLIKE)
    likely[:, -1] = _ANY
    for row, seen in zip(likely, looks, strict=True):
        if seen is None:
            row[:] = 1.0
            continue
        for column, (scale, off) in seen.items():
            size = (np.log(scale) + shift) / _SPREAD
            row[column] = max(np.exp(-0.5 * (size**2 + (off / _SHAPES) ** 2)), _UNLIKE)
    return likely


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


def assign(
    likely: Float[np.ndarray, "n w"],
    scores: Float[np.ndarray, "n"],
    sizes: Float[np.ndarray, "n w 2"],
    doubtful: Bool[np.ndarray, "n"] | None = None,
    metric: bool = False,
) -> list[tuple[int, int]]:
    """Give each wanted word to one thing, all together as likely as possible.

    ``likely`` says how much each thing looks like each word, from 0 to 1; ``sizes`` what
    ``apparent_scale`` returns for it, NaN where the word says no size. All things share one table,
    as in :func:`weigh`, whose scale is chosen unless it was measured (``metric``). ``doubtful``
    things, which may be parts of others, are given only words that they look like.

    Returns:
        Pairs (thing, word); words or things may be left over.
    """
    cost = -np.log(np.maximum(likely, _RARE)) - np.log(np.clip(scores, 0.05, 1.0))[:, None]
    refused = np.zeros(cost.shape, bool)
    if doubtful is not None:
        refused = doubtful[:, None] & (likely < _LIKE)
    best, pairs = np.inf, list[tuple[int, int]]()
    for shift in np.zeros(1) if metric else _SHIFTS:
        scale, off = np.log(sizes[..., 0]) + shift, sizes[..., 1]
        unlike = np.minimum(0.5 * ((scale / _SPREAD) ** 2 + (off / _SHAPES) ** 2), _MOST_UNLIKE)
        total = cost + _SIZE_WEIGHT * np.where(np.isnan(unlike), _NO_SIZE, unlike)
        total[refused] = _LEFT_OUT
        rows, columns = linear_sum_assignment(total)
        value = float(total[rows, columns].sum() + 0.5 * (shift / _TABLES) ** 2)
        if value < best:
            best, found = value, zip(rows, columns, strict=True)
            pairs = [(int(i), int(j)) for i, j in found if not refused[i, j]]
    return pairs


def known_category(instance: Instance, size: SizePrior) -> Category | None:
    """Return the catalogue's category for an instance's label or its prior's name, if any."""
    return find_category(instance.label) or find_category(size.name.rstrip("_0123456789"))
