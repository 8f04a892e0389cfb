"""Weddings: figures, flowers to pin on, garters, veils."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of, ring_parts
from ...build.forms import blade, spread
from ...build.settled import limb, settle
from ...build.shape import Shape, shape
from ...build.solids import box, ellipsoid, join, lathe, tube
from ...build.variants import keep_still
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

GOLD: RGB = (206, 172, 90)


def boutonniere(look: Look) -> Shape:
    """A flower to pin on: a rose, two leaves and small white buds on a wrapped stem, lying."""
    k, color = (
        look.between(0.88, 1.15),
        look.color("red", "white", "pink", "cream", "coral", "violet"),
    )
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
    leaves = [
        blade(
            [(-0.012, 0.004 * s, 0.008), (-0.004, 0.024 * s, 0.01), (-0.02, 0.04 * s, 0.004)],
            0.02,
            thick=0.15,
        )
        for s in (-1, 1)
    ]
    buds = [
        ellipsoid(0.007, 0.007, 0.007, 8, 6).move(
            -0.036 + 0.006 * n, 0.026 * np.cos(1.9 * n), 0.014 + 0.004 * np.sin(n)
        )
        for n in range(7)
    ]
    stem = limb(
        [(-0.012, 0, 0.008), (0.02, 0, 0.006), (0.042, 0.002, 0.006)], [0.005, 0.0055, 0.004], 10
    )
    pin = tube([(0.004, -0.016, 0.01), (0.016, 0.014, 0.012)], 0.0007, 5)
    pearl = ellipsoid(0.005, 0.005, 0.005, 10, 7).move(0.003, -0.018, 0.01)
    return settle(
        [
            (join([*rose, *petals]), textures.speckles(look.rng, color, 14)),
            (join(leaves), textures.leaf(look.rng, (76, 130, 70))),
            (join([*buds, pearl]), textures.plain((250, 248, 240))),
            (stem, textures.stripes([(240, 234, 216), (214, 204, 180)], 10, upright=True)),
            (pin, textures.plain(GOLD)),
        ],
        0.04,
        hulls=[[0], [3]],
    ).scale(k)


def garter(look: Look) -> Shape:
    """A garter: a ring of gathered lace and satin with a little bow, lying."""
    k, color = look.between(0.9, 1.1), look.color("sky", "white", "blue", "pink", "red", "ivory")
    a = np.linspace(0, 2 * np.pi, 121)[:-1]
    wave = 0.006 * np.sin(30 * a)
    rows = []
    for r0, z, amount in ((0.058, 0.0015, 1.0), (0.054, 0.012, 0.25), (0.058, 0.024, 1.0)):
        rows.append(
            np.column_stack(
                [
                    (r0 + amount * wave) * np.cos(a),
                    (r0 + amount * wave) * np.sin(a),
                    np.full(120, z),
                ]
            )
        )
    lace = [tube(rows[0], 0.0014, 5, loop=True), tube(rows[2], 0.0014, 5, loop=True)]
    band = lathe(
        [(0.053, 0.002), (0.057, 0.002), (0.059, 0.012), (0.057, 0.0235), (0.053, 0.0235)],
        60,
        loop=True,
    )
    bow = [
        ellipsoid(0.022, 0.008, 0.014, 12, 7).turn(1, 0.3 * s).move(0.012 * s, -0.062, 0.013)
        for s in (-1, 1)
    ] + [ellipsoid(0.008, 0.009, 0.009, 9, 6).move(0, -0.064, 0.013)]
    made = [
        (band, textures.stripes([color, tint_color(color, 1.25)], 40, upright=True, side=160)),
        (join(lace), textures.plain((250, 250, 250))),
        (join(bow), textures.plain(tint_color(color, 0.8))),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made,
        ring_parts(
            [(0.0585 * k, 0.0002), (0.0585 * k, 0.024 * k)],
            [(0.053 * k, 0.024 * k), (0.053 * k, 0.0002)],
            12,
        ),
    )


def veil(look: Look) -> Shape:
    """A bridal veil laid down: soft folds of white tulle gathered at a comb."""
    k, color = look.between(0.85, 1.05), look.color("white", "ivory", "cream")
    phase = look.between(0, 6)
    n = 28
    u, v = np.meshgrid(np.linspace(-1, 1, n), np.linspace(0, 1, n))
    x, y = u * (0.03 + 0.13 * v) * k, (0.12 - 0.26 * v) * k
    z = 0.002 + (0.006 + 0.012 * v) * (0.5 + 0.5 * np.sin(9 * u + 1.6 * np.sin(3 * v) + phase))
    sheet = spread(np.stack([x[::-1], y[::-1], z[::-1]], -1), 0.0012)
    comb = box(0.07 * k, 0.012 * k, 0.008).move(y=0.122 * k)
    pearls = [
        ellipsoid(0.008, 0.008, 0.008, 9, 6).move(i * 0.011 * k, 0.122 * k, 0.011)
        for i in range(-3, 4)
    ]
    tulle = textures.grid((226, 226, 230), color, 40, 40)
    return shape(
        [
            (sheet, tulle),
            (comb, textures.plain(GOLD)),
            (join(pearls), textures.plain((250, 248, 240))),
        ],
        [hull_of(sheet), hull_of(comb)],
    )


def cake_pillar(look: Look) -> Shape:
    """A small column that carries a tier of a cake."""
    r, h = look.between(0.011, 0.015), look.between(0.07, 0.1)
    color = look.color("white", "ivory", "gold", "silver", "pink")
    body = lathe(
        [
            (0, 0),
            (1.5 * r, 0),
            (1.5 * r, 0.06 * h),
            (1.1 * r, 0.1 * h),
            (0.9 * r, 0.14 * h),
            (0.85 * r, 0.86 * h),
            (1.1 * r, 0.9 * h),
            (1.5 * r, 0.94 * h),
            (1.5 * r, h),
            (0, h),
        ],
        28,
    )
    ribs = [
        box(0.0014, 0.0014, 0.7 * h).move(0.88 * r * np.cos(a), 0.88 * r * np.sin(a), 0.15 * h)
        for a in np.arange(12) * 0.5236
    ]
    tile = look.surface(color, "plastic")
    return shape(
        [(body, tile), (join(ribs), textures.plain(tint_color(color, 0.9)))], [hull_of(body)]
    )


_W, _E = ("living",), ("living",)

CATEGORIES = (
    Category("boutonniere", keep_still(boutonniere), (0.0847, 0.0829, 0.0289), 0.015,
             ("buttonhole", "lapel flower",
              "groom's buttonhole"), _W, (), ("red", "white"), state="lying"),
    Category("garter", garter, (0.13, 0.133, 0.0251), 0.02, ("wedding garter", "bridal garter",
        "lace garter"), _W, (), ("sky", "white"), state="lying"),
    Category("veil", veil, (0.309, 0.259, 0.0212), 0.06, ("bridal veil", "wedding veil",
                                                          "lace veil"), _W, ("big",), ("white",),
                                                          state="lying"),
    Category("cake_pillar", cake_pillar, (0.0393, 0.0393, 0.0842), 0.03,
             ("cake stand pillar", "cake column", "wedding cake pillar"), _W, ("tall",),
             ("white",)),
)  # fmt: skip
"""The module's categories."""
