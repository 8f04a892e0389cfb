"""Comparison of achieved and desired goal vectors for n worlds, and the resulting reward terms.

The formulas are those of ``tasks.task`` for one world; see its table for the entries and the terms.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from jaxtyping import Bool, Float, Int

from ...tasks.task import ENTRIES, PLACE_SCALE
from .arrays import Array, namespace

_LEAST = 1e-6  # metres; minimum semi-axis, for padding


@dataclass(frozen=True, eq=False)
class Agreement:
    """Agreement between achieved and desired goal vectors, for each goal.

    across, up: horizontal and vertical distance of each target from its region, metres; met:
    whether each goal is met (padding counts as met); used: which goals are not padding.
    """

    across: Float[Array, "n g"]
    up: Float[Array, "n g"]
    met: Bool[Array, "n g"]
    used: Bool[Array, "n g"]

    @property
    def active(self) -> Int[Array, "n"]:
        """The index of the first goal that is not met, or of the last goal if all are met."""
        xp = namespace(self.met)
        first = xp.argmax(xp.astype(~self.met, xp.int8), axis=-1)
        last = xp.sum(xp.astype(self.used, xp.int64), axis=-1) - 1
        return xp.where(xp.all(self.met, axis=-1), last, first)


def agreement(
    achieved: Float[Array, "n v"], desired: Float[Array, "n v"], aside: Mapping[int, int]
) -> Agreement:
    """Compare achieved and desired goal vectors; for ``aside``, see ``tasks.task.Task``."""
    xp = namespace(achieved)
    a, d = (xp.reshape(v, (v.shape[0], -1, ENTRIES)) for v in (achieved, desired))
    x, y, z = (a[..., k] - d[..., k] for k in range(3))
    c, s = xp.cos(d[..., 5]), xp.sin(d[..., 5])
    semi = xp.clip(d[..., 3:5], min=_LEAST)
    out = xp.hypot((c * x + s * y) / semi[..., 0], (c * y - s * x) / semi[..., 1])
    across = xp.hypot(x, y) * (1 - 1 / xp.clip(out, min=1.0))
    up = xp.clip(xp.abs(z) - d[..., 6], min=0.0)
    used = d[..., 3] > 0
    met = (across <= 0) & (up <= 0) & (a[..., 7] >= d[..., 7]) | ~used
    for first, second in aside.items():
        met[:, first] |= met[:, second]
    return Agreement(across, up, met, used)


def goal_terms(found: Agreement, aside: Mapping[int, int]) -> dict[str, Float[Array, "n"]]:
    """Return the terms that depend only on the goal vectors: place, met and success."""
    xp = namespace(found.across)
    kind = found.across.dtype
    used, met = xp.astype(found.used, kind), xp.astype(found.met, kind)
    count = xp.sum(used, axis=-1)
    place = 1 / (1 + xp.hypot(found.across, found.up) / PLACE_SCALE)
    for first, second in aside.items():
        place[:, first] = xp.where(found.met[:, second], 1.0, place[:, first])
    return {
        "place": xp.sum(place * used, axis=-1) / count,
        "met": xp.sum(met * used, axis=-1) / count,
        "success": xp.astype(xp.all(found.met, axis=-1), kind),
    }
