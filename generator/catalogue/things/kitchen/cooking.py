"""Things for cooking, brewing and serving."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of, ring_parts
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, lathe, prism, sweep, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look


def pot(look: Look) -> Shape:
    """A cooking pot with two ears: tall, low or bellied; with a lid of steel or glass, or open."""
    r, h, wall = look.between(0.09, 0.118), look.between(0.085, 0.135), 0.003
    color = look.color(
        "silver", "silver", "red", "black", "blue", "copper", "cream", "teal", "orange", "sage"
    )
    kind, open_, metal = look.pick(["drum", "drum", "belly"]), look.chance(0.45), look.chance(0.5)
    skin = look.surface(color, "metal" if metal else "plastic")
    inside = look.pick([skin, textures.brushed_metal(look.rng, (176, 178, 182)),
                        textures.plain((236, 232, 222))])  # fmt: skip
    dark = textures.speckles(
        look.rng, look.own_color("charcoal", "black", "brown", "silver"), 3, 32
    )
    tile = textures.stack((skin, 50), (inside, 50), side=128)
    if not metal and look.chance(0.4):  # enamel with a printed band or dots
        tile = textures.stack((glaze_tile(look, color), 50), (inside, 50), side=192)
    foot, mid = (0.96, 1.0) if kind == "drum" else (0.74, 1.04)
    side = [(foot * r, 0), (mid * r, 0.3 * h), (r, 0.7 * h), (r, h)]
    if kind == "drum":
        side[1] = (r, 0.06 * h)
    inner = [(x - wall, max(z, 0.006)) for x, z in side[::-1]]
    body = lathe([(0, 0), *side, *inner, (0, 0.006)],
                 v=[0, 0.02, 0.16, 0.34, 0.49, 0.51, 0.66, 0.84, 0.98, 1])  # fmt: skip
    ears = [
        tube(smooth([(side * 0.99 * r, -0.03, 0.8 * h), (side * (r + 0.024), -0.022, 0.82 * h),
                     (side * (r + 0.024), 0.022, 0.82 * h), (side * 0.99 * r, 0.03, 0.8 * h)], 3),
             0.0055, 8)
        for side in (-1, 1)
    ]  # fmt: skip
    pieces = [(body, tile), *((ear, dark) for ear in ears)]
    ends = [box_part(0.026, 0.055, 0.011, (s * (r + 0.012), 0, 0.78 * h)) for s in (-1, 1)]
    if open_:
        walls = ring_parts(side, [(r - wall, h), (foot * r - wall, 0.006)])
        return shape(pieces, [*walls, cylinder_part(foot * r, 0.006), *ends])
    lid = lathe([(0, h), (r, h), (1.01 * r, h + 0.003), (0.7 * r, h + 0.014), (0, h + 0.019)])
    knob = lathe([(0, h + 0.016), (0.007, h + 0.017), (0.007, h + 0.03), (0.016, h + 0.034),
                  (0.013, h + 0.043), (0, h + 0.044)], 20)  # fmt: skip
    glass = look.chance(0.35)
    pieces += [(lid, textures.plain((166, 182, 188)) if glass else skin), (knob, dark)]
    if glass:
        band = lathe([(0.96 * r, h), (1.015 * r, h), (1.015 * r, h + 0.005), (0.96 * r, h + 0.005)],
                     32, loop=True)  # fmt: skip
        pieces.append((band, textures.plain((190, 192, 196))))
    trunk = hull_of(body)
    return shape(pieces, [trunk, *ends, hull_of(lid), hull_of(knob)])


def pan(look: Look) -> Shape:
    """A frying pan, skillet, saute pan or wok, its handle to the right."""
    r, h, wall = look.between(0.098, 0.128), look.between(0.036, 0.05), 0.0035
    kind = look.pick(["fry", "fry", "saute", "wok"])
    low = r * {"fry": 0.8, "saute": 0.97, "wok": 0.5}[kind]
    color = look.color(
        "charcoal", "black", "red", "copper", "silver", "teal", "cream", "blue", "sage"
    )
    coat = look.pick(
        [(62, 64, 68), (44, 44, 47), (172, 174, 178), (196, 150, 110), (210, 206, 196)]
    )
    inside = textures.scratches(
        look.rng, coat, tint_color(coat, 1.12), int(look.rng.integers(2, 40))
    )
    body = lathe(
        [(0, 0), (low, 0), (r, h), (r - wall, h), (low - wall, 0.006), (0, 0.006)],
        v=[0, 0.25, 0.48, 0.52, 0.75, 1],
    )
    skin = look.surface(color, look.pick(["plastic", "metal"]))
    tile = textures.stack((skin, 1), (inside, 1), side=128)
    long = look.between(0.15, 0.2)
    grip = sweep(
        smooth([(0.95 * r, 0, 0.75 * h), (r + 0.3 * long, 0, 1.1 * h), (r + long, 0, 1.25 * h)], 4),
        rectangle(look.between(0.018, 0.026), 0.012, 0.005, 2),
    )  # fmt: skip
    shaft = look.own_color("black", "brown", "charcoal", "silver", "tan")
    handle_tile = look.surface(shaft, look.pick(["plastic", "wood"]))
    walls = ring_parts([(low, 0), (r, h)], [(r - wall, h), (low - wall, 0.006)])
    pieces = [(body, tile), (grip, handle_tile)]
    if look.chance(0.2):  # a fried egg
        white = cylinder(0.045, 0.003, 18, bevel=0.001).scale(1, 0.85, 1)
        yolk = ellipsoid(0.03, 0.03, 0.014, 14, 8)
        pieces += [(white.move(-0.01, 0.008, 0.006), textures.plain((246, 244, 236))),
                   (yolk.move(-0.012, 0.01, 0.009), textures.plain((244, 180, 40)))]  # fmt: skip
    return shape(pieces, [*walls, cylinder_part(low, 0.006), hull_of(grip)])


def cutting_board(look: Look) -> Shape:
    """A board, rectangular, rounded or a paddle, of planks, end grain, plastic or slate."""
    x, y, h = look.between(0.26, 0.34), look.between(0.17, 0.23), look.between(0.011, 0.022)
    color = look.color("wooden", "tan", "beige", "brown", "bronze")
    kind = int(look.rng.integers(5))
    tile = look.surface(color, "wood")
    if not look.material and kind == 1:
        tile = textures.wood(look.rng, color, planks=5)
    elif not look.material and kind == 2:
        tone = [tint_color(color, k) for k in (0.62, 1.0, 1.25)]
        tile = textures.stripes(tone, 3, side=96)
    elif not look.material and kind == 3:
        plastic = look.color("white", "sage", "red", "sky", "yellow", "charcoal")
        tile = textures.scratches(look.rng, plastic, tint_color(plastic, 0.85), 30)
    radius, long = look.between(0.006, 0.05), look.between(0.07, 0.1)
    board = prism(rectangle(x, y, radius), 0, h, 0.002)
    hole_tile = textures.plain(tint_color(color, 0.3))
    if look.chance(0.4):  # without a handle: a slot in the board, a groove round it
        slot = block(0.014, 0.07, 0.0006, 0.007).move(x=0.43 * x, z=h - 0.0002)
        return shape([(board, tile), (slot, hole_tile)], [box_part(x, y, h)])
    grip = prism(rectangle(long, look.between(0.04, 0.07), 0.02), 0.0005, h - 0.0005, 0.002)
    grip = grip.move(x=x / 2 + 0.25 * long)
    hole = cylinder(0.009, h, 20).move(x=x / 2 + 0.5 * long)
    return shape(
        [(board, tile), (grip, tile), (hole, hole_tile)],
        [
            box_part(x, y, h),
            box_part(0.75 * long, 0.04, h - 0.001, (x / 2 + 0.375 * long, 0, 0.0005)),
        ],
    )


def toaster(look: Look) -> Shape:
    """A two-slot toaster with a lever at its right end: round-backed, boxy or sloping."""
    x, y, h = look.between(0.25, 0.3), look.between(0.155, 0.18), look.between(0.165, 0.195)
    color = look.color(
        "silver", "silver", "red", "cream", "black", "mint", "sky", "white", "pink", "copper"
    )
    skin = look.surface(color, "metal" if look.chance(0.5) else "plastic")
    dark = textures.plain((40, 40, 43))
    radius = look.pick([0.012, 0.035, 0.06])
    side = prism(rectangle(y, h, radius, 5), 0, x).turn(1, np.pi / 2).turn(0, np.pi / 2)
    low, high = side.bounds
    body = side.move(*(-(low + high) / 2)).move(z=h / 2 + 0.008)
    feet = [box(0.03, 0.02, 0.012).move(sx * 0.38 * x, sy * 0.3 * y) for sx in (-1, 1)
            for sy in (-1, 1)]  # fmt: skip
    top, slot = h + 0.008, look.between(0.6, 0.74)
    slots = [box(slot * x, 0.024, 0.002).move(y=s * 0.024, z=top - 0.0008) for s in (-1, 1)]
    lever = box(0.014, 0.03, 0.012).move(x=x / 2 + 0.006, z=look.between(0.5, 0.75) * h)
    rail = box(0.001, 0.008, 0.5 * h).move(x=x / 2 + 0.0003, z=0.24 * h)
    dial = cylinder(0.013, 0.01, 18, bevel=0.002).turn(1, np.pi / 2).move(x=x / 2, z=0.2 * h)
    pieces = [(body, skin), *((s, dark) for s in (*feet, *slots, lever, rail, dial))]
    front = int(look.rng.integers(4))
    if front == 1:  # a band of another colour with a name
        sign = prints.canvas(256, 48, look.own_color("white", "black", "gold", "charcoal"))
        prints.write(sign, look.pick(["TOAST", "CRISPY", "RETRO", "DAILY"]), 0.5, 0.5, 0.5,
                     tint_color(color, 0.6))  # fmt: skip
        pieces.append((box(0.7 * x, 0.0016, 0.045).move(y=-y / 2, z=0.35 * h), sign))
    elif front == 2:  # ends of another colour
        caps = [box(0.02, 0.9 * y, 0.72 * h).move(s * (x / 2 - 0.009), 0, 0.012) for s in (-1, 1)]
        pieces += [(cap, dark) for cap in caps]
    elif front == 3:
        lines = [
            box(0.8 * x, 0.0016, 0.004).move(y=-y / 2, z=(0.3 + 0.1 * k) * h) for k in (0, 1, 2)
        ]
        pieces += [(line, textures.plain(tint_color(color, 0.6))) for line in lines]
    if look.chance(0.5):
        crust = textures.gradient((200, 150, 88), (232, 196, 140), look.rng)
        toast = block(0.1, 0.013, 0.05, 0.005, 0.002)
        pieces += [
            (toast.move(y=s * 0.024, z=top - 0.012), crust) for s in look.pick([(1,), (-1, 1)])
        ]
    return shape(
        pieces,
        [
            box_part(0.82 * x, 0.8 * y, 0.012),
            hull_of(body),
            hull_of(lever),
        ],
    )


def rolling_pin(look: Look) -> Shape:
    """A wooden rolling pin lying down."""
    r, long = look.between(0.024, 0.029), look.between(0.36, 0.42)
    wood = look.surface(look.color("wooden", "tan", "beige"), "wood")
    profile = [(0, 0), (0.008, 0.002), (0.013, 0.03), (0.008, 0.085), (0.008, 0.09), (r, 0.092)]
    mirrored = [(radius, long - z) for radius, z in profile[::-1]]
    body = lathe([*profile, *mirrored], 24).turn(1, np.pi / 2).move(x=-long / 2, z=r)
    return shape(
        [(body, wood)],
        [box_part(long - 0.19, 1.5 * r, 2 * r),
         *[box_part(0.08, 0.018, 0.018, (side * (long / 2 - 0.045), 0, r - 0.009))
           for side in (-1, 1)]],
    )  # fmt: skip


def whisk(look: Look) -> Shape:
    """A balloon whisk lying down, wires to the left."""
    steel = textures.brushed_metal(look.rng, (190, 193, 198))
    skin = look.surface(look.color("black", "silver", "wooden", "red", "teal"), "plastic")
    wide, long = look.between(0.03, 0.036), 0.15
    grip = cylinder(0.0085, 0.12, 16, top=0.011, bevel=0.002).turn(1, np.pi / 2).move(x=0.02)
    pieces = [(grip, skin)]
    for k in range(4):
        t = np.linspace(0, np.pi, 13)
        x = 0.03 - long * np.sin(t / 2) ** 0.8
        half = np.concatenate([t, t[-2::-1]])
        reach = wide * np.sin(half)
        side = np.where(np.arange(len(half)) < len(t), 1, -1)
        path = np.column_stack([np.concatenate([x, x[-2::-1]]), side * reach, np.zeros(len(half))])
        wire = tube(path, 0.0011, 5).turn(0, np.pi / 4 * k)
        pieces.append((wire, steel))
    lean = np.arctan2(wide - 0.011, 0.21)  # it rests on the wires and the end of its grip
    turned = [(solid.turn(1, lean), tile) for solid, tile in pieces]
    low = min(solid.bounds[0, 2] for solid, _ in turned)
    turned = [(solid.move(z=-low), tile) for solid, tile in turned]
    balloon = np.concatenate([solid.vertices for solid, _ in turned[1:]])
    return shape(
        turned,
        [flat_foot(balloon[np.abs(balloon[:, 0] + 0.075) < 0.04], 0.15), hull_of(turned[0][0])],
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
    Category("pot", pot, (0.265, 0.21, 0.13), 1.1, ("cooking pot", "saucepan", "stockpot",
             "billy can", "billycan"), ("kitchen",), ("big",), ("silver", "red")),
    Category("pan", pan, (0.4, 0.225, 0.062), 0.9, ("frying pan", "skillet", "bed warmer",
             "copper pan"), ("kitchen",), ("container", "big"), ("charcoal",)),
    Category("cutting_board", cutting_board, (0.36, 0.2, 0.017), 0.7, ("chopping board", "board",
             "cheese board", "wooden board", "rolling board", "drawing board"), ("kitchen",),
             ("support", "flat", "big"), ("wooden",), state="lying flat"),
    Category("toaster", toaster, (0.285, 0.168, 0.2), 1.4, (), ("kitchen",), ("big",), ("silver",
             "red")),
    Category("rolling_pin", rolling_pin, (0.39, 0.053, 0.053), 0.45, ("dough roller",), ("kitchen",
             ), (), ("wooden",), state="lying down"),
    Category("whisk", whisk, (0.26, 0.066, 0.066), 0.09, ("egg beater", "balloon whisk"),
             ("kitchen",), (), ("silver", "black"), state="lying down"),
    Category("coaster", coaster, (0.095, 0.095, 0.007), 0.04, ("drink coaster", "cork tile",
             "mosaic tile", "tile", "tessera", "wall tile", "felt coaster", "pop socket",
             "coaster set"), ("coffee", "living", "dining"), ("support", "flat"), ("tan",),
             state="lying flat"),
)  # fmt: skip
