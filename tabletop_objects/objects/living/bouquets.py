"""Objects of the ``living`` theme: bouquets."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from ...kit import surfaces
from ...kit.outlines import ellipse
from ...kit.parts import flat_foot, hull_of, hull_part
from ...kit.primitives import blade, limb, rod
from ...kit.shapes import Pieces, Shape, at_rest, category, keep_still, put_down, settle, shape
from ...kit.solids import Solid, ellipsoid, join, loft, torus, tube
from ...kit.surfaces import RGB, Look, tint_color
from .flowers import layered_head

GREEN: RGB = (84, 126, 64)


@category("corsage", size=(0.077, 0.095, 0.0206), mass=0.015, material="food", assembled=True,
          aliases=("buttonhole flower", "wrist corsage"), themes=("living",),
          colors=("white", "pink"), state="lying flat")  # fmt: skip
def corsage(look: Look) -> Shape:
    """A corsage: a bloom with leaves and a ribbon bow."""
    k = look.between(0.9, 1.1)
    color = look.color("white", "pink", "red", "lavender")
    head = layered_head([(8, 0.024, 0.02, 0.2, 0), (7, 0.02, 0.017, 0.6, 0.002),
                    (5, 0.014, 0.012, 1.0, 0.004)], 0.005, None, 0.05)(look, color)  # fmt: skip
    leaves = [blade([(0, 0, 0.002), (0.02 * np.cos(a), 0.02 * np.sin(a), 0.006),
                     (0.046 * np.cos(a), 0.046 * np.sin(a), 0.002)], 0.02, thick=0.15)
              for a in (0.4, 1.3, 2.4)]  # fmt: skip
    bow = [blade([(0, -0.01, 0.004), (s * 0.02, -0.03, 0.009), (s * 0.03, -0.05, 0.002)], 0.016,
                 thick=0.25) for s in (-1, 1)]  # fmt: skip
    bloom = [(s.move(z=0.006), t) for s, t in head]
    sheen = surfaces.plain(look.own_color("white", "pink", "silver", "gold"))
    pieces: Pieces = [(join(leaves), surfaces.plain(GREEN)), (join(bow), sheen), *bloom]
    return put_down(pieces, join([*leaves, *bow]), join([s for s, _ in bloom]), factor=k)


@category("bouquet", size=(0.377, 0.153, 0.0912), mass=0.3, material="paper", assembled=True,
          aliases=("bouquet of flowers", "bunch of flowers", "flower bouquet", "bouquet of roses",
          "bunch of roses", "rose bouquet", "nosegay", "posy of flowers", "bunch of tulips",
          "bunch of daffodils", "bunch of lavender", "paper flower", "dead flower", "fabric flower",
          "silk flower", "dried flower bunch"), themes=("living", "dining"), roles=("big",),
          colors=("red", "pink"), state="lying flat")  # fmt: skip
def bouquet(look: Look) -> Shape:
    """A bunch of flowers in wrapping paper with a ribbon, lying with its blooms on the left."""
    color = look.color("red", "pink", "yellow", "white", "violet", "orange", "coral")
    other = look.own_color("white", "yellow", "violet", "pink", "cream")
    paper = surfaces.speckles(
        look.rng, look.own_color("tan", "white", "pink", "sage", "sky"), 6, 32
    )
    k = look.between(0.9, 1.1)
    cone = loft(np.stack([np.column_stack([np.full(24, x), ellipse(1, 1, 24)[:, 0] * w,
                                           ellipse(1, 1, 24)[:, 1] * t + t / 2]) for x, w,
                          t in ((0.16, 0.03, 0.024), (0.1, 0.036, 0.026), (0.0, 0.1, 0.05),
                                (-0.06, 0.15, 0.07))]) * k, ellipse(1, 1, 24))  # fmt: skip
    ribbon = torus(0.017 * k, 0.004 * k, 20, 6).scale(1.05, 0.8, 2.2).turn(1, np.pi / 2)
    ribbon = ribbon.move(x=0.1 * k, z=0.0135 * k)
    stems = [tube([(0.14 * k, y * k, 0.012 * k), (0.22 * k, 1.7 * y * k, 0.009 * k)], 0.0028 * k, 6)
             for y in (-0.008, -0.003, 0.002, 0.007, 0.011)]  # fmt: skip
    blooms: dict[bool, list[Solid]] = {True: [], False: []}
    leaves = []
    for n in range(13):
        u, v = 2.4 * n, np.sqrt((n + 0.5) / 13)
        y, z = 0.066 * v * np.cos(u) * k, (0.036 + 0.028 * v * np.sin(u)) * k
        x = (-0.075 - 0.05 * (1 - v**2)) * k
        rose = join([ellipsoid(0.044 * s * k, 0.044 * s * k, 0.022 * k, 8, 4).move(z=0.006 * m * k)
                     for m, s in enumerate((1.0, 0.78, 0.5))])  # fmt: skip
        rose = rose.turn(1, -np.pi / 2 + 0.35).move(x, y, z + 0.012 * k)
        blooms[n % 3 != 0].append(rose)
        if n % 2:
            leaves.append(blade([(x + 0.02, y, z), (x - 0.005, 1.2 * y, z + 0.01),
                                 (x - 0.03, 1.4 * y, z + 0.012)], 0.02 * k))  # fmt: skip
    every = join([*blooms[True], *blooms[False]])
    low = -float(every.bounds[0, 2])
    up = max(low, 0.0)
    green = surfaces.plain((76, 130, 62))
    return shape(
        [
            (cone, paper),
            (join([ribbon]), surfaces.plain(look.own_color("red", "white", "gold", "pink"))),
            (join(stems), green),
            (
                join(blooms[True]).move(z=up),
                surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.25),
            ),
            (
                join(blooms[False]).move(z=up),
                surfaces.spots(look.rng, other, tint_color(other, 0.8), 0.25),
            ),
            (join(leaves).move(z=up), green),
        ],
        [flat_foot(cone.vertices, 0.12), hull_of(every.move(z=up)), hull_of(*stems)],
    )


_COUNT = 11


@category("posy", size=(0.36, 0.17, 0.17), mass=0.25, material="food",
          aliases=("bundle of flowers",), themes=("living",), roles=("big",),
          colors=("red", "pink"), state="lying flat")  # fmt: skip
@at_rest
def posy(look: Look) -> Shape:
    """A bundle of cut flowers, lying with its blossoms on the right."""
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
    skins = [(solid, surfaces.plain(tone)) for solid, tone in pieces]
    skins += [(join(some), surfaces.speckles(look.rng, tone, 8)) for some,
              tone in zip(blooms, (color, other), strict=True)]  # fmt: skip
    low = min(float(solid.bounds[0, 2]) for solid, _ in skins)
    made = [(solid.move(z=-low).scale(k, k, k), skin) for solid, skin in skins]
    points = np.concatenate([solid.vertices for solid, _ in made])
    cuts = (-1.0, 0.0, 0.09 * k, 1.0)
    near = [points[(points[:, 0] >= a - 0.02 * k) & (points[:, 0] <= b + 0.02 * k)]
            for a, b in pairwise(cuts)]  # fmt: skip
    return shape(made, [hull_part(p) for p in near])


GOLD: RGB = (206, 172, 90)


@category("boutonniere", size=(0.0847, 0.0829, 0.0289), mass=0.015, material="food", assembled=True,
          aliases=("buttonhole", "lapel flower", "groom's buttonhole"), themes=("living",),
          colors=("red", "white"), state="lying")  # fmt: skip
@keep_still
def boutonniere(look: Look) -> Shape:
    """A boutonniere lying flat: a rose, two leaves and small white buds on a wrapped stem."""
    k, color = (look.between(0.88, 1.15), look.color("red", "white", "pink", "cream", "coral",
                                                     "violet"))  # fmt: skip
    rose = [
        ellipsoid(0.03 - 0.004 * n, 0.03 - 0.004 * n, 0.014, 12, 7)
        .turn(1, 0.2 * np.cos(2 * n))
        .turn(0, 0.2 * np.sin(2 * n))
        .move(-0.02 + 0.001 * np.cos(2.4 * n), 0.001 * np.sin(2.4 * n), 0.012 + 0.0028 * n)
        for n in range(5)
    ]
    petals = [
        ellipsoid(0.02, 0.017, 0.009, 9, 6)
        .turn(1, -0.7)
        .move(0.012, 0, 0.013)
        .turn(2, a)
        .move(x=-0.02)
        for a in np.arange(6) * 1.05
    ]
    leaves = [blade([(-0.012, 0.004 * s, 0.008), (-0.004, 0.024 * s, 0.01),
                     (-0.02, 0.04 * s, 0.004)], 0.02, thick=0.15) for s in (-1, 1)]  # fmt: skip
    buds = [ellipsoid(0.007, 0.007, 0.007, 8, 6).move(-0.036 + 0.006 * n, 0.026 * np.cos(1.9 * n),
                                                      0.014 + 0.004 * np.sin(n))
            for n in range(7)]  # fmt: skip
    stem = limb(
        [(-0.012, 0, 0.008), (0.02, 0, 0.006), (0.042, 0.002, 0.006)], [0.005, 0.0055, 0.004], 10
    )
    pin = tube([(0.004, -0.016, 0.01), (0.016, 0.014, 0.012)], 0.0007, 5)
    pearl = ellipsoid(0.005, 0.005, 0.005, 10, 7).move(0.003, -0.018, 0.01)
    return settle([(join([*rose, *petals]), surfaces.speckles(look.rng, color, 14)),
                   (join(leaves), surfaces.leaf(look.rng, (76, 130, 70))),
                   (join([*buds, pearl]), surfaces.plain((250, 248, 240))),
                   (stem, surfaces.stripes([(240, 234, 216), (214, 204, 180)], 10, upright=True)),
                   (pin, surfaces.plain(GOLD))], 0.04, hulls=[[0], [3]]).scale(k)  # fmt: skip
