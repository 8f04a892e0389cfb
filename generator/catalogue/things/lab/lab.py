"""Things of a laboratory bench."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part, ring_parts
from ...build.outlines import rectangle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism, sweep, torus
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

LIQUIDS = ("blue", "teal", "amber", "pink", "green", "violet", "coral")


def _glass(color: RGB) -> textures.Tile:
    return textures.plain(tint_color(color, 1.35))


def _graduation(ground: RGB, ink: RGB = (70, 90, 100)) -> textures.Tile:
    """Glass with a measuring scale on the front."""
    image = prints.canvas(128, 128, ground)
    for k in range(9):
        prints.fill(image, 0.46, 0.2 + 0.075 * k, 0.09 if k % 2 else 0.05, 0.014, ink)
    prints.write(image, "250 ml", 0.5, 0.13, 0.09, ink)
    return image


def beaker(look: Look) -> Shape:
    """A glass beaker with a scale and some liquid; open at the top."""
    r, h, wall = look.between(0.034, 0.04), look.between(0.09, 0.105), 0.003
    level = look.between(0.3, 0.6) * h
    liquid = look.color(*LIQUIDS)
    body = lathe(
        [
            (0, 0),
            (r - 0.004, 0),
            (r, 0.004),
            (r, h - 0.004),
            (r + 0.003, h),
            (r, h),
            (r - wall, h - 0.004),
            (r - wall, 0.006),
            (0, 0.006),
        ],
        v=[0, 0, 0.03, 0.9, 0.94, 0.95, 0.96, 0.99, 1],
    )
    fluid = cylinder(r - 1.2 * wall, level, 24).move(z=0.005)
    wedges = ring_parts([(r, 0), (r, h)], [(r - wall, h), (r - wall, 0.006)])
    return shape(
        [(body, _graduation((206, 222, 226))), (fluid, textures.plain(liquid))],
        [*wedges, cylinder_part(r - wall, 0.005 + level)],
        opacity=0.62,
    )


def flask(look: Look) -> Shape:
    """A conical (Erlenmeyer) flask with liquid and a stopper."""
    r, h = look.between(0.04, 0.047), look.between(0.125, 0.145)
    neck = 0.3 * r
    liquid = look.color(*LIQUIDS)
    low = 0.38 * h
    at_low = r + (neck - r) * 0.38 / 0.68
    body = lathe(
        [
            (0, 0),
            (r - 0.005, 0),
            (r, 0.005),
            (at_low, low),
            (neck, 0.68 * h),
            (neck, 0.95 * h),
            (neck + 0.003, 0.97 * h),
            (neck, h),
            (0, h),
        ],
        v=[0, 0, 0.03, 0.42, 0.7, 0.93, 0.95, 0.98, 1],
    )
    tile = textures.stack((textures.plain(liquid), 42), (_graduation((208, 224, 228)), 58))
    cork = cylinder(neck * 0.9, 0.022, 16, top=neck * 1.1).move(z=h - 0.004)
    stopper = look.own_color("tan", "black", "terracotta")
    return shape(
        [(body, tile), (cork, textures.speckles(look.rng, stopper, 8))],
        [hull_of(body), cylinder_part(neck * 1.05, 0.016, (0, 0, h))],
    )


def test_tube_rack(look: Look) -> Shape:
    """A rack of two boards holding a row of stoppered tubes."""
    count = int(look.rng.integers(5, 7))
    pitch, depth = 0.029, 0.058
    length = pitch * count + 0.018
    wood = look.surface(look.color("white", "beige", "blue", "wooden"), "plastic")
    pieces = [
        (block(length, depth, 0.01, 0.004), wood),
        (block(length, depth, 0.007, 0.004).move(z=0.05), wood),
        (box(0.008, depth, 0.05).move(x=-(length - 0.01) / 2), wood),
        (box(0.008, depth, 0.05).move(x=(length - 0.01) / 2), wood),
    ]
    for k in range(count):
        liquid = look.own_color(*LIQUIDS)
        x = pitch * (k - (count - 1) / 2)
        glass = textures.stack((textures.plain(liquid), 5), (_glass((190, 205, 212)), 4))
        cap = textures.plain(look.own_color("red", "blue", "charcoal", "green"))
        pieces.append((cylinder(0.0095, 0.092, 12).move(x=x, z=0.008), glass))
        pieces.append((cylinder(0.0115, 0.018, 12, bevel=0.002).move(x=x, z=0.095), cap))
    top = box_part(pitch * count - 0.006, 0.022, 0.056, (0, 0, 0.057))
    return shape(pieces, [box_part(length, depth, 0.057), top])


def petri_dish(look: Look) -> Shape:
    """A shallow round dish with a lid and cultures inside."""
    r, h = look.between(0.044, 0.05), 0.017
    agar = look.color("cream", "amber", "pink", "mint")
    image = prints.canvas(128, 128, tint_color(agar, 1.1))
    for _ in range(14):
        x, y = look.rng.uniform(0.2, 0.8, 2)
        prints.disc(image, float(x), float(y), look.between(0.01, 0.045), tint_color(agar, 0.6))
    dish = cylinder(r, h, 32, bevel=0.0015)
    rim = torus(r, 0.0018, 32, 6).move(z=h - 0.002)
    return shape([(dish, image), (rim, _glass((180, 196, 202)))], [cylinder_part(r + 0.0015, h)])


def microscope(look: Look) -> Shape:
    """A microscope: foot, stage, curved arm, slanted eyepiece towards the viewer."""
    body = look.color("white", "gray", "navy", "cream", "black", "teal", "red")
    tall, pair = look.between(0.9, 1.12), look.pick([0.0, 0.0, 0.017])
    shell, dark = textures.speckles(look.rng, body, 4), textures.plain((44, 46, 50))
    metal = textures.brushed_metal(look.rng, (176, 180, 186))
    foot = block(0.13, 0.17, 0.028, 0.03, 0.006)
    arm = sweep(
        [(0, 0.06, 0.02), (0, 0.066, 0.12), (0, 0.05, 0.2), (0, 0.0, 0.245)],
        rectangle(0.045, 0.035, 0.01, 2),
    )
    head = block(0.06, 0.07, 0.05, 0.012, 0.004).move(y=-0.01, z=0.225)
    tube = cylinder(0.016, 0.1, 16, bevel=0.003).turn(0, np.deg2rad(40)).move(y=-0.02, z=0.26)
    eye = join([tube.move(x=-pair), tube.move(x=pair)]) if pair else tube
    lens = cylinder(0.011, 0.075, 16, top=0.018).move(y=-0.012, z=0.15)
    stage = block(0.12, 0.1, 0.012, 0.008).move(y=-0.015, z=0.11)
    knob = cylinder(0.022, 0.1, 18, bevel=0.004).turn(1, np.pi / 2).move(-0.05, 0.055, 0.085)
    return shape(
        [
            (foot, shell),
            (arm, shell),
            (head, shell),
            (eye, dark),
            (lens, metal),
            (stage, dark),
            (knob, dark),
        ],
        [
            box_part(0.13, 0.17, 0.028),
            box_part(0.045, 0.045, 0.205, (0, 0.055, 0.028)),
            box_part(0.12, 0.1, 0.012, (0, -0.015, 0.11)),
            hull_of(lens),
            hull_of(head),
            hull_of(eye),
            hull_of(knob),
        ],
    ).scale(tall)


def reagent_bottle(look: Look) -> Shape:
    """A round laboratory bottle with a screw cap and a printed label."""
    r, h = look.between(0.034, 0.042), look.between(0.13, 0.16)
    glass = look.color("brown", "clear", "amber", "teal")
    name = look.pick(["NaCl", "H2O", "EtOH", "CuSO4", "HCl", "KOH"])
    body = lathe(
        [
            (0, 0),
            (r - 0.004, 0),
            (r, 0.004),
            (r, 0.64 * h),
            (0.9 * r, 0.72 * h),
            (0.45 * r, 0.8 * h),
            (0.45 * r, 0.84 * h),
            (0, 0.84 * h),
        ],
        v=[0, 0, 0.03, 0.6, 0.7, 0.85, 0.95, 1],
    )
    print_ = prints.label(look.rng, name, look.own_color("navy", "red", "black"), (244, 244, 240))
    tile = textures.stack((textures.plain(glass), 14), (print_, 36), (textures.plain(glass), 50))
    cap = cylinder(0.55 * r, 0.16 * h, 20, bevel=0.002).move(z=0.84 * h)
    lid = textures.stripes([(40, 90, 170), (30, 74, 150)], 12, upright=True)
    if look.chance(0.5):
        lid = textures.plain(look.own_color("red", "black", "orange"))
    return shape(
        [(body, tile), (cap, lid)],
        [
            cylinder_part(r, 0.66 * h),
            hull_part(body.vertices[body.vertices[:, 2] > 0.6 * h]),
            cylinder_part(0.55 * r, 0.16 * h, (0, 0, 0.84 * h)),
        ],
    )


def pipette_box(look: Look) -> Shape:
    """A box of pipette tips: coloured lid over a clear lower part."""
    x, y, h = look.between(0.115, 0.125), look.between(0.08, 0.09), look.between(0.06, 0.075)
    lid = textures.speckles(look.rng, look.color("blue", "yellow", "green", "red", "violet"), 4)
    base = textures.grid((150, 160, 166), (214, 220, 224), 8, 12)
    rim = prism(rectangle(x, y, 0.008), 0.6 * h, h, 0.003)
    return shape(
        [(block(x - 0.004, y - 0.004, 0.61 * h, 0.006), base), (rim, lid)],
        [box_part(x - 0.004, y - 0.004, 0.6 * h), box_part(x, y, 0.4 * h, (0, 0, 0.6 * h))],
    )


def stirring_dish(look: Look) -> Shape:
    """A porcelain mortar with its pestle leaning inside."""
    r, h, wall = look.between(0.05, 0.058), look.between(0.055, 0.065), 0.008
    glaze = look.surface(look.color("white", "cream", "gray", "green"), "ceramic")
    foot = 0.6 * r
    body = lathe(
        [
            (0, 0),
            (foot, 0),
            (0.92 * r, 0.5 * h),
            (r, h),
            (r - wall, h),
            (0.8 * r, 0.5 * h),
            (0.4 * r, 0.014),
            (0, 0.012),
        ]
    )
    pestle = cylinder(0.012, 0.11, 16, top=0.008, bevel=0.004)
    pestle = pestle.turn(1, np.deg2rad(38)).move(-0.004, 0, 0.02)
    knob = ellipsoid(0.03, 0.03, 0.03, 16, 10).move(x=-0.002, z=0.027)
    wedges = ring_parts(
        [(foot, 0), (0.92 * r, 0.5 * h), (r, h)],
        [(r - wall, h), (0.75 * r, 0.4 * h), (foot, 0.013)],
    )
    return shape(
        [(body, glaze), (pestle, glaze), (knob, glaze)],
        [*wedges, cylinder_part(foot, 0.013), hull_of(pestle)],
    )


CATEGORIES = (
    Category("beaker", beaker, (0.08, 0.08, 0.1), 0.16, ("glass beaker",), ("lab",), ("round",),
             ("clear",)),
    Category("flask", flask, (0.09, 0.09, 0.155), 0.22, ("conical flask", "erlenmeyer flask",
             "erlenmeyer", "schlenk flask"), ("lab",), ("round", "tall"), ("blue", "green",
             "amber")),
    Category("test_tube_rack", test_tube_rack, (0.18, 0.058, 0.113), 0.28, ("rack of test tubes",
             "tube rack"), ("lab",), (), ("white", "blue")),
    Category("petri_dish", petri_dish, (0.097, 0.097, 0.017), 0.035, ("culture dish",
             "evaporating dish", "watch glass"), ("lab",), ("round", "flat"), ("clear",)),
    Category("microscope", microscope, (0.13, 0.18, 0.33), 2.4, (), ("lab",), ("tall", "big"),
             ("white", "gray")),
    Category("reagent_bottle", reagent_bottle, (0.076, 0.076, 0.145), 0.42, ("lab bottle",
             "chemical bottle", "reagent"), ("lab",), ("round",), ("brown", "clear")),
    Category("pipette_box", pipette_box, (0.12, 0.085, 0.068), 0.12, ("tip box", "pipette tip box"),
             ("lab",), (), ("blue", "yellow")),
    Category("mortar", stirring_dish, (0.11, 0.11, 0.1), 0.5, ("mortar and pestle", "pestle",
             "molcajete", "guacamole bowl"), ("lab", "kitchen"), ("round",), ("white",)),
)  # fmt: skip
