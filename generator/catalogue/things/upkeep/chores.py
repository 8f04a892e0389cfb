"""What cleans, dries and feeds: pegs, hangers, buckets, brushes, pet things."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_part
from ...build.outlines import rectangle, smooth
from ...build.recipes import ball, open_vessel, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, loft, prism, torus
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

TONES = ("red", "blue", "green", "yellow", "teal", "pink", "gray", "orange")
STEEL = (196, 200, 206)


def bucket(look: Look) -> Shape:
    """A bucket with its bail hanging down at the back."""
    r, h = look.between(0.075, 0.095), look.between(0.13, 0.16)
    color = look.color(*TONES, "silver")
    body, parts = open_vessel([(0.72 * r, 0), (0.86 * r, 0.5 * h), (r, h)], 0.0035, 0.004)
    rim = torus(r, 0.0042, 32, 8).move(z=h - 0.003)
    lugs = [ball(0.014, 0.02, 0.02, (s * 0.97 * r, 0, h - 0.016), 10) for s in (-1, 1)]
    bail = rod([(-r, 0, h - 0.014), (-0.8 * r, 0.9 * r, h - 0.045), (0, 1.13 * r, h - 0.06),
                (0.8 * r, 0.9 * r, h - 0.045), (r, 0, h - 0.014)], 0.0026, 7)  # fmt: skip
    return shape(
        [
            (body, look.surface(color, "plastic")),
            (join([rim, *lugs]), textures.plain(tint_color(color, 0.8))),
            (bail, textures.plain((206, 208, 212))),
        ],
        parts,
    )


def laundry_basket(look: Look) -> Shape:
    """A small oblong laundry basket with slits in its walls."""
    color = look.color("white", "blue", "teal", "gray", "pink", "green")
    x, y, h = look.between(0.27, 0.32), look.between(0.19, 0.22), look.between(0.13, 0.16)
    outline = rectangle(1, 1, 0.18, 5)
    t = 0.005
    levels = [(x - 0.03, y - 0.03, 0), (x, y, h), (x - 2 * t, y - 2 * t, h),
              (x - 0.03 - 2 * t, y - 0.03 - 2 * t, t)]  # fmt: skip
    body = loft(np.stack([np.column_stack([outline * [a, b], np.full(len(outline), z)])
                          for a, b, z in levels]), outline)  # fmt: skip
    slits = [
        box(0.012, 0.004, 0.6 * h).turn(0, s * 0.055).move(0.028 * n, s * (y / 2 - 0.009), 0.2 * h)
        for n in range(-4, 5)
        for s in (-1, 1)
    ]
    rim = [np.column_stack([outline * [x + 0.012, y + 0.012], np.full(len(outline), z)])
           for z in (h - 0.012, h - 0.002)]  # fmt: skip
    inner = [np.column_stack([outline * [x - 0.006, y - 0.006], np.full(len(outline), z)])
             for z in (h - 0.002, h - 0.012)]  # fmt: skip
    lip = loft(np.stack([*rim, *inner]), None, loop=True)
    walls = [box_part(x - 0.04, y - 0.04, t)]
    for s in (-1, 1):
        for wide, deep, along in ((x, y, 0), (y, x, 1)):
            low, top = deep / 2 - 0.015, deep / 2
            corners = [
                (u * (wide / 2 - (0.015 if z == 0 else 0) - 0.012), s * (v - k * t * 1.2), z)
                for u in (-1, 1)
                for z, v in ((0, low), (h, top))
                for k in (0, 1)
            ]
            pts = np.array(corners)
            walls.append(hull_part(pts if along == 0 else pts[:, [1, 0, 2]]))
    dark = textures.plain(tint_color(color, 0.45))
    return shape([(body, look.surface(color, "plastic")), (join(slits), dark),
                  (lip, textures.plain(tint_color(color, 0.9)))], walls)  # fmt: skip


def dustpan(look: Look) -> Shape:
    """A dustpan lying, its handle to the right."""
    color = look.color(*TONES)
    floor = prism(
        [(-0.12, -0.1), (0.05, -0.075), (0.065, 0), (0.05, 0.075), (-0.12, 0.1)], 0, 0.004
    )
    walls = [
        prism([(-0.12, 0.002), (0.05, 0.002), (0.05, 0.045), (-0.1, 0.012)], -0.002, 0.002)
        .turn(0, np.pi / 2)
        .turn(2, -s * 0.146)
        .move(0.005, s * 0.083, 0)
        for s in (-1, 1)
    ]
    back = box(0.005, 0.152, 0.045).move(0.052)
    grip = rod([(0.05, 0, 0.03), (0.1, 0, 0.024), (0.2, 0, 0.02)], [0.014, 0.0115, 0.013], 12)
    lip = box(0.008, 0.196, 0.003).move(-0.118)
    return put_down([(join([floor, *walls, back, grip]), look.surface(color, "plastic")),
                    (lip, textures.plain((60, 60, 64)))], floor, back, grip,
                   factor=look.between(0.85, 1.05))  # fmt: skip


def scrub_brush(look: Look) -> Shape:
    """A scrubbing brush lying on its bristles."""
    color = look.color("wooden", "red", "blue", "green", "white", "teal")
    x, y = look.between(0.13, 0.17), look.between(0.05, 0.06)
    top = block(x, y, 0.02, 0.025, 0.005).move(z=0.022)
    tufts = [cylinder(0.0042, 0.024, 6, top=0.0034).move((i - 5) * x / 12.5, (j - 1.5) * y / 5)
             for i in range(11) for j in range(4)]  # fmt: skip
    bristle = textures.plain(look.pick([(240, 236, 224), (214, 186, 140), (70, 110, 180)]))
    return put_down([(top, look.surface(color, "wood")), (join(tufts), bristle)], top, join(tufts))


def duster(look: Look) -> Shape:
    """A feather duster lying."""
    color = look.color("pink", "blue", "purple", "yellow", "green", "gray", "orange")
    grip = straight((0.02, 0, 0.012), (0.17, 0, 0.009), [0.008, 0.0085], 10)
    puffs: list[Solid] = [ball(0.15, 0.075, 0.07, (-0.05, 0, 0.034), 16)]
    for k in range(24):
        t = k / 23
        a = 2.4 * k
        r = 0.036 * np.sin(np.pi * (0.15 + 0.75 * t))
        puffs.append(
            ball(
                0.045,
                0.022,
                0.02,
                (0.02 - 0.145 * t, r * np.cos(a), 0.034 + 0.95 * r * np.sin(a)),
                8,
            )
        )
    fluff = textures.scratches(look.rng, color, tint_color(color, 0.75), 140)
    return put_down([(join(puffs), fluff), (grip, textures.plain(look.own_color("white", "black",
                    "wooden")))], join(puffs), grip, factor=look.between(0.9, 1.15))  # fmt: skip


def clothes_peg(look: Look) -> Shape:
    """A clothes peg lying on its side: two legs and a spring."""
    color = look.color("wooden", "wooden", *TONES)
    half = [(-0.036, 0.0006), (0.014, 0.0006), (0.038, 0.006), (0.038, 0.0095), (0.004, 0.0065),
            (-0.036, 0.0055)]  # fmt: skip
    legs = [prism(half, 0, 0.009), prism([(x, -y) for x, y in half][::-1], 0, 0.009)]
    spring = [torus(0.004, 0.0011, 14, 6).move(0.006, 0, z) for z in (0.0022, 0.0045, 0.0068)]
    arms = [
        straight((0.008, s * 0.004, 0.0045), (-0.008, s * 0.0065, 0.0045), 0.001, 6)
        for s in (-1, 1)
    ]
    return put_down([(join(legs), look.surface(color, "wood" if color[0] > 180 and color[2] < 120
                    else "plastic")), (join([*spring, *arms]), textures.plain(STEEL))], join(legs),
                   factor=look.between(0.85, 1.2))  # fmt: skip


def hanger(look: Look) -> Shape:
    """A clothes hanger lying flat."""
    color = look.color("wooden", "black", "white", "pink", "brown", "blue")
    k = look.between(0.75, 0.95)
    wood = look.surface(color, "wood")
    arms = [rod([(0, 0.03, 0.008), (s * 0.08, 0.012, 0.008), (s * 0.2, -0.045, 0.008)],
                [0.0085, 0.008, 0.007], 10) for s in (-1, 1)]  # fmt: skip
    bar = straight((-0.19, -0.042, 0.008), (0.19, -0.042, 0.008), 0.004, 8)
    hook = rod([(0, 0.03, 0.008), (0, 0.06, 0.006), (0.024, 0.085, 0.003), (0.004, 0.112, 0.003),
                (-0.022, 0.092, 0.003)], 0.0022, 8)  # fmt: skip
    return put_down([(join([*arms, bar]), wood), (hook, textures.brushed_metal(look.rng, STEEL))],
                   *arms, bar, hook, factor=k)  # fmt: skip


def iron(look: Look) -> Shape:
    """A flat iron lying on its sole, its point to the left."""
    color = look.color("white", "blue", "teal", "purple", "red", "green")
    base = smooth(
        [
            (-0.12, 0),
            (-0.08, -0.03),
            (-0.02, -0.05),
            (0.08, -0.052),
            (0.095, -0.04),
            (0.095, 0.04),
            (0.08, 0.052),
            (-0.02, 0.05),
            (-0.08, 0.03),
            (-0.12, 0),
        ],
        2,
    )[:-1]
    n = len(base)
    sole = prism(base, 0, 0.006)
    body = loft(
        np.stack(
            [
                np.column_stack([base * [a, b] + [x, 0], np.full(n, z)])
                for a, b, x, z in (
                    (0.95, 0.94, 0, 0.005),
                    (0.9, 0.9, 0.002, 0.03),
                    (0.7, 0.6, 0.012, 0.055),
                    (0.5, 0.4, 0.02, 0.062),
                )
            ]
        ),
        base,
    )
    grip = rod(
        [
            (-0.055, 0, 0.05),
            (-0.06, 0, 0.09),
            (-0.02, 0, 0.112),
            (0.06, 0, 0.108),
            (0.085, 0, 0.07),
            (0.085, 0, 0.02),
        ],
        0.0125,
        12,
    )
    dial = cylinder(0.018, 0.008, 20, bevel=0.001).move(0.012, 0, 0.06)
    cord = rod([(0.085, 0, 0.1), (0.12, 0, 0.08), (0.135, 0.02, 0.02), (0.12, 0.05, 0.004),
                (0.07, 0.075, 0.004)], 0.0032, 7)  # fmt: skip
    other = textures.plain(tint_color(color, 0.5) if sum(color) < 600 else (70, 90, 140))
    return put_down(
        [
            (sole, textures.brushed_metal(look.rng, STEEL)),
            (body, look.surface(color, "plastic")),
            (join([grip, dial]), other),
            (cord, textures.plain((60, 60, 64))),
        ],
        sole,
        body,
        grip,
        factor=look.between(0.85, 1.05),
    )


CATEGORIES = (
    Category("bucket", bucket, (0.18, 0.19, 0.145), 0.3, ("pail", "small bucket", "plastic bucket",
             "metal bucket", "sand bucket", "toy bucket", "beach bucket", "cleaning bucket",
             "coal scuttle", "scuttle", "spittoon", "bait bucket", "ice pail"),
             ("living",), ("container", "round"), ("red", "blue")),
    Category("laundry_basket", laundry_basket, (0.307, 0.217, 0.145), 0.5, ("clothes basket",
             "washing basket", "plastic basket", "laundry hamper"), ("living",), ("container",
             "big"), ("white", "blue")),
    Category("dustpan", dustpan, (0.315, 0.19, 0.045), 0.15, ("dust pan", "dustpan and brush"),
             ("kitchen",), (), ("red", "blue"), state="lying flat"),
    Category("scrub_brush", scrub_brush, (0.15, 0.055, 0.042), 0.1, ("scrubbing brush",
                 "cleaning brush", "dish brush", "washing brush", "shoe brush", "clothes brush",
                 "bristle brush", "grill brush",
             "group head brush", "wire brush", "washing-up brush", "washing up brush", "back brush",
             "nail brush", "dry body brush", "carding brush", "body brush"), ("kitchen",), (),
             ("wooden",
             "red"), state="lying"),
    Category("duster", duster, (0.3, 0.09, 0.08), 0.08, ("feather duster", "dust brush",
             "bundle of dusters", "lint brush"),
             ("living",), (), ("pink", "blue"), state="lying"),
    Category("clothes_peg", clothes_peg, (0.075, 0.0195, 0.0093), 0.008, ("clothespin",
             "clothes pin", "washing peg", "laundry peg", "clothes clip", "spring clip",
             "wonder clip", "curtain clip", "nose clip", "mosquito net clip", "pram clip",
             "waders clip"),
             ("living",), (), ("wooden",), state="lying"),
    Category("clothes_hanger", hanger, (0.35, 0.146, 0.0142), 0.09, ("hanger", "coat hanger",
             "wooden hanger"), ("living",), ("big", "flat"), ("wooden",), state="lying flat"),
    Category("iron", iron, (0.24, 0.125, 0.118), 1.0, ("steam iron", "clothes iron", "flatiron",
             "electric iron"), ("living",), ("big",), ("white", "blue")),
)  # fmt: skip
"""The module's categories."""
