"""Things turned unlike they stand otherwise: upright, lying on a side, upside down."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tabletop_objects.kit.parts import box_part

from ..scene import Model
from ..scene.turning import turn

_THIN = 0.8  # depth to width and height of what falls on its back or its face, not on its side
_STRIP = 0.2  # width of the strip on which a lying round thing rests, in widths of the thing


def pose(model: Model, posture: str) -> Model:
    """Return the model in a posture: "upright", "lying" or "upside down".

    Upright, a flat thing stands on its edge and a long one on its end. A thin upright thing lies on
    its back, and on its face where it is upside down; another one lies on its side. What is in the
    posture already stays as it is, and so does everything for any other word.
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
    """Turn a model that is so much longer than wide that its +x end points up, and no other."""
    length, *others = model.size
    return model if length < slenderness * max(others) else turn(model, (("y", -90),))


def _put_strip_under(model: Model) -> Model:
    """Return the model with a narrow flat part under it, without which a round one would roll."""
    vertices = model.mesh.vertices
    low = vertices[vertices[:, 2] < -0.48]
    if not model.parts or np.ptp(low[:, 1]) > 2 * _STRIP:
        return model
    (x0, y0), (x1, y1) = low[:, :2].min(0), low[:, :2].max(0)
    middle = float(x0 + x1) / 2, float(y0 + y1) / 2, -0.5
    strip = box_part(max(float(x1 - x0), 0.1), _STRIP, 0.05, middle)
    return replace(model, parts=(*model.parts, strip))
