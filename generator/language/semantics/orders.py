"""Orders of objects by size or colour, and sizes for ordered objects that have none."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from tabletop_objects import CATEGORIES

from ..drafts import Draft, Group

_RANKS: Mapping[str, float] = {"tiny": -1.0, "small": 0.0, "medium": 1.0, "large": 2.0}
_RAINBOW = ("red", "orange", "yellow", "green", "cyan", "blue", "indigo", "purple", "violet",
            "pink")  # fmt: skip
_SPREAD = 0.65, 1.45  # relative sizes of ordered objects


def size_rank(draft: Draft) -> float:
    """Return a number that increases with the size stated in the text."""
    if draft.lengths:
        return 10.0 * draft.lengths[0]
    return _RANKS.get(draft.attributes.get("size", ""), 1.0)


def put_in_order(group: Group, order: str | None) -> Group:
    """Return the objects in an order: "size", "size down" or "color"; unchanged for None.

    "ranks down" is the order of the sizes stated in the text, if any, largest first.

    Objects of one kind to be ordered by size, but without stated sizes, get different sizes.
    """
    if order == "color":
        return sorted(group, key=lambda d: _hue(d.attributes.get("color", "")))
    if order not in ("size", "size down", "ranks down"):
        return group
    if order != "ranks down" and len({size_rank(draft) for draft in group}) == 1:
        factors = np.linspace(*_SPREAD, len(group))
        for draft, factor in zip(group, factors, strict=True):
            usual = max(CATEGORIES[draft.category].size) if draft.category else 0.1
            draft.lengths = (float(usual * factor),)
    return sorted(group, key=size_rank, reverse=order != "size")


def _hue(color: str) -> int:
    word = color.split()[-1:]
    return _RAINBOW.index(word[0]) if word and word[0] in _RAINBOW else len(_RAINBOW)
