"""Clothes and blankets that lie on tables."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of, hull_part
from ...build.forms import above, facing
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, join, lathe, loft, sweep, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look


def hat(look: Look) -> Shape:
    """A brimmed hat: straw, fedora or sun hat, with a ribbon round its crown."""
    k = look.between(0.9, 1.05)
    color = look.color("tan", "beige", "brown", "black", "white", "gray", "navy", "cream")
    kind = look.pick(["fedora", "sun", "bowler"])
    brim = {"fedora": 0.155, "sun": 0.19, "bowler": 0.135}[kind] * k
    h = {"fedora": 0.115, "sun": 0.1, "bowler": 0.115}[kind] * k
    r = 0.088 * k
    side = {
        "fedora": [(r, 0.004), (0.92 * r, 0.8 * h), (0.72 * r, h), (0.3 * r, 0.93 * h)],
        "sun": [(r, 0.004), (0.94 * r, 0.5 * h), (0.7 * r, 0.9 * h), (0.3 * r, h)],
        "bowler": [(r, 0.004), (1.0 * r, 0.5 * h), (0.78 * r, 0.88 * h), (0.35 * r, h)],
    }[kind]
    curl = 0.012 if kind != "sun" else 0.0
    body = lathe(
        [
            (0, 0),
            (0.9 * brim, 0),
            (brim, max(curl, 0)),
            (0.995 * brim, max(curl, 0) + 0.003),
            (0.85 * brim, 0.004),
            *side,
            (0, side[-1][1]),
        ],
        36,
    )
    straw = (
        textures.basketwork(look.rng, color, 20)
        if look.chance(0.5) and sum(color) > 330
        else textures.fabric(look.rng, color)
    )
    pinch = 0.3 if kind == "fedora" else 0.0

    def dent(p: np.ndarray) -> np.ndarray:
        up = np.clip((p[:, 2] / h - 0.55) / 0.45, 0, 1)
        middle = np.exp(-((p[:, 0] / (0.35 * r)) ** 2))
        return p * np.column_stack([1 - 0.1 * pinch * up, np.ones(len(p)),
                                    1 - pinch * 0.4 * up * middle])  # fmt: skip

    band = lathe(
        [
            (r - 0.003, 0.005),
            (r + 0.0022, 0.005),
            (0.97 * r + 0.0022, 0.032),
            (0.96 * r - 0.003, 0.032),
        ],
        36,
        loop=True,
    ).scale(0.88, 1, 1)
    ribbon = textures.plain(look.own_color("black", "navy", "red", "brown", "white", "green"))
    body = body.scale(0.88, 1, 1).bend(dent)
    low = body.vertices[body.vertices[:, 2] < 0.02]
    high = body.vertices[body.vertices[:, 2] > 0.0039]
    high = high[np.hypot(high[:, 0] / 0.88, high[:, 1]) < 1.01 * r]
    return shape([(body, straw), (band, ribbon)], [hull_part(low), hull_part(high)])


def blanket(look: Look) -> Shape:
    """A folded blanket or scarf: layers with rounded folds, a pattern, fringes at its edge."""
    x, y, h = look.between(0.26, 0.34), look.between(0.2, 0.26), look.between(0.07, 0.11)
    color = look.color("gray", "cream", "teal", "red", "mustard", "navy", "sage", "pink", "brown")
    other = look.own_color("white", "cream", "navy", "red", "charcoal")
    cloth = look.pick(
        [
            textures.knitting(look.rng, color, 30),
            textures.fabric(look.rng, color, other, 24),
            textures.stripes([color, color, other, color], 3, side=96),
            textures.fabric(look.rng, color),
        ]
    )
    layers = look.pick([2, 3, 4])
    t = h / layers
    pieces, parts = [], []
    for n in range(layers):
        fold = block(x * (1 - 0.01 * n), y, t, 0.02)
        round_ = np.array(
            [
                (0, -t / 2 + 0.0005),
                (0.55 * t, -0.3 * t),
                (0.75 * t, 0),
                (0.55 * t, 0.3 * t),
                (0, t / 2 - 0.0005),
            ]
        )
        nose = loft(
            np.stack(
                [
                    np.column_stack(
                        [np.full(5, u), -round_[:, 0] - y / 2 + 0.006, round_[:, 1] + t / 2]
                    )
                    for u in (-0.49 * x, 0.49 * x)
                ]
            ),
            round_,
        )
        jitter = look.between(-0.004, 0.004)
        pieces.append((join([fold, nose]).move(jitter, jitter, n * t), cloth))
    parts.append(box_part(0.98 * x, y, h))
    if look.chance(0.5):
        threads = [tube([((n / 29 - 0.5) * 0.94 * x, y / 2 - 0.004, h - 0.5 * t),
                         ((n / 29 - 0.5) * 0.94 * x, y / 2 + 0.022, h - 0.9 * t)], 0.0016, 4)
                   for n in range(30)]  # fmt: skip
        pieces.append((join(threads), textures.plain(other)))
    return shape(pieces, parts)


def scarf(look: Look) -> Shape:
    """A scarf folded into a long bundle, its fringed ends over each other."""
    x, y, h = look.between(0.22, 0.28), look.between(0.1, 0.13), look.between(0.04, 0.055)
    color = look.color("red", "gray", "navy", "mustard", "teal", "cream", "maroon", "green", "pink")
    other = look.own_color("white", "black", "navy", "cream", "red", "yellow")
    cloth = look.pick(
        [
            textures.stripes([color, other], 5, upright=True, side=96),
            textures.fabric(look.rng, color, other, 24),
            textures.knitting(look.rng, color, 26),
        ]
    )
    pieces, parts = [], []
    t = h / 2
    for n, (wide, off) in enumerate(((1.0, 0.0), (0.9, 0.01))):
        path = smooth(
            [
                (-wide * x / 2, off, t * (n + 0.5)),
                (-0.2 * x, off, t * (n + 0.53)),
                (0.2 * x, off, t * (n + 0.48)),
                (wide * x / 2, off, t * (n + 0.5)),
            ],
            3,
        )
        bundle = sweep(path, rectangle(y * (1 - 0.06 * n), 0.98 * t, 0.45 * t, 4))
        bundle = bundle.bend(above)
        pieces.append((bundle, cloth))
        parts.append(hull_of(bundle))
    tail = loft(
        np.stack(
            [
                np.column_stack([rectangle(0.07, 0.006), np.full(4, 0.0)]),
                np.column_stack([rectangle(0.07, 0.006), np.full(4, 0.075)]),
            ]
        ),
        rectangle(0.07, 0.006),
    )
    tail = facing(tail).move(0.12 * x, -y / 2 + 0.03, h - 0.004)
    hang = box(0.07, 0.007, h).move(0.12 * x, -y / 2 - 0.002)
    fringe = [
        tube(
            [
                (0.12 * x - 0.032 + 0.008 * n, -y / 2 - 0.004, 0.006),
                (0.12 * x - 0.032 + 0.008 * n, -y / 2 - 0.03, 0.002),
            ],
            0.0018,
            5,
        )
        for n in range(9)
    ]
    pieces += [(join([tail, hang]), cloth), (join(fringe), textures.plain(color))]
    return shape(pieces, parts)


def shoe(look: Look) -> Shape:
    """A trainer with laces, its toe to the left; some are a pair."""
    k = look.between(0.9, 1.05)
    color = look.color("white", "black", "red", "blue", "gray", "navy", "green", "pink", "tan")
    other: RGB = look.own_color("white", "black", "orange", "lime", "navy", "red")
    upper_tile = (
        textures.fabric(look.rng, color)
        if look.chance(0.5)
        else textures.speckles(look.rng, color, 4)
    )

    def foot(grow: float, x: float) -> np.ndarray:
        half = [
            (-0.14, 0.0),
            (-0.13, 0.03),
            (-0.085, 0.048),
            (-0.03, 0.045),
            (0.04, 0.036),
            (0.1, 0.036),
            (0.128, 0.02),
            (0.132, 0.0),
        ]
        curve = smooth(half, 3) * grow
        curve[:, 0] += x
        outline = np.concatenate([curve * [1, -1], curve[::-1][1:-1]])
        return outline * k

    base = foot(1.0, 0.0)
    count = len(base)
    sole = loft(np.stack([np.column_stack([foot(g, 0.0), np.full(count, z * k)])
                          for g, z in ((0.97, 0), (1.0, 0.006), (0.99, 0.028))]), base)  # fmt: skip
    levels = [(0.97, 0.0, 0.026, 0.0), (0.93, 0.002, 0.045, 0.012), (0.82, 0.012, 0.06, 0.04),
              (0.6, 0.05, 0.075, 0.07), (0.46, 0.068, 0.095, 0.09)]  # fmt: skip
    rings = []
    for g, x, z, _ in levels:
        outline = foot(g, x / 1.0)
        rings.append(np.column_stack([outline, np.full(count, z * k)]))
    upper = loft(np.stack(rings), base)
    mouth = loft(
        np.stack(
            [
                np.column_stack([foot(0.38, 0.068), np.full(count, 0.0945 * k)]),
                np.column_stack([foot(0.38, 0.068), np.full(count, 0.0958 * k)]),
            ]
        ),
        base,
    )
    tongue = box(0.07 * k, 0.034 * k, 0.006).turn(1, -0.62).move(-0.018 * k, 0, 0.07 * k)
    laces = [
        tube(
            [(x * k, -0.02 * k, z * k), (x * k, 0, (z + 0.006) * k), (x * k, 0.02 * k, z * k)],
            0.0026 * k,
            6,
        )
        for x, z in ((-0.046, 0.062), (-0.03, 0.071), (-0.014, 0.081), (0.002, 0.091))
    ]
    stripe = [
        box(0.02 * k, 0.004, 0.035 * k)
        .turn(1, 0.4)
        .move((0.03 + 0.03 * n) * k, s * 0.0355 * k, 0.03 * k)
        for n in range(2)
        for s in (-1, 1)
    ]
    pieces = [
        (
            sole,
            textures.plain(look.pick([(240, 240, 236), (240, 240, 236), tint_color(color, 0.6)])),
        ),
        (upper, upper_tile),
        (mouth, textures.plain((46, 44, 46))),
        (join([tongue, *stripe]), textures.plain(other)),
        (join(laces), textures.plain((244, 244, 240))),
    ]
    low = [hull_of(sole), hull_part(upper.vertices[upper.vertices[:, 2] < 0.065 * k]),
           hull_part(upper.vertices[upper.vertices[:, 2] > 0.055 * k])]  # fmt: skip
    return shape(pieces, low)


CATEGORIES = (
    Category("hat", hat, (0.283, 0.322, 0.103), 0.12, ("straw hat", "fedora", "sun hat",
                  "cowboy hat", "panama hat", "easter bonnet",
                 "fascinator", "bonnet", "trilby"), ("living",), ("big",), ("tan",
             "black")),
    Category("blanket", blanket, (0.297, 0.269, 0.0886), 0.8, ("folded blanket", "throw blanket",
             "wool blanket", "folded blankets"), ("living",),
             ("big", "support"), ("gray", "cream"), state="lying folded"),
    Category("scarf", scarf, (0.25, 0.169, 0.0469), 0.2, ("folded scarf", "wool scarf", "shawl",
             "knitted scarf", "cummerbund"), ("living",), (), ("red", "gray"),
             state="lying folded"),
    Category("shoe", shoe, (0.27, 0.095, 0.095), 0.32, ("sneaker", "trainer", "running shoe",
             "sports shoe", "tennis shoe", "gym shoe", "loafer", "brogue", "moccasin",
             "espadrille", "ballet flat", "plimsoll", "miniature shoe"), ("living",), (), ("white",
             "black")),
)  # fmt: skip
"""The module's categories."""
