"""Objects of the ``living`` theme: stands."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.parts import box_part, hull_of, open_vessel
from ...kit.primitives import at_box
from ...kit.shapes import Shape, category, put_down, shape
from ...kit.solids import box, join, lathe
from ...kit.surfaces import Look, tint_color
from .models import _stone

WOODS = ("wooden", "brown", "tan")


@category("small_shelf", size=(0.35, 0.175, 0.245), mass=1.4, material="wood",
          aliases=("wooden shelf", "bookshelf", "desk shelf", "tabletop shelf", "shelf unit",
          "display shelf", "little shelf", "small wooden shelf"), themes=("living",),
          roles=("support", "big"), colors=("wooden", "brown"))  # fmt: skip
def small_shelf(look: Look) -> Shape:
    """A low shelf of boards between two sides, with a clear top."""
    wide, deep, high = look.between(0.32, 0.38), look.between(0.16, 0.19), look.between(0.22, 0.27)
    thick, tiers = 0.012, look.pick([2, 2, 3])
    levels = [0.03 + k * (high - thick - 0.03) / (tiers - 1) for k in range(tiers)]
    bodies = [(wide, deep, thick, (0.0, 0.0, z)) for z in levels]
    side = 0.5 * (wide - thick)
    bodies += [(thick, deep, high - thick, (s * side, 0.0, 0.0)) for s in (-1, 1)]
    tile = look.surface(look.color(*WOODS), "wood")
    boards = join([box(x, y, z).move(*at) for x, y, z, at in bodies])
    return shape([(boards, tile)], [box_part(x, y, z, at) for x, y, z, at in bodies])


@category("ball_stand", size=(0.06, 0.06, 0.03), mass=0.05, material="wood",
          aliases=("sphere stand", "crystal ball stand"), themes=("living",),
          roles=("support", "round"), colors=("wooden", "black"))  # fmt: skip
def ball_stand(look: Look) -> Shape:
    """A turned foot with a shallow cup for a ball or an egg."""
    r = look.between(0.02, 0.026)
    side = [(1.3 * r, 0.0), (1.25 * r, 0.006), (0.75 * r, 0.012), (1.1 * r, 0.03)]
    body, parts = open_vessel(side, 0.004, 0.012, 24)
    return shape([(body, look.surface(look.color(*WOODS, "black"), "wood"))], parts)


@category("cradle_stand", size=(0.145, 0.056, 0.06), mass=0.12, material="wood",
          aliases=("sword stand", "pen rest", "brush stand"), themes=("living",),
          roles=("support",), colors=("wooden", "black"))  # fmt: skip
def cradle_stand(look: Look) -> Shape:
    """A base with two forks that hold a long object."""
    long, thick = look.between(0.13, 0.16), 0.01
    bodies = [(long, 0.056, thick, (0.0, 0.0, 0.0))]
    bodies += [
        (0.012, 0.01, 0.05, (x * 0.36 * long, y * 0.02, thick)) for x in (-1, 1) for y in (-1, 1)
    ]
    bodies += [(0.012, 0.03, 0.025, (x * 0.36 * long, 0.0, thick)) for x in (-1, 1)]
    tile = look.surface(look.color(*WOODS, "black"), "wood")
    solid = join([box(x, y, z).move(*at) for x, y, z, at in bodies])
    return shape([(solid, tile)], [box_part(x, y, z, at) for x, y, z, at in bodies])


@category("plinth", size=(0.116, 0.116, 0.0615), mass=1.4, material="stone", aliases=("pedestal",
          "stone plinth", "display plinth", "marble plinth", "low plinth", "stone pedestal",
          "statue base", "museum plinth"), themes=("living",), roles=("support", "big"),
          colors=("white", "gray"))  # fmt: skip
def plinth(look: Look) -> Shape:
    """A low square plinth with a foot, a shaft and a top plate."""
    s, h = look.between(0.1, 0.14), look.between(0.045, 0.075)
    parts = [at_box(s, s, 0.2 * h), at_box(0.86 * s, 0.86 * s, 0.66 * h, (0, 0, 0.17 * h)),
             at_box(s, s, 0.2 * h, (0, 0, 0.8 * h))]  # fmt: skip
    return put_down([(join(parts), _stone(look, "white", "cream", "gray", "beige"))], *parts)


@category("cake_pillar", size=(0.0393, 0.0393, 0.0842), mass=0.03, material="plastic",
          aliases=("cake stand pillar", "cake column", "wedding cake pillar"), themes=("living",),
          roles=("tall",), colors=("white",))  # fmt: skip
def cake_pillar(look: Look) -> Shape:
    """A small column that supports a tier of a cake."""
    r, h = look.between(0.011, 0.015), look.between(0.07, 0.1)
    color = look.color("white", "ivory", "gold", "silver", "pink")
    body = lathe([(0, 0), (1.5 * r, 0), (1.5 * r, 0.06 * h), (1.1 * r, 0.1 * h),
                  (0.9 * r, 0.14 * h), (0.85 * r, 0.86 * h), (1.1 * r, 0.9 * h),
                  (1.5 * r, 0.94 * h), (1.5 * r, h), (0, h)], 28)  # fmt: skip
    ribs = [box(0.0014, 0.0014, 0.7 * h).move(0.88 * r * np.cos(a), 0.88 * r * np.sin(a), 0.15 * h)
            for a in np.arange(12) * 0.5236]  # fmt: skip
    tile = look.surface(color, "plastic")
    return shape(
        [(body, tile), (join(ribs), surfaces.plain(tint_color(color, 0.9)))], [hull_of(body)]
    )
