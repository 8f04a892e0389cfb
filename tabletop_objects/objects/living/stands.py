"""Objects of the ``living`` theme: stands."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import wood
from ...kit.parts import box_part, hull_of, open_vessel
from ...kit.primitives import at_block, at_box
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import box, join, lathe
from ...kit.surfaces import Look, tint_color
from .models import _stone

WOODS = ("wooden", "brown", "tan")


@category("small_shelf", size=(0.35, 0.175, 0.245), mass=1.4, material="wood",
          aliases=("wooden shelf", "bookshelf", "desk shelf", "tabletop shelf", "shelf unit",
          "display shelf", "little shelf", "small wooden shelf"), themes=("living",),
          roles=("support", "big"), colors=("wooden", "brown"))  # fmt: skip
def small_shelf(look: Look) -> Shape:
    """A low shelf of boards between two sides, with nothing on its top board."""
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
    """A turned base with a shallow cup for a ball or an egg."""
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
    """A low square plinth with a base, a shaft and a top plate."""
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


@category("book_rest", size=(0.191, 0.165, 0.17), mass=0.4, material="wood", aliases=("quran stand",
          "rehal", "koran stand", "book stand with crossed boards", "folding book stand"),
          themes=("living",), colors=("brown",))  # fmt: skip
@from_pieces()
def book_rest(look: Look) -> Pieces:
    """A folding book stand: two crossed boards with perforated ends."""
    tile = wood(look, "brown", "wooden", "tan")
    one = at_box(0.19, 0.008, 0.2, (0, 0, -0.06))
    pair = [one.turn(0, a) for a in (0.6, -0.6)]
    low = min(float(p.bounds[0, 2]) for p in pair)
    return [(p.move(z=-low), tile) for p in pair]


BLACK = surfaces.plain((34, 34, 37))


@category("card_display", size=(0.086, 0.055, 0.13), mass=0.1, material="plastic",
          aliases=("sports card case", "graded card", "card slab"), themes=("living",),
          colors=("blue",))  # fmt: skip
@from_pieces()
def card_display(look: Look) -> Pieces:
    """A trading card in a clear case on a stand."""
    color = look.color("blue", "red", "green", "gold", "purple")
    image = prints.canvas(80, 112, color)
    prints.fill(image, 0.06, 0.04, 0.88, 0.92, (246, 240, 220))
    image[14:66, 10:70] = surfaces.fit(prints.artwork(look.rng, 60, 52), 52, 60)
    prints.lines(image, look.rng, (0.14, 0.66, 0.72, 0.24), 4, (110, 110, 116))
    tilt = -0.2
    case = at_block(0.086, 0.126, 0.008, 0.004).turn(0, np.pi / 2 + tilt)
    card = at_box(0.07, 0.1, 0.001, (0, 0, 0.0078)).turn(0, np.pi / 2 + tilt)
    low = float(case.bounds[0, 2])
    foot = at_box(0.06, 0.05, 0.01, (0, 0.012, 0))
    return [(case.move(z=-low + 0.004), surfaces.plain((206, 222, 230))), (foot, BLACK),
            (card.move(z=-low + 0.004), image)]  # fmt: skip
