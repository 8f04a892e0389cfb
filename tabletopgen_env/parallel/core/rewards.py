"""Reward terms and rewards of n worlds; see ``tasks.task`` for their definitions."""

from __future__ import annotations

from collections.abc import Mapping

from jaxtyping import Float

from ...tasks.task import LIFT, REACH_SCALE
from .arrays import Array, namespace, squares, take_rows
from .goal_rows import RAISED, GoalRows
from .readings import Readings
from .vectors import Agreement, goal_terms

_HAND = ("reach", "grasp", "lift")


def terms(
    rows: GoalRows, seen: Readings, found: Agreement, aside: Mapping[int, int]
) -> dict[str, Float[Array, "n"]]:
    """Return all reward terms by name, each in [0, 1].

    ``found`` is the agreement of the goal vectors; ``aside`` is as in ``tasks.task.Task``.
    """
    xp = namespace(found.across)
    shared = goal_terms(found, aside)
    kind = found.across.dtype
    count = xp.sum(xp.astype(found.used, kind), axis=-1)
    met = shared["met"] * count
    done = shared["success"] > 0
    hand = {name: (met + value) / count for name, value in _hand(rows, seen, found).items()}
    return {k: xp.where(done, xp.ones_like(met), v) for k, v in (hand | shared).items()}


def _hand(rows: GoalRows, seen: Readings, found: Agreement) -> dict[str, Float[Array, "n"]]:
    """Return the reach, grasp and lift terms of active goals."""
    xp = namespace(found.across)
    active = found.active[:, None]

    def now(values: Array) -> Array:
        return take_rows(values, active)[:, 0]

    target = now(rows.target)
    at = take_rows(seen.positions, target[:, None])[:, 0]
    across, up = now(found.across), now(found.up)
    released = now(rows.kind) != RAISED
    away = xp.sqrt(squares(seen.tool - at))
    fingers = xp.astype(now(seen.touched)[:, :2], away.dtype)
    asked = xp.where(released, xp.clip(across, max=LIFT), xp.full_like(across, LIFT))
    risen = (at[:, 2] - now(rows.start)) / xp.where(asked > 0, asked, xp.ones_like(asked))
    values = {
        "reach": 1 / (1 + away / REACH_SCALE),
        "grasp": xp.sum(fingers, axis=-1) / 2,
        "lift": xp.where(asked > 0, xp.clip(risen, 0.0, 1.0), xp.ones_like(asked)),
    }
    over = (target < 0) | (released & (across <= 0) & (up <= 0))
    return {name: xp.where(over, xp.ones_like(across), values[name]) for name in _HAND}


def weigh(
    found: Mapping[str, Float[Array, "n"]], weights: Mapping[str, float], sparse: bool
) -> Float[Array, "n"]:
    """Return the rewards: the weighted sum of the terms, or success minus 1 if ``sparse``."""
    if sparse:
        return found["success"] - 1.0
    total = 0.0
    for name, weight in weights.items():
        total = total + weight * found[name]
    return total
