"""Naming of detected objects by their sizes and the detector's guesses or the text's words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from jaxtyping import Bool, Float
from scipy.optimize import linear_sum_assignment

from tabletop_objects import CATEGORIES, Category, find_category

from ..scene import Instance, SizePrior

_SURE = 0.55  # minimum probability at which an object is named after its category
_SPREAD = 0.3  # standard deviation of an object's size relative to the usual one, logarithm
_SHAPES = 0.4  # standard deviation of the object's proportions in the picture, logarithm
_MAX_DEVIATION = float(np.log(1.7))  # maximum deviation from a category's usual size, logarithm
_TABLES = 0.35  # standard deviation of a table's size relative to the usual one, logarithm
_SHIFTS = np.linspace(-0.7, 0.7, 29)
_UNLIKE = 0.003  # likelihood of a size and shape that are unusual for the category
_ANY = 0.6  # likelihood of any size for an object without a category
_LIKE = 0.03  # minimum probability at which a word is assigned to a doubtful object
_SIZE_WEIGHT = 0.5  # weight of size and shape relative to appearance: both depend on proportions
_MAX_UNLIKE = 5.0  # maximum cost of a size and shape that are unusual for the word
_NO_SIZE = 2.0  # cost if the word or the object has no size
_LEFT_OUT = 6.0  # cost of leaving a doubtful object without a word
_RARE = 1e-4  # minimum probability of any category


def find_kind(word: str) -> Category | None:
    """Return the category of a term or of its head noun ("mug" in "mug of tea" and "tin mug")."""
    parts = (word, word.split(" of ")[0], word.split(" ")[-1])
    return next((found for part in parts if (found := find_category(part))), None)


def weigh(
    names: Float[np.ndarray, "n k"],
    looks: Sequence[Mapping[int, tuple[float, float]] | None],
    metric: bool = False,
) -> Float[np.ndarray, "n k"]:
    """Update the probabilities of names from sizes and shapes, given the most likely table size.

    All objects share one table and thus one scale. It is chosen to maximise the joint likelihood of
    the names, unless it was measured (``metric``). Categories that were not evaluated get the
    minimum likelihood. If an object is far too large or too small for a category at the chosen
    scale, its probability moves to "unknown", regardless of appearance. ``names`` are each object's
    probabilities of the categories and, last, of "unknown". ``looks`` maps category indices to the
    result of ``apparent_scale`` on a table of usual size; it is None for an object that the image
    border cuts off.
    """
    shifts = np.zeros(1) if metric else _SHIFTS
    joint = [names * _likely(names, looks, shift) for shift in shifts]
    evidence = [np.log(j.sum(1)).sum() for j in joint] - 0.5 * (shifts / _TABLES) ** 2
    chosen = int(np.argmax(evidence))
    best = joint[chosen]
    for row, seen in zip(best, looks, strict=True):
        for column, (scale, _) in (seen or {}).items():
            if abs(np.log(scale) + shifts[chosen]) > _MAX_DEVIATION:
                row[-1] += row[column]
                row[column] = 0.0
    return best / best.sum(1, keepdims=True)


def _likely(
    names: Float[np.ndarray, "n k"],
    looks: Sequence[Mapping[int, tuple[float, float]] | None],
    shift: float,
) -> Float[np.ndarray, "n k"]:
    """Return each category's likelihood given sizes, shapes and the table's log scale ``shift``."""
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
    """Return each object's noun, or None if no category is sufficiently likely."""
    best = names[:, :-1].argmax(1)
    return [
        CATEGORIES[keys[int(k)]].noun if p[k] > _SURE and p[k] > p[-1] else None
        for p, k in zip(names, best, strict=True)
    ]


def shape_word(width: float, height: float, share: float) -> str:
    """Return "tall object", "flat object", "round object" or "object" for the shape of a mask."""
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
    """Assign the given words to objects so that the joint likelihood is maximal.

    ``likely`` is the visual probability, from 0 to 1, of each word for each object; ``sizes`` is
    the result of ``apparent_scale``, or NaN if the word has no size. All objects share one table,
    as in :func:`weigh`; its scale is optimised unless it was measured (``metric``). ``doubtful``
    objects, which may be parts of others, get only words that they resemble.

    Returns:
        Pairs (object, word); words or objects may remain unassigned.
    """
    cost = -np.log(np.maximum(likely, _RARE)) - np.log(np.clip(scores, 0.05, 1.0))[:, None]
    refused = np.zeros(cost.shape, bool)
    if doubtful is not None:
        refused = doubtful[:, None] & (likely < _LIKE)
    best, pairs = np.inf, list[tuple[int, int]]()
    for shift in np.zeros(1) if metric else _SHIFTS:
        scale, off = np.log(sizes[..., 0]) + shift, sizes[..., 1]
        unlike = np.minimum(0.5 * ((scale / _SPREAD) ** 2 + (off / _SHAPES) ** 2), _MAX_UNLIKE)
        total = cost + _SIZE_WEIGHT * np.where(np.isnan(unlike), _NO_SIZE, unlike)
        total[refused] = _LEFT_OUT
        rows, columns = linear_sum_assignment(total)
        value = float(total[rows, columns].sum() + 0.5 * (shift / _TABLES) ** 2)
        if value < best:
            best, found = value, zip(rows, columns, strict=True)
            pairs = [(int(i), int(j)) for i, j in found if not refused[i, j]]
    return pairs


def known_category(instance: Instance, size: SizePrior) -> Category | None:
    """Return the catalogue category of an instance's label or of its size prior's name, or None."""
    return find_category(instance.label) or find_category(size.name.rstrip("_0123456789"))
