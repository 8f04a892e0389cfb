"""Objects of the ``pets`` theme: bowls."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.parts import cylinder_part, ring_parts
from ...kit.shapes import Shape, category, shape
from ...kit.solids import cylinder, ellipsoid, join, lathe
from ...kit.surfaces import Look, readable_on, tint_color


@category("pet_bowl", size=(0.175, 0.175, 0.053), mass=0.35, material="ceramic", hollow=True,
          aliases=("dog bowl", "cat bowl", "dog dish", "pet dish", "food bowl", "dog food",
          "cat food"), themes=("pets",), roles=("round", "container", "big"),
          colors=("red", "blue"), common=True)  # fmt: skip
def pet_bowl(look: Look) -> Shape:
    """A pet bowl, empty or with kibble, with a bone or paw print on its side."""
    r, h = look.between(0.075, 0.1), look.between(0.045, 0.06)
    color = look.color("red", "blue", "teal", "silver", "pink", "orange", "green")
    wall = 0.3 * r
    body = lathe(
        [(0, 0), (r, 0), (0.82 * r, h), (0.76 * r, h), (r - 1.3 * wall, 0.22 * h),
         (0, 0.2 * h)], 36,
        v=[0, 0.01, 0.8, 0.84, 0.95, 1],
    )  # fmt: skip
    print_ = prints.canvas(320, 96, color)
    ink = readable_on(color)
    for u in (0.5, 0.0, 0.25, 0.75, 0.999):
        v = 0.58
        prints.disc(print_, u, v + 0.05, 0.1, ink)
        for du, dv in ((-0.045, -0.06), (-0.016, -0.13), (0.016, -0.13), (0.045, -0.06)):
            prints.disc(print_, u + du, v + dv, 0.045, ink)
    pieces = [(body, print_)]
    if look.chance(0.6):
        brown = look.own_color("brown", "copper", "tan")
        food = [
            ellipsoid(0.017, 0.013, 0.011, 8, 5)
            .turn(2, look.between(0, 3))
            .move(a * np.cos(t), a * np.sin(t), 0.34 * h + look.between(0, 0.25) * h)
            for a, t in look.rng.uniform((0.0, 0), (0.52 * r, 6.3), (38, 2))
        ]
        bed = cylinder(0.6 * r, 0.2 * h, 24).move(z=0.18 * h)
        pieces.append((join([bed, *food]), surfaces.spots(look.rng, brown, tint_color(brown, 0.6))))
    ring = ring_parts(
        [(r, 0), (0.82 * r, h)], [(0.76 * r, h), (0.61 * r, 0.22 * h), (0.6 * r, 0)], 10
    )
    return shape(pieces, [cylinder_part(0.62 * r, 0.2 * h), *ring])
