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
    loft,
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
    """A rectangular or rounded board or a paddle, made of planks, end grain, plastic or slate."""
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
    """Return a tile of bright brushed steel."""
    return surfaces.brushed_metal(look.rng, (192, 195, 200))


def grip_bar(start: float, stop: float, wide: float, z: float) -> Solid:
    """Return a rounded handle along x from ``start`` to ``stop`` with its middle at ``z``."""
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
    """A spatula lying flat: a slotted steel turner, a silicone scraper or a wooden one."""
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


@category("peeler", size=(0.149, 0.0548, 0.0125), mass=0.045, material="plastic",
          aliases=("vegetable peeler", "potato peeler", "y peeler", "swivel peeler"),
          themes=("kitchen",), roles=("flat",), colors=("black", "red"),
          state="lying flat")  # fmt: skip
def peeler(look: Look) -> Shape:
    """A vegetable peeler lying flat: a Y-peeler or a straight one."""
    color = look.color("black", "red", "green", "white", "orange", "teal", "silver", "yellow")
    skin, steel = look.surface(color, "plastic"), bright_steel(look)
    if look.chance(0.6):
        wide = look.between(0.058, 0.066)
        grip = sweep([(-0.005, 0, 0.006), (0.03, 0, 0.0065), (0.075, 0, 0.006)],
                     rectangle(0.02, 0.012, 0.005, 3), [0.7, 1.0, 0.85])  # fmt: skip
        fork = sweep(smooth([(-0.06, -wide / 2, 0.006), (-0.03, -wide / 2, 0.006),
                             (-0.004, 0, 0.006), (-0.03, wide / 2, 0.006),
                             (-0.06, wide / 2, 0.006)], 4),
                     rectangle(0.01, 0.0115, 0.003, 2))  # fmt: skip
        edge = [box(0.004, wide - 0.004, 0.0016).turn(1, 0.5).move(x=u, z=0.006)
                for u in (-0.058, -0.051)]  # fmt: skip
        x = fork.vertices[:, 0]
        y = fork.vertices[:, 1]
        arms = [hull_part(fork.vertices[(s * y > 0.35 * wide)]) for s in (-1, 1)]
        return shape([(join([grip, fork]), skin), (join(edge), steel)],
                     [hull_of(grip), *arms, hull_part(fork.vertices[x > -0.028]),
                      hull_of(*edge)])  # fmt: skip
    grip = grip_bar(-0.01, 0.09, 0.021, 0.0066)
    ring = np.array([(0.5, 0), (0, 0.4), (-0.5, 0), (0, -0.12)])
    long = look.between(0.075, 0.085)
    path = np.column_stack([-0.005 - long * np.linspace(0, 1, 6), np.zeros(6), np.full(6, 0.006)])
    blade = sweep(path, ring, 0.017 * np.array([0.5, 0.9, 1, 1, 0.9, 0.2]))
    return shape([(grip, skin), (blade, steel)], [hull_of(grip), hull_of(blade)])


@category("grater", size=(0.11, 0.085, 0.24), mass=0.25, material="metal",
          aliases=("cheese grater", "box grater", "vegetable grater", "shredder"),
          themes=("kitchen",), roles=("tall",), colors=("silver", "black"))  # fmt: skip
def grater(look: Look) -> Shape:
    """A four-sided box grater with a handle on top."""
    x, y, h = look.between(0.095, 0.115), look.between(0.075, 0.085), look.between(0.19, 0.22)
    color = look.color("black", "red", "green", "teal", "orange", "silver", "white")
    face = surfaces.brushed_metal(look.rng, (196, 199, 204), 128).copy()
    face = surfaces.fit(face, 128, 128).copy()
    count = look.pick([7, 9])
    v, u = np.mgrid[0:128, 0:128] / 128
    cells = np.hypot(
        (u * count) % 1 - 0.5, ((v * count + 0.5 * (np.floor(u * count) % 2)) % 1) - 0.5
    )
    keep = (u > 0.1) & (u < 0.9) & (v > 0.12) & (v < 0.86)
    face[(cells < 0.36) & keep] = (236, 238, 242)
    face[(cells < 0.24) & keep] = (52, 54, 58)
    square = rectangle(1, 1)
    rings = np.stack([np.column_stack([square * [x * k, y * k], np.full(4, z)])
                      for k, z in ((1.0, 0.008), (0.78, h))])  # fmt: skip
    sides = []
    for k in range(4):
        a, b = rings[0][k], rings[0][(k + 1) % 4]
        c, d = rings[1][(k + 1) % 4], rings[1][k]
        inward = -0.002 * np.append((a + b)[:2] / np.linalg.norm((a + b)[:2]), 0)
        corners = np.array([a, b, c, d])
        quad = np.concatenate([corners, corners + inward])
        faces = np.array([[0, 1, 2], [0, 2, 3], [5, 4, 7], [5, 7, 6], [0, 4, 5], [0, 5, 1],
                          [1, 5, 6], [1, 6, 2], [2, 6, 7], [2, 7, 3], [3, 7, 4],
                          [3, 4, 0]])  # fmt: skip
        uv = np.array([(0, 0), (1, 0), (1, 1), (0, 1)] * 2, float)
        sides.append(Solid(quad, faces, uv))
    body = join(sides)
    skin = look.surface(color, "plastic")
    lid = block(0.8 * x, 0.8 * y, 0.012, 0.012, 0.003).move(z=h - 0.004)
    foot = loft(np.stack([np.column_stack([rectangle(x * k, y * k), np.full(4, z)])
                          for k, z in ((1.03, 0), (1.02, 0.012))]), square)  # fmt: skip
    ear = tube(smooth([(-0.3 * x, 0, h), (-0.27 * x, 0, h + 0.035), (0.27 * x, 0, h + 0.035),
                       (0.3 * x, 0, h)], 4), 0.007, 8)  # fmt: skip
    return shape([(body, face), (join([lid, foot, ear]), skin)],
                 [hull_of(body, foot), hull_of(lid), hull_of(ear)])  # fmt: skip


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
    """Return the shape function of a tool that lies flat, with a head, a neck and a grip."""

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
    """Return a tile of brushed steel."""
    return surfaces.brushed_metal(look.rng, APPLE_CORER_STEEL)


def _tube_head(look: Look, color: RGB, z: float) -> Pieces:
    pipe = (lathe([(0.0095, 0), (0.0108, 0), (0.0108, 0.09), (0.0095, 0.09)], 18,
                  loop=True).turn(1, -np.pi / 2).move(0, 0, z))  # fmt: skip
    teeth = [box(0.006, 0.003, 0.004).move(-0.092, 0, 0.0085).turn(0, a).move(z=z) for a in 2
             * np.pi * np.arange(8) / 8]  # fmt: skip
    return [(join([pipe, *teeth]), steel(look))]


def _rasp(long: float, wide: float) -> Head:
    def make(look: Look, color: RGB, z: float) -> Pieces:
        plate = prism(rectangle(long, wide, 0.004), 0, 0.0022).move(-long / 2, 0, z)
        image = surfaces.fit(steel(look), 64, 192).copy()
        for i in range(26):
            for j in range(5):
                at = ((i + 0.5 + 0.5 * (j % 2)) / 27, (j + 0.7) / 5.4)
                prints.disc(image, *at, 0.055, (60, 62, 68))
                prints.disc(image, at[0] - 0.006, at[1], 0.03, (230, 232, 236))
        rails = [box(long, 0.003, 0.006).move(-long / 2, s * wide / 2, z - 0.003) for s in (-1, 1)]
        face = box(0.96 * long, 0.9 * wide, 0.0004).move(-long / 2, 0, z + 0.0021)
        return [(join([plate, *rails]), steel(look)), (face, image)]

    return make


def _holes_tip(look: Look, color: RGB, z: float) -> Pieces:
    head = prism(rectangle(0.018, 0.02, 0.006), 0, 0.006).move(-0.009, 0, z - 0.003)
    rings = [torus(0.0022, 0.0009, 10, 5).turn(1, np.pi / 2).move(-0.019, y, z)
             for y in (-0.007, -0.0023, 0.0023, 0.007)]  # fmt: skip
    return [(head, steel(look)), (join(rings), surfaces.plain((60, 62, 68)))]


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


@category("piping_nozzle", size=(0.027, 0.0273, 0.0444), mass=0.008, material="metal",
          aliases=("icing nozzle", "piping tip", "icing tip", "cake nozzle"), themes=("kitchen",),
          roles=("round",), colors=("silver",))  # fmt: skip
def piping_nozzle(look: Look) -> Shape:
    """A piping nozzle standing on its wide end: a small steel cone with a star-shaped tip."""
    k, color = look.between(0.85, 1.3), look.color("silver", "silver", "gray", "gold")
    body = lathe([(0, 0), (0.012, 0), (0.0115, 0.004), (0.0045, 0.034), (0, 0.034)], 24)
    teeth = [prism([(-0.0018, 0), (0.0018, 0), (0, 0.006)], -0.0005,
                   0.0005).turn(0, np.pi / 2).move(y=-0.0042).turn(2, a).move(z=0.0335)
             for a in np.arange(6) * 1.047]  # fmt: skip
    seam = box(0.0006, 0.001, 0.03).turn(0, -0.22).move(y=-0.0118, z=0.002)
    made = join([body, *teeth, seam]).scale(k, k, k)
    return shape([(made, look.surface(color, "steel"))], [hull_of(body.scale(k, k, k))])


@category("tortilla_press", size=(0.2, 0.272, 0.211), mass=1.5, material="metal",
          aliases=("roti press",), themes=("kitchen",), roles=("big",),
          colors=("black",))  # fmt: skip
def tortilla_press(look: Look) -> Shape:
    """A tortilla press: two hinged round plates with a lever and a ball of dough."""
    k, color = look.between(0.88, 1.06), look.color("black", "silver", "red", "gray")
    low = cylinder(0.1, 0.014, 34, bevel=0.002).move(z=0.008)
    feet = [cylinder(0.012, 0.01, 12).move(0.07 * np.cos(a), 0.07 * np.sin(a), 0)
            for a in np.arange(4) * 1.57 + 0.8]  # fmt: skip
    up = [
        s.turn(0, -1.0).move(y=0.1, z=0.03)
        for s in (
            cylinder(0.1, 0.012, 34, bevel=0.002).move(y=-0.1),
            box(0.02, 0.2, 0.01).move(0, -0.1, 0.012),
        )
    ]
    hinge = box(0.05, 0.02, 0.03).move(y=0.105, z=0.006)
    lever = (tube([(0, -0.1, 0.018), (0, -0.135, 0.03), (0, -0.2, 0.034)], 0.0085,
                  9).turn(2, np.pi).move(0, -0.03, 0.0))  # fmt: skip
    dough = ellipsoid(0.05, 0.05, 0.024, 16, 9).move(z=0.03)
    made = [
        (join([low, *up, hinge]), look.surface(color, "iron" if sum(color) < 300 else "plastic")),
        (join([*feet, lever]), surfaces.plain((36, 36, 40))),
        (dough, surfaces.speckles(look.rng, (244, 228, 176), 8)),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(*[s.scale(k, k, k) for s in (low, *feet)]),
                        hull_of(*[s.scale(k, k, k) for s in up]),
                        hull_of(lever.scale(k, k, k))])  # fmt: skip


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
    """Return the tube and the tip of a baster."""
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


CATEGORIES = (
    Category("apple_corer", keep_still(with_handle(_tube_head, (0.08, 0.1), 0.012, r=0.011)),
             size=(0.199, 0.0253, 0.0248), mass=0.06, material="plastic",
             aliases=("corer", "pineapple corer"), themes=("kitchen",), colors=("black", "red"),
             state="lying flat"),
    Category("zester", keep_still(with_handle(_rasp(0.17, 0.03), (0.1, 0.12), 0.01)),
             size=(0.292, 0.0332, 0.0208), mass=0.09, material="plastic", aliases=("microplane",
             "lemon zester", "rasp grater", "hand grater", "nutmeg grater", "fine grater"),
             themes=("kitchen",), colors=("black", "red"), state="lying flat"),
    Category("citrus_zester", keep_still(with_handle(_holes_tip, (0.08, 0.1), 0.03)),
             size=(0.142, 0.0212, 0.0203), mass=0.05, material="plastic",
             aliases=("channel knife", "five hole zester"), themes=("kitchen",),
             colors=("black", "red"), state="lying flat"),
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
)  # fmt: skip
"""Objects that share their drawing functions."""
