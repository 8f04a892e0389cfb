"""Bottles, cans, jars, cartons, shakers: what food and drink come in."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, frame_parts, hull_of, hull_part, ring_parts
from ...build.outlines import rectangle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, lathe, loft, open_box, torus
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

PRINTS = ("red", "navy", "teal", "green", "mustard", "crimson", "orange", "purple", "blue")


def can(look: Look) -> Shape:
    """A tin of soup or a can of soda."""
    soup = look.chance(0.5)
    r, h = (look.between(0.033, 0.037), look.between(0.1, 0.112)) if soup else (0.033, 0.12)
    color = look.color(*PRINTS)
    word = look.pick(["SOUP", "BEANS", "TOMATO", "CORN"] if soup else ["COLA", "FIZZ", "LIME"])
    print_ = prints.label(
        look.rng,
        word,
        color,
        (244, 240, 228) if soup else tint_color(color, look.pick([0.75, 1.5])),
    )
    steel = textures.plain((196, 198, 202))
    rim = 0.0022 if soup else 0.005
    body = lathe(
        [(0, 0.001), (r - rim, 0), (r, rim), (r, h - rim), (r - rim, h),
         (r - rim - 0.002, h - 0.002), (0, h - 0.002)],
        v=[0, 0.02, 0.04, 0.96, 0.98, 0.99, 1],
    )  # fmt: skip
    tile = textures.stack((steel, 4), (print_, 92), (steel, 4), side=160)
    pull = torus(0.007, 0.0016, 16, 6).scale(1, 1.4, 0.8).move(y=-0.006, z=h - 0.0015)
    return shape([(body, tile), (pull, textures.plain((168, 170, 176)))], [cylinder_part(r, h)])


def milk_carton(look: Look) -> Shape:
    """A gable-top carton; its printed front faces the viewer."""
    x, h = look.between(0.066, 0.074), look.between(0.15, 0.19)
    color = look.color("blue", "red", "green", "teal", "sky", "orange")
    word = look.pick(["MILK", "OATS", "JUICE", "CREAM"])
    front = prints.canvas(96, 160, (248, 248, 246))
    prints.fill(front, 0, 0.7, 1, 0.3, color)
    prints.disc(front, 0.5, 0.68, 0.16, tint_color(color, 1.4))
    prints.write(front, word, 0.5, 0.2, 0.14, color, bold=True)
    prints.lines(front, look.rng, (0.2, 0.36, 0.6, 0.08), 2, (140, 140, 150))
    square, ridge = rectangle(x, x), rectangle(x, 0.003)
    roof, top = h + 0.4 * x, h + 0.4 * x + 0.014
    gable = loft(
        np.stack(
            [np.column_stack([o, np.full(4, z)])
             for o, z in [(square, h), (ridge, roof), (ridge, top)]]
        ),
        square,
    )  # fmt: skip
    pieces = [
        (box(x, x, h), front),
        (gable, textures.speckles(look.rng, tint_color(color, 1.1), 3)),
    ]
    if look.chance(0.6):
        cap = cylinder(0.011, 0.012, 18, bevel=0.001).move(z=-0.002)
        cap = cap.turn(0, np.deg2rad(39)).move(y=-0.26 * x, z=h + 0.19 * x)
        pieces.append((cap, textures.plain(look.own_color("white", "red", "blue"))))
    return shape(pieces, [box_part(x, x, h), hull_of(gable)])


def _shaker(look: Look, letter: str, fill_color: RGB) -> Shape:
    r, h = look.between(0.02, 0.024), look.between(0.068, 0.088)
    style = int(look.rng.integers(3))
    palette = ("white", "cream", "sky") if letter == "S" else ("black", "brown", "gray")
    color = look.color(*palette)
    body = lathe([(0, 0), (r, 0), (r, 0.004), (0.84 * r, 0.72 * h), (0, 0.72 * h)], 24)
    skin = prints.canvas(128, 64, color)
    ink = (40, 40, 44) if sum(color) > 380 else (240, 240, 236)
    middle = skin[:, 48:80]
    prints.write(middle, letter, 0.5, 0.5, 0.5, ink, bold=True)
    if style == 0:  # glass: the filling shows
        clear = textures.plain((214, 226, 230))
        skin = textures.stack((textures.plain(fill_color), 6), (clear, 4))
    cap = lathe(
        [(0, 0.7 * h), (0.9 * r, 0.7 * h), (0.9 * r, 0.86 * h), (0.6 * r, 0.97 * h), (0, h)], 24
    )
    steel = textures.brushed_metal(look.rng, look.own_color("silver", "silver", "gold"))
    pieces = [(body, skin), (cap, steel)]
    hole = cylinder(0.0013, 0.002, 8)
    dark = textures.plain((40, 40, 42))
    for k in range(5 if letter == "S" else 3):
        at = 0.007 * np.array([np.cos(2.1 * k), np.sin(2.1 * k)]) * (k > 0)
        pieces.append((hole.move(at[0], at[1], 0.98 * h - 0.0012), dark))
    return shape(pieces, [hull_of(body), hull_part(cap.vertices)])


def salt_shaker(look: Look) -> Shape:
    """A salt shaker with a metal top."""
    return _shaker(look, "S", (246, 246, 244))


def pepper_shaker(look: Look) -> Shape:
    """A pepper shaker with a metal top, or a turned wooden mill."""
    if look.chance(0.6):
        return _shaker(look, "P", (70, 60, 54))
    r, h = 0.026, look.between(0.13, 0.17)
    t = np.linspace(0, 1, 12)
    waist = r * (0.78 + 0.22 * np.cos(2 * np.pi * t) - 0.06 * np.sin(4 * np.pi * t))
    body = lathe([(0, 0), *np.column_stack([waist, 0.76 * h * t]), (0, 0.76 * h)], 24)
    head = lathe(
        [(0, 0.77 * h), (0.9 * r, 0.77 * h), (0.95 * r, 0.84 * h), (0.7 * r, 0.92 * h),
         (0.2 * r, 0.95 * h), (0, 0.95 * h)], 24,
    )  # fmt: skip
    knob = lathe([(0, 0.94 * h), (0.006, 0.95 * h), (0.007, 0.975 * h), (0, h)], 14)
    tile = look.surface(look.color("brown", "wooden", "black", "maroon"), "wood")
    return shape(
        [(body, tile), (head, tile), (knob, textures.brushed_metal(look.rng, (196, 198, 202)))],
        [cylinder_part(r, 0.05 * h), cylinder_part(0.76 * r, 0.72 * h, (0, 0, 0.04 * h)),
         hull_of(head), hull_of(knob)],
    )  # fmt: skip


def sugar_bowl(look: Look) -> Shape:
    """A round lidded bowl with two small ears."""
    r, h = look.between(0.044, 0.05), look.between(0.06, 0.07)
    glaze = look.surface(look.color("white", "cream", "sky", "pink", "navy"), "ceramic")
    t = np.linspace(0, np.pi / 2, 7)
    rise = 0.004 + (h - 0.004) * t / t[-1]
    wall = np.column_stack([0.55 * r + 0.45 * r * np.sin(1.25 * t), rise])
    body = lathe([(0, 0), (0.55 * r, 0), *wall, (0, h)])
    rim = float(wall[-1, 0]) * 1.02
    lid = lathe(
        [(0, h), (rim, h), (rim, h + 0.004), (0.6 * rim, h + 0.014), (0.006, h + 0.018),
         (0.005, h + 0.022), (0.009, h + 0.028), (0.006, h + 0.034), (0, h + 0.035)], 28,
    )  # fmt: skip
    ears = [
        torus(0.011, 0.0032, 16, 8).turn(0, np.pi / 2).move(x=side * r * 0.98, z=0.62 * h)
        for side in (-1, 1)
    ]
    return shape(
        [(body, glaze), (lid, glaze), *((ear, glaze) for ear in ears)],
        [hull_of(body), hull_of(lid),
         *[box_part(0.026, 0.006, 0.024, (side * r, 0, 0.62 * h - 0.012)) for side in (-1, 1)]],
    )  # fmt: skip


def basket(look: Look) -> Shape:
    """A woven basket, open at the top; things go into it."""
    color = look.color("tan", "brown", "beige", "wooden", "white")
    weave = textures.basketwork(look.rng, color)
    dark = textures.speckles(look.rng, tint_color(color, 0.75), 6, 32)
    if look.chance(0.5):
        r, h, wall = look.between(0.1, 0.12), look.between(0.08, 0.1), 0.007
        low = 0.82 * r
        body = lathe(
            [(0, 0), (low, 0), (r, h), (r - wall, h), (low - wall, 0.008), (0, 0.008)],
            v=[0, 0, 0.48, 0.52, 1, 1],
        )
        rim = torus(r - wall / 2, 0.0065, 32, 8).move(z=h)
        return shape(
            [(body, weave), (rim, dark)],
            [*ring_parts([(low, 0), (r, h)], [(r - wall, h), (low - wall, 0.008)]),
             cylinder_part(low, 0.008)],
        )  # fmt: skip
    x, y, h, wall = look.between(0.22, 0.27), look.between(0.15, 0.18), 0.09, 0.008
    rails = [
        block(x + 0.006, 0.012, 0.012, 0.003).move(y=side * (y - 0.008) / 2, z=h - 0.006)
        for side in (-1, 1)
    ] + [
        block(0.012, y + 0.006, 0.012, 0.003).move(x=side * (x - 0.008) / 2, z=h - 0.006)
        for side in (-1, 1)
    ]
    return shape(
        [*((s, weave) for s in open_box(x, y, h, wall, wall)), *((s, dark) for s in rails)],
        frame_parts(x, y, h, wall, wall),
    )


CATEGORIES = (
    Category(
        "can",
        can,
        (0.068, 0.068, 0.113),
        0.36,
        ("tin can",),
        ("kitchen", "dining", "office"),
        ("round",),
        ("red", "navy", "green"),
    ),
    Category(
        "milk_carton",
        milk_carton,
        (0.07, 0.07, 0.213),
        0.75,
        ("carton", "carton of milk", "milk", "milk box", "tetra pak", "tetrapak carton"),
        ("kitchen", "dining"),
        ("tall",),
        ("blue", "red", "green"),
    ),
    Category(
        "salt_shaker",
        salt_shaker,
        (0.044, 0.044, 0.078),
        0.12,
        ("salt", "salt cellar", "sugar pourer"),
        ("dining", "kitchen"),
        ("round",),
        ("white",),
    ),
    Category(
        "pepper_shaker",
        pepper_shaker,
        (0.046, 0.046, 0.1),
        0.12,
        ("pepper",),
        ("dining", "kitchen"),
        ("round",),
        ("black", "brown"),
    ),
    Category(
        "sugar_bowl",
        sugar_bowl,
        (0.12, 0.096, 0.1),
        0.35,
        ("sugar pot", "sugar", "sugar jar"),
        ("coffee", "dining"),
        ("round",),
        ("white", "cream"),
    ),
    Category(
        "basket",
        basket,
        (0.24, 0.19, 0.095),
        0.35,
        (
            "fruit basket",
            "bread basket",
            "wicker basket",
            "storage basket",
            "bin",
            "creel",
            "hanging basket",
            "trug",
            "waste-paper basket",
            "tub of maggots",
        ),
        ("kitchen", "dining", "craft"),
        ("container", "big"),
        ("tan", "brown"),
    ),
)
