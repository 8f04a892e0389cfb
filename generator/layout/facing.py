"""Orientation of things: fronts to the viewer, cutlery in line, pens at random."""

from __future__ import annotations

import numpy as np

from tabletop_objects import CATEGORIES

from ..scene import Model, PlannedObject, ScenePlan

CUTLERY = frozenset({"fork", "knife", "spoon", "chopsticks"})
"""Categories laid in parallel; their working end (-x) points away from the eater."""

STRAIGHT = frozenset({
    "laptop", "keyboard", "monitor", "mousepad", "cutting_board", "tray", "wrist_rest",
})  # fmt: skip
"""Categories that people line up with the table's edge."""


def natural_yaw(
    planned: PlannedObject, model: Model, plan: ScenePlan, rng: np.random.Generator
) -> float:
    """Return a yaw in radians: 0 turns an object's front (-y) to the viewer."""
    key = planned.category
    if key in CUTLERY and _at_plate(planned, plan):
        across = any(
            r.kind == "behind"
            for o in plan.objects
            for r in o.relations
            if o.name in {t.target for t in planned.relations} and r.target == "table"
        )
        return float((1 if across else -1) * np.pi / 2 + rng.normal(0, 0.03))
    if key in STRAIGHT:
        return float(np.clip(rng.normal(0, 0.05), -0.12, 0.12))
    length, depth, height = (float(v) for v in model.size)
    if key in CUTLERY:
        return float(-np.pi / 2 + rng.normal(0, 0.4))
    if length > 3.5 * depth and height < 0.04:
        return float(np.pi / 2 + rng.normal(0, 0.5))
    if key in CATEGORIES and "round" in CATEGORIES[key].roles:
        return float(rng.uniform(-0.9, 0.4))
    if height < 0.05 and length < 0.35 and key != "generic":
        return float(np.clip(rng.normal(0, 0.22), -0.5, 0.5))
    return float(np.clip(rng.normal(0, 0.13), -0.26, 0.26))


def _at_plate(planned: PlannedObject, plan: ScenePlan) -> bool:
    """Tell whether cutlery is laid beside a plate or a bowl."""
    served = {o.name for o in plan.objects if o.category in ("plate", "bowl", *CUTLERY)}
    return any(r.kind in ("left_of", "right_of") and r.target in served for r in planned.relations)
