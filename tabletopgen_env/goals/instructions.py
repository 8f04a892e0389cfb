"""Object names that a person on the robot's side of the table would understand."""

from __future__ import annotations

import math
from collections.abc import Collection

from generator.scene import Object, Scene

_SAME = 4  # decimals of a metre at which two positions are compared

_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth")


def refer(scene: Scene, obj: Object, yaw: float, absent: Collection[str] = ()) -> str:
    """Return a phrase that identifies ``obj`` uniquely in ``scene``, such as "the red mug".

    The phrase is the label if it is unique; the label with its colour if the colours in the plan
    differ; otherwise the phrase counts from the left, as seen in the direction ``yaw`` (that of the
    robot's x axis, radians). ``absent`` objects are not counted.
    """
    alike = [o for o in scene.objects if o.label == obj.label and o.name not in absent]
    colors = {o.name: _color(scene, o.name) for o in alike}
    mine = colors[obj.name]
    if len(alike) == 1 or (mine and list(colors.values()).count(mine) == 1):
        return f"the {mine} {obj.label}" if mine and mine not in obj.label else f"the {obj.label}"
    row = sorted(alike, key=lambda o: (round(_rightwards(o, yaw), _SAME), o.name))
    place = row.index(obj)
    if len(row) == 2:
        return f"the {('left', 'right')[place]} {obj.label}"
    ordinal = _ORDINALS[place] if place < len(_ORDINALS) else f"{place + 1}th"
    return f"the {ordinal} {obj.label} from the left"


def _rightwards(obj: Object, yaw: float) -> float:
    """Return how far to the right an object is, in metres, when viewed in the direction ``yaw``."""
    x, y, _ = obj.pose.position
    return float(x * math.sin(yaw) - y * math.cos(yaw))


def _color(scene: Scene, name: str) -> str | None:
    """Return an object's colour in the scene's plan, or None if the plan has none."""
    planned = scene.plan.objects if scene.plan else ()
    return next((p.attributes.get("color") for p in planned if p.name == name), None)
