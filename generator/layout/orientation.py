"""Orientation of objects: fronts to the viewer, cutlery aligned, pens at random, postures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tabletop_objects import CATEGORIES
from tabletop_objects.kit.parts import box_part

from ..scene import Model, PlannedObject, ScenePlan
from ..scene.quarter_turns import turn

CUTLERY = frozenset({"fork", "knife", "spoon", "chopsticks"})
"""Categories laid in parallel; their working end (-x) points away from the diner."""

STRAIGHT = frozenset({
    "laptop", "keyboard", "monitor", "mousepad", "cutting_board", "tray", "wrist_rest",
})  # fmt: skip
"""Categories that people align with the table's edge."""


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
    """Return whether cutlery is laid beside a plate or a bowl."""
    served = {o.name for o in plan.objects if o.category in ("plate", "bowl", *CUTLERY)}
    return any(r.kind in ("left_of", "right_of") and r.target in served for r in planned.relations)


_THIN = 0.8  # maximum ratio of depth to width and to height for lying on the back or face
_STRIP = 0.2  # width of the strip under a lying round object, in widths of the object


def pose(model: Model, posture: str) -> Model:
    """Return the model in a posture: "upright", "lying" or "upside down".

    Upright, a flat object stands on its edge and a long one on its end. "lying" puts a thin upright
    object on its back and "upside down" on its face; other objects lie on their side or stand on
    their head. A model already in the posture is unchanged, and so is any model for another word.
    """
    x, y, z = (float(v) for v in model.size)
    thin = y < _THIN * min(x, z)
    if posture == "upright" and z < max(x, y):
        on_edge = z < 0.5 * min(x, y) and y >= x
        return turn(model, (("x", 90), ("z", 90)) if on_edge else (("y", -90),))
    if posture == "lying" and z > 0.8 * min(x, y):
        return _put_strip_under(turn(model, (("x", -90),) if thin else (("y", 90),)))
    if posture == "upside down":
        return turn(model, (("x", 90),) if thin else (("x", 180),))
    return model


def stand_up(model: Model, slenderness: float) -> Model:
    """Turn a model that is much longer than wide so that its +x end points up; else return it."""
    length, *others = model.size
    return model if length < slenderness * max(others) else turn(model, (("y", -90),))


def _put_strip_under(model: Model) -> Model:
    """Return a round model with a flat collision strip under it that prevents rolling."""
    vertices = model.mesh.vertices
    low = vertices[vertices[:, 2] < -0.48]
    if not model.parts or np.ptp(low[:, 1]) > 2 * _STRIP:
        return model
    (x0, y0), (x1, y1) = low[:, :2].min(0), low[:, :2].max(0)
    middle = float(x0 + x1) / 2, float(y0 + y1) / 2, -0.5
    strip = box_part(max(float(x1 - x0), 0.1), _STRIP, 0.05, middle)
    return replace(model, parts=(*model.parts, strip))
