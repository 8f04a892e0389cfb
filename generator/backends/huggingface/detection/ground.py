"""Which finds stand on the table, or on what stands on it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Bool

from ....meshes.pixels import hull_of
from .detections import BoxDetection

_FOOT = 1 / 6  # of a mask's height: what it stands on
_BELOW = 1 / 60  # of the picture's longer side: how far below a foot is looked


def on_table(things: Sequence[BoxDetection], table: Bool[np.ndarray, "h w"]) -> list[BoxDetection]:
    """Return the finds without those beside or below the table, in their order.

    Most of a thing's lowest part is over the table's outline, or has things that stand there right
    below it: it stands on them, or behind them.
    """
    ground, others = hull_of(table), np.zeros_like(table)
    standing: set[int] = set()
    while True:
        more = [
            k for k, f in enumerate(things)
            if k not in standing and (_over(f.mask, ground) or _upon(f.mask, others))
        ]  # fmt: skip
        if not more:
            return [things[k] for k in sorted(standing)]
        standing.update(more)
        others |= np.any([things[k].mask for k in more], axis=0)


def _over(mask: Bool[np.ndarray, "h w"], ground: Bool[np.ndarray, "h w"]) -> bool:
    foot = _foot(mask)
    return bool((foot & ground).sum() > 0.5 * foot.sum())


def _upon(mask: Bool[np.ndarray, "h w"], others: Bool[np.ndarray, "h w"]) -> bool:
    step = int(_BELOW * max(mask.shape)) + 1
    below = np.zeros_like(mask)
    below[step:] = _foot(mask)[:-step]
    below &= ~mask
    return bool((below & others).sum() > 0.5 * below.sum())


def _foot(mask: Bool[np.ndarray, "h w"]) -> Bool[np.ndarray, "h w"]:
    rows = np.flatnonzero(mask.any(1))
    low = rows[-1] - _FOOT * (rows[-1] - rows[0])
    return mask & (np.arange(len(mask))[:, None] >= low)
