"""Bar things: snifters, growlers, spouts, measures, tap handles."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import facing
from ...build.outlines import smooth
from ...build.settled import limb, settle
from ...build.shape import Shape, shape
from ...build.solids import box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...build.variants import at_rest, keep_still
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def brandy_snifter(look: Look) -> Shape:
    """A brandy snifter: a wide belly on a short stem, brandy in it or empty."""
    k, color = look.between(0.9, 1.08), look.color("clear", "clear", "amber", "sky")
    side = [
        (0.034 * k, 0),
        (0.034 * k, 0.004),
        (0.005 * k, 0.012 * k),
        (0.0055 * k, 0.03 * k),
        (0.026 * k, 0.04 * k),
        (0.044 * k, 0.07 * k),
        (0.042 * k, 0.095 * k),
        (0.031 * k, 0.125 * k),
    ]
    inner = [
        (0.0295 * k, 0.125 * k),
        (0.0405 * k, 0.095 * k),
        (0.0425 * k, 0.07 * k),
        (0.024 * k, 0.043 * k),
        (0, 0.04 * k),
    ]
    body = lathe([(0, 0), *side, *inner], 32)
    drink = lathe(
        [(0, 0.041 * k), (0.024 * k, 0.044 * k), (0.0415 * k, 0.068 * k), (0, 0.069 * k)], 28
    )
    state = look.attributes.get("state", "")
    pieces = [(body, textures.plain(tint_color(color, 1.2)))]
    if state != "empty":
        pieces.append((drink, textures.plain((176, 92, 30))))
    return shape(
        pieces,
        [
            hull_of(lathe([(0, 0), side[0], side[1], (0, 0.004)], 16)),
            hull_of(lathe([(0, 0.004), side[2], side[3], (0, 0.03 * k)], 10)),
            hull_of(lathe([(0, 0.03 * k), *side[4:], (0, 0.125 * k)], 20)),
        ],
        0.55,
    )


def growler(look: Look) -> Shape:
    """A growler: a brown glass jug with a small ring handle at its neck and a label."""
    k, color = look.between(0.9, 1.06), look.color("brown", "brown", "amber", "green", "black")
    r, h = 0.058 * k, 0.26 * k
    body = lathe(
        [
            (0, 0),
            (0.96 * r, 0),
            (r, 0.02),
            (r, 0.58 * h),
            (0.7 * r, 0.76 * h),
            (0.34 * r, 0.84 * h),
            (0.3 * r, 0.95 * h),
            (0, 0.95 * h),
        ],
        32,
        v=[0, 0, 0.05, 0.55, 0.75, 0.85, 0.98, 1],
    )
    label = prints.canvas(256, 128, tint_color(color, 0.55))
    front = label[:, 84:172]
    prints.disc(front, 0.5, 0.5, 0.34, (244, 236, 214))
    prints.write(
        front, look.pick(["ALE", "IPA", "BREW", "STOUT"]), 0.5, 0.5, 0.24, (60, 40, 30), bold=True
    )
    dark = textures.plain(tint_color(color, 0.55))
    tile = textures.stack((dark, 0.1), (label, 0.42), (dark, 0.48), side=192)
    cap = cylinder(0.34 * r, 0.03 * k, 20).move(z=0.93 * h)
    ring = torus(0.018 * k, 0.0045 * k, 20, 8).turn(0, np.pi / 2).move(0.034 * k, 0, 0.83 * h)
    return shape(
        [(body, textures.fit(tile, 192, 256)), (cap, textures.plain((30, 30, 32))), (ring, dark)],
        [hull_of(body), hull_of(ring), hull_of(cap)],
    )


def _spout(kind: str) -> Callable[[Look], Shape]:
    """Return the shape function of a spout for a bottle, lying: a pourer or an aerator."""

    def make(look: Look) -> Shape:
        k, color = (
            look.between(0.9, 1.12),
            look.color("silver", "silver", "gold", "black")
            if kind == "pourer"
            else look.color("black", "silver", "gray"),
        )
        stopper = lathe(
            [
                (0, 0),
                (0.007, 0.002),
                (0.0085, 0.01),
                (0.0075, 0.014),
                (0.0095, 0.018),
                (0.0085, 0.023),
                (0.0105, 0.028),
                (0, 0.03),
            ],
            20,
        )
        if kind == "pourer":
            head = [lathe([(0, 0.029), (0.011, 0.029), (0.009, 0.036), (0.0045, 0.04), (0, 0.04)],
                          18), limb([(0, 0, 0.036), (0.002, 0, 0.06), (0.012, 0, 0.082),
                                     (0.02, 0, 0.092)], [0.0045, 0.0042, 0.0036, 0.0036], 10),
                    tube([(-0.006, 0, 0.03), (-0.009, 0, 0.055)], 0.0015, 6)]  # fmt: skip
        else:
            head = [
                lathe(
                    [
                        (0, 0.029),
                        (0.012, 0.029),
                        (0.018, 0.05),
                        (0.019, 0.08),
                        (0.014, 0.1),
                        (0.01, 0.104),
                        (0, 0.104),
                    ],
                    24,
                ),
                torus(0.019, 0.0014, 26, 5).move(z=0.07),
            ]
        laid = [
            (s.turn(1, np.pi / 2).move(-0.05, 0, 0), t)
            for s, t in (
                (stopper, textures.plain((34, 34, 36))),
                (join(head), look.surface(color, "steel" if sum(color) > 300 else "plastic")),
            )
        ]
        return settle(laid, 0.1, hulls=[[0], [1]]).scale(k)

    return make


def optic(look: Look) -> Shape:
    """A spirit measure: a clear chamber under a stopper, standing on its mouth."""
    k, color = look.between(0.9, 1.1), look.color("silver", "black", "white", "red")
    base = lathe(
        [(0, 0), (0.024, 0), (0.026, 0.01), (0.012, 0.016), (0.012, 0.026), (0, 0.026)], 22
    )
    glass = lathe(
        [(0, 0.024), (0.02, 0.024), (0.022, 0.03), (0.022, 0.07), (0.012, 0.078), (0, 0.078)], 24
    )
    top = lathe(
        [(0, 0.076), (0.014, 0.076), (0.014, 0.09), (0.009, 0.094), (0.0085, 0.115), (0, 0.116)], 18
    )
    arm = [
        tube([(s * 0.024, -0.002, 0.012), (s * 0.032, -0.03, 0.012)], 0.003, 7) for s in (-1, 1)
    ] + [tube([(-0.032, -0.03, 0.012), (0.032, -0.03, 0.012)], 0.003, 7)]
    badge = box(0.018, 0.001, 0.012).move(0, -0.0222, 0.045)
    image = prints.canvas(48, 32, (250, 250, 248))
    prints.write(image, "25ml", 0.5, 0.5, 0.5, (40, 50, 90), bold=True)
    made = [
        (join([base, top, *arm]), look.surface(color, "steel" if sum(color) > 300 else "plastic")),
        (glass, textures.gradient((206, 160, 84), (226, 236, 240), look.rng)),
        (badge, image),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(base.scale(k, k, k)), hull_of(made[1][0], top.scale(k, k, k))])


def tap_handle(look: Look) -> Shape:
    """A beer tap handle standing on a foot: a tall painted paddle with a badge."""
    k, color = (
        look.between(0.9, 1.08),
        look.color("wooden", "red", "green", "navy", "black", "gold"),
    )
    foot = lathe(
        [
            (0, 0),
            (0.032, 0),
            (0.032, 0.01),
            (0.012, 0.016),
            (0.01, 0.04),
            (0.014, 0.046),
            (0, 0.046),
        ],
        24,
    )
    side = smooth(
        [
            (-0.016, 0.0),
            (0.016, 0.0),
            (0.024, 0.09),
            (0.03, 0.16),
            (0.02, 0.195),
            (0, 0.2),
            (-0.02, 0.195),
            (-0.03, 0.16),
            (-0.024, 0.09),
            (-0.016, 0),
        ],
        3,
    )[:-1]
    paddle = facing(prism(side, -0.011, 0.011, 0.0)).move(z=0.044)
    badge = facing(cylinder(0.021, 0.003, 26)).move(0, -0.011, 0.195)
    image = prints.canvas(96, 96, (244, 236, 214))
    prints.disc(image, 0.5, 0.5, 0.46, color, 0.4)
    prints.write(
        image,
        look.pick(["ALE", "IPA", "BEER", "LAGER"]),
        0.5,
        0.5,
        0.24,
        tint_color(color, 0.6) if sum(color) > 200 else (40, 36, 30),
        bold=True,
    )
    made = [
        (foot, textures.brushed_metal(look.rng, (206, 172, 96))),
        (paddle, look.surface(color, "wood" if color[0] > 1.3 * color[2] else "plastic")),
        (badge, image),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0]), hull_of(made[1][0])])


def bombilla(look: Look) -> Shape:
    """A bombilla: a metal straw with a bulb filter at one end, lying."""
    k, color = look.between(0.88, 1.1), look.color("silver", "silver", "gold", "black")
    straw = tube(
        smooth([(-0.08, 0, 0.008), (0.03, 0, 0.006), (0.075, 0, 0.007), (0.095, 0, 0.011)], 4),
        [0.0032] * 13,
        10,
    )
    bulb = ellipsoid(0.032, 0.015, 0.015, 18, 10).move(-0.088, 0, 0.008)
    holes = [
        ellipsoid(0.0026, 0.0026, 0.0016, 6, 4).move(
            -0.097 + 0.006 * (n % 4), 0.004 * (n // 4 - 1), 0.0155 - 0.0004 * abs(n // 4 - 1)
        )
        for n in range(12)
    ]
    ring = [
        torus(0.0042, 0.0012, 14, 6).turn(1, np.pi / 2).move(x, 0, 0.0068)
        for x in (-0.02, -0.014, 0.04)
    ]
    return settle(
        [
            (join([straw, bulb]), look.surface(color, "steel")),
            (join(holes), textures.plain((50, 50, 54))),
            (join(ring), textures.plain((206, 172, 96))),
        ],
        0.04,
        hulls=[[0]],
    ).scale(k)


CATEGORIES = (
    Category("brandy_snifter", brandy_snifter, (0.0877, 0.0877, 0.125), 0.18,
             ("snifter", "cognac glass", "brandy glass", "balloon glass", "glass of brandy",
              "glass of cognac"), ("dining",), ("round",), ("clear",)),
    Category("growler", growler, (0.111, 0.111, 0.26), 1.6, ("beer growler", "beer jug bottle",
        "cider jug", "moonshine jug", "demijohn"), ("dining",), ("tall", "round"), ("brown",)),
    at_rest(Category("pourer", _spout("pourer"), (0.0942, 0.022, 0.0301), 0.03,
             ("pourer spout", "bottle pourer", "speed pourer", "pour spout", "liquor pourer"),
             ("dining",), (), ("silver",), state="lying")),
    Category("wine_aerator", _spout("aerator"), (0.109, 0.0426, 0.0381), 0.08,
             ("aerator", "wine pourer"),
             ("dining",), (), ("black",), state="lying"),
    Category("optic_measure", optic, (0.0695, 0.059, 0.116), 0.12, ("optic", "bar optic",
        "spirit optic"), ("dining",), ("tall",), ("silver",)),
    Category("tap_handle", tap_handle, (0.0641, 0.0641, 0.245), 0.3, ("keg tap handle",
        "beer tap handle", "beer tap", "beer pump handle", "pump clip"), ("dining",), ("tall",),
        ("wooden",)),
    Category("bombilla", keep_still(bombilla), (0.201, 0.0151, 0.0153), 0.03,
             ("mate straw", "yerba mate straw", "metal straw", "steel straw"), ("dining",), (),
             ("silver",), state="lying"),
)  # fmt: skip
"""The module's categories."""
