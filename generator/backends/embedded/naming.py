"""Which word belongs to which region."""

from __future__ import annotations

import numpy as np
from jaxtyping import Bool, UInt8

from ...catalogue import Category, category
from ...errors import InputError
from .plane import TablePlane


def known(word: str) -> Category | None:
    """Return the catalogue's category for a word, or None if it has none."""
    try:
        return category(word)
    except InputError:
        return None


def name_things(
    image: UInt8[np.ndarray, "h w 3"],
    plane: TablePlane,
    masks: list[Bool[np.ndarray, "h w"]],
    labels: tuple[str, ...],
    naming: bool,
) -> list[tuple[str, float]]:
    """Return a label and a score in [0, 1] for each region."""
    wanted = [w for w in labels if w != "object"]
    if not wanted or not naming:
        return [("object", 0.5)] * len(masks)
    return [(wanted[k % len(wanted)], 0.5) for k in range(len(masks))]
