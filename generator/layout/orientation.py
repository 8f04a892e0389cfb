"""Orientation and posture: fronts face the viewer, cutlery is aligned, pens lie at random."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tabletop_objects import CATEGORIES
from tabletop_objects.kit.parts import box_part

from ..scene import Model, PlannedObject, ScenePlan
from ..scene.quarter_turns import turn

CUTLERY = frozenset({"fork", "knife", "spoon", "chopsticks"})
"""Categories of objects laid in parallel, with the working end (-x) away from the diner."""

STRAIGHT = frozenset({
    "laptop", "keyboard", "monitor", "mousepad", "cutting_board", "tray", "wrist_rest",
})  # fmt: skip
"""Categories of objects that people align with the table's edge."""


def natural_yaw(
    planned: PlannedObject, model: Model, plan: ScenePlan, rng: np.random.Generator
) -> float:
    """Return a natural yaw in radians; 0 turns an object's front (-y) to the viewer."""
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


_THIN = 0.8  # maximum ratio of depth to width and to height of an object laid on its back or face
_STRIP = 0.2  # width of the strip under a lying round object, as a fraction of the object's width


def pose(model: Model, posture: str) -> Model:
    """Return the model in a posture: "upright", "lying" or "upside down".

    "upright" stands a flat object on its edge and a long one on its end. A thin, upright object is
    put on its back by "lying" and on its face by "upside down"; other objects are laid on their
    side or turned over. A model that already has the posture is unchanged; any other word has no
    effect.
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
    """Stand a model on end, with +x up, if it is much longer than wide; return others unchanged."""
    length, *others = model.size
    return model if length < slenderness * max(others) else turn(model, (("y", -90),))


def _put_strip_under(model: Model) -> Model:
    """Return a round model with a flat collision strip under it that keeps it from rolling."""
    vertices = model.mesh.vertices
    low = vertices[vertices[:, 2] < -0.48]
    if not model.parts or np.ptp(low[:, 1]) > 2 * _STRIP:
        return model
    (x0, y0), (x1, y1) = low[:, :2].min(0), low[:, :2].max(0)
    middle = float(x0 + x1) / 2, float(y0 + y1) / 2, -0.5
    strip = box_part(max(float(x1 - x0), 0.1), _STRIP, 0.05, middle)
    return replace(model, parts=(*model.parts, strip))
