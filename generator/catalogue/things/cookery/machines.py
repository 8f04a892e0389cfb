"""Machines of a kitchen counter: waffle irons, air fryers, slow cookers, small ovens, mixers."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import facing, side_view
from ...build.outlines import smooth
from ...build.settled import limb, settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

BODY = ("black", "silver", "white", "red", "cream", "mint", "charcoal")
DARK = (36, 37, 40)


def _steel(look: Look) -> textures.Tile:
    return textures.brushed_metal(look.rng, (196, 199, 204))


def waffle_iron(look: Look) -> Shape:
    """A round waffle iron, its lid raised over a waffle pattern."""
    r = look.between(0.095, 0.11)
    color = look.color(*BODY)
    skin = look.surface(color, "metal")
    base = cylinder(r, 0.045, 36, bevel=0.006)
    plate = cylinder(0.88 * r, 0.004, 34).move(z=0.043)
    ribs = []
    for k in range(7):
        at = (k / 6 - 0.5) * 1.5 * r
        long = 2 * np.sqrt(max((0.86 * r) ** 2 - at * at, 0))
        bar = box(long, 0.006, 0.004)
        ribs += [bar.move(y=at, z=0.046), bar.turn(2, np.pi / 2).move(x=at, z=0.046)]
    iron = textures.plain((70, 70, 74))
    inside = join([plate, *ribs])
    up = np.deg2rad(72)
    lid = cylinder(r, 0.04, 36, bevel=0.008).move(y=-r)
    face = inside.move(y=-r, z=-0.05)
    grip = box(0.07, 0.03, 0.014).move(y=-2 * r - 0.012, z=0.012)
    raised = [s.turn(0, -up).move(y=0.99 * r + 0.008, z=0.052) for s in (lid, face, grip)]
    hinge = box(0.08, 0.03, 0.06).move(y=r)
    front = box(0.07, 0.03, 0.014).move(y=-r - 0.012, z=0.024)
    dark = textures.plain(DARK)
    return shape([(base, skin), (inside, iron), (raised[0], skin), (raised[1], iron),
                  (join([raised[2], hinge, front]), dark)],
                 [cylinder_part(r, 0.045), hull_of(raised[0]), hull_of(raised[2]), hull_of(hinge),
                  hull_of(front)])  # fmt: skip


def air_fryer(look: Look) -> Shape:
    """An egg-shaped air fryer: a drawer with a handle below a display."""
    x, h = look.between(0.25, 0.28), look.between(0.29, 0.33)
    color = look.color("black", "black", "white", "charcoal", "red", "silver", "cream")
    skin = look.surface(color, "plastic")
    body = lathe([(0, 0), (0.44, 0), (0.49, 0.08), (0.5, 0.4), (0.46, 0.76), (0.36, 0.95),
                  (0.2, 1), (0, 1)], 36).scale(x, x, h)  # fmt: skip
    seam = torus(0.498 * x, 0.0035, 40, 6).move(z=0.5 * h)
    low = block(0.42 * x, 0.02, 0.4 * h, 0.008).move(y=-0.49 * x, z=0.07 * h)
    grip = tube(smooth([(0, -0.48 * x, 0.42 * h), (0, -0.66 * x, 0.42 * h), (0, -0.68 * x, 0.3 * h),
                        (0, -0.68 * x, 0.2 * h)], 4), 0.013, 10)  # fmt: skip
    panel = prints.canvas(96, 80, DARK)
    prints.write(panel, look.pick(["180", "200", "15:00"]), 0.5, 0.35, 0.32, (120, 220, 240))
    for k in range(4):
        prints.disc(panel, 0.2 + 0.2 * k, 0.74, 0.07, (90, 94, 100))
    lean = 0.16
    screen = facing(block(0.09, 0.075, 0.012, 0.008)).turn(0, -lean)
    screen = screen.move(y=-0.452 * x, z=0.68 * h)
    trim = textures.plain(tint_color(color, 0.6) if sum(color) > 250 else (96, 98, 102))
    return shape([(body, skin), (join([seam, low, grip]), trim), (screen, panel)],
                 [hull_of(body), hull_of(low), hull_of(grip)])  # fmt: skip


def slow_cooker(look: Look) -> Shape:
    """An oval slow cooker with a glass lid, two handles and a dial."""
    x, h = look.between(0.3, 0.34), look.between(0.15, 0.18)
    color = look.color("silver", "red", "black", "white", "silver", "cream")
    skin = look.surface(color, "metal")
    y = 0.76
    pot = lathe([(0, 0.03), (0.42, 0.03), (0.5, 0.14), (0.5, 0.92), (0.52, 0.96), (0.52, 1),
                 (0, 1)], 40).scale(x, y * x, h)  # fmt: skip
    foot = lathe([(0, 0), (0.38, 0), (0.38, 0.05), (0, 0.05)], 36).scale(x, y * x, h)
    lid = lathe([(0, 1), (0.49, 1), (0.46, 1.06), (0.2, 1.2), (0, 1.22)], 40).scale(x, y * x, h)
    knob = lathe([(0, 0), (0.01, 0), (0.01, 0.01), (0.024, 0.014), (0.02, 0.026), (0, 0.028)],
                 22).move(z=1.21 * h)  # fmt: skip
    ears = [box(0.04, 0.09, 0.018).move(s * (x / 2 + 0.014), 0, 0.72 * h) for s in (-1, 1)]
    dial = facing(cylinder(0.021, 0.018, 24, bevel=0.002)).move(y=-y * x / 2 + 0.004, z=0.36 * h)
    mark = box(0.0035, 0.001, 0.016).move(0, -y * x / 2 - 0.0146, 0.36 * h)
    dark = textures.plain(DARK)
    return shape([(pot, skin), (lid, textures.plain((176, 190, 196))),
                  (join([foot, knob, *ears, dial]), dark), (mark, textures.plain((240, 240, 240)))],
                 [hull_of(foot), hull_of(pot), hull_of(lid), hull_of(knob),
                  *(hull_of(e) for e in ears)])  # fmt: skip


def toaster_oven(look: Look) -> Shape:
    """A small oven: a glass door with a bar handle, knobs at its right."""
    x, y, h = look.between(0.38, 0.44), look.between(0.25, 0.29), look.between(0.22, 0.25)
    color = look.color(*BODY)
    skin = look.surface(color, "metal")
    body = block(x, y, h - 0.014, 0.012, 0.003).move(z=0.014)
    feet = [cylinder(0.014, 0.015, 14).move(a * 0.43 * x, b * 0.4 * y) for a in (-1, 1)
            for b in (-1, 1)]  # fmt: skip
    glow = prints.canvas(160, 112, (44, 40, 40))
    prints.fill(glow, 0.06, 0.08, 0.88, 0.84, (92, 62, 44))
    for k in range(3):
        prints.fill(
            glow, 0.08, 0.2 + 0.3 * k, 0.84, 0.03, (214, 120, 60) if k != 1 else (160, 160, 160)
        )
    door = box(0.68 * x, 0.01, 0.78 * h).move(-0.13 * x, -y / 2 - 0.003, 0.12 * h)
    pane = box(0.6 * x, 0.001, 0.58 * h).move(-0.13 * x, -y / 2 - 0.0085, 0.16 * h)
    bar = tube([(-0.42 * x, -y / 2 - 0.032, 0.82 * h), (0.16 * x, -y / 2 - 0.032, 0.82 * h)],
               0.007, 10)  # fmt: skip
    arms = [box(0.01, 0.034, 0.01).move(u * x, -y / 2 - 0.017, 0.8 * h) for u in (-0.4, 0.14)]
    knobs = [facing(cylinder(0.019, 0.02, 22, bevel=0.002)).move(0.36 * x, -y / 2, z * h)
             for z in (0.25, 0.5, 0.76)]  # fmt: skip
    marks = [box(0.003, 0.001, 0.015).move(0.36 * x, -y / 2 - 0.0204, z * h + 0.002)
             for z in (0.25, 0.5, 0.76)]  # fmt: skip
    dark = textures.plain(DARK if sum(color) > 200 else (104, 106, 110))
    return shape([(body, skin), (join([*feet, door]), dark), (pane, glow),
                  (join([bar, *arms]), _steel(look)), (join(knobs), dark),
                  (join(marks), textures.plain((240, 240, 240)))],
                 [hull_of(body), box_part(0.9 * x, 0.85 * y, 0.015), hull_of(door), hull_of(bar),
                  hull_of(*knobs)])  # fmt: skip


def food_processor(look: Look) -> Shape:
    """A food processor: a clear bowl with a handle and a feed tube on a motor base."""
    x, h = look.between(0.19, 0.22), look.between(0.34, 0.39)
    color = look.color(*BODY)
    skin = look.surface(color, "plastic")
    base = block(x, 0.95 * x, 0.32 * h, 0.04, 0.008)
    r = 0.42 * x
    bowl = cylinder(0.94 * r, 0.4 * h, 34, top=r).move(z=0.33 * h)
    lid = lathe([(0, 0.73 * h), (1.05 * r, 0.73 * h), (1.03 * r, 0.78 * h), (0, 0.82 * h)], 34)
    feed = block(0.36 * r, 0.62 * r, 0.2 * h, 0.02).move(0.3 * r, 0, 0.79 * h)
    ear = tube(smooth([(0.95 * r, 0, 0.7 * h), (1.55 * r, 0, 0.68 * h), (1.55 * r, 0, 0.42 * h),
                       (0.9 * r, 0, 0.38 * h)], 4), 0.011, 10)  # fmt: skip
    hub = cylinder(0.18 * r, 0.3 * h, 16).move(z=0.33 * h)
    dial = facing(cylinder(0.024, 0.016, 24, bevel=0.003)).move(y=-0.475 * x, z=0.16 * h)
    food = look.pick([(214, 222, 226), (214, 222, 226), (150, 180, 90), (226, 150, 70)])
    tile = textures.stack((textures.plain(food), 45), (textures.plain((214, 224, 228)), 55))
    dark = textures.plain(DARK if sum(color) > 200 else (120, 122, 126))
    return shape([(base, skin), (bowl, tile), (join([lid, feed, ear]), textures.plain(
        (190, 202, 208))), (join([hub, dial]), dark)],
        [hull_of(base), hull_of(bowl), hull_of(lid), hull_of(feed), hull_of(ear)])  # fmt: skip


def hand_mixer(look: Look) -> Shape:
    """An electric hand mixer standing on its heel, its beaters lying to the left."""
    long = look.between(0.17, 0.195)
    color = look.color("white", "red", "mint", "black", "cream", "sky", "pink")
    skin = look.surface(color, "plastic")
    side = smooth(np.array([(-0.5, 0.0), (0.42, 0.0), (0.5, 0.06), (0.48, 0.3), (0.42, 0.36),
                            (0.3, 0.3), (0.12, 0.28), (0.1, 0.44), (0.36, 0.47), (0.44, 0.52),
                            (0.4, 0.6), (0.1, 0.62), (-0.3, 0.56), (-0.52, 0.34), (-0.55, 0.12),
                            (-0.5, 0.0)]), 2)[:-1] * long  # fmt: skip
    body = side_view(side, 0.078)
    steel = _steel(look)
    rods, hoops = [], []
    for s in (-1, 1):
        y = 0.02 * s
        rods.append(tube([(-0.53 * long, y, 0.028), (-0.53 * long - 0.06, y, 0.026)], 0.003, 8))
        for a in (0, np.pi / 2):
            t = np.linspace(0, 2 * np.pi, 17)[:-1]
            path = np.column_stack([-0.53 * long - 0.09 + 0.036 * np.cos(t), 0.021 * np.sin(t),
                                    0 * t])  # fmt: skip
            hoop = tube(path, 0.0018, 6, loop=True).turn(0, a + np.pi / 4)
            hoops.append(hoop.move(y=y, z=0.018 + 0.003))
    switch = block(0.034, 0.02, 0.012, 0.006, 0.002).move(-0.1 * long, 0, 0.6 * long)
    dark = textures.plain(tint_color(color, 0.55))
    return settle([(body, skin), (join([*rods, *hoops]), steel), (switch, dark)], 0.01,
                  hulls=[[0], [1], [2]])  # fmt: skip


def coffee_machine(look: Look) -> Shape:
    """A filter coffee machine: a glass pot on a hot plate under the filter, a water tank behind."""
    x, y, h = look.between(0.19, 0.22), look.between(0.22, 0.25), look.between(0.32, 0.36)
    color = look.color("black", "silver", "white", "red", "cream", "charcoal")
    skin = look.surface(color, "plastic")
    base = block(x, y, 0.12 * h, 0.03, 0.004)
    back = block(x, 0.36 * y, h, 0.03, 0.006).move(y=0.32 * y)
    head = block(x, 0.96 * y, 0.26 * h, 0.04, 0.008).move(y=0.01 * y, z=0.74 * h)
    cone = cylinder(0.24 * x, 0.1 * h, 24, top=0.34 * x).move(y=-0.17 * y, z=0.655 * h)
    r = 0.33 * x
    z = 0.12 * h
    plate = cylinder(1.02 * r, 0.004, 30).move(y=-0.17 * y, z=z - 0.001)
    pot = lathe(
        [
            (0, 0),
            (0.86 * r, 0),
            (r, 0.12 * h),
            (0.96 * r, 0.26 * h),
            (0.66 * r, 0.42 * h),
            (0.7 * r, 0.46 * h),
            (0, 0.46 * h),
        ],
        30,
    ).move(y=-0.17 * y, z=z + 0.002)
    ear = tube(smooth([(0.6 * r, -0.17 * y, z + 0.42 * h), (1.5 * r, -0.17 * y, z + 0.42 * h),
                       (1.5 * r, -0.17 * y, z + 0.16 * h), (1.25 * r, -0.17 * y, z + 0.12 * h)], 4),
               0.008, 8).turn(2, 0.0)  # fmt: skip
    top = cylinder(0.72 * r, 0.02 * h, 24).move(y=-0.17 * y, z=z + 0.46 * h)
    light = box(0.02, 0.001, 0.01).move(0.3 * x, -y / 2, 0.05 * h)
    coffee = textures.stack((textures.plain((60, 34, 20)), 42), (textures.plain(
        (196, 208, 214)), 58))  # fmt: skip
    dark = textures.plain(DARK if sum(color) > 200 else (96, 98, 102))
    return shape([(join([base, back, head]), skin), (join([cone, plate, ear, top]), dark),
                  (pot, coffee), (light, textures.plain((230, 60, 40)))],
                 [box_part(x, y, 0.12 * h), hull_of(back), hull_of(head), hull_of(cone),
                  hull_of(pot), hull_of(ear)])  # fmt: skip


def coffee_pod(look: Look) -> Shape:
    """A capsule of coffee, foil side down."""
    r, h = look.between(0.016, 0.019), look.between(0.025, 0.03)
    color = look.color("gold", "purple", "red", "blue", "green", "brown", "black", "silver")
    body = lathe(
        [
            (0, 0),
            (1.12 * r, 0),
            (1.14 * r, 0.06 * h),
            (0.98 * r, 0.08 * h),
            (0.76 * r, 0.72 * h),
            (0.6 * r, 0.9 * h),
            (0.3 * r, h),
            (0, h),
        ],
        30,
    )
    tile = textures.brushed_metal(look.rng, color)
    return shape([(body, tile)], [hull_of(body)])


def portafilter(look: Look) -> Shape:
    """A portafilter with ground coffee in its basket, its handle to the right."""
    r = look.between(0.032, 0.036)
    color = look.color("black", "wooden", "black", "brown", "white")
    steel = _steel(look)
    cup = lathe([(0, 0.012), (0.5 * r, 0.012), (0.92 * r, 0.02), (r, 0.026), (r, 0.05),
                 (0.9 * r, 0.05), (0.88 * r, 0.046), (0, 0.046)], 32)  # fmt: skip
    lugs = [box(0.012, 0.014, 0.006).move(s * (r + 0.002), 0, 0.042).turn(2, np.pi / 2)
            for s in (-1, 1)]  # fmt: skip
    spouts = [limb([(0, 0, 0.014), (0, s * 0.012, 0.01), (0, s * 0.018, 0.0)],
                   [0.0065, 0.006, 0.0055], 10) for s in (-1, 1)]  # fmt: skip
    puck = cylinder(0.87 * r, 0.003, 30).move(z=0.0445)
    neck = limb([(0.97 * r, 0, 0.038), (r + 0.02, 0, 0.036), (r + 0.035, 0, 0.034)],
                [0.006, 0.006, 0.007], 10)  # fmt: skip
    grip = limb([(r + 0.03, 0, 0.0345), (r + 0.06, 0, 0.028), (r + 0.12, 0, 0.0145),
                 (r + 0.14, 0, 0.0115), (r + 0.143, 0, 0.011)],
                [0.009, 0.0105, 0.0125, 0.0105, 0.005], 14)  # fmt: skip
    grounds = textures.spots(look.rng, (62, 38, 26), (40, 24, 16), 0.3)
    return settle([(join([cup, *lugs, *spouts, neck]), steel), (puck, grounds),
                   (grip, look.surface(color, "wood" if look.chance(0.3) else "plastic"))], 0.0,
                  hulls=[[0], [2]])  # fmt: skip


def milk_frother(look: Look) -> Shape:
    """A battery milk frother lying, its whisk to the left."""
    long = look.between(0.21, 0.24)
    color = look.color("black", "silver", "white", "red", "copper", "mint")
    grip = limb([(0.02 * long, 0, 0), (0.06 * long, 0, 0), (0.2 * long, 0, 0), (0.46 * long, 0, 0),
                 (0.5 * long, 0, 0)], [0.005, 0.011, 0.0135, 0.0145, 0.009], 18)  # fmt: skip
    rod = tube([(0.03 * long, 0, 0), (-0.47 * long, 0, -0.0045)], 0.0014, 8)
    ring = torus(0.0095, 0.0022, 26, 8).turn(1, np.pi / 2).move(-0.47 * long, 0, -0.0045)
    knob = block(0.018, 0.01, 0.006, 0.004, 0.001).move(0.2 * long, 0, 0.011)
    steel = _steel(look)
    dark = textures.plain(tint_color(color, 0.6))
    return settle([(grip, look.surface(color, "plastic")), (join([rod, ring]), steel),
                   (knob, dark)], 0.06, hulls=[[0, 2], [1]])  # fmt: skip


_K = ("kitchen",)
CATEGORIES = (
    Category("waffle_iron", waffle_iron, (0.202, 0.272, 0.278), 2.2, ("waffle maker",),
             _K, ("big",), ("black",
             "silver")),
    Category("air_fryer", air_fryer, (0.273, 0.331, 0.307), 4.5, ("airfryer",), _K,
             ("big", "tall"), ("black",)),
    Category("slow_cooker", slow_cooker, (0.387, 0.262, 0.227), 4.5, ("crockpot", "crock pot",
             "pressure cooker", "multicooker", "instant pot"), _K, ("big",), ("silver", "red")),
    Category("toaster_oven", toaster_oven, (0.403, 0.307, 0.234), 5.5, ("mini oven", "oven",
             "countertop oven", "tabletop oven"), _K, ("big",), ("black", "silver")),
    Category("food_processor", food_processor, (0.248, 0.207, 0.369), 3.5, ("kitchen machine",
             "food chopper",), _K, ("big", "tall"), ("black", "white")),
    Category("hand_mixer", hand_mixer, (0.324, 0.078, 0.124), 0.9, ("electric mixer",
             "electric whisk", "handheld mixer", "hand blender", "electric hand mixer"), _K, (),
             ("white", "red")),
    Category("coffee_machine", coffee_machine, (0.217, 0.233, 0.341), 2.4, ("coffee maker",
             "drip coffee maker", "filter coffee machine", "coffeemaker", "drip coffee machine"),
             ("kitchen", "coffee"), ("big", "tall"), ("black",)),
    Category("coffee_pod", coffee_pod, (0.04, 0.0402, 0.0277), 0.006, ("coffee capsule",
             "coffee pad", "espresso capsule", "nespresso capsule"), ("coffee",),
             ("round",), ("gold",)),
    Category("portafilter", portafilter, (0.21, 0.082, 0.0524), 0.5, ("portafilter handle",
             "espresso handle", "filter holder"), ("coffee",), (), ("black",), state="lying flat"),
    Category("milk_frother", milk_frother, (0.223, 0.0295, 0.0311), 0.12, ("frother",
                 "electric frother", "milk foamer", "handheld frother", "milk warmer"),
             ("coffee",), (), ("black",),
             state="lying flat"),
)  # fmt: skip
"""The module's categories."""
