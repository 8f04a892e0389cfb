"""A weighted foot for what would not stand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..scene import ConvexPart, Object
from .inertia import MassProperties, box_mass, join_bodies
from .parts import lowest

_FOOT = 0.25, 0.75  # the least and the largest share of its weight that a thing has in its foot


def on_foot(thing: Object) -> Object:
    """Return the object with a flat box under it that has a share of its weight.

    The foot spans the object's box and is a thirtieth of its height, 2 mm at least. It has a
    quarter of the weight, or as much (up to three) as draws the whole's centre down to a third of
    the height; its own lies so that the whole's is over the middle, as far as the foot reaches.
    """
    height = float(thing.scale[2])
    size = np.array([*thing.scale[:2], max(2e-3, height / 30)])
    middle = np.array([0.0, 0.0, lowest(thing) + size[2] / 2])
    rise = float(thing.com[2] - middle[2])
    needed = 1 - (height / 3 - size[2] / 2) / rise if rise > 0 else 0.0
    share = float(np.clip(needed, *_FOOT))
    aside = np.clip((1 - 1 / share) * (thing.com * [1, 1, 0]), -size / 2, size / 2)
    rest = MassProperties((1 - share) * thing.mass, thing.com, (1 - share) * thing.inertia)
    whole = join_bodies((rest, box_mass(share * thing.mass, middle + aside, size)))
    corners = middle + size * (np.indices((2, 2, 2)).reshape(3, 8).T - 0.5)
    parts = (*thing.parts, ConvexPart(corners, "box"))
    return replace(thing, parts=parts, com=whole.com, inertia=whole.inertia)
