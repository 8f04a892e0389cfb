"""Toys."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

BRIGHT = ("red", "blue", "yellow", "green", "orange", "violet", "pink", "teal", "lime")


def _side(outline: list[tuple[float, float]], width: float, bevel: float = 0.0) -> Solid:
    """Return a side view (x, z; counter-clockwise) as thick as ``width`` along y."""
    return prism(outline, -width / 2, width / 2, bevel).turn(0, np.pi / 2)


def toy_car(look: Look) -> Shape:
    """A model car; it drives towards +x."""
    color = look.color("red", "blue", "navy", "silver", "yellow", "green", "white")
    paint, dark = textures.speckles(look.rng, color, 4), textures.plain((34, 38, 44))
    glass = textures.gradient((30, 36, 44), (92, 106, 118), look.rng)
    k, w = look.between(0.92, 1.1), look.between(0.062, 0.068)
    cabin = look.pick([-0.01, 0.0, 0.008])
    hull = _side(
        [(-0.07 * k, 0.009), (0.072 * k, 0.009), (0.08 * k, 0.016), (0.079 * k, 0.026),
         (0.052 * k, 0.034), (-0.072 * k, 0.037), (-0.079 * k, 0.03), (-0.08 * k, 0.016)],
        w, 0.006,
    )  # fmt: skip
    windows = _side(
        [(cabin - 0.06, 0.033), (cabin + 0.034, 0.031), (cabin + 0.008, 0.053),
         (cabin - 0.038, 0.054)],
        0.86 * w, 0.005,
    )  # fmt: skip
    roof = _side(
        [(cabin - 0.04, 0.0525), (cabin + 0.01, 0.0515), (cabin + 0.006, 0.0565),
         (cabin - 0.034, 0.0575)],
        0.78 * w, 0.002,
    )  # fmt: skip
    pillar = _side([(cabin - 0.018, 0.033), (cabin - 0.01, 0.033), (cabin - 0.012, 0.0535),
                    (cabin - 0.017, 0.0535)], 0.875 * w)  # fmt: skip
    places = [(x * k, s * (w / 2 - 0.004)) for x in (-0.048, 0.05) for s in (-1, 1)]
    wheel = cylinder(0.0135, 0.011, 18, bevel=0.002).turn(0, np.pi / 2).move(y=0.0055)
    rim = cylinder(0.008, 0.0122, 12).turn(0, np.pi / 2).move(y=0.0061)
    lamps = [ellipsoid(0.008, 0.013, 0.007, 10, 6).move(0.075 * k, s * 0.022, 0.0255)
             for s in (-1, 1)]  # fmt: skip
    tails = [box(0.004, 0.013, 0.006).move(-0.0785 * k, s * 0.022, 0.022) for s in (-1, 1)]
    pieces = [
        (hull, paint), (windows, glass), (roof, paint), (pillar, paint),
        (join([wheel.move(x, y, 0.0135) for x, y in places]), dark),
        (join([rim.move(x, y, 0.0135) for x, y in places]), textures.plain((196, 198, 202))),
        (join(lamps), textures.plain((246, 244, 226))),
        (join(tails), textures.plain((150, 20, 24))),
    ]  # fmt: skip
    if look.chance(0.4):
        stripe = textures.plain(look.own_color("white", "black", "yellow"))
        pieces.append(
            (box(0.044 * k, 0.014, 0.0012).turn(1, 0.28).move(0.054 * k, 0, 0.0335), stripe)
        )
        pieces.append((box(0.04, 0.014, 0.001).move(cabin - 0.014, 0, 0.0572), stripe))
    track = box_part(0.125 * k, w, 0.012)
    return shape(pieces, [track, hull_of(hull), hull_of(windows, roof)])


def toy_block(look: Look) -> Shape:
    """A wooden letter block, painted where a colour is asked for."""
    side = look.between(0.038, 0.046)
    color, bare = look.color(*BRIGHT), (232.0, 208.0, 166.0)
    ground, ink = (color, bare) if "color" in look.attributes else (bare, color)
    face = prints.canvas(96, 96, ground)
    for at in (0.0, 0.91):
        prints.fill(face, at, 0, 0.09, 1, color)
        prints.fill(face, 0, at, 1, 0.09, color)
    prints.write(face, look.pick(list("ABCDEGKMR")), 0.5, 0.5, 0.5, ink, bold=True)
    return shape([(box(side, side, side), face)], [box_part(side, side, side)])


def brick(look: Look) -> Shape:
    """A plastic building brick with studs."""
    columns = int(look.rng.integers(2, 5))
    pitch, h = 0.016, 0.0192
    tile = textures.speckles(look.rng, look.color(*BRIGHT, "white"), 3)
    x, y = columns * pitch - 0.0004, 2 * pitch - 0.0004
    studs = [
        cylinder(0.0048, 0.0036, 12).move(pitch * (i - (columns - 1) / 2), pitch * (j - 0.5), h)
        for i in range(columns)
        for j in range(2)
    ]
    top = box_part(x - 0.006, y - 0.006, 0.0036, (0, 0, h))
    return shape([(box(x, y, h), tile), (join(studs), tile)], [box_part(x, y, h), top])


def toy_robot(look: Look) -> Shape:
    """A tin robot with a dial on its chest."""
    color, other = look.color("silver", "red", "teal", "blue", "mustard"), look.own_color(*BRIGHT)
    trim = textures.speckles(look.rng, other, 4)
    dark = textures.plain((50, 52, 56))
    chest = prints.canvas(64, 64, color)
    prints.fill(chest, 0.15, 0.2, 0.7, 0.55, (235, 235, 225))
    prints.disc(chest, 0.35, 0.45, 0.13, (200, 60, 50))
    prints.disc(chest, 0.66, 0.45, 0.1, (60, 120, 190))
    face = prints.canvas(64, 64, color)
    for x in (0.3, 0.7):
        prints.disc(face, x, 0.38, 0.13, (250, 240, 150))
        prints.disc(face, x, 0.38, 0.06, (30, 30, 30))
    prints.fill(face, 0.25, 0.68, 0.5, 0.1, (60, 40, 40))
    w = look.between(0.05, 0.06)
    legs = [box(0.02, 0.03, 0.035).move(x=s * 0.015) for s in (-1, 1)]
    feet = [block(0.026, 0.046, 0.012, 0.004, 0.002).move(s * 0.016, -0.005) for s in (-1, 1)]
    arms = [block(0.014, 0.02, 0.045, 0.004, 0.002).move(s * (w / 2 + 0.007), 0, 0.045)
            for s in (-1, 1)]  # fmt: skip
    body = box(w, 0.036, 0.052).move(z=0.035)
    head = box(0.04, 0.034, 0.032).move(z=0.09)
    mast = cylinder(0.002, 0.018, 8).move(z=0.12)
    knob = ellipsoid(0.009, 0.009, 0.009, 10, 6).move(z=0.139)
    return shape(
        [
            (body, chest),
            (head, face),
            (join(legs), dark),
            (join(feet), trim),
            (join(arms), trim),
            (cylinder(0.011, 0.004, 14).move(z=0.0865), dark),
            (mast, dark),
            (knob, textures.plain(other)),
        ],
        [
            box_part(0.058, 0.046, 0.035, (0, -0.005, 0)),
            box_part(w + 0.028, 0.036, 0.052, (0, 0, 0.035)),
            box_part(0.04, 0.034, 0.035, (0, 0, 0.087)),
            box_part(0.008, 0.008, 0.021, (0, 0, 0.122)),
        ],
    )


def teddy_bear(look: Look) -> Shape:
    """A small sitting teddy bear."""
    color = look.color("brown", "tan", "cream", "gray", "terracotta")
    fur = textures.knitting(look.rng, color)
    pale, dark = textures.plain(tint_color(color, 1.35)), textures.plain((34, 28, 26))
    ball = ellipsoid
    pieces: list[tuple[Solid, textures.Tile]] = [
        (ball(0.085, 0.075, 0.09, 20, 12).move(z=0.044), fur),
        (ball(0.075, 0.066, 0.066, 20, 12).move(y=-0.004, z=0.112), fur),
        (ball(0.034, 0.026, 0.026, 14, 8).move(y=-0.035, z=0.104), pale),
        (ball(0.012, 0.009, 0.009, 10, 6).move(y=-0.049, z=0.109), dark),
        (ball(0.05, 0.02, 0.055, 14, 8).move(y=-0.03, z=0.045), pale),
    ]
    for s in (-1, 1):
        pieces += [
            (ball(0.027, 0.014, 0.027, 12, 8).move(s * 0.03, 0.002, 0.142), fur),
            (ball(0.008, 0.006, 0.008, 8, 6).move(s * 0.014, -0.035, 0.122), dark),
            (ball(0.034, 0.07, 0.034, 14, 8).move(s * 0.034, -0.042, 0.017), fur),
            (ball(0.026, 0.006, 0.026, 12, 6).move(s * 0.034, -0.075, 0.017), pale),
            (ball(0.028, 0.03, 0.06, 12, 8).turn(1, s * -0.5).move(s * 0.05, -0.01, 0.058), fur),
        ]
    seat = cylinder(0.034, 0.05, 16, top=0.04)
    return shape(
        [*pieces, (seat, fur)],
        [
            cylinder_part(0.036, 0.085),
            box_part(0.1, 0.06, 0.03, (0, -0.047, 0.0)),
            box_part(0.06, 0.055, 0.055, (0, -0.006, 0.085)),
            box_part(0.115, 0.024, 0.035, (0, -0.01, 0.042)),
        ],
    )


def rubber_duck(look: Look) -> Shape:
    """A bath duck; it faces the viewer's left."""
    color = look.color("yellow", "yellow", "pink", "sky", "mint")
    skin, beak = textures.speckles(look.rng, color, 3), textures.plain((236, 120, 40))
    dark = textures.plain((24, 24, 26))
    body = ellipsoid(0.085, 0.065, 0.058, 22, 12).bend(
        lambda p: np.column_stack(
            [p[:, :2], np.maximum(p[:, 2] + 6 * np.clip(p[:, 0] - 0.01, 0, 1) ** 2, -0.022)]
        )
    )
    head = ellipsoid(0.046, 0.044, 0.044, 18, 10).move(x=-0.022, z=0.066)
    bill = ellipsoid(0.026, 0.026, 0.009, 12, 6).move(x=-0.05, z=0.062)
    eyes = [ellipsoid(0.008, 0.006, 0.009, 8, 6).move(-0.036, s * 0.0165, 0.073) for s in (-1, 1)]
    wings = [ellipsoid(0.045, 0.014, 0.026, 12, 8).move(0.01, s * 0.028, 0.026) for s in (-1, 1)]
    return shape(
        [
            (body.move(z=0.022), skin),
            (head, skin),
            (bill, beak),
            (join(eyes), dark),
            (join(wings), textures.plain(tint_color(color, 0.9))),
        ],
        [hull_of(body.move(z=0.022)), hull_of(head), hull_of(bill)],
    )


def toy_train(look: Look) -> Shape:
    """A wooden locomotive with four wheels."""
    paint = textures.speckles(look.rng, look.color("red", "blue", "green", "violet"), 4)
    other = textures.speckles(look.rng, look.own_color("yellow", "orange", "teal"), 4)
    wood = textures.wood(look.rng, (206, 164, 110))
    bed = block(0.11, 0.044, 0.014, 0.005, 0.002).move(z=0.014)
    boiler = cylinder(0.019, 0.062, 20, bevel=0.002).turn(1, np.pi / 2).move(-0.05, 0, 0.045)
    cab = block(0.036, 0.042, 0.052, 0.004, 0.002).move(x=0.034, z=0.028)
    roof = block(0.048, 0.05, 0.006, 0.004, 0.001).move(x=0.034, z=0.08)
    chimney = cylinder(0.0065, 0.024, 14, top=0.009).move(x=-0.034, z=0.062)
    wheels = [
        cylinder(0.0145, 0.007, 18, bevel=0.001).turn(0, np.pi / 2).move(x, y, 0.0145)
        for x in (-0.034, 0.034)
        for y in (-0.022, 0.029)
    ]
    return shape(
        [
            (bed, wood),
            (boiler, paint),
            (cab, paint),
            (roof, other),
            (chimney, other),
            (join(wheels), other),
        ],
        [
            box_part(0.084, 0.058, 0.014),
            box_part(0.11, 0.044, 0.014, (0, 0, 0.014)),
            box_part(0.062, 0.036, 0.036, (-0.02, 0, 0.028)),
            box_part(0.048, 0.05, 0.058, (0.034, 0, 0.028)),
            cylinder_part(0.0085, 0.022, (-0.034, 0, 0.064)),
        ],
    )


def stacking_rings(look: Look) -> Shape:
    """A baby's cone of coloured rings on a peg."""
    pieces: list[tuple[Solid, textures.Tile]] = [
        (cylinder(0.045, 0.012, 28, bevel=0.003), textures.wood(look.rng, (214, 176, 124)))
    ]
    start, pastel = int(look.rng.integers(len(BRIGHT))), look.pick([1.0, 1.0, 1.4])
    for k in range(5):
        color = tint_color(look.own_color(BRIGHT[(start + k) % len(BRIGHT)]), pastel)
        ring = torus(0.03 - 0.004 * k, 0.0115, 26, 10).move(z=0.0225 + 0.0205 * k)
        pieces.append((ring, textures.speckles(look.rng, color, 3)))
    pieces.append((ellipsoid(0.026, 0.026, 0.026, 16, 10).move(z=0.124), pieces[0][1]))
    pieces.append((cylinder(0.012, 0.11, 14).move(z=0.01), pieces[0][1]))
    body = lathe([(0, 0), (0.041, 0.0), (0.041, 0.034), (0.013, 0.136), (0, 0.136)], 12)
    return shape(pieces, [cylinder_part(0.045, 0.012), hull_of(body.move(z=0.001))])


CATEGORIES = (
    Category("toy_car", toy_car, (0.16, 0.07, 0.058), 0.16, ("car", "model car", "miniature car",
             "race car", "vehicle", "matchbox car", "hot wheels car", "die cast car",
             "diecast car"), ("toys", "craft"), (), ("red", "blue", "yellow")),
    Category("toy_block", toy_block, (0.042, 0.042, 0.042), 0.045, ("letter block", "wooden block",
             "block", "alphabet block", "wood block cube", "counting cube", "stacked block",
             "letter e block", "soft block", "building blocks", "base ten block"), ("toys",), (),
             BRIGHT),
    Category("building_brick", brick, (0.05, 0.0316, 0.0228), 0.012, ("toy brick", "lego brick",
             "lego", "brick", "building block"), ("toys", "craft"), (), BRIGHT),
    Category("toy_robot", toy_robot, (0.083, 0.048, 0.143), 0.16, ("robot", "action figure",
             "toy figure", "figure", "robot kit", "wind-up toy", "wind up toy", "star wars figure",
             "kinder toy", "cereal toy"), ("toys", "craft"), ("tall",), ("silver", "red", "teal")),
    Category("teddy_bear", teddy_bear, (0.13, 0.12, 0.155), 0.11, ("teddy", "stuffed animal",
             "plush toy", "bear", "plush", "cuddly toy", "comforter", "soft toy", "counting bear",
             "amigurumi", "plush cat", "soft toy cat", "stuffed cat", "plush rabbit", "plush dog",
             "beanie baby", "plushie", "stuffed toy"), ("toys",), (), ("brown", "cream"),
             friction=0.8, state="sitting"),
    Category("rubber_duck", rubber_duck, (0.1, 0.066, 0.088), 0.05, ("duck", "toy duck",
             "bath duck", "bath toy", "rubber bath duck", "squeaky toy"), ("toys", "vanity"), (),
             ("yellow",)),
    Category("toy_train", toy_train, (0.115, 0.058, 0.088), 0.15, ("train", "locomotive",
             "toy locomotive"), ("toys",), (), ("red", "blue")),
    Category("stacking_rings", stacking_rings, (0.09, 0.09, 0.137), 0.22, ("ring stacker",
             "stacking toy", "stacking ring tower", "stacking ring toy"), ("toys",), ("round",)),
)  # fmt: skip
