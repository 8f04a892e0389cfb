"""What stands on or in what, from the masks alone (Fig. 25)."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from jaxtyping import Bool

from ...geometry import mask_box
from ...scene import TABLE, Instance, Stacking


def support_share(thing: Bool[np.ndarray, "h w"], below: Bool[np.ndarray, "h w"]) -> float:
    """Return how much of what surrounds the foot of ``thing`` belongs to ``below``.

    The foot is the lowest sixth of the mask. Something that stands on or in ``below`` has it on
    both sides of its foot and under it; something that stands behind it has it only under it.
    """
    x0, y0, x1, y1 = mask_box(thing).astype(int)
    rise = max(2, (y1 - y0) // 6)
    reach = max(3, (x1 - x0) // 12)
    h, w = thing.shape
    sides, under = [], []
    for y in range(max(y1 - rise, y0), y1):
        row = np.flatnonzero(thing[y])
        if len(row):
            sides += [below[y, max(row[0] - reach, 0)], below[y, min(row[-1] + reach, w - 1)]]
    for x in range(x0, x1):
        column = np.flatnonzero(thing[:, x])
        if len(column) and column[-1] >= y1 - rise:
            under.append(below[min(column[-1] + reach, h - 1), x])
    if not sides or not under:
        return 0.0
    return float(min(np.mean(sides), np.mean(under)))


def stack(
    instances: tuple[Instance, ...], container: Callable[[str], bool]
) -> Mapping[str, Stacking]:
    """Return what each instance stands on; ``container`` tells whether a label holds things."""
    things = [i for i in instances if i.name != TABLE]
    masks = {i.name: np.asarray(i.mask) for i in things}
    areas = {i.name: float(i.mask.sum()) for i in things}
    on = {}
    for thing in things:
        shares = {
            other.name: support_share(masks[thing.name], masks[other.name])
            for other in things
            if areas[other.name] > 0.8 * areas[thing.name] and other is not thing
        }
        best = max(shares, key=lambda n: shares[n], default=None)
        on[thing.name] = best if best is not None and shares[best] >= 0.5 else TABLE
    labels = {i.name: i.label for i in things}
    result = {TABLE: Stacking(1)}
    for name in masks:
        chain = [name]
        while on[chain[-1]] != TABLE and on[chain[-1]] not in chain:
            chain.append(on[chain[-1]])
        below = on[name] if on[chain[-1]] == TABLE else TABLE
        inside = below != TABLE and container(labels[below])
        result[name] = Stacking(1 + len(chain), below, inside)
    return result
