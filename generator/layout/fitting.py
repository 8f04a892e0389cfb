"""A layout on the smallest plausible table that holds it."""

from __future__ import annotations

from collections.abc import Mapping

from ..errors import SceneError
from ..scene import Model, ScenePlan
from .arranging import Layout, arrange
from .furnishing import build_top

GROWTH = (1.0, 1.15, 1.3)
"""How much larger the table gets, try by try, when the objects do not fit."""


def lay_out(plan: ScenePlan, models: Mapping[str, Model], seed: int) -> tuple[Layout, Model]:
    """Arrange the models on the plan's table, on a larger one if they do not fit.

    Raises:
        SceneError: they fit on no plausible table.
    """
    error: SceneError | None = None
    for growth in GROWTH:
        table = build_top(plan, models, seed, growth)
        try:
            return arrange(plan, models, table, seed), table
        except SceneError as failed:
            error = failed
    raise error or SceneError("No table was tried.")
