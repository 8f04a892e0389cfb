"""Names for objects that a person at the table, on the robot's side, would understand."""

from __future__ import annotations

import math
from collections.abc import Collection

from generator.scene import Object, Scene

_SAME = 4  # decimals of a metre to which two places are compared

_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth")


def refer(scene: Scene, obj: Object, yaw: float, absent: Collection[str] = ()) -> str:
    """Return a phrase that means ``obj`` and nothing else in ``scene``, such as "the red mug".

    The label alone if it is unique; with its colour if the plan tells colours apart; otherwise
    counted from the left, seen along ``yaw`` (of the robot's x axis, radians). ``absent`` objects
    are not counted.
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
    """Return how far to the right an object is when looking along ``yaw``, metres."""
    x, y, _ = obj.pose.position
    return float(x * math.sin(yaw) - y * math.cos(yaw))


def _color(scene: Scene, name: str) -> str | None:
    """Return the colour that the plan gives the object, if there is a plan."""
    planned = scene.plan.objects if scene.plan else ()
    return next((p.attributes.get("color") for p in planned if p.name == name), None)
