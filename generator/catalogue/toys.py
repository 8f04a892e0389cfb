"""Toys and games."""

from __future__ import annotations

import numpy as np

from . import prints, textures
from .category import Category
from .collision import box_part, cylinder_part, hull_of
from .colors import RGB, tinted
from .look import Look
from .shape import Shape, shape
from .solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    joined,
    lathe,
    torus,
)

BRIGHT = ("red", "blue", "yellow", "green", "orange", "violet")


def toy_block(look: Look) -> Shape:
    """A wooden letter block."""
    side = look.between(0.038, 0.046)
    color = look.color(*BRIGHT)
    face = prints.canvas(96, 96, (232, 208, 166))
    for at in (0.0, 0.91):
        prints.fill(face, at, 0, 0.09, 1, color)
        prints.fill(face, 0, at, 1, 0.09, color)
    prints.write(face, look.pick(list("ABCDEGKMR")), 0.5, 0.5, 0.5, color, bold=True)
    return shape([(box(side, side, side), face)], [box_part(side, side, side)])


def brick(look: Look) -> Shape:
    """A plastic building brick with studs."""
    columns = int(look.rng.integers(2, 5))
    pitch, h = 0.016, 0.0192
    tile = textures.speckled(look.rng, look.color(*BRIGHT, "white"), 3)
    x, y = columns * pitch - 0.0004, 2 * pitch - 0.0004
    studs = [
        cylinder(0.0048, 0.0036, 12).moved(pitch * (i - (columns - 1) / 2), pitch * (j - 0.5), h)
        for i in range(columns)
        for j in range(2)
    ]
    top = box_part(x - 0.006, y - 0.006, 0.0036, (0, 0, h))
    return shape([(box(x, y, h), tile), (joined(studs), tile)], [box_part(x, y, h), top])


def puzzle_cube(look: Look) -> Shape:
    """A 3x3 colour puzzle cube, scrambled."""
    side = 0.057
    paints: tuple[RGB, ...] = (
        (200, 40, 40), (40, 90, 190), (245, 245, 240),
        (245, 205, 50), (50, 150, 70), (240, 130, 40),
    )  # fmt: skip
    pieces = [(box(side, side, side), textures.plain((26, 26, 28)))]
    places = [
        (0.0, -side / 2, 0), (0.0, side / 2, np.pi), (-side / 2, 0.0, -np.pi / 2),
        (side / 2, 0.0, np.pi / 2),
    ]  # fmt: skip
    plate = box(0.97 * side, 0.0008, 0.97 * side)
    for x, y, turn in places:
        pieces.append((plate.turned(2, turn).moved(x, y, 0.015 * side), _stickers(look, paints)))
    top = box(0.97 * side, 0.97 * side, 0.0004).moved(z=side)
    pieces.append((top, _stickers(look, paints)))
    return shape(pieces, [box_part(side, side, side)])


def _stickers(look: Look, paints: tuple[RGB, ...]) -> textures.Tile:
    image = prints.canvas(96, 96, (26, 26, 28))
    for i in range(3):
        for j in range(3):
            paint = paints[int(look.rng.integers(len(paints)))]
            prints.fill(image, 0.03 + 0.32 * i, 0.03 + 0.32 * j, 0.29, 0.29, paint)
    return image


def toy_robot(look: Look) -> Shape:
    """A tin robot with a dial on its chest."""
    color, other = look.color("silver", "red", "teal", "blue", "mustard"), look.fixed(*BRIGHT)
    trim = textures.speckled(look.rng, other, 4)
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
    legs = [box(0.02, 0.03, 0.035).moved(x=s * 0.015) for s in (-1, 1)]
    feet = [block(0.026, 0.046, 0.012, 0.004, 0.002).moved(s * 0.016, -0.005) for s in (-1, 1)]
    arms = [block(0.014, 0.02, 0.045, 0.004, 0.002).moved(s * (w / 2 + 0.007), 0, 0.045)
            for s in (-1, 1)]  # fmt: skip
    body = box(w, 0.036, 0.052).moved(z=0.035)
    head = box(0.04, 0.034, 0.032).moved(z=0.09)
    mast = cylinder(0.002, 0.018, 8).moved(z=0.12)
    knob = ellipsoid(0.009, 0.009, 0.009, 10, 6).moved(z=0.139)
    return shape(
        [
            (body, chest),
            (head, face),
            (joined(legs), dark),
            (joined(feet), trim),
            (joined(arms), trim),
            (cylinder(0.011, 0.004, 14).moved(z=0.0865), dark),
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
    fur = textures.knitted(look.rng, color)
    pale, dark = textures.plain(tinted(color, 1.35)), textures.plain((34, 28, 26))
    ball = ellipsoid
    pieces: list[tuple[Solid, textures.Tile]] = [
        (ball(0.085, 0.075, 0.09, 20, 12).moved(z=0.044), fur),
        (ball(0.075, 0.066, 0.066, 20, 12).moved(y=-0.004, z=0.112), fur),
        (ball(0.034, 0.026, 0.026, 14, 8).moved(y=-0.035, z=0.104), pale),
        (ball(0.012, 0.009, 0.009, 10, 6).moved(y=-0.049, z=0.109), dark),
        (ball(0.05, 0.02, 0.055, 14, 8).moved(y=-0.03, z=0.045), pale),
    ]
    for s in (-1, 1):
        pieces += [
            (ball(0.027, 0.014, 0.027, 12, 8).moved(s * 0.03, 0.002, 0.142), fur),
            (ball(0.008, 0.006, 0.008, 8, 6).moved(s * 0.014, -0.035, 0.122), dark),
            (ball(0.034, 0.07, 0.034, 14, 8).moved(s * 0.034, -0.042, 0.017), fur),
            (ball(0.026, 0.006, 0.026, 12, 6).moved(s * 0.034, -0.075, 0.017), pale),
            (ball(0.028, 0.03, 0.06, 12, 8).turned(1, s * -0.5).moved(s * 0.05, -0.01, 0.058), fur),
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
    skin, beak = textures.speckled(look.rng, color, 3), textures.plain((236, 120, 40))
    dark = textures.plain((24, 24, 26))
    body = ellipsoid(0.085, 0.065, 0.058, 22, 12).bent(
        lambda p: np.column_stack(
            [p[:, :2], np.maximum(p[:, 2] + 6 * np.clip(p[:, 0] - 0.01, 0, 1) ** 2, -0.022)]
        )
    )
    head = ellipsoid(0.046, 0.044, 0.044, 18, 10).moved(x=-0.022, z=0.066)
    bill = ellipsoid(0.026, 0.026, 0.009, 12, 6).moved(x=-0.05, z=0.062)
    eyes = [ellipsoid(0.008, 0.006, 0.009, 8, 6).moved(-0.036, s * 0.0165, 0.073) for s in (-1, 1)]
    wings = [ellipsoid(0.045, 0.014, 0.026, 12, 8).moved(0.01, s * 0.028, 0.026) for s in (-1, 1)]
    return shape(
        [
            (body.moved(z=0.022), skin),
            (head, skin),
            (bill, beak),
            (joined(eyes), dark),
            (joined(wings), textures.plain(tinted(color, 0.9))),
        ],
        [hull_of(body.moved(z=0.022)), hull_of(head), hull_of(bill)],
    )


def die(look: Look) -> Shape:
    """One large die; the visible faces carry different counts."""
    side = look.between(0.018, 0.024)
    ground = look.color("white", "red", "blue", "black", "green")
    ink: RGB = (30, 30, 32) if sum(ground) > 420 else (244, 244, 240)
    cube = box(side, side, side)
    pieces = []
    for k, count in enumerate((1, 6, 2, 5, 3, 4)):
        face = Solid(cube.vertices[4 * k : 4 * k + 4], [[0, 1, 2], [0, 2, 3]],
                     cube.uv[4 * k : 4 * k + 4])  # fmt: skip
        pieces.append((face, prints.pips(count, ground, ink)))
    return shape(pieces, [box_part(side, side, side)])


def playing_cards(look: Look) -> Shape:
    """A squared-up deck of cards, face up."""
    x, y, h = 0.063, 0.088, look.between(0.014, 0.018)
    red = look.chance(0.5)
    ink: RGB = (190, 30, 40) if red else (28, 28, 32)
    face = prints.canvas(96, 134, (250, 249, 244))
    rank = look.pick(["A", "K", "Q", "7"])
    prints.write(face, rank, 0.14, 0.09, 0.11, ink, bold=True)
    face = face[::-1, ::-1].copy()
    prints.write(face, rank, 0.14, 0.09, 0.11, ink, bold=True)
    prints.disc(face, 0.5, 0.5, 0.19, ink)
    prints.disc(face, 0.5, 0.5, 0.11, (250, 249, 244))
    prints.fill(face, 0.42, 0.4, 0.16, 0.2, ink)
    edge = textures.stripes([(250, 249, 244), (206, 204, 198)], 12)
    back = look.color("navy", "crimson", "green")
    return shape(
        [
            (block(x, y, h, 0.003), edge),
            (box(x - 0.003, y - 0.003, 0.0006).moved(z=h - 0.0002), face),
            (box(x - 0.002, y - 0.002, 0.0008).moved(z=0.0001), textures.plain(back)),
        ],
        [box_part(x, y, h)],
    )


def toy_train(look: Look) -> Shape:
    """A wooden locomotive with four wheels."""
    paint = textures.speckled(look.rng, look.color("red", "blue", "green", "violet"), 4)
    other = textures.speckled(look.rng, look.fixed("yellow", "orange", "teal"), 4)
    wood = textures.wood(look.rng, (206, 164, 110))
    bed = block(0.11, 0.044, 0.014, 0.005, 0.002).moved(z=0.014)
    boiler = cylinder(0.019, 0.062, 20, bevel=0.002).turned(1, np.pi / 2).moved(-0.05, 0, 0.045)
    cab = block(0.036, 0.042, 0.052, 0.004, 0.002).moved(x=0.034, z=0.028)
    roof = block(0.048, 0.05, 0.006, 0.004, 0.001).moved(x=0.034, z=0.08)
    chimney = cylinder(0.0065, 0.024, 14, top=0.009).moved(x=-0.034, z=0.062)
    wheels = [
        cylinder(0.0145, 0.007, 18, bevel=0.001).turned(0, np.pi / 2).moved(x, y, 0.0145)
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
            (joined(wheels), other),
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
    start = int(look.rng.integers(6))
    for k in range(5):
        color = look.fixed(BRIGHT[(start + k) % 6])
        ring = torus(0.03 - 0.004 * k, 0.0115, 26, 10).moved(z=0.0225 + 0.0205 * k)
        pieces.append((ring, textures.speckled(look.rng, color, 3)))
    pieces.append((ellipsoid(0.026, 0.026, 0.026, 16, 10).moved(z=0.124), pieces[0][1]))
    pieces.append((cylinder(0.012, 0.11, 14).moved(z=0.01), pieces[0][1]))
    body = lathe([(0, 0), (0.041, 0.0), (0.041, 0.034), (0.013, 0.136), (0, 0.136)], 12)
    return shape(pieces, [cylinder_part(0.045, 0.012), hull_of(body.moved(z=0.001))])


def chess_piece(look: Look) -> Shape:
    """A chess piece: pawn, bishop-like or rook-like."""
    wood = look.surface(look.color("cream", "black", "brown"), "plastic")
    kind = int(look.rng.integers(3))
    r, h = 0.016, (0.042, 0.06, 0.048)[kind]
    neck = [(0, 0), (r, 0), (r, 0.006), (0.8 * r, 0.011), (0.42 * r, 0.5 * h), (0.62 * r, 0.62 * h)]
    if kind == 2:
        head = [(0.72 * r, 0.66 * h), (0.72 * r, h), (0, h)]
    else:
        angles = np.linspace(-0.9, np.pi / 2, 7)
        ball = np.column_stack([0.6 * r * np.cos(angles), 0.8 * h + 0.2 * h * np.sin(angles)])
        head = [tuple(p) for p in ball[:-1]] + [(0, h)]
    body = lathe([*neck, *head], 20)
    return shape([(body, wood)], [cylinder_part(r, 0.008), hull_of(body)])


CATEGORIES = (
    Category(
        "toy_block",
        toy_block,
        (0.042, 0.042, 0.042),
        0.045,
        ("letter block", "wooden block", "block", "cube", "alphabet block"),
        ("toys",),
        (),
        BRIGHT,
    ),
    Category(
        "building_brick",
        brick,
        (0.05, 0.0316, 0.0228),
        0.012,
        ("toy brick", "lego brick", "lego", "brick", "building block"),
        ("toys", "craft"),
        (),
        BRIGHT,
    ),
    Category(
        "puzzle_cube",
        puzzle_cube,
        (0.058, 0.058, 0.058),
        0.09,
        ("rubik's cube", "rubiks cube", "magic cube", "rubik cube"),
        ("toys", "office"),
    ),
    Category(
        "toy_robot",
        toy_robot,
        (0.083, 0.048, 0.143),
        0.16,
        ("robot", "figurine", "action figure", "toy figure", "figure"),
        ("toys", "craft"),
        ("tall",),
        ("silver", "red", "teal"),
    ),
    Category(
        "teddy_bear",
        teddy_bear,
        (0.13, 0.12, 0.155),
        0.11,
        ("teddy", "stuffed animal", "plush toy", "bear", "plush"),
        ("toys",),
        (),
        ("brown", "cream"),
        friction=0.8,
        state="sitting",
    ),
    Category(
        "rubber_duck",
        rubber_duck,
        (0.1, 0.066, 0.088),
        0.05,
        ("duck", "toy duck", "bath duck"),
        ("toys", "vanity"),
        (),
        ("yellow",),
    ),
    Category(
        "die",
        die,
        (0.021, 0.021, 0.021),
        0.012,
        ("dice", "gaming die"),
        ("toys", "games"),
        (),
        ("white", "red"),
    ),
    Category(
        "playing_cards",
        playing_cards,
        (0.063, 0.088, 0.016),
        0.095,
        ("deck of cards", "pack of cards", "cards", "card deck", "deck"),
        ("games", "coffee"),
        ("flat",),
        state="lying flat",
    ),
    Category(
        "toy_train",
        toy_train,
        (0.115, 0.058, 0.088),
        0.15,
        ("train", "locomotive", "toy locomotive"),
        ("toys",),
        (),
        ("red", "blue"),
    ),
    Category(
        "stacking_rings",
        stacking_rings,
        (0.09, 0.09, 0.137),
        0.22,
        ("ring stacker", "stacking toy"),
        ("toys",),
        ("round",),
    ),
    Category(
        "chess_piece",
        chess_piece,
        (0.032, 0.032, 0.05),
        0.035,
        ("pawn", "rook", "chessman", "bishop"),
        ("games",),
        ("round",),
        ("cream", "black"),
    ),
)
