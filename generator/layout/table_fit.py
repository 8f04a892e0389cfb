"""Layout on the smallest plausible table that holds all objects."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from ..errors import SceneError
from ..scene import Model, ScenePlan
from .arrangement import Layout, arrange
from .furniture import build_top

GROWTH = (1.0, 1.15, 1.3)
"""Growth factors of the table, one per attempt."""

_STRAINED = 1.0
"""Violation of a relation (``Layout.strain``) at or above which a larger table is tried."""


def lay_out(
    plan: ScenePlan,
    models: Mapping[str, Model],
    seed: int,
    yaws: Mapping[str, float] = MappingProxyType({}),
) -> tuple[Layout, Model]:
    """Arrange the models on the plan's table, or on a larger one if they do not fit.

    ``yaws`` prescribes the yaws of some objects, in radians.

    Raises:
        SceneError: The objects do not fit on any plausible table.
    """
    error: SceneError | None = None
    best: tuple[Layout, Model] | None = None
    for growth in GROWTH:
        try:
            table = build_top(plan, models, seed, growth)
            layout = arrange(plan, models, table, seed, yaws)
        except SceneError as failed:
            error = failed
            continue
        if best is None or layout.strain < best[0].strain:
            best = layout, table
        if layout.strain < _STRAINED:
            break
    if best is None:
        raise error or SceneError("No table size was tried.")
    return best
