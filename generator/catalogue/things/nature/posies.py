"""A bouquet out of its paper, for a vase: one bundle of stems with a dome of blossoms."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from ...build.category import Category
from ...build.collision import hull_part
from ...build.recipes import rod
from ...build.shape import Shape, shape
from ...build.solids import Solid, ellipsoid, join
from ...build.variants import at_rest
from ...surfaces import textures
from ...surfaces.look import Look

_COUNT = 11


def posy(look: Look) -> Shape:
    """A bundle of cut flowers lying, blossoms to the right."""
    color = look.color("red", "pink", "yellow", "white", "violet", "orange", "coral")
    other = look.own_color("white", "yellow", "violet", "pink", "cream")
    k = look.between(0.92, 1.08)
    stems: list[Solid] = []
    blooms: tuple[list[Solid], list[Solid]] = ([], [])
    leaves: list[Solid] = []
    for n in range(_COUNT):
        away, turn = np.sqrt((n + 0.5) / _COUNT), 2.4 * n
        way = np.array([0.0, np.cos(turn), np.sin(turn)])
        tip = way * 0.07 * away + [0.17 - 0.04 * away**2, 0, 0]
        stems.append(rod([np.array([-0.17, 0, 0]) - 0.024 * away * way,
                          way * 0.012 * away, tip], 0.0024, 6))  # fmt: skip
        bloom = join([ellipsoid(0.02, 0.046 * s, 0.046 * s, 8, 5).move(x=0.006 * m)
                      for m, s in enumerate((1.0, 0.78, 0.5))])  # fmt: skip
        heading = np.arctan2(way[1], way[2])
        blooms[n % 3 == 2].append(bloom.turn(1, 0.7 * away).turn(0, -heading).move(*tip))
        leaves.append(ellipsoid(0.06, 0.022, 0.005, 8, 4).turn(1, -0.3).turn(0, turn)
                      .move(*(0.55 * tip + [0.03, 0, 0])))  # fmt: skip
    pieces = [(join(stems), (84, 126, 64)), (join(leaves), (66, 110, 58))]
    skins = [(solid, textures.plain(tone)) for solid, tone in pieces]
    skins += [
        (join(some), textures.speckles(look.rng, tone, 8))
        for some, tone in zip(blooms, (color, other), strict=True)
    ]
    low = min(float(solid.bounds[0, 2]) for solid, _ in skins)
    made = [(solid.move(z=-low).scale(k, k, k), skin) for solid, skin in skins]
    points = np.concatenate([solid.vertices for solid, _ in made])
    cuts = (-1.0, 0.0, 0.09 * k, 1.0)
    near = [points[(points[:, 0] >= a - 0.02 * k) & (points[:, 0] <= b + 0.02 * k)]
            for a, b in pairwise(cuts)]  # fmt: skip
    return shape(made, [hull_part(p) for p in near])


CATEGORIES = (
    at_rest(Category("posy", posy, (0.36, 0.17, 0.17), 0.25, ("bundle of flowers",), ("living",),
             ("big",), ("red", "pink"), state="lying flat")),
)  # fmt: skip
"""The module's categories."""
