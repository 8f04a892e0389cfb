"""Games: cubes, dice, cards, chess."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, lathe
from ...surfaces import prints, textures
from ...surfaces.colors import RGB
from ...surfaces.look import Look


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
        pieces.append((plate.turn(2, turn).move(x, y, 0.015 * side), _stickers(look, paints)))
    top = box(0.97 * side, 0.97 * side, 0.0004).move(z=side)
    pieces.append((top, _stickers(look, paints)))
    return shape(pieces, [box_part(side, side, side)])


def _stickers(look: Look, paints: tuple[RGB, ...]) -> textures.Tile:
    image = prints.canvas(96, 96, (26, 26, 28))
    for i in range(3):
        for j in range(3):
            paint = paints[int(look.rng.integers(len(paints)))]
            prints.fill(image, 0.03 + 0.32 * i, 0.03 + 0.32 * j, 0.29, 0.29, paint)
    return image


def die(look: Look) -> Shape:
    """One large die; the visible faces carry different counts."""
    side = look.between(0.018, 0.024)
    ground = look.color("white", "red", "blue", "black", "green")
    ink: RGB = (30, 30, 32) if sum(ground) > 420 else (244, 244, 240)
    cube = box(side, side, side)
    pieces = []
    for k, count in enumerate((1, 6, 2, 5, 3, 4)):
        face = Solid(cube.vertices[4 * k : 4 * k + 4], np.array([[0, 1, 2], [0, 2, 3]]),
                     cube.uv[4 * k : 4 * k + 4])  # fmt: skip
        pieces.append((face, prints.pips(count, ground, ink)))
    return shape(pieces, [box_part(side, side, side)])


def playing_cards(look: Look) -> Shape:
    """A squared-up deck of cards, face up."""
    x, y, h = 0.063, 0.088, look.between(0.014, 0.018)
    red = look.chance(0.5)
    ink: RGB = (190, 30, 40) if red else (28, 28, 32)
    face = prints.canvas(96, 134, (250, 249, 244))
    rank = look.pick(["A", "K", "Q", "J", "7", "10", "2", "9"])
    prints.write(face, rank, 0.14, 0.09, 0.11, ink, bold=True)
    face = face[::-1, ::-1].copy()
    prints.write(face, rank, 0.14, 0.09, 0.11, ink, bold=True)
    prints.disc(face, 0.5, 0.5, 0.19, ink)
    prints.disc(face, 0.5, 0.5, 0.11, (250, 249, 244))
    prints.fill(face, 0.42, 0.4, 0.16, 0.2, ink)
    edge = textures.stripes([(250, 249, 244), (206, 204, 198)], 12)
    back = look.color("navy", "crimson", "green", "black", "violet")
    return shape(
        [
            (block(x, y, h, 0.003), edge),
            (box(x - 0.003, y - 0.003, 0.0006).move(z=h - 0.0002), face),
            (box(x - 0.002, y - 0.002, 0.0008).move(z=0.0001), textures.plain(back)),
        ],
        [box_part(x, y, h)],
    )


def chess_piece(look: Look) -> Shape:
    """A chess piece: pawn, bishop-like or rook-like."""
    wood = look.surface(
        look.color("cream", "black", "brown", "white", "crimson", "tan"),
        look.pick(["plastic", "wood"]),
    )
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
        "puzzle_cube",
        puzzle_cube,
        (0.058, 0.058, 0.058),
        0.09,
        ("rubik's cube", "rubiks cube", "magic cube", "rubik cube"),
        ("toys", "office"),
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
        (
            "deck of cards",
            "pack of cards",
            "cards",
            "card deck",
            "deck",
            "uno deck",
            "deck of uno cards",
        ),
        ("games", "coffee"),
        ("flat",),
        state="lying flat",
    ),
    Category(
        "chess_piece",
        chess_piece,
        (0.032, 0.032, 0.05),
        0.035,
        ("chessman", "chessman of lewis"),
        ("games",),
        ("round",),
        ("cream", "black"),
    ),
)
