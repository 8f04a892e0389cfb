"""What one cooks, brews and serves with."""

from __future__ import annotations

import numpy as np

from . import textures
from .category import Category
from .collision import box_part, cylinder_part, footed, hull_of, hull_part, ring_parts
from .colors import tinted
from .look import Look
from .shape import Shape, shape
from .solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    lathe,
    prism,
    rectangle,
    smooth,
    sweep,
    tube,
)


def _spout(start: tuple[float, float], end: tuple[float, float], low: float, top: float) -> Solid:
    """Return a curved spout in the x-z plane, ``low`` and ``top`` its radii, on the -x side."""
    (x0, z0), (x1, z1) = start, end
    path = smooth([(x0, 0, z0), (0.5 * (x0 + x1), 0, z0 + 0.25 * (z1 - z0)), (x1, 0, z1)], 4)
    return tube(path, np.linspace(low, top, len(path)), 10)


def teapot(look: Look) -> Shape:
    """A round teapot: spout to the left, handle to the right, a knob on its lid."""
    r, h = look.between(0.066, 0.076), look.between(0.105, 0.12)
    color = look.color("white", "teal", "cream", "navy", "terracotta", "black", "pink", "sage")
    glaze = look.surface(color, "ceramic")
    if look.chance(0.4) and not look.material:
        glaze = textures.spotted(look.rng, color, tinted(color, 1.5), 0.05)
    t = np.linspace(-1.0, 1.05, 12)
    wall = np.column_stack([r * np.cos(t), h * (0.5 + 0.5 * np.sin(t) / np.sin(1.05))])
    wall[:, 1] = np.maximum(wall[:, 1] - wall[0, 1], 0)
    top = float(wall[-1, 1])
    body = lathe([(0, 0), *wall, (0, top)])
    rim = 0.92 * float(wall[-1, 0])
    lid = lathe(
        [(0, top), (rim, top), (rim, top + 0.003), (0.6 * rim, top + 0.011), (0.007, top + 0.015),
         (0.006, top + 0.019), (0.011, top + 0.025), (0.008, top + 0.033), (0, top + 0.034)], 28,
    )  # fmt: skip
    spout = _spout((-0.82 * r, 0.3 * top), (-1.62 * r, 0.95 * top), 0.017, 0.0085)
    ear = tube(
        smooth([(0.82 * r, 0, 0.86 * top), (1.4 * r, 0, 0.92 * top), (1.62 * r, 0, 0.6 * top),
                (1.38 * r, 0, 0.25 * top), (0.9 * r, 0, 0.2 * top)], 4), 0.0065, 8,
    )  # fmt: skip
    ring = wall[:, 1]
    return shape(
        [(body, glaze), (lid, glaze), (spout, glaze), (ear, glaze)],
        [hull_part(body.vertices[body.vertices[:, 2] <= ring[5] + 1e-6]),
         hull_part(body.vertices[body.vertices[:, 2] >= ring[5] - 1e-6]),
         hull_of(lid), hull_of(spout),
         box_part(0.72 * r, 0.013, 0.7 * top, (1.26 * r, 0, 0.2 * top))],
    )  # fmt: skip


def kettle(look: Look) -> Shape:
    """An electric kettle on its base: spout to the left, handle to the right."""
    r, h = look.between(0.068, 0.076), look.between(0.185, 0.21)
    color = look.color("silver", "black", "red", "white", "cream", "sage")
    skin = look.surface(color, "metal" if look.chance(0.5) else "plastic")
    dark = textures.speckled(look.rng, (46, 46, 50), 3, 32)
    body = lathe(
        [(0, 0.02), (r, 0.02), (1.02 * r, 0.04), (0.74 * r, 0.92 * h), (0.6 * r, 0.96 * h),
         (0, 0.96 * h)],
    )  # fmt: skip
    base = cylinder(1.02 * r, 0.02, 32, bevel=0.003)
    lid = lathe([(0, 0.95 * h), (0.58 * r, 0.95 * h), (0.5 * r, 0.98 * h), (0, h)], 28)
    knob = cylinder(0.011, 0.014, 16, bevel=0.002).moved(z=0.99 * h)
    beak = np.array([(-1.18, 0.0), (-0.6, -0.42), (-0.6, 0.42)]) * r
    spout = prism(beak, 0.72 * h, 0.93 * h)
    grip = sweep(
        smooth([(0.68 * r, 0, 0.9 * h), (1.35 * r, 0, 0.93 * h), (1.62 * r, 0, 0.7 * h),
                (1.5 * r, 0, 0.34 * h), (1.25 * r, 0, 0.26 * h)], 4),
        rectangle(0.024, 0.014, 0.005, 2),
    )  # fmt: skip
    return shape(
        [(body, skin), (base, dark), (lid, dark), (knob, dark), (spout, skin), (grip, dark)],
        [cylinder_part(1.02 * r, 0.02), hull_of(body), hull_of(lid, knob), hull_of(spout),
         box_part(0.024, 0.022, 0.5 * h, (1.5 * r, 0, 0.32 * h)),
         box_part(0.7 * r, 0.022, 0.016, (1.05 * r, 0, 0.87 * h))],
    )  # fmt: skip


def pot(look: Look) -> Shape:
    """A cooking pot with two ears and a lid, or open without it."""
    r, h, wall = look.between(0.095, 0.115), look.between(0.1, 0.125), 0.003
    color = look.color("silver", "red", "black", "blue", "copper", "cream")
    skin = look.surface(color, "metal" if look.chance(0.5) else "plastic")
    dark = textures.speckled(look.rng, (50, 50, 54), 3, 32)
    body = lathe(
        [(0, 0), (0.96 * r, 0), (r, 0.006), (r, h), (r - wall, h), (r - wall, 0.008), (0, 0.006)]
    )
    ears = [
        tube(smooth([(side * 0.99 * r, -0.03, 0.8 * h), (side * (r + 0.024), -0.022, 0.82 * h),
                     (side * (r + 0.024), 0.022, 0.82 * h), (side * 0.99 * r, 0.03, 0.8 * h)], 3),
             0.0055, 8)
        for side in (-1, 1)
    ]  # fmt: skip
    pieces = [(body, skin), *((ear, dark) for ear in ears)]
    walls = ring_parts([(0.96 * r, 0), (r, 0.006), (r, h)], [(r - wall, h), (r - wall, 0.008)], 8)
    parts = [
        *walls,
        cylinder_part(0.96 * r, 0.006),
        *[box_part(0.026, 0.055, 0.011, (side * (r + 0.012), 0, 0.78 * h)) for side in (-1, 1)],
    ]
    if look.chance(0.5):
        lid = lathe([(0, h), (r, h), (1.01 * r, h + 0.003), (0.7 * r, h + 0.014), (0, h + 0.019)])
        knob = lathe([(0, h + 0.016), (0.007, h + 0.017), (0.007, h + 0.03), (0.016, h + 0.034),
                      (0.013, h + 0.043), (0, h + 0.044)], 20)  # fmt: skip
        pieces += [(lid, skin), (knob, dark)]
        parts = [cylinder_part(r, h), *parts[-2:], hull_of(lid), hull_of(knob)]
    return shape(pieces, parts)


def pan(look: Look) -> Shape:
    """A frying pan, its handle to the right."""
    r, h, wall = look.between(0.1, 0.125), look.between(0.038, 0.048), 0.0035
    low = 0.8 * r
    color = look.color("charcoal", "black", "red", "copper", "silver")
    inside = textures.speckled(look.rng, look.fixed("charcoal", "black"), 4)
    body = lathe(
        [(0, 0), (low, 0), (r, h), (r - wall, h), (low - wall, 0.006), (0, 0.006)],
        v=[0, 0.25, 0.48, 0.52, 0.75, 1],
    )
    tile = textures.stacked((look.surface(color, "plastic"), 1), (inside, 1), side=64)
    long = look.between(0.16, 0.19)
    grip = sweep(
        smooth([(0.95 * r, 0, 0.75 * h), (r + 0.3 * long, 0, 1.1 * h), (r + long, 0, 1.25 * h)], 4),
        rectangle(0.022, 0.012, 0.005, 2),
    )  # fmt: skip
    handle_tile = look.surface(look.fixed("black", "brown", "charcoal"), "plastic")
    walls = ring_parts([(low, 0), (r, h)], [(r - wall, h), (low - wall, 0.006)])
    return shape(
        [(body, tile), (grip, handle_tile)],
        [*walls, cylinder_part(low, 0.006), hull_of(grip)],
    )


def cutting_board(look: Look) -> Shape:
    """A wooden board with a rounded grip and a hole in it."""
    x, y, h = look.between(0.27, 0.33), look.between(0.18, 0.22), look.between(0.014, 0.02)
    color = look.color("wooden", "tan", "beige", "brown")
    tile = look.surface(color, "wood")
    if not look.material and look.chance(0.5):
        tile = textures.wood(look.rng, color, planks=5)
    board = prism(rectangle(x, y, 0.02), 0, h, 0.002)
    long = 0.085
    grip = prism(rectangle(long, 0.05, 0.02), 0.0005, h - 0.0005, 0.002)
    grip = grip.moved(x=x / 2 + 0.25 * long)
    hole = cylinder(0.009, h, 20).moved(x=x / 2 + 0.5 * long)
    return shape(
        [(board, tile), (grip, tile), (hole, textures.plain(tinted(color, 0.3)))],
        [
            box_part(x, y, h),
            box_part(0.75 * long, 0.05, h - 0.001, (x / 2 + 0.375 * long, 0, 0.0005)),
        ],
    )


def french_press(look: Look) -> Shape:
    """A coffee press: glass beaker with coffee, metal frame, plunger, handle to the right."""
    r, h = look.between(0.045, 0.052), look.between(0.15, 0.175)
    level = look.between(0.45, 0.75)
    coffee, clear = textures.plain((62, 38, 26)), textures.plain((206, 218, 220))
    metal = textures.brushed(look.rng, look.color("silver", "black", "copper", "gold"))
    dark = textures.speckled(look.rng, (44, 44, 48), 3, 32)
    body = lathe([(0, 0.01), (r, 0.01), (r, h), (0, h)], v=[0, 0.01, 0.99, 1])
    tile = textures.stacked((coffee, level), (clear, 1 - level), side=64)
    rings = [
        lathe([(0.98 * r, z), (1.03 * r, z), (1.03 * r, z + t), (0.98 * r, z + t)], loop=True)
        for z, t in ((0.004, 0.014), (0.5 * h, 0.006), (0.88 * h, 0.008))
    ]
    bars = [
        box(0.007, 0.003, 0.9 * h).moved(y=-1.02 * r).turned(2, np.pi / 2 * k + np.pi / 4)
        for k in range(4)
    ]
    lid = lathe([(0, h), (1.05 * r, h), (1.02 * r, h + 0.01), (0.4 * r, h + 0.018), (0, h + 0.018)])
    rod = cylinder(0.0025, 0.03, 10).moved(z=h + 0.014)
    knob = ellipsoid(0.018, 0.018, 0.018, 16, 10).moved(z=h + 0.05)
    grip = tube(
        smooth([(1.0 * r, 0, 0.9 * h), (1.65 * r, 0, 0.88 * h), (1.8 * r, 0, 0.6 * h),
                (1.65 * r, 0, 0.2 * h), (1.0 * r, 0, 0.16 * h)], 4), 0.0075, 8,
    )  # fmt: skip
    foot = cylinder(1.03 * r, 0.01, 32, bevel=0.001)
    return shape(
        [(body, tile), (foot, metal), *((s, metal) for s in (*rings, *bars)), (lid, metal),
         (rod, metal), (knob, dark), (grip, dark)],
        [cylinder_part(1.03 * r, h), hull_of(lid), cylinder_part(0.007, 0.042, (0, 0, h + 0.016)),
         box_part(0.8 * r, 0.014, 0.75 * h, (1.42 * r, 0, 0.15 * h))],
    )  # fmt: skip


def toaster(look: Look) -> Shape:
    """A two-slot toaster with a lever at its right end."""
    x, y, h = look.between(0.26, 0.29), look.between(0.16, 0.175), look.between(0.175, 0.19)
    color = look.color("silver", "red", "cream", "black", "mint", "sky")
    skin = look.surface(color, "metal" if look.chance(0.4) else "plastic")
    dark = textures.plain((40, 40, 43))
    outline = rectangle(y, h, 0.035, 5)
    side = prism(outline, 0, x).turned(1, np.pi / 2).turned(0, np.pi / 2)
    low, high = side.bounds
    body = side.moved(*(-(low + high) / 2)).moved(z=h / 2 + 0.008)
    feet = [box(0.03, 0.02, 0.012).moved(sx * 0.38 * x, sy * 0.3 * y) for sx in (-1, 1)
            for sy in (-1, 1)]  # fmt: skip
    top = h + 0.008
    slots = [box(0.66 * x, 0.024, 0.002).moved(y=s * 0.024, z=top - 0.0008) for s in (-1, 1)]
    lever = box(0.014, 0.03, 0.012).moved(x=x / 2 + 0.006, z=0.68 * h)
    rail = box(0.001, 0.008, 0.5 * h).moved(x=x / 2 + 0.0003, z=0.24 * h)
    dial = cylinder(0.013, 0.01, 18, bevel=0.002).turned(1, np.pi / 2).moved(x=x / 2, z=0.2 * h)
    pieces = [(body, skin), *((s, dark) for s in (*feet, *slots, lever, rail, dial))]
    if look.chance(0.5):
        crust = textures.gradient((200, 150, 88), (232, 196, 140), look.rng)
        toast = block(0.1, 0.013, 0.05, 0.005, 0.002).moved(y=0.024, z=top - 0.012)
        pieces.append((toast, crust))
    return shape(
        pieces,
        [
            box_part(0.82 * x, 0.8 * y, 0.012),
            hull_of(body),
            box_part(0.014, 0.03, 0.012, (x / 2 + 0.006, 0, 0.68 * h)),
        ],
    )


def rolling_pin(look: Look) -> Shape:
    """A wooden rolling pin lying down."""
    r, long = look.between(0.024, 0.029), look.between(0.36, 0.42)
    wood = look.surface(look.color("wooden", "tan", "beige"), "wood")
    profile = [(0, 0), (0.008, 0.002), (0.013, 0.03), (0.008, 0.085), (0.008, 0.09), (r, 0.092)]
    mirrored = [(radius, long - z) for radius, z in profile[::-1]]
    body = lathe([*profile, *mirrored], 24).turned(1, np.pi / 2).moved(x=-long / 2, z=r)
    return shape(
        [(body, wood)],
        [box_part(long - 0.19, 1.5 * r, 2 * r),
         *[box_part(0.08, 0.018, 0.018, (side * (long / 2 - 0.045), 0, r - 0.009))
           for side in (-1, 1)]],
    )  # fmt: skip


def whisk(look: Look) -> Shape:
    """A balloon whisk lying down, wires to the left."""
    steel = textures.brushed(look.rng, (190, 193, 198))
    skin = look.surface(look.color("black", "silver", "wooden", "red", "teal"), "plastic")
    wide, long = look.between(0.03, 0.036), 0.15
    grip = cylinder(0.0085, 0.12, 16, top=0.011, bevel=0.002).turned(1, np.pi / 2).moved(x=0.02)
    pieces = [(grip, skin)]
    for k in range(4):
        t = np.linspace(0, np.pi, 13)
        x = 0.03 - long * np.sin(t / 2) ** 0.8
        half = np.concatenate([t, t[-2::-1]])
        reach = wide * np.sin(half)
        side = np.where(np.arange(len(half)) < len(t), 1, -1)
        path = np.column_stack([np.concatenate([x, x[-2::-1]]), side * reach, np.zeros(len(half))])
        wire = tube(path, 0.0011, 5).turned(0, np.pi / 4 * k)
        pieces.append((wire, steel))
    lean = np.arctan2(wide - 0.011, 0.21)  # it rests on the wires and the end of its grip
    turned = [(solid.turned(1, lean), tile) for solid, tile in pieces]
    low = min(solid.bounds[0, 2] for solid, _ in turned)
    turned = [(solid.moved(z=-low), tile) for solid, tile in turned]
    balloon = np.concatenate([solid.vertices for solid, _ in turned[1:]])
    return shape(
        turned,
        [footed(balloon[np.abs(balloon[:, 0] + 0.075) < 0.04], 0.15), hull_of(turned[0][0])],
    )


def coaster(look: Look) -> Shape:
    """A round or square coaster."""
    side, h = look.between(0.09, 0.1), look.between(0.005, 0.009)
    color = look.color("tan", "charcoal", "teal", "red", "wooden", "white")
    tile = look.surface(color, look.pick(["cork", "wood", "marble", "felt"]))
    if look.chance(0.6):
        return shape([(cylinder(side / 2, h, 32, bevel=0.001), tile)], [cylinder_part(side / 2, h)])
    return shape([(block(side, side, h, 0.008, 0.001), tile)], [box_part(side, side, h)])


CATEGORIES = (
    Category(
        "teapot",
        teapot,
        (0.23, 0.14, 0.145),
        0.7,
        ("tea pot", "pot of tea"),
        ("coffee", "dining", "kitchen"),
        (),
        ("white", "teal", "cream"),
    ),
    Category(
        "kettle",
        kettle,
        (0.21, 0.146, 0.21),
        1.0,
        ("electric kettle", "tea kettle"),
        ("kitchen",),
        ("tall",),
        ("silver", "black"),
    ),
    Category(
        "pot",
        pot,
        (0.265, 0.21, 0.13),
        1.1,
        ("cooking pot", "saucepan", "stockpot"),
        ("kitchen",),
        ("big",),
        ("silver", "red"),
    ),
    Category(
        "pan",
        pan,
        (0.4, 0.225, 0.062),
        0.9,
        ("frying pan", "skillet"),
        ("kitchen",),
        ("container", "big"),
        ("charcoal",),
    ),
    Category(
        "cutting_board",
        cutting_board,
        (0.36, 0.2, 0.017),
        0.7,
        ("chopping board", "board", "cheese board", "wooden board"),
        ("kitchen",),
        ("support", "flat", "big"),
        ("wooden",),
        state="lying flat",
    ),
    Category(
        "french_press",
        french_press,
        (0.14, 0.105, 0.225),
        0.6,
        ("coffee press", "coffee pot", "coffee maker", "cafetiere", "moka pot"),
        ("coffee", "kitchen"),
        ("tall",),
        ("silver", "black"),
    ),
    Category(
        "toaster", toaster, (0.285, 0.168, 0.2), 1.4, (), ("kitchen",), ("big",), ("silver", "red")
    ),
    Category(
        "rolling_pin",
        rolling_pin,
        (0.39, 0.053, 0.053),
        0.45,
        ("dough roller",),
        ("kitchen",),
        (),
        ("wooden",),
        state="lying down",
    ),
    Category(
        "whisk",
        whisk,
        (0.26, 0.066, 0.066),
        0.09,
        ("egg beater", "balloon whisk"),
        ("kitchen",),
        (),
        ("silver", "black"),
        state="lying down",
    ),
    Category(
        "coaster",
        coaster,
        (0.095, 0.095, 0.007),
        0.04,
        ("drink coaster",),
        ("coffee", "living", "dining"),
        ("support", "flat"),
        ("tan",),
        state="lying flat",
    ),
)
