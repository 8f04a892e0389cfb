"""Panels of electronics: solar cells and displays."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import BRASS_TONE, DARK, at_box, drum, steel
from ...build.recipes import put_down, rod
from ...build.shape import Shape
from ...build.solids import block, join
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain
from .coils import pins_at


def solar_panel(look: Look) -> Shape:
    """A small solar panel lying, with two wires."""
    color = look.color("navy", "black", "blue")
    x, y = look.between(0.09, 0.15), look.between(0.07, 0.1)
    base, face = (
        block(x, y, 0.004, 0.003, 0.0008),
        at_box(0.95 * x, 0.94 * y, 0.0008, (0, 0, 0.0037)),
    )
    cells = textures.grid((196, 204, 214), color, 4, int(look.pick([4, 6])), 160, 3)
    fine = cells.copy()
    fine[::10] = np.clip(fine[::10].astype(int) + 26, 0, 255)
    wires = [
        rod(
            [
                (x / 2 - 0.004, s * 0.006, 0.002),
                (x / 2 + 0.015, s * 0.01, 0.002),
                (x / 2 + 0.035, s * 0.004 - 0.012, 0.0013),
            ],
            0.0012,
            6,
        )
        for s in (-1, 1)
    ]
    return put_down(
        [
            (base, plain((226, 228, 230) if look.chance(0.5) else (50, 52, 58))),
            (face, fine),
            (wires[0], plain((200, 40, 40))),
            (wires[1], plain((34, 34, 38))),
        ],
        base,
        *wires,
    )


def segment_display(look: Look) -> Shape:
    """A seven-segment display module with lit digits."""
    color = look.color("red", "green", "blue", "yellow")
    k = look.between(0.85, 1.2)
    n = look.pick([1, 2, 4])
    x = 0.016 * n + 0.004
    body = block(x, 0.024, 0.01, 0.001, 0.0005).move(z=0.003)
    image = prints.canvas(64 * n, 96, (40, 36, 36))
    dim = tint_color(color, 0.28)
    shapes = {
        0: "abcdef",
        1: "bc",
        2: "abged",
        3: "abgcd",
        4: "fgbc",
        5: "afgcd",
        6: "afgedc",
        7: "abc",
        8: "abcdefg",
        9: "abcdfg",
    }
    places = {
        "a": (0.2, 0.12, 0.5, 0.08),
        "d": (0.2, 0.8, 0.5, 0.08),
        "g": (0.2, 0.46, 0.5, 0.08),
        "f": (0.16, 0.18, 0.12, 0.3),
        "b": (0.64, 0.18, 0.12, 0.3),
        "e": (0.16, 0.52, 0.12, 0.3),
        "c": (0.64, 0.52, 0.12, 0.3),
    }
    for d in range(n):
        lit = shapes[int(look.rng.integers(10))]
        for name, (u, v, w, h) in places.items():
            prints.fill(
                image, (d + u) / n, v, w / n, h, tint_color(color, 1.25) if name in lit else dim
            )
        prints.disc(image, (d + 0.88) / n, 0.85, 0.05, dim)
    face = at_box(0.98 * x, 0.0235, 0.0006, (0, 0, 0.0127))
    pins = pins_at(
        [(u, s * 0.009) for u in np.linspace(-0.4 * x, 0.4 * x, 5) for s in (-1, 1)], 0.004, 0.0008
    )
    return put_down(
        [
            (body, plain((232, 230, 224) if look.chance(0.4) else (50, 50, 54))),
            (face, image),
            (pins, steel(look)),
        ],
        body,
        pins,
        factor=k,
    )


def lcd_module(look: Look) -> Shape:
    """A character display on its board: two lines of text in a metal frame."""
    color = look.color("blue", "lime", "green")
    k = look.between(0.9, 1.15)
    board, frame = (
        block(0.08, 0.036, 0.0016, 0.001).move(z=0.004),
        at_box(0.071, 0.026, 0.007, (0, 0, 0.0052)),
    )
    glass = at_box(0.064, 0.0155, 0.0006, (0, 0, 0.0119))
    image = prints.canvas(192, 48, color)
    ink = (240, 246, 255) if sum(color) < 340 else (40, 56, 30)
    prints.write(
        image, look.pick(["HELLO WORLD", "TEMP 21.5 C", "READY", "TIME 12:04"]), 0.5, 0.3, 0.34, ink
    )
    prints.write(
        image, look.pick(["TABLETOP", "VOLTS 4.97", "> START", "OK"]), 0.5, 0.72, 0.34, ink
    )
    pads = [drum(0.0009, 0.0004, (-0.036 + 0.0025 * n, 0.0158, 0.0055), sides=8) for n in range(16)]
    posts = [
        drum(0.003, 0.0045, (sx * 0.036, sy * 0.0145, 0), sides=10)
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    return put_down(
        [
            (join([board, *posts]), plain((40, 110, 70))),
            (frame, plain(DARK)),
            (glass, image),
            (join(pads), plain(BRASS_TONE)),
        ],
        board,
        frame,
        *posts,
        factor=k,
    )


CATEGORIES = (
    Category("solar_panel", solar_panel, (0.153, 0.0831, 0.0045), 0.06, ("solar cell",
             "mini solar panel", "photovoltaic panel"), ("electronics",), ("flat",), ("navy",)),
    Category("segment_display", segment_display, (0.0373, 0.0245, 0.0136), 0.012,
             ("seven-segment display", "seven segment display", "digit display",
             "led display", "7-segment display"), ("electronics",), (), ("red",)),
    Category("lcd_module", lcd_module, (0.0846, 0.0381, 0.0132), 0.035, ("lcd display", "lcd",
             "character display", "lcd screen", "oled display", "display module"),
             ("electronics",), ("flat",), ("blue", "green")),
)  # fmt: skip
"""The module's categories."""
