"""What one cooks, brews and serves with."""

from __future__ import annotations

import numpy as np

from . import textures
from .category import Category
from .collision import box_part, cylinder_part, footed, hull_of, ring_parts
from .colors import tinted
from .look import Look
from .outlines import rectangle, smooth
from .shape import Shape, shape
from .solids import block, box, cylinder, lathe, prism, sweep, tube


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
