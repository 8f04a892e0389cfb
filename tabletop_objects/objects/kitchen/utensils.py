"""Objects of the ``kitchen`` theme: utensils."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import ellipse, rectangle, rounded_polygon, smooth
from ...kit.parts import (
    box_part,
    cylinder_part,
    flat_foot,
    hull_above,
    hull_of,
    hull_part,
    open_vessel,
    ring_parts,
)
from ...kit.primitives import ball, bent_rod, limb, lobe, straight
from ...kit.shapes import Category, Pieces, Shape, category, keep_still, settle, shape, vary
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    prism,
    sweep,
    torus,
    tube,
)
from ...kit.surfaces import RGB, Look, tint_color
from ...values import ConvexPart
from .appliances import metal

STEEL: RGB = (188, 191, 196)


@category("burger_press", size=(0.122, 0.122, 0.0785), mass=0.4, material="metal",
          aliases=("patty press", "hamburger press", "bacon press"), themes=("kitchen",),
          roles=("round",), colors=("silver",))  # fmt: skip
def burger_press(look: Look) -> Shape:
    """A burger press: a round metal plate with a handle on top."""
    k = look.between(0.94, 1.08)
    color = look.color("silver", "black", "red")
    dish = lathe(
        [(0, 0), (0.058, 0), (0.062, 0.004), (0.062, 0.022), (0.05, 0.027), (0, 0.028)], 36
    )
    post = cylinder(0.008, 0.03, 14).move(z=0.026)
    knob = lathe([(0, 0.052), (0.014, 0.052), (0.023, 0.066), (0.018, 0.078), (0, 0.08)], 24)
    rings = [torus(r, 0.0012, 32, 5).move(z=0.0275) for r in (0.024, 0.036)]
    return shape([(join([dish, *rings]), surfaces.brushed_metal(look.rng, color)),
                  (post, surfaces.brushed_metal(look.rng, STEEL)),
                  (knob, surfaces.wood(look.rng, (120, 78, 48)))],
                 [hull_of(dish), hull_of(post), hull_of(knob)]).scale(k)  # fmt: skip


@category("meat_claw", size=(0.12, 0.112, 0.0232), mass=0.08, material="plastic", assembled=True,
          aliases=("bear claw shredder", "meat shredder", "shredding claw", "bbq claw"),
          themes=("kitchen",), colors=("black",), state="lying flat")  # fmt: skip
def meat_claw(look: Look) -> Shape:
    """A meat claw lying flat: a grip with long, curved prongs."""
    k = look.between(0.94, 1.06)
    color = look.color("black", "black", "red", "wooden")
    grip = bent_rod(0.11, 0.013, blunt=7).turn(2, np.pi / 2)
    plate = block(0.03, 0.095, 0.008, 0.004).move(x=0.018, z=-0.004)
    prongs = [limb([(0.028, y, 0), (0.075, y, 0.004), (0.105, y, -0.008)], [0.0045, 0.004, 0.001],
                   7) for y in np.linspace(-0.04, 0.04, 6)]  # fmt: skip
    return settle([(join([grip, plate]), look.surface(color, "plastic")),
                   (join(prongs), surfaces.plain((44, 44, 48)))], 0.1,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip


@category("corn_holder", size=(0.0704, 0.0243, 0.0172), mass=0.008, material="metal",
          assembled=True, aliases=("corn skewer", "corn fork", "corn cob holder"),
          themes=("kitchen",), colors=("yellow",), state="lying flat")  # fmt: skip
@vary()
def corn_holder(look: Look) -> Shape:
    """A corn holder lying flat: a tiny yellow cob with two pins."""
    k = look.between(0.95, 1.2)
    color = look.color("yellow", "yellow", "green")
    cob = bent_rod(0.036, 0.0095, blunt=3.5)
    pins = [straight((0.015, s * 0.004, 0), (0.042, s * 0.004, 0), [0.0012, 0.0006], 6)
            for s in (-1, 1)]  # fmt: skip
    husk = [ball(0.024, 0.009, 0.006, (-0.012, s * 0.007, 0.004), 8) for s in (-1, 1)]
    tile = surfaces.fit(surfaces.spots(look.rng, color, tint_color(color, 0.8), 0.35), 64, 64)
    return settle([(cob, tile), (join(pins), surfaces.plain((196, 198, 202))),
                   (join(husk), surfaces.plain((104, 160, 70)))], 0.14,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip


GRIPS = ("black", "red", "teal", "white", "navy", "sage", "gray")


@category("sieve", size=(0.35, 0.164, 0.0563), mass=0.18, material="metal", hollow=True,
          aliases=("strainer", "mesh strainer", "flour sifter", "sifter", "fine mesh sieve",
          "mesh sieve"), themes=("kitchen",), roles=("container", "big"),
          colors=("silver", "black"))  # fmt: skip
def sieve(look: Look) -> Shape:
    """A round mesh sieve with a long handle, resting with its bowl down."""
    r, h = look.between(0.07, 0.09), look.between(0.045, 0.058)
    color = look.color(*GRIPS, "silver")
    t = np.linspace(0.15, np.pi / 2, 6)
    outer = [(r * np.sin(a), h * (1 - np.cos(a))) for a in t]
    inner = [(max(x - 0.0016, 0.001), max(z, 0.0016)) for x, z in outer]
    inner[0] = (outer[0][0] - 0.0016, outer[0][1] + 0.0016)
    cup = lathe([(0, 0), *outer, *inner[::-1], (0, 0.0016)], 32)
    mesh = surfaces.grid((122, 126, 130), (206, 209, 213), 40, 64, 128)
    rim = torus(r, 0.0034, 36, 8).move(z=h)
    bar = tube([(r, 0, h), (r + 0.03, 0, h), (r + 0.07, 0, 0.86 * h)], 0.0035, 8)
    grip = limb([(r + 0.05, 0, 0.9 * h), (r + 0.09, 0, 0.72 * h), (r + 0.16, 0, 0.2 * h),
                 (r + 0.165, 0, 0.17 * h)], [0.006, 0.0095, 0.009, 0.005], 12)  # fmt: skip
    hook = tube(smooth([(-r, -0.014, h), (-r - 0.02, 0, h), (-r, 0.014, h)], 4), 0.002, 6)
    steel = bright_steel(look)
    walls = ring_parts([outer[0], outer[2], outer[4], outer[5]], [inner[5], inner[2]])
    low = cylinder_part(outer[2][0] * 0.9, outer[2][1])
    return shape(
        [(cup, mesh), (join([rim, bar, hook]), steel), (grip, look.surface(color))],
        [*walls, low, cylinder_part(outer[0][0], 0.004), hull_of(grip), hull_of(hook)],
    )


@category("garlic_press", size=(0.177, 0.03, 0.0576), mass=0.2, material="metal",
          aliases=("garlic crusher",), themes=("kitchen",), colors=("silver",),
          state="lying flat")  # fmt: skip
def garlic_press(look: Look) -> Shape:
    """A garlic press lying flat, with its handles slightly open on the right."""
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
                  (join(holes), surfaces.plain((60, 60, 62)))],
                 [hull_of(cup), hull_above(low), hull_of(high)])  # fmt: skip


@category("potato_masher", size=(0.0862, 0.0761, 0.243), mass=0.18, material="metal",
          assembled=True, aliases=("masher",), themes=("kitchen",), roles=("tall",),
          colors=("black", "silver"))  # fmt: skip
def potato_masher(look: Look) -> Shape:
    """A potato masher standing on its zigzag or perforated plate."""
    h = look.between(0.23, 0.27)
    color = look.color(*GRIPS, "wooden")
    steel = bright_steel(look)
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
        pieces.append((join(holes), surfaces.plain((70, 72, 76))))
    return shape(pieces, [hull_above(*foot), hull_of(*arms), hull_of(grip)])


@category("citrus_juicer", size=(0.179, 0.126, 0.056), mass=0.2, material="plastic",
          aliases=("lemon squeezer", "juice squeezer", "citrus squeezer", "lemon juicer",
          "orange squeezer", "orange juicer", "citrus press", "reamer", "juicer", "lime squeezer",
          "lemon press"), themes=("kitchen",), roles=("round",),
          colors=("yellow", "white"))  # fmt: skip
def citrus_juicer(look: Look) -> Shape:
    """A citrus juicer: a ridged cone in a dish with a spout and a handle."""
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


@category("skewer", size=(0.27, 0.0194, 0.00298), mass=0.006, material="wood", assembled=True,
          aliases=("kebab skewer", "bamboo skewer"), themes=("kitchen",), colors=("tan", "silver"),
          state="lying flat")  # fmt: skip
def skewer(look: Look) -> Shape:
    """A bare skewer of wood or steel, lying flat."""
    long = look.between(0.22, 0.27)
    color = look.color("tan", "wooden", "silver")
    skin = look.surface(color, "metal" if color[2] > 150 else "wood")
    rod = limb([(-0.5 * long, 0, 0), (-0.46 * long, 0, 0), (0, 0, 0), (0.5 * long, 0, 0)],
               [0.0003, 0.0016, 0.0017, 0.0017], 8)  # fmt: skip
    ring = torus(0.008, 0.0017, 18, 8).move(x=0.5 * long + 0.008)
    return settle([(rod, skin), (ring, skin)], 0.14)


@category("pastry_brush", size=(0.217, 0.0401, 0.0158), mass=0.05, material="wood",
          aliases=("basting brush", "baking brush", "kitchen brush"), themes=("kitchen",),
          roles=("flat",), colors=("wooden",), state="lying flat")  # fmt: skip
def pastry_brush(look: Look) -> Shape:
    """A pastry brush with bristles or silicone strands, lying flat."""
    long, wide = look.between(0.19, 0.23), look.between(0.032, 0.042)
    color = look.color("wooden", "red", "black", "teal", "wooden")
    handle = look.surface(color, "wood")
    hair = look.own_color("cream", "red", "white", "tan")
    grip = sweep([(-0.14 * long, 0, 0.006), (0.02 * long, 0, 0.006), (0.2 * long, 0, 0.006),
                  (0.5 * long, 0, 0.006)], rectangle(0.02, 0.011, 0.004, 3),
                 [1.5, 0.9, 1.1, 0.8])  # fmt: skip
    band = block(0.03, wide, 0.012, 0.003).move(x=-0.17 * long)
    strands = [sweep([(-0.2 * long, y, 0.006), (-0.5 * long, 1.15 * y, 0.0055)],
                     rectangle(wide / 11, 0.009, 0.001, 1), [1, 0.8])
               for y in np.linspace(-0.44, 0.44, 9) * wide]  # fmt: skip
    steel = surfaces.brushed_metal(look.rng, (192, 195, 200))
    return settle([(grip, handle), (band, steel), (join(strands), surfaces.plain(hair))], 0.04,
                  hulls=[[0], [1], [2]])  # fmt: skip


@category("cutting_board", size=(0.36, 0.2, 0.017), mass=0.7, material="wood",
          aliases=("chopping board", "board", "cheese board", "wooden board", "rolling board",
          "drawing board"), themes=("kitchen",), roles=("support", "flat", "big"),
          colors=("wooden",), state="lying flat", common=True)  # fmt: skip
def cutting_board(look: Look) -> Shape:
    """A rectangular, rounded or paddle-shaped cutting board of wood, plastic or slate."""
    x, y, h = look.between(0.26, 0.34), look.between(0.17, 0.23), look.between(0.011, 0.022)
    color = look.color("wooden", "tan", "beige", "brown", "bronze")
    kind = int(look.rng.integers(5))
    tile = look.surface(color, "wood")
    if not look.material and kind == 1:
        tile = surfaces.wood(look.rng, color, planks=5)
    elif not look.material and kind == 2:
        tone = [tint_color(color, k) for k in (0.62, 1.0, 1.25)]
        tile = surfaces.stripes(tone, 3, side=96)
    elif not look.material and kind == 3:
        plastic = look.color("white", "sage", "red", "sky", "yellow", "charcoal")
        tile = surfaces.scratches(look.rng, plastic, tint_color(plastic, 0.85), 30)
    radius, long = look.between(0.006, 0.05), look.between(0.07, 0.1)
    board = prism(rectangle(x, y, radius), 0, h, 0.002)
    hole_tile = surfaces.plain(tint_color(color, 0.3))
    if look.chance(0.4):  # boards without a handle have a slot and a groove around them
        slot = block(0.014, 0.07, 0.0006, 0.007).move(x=0.43 * x, z=h - 0.0002)
        return shape([(board, tile), (slot, hole_tile)], [box_part(x, y, h)])
    grip = prism(rectangle(long, look.between(0.04, 0.07), 0.02), 0.0005, h - 0.0005, 0.002)
    grip = grip.move(x=x / 2 + 0.25 * long)
    hole = cylinder(0.009, h, 20).move(x=x / 2 + 0.5 * long)
    return shape([(board, tile), (grip, tile), (hole, hole_tile)],
                 [box_part(x, y, h), box_part(0.75 * long, 0.04, h - 0.001,
                                              (x / 2 + 0.375 * long, 0, 0.0005))])  # fmt: skip


@category("rolling_pin", size=(0.39, 0.053, 0.053), mass=0.45, material="wood",
          aliases=("dough roller",), themes=("kitchen",), colors=("wooden",), state="lying down",
          common=True)  # fmt: skip
def rolling_pin(look: Look) -> Shape:
    """A wooden rolling pin, lying flat."""
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


@category("whisk", size=(0.26, 0.066, 0.066), mass=0.09, material="metal",
          aliases=("egg beater", "balloon whisk"), themes=("kitchen",), colors=("silver", "black"),
          state="lying down", common=True)  # fmt: skip
def whisk(look: Look) -> Shape:
    """A balloon whisk lying flat with its wires on the left."""
    steel = surfaces.brushed_metal(look.rng, (190, 193, 198))
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
    lean = np.arctan2(wide - 0.011, 0.21)  # rests on the wires and the end of the grip
    turned = [(solid.turn(1, lean), tile) for solid, tile in pieces]
    low = min(solid.bounds[0, 2] for solid, _ in turned)
    turned = [(solid.move(z=-low), tile) for solid, tile in turned]
    balloon = np.concatenate([solid.vertices for solid, _ in turned[1:]])
    return shape(turned, [flat_foot(balloon[np.abs(balloon[:, 0] + 0.075) < 0.04], 0.15),
                          hull_of(turned[0][0])])  # fmt: skip


SPATULA_GRIPS = ("black", "red", "teal", "wooden", "white", "navy", "sage", "silver")


def bright_steel(look: Look) -> surfaces.Tile:
    """Return a texture of bright brushed steel."""
    return surfaces.brushed_metal(look.rng, (192, 195, 200))


def grip_bar(start: float, stop: float, wide: float, z: float) -> Solid:
    """Return a rounded handle along x from ``start`` to ``stop``, centred at height ``z``."""
    t = np.linspace(0, 1, 7)
    x = start + (stop - start) * t
    scale = wide * (0.72 + 0.28 * np.sin(np.pi * (0.15 + 0.85 * t)))
    scale[-1] *= 0.6
    path = np.column_stack([x, np.zeros(7), np.full(7, z)])
    return sweep(path, rectangle(1.0, 0.62, 0.26, 3), scale)


def _slices(solid: Solid, edges: list[float]) -> list[ConvexPart]:
    x = solid.vertices[:, 0]
    return [hull_part(solid.vertices[(x >= a - 1e-6) & (x <= b + 1e-6)])
            for a, b in itertools.pairwise(edges)]  # fmt: skip


@category("spatula", size=(0.306, 0.0711, 0.0214), mass=0.09, material="plastic", aliases=("turner",
          "fish slice", "egg flipper", "slotted spatula", "pancake turner", "rubber spatula",
          "wooden spatula", "slotted turner"), themes=("kitchen",), roles=("flat",),
          colors=("black", "red"), state="lying flat")  # fmt: skip
def spatula(look: Look) -> Shape:
    """A spatula lying flat: a slotted steel turner, a silicone scraper or a wooden spatula."""
    kind = look.pick(["turner", "turner", "scraper", "wooden"])
    color = look.color(*SPATULA_GRIPS)
    long = look.between(0.28, 0.33)
    head, tip = look.between(0.085, 0.1), -0.5 * long
    if kind == "wooden":
        wood = look.surface(look.color("wooden", "tan", "brown", "beige"), "wood")
        outline = rounded_polygon(np.array([(tip, -0.032), (tip + head, -0.026),
                                            (tip + head, 0.026), (tip, 0.032)]), 0.008)  # fmt: skip
        plate = prism(outline, 0, 0.006, 0.002)
        rod = sweep([(tip + head - 0.02, 0, 0.004), (0.0, 0, 0.006), (0.5 * long, 0, 0.006)],
                    rectangle(0.016, 0.008, 0.003, 2), [0.9, 0.9, 1.2])  # fmt: skip
        return shape([(plate, wood), (rod, wood)], [hull_of(plate), hull_of(rod)])
    skin = look.surface(color, "plastic")
    if kind == "scraper":
        plate = prism(rectangle(head, 0.056, 0.018, 4), 0, 0.009, 0.003).move(x=tip + head / 2)
        stem = sweep([(tip + head - 0.015, 0, 0.0045), (0.0, 0, 0.007)],
                     rectangle(0.014, 0.007, 0.003, 2))  # fmt: skip
        grip = grip_bar(-0.005, 0.5 * long, 0.024, 0.0082)
        other = look.surface(look.own_color("wooden", "white", "charcoal", "silver"), "wood")
        return shape([(plate, skin), (join([stem, grip]), other)],
                     [hull_of(plate), hull_of(stem, grip)])  # fmt: skip
    count, wide = look.pick([4, 5]), look.between(0.07, 0.085)
    bar, pitch = box(0.7 * head, 0.5 * wide / count, 0.002), wide - 0.5 * wide / count
    bars = [bar.move(tip + head / 2, (k / count - 0.5) * pitch) for k in range(count + 1)]
    ends = [box(0.17 * head, wide, 0.002).move(x=tip + u * head) for u in (0.085, 0.915)]
    steel = bright_steel(look) if look.chance(0.6) else surfaces.plain((44, 45, 49))
    neck = sweep(smooth([(tip + 0.95 * head, 0, 0.0025), (tip + head + 0.02, 0, 0.012),
                         (0.02, 0, 0.02)], 3), rectangle(0.013, 0.004, 0.0015, 2))  # fmt: skip
    grip = grip_bar(0.0, 0.5 * long, 0.024, 0.0)
    lean = np.arctan2(0.013, 0.5 * long)
    grip = grip.turn(1, lean).move(z=0.0215)
    return shape(
        [(join([*bars, *ends, neck]), steel), (grip, skin)],
        [box_part(head, wide, 0.002, (tip + head / 2, 0, 0)), hull_of(neck), hull_of(grip)],
    )


@category("tongs", size=(0.29, 0.08, 0.02), mass=0.13, material="metal", assembled=True,
          aliases=("kitchen tongs", "cooking tongs", "pair of tongs", "serving tongs",
          "barbecue tongs", "sugar nips"), themes=("kitchen",), roles=("flat",),
          colors=("silver", "black"), state="lying flat")  # fmt: skip
def tongs(look: Look) -> Shape:
    """Open kitchen tongs lying flat with their heads on the left."""
    long, gap = look.between(0.23, 0.3), look.between(0.03, 0.045)
    color = look.color(*SPATULA_GRIPS)
    steel, skin = bright_steel(look), look.surface(color, "plastic")
    arms, grips, parts = [], [], []
    for s in (-1, 1):
        path = [(0.5 * long, s * 0.006, 0.01), (0.1 * long, s * 0.75 * gap, 0.01),
                (-0.28 * long, s * gap, 0.01), (-0.5 * long, s * (gap - 0.006), 0.01)]  # fmt: skip
        arm = sweep(smooth(path, 3), rectangle(0.0026, 0.02, 0.0008, 1))
        hand = sweep([(0.3 * long, s * 0.43 * gap, 0.01), (0.08 * long, s * 0.76 * gap, 0.01)],
                     rectangle(0.009, 0.02, 0.003, 2))  # fmt: skip
        head = prism(ellipse(0.05, 0.02, 14), 0, 0.003).turn(0, np.pi / 2)
        head = head.turn(2, -s * 0.14).move(-0.5 * long + 0.012, s * (gap - 0.006), 0.01)
        arms += [arm, head]
        grips.append(hand)
        parts += [*_slices(arm, [-0.5 * long - 0.02, -0.2 * long, 0.52 * long]), hull_of(head)]
    ring = torus(0.009, 0.0016, 16, 6).move(x=0.5 * long + 0.009, z=0.01)
    hinge = cylinder(0.007, 0.02, 14).move(x=0.5 * long)
    return shape(
        [(join([*arms, ring, hinge]), steel), (join(grips), skin)], [*parts, hull_of(hinge)]
    )


@category("ricer", size=(0.268, 0.0832, 0.105), mass=0.5, material="metal",
          aliases=("potato ricer", "potato press", "spaetzle press"), themes=("kitchen",),
          colors=("silver",), state="lying")  # fmt: skip
@keep_still
def ricer(look: Look) -> Shape:
    """A potato ricer lying flat: a perforated cup between two long handles."""
    k, color = (look.between(0.9, 1.08), look.color("silver", "black", "red", "green", "blue",
                                                    "white"))  # fmt: skip
    cup = lathe(
        [(0, 0), (0.038, 0), (0.042, 0.07), (0.039, 0.07), (0.035, 0.003), (0, 0.003)], 26
    ).move(-0.06, 0, 0)
    press = cylinder(0.036, 0.012, 24).move(-0.06, 0, 0.075)
    arms = [tube(smooth([(-0.02, 0, 0.062), (0.06, 0, 0.05), (0.16, 0, 0.012)], 4), 0.006, 8)]
    link = tube([(-0.105, 0, 0.064), (-0.06, 0, 0.1), (0.02, 0, 0.085), (0.16, 0, 0.068)], 0.006, 8)
    made = [(join([cup]), prints.mesh_holes((196, 200, 206), (90, 94, 100), 14, 34)),
            (join([press, *arms, link]), look.surface(color, "steel"))]  # fmt: skip
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.0, hulls=[[0], [1]])


APPLE_CORER_STEEL: RGB = (188, 192, 198)
HUES = ("black", "red", "wooden", "gray", "teal", "blue", "green", "white", "wooden")
Head = Callable[[Look, RGB, float], Pieces]
"""Makes the head that starts at x = 0 and reaches to the left, at height z."""


def with_handle(
    head: Head,
    grip: tuple[float, float],
    neck: float,
    palette: tuple[str, ...] = HUES,
    r: float = 0.009,
) -> Callable[[Look], Shape]:
    """Return the shape function of a tool that lies flat and has the given head, neck and grip."""

    def make(look: Look) -> Shape:
        long, color = look.between(*grip), look.color(*palette)
        size = look.between(0.92, 1.08)
        kind = look.pick(["straight", "waisted", "swelling"])
        radii = {"straight": [0.9, 1, 1, 1, 0.8], "waisted": [1, 0.75, 0.9, 1.15, 0.7],
                 "swelling": [0.7, 0.9, 1.1, 1.2, 0.8]}[kind]  # fmt: skip
        x = np.linspace(neck, neck + long, 5)
        z = r * 1.2
        handle = limb(np.column_stack([x, 0 * x, 0 * x + z]), [r * k for k in radii], 12)
        pieces: Pieces = [(handle, look.surface(color, "wood" if color[0] > 1.25
                                                * color[2] and look.chance(0.6)
                                                else "plastic"))]  # fmt: skip
        if neck > 0:
            pieces.append((tube([(-0.004, 0, z), (neck + 0.01, 0, z)], 0.32 * r, 8),
                           surfaces.plain(APPLE_CORER_STEEL)))  # fmt: skip
        pieces += head(look, color, z)
        return settle(pieces, 0.02, hulls=[[0], list(range(1, len(pieces)))]).scale(size)

    return make


def steel(look: Look) -> surfaces.Tile:
    """Return a texture of brushed steel."""
    return surfaces.brushed_metal(look.rng, APPLE_CORER_STEEL)


def _mallet(look: Look, color: RGB, z: float) -> Pieces:
    head = box(0.05, 0.055, 0.05).move(-0.02, 0, -0.0145 + z - 0.0105)
    spikes = [cylinder(0.006, 0.006, 4, top=0.0005).turn(2, np.pi / 4).turn(0,
        s * -np.pi / 2).move(-0.02 + 0.0115 * i, s * 0.0275 * -1, z + 0.0115 * j)
              for s in (-1, 1) for i in range(-1, 2) for j in range(-1, 2)]  # fmt: skip
    return [(head.move(z=0.0), steel(look)),
            (join(spikes), surfaces.plain(tint_color(APPLE_CORER_STEEL, 0.8)))]  # fmt: skip


@category("cherry_pitter", size=(0.21, 0.068, 0.0321), mass=0.12, material="plastic",
          aliases=("olive pitter", "cherry stoner", "cherry pit remover"), themes=("kitchen",),
          colors=("red",), state="lying")  # fmt: skip
@keep_still
def cherry_pitter(look: Look) -> Shape:
    """A cherry pitter lying flat: two sprung handles, a ring with a cherry and a plunger."""
    k, color = look.between(0.9, 1.12), look.color("red", "black", "silver", "green")
    arms = [tube(smooth([(-0.04, s * 0.012, 0.012), (0.0, s * 0.022, 0.012),
                         (0.06, s * 0.026, 0.012), (0.11, s * 0.018, 0.012)], 4), 0.0075, 9)
            for s in (-1, 1)]  # fmt: skip
    ring = (lathe([(0.011, 0), (0.016, 0), (0.016, 0.01), (0.011, 0.01)], 22,
                  loop=True).turn(0, np.pi / 2).move(-0.05, -0.004, 0.016))  # fmt: skip
    cherry = ellipsoid(0.022, 0.022, 0.022, 16, 10).move(-0.05, -0.009, 0.016)
    pin = tube([(-0.05, 0.022, 0.016), (-0.05, 0.004, 0.016)], 0.0025, 7)
    bow = torus(0.02, 0.005, 20, 7).scale(1, 1.1, 1).move(0.115, 0, 0.012)
    made = [(join(arms), look.surface(color, "plastic")), (join([ring, pin, bow]), metal(look)),
            (cherry, surfaces.speckles(look.rng, (150, 20, 40), 8))]  # fmt: skip
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.02, hulls=[[0], [1]])


@category("toothpick", size=(0.0656, 0.00214, 0.00214), mass=0.0002, material="wood",
          aliases=("wooden toothpick",), themes=("kitchen",), colors=("tan",),
          state="lying")  # fmt: skip
def toothpick(look: Look) -> Shape:
    """A thin wooden toothpick with two points, lying flat."""
    long, r = look.between(0.06, 0.07), look.between(0.0009, 0.0012)
    color = look.color("tan", "wooden", "beige", "amber", "cream", "brown")
    pick = lathe([(0, 0), (0.7 * r, 0.12 * long), (r, 0.25 * long), (r, 0.75 * long),
                  (0.7 * r, 0.88 * long), (0, long)], 8)  # fmt: skip
    pick = pick.turn(1, np.pi / 2).move(-long / 2, 0, r)
    return shape([(pick, look.surface(color, "wood"))], [box_part(0.9 * long, 2 * r, 2 * r)])


@category("cocktail_pick", size=(0.0936, 0.0124, 0.00407), mass=0.0006, material="wood",
          assembled=True, aliases=("cocktail stick", "party pick", "olive pick", "sandwich pick",
          "food pick", "flag pick"), themes=("kitchen",), colors=("red",),
          state="lying")  # fmt: skip
def cocktail_pick(look: Look) -> Shape:
    """A cocktail stick with a bead or a small flag at one end, lying flat."""
    long, r = look.between(0.08, 0.11), look.between(0.0009, 0.0012)
    color = look.color("red", "green", "gold", "blue", "white", "pink")
    pick = (lathe([(0, 0), (r, 0.2 * long), (r, long), (0, long)],
                  8).turn(1, np.pi / 2).move(-long / 2, 0, r + 0.002))  # fmt: skip
    pieces: Pieces = [(pick, surfaces.plain((226, 196, 146)))]
    if look.chance(0.5):
        pieces.append((ellipsoid(0.008, 0.008, 0.008, 12, 8).move(long / 2 - 0.002, 0, 0.003),
                       look.surface(color, "plastic")))  # fmt: skip
    else:
        flag = prism(
            [(-0.016, 0.0), (0.0, 0.0), (0.0, 0.014), (-0.016, 0.014), (-0.011, 0.007)], 0, 0.001
        )
        pieces.append((flag.move(long / 2 - 0.004, 0, r + 0.0015), look.surface(color, "paper")))
    made = settle(pieces, 0.02)
    points = np.concatenate([p.solid.vertices for p in made.pieces])
    x, y, z = (float(side) for side in np.ptp(points, axis=0) * [0.9, 0.9, 0.8])
    middle = float(points[:, 1].min() + points[:, 1].max()) / 2
    return Shape(made.pieces, (box_part(x, y, z, (0, middle, 0)),))


def _leaf_plate(look: Look, color: RGB, z: float) -> Pieces:
    plate = prism(smooth([(0, -0.006), (0, 0.006), (-0.03, 0.024), (-0.08, 0.02), (-0.1, 0),
                          (-0.08, -0.02), (-0.03, -0.024)], 3), 0, 0.002)  # fmt: skip
    holes = [cylinder(0.002 + 0.0006 * n, 0.0006, 12).move(-0.025 - 0.016 * (n % 4), (n // 4 - 0.5)
                                                           * 0.02, 0.0017)
             for n in range(8)]  # fmt: skip
    return [(plate.move(z=z - 0.001), steel(look)), (join([h.move(z=z - 0.001) for h in holes]),
                                                     surfaces.plain((30, 30, 34)))]  # fmt: skip


def _separator(look: Look, color: RGB, z: float) -> Pieces:
    cup = lathe([(0, -0.018), (0.02, -0.014), (0.033, 0.004), (0.031, 0.004), (0.019, -0.012),
                 (0, -0.016)], 24).move(-0.034, 0, z)  # fmt: skip
    slots = [torus(0.026, 0.0018, 30, 5).move(-0.034, 0, z - 0.003),
             torus(0.017, 0.0012, 24, 5).move(-0.034, 0, z - 0.0115)]  # fmt: skip
    return [(cup, surfaces.plain(tint_color(color, 1.2))),
            (join(slots), surfaces.plain((30, 30, 32)))]  # fmt: skip


def _balloon(look: Look, color: RGB, z: float) -> Pieces:
    """Return the graduated tube of a baster, with its tapered tip, at height ``z``."""
    pipe = (lathe([(0, 0), (0.011, 0), (0.0115, 0.13), (0.004, 0.17), (0.003, 0.2), (0, 0.2)],
                  18).turn(1, -np.pi / 2).move(0.0, 0, z))  # fmt: skip
    image = prints.canvas(96, 24, (214, 226, 230))
    for n in range(9):
        prints.fill(image, 0.1, 0.08 + 0.07 * n, 0.4, 0.02, (70, 80, 90))
    return [(pipe, surfaces.fit(image, 64, 64))]


def _curl(look: Look, color: RGB, z: float) -> Pieces:
    loop = tube(smooth([(0, -0.004, z), (-0.02, -0.018, z), (-0.05, -0.016, z), (-0.062, 0, z),
                        (-0.05, 0.016, z), (-0.02, 0.018, z), (0, 0.004, z)], 4), 0.0022,
                7)  # fmt: skip
    return [(loop, steel(look))]


def _matcha(look: Look, color: RGB, z: float) -> Pieces:
    tines = [limb([(0, 0.011 * np.cos(a), z + 0.011 * np.sin(a)), (-0.03, 0.02 * np.cos(a),
        z + 0.02 * np.sin(a)), (-0.06, 0.024 * np.cos(a), z + 0.024 * np.sin(a)),
                   (-0.068, 0.019 * np.cos(a), z + 0.019 * np.sin(a))],
                   [0.0016, 0.0014, 0.001, 0.0008],
                   4) for a in 2 * np.pi * np.arange(24) / 24]  # fmt: skip
    thread = torus(0.0125, 0.0018, 18, 6).turn(1, np.pi / 2).move(-0.004, 0, z)
    return [(join(tines), surfaces.plain((226, 202, 140))), (thread, surfaces.plain((40, 34, 34)))]


def _spatula_scraper(look: Look, color: RGB, z: float) -> Pieces:
    return [(prism(rectangle(0.09, 0.06, 0.012), 0, 0.006).move(-0.045, 0, z - 0.003),
             surfaces.plain(tint_color(color, 1.2)))]  # fmt: skip


@category("colander", size=(0.289, 0.223, 0.119), mass=0.35, material="metal", hollow=True,
          aliases=("pasta strainer", "salad strainer", "drainer"), themes=("kitchen",),
          roles=("container", "round", "big"), colors=("silver", "white"))  # fmt: skip
def colander(look: Look) -> Shape:
    """A colander: a perforated bowl on feet with two handles."""
    r, h = look.between(0.1, 0.12), look.between(0.085, 0.105)
    color = look.color("silver", "silver", "white", "red", "mint", "sky", "cream", "yellow")
    t = np.linspace(0, np.pi / 2, 8)
    side = [((0.5 + 0.5 * np.sin(a)) * r, h * (1 - np.cos(a)) ** 0.85) for a in t]
    body, parts = open_vessel(side, 0.003, 0.004, 34)
    skin = surfaces.fit(look.surface(color, "metal"), 256, 256).copy()
    v, u = np.mgrid[0:256, 0:256] / 256
    count, rows = 30, 26
    dots = np.hypot((u * count + 0.5 * (np.floor(v * rows) % 2)) % 1 - 0.5, (v * rows) % 1 - 0.5)
    near = np.minimum(np.abs(v - 0.5), np.abs(1 - v))
    holes = (dots < 0.27) & (np.abs(v - 0.5) > 0.08) & (near > 0.06)
    skin[holes] = np.array(tint_color(color, 0.28)).astype(np.uint8)
    plain = look.surface(color, "metal")
    foot = lathe([(0.5 * r, -0.016), (0.53 * r, -0.016), (0.56 * r, 0.008), (0.53 * r, 0.008)], 30,
                 loop=True)  # fmt: skip
    ears = [tube(smooth([(s * 0.97 * r, -0.035, h - 0.006), (s * (r + 0.028), -0.026, h),
                         (s * (r + 0.028), 0.026, h), (s * 0.97 * r, 0.035, h - 0.006)], 3),
                 0.004, 8) for s in (-1, 1)]  # fmt: skip
    rim = torus(r - 0.001, 0.0035, 36, 6).move(z=h - 0.003)
    pieces = [(body, skin), (join([foot, rim, *ears]), plain)]
    up = [(solid.move(z=0.016), tile) for solid, tile in pieces]
    raised = [type(p)(p.vertices + np.array([0, 0, 0.016]), p.kind, p.axis) for p in parts]
    lugs = [box_part(0.03, 0.06, 0.006, (s * (r + 0.012), 0, h + 0.011)) for s in (-1, 1)]
    return shape(up, [*raised, cylinder_part(0.53 * r, 0.018), *lugs])


@category("measuring_cup", size=(0.161, 0.0799, 0.0558), mass=0.3, material="glass", hollow=True,
          aliases=("measuring jug", "measure cup", "measuring glass", "glass measuring cup"),
          themes=("kitchen",), roles=("container",), colors=("silver", "red"))  # fmt: skip
def measuring_cup(look: Look) -> Shape:
    """A glass measuring jug with a red scale, or a steel measuring cup with a long handle."""
    if look.chance(0.6):
        r, h = look.between(0.042, 0.055), look.between(0.085, 0.12)
        ink = look.color("red", "red", "blue", "green", "black")
        body, parts = open_vessel([(0.82 * r, 0), (0.88 * r, 0.3 * h), (0.95 * r, 0.7 * h), (r, h)],
                                  0.004, 0.006)  # fmt: skip
        face = prints.canvas(160, 96, (214, 226, 230))
        for k in range(6):
            long = 0.09 if k % 2 == 0 else 0.05
            prints.fill(face, 0.47, 0.14 + 0.13 * k, long, 0.03, ink)
            if k % 2 == 0:
                prints.write(face[:, 50:74], str(600 - 100 * k), 0.5, 0.16 + 0.13 * k, 0.11, ink)
        glass = surfaces.plain((206, 220, 224))
        tile = surfaces.stack((face, 50), (glass, 50), side=192)

        def lip_profile(p: np.ndarray) -> np.ndarray:
            up = np.clip((p[:, 2] / h - 0.7) / 0.3, 0, 1) ** 2
            left = np.clip(-p[:, 0] / r, 0, 1) ** 6
            return p + np.column_stack([-0.013 * up * left, 0 * up, 0 * up])

        ear = tube(smooth([(0.95 * r, 0, 0.88 * h), (r + 0.035, 0, 0.86 * h),
                           (r + 0.035, 0, 0.3 * h), (0.86 * r, 0, 0.2 * h)], 4), 0.006,
                   8)  # fmt: skip
        return shape([(body.bend(lip_profile), tile), (ear, glass)],
                     [*parts, box_part(0.025, 0.012, 0.6 * h, (r + 0.026, 0, 0.24 * h))],
                     opacity=0.75)  # fmt: skip
    r, h = look.between(0.032, 0.044), look.between(0.035, 0.048)
    color = look.color("silver", "silver", "copper", "red", "teal", "white", "yellow", "black")
    skin = look.surface(color, "metal")
    body, parts = open_vessel([(0.85 * r, 0), (0.92 * r, 0.2 * h), (r, h)], 0.0016, 0.002)
    long = look.between(0.08, 0.1)
    grip = sweep([(0.95 * r, 0, h - 0.003), (r + long, 0, h - 0.0035)],
                 rectangle(0.018, 0.003, 0.0012, 2), [0.7, 1.0])  # fmt: skip
    mark = box(0.03, 0.009, 0.0004).move(r + 0.6 * long, 0, h - 0.0021)
    sign = prints.canvas(64, 20, tint_color(color, 0.95))
    prints.write(sign, look.pick(["1 CUP", "1/2", "1/3", "1/4"]), 0.5, 0.5, 0.7, (30, 30, 34))
    return shape([(body, skin), (grip, skin), (mark, sign)], [*parts, hull_of(grip)])


@category("honey_dipper", size=(0.15, 0.0287, 0.0258), mass=0.02, material="wood",
          aliases=("honey stick", "honey spoon", "honey wand"), themes=("kitchen",),
          colors=("wooden",), state="lying flat")  # fmt: skip
def honey_dipper(look: Look) -> Shape:
    """A grooved wooden honey dipper, lying flat."""
    long, r = look.between(0.14, 0.165), look.between(0.013, 0.016)
    wood = look.surface(look.color("wooden", "tan", "brown"), "wood")
    head = []
    for k in range(6):
        u = (k + 0.5) / 6
        wide = r * np.sqrt(1 - (2 * u - 1) ** 2 * 0.72)
        head.append(cylinder(wide, 0.0046, 20, bevel=0.001).turn(1, np.pi / 2).move(
            -0.5 * long + 0.0062 * k))  # fmt: skip
    core = cylinder(0.5 * r, 0.038, 14).turn(1, np.pi / 2).move(x=-0.5 * long)
    stick = limb([(-0.5 * long + 0.03, 0, 0), (0.2 * long, 0, -0.2 * r),
                  (0.48 * long, 0, -0.62 * r), (0.5 * long, 0, -0.65 * r)],
                 [0.0036, 0.0036, 0.0046, 0.003], 10)  # fmt: skip
    return settle([(join([*head, core]), wood), (stick, wood)], 0.1)


def _scoop(look: Look, color: RGB, z: float) -> Pieces:
    bowl = lathe(
        [(0, -0.012), (0.009, -0.009), (0.0135, 0), (0.0125, 0), (0.008, -0.008), (0, -0.0108)], 20
    )
    return [(bowl.move(-0.014, 0, z + 0.002), steel(look))]


@category("salad_spinner", size=(0.247, 0.247, 0.178), mass=0.9, material="plastic", hollow=True,
          aliases=("lettuce spinner", "salad dryer", "salad drier"), themes=("kitchen",),
          roles=("big", "round"), colors=("green", "white"))  # fmt: skip
def salad_spinner(look: Look) -> Shape:
    """A salad spinner: a clear bowl, a slotted basket with leaves and a lid with a knob."""
    k, color = look.between(0.88, 1.06), look.color("green", "white", "red", "gray", "lime", "teal")
    bowl = lathe([(0, 0), (0.08, 0), (0.1, 0.01), (0.122, 0.1), (0.124, 0.12), (0, 0.12)], 36)
    image = prints.canvas(192, 96, (222, 230, 232))
    for n in range(40):
        prints.fill(image, n / 40, 0.2, 0.01, 0.62, (120, 170, 110) if n % 3 else (200, 210, 206))
    lid = lathe([(0, 0.118), (0.128, 0.118), (0.126, 0.13), (0.06, 0.145), (0, 0.147)], 36)
    knob = lathe(
        [(0, 0.14), (0.03, 0.14), (0.026, 0.158), (0.03, 0.17), (0.018, 0.182), (0, 0.184)], 24
    )
    ring = torus(0.08, 0.003, 36, 6).move(z=0.139)
    tile = look.surface(color, "plastic")
    made = [(bowl, image), (lid, tile),
            (join([knob, ring]), surfaces.plain(tint_color(color, 0.7)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0]), hull_of(made[1][0]), hull_of(knob.scale(k, k, k))])


CATEGORIES = (
    Category("meat_tenderiser", keep_still(with_handle(_mallet, (0.13, 0.16), 0.01, r=0.01)),
             size=(0.203, 0.0562, 0.0501), mass=0.35, material="metal",
             aliases=("meat tenderizer", "meat mallet", "meat hammer", "steak hammer"),
             themes=("kitchen",), colors=("black", "red"), state="lying flat"),
    Category("herb_stripper", keep_still(with_handle(_leaf_plate, (0.05, 0.07), 0.01)),
             size=(0.173, 0.0499, 0.0211), mass=0.05, material="metal",
             aliases=("herb peeler", "kale stripper"), themes=("kitchen",), colors=("black", "red"),
             state="lying flat"),
    Category("egg_separator", keep_still(with_handle(_separator, (0.06, 0.08), 0.0, ("white",
             "yellow", "red", "green", "sky"), 0.006)), size=(0.132, 0.065, 0.024), mass=0.03,
             material="plastic", aliases=("yolk separator",), themes=("kitchen",),
             colors=("black", "red"), state="lying flat"),
    Category("turkey_baster", keep_still(with_handle(_balloon, (0.06, 0.07), 0.0, ("red", "black",
             "blue", "orange", "gray"), 0.02)), size=(0.264, 0.0453, 0.0444), mass=0.08,
             material="plastic", aliases=("baster", "meat baster"), themes=("kitchen",),
             colors=("black", "red"), state="lying flat"),
    Category("butter_curler", keep_still(with_handle(_curl, (0.08, 0.1), 0.04)),
             size=(0.2, 0.0434, 0.0209), mass=0.04, material="plastic", aliases=("butter scraper",),
             themes=("kitchen",), colors=("black", "red"), state="lying flat"),
    Category("matcha_whisk",
             keep_still(with_handle(_matcha, (0.04, 0.05), 0.0, ("wooden", "tan", "cream"), 0.013)),
             size=(0.115, 0.0511, 0.0501), mass=0.02, material="wood", assembled=True,
             aliases=("bamboo whisk", "chasen", "tea whisk"), themes=("kitchen",),
             colors=("black", "red"), state="lying flat"),
    Category("dough_scraper", keep_still(with_handle(_spatula_scraper, (0.1, 0.13), 0.0)),
             size=(0.204, 0.0601, 0.0201), mass=0.06, material="plastic",
             aliases=("bowl scraper", "silicone scraper", "jar spatula", "dish scraper"),
             themes=("kitchen",), colors=("black", "red"), state="lying flat"),
    Category("melon_baller", keep_still(with_handle(_scoop, (0.08, 0.1), 0.045)),
             size=(0.164, 0.0273, 0.0203), mass=0.04, material="plastic",
             aliases=("melon scoop", "fruit baller", "parisienne scoop"), themes=("kitchen",),
             colors=("black", "red"), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
