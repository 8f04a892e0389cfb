"""What stands on counters and desks: scanners, cash registers, card readers, joysticks."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import facing, side_view
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import (
    block,
    box,
    cylinder,
    join,
    lathe,
    loft,
    sweep,
)
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

DARK: RGB = (38, 39, 43)


def barcode_scanner(look: Look) -> Shape:
    """A hand-held bar-code scanner standing in its foot, its window to the viewer."""
    color = look.color("black", "gray", "white", "charcoal", "yellow", "red")
    k = look.between(0.92, 1.08)
    shell, trim = textures.speckles(look.rng, color, 3, 32), textures.speckles(look.rng, DARK, 4)
    foot = lathe([(0, 0), (0.048 * k, 0), (0.046 * k, 0.01), (0.02 * k, 0.018), (0, 0.018)], 30)
    grip = sweep(smooth([(0, 0.012 * k, 0.012), (0, 0.018 * k, 0.06 * k), (0, 0.012 * k, 0.12 * k),
                         (0, -0.004 * k, 0.15 * k)], 3), rectangle(0.032 * k, 0.03 * k, 0.01, 3),
                 [0.9, 0.92, 0.95, 0.97, 1, 1.02, 1.04, 1.06, 1.08, 1.1])  # fmt: skip
    head = loft(np.stack([np.column_stack([rectangle(a, b, 0.012, 3) * k, np.full(16, z * k)])
                          for a, b, z in ((0.05, 0.036, -0.05), (0.056, 0.044, 0.0),
                                          (0.068, 0.044, 0.045), (0.066, 0.04, 0.05))]),
                rectangle(0.06, 0.04, 0.012, 3))  # fmt: skip
    head = facing(head).turn(0, 0.15).move(y=-0.01 * k, z=0.165 * k)
    pane = facing(box(0.054 * k, 0.026 * k, 0.002)).turn(0, 0.15).move(y=-0.06 * k, z=0.157 * k)
    glow = prints.canvas(64, 32, (60, 14, 18))
    prints.fill(glow, 0.08, 0.44, 0.84, 0.12, (250, 60, 60))
    trigger = facing(block(0.014, 0.03, 0.008, 0.004, 0.002)).move(y=-0.002 * k, z=0.105 * k)
    return shape([(join([grip, head]), shell), (join([foot, trigger]), trim), (pane, glow)],
                 [hull_of(foot), hull_of(grip), hull_of(head)])  # fmt: skip


def cash_register(look: Look) -> Shape:
    """A cash register: keys on a slope, a display, a till drawer and a receipt."""
    x, y, h = look.between(0.3, 0.36), look.between(0.3, 0.35), look.between(0.1, 0.12)
    color = look.color("gray", "black", "white", "beige", "red", "sky", "charcoal")
    shell = textures.speckles(look.rng, color, 3, 32)
    dark = textures.plain(DARK)
    till = box(x, y, 0.09)
    front = box(0.9 * x, 0.004, 0.06).move(y=-y / 2 - 0.001, z=0.016)
    lock = facing(cylinder(0.009, 0.004, 16)).move(0.3 * x, -y / 2 - 0.003, 0.046)
    slope = side_view(np.array([(-0.46 * y, 0.09), (0.46 * y, 0.09), (0.46 * y, 0.09 + h),
                                (0.16 * y, 0.09 + h), (-0.46 * y, 0.125)]), 0.92 * x)  # fmt: skip
    body = slope.turn(2, np.pi / 2)
    rise = np.arctan2(h - 0.035, 0.62 * y)
    face = prints.canvas(160, 112, tint_color(color, 0.9))
    for row in range(4):
        for column in range(7):
            special = column > 4
            tone = look.own_color("red", "green", "yellow", "blue") if special else (246, 246, 242)
            prints.fill(
                face, 0.05 + 0.133 * column + 0.02 * special, 0.08 + 0.225 * row, 0.1, 0.16, tone
            )
    pad = (
        box(0.82 * x, 0.56 * y, 0.005).turn(0, rise).move(y=-0.15 * y, z=0.1225 + 0.5 * (h - 0.035))
    )
    screen = prints.canvas(96, 32, (18, 30, 26))
    amount = f"{int(look.rng.integers(1, 99))}.{int(look.rng.integers(100)):02d}"
    prints.write(screen, amount, 0.6, 0.5, 0.6, (110, 240, 150), bold=True)
    tower = box(0.4 * x, 0.07, 0.07).move(-0.2 * x, 0.28 * y, 0.09 + h)
    glass = box(0.36 * x, 0.002, 0.05).move(-0.2 * x, 0.28 * y - 0.036, 0.1 + h)
    paper = box(0.05, 0.002, 0.07).turn(0, -0.25).move(0.26 * x, 0.22 * y, 0.09 + h)
    strip = prints.canvas(32, 64, (250, 250, 248))
    prints.lines(strip, look.rng, (0.15, 0.1, 0.7, 0.8), 9, (110, 110, 116))
    return shape(
        [
            (join([till, body, tower]), shell),
            (join([front, lock]), textures.plain(tint_color(color, 0.7))),
            (pad, face),
            (glass, screen),
            (paper, strip),
            (box(0.064, 0.03, 0.004).move(0.26 * x, 0.22 * y, 0.09 + h), dark),
        ],
        [hull_of(till), hull_of(body), hull_of(tower)],
    )


def card_reader(look: Look) -> Shape:
    """A payment terminal lying, its keys and display up, sometimes with a card or a receipt."""
    x, y, h = look.between(0.07, 0.085), look.between(0.14, 0.18), look.between(0.025, 0.035)
    color = look.color("black", "charcoal", "white", "gray", "navy")
    face = prints.canvas(96, 176, tint_color(color, 1.15 if sum(color) < 250 else 0.94))
    prints.fill(face, 0.1, 0.07, 0.8, 0.3, (206, 226, 240))
    prints.write(
        face, look.pick(["24.90", "PAY", "TOTAL", "9.50"]), 0.5, 0.2, 0.1, (30, 40, 70), bold=True
    )
    for n in range(9):
        prints.fill(
            face, 0.12 + 0.27 * (n % 3), 0.44 + 0.12 * (n // 3), 0.22, 0.08, (236, 236, 232)
        )
    for n, tone in enumerate([(206, 50, 46), (236, 200, 60), (70, 170, 90)]):
        prints.fill(face, 0.12 + 0.27 * n, 0.83, 0.22, 0.09, tone)
    body = side_view(np.array([(-y / 2, 0), (y / 2, 0), (y / 2, h), (-y / 2, 0.62 * h)]), x, 0.002)
    body = body.turn(2, np.pi / 2)
    lean = np.arctan2(0.38 * h, y)
    top = box(0.9 * x, 0.94 * y, 0.0012).turn(0, lean).move(z=0.81 * h - 0.0004)
    pieces = [(body, textures.speckles(look.rng, color, 3, 32)), (top, face)]
    parts = [hull_of(body)]
    if look.chance(0.5):
        slip = textures.plain(look.own_color("blue", "gold", "red", "teal", "silver"))
        card = block(0.054, 0.05, 0.001, 0.003).move(y=-y / 2 - 0.018, z=0.3 * h)
        pieces.append((card, slip))
    elif look.chance(0.6):
        path = smooth([(0, 0.46 * y, h), (0, 0.5 * y, h + 0.03), (0, 0.46 * y, h + 0.06),
                       (0, 0.34 * y, h + 0.07)], 4)  # fmt: skip
        strip = sweep(path, rectangle(0.055, 0.0008))
        pieces.append(
            (strip, textures.stripes([(250, 250, 248), (250, 250, 248), (190, 190, 194)], 6))
        )
    return shape(pieces, parts)


def joystick(look: Look) -> Shape:
    """A flight joystick: a grip with a trigger and a hat switch on a broad foot with buttons."""
    k = look.between(0.92, 1.08)
    color = look.color("black", "charcoal", "gray", "navy", "black")
    trim = textures.plain(look.own_color("red", "orange", "blue", "silver", "lime"))
    skin = textures.speckles(look.rng, color, 4, 32)
    base = loft(
        np.stack(
            [
                np.column_stack([rectangle(1, 1, 0.22, 4) * [a * k, b * k], np.full(20, z * k)])
                for a, b, z in ((0.19, 0.18, 0), (0.19, 0.18, 0.012), (0.15, 0.14, 0.045))
            ]
        ),
        rectangle(1, 1, 0.22, 4),
    )
    boot = lathe(
        [
            (0, 0.044 * k),
            (0.038 * k, 0.044 * k),
            (0.03 * k, 0.056 * k),
            (0.034 * k, 0.06 * k),
            (0.018 * k, 0.075 * k),
            (0, 0.075 * k),
        ],
        24,
    )
    grip = sweep(smooth([(0, 0.0, 0.07 * k), (0, 0.004 * k, 0.1 * k), (0, 0.0, 0.15 * k),
                         (0, -0.012 * k, 0.19 * k), (0, -0.022 * k, 0.212 * k)], 3),
                 rectangle(0.036 * k, 0.042 * k, 0.014, 4),
                 [0.75, 0.8, 0.86, 0.94, 1, 1, 0.98, 0.96, 0.98, 1.05, 1.1, 1.1, 1.0])  # fmt: skip
    hat = cylinder(0.008, 0.01, 14, bevel=0.002).move(0.004, -0.014 * k, 0.21 * k)
    thumb = facing(cylinder(0.006, 0.006, 14)).move(0.009, -0.036 * k, 0.195 * k)
    trigger = block(0.012, 0.014, 0.03 * k, 0.004, 0.002).move(y=0.022 * k, z=0.155 * k)
    buttons = [
        cylinder(0.0075, 0.006, 14).move(s * 0.055 * k, -0.05 * k + 0.026 * n * k, 0.043 * k)
        for s in (-1, 1)
        for n in range(3)
    ]
    lever = box(0.02, 0.01, 0.014).move(0, 0.055 * k, 0.044 * k)
    return shape(
        [
            (join([base, boot, grip]), skin),
            (join([hat, thumb, trigger, *buttons, lever]), trim),
        ],
        [hull_of(base), hull_of(boot), hull_of(grip)],
    )


CATEGORIES = (
    Category("barcode_scanner", barcode_scanner, (0.1, 0.11, 0.19), 0.25, ("bar code scanner",
             "handheld scanner", "hand scanner", "barcode reader", "code scanner", "price scanner",
             "barcode gun", "microchip reader"), ("office",), ("tall",), ("black", "gray")),
    Category("cash_register", cash_register, (0.33, 0.33, 0.28), 5.0, ("cash till",
             "toy cash register", "cashier machine", "lottery terminal"), ("office",), ("big",
             "tall"), ("gray", "black")),
    Category("card_reader", card_reader, (0.0753, 0.187, 0.0569), 0.3, ("payment terminal",
             "card terminal", "credit card reader", "pos terminal", "credit card machine",
             "card machine", "card payment terminal", "card reader machine",
             "chip and pin machine"), ("office",), ("flat",), ("black", "white"),
             state="lying flat"),
    Category("joystick", joystick, (0.19, 0.18, 0.22), 0.8, ("flight stick", "flight joystick",
             "joy stick", "gaming joystick", "control stick"), ("gaming",), ("tall",), ("black",)),
)  # fmt: skip
"""The module's categories."""
