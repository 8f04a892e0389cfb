"""Small kitchen tools: funnels, sieves, lids, openers, presses, mashers, timers, cutters."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part, ring_parts
from ...build.forms import facing, lobe
from ...build.outlines import ellipse, smooth
from ...build.settled import hull_above, limb
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, loft, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

GRIPS = ("black", "red", "teal", "white", "navy", "sage", "gray")


def _steel(look: Look) -> textures.Tile:
    return textures.brushed_metal(look.rng, (192, 195, 200))


def funnel(look: Look) -> Shape:
    """A funnel standing on its wide rim, its spout up."""
    r, h = look.between(0.05, 0.062), look.between(0.1, 0.125)
    color = look.color("silver", "red", "white", "blue", "green", "copper", "yellow")
    skin = look.surface(color, look.pick(["metal", "plastic"]))
    outer = [(r, 0), (r, 0.006), (0.2 * r, 0.55 * h), (0.13 * r, h)]
    inner = [(0.1 * r, h), (0.16 * r, 0.55 * h), (0.93 * r, 0)]
    body = lathe([*outer, *inner], 32, loop=True)
    ear = torus(0.011, 0.003, 18, 6).move(x=r + 0.009, z=0.003)
    walls = ring_parts(outer[:3], [(0.16 * r, 0.55 * h), (0.93 * r, 0)], 12)
    return shape(
        [(body, skin), (ear, skin)],
        [*walls, cylinder_part(0.13 * r, 0.44 * h, (0, 0, 0.55 * h)), hull_of(ear)],
    )


def sieve(look: Look) -> Shape:
    """A round mesh sieve with a long handle, resting bowl down."""
    r, h = look.between(0.07, 0.09), look.between(0.045, 0.058)
    color = look.color(*GRIPS, "silver")
    t = np.linspace(0.15, np.pi / 2, 6)
    outer = [(r * np.sin(a), h * (1 - np.cos(a))) for a in t]
    inner = [(max(x - 0.0016, 0.001), max(z, 0.0016)) for x, z in outer]
    inner[0] = (outer[0][0] - 0.0016, outer[0][1] + 0.0016)
    cup = lathe([(0, 0), *outer, *inner[::-1], (0, 0.0016)], 32)
    mesh = textures.grid((122, 126, 130), (206, 209, 213), 40, 64, 128)
    rim = torus(r, 0.0034, 36, 8).move(z=h)
    bar = tube([(r, 0, h), (r + 0.03, 0, h), (r + 0.07, 0, 0.86 * h)], 0.0035, 8)
    grip = limb([(r + 0.05, 0, 0.9 * h), (r + 0.09, 0, 0.72 * h), (r + 0.16, 0, 0.2 * h),
                 (r + 0.165, 0, 0.17 * h)], [0.006, 0.0095, 0.009, 0.005], 12)  # fmt: skip
    hook = tube(smooth([(-r, -0.014, h), (-r - 0.02, 0, h), (-r, 0.014, h)], 4), 0.002, 6)
    steel = _steel(look)
    walls = ring_parts([outer[0], outer[2], outer[4], outer[5]], [inner[5], inner[2]])
    low = cylinder_part(outer[2][0] * 0.9, outer[2][1])
    return shape(
        [(cup, mesh), (join([rim, bar, hook]), steel), (grip, look.surface(color))],
        [*walls, low, cylinder_part(outer[0][0], 0.004), hull_of(grip), hull_of(hook)],
    )


def lid(look: Look) -> Shape:
    """A pot's lid of steel or glass with its knob, lying right side up."""
    r, h = look.between(0.09, 0.125), look.between(0.02, 0.032)
    color = look.color("silver", "silver", "red", "black", "blue", "copper", "white", "sage")
    body = lathe([(0, 0), (0.95 * r, 0), (r, 0.004), (r, 0.009), (0.75 * r, 0.66 * h),
                  (0.35 * r, 0.94 * h), (0, h)], 36)  # fmt: skip
    rim = lathe([(0.955 * r, 0.0005), (1.01 * r, 0.002), (1.01 * r, 0.01), (0.955 * r, 0.011)], 36,
                loop=True)  # fmt: skip
    knob = lathe([(0, 0), (0.009, 0), (0.009, 0.014), (0.02, 0.019), (0.018, 0.028),
                  (0, 0.03)], 22).move(z=h - 0.001)  # fmt: skip
    glass = look.chance(0.4)
    skin = textures.plain((178, 194, 200)) if glass else look.surface(color, "metal")
    tone = look.surface(look.own_color("black", "charcoal", "brown", "silver"), "plastic")
    return shape([(body, skin), (rim, _steel(look) if glass else skin), (knob, tone)],
                 [hull_of(body), hull_of(knob)])  # fmt: skip


def can_opener(look: Look) -> Shape:
    """A can opener lying: two handles to the right, a cutting wheel and a turning key."""
    long = look.between(0.17, 0.2)
    color = look.color(*GRIPS)
    steel, skin = _steel(look), look.surface(color, "plastic")
    arms = [limb([(-0.38 * long, s * 0.004, 0.006), (-0.1 * long, s * 0.01, 0.006),
                  (0.46 * long, s * 0.021, 0.0075), (0.5 * long, s * 0.021, 0.0075)],
                 [0.006, 0.0065, 0.0085, 0.005], 10, 0.9) for s in (-1, 1)]  # fmt: skip
    plate = block(0.06, 0.03, 0.004, 0.01).move(-0.4 * long, 0, 0.006)
    wheel = cylinder(0.011, 0.003, 24).move(-0.46 * long, 0.004, 0.0095)
    cog = lobe(cylinder(0.0075, 0.004, 36), 12, 0.2).move(-0.43 * long, -0.007, 0.0095)
    stem = cylinder(0.004, 0.012, 12).move(-0.38 * long, 0, 0.009)
    key = block(0.013, 0.05, 0.005, 0.006, 0.001).turn(2, 0.35).move(-0.38 * long, 0, 0.019)
    return shape(
        [(join(arms), skin), (join([plate, wheel, cog, stem]), steel), (key, skin)],
        [hull_above(a) for a in arms] + [hull_of(plate, wheel), hull_of(stem, key)],
    )


def garlic_press(look: Look) -> Shape:
    """A garlic press lying, its handles a little open to the right."""
    long = look.between(0.155, 0.18)
    color = look.color("silver", "silver", "red", "black", "teal")
    skin = look.surface(color, "metal")
    cup = block(0.045, 0.03, 0.03, 0.008, 0.002).move(-0.38 * long)
    holes = [cylinder(0.0016, 0.0008, 8).move(-0.38 * long + 0.0075 * i, 0.006 * j, 0.0297)
             for i in range(-2, 3) for j in range(-1, 2)]  # fmt: skip
    low = limb([(-0.3 * long, 0, 0.011), (0.1 * long, 0, 0.009), (0.46 * long, 0, 0.0085),
                (0.5 * long, 0, 0.0085)], [0.0085, 0.008, 0.008, 0.004], 10)  # fmt: skip
    high = limb([(-0.42 * long, 0, 0.03), (-0.2 * long, 0, 0.036), (0.2 * long, 0, 0.042),
                 (0.5 * long, 0, 0.052)], [0.006, 0.0085, 0.008, 0.006], 10)  # fmt: skip
    head = block(0.03, 0.022, 0.012, 0.005, 0.002).move(-0.36 * long, 0, 0.026)
    return shape([(join([cup, low, high, head]), skin),
                  (join(holes), textures.plain((60, 60, 62)))],
                 [hull_of(cup), hull_above(low), hull_of(high)])  # fmt: skip


def potato_masher(look: Look) -> Shape:
    """A potato masher standing on its zigzag or pierced plate."""
    h = look.between(0.23, 0.27)
    color = look.color(*GRIPS, "wooden")
    steel = _steel(look)
    r = look.between(0.04, 0.046)
    if look.chance(0.5):
        foot = [prism(ellipse(2 * r, 2 * r, 32), 0, 0.003)]
        holes = [box(0.008, 0.008, 0.0006).move(0.017 * i, 0.017 * j, 0.0028)
                 for i in range(-2, 3) for j in range(-2, 3) if i * i + j * j < 6]  # fmt: skip
    else:
        y = np.array([-1, 1, 1, -1] * 3)[:11] * 0.8
        x = np.repeat(np.linspace(-1, 1, 6), 2)[:11]
        path = np.column_stack([x * r, y * r, np.full(11, 0.003)])
        foot, holes = [tube(path, 0.003, 8)], []
    arms = [tube(smooth([(s * 0.85 * r, 0, 0.003), (s * 0.75 * r, 0, 0.3 * h),
                         (s * 0.1 * r, 0, 0.5 * h), (0, 0, 0.58 * h)], 4), 0.0034, 8)
            for s in (-1, 1)]  # fmt: skip
    grip = lathe([(0, 0), (0.009, 0), (0.013, 0.14 * h), (0.011, 0.3 * h), (0.013, 0.4 * h),
                  (0.006, 0.45 * h), (0, 0.45 * h)], 18).move(z=0.55 * h)  # fmt: skip
    pieces = [(join([*foot, *arms]), steel), (grip, look.surface(color, "plastic"))]
    if holes:
        pieces.append((join(holes), textures.plain((70, 72, 76))))
    return shape(pieces, [hull_above(*foot), hull_of(*arms), hull_of(grip)])


def mandoline(look: Look) -> Shape:
    """A mandoline slicer: a sloping board on a foot, a slanted blade across it."""
    x, y = look.between(0.28, 0.34), look.between(0.1, 0.12)
    color = look.color("white", "black", "red", "green", "sage", "silver")
    skin = look.surface(color, "plastic")
    board = block(x, y, 0.01, 0.02, 0.002)
    rails = [box(0.82 * x, 0.008, 0.014).move(0, s * 0.44 * y, 0.004) for s in (-1, 1)]
    blade = prism(np.array([(-0.02, -0.4 * y), (0.0, -0.4 * y), (0.03, 0.4 * y), (0.01, 0.4 * y)]),
                  0.0095, 0.012)  # fmt: skip
    guard = block(0.075, 0.8 * y, 0.014, 0.02, 0.004).move(0.24 * x, 0, 0.0105)
    knob = cylinder(0.018, 0.02, 20, top=0.022, bevel=0.004).move(0.24 * x, 0, 0.024)
    dark = textures.plain(tint_color(color, 0.55) if sum(color) > 200 else (110, 112, 116))
    lean = 0.3
    up = [
        (s.turn(1, lean).move(z=0.5 * x * np.sin(lean)), t)
        for s, t in (
            (join([board, *rails]), skin),
            (blade, _steel(look)),
            (join([guard, knob]), dark),
        )
    ]
    legs = [box(0.012, 0.012, 0.28 * x).turn(1, -0.25).move(-0.3 * x, s * 0.42 * y, 0)
            for s in (-1, 1)]  # fmt: skip
    bar = box(0.02, y, 0.006).move(-0.31 * x)
    up.append((join([*legs, bar]), skin))
    return shape(up, [hull_above(up[0][0]), hull_of(up[2][0]), hull_above(*legs, bar)])


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


def nutcracker(look: Look) -> Shape:
    """A pair of hinged nutcrackers lying, teeth in their jaws."""
    long = look.between(0.15, 0.175)
    color = look.color("silver", "silver", "gold", "copper", "black")
    skin = look.surface(color, "metal")
    arms = []
    for s in (-1, 1):
        path = [
            (-0.46 * long, s * 0.007, 0.006),
            (-0.34 * long, s * 0.0165, 0.006),
            (-0.16 * long, s * 0.0125, 0.006),
            (0.1 * long, s * 0.017, 0.006),
            (0.46 * long, s * 0.028, 0.006),
            (0.5 * long, s * 0.03, 0.006),
        ]
        arms.append(limb(path, [0.0055, 0.0062, 0.005, 0.0058, 0.0062, 0.004], 10))
    hinge = cylinder(0.0085, 0.013, 18, bevel=0.001).move(-0.49 * long)
    bar = block(0.01, 0.022, 0.008, 0.003).move(-0.47 * long, 0, 0.0025)
    teeth = [box(0.002, 0.004, 0.011).move((-0.36 + 0.03 * k) * long, s * 0.0105, 0.0007)
             for k in range(5) for s in (-1, 1)]  # fmt: skip
    return shape([(join([*arms, hinge, bar]), skin),
                  (join(teeth), textures.plain(tint_color(color, 0.7)))],
                 [*(hull_above(a) for a in arms), hull_of(hinge, bar)])  # fmt: skip


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
    Category("funnel", funnel, (0.132, 0.109, 0.108), 0.06, ("kitchen funnel",), _K, (), ("silver",
             "red")),
    Category("sieve", sieve, (0.35, 0.164, 0.0563), 0.18, ("strainer", "mesh strainer",
             "flour sifter", "sifter", "fine mesh sieve", "mesh sieve"), _K, ("container", "big"),
             ("silver", "black")),
    Category("lid", lid, (0.214, 0.214, 0.0552), 0.45, ("pot lid", "pan lid", "saucepan lid",
             "glass lid", "lid of a pot", "jar lid"), _K, ("round", "flat"), ("silver",),
             state="lying flat"),
    Category("can_opener", can_opener, (0.2, 0.0595, 0.024), 0.16, ("tin opener",), _K, (),
             ("black", "red"), state="lying flat"),
    Category("garlic_press", garlic_press, (0.177, 0.03, 0.0576), 0.2, ("garlic crusher",), _K, (),
             ("silver",), state="lying flat"),
    Category("potato_masher", potato_masher, (0.0862, 0.0761, 0.243), 0.18, ("masher",), _K,
             ("tall",), ("black", "silver")),
    Category("mandoline", mandoline, (0.29, 0.109, 0.0985), 0.5, ("mandolin slicer",
             "vegetable slicer", "mandoline slicer", "food slicer"), _K, ("big",), ("white",
             "black")),
    Category("citrus_juicer", citrus_juicer, (0.179, 0.126, 0.056), 0.2, ("lemon squeezer",
             "juice squeezer", "citrus squeezer", "lemon juicer", "orange squeezer",
             "orange juicer", "citrus press", "reamer", "juicer"), _K, ("round",), ("yellow",
             "white")),
    Category("cookie_cutter", cookie_cutter, (0.0761, 0.0725, 0.0243), 0.025, ("biscuit cutter",
             "pastry cutter", "cookie stamp"), _K, ("flat",), ("silver", "red"),
             state="lying flat"),
    Category("kitchen_timer", kitchen_timer, (0.0679, 0.0618, 0.0714), 0.1, ("egg timer", "timer",
             "cooking timer"), _K, (), ("red", "white")),
    Category("nutcracker", nutcracker, (0.175, 0.0696, 0.013), 0.2, ("nut cracker",
             "lobster cracker"), _K, (), ("silver",), state="lying flat"),
    Category("trivet", trivet, (0.182, 0.182, 0.0135), 0.4, ("pot stand", "hot pad",
             "hot plate stand", "pan stand"), _K, ("support", "flat"), ("black", "wooden"),
             state="lying flat"),
    Category("knife_block", knife_block, (0.108, 0.188, 0.278), 2.2, ("knife holder",
             "block of knives", "knife set", "knife stand"), _K, ("tall", "big"), ("wooden",)),
)  # fmt: skip
"""The module's categories."""
