"""Stands, timers and cutters of a kitchen: trivets, knife blocks, kitchen timers, juicers."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part, ring_parts
from ...build.forms import facing, lobe
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, loft, prism, tube
from ...surfaces import prints, textures
from ...surfaces.look import Look


def citrus_juicer(look: Look) -> Shape:
    """A citrus squeezer: a ridged cone in a dish with a spout and an ear."""
    r = look.between(0.058, 0.068)
    color = look.color("yellow", "white", "green", "orange", "clear", "silver", "sky")
    skin = look.surface(color, look.pick(["plastic", "ceramic"]))
    dish = lathe([(0, 0), (0.8 * r, 0), (r, 0.024), (0.95 * r, 0.024), (0.74 * r, 0.007),
                  (0, 0.007)], 36)  # fmt: skip
    cone = lobe(lathe([(0, 0.005), (0.5 * r, 0.006), (0.46 * r, 0.02), (0.26 * r, 0.042),
                       (0.05 * r, 0.055), (0, 0.056)], 60), 12, 0.14)  # fmt: skip
    ear = tube(smooth([(0.97 * r, -0.01, 0.02), (1.5 * r, -0.012, 0.02), (1.5 * r, 0.012, 0.02),
                       (0.97 * r, 0.01, 0.02)], 4), 0.004, 8)  # fmt: skip
    lip = prism(np.array([(-1.22, 0), (-0.9, -0.22), (-0.9, 0.22)]) * r, 0.016, 0.0235)
    walls = ring_parts([(0.8 * r, 0), (r, 0.024)], [(0.95 * r, 0.024), (0.74 * r, 0.006)], 10)
    return shape([(join([dish, cone, ear, lip]), skin)],
                 [*walls, cylinder_part(0.8 * r, 0.007), hull_of(cone), hull_of(ear),
                  hull_of(lip)])  # fmt: skip


def cookie_cutter(look: Look) -> Shape:
    """A cookie cutter: a thin wall round a star, heart, flower or round, open above."""
    r, h = look.between(0.03, 0.042), look.between(0.02, 0.026)
    color = look.color("silver", "silver", "copper", "red", "green", "blue", "pink")
    skin = look.surface(color, "metal")
    kind = look.pick(["star", "heart", "flower", "round"])
    t = np.linspace(0, 2 * np.pi, 61)[:-1]
    if kind == "star":
        away = 0.78 + 0.3 * np.abs(((t * 5 / (2 * np.pi)) % 1) - 0.5) * 2 - 0.1
        ring = np.column_stack([away * np.sin(t), away * np.cos(t)])[::-1]
    elif kind == "heart":
        ring = np.column_stack([np.sin(t) ** 3, (13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(
            3 * t) - np.cos(4 * t)) / 15])[::-1]  # fmt: skip
    elif kind == "flower":
        away = 0.86 + 0.14 * np.cos(6 * t)
        ring = np.column_stack([away * np.cos(t), away * np.sin(t)])
    else:
        ring = np.column_stack([np.cos(t), np.sin(t)])
    ring = ring * r
    lip, thin = 1.06, 0.955
    loop = np.stack(
        [
            np.column_stack([ring * k, np.full(len(ring), z)])
            for k, z in (
                (1.0, 0),
                (1.0, h - 0.002),
                (lip, h - 0.002),
                (lip, h),
                (thin, h),
                (thin, 0),
            )
        ]
    )
    wall = loft(
        loop,
        ring,
        profile=np.array(
            [
                (k * r, z)
                for k, z in (
                    (1.0, 0),
                    (1.0, h - 0.002),
                    (lip, h - 0.002),
                    (lip, h),
                    (thin, h),
                    (thin, 0),
                )
            ]
        ),
        loop=True,
    )
    parts = []
    for k in range(12):
        span = np.arange(5 * k, 5 * k + 6) % 60
        points = np.concatenate([np.column_stack([ring[span] * f, np.full(6, z)])
                                 for f in (1.0, thin) for z in (0, h)])  # fmt: skip
        parts.append(hull_part(points))
    return shape([(wall, skin)], parts)


def kitchen_timer(look: Look) -> Shape:
    """A kitchen timer: a round dial on its foot, or an egg or tomato to twist."""
    d = look.between(0.06, 0.072)
    color = look.color("red", "white", "yellow", "sky", "orange", "mint", "black", "silver")
    skin = look.surface(color, "plastic")
    marks = prints.canvas(128, 128, (248, 246, 240))
    prints.disc(marks, 0.5, 0.5, 0.48, (40, 40, 44), 0.46)
    for k in range(12):
        a = k * np.pi / 6
        prints.stroke(
            marks,
            [
                (0.5 + 0.36 * np.sin(a), 0.5 - 0.36 * np.cos(a)),
                (0.5 + 0.44 * np.sin(a), 0.5 - 0.44 * np.cos(a)),
            ],
            0.02,
            (30, 30, 34),
        )
    for k, word in enumerate(("0", "15", "30", "45")):
        a = k * np.pi / 2
        spot = (0.5 + 0.29 * np.sin(a), 0.5 - 0.29 * np.cos(a))
        prints.write(marks, word, *spot, 0.1, (30, 30, 34), bold=True)
    if look.chance(0.55):
        body = facing(cylinder(d / 2, 0.03, 36, bevel=0.005)).move(y=0.015, z=0.5 * d + 0.004)
        face = facing(cylinder(0.43 * d, 0.001, 36)).move(y=-0.0145, z=0.5 * d + 0.004)
        knob = facing(cylinder(0.16 * d, 0.012, 22, bevel=0.002)).move(y=-0.0155, z=0.5 * d + 0.004)
        mark = box(0.0024, 0.001, 0.14 * d).move(0, -0.0278, 0.5 * d + 0.006)
        foot = block(0.6 * d, 0.036, 0.012, 0.006)
        return shape(
            [
                (join([body, foot]), skin),
                (face, marks),
                (knob, skin),
                (mark, textures.plain((250, 250, 250))),
            ],
            [hull_of(body), box_part(0.6 * d, 0.036, 0.012), hull_of(knob)],
        )
    low = lathe([(0, 0), (0.3 * d, 0), (0.46 * d, 0.2 * d), (0.5 * d, 0.44 * d), (0, 0.44 * d)], 32)
    ring = lathe([(0.4 * d, 0.43 * d), (0.505 * d, 0.43 * d), (0.495 * d, 0.56 * d),
                  (0.4 * d, 0.56 * d)], 32, v=[0, 0.02, 0.98, 1], loop=True)  # fmt: skip
    high = lathe([(0, 0.55 * d), (0.485 * d, 0.55 * d), (0.42 * d, 0.78 * d), (0.24 * d, 0.98 * d),
                  (0, 1.06 * d)], 32)  # fmt: skip
    scale = prints.canvas(256, 24, (248, 246, 240))
    for k in range(24):
        prints.fill(scale, k / 24, 0.0, 0.006, 0.5 if k % 2 else 0.9, (40, 40, 44))
    return shape([(join([low, high]), skin), (ring, scale)], [hull_of(low, high)])


def trivet(look: Look) -> Shape:
    """A trivet to put hot pots on: a lattice of bars, or a ring with spokes."""
    x, h = look.between(0.16, 0.2), look.between(0.012, 0.016)
    color = look.color("black", "wooden", "silver", "red", "tan", "teal")
    skin = look.surface(color, look.pick(["wood", "metal"]))
    if look.chance(0.5):
        bars = [box(x, 0.012, 0.5 * h).move(y=(k / 5 - 0.5) * 0.94 * x, z=0.5 * h)
                for k in range(6)]  # fmt: skip
        bars += [box(0.012, x, 0.55 * h).move(x=(k / 3 - 0.5) * 0.94 * x) for k in range(4)]
        return shape([(join(bars), skin)], [box_part(x, x, h)])
    rings = [
        lathe(
            [
                (k * x - 0.006, 0.3 * h),
                (k * x + 0.006, 0.3 * h),
                (k * x + 0.006, h),
                (k * x - 0.006, h),
            ],
            36,
            loop=True,
        )
        for k in (0.18, 0.335, 0.49)
    ]
    spokes = [box(0.98 * x, 0.01, 0.6 * h).move(z=0.3 * h).turn(2, k * np.pi / 3) for k in range(3)]
    feet = [cylinder(0.008, 0.6 * h, 12).move(0.44 * x * np.cos(a), 0.44 * x * np.sin(a))
            for a in np.arange(6) * np.pi / 3]  # fmt: skip
    return shape([(join([*rings, *spokes, *feet]), skin)], [cylinder_part(0.49 * x, h)])


def knife_block(look: Look) -> Shape:
    """A slanted wooden block with knife handles sticking out."""
    x, y, h = look.between(0.1, 0.12), look.between(0.13, 0.15), look.between(0.2, 0.23)
    color = look.color("wooden", "brown", "black", "tan", "white")
    skin = look.surface(color, "wood")
    side = np.array([(-0.5 * y, 0), (0.5 * y, 0), (0.62 * y, 0.62 * h), (0.02 * y, h),
                     (-0.28 * y, 0.86 * h)])  # fmt: skip
    body = prism(side, -x / 2, x / 2).turn(0, np.pi / 2).turn(2, np.pi / 2)
    dark = look.surface(look.own_color("black", "black", "charcoal", "brown", "silver"), "plastic")
    grips, studs = [], []
    for u, long in ((0.24, 0.11), (0.5, 0.1), (0.76, 0.09)):
        for j in (-1, 0, 1):
            at = np.array([0.02, 1.0]) * (1 - u) + np.array([0.62, 0.62]) * u
            grip = block(0.019, 0.014, long, 0.006, 0.003).turn(0, -0.55)
            spot = (j * 0.3 * x, at[0] * y, at[1] * h - 0.012)
            grips.append(grip.move(*spot))
            stud = cylinder(0.0025, 0.02, 8).turn(1, np.pi / 2).move(x=-0.01)
            studs.append(stud.move(spot[0], spot[1] + 0.03, spot[2] + 0.045))
    sharp = [hull_of(*grips[3 * k : 3 * k + 3]) for k in range(3)]
    return shape(
        [(body, skin), (join(grips), dark), (join(studs), textures.plain((200, 196, 186)))],
        [hull_of(body), *sharp],
    )


_K = ("kitchen",)
CATEGORIES = (
    Category("citrus_juicer", citrus_juicer, (0.179, 0.126, 0.056), 0.2, ("lemon squeezer",
                 "juice squeezer", "citrus squeezer", "lemon juicer", "orange squeezer",
                 "orange juicer", "citrus press", "reamer", "juicer", "lime squeezer",
                 "lemon press"), _K, ("round",), ("yellow",
             "white")),
    Category("cookie_cutter", cookie_cutter, (0.0761, 0.0725, 0.0243), 0.025, ("biscuit cutter",
             "pastry cutter", "cookie stamp"), _K, ("flat",), ("silver", "red"),
             state="lying flat"),
    Category("kitchen_timer", kitchen_timer, (0.0679, 0.0618, 0.0714), 0.1, ("egg timer",
             "cooking timer"), _K, (), ("red", "white")),
    Category("trivet", trivet, (0.182, 0.182, 0.0135), 0.4, ("pot stand", "hot pad",
             "hot plate stand", "pan stand"), _K, ("support", "flat"), ("black", "wooden"),
             state="lying flat"),
    Category("knife_block", knife_block, (0.108, 0.188, 0.278), 2.2, ("knife holder",
             "block of knives", "knife set", "knife stand"), _K, ("tall", "big"), ("wooden",)),
)  # fmt: skip
"""The module's categories."""
