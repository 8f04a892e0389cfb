"""Objects of the ``travel`` theme: bottles."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.parts import hull_above, hull_of
from ...kit.primitives import limb
from ...kit.shapes import Shape, category, shape
from ...kit.solids import block, cylinder, join, lathe, torus
from ...kit.surfaces import RGB, Look, tint_color

STEEL: RGB = (188, 191, 196)


@category("canteen", size=(0.165, 0.053, 0.183), mass=0.9, material="fabric", assembled=True,
          aliases=("water canteen", "army canteen", "field flask", "military canteen",
          "camping canteen"), themes=("travel",), roles=("tall",), colors=("olive",))  # fmt: skip
def canteen(look: Look) -> Shape:
    """A round, upright water bottle covered in felt, with its cap on a chain."""
    k = look.between(0.92, 1.06)
    color = look.color("olive", "tan", "gray", "green")
    r = 0.075
    drum = lathe([(0, -0.026), (0.82 * r, -0.024), (r, -0.012), (r, 0.012), (0.82 * r, 0.024), (0,
                  0.026)], 34).turn(0, np.pi / 2).move(z=0.96 * r)  # fmt: skip
    low = block(0.07, 0.046, 0.006, 0.01)
    neck = cylinder(0.014, 0.025, 18).move(z=1.9 * r)
    cap = cylinder(0.018, 0.02, 20, bevel=0.002).move(z=1.9 * r + 0.022)
    strap = torus(1.02 * r, 0.007, 36, 6).turn(0, np.pi / 2).move(z=0.97 * r + 0.006)
    chain = limb([(0.018, 0, 1.9 * r + 0.03), (0.05, -0.012, 1.75 * r), (0.04, -0.026, 1.5 * r)],
                 [0.0018] * 3, 5)  # fmt: skip
    return shape([(join([drum, low]), surfaces.fabric(look.rng, color)),
                  (strap, surfaces.plain(tint_color(color, 0.65))),
                  (join([neck]), surfaces.brushed_metal(look.rng, STEEL)),
                  (join([cap, chain]), surfaces.plain((44, 42, 40)))],
                 [hull_above(drum, low), hull_of(neck, cap)]).scale(k)  # fmt: skip
