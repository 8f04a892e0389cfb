"""More altar things: horns, wheels, plates, signs, shrines."""

from __future__ import annotations

import itertools

import numpy as np

from ...build.category import Category
from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    metal,
    of,
    spindle,
    standing,
    wood,
)
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, rod, standing_plate
from ...build.solids import join, torus, tube
from ...surfaces import prints, textures
from ...surfaces.look import Look


def _horn(curve: float, r: float, palette: tuple[str, ...]) -> Drawing:
    """A horn lying: curved, widening towards its mouth."""

    def draw(look: Look) -> Pieces:
        color = look.color(*palette)
        path = smooth([(-0.13, -curve, 0.35 * r), (-0.06, 0.1 * curve, 0.5 * r),
                       (0.03, 0.3 * curve, 0.8 * r), (0.12, -0.9 * curve, r)], 8)  # fmt: skip
        radii = np.interp(np.linspace(0, 1, len(path)), [0, 0.4, 1], [0.2 * r, 0.48 * r, r])
        horn = tube(path, radii, 16)
        mouth = tube([path[-1] - 0.0006 * (path[-1] - path[-2]),
             path[-1] + 0.06 * (path[-1] - path[-2])],
                     0.84 * r, 16)  # fmt: skip
        band = tube(path[-6:-4], radii[-5] * 1.06, 16)
        tip = tube(path[:3], radii[:3] * 1.35, 12)
        tile = textures.gradient(tuple(0.55 * c for c in color), color, look.rng)  # type: ignore[arg-type]
        gilt = dye(look, "gold", "silver")
        return [(horn, tile), (mouth, textures.plain((46, 34, 26))), (band, gilt), (tip, gilt)]

    return draw


def _wheel(look: Look) -> Pieces:
    """A prayer wheel: a turned handle under an ornate drum with a tip."""
    gold = metal(look, "brass", "gold", "copper")
    base = disc(0.04, 0.014)
    stem = standing((0.008, 0.014), (0.01, 0.05), (0.007, 0.075), sides=14)
    drum = disc(0.036, 0.055, (0, 0, 0.075))
    band = disc(0.0366, 0.03, (0, 0, 0.0875))
    image = prints.canvas(192, 48, (150, 40, 44))
    for k in range(10):
        prints.write(image, "OM", 0.05 + 0.1 * k, 0.5, 0.4, (226, 190, 96), True)
    lid = standing((0.04, 0.13), (0.036, 0.136), (0.012, 0.146), (0.008, 0.156), (0.002, 0.166))
    weight = [
        ball(0.012, 0.012, 0.012, (0.06, 0, 0.1), 10),
        rod([(0.036, 0, 0.105), (0.055, 0, 0.1)], 0.0012, 6),
    ]
    return [(base, wood(look, "brown")), (stem, wood(look, "brown")), (drum, gold), (lid, gold),
            (band, image), (join(weight), gold)]  # fmt: skip


def _vajra(look: Look) -> Pieces:
    """A vajra lying: two crowns of bent prongs on a round grip."""
    tile = metal(look, "brass", "bronze", "gold")
    grip = spindle((-0.03, 0.009), (-0.022, 0.0115), (-0.014, 0.008), (-0.008, 0.011), (0, 0.013),
                  (0.008, 0.011), (0.014, 0.008), (0.022, 0.0115), (0.03, 0.009),
             z=0.016)  # fmt: skip
    prongs = []
    for s in (-1, 1):
        for a in np.arange(4) * np.pi / 2 + np.pi / 4:
            y, z = np.cos(a), np.sin(a)
            prongs.append(rod([(s * 0.028, 0.006 * y, 0.016 + 0.006 * z),
                               (s * 0.045, 0.019 * y, 0.016 + 0.019 * z),
                               (s * 0.066, 0.004 * y, 0.016 + 0.004 * z)], [0.004, 0.0035,
             0.0015], 6))  # fmt: skip
        prongs.append(rod([(s * 0.028, 0, 0.016), (s * 0.07, 0, 0.016)], [0.004, 0.001], 8))
    return [(grip, tile), (join(prongs), tile)]


def _thali(look: Look) -> Pieces:
    """A brass plate with an oil lamp, a bell, red powder and petals."""
    tile = metal(look, "brass", "silver", "copper")
    dish = standing((0.085, 0), (0.1, 0.012), (0.098, 0.012), (0.084, 0.004), sides=36)
    pots = [disc(0.018, 0.014, (x, y, 0.003), top=0.021) for x, y in ((-0.04, 0.03), (0.04, 0.03))]
    fill = [disc(0.018, 0.002, (x, y, 0.016)) for x, y in ((-0.04, 0.03), (0.04, 0.03))]
    lamp = disc(0.016, 0.012, (0, -0.04, 0.003), top=0.022)
    flame = ball(0.007, 0.007, 0.018, (0, -0.046, 0.024), 10)
    petals = [ball(0.018, 0.012, 0.006, (0.05 * np.cos(a), -0.02 + 0.03 * np.sin(a), 0.007), 8)
              for a in (0, 0.4, 3.0, 3.5)]  # fmt: skip
    return [(dish, tile), (join([*pots, lamp]), tile), (fill[0], dye(look, "crimson")),
            (fill[1], dye(look, "mustard")), (flame, textures.plain((250, 190, 70))),
            (join(petals), dye(look, "orange", "pink"))]  # fmt: skip


def _ankh(look: Look) -> Pieces:
    tile = metal(look, "gold", "silver", "bronze")
    a = np.linspace(-1.2, 2 * np.pi - 1.94, 26)
    ring = tube(
        np.column_stack([0.016 * np.cos(a), 0.032 + 0.022 * np.sin(a), 0 * a + 0.004]), 0.004, 8
    )
    return [(ring, tile), (at_box(0.009, 0.055, 0.007, (0, -0.017, 0)), tile),
            (at_box(0.05, 0.009, 0.007, (0, 0.006, 0)), tile)]  # fmt: skip


def _pentacle(look: Look) -> Pieces:
    """A five-pointed star in a ring, lying flat."""
    tile = metal(look, "silver", "gold", "bronze")
    a = np.pi / 2 + np.arange(6) * 4 * np.pi / 5
    star = [rod([(0.032 * np.cos(p), 0.032 * np.sin(p), 0.003),
                 (0.032 * np.cos(q), 0.032 * np.sin(q), 0.003)], 0.0018, 6)
            for p, q in itertools.pairwise(a)]  # fmt: skip
    return [(torus(0.034, 0.003, 40, 8).move(z=0.003), tile), (join(star), tile)]


def _wafer(look: Look) -> Pieces:
    color = look.color("ivory", "cream")
    top = textures.plain(color).repeat(8, 0).repeat(8, 1)
    dark = tuple(0.9 * c for c in color)
    prints.fill(top, 0.46, 0.2, 0.08, 0.6, dark)  # type: ignore[arg-type]
    prints.fill(top, 0.25, 0.38, 0.5, 0.08, dark)  # type: ignore[arg-type]
    return [(disc(0.017, 0.0022), top)]


def _shrine(look: Look) -> Pieces:
    """A golden box like a small house: gems, a cross on its roof."""
    gold = metal(look, "gold", "gold", "silver")
    body = at_box(0.12, 0.07, 0.06, (0, 0, 0.012))
    foot = at_block(0.13, 0.08, 0.012, 0.004)
    roof = standing_plate([(-0.04, 0.072), (0.04, 0.072), (0, 0.115)], 0.124).turn(2, np.pi / 2)
    gems = [[ball(0.012, 0.006, 0.014, (x, -0.036, 0.042), 10)] for x in (-0.04, 0, 0.04)]
    top = [at_box(0.005, 0.005, 0.028, (0, 0, 0.112)), at_box(0.018, 0.005, 0.005, (0, 0, 0.126))]
    tones = ("crimson", "blue", "green")
    return [(foot, gold), (body, gold), (roof, gold), (join(top), gold),
            *((g[0], dye(look, t)) for g, t in zip(gems, tones, strict=True))]  # fmt: skip


CATEGORIES = (
    Category("shofar", of(_horn(0.04, 0.022, ("beige", "brown", "tan")), 0.1, bodies=1),
             (0.26, 0.085, 0.042), 0.25, ("ram horn", "drinking horn", "viking horn", "war horn",
             "blowing horn", "hunting horn", "animal horn"), ("living",), (),
             ("beige", "brown"), state="lying"),
    Category("prayer_wheel", of(_wheel), (0.11, 0.08, 0.166), 0.3, ("tibetan prayer wheel",
             "mani wheel"), ("living",), (), ("brass",)),
    Category("vajra", of(_vajra, 0.1), (0.139, 0.0333, 0.0324), 0.15, ("dorje",), ("living",), (),
             ("brass",), state="lying"),
    Category("puja_thali", of(_thali), (0.2, 0.2, 0.033), 0.4, ("puja plate", "thali",
             "aarti plate",
             "puja tray"), ("living",), ("flat",), ("brass",)),
    Category("ankh", of(_ankh, 0.05), (0.05, 0.1, 0.008), 0.04, ("egyptian cross", "key of life"),
             ("living",), ("flat",), ("gold",), state="lying"),
    Category("pentacle", of(_pentacle), (0.074, 0.074, 0.006), 0.04, ("pentagram",
             "star in a circle"), ("living",), ("flat",), ("silver",), state="lying"),
    Category("communion_wafer", of(_wafer), (0.034, 0.034, 0.0022), 0.001, ("wafer host",
             "sacramental bread"), ("living",), ("flat", "edible"), ("ivory",)),
    Category("reliquary", of(_shrine), (0.13, 0.08, 0.14), 0.7, ("golden shrine", "relic box",
             "casket reliquary"), ("living",), (), ("gold",)),
)  # fmt: skip
"""The module's categories."""
