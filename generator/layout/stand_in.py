"""A plain solid for a thing the catalogue does not know: a box or a drum of the right size."""

from __future__ import annotations

import numpy as np

from ..catalogue.build.category import Category, model_of
from ..catalogue.build.collision import box_part, cylinder_part
from ..catalogue.build.shape import Shape, shape
from ..catalogue.build.solids import block, cylinder
from ..catalogue.surfaces.look import Look
from ..scene import Model, PlannedObject

SIZE = (0.1, 0.08, 0.09)
"""Extent in metres when nothing is known."""

_ROUND = ("pot", "jar", "can", "cup", "tube", "barrel", "roll", "wheel", "disc", "candle", "vase",
          "bottle", "ball", "coin", "pill", "round")  # fmt: skip
_PALETTE = ("gray", "tan", "teal", "navy", "terracotta", "olive", "mustard")


def stand_in(planned: PlannedObject, seed: int) -> Model:
    """Return a box, or a drum if its name sounds round, in the colour and material asked for."""
    words = (*planned.noun.split(), planned.attributes.get("state", ""))
    make = _drum if any(word in _ROUND for word in words) else _box
    size = planned.size or SIZE
    category = Category(
        "generic", make, size, float(np.clip(400 * np.prod(size), 0.02, 5.0)), friction=0.7
    )
    look = Look(np.random.default_rng([int(seed) & 0xFFFFFFFF, 5]), planned.attributes)
    return model_of(category, look, size)


def _box(look: Look) -> Shape:
    tile = look.surface(look.color(*_PALETTE))
    x, y, z = SIZE
    return shape([(block(x, y, z, 0.006, 0.003), tile)], [box_part(x, y, z)])


def _drum(look: Look) -> Shape:
    tile = look.surface(look.color(*_PALETTE))
    x, _, z = SIZE
    return shape([(cylinder(x / 2, z, 32, bevel=0.003), tile)], [cylinder_part(x / 2, z)])
