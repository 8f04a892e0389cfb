"""What a table is dressed with: candlesticks, a mirror on its foot, an ashtray."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of, hull_part
from ...build.forms import facing
from ...build.outlines import ellipse, rectangle, smooth
from ...build.recipes import open_vessel
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def candlestick(look: Look) -> Shape:
    """A candlestick with its candle: turned, slim or a saucer with a ring; or a candelabrum."""
    color = look.color("brass", "silver", "gold", "black", "copper", "white", "wooden")
    skin = look.surface(color, look.pick(["metal", "ceramic"]))
    wax = textures.speckles(
        look.rng, look.own_color("white", "ivory", "cream", "red", "navy", "sage"), 4, 32
    )
    h = look.between(0.1, 0.17)
    kind = look.pick(["turned", "turned", "saucer", "three"])
    tall = look.between(0.1, 0.16)

    def candle(x: float, z: float, long: float) -> list[tuple[Solid, textures.Tile]]:
        stick = lathe(
            [(0, 0), (0.0105, 0), (0.0098, long), (0.006, long + 0.002), (0, long + 0.001)], 18
        )
        wick = cylinder(0.0009, 0.009, 6).move(z=long)
        found = [(stick.move(x=x, z=z), wax), (wick.move(x=x, z=z), textures.plain((40, 34, 30)))]
        if lit:
            flame = lathe([(0, 0), (0.0045, 0.006), (0.003, 0.014), (0, 0.024)], 12).move(
                z=long + 0.006
            )
            found.append(
                (
                    flame.move(x=x, z=z),
                    textures.gradient((246, 150, 40), (254, 240, 150), look.rng),
                )
            )
        return found

    lit = look.chance(0.5)
    if kind == "saucer":
        dish = lathe(
            [
                (0, 0),
                (0.04, 0),
                (0.058, 0.012),
                (0.056, 0.014),
                (0.038, 0.004),
                (0.016, 0.004),
                (0.015, 0.03),
                (0.012, 0.03),
                (0.012, 0.02),
                (0, 0.02),
            ],
            30,
        )
        ear = torus(0.014, 0.0035, 18, 8).turn(0, np.pi / 2).move(x=0.066, z=0.0185)
        pieces = [(join([dish, ear]), skin), *candle(0, 0.02, tall * 0.8)]
        return shape(
            pieces,
            [
                hull_part(dish.vertices[dish.vertices[:, 2] < 0.015]),
                cylinder_part(0.015, 0.03),
                cylinder_part(0.0098, 0.8 * tall, (0, 0, 0.02)),
                hull_of(ear),
            ],
        )
    foot = lathe(
        [
            (0, 0),
            (0.042, 0),
            (0.042, 0.006),
            (0.02, 0.016),
            (0.008, 0.026),
            (0.0065, 0.4 * h),
            (0.013, 0.47 * h),
            (0.0065, 0.54 * h),
            (0.008, 0.86 * h),
            (0.018, 0.95 * h),
            (0.017, h),
            (0.0115, h),
            (0.0115, h - 0.01),
            (0, h - 0.01),
        ],
        28,
    )
    parts = [
        cylinder_part(0.042, 0.007),
        cylinder_part(0.01, 0.9 * h),
        cylinder_part(0.0175, 0.06 * h, (0, 0, 0.94 * h)),
    ]
    pieces = [(foot, skin), *candle(0, h - 0.01, tall)]
    parts.append(cylinder_part(0.0098, tall, (0, 0, h - 0.01)))
    if kind == "three":
        cup = lathe([(0, -0.008), (0.006, -0.006), (0.017, 0.004), (0.0165, 0.012), (0, 0.012)], 20)
        for s in (-1, 1):
            arm = tube(smooth([(0, 0, 0.5 * h), (s * 0.04, 0, 0.42 * h), (s * 0.062, 0, 0.6 * h),
                               (s * 0.062, 0, 0.84 * h)], 4), 0.0045, 8)  # fmt: skip
            holder = cup.move(x=s * 0.062, z=0.84 * h)
            pieces += [
                (join([arm, holder]), skin),
                *candle(s * 0.062, 0.84 * h + 0.012, 0.8 * tall),
            ]
            parts += [
                hull_of(arm),
                hull_of(holder),
                cylinder_part(0.0098, 0.8 * tall, (s * 0.062, 0, 0.84 * h + 0.012)),
            ]
    return shape(pieces, parts)


def standing_mirror(look: Look) -> Shape:
    """A make-up mirror on a foot: round, oval or square, tilted a little back."""
    w = look.between(0.075, 0.1)
    color = look.color("white", "gold", "silver", "black", "pink", "wooden", "copper")
    skin = look.surface(color, look.pick(["metal", "plastic"]))
    kind = look.pick(["round", "round", "oval", "square"])
    tall = {"round": w, "oval": 1.3 * w, "square": 1.2 * w}[kind]
    outline = (
        rectangle(2 * w, 2 * tall, 0.02, 5) if kind == "square" else ellipse(2 * w, 2 * tall, 40)
    )
    frame = prism(outline, 0, 0.012, 0.003)
    inner = prism(outline * 0.9, 0, 0.0006)
    lean = look.between(0.1, 0.25)
    middle = tall + look.between(0.05, 0.09)
    back = facing(frame).turn(0, -lean).move(z=middle)
    way = np.array([0, -np.cos(lean), np.sin(lean)])
    glass = facing(inner).turn(0, -lean).move(z=middle).move(*(0.0118 * way))
    image = textures.gradient((150, 172, 186), (232, 240, 244), look.rng, 3).astype(float)
    image = textures.fit(image.astype(np.uint8), 96, 96).copy()
    prints.polygon(image, [(0.2, 1), (0.55, 0), (0.68, 0), (0.33, 1)], (240, 246, 248))
    foot = cylinder(0.8 * w, 0.01, 34, bevel=0.003)
    post = cylinder(0.006, middle - tall + 0.03, 14).move(y=0.008, z=0.008)
    return shape([(join([back, foot, post]), skin), (glass, image)],
                 [cylinder_part(0.8 * w, 0.01), hull_of(post), hull_of(back)])  # fmt: skip


def ashtray(look: Look) -> Shape:
    """An ashtray with notches in its rim, empty or with a stub and ash."""
    r, h = look.between(0.05, 0.065), look.between(0.025, 0.035)
    color = look.color("clear", "green", "black", "white", "brown", "amber", "red")
    skin = look.surface(color, look.pick(["ceramic", "ceramic", "stone"]))
    sides = look.pick([30, 30, 6])
    body, parts = open_vessel([(0.92 * r, 0), (r, 0.3 * h), (r, h)], 0.011, 0.008, sides)
    notches = []
    for n in range(3 if sides == 6 else 4):
        a = 2 * np.pi * n / (3 if sides == 6 else 4) + 0.5
        slot = box(0.02, 0.009, 0.006).turn(2, a)
        notches.append(
            slot.move((r - 0.006) * np.cos(a) * 0.97, (r - 0.006) * np.sin(a) * 0.97, h - 0.0052)
        )
    pieces = [(body, skin), (join(notches), textures.plain(tint_color(color, 0.6)))]
    if look.chance(0.5):
        ash = ellipsoid(0.9 * r, 0.75 * r, 0.008, 16, 6).move(z=0.0085)
        stub = cylinder(0.0038, 0.03, 12).turn(1, np.pi / 2 - 0.25).move(-0.012, 0.005, 0.018)
        tile = textures.stack(
            (textures.plain((206, 140, 70)), 45), (textures.plain((244, 242, 236)), 55)
        )
        pieces += [(ash, textures.speckles(look.rng, (120, 118, 116), 26)), (stub, tile)]
    return shape(pieces, parts)


def sink(look: Look) -> Shape:
    """A washbasin that stands on a top, with a tap behind it."""
    r, h = look.between(0.17, 0.2), look.between(0.11, 0.13)
    side = [(0.62 * r, 0), (0.8 * r, 0.3 * h), (0.94 * r, 0.7 * h), (r, h)]
    basin, parts = open_vessel(side, 0.012, 0.014)
    reach = r + 0.035
    neck = [(0, reach, 0), (0, reach, 1.7 * h), (0, reach - 0.03, 1.95 * h),
            (0, reach - 0.1, 1.95 * h), (0, reach - 0.12, 1.8 * h)]  # fmt: skip
    tap = join([tube(neck, 0.012, 14), cylinder(0.026, 0.012, 20).move(y=reach),
                cylinder(0.016, 0.03, 16).move(y=reach, z=1.95 * h),
                box(0.05, 0.01, 0.008).move(y=reach, z=1.95 * h + 0.03)])  # fmt: skip
    drain = cylinder(0.022, 0.002, 20).move(z=0.0145)
    steel = textures.brushed_metal(look.rng, (196, 200, 204))
    glaze = look.surface(look.color("white", "white", "cream", "charcoal"), "ceramic")
    return shape(
        [(basin, glaze), (join([tap, drain]), steel)],
        [*parts, cylinder_part(0.026, 2 * h, at=(0, reach, 0))],
    )


CATEGORIES = (
    Category(
        "sink",
        sink,
        (0.37, 0.44, 0.27),
        4.0,
        ("washbasin", "wash basin", "hand basin", "bathroom sink", "kitchen sink", "vessel sink"),
        ("vanity",),
        ("container", "big"),
        ("white",),
    ),
    Category(
        "candlestick",
        candlestick,
        (0.126, 0.092, 0.245),
        0.4,
        ("candle holder", "candleholder", "candlestick holder", "candle stick"),
        ("dining", "living"),
        ("tall",),
        ("brass", "silver"),
    ),
    Category(
        "standing_mirror",
        standing_mirror,
        (0.175, 0.145, 0.26),
        0.6,
        (
            "makeup mirror",
            "table mirror",
            "vanity mirror",
            "stand mirror",
            "cosmetic mirror",
            "tabletop mirror",
            "desk mirror",
            "make up mirror",
            "shaving mirror",
        ),
        ("vanity",),
        ("tall", "big"),
        ("white", "gold"),
    ),
    Category(
        "ashtray",
        ashtray,
        (0.115, 0.115, 0.03),
        0.35,
        ("ash tray", "cigarette tray"),
        ("living",),
        ("round",),
        ("clear", "black"),
    ),
)
"""The module's categories."""
