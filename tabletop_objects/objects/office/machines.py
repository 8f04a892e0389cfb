"""Objects of the ``office`` theme: machines."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import DARK, dye, plastic, shine, steel
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, hull_of
from ...kit.primitives import at_block, at_box, disc, drum, facing, rod, side_view
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape, vary
from ...kit.solids import block, box, cylinder, join, lathe, loft, sweep
from ...kit.surfaces import RGB, Look, plain, tint_color


@category("note_counter", size=(0.24, 0.205, 0.2), mass=4.0, material="device",
          aliases=("banknote counter", "money counter", "bill counter", "cash counter"),
          themes=("office",), roles=("big",), colors=("gray",))  # fmt: skip
@from_pieces()
def note_counter(look: Look) -> Pieces:
    """A banknote counter with a hopper of notes, a screen and a tray."""
    shell = plastic(look, "gray", "white", "charcoal")
    body = at_block(0.24, 0.2, 0.15, 0.02)
    hopper = at_box(0.18, 0.07, 0.03, (0, 0.04, 0.148))
    notes = at_box(0.15, 0.03, 0.05, (0, 0.035, 0.15)).turn(0, 0.0)
    screen = at_box(0.07, 0.002, 0.03, (-0.05, -0.1, 0.1))
    image = prints.canvas(64, 28, (24, 60, 48))
    prints.write(image, str(int(look.rng.integers(100, 999))), 0.5, 0.5, 0.7, (110, 240, 150), True)
    keys = [at_box(0.014, 0.003, 0.01, (0.03 + 0.022 * k, -0.1, 0.1 + 0.016 * n)) for k in range(3)
            for n in range(2)]  # fmt: skip
    slot = at_box(0.17, 0.004, 0.05, (0, -0.099, 0.02))
    color = look.own_color("green", "blue", "orange")
    return [(body, shell), (hopper, dye(look, "charcoal")),
            (notes, surfaces.stripes([tint_color(color, 1.6), tint_color(color, 1.2)], 10,
                                     upright=True)), (screen, image),
            (join(keys), dye(look, "charcoal", "blue")),
            (slot, surfaces.plain((36, 36, 40)))]  # fmt: skip


@category("coin_sorter", size=(0.201, 0.206, 0.149), mass=1.2, material="device",
          aliases=("coin counter", "coin sorting machine", "coin machine"), themes=("office",),
          roles=("big",), colors=("black",))  # fmt: skip
@from_pieces()
def coin_sorter(look: Look) -> Pieces:
    """A coin sorter with a bowl on top and tubes of stacked coins in front."""
    shell = plastic(look, "black", "charcoal", "blue", "gray")
    body = at_block(0.2, 0.12, 0.12, 0.02, (0, 0.03, 0))
    shelf = at_block(0.2, 0.07, 0.014, 0.01, (0, -0.05, 0))
    dish = lathe(
        [(0, 0), (0.07, 0), (0.09, 0.03), (0.085, 0.03), (0.065, 0.008), (0, 0.008)], 30
    ).move(0, 0.03, 0.118)
    stacks = []
    for k in range(5):
        x = -0.076 + 0.038 * k
        stacks.append((disc(0.013 + 0.0012 * (k % 3), 0.03 + 0.012 * ((3 * k) % 5),
                            (x, -0.055, 0.013)), ("gold", "silver", "copper", "silver",
                                                  "gold")[k]))  # fmt: skip
    loose = [disc(0.012, 0.003, (0.03 * np.cos(a), 0.03 + 0.03 * np.sin(a), 0.127 + 0.001 * n))
             for n, a in enumerate((0, 1.3, 2.5, 3.8, 5.0))]  # fmt: skip
    return [(body, shell), (shelf, shell), (dish, dye(look, "gray")),
            *((s, surfaces.stripes([tint_color(look.own_color(c), 0.8), look.own_color(c)], 8))
              for s, c in stacks), (join(loose), shine(look, "gold", "silver"))]  # fmt: skip


@category("ticket_dispenser", size=(0.146, 0.0881, 0.201), mass=0.5, material="plastic",
          aliases=("queue ticket dispenser", "take a number dispenser", "number dispenser",
          "queue number dispenser"), themes=("office",), roles=("tall",),
          colors=("red",))  # fmt: skip
@vary()
def ticket_dispenser(look: Look) -> Shape:
    """A rounded dispenser on a base with a numbered queue ticket hanging out."""
    k = look.between(0.94, 1.06)
    color = look.color("red", "red", "blue", "green")
    foot = block(0.12, 0.09, 0.012, 0.015, 0.002)
    post = block(0.03, 0.02, 0.05, 0.006).move(z=0.01)
    drum = cylinder(0.075, 0.045, 34, bevel=0.006).turn(0, np.pi / 2).move(0, 0.0225, 0.13)
    face = cylinder(0.058, 0.002, 30).turn(0, np.pi / 2).move(0, -0.0215, 0.13)
    ticket = box(0.032, 0.0014, 0.05).turn(0, -0.25).move(0, -0.026, 0.028)
    image = prints.canvas(60, 96, (250, 248, 240))
    prints.write(image, str(int(look.rng.integers(10, 99))), 0.5, 0.5, 0.4, (40, 40, 46), bold=True)
    sign = prints.canvas(120, 120, (250, 248, 242))
    prints.write(sign, "TAKE", 0.5, 0.4, 0.16, (60, 60, 66), bold=True)
    prints.write(sign, "A NUMBER", 0.5, 0.6, 0.12, (60, 60, 66), bold=True)
    return shape([(join([foot, post]), surfaces.plain((60, 60, 64))),
                  (drum, surfaces.speckles(look.rng, color, 4)), (face, sign), (ticket, image)],
                 [hull_of(foot), hull_of(post), hull_of(drum, face),
                  hull_of(ticket)]).scale(k)  # fmt: skip


BARCODE_SCANNER_DARK: RGB = (38, 39, 43)


@category("barcode_scanner", size=(0.1, 0.11, 0.19), mass=0.25, material="device",
          aliases=("bar code scanner", "handheld scanner", "hand scanner", "barcode reader",
          "code scanner", "price scanner", "barcode gun", "microchip reader"), themes=("office",),
          roles=("tall",), colors=("black", "gray"))  # fmt: skip
def barcode_scanner(look: Look) -> Shape:
    """A hand-held barcode scanner in its stand with its window towards the viewer."""
    color = look.color("black", "gray", "white", "charcoal", "yellow", "red")
    k = look.between(0.92, 1.08)
    shell, trim = (surfaces.speckles(look.rng, color, 3, 32),
                   surfaces.speckles(look.rng, BARCODE_SCANNER_DARK, 4))  # fmt: skip
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


@category("cash_register", size=(0.33, 0.33, 0.28), mass=5.0, material="device",
          aliases=("cash till", "toy cash register", "cashier machine", "lottery terminal"),
          themes=("office",), roles=("big", "tall"), colors=("gray", "black"))  # fmt: skip
def cash_register(look: Look) -> Shape:
    """A cash register with sloped keys, a display, a till drawer and a receipt."""
    x, y, h = look.between(0.3, 0.36), look.between(0.3, 0.35), look.between(0.1, 0.12)
    color = look.color("gray", "black", "white", "beige", "red", "sky", "charcoal")
    shell = surfaces.speckles(look.rng, color, 3, 32)
    dark = surfaces.plain(BARCODE_SCANNER_DARK)
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
    return shape([(join([till, body, tower]), shell),
                  (join([front, lock]), surfaces.plain(tint_color(color, 0.7))), (pad, face),
                  (glass, screen), (paper, strip),
                  (box(0.064, 0.03, 0.004).move(0.26 * x, 0.22 * y, 0.09 + h), dark)],
                 [hull_of(till), hull_of(body), hull_of(tower)])  # fmt: skip


@category("card_reader", size=(0.0753, 0.187, 0.0569), mass=0.3, material="device",
          aliases=("payment terminal", "card terminal", "credit card reader", "pos terminal",
          "credit card machine", "card machine", "card payment terminal", "card reader machine",
          "chip and pin machine"), themes=("office",), roles=("flat",), colors=("black", "white"),
          state="lying flat")  # fmt: skip
def card_reader(look: Look) -> Shape:
    """A payment terminal lying with its keys and display up, sometimes with a card or receipt."""
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
    pieces = [(body, surfaces.speckles(look.rng, color, 3, 32)), (top, face)]
    parts = [hull_of(body)]
    if look.chance(0.5):
        slip = surfaces.plain(look.own_color("blue", "gold", "red", "teal", "silver"))
        card = block(0.054, 0.05, 0.001, 0.003).move(y=-y / 2 - 0.018, z=0.3 * h)
        pieces.append((card, slip))
    elif look.chance(0.6):
        path = smooth([(0, 0.46 * y, h), (0, 0.5 * y, h + 0.03), (0, 0.46 * y, h + 0.06),
                       (0, 0.34 * y, h + 0.07)], 4)  # fmt: skip
        strip = sweep(path, rectangle(0.055, 0.0008))
        pieces.append(
            (strip, surfaces.stripes([(250, 250, 248), (250, 250, 248), (190, 190, 194)], 6))
        )
    return shape(pieces, parts)


@category("scanner", size=(0.26, 0.353, 0.0505), mass=2.0, material="device",
          aliases=("flatbed scanner", "document scanner", "photo scanner"), themes=("office",),
          roles=("big", "support", "flat"), colors=("white",))  # fmt: skip
def scanner(look: Look) -> Shape:
    """A flatbed scanner with its lid closed."""
    k = look.between(0.85, 1.0)
    x, y, h = 0.28 * k, 0.38 * k, 0.055 * k
    color = look.color("white", "gray", "black", "charcoal")
    body = block(x, y, 0.6 * h, 0.012, 0.003)
    lid = block(0.98 * x, 0.9 * y, 0.36 * h, 0.012, 0.004).move(y=0.04 * y, z=0.63 * h)
    seam = box(0.97 * x, 0.9 * y, 0.06 * h).move(y=0.04 * y, z=0.59 * h)
    keys = [cylinder(0.006, 0.0016, 14).move((n - 1.5) * 0.02, -0.458 * y, 0.6 * h - 0.0004)
            for n in range(4)]  # fmt: skip
    line = box(0.82 * x, 0.0015, 0.0006).move(y=-0.3 * y, z=0.99 * h - 0.0002)
    mark = box(0.2 * x, 0.02 * y, 0.0006).move(y=-0.35 * y, z=0.99 * h - 0.0002)
    tile = look.surface(color, "plastic")
    glow = look.own_color("lime", "cyan", "blue")
    return shape([(body, tile), (lid, tile), (join([seam, line, mark]), surfaces.plain(
                  tint_color(color, 0.55))), (join(keys), surfaces.plain(glow))],
                 [hull_of(body), hull_of(lid), hull_of(seam)])  # fmt: skip


PRINTER_DARK = (40, 42, 46)


@category("printer", size=(0.4, 0.45, 0.26), mass=4.5, material="device",
          aliases=("inkjet printer", "copier", "fax machine", "laminator", "franking machine"),
          themes=("office",), roles=("big",), colors=("white", "black"), common=True)  # fmt: skip
def printer(look: Look) -> Shape:
    """An ink-jet printer with a small screen, paper behind and a printed sheet in front."""
    x, y, h = look.between(0.36, 0.44), look.between(0.26, 0.32), look.between(0.13, 0.17)
    color = look.color("white", "black", "gray", "charcoal", "white")
    shell = surfaces.speckles(look.rng, color, 3, 32)
    other = surfaces.speckles(
        look.rng, tint_color(color, 0.72 if sum(color) > 300 else 1.25), 3, 32
    )
    body = block(x, y, h, 0.02, 0.008)
    lid = block(0.94 * x, 0.86 * y, 0.014, 0.014, 0.004).move(y=0.03 * y, z=h - 0.001)
    slot = box(0.66 * x, 0.004, 0.3 * h).move(y=-y / 2 - 0.001, z=0.14 * h)
    tray = box(0.6 * x, 0.12, 0.006).move(y=-y / 2 - 0.055, z=0.12 * h)
    sheet = prints.sheet(look.rng, picture=look.chance(0.6))
    page = box(0.21, 0.13, 0.0012).move(y=-y / 2 - 0.05, z=0.12 * h + 0.006)
    feed = box(0.21, 0.003, 0.13).turn(0, -0.28).move(y=0.42 * y, z=h)
    rest = box(0.25, 0.005, 0.085).turn(0, -0.28).move(y=0.45 * y, z=h)
    face = prints.canvas(96, 48, PRINTER_DARK)
    prints.fill(face, 0.08, 0.14, 0.5, 0.72, (90, 150, 210))
    for k, ink in enumerate([(80, 190, 110), (220, 220, 220), (220, 80, 60)]):
        prints.disc(face, 0.72 + 0.1 * k, 0.5, 0.11, ink)
    panel = box(0.1, 0.003, 0.04).move(-0.32 * x, -y / 2 - 0.001, 0.62 * h)
    return shape(
        [(body, shell), (join([lid, rest, tray]), other), (slot, surfaces.plain(PRINTER_DARK)),
         (page, sheet), (feed, surfaces.plain((248, 248, 246))), (panel, face)],
        [box_part(x, y, h), hull_of(lid), hull_of(feed, rest), hull_of(tray)],
    )  # fmt: skip


@category("label_maker", size=(0.123, 0.1665, 0.045), mass=0.4, material="device",
          aliases=("label printer", "labelmaker", "labeler", "labeller", "label writer",
          "label machine"), themes=("office",), colors=("white",))  # fmt: skip
def label_maker(look: Look) -> Shape:
    """A hand-held label printer lying flat, with a screen, keys and a label coming out."""
    k = look.between(0.9, 1.06)
    color = look.color("white", "blue", "black", "gray", "teal")
    x, y, h = 0.1 * k, 0.17 * k, 0.045 * k
    body = block(x, y, h, 0.02, 0.006)
    shown = prints.canvas(72, 32, (176, 196, 170))
    word = look.pick(["FILES", "HOME", "KEYS", "LABEL"])
    prints.write(shown, word, 0.5, 0.5, 0.5, (30, 36, 28), bold=True)
    screen = box(0.66 * x, 0.16 * y, 0.0008).move(y=0.27 * y, z=h - 0.0003)
    pad = prints.keys([(1,) * 7] * 5, (236, 236, 232), tint_color(color, 0.6), width=112, height=80)
    board = box(0.84 * x, 0.46 * y, 0.0008).move(y=-0.13 * y, z=h - 0.0003)
    strip = prints.canvas(96, 28, (250, 250, 246))
    prints.write(strip, word, 0.45, 0.5, 0.6, (20, 20, 24), bold=True)
    paper = box(0.05 * k, 0.0006, 0.013 * k).move(-0.5 * x - 0.022 * k, 0.36 * y, 0.4 * h)
    return shape([(body, look.surface(color, "plastic")), (screen, shown), (board, pad),
                  (paper, strip)], [hull_of(body)])  # fmt: skip


@category("typewriter", size=(0.33, 0.289, 0.221), mass=4.5, material="device",
          aliases=("portable typewriter", "manual typewriter", "vintage typewriter",
          "toy typewriter"), themes=("office",), roles=("big",),
          colors=("teal", "black"))  # fmt: skip
def typewriter(look: Look) -> Shape:
    """A portable typewriter with a sheet of paper in its carriage."""
    color = look.color("teal", "black", "mint", "red", "cream", "sky", "gray")
    k = look.between(0.85, 1.05)
    side = [(-0.16, 0), (0.13, 0), (0.13, 0.085), (0.02, 0.075), (-0.16, 0.03)]
    body = side_view(np.array(side), 0.3).turn(2, np.pi / 2)
    keys = []
    for row in range(4):
        for n in range(10):
            y = -0.135 + 0.026 * row
            z = 0.03 + (y + 0.16) * 0.25 - 0.001
            keys.append(drum(0.0085, 0.006, (-0.117 + 0.0255 * n + 0.004 * row, y, z), sides=10))
    space = at_box(0.13, 0.012, 0.01, (0, -0.153, 0.027))
    well = at_box(0.13, 0.05, 0.012, (0, 0.0, 0.072))
    roller = drum(0.017, 0.3, (-0.15, 0.08, 0.1), 0, sides=20)
    ends = [drum(0.013, 0.018, (x, 0.08, 0.1), 0, sides=14) for x in (-0.168, 0.15)]
    carriage = at_box(0.29, 0.05, 0.02, (0, 0.095, 0.078))
    lever = rod([(-0.15, 0.07, 0.1), (-0.175, 0.03, 0.118), (-0.18, 0.0, 0.122)], 0.003, 6)
    page = at_box(0.2, 0.0012, 0.13).turn(0, 0.28).move(0, 0.085, 0.11)
    text = prints.sheet(look.rng)
    paint = surfaces.speckles(look.rng, color, 4)
    dark = plain((44, 44, 48) if sum(color) > 240 else (226, 220, 200))
    chrome = steel(look)
    return put_down(
        [(body, paint), (join(keys), dark), (join([space, roller, well]), plain(DARK)),
         (join([*ends, lever]), chrome), (carriage, chrome), (page, text)],
        body, carriage, roller, page, factor=k,
    )  # fmt: skip
